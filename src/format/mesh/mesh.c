/* SPDX-License-Identifier: MIT */
/* Meshes: which reader a file is for, and what the readers have in common. */
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/encoding.h"
#include "../../base/ending.h"
#include "../../base/memory.h"
#include "mesh_read.h"

void lx_mesh_free(struct lx_kept *kept)
{
    struct lx_mesh *mesh = (struct lx_mesh *)kept;
    free(mesh->corners);
    free(mesh->loop);
    free(mesh->counts);
    free(mesh->origins);
    free(mesh->normals);
    free(mesh->turns);
    for (size_t i = 0; i < mesh->file_count; i++)
        free(mesh->files[i].path);
    free(mesh->files);
    for (size_t i = 0; i < LX_MESH_MADE; i++)
        lx_kept_slot_free(mesh->made[i]);
    lx_kept_release(mesh->body);
    free(mesh);
}

struct lx_mesh_report lx_mesh_fault(enum lx_message message, size_t line)
{
    return (struct lx_mesh_report){.message = message, .line = line};
}

/* ---- what is read ---- */

/* Notes the digits of what is a number. */
static void note_digits(struct lx_digits *digits, const char *word, size_t length, double value)
{
    int decimals = 0, significant = 0;
    bool in_fraction = false;
    size_t i = 0;
    for (; i < length && word[i] != 'e' && word[i] != 'E'; i++) {
        in_fraction = in_fraction || word[i] == '.';
        if (word[i] < '0' || word[i] > '9')
            continue;
        decimals += in_fraction;
        significant += significant > 0 || word[i] != '0';
    }
    digits->has_point = digits->has_point || in_fraction || i < length;
    double exponent = 0;
    if (i < length && lx_read_number(word + i + 1, length - i - 1, &exponent))
        decimals -= (int)fmax(-1000, fmin(exponent, 1000));
    digits->decimals = decimals > digits->decimals ? decimals : digits->decimals;
    digits->significant = significant > digits->significant ? significant : digits->significant;
    digits->largest = fmax(digits->largest, fabs(value));
}

/* Half a unit of the last digit that the largest number shows; 0 where all are whole. */
static double rounding_of(const struct lx_digits *digits)
{
    if (!digits->has_point || !(digits->largest > 0))
        return 0;
    double by_decimals = pow(10, -digits->decimals);
    double by_digits = pow(10, floor(log10(digits->largest)) + 1 - digits->significant);
    return 0.5 * fmax(by_decimals, by_digits);
}

bool lx_read_place(struct lx_raw_mesh *raw, const char *word, size_t length, double *value)
{
    if (!lx_read_number(word, length, value))
        return false;
    note_digits(&raw->digits, word, length, *value);
    *value += 0.0; /* -0 and 0 are one place */
    return true;
}

bool lx_read_corner(struct lx_raw_mesh *raw, struct lx_lines *lines, double corner[3])
{
    const char *word;
    size_t length;
    for (int i = 0; i < 3; i++)
        if (!lx_next_word(lines, &word, &length) || !lx_read_place(raw, word, length, &corner[i]))
            return false;
    return true;
}

struct lx_mesh_report lx_add_corner(struct lx_raw_mesh *raw, const double corner[3], size_t line)
{
    if (raw->mesh->corner_count == LX_MOST_CORNERS)
        return lx_mesh_fault(LX_MSG_MESH_TOO_LARGE, line);
    if (lx_reserve(&raw->mesh->corners, &raw->corner_capacity, raw->mesh->corner_count + 1, sizeof(double[3])) < 0)
        return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, line);
    memcpy(raw->mesh->corners[raw->mesh->corner_count++], corner, sizeof(double[3]));
    return lx_mesh_fault(LX_MSG_COUNT, line);
}

