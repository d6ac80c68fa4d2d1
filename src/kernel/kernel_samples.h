/* SPDX-License-Identifier: MIT */
/*
 * Samples of extended sources on a few elements, in one precision.  Included by kernel.c behind each kernel_real.h,
 * whose names and formulas it uses.
 */

/* What samples on round sources need of a vector of elements: a frame for each, and T and d - R. */
struct NAME(poles) {
    NAME(lanes) nx, ny, nz; /* direction to the element; of a side across its axis */
    NAME(lanes) ax, ay, az, bx, by, bz;
    NAME(lanes) tangent, above;
};

/* E_perp of a sample whose plane the element is `above`, told 1/r and r. */
LX_LANE NAME(lanes) NAME(sample_strength)(const struct NAME(lx_samples) * samples, enum lx_attenuation law,
                                          NAME(lanes) above, NAME(lanes) inverse, NAME(lanes) distance)
{
    NAME(lanes) cosine = NAME(greater)(above, NAME(all)(0)) * inverse;
    if (law == LX_POLYNOMIAL)
        return cosine * NAME(by_polynomial)(samples->by_none, samples->by_root, samples->by_square, distance);
    return law == LX_INVERSE_SQUARE ? cosine * inverse * inverse
           : law == LX_PRACTICAL    ? cosine * NAME(inverse)(samples->k + distance)
                                    : cosine;
}

/* The frames of a ball, whose pole is the way to the element and whose first axis is near to a. */
LX_LANE struct NAME(poles)
    NAME(find_poles)(const struct NAME(lx_samples) * samples, const struct NAME(elements) * at, enum lx_bend bend)
{
    const bool is_side = bend == LX_SIDE;
    const NAME(lanes) zero = NAME(all)(0), tiny = NAME(all)((REAL)1e-30);
    const REAL mx = samples->nx, my = samples->ny, mz = samples->nz;
    const REAL sx = samples->ax, sy = samples->ay, sz = samples->az;
    NAME(lanes) x = at->px - samples->ox, y = at->py - samples->oy, z = at->pz - samples->oz;
    NAME(lanes) along = is_side ? x * mx + y * my + z * mz : zero;
    x -= along * mx, y -= along * my, z -= along * mz;
    NAME(lanes) square = x * x + y * y + z * z;
    NAME(lanes) inverse = NAME(inverse_root)(NAME(greater)(square, tiny)), distance = square * inverse;
    NAME(lanes) above = distance - samples->radius;
    x *= inverse, y *= inverse, z *= inverse;
    /* a: of a ball the given one, made perpendicular; of a side its axis */
    NAME(lanes) slant = is_side ? zero : x * sx + y * sy + z * sz;
    NAME(lanes) ax = (is_side ? mx : sx) - slant * x, ay = (is_side ? my : sy) - slant * y;
    NAME(lanes) az = (is_side ? mz : sz) - slant * z;
    NAME(lanes) length2 = ax * ax + ay * ay + az * az;
    NAME(lanes) scale = NAME(inverse_root)(NAME(greater)(length2, tiny));
    ax *= scale, ay *= scale, az *= scale;
    above = NAME(where_above)(above, NAME(all)(samples->touch), above, zero);
    return (struct NAME(poles)){
        .nx = x,
        .ny = y,
        .nz = z,
        .ax = ax,
        .ay = ay,
        .az = az,
        .bx = y * az - z * ay,
        .by = z * ax - x * az,
        .bz = x * ay - y * ax,
        .above = above,
        .tangent = NAME(root)(above / (distance + samples->radius)),
    };
}

