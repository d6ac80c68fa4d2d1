/* SPDX-License-Identifier: MIT */
/* Verdicts by limits, as text and as JSON. */
#include "grid_limits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"
#include "result.h"
#include "text.h"

enum { LEVEL_VIEWS = 4 };

/* ---- limits ---- */

struct judged limits_of_grid(const luxel_scene *scene, size_t i, const luxel_grid *grid)
{
    struct judged judged = {.count = 0};

    luxel_judge_grid_and_areas(scene, i, grid, judged.list, &judged.count);
    return judged;
}

void limits_print(const struct judged *judged, const char *unit)
{
    struct text_table *table;

    if (judged->count == 0)
        return;
    table = text_table_new("llll");
    for (size_t i = 0; i < judged->count; i++) {
        const luxel_limit *limit = &judged->list[i];
        char wanted[TEXT_SIZE], value[TEXT_SIZE];

        if (strcmp(limit->name, "share") == 0)
            text_format(wanted, _("at least %.6g %% from %.6g %s on"), limit->wanted, limit->above, text_unit(unit));
        else
            text_format(wanted, limit->is_most ? _("at most %.6g%s%s") : _("at least %.6g%s%s"), limit->wanted,
                        luxel_limit_has_unit(limit) ? " " : "", luxel_limit_has_unit(limit) ? text_unit(unit) : "");
        text_table_row(table,
                       TEXT_CELLS(_(luxel_limit_word(limit)), wanted,
                                  limit->has_value ? text_value_bound(value, 6, limit->value.value, limit->value.error)
                                                   : _("none"),
                                  _(luxel_verdict_word(limit->verdict))));
    }
    printf(_("  limits\n"));
    text_table_print(table, stdout, 4);
}

void limits_write(struct json *json, const struct judged *judged)
{
    if (judged->count == 0)
        return;
    json_open(json, "limits", '[');
    for (size_t i = 0; i < judged->count; i++) {
        const luxel_limit *limit = &judged->list[i];

        json_open(json, NULL, '{');
        json_text(json, "name", limit->name);
        json_number(json, "wanted", limit->wanted);
        if (strcmp(limit->name, "share") == 0)
            json_number(json, "above", limit->above);
        json_number(json, "value", limit->has_value ? limit->value.value : (double)NAN);
        json_number(json, "error", limit->has_value ? limit->value.error : (double)NAN);
        json_text(json, "verdict", luxel_verdict_word(limit->verdict));
        json_close(json, '}');
    }
    json_close(json, ']');
}

/* ---- observers ---- */

luxel_status observers_rate(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct observers *observers)
{
    const size_t count = luxel_scene_observer_count(scene);
    luxel_status status = LUXEL_OK;

    *observers = (struct observers){.scene = scene,
                                    .list = message_allocate(count, sizeof *observers->list),
                                    .judged = message_allocate(count, sizeof *observers->judged)};
    while (observers->count < count && status == LUXEL_OK) {
        const size_t i = observers->count;
        luxel_glare_sight sight;

        luxel_scene_observer(scene, i, NULL, &sight);
        status = luxel_find_glare(scene, settings, &sight, diagnostics, &observers->list[i]);
        if (status != LUXEL_OK)
            break;
        luxel_judge_glare(scene, i, observers->list[i], observers->judged[i].list, &observers->judged[i].count);
        observers->count++;
    }
    return status;
}

void observers_clear(struct observers *observers)
{
    for (size_t i = 0; i < observers->count; i++)
        luxel_glare_free(observers->list[i]);
    free(observers->list);
    free(observers->judged);
}

/* How many lights without an area shine at the eye. */
static size_t count_without_area(const luxel_glare *glare)
{
    size_t count = 0;

    for (size_t i = 0; i < glare->source_count; i++)
        count += glare->sources[i].reason == LUXEL_GLARE_NO_AREA;
    return count;
}

/* "desk", or "observer 2". */
static void print_name(const struct observers *observers, size_t i, size_t number)
{
    const char *name = NULL;

    luxel_scene_observer(observers->scene, i, &name, NULL);
    if (name)
        text_print_escaped(stdout, name);
    else
        printf(_("observer %zu"), number);
}

/* How many of some observers leave lights out, at most. */
static void print_left_out(const struct observers *observers, const luxel_observer_places *places)
{
    size_t without = 0;

    for (size_t i = places->first; i < places->first + places->count; i++) {
        const size_t here = count_without_area(observers->list[i]);

        without = here > without ? here : without;
    }
    if (without > 0)
        printf(ngettext("  %zu light has no luminous area and is left out: UGR may be greater\n",
                        "  %zu lights have no luminous area and are left out: UGR may be greater\n", without),
               without);
}

static void print_single(const struct observers *observers, size_t i, size_t number)
{
    const luxel_glare *glare = observers->list[i];
    luxel_glare_sight sight;
    char place[TEXT_SIZE], value[TEXT_SIZE];

    luxel_scene_observer(observers->scene, i, NULL, &sight);
    print_name(observers, i, number);
    printf(_(": the eye at %s mm, looking along (%.6g, %.6g, %.6g)\n"), text_lengths(sight.eye_mm, 3, place),
           sight.view[0], sight.view[1], sight.view[2]);
    if (glare->has_rating)
        printf(_("  UGR %s\n"), text_value_bound(value, 6, glare->rating.value, glare->rating.error));
    else
        printf(glare->background.value > 0 ? _("  no UGR: nothing dazzles\n")
                                           : _("  no UGR: the background is dark, as nothing reflects light\n"));
}

