/* SPDX-License-Identifier: MIT */
/*
 * Kinds of lights.  A kind describes its authored parameters by a table and lowers them to emitters, so that
 * kernels and references exist once per emitter and not once per light.  To add a kind: a file like
 * distant.c, and a line in registry.c.
 */
#ifndef LX_LIGHT_LIGHT_H
#define LX_LIGHT_LIGHT_H

#include <luxel/photometry.h>

#include "../format/mesh/mesh_survey.h"
#include "../parameter/table.h"
#include "emitter.h"

struct lx_light_kind {
    struct lx_variant variant; /* first, so that a variant of the list `lights` is its kind */
    /* Appends the emitters that this light is made of; 0, or -1 when memory ran out.  Pure. */
    int (*prepare)(const void *parameters, struct lx_emitters *emitters);
    /* The greatest length of what shines as one point, 0 where it is one; NULL: so are all of them. */
    double (*opening_mm)(const void *parameters);
    /* The content of the photometry file that parameters name, and its name.  NULL: they name none. */
    const luxel_photometry *(*photometry)(const void *parameters, const char **file);
    /* The mesh that parameters name, where they do.  NULL: never. */
    bool (*mesh)(const void *parameters, struct lx_mesh_use *use);
    /* Its light comes from beyond all surfaces, and no maintenance factor weakens it. */
    bool is_daylight;
};

/* NULL-terminated: the variants of the list `lights`. */
extern const struct lx_variant *const lx_light_variants[];

#endif
