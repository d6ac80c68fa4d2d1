/* SPDX-License-Identifier: MIT */
/*
 * Samples of extended sources on a few elements, in one precision.  Included by kernel.c behind each kernel_real.h,
 * whose names and formulas it uses.
 */

/* E_perp of a sample whose plane the element is `above`, told 1/r and r. */
static inline __attribute__((always_inline)) REAL NAME(sample_strength)(enum lx_attenuation law, REAL k, REAL above,
                                                                        REAL inverse, REAL distance)
{
    REAL cosine = (above > 0 ? above : 0) * inverse;
    return cosine * (law == LX_INVERSE_SQUARE ? inverse * inverse : law == LX_PRACTICAL ? 1 / (k + distance) : 1);
}

static inline __attribute__((always_inline)) void
NAME(add_samples)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                  const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block, size_t start,
                  enum lx_model model, enum lx_highlight highlight, REAL *restrict sum)
{
    const struct NAME(lx_lobe) constants = *lobe;
    const enum lx_attenuation law = samples->law;
    REAL total[LX_LANES] = {0};
    for (size_t s = first; s < first + count; s++) {
        const REAL sx = samples->x[s], sy = samples->y[s], sz = samples->z[s], gain = samples->gain[s];
        const REAL ax = samples->nx[s], ay = samples->ny[s], az = samples->nz[s], height = samples->height[s];
        for (size_t lane = 0; lane < LX_LANES; lane++) {
            size_t i = start + lane;
            REAL px = block->px[i], py = block->py[i], pz = block->pz[i];
            REAL x = sx - px, y = sy - py, z = sz - pz;
            REAL r2 = x * x + y * y + z * z;
            r2 = r2 > (REAL)1e-30 ? r2 : (REAL)1e-30;
            REAL inverse = 1 / SQRT(r2);
            REAL e = NAME(sample_strength)(law, samples->k, ax * px + ay * py + az * pz - height, inverse,
                                           r2 * inverse);
            total[lane] += gain * e *
                           NAME(weight_of)(&constants, block, i, model, highlight, x * inverse, y * inverse,
                                           z * inverse);
        }
    }
    for (size_t lane = 0; lane < LX_LANES; lane++)
        sum[lane] = total[lane];
}

static void NAME(samples)(const struct NAME(lx_samples) * samples, size_t first, size_t count,
                          const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block, size_t start,
                          REAL *sum)
{
    if (lobe->model == LX_LAMBERT)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_LAMBERT, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_BLINN_PHONG, LX_HIGHLIGHT_GATED, sum);
    else if (lobe->model == LX_BLINN_PHONG)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_PHONG, LX_HIGHLIGHT_PLAIN, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_PHONG, LX_HIGHLIGHT_GATED, sum);
    else
        NAME(add_samples)(samples, first, count, lobe, block, start, LX_PHONG, LX_HIGHLIGHT_COSINE, sum);
}
