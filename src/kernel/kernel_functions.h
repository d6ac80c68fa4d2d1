/* SPDX-License-Identifier: MIT */
/*
 * The functions of a number that the kernels need beside roots: powers of cosines and an angle.  kernel.c includes it
 * once for each precision, behind lanes.h, with LOG_TERMS and EXP_TERMS, the terms of the series, besides.
 *
 * Cosines that are raised to a power enter with t = 1 - cos = |a - b|^2 / 2, a and b the unit vectors that make the
 * angle: near 1 a cosine has lost the digits that tell how far the angle is from 0.  In float64 the cosine itself is
 * exact where t, near 1, has lost those that tell how far the angle is from pi/2; in float32 it may be 1 - t, as lights
 * for which that matters are never left to float32.  NAME(limit) makes both 0 and 1 beyond pi/2.
 */

LX_LANE NAME(lanes) NAME(polynomial)(NAME(lanes) x, const REAL *coefficients, int count)
{
    NAME(lanes) value = NAME(all)(coefficients[count - 1]);
    for (int k = count - 2; k >= 0; k--)
        value = value * x + coefficients[k];
    return value;
}

/*
 * log2(w + c) of w > 0 and a c that is small beside it, and 2^y for y <= 0, about 0 below the normal numbers.  Errors
 * below 3 ulp of the result and 2 ulp.
 *
 * Where a register holds a table of 16: with w = 2^k m, m within [3/4, 3/2), and 1/a of the table near to m,
 * log2 m = log2 a + log2(1 + r), r = m/a - 1 within [-1/32, 1/16]; a is 1 on both sides of 1, and else one whose
 * logarithm is very nearly a number of float32.  2^y = 2^k 2^(j/16) 2^f, |f| <= 1/32.  The polynomials are the nearest.
 */
#if LX_IS_SINGLE && LX_ISA_LEVEL >= 4
LX_LANE NAME(lanes) NAME(log2_of)(NAME(lanes) w, NAME(lanes) c)
{
    _Alignas(64) static const REAL inverses[] = {
        1,           0.9141801F,  0.864696205F, 0.820501029F, 0.780451536F, 0.744180262F, 0.71124357F, 0.680757821F,
        1.30610323F, 1.25497186F, 1.20725596F,  1.16394758F,  1.12315786F,  1.08470762F,  1.04888546F, 1,
    };
    _Alignas(64) static const REAL logarithms[] = {
        0,
        0.12944968F,
        0.209734738F,
        0.285422951F,
        0.357619047F,
        0.426275969F,
        0.49158439F,
        0.554786444F,
        -0.385268927F,
        -0.327655017F,
        -0.271731585F,
        -0.219026089F,
        -0.167560712F,
        -0.117306218F,
        -0.0688571483F,
        0,
    };
    static const REAL terms[] = {1.442695038F, -0.7213475528F, 0.4809186596F, -0.3607730393F, 0.2712075229F};
    NAME(lanes) exponent, m = NAME(split)(w, &exponent);
    const NAME(lane_bits) index = (NAME(lane_bits))m >> (MANTISSA - 4);
    /* without rounding the product, whatever compilers make of sums */
    const NAME(lanes) r = LX_OPERATION(fmsub)(m, NAME(entries)(inverses, index), NAME(all)(1));
    const NAME(lanes) rest = NAME(entries)(logarithms, index) + (REAL)1.4426950408889634 * c;
    return exponent + (r * NAME(polynomial)(r, terms, (int)(sizeof terms / sizeof *terms)) + rest);
}

