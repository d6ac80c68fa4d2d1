/* SPDX-License-Identifier: MIT */
/* luxel explain: the whole calculation of a value, and what every other convention would make of it. */
#include <luxel/luxel.h>

#include <stdlib.h>

#include "../front/language.h"
#include "cli.h"
#include "json.h"
#include "lights.h"
#include "load.h"
#include "message.h"
#include "outputs.h"
#include "result.h"
#include "text.h"

/* The points that are asked for: those of -p, else the scene's own, else the screen's centre. */
static size_t point_count(const struct options *options, const luxel_scene *scene)
{
    const size_t own = luxel_scene_point_count(scene);

    return options->place_count > 0 ? options->place_count : own > 0 ? own : 1;
}

static void point_at(const struct options *options, const luxel_scene *scene, size_t i, double point[2])
{
    point[0] = point[1] = 0.0;
    if (options->place_count > 0) {
        point[0] = options->places[i].numbers[0];
        point[1] = options->places[i].numbers[1];
    } else if (luxel_scene_point_count(scene) > 0) {
        luxel_scene_point(scene, i, &point[0], &point[1]);
    }
}

static int explain_point(const struct options *options, const struct loaded *loaded, const double point[2])
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_document *document = NULL;
    luxel_status status =
        luxel_explain(loaded->scene, &options->settings, point[0], point[1], &language, loaded->diagnostics, &document);
    int code = EXIT_DONE;
    char *text;

    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    for (size_t i = 0; i < options->output_count; i++) {
        status = luxel_document_write(document, options->outputs[i], loaded->diagnostics);
        if (status != LUXEL_OK)
            code = message_failure(status, loaded->diagnostics);
        luxel_diagnostics_clear(loaded->diagnostics);
    }
    if (options->prints_document) {
        text = luxel_document_write_text(document, (luxel_document_format)options->format);
        fputs(text ? text : "", stdout);
        if (!text) {
            message_error(_("out of memory"));
            code = EXIT_SCENE;
        }
        luxel_text_free(text);
    }
    luxel_document_free(document);
    return code;
}

static void write_alternative(struct json *json, const luxel_alternative *alternative)
{
    json_open(json, NULL, '{');
    json_text(json, "convention", alternative->convention);
    json_text(json, "choice", alternative->choice);
    json_text(json, "meaning", alternative->meaning);
    json_bool(json, "present", alternative->is_present);
    if (alternative->has_value) {
        json_number(json, "value", alternative->value);
        json_number(json, "error", alternative->error);
    } else {
        json_null(json, "value");
        json_null(json, "error");
    }
    json_text(json, "assignment", alternative->assignment);
    json_close(json, '}');
}

