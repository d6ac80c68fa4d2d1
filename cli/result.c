/* SPDX-License-Identifier: MIT */
/* Results in their common forms.  JSON is an interface: its words are never translated. */
#include "result.h"

#include <stdlib.h>

#include "cli.h"
#include "lights.h"
#include "message.h"
#include "places.h"
#include "progress.h"
#include "work.h"

/* The library's part of it, which Ctrl-C ends. */
static int probe_places(const struct options *options, const struct places *places, bool shows_pixels,
                        luxel_diagnostics *diagnostics, struct result *result)
{
    struct work work;
    luxel_status status;

    work_begin(&work, options);
    work.settings.skip_reflected_pixels = !shows_pixels;
    status =
        luxel_probe_places(result->scene, &work.settings, places->list, places->count, diagnostics, &result->probes);
    if (status == LUXEL_OK)
        result->count = places->count;
    return work_end(&work, status, diagnostics);
}

int result_probe(const struct options *options, const luxel_scene *scene, bool shows_pixels,
                 luxel_diagnostics *diagnostics, struct result *result)
{
    struct places places;
    size_t missed = 0;
    int code;

    *result = (struct result){.scene = scene, .options = options};
    code = places_collect(options, scene, diagnostics, &places);
    if (code == EXIT_DONE)
        code = probe_places(options, &places, shows_pixels, diagnostics, result);
    places_clear(&places);
    if (code != EXIT_DONE)
        return code;
    result->surfaces = message_allocate(luxel_scene_surface_count(scene), sizeof *result->surfaces);
    result->use = places_use(options, scene, result->probes, result->surfaces);
    for (size_t i = 0; i < result->count; i++) {
        const luxel_probe *probe = luxel_probes_get(result->probes, i);
        missed += probe->has_value && !(probe->tolerance_reached && probe->reflected_reached);
    }
    if (missed > 0)
        message_tolerance(missed, result->count);
    return missed > 0 ? EXIT_TOLERANCE : EXIT_DONE;
}

void result_clear(struct result *result)
{
    luxel_probes_free(result->probes);
    free(result->surfaces);
}

const char *result_quantity_word(const struct result *result)
{
    return luxel_scene_quantity_word(result->scene, result->options->settings.quantity);
}

const char *result_unit(const struct result *result)
{
    return luxel_settings_unit(result->scene, &result->options->settings);
}

/* Why a point of a surface has no value: a format for the number of the light. */
static const char on_element[] = N_("the source lights[%zu] lies on the element");

const char *result_point_name(const struct result *result, size_t i, char buffer[TEXT_SIZE])
{
    const luxel_probe *probe = luxel_probes_get(result->probes, i);
    char place[TEXT_SIZE];

    if (probe->has_screen)
        text_lengths((const double[]){probe->x_mm, probe->y_mm}, 2, place);
    else
        text_lengths(probe->position_mm, 3, place);
    return text_format(buffer, "P%zu %s", i + 1, place);
}

const char *result_no_value(const struct result *result, size_t i, char buffer[TEXT_SIZE])
{
    const luxel_probe *probe = luxel_probes_get(result->probes, i);
    const bool off_screen = probe->has_screen && !probe->has_pixel;
    char name[TEXT_SIZE], reason[TEXT_SIZE];

    result_point_name(result, i, name);
    text_format(reason, probe->on_surface ? _(on_element) : _("off the surface"), probe->blocking_light);
    return text_format(buffer, "%s: %s%s", name, reason, off_screen ? _(", off the screen") : "");
}

void result_write_extremum(struct json *json, const char *key, const luxel_extremum *extremum)
{
    if (!extremum || !extremum->exists) {
        json_null(json, key);
        return;
    }
    json_open(json, key, '{');
    json_number(json, "value", extremum->value);
    json_wholes(json, "pixel", (const unsigned[]){extremum->column, extremum->row}, 2);
    json_numbers(json, "screen", (const double[]){extremum->x_mm, extremum->y_mm}, 2);
    json_close(json, '}');
}

static void write_statistics(struct json *json, const luxel_statistics *statistics)
{
    result_write_extremum(json, "max", statistics ? &statistics->maximum : NULL);
    result_write_extremum(json, "min", statistics ? &statistics->minimum : NULL);
    if (statistics && statistics->has_surface) {
        json_number(json, "mean", statistics->mean);
        json_number(json, "lit", statistics->lit);
    } else {
        json_null(json, "mean");
        json_null(json, "lit");
    }
}

static void write_rgb(struct json *json, const luxel_color *color)
{
    json_open(json, "rgb", '{');
    json_numbers(json, "value", color->rgb, 3);
    json_numbers(json, "error", color->error, 3);
    json_close(json, '}');
}

static void write_share(struct json *json, const struct light_strengths *lights, const luxel_light_share *share)
{
    json_open(json, NULL, '{');
    json_text(json, "type", share->type);
    json_number(json, "irradiance", share->irradiance);
    json_number(json, "diffuse", share->diffuse);
    json_number(json, "specular", share->specular);
    json_number(json, "error", share->error);
    json_whole(json, "index", share->light);
    lights_write_strength(json, lights, share->light);
    if (share->parts > 0)
        json_whole(json, "parts", share->parts);
    if (share->name)
        json_text(json, "name", share->name);
    if (share->color)
        write_rgb(json, share->color);
    json_close(json, '}');
}

