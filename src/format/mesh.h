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
#include "kept.h"

enum { LX_LARGEST_MESH = 64 << 20, LX_MOST_FACES = 1000000 };

/* Where a face comes from: its number in the file, from 1 on, and its line. */
struct lx_mesh_origin {
    unsigned number, line;
};

/* Corners at the same place are one; those of no face are left out. */
struct lx_mesh {
    struct lx_kept kept;
    double (*corners)[3];
    size_t corner_count;
    unsigned *loop;   /* the corners of all faces, one face behind the other */
    unsigned *counts; /* of corners in each face */
    struct lx_mesh_origin *origins;
    size_t face_count;
    struct lx_kept *body; /* what was made of it (light/facets.h): set before it is shared; NULL: nothing */
};

/* What is wrong with a file: the message, whose {1} is its name and {2} the line; LX_MSG_COUNT: nothing. */
struct lx_mesh_report {
    enum lx_message message;
    size_t line;
};

/* Reads a text, which it changes; `name` is the file's.  The mesh has one user. */
struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, struct lx_mesh **mesh);

/* Frees a mesh: what its users come to in the end. */
void lx_mesh_free(struct lx_kept *kept);

#endif
