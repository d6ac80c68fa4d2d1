/* SPDX-License-Identifier: MIT */
/*
 * A search by linear programs (Griffith and Stewart): around where it stands, what each goal wants of each cell is
 * taken for linear in the numbers, within a region that grows while that comes true and shrinks where it does not.
 * The least of all that is wanted becomes as great as it can be or, with dimming, the flux as small as the goals
 * allow.
 */
#include "tuning.h"

#include <luxel/light.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../api/refuse.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "conclude.h"
#include "keys.h"
#include "linear_program.h"
#include "search.h"

enum { STARTS = 5, SLOW_STARTS = 2, MOST_STEPS = 80, TRIES = 3 };
/* The region: its first size, the greatest and the least, by the scales of the numbers; steps of differences. */
static const double FIRST_REACH = 0.2, MOST_REACH = 1, LEAST_REACH = 2e-5, STEP = 1e-4;
/* With dimming: how far above the goals, so that bounds and rounding leave them kept, and what a miss of them costs. */
static const double ABOVE = 1.0005, COST = 100;
/* Numbers are written to so much of their scale, which may cost so much; ends that are so near each other are one. */
static const double FINE = 1e-4, LOSS = 1e-3, NEAR = 1e-2;

struct tuning {
    struct lx_arranging *arranging;
    struct lx_superposition *goals;
    struct lx_keys keys;
    luxel_scene *plain; /* in which nothing is reflected */
    size_t numbers, cells;
    double *scale, *low, *high;
    double first_flux; /* of the scene as it is */
    /* Reflected light where the flux was that; of observers, the factor of their glare. */
    double *correction, correct_flux;
    double *slopes, *fluxes; /* numbers x cells, numbers */
    double *rows, *table;
    size_t *basis;
};

/* Numbers, and what they give. */
struct stand {
    double *numbers, *values;
    double flux, reserve, merit;
};

/* ---- values ---- */

static double flux_of(const luxel_scene *scene)
{
    double sum = 0, flux;
    for (size_t i = 0; i < luxel_scene_light_count(scene); i++)
        if (luxel_scene_light_enabled(scene, i) && luxel_scene_light_flux(scene, i, &flux) == LUXEL_OK &&
            isfinite(flux))
            sum += flux;
    return sum;
}

static luxel_status measure(const struct tuning *tuning, const double *numbers, double *values, double *flux)
{
    luxel_scene *scene = NULL;
    luxel_status status = lx_keys_change(tuning->plain, &tuning->keys, numbers, NULL, &scene);
    if (status != LUXEL_OK)
        return status;
    status = lx_measure_goals(tuning->goals, scene, tuning->goals->settings, values, NULL, NULL);
    *flux = flux_of(scene);
    luxel_scene_free(scene);
    const double by = tuning->correct_flux > 0 && *flux > 0 ? *flux / tuning->correct_flux : 1;
    const size_t seen = tuning->cells - tuning->goals->observers;
    for (size_t i = 0; i < seen; i++)
        values[i] += tuning->correction[i] * by;
    for (size_t i = seen; i < tuning->cells; i++)
        values[i] *= tuning->correction[i] / by;
    return status;
}

static double merit_of(const struct tuning *tuning, double reserve, double flux)
{
    return tuning->arranging->wanted->dims ? COST * fmin(reserve, ABOVE) - flux / tuning->first_flux : reserve;
}

/* Rows with the slopes by so many of the numbers. */
static size_t make_rows(const struct tuning *tuning, const double *values, size_t numbers)
{
    return lx_goals_rows(tuning->goals->goals, tuning->goals->goal_count, values, tuning->slopes, tuning->cells,
                         numbers, tuning->rows);
}

static luxel_status stand_at(const struct tuning *tuning, struct stand *stand)
{
    const luxel_status status = measure(tuning, stand->numbers, stand->values, &stand->flux);
    if (status != LUXEL_OK)
        return status;
    const size_t count = make_rows(tuning, stand->values, 0);
    stand->reserve = count > 0 ? HUGE_VAL : 0;
    for (size_t i = 0; i < count; i++)
        stand->reserve = fmin(stand->reserve, tuning->rows[i]);
    stand->merit = merit_of(tuning, stand->reserve, stand->flux);
    return LUXEL_OK;
}

