/* SPDX-License-Identifier: MIT */
/* Reading OFF: a header, a line for each corner, a line for each face. */
#include "mesh_read.h"

/* OFF, with letters before it that say which numbers follow the places of corners. */
bool lx_is_off_word(const char *word, size_t length)
{
    if (length < 3 || !lx_word_is(word + length - 3, 3, "OFF"))
        return false;
    for (size_t i = 0; i < length - 3; i++)
        if (word[i] != 'S' && word[i] != 'T' && word[i] != 'C' && word[i] != 'N')
            return false;
    return true;
}

/* A whole number of at most `most`. */
static bool read_whole(struct lx_lines *lines, size_t most, size_t *number)
{
    const char *word;
    size_t length;
    if (!lx_next_word(lines, &word, &length))
        return false;
    *number = 0;
    for (size_t i = 0; i < length; i++) {
        if (word[i] < '0' || word[i] > '9')
            return false;
        *number = *number * 10 + (size_t)(word[i] - '0');
        if (*number > most)
            return false;
    }
    return true;
}

/* The header up to the numbers of corners and faces, which a text of this length can have. */
static struct lx_mesh_report read_header(struct lx_lines *lines, size_t *corners, size_t *faces)
{
    const char *word;
    size_t length;
    lx_next_line(lines);
    struct lx_lines numbers = *lines;
    if (lx_next_word(lines, &word, &length) && lx_is_off_word(word, length)) {
        struct lx_lines rest = *lines;
        if (lx_next_word(&rest, &word, &length) && lx_word_is(word, length, "BINARY"))
            return (struct lx_mesh_report){LX_MSG_MESH_FORMAT, lines->line};
        rest = *lines;
        if (!lx_next_word(&rest, &word, &length) && !lx_next_line(lines))
            return (struct lx_mesh_report){LX_MSG_MESH_ENDS, lines->line};
        numbers = *lines;
    }
    if (!read_whole(&numbers, SIZE_MAX / 16, corners) || !read_whole(&numbers, SIZE_MAX / 16, faces))
        return (struct lx_mesh_report){LX_MSG_MESH_COUNTS, numbers.line};
    if (*corners > LX_MOST_CORNERS || *faces > LX_MOST_FACES)
        return (struct lx_mesh_report){LX_MSG_MESH_TOO_LARGE, numbers.line};
    lines->at = lines->stop;
    return (struct lx_mesh_report){LX_MSG_COUNT, 0};
}

static struct lx_mesh_report read_face(struct lx_raw_mesh *raw, struct lx_lines *lines)
{
    struct lx_mesh_report report = {LX_MSG_COUNT, lines->line};
    size_t count, corner;
    if (!read_whole(lines, raw->length, &count) || count < 3)
        return (struct lx_mesh_report){LX_MSG_OFF_FACE, lines->line};
    for (size_t i = 0; i < count && report.message == LX_MSG_COUNT; i++) {
        if (!read_whole(lines, SIZE_MAX / 16, &corner))
            return (struct lx_mesh_report){LX_MSG_OFF_FACE, lines->line};
        if (corner >= raw->mesh->corner_count)
            return (struct lx_mesh_report){LX_MSG_MESH_INDEX, lines->line};
        report = lx_add_to_loop(raw, (unsigned)corner, lines->line);
    }
    return report.message == LX_MSG_COUNT ? lx_add_face(raw, (unsigned)count, lines->line) : report;
}

struct lx_mesh_report lx_read_off(struct lx_raw_mesh *raw)
{
    struct lx_lines lines = {.next = raw->text, .end = raw->text + raw->length};
    size_t corners = 0, faces = 0;
    struct lx_mesh_report report = read_header(&lines, &corners, &faces);
    for (size_t i = 0; i < corners + faces && report.message == LX_MSG_COUNT; i++) {
        double corner[3];
        if (!lx_next_line(&lines))
            return (struct lx_mesh_report){LX_MSG_MESH_ENDS, lines.line};
        if (i >= corners)
            report = read_face(raw, &lines);
        else if (lx_read_corner(&lines, corner))
            report = lx_add_corner(raw, corner, lines.line);
        else
            report = (struct lx_mesh_report){LX_MSG_MESH_CORNER, lines.line};
    }
    return report;
}
