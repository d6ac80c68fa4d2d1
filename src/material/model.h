/* SPDX-License-Identifier: MIT */
/*
 * The list of models, how a highlight is weighted, and which of them kernels have loops of their own for; numbers
 * alone, so that kernels may include it.  What else there is to know of a model, its lobe tells (lobe.h).
 */
#ifndef LX_MATERIAL_MODEL_H
#define LX_MATERIAL_MODEL_H

/* A model is a line here: its number, its table of operations, and its name in scenes. */
#define LX_MODELS(X)                                                                                                   \
    X(LX_BLINN_PHONG, lx_blinn_phong_lobe, "blinn-phong")                                                              \
    X(LX_PHONG, lx_phong_lobe, "phong")                                                                                \
    X(LX_GGX, lx_ggx_lobe, "ggx")                                                                                      \
    X(LX_LAMBERT, lx_lambert_lobe, "lambert")

/* So is a model of a diffuse part other than Lambert's, which is a lobe of its own with the weight N.L. */
#define LX_DIFFUSE_MODELS(X)                                                                                           \
    X(LX_OREN_NAYAR, lx_oren_nayar_lobe, "oren-nayar")                                                                 \
    X(LX_EON, lx_eon_lobe, "eon")

/* A lobe that is no material's: the measures of light at a place (measure.h). */
#define LX_MEASURE_MODELS(X) X(LX_MEASURE, lx_measure_lobe, "measure")

#define LX_MODEL_NUMBER(number, lobe, name) number,
enum lx_model {
    LX_MODELS(LX_MODEL_NUMBER) LX_DIFFUSE_MODELS(LX_MODEL_NUMBER) LX_MEASURE_MODELS(LX_MODEL_NUMBER) LX_LOBE_COUNT
};
#undef LX_MODEL_NUMBER

enum lx_highlight { LX_HIGHLIGHT_PLAIN, LX_HIGHLIGHT_GATED, LX_HIGHLIGHT_COSINE };

/*
 * The questions that kernels ask a lobe.  These are macros, as the order in which compilers fold what they know decides
 * which products and sums they contract, and so on the last bits of pictures.
 *
 * Whether a kernel's lobe has a highlight; whether S of that is N.H, of the half vector, or R.V, of the mirrored ray.
 */
#define LX_HAS_HIGHLIGHT(model) ((model) != LX_LAMBERT)
#define LX_IS_BY_HALF(model) ((model) == LX_BLINN_PHONG)
#define LX_IS_BY_MIRROR(model) ((model) == LX_PHONG)

/* Whether a highlight ends at the horizon, N.L = 0; whether it jumps there, or falls with N.L. */
#define LX_ENDS_AT_HORIZON(highlight) ((highlight) != LX_HIGHLIGHT_PLAIN)
#define LX_JUMPS_AT_HORIZON(highlight) ((highlight) == LX_HIGHLIGHT_GATED)
#define LX_FALLS_TO_HORIZON(highlight) ((highlight) == LX_HIGHLIGHT_COSINE)

/* The weight by which kernels are chosen: a lobe without a highlight has none. */
#define LX_KERNEL_WEIGHT(model, highlight) (!LX_HAS_HIGHLIGHT(model) ? LX_HIGHLIGHT_PLAIN : (highlight))

/* The lobes that kernels have loops of their own for: X(model, weight, when), where the first that is so is it. */
#define LX_KERNEL_LOBES(X, model, highlight)                                                                           \
    X(LX_LAMBERT, LX_HIGHLIGHT_PLAIN, (model) == LX_LAMBERT)                                                           \
    X(LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, (model) == LX_BLINN_PHONG && (highlight) == LX_HIGHLIGHT_PLAIN)              \
    X(LX_BLINN_PHONG, LX_HIGHLIGHT_GATED, (model) == LX_BLINN_PHONG && (highlight) == LX_HIGHLIGHT_GATED)              \
    X(LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, (model) == LX_BLINN_PHONG)                                                  \
    X(LX_PHONG, LX_HIGHLIGHT_PLAIN, (highlight) == LX_HIGHLIGHT_PLAIN)                                                 \
    X(LX_PHONG, LX_HIGHLIGHT_GATED, (highlight) == LX_HIGHLIGHT_GATED)                                                 \
    X(LX_PHONG, LX_HIGHLIGHT_COSINE, 1)

/* Those with a loop over directions none of which is below the horizon: a highlight that jumps there is plain. */
#define LX_KERNEL_BEAMS(X, model, by_cosine)                                                                           \
    X(LX_BLINN_PHONG, LX_HIGHLIGHT_COSINE, (model) == LX_BLINN_PHONG && (by_cosine))                                   \
    X(LX_BLINN_PHONG, LX_HIGHLIGHT_PLAIN, (model) == LX_BLINN_PHONG)                                                   \
    X(LX_PHONG, LX_HIGHLIGHT_COSINE, (by_cosine))                                                                      \
    X(LX_PHONG, LX_HIGHLIGHT_PLAIN, 1)

#endif
