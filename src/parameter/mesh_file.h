/* SPDX-License-Identifier: MIT */
/* Files of meshes that a scene names, for the check() of whoever uses them. */
#ifndef LX_PARAMETER_MESH_FILE_H
#define LX_PARAMETER_MESH_FILE_H

#include "../format/mesh/mesh.h"
#include "check.h"

/*
 * The mesh of the file that the value of `key` names, which the caller releases: read unless the scene has done so
 * already, and then *is_new; it is to be kept with lx_check_keep_mesh().  NULL: it cannot be read, which is reported.
 */
struct lx_mesh *lx_check_mesh(const struct lx_check *check, const char *key, const char *path, bool *is_new);
void lx_check_keep_mesh(const struct lx_check *check, const char *path, struct lx_mesh *mesh);

/* Advice on what was left out of it. */
void lx_check_advise_mesh(const struct lx_check *check, const char *key, const char *file, const struct lx_mesh *mesh);

/* Advice where the longest side is not between two sizes in mm, but would be in another unit. */
void lx_check_advise_mesh_size(const struct lx_check *check, const char *key, const struct lx_mesh *mesh,
                               double scale_mm, double least_mm, double most_mm);

#endif
