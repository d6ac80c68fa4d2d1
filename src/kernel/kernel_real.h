/* SPDX-License-Identifier: MIT */
/*
 * The shading kernel in one precision.  kernel.c includes it twice, behind lanes.h, with
 *
 *     REAL      float or double, and LX_IS_SINGLE 1 or 0
 *     NAME(x)   x with the precision's suffix
 *     BITS      an unsigned integer of the same size
 *     MANTISSA  number of bits of the fraction, BIAS of the exponent, MAGIC = 1.5 * 2^MANTISSA
 *     TINY      less than the square of any length that counts, and not 0
 *
 * For some vectors of elements side by side all lights of one kind are summed.  What varies between kinds of lights and
 * materials is a constant parameter of an inlined loop, and so is how many vectors there are.
 */

/*
 * A vector of the elements of a block, and what it stands for: elements of another one, from the start-th on.  The view
 * vector comes as its part along the normal, N.V, and the one across it.
 */
struct NAME(elements) {
    NAME(lanes) px, py, pz, nx, ny, nz, along_n, vx, vy, vz;
    const struct lx_block_double *exact;
    size_t start;
};

/* L, as the way to a light times `inverse`; E_perp; of a point its distance r, and 1/r for `inverse`. */
struct NAME(ray) {
    NAME(lanes) x, y, z, inverse, e, r;
};

/* Half the squared length of a vector. */
LX_LANE NAME(lanes) NAME(half_square)(NAME(lanes) x, NAME(lanes) y, NAME(lanes) z)
{
    return (REAL)0.5 * (x * x + y * y + z * z);
}

/* 1/(by_none + by_root r + by_square r^2), r in m, of a distance in mm. */
LX_LANE NAME(lanes) NAME(by_polynomial)(REAL by_none, REAL by_root, REAL by_square, NAME(lanes) distance)
{
    const NAME(lanes) r = distance * (REAL)1e-3;
    return NAME(inverse)(by_none + r * (by_root + r * by_square));
}

/* L and E_perp of a point without its profile. */
LX_LANE struct NAME(ray)
    NAME(towards)(const struct NAME(lx_light) * light, const struct NAME(elements) * at, enum lx_attenuation law)
{
    NAME(lanes) x = light->x - at->px, y = light->y - at->py, z = light->z - at->pz;
    NAME(lanes) r2 = x * x + y * y + z * z, inverse, limited;
    if (LX_IS_SINGLE) { /* sources that stand very near are never left to float32 */
        inverse = limited = NAME(inverse_root)(r2);
    } else {
        /* A source on the element itself counts as standing just above it. */
        const REAL nearest = (REAL)1e-6; /* mm */
        NAME(lanes) zero = NAME(all)(0), lift = NAME(where_above)(r2, zero, zero, NAME(all)(nearest));
        x += lift * at->nx, y += lift * at->ny, z += lift * at->nz;
        r2 = NAME(where_above)(r2, zero, r2, NAME(all)(nearest * nearest));
        inverse = NAME(inverse_root)(r2);
        limited = NAME(lesser)(inverse, NAME(all)(1 / nearest));
    }
    NAME(lanes) e = NAME(all)(light->gain);
    if (law == LX_INVERSE_SQUARE)
        e *= limited * limited;
    else if (law == LX_PRACTICAL)
        e *= NAME(inverse)(light->k + NAME(root)(r2));
    else if (law == LX_POLYNOMIAL)
        e *= NAME(by_polynomial)(light->by_none, light->by_root, light->by_square, NAME(root)(r2));
    return (struct NAME(ray)){x, y, z, inverse, e, r2 * inverse};
}

/* The versine and the cosine of the angle between the direction from the light, -L, and its axis. */
LX_LANE NAME(lanes) NAME(versine)(const struct NAME(lx_light) * light, const struct NAME(ray) * ray)
{
    return NAME(half_square)(light->axis_x + ray->inverse * ray->x, light->axis_y + ray->inverse * ray->y,
                             light->axis_z + ray->inverse * ray->z);
}

