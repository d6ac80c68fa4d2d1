/* SPDX-License-Identifier: MIT */
/* The rule of Gauss and Kronrod, when to believe it, and the choice of the panel to halve. */
#include <math.h>

#include "adaptive.h"

enum { HALF = 10, NODES = 2 * HALF + 1, MOST_PLACES = NODES + 2 }; /* places: with the ends */

/* Positive nodes from the outermost to the middle one; the Gauss rule has every second of them. */
static const double nodes[HALF + 1] = {0.995657163025808080735527280689003,
                                       0.973906528517171720077964012084452,
                                       0.930157491355708226001207180059508,
                                       0.865063366688984510732096688423493,
                                       0.780817726586416897063717578345042,
                                       0.679409568299024406234327365114874,
                                       0.562757134668604683339000099272694,
                                       0.433395394129247190799265943165784,
                                       0.294392862701460198131126603103866,
                                       0.148874338981631210884826001129720,
                                       0};
static const double kronrod[HALF + 1] = {
    0.011694638867371874278064396062192, 0.032558162307964727478818972459390, 0.054755896574351996031381300244580,
    0.075039674810919952767043140916190, 0.093125454583697605535065465083366, 0.109387158802297641899210590325805,
    0.123491976262065851077958109585166, 0.134709217311473325928054001771707, 0.142775938577060080797094273138717,
    0.147739104901338491374841515972068, 0.149445554002916905664936468389821};
static const double gauss[HALF / 2] = {0.066671344308688137593568809893332, 0.149451349150580593145863396957658,
                                       0.219086362515982043995534934228163, 0.269266719309996355091226921569469,
                                       0.295524224714752870173815619188769};

/* A rule: positive nodes and weights from the outermost to the middle one; every second node is one of Gauss's. */
struct rule {
    int half;
    const double *nodes, *kronrod, *gauss;
};

static const struct rule fine_rule = {HALF, nodes, kronrod, gauss};

/* With 3 and 7 points, where little is asked for. */
static const struct rule coarse_rule = {
    3,
    (const double[]){0.960491268708020283423507092629080, 0.774596669241483377035853079956480,
                     0.434243749346802558002071502844628, 0},
    (const double[]){0.104656226026467265193823857192073, 0.268488089868333440728569280666710,
                     0.401397414775962222905051818618432, 0.450916538658474142345110087045571},
    (const double[]){0.555555555555555555555555555555556, 0.888888888888888888888888888888889}};

/* Where the function begins like a small power, K21 is off by up to the plain difference. */
static const double CAUTION = 10;

/* Neighbouring places may differ by this in their logarithms, unless both are below the top by the second. */
static const double STEEPEST = 6, NEGLIGIBLE = 40;
/* Where the function vanishes at one of two neighbours its support ends between them: looked for down to this. */
static const double NARROWEST = 1e-7;

/* Falling towards an end like a power is steep between the places next to it, and hides nothing. */
static bool falls_to_end(int i, int places, double rise)
{
    return (i < 2 && rise > 0) || (i >= places - 3 && rise < 0);
}

/*
 * The most that the logarithm can be between places i and i + 1 where it is concave, as round a peak: it stays below
 * the lines through the two places before and through the two behind.  Beyond NEGLIGIBLE the panel is halved anyway.
 */
static double height_between(const double *x, const double *logs, int places, int i)
{
    double from = logs[i], to = logs[i + 1], length = x[i + 1] - x[i], higher = fmax(from, to);
    double before = i > 0 ? (from - logs[i - 1]) / (x[i] - x[i - 1]) : HUGE_VAL;
    double behind = i + 2 < places ? (logs[i + 2] - to) / (x[i + 2] - x[i + 1]) : -HUGE_VAL;
    if (!(before > 0 && behind < 0))
        return higher;
    double meet = isinf(before)   ? to - behind * length
                  : isinf(behind) ? from + before * length
                                  : from + before * (to - from - behind * length) / (before - behind);
    return fmax(higher, fmin(meet, higher + NEGLIGIBLE));
}

