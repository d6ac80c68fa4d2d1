/* SPDX-License-Identifier: MIT */
/* The lobes' constants and their float64 reference with its error bound. */
#include "lobe.h"
#include "material.h"

/* c: 1, or what makes a lobe over pi with the cosine reflect exactly ks at normal view. */
static lx_bounded normalization(const struct lx_material *material)
{
    lx_bounded n = lx_exact(material->shininess), two = lx_exact(2);
    if (!material->normalized)
        return lx_exact(1);
    if (material->model == LX_PHONG)
        return lx_scale(lx_add(n, two), 0.5);
    lx_bounded above = lx_mul(lx_add(n, two), lx_add(n, lx_exact(4)));
    lx_bounded below = lx_scale(lx_add(n, lx_rounded(exp2(-material->shininess / 2), 0, 2)), 8);
    return lx_div(above, below);
}

struct lx_lobe lx_lobe_prepare(const struct lx_material *material)
{
    lx_bounded p = material->over_pi ? lx_rounded(M_1_PI, 0, 1) : lx_exact(1);
    bool shines = material->model != LX_LAMBERT;
    lx_bounded specular = lx_mul(lx_exact(material->specular), normalization(material));
    return (struct lx_lobe){
        .model = (enum lx_model)material->model,
        .highlight = (enum lx_highlight)material->highlight,
        .diffuse = lx_mul(p, lx_exact(material->diffuse)),
        .specular = shines ? lx_mul(p, specular) : lx_exact(0),
        .ambient = lx_mul(p, lx_exact(lx_material_ambient(material))),
        .exponent = material->shininess,
    };
}

struct lx_lobe lx_lobe_irradiance(void)
{
    return (struct lx_lobe){.model = LX_LAMBERT, .diffuse = lx_exact(1), .ambient = lx_exact(1)};
}

/* S^n by the cosine and the squared sine of the angle that S is the cosine of. */
static lx_bounded lobe_power(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    if (lobe->model == LX_BLINN_PHONG) {
        lx_bounded3 half = lx_unit3(lx_add3(towards, view));
        return lx_cosine_power(lx_dot3(normal, half), lx_square3(lx_cross3(normal, half)), lobe->exponent);
    }
    lx_bounded twice = lx_scale(lx_dot3(normal, towards), 2);
    lx_bounded3 mirrored = lx_sub3(lx_mul3(normal, twice), towards);
    return lx_cosine_power(lx_dot3(mirrored, view), lx_square3(lx_cross3(mirrored, view)), lobe->exponent);
}

/* w, the weight of the highlight */
static lx_bounded highlight_weight(const struct lx_lobe *lobe, lx_bounded n_dot_l)
{
    switch (lobe->highlight) {
    case LX_HIGHLIGHT_GATED: return lx_step(n_dot_l, false);
    case LX_HIGHLIGHT_COSINE: return lx_positive(n_dot_l);
    case LX_HIGHLIGHT_PLAIN: break;
    }
    return lx_exact(1);
}

struct lx_reflection lx_lobe_reflect(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view,
                                     lx_bounded3 towards)
{
    lx_bounded n_dot_l = lx_dot3(normal, towards);
    struct lx_reflection result = {.cosine = lx_positive(n_dot_l)};
    result.diffuse = lx_mul(lobe->diffuse, result.cosine);
    if (lobe->specular.value > 0)
        result.specular =
            lx_mul(lx_mul(lobe->specular, highlight_weight(lobe, n_dot_l)), lobe_power(lobe, normal, view, towards));
    return result;
}
