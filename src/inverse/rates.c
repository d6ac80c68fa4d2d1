/* SPDX-License-Identifier: MIT */
/* Rates of a scene's constants from differences of prepared scenes. */
#include "rates.h"

#include <stdlib.h>
#include <string.h>

#include "../api/session.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../scene/colours.h"
#include "differences.h"
#include "steps.h"

/* A constant that a number changes. */
struct changing {
    size_t constant;
    struct lx_differences differences;
};

struct finding {
    const luxel_scene *scene;
    luxel_settings settings;
    bool is_bright;
    struct lx_prepared prepared; /* the scene as it is */
    struct lx_constants constants;
    struct lx_slopes *slopes;
};

/* The things that a key may move, by its place in the scene; false: it changes more than constants tell. */
static bool find_moving(const luxel_scene *scene, const struct lx_target *target, struct lx_moving *moving)
{
    const struct lx_place place = {.source = "key", .text = target->path, .length = strlen(target->path)};
    struct lx_path path;
    if (lx_follow_path(scene, &place, place.length, NULL, &path) != LUXEL_OK)
        return false;
    const char *root = path.segments[0].key;
    if (strcmp(root, "lights") == 0 || strcmp(root, "dimming") == 0 || strcmp(root, "maintenance_factor") == 0)
        return true;
    const bool is_surface = strcmp(root, "surfaces") == 0 && path.count > 2;
    if (is_surface && strncmp(path.segments[2].key, "material", strlen("material")) == 0)
        return true;
    if (is_surface)
        moving->surface = path.segments[1].index + 1;
    moving->moves = is_surface || strcmp(root, "observer") == 0;
    return moving->moves;
}

/* The constants of a changed scene; false: it is not the same but for them. */
static bool find_constants(const struct finding *finding, const struct lx_stepping *stepping, double change,
                           struct lx_constants *constants)
{
    luxel_scene *scene;
    struct lx_prepared prepared = {.scene = NULL};
    *constants = (struct lx_constants){.count = 0};
    if (lx_step_scene(stepping, change, NULL, &scene) != LUXEL_OK)
        return false;
    const bool good = lx_session_prepare(scene, &finding->settings, NULL, &prepared) == LUXEL_OK &&
                      lx_constants_are_alike(&finding->prepared, &prepared) &&
                      lx_constants_make(&prepared, finding->is_bright, constants) == 0;
    lx_prepared_clear(&prepared);
    luxel_scene_free(scene);
    return good;
}

/* Those that are others at a step's ends. */
static size_t find_changing(const struct finding *finding, const struct lx_stepping *stepping,
                            const struct lx_constants ends[2], struct changing *changing)
{
    const size_t sides = stepping->is_one_sided ? 1 : 2;
    size_t count = 0;
    for (size_t i = 0; i < finding->constants.count; i++) {
        const lx_bounded middle = finding->constants.list[i];
        bool changes = false;
        for (size_t side = 0; side < sides; side++)
            changes = changes || ends[side].list[i].value != middle.value;
        if (!changes)
            continue;
        changing[count].constant = i;
        lx_differences_begin(&changing[count].differences, middle.value, middle.error, stepping->is_one_sided);
        count++;
    }
    return count;
}

/* Adds a step to those that are not done yet; whether there are any. */
static bool add_step(const struct lx_stepping *stepping, double step, const struct lx_constants ends[2],
                     struct changing *changing, size_t count)
{
    bool is_open = false;
    for (size_t i = 0; i < count; i++) {
        struct lx_differences *differences = &changing[i].differences;
        double values[2] = {0.0, 0.0}, errors[2] = {0.0, 0.0};
        for (size_t side = 0; side < (stepping->is_one_sided ? 1u : 2u); side++) {
            values[side] = ends[side].list[changing[i].constant].value;
            errors[side] = ends[side].list[changing[i].constant].error;
        }
        if (!lx_differences_are_done(differences))
            lx_differences_add(differences, step, values, errors);
        is_open = is_open || !lx_differences_are_done(differences);
    }
    return is_open;
}

