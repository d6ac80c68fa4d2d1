/* SPDX-License-Identifier: MIT */
/*
 * Lobes: the prepared constants of a material, and what there is to know of how it reflects one light sample:
 *
 *     brightness = E_perp (diffuse max(0, N.L) + specular w f(N, V, L)),   ambient light: ambient E
 *
 * The factors hold p, kd, ks, ka and c of the material; w is the highlight's weight, 1, 1 above the horizon or
 * max(0, N.L); f is the model's, in one file each with the source of its formula: it is not negative, and it is all
 * that a model without a diffuse part has.  Most are powers S^n of a cosine, which kernels and their bounds know
 * (struct lx_power_lobe); any other f is summed by the reference alone.  A diffuse part that is not Lambert's is such
 * an f, too, D of its diffuse model: it is a lobe of its own (lx_lobe_of_diffuse()), and N.L above is D N.L.
 *
 * Whoever wants to know something of a lobe asks here.  N, V and L are unit vectors: the normal, the way to the
 * observer, the way to the light; M is V mirrored at N.  Angles are in radians.
 */
#ifndef LX_MATERIAL_LOBE_H
#define LX_MATERIAL_LOBE_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/bounded.h"
#include "model.h"

struct lx_material;

struct lx_lobe {
    enum lx_model model;
    enum lx_highlight highlight;
    lx_bounded diffuse, specular, ambient;
    double exponent;   /* n */
    double own[3];     /* the model's to use */
    int diffuse_model; /* 0: Lambert's; else LX_LAMBERT and so many */
    double diffuse_own[3];
};

/* An element as a lobe sees it. */
struct lx_lobe_at {
    double normal[3], view[3], mirrored[3]; /* N, V, M */
    double n_dot_v;
    double normal_error, view_error; /* how far N and V are off at most */
};

void lx_lobe_at_set(const double normal[3], const double view[3], struct lx_lobe_at *at);

/* The most peaks that a lobe may have on a great circle, and the most planes on which it may have kinks. */
enum { LX_MOST_PEAKS = 4, LX_MOST_KINKS = 2 };

/* The plane g.L = limit. */
struct lx_border {
    double g[3], limit;
};

/*
 * Lobes f = S^n, S the cosine between two unit vectors: those that kernels are compiled for.  `half` is the length of
 * L + V, of which some know how fast S turns.
 */
struct lx_power_lobe {
    /* The vectors that S is the cosine between; pair[moving] is the one that depends on L. */
    void (*pair)(lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards, lx_bounded3 pair[2]);
    int moving;
    bool asks_half;         /* whether the error depends on `half` */
    double turns_of_normal; /* how far S's angle turns where N does by 1 */

    /* No S^2 is greater for an L whose angle to M has the cosine `cosine`. */
    double (*greatest_square)(double cosine);

    /* The least angle that S is the cosine of for L within an angle `spread` of a direction. */
    double (*least_angle)(const struct lx_lobe_at *at, const double towards[3], double spread);

    /* How wide S^n is as an angle of L, 1/sqrt(n) being the width as one of S's. */
    double (*width)(double exponent, double half);

    /* How far S's angle is off, in float32 with the unit roundoff `unit`, where L is off by `off`. */
    double (*angle_error)(double off, double half, double unit);
};

/* How a model is explained: formulas in the subset of LaTeX that documents know. */
struct lx_lobe_words {
    const char *definition; /* what f is made of; NULL: nothing */
    const char *brightness; /* B = p E_perp times this, */
    const char *normalized; /* and where it is normalised; NULL: it never is */
    const char *constant;   /* c, where it is normalised */
    const char *vector;     /* of a power: its moving vector, and S */
    const char *cosine;
    const char *step; /* of any other f: what it gives, "B_s = ... = ", as E_perp, the factor, w and f follow; of a
                       * diffuse model "D = ... = ", as D follows */
};

struct lx_lobe_kind {
    struct lx_lobe_words words;

    /* Whether all that it reflects but f is Lambert's with the reflectance kd, so that reflections know it. */
    bool is_lambertian;

    /* The greatest kd that a diffuse model has a meaning for; 0: any. */
    double most_diffuse;

    /* Changes what is otherwise than p kd, p ks c, p ka, n and w of the material, which stand there.  NULL: nothing. */
    void (*prepare)(const struct lx_material *material, struct lx_lobe *lobe);