static bool is_resolved(const double *x, const double *logs, int places, double top)
{
    double width = x[places - 1] - x[0];
    for (int i = 0; i + 1 < places; i++) {
        double rise = logs[i + 1] - logs[i];
        bool vanishes = isinf(rise) && width <= NARROWEST;
        if (fabs(rise) > STEEPEST && !falls_to_end(i, places, rise) && !vanishes &&
            height_between(x, logs, places, i) > top - NEGLIGIBLE)
            return false;
    }
    return true;
}

/* How far a place is off the line through its neighbours. */
static double bend(const double *x, const double *values, int i)
{
    const double share = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1]);
    return fabs(values[i - 1] + share * (values[i + 1] - values[i - 1]) - values[i]);
}

/*
 * What kinks may do to the sum: where the slope changes by s within a gap of the width g it is no more than s g^2/8,
 * and the place on one of its sides is off the line through its neighbours by s g/4 and more, where these are as far.
 */
static double judge_kinks(const double *x, const double *values, const uint64_t *forms, int places,
                          struct lx_panel *panel, double middle)
{
    const double CAUTIOUS = 2;
    double sum = 0, worst = 0;
    for (int i = 0; i + 1 < places; i++) {
        if (forms[i] == forms[i + 1])
            continue;
        double off = 0;
        for (int k = i - 1; k <= i + 2; k++)
            off = k > 0 && k + 1 < places ? fmax(off, bend(x, values, k)) : off;
        const double amount = CAUTIOUS * (x[i + 1] - x[i]) * off;
        sum += amount;
        if (amount > worst) {
            worst = amount;
            panel->kink_from = middle + x[i];
            panel->kink_to = middle + x[i + 1];
        }
    }
    return sum;
}

/* Evaluates a panel in which nothing hides. */
static void evaluate_smooth(const struct lx_integrand *integrand, struct lx_panel *panel)
{
    const struct rule *rule = &coarse_rule;
    const double middle = panel->from + (panel->to - panel->from) / 2, half = (panel->to - panel->from) / 2;
    double by_kronrod = 0, by_gauss = 0, inherited = 0;
    for (int i = 0; i <= 2 * rule->half; i++) {
        const int k = i <= rule->half ? i : 2 * rule->half - i;
        const double offset = i <= rule->half ? -rule->nodes[k] * half : rule->nodes[k] * half;
        const struct lx_point_value point = integrand->at(integrand->data, panel->interval, middle + offset);
        by_kronrod += rule->kronrod[k] * point.value;
        by_gauss += k % 2 ? rule->gauss[k / 2] * point.value : 0;
        inherited += rule->kronrod[k] * point.error;
    }
    panel->value = by_kronrod * half;
    panel->inherited = inherited * half;
    panel->estimate = CAUTION * fabs(by_kronrod - by_gauss) * half;
    panel->kink_from = panel->kink_to = panel->from;
}