/* Differences by each number, per its scale; to one side where the other is no scene. */
static luxel_status find_slopes(struct tuning *tuning, const struct stand *stand, double *numbers, double *room)
{
    luxel_status status = LUXEL_OK;
    memcpy(numbers, stand->numbers, tuning->numbers * sizeof *numbers);
    for (size_t k = 0; k < tuning->numbers && status == LUXEL_OK; k++) {
        double *slope = &tuning->slopes[k * tuning->cells], width = 0;
        for (size_t i = 0; i < tuning->cells; i++)
            slope[i] = 0;
        tuning->fluxes[k] = 0;
        for (int side = 1; side >= -1 && status == LUXEL_OK; side -= 2) {
            double flux = 0;
            numbers[k] =
                fmin(fmax(stand->numbers[k] + side * STEP * tuning->scale[k], tuning->low[k]), tuning->high[k]);
            const double way = fabs(numbers[k] - stand->numbers[k]) / tuning->scale[k];
            status = way > 0 ? measure(tuning, numbers, room, &flux) : LUXEL_ERROR_SCENE;
            if (status == LUXEL_ERROR_SCENE) {
                status = LUXEL_OK;
                continue;
            }
            width += way;
            tuning->fluxes[k] += side * (flux - stand->flux);
            for (size_t i = 0; i < tuning->cells; i++)
                slope[i] += side * (room[i] - stand->values[i]);
        }
        numbers[k] = stand->numbers[k];
        tuning->fluxes[k] /= width > 0 ? width : 1;
        for (size_t i = 0; i < tuning->cells; i++)
            slope[i] /= width > 0 ? width : 1;
    }
    return status;
}

/* ---- steps ---- */

/* How far number k may go down, or up, within a reach: per its scale. */
static double room_of(const struct tuning *tuning, const struct stand *stand, size_t k, double reach, bool is_up)
{
    const double end = is_up ? tuning->high[k] : tuning->low[k];
    return fmin(reach, fabs(end - stand->numbers[k]) / tuning->scale[k]);
}

/* The numbers that are best by the linear program, and the merit that it expects there. */
static double plan_step(const struct tuning *tuning, const struct stand *stand, double reach, double *numbers)
{
    const size_t n = tuning->numbers, width = n + 1, columns = n + 1, count = make_rows(tuning, stand->values, n);
    const bool dims = tuning->arranging->wanted->dims;
    double gain[LX_MOST_TUNED + 1], found[LX_MOST_TUNED + 1], lowest = HUGE_VAL, highest = HUGE_VAL;
    double flux = stand->flux, least = HUGE_VAL;
    size_t rows = 0;
    for (size_t i = 0; i < count; i++) {
        const double *row = &tuning->rows[i * width];
        double down = row[n], up = row[n];
        for (size_t k = 0; k < n; k++) {
            down -= row[k] * room_of(tuning, stand, k, reach, false);
            up += fabs(row[k]) * reach;
        }
        lowest = fmin(lowest, down);
        highest = fmin(highest, up);
    }
    for (size_t i = 0; i < count; i++) {
        const double *row = &tuning->rows[i * width];
        double *line = &tuning->table[rows * (columns + 1)], down = row[n], reached = row[n];
        for (size_t k = 0; k < n; k++) {
            line[k] = -row[k];
            down -= row[k] * room_of(tuning, stand, k, reach, false);
            reached -= fabs(row[k]) * reach;
        }
        line[n] = 1;
        line[columns] = fmax(down - lowest, 0);
        rows += reached <= highest; /* others are never the least */
    }
    for (size_t k = 0; k <= n; k++) {
        double *line = &tuning->table[rows * (columns + 1)];
        if (k == n && !dims)
            break;
        for (size_t i = 0; i < columns; i++)
            line[i] = i == k;
        line[columns] = k == n ? fmax(ABOVE - lowest, 0)
                               : room_of(tuning, stand, k, reach, false) + room_of(tuning, stand, k, reach, true);
        rows++;
    }
    for (size_t k = 0; k < n; k++)
        gain[k] = dims ? -tuning->fluxes[k] / tuning->first_flux : 0;
    gain[n] = dims ? COST : 1;
    lx_linear_program(tuning->table, rows, columns, gain, tuning->basis, found);
    for (size_t k = 0; k < n; k++) {
        found[k] -= room_of(tuning, stand, k, reach, false);
        numbers[k] = fmin(fmax(stand->numbers[k] + found[k] * tuning->scale[k], tuning->low[k]), tuning->high[k]);
        flux += tuning->fluxes[k] * found[k];
    }
    for (size_t i = 0; i < count; i++) {
        double value = tuning->rows[i * width + n];
        for (size_t k = 0; k < n; k++)
            value += tuning->rows[i * width + k] * found[k];
        least = fmin(least, value);
    }
    return merit_of(tuning, least, flux);
}

