/* SPDX-License-Identifier: MIT */
/*
 * Reading PLY: a header that says which elements follow, each with which properties, then their values, as text or as
 * binary numbers of either byte order.  Corners are the elements "vertex", faces the lists of "face", or the strips of
 * triangles of "tristrips", which -1 begins anew; all else is passed over, value by value.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../base/memory.h"
#include "../binary.h"
#include "mesh_read.h"

enum { MOST_ELEMENTS = 64, MOST_PROPERTIES = 512 };

enum role { OTHER, PLACE, NORMAL = PLACE + 3, LOOP = NORMAL + 3, STRIPS };

struct property {
    enum lx_binary_type type, counted_by;
    bool is_list;
    int role; /* enum role, PLACE and NORMAL with the axis added */
};

struct element {
    enum { OTHERS, VERTEX, FACE, STRIP } kind;
    size_t count, first, properties;
};

struct ply {
    struct lx_raw_mesh *raw;
    struct lx_lines lines;  /* of a text */
    const char *next, *end; /* of binary numbers */
    bool is_text, is_big;
    struct element elements[MOST_ELEMENTS];
    struct property properties[MOST_PROPERTIES];
    size_t element_count, property_count;
    bool has_normals;
};

static struct lx_mesh_report say(const struct ply *ply, enum lx_message message)
{
    return lx_mesh_fault(message, ply->lines.line);
}

/* ---- the header ---- */

static bool read_type(const char *word, size_t length, enum lx_binary_type *type)
{
    static const struct {
        const char *name;
        enum lx_binary_type type;
    } names[] = {
        {"char", LX_INT8},   {"uchar", LX_UINT8},   {"short", LX_INT16},     {"ushort", LX_UINT16},
        {"int", LX_INT32},   {"uint", LX_UINT32},   {"float", LX_FLOAT32},   {"double", LX_FLOAT64},
        {"int8", LX_INT8},   {"uint8", LX_UINT8},   {"int16", LX_INT16},     {"uint16", LX_UINT16},
        {"int32", LX_INT32}, {"uint32", LX_UINT32}, {"float32", LX_FLOAT32}, {"float64", LX_FLOAT64},
    };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (lx_word_is(word, length, names[i].name)) {
            *type = names[i].type;
            return true;
        }
    return false;
}

static int role_of(const struct element *element, const char *word, size_t length, bool is_list)
{
    static const char *const names[] = {"x", "y", "z", "nx", "ny", "nz"};
    if (is_list && (lx_is_word(word, length, "vertex_indices") || lx_is_word(word, length, "vertex_index")))
        return element->kind == FACE ? LOOP : element->kind == STRIP ? STRIPS : OTHER;
    for (int i = 0; element->kind == VERTEX && !is_list && i < 6; i++)
        if (lx_is_word(word, length, names[i]))
            return PLACE + i;
    return OTHER;
}

static bool next_word(struct ply *ply, const char **word, size_t *length)
{
    return lx_next_word(&ply->lines, word, length);
}

static bool read_property(struct ply *ply)
{
    struct property property = {.is_list = false};
    const char *word;
    size_t length;
    if (ply->element_count == 0 || ply->property_count == MOST_PROPERTIES || !next_word(ply, &word, &length))
        return false;
    property.is_list = lx_word_is(word, length, "list");
    if (property.is_list && (!next_word(ply, &word, &length) || !read_type(word, length, &property.counted_by) ||
                             !next_word(ply, &word, &length)))
        return false;
    if (!read_type(word, length, &property.type) || !next_word(ply, &word, &length))
        return false;
    struct element *element = &ply->elements[ply->element_count - 1];
    property.role = role_of(element, word, length, property.is_list);
    ply->has_normals = ply->has_normals || property.role == NORMAL;
    ply->properties[ply->property_count++] = property;
    element->properties++;
    return true;
}

static bool read_element(struct ply *ply)
{
    const char *word;
    size_t length;
    double count;
    if (ply->element_count == MOST_ELEMENTS || !next_word(ply, &word, &length))
        return false;
    struct element element = {.first = ply->property_count};
    if (lx_is_word(word, length, "vertex"))
        element.kind = VERTEX;
    else if (lx_is_word(word, length, "face"))
        element.kind = FACE;
    else if (lx_is_word(word, length, "tristrips"))
        element.kind = STRIP;
    if (!next_word(ply, &word, &length) || !lx_read_number(word, length, &count) || !(count >= 0 && count < 1e15) ||
        count != floor(count))
        return false;
    element.count = (size_t)count;
    ply->elements[ply->element_count++] = element;
    return true;
}