LX_LANE NAME(lanes) NAME(axial)(const struct NAME(lx_light) * light, const struct NAME(ray) * ray)
{
    return -ray->inverse * (light->axis_x * ray->x + light->axis_y * ray->y + light->axis_z * ray->z);
}

/* g of a cone; `exact`: the light in float64, as in all that follows. */
LX_LANE NAME(lanes) NAME(cone)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                               const struct NAME(elements) * at, const struct NAME(ray) * ray)
{
#if LX_IS_SINGLE
    return cone_in_single(light, exact, at->exact, at->start, NAME(axial)(light, ray), ray->r, ray->inverse);
#else
    (void)exact, (void)at;
    const NAME(lanes) versine = NAME(versine)(light, ray), zero = NAME(all)(0), one = NAME(all)(1);
    NAME(lanes) measure = versine;
    if (light->falloff == LX_HARD)
        return NAME(where_above)(versine, NAME(all)(light->edge), zero, one);
    if (light->falloff == LX_LINEAR) /* tan^2 of half the angle */
        measure = NAME(angle_of_half_tangent)(NAME(root)(versine / (2 - NAME(lesser)(versine, one))));
    NAME(lanes) t = NAME(lesser)(NAME(greater)((light->edge - measure) * light->edge_slope, zero), one);
    NAME(lanes) g = light->falloff == LX_SMOOTHSTEP ? t * t * (3 - 2 * t) : light->falloff == LX_SQUARED ? t * t : t;
    return NAME(where_above)(one, versine, g, zero); /* cones end at 90 degrees */
#endif
}

/* cos^exponent of the angle between the direction from the light and its axis. */
LX_LANE NAME(lanes) NAME(pattern)(const struct NAME(lx_light) * light, const struct NAME(ray) * ray)
{
    const NAME(lanes) cosine = NAME(axial)(light, ray);
    if (light->exponent.whole == 1)
        return NAME(greater)(cosine, NAME(all)(0));
    return NAME(power_of)(cosine, NAME(versine)(light, ray), light->exponent);
}

/* g of the direction from the light, -L. */
LX_LANE NAME(lanes) NAME(profile)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                                  const struct NAME(elements) * at, const struct NAME(ray) * ray)
{
    NAME(lanes) g = NAME(all)(1);
    if (light->luminaire) {
        NAME(look_up)(light->luminaire, &ray->x, &ray->y, &ray->z, &ray->r, &g);
        return g;
    }
    if (light->falloff != LX_NO_CONE)
        g = NAME(cone)(light, exact, at, ray);
    if (light->exponent.value > 0)
        g *= NAME(pattern)(light, ray);
    return g;
}

LX_LANE struct NAME(ray) NAME(ray_of)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                                      const struct NAME(elements) * at, enum lx_kernel_light kind)
{
    struct NAME(ray) ray;
    if (kind == LX_DISTANT)
        return (struct NAME(ray)){.x = NAME(all)(light->x),
                                  .y = NAME(all)(light->y),
                                  .z = NAME(all)(light->z),
                                  .inverse = NAME(all)(1),
                                  .e = NAME(all)(light->gain)};
    if (kind == LX_BY_SQUARE || (kind == LX_PROFILED && light->law == LX_INVERSE_SQUARE))
        ray = NAME(towards)(light, at, LX_INVERSE_SQUARE);
    else if (kind == LX_BY_SUM || (kind == LX_PROFILED && light->law == LX_PRACTICAL))
        ray = NAME(towards)(light, at, LX_PRACTICAL);
    else if (kind == LX_PROFILED && light->law == LX_POLYNOMIAL)
        ray = NAME(towards)(light, at, LX_POLYNOMIAL);
    else
        ray = NAME(towards)(light, at, LX_NO_ATTENUATION);
    if (kind == LX_PROFILED)
        ray.e *= NAME(profile)(light, exact, at, &ray);
    return ray;
}