static void exchange(struct stand *a, struct stand *b)
{
    const struct stand kept = *a;
    *a = *b;
    *b = kept;
}

/* Goes on from where `at` stands, which ends where nothing better is near; `other` is room. */
static luxel_status go(struct tuning *tuning, struct stand *at, struct stand *other)
{
    double reach = FIRST_REACH;
    bool is_known = false; /* whether the slopes are those here */
    luxel_status status = LUXEL_OK;
    for (int i = 0; i < MOST_STEPS && reach > LEAST_REACH && status == LUXEL_OK; i++) {
        if (!is_known)
            status = find_slopes(tuning, at, other->numbers, other->values);
        is_known = true;
        if (status != LUXEL_OK)
            return status;
        const double expected = plan_step(tuning, at, reach, other->numbers) - at->merit;
        if (!(expected > 1e-7))
            break;
        status = stand_at(tuning, other);
        const double gained = status == LUXEL_OK ? other->merit - at->merit : -HUGE_VAL;
        if (status == LUXEL_ERROR_SCENE)
            status = LUXEL_OK;
        reach = gained > 0.7 * expected ? fmin(2 * reach, MOST_REACH) : gained > 0.2 * expected ? reach : reach / 3;
        if (!(gained > 0.01 * expected))
            continue;
        exchange(at, other);
        is_known = false;
    }
    return status;
}

/* Numbers as people write them, where they are as good. */
static luxel_status round_numbers(const struct tuning *tuning, struct stand *at, struct stand *other)
{
    const double loss = tuning->arranging->wanted->dims ? COST * LOSS : LOSS;
    for (size_t k = 0; k < tuning->numbers; k++) {
        const double by = pow(10, -floor(log10(tuning->scale[k] * FINE)));
        other->numbers[k] = fmin(fmax(round(at->numbers[k] * by) / by + 0.0, tuning->low[k]), tuning->high[k]);
    }
    const luxel_status status = stand_at(tuning, other);
    if (status == LUXEL_OK && other->merit > at->merit - loss && (at->reserve < 1 || other->reserve >= 1))
        exchange(at, other);
    return status == LUXEL_ERROR_SCENE ? LUXEL_OK : status;
}

/* ---- ends ---- */

static bool is_found(const struct tuning *tuning, const struct stand *at)
{
    const struct lx_own_arrangement *made = tuning->arranging->made;
    for (size_t i = 0; i < made->arrangement.computed; i++) {
        bool is_same = true;
        for (size_t k = 0; k < tuning->numbers; k++)
            is_same = is_same && fabs(made->computed[i].layout.numbers[k] - at->numbers[k]) < NEAR * tuning->scale[k];
        if (is_same)
            return true;
    }
    return false;
}

/* Computes the scene of an end and keeps it. */
static luxel_status keep(struct tuning *tuning, const struct stand *at, struct lx_computed **kept)
{
    struct lx_arranging *arranging = tuning->arranging;
    struct lx_own_arrangement *made = arranging->made;
    if (lx_reserve(&made->computed, &arranging->capacity, made->arrangement.computed + 1, sizeof *made->computed) != 0)
        return lx_out_of_memory(arranging->diagnostics);
    double *numbers = lx_new_array(tuning->numbers, sizeof *numbers);
    struct lx_computed *computed = *kept = &made->computed[made->arrangement.computed++];
    *computed = (struct lx_computed){.layout = {.dimming = 1, .numbers = numbers}};
    if (!numbers)
        return lx_out_of_memory(arranging->diagnostics);
    memcpy(numbers, at->numbers, tuning->numbers * sizeof *numbers);
    if (arranging->wanted->dims && tuning->first_flux > 0)
        computed->layout.dimming = at->flux / tuning->first_flux;
    luxel_status status = lx_keys_change(made->goals, &tuning->keys, numbers, arranging->diagnostics, &computed->scene);
    if (status == LUXEL_OK)
        status = lx_judge_layout(arranging, LX_COARSE, computed);
    return status;
}

static void forget(struct tuning *tuning)
{
    tuning->correct_flux = 0;
    for (size_t i = 0; i < tuning->cells; i++)
        tuning->correction[i] = i < tuning->cells - tuning->goals->observers ? 0 : 1;
}

