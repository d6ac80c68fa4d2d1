/* SPDX-License-Identifier: MIT */
/*
 * Meshes that a committed scene reads from files, as surfaces and as bodies of volume sources: how many triangles,
 * whether they close, how large; and what surfaces look like from afar.
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
    void *reserved[4];      /* for later versions: NULL */
} luxel_mesh_survey;

/*
 * Surveys the mesh of surface i.  *is_mesh: whether it reads one; else *survey is left as it was.
 * LUXEL_ERROR_ARGUMENT: not committed, no such surface, or a pointer is NULL.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_surface_mesh(const luxel_scene *scene, size_t i, bool *is_mesh,
                                                luxel_mesh_survey *survey);
/* The mesh that is the body of light i, likewise. */
LUXEL_API luxel_status luxel_scene_light_mesh(const luxel_scene *scene, size_t i, bool *is_mesh,
                                              luxel_mesh_survey *survey);

/* A closed line of a silhouette, the last place of which is joined to the first one. */
typedef struct luxel_silhouette_line {
    const double (*places_mm)[2]; /* along `right` and `up` from the origin of the scene */
    size_t count;                 /* of the places */
} luxel_silhouette_line;

/* The part of a plane that a surface covers: lines run counter-clockwise around it, and clockwise around its holes. */
typedef struct luxel_silhouette {
    const luxel_silhouette_line *lines; /* count of them */
    size_t count;                       /* of the lines */
} luxel_silhouette;

/*
 * Finds the silhouette of surface i as it is seen from afar, `right` and `up` being unit vectors at right angles to
 * each other, such as {1, 0, 0} and {0, 1, 0} for a plan; of a room or a box a line around each side.  It is for
 * drawings: lines lie at most 0.3 % of the longer side beside a mesh, of which no part is left out, however thin (a
 * million triangles take some 0.3 s), and less beside others.  It is the caller's: luxel_silhouette_free() frees it.
 * LUXEL_ERROR_ARGUMENT: not committed, no such surface, no such vectors, or a pointer is NULL.
 * LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_find_silhouette(const luxel_scene *scene, size_t i, const double right[3],
                                             const double up[3], luxel_silhouette **silhouette);
/* Frees a silhouette; NULL is harmless. */
LUXEL_API void luxel_silhouette_free(luxel_silhouette *silhouette);

#ifdef __cplusplus
}
#endif
#endif
