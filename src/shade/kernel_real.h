/* SPDX-License-Identifier: MIT */
/*
 * The shading kernel in one precision.  kernel.c includes it twice, behind lanes.h, with
 *
 *     REAL      float or double, and LX_IS_SINGLE 1 or 0
 *     NAME(x)   x with the precision's suffix
 *     BITS      an unsigned integer of the same size
 *     MANTISSA  number of bits of the fraction, BIAS of the exponent, MAGIC = 1.5 * 2^MANTISSA
 *     LOG_TERMS, EXP_TERMS   terms of the series
 *
 * For each vector of elements all lights of one kind are summed in registers.  What varies between kinds of lights and
 * materials is a constant parameter of an inlined loop.
 *
 * Cosines that are raised to a power enter as t = 1 - cos = |a - b|^2 / 2, a and b the unit vectors that make the
 * angle: a cosine near 1 has lost the digits that tell how far the angle is from 0.  In float64 the cosine itself comes
 * with it, as a t near 1 has lost those that tell how far the angle is from pi/2; lights for which that matters never
 * are left to float32.
 */

/* A vector of the elements of a block. */
struct NAME(elements) {
    NAME(lanes) px, py, pz, nx, ny, nz, vx, vy, vz;
};

/* The direction to a light, and E_perp. */
struct NAME(ray) {
    NAME(lanes) x, y, z, e;
};

/*
 * log2(w + c) of w > 0 and a c that is small beside it.  With w = 2^k m, m within [sqrt(1/2), sqrt(2)):
 * log2 m = 2/ln 2 (s + s^3/3 + s^5/5 ...), s = (m - 1)/(m + 1).  Error below 3 ulp of the result.
 */
LX_LANE NAME(lanes) NAME(log2_of)(NAME(lanes) w, NAME(lanes) c)
{
    NAME(lanes) exponent, m = NAME(split)(NAME(greater)(w, NAME(all)((REAL)SMALLEST)), &exponent);
    NAME(lanes) s = (m - 1) * NAME(inverse)(m + 1), s2 = s * s;
    NAME(lanes) series = NAME(all)((REAL)1 / (2 * LOG_TERMS - 1));
    for (int k = LOG_TERMS - 2; k >= 0; k--)
        series = series * s2 + (REAL)1 / (REAL)(2 * k + 1);
    return exponent + ((REAL)2.8853900817779268 * s * series + (REAL)1.4426950408889634 * c);
}

/* 2^y for y <= 0, about 0 below the normal numbers; error below 2 ulp. */
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

/*
 * cosine^exponent with t = 1 - cosine, 0 for cosines below 0.  A whole exponent by squaring: while it is large by
 * squaring the complements, 1 - (1 - t)^2 = t (2 - t), which keeps the digits of a small t; at last the powers
 * themselves, which keeps those of a small power.  Others by the logarithm.  Errors, t's own aside: below 6 ulp of
 * 1, by the logarithm 2.  In float64 what has become less than a half is squared itself from there on, so that a
 * power p of any size is good to some ulp of p ln p: there are pictures that show only the faint foot of a highlight.
 */
LX_LANE NAME(lanes) NAME(power_of)(NAME(lanes) t, NAME(lanes) cosine, struct NAME(lx_exponent) exponent)
{
    enum { LEAST_BY_COMPLEMENTS = 12 };
    const NAME(lanes) zero = NAME(all)(0), half = NAME(all)((REAL)0.5);
    t = NAME(lesser)(t, NAME(all)(1));
    NAME(lanes) base = 1 - t;
    if (!LX_IS_SINGLE)
        base = NAME(where_above)(t, half, NAME(greater)(cosine, zero), base);
    if (exponent.whole > 0) {
        unsigned bits = exponent.whole;
        NAME(lanes) power = NAME(all)(1);
        for (; bits >= LEAST_BY_COMPLEMENTS; bits >>= 1) {
            if (bits & 1)
                power = LX_IS_SINGLE ? power - power * t : power * base;
            t = t * (2 - t);
            base = LX_IS_SINGLE ? 1 - t : NAME(where_above)(t, half, base * base, 1 - t);
        }
        for (; !(bits & 1); bits >>= 1)
            base *= base;
        power *= base;
        while (bits >>= 1) {
            base *= base;
            if (bits & 1)
                power *= base;
        }
        return power;
    }
    NAME(lanes) rest = (1 - base) - t; /* what base has lost of 1 - t */
    if (!LX_IS_SINGLE)
        rest = NAME(where_above)(t, half, zero, rest);
    NAME(lanes) power = NAME(exp2_of)(exponent.value * NAME(log2_of)(base, rest));
    return NAME(where_above)(base, zero, power, zero);
}

