/* SPDX-License-Identifier: MIT */
/*
 * Bounded numbers: a float64 value with a bound of its distance from the exact result, carried through every
 * operation (running error analysis: Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 3.3).
 *
 * The value is what plain float64 arithmetic gives; `error` bounds |value - exact|, where exact is the result
 * in real numbers.  Each operation adds its own rounding, half a unit in the last place for + - * / sqrt and
 * one unit for the functions of libm, to what its operands bring.  The bounds' own roundings are covered by
 * LX_BOUND_SLACK, applied once in an operation.  The files that use this are built without contraction of
 * products and sums.
 */
#ifndef LX_BASE_BOUNDED_H
#define LX_BASE_BOUNDED_H

#include <float.h>
#include <luxel/bounded.h>
#include <math.h>
#include <stdbool.h>

typedef luxel_bounded lx_bounded;

typedef struct lx_bounded3 {
    lx_bounded x, y, z;
} lx_bounded3;

#define LX_ROUNDING (DBL_EPSILON / 2)
#define LX_BOUND_SLACK (1 + 16 * DBL_EPSILON)
/* Absolute rounding of a result, and of its bound, that may have left the normal numbers: bounds of results below
 * LX_SMALL may. */
#define LX_UNDERFLOW (4 * DBL_TRUE_MIN)
#define LX_SMALL (DBL_MIN / DBL_EPSILON)

static inline lx_bounded lx_exact(double value)
{
    return (lx_bounded){value, 0};
}

/* value with the roundings `units` half-units in the last place, and the error that came with the operands */
static inline lx_bounded lx_rounded(double value, double inherited, double units)
{
    return (lx_bounded){value, (inherited + units * LX_ROUNDING * fabs(value)) * LX_BOUND_SLACK};
}

static inline bool lx_is_zero(lx_bounded a)
{
    return a.value == 0 && a.error == 0;
}

static inline lx_bounded lx_negate(lx_bounded a)
{
    return (lx_bounded){-a.value, a.error};
}

static inline lx_bounded lx_add(lx_bounded a, lx_bounded b)
{
    return lx_rounded(a.value + b.value, a.error + b.error, 1);
}

static inline lx_bounded lx_sub(lx_bounded a, lx_bounded b)
{
    return lx_rounded(a.value - b.value, a.error + b.error, 1);
}

static inline lx_bounded lx_mul(lx_bounded a, lx_bounded b)
{
    double inherited = fabs(a.value) * b.error + fabs(b.value) * a.error + a.error * b.error;
    double value = a.value * b.value;
    if (fabs(value) < LX_SMALL && !lx_is_zero(a) && !lx_is_zero(b))
        inherited += LX_UNDERFLOW;
    return lx_rounded(value, inherited, 1);
}

/* Exact factors: powers of two, 0 and signs. */
static inline lx_bounded lx_scale(lx_bounded a, double exact_factor)
{
    return (lx_bounded){a.value * exact_factor, a.error * fabs(exact_factor)};
}

/* An infinite bound where the divisor may be zero. */
static inline lx_bounded lx_div(lx_bounded a, lx_bounded b)
{
    double least = fabs(b.value) - b.error;
    double value = a.value / b.value;
    if (!(least > 0))
        return (lx_bounded){value, HUGE_VAL};
    double inherited = (a.error + fabs(value) * b.error) / least;
    if (fabs(value) < LX_SMALL && !lx_is_zero(a))
        inherited += LX_UNDERFLOW;
    return lx_rounded(value, inherited, 2);
}

/* |sqrt(a + e) - sqrt(a)| <= e / sqrt(a), and sqrt(a + e) where a is not larger than e. */
static inline lx_bounded lx_sqrt(lx_bounded a)
{
    double value = sqrt(fmax(a.value, 0));
    double inherited = a.error == 0 ? 0 : a.value > a.error ? a.error / value : sqrt(fmax(a.value, 0) + a.error);
    return lx_rounded(value, inherited, 2);
}

/* max(0, a) */
static inline lx_bounded lx_positive(lx_bounded a)
{
    if (a.value > 0)
        return a;
    return (lx_bounded){0, fmax(a.value + a.error, 0)};
}