/* The eye, and the ratings of all ways that it looks. */
static void add_place(struct text_table *table, const struct observers *observers, size_t first, unsigned views)
{
    char cells[LEVEL_VIEWS + 1][TEXT_SIZE];
    const char *row[LEVEL_VIEWS + 1];
    luxel_glare_sight sight;

    luxel_scene_observer(observers->scene, first, NULL, &sight);
    row[0] = text_lengths(sight.eye_mm, 3, cells[0]);
    for (unsigned k = 0; k < views; k++) {
        const luxel_glare *glare = observers->list[first + k];

        row[k + 1] = glare->has_rating ? text_format(cells[k + 1], "%.2f", glare->rating.value) : "-";
    }
    text_table_row(table, row);
}

/* Ratings rounded to hundredths, and how far all of them may be off with that. */
static void print_places(const struct observers *observers, const luxel_observer_places *places, size_t number)
{
    struct text_table *table = text_table_new(places->views > 1 ? "lrrrr" : "lr");
    char cells[LEVEL_VIEWS + 1][TEXT_SIZE], error[TEXT_SIZE];
    const char *row[LEVEL_VIEWS + 1] = {_("eye, mm")};
    double bound = 0;

    print_name(observers, places->first, number);
    printf(_(": UGR at %u × %u places, by the way the eye looks\n"), places->columns, places->rows);
    for (unsigned k = 0; k < places->views; k++) {
        luxel_glare_sight sight;

        luxel_scene_observer(observers->scene, places->first + k, NULL, &sight);
        row[k + 1] = text_format(cells[k + 1], "(%.3g, %.3g, %.3g)", sight.view[0], sight.view[1], sight.view[2]);
    }
    text_table_row(table, row);
    for (size_t i = places->first; i < places->first + places->count; i += places->views)
        add_place(table, observers, i, places->views);
    text_table_print(table, stdout, 2);
    for (size_t i = places->first; i < places->first + places->count; i++)
        if (observers->list[i]->has_rating)
            bound = fmax(bound, observers->list[i]->rating.error);
    printf(_("  error at most %s\n"), text_error(bound + 0.005, error));
}

/* Limits of observers that are one entry of the scene, as one. */
static struct judged judge_together(const struct observers *observers, const luxel_observer_places *places)
{
    struct judged judged = {.count = observers->judged[places->first].count};
    luxel_limit *limits = message_allocate(places->count, sizeof *limits);

    for (size_t k = 0; k < judged.count; k++) {
        for (size_t i = 0; i < places->count; i++)
            limits[i] = observers->judged[places->first + i].list[k];
        judged.list[k] = luxel_worst_limit(limits, places->count);
    }
    free(limits);
    return judged;
}

void observers_print(const struct observers *observers)
{
    luxel_observer_places places;
    size_t number = 1;

    for (size_t i = 0; i < observers->count; i += places.count, number++) {
        luxel_scene_observer_places(observers->scene, i, &places);
        if (places.count == 1)
            print_single(observers, i, number);
        else
            print_places(observers, &places, number);
        print_left_out(observers, &places);
        const struct judged judged = judge_together(observers, &places);

        limits_print(&judged, "");
        fputc('\n', stdout);
    }
}

void observers_write(struct json *json, const struct observers *observers)
{
    json_open(json, "observers", '[');
    for (size_t i = 0; i < observers->count; i++) {
        const luxel_glare *glare = observers->list[i];
        const char *name = NULL;
        luxel_glare_sight sight;

        luxel_scene_observer(observers->scene, i, &name, &sight);
        json_open(json, NULL, '{');
        json_text(json, "name", name);
        json_numbers(json, "eye", sight.eye_mm, 3);
        json_numbers(json, "view", sight.view, 3);
        result_write_rating(json, glare);
        limits_write(json, &observers->judged[i]);
        json_close(json, '}');
    }
    json_close(json, ']');
}

/* ---- all of them ---- */

bool limits_can_judge(const struct loaded *loaded)
{
    if (!luxel_scene_has_limits(loaded->scene)) {
        message_error(_("%s has no limits"), loaded->name);
        message_hint(_("give its grids some, such as -s 'grids[0].limits={average: 500, uniformity: 0.6}'"));
        return false;
    }
    if (luxel_scene_observer_count(loaded->scene) > 0 &&
        strcmp(luxel_scene_unit(loaded->scene, LUXEL_IRRADIANCE), "W/m²") == 0) {
        message_error(_("%s is in radiometric units, and glare is rated by luminances"), loaded->name);
        message_hint(_("units: photometric, or -s units=photometric"));
        return false;
    }
    return true;
}

static bool pass(const struct judged *judged)
{
    for (size_t i = 0; i < judged->count; i++)
        if (judged->list[i].verdict != LUXEL_PASS)
            return false;
    return true;
}

bool limits_all_pass(const luxel_scene *scene, const luxel_grid *const *grids, size_t count,
                     const struct observers *observers)
{
    for (size_t i = 0; i < count; i++) {
        const struct judged judged = limits_of_grid(scene, i, grids[i]);

        if (!pass(&judged))
            return false;
    }
    for (size_t i = 0; i < observers->count; i++)
        if (!pass(&observers->judged[i]))
            return false;
    return true;
}
