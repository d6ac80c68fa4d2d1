/* SPDX-License-Identifier: MIT */
/*
 * The highlight that one element shows of light from many directions, in one precision.  Included by kernel.c behind
 * each kernel_real.h, whose names and formulas it uses.
 */

/* An element in all lanes. */
LX_LANE struct NAME(elements) NAME(element_everywhere)(const double normal[3], const double view[3])
{
    const double along_n = normal[0] * view[0] + normal[1] * view[1] + normal[2] * view[2];
    return (struct NAME(elements)){
        .nx = NAME(all)((REAL)normal[0]),
        .ny = NAME(all)((REAL)normal[1]),
        .nz = NAME(all)((REAL)normal[2]),
        .along_n = NAME(all)((REAL)along_n),
        .vx = NAME(all)((REAL)(view[0] - along_n * normal[0])),
        .vy = NAME(all)((REAL)(view[1] - along_n * normal[1])),
        .vz = NAME(all)((REAL)(view[2] - along_n * normal[2])),
    };
}

LX_LANE double NAME(beams_of)(const struct NAME(lx_beams) * beams, size_t count, struct NAME(lx_exponent) exponent,
                              const double normal[3], const double view[3], enum lx_model model,
                              enum lx_highlight highlight)
{
    const struct NAME(elements) at = NAME(element_everywhere)(normal, view);
    NAME(lanes) total = NAME(all)(0);
    for (size_t i = 0; i < count; i += NAME(LX_WIDTH)) {
        const NAME(lanes) x = NAME(load)(beams->x + i), y = NAME(load)(beams->y + i), z = NAME(load)(beams->z + i);
        const NAME(lanes) inverse = NAME(inverse_root)(x * x + y * y + z * z);
        const struct NAME(ray) ray = {.x = x, .y = y, .z = z, .inverse = inverse};
        NAME(lanes) height = NAME(n_dot)(&at, &ray), diffuse, specular = NAME(all)(0);
        NAME(reflect)(exponent, &at, &ray, &height, 1, model, highlight, &diffuse, &specular);
        total += NAME(load)(beams->weight + i) * NAME(greater)(specular, NAME(all)(0)) * (inverse * inverse * inverse);
    }
    REAL lanes[NAME(LX_WIDTH)];
    double sum = 0;
    memcpy(lanes, &total, sizeof lanes);
    for (int i = 0; i < NAME(LX_WIDTH); i++)
        sum += (double)lanes[i];
    return sum;
}

static double NAME(sum_beams)(const struct NAME(lx_beams) * beams, size_t count, const struct NAME(lx_lobe) * lobe,
                              const double normal[3], const double view[3])
{
    const bool by_cosine = LX_FALLS_TO_HORIZON(lobe->highlight);
#define LX_SUM_BEAMS(one, weight, when)                                                                                \
    if (when)                                                                                                          \
        return NAME(beams_of)(beams, count, lobe->exponent, normal, view, one, weight);
    LX_KERNEL_BEAMS(LX_SUM_BEAMS, lobe->model, by_cosine)
#undef LX_SUM_BEAMS
}
