/* SPDX-License-Identifier: MIT */
/* For the readers of meshes: lines, words and what grows while they read. */
#ifndef LX_FORMAT_MESH_READ_H
#define LX_FORMAT_MESH_READ_H

#include "../base/number.h"
#include "mesh.h"

enum {
    LX_MOST_CORNERS = 2000000,
    LX_JOINED_LINES = '\v' /* stands where a line goes on on the next one */
};

/* The lines of a text without comments and those that are blank; next and end are set at first. */
struct lx_lines {
    const char *next, *end; /* what follows the line */
    const char *at, *stop;  /* what is left of it */
    size_t line, joined;    /* its number, from 1 on, and how many it goes on on */
};

bool lx_next_line(struct lx_lines *lines);
/* The next word of the line; false where there is none. */
bool lx_next_word(struct lx_lines *lines, const char **word, size_t *length);
bool lx_word_is(const char *word, size_t length, const char *wanted);
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
