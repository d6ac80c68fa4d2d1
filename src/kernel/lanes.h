/* SPDX-License-Identifier: MIT */
/*
 * Lanes: vectors of one precision and the few operations on them that C has no sign for.  kernel.c includes it twice,
 * as it does kernel_real.h, with SUFFIX ps or pd besides.  Sums, products and comparisons are the compilers' own
 * (vector extensions of GCC and Clang), who also join products and sums into one operation where the set has it.
 *
 * A vector fills a register of the set: 16, 8, 4 numbers of float32, half as many of float64.
 */
#if LX_ISA_LEVEL >= 1
#include <immintrin.h>
#endif

#ifndef LX_VECTOR_BYTES
#if LX_ISA_LEVEL >= 4
#define LX_VECTOR_BYTES 64
#elif LX_ISA_LEVEL >= 3
#define LX_VECTOR_BYTES 32
#else
#define LX_VECTOR_BYTES 16
#endif

/*
 * Vectors that go side by side where one alone would wait for its own results, if there are that many lights; otherwise
 * two, as what wide registers hold takes as long to be kept in memory meanwhile as a light does.
 */
enum { LX_ABREAST = 4, LX_FEWEST_ABREAST = LX_VECTOR_BYTES == 64 ? 2 : 1 };

/* Before loops over them whose bodies compilers take for too long to be written out. */
#ifdef __clang__
#define LX_UNROLLED _Pragma("clang loop unroll(full)")
#else
#define LX_UNROLLED _Pragma("GCC unroll 32")
#endif

#define LX_LANE static inline __attribute__((always_inline))
#define LX_JOIN(a, b) LX_JOIN_WORDS(a, b)
#define LX_JOIN_WORDS(a, b) a##b
#if LX_ISA_LEVEL >= 4
#define LX_OPERATION(name) LX_JOIN(_mm512_##name##_, SUFFIX)
#elif LX_ISA_LEVEL >= 3
#define LX_OPERATION(name) LX_JOIN(_mm256_##name##_, SUFFIX)
#else
#define LX_OPERATION(name) LX_JOIN(_mm_##name##_, SUFFIX)
#endif
#endif

/*
 * Before loops that compilers write out by themselves.  With LX_KEPT_LOOPS they are told to keep loops, which makes
 * kernels smaller; in float32, which pictures wait for, these are written out still: kept, they cost an eighth.
 */
#undef LX_WRITTEN_OUT
#if LX_IS_SINGLE && defined LX_KEPT_LOOPS
#define LX_WRITTEN_OUT LX_UNROLLED
#else
#define LX_WRITTEN_OUT
#endif

typedef REAL NAME(lanes) __attribute__((vector_size(LX_VECTOR_BYTES)));
typedef BITS NAME(lane_bits) __attribute__((vector_size(LX_VECTOR_BYTES)));

enum { NAME(LX_WIDTH) = LX_VECTOR_BYTES / sizeof(REAL) };

/* One number in every lane. */
LX_LANE NAME(lanes) NAME(all)(REAL number)
{
    return number - (NAME(lanes)){0};
}

/* Arrays are aligned to whole vectors. */
LX_LANE NAME(lanes) NAME(load)(const REAL *from)
{
    return *(const NAME(lanes) *)__builtin_assume_aligned(from, LX_VECTOR_BYTES);
}

LX_LANE void NAME(store)(REAL *to, NAME(lanes) lanes)
{
    *(NAME(lanes) *)__builtin_assume_aligned(to, LX_VECTOR_BYTES) = lanes;
}

/* The greater and the lesser of two; b where a is no number. */
#if LX_ISA_LEVEL >= 1

LX_LANE NAME(lanes) NAME(greater)(NAME(lanes) a, NAME(lanes) b)
{
    return LX_OPERATION(max)(a, b);
}

LX_LANE NAME(lanes) NAME(lesser)(NAME(lanes) a, NAME(lanes) b)
{
    return LX_OPERATION(min)(a, b);
}

/* The root of a >= 0, whose square is normal where it is not 0: rounded as the machine does, or, where Newton's steps
 * take less time (see below), within 0.54 ulp, in float64 0.501. */
