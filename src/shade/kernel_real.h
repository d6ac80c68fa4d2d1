/* SPDX-License-Identifier: MIT */
/*
 * The shading kernel in one precision, written as plain loops over arrays that the compiler turns into vector
 * code.  kernel.c includes it twice, with
 *
 *     REAL      float or double
 *     NAME(x)   x with the precision's suffix
 *     BITS      an unsigned integer of the same size
 *     MANTISSA  number of bits of the fraction, BIAS of the exponent, MAGIC = 1.5 * 2^MANTISSA
 *     LOG_TERMS, EXP_TERMS   terms of the series
 *
 * A light passes over a block in three loops: towards (L and E_perp), profile, reflect.  What varies between
 * lights and materials is a constant parameter of an inlined loop, so that no loop tests it.
 */

typedef union {
    REAL real;
    BITS bits;
} NAME(pun);

/* The intermediate results of one light. */
struct NAME(rays) {
    REAL lx[LX_BLOCK], ly[LX_BLOCK], lz[LX_BLOCK], e[LX_BLOCK];
};

/*
 * log2(w) of a squared cosine w = 1 - q, given both: near 1 the logarithm comes from q, which keeps the digits
 * that w has lost.  With w = 2^e m, m within [sqrt(1/2), sqrt(2)): log2 m = 2/ln 2 (s + s^3/3 + s^5/5 ...),
 * s = (m - 1)/(m + 1).  Error below 3 ulp of the result, plus what q brings.
 */
static inline REAL NAME(log2_of)(REAL w, REAL q)
{
    const REAL smallest = (REAL)SMALLEST;
    NAME(pun) v = {.real = w > smallest ? w : smallest};
    NAME(pun) root = {.real = (REAL)0.70710678118654752};
    BITS biased = (v.bits - root.bits + ((BITS)BIAS << MANTISSA)) >> MANTISSA;
    NAME(pun) m = {.bits = v.bits - ((biased - BIAS) << MANTISSA)};
    NAME(pun) whole = {.real = MAGIC}; /* counts in its last bits: a conversion that every set has */
    whole.bits += biased;
    REAL exponent = whole.real - (MAGIC + BIAS);
    REAL above = q < (REAL)0.25 ? -q : m.real - 1;
    REAL s = above / (m.real + 1);
    REAL s2 = s * s;
    REAL series = (REAL)1 / (2 * LOG_TERMS - 1);
    for (int k = LOG_TERMS - 2; k >= 0; k--)
        series = series * s2 + (REAL)1 / (REAL)(2 * k + 1);
    return exponent + (REAL)2.8853900817779268 * s * series;
}

/* 2^y for y <= 0, 0 below the normal numbers; error below 2 ulp. */
static inline REAL NAME(exp2_of)(REAL y)
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
    const REAL lowest = (REAL)(1 - BIAS);
    REAL limited = y > lowest ? y : lowest;
    NAME(pun) whole = {.real = limited + MAGIC};
    REAL fraction = limited - (whole.real - MAGIC);
    REAL series = coefficients[EXP_TERMS - 1];
    for (int k = EXP_TERMS - 2; k >= 0; k--)
        series = series * fraction + coefficients[k];
    NAME(pun) magic = {.real = MAGIC};
    NAME(pun) scale = {.bits = (BITS)(whole.bits - magic.bits + BIAS) << MANTISSA};
    return y > lowest ? series * scale.real : 0;
}

/* cosine^(2 half_exponent) of an angle by its cosine and squared sine; 0 where the cosine is not positive */
static inline REAL NAME(cosine_power)(REAL cosine, REAL cosine_squared, REAL sine_squared, REAL half_exponent)
{
    REAL power = NAME(exp2_of)(half_exponent * NAME(log2_of)(cosine_squared, sine_squared));
    return cosine > 0 ? power : 0;
}

/* The angle, up to pi/2, of which t is the tangent of the half: the argument is halved twice more. */
static inline REAL NAME(angle_of_half_tangent)(REAL t)
{
    for (int i = 0; i < 2; i++)
        t = t / (1 + SQRT(1 + t * t));
    REAL t2 = t * t, series = 0;
    for (int k = 9; k >= 0; k--)
        series = (REAL)1 / (REAL)(2 * k + 1) - t2 * series;
    return 8 * t * series;
}

