/* SPDX-License-Identifier: MIT */
/* luxel probe: exact values at single places, light by light. */
#include <stdlib.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "outputs.h"
#include "probe_table.h"
#include "result.h"
#include "standard_output.h"
#include "text.h"

/* The most points that are told light by light, and the most of which the values alone are told. */
enum { MOST_IN_DETAIL = 100, MOST_LINES = 1000 };

/* "lights[0] window" */
static void name_light(const luxel_light_share *share, char buffer[TEXT_SIZE])
{
    char *name = share->name ? luxel_escaped_text(share->name) : NULL;

    text_format(buffer, "lights[%zu]%s%s", share->light, name ? " " : "", name ? name : "");
    luxel_text_free(name);
}

/* The number of points only where some source was split into such. */
static void print_shares(const luxel_scene *scene, const luxel_probe *probe)
{
    bool split = false;

    for (size_t i = 0; i < probe->share_count; i++)
        split = split || probe->shares[i].parts > 0;

    struct text_table *table = text_table_new(split ? "llrrrrr" : "llrrrr");

    text_table_row(table, TEXT_CELLS(_("light"), _("type"), _(luxel_scene_quantity_word(scene, LUXEL_IRRADIANCE)),
                                     _("diffuse"), _("highlight"), _("error at most"), split ? _("parts") : NULL));
    for (size_t i = 0; i < probe->share_count; i++) {
        const luxel_light_share *share = &probe->shares[i];
        char name[TEXT_SIZE], irradiance[TEXT_SIZE], diffuse[TEXT_SIZE], specular[TEXT_SIZE], error[TEXT_SIZE];
        char parts[TEXT_SIZE];

        /* the error is of what the light makes in all; of the irradiance it is as large a share */
        const double made = share->diffuse + share->specular;
        const double of_irradiance = made > 0.0 ? share->error * (share->irradiance / made) : share->error;
        name_light(share, name);
        text_table_row(
            table, TEXT_CELLS(name, share->type, text_bounded(irradiance, 12, share->irradiance, of_irradiance),
                              text_bounded(diffuse, 12, share->diffuse, share->error),
                              text_bounded(specular, 12, share->specular, share->error),
                              text_error(share->error, error), split ? text_format(parts, "%zu", share->parts) : NULL));
    }
    if (probe->has_reflected) {
        const double share = probe->reflected.value > 0.0 ? probe->reflected_irradiance / probe->reflected.value : 1.0;
        char irradiance[TEXT_SIZE], value[TEXT_SIZE], error[TEXT_SIZE];

        text_table_row(
            table,
            TEXT_CELLS(_("reflected"), "",
                       text_bounded(irradiance, 12, probe->reflected_irradiance, probe->reflected.error * share),
                       text_bounded(value, 12, probe->reflected.value, probe->reflected.error), "",
                       text_bound(error, 12, probe->reflected.value, probe->reflected.error), split ? "" : NULL));
    }
    text_table_print(table, stdout, 4);
}

/* Where the point lies in the picture. */
static void print_pixel(const luxel_probe *probe)
{
    if (!probe->has_screen)
        return;
    if (!probe->has_pixel)
        printf(_("  off the screen\n"));
    else if (probe->has_pixel_value)
        printf(_("  pixel (%u, %u), pixel value %.6g\n"), probe->column, probe->row, probe->pixel_value);
    else
        printf(_("  pixel (%u, %u)\n"), probe->column, probe->row);
}

/* "surfaces[1] ball", "surfaces[0], floor" */
static const char *name_surface(const luxel_probe *probe, char buffer[TEXT_SIZE])
{
    char *name = probe->surface_name ? luxel_escaped_text(probe->surface_name) : NULL;

    text_format(buffer, "surfaces[%zu]%s%s%s%s", probe->surface, name ? " " : "", name ? name : "",
                probe->part_name ? ", " : "", probe->part_name ? probe->part_name : "");
    luxel_text_free(name);
    return buffer;
}

/* What counted for a free element, and which of several surfaces is seen at a point of the screen. */
static void print_surface(const struct result *result, const luxel_probe *probe)
{
    char name[TEXT_SIZE];

    if (probe->has_screen) {
        if (luxel_scene_surface_count(result->scene) > 1 || probe->part_name)
            printf(_("  on %s\n"), name_surface(probe, name));
        return;
    }
    printf(_("  view (%.9g, %.9g, %.9g)\n"), probe->view[0] + 0.0, probe->view[1] + 0.0, probe->view[2] + 0.0);
    if (luxel_scene_surface_count(result->scene) == 0)
        puts(_("  lies on no surface, as there is none; its material has all keys by default"));
    else
        printf(probe->lies_on_surface ? _("  lies on %s, whose material it has\n")
                                      : _("  lies on no surface; has the material of %s\n"),
               name_surface(probe, name));
    if (probe->is_enclosed)
        printf(_("  inside the body of surfaces[%zu]\n"), probe->enclosing_surface);
}

