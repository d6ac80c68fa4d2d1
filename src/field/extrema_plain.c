/* SPDX-License-Identifier: MIT */
/*
 * The plain search for an extremum, where a surface has no coordinates to walk in: from the best pixels over the
 * screen, by steps in eight directions that are halved where none of them leads further (a pattern search: Hooke and
 * Jeeves, 1961), and along the rim that they end on.
 */
#include "extrema_plain.h"

#include "../world/evaluate.h"
#include "extrema.h"
#include "field.h"

/* The pixels to begin at, how often steps are halved, and how many steps are made at most. */
static const double FIT = 0.1;        /* of the bend: how far neighbours may be off a parabola */
static const double ROUNDING = 1e-14; /* of a value */
enum { STARTS = 12, STARTS_COSTLY = 4, HALVINGS = 34, MOST_STEPS = 2000 };

static const double ways[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

struct found {
    double at[2];
    luxel_value value;
};

/* Whether there is a value at a place of the screen and the region. */
static bool look(const struct lx_extremum_search *search, const double at[2], struct found *found)
{
    const struct lx_screen *screen = &search->prepared->scene->screen;
    if (!(fabs(at[0]) <= screen->width_mm / 2 && fabs(at[1]) <= screen->height_mm / 2 &&
          luxel_region_holds(search->region, at[0], at[1])))
        return false;
    found->at[0] = at[0], found->at[1] = at[1];
    luxel_evaluate_screen(search->evaluator, at[0], at[1], &found->value, NULL);
    return found->value.on_surface && found->value.has_value;
}

/* The best pixel that is not near to one of those taken; false: there is none. */
static bool next_start(const struct lx_extremum_search *search, const luxel_field *field, const struct found *taken,
                       unsigned count, double at[2])
{
    double best = -HUGE_VAL;
    const double near = 8 * search->pixel_mm;
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++) {
        const double x = field->x_mm[i % field->columns], y = field->y_mm[i / field->columns];
        const double value = search->sign * lx_field_value(field, i);
        bool fits = field->mask[i] && value > best && luxel_region_holds(search->region, x, y);
        for (unsigned k = 0; fits && k < count; k++)
            fits = fabs(x - taken[k].at[0]) > near || fabs(y - taken[k].at[1]) > near;
        if (fits)
            best = value, at[0] = x, at[1] = y;
    }
    return best > -HUGE_VAL;
}

/*
 * The peak of a parabola through a place and its eight neighbours: how far it is, in steps, and how much higher.  False
 * where no parabola fits them: at an edge, on a slope, or where rounding is all there is.
 */
static bool fit_peak(double here, const double around[8], double away[2], double *gain)
{
    const double slope[2] = {(around[0] - around[1]) / 2, (around[2] - around[3]) / 2};
    const double bend[2] = {around[0] + around[1] - 2 * here, around[2] + around[3] - 2 * here};
    const double twist = (around[4] + around[5] - around[6] - around[7]) / 4;
    const double determinant = bend[0] * bend[1] - twist * twist;
    if (!(bend[0] < 0 && bend[1] < 0 && determinant > 0))
        return false;
    for (int i = 4; i < 8; i++) {
        const double fitted = here + slope[0] * ways[i][0] + slope[1] * ways[i][1] + (bend[0] + bend[1]) / 2 +
                              twist * ways[i][0] * ways[i][1];
        if (!(fabs(fitted - around[i]) <= FIT * fmin(-bend[0], -bend[1])))
            return false;
    }
    away[0] = (twist * slope[1] - bend[1] * slope[0]) / determinant;
    away[1] = (twist * slope[0] - bend[0] * slope[1]) / determinant;
    *gain = (slope[0] * away[0] + slope[1] * away[1]) / 2;
    return fabs(away[0]) <= 1 && fabs(away[1]) <= 1;
}

/* Steps as long as they lead up; then to the peak of the parabola, from where shorter ones suffice, or half as long. */
static void climb(struct lx_extremum_search *search, struct found *here)
{
    double step_mm = search->pixel_mm;
    for (int halvings = 0, steps = 0; halvings < HALVINGS && steps < MOST_STEPS && lx_search_goes_on(search); steps++) {
        struct found best = *here, next;
        double around[8], away[2], gain;
        for (int i = 0; i < 8; i++) {
            const double at[2] = {here->at[0] + step_mm * ways[i][0], here->at[1] + step_mm * ways[i][1]};
            around[i] = (double)NAN;
            if (!look(search, at, &next))
                continue;
            around[i] = search->sign * next.value.value;
            if (around[i] > search->sign * best.value.value)
                best = next;
        }
        const bool moved = best.at[0] != here->at[0] || best.at[1] != here->at[1];
        if (moved) {
            *here = best;
            continue;
        }
        if (!fit_peak(search->sign * here->value.value, around, away, &gain)) {
            halvings++;
            step_mm /= 2;
            continue;
        }
        const double at[2] = {here->at[0] + step_mm * away[0], here->at[1] + step_mm * away[1]};
        if (look(search, at, &next) && search->sign * (next.value.value - here->value.value) > 0)
            *here = next;
        if (gain <= ROUNDING * fabs(here->value.value))
            return;
        halvings += 4;
        step_mm /= 16;
    }
}

/* -- along a rim, where no fixed direction leads on -- */

/* Rounds along the rim, halvings on the way to it, and steps of the golden section. */
enum { ROUNDS = 4, BISECTIONS = 60, SECTIONS = 44 };

