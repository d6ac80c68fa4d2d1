/* SPDX-License-Identifier: MIT */
/* What the meshes of a scene are as bodies, as luxel check tells it. */
#ifndef LUXEL_CLI_MESHES_H
#define LUXEL_CLI_MESHES_H

#include <luxel/mesh.h>

#include "json.h"

/* A mesh and where it is named. */
struct mesh {
    bool of_light;
    bool is_repeated; /* one before it is of the same file and scale */
    size_t index;     /* in the list */
    luxel_mesh_survey survey;
};

/* Zero-initialise, and clear.  They last until the scene changes. */
struct meshes {
    struct mesh *list;
    size_t count, capacity;
};

/* Surveys those of all surfaces, then of all lights.  False: memory ran out. */
bool meshes_gather(const luxel_scene *scene, struct meshes *meshes);
void meshes_clear(struct meshes *meshes);

/* Prints each file once, at the place where it is named first with that scale. */
void meshes_print(const struct meshes *meshes);

/* Writes all of them as the member `meshes`. */
void meshes_write(struct json *json, const struct meshes *meshes);

#endif
