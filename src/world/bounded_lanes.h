/* SPDX-License-Identifier: MIT */
/*
 * Bounded numbers (base/bounded.h) in vectors of float64: each operation makes of every lane what the one of the same
 * name there makes of a single number, to the last bit, the bound included.  So there is nothing to prove anew, and
 * tests compare bits.  Needs lanes.h in float64 before it, and a compiler that contracts nothing.
 *
 * The functions of libm are taken lane by lane: vectors of them would have other last bits.
 */
#include "../base/bounded.h"

struct bounded {
    lanes_double value, error;
};

struct bounded3 {
    struct bounded x, y, z;
};

LX_LANE lanes_double size_of(lanes_double a)
{
    return (lanes_double)((lane_bits_double)a & ~(lane_bits_double)all_double(-0.0));
}

LX_LANE lanes_double square_root(lanes_double a)
{
#if LX_ISA_LEVEL >= 1
    return LX_OPERATION(sqrt)(a);
#else
    for (int i = 0; i < LX_WIDTH_double; i++)
        a[i] = sqrt(a[i]);
    return a;
#endif
}

/* Where a > b, in any lane, what holds for it; 0 elsewhere. */
LX_LANE lanes_double only_above(lanes_double a, lanes_double b, lanes_double number)
{
    return where_above_double(a, b, number, all_double(0));
}

LX_LANE struct bounded exactly(lanes_double value)
{
    return (struct bounded){value, all_double(0)};
}

LX_LANE struct bounded everywhere(lx_bounded a)
{
    return (struct bounded){all_double(a.value), all_double(a.error)};
}

LX_LANE struct bounded3 everywhere3(lx_bounded3 a)
{
    return (struct bounded3){everywhere(a.x), everywhere(a.y), everywhere(a.z)};
}

LX_LANE struct bounded rounded(lanes_double value, lanes_double inherited, double units)
{
    return (struct bounded){value, (inherited + units * LX_ROUNDING * size_of(value)) * LX_BOUND_SLACK};
}

LX_LANE struct bounded negated(struct bounded a)
{
    return (struct bounded){-a.value, a.error};
}

LX_LANE struct bounded plus(struct bounded a, struct bounded b)
{
    return rounded(a.value + b.value, a.error + b.error, 1);
}

LX_LANE struct bounded minus(struct bounded a, struct bounded b)
{
    return rounded(a.value - b.value, a.error + b.error, 1);
}

/* What a result adds to its bound that may have left the normal numbers, unless a is 0. */
LX_LANE lanes_double underflow(lanes_double value, struct bounded a)
{
    const lanes_double lost = only_above(all_double(LX_SMALL), size_of(value), all_double(LX_UNDERFLOW));
    return only_above(size_of(a.value) + a.error, all_double(0), lost);
}

/* A product with its bound but for its own rounding.  Few products are as small as what may be lost. */
LX_LANE struct bounded product(lanes_double value, lanes_double inherited, struct bounded a, struct bounded b)
{
    if (__builtin_expect(any_above_double(all_double(LX_SMALL), size_of(value)), false))
        inherited += only_above(size_of(b.value) + b.error, all_double(0), underflow(value, a));
    return rounded(value, inherited, 1);
}

LX_LANE struct bounded times(struct bounded a, struct bounded b)
{
    return product(a.value * b.value, size_of(a.value) * b.error + size_of(b.value) * a.error + a.error * b.error, a,
                   b);
}

/* By a number without an error, other than which all is finite. */
LX_LANE struct bounded times_exactly(struct bounded a, lanes_double b)
{
    return product(a.value * b, size_of(b) * a.error, a, exactly(b));
}

LX_LANE struct bounded scaled(struct bounded a, lanes_double exact_factor)
{
    return (struct bounded){a.value * exact_factor, a.error * size_of(exact_factor)};
}

LX_LANE struct bounded over(struct bounded a, struct bounded b)
{
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL);
    const lanes_double least = size_of(b.value) - b.error, value = a.value / b.value;
    lanes_double inherited = (a.error + size_of(value) * b.error) / least;
    if (__builtin_expect(any_above_double(all_double(LX_SMALL), size_of(value)), false))
        inherited += underflow(value, a);
    const struct bounded quotient = rounded(value, inherited, 2);
    if (__builtin_expect(all_above_double(least, zero), true))
        return quotient;
    return (struct bounded){value, where_above_double(least, zero, quotient.error, infinite)};
}

/* By a number above 0 without an error. */
LX_LANE struct bounded over_exactly(struct bounded a, double b)
{
    const lanes_double value = a.value / b;
    lanes_double inherited = a.error / b;
    if (__builtin_expect(any_above_double(all_double(LX_SMALL), size_of(value)), false))
        inherited += underflow(value, a);
    return rounded(value, inherited, 2);
}

LX_LANE struct bounded root_of(struct bounded a)
{
    const lanes_double zero = all_double(0), above = greater_double(a.value, zero);
    const lanes_double value = square_root(above);
    lanes_double inherited = a.error / value;
    if (!all_above_double(a.value, a.error)) {
        inherited = where_above_double(a.value, a.error, inherited, square_root(above + a.error));
    }
    return rounded(value, only_above(a.error, zero, inherited), 2);
}

LX_LANE struct bounded positive(struct bounded a)
{
    const lanes_double zero = all_double(0);
    return (struct bounded){only_above(a.value, zero, a.value),
                            where_above_double(a.value, zero, a.error, greater_double(a.value + a.error, zero))};
}