/* Half the squared length of a vector. */
LX_LANE NAME(lanes) NAME(half_square)(NAME(lanes) x, NAME(lanes) y, NAME(lanes) z)
{
    return (REAL)0.5 * (x * x + y * y + z * z);
}

/* The angle, up to pi/2, of which t is the tangent of the half: the argument is halved twice more.  Within 4 ulp. */
LX_LANE NAME(lanes) NAME(angle_of_half_tangent)(NAME(lanes) t)
{
    for (int i = 0; i < 2; i++)
        t = t / (1 + NAME(root)(1 + t * t));
    NAME(lanes) t2 = t * t, series = NAME(all)(0);
    for (int k = 9; k >= 0; k--)
        series = (REAL)1 / (REAL)(2 * k + 1) - t2 * series;
    return 8 * t * series;
}

/* L and E_perp of a point without its profile. */
LX_LANE struct NAME(ray)
    NAME(towards)(const struct NAME(lx_light) * light, const struct NAME(elements) * at, enum lx_attenuation law)
{
    NAME(lanes) x = light->x - at->px, y = light->y - at->py, z = light->z - at->pz;
    NAME(lanes) r2 = x * x + y * y + z * z, limited;
    if (LX_IS_SINGLE) { /* sources that stand very near are never left to float32 */
        limited = NAME(inverse_root)(r2);
        x *= limited, y *= limited, z *= limited;
    } else {
        /* A source on the element itself counts as standing just above it. */
        const REAL nearest = (REAL)1e-6; /* mm */
        NAME(lanes) zero = NAME(all)(0), lift = NAME(where_above)(r2, zero, zero, NAME(all)(nearest));
        x += lift * at->nx, y += lift * at->ny, z += lift * at->nz;
        r2 = NAME(where_above)(r2, zero, r2, NAME(all)(nearest * nearest));
        NAME(lanes) inverse = NAME(inverse_root)(r2);
        x *= inverse, y *= inverse, z *= inverse;
        limited = NAME(lesser)(inverse, NAME(all)(1 / nearest));
    }
    NAME(lanes) e = NAME(all)(light->gain);
    if (law == LX_INVERSE_SQUARE)
        e *= limited * limited;
    else if (law == LX_PRACTICAL)
        e *= NAME(inverse)(light->k + NAME(root)(r2));
    return (struct NAME(ray)){x, y, z, e};
}

LX_LANE NAME(lanes) NAME(cone)(const struct NAME(lx_light) * light, NAME(lanes) versine)
{
    const NAME(lanes) zero = NAME(all)(0), one = NAME(all)(1);
    NAME(lanes) measure = versine;
    if (light->falloff == LX_HARD)
        return NAME(where_above)(versine, NAME(all)(light->edge), zero, one);
    if (light->falloff == LX_LINEAR) /* tan^2 of half the angle */
        measure = NAME(angle_of_half_tangent)(NAME(root)(versine / (2 - NAME(lesser)(versine, one))));
    NAME(lanes) t = NAME(lesser)(NAME(greater)((light->edge - measure) * light->edge_slope, zero), one);
    NAME(lanes) g = light->falloff == LX_SMOOTHSTEP ? t * t * (3 - 2 * t) : light->falloff == LX_SQUARED ? t * t : t;
    return NAME(where_above)(one, versine, g, zero); /* cones end at 90 degrees */
}

/* g of the direction from the light, -L. */
LX_LANE NAME(lanes) NAME(profile)(const struct NAME(lx_light) * light, const struct NAME(ray) * ray)
{
    NAME(lanes) versine = NAME(half_square)(light->axis_x + ray->x, light->axis_y + ray->y, light->axis_z + ray->z);
    NAME(lanes) g = NAME(all)(1);
    if (light->falloff != LX_NO_CONE)
        g = NAME(cone)(light, versine);
    if (light->exponent.value > 0) {
        NAME(lanes) cosine = -(light->axis_x * ray->x + light->axis_y * ray->y + light->axis_z * ray->z);
        g *= NAME(power_of)(versine, cosine, light->exponent);
    }
    return g;
}

