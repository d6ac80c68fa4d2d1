/* SPDX-License-Identifier: MIT */
/*
 * Round levels: numbers that a reader takes in at a glance.  Each is a digit times a power of ten, rounded once, so
 * that it is the very number that its few digits stand for.
 */
#include <luxel/isophotes.h>

#include <math.h>
#include <stdio.h>

#include "../base/number.h"

/* Whole numbers up to here are exact, and one more is another. */
static const double MOST_STEPS = 1e15;

/* whole x 10^exponent, where it is a double; else the infinity or the 0 that lies beyond. */
static double scaled(double whole, int exponent)
{
    char text[48];
    double value;
    int length = snprintf(text, sizeof text, "%lldE%d", (long long)whole, exponent);
    if (lx_read_number(text, (size_t)length, &value))
        return value;
    return whole == 0 ? 0 : copysign(HUGE_VAL, whole);
}

/* A step: a digit times a power of ten. */
struct step {
    int digit, exponent;
};

/* The step of 1, 2 or 5 times a power of ten that cuts a range nearest to `wanted` times. */
static struct step round_step(double low, double high, size_t wanted)
{
    static const int digits[] = {1, 2, 5, 10};
    /* the range itself may be beyond all doubles */
    double cuts = (double)wanted + 1, part = high / cuts - low / cuts, nearest = HUGE_VAL;
    struct step best = {1, (int)floor(log10(part))};
    int exponent = best.exponent;
    for (int i = 0; i < 4; i++) {
        double away = fabs(log(part) - log(digits[i]) - exponent * log(10));
        if (away < nearest) {
            nearest = away;
            best = (struct step){digits[i], exponent};
        }
    }
    return best;
}

/* The next coarser one. */
static struct step coarser(struct step step)
{
    switch (step.digit) {
    case 1: return (struct step){2, step.exponent};
    case 2: return (struct step){5, step.exponent};
    case 5: return (struct step){1, step.exponent + 1};
    default: return (struct step){2, step.exponent + 1};
    }
}

static size_t linear_levels(double low, double high, size_t wanted, double *levels, size_t room)
{
    for (struct step step = round_step(low, high, wanted);; step = coarser(step)) {
        double size = scaled(step.digit, step.exponent), first = floor(low / size), last = ceil(high / size);
        /* a range too narrow, or too near to 0, for steps that doubles can tell apart */
        if (!(size > 0 && size < HUGE_VAL) || !(fabs(first) <= MOST_STEPS && fabs(last) <= MOST_STEPS))
            return 0;
        while (first <= last && scaled(first * step.digit, step.exponent) <= low)
            first++;
        while (first <= last && scaled(last * step.digit, step.exponent) >= high)
            last--;
        if (last - first + 1 > (double)room)
            continue;
        size_t count = 0;
        for (double k = first; k <= last; k++)
            levels[count++] = scaled(k * step.digit, step.exponent);
        return count;
    }
}

/* 1, 2 and 5 times the powers of ten, or the powers alone, or every second, third ... of them. */
static size_t logarithmic_levels(double low, double high, size_t wanted, double *levels, size_t room)
{
    static const int digits[] = {1, 2, 5};
    double decades = log10(high) - log10(low);
    bool all = 3 * decades <= 1.5 * (double)wanted + 1e-9; /* four decades are four, whatever rounding makes of them */
    int stride = all ? 1 : (int)fmax(1, ceil(decades / (1.5 * (double)wanted)));
    size_t count = 0;
    for (int exponent = (int)floor(log10(low) / stride) * stride;; exponent += stride)
        for (int i = 0; i < (all ? 3 : 1); i++) {
            double level = scaled(digits[i], exponent);
            if (level >= high || count == room)
                return count;
            if (level > low)
                levels[count++] = level;
        }
}

size_t luxel_round_levels(double low, double high, bool logarithmic, size_t wanted, double *levels, size_t room)
{
    if (!(low < high) || !isfinite(low) || !isfinite(high) || wanted == 0 || room == 0)
        return 0;
    if (wanted > room)
        wanted = room;
    if (!logarithmic)
        return linear_levels(low, high, wanted, levels, room);
    /* from 0 on: the four decades that pictures show */
    double least = low > 0 ? low : high * 1e-4;
    return least > 0 ? logarithmic_levels(least, high, wanted, levels, room) : 0;
}