LX_LANE NAME(lanes) NAME(exp2_of)(NAME(lanes) y)
{
    _Alignas(64) static const REAL roots[] = {
        1,           1.04427373F, 1.09050775F, 1.13878858F, 1.18920708F, 1.24185777F, 1.29683959F, 1.35425556F,
        1.41421354F, 1.47682619F, 1.54221082F, 1.61049032F, 1.68179286F, 1.75625217F, 1.8340081F,  1.91520655F,
    };
    static const REAL terms[] = {0.6931471802F, 0.2402335516F, 0.05550573632F};
    const REAL magic = (REAL)MAGIC / 16; /* sixteenths are counted in its last bits */
    const NAME(lanes) count = y + magic, near = count - magic, f = y - near;
    const NAME(lanes) root = NAME(entries)(roots, (NAME(lane_bits))count);
    const NAME(lanes) series = f * NAME(polynomial)(f, terms, (int)(sizeof terms / sizeof *terms));
    return NAME(scale)(root + root * series, near); /* by the whole number below it */
}
#else
/* With w = 2^k m, m within [sqrt(1/2), sqrt(2)): log2 m = 2/ln 2 (s + s^3/3 + s^5/5 ...), s = (m - 1)/(m + 1). */
LX_LANE NAME(lanes) NAME(log2_of)(NAME(lanes) w, NAME(lanes) c)
{
    NAME(lanes) exponent, m = NAME(split)(NAME(greater)(w, NAME(all)((REAL)SMALLEST)), &exponent);
    NAME(lanes) s = (m - 1) * NAME(inverse)(m + 1), s2 = s * s;
    NAME(lanes) series = NAME(all)((REAL)1 / (2 * LOG_TERMS - 1));
    for (int k = LOG_TERMS - 2; k >= 0; k--)
        series = series * s2 + (REAL)1 / (REAL)(2 * k + 1);
    return exponent + ((REAL)2.8853900817779268 * s * series + (REAL)1.4426950408889634 * c);
}

LX_LANE NAME(lanes) NAME(exp2_of)(NAME(lanes) y)
{
    static const REAL coefficients[] = {
        (REAL)1,
        (REAL)6.9314718055994531e-1,
        (REAL)2.4022650695910071e-1,
        (REAL)5.5504108664821580e-2,
        (REAL)9.6181291076284772e-3,
        (REAL)1.3333558146428443e-3,
        (REAL)1.5403530393381609e-4,
        (REAL)1.5252733804059840e-5,
        (REAL)1.3215486790144309e-6,
        (REAL)1.0178086009239699e-7,
        (REAL)7.0549116208011233e-9,
        (REAL)4.4455382718708114e-10,
        (REAL)2.5678435993488204e-11,
        (REAL)1.3691488853904128e-12,
    };
    NAME(lanes) whole = NAME(whole_of)(y), fraction = y - whole;
    NAME(lanes) series = NAME(all)(coefficients[EXP_TERMS - 1]);
    for (int k = EXP_TERMS - 2; k >= 0; k--)
        series = series * fraction + coefficients[k];
    return NAME(scale)(series, whole);
}
#endif

LX_LANE void NAME(limit)(NAME(lanes) * cosine, NAME(lanes) * versine)
{
    *versine = NAME(lesser)(*versine, NAME(all)(1));
    *cosine = LX_IS_SINGLE ? 1 - *versine : NAME(greater)(*cosine, NAME(all)(0));
}

/*
 * The powers cosine^exponent of `count` vectors side by side, with t = 1 - cosine; cosine is at least 0, but for
 * roundings of 1 by which a power near 0 may then be off, too.  A whole exponent by
 * squaring: while it is large by squaring the complements, 1 - (1 - t)^2 = t (2 - t), which keeps the digits of a small
 * t; at last the powers themselves, which keeps those of a small power.  Others by the logarithm.  Errors, t's own
 * aside: below 6 ulp of 1, by the logarithm 2.  In float64 what has become less than a half is squared itself from
 * there on, so that a power p of any size is good to some ulp of p ln p: there are pictures that show only the faint
 * foot of a highlight.
 */
LX_LANE void NAME(raise)(const NAME(lanes) * cosine, const NAME(lanes) * versine, int count,
                         struct NAME(lx_exponent) exponent, NAME(lanes) * power)
{
    enum { LEAST_BY_COMPLEMENTS = 12 };
    const NAME(lanes) zero = NAME(all)(0), half = NAME(all)((REAL)0.5);
    NAME(lanes) base[LX_ABREAST], t[LX_ABREAST];
    for (int i = 0; i < count; i++) {
        t[i] = versine[i];
        base[i] = LX_IS_SINGLE ? cosine[i] : NAME(where_above)(t[i], half, cosine[i], 1 - t[i]);
    }
    unsigned bits = exponent.whole;
    if (bits == 0) {
        for (int i = 0; i < count; i++) {
            NAME(lanes) rest = (1 - base[i]) - t[i]; /* what base has lost of 1 - t */
            if (!LX_IS_SINGLE)
                rest = NAME(where_above)(t[i], half, zero, rest);
            power[i] = exponent.value * NAME(log2_of)(base[i], rest);
        }
        for (int i = 0; i < count; i++)
            power[i] = NAME(where_above)(base[i], zero, NAME(exp2_of)(power[i]), zero);
        return;
    }
    bool is_one = true; /* the power so far */
    for (; bits >= LEAST_BY_COMPLEMENTS; bits >>= 1) {
        if (bits & 1) {
            for (int i = 0; i < count; i++)
                power[i] = is_one ? base[i] : LX_IS_SINGLE ? power[i] - power[i] * t[i] : power[i] * base[i];
            is_one = false;
        }
        for (int i = 0; i < count; i++) {
            t[i] = t[i] * (2 - t[i]);
            base[i] = LX_IS_SINGLE ? 1 - t[i] : NAME(where_above)(t[i], half, base[i] * base[i], 1 - t[i]);
        }
    }
    for (; !(bits & 1); bits >>= 1)
        for (int i = 0; i < count; i++)
            base[i] *= base[i];
    for (int i = 0; i < count; i++)
        power[i] = is_one ? base[i] : power[i] * base[i];
    while (bits >>= 1) {
        for (int i = 0; i < count; i++)
            base[i] *= base[i];
        for (int i = 0; i < count && (bits & 1); i++)
            power[i] *= base[i];
    }
}

