/* SPDX-License-Identifier: MIT */
/*
 * Reading STL: triangles with corners of their own, as text or binary.  Normals are often 0 or wrong, and are not used;
 * a text may hold several solids, which are read as one.  A binary file tells its number of triangles, and behind each
 * of them a number of bytes of attributes, which most programs fill with a colour instead; how its triangles lie is
 * what its size agrees with.
 */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "../binary.h"
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
    const bool has_zeros = length >= HEAD + EACH && memchr(text, 0, HEAD + EACH);
    return length == HEAD + EACH * count || (is_named && (has_zeros || !begins_with_solid(text, length)));
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

/* How the triangles of a binary file lie in it. */
struct layout {
    uint64_t count;
    bool has_attributes; /* behind each triangle, as many bytes as it says */
};

static size_t attributes_behind(const char *triangle)
{
    return (size_t)lx_binary_bits(triangle + EACH - 2, 2, false);
}

/* Where so many triangles end, each with its attributes; 0: beyond the file. */
static size_t end_of(const struct lx_raw_mesh *raw, uint64_t count)
{
    size_t at = HEAD;
    for (uint64_t i = 0; i < count; i++) {
        if (raw->length - at < EACH || raw->length - at - EACH < attributes_behind(raw->text + at))
            return 0;
        at += EACH + attributes_behind(raw->text + at);
    }
    return at;
}

/* The layout that the size agrees with: that of the announced number, with colours, with attributes, without either
 * and with bytes behind it; or as many triangles as there are. */
static struct lx_mesh_report find_layout(const struct lx_raw_mesh *raw, struct layout *layout)
{
    const uint64_t count = lx_binary_bits(raw->text + HEAD - 4, 4, false), bare = HEAD + EACH * count;
    const uint64_t present = (raw->length - HEAD) / EACH;
    *layout = (struct layout){.count = count};
    if (raw->length == bare)
        return lx_mesh_fault(LX_MSG_COUNT, 0);
    const size_t end = end_of(raw, count);
    layout->has_attributes = end == raw->length;
    if (layout->has_attributes)
        return lx_mesh_fault(LX_MSG_COUNT, 0);
    if (raw->length == HEAD + EACH * present && end_of(raw, present) == raw->length) {
        layout->count = present;
        raw->mesh->uncounted.count = (unsigned)present;
        return lx_mesh_fault(LX_MSG_COUNT, 0);
    }
    if (count == 0 || end != bare)
        return lx_mesh_fault(raw->length < bare ? LX_MSG_MESH_ENDS : LX_MSG_STL_SIZE, 0);
    raw->mesh->bytes_behind.count = (unsigned)(raw->length - end);
    return lx_mesh_fault(LX_MSG_COUNT, 0);
}

struct lx_mesh_report lx_read_binary_stl(struct lx_raw_mesh *raw)
{
    struct layout layout;
    struct lx_mesh_report report = find_layout(raw, &layout);
    const char *at = raw->text + HEAD;
    raw->rounding = 0x1p-24;
    for (uint64_t i = 0; i < layout.count && report.message == LX_MSG_COUNT; i++) {
        const char *place = at + 12;
        for (int c = 0; c < 3 && report.message == LX_MSG_COUNT; c++) {
            double corner[3];
            for (int k = 0; k < 3; k++, place += 4)
                corner[k] = lx_binary_number(place, LX_FLOAT32, false) + 0.0;
            report = add(raw, corner, 0);
        }
        if (report.message == LX_MSG_COUNT)
            report = lx_add_face(raw, 3, 0);
        at += EACH + (layout.has_attributes ? attributes_behind(at) : 0);
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

enum word { OTHER, SOLID, FACET, OUTER, LOOP, VERTEX, NORMAL, END_SOLID, END_FACET, END_OUTER, END_LOOP };

/* The word, taken together with the next one where it is an "end" that stands alone: "end loop". */
static enum word whole_word(struct lx_lines *lines, const char *word, size_t length)
{
    static const char *const names[] = {
        [SOLID] = "solid",        [FACET] = "facet",      [OUTER] = "outer",        [LOOP] = "loop",
        [VERTEX] = "vertex",      [NORMAL] = "normal",    [END_SOLID] = "endsolid", [END_FACET] = "endfacet",
        [END_OUTER] = "endouter", [END_LOOP] = "endloop",
    };
    const bool is_end = lx_is_word(word, length, "end");
    if (is_end && !next_word(lines, &word, &length))
        return OTHER;
    for (enum word i = is_end ? END_SOLID : SOLID; i <= END_LOOP; i++)
        if (lx_is_word(word, length, is_end ? names[i] + 3 : names[i]))
            return i;
    return OTHER;
}

/* Where a text is read: the corners since the last face, the line of its facet, and what has begun and not ended. */
struct place {
    unsigned corners;
    size_t line;
    bool in_solid, in_facet; /* a facet without a face as yet */
};

/* Faces end with their loop, or with their facet where a text has no loops. */
static struct lx_mesh_report end_face(struct lx_raw_mesh *raw, struct place *place)
{
    const unsigned corners = place->corners;
    place->corners = 0;
    place->in_facet = false;
    return lx_add_face(raw, corners, place->line);
}

static struct lx_mesh_report take_word(struct lx_raw_mesh *raw, struct lx_lines *lines, enum word word,
                                       struct place *place)
{
    const bool begins = word == FACET || word == OUTER;
    if (word == SOLID || word == END_SOLID) {
        place->in_solid = word == SOLID;
        lines->at = lines->stop; /* its name */
    } else if (word == VERTEX) {
        place->corners++;
        return read_vertex(raw, lines);
    } else if (word == END_LOOP || (word == END_FACET && (place->in_facet || place->corners > 0))) {
        return end_face(raw, place);
    } else if (place->corners > 0 && (begins || word == OTHER)) {
        return lx_mesh_fault(LX_MSG_STL_WORD, lines->line);
    } else if (begins && (word == FACET || !place->in_facet)) {
        place->in_facet = true;
        place->line = lines->line;
    }
    return lx_mesh_fault(LX_MSG_COUNT, 0);
}

struct lx_mesh_report lx_read_text_stl(struct lx_raw_mesh *raw)
{
    struct lx_lines lines = {.next = raw->text, .end = raw->text + raw->length};
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, 0);
    struct place place = {.corners = 0};
    const char *word;
    size_t length;
    while (report.message == LX_MSG_COUNT && next_word(&lines, &word, &length))
        report = take_word(raw, &lines, whole_word(&lines, word, length), &place);
    if (report.message == LX_MSG_COUNT && (place.in_facet || place.corners > 0))
        report = lx_mesh_fault(LX_MSG_STL_ENDS, lines.line);
    if (place.in_solid)
        lx_mesh_take_note(&raw->mesh->unended, lines.line);
    return report;
}
