/* SPDX-License-Identifier: MIT */
/* The registry of lobes, the constants of a lobe, and what holds for any. */
#include <math.h>

#include "../base/vector.h"
#include "lobe.h"
#include "material.h"

#define LX_DECLARE_LOBE(number, lobe, name) extern const struct lx_lobe_kind lobe;
LX_MODELS(LX_DECLARE_LOBE)
LX_DIFFUSE_MODELS(LX_DECLARE_LOBE)
LX_MEASURE_MODELS(LX_DECLARE_LOBE)

#define LX_LIST_LOBE(number, lobe, name) &lobe,
const struct lx_lobe_kind *const lx_lobe_kinds[LX_LOBE_COUNT] = {LX_MODELS(LX_LIST_LOBE) LX_DIFFUSE_MODELS(LX_LIST_LOBE)
                                                                     LX_MEASURE_MODELS(LX_LIST_LOBE)};

void lx_lobe_at_set(const double normal[3], const double view[3], struct lx_lobe_at *at)
{
    at->n_dot_v = lx_dot(normal, view);
    at->normal_error = at->view_error = 0;
    for (int i = 0; i < 3; i++) {
        at->normal[i] = normal[i];
        at->view[i] = view[i];
        at->mirrored[i] = 2 * at->n_dot_v * normal[i] - view[i];
    }
}

struct lx_lobe lx_lobe_of_diffuse(const struct lx_lobe *lobe)
{
    struct lx_lobe rough = {
        .model = (enum lx_model)(LX_LAMBERT + lobe->diffuse_model),
        .highlight = LX_HIGHLIGHT_COSINE,
        .diffuse = lx_exact(0),
        .specular = lobe->diffuse,
        .ambient = lx_exact(0),
        .exponent = 1,
    };
    for (size_t i = 0; i < sizeof rough.own / sizeof rough.own[0]; i++)
        rough.own[i] = lobe->diffuse_own[i];
    return rough;
}

/* What the diffuse model makes of the material; that of Lambert is left out. */
static void prepare_diffuse(const struct lx_material *material, struct lx_lobe *lobe)
{
    lobe->diffuse_model = material->diffuse_model;
    struct lx_lobe rough = lx_lobe_of_diffuse(lobe);
    if (lx_lobe_kind_of(&rough)->prepare)
        lx_lobe_kind_of(&rough)->prepare(material, &rough);
    lobe->diffuse_model = (int)rough.model - LX_LAMBERT;
    for (size_t i = 0; i < sizeof rough.own / sizeof rough.own[0]; i++)
        lobe->diffuse_own[i] = rough.own[i];
}

const struct lx_lobe_kind *lx_diffuse_kind_of(const struct lx_material *material)
{
    return lx_lobe_kinds[LX_LAMBERT + material->diffuse_model];
}

struct lx_lobe lx_lobe_prepare(const struct lx_material *material)
{
    const struct lx_lobe_kind *kind = lx_lobe_kinds[material->model];
    const lx_bounded p = material->over_pi ? lx_rounded(M_1_PI, 0, 1) : lx_exact(1);
    const bool is_scaled = material->normalized && kind->normalization;
    const lx_bounded c = is_scaled ? kind->normalization(material->shininess) : lx_exact(1);
    const lx_bounded specular = lx_mul(p, lx_mul(lx_exact(material->specular), c));
    struct lx_lobe lobe = {
        .model = (enum lx_model)material->model,
        .highlight = (enum lx_highlight)material->highlight,
        .diffuse = lx_mul(p, lx_exact(material->diffuse)),
        .specular = kind->value ? specular : lx_exact(0),
        .ambient = lx_mul(p, lx_exact(lx_material_ambient(material))),
        .exponent = material->shininess,
    };
    prepare_diffuse(material, &lobe);
    if (kind->prepare)
        kind->prepare(material, &lobe);
    return lobe;
}

struct lx_lobe lx_lobe_irradiance(void)
{
    return (struct lx_lobe){.model = LX_LAMBERT, .diffuse = lx_exact(1), .ambient = lx_exact(1)};
}

enum lx_model lx_lobe_kernel_model(const struct lx_lobe *lobe)
{
    return lx_lobe_shines(lobe) && lx_lobe_kind_of(lobe)->power ? lobe->model : LX_LAMBERT;
}

static lx_bounded highlight_weight(const struct lx_lobe *lobe, lx_bounded n_dot_l)
{
    switch (lobe->highlight) {
    case LX_HIGHLIGHT_GATED: return lx_step(n_dot_l, false);
    case LX_HIGHLIGHT_COSINE: return lx_positive(n_dot_l);
    case LX_HIGHLIGHT_PLAIN: break;
    }
    return lx_exact(1);
}

double lx_lobe_weight(const struct lx_lobe *lobe, double n_dot_l)
{
    return highlight_weight(lobe, lx_exact(n_dot_l)).value;
}

struct lx_reflection lx_lobe_reflect(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view,
                                     lx_bounded3 towards)
{
    const lx_bounded n_dot_l = lx_dot3(normal, towards);
    struct lx_reflection result = {.cosine = lx_positive(n_dot_l)};
    result.diffuse = lx_mul(lobe->diffuse, result.cosine);
    if (lx_lobe_is_rough(lobe)) {
        const struct lx_lobe rough = lx_lobe_of_diffuse(lobe);
        result.diffuse = lx_mul(result.diffuse, lx_lobe_kind_of(&rough)->value(&rough, normal, view, towards));
    }
    if (lx_lobe_shines(lobe))
        result.specular = lx_mul(lx_mul(lobe->specular, highlight_weight(lobe, n_dot_l)),
                                 lx_lobe_kind_of(lobe)->value(lobe, normal, view, towards));
    return result;
}

/* A vector of which each part may be off by so much. */
static lx_bounded3 bounded(const double a[3], double error)
{
    return (lx_bounded3){{a[0], error}, {a[1], error}, {a[2], error}};
}

double lx_lobe_log(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                   double *error)
{
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    if (kind->log_value)
        return kind->log_value(lobe, at, towards, moved, error);
    const lx_bounded value = kind->value(lobe, bounded(at->normal, at->normal_error), bounded(at->view, at->view_error),
                                         bounded(towards, moved + DBL_EPSILON));
    *error = value.value > 0 ? value.error / value.value : 0;
    return value.value > 0 ? log(value.value) : -HUGE_VAL;
}

size_t lx_lobe_peaks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                     double tau[LX_MOST_PEAKS])
{
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    if (kind->peaks)
        return kind->peaks(lobe, at, a, b, tau);
    tau[0] = atan2(lx_dot(at->mirrored, b), lx_dot(at->mirrored, a));
    return 1;
}

size_t lx_lobe_kinks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, struct lx_border kinks[LX_MOST_KINKS])
{
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    return kind->kinks ? kind->kinks(at, kinks) : 0;
}
