/* SPDX-License-Identifier: MIT */
/* Reading OBJ: corners and faces, whatever else there is. */
#include <string.h>

#include "mesh_read.h"

/* Lines that end with a backslash, and blanks perhaps, go on on the next one. */
static void join_lines(char *text, size_t length)
{
    char *end = text + length;
    for (char *at = text; (at = memchr(at, '\\', (size_t)(end - at))) != NULL; at++) {
        char *stop = at + 1;
        while (stop < end && (*stop == ' ' || *stop == '\t'))
            stop++;
        if (stop < end && *stop == '\n') {
            memset(at, ' ', (size_t)(stop - at));
            *stop = LX_JOINED_LINES;
        }
    }
}

/* A number up to a slash or the end of the word, as an index of what may still come; false where it is none.  What is
 * named from the last one back has to be there. */
static bool read_index(const char **word, const char *end, size_t count, size_t *index)
{
    const char *at = *word;
    const bool negative = at < end && *at == '-';
    const char *start = at += negative;
    size_t number = 0;
    for (; at < end && *at >= '0' && *at <= '9'; at++) {
        number = number * 10 + (size_t)(*at - '0');
        if (number > LX_LARGEST_MESH)
            return false;
    }
    if (at == start || (at < end && *at != '/') || number == 0 || (negative && number > count))
        return false;
    *index = negative ? count - number : number - 1;
    *word = at;
    return true;
}

/* The corner of a face, v, v/vt, v//vn or v/vt/vn; a normal that is not as it should be is none. */
static bool read_face_corner(const struct lx_mesh *mesh, const char *word, size_t length, size_t *corner,
                             unsigned *normal)
{
    const char *end = word + length;
    size_t index;
    *normal = LX_NO_NORMAL;
    if (!read_index(&word, end, mesh->corner_count, corner))
        return false;
    for (int slashes = 0; word < end; word++) {
        if (*word == '/' && ++slashes == 2 && word + 1 < end) {
            word++;
            const bool is_number = read_index(&word, end, mesh->normal_count, &index);
            *normal = is_number && word == end ? (unsigned)index : LX_NO_NORMAL - 1;
            return true;
        }
    }
    return true;
}

static struct lx_mesh_report read_face(struct lx_raw_mesh *raw, struct lx_lines *lines)
{
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, lines->line);
    const char *word;
    size_t length, corner;
    unsigned count = 0, normal;
    for (; report.message == LX_MSG_COUNT && lx_next_word(lines, &word, &length); count++) {
        if (!read_face_corner(raw->mesh, word, length, &corner, &normal))
            return lx_mesh_fault(LX_MSG_OBJ_FACE, lines->line);
        report = lx_add_to_loop(raw, (unsigned)corner, normal, lines->line);
    }
    return report.message == LX_MSG_COUNT ? lx_add_face(raw, count, lines->line) : report;
}

/* Faces may name corners and normals that come behind them, so what is there is known only at the end. */
static struct lx_mesh_report check_indexes(struct lx_mesh *mesh)
{
    size_t at = 0;
    for (size_t face = 0; face < mesh->face_count; face++)
        for (unsigned i = 0; i < mesh->counts[face]; i++, at++) {
            if (mesh->loop[at] >= mesh->corner_count)
                return lx_mesh_fault(LX_MSG_MESH_INDEX, mesh->origins[face].line);
            if (!mesh->turns || mesh->turns[at] == LX_NO_NORMAL || mesh->turns[at] < mesh->normal_count)
                continue;
            mesh->turns[at] = LX_NO_NORMAL;
            lx_mesh_take_note(&mesh->lost_normals, mesh->origins[face].line);
        }
    return lx_mesh_fault(LX_MSG_COUNT, 0);
}

/* Points and lines have no area. */
static void note_other(struct lx_mesh *mesh, const char *word, size_t length, size_t line)
{
    if (!lx_word_is(word, length, "p") && !lx_word_is(word, length, "l"))
        return;
    lx_mesh_take_note(&mesh->others, line);
}

/* A normal; what is none keeps its number, so that others keep theirs. */
static struct lx_mesh_report read_normal(struct lx_raw_mesh *raw, struct lx_lines *lines)
{
    double normal[3] = {0, 0, 0};
    const char *word;
    size_t length;
    for (int i = 0; i < 3; i++)
        if (!lx_next_word(lines, &word, &length) || !lx_read_number(word, length, &normal[i]))
            memset(normal, 0, sizeof normal);
    return lx_add_normal(raw, normal, lines->line);
}

struct lx_mesh_report lx_read_obj(struct lx_raw_mesh *raw)
{
    join_lines(raw->text, raw->length);
    struct lx_lines lines = {.next = raw->text, .end = raw->text + raw->length};
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, 0);
    while (report.message == LX_MSG_COUNT && lx_next_line(&lines)) {
        const char *word;
        size_t length;
        double corner[3];
        lx_next_word(&lines, &word, &length);
        if (lx_word_is(word, length, "f") || lx_word_is(word, length, "fo"))
            report = read_face(raw, &lines);
        else if (lx_word_is(word, length, "surf") || lx_word_is(word, length, "cstype"))
            report = lx_mesh_fault(LX_MSG_OBJ_FREE_FORM, lines.line);
        else if (lx_word_is(word, length, "vn"))
            report = read_normal(raw, &lines);
        else if (!lx_word_is(word, length, "v"))
            note_other(raw->mesh, word, length, lines.line);
        else if (lx_read_corner(raw, &lines, corner))
            report = lx_add_corner(raw, corner, lines.line);
        else
            report = lx_mesh_fault(LX_MSG_MESH_CORNER, lines.line);
    }
    return report.message == LX_MSG_COUNT ? check_indexes(raw->mesh) : report;
}