struct lx_mesh_report lx_add_normal(struct lx_raw_mesh *raw, const double normal[3], size_t line)
{
    if (raw->mesh->normal_count == 3 * (size_t)LX_MOST_CORNERS)
        return lx_mesh_fault(LX_MSG_MESH_TOO_LARGE, line);
    if (lx_reserve(&raw->mesh->normals, &raw->normal_capacity, raw->mesh->normal_count + 1, sizeof(double[3])) < 0)
        return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, line);
    memcpy(raw->mesh->normals[raw->mesh->normal_count++], normal, sizeof(double[3]));
    return lx_mesh_fault(LX_MSG_COUNT, line);
}

struct lx_mesh_report lx_add_to_loop(struct lx_raw_mesh *raw, unsigned corner, unsigned normal, size_t line)
{
    struct lx_mesh *mesh = raw->mesh;
    if (lx_reserve(&mesh->loop, &raw->loop_capacity, raw->loop_count + 1, sizeof(unsigned)) < 0)
        return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, line);
    if (normal != LX_NO_NORMAL || mesh->turns) {
        const bool is_first = !mesh->turns;
        if (lx_reserve(&mesh->turns, &raw->turn_capacity, raw->loop_count + 1, sizeof(unsigned)) < 0)
            return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, line);
        for (size_t i = 0; is_first && i < raw->loop_count; i++)
            mesh->turns[i] = LX_NO_NORMAL;
        mesh->turns[raw->loop_count] = normal;
    }
    mesh->loop[raw->loop_count++] = corner;
    return lx_mesh_fault(LX_MSG_COUNT, line);
}

struct lx_mesh_report lx_add_face(struct lx_raw_mesh *raw, unsigned corners, size_t line)
{
    struct lx_mesh *mesh = raw->mesh;
    mesh->face_total++;
    if (corners < 3) {
        raw->loop_count -= corners;
        lx_mesh_take_note(&mesh->thin, line);
        return lx_mesh_fault(LX_MSG_COUNT, line);
    }
    if (mesh->face_count == LX_MOST_FACES)
        return lx_mesh_fault(LX_MSG_MESH_TOO_LARGE, line);
    if (lx_reserve(&mesh->counts, &raw->count_capacity, mesh->face_count + 1, sizeof(unsigned)) < 0 ||
        lx_reserve(&mesh->origins, &raw->origin_capacity, mesh->face_count + 1, sizeof *mesh->origins) < 0)
        return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, line);
    mesh->counts[mesh->face_count] = corners;
    mesh->origins[mesh->face_count] = (struct lx_mesh_origin){mesh->face_total, (unsigned)line};
    mesh->face_count++;
    return lx_mesh_fault(LX_MSG_COUNT, line);
}

/* ---- reading ---- */

/* Whether a text begins as an OFF file does, or an OBJ file. */
static bool begins_as(const char *name, const char *text, size_t length, bool is_off)
{
    static const char *const keywords[] = {"v", "vn", "vt", "vp", "f", "g", "o", "s", "mtllib", "usemtl", NULL};
    struct lx_lines lines = {.next = text, .end = text + length};
    const char *word;
    size_t size;
    double number;
    if (!lx_next_line(&lines) || !lx_next_word(&lines, &word, &size))
        return !is_off && lx_has_ending(name, ".obj");
    if (is_off)
        return lx_is_off_word(word, size) || (lx_has_ending(name, ".off") && lx_read_number(word, size, &number));
    for (size_t i = 0; keywords[i]; i++)
        if (lx_word_is(word, size, keywords[i]))
            return true;
    return lx_has_ending(name, ".obj");
}

static bool is_off(const char *name, const char *text, size_t length)
{
    return begins_as(name, text, length, true);
}

static bool is_obj(const char *name, const char *text, size_t length)
{
    return begins_as(name, text, length, false);
}

/* The formats, in the order in which a file is tried: by what it begins with, and where that says nothing by the ending
 * of its name. */
