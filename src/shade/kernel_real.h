/* SPDX-License-Identifier: MIT */
/*
 * The shading kernel in one precision.  kernel.c includes it twice, behind lanes.h, with
 *
 *     REAL      float or double, and LX_IS_SINGLE 1 or 0
 *     NAME(x)   x with the precision's suffix
 *     BITS      an unsigned integer of the same size
 *     MANTISSA  number of bits of the fraction, BIAS of the exponent, MAGIC = 1.5 * 2^MANTISSA
 *
 * For each vector of elements all lights of one kind are summed in registers.  What varies between kinds of lights and
 * materials is a constant parameter of an inlined loop.
 */

/* A vector of the elements of a block, and what it stands for: elements of another one, from the start-th on. */
struct NAME(elements) {
    NAME(lanes) px, py, pz, nx, ny, nz, vx, vy, vz;
    const struct lx_block_double *exact;
    size_t start;
};

/* The direction to a light, and E_perp; of a point its distance r and 1/r. */
struct NAME(ray) {
    NAME(lanes) x, y, z, e, r, inverse;
};

/* Half the squared length of a vector. */
LX_LANE NAME(lanes) NAME(half_square)(NAME(lanes) x, NAME(lanes) y, NAME(lanes) z)
{
    return (REAL)0.5 * (x * x + y * y + z * z);
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
    return (struct NAME(ray)){x, y, z, e, r2 * limited, limited};
}

/* The versine and the cosine of the angle between the direction from the light, -L, and its axis. */
LX_LANE NAME(lanes) NAME(versine)(const struct NAME(lx_light) * light, const struct NAME(ray) * ray)
{
    return NAME(half_square)(light->axis_x + ray->x, light->axis_y + ray->y, light->axis_z + ray->z);
}

LX_LANE NAME(lanes) NAME(axial)(const struct NAME(lx_light) * light, const struct NAME(ray) * ray)
{
    return -(light->axis_x * ray->x + light->axis_y * ray->y + light->axis_z * ray->z);
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

/* g of the direction from the light, -L. */
LX_LANE NAME(lanes) NAME(profile)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                                  const struct NAME(elements) * at, const struct NAME(ray) * ray)
{
    NAME(lanes) g = NAME(all)(1);
    if (light->falloff != LX_NO_CONE)
        g = NAME(cone)(light, exact, at, ray);
    if (light->exponent.value > 0)
        g *= NAME(power_of)(NAME(versine)(light, ray), NAME(axial)(light, ray), light->exponent);
    return g;
}

LX_LANE struct NAME(ray) NAME(ray_of)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                                      const struct NAME(elements) * at, enum lx_light_kind kind)
{
    struct NAME(ray) ray;
    if (kind == LX_DISTANT)
        return (struct NAME(ray)){
            .x = NAME(all)(light->x), .y = NAME(all)(light->y), .z = NAME(all)(light->z), .e = NAME(all)(light->gain)};
    if (kind == LX_BY_SQUARE || (kind == LX_PROFILED && light->law == LX_INVERSE_SQUARE))
        ray = NAME(towards)(light, at, LX_INVERSE_SQUARE);
    else if (kind == LX_BY_SUM || (kind == LX_PROFILED && light->law == LX_PRACTICAL))
        ray = NAME(towards)(light, at, LX_PRACTICAL);
    else
        ray = NAME(towards)(light, at, LX_NO_ATTENUATION);
    if (kind == LX_PROFILED)
        ray.e *= NAME(profile)(light, exact, at, &ray);
    return ray;
}