LX_LANE NAME(lanes) NAME(n_dot)(const struct NAME(elements) * at, const struct NAME(ray) * ray)
{
    return (at->nx * ray->x + at->ny * ray->y + at->nz * ray->z) * ray->inverse;
}

/* Above 0 where a light stands above the horizon. */
LX_LANE NAME(lanes) NAME(height)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                                 const struct NAME(elements) * at, const struct NAME(ray) * ray)
{
#if LX_IS_SINGLE
    return height_in_single(light, exact, at->exact, at->start, NAME(n_dot)(at, ray), ray->inverse);
#else
    (void)light, (void)exact;
    return NAME(n_dot)(at, ray);
#endif
}

/*
 * S of a highlight, and 1 - S.  With l and v the parts of L and V across the normal, (N.L) N - l is the mirrored L, and
 * |l + v|^2 + (N.L - N.V)^2 = 2 - 2 S.
 */
LX_LANE void NAME(phong)(const struct NAME(elements) * at, const struct NAME(ray) * ray, NAME(lanes) n_dot_l,
                         NAME(lanes) across, NAME(lanes) * cosine, NAME(lanes) * versine)
{
    NAME(lanes) apart = n_dot_l - at->along_n;
    NAME(lanes) l_dot_v = (ray->x * at->vx + ray->y * at->vy + ray->z * at->vz) * ray->inverse; /* of l and v */
    *versine = (REAL)0.5 * (across + apart * apart);
    *cosine = n_dot_l * at->along_n - l_dot_v;
    NAME(limit)(cosine, versine);
}

/* L = -V, but for rounding, has no half vector: |L + V|^2 is no more than this; float32 never comes near it. */
static const REAL NAME(least_half) = (REAL)0x1p-98;

/*
 * S^2 and 1 - S^2, which take no root, with the half vector H, whose parts along the normal and across it are as
 * `along`, N.L + N.V, to l + v, the squares of which add up to `square`.
 */
LX_LANE void NAME(blinn_phong)(NAME(lanes) along, NAME(lanes) across, NAME(lanes) * square, NAME(lanes) * cosine2,
                               NAME(lanes) * sine2)
{
    *square = across + along * along;
    NAME(lanes) inverse = NAME(inverse)(*square);
    *sine2 = across * inverse;
    if (LX_IS_SINGLE) {
        *cosine2 = 1 - *sine2;
    } else {
        const NAME(lanes) least = NAME(all)(NAME(least_half));
        *sine2 = NAME(where_above)(*square, least, *sine2, NAME(all)(1));
        *cosine2 = NAME(where_above)(*square, least, along * along * inverse, NAME(all)(0));
    }
}

