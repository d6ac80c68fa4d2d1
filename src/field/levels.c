/* SPDX-License-Identifier: MIT */
/* Round levels: numbers that a reader takes in at a glance. */
#include <luxel/isophotes.h>

#include <math.h>

/* The step of 1, 2 or 5 times a power of ten that cuts a range nearest to `wanted` times. */
static double round_step(double range, size_t wanted, double *power)
{
    static const double steps[] = {1, 2, 5, 10};
    double best = 0, nearest = HUGE_VAL;
    *power = pow(10, floor(log10(range / (double)(wanted + 1))));
    for (int i = 0; i < 4; i++) {
        double count = range / (steps[i] * *power), away = fabs(log(count / (double)(wanted + 1)));
        if (away < nearest) {
            nearest = away;
            best = steps[i];
        }
    }
    return best;
}

/* k times step times power with as little rounding as may be: powers below 1 divide. */
static double multiple(double k, double step, double power)
{
    return power < 1 ? k * step / round(1 / power) : k * step * power;
}

static size_t linear_levels(double low, double high, size_t wanted, double *levels, size_t room)
{
    double power, step = round_step(high - low, wanted, &power);
    size_t count = 0;
    for (double k = floor(low / (step * power)); count < room; k++) {
        double level = multiple(k, step, power);
        if (level >= high)
            break;
        if (level > low)
            levels[count++] = level;
    }
    return count;
}

/* 1, 2 and 5 times the powers of ten, or the powers alone, or every second, third ... of them. */
static size_t logarithmic_levels(double low, double high, size_t wanted, double *levels, size_t room)
{
    static const double digits[] = {1, 2, 5};
    double decades = log10(high / low);
    bool all = 3 * decades <= 1.5 * (double)wanted;
    double stride = all ? 1 : fmax(1, ceil(decades / (1.5 * (double)wanted)));
    size_t count = 0;
    for (double exponent = floor(log10(low) / stride) * stride; count < room; exponent += stride)
        for (int i = 0; i < (all ? 3 : 1) && count < room; i++) {
            double level = exponent < 0 ? digits[i] / pow(10, -exponent) : digits[i] * pow(10, exponent);
            if (level >= high)
                return count;
            if (level > low)
                levels[count++] = level;
        }
    return count;
}

size_t luxel_round_levels(double low, double high, bool logarithmic, size_t wanted, double *levels, size_t room)
{
    if (!(low < high) || !isfinite(low) || !isfinite(high) || !isfinite(high - low) || wanted == 0)
        return 0;
    if (!logarithmic)
        return linear_levels(low, high, wanted, levels, room);
    /* from 0 on: the four decades that pictures show */
    double least = low > 0 ? low : high * 1e-4;
    return high > 0 ? logarithmic_levels(least, high, wanted, levels, room) : 0;
}
