/* SPDX-License-Identifier: MIT */
/*
 * Meshes that a committed scene reads from files, as surfaces and as bodies of volume sources: how many triangles,
 * whether they close, how large.
 *
 * Threads: these functions only read the scene; several threads may call them at once.
 */
#ifndef LUXEL_MESH_H
#define LUXEL_MESH_H

#include <luxel/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a mesh is as a body.  Its texts are the scene's and last until that changes. */
typedef struct luxel_mesh_survey {
    const char *key;        /* that names the file: "file" of a surface, "mesh" of a light */
    const char *file;       /* as the scene names it */
    size_t triangles;       /* into which its faces are cut */
    size_t corners;         /* at different places */
    size_t edges;           /* between them */
    size_t open_edges;      /* of one face alone */
    size_t crowded_edges;   /* of more than two faces */
    bool is_closed;         /* none is open or crowded: it bounds a body */
    long euler_number;      /* corners - edges + faces: 2 of what is like a ball, 0 of what is like a ring */
    size_t parts;           /* that share no edge */
    size_t flipped_faces;   /* that look to the other side than most of the faces that they go on with */
    unsigned first_flipped; /* the number of the first one in the file, from 1 on; 0: there is none */
    bool is_one_sided;      /* no two sides can be told, as of a Moebius strip */
    double volume_mm3;      /* below 0 where its faces look inwards; NaN unless it is closed and no face is flipped */
    double scale_mm;        /* how long a unit of the file is */
    double size_mm[3];      /* the sides of the box around it, along the axes of the file */
} luxel_mesh_survey;

/*
 * Surveys the mesh of surface i.  *is_mesh: whether it reads one; else *survey is left as it was.
 * LUXEL_ERROR_ARGUMENT: not committed, no such surface, or a pointer is NULL.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_surface_mesh(const luxel_scene *scene, size_t i, bool *is_mesh,
                                                luxel_mesh_survey *survey);
/* The same of light i, whose body it is. */
LUXEL_API luxel_status luxel_scene_light_mesh(const luxel_scene *scene, size_t i, bool *is_mesh,
                                              luxel_mesh_survey *survey);

#ifdef __cplusplus
}
#endif
#endif