/* L and E_perp of a point without its profile */
static inline __attribute__((always_inline)) void NAME(towards)(const struct NAME(lx_light) * light,
                                                                const struct NAME(lx_block) * block, size_t count,
                                                                enum lx_attenuation law, struct NAME(rays) * rays)
{
    const REAL nearest = (REAL)1e-6; /* mm */
    for (size_t i = 0; i < count; i++) {
        REAL x = light->x - block->px[i], y = light->y - block->py[i], z = light->z - block->pz[i];
        REAL r2 = x * x + y * y + z * z;
        if (sizeof(REAL) == sizeof(double)) { /* sources that near are never left to float32 */
            /* A source on the element itself counts as standing just above it. */
            REAL lift = r2 > 0 ? 0 : nearest;
            x += lift * block->nx[i];
            y += lift * block->ny[i];
            z += lift * block->nz[i];
            r2 = r2 > 0 ? r2 : nearest * nearest;
        }
        REAL inverse = 1 / SQRT(r2);
        rays->lx[i] = x * inverse;
        rays->ly[i] = y * inverse;
        rays->lz[i] = z * inverse;
        REAL limited = inverse < 1 / nearest ? inverse : 1 / nearest;
        REAL distance = r2 * inverse;
        rays->e[i] = light->gain * (law == LX_INVERSE_SQUARE ? limited * limited
                                    : law == LX_PRACTICAL    ? 1 / (light->k + distance)
                                                             : 1);
    }
}

static void NAME(same_direction)(const struct NAME(lx_light) * light, size_t count, struct NAME(rays) * rays)
{
    for (size_t i = 0; i < count; i++) {
        rays->lx[i] = light->x;
        rays->ly[i] = light->y;
        rays->lz[i] = light->z;
        rays->e[i] = light->gain;
    }
}

/* Multiplies E_perp by the cone of this falloff, or, for LX_NO_CONE, by the power of the cosine. */
static inline __attribute__((always_inline)) void NAME(profile)(const struct NAME(lx_light) * light, size_t count,
                                                                enum lx_falloff falloff, struct NAME(rays) * rays)
{
    for (size_t i = 0; i < count; i++) {
        REAL ax = light->axis_x, ay = light->axis_y, az = light->axis_z;
        REAL x = rays->lx[i], y = rays->ly[i], z = rays->lz[i];
        REAL cosine = -(ax * x + ay * y + az * z);
        REAL sx = ay * z - az * y, sy = az * x - ax * z, sz = ax * y - ay * x;
        REAL sine_squared = sx * sx + sy * sy + sz * sz;
        REAL g;
        if (falloff == LX_NO_CONE) {
            g = NAME(cosine_power)(cosine, cosine * cosine, sine_squared, light->half_exponent);
        } else {
            REAL below = cosine > 0 ? 1 + cosine : 1; /* cones end at 90 degrees */
            REAL versine = cosine > 0 ? sine_squared / below : 1 - cosine;
            REAL t = (light->edge - versine) * light->edge_slope;
            if (falloff == LX_LINEAR) {
                REAL angle = NAME(angle_of_half_tangent)(SQRT(sine_squared) / below);
                t = cosine > 0 ? (light->edge - angle) * light->edge_slope : 0;
            }
            t = t < 0 ? 0 : t;
            t = t > 1 ? 1 : t;
            g = falloff == LX_SMOOTHSTEP ? t * t * (3 - 2 * t)
                : falloff == LX_SQUARED  ? t * t
                : falloff == LX_LINEAR   ? t
                                         : (light->edge >= versine ? 1 : 0);
        }
        rays->e[i] *= g;
    }
}

/* What the lobe makes of light from L, for each unit of E_perp. */
static inline __attribute__((always_inline)) REAL NAME(weight_of)(const struct NAME(lx_lobe) * lobe,
                                                                  const struct NAME(lx_block) * block, size_t i,
                                                                  enum lx_model model, enum lx_highlight highlight,
                                                                  REAL lx, REAL ly, REAL lz)
{
    REAL nx = block->nx[i], ny = block->ny[i], nz = block->nz[i];
    REAL n_dot_l = nx * lx + ny * ly + nz * lz;
    REAL front = n_dot_l > 0 ? n_dot_l : 0;
    REAL weight = lobe->diffuse * front;
    if (model == LX_LAMBERT)
        return weight;
    /* the vectors whose angle makes the lobe, and the squared length of the second */
    REAL ax, ay, az, bx, by, bz, length_squared;
    REAL vx = block->vx[i], vy = block->vy[i], vz = block->vz[i];
    if (model == LX_BLINN_PHONG) {
        ax = nx, ay = ny, az = nz;
        bx = lx + vx, by = ly + vy, bz = lz + vz;
        REAL length = bx * bx + by * by + bz * bz;
        length_squared = length > (REAL)SMALLEST ? length : (REAL)SMALLEST;
    } else {
        ax = vx, ay = vy, az = vz;
        bx = 2 * n_dot_l * nx - lx, by = 2 * n_dot_l * ny - ly, bz = 2 * n_dot_l * nz - lz;
        length_squared = 1;
    }
    REAL cosine = ax * bx + ay * by + az * bz;
    REAL cx = ay * bz - az * by, cy = az * bx - ax * bz, cz = ax * by - ay * bx;
    REAL inverse = 1 / length_squared;
    REAL power = NAME(cosine_power)(cosine, cosine * cosine * inverse, (cx * cx + cy * cy + cz * cz) * inverse,
                                    lobe->half_exponent);
    REAL w = highlight == LX_HIGHLIGHT_PLAIN ? 1 : highlight == LX_HIGHLIGHT_GATED ? (n_dot_l > 0 ? 1 : 0) : front;
    return weight + lobe->specular * w * power;
}

