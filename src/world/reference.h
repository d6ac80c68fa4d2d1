/* SPDX-License-Identifier: MIT */
/*
 * The reference: the light of one emitter on one surface element, in float64 with an error bound.  Probes are
 * made of it, and the kernels are tested against it.
 */
#ifndef LX_WORLD_REFERENCE_H
#define LX_WORLD_REFERENCE_H

#include <luxel/probe.h>

#include "../light/sky/dome.h"
#include "element.h"
#include "open_domes.h"
#include "prepared.h"

struct lx_occlusion;

/* What is seen through a screen point, in mirrors, too; false: nothing. */
bool lx_element_seen(const struct lx_prepared *prepared, double x_mm, double y_mm, struct lx_element *element);

/* The free element at a place that is one.  Its surface is that which it lies on, the first where surfaces meet. */
struct lx_element lx_element_at(const struct lx_prepared *prepared, const luxel_place *place);

/* The element of a surface that has a chart, at coordinates of that. */
struct lx_element lx_element_on(const struct lx_prepared *prepared, size_t surface, const double at[3]);

/* Whether those coordinates are the direction, of any length but 0, of the normal: so with spheres alone. */
bool lx_is_by_normal(const struct lx_prepared *prepared, size_t surface);

/* Farther from a place than all that may stand in its way, in mm: a power of two, for which directions stay what they
 * are. */
double lx_beyond_all(const struct lx_prepared *prepared, const double place_mm[3]);

/* 1 where the way from the element to a point or in a direction is free, 0 where a surface stands in it. */
lx_bounded lx_openness_of(const struct lx_prepared *prepared, const struct lx_element *element,
                          const struct lx_emitter *emitter);

/* 1 where one surface stands in that way, 0 where it does not; it is not asked whether the scene has shadows. */
lx_bounded lx_hidden_by(const struct lx_prepared_surface *surface, const struct lx_element *element,
                        const struct lx_emitter *emitter);

/* Whether a shape, the element's own or another, stands in a way from the element: 1 or 0. */
lx_bounded lx_blocked_by(const struct lx_shape *shape, bool is_own, const struct lx_element *element, lx_bounded3 way,
                         bool endless);

/* The panes that its light may come through, where what stands in the way counts; of a room that is left out, none. */
void lx_set_panes(const struct lx_prepared *prepared, struct lx_emitter *emitter);

/* What obstacles (NULL: nothing) leave of an extended emitter, by its borders; false: these are not known to the
 * tolerance.  `before`: irradiance of other parts of the same emitter, relative to which the tolerance is, too. */
bool lx_light_by_borders(const struct lx_prepared *prepared, const struct lx_element *element,
                         const struct lx_emitter *emitter, const struct lx_occlusion *occlusion, double before,
                         struct lx_lighting *lighting);

/* All that an extended emitter gives: in closed form or by borders, else by integrals, to the tolerance. */
struct lx_lighting lx_light_around(const struct lx_prepared *prepared, const struct lx_element *element,
                                   const struct lx_emitter *emitter, struct lx_occlusion *occlusion, double before);

/* And with what stands before it.  `is_open`: not NULL where somebody knows what it gives if nothing does; that is then
 * told, and nothing else. */
struct lx_lighting lx_light_by_extended(const struct lx_prepared *prepared, const struct lx_element *element,
                                        const struct lx_emitter *emitter, double before, bool *is_open);

/* What an extended emitter gives behind obstacles, beside the irradiance that came before it; where that is not known
 * to the tolerance, between what there can be. */
struct lx_lighting lx_light_behind(const struct lx_prepared *prepared, const struct lx_element *element,
                                   const struct lx_emitter *emitter, struct lx_occlusion *occlusion, double before);

/* Without what comes over mirrors, and with it. */
struct lx_lighting lx_light_directly(const struct lx_prepared *prepared, const struct lx_element *element,
                                     const struct lx_emitter *emitter);
struct lx_lighting lx_light_element(const struct lx_prepared *prepared, const struct lx_element *element,
                                    const struct lx_emitter *emitter);

#endif