    /* c: what makes a lobe over pi with the cosine reflect exactly ks at normal view. */
    lx_bounded (*normalization)(double exponent);

    /* The integral of D max(0, N.L)/pi, of a diffuse model, over all L above the horizon, for N.V. */
    double (*albedo)(const struct lx_lobe *lobe, double n_dot_v);

    /* f, with the error that it has by those of the vectors; NULL: it has no highlight. */
    lx_bounded (*value)(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards);

    /* The logarithm of f for an L that is off by `moved`; -HUGE_VAL where f = 0; *error: of f, relative.  NULL: by
     * the value. */
    double (*log_value)(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                        double *error);

    /* Where f may have peaks on the great circle of directions a cos(tau) + b sin(tau), a and b units: sets at most
     * LX_MOST_PEAKS of these tau.  NULL: at what is nearest to M. */
    size_t (*peaks)(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                    double tau[LX_MOST_PEAKS]);

    /* Planes on which f is continuous, but its slope is not; their number.  NULL: there are none. */
    size_t (*kinks)(const struct lx_lobe_at *at, struct lx_border kinks[LX_MOST_KINKS]);

    /* The vector g for which f = 0 where g.L <= *limit.  NULL: f ends nowhere but at the horizon. */
    const double *(*end)(const struct lx_lobe_at *at, double *limit);

    const struct lx_power_lobe *power; /* NULL: f is no such power */
};

/* The tables, by model. */
extern const struct lx_lobe_kind *const lx_lobe_kinds[LX_LOBE_COUNT];

static inline const struct lx_lobe_kind *lx_lobe_kind_of(const struct lx_lobe *lobe)
{
    return lx_lobe_kinds[lobe->model];
}

/* The power that a model's highlight is; NULL: it is none. */
static inline const struct lx_power_lobe *lx_power_lobe_of(enum lx_model model)
{
    return lx_lobe_kinds[model]->power;
}

/* The operations of a material's diffuse model, Lambert's too. */
const struct lx_lobe_kind *lx_diffuse_kind_of(const struct lx_material *material);

struct lx_lobe lx_lobe_prepare(const struct lx_material *material);

/* The lobe that makes the irradiance itself: diffuse and ambient 1, no highlight. */
struct lx_lobe lx_lobe_irradiance(void);

/* Whether its diffuse part is not Lambert's; and that as a lobe of its own, whose highlight it is. */
static inline bool lx_lobe_is_rough(const struct lx_lobe *lobe)
{
    return lobe->diffuse_model != 0;
}
struct lx_lobe lx_lobe_of_diffuse(const struct lx_lobe *lobe);

/* Whether there is any highlight. */
static inline bool lx_lobe_shines(const struct lx_lobe *lobe)
{
    return lobe->specular.value > 0;
}

/* Whether light from below the horizon makes a highlight. */
static inline bool lx_lobe_reaches_below(const struct lx_lobe *lobe)
{
    return lx_lobe_shines(lobe) && !LX_ENDS_AT_HORIZON(lobe->highlight);
}

/* Whether kernels can sum it; else the reference has to. */
static inline bool lx_lobe_has_kernels(const struct lx_lobe *lobe)
{
    return !lx_lobe_is_rough(lobe) && (!lx_lobe_shines(lobe) || lx_lobe_kind_of(lobe)->power);
}

/* The model by which kernels sum it: without a highlight, or with one that they do not know, that of a lobe that has
 * none. */
enum lx_model lx_lobe_kernel_model(const struct lx_lobe *lobe);

/* w, for N.L */
double lx_lobe_weight(const struct lx_lobe *lobe, double n_dot_l);

/* log_value, peaks and kinks of any lobe. */
double lx_lobe_log(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                   double *error);
size_t lx_lobe_peaks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                     double tau[LX_MOST_PEAKS]);
size_t lx_lobe_kinks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, struct lx_border kinks[LX_MOST_KINKS]);

/* What a lobe makes of light from L (unit), for the normal N and view V (units). */
struct lx_reflection {
    lx_bounded cosine;            /* max(0, N.L) */
    lx_bounded diffuse, specular; /* brightness for each unit of E_perp */
};

struct lx_reflection lx_lobe_reflect(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view,
                                     lx_bounded3 towards);

#endif
