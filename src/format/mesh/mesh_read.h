/* SPDX-License-Identifier: MIT */
/* For the readers of meshes: what grows while they read. */
#ifndef LX_FORMAT_MESH_READ_H
#define LX_FORMAT_MESH_READ_H

#include "../../base/number.h"
#include "../lines.h"
#include "mesh.h"

/* How finely the places of corners are written. */
struct lx_digits {
    int decimals;    /* the most behind a point, an exponent taken into account */
    int significant; /* the most from the first that is not 0 on */
    bool has_point;  /* a number has decimals or an exponent */
    double largest;  /* the largest size of a number */
};

struct lx_raw_mesh {
    char *text;
    size_t length;
    struct lx_mesh *mesh;
    struct lx_digits digits;
    size_t corner_capacity, loop_count, loop_capacity, count_capacity, origin_capacity, normal_capacity, turn_capacity;
    double rounding; /* of binary numbers, relative to the largest one */
    const struct lx_mesh_opener *opener;
};

struct lx_mesh_report lx_mesh_fault(enum lx_message message, size_t line);

/* Reads a number of a place, and notes its digits. */
bool lx_read_place(struct lx_raw_mesh *raw, const char *word, size_t length, double *value);

/* Three of them. */
bool lx_read_corner(struct lx_raw_mesh *raw, struct lx_lines *lines, double corner[3]);

/* The message of what they report is LX_MSG_COUNT where all went well. */
struct lx_mesh_report lx_add_corner(struct lx_raw_mesh *raw, const double corner[3], size_t line);
struct lx_mesh_report lx_add_normal(struct lx_raw_mesh *raw, const double normal[3], size_t line);
/* The normal may be LX_NO_NORMAL. */
struct lx_mesh_report lx_add_to_loop(struct lx_raw_mesh *raw, unsigned corner, unsigned normal, size_t line);
/* A face of the last so many corners of the loop; one of fewer than 3 is noted and left out. */
struct lx_mesh_report lx_add_face(struct lx_raw_mesh *raw, unsigned corners, size_t line);

void lx_mesh_take_note(struct lx_mesh_note *about, size_t line);

/* Brings corners at one place together, and leaves out what is of no use. */
struct lx_mesh_report lx_mesh_tidy(struct lx_mesh *mesh);

/* Whether a word begins an OFF file: OFF in any case, letters before it, the number of corners perhaps behind it. */
bool lx_is_off_word(const char *word, size_t length);
struct lx_mesh_report lx_read_off(struct lx_raw_mesh *raw);
struct lx_mesh_report lx_read_obj(struct lx_raw_mesh *raw);
bool lx_is_ply(const char *name, const char *text, size_t length);
struct lx_mesh_report lx_read_ply(struct lx_raw_mesh *raw);
bool lx_is_binary_stl(const char *name, const char *text, size_t length);
struct lx_mesh_report lx_read_binary_stl(struct lx_raw_mesh *raw);
bool lx_is_text_stl(const char *name, const char *text, size_t length);
struct lx_mesh_report lx_read_text_stl(struct lx_raw_mesh *raw);
bool lx_is_glb(const char *name, const char *text, size_t length);
struct lx_mesh_report lx_read_glb(struct lx_raw_mesh *raw);
bool lx_is_gltf(const char *name, const char *text, size_t length);
struct lx_mesh_report lx_read_gltf(struct lx_raw_mesh *raw);

#endif