/* The most places whose albedo is told, as it is an integral for each. */
enum { MOST_ALBEDOS = 1000 };

static void write_number_if(struct json *json, const char *key, bool exists, double value)
{
    if (exists)
        json_number(json, key, value);
    else
        json_null(json, key);
}

static void write_numbers_if(struct json *json, const char *key, bool exist, const double *values, size_t count)
{
    if (exist)
        json_numbers(json, key, values, count);
    else
        json_null(json, key);
}

/* What counts for a free element: its view, the surface whose material it has, and what it is inside of. */
static void write_element(struct json *json, const luxel_probe *probe)
{
    json_numbers(json, "view", probe->view, 3);
    json_open(json, "material", '{');
    if (probe->surface != SIZE_MAX)
        json_whole(json, "surface", probe->surface);
    else
        json_null(json, "surface");
    json_text(json, "name", probe->surface_name);
    if (probe->part_name)
        json_text(json, "wall", probe->part_name);
    json_bool(json, "lies_on_it", probe->lies_on_surface);
    json_close(json, '}');
    if (probe->is_enclosed)
        json_whole(json, "inside", probe->enclosing_surface);
    else
        json_null(json, "inside");
}

void result_write_derivative(struct json *json, const char *key, const luxel_derivative *derivative)
{
    const char *words = luxel_derivative_words(derivative->state);

    json_open(json, key, '{');
    write_number_if(json, "value", !words, derivative->value);
    write_number_if(json, "error", !words, derivative->error);
    if (words)
        json_text(json, "reason", words);
    else if (derivative->state == LUXEL_DERIVATIVE_ONE_SIDED)
        json_bool(json, "one_sided", true);
    json_close(json, '}');
}

void result_write_derivatives(struct json *json, const struct options *options, const luxel_derivatives *derivatives,
                              size_t place)
{
    json_open(json, "derivatives", '{');
    for (size_t k = 0; k < options->free_key_count; k++) {
        const char *key = options->free_keys[k];
        const size_t numbers = luxel_derivatives_numbers(derivatives, k);

        if (numbers > 1)
            json_open(json, key, '[');
        for (size_t i = 0; i < numbers; i++)
            result_write_derivative(json, numbers > 1 ? NULL : key, luxel_derivatives_get(derivatives, place, k, i));
        if (numbers > 1)
            json_close(json, ']');
    }
    json_close(json, '}');
}

/* `scene`: NULL where nobody waits for the albedo. */
static void write_probe(struct json *json, const struct result *result, size_t place, const luxel_scene *scene,
                        const struct light_strengths *lights, bool in_color)
{
    const luxel_probe *probe = luxel_probes_get(result->probes, place);
    char reason[TEXT_SIZE];

    json_open(json, NULL, '{');
    write_numbers_if(json, "screen", probe->has_screen, (const double[]){probe->x_mm, probe->y_mm}, 2);
    if (probe->has_pixel)
        json_wholes(json, "pixel", (const unsigned[]){probe->column, probe->row}, 2);
    else
        json_null(json, "pixel");
    json_bool(json, "on_surface", probe->on_surface);
    write_number_if(json, "value", probe->has_value, probe->value);
    write_number_if(json, "pixel_value", probe->on_surface && probe->has_pixel_value, probe->pixel_value);
    write_number_if(json, "error", probe->has_value, probe->error);
    if (in_color)
        result_write_color(json, &probe->color);
    write_numbers_if(json, "position", probe->on_surface, probe->position_mm, 3);
    write_numbers_if(json, "normal", probe->on_surface, probe->normal, 3);
    if (scene)
        result_write_albedo(json, scene, probe);
    if (!probe->has_screen)
        write_element(json, probe);
    json_open(json, "lights", '[');
    for (size_t i = 0; probe->has_value && i < probe->share_count; i++)
        write_share(json, lights, &probe->shares[i]);
    json_close(json, ']');
    result_write_reflected(json, probe);
    if (result->derivatives)
        result_write_derivatives(json, result->options, result->derivatives, place);
    if (probe->source_on_element)
        json_text(json, "reason", text_format(reason, on_element, probe->blocking_light));
    json_close(json, '}');
}

void result_write_seen(struct json *json, const double rgb[3])
{
    luxel_chromaticity seen = {.has_xy = false};

    if (rgb)
        luxel_find_chromaticity(rgb, &seen);
    write_numbers_if(json, "xy", seen.has_xy, seen.xy, 2);
    write_numbers_if(json, "uv", seen.has_xy, seen.uv, 2);
    write_number_if(json, "cct", seen.has_cct, seen.cct_k);
    write_number_if(json, "duv", seen.has_cct, seen.duv);
}

void result_write_color(struct json *json, const luxel_color *color)
{
    if (color->exists)
        write_rgb(json, color);
    else
        json_null(json, "rgb");
    result_write_seen(json, color->exists ? color->rgb : NULL);
}

