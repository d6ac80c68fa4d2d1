/* SPDX-License-Identifier: MIT */
/*
 * Polyhedra in text files: OFF and OBJ.  What is read is only what files tell, corners and faces; whether they make a
 * body is for others to say.
 *
 * OFF   the word OFF in any case, perhaps with the letters ST, C, N before it, whose further numbers are passed over
 *       (in a file named *.off it may be missing); the numbers of corners, faces and edges; the corners; for each face
 *       the number of its corners and their indexes from 0 on.  Corners and faces stand on lines of their own, and
 *       what else stands there is passed over; or all is anywhere, and then there is nothing else.
 * OBJ   v x y z, and f with the numbers of corners from 1 on, or from -1 down for the last ones before it; what stands
 *       behind a slash, and other statements, are passed over.  Free-form surfaces are refused.
 *
 * In both # begins a comment, lines end in LF, CR LF or CR, and a byte order mark or UTF-16 are understood.
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

/* What was left out, and the line where it was for the first time. */
struct lx_mesh_note {
    unsigned count, line;
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
    unsigned face_total;               /* of the file, with those that were left out */
    double rounding;                   /* half a unit of the last digit of its places; 0: all are whole numbers */
    struct lx_mesh_note thin, doubled; /* faces of fewer than 3 corners, and those that were there before */
    struct lx_mesh_note others;        /* points and lines of OBJ files */
    unsigned joined;                   /* corners that lay within the rounding of others */
    double scale;                      /* with which the body was made */
    struct lx_kept *body; /* what was made of it (light/facets.h): set before it is shared; NULL: nothing */
};

/* What is wrong with a file: the message, whose {1} is its name and {2} the line; LX_MSG_COUNT: nothing. */
struct lx_mesh_report {
    enum lx_message message;
    size_t line;
};

/* Reads a text with a 0 byte behind it, which it changes; `name` is the file's.  The mesh has one user. */
struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, struct lx_mesh **mesh);

/* The longest side of the box around a mesh, in units of the file. */
double lx_mesh_size(const struct lx_mesh *mesh);

/*
 * Brings corners together that differ by one unit of their last digit, or by no more than the roundings of sums; only
 * before the mesh is shared.  False: none do, or memory ran out.
 */
bool lx_mesh_join(struct lx_mesh *mesh);

/* Frees a mesh: what its users come to in the end. */
void lx_mesh_free(struct lx_kept *kept);

#endif
