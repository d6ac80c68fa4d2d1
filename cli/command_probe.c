/* SPDX-License-Identifier: MIT */
/* luxel probe: exact values at single places, light by light. */
#include <stdlib.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "result.h"
#include "text.h"

/* "lights[0] window" */
static void name_light(const luxel_light_share *share, char buffer[TEXT_SIZE])
{
    char *name = share->name ? luxel_escaped_text(share->name) : NULL;

    text_format(buffer, "lights[%zu]%s%s", share->light, name ? " " : "", name ? name : "");
    luxel_text_free(name);
}

/* The number of points only where some source was split into such. */
static void print_shares(const luxel_probe *probe)
{
    bool split = false;

    for (size_t i = 0; i < probe->share_count; i++)
        split = split || probe->shares[i].parts > 0;

    struct text_table *table = text_table_new(split ? "llrrrrr" : "llrrrr");

    text_table_row(table, TEXT_CELLS(_("light"), _("type"), _("irradiance"), _("diffuse"), _("highlight"),
                                     _("error at most"), split ? _("parts") : NULL));
    for (size_t i = 0; i < probe->share_count; i++) {
        const luxel_light_share *share = &probe->shares[i];
        char name[TEXT_SIZE], irradiance[TEXT_SIZE], diffuse[TEXT_SIZE], specular[TEXT_SIZE], error[TEXT_SIZE];
        char parts[TEXT_SIZE];

        name_light(share, name);
        text_table_row(table,
                       TEXT_CELLS(name, share->type, text_format(irradiance, "%.12g", share->irradiance),
                                  text_format(diffuse, "%.12g", share->diffuse),
                                  text_format(specular, "%.12g", share->specular), text_error(share->error, error),
                                  split ? text_format(parts, "%zu", share->parts) : NULL));
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

static void print_point(const struct result *result, size_t i)
{
    const luxel_probe *probe = result->probes[i];
    char name[TEXT_SIZE], error[TEXT_SIZE], position[TEXT_SIZE];

    if (!probe->has_value) {
        printf("%s\n", result_no_value(result, i, name));
        return;
    }
    printf("%s: %.15g ± %s %s\n", result_point_name(result, i, name), probe->value, text_error(probe->error, error),
           _(result_unit(result)));
    printf(_("  position %s mm, normal (%.9g, %.9g, %.9g)\n"), text_lengths(probe->position_mm, 3, position),
           probe->normal[0] + 0.0, probe->normal[1] + 0.0, probe->normal[2] + 0.0);
    print_pixel(probe);
    if (probe->share_count > 0)
        print_shares(probe);
}

static void print_text(const struct result *result, const char *name)
{
    text_print_escaped(stdout, name);
    printf(_(": %s in %s\n\n"), _(result_quantity_word(result)), _(result_unit(result)));
    for (size_t i = 0; i < result->count; i++) {
        print_point(result, i);
        fputc('\n', stdout);
    }
    result_print_conventions(result->scene);
}

static int probe(const struct options *options, const struct loaded *loaded)
{
    struct result result;
    const int code = result_probe(options, loaded->scene, loaded->diagnostics, &result);

    if (code == EXIT_DONE || code == EXIT_TOLERANCE) {
        if (result.count == 0 && !options->quiet)
            message_note(_("%s has no points; name some with -p X,Y or --at X,Y,Z,NX,NY,NZ"), loaded->name);
        if (options->json)
            result_print_json(&result);
        else if (result.count > 0)
            print_text(&result, loaded->name);
    }
    result_clear(&result);
    return code;
}

static int run(const struct options *options)
{
    return load_and(options, probe);
}

const struct command command_probe = {
    .name = "probe",
    .bit = COMMAND_PROBE,
    .operand = N_("SCENE"),
    .summary = N_("compute exact values at points, light by light"),
    .description = N_("Prints the exact value at each point, with a bound of its error and the share of each light. "
                      "The points are those of -p and --at or, without any, the scene's own."),
    .examples = "luxel probe my.yaml -p 0,0 -p -150,0 --json\n"
                "luxel probe --at 0,0,1300,0,0,1 --quantity irradiance",
    .run = run,
};