LX_LANE struct NAME(ray)
    NAME(ray_of)(const struct NAME(lx_light) * light, const struct NAME(elements) * at, enum lx_light_kind kind)
{
    struct NAME(ray) ray;
    if (kind == LX_DISTANT)
        return (struct NAME(ray)){NAME(all)(light->x), NAME(all)(light->y), NAME(all)(light->z),
                                  NAME(all)(light->gain)};
    if (kind == LX_BY_SQUARE || (kind == LX_PROFILED && light->law == LX_INVERSE_SQUARE))
        ray = NAME(towards)(light, at, LX_INVERSE_SQUARE);
    else if (kind == LX_BY_SUM || (kind == LX_PROFILED && light->law == LX_PRACTICAL))
        ray = NAME(towards)(light, at, LX_PRACTICAL);
    else
        ray = NAME(towards)(light, at, LX_NO_ATTENUATION);
    if (kind == LX_PROFILED)
        ray.e *= NAME(profile)(light, &ray);
    return ray;
}

/* What the lobe makes of light from L, for each unit of E_perp. */
LX_LANE NAME(lanes)
    NAME(weight_of)(const struct NAME(lx_lobe) * lobe, const struct NAME(elements) * at, enum lx_model model,
                    enum lx_highlight highlight, NAME(lanes) lx, NAME(lanes) ly, NAME(lanes) lz)
{
    const NAME(lanes) zero = NAME(all)(0);
    NAME(lanes) n_dot_l = at->nx * lx + at->ny * ly + at->nz * lz, front = NAME(greater)(n_dot_l, zero);
    NAME(lanes) weight = lobe->diffuse * front;
    if (model == LX_LAMBERT)
        return weight;
    NAME(lanes) x = lx + at->vx, y = ly + at->vy, z = lz + at->vz, t, cosine;
    if (model == LX_BLINN_PHONG) { /* from N to the unit vector along L + V */
        NAME(lanes) square = x * x + y * y + z * z, inverse = NAME(inverse_root)(square);
        t = NAME(half_square)(at->nx - x * inverse, at->ny - y * inverse, at->nz - z * inverse);
        cosine = (at->nx * x + at->ny * y + at->nz * z) * inverse;
        if (!LX_IS_SINGLE) { /* L = -V, but for rounding, has no half vector; float32 never comes near that */
            const NAME(lanes) rounding = NAME(all)((REAL)0x1p-98);
            t = NAME(where_above)(square, rounding, t, NAME(all)(1));
            cosine = NAME(where_above)(square, rounding, cosine, zero);
        }
    } else { /* from the mirrored L, 2 (N.L) N - L, to V */
        NAME(lanes) twice = 2 * n_dot_l;
        t = NAME(half_square)(x - twice * at->nx, y - twice * at->ny, z - twice * at->nz);
        cosine = (twice * at->nx - lx) * at->vx + (twice * at->ny - ly) * at->vy + (twice * at->nz - lz) * at->vz;
    }
    NAME(lanes) shine = lobe->specular * NAME(power_of)(t, cosine, lobe->exponent);
    if (highlight == LX_HIGHLIGHT_COSINE)
        shine *= front;
    if (highlight == LX_HIGHLIGHT_GATED)
        shine = NAME(where_above)(n_dot_l, zero, shine, zero);
    return weight + shine;
}

LX_LANE struct NAME(elements) NAME(elements_at)(const struct NAME(lx_block) * block, size_t i)
{
    return (struct NAME(elements)){NAME(load)(block->px + i), NAME(load)(block->py + i), NAME(load)(block->pz + i),
                                   NAME(load)(block->nx + i), NAME(load)(block->ny + i), NAME(load)(block->nz + i),
                                   NAME(load)(block->vx + i), NAME(load)(block->vy + i), NAME(load)(block->vz + i)};
}