static size_t surface_of(const struct lx_extremum_search *search, const struct found *found)
{
    return lx_prepared_index(search->prepared, found->value.surface, found->value.part);
}

static bool shows(const struct lx_extremum_search *search, const double at[2], size_t surface)
{
    const struct lx_screen *screen = &search->prepared->scene->screen;
    struct lx_element element;
    return fabs(at[0]) <= screen->width_mm / 2 && fabs(at[1]) <= screen->height_mm / 2 &&
           luxel_region_holds(search->region, at[0], at[1]) &&
           lx_element_seen(search->prepared, at[0], at[1], &element) &&
           (size_t)(element.own - search->prepared->surfaces) == surface;
}

/* Value at the last place in a direction from an inner one, no farther than `most`, that shows the surface. */
static bool look_at_rim(const struct lx_extremum_search *search, const double inner[2], double turn, double most,
                        size_t surface, struct found *found)
{
    double on = 0, off = most, at[2] = {inner[0], inner[1]};
    for (int i = 0; i < BISECTIONS; i++) {
        const double middle = (on + off) / 2;
        const double trial[2] = {inner[0] + middle * cos(turn), inner[1] + middle * sin(turn)};
        if (shows(search, trial, surface))
            on = middle, at[0] = trial[0], at[1] = trial[1];
        else
            off = middle;
    }
    return look(search, at, found) && surface_of(search, found) == surface;
}

/* The best place of the rim within half a radian to both sides, seen from an inner place some pixels away. */
static void follow_rim(struct lx_extremum_search *search, struct found *here)
{
    static const double golden = 0.6180339887498949;
    for (int round = 0; round < ROUNDS && lx_search_goes_on(search); round++) {
        const double away = 8 * search->pixel_mm;
        double inner[2], low, high;
        int way = 0;
        struct found best = *here, next;
        for (; way < 8; way++) {
            const double share = away / hypot(ways[way][0], ways[way][1]);
            inner[0] = here->at[0] + share * ways[way][0], inner[1] = here->at[1] + share * ways[way][1];
            const double halfway[2] = {(inner[0] + here->at[0]) / 2, (inner[1] + here->at[1]) / 2};
            const double beyond[2] = {here->at[0] - 1e-3 * (inner[0] - here->at[0]),
                                      here->at[1] - 1e-3 * (inner[1] - here->at[1])};
            if (shows(search, inner, surface_of(search, here)) && shows(search, halfway, surface_of(search, here)) &&
                !shows(search, beyond, surface_of(search, here)))
                break;
        }
        if (way == 8)
            return;
        low = atan2(here->at[1] - inner[1], here->at[0] - inner[0]) - 0.5, high = low + 1;
        for (int i = 0; i < SECTIONS; i++) {
            double values[2] = {-HUGE_VAL, -HUGE_VAL};
            const double turns[2] = {high - golden * (high - low), low + golden * (high - low)};
            for (int k = 0; k < 2; k++) {
                if (!look_at_rim(search, inner, turns[k], 4 * away, surface_of(search, here), &next))
                    continue;
                values[k] = search->sign * next.value.value;
                if (values[k] > search->sign * best.value.value)
                    best = next;
            }
            *(values[0] < values[1] ? &low : &high) = turns[values[0] >= values[1]];
        }
        if (best.at[0] == here->at[0] && best.at[1] == here->at[1])
            return;
        *here = best;
    }
}

/* On a border of screen or region, on the rim of a surface, or inside. */
static luxel_peak_place place_of(const struct lx_extremum_search *search, const struct found *peak)
{
    const struct lx_screen *screen = &search->prepared->scene->screen;
    luxel_peak_place place = LUXEL_PEAK_INSIDE;
    for (int i = 0; i < 8; i++) {
        const double reach = 1e-6 * search->pixel_mm;
        const double at[2] = {peak->at[0] + reach * ways[i][0], peak->at[1] + reach * ways[i][1]};
        const bool inside = fabs(at[0]) <= screen->width_mm / 2 && fabs(at[1]) <= screen->height_mm / 2 &&
                            luxel_region_holds(search->region, at[0], at[1]);
        if (!inside)
            return LUXEL_PEAK_BORDER;
        if (!shows(search, at, surface_of(search, peak)))
            place = LUXEL_PEAK_LIMB;
    }
    return place;
}

void lx_search_plainly(struct lx_extremum_search *search, const luxel_field *field, luxel_peak *peak)
{
    struct found taken[STARTS], here;
    const unsigned most = search->costly ? STARTS_COSTLY : STARTS;
    for (unsigned count = 0; count < most && lx_search_goes_on(search); count++) {
        if (!next_start(search, field, taken, count, taken[count].at))
            return;
        if (!look(search, taken[count].at, &here))
            continue;
        climb(search, &here);
        if (place_of(search, &here) != LUXEL_PEAK_INSIDE)
            follow_rim(search, &here);
        if (peak->exists && search->sign * (here.value.value - peak->value) <= 0)
            continue;
        *peak = (luxel_peak){.exists = true,
                             .value = here.value.value,
                             .error = here.value.error,
                             .x_mm = here.at[0],
                             .y_mm = here.at[1],
                             .surface = here.value.surface,
                             .part = here.value.part,
                             .place = place_of(search, &here)};
        for (int i = 0; i < 3; i++) {
            peak->position_mm[i] = here.value.position_mm[i];
            peak->normal[i] = here.value.normal[i];
        }
    }
}
