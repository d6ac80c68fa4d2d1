/* SPDX-License-Identifier: MIT */
/*
 * Luminaires over squares of pixels.  Their tables have a kink at every line, so no polynomial takes their place; but
 * what one would give if it shone evenly is as smooth as the light of a point, and so are the angles under which it
 * sees the square, as long as its axis is not near.  These are polynomials, good to what the table makes of them, and
 * each pixel looks up its cell by them (kernel_tabled.h; docs/MATHS.md, "Squares of a picture").
 *
 * Luminaires whose light jumps within the square, sets there, or is hidden from some of it are left, as are those that
 * stand too near, or over whose axis the square lies.
 */
#ifndef LX_PICTURE_TABLED_H
#define LX_PICTURE_TABLED_H

#include "../../kernel/kernel.h"
#include "../lights.h"
#include "smooth_lights.h"
#include "smooth_plan.h"
#include "vicinity.h"

struct lx_fitting;
struct lx_shader_memory;

void lx_table_bases_make(struct lx_basis *bases);

/* 0, or -1 when memory ran out.  Clear them in any case. */
int lx_luminaires_make(const struct lx_planned_surface *surface, struct lx_luminaires *made);
void lx_luminaires_clear(struct lx_luminaires *luminaires);

/* Errors that luminaires over a square may have: as functions, and by roundings. */
struct lx_allowance {
    double error, rounding;
};

/* Where to add light: to so many rows and columns of the square. */
struct lx_square_values {
    unsigned rows, columns;
    float *values;
    size_t stride;
};

/*
 * Adds to the values over a square the light of those luminaires that are left and that polynomials do for, which are
 * left no more; `allowance` is lessened by what they may be off by.  How many they are.  The elements that the shader
 * has seen are lost.
 */
size_t lx_add_tabled(const struct lx_plan *plan, struct lx_fitting *fitting, struct lx_shader_memory *shader,
                     const struct lx_square *square, const struct lx_square_values *to, struct lx_allowance *allowance);

#endif