/* S^n of the highlights of `count` vectors. */
LX_LANE void NAME(shine_of)(struct NAME(lx_exponent) exponent, const struct NAME(elements) * at,
                            const struct NAME(ray) * ray, const NAME(lanes) * n_dot_l, int count, enum lx_model model,
                            NAME(lanes) * shine)
{
    /* with an exponent below 2 a power of S^2 would rise too steeply from S = 0 */
    const bool by_square = LX_IS_BY_HALF(model) && exponent.value >= 2;
    const bool is_odd = by_square && exponent.whole % 2 == 1;
    NAME(lanes) cosine[LX_ABREAST], versine[LX_ABREAST], along[LX_ABREAST], square[LX_ABREAST];
    LX_WRITTEN_OUT
    for (int i = 0; i < count; i++) {
        NAME(lanes) x = ray[i].x * ray[i].inverse + (at[i].vx - n_dot_l[i] * at[i].nx);
        NAME(lanes) y = ray[i].y * ray[i].inverse + (at[i].vy - n_dot_l[i] * at[i].ny);
        NAME(lanes) z = ray[i].z * ray[i].inverse + (at[i].vz - n_dot_l[i] * at[i].nz);
        NAME(lanes) across = x * x + (y * y + (z * z + (REAL)TINY));
        along[i] = NAME(greater)(n_dot_l[i] + at[i].along_n, NAME(all)(0));
        square[i] = across; /* of Phong's none is asked for, which compilers cannot tell in a loop for both */
        if (LX_IS_BY_MIRROR(model))
            NAME(phong)(&at[i], &ray[i], n_dot_l[i], across, &cosine[i], &versine[i]);
        else
            NAME(blinn_phong)(along[i], across, &square[i], &cosine[i], &versine[i]);
    }
    for (int i = 0; i < count && LX_IS_BY_HALF(model) && !by_square; i++) {
        NAME(lanes) root = along[i] * NAME(inverse_root)(square[i]);
        if (!LX_IS_SINGLE)
            root = NAME(where_above)(square[i], NAME(all)(NAME(least_half)), root, NAME(all)(0));
        versine[i] *= NAME(inverse)(1 + root);
        cosine[i] = LX_IS_SINGLE ? 1 - versine[i] : root;
    }
    if (by_square)
        exponent = (struct NAME(lx_exponent)){exponent.value / 2, exponent.whole / 2};
    NAME(raise)(cosine, versine, count, exponent, shine);
    for (int i = 0; i < count && is_odd; i++)
        shine[i] *= along[i] * NAME(inverse_root)(square[i]);
}

/*
 * Factors of the diffuse and the specular coefficient for light from L, for each unit of E_perp.  A gated
 * highlight is there where `height` is above 0.
 */
LX_LANE void NAME(reflect)(struct NAME(lx_exponent) exponent, const struct NAME(elements) * at,
                           const struct NAME(ray) * ray, const NAME(lanes) * height, int count, enum lx_model model,
                           enum lx_highlight highlight, NAME(lanes) * diffuse, NAME(lanes) * specular)
{
    const NAME(lanes) zero = NAME(all)(0);
    NAME(lanes) n_dot_l[LX_ABREAST];
    LX_WRITTEN_OUT
    for (int i = 0; i < count; i++)
        n_dot_l[i] = NAME(n_dot)(&at[i], &ray[i]);
    if (LX_HAS_HIGHLIGHT(model))
        NAME(shine_of)(exponent, at, ray, n_dot_l, count, model, specular);
    LX_WRITTEN_OUT
    for (int i = 0; i < count; i++) {
        diffuse[i] = NAME(greater)(n_dot_l[i], zero);
        if (LX_HAS_HIGHLIGHT(model) && LX_FALLS_TO_HORIZON(highlight))
            specular[i] *= diffuse[i];
        if (LX_HAS_HIGHLIGHT(model) && LX_JUMPS_AT_HORIZON(highlight))
            specular[i] = NAME(where_above)(height[i], zero, specular[i], zero);
    }
}

LX_LANE struct NAME(elements)
    NAME(elements_at)(const struct NAME(lx_block) * block, const struct lx_block_double *exact, size_t i)
{
    const NAME(lanes) nx = NAME(load)(block->nx + i), ny = NAME(load)(block->ny + i), nz = NAME(load)(block->nz + i);
    const NAME(lanes) vx = NAME(load)(block->vx + i), vy = NAME(load)(block->vy + i), vz = NAME(load)(block->vz + i);
    const NAME(lanes) along_n = nx * vx + ny * vy + nz * vz;
    return (struct NAME(elements)){
        .px = NAME(load)(block->px + i),
        .py = NAME(load)(block->py + i),
        .pz = NAME(load)(block->pz + i),
        .nx = nx,
        .ny = ny,
        .nz = nz,
        .along_n = along_n,
        .vx = vx - along_n * nx,
        .vy = vy - along_n * ny,
        .vz = vz - along_n * nz,
        .exact = exact,
        .start = i,
    };
}