LX_LANE NAME(lanes) NAME(root)(NAME(lanes) a)
{
#if LX_ISA_LEVEL >= 4
    NAME(lanes) guess = LX_OPERATION(rsqrt14)(a);
    if (!LX_IS_SINGLE) {
        const NAME(lanes) e = 1 - a * guess * guess;
        guess += guess * e * ((REAL)0.5 + (REAL)0.375 * e);
    }
    NAME(lanes) root = a * guess, rest = LX_OPERATION(fnmadd)(root, root, a); /* without rounding the square */
    return LX_OPERATION(maskz_fmadd)(LX_JOIN(LX_OPERATION(cmp), _mask)(a, NAME(all)(0), _CMP_GT_OQ), (REAL)0.5 * guess,
                                     rest, root);
#else
    return LX_OPERATION(sqrt)(a);
#endif
}

/* Where a > b, `above`, elsewhere `other`. */
LX_LANE NAME(lanes) NAME(where_above)(NAME(lanes) a, NAME(lanes) b, NAME(lanes) above, NAME(lanes) other)
{
#if LX_ISA_LEVEL >= 4
    return LX_OPERATION(mask_blend)(LX_JOIN(LX_OPERATION(cmp), _mask)(a, b, _CMP_GT_OQ), other, above);
#elif LX_ISA_LEVEL >= 3
    /* of the set's own comparison gcc does not know that it is all a choice needs, and compares it with 0 */
    return LX_OPERATION(blendv)(other, above, (NAME(lanes))(a > b));
#else
    NAME(lanes) mask = LX_OPERATION(cmpgt)(a, b);
    return LX_OPERATION(or)(LX_OPERATION(and)(mask, above), LX_OPERATION(andnot)(mask, other));
#endif
}

#else

LX_LANE NAME(lanes) NAME(where_above)(NAME(lanes) a, NAME(lanes) b, NAME(lanes) above, NAME(lanes) other)
{
    NAME(lane_bits) mask = (NAME(lane_bits))(a > b);
    return (NAME(lanes))((mask & (NAME(lane_bits))above) | (~mask & (NAME(lane_bits))other));
}

LX_LANE NAME(lanes) NAME(greater)(NAME(lanes) a, NAME(lanes) b)
{
    return NAME(where_above)(a, b, a, b);
}

LX_LANE NAME(lanes) NAME(lesser)(NAME(lanes) a, NAME(lanes) b)
{
    return NAME(where_above)(b, a, a, b);
}

LX_LANE NAME(lanes) NAME(root)(NAME(lanes) a)
{
    for (int i = 0; i < NAME(LX_WIDTH); i++)
        a[i] = SQRT(a[i]);
    return a;
}

#endif

/* The size of a number, without its sign. */
LX_LANE NAME(lanes) NAME(magnitude)(NAME(lanes) a)
{
    return NAME(greater)(a, -a);
}

/* Whether a > b in any lane, and in all of them. */
#if LX_ISA_LEVEL >= 4
#define LX_LANES_ABOVE(a, b) ((unsigned)LX_JOIN(LX_OPERATION(cmp), _mask)(a, b, _CMP_GT_OQ))
#elif LX_ISA_LEVEL >= 3
#define LX_LANES_ABOVE(a, b) ((unsigned)LX_OPERATION(movemask)(LX_OPERATION(cmp)(a, b, _CMP_GT_OQ)))
#elif LX_ISA_LEVEL >= 1
#define LX_LANES_ABOVE(a, b) ((unsigned)LX_OPERATION(movemask)(LX_OPERATION(cmpgt)(a, b)))
#endif

LX_LANE bool NAME(any_above)(NAME(lanes) a, NAME(lanes) b)
{
#if LX_ISA_LEVEL >= 1
    return LX_LANES_ABOVE(a, b) != 0;
#else
    bool any = false;
    for (int i = 0; i < NAME(LX_WIDTH); i++)
        any = any || a[i] > b[i];
    return any;
#endif
}

LX_LANE bool NAME(all_above)(NAME(lanes) a, NAME(lanes) b)
{
#if LX_ISA_LEVEL >= 1
    return LX_LANES_ABOVE(a, b) == (1U << NAME(LX_WIDTH)) - 1;
#else
    bool all = true;
    for (int i = 0; i < NAME(LX_WIDTH); i++)
        all = all && a[i] > b[i];
    return all;
#endif
}
#undef LX_LANES_ABOVE

/*
 * 1 / a and 1 / sqrt(a) of normal numbers whose square and reciprocal are normal, too; within 2 ulp.  With 512 bits
 * from the machine's first guess g, whose relative error is at most 2^-14, by steps of Newton's with e = 1 - a g or
 * 1 - a g^2, which take less time than a root and a quotient; with narrower vectors they take more.  In float64 the
 * first step takes e^2 in, and a second one follows.
 */