static inline lx_bounded lx_exp(lx_bounded a)
{
    double value = exp(a.value);
    return lx_rounded(value, value * expm1(a.error) + LX_UNDERFLOW, 4);
}

/* log(1 + a) */
static inline lx_bounded lx_log1p(lx_bounded a)
{
    double least = 1 + a.value - a.error;
    return lx_rounded(log1p(a.value), least > 0 ? a.error / least * (1 + 4 * DBL_EPSILON) : HUGE_VAL, 4);
}

/* a^n for a >= 0 and an exact n >= 0, with 0^0 = 1 */
static inline lx_bounded lx_power(lx_bounded a, double n)
{
    if (n == 0 || lx_is_zero(a))
        return lx_exact(n == 0);
    double value = pow(a.value, n);
    double least = a.value - a.error, growth = least > 0 ? n * a.error / least : HUGE_VAL;
    if (growth < 1)
        return lx_rounded(value, value * expm1(growth) + LX_UNDERFLOW, 4);
    /* somewhere between 0 and (a + error)^n; the power multiplies the rounding of the sum */
    double most = pow((a.value + a.error) * (1 + 2 * DBL_EPSILON), n);
    return (lx_bounded){value, most * (1 + 8 * DBL_EPSILON) + LX_UNDERFLOW};
}

/*
 * cosine^exponent of an angle given by its cosine and its squared sine, 0 where the cosine is negative; x^0 = 1.
 * Near 1 the logarithm of the cosine is known better from the sine: pow would multiply the cosine's rounding by
 * the exponent.
 */
static inline lx_bounded lx_cosine_power(lx_bounded cosine, lx_bounded sine_squared, double exponent)
{
    if (exponent == 0)
        return lx_exact(1);
    lx_bounded power = cosine.value > 0 && sine_squared.value < 0.5
                           ? lx_exp(lx_mul(lx_exact(exponent / 2), lx_log1p(lx_negate(sine_squared))))
                           : lx_power(lx_positive(cosine), exponent);
    /* A direction that is not defined (the half vector of opposite directions) lights nothing; in doubt the
     * power is still between 0 and 1. */
    if (!(power.value >= 0))
        return (lx_bounded){0, 1};
    return (lx_bounded){power.value, power.error < 1 ? power.error : 1};
}

/* The angle of (x, y) in radians; its error is at most the operands' errors over the distance from 0. */
static inline lx_bounded lx_angle(lx_bounded y, lx_bounded x)
{
    double least = hypot(x.value, y.value) - x.error - y.error;
    double moved = hypot(x.error, y.error);
    return lx_rounded(atan2(y.value, x.value), least > 0 ? moved / least * (1 + 8 * DBL_EPSILON) : 2 * M_PI, 4);
}

static inline lx_bounded lx_sin(lx_bounded a)
{
    return lx_rounded(sin(a.value), a.error, 4);
}

/* A yes (1) or no (0) by the sign of a; where the sign is in doubt the bound covers both. */
static inline lx_bounded lx_step(lx_bounded a, bool yes_at_zero)
{
    bool yes = a.value > 0 || (yes_at_zero && a.value == 0);
    bool certain = fabs(a.value) > a.error || a.error == 0;
    return (lx_bounded){yes ? 1 : 0, certain ? 0 : 1};
}

/* The other answer. */
static inline lx_bounded lx_not(lx_bounded step)
{
    return (lx_bounded){1 - step.value, step.error};
}

/* Whether both answers are yes. */
static inline lx_bounded lx_both(lx_bounded a, lx_bounded b)
{
    bool no = lx_is_zero(a) || lx_is_zero(b);
    return (lx_bounded){a.value * b.value, no ? 0 : fmax(a.error, b.error)};
}

static inline lx_bounded3 lx_exact3(const double v[3])
{
    return (lx_bounded3){lx_exact(v[0]), lx_exact(v[1]), lx_exact(v[2])};
}

static inline void lx_values3(lx_bounded3 a, double values[3])
{
    values[0] = a.x.value, values[1] = a.y.value, values[2] = a.z.value;
}

/* How far a vector may be off: no farther than its components together. */
static inline double lx_error3(lx_bounded3 a)
{
    return a.x.error + a.y.error + a.z.error;
}