/* Reflected light of a scene that was computed: its values less those without; of observers, divided by those. */
static luxel_status learn(struct tuning *tuning, const struct stand *at, double *room)
{
    const double *values = tuning->arranging->values;
    const size_t seen = tuning->cells - tuning->goals->observers;
    double flux;
    forget(tuning);
    const luxel_status status = measure(tuning, at->numbers, room, &flux);
    for (size_t i = 0; status == LUXEL_OK && i < seen; i++)
        tuning->correction[i] = isnan(room[i]) ? 0 : values[i] - room[i];
    for (size_t i = seen; status == LUXEL_OK && i < tuning->cells; i++)
        tuning->correction[i] = room[i] > 0 && values[i] > 0 ? values[i] / room[i] : 1;
    tuning->correct_flux = flux;
    return status;
}

/* What is reflected in the scene as it is, which is a first idea. */
static luxel_status learn_first(struct tuning *tuning, const struct stand *at, double *room)
{
    struct lx_arranging *arranging = tuning->arranging;
    struct lx_computed computed = {.scene = luxel_scene_copy(arranging->made->goals)};
    luxel_status status =
        computed.scene ? lx_judge_layout(arranging, LX_ROUGH, &computed) : lx_out_of_memory(arranging->diagnostics);
    lx_computed_clear(&computed);
    return status == LUXEL_OK ? learn(tuning, at, room) : status;
}

static luxel_status try_start(struct tuning *tuning, unsigned start, struct stand *at, struct stand *other)
{
    struct lx_arranging *arranging = tuning->arranging;
    luxel_status status = LUXEL_OK;
    lx_other_start(&tuning->keys, tuning->low, tuning->high, tuning->scale, start, at->numbers);
    for (size_t k = 0; start == 0 && k < tuning->numbers; k++) {
        const struct lx_key *key = lx_keys_of(&tuning->keys, k);
        at->numbers[k] = key->targets->numbers[k - key->offset];
    }
    if (start == 0 && arranging->reflects)
        status = learn_first(tuning, at, other->values);
    for (int i = 0; i < TRIES && status == LUXEL_OK; i++) {
        struct lx_computed *computed = NULL;
        status = stand_at(tuning, at);
        if (status == LUXEL_ERROR_SCENE && start > 0)
            return LUXEL_OK;
        if (status == LUXEL_OK)
            status = go(tuning, at, other);
        if (status == LUXEL_OK)
            status = round_numbers(tuning, at, other);
        if (status != LUXEL_OK || (i == 0 && is_found(tuning, at)))
            return status;
        if (i > 0)
            lx_computed_clear(&arranging->made->computed[--arranging->made->arrangement.computed]);
        status = keep(tuning, at, &computed);
        if (status != LUXEL_OK || computed->layout.reaches || !arranging->reflects || i == TRIES - 1)
            break;
        status = learn(tuning, at, other->values);
    }
    lx_end_part(arranging);
    return status;
}

/* ---- all of it ---- */

static luxel_status make_room(struct tuning *tuning, struct stand stands[2])
{
    const size_t n = tuning->numbers, cells = tuning->cells;
    const size_t rows = lx_goals_most_rows(tuning->goals->goals, tuning->goals->goal_count) + n + 2;
    double **const arrays[] = {&tuning->scale,  &tuning->low,       &tuning->high,
                               &tuning->fluxes, &stands[0].numbers, &stands[1].numbers};
    double **const of_cells[] = {&tuning->correction, &stands[0].values, &stands[1].values};
    bool good = true;
    for (size_t i = 0; i < LX_COUNT(arrays); i++)
        good = (*arrays[i] = lx_new_array(n + 1, sizeof **arrays[i])) != NULL && good;
    for (size_t i = 0; i < LX_COUNT(of_cells); i++)
        good = (*of_cells[i] = lx_new_array(cells + 1, sizeof **of_cells[i])) != NULL && good;
    tuning->slopes = lx_new_array(n * cells + 1, sizeof *tuning->slopes);
    tuning->rows = lx_new_array(rows * (n + 1), sizeof *tuning->rows);
    tuning->table = lx_new_array((rows + 1) * (n + 2), sizeof *tuning->table);
    tuning->basis = lx_new_array(rows + n + 2, sizeof *tuning->basis);
    good = good && tuning->slopes && tuning->rows && tuning->table && tuning->basis;
    for (size_t k = 0; good && k < n; k++) {
        const struct lx_key *key = lx_keys_of(&tuning->keys, k);
        tuning->scale[k] = key->targets->scale;
        tuning->low[k] = key->legal.given ? key->legal.low : -HUGE_VAL;
        tuning->high[k] = key->legal.given ? key->legal.high : HUGE_VAL;
        if (key->legal.given && key->legal.low_open)
            tuning->low[k] += FINE * tuning->scale[k];
    }
    return good ? LUXEL_OK : lx_out_of_memory(tuning->arranging->diagnostics);
}

