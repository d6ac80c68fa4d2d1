/* SPDX-License-Identifier: MIT */
/*
 * Reading STL: triangles with corners of their own, as text or binary.  A binary file tells its number of triangles,
 * and with it its size, so that one which begins with "solid" is none of the texts.  Its normals are often 0 or wrong,
 * and are not used; a text may hold several solids, which are read as one.
 */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "binary.h"
#include "mesh_read.h"

enum { HEAD = 84, EACH = 50 };

static bool begins_with_solid(const char *text, size_t length)
{
    while (length > 0 && lx_is_blank(*text))
        text++, length--;
    return length > 5 && strncasecmp(text, "solid", 5) == 0 && lx_is_blank(text[5]);
}

bool lx_is_binary_stl(const char *name, const char *text, size_t length)
{
    if (length < HEAD)
        return false;
    const size_t name_length = strlen(name);
    const uint64_t count = lx_binary_bits(text + HEAD - 4, 4, false);
    const bool is_named = name_length > 4 && strcasecmp(name + name_length - 4, ".stl") == 0;
    return length == HEAD + EACH * count || (is_named && !begins_with_solid(text, length));
}

bool lx_is_text_stl(const char *name, const char *text, size_t length)
{
    (void)name;
    return begins_with_solid(text, length);
}

/* Adds a corner, which is the next one of the face. */
static struct lx_mesh_report add(struct lx_raw_mesh *raw, const double corner[3], size_t line)
{
    if (!isfinite(corner[0] + corner[1] + corner[2]))
        return lx_mesh_fault(LX_MSG_MESH_NOT_FINITE, raw->mesh->corner_count + 1);
    const struct lx_mesh_report report = lx_add_to_loop(raw, (unsigned)raw->mesh->corner_count, LX_NO_NORMAL, line);
    return report.message == LX_MSG_COUNT ? lx_add_corner(raw, corner, line) : report;
}

struct lx_mesh_report lx_read_binary_stl(struct lx_raw_mesh *raw)
{
    const uint64_t count = lx_binary_bits(raw->text + HEAD - 4, 4, false);
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, 0);
    if (raw->length < HEAD + EACH * count)
        return lx_mesh_fault(LX_MSG_MESH_ENDS, 0);
    raw->rounding = 0x1p-24;
    for (uint64_t i = 0; i < count && report.message == LX_MSG_COUNT; i++) {
        const char *at = raw->text + HEAD + EACH * i + 12;
        for (int c = 0; c < 3 && report.message == LX_MSG_COUNT; c++) {
            double corner[3];
            for (int k = 0; k < 3; k++, at += 4)
                corner[k] = lx_binary_number(at, LX_FLOAT32, false) + 0.0;
            report = add(raw, corner, 0);
        }
        if (report.message == LX_MSG_COUNT)
            report = lx_add_face(raw, 3, 0);
    }
    return report;
}

/* The next word, on whatever line. */
static bool next_word(struct lx_lines *lines, const char **word, size_t *length)
{
    while (!lx_next_word(lines, word, length))
        if (!lx_next_line(lines))
            return false;
    return true;
}

static bool is_word(const char *word, size_t length, const char *wanted)
{
    return strlen(wanted) == length && strncasecmp(word, wanted, length) == 0;
}

static struct lx_mesh_report read_vertex(struct lx_raw_mesh *raw, struct lx_lines *lines)
{
    const char *word;
    size_t length;
    double corner[3];
    for (int k = 0; k < 3; k++)
        if (!next_word(lines, &word, &length) || !lx_read_place(raw, word, length, &corner[k]))
            return lx_mesh_fault(LX_MSG_MESH_CORNER, lines->line);
    return add(raw, corner, lines->line);
}

struct lx_mesh_report lx_read_text_stl(struct lx_raw_mesh *raw)
{
    struct lx_lines lines = {.next = raw->text, .end = raw->text + raw->length};
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, 0);
    const char *word;
    size_t length, line = 0;
    unsigned corners = 0;
    bool is_open = false; /* in a solid that has not ended */
    while (report.message == LX_MSG_COUNT && next_word(&lines, &word, &length)) {
        if (is_word(word, length, "solid") || is_word(word, length, "endsolid")) {
            is_open = is_word(word, length, "solid");
            lines.at = lines.stop; /* its name */
        } else if (is_word(word, length, "facet")) {
            if (corners > 0)
                report = lx_mesh_fault(LX_MSG_STL_WORD, lines.line);
            line = lines.line;
        } else if (is_word(word, length, "vertex")) {
            report = read_vertex(raw, &lines);
            corners++;
        } else if (is_word(word, length, "endfacet")) {
            report = lx_add_face(raw, corners, line);
            corners = 0;
        } else if (!is_word(word, length, "outer") && !is_word(word, length, "loop") &&
                   !is_word(word, length, "endloop") && !is_word(word, length, "normal") && corners > 0) {
            report = lx_mesh_fault(LX_MSG_STL_WORD, lines.line);
        }
    }
    if (report.message == LX_MSG_COUNT && (is_open || corners > 0))
        report = lx_mesh_fault(LX_MSG_MESH_ENDS, lines.line);
    return report;
}
