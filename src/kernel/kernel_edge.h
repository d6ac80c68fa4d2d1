/* SPDX-License-Identifier: MIT */
/*
 * Edges in float32.  In the penumbra of a cone, and where a gated highlight sets, a small error of a direction is a
 * large one of the brightness.  There, and only there, what decides is formed in float64 from the same lights and
 * elements, without a root or a quotient:
 *
 *     cone      d from the light to the element, h = d.a along the axis, o the outer angle:
 *               q = h^2 - cos^2 o d^2 = d^2 (cos^2 theta - cos^2 o) = d^2 sin(o - theta) sin(o + theta)
 *     horizon   N.(S - P) of a point S and an element P, or N.L
 *
 * The vanishing factor of q is exact to the last bits of float32 once the other one, which does not vanish, is divided
 * out.  An element that float32 can tell from the edge is decided by float32, whatever its neighbours in the vector do.
 *
 * kernel.c includes this once, behind lanes.h and kernel_functions.h in both precisions.
 */

/* Two vectors of float64 as one of float32. */
LX_LANE lanes_single joined(lanes_double low, lanes_double high)
{
    typedef float half __attribute__((vector_size(LX_VECTOR_BYTES / 2)));
    const half a = __builtin_convertvector(low, half), b = __builtin_convertvector(high, half);
#if LX_VECTOR_BYTES == 64
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#elif LX_VECTOR_BYTES == 32
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return __builtin_shufflevector(a, b, 0, 1, 2, 3);
#endif
}

/*
 * More than the error of N.L, or of L and an axis: with u = 2^-24 places are off by u (|S| + |P|), S and P from the
 * anchor, so that L is off by at most u (2 |S|/r + 4), and the rest adds 8 u.
 */
LX_LANE lanes_single doubt(const struct lx_light_single *light, lanes_single inverse)
{
    const float away = light->kind == LX_DISTANT ? 0 : fabsf(light->x) + fabsf(light->y) + fabsf(light->z);
    return 0x1p-20F * away * inverse + 0x1p-19F;
}

/* Terms of a cone, of half a vector: q, h, and the square of the distance from the axis. */
struct cone_terms {
    lanes_double square, height, across;
};

LX_LANE struct cone_terms cone_terms(const struct lx_light_double *light, const struct lx_block_double *block, size_t i)
{
    const lanes_double x = load_double(block->px + i) - light->x, y = load_double(block->py + i) - light->y;
    const lanes_double z = load_double(block->pz + i) - light->z;
    const lanes_double height = x * light->axis_x + y * light->axis_y + z * light->axis_z;
    const lanes_double away = x * x + y * y + z * z; /* less h^2 this would lose what is across near the axis */
    const lanes_double bx = x - height * light->axis_x, by = y - height * light->axis_y,
                       bz = z - height * light->axis_z;
    return (struct cone_terms){.square = height * height - light->cosine * light->cosine * away,
                               .height = height,
                               .across = bx * bx + by * by + bz * bz};
}

/* g of a cone within its penumbra, and a little beyond; r the distance, `inverse` 1/r. */
LX_LANE lanes_single penumbra(const struct lx_light_single *light, const struct lx_light_double *exact,
                              const struct lx_block_double *block, size_t start, lanes_single r, lanes_single inverse)
{
    const lanes_single zero = all_single(0), one = all_single(1), least = all_single(1e-36F);
    const struct cone_terms low = cone_terms(exact, block, start);
    const struct cone_terms high = cone_terms(exact, block, start + LX_WIDTH_double);
    const lanes_single square = joined(low.square, high.square), height = joined(low.height, high.height);
    lanes_single g;
    if (light->falloff == LX_HARD) {
        g = where_above_single(zero, square, zero, one);
    } else if (light->falloff == LX_LINEAR) { /* the angle o - theta, by the tangent of its half */
        const lanes_single square_across = greater_single(joined(low.across, high.across), least);
        const lanes_single across = square_across * inverse_root_single(square_across);
        const lanes_single sine = light->sine * height + light->cosine * across;   /* of o + theta, times r */
        const lanes_single cosine = light->cosine * height + light->sine * across; /* of o - theta, times r */
        const lanes_single tangent = square * inverse_single(greater_single(sine * (r + cosine), least));
        g = angle_of_half_tangent_single(lesser_single(greater_single(tangent, zero), one)) * light->edge_slope;
    } else {
        const lanes_single both = greater_single(height + light->cosine * r, least);
        g = square * inverse * inverse_single(both) * light->edge_slope;
    }
    g = lesser_single(greater_single(g, zero), one);
    if (light->falloff == LX_SMOOTHSTEP)
        g *= g * (3 - 2 * g);
    else if (light->falloff == LX_SQUARED)
        g *= g;
    return where_above_single(height, zero, g, zero); /* cones end at 90 degrees */
}

/* g of a cone, of a cosine in float32. */
LX_LANE lanes_single cone_in_single(const struct lx_light_single *light, const struct lx_light_double *exact,
                                    const struct lx_block_double *block, size_t start, lanes_single cosine,
                                    lanes_single r, lanes_single inverse)
{
    const lanes_single zero = all_single(0), one = all_single(1), off = doubt(light, inverse);
    const lanes_single from_inner = light->inner_cosine - cosine, to_outer = cosine - light->cosine;
    const lanes_single within = off + lesser_single(from_inner, to_outer);
    lanes_single g = where_above_single(from_inner, zero, zero, one);
    if (any_above_single(within, zero))
        g = where_above_single(within, zero, penumbra(light, exact, block, start, r, inverse), g);
    return g;
}

/* The height of a light above the horizon, of half a vector; of a point in mm. */
LX_LANE lanes_double height_exactly(const struct lx_light_double *light, const struct lx_block_double *block, size_t i)
{
    const double from = light->kind == LX_DISTANT ? 0 : 1; /* a direction is the same from everywhere */
    return load_double(block->nx + i) * (light->x - from * load_double(block->px + i)) +
           load_double(block->ny + i) * (light->y - from * load_double(block->py + i)) +
           load_double(block->nz + i) * (light->z - from * load_double(block->pz + i));
}

/* N.L, or, where that is so near to 0 that its sign is in doubt, something with the sign of the height. */
LX_LANE lanes_single height_in_single(const struct lx_light_single *light, const struct lx_light_double *exact,
                                      const struct lx_block_double *block, size_t start, lanes_single n_dot_l,
                                      lanes_single inverse)
{
    const lanes_single zero = all_single(0), off = doubt(light, inverse);
    const lanes_single within = lesser_single(n_dot_l + off, off - n_dot_l);
    if (!any_above_single(within, zero))
        return n_dot_l;
    const lanes_double low = height_exactly(exact, block, start);
    const lanes_double high = height_exactly(exact, block, start + LX_WIDTH_double);
    return where_above_single(within, zero, joined(low, high), n_dot_l);
}
