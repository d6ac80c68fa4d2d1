/* SPDX-License-Identifier: MIT */
/*
 * Reading OFF: a header, corners, faces.  Programs put each corner and face on a line of its own, with colours and the
 * like behind them, or let lines end anywhere; the one is tried first, then the other.
 */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "mesh_read.h"

/* What the word before the numbers says. */
struct header {
    size_t extra;     /* numbers behind the place of a corner */
    bool has_normals; /* the first three of them are a normal */
    size_t letters;   /* length of the word up to its end OFF */
    bool is_known;
};

/* OFF in any case, with letters before it that say what follows the places of corners, and perhaps digits behind it. */
static struct header judge_word(const char *word, size_t length)
{
    struct header header = {0};
    for (size_t i = 0; i < length;) {
        if (length - i >= 3 && strncasecmp(word + i, "OFF", 3) == 0) {
            header.letters = i + 3;
            header.is_known = i + 3 == length || strspn(word + i + 3, "0123456789") >= length - i - 3;
            return header;
        }
        char letter = (char)(word[i] & ~0x20);
        bool is_texture = letter == 'S' && i + 1 < length && (word[i + 1] & ~0x20) == 'T';
        if (!is_texture && letter != 'C' && letter != 'N' && word[i] != '4')
            return header;
        header.extra += is_texture ? 2 : letter == 'C' ? 4 : 3;
        header.has_normals = header.has_normals || letter == 'N';
        i += 1 + is_texture;
    }
    return header;
}

bool lx_is_off_word(const char *word, size_t length)
{
    return judge_word(word, length).is_known;
}

/* A whole number of at most `most`; false, and nothing is taken, where there is none. */
static bool take_whole(const char *word, size_t length, size_t most, size_t *number)
{
    *number = 0;
    for (size_t i = 0; i < length; i++) {
        if (word[i] < '0' || word[i] > '9')
            return false;
        *number = *number * 10 + (size_t)(word[i] - '0');
        if (*number > most)
            return false;
    }
    return length > 0;
}

struct off {
    struct lx_raw_mesh *raw;
    struct lx_lines lines;
    struct header header;
    size_t corners, faces;
    bool is_free; /* lines end anywhere */
};

/* The next word, of the line or, where lines end anywhere, of the file. */
static bool next_word(struct off *off, const char **word, size_t *length)
{
    while (!lx_next_word(&off->lines, word, length))
        if (!off->is_free || !lx_next_line(&off->lines))
            return false;
    return true;
}

static bool next_whole(struct off *off, size_t most, size_t *number)
{
    const char *word;
    size_t length;
    return next_word(off, &word, &length) && take_whole(word, length, most, number);
}

static struct lx_mesh_report say(const struct off *off, enum lx_message message)
{
    return lx_mesh_fault(message, off->lines.line);
}

/* The word OFF, if it is there, without digits that are joined to it; what kind of file is not read is told. */
static struct lx_mesh_report read_word(struct off *off)
{
    const char *word;
    size_t length;
    struct lx_lines before = off->lines;
    if (!next_word(off, &word, &length))
        return say(off, LX_MSG_MESH_ENDS);
    off->header = judge_word(word, length);
    if (!off->header.is_known) {
        off->lines = before;
        return say(off, LX_MSG_COUNT);
    }
    const char *off_word = word + off->header.letters - 3; /* n means another thing than N, where case tells */
    bool is_other =
        memchr(word, '4', off->header.letters) || (*off_word == 'O' && memchr(word, 'n', off->header.letters - 3));
    if (is_other)
        return say(off, LX_MSG_OFF_DIMENSIONS);
    off->lines.at = word + off->header.letters;
    before = off->lines;
    if (lx_next_word(&before, &word, &length) && length == 6 && strncasecmp(word, "BINARY", 6) == 0)
        return say(off, LX_MSG_OFF_BINARY);
    return say(off, LX_MSG_COUNT);
}

/* The numbers of corners and faces; that of edges may be missing at the end of a line. */
static struct lx_mesh_report read_counts(struct off *off)
{
    size_t edges;
    struct lx_lines rest = off->lines;
    const char *word;
    size_t length;
    if (!off->is_free && !lx_next_word(&rest, &word, &length) && !lx_next_line(&off->lines))
        return say(off, LX_MSG_MESH_ENDS);
    if (!next_whole(off, SIZE_MAX / 16, &off->corners) || !next_whole(off, SIZE_MAX / 16, &off->faces) ||
        (off->is_free && !next_whole(off, SIZE_MAX / 16, &edges)))
        return say(off, LX_MSG_MESH_COUNTS);
    if (off->corners > LX_MOST_CORNERS || off->faces > LX_MOST_FACES)
        return say(off, LX_MSG_MESH_TOO_LARGE);
    return say(off, LX_MSG_COUNT);
}