/* What all samples give to one vector of elements. */
LX_LANE NAME(lanes) NAME(sum_samples)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                                      const struct NAME(lx_lobe) * lobe, const struct NAME(elements) * at,
                                      enum lx_bend bend, enum lx_model model, enum lx_highlight highlight)
{
    const enum lx_attenuation law = samples->law;
    const REAL ox = samples->ox, oy = samples->oy, oz = samples->oz, radius = samples->radius;
    const REAL mx = samples->nx, my = samples->ny, mz = samples->nz;
    const bool is_side = bend == LX_SIDE;
    NAME(lanes) total = NAME(all)(0);
    struct NAME(poles) poles;
    if (bend != LX_FLAT)
        poles = NAME(find_poles)(samples, at, bend);
    for (size_t s = first; s < first + count; s++) {
        const REAL u = samples->x[s], v = samples->y[s], w = samples->z[s];
        NAME(lanes) x, y, z, above, area = NAME(all)(samples->gain[s]);
        if (bend == LX_FLAT) {
            x = u - at->px, y = v - at->py, z = w - at->pz;
            above = mx * at->px + my * at->py + mz * at->pz - samples->height;
        } else {
            REAL share = is_side ? v : u, along_m = is_side ? u : 0;
            NAME(lanes) t = share * poles.tangent, t2 = t * t, inverse = NAME(inverse)(1 + t2);
            NAME(lanes) cosine = (1 - t2) * inverse, sine = 2 * t * inverse, slope = 2 * poles.tangent * inverse;
            NAME(lanes) along_a = is_side ? NAME(all)(0) : v * sine, along_b = is_side ? sine : w * sine;
            x = ox - at->px + along_m * mx + radius * (cosine * poles.nx + along_a * poles.ax + along_b * poles.bx);
            y = oy - at->py + along_m * my + radius * (cosine * poles.ny + along_a * poles.ay + along_b * poles.by);
            z = oz - at->pz + along_m * mz + radius * (cosine * poles.nz + along_a * poles.az + along_b * poles.bz);
            above = poles.above * (1 - share * share) * inverse;
            area *= is_side ? radius * slope : radius * radius * slope * sine;
        }
        NAME(lanes) r2 = NAME(greater)(x * x + y * y + z * z, NAME(all)((REAL)1e-30));
        NAME(lanes) inverse = NAME(inverse_root)(r2);
        NAME(lanes) e = NAME(sample_strength)(samples, law, above, inverse, r2 * inverse);
        const struct NAME(ray) ray = {.x = x, .y = y, .z = z, .inverse = inverse};
        NAME(lanes) height = NAME(n_dot)(at, &ray), diffuse, specular = NAME(all)(0);
        NAME(reflect)(lobe->exponent, at, &ray, &height, 1, model, highlight, &diffuse, &specular);
        specular = NAME(greater)(specular, NAME(all)(0)); /* as in NAME(sum_lights) */
        total += area * e * (lobe->diffuse * diffuse + lobe->specular * specular);
    }
    return total;
}

LX_LANE void NAME(add_samples)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                               const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block, size_t start,
                               enum lx_bend bend, enum lx_model model, enum lx_highlight highlight, REAL *sum)
{
    const struct NAME(lx_lobe) constants = *lobe;
    for (size_t i = 0; i < LX_LANES; i += NAME(LX_WIDTH)) {
        const struct NAME(elements) at = NAME(elements_at)(block, NULL, start + i);
        NAME(lanes) total = NAME(sum_samples)(samples, first, count, &constants, &at, bend, model, highlight);
        memcpy(sum + i, &total, sizeof total);
    }
}

LX_LANE void NAME(samples_of)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                              const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block, size_t start,
                              enum lx_model model, enum lx_highlight highlight, REAL *sum)
{
    if (samples->bend == LX_FLAT)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_FLAT, model, highlight, sum);
    else if (samples->bend == LX_BALL_SHAPED)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_BALL_SHAPED, model, highlight, sum);
    else
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_SIDE, model, highlight, sum);
}

static void NAME(samples)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                          const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block, size_t start,
                          REAL *sum)
{
#ifdef LX_FEW_KERNELS
    const enum lx_highlight highlight = LX_KERNEL_WEIGHT(lobe->model, lobe->highlight);
    NAME(samples_of)(samples, first, count, lobe, block, start, lobe->model, highlight, sum);
#else
#define LX_SUM_SAMPLES(one, weight, when)                                                                              \
    if (when)                                                                                                          \
        NAME(samples_of)(samples, first, count, lobe, block, start, one, weight, sum);                                 \
    else
    LX_KERNEL_LOBES(LX_SUM_SAMPLES, lobe->model, lobe->highlight)
    return;
#undef LX_SUM_SAMPLES
#endif
}