/* The colour of a value, and what each light has of it: its own channels at luminance 1, and what they become. */
static void write_channels(struct json *json, const luxel_scene *scene, const luxel_probe *probe)
{
    result_write_color(json, &probe->color);
    json_open(json, "channels", '[');
    for (size_t i = 0; probe->has_value && i < probe->share_count; i++) {
        double lamp[3] = {0.0, 0.0, 0.0};

        luxel_scene_light_rgb(scene, probe->shares[i].light, lamp);
        json_open(json, NULL, '{');
        json_whole(json, "light", probe->shares[i].light);
        json_numbers(json, "lamp", lamp, 3);
        json_numbers(json, "value", probe->shares[i].color->rgb, 3);
        json_numbers(json, "error", probe->shares[i].color->error, 3);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static int write_point(struct json *json, const struct options *options, const struct loaded *loaded,
                       const double point[2])
{
    luxel_probe *probe = NULL;
    luxel_alternatives *alternatives = NULL;
    luxel_settings settings = options->settings;

    settings.skip_reflected_pixels = true;
    luxel_status status = luxel_probe_screen(loaded->scene, &settings, point[0], point[1], loaded->diagnostics, &probe);

    if (status == LUXEL_OK)
        status = luxel_find_alternatives(loaded->scene, &options->settings, point[0], point[1], loaded->diagnostics,
                                         &alternatives);
    if (status == LUXEL_OK) {
        json_open(json, NULL, '{');
        json_numbers(json, "screen", point, 2);
        json_bool(json, "on_surface", probe->on_surface);
        if (probe->has_value) {
            json_number(json, "value", probe->value);
            json_number(json, "error", probe->error);
        } else {
            json_null(json, "value");
            json_null(json, "error");
        }
        if (luxel_scene_has_color(loaded->scene))
            write_channels(json, loaded->scene, probe);
        result_write_reflected(json, probe);
        result_write_albedo(json, loaded->scene, probe);
        json_open(json, "alternatives", '[');
        for (size_t i = 0; i < alternatives->count; i++)
            write_alternative(json, &alternatives->list[i]);
        json_close(json, ']');
        json_close(json, '}');
    }
    luxel_alternatives_free(alternatives);
    luxel_probe_free(probe);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
}

/* Everything is found before anything is printed, so that an error leaves no half of an object. */
static int print_json(const struct options *options, const struct loaded *loaded)
{
    char *bytes = NULL;
    size_t size = 0;
    const luxel_conventions_use use = result_use_of_screen(options, true);
    struct json json = {.stream = open_memstream(&bytes, &size)};
    int code = EXIT_DONE;

    if (!json.stream) {
        message_error(_("out of memory"));
        return EXIT_SCENE;
    }
    struct light_strengths lights = lights_measure(loaded->scene);
    json_open(&json, NULL, '{');
    json_text(&json, "quantity", options_quantity_name(options->settings.quantity));
    json_text(&json, "unit", luxel_settings_unit(loaded->scene, &options->settings));
    json_open(&json, "points", '[');
    for (size_t i = 0; code == EXIT_DONE && i < point_count(options, loaded->scene); i++) {
        double point[2];

        point_at(options, loaded->scene, i, point);
        code = write_point(&json, options, loaded, point);
    }
    json_close(&json, ']');
    lights_write(&json, &lights);
    lights_clear(&lights);
    result_write_conventions(&json, loaded->scene, &use);
    json_close(&json, '}');
    if (fclose(json.stream) == 0 && code == EXIT_DONE)
        fwrite(bytes, 1, size, stdout);
    free(bytes);
    return code;
}

static int explain(const struct options *options, const struct loaded *loaded)
{
    const size_t count = point_count(options, loaded->scene);
    int code = EXIT_DONE;

    if (options->output_count > 0 && count > 1) {
        message_error(_("-o holds the explanation of one point: name it with -p X,Y"));
        return EXIT_USAGE;
    }
    if (options->json)
        return print_json(options, loaded);
    for (size_t i = 0; i < count && code == EXIT_DONE; i++) {
        double point[2];

        point_at(options, loaded->scene, i, point);
        if (i > 0)
            fputs("\n\n", stdout);
        code = explain_point(options, loaded, point);
    }
    return code;
}

static int run(const struct options *options)
{
    const int code = outputs_check(options, luxel_check_document_name);

    return code == EXIT_DONE ? load_and(options, explain) : code;
}

const struct command command_explain = {
    .name = "explain",
    .bit = COMMAND_EXPLAIN,
    .operand = N_("SCENE"),
    .endings = ".txt .md .tex .html",
    .summary = N_("the whole calculation of a value, and what other conventions give"),
    .description = N_("Explains the value at each point step by step, every formula with its numbers, and lists beside "
                      "every convention what its other choices would give: so you see why another program says "
                      "something else. The points are those of -p, or the scene's own, or the screen's centre."),
    .examples = "luxel explain -p 0,0\n"
                "luxel explain my.yaml -p 150,0 -o value.html\n"
                "luxel explain my.yaml -p 150,0 --format markdown",
    .run = run,
};