static bool read_format(struct ply *ply)
{
    const char *word;
    size_t length;
    if (!next_word(ply, &word, &length))
        return false;
    ply->is_text = lx_word_is(word, length, "ascii");
    ply->is_big = lx_word_is(word, length, "binary_big_endian");
    return ply->is_text || ply->is_big || lx_word_is(word, length, "binary_little_endian");
}

/* Reads the header's lines up to its end; false where one is not as it should be. */
static bool read_header(struct ply *ply)
{
    bool has_format = false;
    const char *word;
    size_t length;
    while (lx_next_line(&ply->lines) && next_word(ply, &word, &length)) {
        bool is_good = true;
        if (lx_word_is(word, length, "end_header"))
            return has_format;
        if (lx_word_is(word, length, "format"))
            has_format = is_good = read_format(ply);
        else if (lx_word_is(word, length, "element"))
            is_good = read_element(ply);
        else if (lx_word_is(word, length, "property"))
            is_good = read_property(ply);
        else
            is_good = lx_word_is(word, length, "comment") || lx_word_is(word, length, "obj_info") ||
                      (ply->lines.line == 1 && lx_word_is(word, length, "ply"));
        if (!is_good)
            return false;
    }
    return false;
}

/* ---- values ---- */

static struct lx_mesh_report read_value(struct ply *ply, enum lx_binary_type type, double *value)
{
    const char *word;
    size_t length;
    if (!ply->is_text) {
        if ((size_t)(ply->end - ply->next) < lx_binary_size(type))
            return say(ply, LX_MSG_MESH_ENDS);
        *value = lx_binary_number(ply->next, type, ply->is_big);
        ply->next += lx_binary_size(type);
        return say(ply, LX_MSG_COUNT);
    }
    while (!next_word(ply, &word, &length))
        if (!lx_next_line(&ply->lines))
            return say(ply, LX_MSG_MESH_ENDS);
    if (!lx_read_place(ply->raw, word, length, value))
        return say(ply, LX_MSG_MESH_NUMBER);
    return say(ply, LX_MSG_COUNT);
}

static struct lx_mesh_report add_to_loop(struct ply *ply, double index, size_t line)
{
    if (!(index >= 0 && index < LX_MOST_CORNERS && index == floor(index)))
        return lx_mesh_fault(LX_MSG_MESH_INDEX, line);
    return lx_add_to_loop(ply->raw, (unsigned)index, ply->has_normals ? (unsigned)index : LX_NO_NORMAL, line);
}

/* A strip of triangles: each corner makes one with the two before it, every second one turned round.  Triangles that
 * name a corner twice lead from one part of the strip to another. */
struct strip {
    double last[2];
    size_t length; /* since its beginning */
};

static struct lx_mesh_report add_to_strip(struct ply *ply, struct strip *strip, double index, size_t line)
{
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, line);
    const bool is_odd = strip->length % 2 == 1;
    const double corners[3] = {strip->last[is_odd], strip->last[!is_odd], index};
    if (index == -1) {
        strip->length = 0;
        return report;
    }
    const bool is_face = strip->length >= 2 && corners[0] != corners[1] && index != corners[0] && index != corners[1];
    for (int k = 0; is_face && k < 3 && report.message == LX_MSG_COUNT; k++)
        report = add_to_loop(ply, corners[k], line);
    if (is_face && report.message == LX_MSG_COUNT)
        report = lx_add_face(ply->raw, 3, line);
    *strip = (struct strip){{strip->last[1], index}, strip->length + 1};
    return report;
}

static struct lx_mesh_report read_list(struct ply *ply, const struct property *property)
{
    double count, index;
    struct strip strip = {.length = 0};
    struct lx_mesh_report report = read_value(ply, property->counted_by, &count);
    if (report.message != LX_MSG_COUNT)
        return report;
    const size_t line = ply->lines.line;
    if (!(count >= 0 && count <= LX_LARGEST_MESH && count == floor(count)))
        return say(ply, LX_MSG_MESH_LIST);
    for (size_t i = 0; i < (size_t)count && report.message == LX_MSG_COUNT; i++) {
        report = read_value(ply, property->type, &index);
        if (report.message != LX_MSG_COUNT)
            return report;
        if (property->role == LOOP)
            report = add_to_loop(ply, index, line);
        else if (property->role == STRIPS)
            report = add_to_strip(ply, &strip, index, line);
    }
    return property->role == LOOP && report.message == LX_MSG_COUNT ? lx_add_face(ply->raw, (unsigned)count, line)
                                                                    : report;
}