LX_LANE NAME(lanes) NAME(inverse)(NAME(lanes) a)
{
#if LX_ISA_LEVEL >= 4
    NAME(lanes) guess = LX_OPERATION(rcp14)(a), e = 1 - a * guess;
    if (LX_IS_SINGLE)
        return guess + guess * e;
    guess += guess * (e + e * e);
    return guess + guess * (1 - a * guess);
#else
    return 1 / a;
#endif
}

LX_LANE NAME(lanes) NAME(inverse_root)(NAME(lanes) a)
{
#if LX_ISA_LEVEL >= 4
    NAME(lanes) guess = LX_OPERATION(rsqrt14)(a), e = 1 - a * guess * guess;
    if (LX_IS_SINGLE)
        return guess + (REAL)0.5 * guess * e;
    guess += guess * e * ((REAL)0.5 + (REAL)0.375 * e);
    return guess + (REAL)0.5 * guess * (1 - a * guess * guess);
#else
    return 1 / NAME(root)(a);
#endif
}

/*
 * Numbers as 2^whole times what is left.
 *
 * split      of a normal a > 0 what is left, from sqrt(1/2) to sqrt(2); where there are tables from 3/4 to 3/2, and a
 *            may be any number
 * whole_of   the whole number nearest to a <= 0, or, far below the exponents that there are, some number as low
 * scale      a 2^whole; where that is below the normal numbers, 0 or less than the least of them
 * entries    of a table of 16 those that the last four bits of each index choose; where a register holds as many
 */
#if LX_ISA_LEVEL >= 4

#if LX_IS_SINGLE
LX_LANE NAME(lanes) NAME(entries)(const REAL *table, NAME(lane_bits) index)
{
    return _mm512_permutexvar_ps((__m512i)index, NAME(load)(table));
}

LX_LANE NAME(lanes) NAME(split)(NAME(lanes) a, NAME(lanes) * whole)
{
    const NAME(lanes) left = _mm512_getmant_ps(a, _MM_MANT_NORM_p75_1p5, _MM_MANT_SIGN_src);
    *whole = _mm512_cvtepi32_ps((__m512i)((NAME(lane_bits))a - (NAME(lane_bits))left)) * 0x1p-23F;
    return left;
}
#else
LX_LANE NAME(lanes) NAME(split)(NAME(lanes) a, NAME(lanes) * whole)
{
    *whole = LX_OPERATION(getexp)((NAME(lanes))((REAL)1.4142135623730951 * a));
    return LX_OPERATION(scalef)(a, (NAME(lanes)) - *whole);
}

LX_LANE NAME(lanes) NAME(whole_of)(NAME(lanes) a)
{
    return LX_OPERATION(roundscale)(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
#endif

/* a 2^k; where k is no whole number the one below it counts.  Numbers below the normal ones cost a hundredfold. */
LX_LANE NAME(lanes) NAME(scale)(NAME(lanes) a, NAME(lanes) k)
{
    return LX_OPERATION(maskz_scalef)(LX_JOIN(LX_OPERATION(cmp), _mask)(k, NAME(all)(1 - BIAS), _CMP_GE_OQ), a, k);
}

#else

/* Whole numbers are counted in the last bits of numbers about 1.5 * 2^MANTISSA: a conversion that every set has. */
LX_LANE NAME(lanes) NAME(split)(NAME(lanes) a, NAME(lanes) * whole)
{
    const NAME(lane_bits) root = (NAME(lane_bits))NAME(all)((REAL)0.70710678118654752);
    NAME(lane_bits) bits = (NAME(lane_bits))a, biased = (bits - root + ((BITS)BIAS << MANTISSA)) >> MANTISSA;
    *whole = (NAME(lanes))(biased + (NAME(lane_bits))NAME(all)((REAL)MAGIC)) - (REAL)(MAGIC + BIAS);
    return (NAME(lanes))(bits - ((biased - (BITS)BIAS) << MANTISSA));
}

LX_LANE NAME(lanes) NAME(whole_of)(NAME(lanes) a)
{
    return NAME(greater)(a, NAME(all)(-BIAS)) + (REAL)MAGIC - (REAL)MAGIC;
}

LX_LANE NAME(lanes) NAME(scale)(NAME(lanes) a, NAME(lanes) whole)
{
    const NAME(lanes) magic = NAME(all)((REAL)MAGIC), lowest = NAME(all)(-BIAS);
    NAME(lane_bits) biased = (NAME(lane_bits))(whole + magic) - (NAME(lane_bits))magic + (BITS)BIAS;
    return NAME(where_above)(whole, lowest, a * (NAME(lanes))(biased << MANTISSA), NAME(all)(0));
}

#endif