/* Adds the brightness that the rays make by the lobe. */
static inline __attribute__((always_inline)) void NAME(reflect)(const struct NAME(lx_lobe) * lobe,
                                                                const struct NAME(lx_block) * block, size_t count,
                                                                enum lx_model model, enum lx_highlight highlight,
                                                                const struct NAME(rays) * rays, REAL *restrict sum)
{
    const struct NAME(lx_lobe) constants = *lobe;
    for (size_t i = 0; i < count; i++)
        sum[i] +=
            rays->e[i] * NAME(weight_of)(&constants, block, i, model, highlight, rays->lx[i], rays->ly[i], rays->lz[i]);
}

static void NAME(find_rays)(const struct NAME(lx_light) * light, const struct NAME(lx_block) * block, size_t count,
                            struct NAME(rays) * rays)
{
    if (!light->is_point)
        NAME(same_direction)(light, count, rays);
    else if (light->law == LX_INVERSE_SQUARE)
        NAME(towards)(light, block, count, LX_INVERSE_SQUARE, rays);
    else if (light->law == LX_PRACTICAL)
        NAME(towards)(light, block, count, LX_PRACTICAL, rays);
    else
        NAME(towards)(light, block, count, LX_NO_ATTENUATION, rays);
}

static void NAME(weigh_rays)(const struct NAME(lx_light) * light, size_t count, struct NAME(rays) * rays)
{
    if (light->falloff == LX_LINEAR)
        NAME(profile)(light, count, LX_LINEAR, rays);
    else if (light->falloff == LX_SMOOTHSTEP)
        NAME(profile)(light, count, LX_SMOOTHSTEP, rays);
    else if (light->falloff == LX_SQUARED)
        NAME(profile)(light, count, LX_SQUARED, rays);
    else if (light->falloff == LX_HARD)
        NAME(profile)(light, count, LX_HARD, rays);
    if (light->half_exponent > 0)
        NAME(profile)(light, count, LX_NO_CONE, rays);
}

static void NAME(shade)(const struct NAME(lx_light) * light, const struct NAME(lx_lobe) * lobe,
                        const struct NAME(lx_block) * block, const float *open, size_t count, REAL *sum)
{
    struct NAME(rays) rays;
    count = lx_padded(count);
    NAME(find_rays)(light, block, count, &rays);
    NAME(weigh_rays)(light, count, &rays);
    if (open)
        for (size_t i = 0; i < count; i++)
            rays.e[i] *= (REAL)open[i];

    if (lobe->model == LX_LAMBERT)
        NAME(reflect)(lobe, block, count, LX_LAMBERT, LX_HIGHLIGHT_PLAIN, &rays, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(reflect)(lobe, block, count, LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, &rays, sum);
    else if (lobe->model == LX_BLINN_PHONG && lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(reflect)(lobe, block, count, LX_BLINN_PHONG, LX_HIGHLIGHT_GATED, &rays, sum);
    else if (lobe->model == LX_BLINN_PHONG)
        NAME(reflect)(lobe, block, count, LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, &rays, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_PLAIN)
        NAME(reflect)(lobe, block, count, LX_PHONG, LX_HIGHLIGHT_PLAIN, &rays, sum);
    else if (lobe->highlight == LX_HIGHLIGHT_GATED)
        NAME(reflect)(lobe, block, count, LX_PHONG, LX_HIGHLIGHT_GATED, &rays, sum);
    else
        NAME(reflect)(lobe, block, count, LX_PHONG, LX_HIGHLIGHT_COSINE, &rays, sum);
}
