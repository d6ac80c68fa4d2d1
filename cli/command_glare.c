/* SPDX-License-Identifier: MIT */
/* luxel glare: the unified glare rating of observers in a scene, light by light. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "grid_limits.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "result.h"
#include "text.h"
#include "work.h"

/* Reasons as JSON has them. */
static const char *const reason_names[] = {
    [LUXEL_GLARE_COUNTS] = "counts", [LUXEL_GLARE_NO_AREA] = "no_area", [LUXEL_GLARE_UNSEEN] = "unseen",
    [LUXEL_GLARE_HIDDEN] = "hidden", [LUXEL_GLARE_DARK] = "dark",       [LUXEL_GLARE_BACKGROUND] = "background",
};

/* Ratings of the observers of --eye, else of those of the scene. */
struct ratings {
    const struct loaded *loaded;
    luxel_glare_sight *sights;
    luxel_glare **list; /* one for each */
    size_t count;
    bool is_of_scene;
    struct observers observers; /* those, which then have `list` */
};

/* ---- text ---- */

static void add_source(struct text_table *table, const luxel_glare_source *source)
{
    char *name = source->name ? luxel_escaped_text(source->name) : NULL;
    char place[TEXT_SIZE] = "";
    char light[TEXT_SIZE], luminance[TEXT_SIZE], angle[TEXT_SIZE], seen[TEXT_SIZE], index[TEXT_SIZE], share[TEXT_SIZE];
    const bool has_numbers = source->solid_angle > 0;

    if (source->places > 1)
        text_format(place, _(", place %zu"), source->place + 1);
    text_format(light, "lights[%zu]%s%s%s", source->light, name ? " " : "", name ? name : "", place);
    text_table_row(table,
                   TEXT_CELLS(light, source->type, has_numbers ? text_value(luminance, 5, source->luminance) : "",
                              has_numbers ? text_value(angle, 4, source->solid_angle) : "",
                              has_numbers ? text_format(seen, "%.4g %%", 100 * source->seen) : "",
                              isfinite(source->position_index) && has_numbers
                                  ? text_format(index, "%.4g", source->position_index)
                                  : "",
                              source->reason == LUXEL_GLARE_COUNTS ? text_format(share, "%.2f %%", 100 * source->share)
                                                                   : _(luxel_glare_reason_words(source->reason))));
    luxel_text_free(name);
}

static void print_rating(const struct ratings *ratings, size_t i)
{
    const luxel_glare *glare = ratings->list[i];
    const luxel_glare_sight *sight = &ratings->sights[i];
    struct text_table *table = text_table_new("llrrrrr");
    char place[TEXT_SIZE], value[TEXT_SIZE], background[TEXT_SIZE];

    printf(_("the eye at %s mm, looking along (%.6g, %.6g, %.6g)\n"), text_lengths(sight->eye_mm, 3, place),
           sight->view[0], sight->view[1], sight->view[2]);
    /* the rating is defined to a tenth: a bound below its rounding says nothing */
    if (glare->has_rating && glare->rating.error < 0.05)
        printf(_("  UGR %.1f\n"), glare->rating.value);
    else if (glare->has_rating)
        printf(_("  UGR %s\n"), text_value_bound(value, 6, glare->rating.value, glare->rating.error));
    else
        printf(glare->background.value > 0 ? _("  no UGR: nothing dazzles\n")
                                           : _("  no UGR: the background is dark, as nothing reflects light\n"));
    printf(_("  background luminance %s cd/m²\n"),
           text_value_bound(background, 6, glare->background.value, glare->background.error));
    text_table_row(table, TEXT_CELLS(_("light"), _("type"), _("luminance, cd/m²"), _("solid angle, sr"), _("seen"),
                                     _("position index"), _("share of the glare")));
    for (size_t k = 0; k < glare->source_count; k++)
        add_source(table, &glare->sources[k]);
    text_table_print(table, stdout, 4);
}

/* ---- JSON ---- */

static void write_source(struct json *json, const luxel_glare_source *source)
{
    json_open(json, NULL, '{');
    json_whole(json, "light", source->light);
    json_text(json, "type", source->type);
    json_text(json, "name", source->name);
    if (source->places > 1)
        json_whole(json, "place", source->place);
    json_text(json, "status", reason_names[source->reason]);
    json_number(json, "luminance", source->luminance);
    json_number(json, "solid_angle", source->solid_angle);
    json_number(json, "seen", source->seen);
    json_number(json, "position_index", source->position_index);
    json_number(json, "share", source->share);
    json_close(json, '}');
}

static void write_rating(struct json *json, const struct ratings *ratings, size_t i)
{
    const luxel_glare *glare = ratings->list[i];
    const char *name = NULL;

    json_open(json, NULL, '{');
    if (ratings->is_of_scene) {
        luxel_scene_observer(ratings->loaded->scene, i, &name, NULL);
        json_text(json, "name", name);
    }
    json_numbers(json, "eye", ratings->sights[i].eye_mm, 3);
    json_numbers(json, "view", ratings->sights[i].view, 3);
    result_write_rating(json, glare);
    if (ratings->is_of_scene)
        limits_write(json, &ratings->observers.judged[i]);
    json_open(json, "sources", '[');
    for (size_t k = 0; k < glare->source_count; k++)
        write_source(json, &glare->sources[k]);
    json_close(json, ']');
    json_close(json, '}');
}

