/* SPDX-License-Identifier: MIT */
/*
 * The light that comes to an element over mirrors: of each way (mirrors.h) what the light gives to the element's image,
 * through the outlines of the mirrors and past what stands before them on all of their sides, and a bound of what
 * comes over more mirrors than are counted.
 */
#ifndef LX_WORLD_IMAGES_H
#define LX_WORLD_IMAGES_H

#include "reference.h"

/* Adds it to what an emitter gives directly. */
void lx_add_images(const struct lx_prepared *prepared, const struct lx_element *element,
                   const struct lx_emitter *emitter, struct lx_lighting *lighting);

/* Adds to its errors what may come over more mirrors than are counted; the other of the two does so. */
void lx_add_rest(const struct lx_prepared *prepared, const struct lx_element *element, const struct lx_emitter *emitter,
                 struct lx_lighting *lighting);

#endif