/* The brightness of a vector of elements by a light whose rays are known. */
LX_LANE NAME(lanes) NAME(reflected)(const struct NAME(lx_lobe) * lobe, const struct NAME(elements) * at,
                                    const struct NAME(ray) * ray, enum lx_model model, enum lx_highlight highlight)
{
    return ray->e * NAME(weight_of)(lobe, at, model, highlight, ray->x, ray->y, ray->z);
}

/*
 * Adds the brightness by all the lights, which are of one kind.  Two vectors at once, their rays first, keep the
 * machine busy where one would wait for its own results.
 */
LX_LANE void NAME(reflect)(const struct NAME(lx_light) * lights, size_t light_count, const struct NAME(lx_lobe) * lobe,
                           const struct NAME(lx_block) * block, const float *open, size_t count,
                           enum lx_light_kind kind, enum lx_model model, enum lx_highlight highlight,
                           double *restrict sum)
{
    const struct NAME(lx_lobe) constants = *lobe;
    const size_t width = NAME(LX_WIDTH);
    _Alignas(LX_VECTOR_BYTES) REAL totals[LX_BLOCK];
    size_t i = 0;
    for (; i + 2 * width <= count; i += 2 * width) {
        const struct NAME(elements) at = NAME(elements_at)(block, i), next = NAME(elements_at)(block, i + width);
        NAME(lanes) total = NAME(all)(0), total_of_next = total;
        for (size_t k = 0; k < light_count; k++) {
            struct NAME(ray) ray = NAME(ray_of)(&lights[k], &at, kind);
            struct NAME(ray) ray_to_next = NAME(ray_of)(&lights[k], &next, kind);
            total += NAME(reflected)(&constants, &at, &ray, model, highlight);
            total_of_next += NAME(reflected)(&constants, &next, &ray_to_next, model, highlight);
        }
        NAME(store)(totals + i, total);
        NAME(store)(totals + i + width, total_of_next);
    }
    if (i < count) { /* one vector more */
        const struct NAME(elements) at = NAME(elements_at)(block, i);
        NAME(lanes) total = NAME(all)(0);
        for (size_t k = 0; k < light_count; k++) {
            struct NAME(ray) ray = NAME(ray_of)(&lights[k], &at, kind);
            total += NAME(reflected)(&constants, &at, &ray, model, highlight);
        }
        NAME(store)(totals + i, total);
    }
    for (i = 0; open && i < count; i++)
        totals[i] *= (REAL)open[i];
    for (i = 0; i < count; i++)
        sum[i] += (double)totals[i];
}

LX_LANE void NAME(by_lobe)(const struct NAME(lx_light) * lights, size_t light_count, const struct NAME(lx_lobe) * lobe,
                           const struct NAME(lx_block) * block, const float *open, size_t count,
                           enum lx_light_kind kind, double *sum)
{
    if (lobe->model == LX_LAMBERT)
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_LAMBERT, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_BLINN_PHONG, LX_HIGHLIGHT_GATED, sum);
    else if (lobe->model == LX_BLINN_PHONG)
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_PHONG, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_PHONG, LX_HIGHLIGHT_GATED, sum);
    else
        NAME(reflect)(lights, light_count, lobe, block, open, count, kind, LX_PHONG, LX_HIGHLIGHT_COSINE, sum);
}

static void NAME(shade)(const struct NAME(lx_light) * lights, size_t light_count, const struct NAME(lx_lobe) * lobe,
                        const struct NAME(lx_block) * block, const float *open, size_t count, double *sum)
{
    count = lx_padded(count);
    switch (lights->kind) {
    case LX_DISTANT: NAME(by_lobe)(lights, light_count, lobe, block, open, count, LX_DISTANT, sum); break;
    case LX_BY_SQUARE: NAME(by_lobe)(lights, light_count, lobe, block, open, count, LX_BY_SQUARE, sum); break;
    case LX_BY_SUM: NAME(by_lobe)(lights, light_count, lobe, block, open, count, LX_BY_SUM, sum); break;
    case LX_UNATTENUATED: NAME(by_lobe)(lights, light_count, lobe, block, open, count, LX_UNATTENUATED, sum); break;
    case LX_PROFILED: NAME(by_lobe)(lights, light_count, lobe, block, open, count, LX_PROFILED, sum); break;
    }
}