LX_LANE NAME(lanes) NAME(n_dot)(const struct NAME(elements) * at, const struct NAME(ray) * ray)
{
    return at->nx * ray->x + at->ny * ray->y + at->nz * ray->z;
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

/* What the lobe makes of light from L, for each unit of E_perp.  A gated highlight is there where `height` is above
 * 0. */
LX_LANE NAME(lanes)
    NAME(weight_of)(const struct NAME(lx_lobe) * lobe, const struct NAME(elements) * at, enum lx_model model,
                    enum lx_highlight highlight, const struct NAME(ray) * ray, NAME(lanes) height)
{
    const NAME(lanes) zero = NAME(all)(0), lx = ray->x, ly = ray->y, lz = ray->z;
    NAME(lanes) n_dot_l = NAME(n_dot)(at, ray), front = NAME(greater)(n_dot_l, zero);
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
        shine = NAME(where_above)(height, zero, shine, zero);
    return weight + shine;
}

LX_LANE struct NAME(elements)
    NAME(elements_at)(const struct NAME(lx_block) * block, const struct lx_block_double *exact, size_t i)
{
    return (struct NAME(elements)){NAME(load)(block->px + i),
                                   NAME(load)(block->py + i),
                                   NAME(load)(block->pz + i),
                                   NAME(load)(block->nx + i),
                                   NAME(load)(block->ny + i),
                                   NAME(load)(block->nz + i),
                                   NAME(load)(block->vx + i),
                                   NAME(load)(block->vy + i),
                                   NAME(load)(block->vz + i),
                                   exact,
                                   i};
}

/* The brightness of a vector of elements by a light whose rays are known. */
LX_LANE NAME(lanes) NAME(reflected)(const struct NAME(lx_light) * light, const struct lx_light_double *exact,
                                    const struct NAME(lx_lobe) * lobe, const struct NAME(elements) * at,
                                    const struct NAME(ray) * ray, enum lx_model model, enum lx_highlight highlight)
{
    NAME(lanes) height = NAME(all)(0);
    if (highlight == LX_HIGHLIGHT_GATED)
        height = NAME(height)(light, exact, at, ray);
    return ray->e * NAME(weight_of)(lobe, at, model, highlight, ray, height);
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
    size_t count;
    double *sum;
};

/*
 * Adds the brightness by all the lights, which are of one kind.  Two vectors at once, their rays first, keep the
 * machine busy where one would wait for its own results.
 */
LX_LANE void NAME(reflect)(const struct NAME(work) * work, enum lx_light_kind kind, enum lx_model model,
                           enum lx_highlight highlight)
{
    const struct NAME(lx_lobe) constants = *work->lobe;
    const struct NAME(lx_block) *block = work->block;
    const struct lx_light_double *exacts = work->exacts;
    const float *open = work->open;
    double *restrict sum = work->sum;
    const size_t count = work->count;
    const size_t width = NAME(LX_WIDTH);
    _Alignas(LX_VECTOR_BYTES) REAL totals[LX_BLOCK];
    size_t i = 0;
    for (; i + 2 * width <= count; i += 2 * width) {
        const struct NAME(elements) at = NAME(elements_at)(block, work->exact, i);
        const struct NAME(elements) next = NAME(elements_at)(block, work->exact, i + width);
        NAME(lanes) total = NAME(all)(0), total_of_next = total;
        for (size_t k = 0; k < work->light_count; k++) {
            const struct NAME(lx_light) *light = &work->lights[k];
            const struct lx_light_double *in_double = exacts ? &exacts[k] : NULL;
            struct NAME(ray) ray = NAME(ray_of)(light, in_double, &at, kind);
            struct NAME(ray) ray_to_next = NAME(ray_of)(light, in_double, &next, kind);
            if (kind == LX_PROFILED && !NAME(any_above)(ray.e + ray_to_next.e, NAME(all)(0)))
                continue; /* no light falls there */
            total += NAME(reflected)(light, in_double, &constants, &at, &ray, model, highlight);
            total_of_next += NAME(reflected)(light, in_double, &constants, &next, &ray_to_next, model, highlight);
        }
        NAME(store)(totals + i, total);
        NAME(store)(totals + i + width, total_of_next);
    }
    if (i < count) { /* one vector more */
        const struct NAME(elements) at = NAME(elements_at)(block, work->exact, i);
        NAME(lanes) total = NAME(all)(0);
        for (size_t k = 0; k < work->light_count; k++) {
            const struct lx_light_double *in_double = exacts ? &exacts[k] : NULL;
            struct NAME(ray) ray = NAME(ray_of)(&work->lights[k], in_double, &at, kind);
            total += NAME(reflected)(&work->lights[k], in_double, &constants, &at, &ray, model, highlight);
        }
        NAME(store)(totals + i, total);
    }
    for (i = 0; open && i < count; i++)
        totals[i] *= (REAL)open[i];
    for (i = 0; i < count; i++)
        sum[i] += (double)totals[i];
}

LX_LANE void NAME(by_lobe)(const struct NAME(work) * work, enum lx_light_kind kind)
{
    const enum lx_model model = work->lobe->model;
    const enum lx_highlight highlight = work->lobe->highlight;
    if (model == LX_LAMBERT)
        NAME(reflect)(work, kind, LX_LAMBERT, LX_HIGHLIGHT_PLAIN);
    else if (model == LX_BLINN_PHONG && highlight == LX_HIGHLIGHT_PLAIN)
        NAME(reflect)(work, kind, LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN);
    else if (model == LX_BLINN_PHONG && highlight == LX_HIGHLIGHT_GATED)
        NAME(reflect)(work, kind, LX_BLINN_PHONG, LX_HIGHLIGHT_GATED);
    else if (model == LX_BLINN_PHONG)
        NAME(reflect)(work, kind, LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE);
    else if (highlight == LX_HIGHLIGHT_PLAIN)
        NAME(reflect)(work, kind, LX_PHONG, LX_HIGHLIGHT_PLAIN);
    else if (highlight == LX_HIGHLIGHT_GATED)
        NAME(reflect)(work, kind, LX_PHONG, LX_HIGHLIGHT_GATED);
    else
        NAME(reflect)(work, kind, LX_PHONG, LX_HIGHLIGHT_COSINE);
}

static void NAME(shade)(const struct NAME(lx_light) * lights, const struct lx_light_double *exacts, size_t light_count,
                        const struct NAME(lx_lobe) * lobe, const struct NAME(lx_block) * block,
                        const struct lx_block_double *exact, const float *open, size_t count, double *sum)
{
    const struct NAME(work) work = {lights, exacts, light_count, lobe, block, exact, open, lx_padded(count), sum};
    switch (lights->kind) {
    case LX_DISTANT: NAME(by_lobe)(&work, LX_DISTANT); break;
    case LX_BY_SQUARE: NAME(by_lobe)(&work, LX_BY_SQUARE); break;
    case LX_BY_SUM: NAME(by_lobe)(&work, LX_BY_SUM); break;
    case LX_UNATTENUATED: NAME(by_lobe)(&work, LX_UNATTENUATED); break;
    case LX_PROFILED: NAME(by_lobe)(&work, LX_PROFILED); break;
    }
}