static const struct format {
    bool (*fits)(const char *name, const char *text, size_t length);
    struct lx_mesh_report (*read)(struct lx_raw_mesh *raw);
    bool is_plain; /* text, with lines of its own as they come */
} formats[] = {
    {lx_is_ply, lx_read_ply, false},
    {lx_is_glb, lx_read_glb, false},
    {lx_is_binary_stl, lx_read_binary_stl, false},
    {is_off, lx_read_off, true},
    {lx_is_text_stl, lx_read_text_stl, true},
    {lx_is_gltf, lx_read_gltf, true},
    {is_obj, lx_read_obj, true},
};

/* Makes every line end in LF, and UTF-16 UTF-8; returns the text, the caller's where it is another one, or NULL. */
static char *plain_text(char *text, size_t *length)
{
    text = lx_text_of_bytes(text, length);
    if (!text)
        return NULL;
    for (char *at = text; (at = memchr(at, '\r', *length - (size_t)(at - text))) != NULL;)
        *at = at + 1 < text + *length && at[1] == '\n' ? ' ' : '\n';
    return text;
}

/* Reads a file in the first format that it fits; in `text` in the end what it was made plain in. */
static struct lx_mesh_report read_as(struct lx_raw_mesh *raw, const char *name, char **text)
{
    char *given = *text, *plain = NULL;
    size_t plain_length = raw->length;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (formats[i].is_plain && !plain) {
            plain = *text = plain_text(given, &plain_length);
            if (!plain)
                return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, 0);
        }
        raw->text = formats[i].is_plain ? plain : given;
        raw->length = formats[i].is_plain ? plain_length : raw->length;
        if (formats[i].fits(name, raw->text, raw->length))
            return formats[i].read(raw);
    }
    return lx_mesh_fault(LX_MSG_MESH_FORMAT, 0);
}

/* The largest coordinate. */
static double largest_of(const struct lx_mesh *mesh)
{
    double largest = 0;
    for (size_t i = 0; i < mesh->corner_count; i++)
        for (int k = 0; k < 3; k++)
            largest = fmax(largest, fabs(mesh->corners[i][k]));
    return largest;
}

static bool make_slots(struct lx_mesh *mesh)
{
    for (size_t i = 0; i < LX_MESH_MADE; i++) {
        mesh->made[i] = lx_kept_slot_new();
        if (!mesh->made[i])
            return false;
    }
    return true;
}

/* Whether the other files of a mesh are as they were. */
static bool is_current(const struct lx_kept *kept)
{
    const struct lx_mesh *mesh = (const struct lx_mesh *)kept;
    for (size_t i = 0; i < mesh->file_count; i++)
        if (!lx_file_is_as_before(mesh->files[i].path, &mesh->files[i].state))
            return false;
    return true;
}

struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, const struct lx_mesh_opener *opener,
                                   struct lx_mesh **mesh)
{
    struct lx_raw_mesh raw = {.mesh = lx_new_array(1, sizeof *raw.mesh), .length = length, .opener = opener};
    char *plain = text;
    if (!raw.mesh)
        return lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, 0);
    lx_kept_init(&raw.mesh->kept, lx_mesh_free);
    raw.mesh->kept.is_current = is_current;
    struct lx_mesh_report report = lx_mesh_fault(LX_MSG_OUT_OF_MEMORY, 0);
    if (make_slots(raw.mesh))
        report = read_as(&raw, name, &plain);
    if (report.message == LX_MSG_COUNT) {
        raw.mesh->rounding = rounding_of(&raw.digits);
        if (raw.rounding > 0)
            raw.mesh->rounding = fmax(raw.mesh->rounding, raw.rounding * largest_of(raw.mesh));
        report = lx_mesh_tidy(raw.mesh);
    }
    if (plain != text)
        free(plain);
    if (report.message == LX_MSG_COUNT)
        *mesh = raw.mesh;
    else
        lx_mesh_free(&raw.mesh->kept);
    return report;
}