static struct lx_mesh_report read_corner(struct off *off)
{
    double corner[3], normal[3] = {0, 0, 0}, number;
    bool is_whole = true;
    const char *word;
    size_t length;
    for (int i = 0; i < 3; i++) {
        if (!next_word(off, &word, &length))
            return say(off, off->is_free ? LX_MSG_MESH_ENDS : LX_MSG_MESH_CORNER);
        if (!lx_read_place(off->raw, word, length, &corner[i]))
            return say(off, LX_MSG_MESH_CORNER);
    }
    for (size_t i = 0; i < (off->is_free ? off->header.extra : off->header.has_normals ? 3 : 0); i++) {
        const bool is_number = next_word(off, &word, &length) && lx_read_number(word, length, &number);
        if (!is_number && off->is_free)
            return say(off, LX_MSG_MESH_CORNER);
        is_whole = is_whole && is_number;
        if (i < 3 && is_number)
            normal[i] = number;
    }
    if (off->header.has_normals) {
        const double none[3] = {0, 0, 0};
        const struct lx_mesh_report report = lx_add_normal(off->raw, is_whole ? normal : none, off->lines.line);
        if (report.message != LX_MSG_COUNT)
            return report;
    }
    return lx_add_corner(off->raw, corner, off->lines.line);
}

static struct lx_mesh_report read_face(struct off *off)
{
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_COUNT, off->lines.line);
    size_t count, corner;
    const char *word;
    size_t length;
    if (!next_word(off, &word, &length))
        return say(off, off->is_free ? LX_MSG_MESH_ENDS : LX_MSG_OFF_FACE);
    if (!take_whole(word, length, off->raw->length, &count))
        return say(off, LX_MSG_OFF_FACE);
    report.line = off->lines.line;
    for (size_t i = 0; i < count && report.message == LX_MSG_COUNT; i++) {
        if (!next_whole(off, SIZE_MAX / 16, &corner))
            return say(off, LX_MSG_OFF_FACE);
        if (corner >= off->raw->mesh->corner_count)
            return say(off, LX_MSG_MESH_INDEX);
        const unsigned normal = off->header.has_normals ? (unsigned)corner : LX_NO_NORMAL;
        report = lx_add_to_loop(off->raw, (unsigned)corner, normal, report.line);
    }
    return report.message == LX_MSG_COUNT ? lx_add_face(off->raw, (unsigned)count, report.line) : report;
}

/* Reads it one way. */
static struct lx_mesh_report read_all(struct lx_raw_mesh *raw, bool is_free)
{
    struct off off = {.raw = raw, .lines = {.next = raw->text, .end = raw->text + raw->length}};
    const char *word;
    size_t length;
    lx_next_line(&off.lines);
    struct lx_mesh_report report = read_word(&off);
    off.is_free = is_free;
    if (report.message == LX_MSG_COUNT)
        report = read_counts(&off);
    for (size_t i = 0; i < off.corners + off.faces && report.message == LX_MSG_COUNT; i++) {
        if (!is_free && !lx_next_line(&off.lines))
            return say(&off, LX_MSG_MESH_ENDS);
        report = i < off.corners ? read_corner(&off) : read_face(&off);
    }
    if (report.message == LX_MSG_COUNT && is_free && next_word(&off, &word, &length))
        report = say(&off, LX_MSG_OFF_FACE);
    return report;
}

/* Forgets what was read, and its digits. */
static void begin_again(struct lx_raw_mesh *raw)
{
    struct lx_mesh *mesh = raw->mesh;
    mesh->corner_count = mesh->face_count = mesh->normal_count = raw->loop_count = 0;
    free(mesh->turns);
    mesh->turns = NULL;
    raw->turn_capacity = 0;
    mesh->face_total = 0;
    mesh->thin = (struct lx_mesh_note){0};
    raw->digits = (struct lx_digits){0};
}

struct lx_mesh_report lx_read_off(struct lx_raw_mesh *raw)
{
    struct lx_mesh_report by_lines = read_all(raw, false);
    if (by_lines.message == LX_MSG_COUNT || by_lines.message == LX_MSG_OUT_OF_MEMORY ||
        by_lines.message == LX_MSG_OFF_DIMENSIONS || by_lines.message == LX_MSG_OFF_BINARY)
        return by_lines;
    begin_again(raw);
    struct lx_mesh_report anywhere = read_all(raw, true);
    return anywhere.message == LX_MSG_COUNT || anywhere.message == LX_MSG_OUT_OF_MEMORY ? anywhere : by_lines;
}