static void print_point(const struct result *result, size_t i)
{
    const luxel_probe *probe = luxel_probes_get(result->probes, i);
    char name[TEXT_SIZE], value[TEXT_SIZE], position[TEXT_SIZE];

    if (!probe->has_value) {
        printf("%s\n", result_no_value(result, i, name));
        return;
    }
    printf("%s: %s %s\n", result_point_name(result, i, name), text_value_bound(value, 15, probe->value, probe->error),
           text_unit(result_unit(result)));
    if (probe->color.exists)
        printf(_("  colour %s\n"), result_color_text(&probe->color, name));
    printf(_("  position %s mm, normal (%.9g, %.9g, %.9g)\n"), text_lengths(probe->position_mm, 3, position),
           probe->normal[0] + 0.0, probe->normal[1] + 0.0, probe->normal[2] + 0.0);
    print_surface(result, probe);
    print_pixel(probe);
    if (probe->share_count > 0 || probe->has_reflected)
        print_shares(result->scene, probe);
}

/* How many elements lie where hardly anybody wants them, the first of them by its number. */
static void print_enclosed(const struct result *result)
{
    size_t enclosed = 0, first = 0;

    for (size_t i = 0; i < result->count; i++) {
        const luxel_probe *probe = luxel_probes_get(result->probes, i);
        if (!probe->has_screen && probe->is_enclosed && enclosed++ == 0)
            first = i;
    }
    if (enclosed > 0)
        printf(ngettext("  %zu element is inside a body: P%zu in surfaces[%zu]\n",
                        "  %zu elements are inside bodies, the first of them P%zu in surfaces[%zu]\n", enclosed),
               enclosed, first + 1, luxel_probes_get(result->probes, first)->enclosing_surface);
}

/* Many points: a line each, and no more lines than somebody may look through. */
static void print_lines(const struct result *result)
{
    struct text_table *table = text_table_new("lrr");
    char value[TEXT_SIZE], error[TEXT_SIZE], name[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(_("point (mm)"), _("value"), _("error at most")));
    for (size_t i = 0; i < result->count && i < MOST_LINES; i++) {
        const luxel_probe *probe = luxel_probes_get(result->probes, i);

        if (probe->has_value)
            text_table_row(table, TEXT_CELLS(result_point_name(result, i, name),
                                             text_bounded(value, 12, probe->value, probe->error),
                                             text_bound(error, 12, probe->value, probe->error)));
        else
            text_table_line(table, result_no_value(result, i, value));
    }
    text_table_print(table, stdout, 2);
    if (result->count > MOST_LINES)
        printf(_("  the first %d of %zu points; --json prints all of them, -o FILE.csv writes them\n"), MOST_LINES,
               result->count);
    else
        printf(_("  --json prints all that is known of them, light by light\n"));
    print_enclosed(result);
    fputc('\n', stdout);
}

static void print_text(const struct result *result, const char *name)
{
    text_print_escaped(stdout, name);
    printf(_(": %s in %s\n\n"), _(result_quantity_word(result)), text_unit(result_unit(result)));
    if (result->count > MOST_IN_DETAIL)
        print_lines(result);
    for (size_t i = 0; result->count <= MOST_IN_DETAIL && i < result->count; i++) {
        print_point(result, i);
        fputc('\n', stdout);
    }
    result_print_conventions(result->scene, &result->use);
}

static void print(const struct result *result, const struct loaded *loaded)
{
    const struct options *options = result->options;

    if (result->count == 0 && !options->quiet)
        message_note(_("%s has no points; name some with -p X,Y, --at X,Y,Z,NX,NY,NZ or --points FILE"), loaded->name);
    if (options->json)
        result_print_json(result);
    else if (result->count > 0 && standard_output_is_free(options))
        print_text(result, loaded->name);
}

static int probe(const struct options *options, const struct loaded *loaded)
{
    struct result result;
    const bool shows_pixels = options->json || probe_table_is_json(options);
    int code = result_probe(options, loaded->scene, shows_pixels, loaded->diagnostics, &result);

    if (code == EXIT_DONE || code == EXIT_TOLERANCE) {
        const int file_code = probe_table_write(&result);

        print(&result, loaded);
        code = file_code == EXIT_DONE ? code : file_code;
    }
    result_clear(&result);
    return code;
}

static int run(const struct options *options)
{
    const int code = outputs_check(options, probe_table_check_name);

    return code == EXIT_DONE ? load_and(options, probe) : code;
}

const struct command command_probe = {
    .name = "probe",
    .bit = COMMAND_PROBE,
    .operand = N_("SCENE"),
    .endings = ".csv .npy .json",
    .summary = N_("compute exact values at points, light by light"),
    .description = N_("Prints the exact value at each point, with a bound of its error and the share of each light. "
                      "The points are those of -p, --at and --points or, without any, the scene's own. A free element "
                      "that lies on a surface, to 1e-9 of its size, belongs to it; elsewhere it has the material of "
                      "surfaces[0], unless --material names another. It is seen as the scene says, unless --view gives "
                      "a direction, and every surface that stands in the way of a source shades it. "
                      "Where surfaces reflect light, the picture's value at the pixel of a point is told in JSON "
                      "alone: it takes a solution for all of the picture. "
                      "Each FILE of -o appears whole or not at all: .csv is a table, .npy the values alone "
                      "(float64, NaN where there is none), .json what --json prints."),
    .examples = "luxel probe my.yaml -p 0,0 -p -150,0 --json\n"
                "luxel probe --at 0,0,1300,0,0,1 --quantity irradiance\n"
                "luxel probe my.yaml --points places.csv -o values.csv",
    .run = run,
};
