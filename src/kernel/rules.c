/* SPDX-License-Identifier: MIT */
/* Places and weights of Gauss's rules: the zeros of Legendre's polynomials by Newton's steps. */
#include <math.h>

#include "../base/memory.h"
#include "rules.h"

/* P_n(x), and its derivative. */
static double legendre(unsigned n, double x, double *slope)
{
    double before = 1, now = x;
    for (unsigned k = 2; k <= n; k++) {
        const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now;
        now = next;
    }
    *slope = n * (before - x * now) / ((1 - x) * (1 + x));
    return now;
}

static void make_rule(unsigned count, struct lx_gauss_rule *rule)
{
    enum { STEPS = 5 };
    rule->count = count;
    for (unsigned i = 0; i < count; i++) {
        double x = -cos(M_PI * (i + 0.75) / (count + 0.5)), slope = 1;
        for (int step = 0; step < STEPS; step++) {
            const double change = legendre(count, x, &slope) / slope;
            x -= change;
            if (fabs(change) < 1e-15)
                break;
        }
        legendre(count, x, &slope);
        rule->places_double[i] = x;
        rule->weights_double[i] = 2 / ((1 - x) * (1 + x) * slope * slope);
        rule->places_single[i] = (float)x;
        rule->weights_single[i] = (float)rule->weights_double[i];
    }
}

struct lx_gauss_rules *lx_gauss_rules_new(double error)
{
    static const unsigned counts[LX_RULES] = {LX_RULE_COUNTS};
    struct lx_gauss_rules *rules = lx_new_array(1, sizeof *rules);
    if (!rules)
        return NULL;
    rules->digits = -log(error);
    for (int i = 0; i < LX_RULES; i++)
        make_rule(counts[i], &rules->rules[i]);
    return rules;
}
