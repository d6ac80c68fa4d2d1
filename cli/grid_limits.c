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

/* ---- limits ---- */

struct judged limits_of_grid(const luxel_scene *scene, size_t i, const luxel_grid *grid)
{
    struct judged judged = {.count = 0};

    luxel_judge_grid(scene, i, grid, judged.list, &judged.count);
    return judged;
}

const char *limits_name(const luxel_limit *limit)
{
    static const struct {
        const char *key, *words;
    } known[] = {{"average", N_("average")},
                 {"minimum", N_("minimum")},
                 {"maximum", N_("maximum")},
                 {"uniformity", N_("uniformity U0")},
                 {"ugr", "UGR"}};

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strcmp(known[i].key, limit->name) == 0)
            return _(known[i].words);
    return limit->is_most ? _("maximum / minimum") : _("minimum / maximum");
}

bool limits_have_unit(const luxel_limit *limit)
{
    return strcmp(limit->name, "average") == 0 || strcmp(limit->name, "minimum") == 0 ||
           strcmp(limit->name, "maximum") == 0;
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

        text_format(wanted, limit->is_most ? _("at most %.6g%s%s") : _("at least %.6g%s%s"), limit->wanted,
                    limits_have_unit(limit) ? " " : "", limits_have_unit(limit) ? text_unit(unit) : "");
        text_table_row(table,
                       TEXT_CELLS(limits_name(limit), wanted,
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

void observers_print(const struct observers *observers)
{
    for (size_t i = 0; i < observers->count; i++) {
        const luxel_glare *glare = observers->list[i];
        const size_t without = count_without_area(glare);
        const char *name = NULL;
        luxel_glare_sight sight;
        char place[TEXT_SIZE], value[TEXT_SIZE];

        luxel_scene_observer(observers->scene, i, &name, &sight);
        if (name)
            text_print_escaped(stdout, name);
        else
            printf(_("observer %zu"), i + 1);
        printf(_(": the eye at %s mm, looking along (%.6g, %.6g, %.6g)\n"), text_lengths(sight.eye_mm, 3, place),
               sight.view[0], sight.view[1], sight.view[2]);
        if (glare->has_rating)
            printf(_("  UGR %s\n"), text_value_bound(value, 6, glare->rating.value, glare->rating.error));
        else
            printf(glare->background.value > 0 ? _("  no UGR: nothing dazzles\n")
                                               : _("  no UGR: the background is dark, as nothing reflects light\n"));
        if (without > 0)
            printf(ngettext("  %zu light has no luminous area and is left out: UGR may be greater\n",
                            "  %zu lights have no luminous area and are left out: UGR may be greater\n", without),
                   without);
        limits_print(&observers->judged[i], "");
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