/* What a kernel is called with. */
struct NAME(work) {
    const struct NAME(lx_light) * lights;
    const struct lx_light_double *exacts;
    size_t light_count;
    const struct NAME(lx_lobe) * lobe;
    const struct NAME(lx_block) * block;
    const struct lx_block_double *exact;
    const float *open;
    size_t count;  /* in whole lanes */
    double *sum;   /* what is added to; or NULL, and: */
    float *values; /* what is set, of so many elements, to `uniform` and the light */
    size_t value_count;
    float uniform;
};

/*
 * Sets totals[] to the brightness of `count` vectors of elements, from the start-th element on, by all the lights,
 * which are of one kind.  What would lie beyond the last vector is that vector once more.
 */
LX_LANE void NAME(sum_lights)(const struct NAME(work) * work, size_t start, int count, enum lx_kernel_light kind,
                              enum lx_model model, enum lx_highlight highlight, REAL *totals)
{
    const struct NAME(lx_lobe) lobe = *work->lobe;
    const NAME(lanes) zero = NAME(all)(0);
    struct NAME(elements) at[LX_ABREAST];
    struct NAME(ray) ray[LX_ABREAST];
    NAME(lanes) height[LX_ABREAST], diffuse[LX_ABREAST], specular[LX_ABREAST];
    NAME(lanes) total_diffuse[LX_ABREAST], total_specular[LX_ABREAST];
    LX_WRITTEN_OUT
    for (int i = 0; i < count; i++) {
        const size_t next = start + (size_t)i * NAME(LX_WIDTH), last = work->count - NAME(LX_WIDTH);
        at[i] = NAME(elements_at)(work->block, work->exact, next < last ? next : last);
        total_diffuse[i] = total_specular[i] = zero;
    }
    for (size_t k = 0; k < work->light_count; k++) {
        const struct NAME(lx_light) *light = &work->lights[k];
        const struct lx_light_double *exact = work->exacts ? &work->exacts[k] : NULL;
        NAME(lanes) most = zero;
        LX_UNROLLED
        for (int i = 0; i < count; i++) {
            ray[i] = NAME(ray_of)(light, exact, &at[i], kind);
            most = NAME(greater)(most, ray[i].e);
        }
        if (kind == LX_PROFILED && !NAME(any_above)(most, zero))
            continue; /* no light falls there */
        for (int i = 0; i < count && LX_JUMPS_AT_HORIZON(highlight); i++)
            height[i] = NAME(height)(light, exact, &at[i], &ray[i]);
        NAME(reflect)(lobe.exponent, at, ray, height, count, model, highlight, diffuse, specular);
        LX_WRITTEN_OUT
        for (int i = 0; i < count; i++) {
            total_diffuse[i] += ray[i].e * diffuse[i];
            if (LX_HAS_HIGHLIGHT(model))
                total_specular[i] += ray[i].e * specular[i];
        }
    }
    LX_WRITTEN_OUT
    for (int i = 0; i < count; i++) {
        /* in float32 S^2 = 1 - sine^2 may be a rounding below 0 */
        const NAME(lanes) glossy = LX_IS_SINGLE ? NAME(greater)(total_specular[i], zero) : total_specular[i];
        NAME(lanes) total = lobe.diffuse * total_diffuse[i] + lobe.specular * glossy;
        NAME(store)(totals + at[i].start, total);
    }
}

/* The brightness by all the lights. */
LX_LANE void NAME(add_lights)(const struct NAME(work) * work, enum lx_kernel_light kind, enum lx_model model,
                              enum lx_highlight highlight)
{
    const size_t count = work->count, width = NAME(LX_WIDTH);
    _Alignas(LX_VECTOR_BYTES) REAL totals[LX_BLOCK];
    size_t i = 0;
    for (; work->light_count >= LX_FEWEST_ABREAST && i + LX_ABREAST * width <= count; i += LX_ABREAST * width)
        NAME(sum_lights)(work, i, LX_ABREAST, kind, model, highlight, totals);
    for (; i < count; i += 2 * width)
        NAME(sum_lights)(work, i, 2, kind, model, highlight, totals);
    for (i = 0; work->open && i < count; i++)
        totals[i] *= (REAL)work->open[i];
    double *restrict sum = work->sum;
    float *restrict values = work->values;
    const float uniform = work->uniform;
    for (i = 0; sum && i < count; i++)
        sum[i] += (double)totals[i];
    for (i = 0; values && i < work->value_count; i++)
        values[i] = uniform + (float)totals[i];
}

