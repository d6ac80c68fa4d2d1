/* SPDX-License-Identifier: MIT */
/*
 * Polyhedra in text files: OFF and OBJ.  What is read is only what files tell, corners and faces; whether they make a
 * body is for others to say.
 *
 * OFF   the word OFF (or COFF, NOFF ..., whose further numbers are passed over; in a file named *.off it may be
 *       missing), the numbers of corners, faces and, perhaps, edges; a line for each corner; a line for each face: the
 *       number of its corners and their indexes from 0 on.
 * OBJ   v x y z, and f with the numbers of corners from 1 on, or from -1 down for the last ones before it; what stands
 *       behind a slash, and all other lines, are passed over.
 *
 * In both # begins a comment.
 */
#ifndef LX_FORMAT_MESH_H
#define LX_FORMAT_MESH_H

#include "../base/diagnostics.h"

enum { LX_LARGEST_MESH = 64 << 20, LX_MOST_FACES = 1000000 };

/* Where a face comes from: its number in the file, from 1 on, and its line. */
struct lx_mesh_origin {
    unsigned number, line;
};

/* Corners at the same place are one; those of no face are left out.  It never changes, and scenes share it. */
struct lx_mesh {
    double (*corners)[3];
    size_t corner_count;
    unsigned *loop;   /* the corners of all faces, one face behind the other */
    unsigned *counts; /* of corners in each face */
    struct lx_mesh_origin *origins;
    size_t face_count;
    _Atomic size_t users;
};

/* What is wrong with a file: the message, whose {1} is its name and {2} the line; LX_MSG_COUNT: nothing. */
struct lx_mesh_report {
    enum lx_message message;
    size_t line;
};

/* Reads a text, which it changes; `name` is the file's.  The mesh has one user. */
struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, struct lx_mesh **mesh);

/* One more user; one less (NULL is harmless), the last frees it. */
struct lx_mesh *lx_mesh_hold(struct lx_mesh *mesh);
void lx_mesh_release(struct lx_mesh *mesh);

/* Meshes by the paths of their files; starts as {0}. */
struct lx_meshes {
    struct lx_kept_mesh {
        char *path;
        struct lx_mesh *mesh;
    } * items;
    size_t count, capacity;
};

/* The mesh of a path, which keeps its user; NULL where there is none. */
struct lx_mesh *lx_meshes_find(const struct lx_meshes *meshes, const char *path);
/* Keeps a mesh, as one more user; 0, or -1 when memory ran out. */
int lx_meshes_keep(struct lx_meshes *meshes, const char *path, struct lx_mesh *mesh);
/* Keeps all of another list; 0, or -1 when memory ran out. */
int lx_meshes_copy(const struct lx_meshes *meshes, struct lx_meshes *copy);
void lx_meshes_clear(struct lx_meshes *meshes);

#endif
