/* SPDX-License-Identifier: MIT */
/*
 * What can be said of a mesh as a body: edges that are not shared by two faces, faces that look the wrong way, parts,
 * volume; and which meshes a scene uses for what.
 */
#ifndef LX_FORMAT_MESH_SURVEY_H
#define LX_FORMAT_MESH_SURVEY_H

#include "mesh.h"

/* A mesh as a body. */
struct lx_mesh_survey {
    size_t triangles, corners, edges;
    size_t open, crowded, flipped; /* edges of one face, of more than two, of two that run along it the same way */
    struct lx_mesh_origin open_at, crowded_at, flipped_at;
    size_t turned_faces; /* that look to the other side than most of the faces that they go on with */
    struct lx_mesh_origin turned_at;
    bool is_one_sided; /* faces go on with each other so that no two sides could be told, as of a Moebius strip */
    double volume;     /* in cubes of the file's unit, above 0 where its faces look outwards */
    long euler;        /* corners - edges + faces */
    size_t parts;      /* that share no edge */
};

/* False: memory ran out. */
bool lx_survey_mesh(const struct lx_mesh *mesh, struct lx_mesh_survey *survey);

static inline bool lx_is_closed(const struct lx_mesh_survey *survey)
{
    return survey->open == 0 && survey->crowded == 0;
}

/* A mesh that parameters name: their key, the file as it stands there, how long a unit of it is, and its survey where
 * one was made already. */
struct lx_mesh_use {
    const char *key, *file;
    const struct lx_mesh *mesh;
    double scale_mm;
    const struct lx_mesh_survey *survey;
};

#endif