const char *result_color_text(const luxel_color *color, char buffer[TEXT_SIZE])
{
    luxel_chromaticity seen;
    char channels[TEXT_SIZE];

    luxel_find_chromaticity(color->rgb, &seen);
    text_format(channels, "R, G, B %.6g, %.6g, %.6g", color->rgb[0], color->rgb[1], color->rgb[2]);
    if (seen.has_cct)
        text_format(buffer, _("%s; x, y %.5f, %.5f; u', v' %.5f, %.5f; %.0f K, Duv %.4f (nearest black body in u, v)"),
                    channels, seen.xy[0], seen.xy[1], seen.uv[0], seen.uv[1], seen.cct_k, seen.duv + 0.0);
    else if (seen.has_xy)
        text_format(buffer, _("%s; x, y %.5f, %.5f; u', v' %.5f, %.5f; no colour temperature"), channels, seen.xy[0],
                    seen.xy[1], seen.uv[0], seen.uv[1]);
    else
        text_format(buffer, "%s", channels);
    return buffer;
}

void result_write_reflected(struct json *json, const luxel_probe *probe)
{
    if (!probe->has_reflected)
        return;
    json_open(json, "reflected", '{');
    json_number(json, "irradiance", probe->reflected_irradiance);
    json_number(json, "value", probe->reflected.value);
    json_number(json, "error", probe->reflected.error);
    json_text(json, "ended", progress_end_word(probe->reflected_reached));
    json_close(json, '}');
}

luxel_conventions_use result_use_of_screen(const struct options *options, bool pixels)
{
    return (luxel_conventions_use){
        .screen = true, .pixels = pixels, .brightness = options->settings.quantity != LUXEL_IRRADIANCE};
}

void result_write_conventions(struct json *json, const luxel_scene *scene, const luxel_conventions_use *use)
{
    luxel_conventions *conventions = NULL;

    json_open(json, "conventions", '{');
    if (luxel_find_conventions(scene, use, &conventions) == LUXEL_OK)
        for (size_t i = 0; i < conventions->count; i++)
            json_text(json, conventions->list[i].key, conventions->list[i].value);
    json_close(json, '}');
    luxel_conventions_free(conventions);
}

void result_write_albedo(struct json *json, const luxel_scene *scene, const luxel_probe *probe)
{
    const double albedo = luxel_probe_albedo(scene, probe);

    write_number_if(json, "albedo", albedo >= 0, albedo);
}

void result_write_json(FILE *stream, const struct result *result)
{
    struct json json = {.stream = stream};
    struct light_strengths lights = lights_measure(result->scene);
    unsigned resolution[2] = {0, 0};

    luxel_scene_resolution(result->scene, &resolution[0], &resolution[1]);
    json_open(&json, NULL, '{');
    json_text(&json, "quantity", options_quantity_name(result->options->settings.quantity));
    json_text(&json, "unit", result_unit(result));
    json_wholes(&json, "resolution", resolution, 2);
    write_statistics(&json, result->statistics);
    json_open(&json, "points", '[');
    for (size_t i = 0; i < result->count; i++)
        write_probe(&json, result, i, result->count <= MOST_ALBEDOS ? result->scene : NULL, &lights,
                    luxel_scene_has_color(result->scene));
    json_close(&json, ']');
    if (result->statistics && result->statistics->has_reflected)
        json_number(&json, "reflected_error", result->statistics->reflected_error);
    if (result->statistics && result->statistics->mirrored_error > 0.0)
        json_number(&json, "mirrored_error", result->statistics->mirrored_error);
    result_write_extremum(&json, "min_reached", result->statistics ? &result->statistics->minimum_reached : NULL);
    lights_write(&json, &lights);
    result_write_conventions(&json, result->scene, &result->use);
    json_close(&json, '}');
    lights_clear(&lights);
}

void result_print_json(const struct result *result)
{
    result_write_json(stdout, result);
}

void result_print_conventions(const luxel_scene *scene, const luxel_conventions_use *use)
{
    luxel_conventions *conventions = NULL;
    char *line = NULL;
    size_t length;
    FILE *stream;

    if (luxel_find_conventions(scene, use, &conventions) != LUXEL_OK)
        return;
    stream = open_memstream(&line, &length);
    if (stream) {
        fputs(_("Conventions:"), stream);
        for (size_t i = 0; i < conventions->count; i++)
            fprintf(stream, "%s %s %s", i > 0 ? ";" : "", conventions->list[i].key, conventions->list[i].value);
        if (fclose(stream) == 0)
            text_definition(stdout, "", 0, line);
    }
    free(line);
    luxel_conventions_free(conventions);
}

void result_write_rating(struct json *json, const luxel_glare *glare)
{
    json_number_if(json, "ugr", glare->has_rating, glare->rating.value);
    json_number_if(json, "error", glare->has_rating, glare->rating.error);
    json_open(json, "background", '{');
    json_number(json, "value", glare->background.value);
    json_number(json, "error", glare->background.error);
    json_close(json, '}');
}