static void clear(struct tuning *tuning, struct stand stands[2])
{
    double *const arrays[] = {tuning->scale,     tuning->low,       tuning->high,     tuning->fluxes,
                              tuning->slopes,    tuning->rows,      tuning->table,    tuning->correction,
                              stands[0].numbers, stands[1].numbers, stands[0].values, stands[1].values};
    for (size_t i = 0; i < LX_COUNT(arrays); i++)
        free(arrays[i]);
    free(tuning->basis);
    lx_keys_clear(&tuning->keys);
    luxel_scene_free(tuning->plain);
}

/* The names and units of the numbers, which are told. */
static luxel_status name_numbers(const struct tuning *tuning)
{
    struct lx_own_arrangement *made = tuning->arranging->made;
    made->names = lx_new_array(tuning->numbers + 1, sizeof *made->names);
    made->units = lx_new_array(tuning->numbers + 1, sizeof *made->units);
    for (size_t k = 0; made->names && made->units && k < tuning->numbers; k++) {
        made->arrangement.number_count = k + 1;
        made->units[k] = lx_keys_of(&tuning->keys, k)->unit;
        if (!(made->names[k] = lx_unknown_name(&tuning->keys, k)))
            return lx_out_of_memory(tuning->arranging->diagnostics);
    }
    made->arrangement.names = (const char *const *)made->names;
    made->arrangement.units = made->units;
    return made->names && made->units ? LUXEL_OK : lx_out_of_memory(tuning->arranging->diagnostics);
}

static luxel_status begin(struct tuning *tuning, struct stand stands[2])
{
    struct lx_arranging *arranging = tuning->arranging;
    const luxel_arranging *wanted = arranging->wanted;
    luxel_status status =
        lx_keys_find(arranging->made->goals, wanted->keys, wanted->key_count, arranging->diagnostics, &tuning->keys);
    char number[LX_NUMBER_SIZE];
    tuning->numbers = tuning->keys.number_count;
    if (status == LUXEL_OK && tuning->numbers > LX_MOST_TUNED)
        status =
            lx_refuse(arranging->diagnostics, LX_MSG_ARRANGE_TOO_MANY, LX_ARGS(lx_write_number(LX_MOST_TUNED, number)));
    if (status == LUXEL_OK)
        status = make_room(tuning, stands);
    if (status == LUXEL_OK)
        status = name_numbers(tuning);
    tuning->plain = status == LUXEL_OK ? luxel_scene_copy(arranging->made->goals) : NULL;
    if (status == LUXEL_OK && !tuning->plain)
        status = lx_out_of_memory(arranging->diagnostics);
    if (status == LUXEL_OK && arranging->reflects)
        status = luxel_scene_set(tuning->plain, "reflections=none", arranging->diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(tuning->plain, arranging->diagnostics);
    tuning->first_flux = status == LUXEL_OK ? flux_of(tuning->plain) : 0;
    if (status == LUXEL_OK && wanted->dims && !(tuning->first_flux > 0))
        status = lx_refuse(arranging->diagnostics, LX_MSG_ARRANGE_DARK, NULL);
    return status;
}

luxel_status lx_tune(struct lx_arranging *arranging)
{
    struct tuning tuning = {
        .arranging = arranging, .goals = &arranging->superposition, .cells = arranging->superposition.cells};
    struct stand stands[2] = {{.numbers = NULL}};
    luxel_status status = begin(&tuning, stands);
    if (status == LUXEL_OK)
        forget(&tuning);
    for (unsigned i = 0; i < (arranging->reflects ? SLOW_STARTS : STARTS) && status == LUXEL_OK; i++) {
        status = try_start(&tuning, i, &stands[0], &stands[1]);
        arranging->made->arrangement.tried++;
    }
    clear(&tuning, stands);
    return status;
}