LX_LANE NAME(lanes) NAME(power_of)(NAME(lanes) cosine, NAME(lanes) versine, struct NAME(lx_exponent) exponent)
{
    NAME(lanes) power;
    NAME(limit)(&cosine, &versine);
    NAME(raise)(&cosine, &versine, 1, exponent, &power);
    return power;
}

/* gap(z) = 1 - atan(sqrt z)/sqrt z for 0 <= z <= 1; the polynomial is the nearest to gap(z)/z.  Error below 2 ulp. */
#if LX_IS_SINGLE
static const REAL NAME(gap_terms)[] = {0.333333317F,   -0.199997393F, 0.142785687F,   -0.110337641F, 0.0865688043F,
                                       -0.0625016944F, 0.035871539F,  -0.0135077714F, 0.00238699732F};
#else
static const REAL NAME(gap_terms)[] = {
    0.33333333333333333,   -0.19999999999999553,  0.14285714285648404,   -0.11111111107234799,   0.090909089695574031,
    -0.076923053546786548, 0.066666364357776927,  -0.058820749563712946, 0.052612657357094544,   -0.047520867735766561,
    0.043081196553304713,  -0.038726402140426325, 0.033750132001619734,  -0.027567942297344677,  0.020238706986393516,
    -0.012756172907694297, 0.0065756833441516986, -0.002622977891906089, 0.00075184725269738215, -0.0001368724853148122,
    1.1832505417555693e-5,
};
#endif
enum { NAME(GAP_TERMS) = sizeof NAME(gap_terms) / sizeof *NAME(gap_terms) };

LX_LANE NAME(lanes) NAME(gap_of)(NAME(lanes) z)
{
    return z * NAME(polynomial)(z, NAME(gap_terms), NAME(GAP_TERMS));
}

/* An angle up to 90 degrees divided by its sine, of z = 1 - cosine; likewise.  Error below 2 ulp of 1. */
LX_LANE NAME(lanes) NAME(arc_over_sine)(NAME(lanes) z)
{
#if LX_IS_SINGLE
    static const REAL coefficients[] = {0.333333328F,  0.133334323F,   0.0571105879F, 0.0258003783F,  0.0090147924F,
                                        0.0142751467F, -0.0162989942F, 0.024591851F,  -0.0157470768F, 0.00538198021F};
#else
    static const REAL coefficients[] = {
        0.33333333333333335,   0.13333333333332159,    0.057142857144574497,   0.025396825297269286,
        0.011544014593116172,  0.0053279483088366183,  0.0024871121300071885,  0.0011638546001328132,
        0.0005940854424188283, 7.2113529832630871e-5,  0.00083300093742698707, -0.0019569674992866074,
        0.0045212623352351001, -0.0078002147398554877, 0.010588885862776898,   -0.011041195077543494,
        0.008721864552393709,  -0.0050442123635885331, 0.0020230684103422831,  -0.00050420295628496021,
        5.9559620437726247e-5,
    };
#endif
    return 1 + z * NAME(polynomial)(z, coefficients, (int)(sizeof coefficients / sizeof *coefficients));
}

/* The angle, up to pi/2, of which t is the tangent of the half.  Error below 2 ulp. */
LX_LANE NAME(lanes) NAME(angle_of_half_tangent)(NAME(lanes) t)
{
    return 2 * t * (1 - NAME(gap_of)(t * t));
}
