/* SPDX-License-Identifier: MIT */
/* Squares of the pictures of random scenes, what they are fitted with, and complex places of the screen around them. */
#ifndef TESTS_UNIT_SQUARES_H
#define TESTS_UNIT_SQUARES_H

#include <complex.h>

#include "picture/polynomial/panels.h"
#include "picture/polynomial/smooth_gloss.h"
#include "random_scenes.h"

/* A random scene of one surface, seen so finely that squares fit, without shadows, and a place for a source, so far
 * from the surface in a direction: of a plate in front of it. */
void make_finer_scene(struct randomness *random, bool is_plate, struct test_scene *test, double direction[3],
                      double center[3]);

/* What squares are fitted with. */
struct workplace {
    struct lx_plan plan;
    struct lx_shader_memory *shader;
    struct lx_fitting fitting;
};

/* False: the picture is not shaded by panels. */
bool open_workplace(const struct test_scene *test, const struct lx_kernels *kernels, struct workplace *work);
void close_workplace(struct workplace *work);

struct vector {
    double complex x, y, z;
};

double complex dot(struct vector a, struct vector b);
struct vector plus(struct vector a, double complex times, struct vector b);
struct vector unit(struct vector a);
struct vector cross(struct vector a, struct vector b);
struct vector vector_of(const double a[3]);
struct vector across(struct vector a, struct vector axis); /* the part of a that is across a unit vector */
double length_of_real(struct vector a);

/* The surface through a place on the screen, from its anchor: as surface/sphere.c and rectangle.c find it. */
struct vector place_at(const struct lx_plan *plan, double complex x, double complex y, struct vector *normal);
struct vector view_at(const struct lx_plan *plan, struct vector place);

/* a(r) where r^2 is `square`. */
double complex attenuated(const struct lx_area_light_law *law, double complex square);

/* What a body shows of its place with the coordinates s and t of struct lx_patch, from 0 to 1. */
struct seen_place {
    struct vector from_center;
    double complex e; /* E_perp that it gives for a unit of s, t and the radiance, times the square of the way */
};

/* A place of a cylinder's side (round_view.h). */
struct seen_place seen_of_side(const struct lx_area_light *lamp, struct vector place, double s, double t);

/* The irradiance by a cylinder of the radiance 1: its side, and the end that is seen from the middle of the square. */
double complex irradiance_by_cylinder(const struct lx_area_light *lamp, const struct lx_vicinity *at,
                                      struct vector place, struct vector normal);

/* What is tried of squares of random scenes. */
struct campaign {
    int scenes;  /* how many as a rule (campaign.h) */
    int squares; /* of each picture that is shaded by panels */
    uint64_t seed;
    void (*make)(int i, struct test_scene *test);
    void (*clear)(struct test_scene *test); /* NULL: there is nothing to clear */
    void (*visit)(const struct test_scene *test, struct workplace *work, const struct lx_square *square, int q,
                  struct randomness *random, void *data);
};

/* Visits squares, each with its number q, by the kernels of an instruction set; or by all that the machine has: every
 * scene by the best of them, each tenth by the others. */
void visit_squares(const struct campaign *campaign, const struct lx_kernels *kernels, void *data);
void visit_by_all_sets(const struct campaign *campaign, void *data);

/* By a light all of which falls on such a place: E_perp, N.L, and what the power of the highlight is of. */
struct falling {
    double complex e, cosine, s;
};

struct falling falling_at(const struct lx_plan *plan, const struct lx_light_double *light, double complex x,
                          double complex y);
/* What falls on a place along a way, or in a direction, from there. */
struct falling falling_along(const struct lx_plan *plan, struct vector way, double complex e, struct vector place,
                             struct vector normal);

/* A place on the ellipse, or in it, on one axis, and in the square on the other. */
void random_place(struct randomness *random, const struct lx_square *square, const struct lx_basis *basis,
                  double complex place[2]);

/* The brightness by something there above the horizon, or below it where it `is_dark`. */
typedef double complex brightness_by(const struct lx_plan *plan, const struct lx_lobe_double *lobe, const void *light,
                                     bool is_dark, bool has_highlight, double complex x, double complex y);
double complex brightness_of(const struct lx_lobe_double *lobe, struct falling falling, bool is_dark,
                             bool has_highlight);

/* Checks the size that lx_bound_smooth() promises, finite and not 0, at such a place: of something that stands about
 * where a light does; and of a light. */
void check_size_by(const struct lx_plan *plan, const struct lx_lobe_double *lobe, brightness_by *by, const void *what,
                   const struct lx_light_double *about, double size, const struct lx_vicinity *at,
                   const struct lx_square *square, const struct lx_basis *basis, struct randomness *random);
void check_size(const struct lx_plan *plan, const struct lx_lobe_double *lobe, const struct lx_light_double *light,
                double size, const struct lx_vicinity *at, const struct lx_square *square, const struct lx_basis *basis,
                struct randomness *random);

#endif
