/* SPDX-License-Identifier: MIT */
/* For the readers of meshes: what grows while they read. */
#ifndef LX_FORMAT_MESH_READ_H
#define LX_FORMAT_MESH_READ_H

#include "../base/number.h"
#include "lines.h"
#include "mesh.h"

enum { LX_MOST_CORNERS = 2000000 };

/* Three numbers. */
bool lx_read_corner(struct lx_lines *lines, double corner[3]);

struct lx_raw_mesh {
    char *text;
    size_t length;
    struct lx_mesh *mesh;
    size_t corner_capacity, loop_count, loop_capacity, count_capacity, origin_capacity;
};

/* The message of what they report is LX_MSG_COUNT where all went well. */
struct lx_mesh_report lx_add_corner(struct lx_raw_mesh *raw, const double corner[3], size_t line);
struct lx_mesh_report lx_add_to_loop(struct lx_raw_mesh *raw, unsigned corner, size_t line);
/* A face of the last so many corners of the loop. */
struct lx_mesh_report lx_add_face(struct lx_raw_mesh *raw, unsigned corners, size_t line);

bool lx_is_off_word(const char *word, size_t length);
struct lx_mesh_report lx_read_off(struct lx_raw_mesh *raw);
struct lx_mesh_report lx_read_obj(struct lx_raw_mesh *raw);

#endif
