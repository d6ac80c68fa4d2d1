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

/* The number of a corner up to a slash, as an index; false where it is none.  The corner may still come. */
static bool read_index(const char *word, size_t length, size_t corner_count, size_t *index)
{
    bool negative = word[0] == '-';
    size_t i = negative, number = 0;
    for (; i < length && word[i] >= '0' && word[i] <= '9'; i++) {
        number = number * 10 + (size_t)(word[i] - '0');
        if (number > LX_LARGEST_MESH)
            return false;
    }
    if (i == negative || (i < length && word[i] != '/') || number == 0 || (negative && number > corner_count))
        return false;
    *index = negative ? corner_count - number : number - 1;
    return true;
}

static struct lx_mesh_report read_face(struct lx_raw_mesh *raw, struct lx_lines *lines)
{
    struct lx_mesh_report report = {LX_MSG_COUNT, lines->line};
    const char *word;
    size_t length, index;
    unsigned count = 0;
    for (; report.message == LX_MSG_COUNT && lx_next_word(lines, &word, &length); count++) {
        if (!read_index(word, length, raw->mesh->corner_count, &index))
            return (struct lx_mesh_report){LX_MSG_OBJ_FACE, lines->line};
        report = lx_add_to_loop(raw, (unsigned)index, lines->line);
    }
    return report.message == LX_MSG_COUNT ? lx_add_face(raw, count, lines->line) : report;
}

/* Faces may name corners that come behind them, so this is known only at the end. */
static struct lx_mesh_report check_indexes(const struct lx_mesh *mesh)
{
    size_t at = 0;
    for (size_t face = 0; face < mesh->face_count; face++)
        for (unsigned i = 0; i < mesh->counts[face]; i++)
            if (mesh->loop[at++] >= mesh->corner_count)
                return (struct lx_mesh_report){LX_MSG_MESH_INDEX, mesh->origins[face].line};
    return (struct lx_mesh_report){LX_MSG_COUNT, 0};
}

/* Points and lines have no area. */
static void note_other(struct lx_mesh *mesh, const char *word, size_t length, size_t line)
{
    if (!lx_word_is(word, length, "p") && !lx_word_is(word, length, "l"))
        return;
    if (mesh->others.count++ == 0)
        mesh->others.line = (unsigned)line;
}

struct lx_mesh_report lx_read_obj(struct lx_raw_mesh *raw)
{
    join_lines(raw->text, raw->length);
    struct lx_lines lines = {.next = raw->text, .end = raw->text + raw->length};
    struct lx_mesh_report report = {LX_MSG_COUNT, 0};
    while (report.message == LX_MSG_COUNT && lx_next_line(&lines)) {
        const char *word;
        size_t length;
        double corner[3];
        lx_next_word(&lines, &word, &length);
        if (lx_word_is(word, length, "f") || lx_word_is(word, length, "fo"))
            report = read_face(raw, &lines);
        else if (lx_word_is(word, length, "surf") || lx_word_is(word, length, "cstype"))
            report = (struct lx_mesh_report){LX_MSG_OBJ_FREE_FORM, lines.line};
        else if (!lx_word_is(word, length, "v"))
            note_other(raw->mesh, word, length, lines.line);
        else if (lx_read_corner(raw, &lines, corner))
            report = lx_add_corner(raw, corner, lines.line);
        else
            report = (struct lx_mesh_report){LX_MSG_MESH_CORNER, lines.line};
    }
    return report.message == LX_MSG_COUNT ? check_indexes(raw->mesh) : report;
}