static inline lx_bounded3 lx_negate3(lx_bounded3 a)
{
    return (lx_bounded3){lx_negate(a.x), lx_negate(a.y), lx_negate(a.z)};
}

static inline lx_bounded3 lx_add3(lx_bounded3 a, lx_bounded3 b)
{
    return (lx_bounded3){lx_add(a.x, b.x), lx_add(a.y, b.y), lx_add(a.z, b.z)};
}

static inline lx_bounded3 lx_sub3(lx_bounded3 a, lx_bounded3 b)
{
    return (lx_bounded3){lx_sub(a.x, b.x), lx_sub(a.y, b.y), lx_sub(a.z, b.z)};
}

static inline lx_bounded3 lx_mul3(lx_bounded3 a, lx_bounded factor)
{
    return (lx_bounded3){lx_mul(a.x, factor), lx_mul(a.y, factor), lx_mul(a.z, factor)};
}

static inline lx_bounded lx_dot3(lx_bounded3 a, lx_bounded3 b)
{
    return lx_add(lx_add(lx_mul(a.x, b.x), lx_mul(a.y, b.y)), lx_mul(a.z, b.z));
}

static inline lx_bounded3 lx_cross3(lx_bounded3 a, lx_bounded3 b)
{
    return (lx_bounded3){
        lx_sub(lx_mul(a.y, b.z), lx_mul(a.z, b.y)),
        lx_sub(lx_mul(a.z, b.x), lx_mul(a.x, b.z)),
        lx_sub(lx_mul(a.x, b.y), lx_mul(a.y, b.x)),
    };
}

static inline lx_bounded lx_square3(lx_bounded3 a)
{
    return lx_dot3(a, a);
}

/* The power of two that brings the largest component near 1, so that squares neither overflow nor vanish. */
static inline double lx_scale_for3(lx_bounded3 a)
{
    double largest = fmax(fmax(fabs(a.x.value), fabs(a.y.value)), fabs(a.z.value));
    if (!(largest > 0 && isfinite(largest)))
        return 1;
    int exponent = ilogb(largest);
    return ldexp(1, exponent < -1000 ? 1000 : -exponent); /* the scale itself must stay finite */
}

static inline lx_bounded3 lx_scale3(lx_bounded3 a, double exact_factor)
{
    return (lx_bounded3){lx_scale(a.x, exact_factor), lx_scale(a.y, exact_factor), lx_scale(a.z, exact_factor)};
}

static inline lx_bounded lx_length3(lx_bounded3 a)
{
    double scale = lx_scale_for3(a);
    return lx_scale(lx_sqrt(lx_square3(lx_scale3(a, scale))), 1 / scale);
}

static inline lx_bounded3 lx_unit3(lx_bounded3 a)
{
    a = lx_scale3(a, lx_scale_for3(a));
    lx_bounded length = lx_sqrt(lx_square3(a));
    lx_bounded3 unit = {lx_div(a.x, length), lx_div(a.y, length), lx_div(a.z, length)};
    const int along = (fabs(a.x.value) > 0) + (fabs(a.y.value) > 0) + (fabs(a.z.value) > 0);
    if (along == 1 && a.x.error + a.y.error + a.z.error == 0) /* an axis, and exact */
        unit.x.error = unit.y.error = unit.z.error = 0;
    return unit;
}

/* An unevaluated sum of two float64 numbers: twice the precision where cancellation would lose it. */
struct lx_pair {
    double high, low;
};

/* a - b without error. */
struct lx_pair lx_exact_difference(double a, double b);

/* a * b without error (short of underflow). */
struct lx_pair lx_exact_product(double a, double b);

/* a^2 - b^2 as if computed in twice the precision: lx_exact_dot() of two terms, without the bound. */
struct lx_pair lx_exact_difference_of_squares(double a, double b);

/*
 * The sum of a[i] b[i] as if computed in twice the precision: its error is at most
 * (2 count rounding)^2 * sum |a[i] b[i]|, handed out as *error.  (Ogita, Rump, Oishi, Accurate sum and dot
 * product, SIAM J. Sci. Comput. 26 (2005), algorithm 5.3.)
 */
struct lx_pair lx_exact_dot(unsigned count, const double a[], const double b[], double *error);

#endif