/* Keeps the rates that differences tell; false: some have none, or memory ran out. */
static bool keep_rates(struct lx_slopes *slopes, const struct changing *changing, size_t count, size_t number)
{
    for (size_t i = 0; i < count; i++) {
        const luxel_derivative rate = lx_differences_conclude(&changing[i].differences);
        if (luxel_derivative_words(rate.state) ||
            lx_reserve(&slopes->rates, &slopes->rate_capacity, slopes->rate_count + 1, sizeof *slopes->rates))
            return false;
        slopes->rates[slopes->rate_count++] =
            (struct lx_rate){.constant = changing[i].constant, .number = number, .rate = {rate.value, rate.error}};
    }
    return true;
}

/* The rates by number k of all, of one of its key's values; false: they are unknown. */
static bool find_rates(struct finding *finding, const struct lx_key *key, size_t target, size_t k,
                       struct changing *changing)
{
    struct lx_stepping stepping;
    size_t count = 0;
    bool is_open = true, known = true;
    if (lx_steps_find(finding->scene, key, target, k - key->offset, NULL, &stepping) != LUXEL_OK)
        return false;
    for (unsigned row = 0; row < LX_MOST_STEPS && is_open && known; row++) {
        const double step = lx_step_of(&stepping, row);
        struct lx_constants ends[2] = {{.count = 0}, {.count = 0}};
        if (step == 0.0)
            break;
        known = find_constants(finding, &stepping, step, &ends[0]) &&
                (stepping.is_one_sided || find_constants(finding, &stepping, -step, &ends[1]));
        if (known && row == 0)
            count = find_changing(finding, &stepping, ends, changing);
        is_open = known && add_step(&stepping, step, ends, changing, count);
        lx_constants_clear(&ends[0]);
        lx_constants_clear(&ends[1]);
    }
    finding->slopes->numbers[k].is_limited = finding->slopes->numbers[k].is_limited || stepping.is_one_sided;
    return known && keep_rates(finding->slopes, changing, count, k);
}

/* All numbers of a key. */
static void find_key(struct finding *finding, const struct lx_key *key, struct changing *changing)
{
    for (size_t k = key->offset; k < key->offset + key->count; k++) {
        struct lx_moving *number = &finding->slopes->numbers[k];
        number->is_known = true;
        for (size_t t = 0; t < key->target_count && number->is_known; t++) {
            const size_t before = finding->slopes->rate_count;
            /* several surfaces that move at once are more than is told of a number */
            number->is_known = find_moving(finding->scene, &key->targets[t], number) &&
                               (key->target_count == 1 || !number->moves) && find_rates(finding, key, t, k, changing);
            if (!number->is_known)
                finding->slopes->rate_count = before;
        }
        finding->slopes->moves = finding->slopes->moves || (number->is_known && number->moves);
    }
}

luxel_status lx_rates_find(const luxel_scene *scene, const luxel_settings *settings, const struct lx_keys *keys,
                           luxel_diagnostics *diagnostics, bool is_tried, struct lx_slopes *slopes)
{
    struct finding finding = {.scene = scene, .slopes = slopes};
    struct changing *changing = NULL;
    *slopes = (struct lx_slopes){.numbers = lx_new_array(keys->number_count + 1, sizeof *slopes->numbers),
                                 .number_count = keys->number_count};
    luxel_status status = slopes->numbers ? lx_settings_check(scene, settings, diagnostics, &finding.settings)
                                          : lx_out_of_memory(diagnostics);
    if (status != LUXEL_OK || !is_tried || lx_is_sum_of_channels(lx_scene_parameters(scene), finding.settings.quantity))
        return status;
    finding.is_bright = finding.settings.quantity != LUXEL_IRRADIANCE;
    finding.settings.progress = NULL;
    status = lx_session_prepare(scene, &finding.settings, diagnostics, &finding.prepared);
    if (status == LUXEL_OK && lx_constants_make(&finding.prepared, finding.is_bright, &finding.constants) == 0) {
        changing = lx_new_array(finding.constants.count + 1, sizeof *changing);
        for (size_t i = 0; changing && i < keys->count; i++)
            find_key(&finding, &keys->list[i], changing);
        slopes->constants = finding.constants;
        slopes->constants.list = NULL;
        lx_slopes_sort(slopes);
    }
    free(changing);
    lx_constants_clear(&finding.constants);
    lx_prepared_clear(&finding.prepared);
    return status;
}