/* One element, whatever it is. */
static struct lx_mesh_report read_one(struct ply *ply, const struct element *element)
{
    double places[6] = {(double)NAN, (double)NAN, (double)NAN, 0, 0, 0}, value;
    struct lx_mesh_report report = say(ply, LX_MSG_COUNT);
    for (size_t p = 0; p < element->properties && report.message == LX_MSG_COUNT; p++) {
        const struct property *property = &ply->properties[element->first + p];
        if (property->is_list) {
            report = read_list(ply, property);
            continue;
        }
        report = read_value(ply, property->type, &value);
        if (report.message == LX_MSG_COUNT && property->role >= PLACE && property->role < LOOP)
            places[property->role - PLACE] = value + 0.0;
    }
    if (report.message != LX_MSG_COUNT || element->kind != VERTEX)
        return report;
    if (!isfinite(places[0] + places[1] + places[2]))
        return lx_mesh_fault(LX_MSG_MESH_NOT_FINITE, ply->raw->mesh->corner_count + 1);
    if (ply->has_normals)
        report = lx_add_normal(ply->raw, places + 3, ply->lines.line);
    return report.message == LX_MSG_COUNT ? lx_add_corner(ply->raw, places, ply->lines.line) : report;
}

/* Faces may stand before the corners. */
static struct lx_mesh_report check_indexes(const struct lx_mesh *mesh)
{
    size_t at = 0;
    for (size_t face = 0; face < mesh->face_count; face++)
        for (unsigned i = 0; i < mesh->counts[face]; i++)
            if (mesh->loop[at++] >= mesh->corner_count) {
                struct lx_mesh_report report = lx_mesh_fault(LX_MSG_MESH_FACE_INDEX, mesh->origins[face].number);
                return mesh->origins[face].line ? lx_mesh_fault(LX_MSG_MESH_INDEX, mesh->origins[face].line) : report;
            }
    return lx_mesh_fault(LX_MSG_COUNT, 0);
}

bool lx_is_ply(const char *name, const char *text, size_t length)
{
    (void)name;
    return length > 4 && memcmp(text, "ply", 3) == 0 && (text[3] == '\n' || text[3] == '\r');
}

struct lx_mesh_report lx_read_ply(struct lx_raw_mesh *raw)
{
    static const char mark[] = "end_header";
    struct ply *ply = lx_new_array(1, sizeof *ply);
    if (!ply)
        return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, 0);
    ply->raw = raw;
    char *end = lx_find_text(raw->text, raw->length, mark);
    char *stop =
        end ? memchr(end, end[sizeof mark - 1] == '\r' ? '\r' : '\n', (size_t)(raw->text + raw->length - end)) : NULL;
    if (stop && *stop == '\r' && stop + 1 < raw->text + raw->length && stop[1] == '\n')
        stop++;
    const size_t header = stop ? (size_t)(stop + 1 - raw->text) : raw->length;
    for (size_t i = 0; i < header; i++)
        if (raw->text[i] == '\r')
            raw->text[i] = i + 1 < header && raw->text[i + 1] == '\n' ? ' ' : '\n';
    ply->lines = (struct lx_lines){.next = raw->text, .end = raw->text + header};
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, 0);
    if (!read_header(ply))
        report = say(ply, LX_MSG_PLY_HEADER);
    ply->next = raw->text + header;
    ply->end = raw->text + raw->length;
    if (ply->is_text)
        ply->lines = (struct lx_lines){.next = raw->text + header, .end = ply->end, .line = ply->lines.line};
    else
        ply->lines.line = 0;
    for (size_t e = 0; e < ply->element_count && report.message == LX_MSG_COUNT; e++)
        for (size_t i = 0; ply->elements[e].properties > 0 && i < ply->elements[e].count; i++)
            if ((report = read_one(ply, &ply->elements[e])).message != LX_MSG_COUNT)
                break;
    if (!ply->is_text)
        raw->rounding = 0x1p-24;
    free(ply);
    return report.message == LX_MSG_COUNT ? check_indexes(raw->mesh) : report;
}
