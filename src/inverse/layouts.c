/* SPDX-License-Identifier: MIT */
/* A search in two spacings: an even net of them, then steps from the best of these that are halved where none helps. */
#include "layouts.h"

#include <math.h>

enum { NET = 12, DIRECTIONS = 16, HALVINGS = 60, STARTS = 3 };
/* Spacings are found to half a millimetre and written in whole ones. */
static const double FINE_MM = 0.5;
/* Least dimming that is found, and how exactly. */
static const double GOLDEN = 0.61803398874989485, DIM_STEP = 1e-3;

struct finding {
    const struct lx_superposition *superposition;
    const luxel_arranging *arranging;
    double *values, *mixed; /* of each cell */
    double low[2], high[2]; /* of the spacings */
};

bool lx_layout_fits(const struct lx_superposition *superposition, unsigned columns, unsigned rows)
{
    const unsigned n[2] = {columns, rows};
    for (int i = 0; i < 2; i++)
        if (n[i] > 1 && (n[i] - 1) * superposition->least_mm[i] > 2 * superposition->half_mm[i])
            return false;
    return true;
}

/* ---- dimming ---- */

static double reserve_at(const struct finding *finding, double dimming)
{
    const struct lx_superposition *superposition = finding->superposition;
    for (size_t k = 0; k < superposition->cells; k++)
        finding->mixed[k] = superposition->base[k] + dimming * finding->values[k];
    return lx_goals_reserve(superposition->goals, superposition->goal_count, finding->mixed);
}

/* The dimming with the greatest reserve: each goal goes one way with it, so that their least rises and then falls. */
static double find_best_dimming(const struct finding *finding)
{
    double low = 0, high = 1;
    for (int i = 0; i < 40; i++) {
        const double first = high - GOLDEN * (high - low), second = low + GOLDEN * (high - low);
        if (reserve_at(finding, first) > reserve_at(finding, second))
            high = second;
        else
            low = first;
    }
    return high;
}

/* The least dimming that reaches the goals, up to one that does, rounded up to what people write. */
static double find_least_dimming(const struct finding *finding, double enough)
{
    double low = 0, high = enough;
    while (high - low > DIM_STEP / 4) {
        const double middle = (low + high) / 2;
        if (reserve_at(finding, middle) >= 1)
            high = middle;
        else
            low = middle;
    }
    const double rounded = ceil(high / DIM_STEP) * DIM_STEP;
    return rounded <= 1 && reserve_at(finding, rounded) >= 1 ? rounded : high;
}

static void judge(const struct finding *finding, struct lx_lamp_layout *layout)
{
    lx_superpose(finding->superposition, &layout->array, finding->values);
    layout->dimming = 1;
    layout->score = layout->reserve = reserve_at(finding, 1);
    if (!finding->arranging->dims)
        return;
    const double dimming = layout->reserve < 1 ? find_best_dimming(finding) : 1;
    if (reserve_at(finding, dimming) > layout->reserve * (1 + 1e-6)) {
        layout->dimming = dimming;
        layout->score = layout->reserve = reserve_at(finding, dimming);
    }
    if (layout->reserve < 1)
        return;
    layout->dimming = find_least_dimming(finding, layout->dimming);
    layout->reserve = reserve_at(finding, layout->dimming);
    layout->score = 1 / layout->dimming;
}

/* ---- spacings ---- */

static double limited(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

/* An array with other spacings, if it is better. */
static bool take_better(const struct finding *finding, double x_mm, double y_mm, struct lx_lamp_layout *layout)
{
    struct lx_lamp_layout other = *layout;
    other.array.spacing_mm[0] = limited(x_mm, finding->low[0], finding->high[0]);
    other.array.spacing_mm[1] = limited(y_mm, finding->low[1], finding->high[1]);
    judge(finding, &other);
    if (!(other.score > layout->score))
        return false;
    *layout = other;
    return true;
}

static void climb(const struct finding *finding, struct lx_lamp_layout *layout)
{
    double step[2];
    for (int i = 0; i < 2; i++)
        step[i] = (finding->high[i] - finding->low[i]) / NET;
    for (int halvings = 0; halvings < HALVINGS && fmax(step[0], step[1]) > FINE_MM;) {
        bool is_better = false;
        for (int k = 0; k < DIRECTIONS && !is_better; k++) {
            const double angle = 2 * M_PI * (k + 0.5 * (halvings % 2)) / DIRECTIONS;
            is_better = take_better(finding, layout->array.spacing_mm[0] + step[0] * cos(angle),
                                    layout->array.spacing_mm[1] + step[1] * sin(angle), layout);
        }
        for (int i = 0; i < 2 && !is_better; i++)
            step[i] /= 2;
        halvings += !is_better;
    }
}

/* The best of the whole millimetres around. */
static void round_spacings(const struct finding *finding, struct lx_lamp_layout *layout)
{
    const double at[2] = {layout->array.spacing_mm[0], layout->array.spacing_mm[1]};
    layout->score = -1;
    for (int k = 0; k < 4; k++)
        take_better(finding, k % 2 == 0 ? floor(at[0]) : ceil(at[0]), k / 2 == 0 ? floor(at[1]) : ceil(at[1]), layout);
}

static void set_range(struct finding *finding, const unsigned n[2])
{
    for (int i = 0; i < 2; i++) {
        const struct lx_superposition *superposition = finding->superposition;
        const double even = 2 * superposition->wall_mm[i] / n[i];
        if (finding->arranging->is_even || n[i] == 1) {
            finding->low[i] = finding->high[i] = fmax(round(even * 100) / 100, 1);
            continue;
        }
        finding->high[i] = floor(2 * superposition->half_mm[i] / (n[i] - 1));
        finding->low[i] = fmin(ceil(superposition->least_mm[i]), finding->high[i]);
    }
}

struct lx_lamp_layout lx_layout_find(const struct lx_superposition *superposition, const luxel_arranging *arranging,
                                     unsigned columns, unsigned rows, double *room)
{
    struct finding finding = {
        .superposition = superposition, .arranging = arranging, .values = room, .mixed = superposition->sums};
    const struct lx_lamp_layout none = {.array = {.n = {columns, rows}}, .score = -1};
    struct lx_lamp_layout starts[STARTS], best = none;
    set_range(&finding, none.array.n);
    for (int i = 0; i < STARTS; i++)
        starts[i] = none;
    for (int row = 0; row <= NET; row++)
        for (int column = 0; column <= NET; column++) {
            struct lx_lamp_layout one = none;
            if ((column > 0 && finding.low[0] == finding.high[0]) || (row > 0 && finding.low[1] == finding.high[1]))
                continue;
            take_better(&finding, finding.low[0] + (finding.high[0] - finding.low[0]) * column / NET,
                        finding.low[1] + (finding.high[1] - finding.low[1]) * row / NET, &one);
            for (int i = 0; i < STARTS; i++)
                if (one.score > starts[i].score) {
                    for (int k = STARTS - 1; k > i; k--)
                        starts[k] = starts[k - 1];
                    starts[i] = one;
                    break;
                }
        }
    for (int i = 0; i < STARTS && starts[i].score > 0; i++) {
        climb(&finding, &starts[i]);
        if (starts[i].score > best.score)
            best = starts[i];
    }
    if (!arranging->is_even && best.score > 0)
        round_spacings(&finding, &best);
    return best;
}
