/* SPDX-License-Identifier: MIT */
/*
 * Samples of extended sources on a few elements, in one precision.  Included by kernel.c behind each kernel_real.h,
 * whose names and formulas it uses.
 */
#define SAMPLE_LANE static inline __attribute__((always_inline))

/* What samples on round sources need of each element. */
struct NAME(poles) {
    REAL nx[LX_LANES], ny[LX_LANES], nz[LX_LANES]; /* direction to the element; of a side across its axis */
    REAL ax[LX_LANES], ay[LX_LANES], az[LX_LANES];
    REAL bx[LX_LANES], by[LX_LANES], bz[LX_LANES];
    REAL tangent[LX_LANES], above[LX_LANES]; /* T and d - R */
};

/* E_perp of a sample whose plane the element is `above`, told 1/r and r. */
SAMPLE_LANE REAL NAME(sample_strength)(enum lx_attenuation law, REAL k, REAL above, REAL inverse, REAL distance)
{
    REAL cosine = (above > 0 ? above : 0) * inverse;
    return cosine * (law == LX_INVERSE_SQUARE ? inverse * inverse : law == LX_PRACTICAL ? 1 / (k + distance) : 1);
}

/* The frames of a ball, whose pole is the way to the element and whose first axis is near to a. */
static void NAME(find_poles)(const struct NAME(lx_samples) * samples, const struct NAME(lx_block) * block, size_t start,
                             struct NAME(poles) * poles)
{
    const bool is_side = samples->bend == LX_SIDE;
    const REAL radius = samples->radius, tiny = (REAL)1e-30;
    const REAL ox = samples->ox, oy = samples->oy, oz = samples->oz, mx = samples->nx, my = samples->ny,
               mz = samples->nz, sx = samples->ax, sy = samples->ay, sz = samples->az;
    for (size_t lane = 0; lane < LX_LANES; lane++) {
        REAL x = block->px[start + lane] - ox, y = block->py[start + lane] - oy, z = block->pz[start + lane] - oz;
        REAL along = is_side ? x * mx + y * my + z * mz : 0;
        x -= along * mx, y -= along * my, z -= along * mz;
        REAL square = x * x + y * y + z * z;
        REAL inverse = 1 / SQRT(square > tiny ? square : tiny), distance = square * inverse;
        REAL above = distance - radius;
        x *= inverse, y *= inverse, z *= inverse;
        /* a: of a ball the given one, made perpendicular; of a side its axis */
        REAL slant = is_side ? 0 : x * sx + y * sy + z * sz;
        REAL ax = (is_side ? mx : sx) - slant * x, ay = (is_side ? my : sy) - slant * y;
        REAL az = (is_side ? mz : sz) - slant * z;
        REAL length2 = ax * ax + ay * ay + az * az;
        REAL scale = 1 / SQRT(length2 > tiny ? length2 : tiny);
        ax *= scale, ay *= scale, az *= scale;
        above = above > samples->touch ? above : 0;
        poles->nx[lane] = x, poles->ny[lane] = y, poles->nz[lane] = z;
        poles->ax[lane] = ax, poles->ay[lane] = ay, poles->az[lane] = az;
        poles->bx[lane] = y * az - z * ay, poles->by[lane] = z * ax - x * az, poles->bz[lane] = x * ay - y * ax;
        poles->above[lane] = above;
        poles->tangent[lane] = SQRT(above / (distance + radius));
    }
}

SAMPLE_LANE void NAME(add_samples)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                                   const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block, size_t start,
                                   enum lx_bend bend, enum lx_model model, enum lx_highlight highlight,
                                   REAL *restrict sum)
{
    const struct NAME(lx_lobe) constants = *lobe;
    const enum lx_attenuation law = samples->law;
    const REAL ox = samples->ox, oy = samples->oy, oz = samples->oz, radius = samples->radius, k = samples->k;
    const REAL mx = samples->nx, my = samples->ny, mz = samples->nz, height = samples->height;
    REAL total[LX_LANES] = {0};
    struct NAME(poles) poles;
    if (bend != LX_FLAT)
        NAME(find_poles)(samples, block, start, &poles);
    for (size_t s = first; s < first + count; s++) {
        const REAL u = samples->x[s], v = samples->y[s], w = samples->z[s], gain = samples->gain[s];
        for (size_t lane = 0; lane < LX_LANES; lane++) {
            size_t i = start + lane;
            REAL px = block->px[i], py = block->py[i], pz = block->pz[i], x, y, z, above, area = gain;
            if (bend == LX_FLAT) {
                x = u - px, y = v - py, z = w - pz;
                above = mx * px + my * py + mz * pz - height;
            } else {
                bool is_side = bend == LX_SIDE;
                REAL share = is_side ? v : u, t = share * poles.tangent[lane], t2 = t * t, inverse = 1 / (1 + t2);
                REAL cosine = (1 - t2) * inverse, sine = 2 * t * inverse, slope = 2 * poles.tangent[lane] * inverse;
                REAL along_a = is_side ? 0 : v * sine, along_b = is_side ? sine : w * sine, along_m = is_side ? u : 0;
                x = ox - px + along_m * mx +
                    radius * (cosine * poles.nx[lane] + along_a * poles.ax[lane] + along_b * poles.bx[lane]);
                y = oy - py + along_m * my +
                    radius * (cosine * poles.ny[lane] + along_a * poles.ay[lane] + along_b * poles.by[lane]);
                z = oz - pz + along_m * mz +
                    radius * (cosine * poles.nz[lane] + along_a * poles.az[lane] + along_b * poles.bz[lane]);
                above = poles.above[lane] * (1 - share * share) * inverse;
                area *= is_side ? radius * slope : radius * radius * slope * sine;
            }
            REAL r2 = x * x + y * y + z * z;
            r2 = r2 > (REAL)1e-30 ? r2 : (REAL)1e-30;
            REAL inverse = 1 / SQRT(r2);
            REAL e = NAME(sample_strength)(law, k, above, inverse, r2 * inverse);
            total[lane] +=
                area * e *
                NAME(weight_of)(&constants, block, i, model, highlight, x * inverse, y * inverse, z * inverse);
        }
    }
    for (size_t lane = 0; lane < LX_LANES; lane++)
        sum[lane] = total[lane];
}

SAMPLE_LANE void NAME(samples_of)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
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
    if (lobe->model == LX_LAMBERT)
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_LAMBERT, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_BLINN_PHONG, LX_HIGHLIGHT_GATED, sum);
    else if (lobe->model == LX_BLINN_PHONG)
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_PHONG, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_PHONG, LX_HIGHLIGHT_GATED, sum);
    else
        NAME(samples_of)(samples, first, count, lobe, block, start, LX_PHONG, LX_HIGHLIGHT_COSINE, sum);
}
#undef SAMPLE_LANE