static void evaluate(const struct lx_integrand *integrand, struct lx_panel *panel, double *top)
{
    if (integrand->is_smooth) {
        evaluate_smooth(integrand, panel);
        return;
    }
    const struct rule *rule = integrand->is_coarse ? &coarse_rule : &fine_rule;
    const int places = 2 * rule->half + 3, count = places - 2;
    double x[MOST_PLACES], logs[MOST_PLACES], values[MOST_PLACES]; /* x: from the middle */
    uint64_t forms[MOST_PLACES];
    double middle = panel->from + (panel->to - panel->from) / 2, half = (panel->to - panel->from) / 2;
    double by_kronrod = 0, by_gauss = 0, inherited = 0;
    for (int i = 0; i < places; i++) {
        bool end = i == 0 || i == places - 1;
        int k = i <= rule->half + 1 ? i - 1 : count - i;
        double offset = end ? half : rule->nodes[k] * half;
        x[i] = i <= rule->half ? -offset : offset;
        struct lx_point_value point = integrand->at(integrand->data, panel->interval, middle + x[i]);
        logs[i] = log(point.value);
        values[i] = point.value;
        forms[i] = point.form;
        *top = fmax(*top, logs[i]);
        if (end)
            continue;
        by_kronrod += rule->kronrod[k] * point.value;
        by_gauss += k % 2 ? rule->gauss[k / 2] * point.value : 0;
        inherited += rule->kronrod[k] * point.error;
    }
    panel->value = by_kronrod * half;
    panel->inherited = inherited * half;
    panel->estimate = CAUTION * fabs(by_kronrod - by_gauss) * half;
    panel->kink_from = panel->kink_to = panel->from;
    if (integrand->form)
        panel->estimate += judge_kinks(x, values, forms, places, panel, middle);
    if (is_resolved(x, logs, places, *top))
        return;
    double greatest = -HUGE_VAL;
    for (int i = 0; i + 1 < places; i++)
        greatest = fmax(greatest, height_between(x, logs, places, i));
    panel->estimate = fmax(panel->estimate, 2 * half * exp(greatest));
}

static struct lx_integral sum(const struct lx_panels *panels)
{
    struct lx_integral all = {0, 0, 0};
    for (size_t i = 0; i < panels->count; i++) {
        all.value += panels->items[i].value;
        all.error += panels->items[i].estimate;
        all.inherited += panels->items[i].inherited;
    }
    return all;
}

static struct lx_panel *worst(struct lx_panels *panels)
{
    struct lx_panel *found = &panels->items[0];
    for (size_t i = 1; i < panels->count; i++)
        if (panels->items[i].estimate > found->estimate)
            found = &panels->items[i];
    return found;
}

/* Where to cut a panel in two: in its middle, or where its form changes, which is looked for until no number, or
 * little, is between; either part has one form there. */
static void cut(const struct lx_integrand *integrand, struct lx_panel *first, struct lx_panel *second)
{
    enum { HALVINGS = 60 };
    const double length = first->to - first->from, least = 1e-13 * length, apart = integrand->narrowest * length;
    double from = first->kink_from, to = first->kink_to, middle = first->from + (first->to - first->from) / 2;
    *second = (struct lx_panel){.interval = first->interval, .from = middle, .to = first->to};
    if (integrand->form && to > from) {
        const uint64_t form = integrand->form(integrand->data, first->interval, from);
        for (int i = 0; i < HALVINGS; i++) {
            const double between = from + (to - from) / 2;
            if (!(between > from && between < to) || to - from < apart)
                break;
            *(integrand->form(integrand->data, first->interval, between) == form ? &from : &to) = between;
        }
        if (from > first->from + least && to < first->to - least) { /* next to an end there is nothing to cut off */
            if (apart > 0)
                from = to = from + (to - from) / 2;
            second->from = to;
            middle = from;
        }
    }
    first->to = middle;
}

struct lx_integral lx_integrate_panels(const struct lx_integrand *integrand, struct lx_panels *panels)
{
    const double floor = 1e-14; /* of a panel's value: below it the estimate is rounding */
    double top = -HUGE_VAL;
    for (size_t i = 0; i < panels->count; i++)
        evaluate(integrand, &panels->items[i], &top);
    struct lx_integral all = sum(panels);
    while (panels->count > 0 && panels->count < panels->capacity &&
           all.error > integrand->target(integrand->data, &all)) {
        struct lx_panel *first = worst(panels), *second = &panels->items[panels->count];
        double middle = first->from + (first->to - first->from) / 2;
        if (first->estimate <= floor * first->value || !(middle > first->from && middle < first->to))
            break;
        cut(integrand, first, second);
        panels->count++;
        evaluate(integrand, first, &top);
        evaluate(integrand, second, &top);
        all = sum(panels);
    }
    return all;
}