/* 1 or 0 by the sign of a, as lx_step() has it. */
LX_LANE struct bounded step(struct bounded a, bool yes_at_zero)
{
    const lanes_double zero = all_double(0), one = all_double(1);
    const lanes_double in_doubt = only_above(a.error, zero, where_above_double(size_of(a.value), a.error, zero, one));
    return (struct bounded){
        yes_at_zero ? where_above_double(zero, a.value, zero, one) : only_above(a.value, zero, one),
        in_doubt,
    };
}

LX_LANE struct bounded3 minus3(struct bounded3 a, struct bounded3 b)
{
    return (struct bounded3){minus(a.x, b.x), minus(a.y, b.y), minus(a.z, b.z)};
}

LX_LANE struct bounded3 plus3(struct bounded3 a, struct bounded3 b)
{
    return (struct bounded3){plus(a.x, b.x), plus(a.y, b.y), plus(a.z, b.z)};
}

LX_LANE struct bounded3 times3(struct bounded3 a, struct bounded factor)
{
    return (struct bounded3){times(a.x, factor), times(a.y, factor), times(a.z, factor)};
}

LX_LANE struct bounded dot3(struct bounded3 a, struct bounded3 b)
{
    return plus(plus(times(a.x, b.x), times(a.y, b.y)), times(a.z, b.z));
}

LX_LANE struct bounded3 cross3(struct bounded3 a, struct bounded3 b)
{
    return (struct bounded3){
        minus(times(a.y, b.z), times(a.z, b.y)),
        minus(times(a.z, b.x), times(a.x, b.z)),
        minus(times(a.x, b.y), times(a.y, b.x)),
    };
}

LX_LANE struct bounded square3(struct bounded3 a)
{
    return dot3(a, a);
}

/* A power of two and its inverse. */
struct power_of_two {
    lanes_double value, inverse;
};

/* The one that lx_scale_for3() brings the largest component near 1 with, from the exponent's bits. */
LX_LANE struct power_of_two scale_for(lanes_double x, lanes_double y, lanes_double z)
{
    const lanes_double one = all_double(1), low = all_double(0x1p-1000), high = all_double(0x1p1023);
    const lanes_double largest = greater_double(greater_double(size_of(x), size_of(y)), size_of(z));
    const lane_bits_double exponent = (lane_bits_double)largest >> MANTISSA;
    struct power_of_two power = {(lanes_double)((2 * BIAS - exponent) << MANTISSA),
                                 (lanes_double)(exponent << MANTISSA)};
    if (__builtin_expect(all_above_double(largest, low) && all_above_double(high, largest), true))
        return power;
    power.value = where_above_double(low, largest, all_double(0x1p1000), power.value);
    power.value = where_above_double(high, largest, power.value, all_double(0x1p-1023));
    power.value = where_above_double(all_double(HUGE_VAL), largest, power.value, one);
    power.value = where_above_double(largest, all_double(0), power.value, one);
    power.inverse = 1 / power.value;
    return power;
}

LX_LANE struct bounded3 scaled3(struct bounded3 a, lanes_double factor)
{
    return (struct bounded3){scaled(a.x, factor), scaled(a.y, factor), scaled(a.z, factor)};
}

/* A unit vector and the length, which have the largest part of the work in common. */
LX_LANE struct bounded3 unit3(struct bounded3 a, struct bounded *length)
{
    const struct power_of_two scale = scale_for(a.x.value, a.y.value, a.z.value);
    const struct bounded3 near = scaled3(a, scale.value);
    const struct bounded measure = root_of(square3(near));
    if (length)
        *length = scaled(measure, scale.inverse);
    const lanes_double zero = all_double(0), one = all_double(1), doubt = near.x.error + near.y.error + near.z.error;
    const lanes_double along = only_above(size_of(near.x.value), zero, one) +
                               only_above(size_of(near.y.value), zero, one) +
                               only_above(size_of(near.z.value), zero, one);
    /* an axis, where that is exact, has no error */
    const lanes_double is_one =
        only_above(along, all_double(0.5), where_above_double(along, all_double(1.5), zero, one));
    const lanes_double share = where_above_double(doubt, zero, one, one - is_one);
    struct bounded3 unit = {over(near.x, measure), over(near.y, measure), over(near.z, measure)};
    unit.x.error *= share, unit.y.error *= share, unit.z.error *= share;
    return unit;
}

/* lx_cosine_power(), lane by lane. */
LX_LANE struct bounded cosine_power(struct bounded cosine, struct bounded sine_squared, double exponent)
{
    struct bounded power = exactly(all_double(1));
    for (int i = 0; i < LX_WIDTH_double && exponent != 0; i++) {
        const lx_bounded one = lx_cosine_power((lx_bounded){cosine.value[i], cosine.error[i]},
                                               (lx_bounded){sine_squared.value[i], sine_squared.error[i]}, exponent);
        power.value[i] = one.value;
        power.error[i] = one.error;
    }
    return power;
}

/* lx_angle(), likewise. */
LX_LANE struct bounded angle(struct bounded y, struct bounded x)
{
    struct bounded made = exactly(all_double(0));
    for (int i = 0; i < LX_WIDTH_double; i++) {
        const lx_bounded one = lx_angle((lx_bounded){y.value[i], y.error[i]}, (lx_bounded){x.value[i], x.error[i]});
        made.value[i] = one.value;
        made.error[i] = one.error;
    }
    return made;
}