/*
 * Each kind of material has a loop of its own, which asks nothing on its way.  With LX_FEW_KERNELS all have one, which
 * takes less room for the same numbers.
 */
LX_LANE void NAME(by_lobe)(const struct NAME(work) * work, enum lx_kernel_light kind)
{
    const enum lx_model model = work->lobe->model;
    const enum lx_highlight highlight = work->lobe->highlight;
#ifdef LX_FEW_KERNELS
    NAME(add_lights)(work, kind, model, LX_KERNEL_WEIGHT(model, highlight));
#else
#define LX_ADD_LIGHTS(one, weight, when)                                                                               \
    if (when)                                                                                                          \
        NAME(add_lights)(work, kind, one, weight);                                                                     \
    else
    LX_KERNEL_LOBES(LX_ADD_LIGHTS, model, highlight)
    return;
#undef LX_ADD_LIGHTS
#endif
}

/*
 * Functions of their own for each kind: compilers take much longer for one that holds them all.  Of float64, which few
 * pictures need, LX_FEW_KERNELS has but one.
 */
#define LX_SHADE_BY(name, kind)                                                                                        \
    static __attribute__((noinline)) void NAME(name)(const struct NAME(work) * work)                                   \
    {                                                                                                                  \
        NAME(by_lobe)(work, kind);                                                                                     \
    }
#if defined LX_FEW_KERNELS && !LX_IS_SINGLE
static __attribute__((noinline)) void NAME(by_any)(const struct NAME(work) * work)
{
    NAME(by_lobe)(work, work->lights->kind);
}
#else
LX_SHADE_BY(by_direction, LX_DISTANT)
LX_SHADE_BY(by_square, LX_BY_SQUARE)
LX_SHADE_BY(by_sum, LX_BY_SUM)
LX_SHADE_BY(unattenuated, LX_UNATTENUATED)
LX_SHADE_BY(profiled, LX_PROFILED)
#endif
#undef LX_SHADE_BY

LX_LANE void NAME(by_kind)(const struct NAME(work) * work)
{
#if defined LX_FEW_KERNELS && !LX_IS_SINGLE
    NAME(by_any)(work);
#else
    switch (work->lights->kind) {
    case LX_DISTANT: NAME(by_direction)(work); break;
    case LX_BY_SQUARE: NAME(by_square)(work); break;
    case LX_BY_SUM: NAME(by_sum)(work); break;
    case LX_UNATTENUATED: NAME(unattenuated)(work); break;
    case LX_PROFILED: NAME(profiled)(work); break;
    }
#endif
}

static void NAME(shade)(const struct NAME(lx_light) * lights, const struct lx_light_double *exacts, size_t light_count,
                        const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block,
                        const struct lx_block_double *exact, const float *open, size_t count, double *sum)
{
    const struct NAME(work)
        work = {lights, exacts, light_count, lobe, block, exact, open, .count = lx_padded(count), .sum = sum};
    NAME(by_kind)(&work);
}

#if LX_IS_SINGLE
static void value_single(const struct lx_light_single *lights, size_t light_count, const struct lx_lobe_single *lobe,
                         const struct lx_block_single *block, size_t count, float uniform, float *values)
{
    const struct work_single work = {
        lights,           .light_count = light_count, .lobe = lobe,      .block = block, .count = lx_padded(count),
        .values = values, .value_count = count,       .uniform = uniform};
    by_kind_single(&work);
}
#endif
