/* SPDX-License-Identifier: MIT */
/*
 * Meshes in files: OFF, OBJ, PLY, STL and glTF 2.0.  What is read is only what files tell, corners, faces and perhaps
 * normals; whether they make a body is for others to say.
 *
 * OFF   the word OFF in any case, perhaps with the letters ST, C, N before it, of whose further numbers those of N are
 *       normals (in a file named *.off it may be missing); the numbers of corners, faces and edges; the corners; for
 *       each face the number of its corners and their indexes from 0 on.  Corners and faces stand on lines of their
 *       own, and what else stands there is passed over; or all is anywhere, and then there is nothing else.
 * OBJ   v x y z, vn x y z, and f with the numbers of corners from 1 on, or from -1 down for the last ones before it,
 *       perhaps as v/vt/vn; other statements are passed over.  Free-form surfaces are refused.
 * PLY   text or binary of either byte order: vertex with x, y, z and perhaps nx, ny, nz; face with a list
 *       vertex_indices or vertex_index.  Other elements and properties are passed over.
 * STL   text or binary, which the size tells from a text that begins with "solid", too.  Its normals are not used.
 * glTF  JSON, or binary (.glb); its buffers may be files of their own (mesh_gltf.c).
 *
 * In texts # begins a comment, lines end in LF, CR LF or CR, and a byte order mark or UTF-16 are understood.
 */
#ifndef LX_FORMAT_MESH_H
#define LX_FORMAT_MESH_H

#include <limits.h>

#include "../../base/diagnostics.h"
#include "../kept.h"

enum { LX_LARGEST_MESH = 1 << 30, LX_MOST_FACES = 10000000, LX_MOST_CORNERS = 30000000 };

/* The normal's number of a corner that has none. */
#define LX_NO_NORMAL UINT_MAX

/* Where a face comes from: its number in the file, from 1 on, and its line; 0 in files without lines. */
struct lx_mesh_origin {
    unsigned number, line;
};

/* What was left out, and the line where it was for the first time. */
struct lx_mesh_note {
    unsigned count, line;
};

/* What surfaces make of a mesh, each kept with it. */
enum lx_mesh_made { LX_MESH_TREE, LX_MESH_NORMALS, LX_MESH_MADE };

/* Corners at the same place are one; those of no face are left out. */
struct lx_mesh {
    struct lx_kept kept;
    double (*corners)[3];
    size_t corner_count;
    unsigned *loop;   /* the corners of all faces, one face behind the other */
    unsigned *counts; /* of corners in each face */
    struct lx_mesh_origin *origins;
    size_t face_count;
    double (*normals)[3]; /* of any length but 0 */
    size_t normal_count;
    unsigned *turns;                   /* the normal of each corner of the loop; NULL: there are none */
    unsigned face_total;               /* of the file, with those that were left out */
    double rounding;                   /* half a unit of the last digit of its places; 0: all are whole numbers */
    double unit_mm;                    /* what the format says that a unit is; 0: nothing */
    struct lx_mesh_note thin, doubled; /* faces of fewer than 3 corners, and those that were there before */
    struct lx_mesh_note others;        /* points and lines of OBJ files */
    struct lx_mesh_note lost_normals;  /* normals that faces name but that are not there */
    struct lx_mesh_note uncounted;     /* triangles of STL files that announce another number */
    struct lx_mesh_note bytes_behind;  /* behind all triangles of STL files */
    struct lx_mesh_note unended;       /* solids of STL files without an end */
    unsigned joined;                   /* corners that lay within the rounding of others */
    double scale;                      /* with which the body was made */
    struct lx_kept *body; /* what was made of it (light/solid/facets.h): set before it is shared; NULL: nothing */
    struct lx_kept_slot *made[LX_MESH_MADE];
    struct lx_mesh_file *files; /* other files that belong to it */
    size_t file_count;
};

/* A file that belongs to a mesh, and what it was before it was read. */
struct lx_mesh_file {
    char *path;
    struct lx_file_state state;
};

/* Reads a file that belongs to a mesh, as the mesh names it: its bytes, the caller's, or NULL; then *told says whether
 * why not has been reported. */
struct lx_mesh_opener {
    char *(*open)(const struct lx_mesh_opener *opener, const char *name, size_t *length, struct lx_mesh_file *file);
    const void *data;
};

/* What is wrong with a file: the message, whose {1} is its name, {2} the line, {3} the detail; LX_MSG_COUNT: nothing,
 * LX_MSG_NAMED_FILE_NOT_READ: a file that belongs to it, which has been reported. */
struct lx_mesh_report {
    enum lx_message message;
    size_t line;
    char detail[96];
};

/*
 * Reads a file with a 0 byte behind it, which it changes; `name` is the file's.  The mesh has one user.  `opener` may
 * be NULL: then other files are refused.
 */
struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, const struct lx_mesh_opener *opener,
                                   struct lx_mesh **mesh);

/* The sides of the box around a mesh, and the longest of them, in units of the file. */
void lx_mesh_sizes(const struct lx_mesh *mesh, double sizes[3]);
double lx_mesh_size(const struct lx_mesh *mesh);

/*
 * Brings corners together that differ by one unit of their last digit, or by no more than the roundings of sums; only
 * before the mesh is shared.  False: none do, or memory ran out.
 */
bool lx_mesh_join(struct lx_mesh *mesh);

/* Frees a mesh: what its users come to in the end. */
void lx_mesh_free(struct lx_kept *kept);

#endif