/* The lights of each observer that is alone; tables of those with several places. */
static void print_text(const struct ratings *ratings)
{
    text_print_escaped(stdout, ratings->loaded->name);
    printf(_(": unified glare rating\n"));
    if (ratings->is_of_scene) {
        fputc('\n', stdout);
        observers_print(&ratings->observers);
    }
    for (size_t i = 0; i < ratings->count; i++) {
        luxel_observer_places places = {.count = 1};

        if (ratings->is_of_scene)
            luxel_scene_observer_places(ratings->loaded->scene, i, &places);
        if (places.count > 1)
            continue;
        if (i > 0 || !ratings->is_of_scene)
            fputc('\n', stdout);
        print_rating(ratings, i);
    }
}

static void print(const struct ratings *ratings, const struct options *options)
{
    struct json json = {.stream = stdout};

    if (!options->json) {
        print_text(ratings);
        return;
    }
    json_open(&json, NULL, '{');
    json_text(&json, "unit", "cd/m²");
    json_open(&json, "observers", '[');
    for (size_t i = 0; i < ratings->count; i++)
        write_rating(&json, ratings, i);
    json_close(&json, ']');
    json_close(&json, '}');
}

/* ---- the command ---- */

/* The observers of --eye, else those of the scene. */
static void take_sights(struct ratings *ratings, const struct options *options)
{
    ratings->is_of_scene = options->place_count == 0;
    ratings->count = ratings->is_of_scene ? luxel_scene_observer_count(ratings->loaded->scene) : options->place_count;
    ratings->sights = message_allocate(ratings->count, sizeof *ratings->sights);
    for (size_t i = 0; i < ratings->count; i++) {
        luxel_glare_sight *sight = &ratings->sights[i];

        *sight = (luxel_glare_sight){.eye_mm = {0}};
        if (ratings->is_of_scene) {
            luxel_scene_observer(ratings->loaded->scene, i, NULL, sight);
        } else {
            memcpy(sight->eye_mm, options->places[i].numbers, sizeof sight->eye_mm);
            memcpy(sight->view, options->places[i].numbers + 3, sizeof sight->view);
        }
        memcpy(sight->up, options->up, sizeof sight->up);
    }
}

static luxel_status rate_all(struct ratings *ratings, const luxel_settings *settings)
{
    luxel_status status = LUXEL_OK;

    if (ratings->is_of_scene) {
        status = observers_rate(ratings->loaded->scene, settings, ratings->loaded->diagnostics, &ratings->observers);
        ratings->list = ratings->observers.list;
        return status;
    }
    ratings->list = message_allocate(ratings->count, sizeof *ratings->list);
    for (size_t i = 0; i < ratings->count && status == LUXEL_OK; i++)
        status = luxel_find_glare(ratings->loaded->scene, settings, &ratings->sights[i], ratings->loaded->diagnostics,
                                  &ratings->list[i]);
    return status;
}

static void clear(struct ratings *ratings)
{
    if (ratings->is_of_scene) {
        observers_clear(&ratings->observers);
    } else {
        for (size_t i = 0; i < ratings->count; i++)
            luxel_glare_free(ratings->list[i]);
        free(ratings->list);
    }
    free(ratings->sights);
}

static int rate(const struct options *options, const struct loaded *loaded)
{
    struct ratings ratings = {.loaded = loaded};
    struct work work;
    int code;

    take_sights(&ratings, options);
    if (ratings.count == 0) {
        free(ratings.sights);
        message_error(_("luxel glare needs an observer, and %s has none"), loaded->name);
        message_hint(_("name one with --eye X,Y,Z,VX,VY,VZ: where the eye is, in mm, and where it looks; or give the "
                       "scene observers"));
        return EXIT_USAGE;
    }
    if (strcmp(luxel_scene_unit(loaded->scene, LUXEL_IRRADIANCE), "W/m²") == 0) {
        message_error(_("%s is in radiometric units, and glare is rated by luminances"), loaded->name);
        message_hint(_("units: photometric, or -s units=photometric"));
        free(ratings.sights);
        return EXIT_SCENE;
    }
    work_begin(&work, options);
    code = work_end(&work, rate_all(&ratings, &work.settings), loaded->diagnostics);
    if (code == EXIT_DONE) {
        for (size_t i = 0; i < ratings.count; i++)
            code = ratings.list[i]->reached ? code : EXIT_TOLERANCE;
        print(&ratings, options);
        if (code == EXIT_TOLERANCE)
            message_error(_("reflected light is not known as well as --reflected-error asks for; the bounds hold"));
    }
    clear(&ratings);
    return code;
}

static int run(const struct options *options)
{
    return load_and(options, rate);
}

const struct command command_glare = {
    .name = "glare",
    .bit = COMMAND_GLARE,
    .operand = N_("SCENE"),
    .endings = "",
    .summary = N_("the unified glare rating (UGR) of observers"),
    .description = N_(
        "Prints how much the lights of a scene dazzle an observer: the unified glare rating of CIE 117 with a bound of "
        "its error, the luminance of the background, and for each light its luminance, the solid angle and the "
        "position index under which it is seen, how much of it surfaces leave to be seen, and its share of the glare. "
        "The background is the light that reaches the eye by reflections, which the scene must ask for (reflections), "
        "and as ambient light. A luminaire that shines as a point counts with the luminous opening of its file. "
        "Without "
        "--eye the observers of the scene are rated and judged by their limits; one with several places (size, n) is a "
        "table, and one without a view looks in four level directions."),
    .examples = "luxel glare office -s reflections=1 --eye 0,1200,5300,0,0,-1\n"
                "luxel glare room.yaml --eye 0,-1900,1200,0,1,0 --eye 1900,0,1200,-1,0,0 --json",
    .run = run,
};
