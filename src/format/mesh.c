/* SPDX-License-Identifier: MIT */
/* Meshes: what OFF and OBJ files have in common, and corners at one place brought together. */
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../base/encoding.h"
#include "../base/memory.h"
#include "mesh_read.h"

void lx_mesh_free(struct lx_kept *kept)
{
    struct lx_mesh *mesh = (struct lx_mesh *)kept;
    free(mesh->corners);
    free(mesh->loop);
    free(mesh->counts);
    free(mesh->origins);
    lx_kept_release(mesh->body);
    free(mesh);
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

static void note(struct lx_mesh_note *about, size_t line)
{
    about->line = about->count++ ? about->line : (unsigned)line;
}

struct lx_mesh_report lx_add_corner(struct lx_raw_mesh *raw, const double corner[3], size_t line)
{
    if (raw->mesh->corner_count == LX_MOST_CORNERS)
        return (struct lx_mesh_report){LX_MSG_MESH_TOO_LARGE, line};
    if (lx_reserve(&raw->mesh->corners, &raw->corner_capacity, raw->mesh->corner_count + 1, sizeof(double[3])) < 0)
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, line};
    memcpy(raw->mesh->corners[raw->mesh->corner_count++], corner, sizeof(double[3]));
    return (struct lx_mesh_report){LX_MSG_COUNT, line};
}

struct lx_mesh_report lx_add_to_loop(struct lx_raw_mesh *raw, unsigned corner, size_t line)
{
    if (lx_reserve(&raw->mesh->loop, &raw->loop_capacity, raw->loop_count + 1, sizeof(unsigned)) < 0)
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, line};
    raw->mesh->loop[raw->loop_count++] = corner;
    return (struct lx_mesh_report){LX_MSG_COUNT, line};
}

struct lx_mesh_report lx_add_face(struct lx_raw_mesh *raw, unsigned corners, size_t line)
{
    struct lx_mesh *mesh = raw->mesh;
    mesh->face_total++;
    if (corners < 3) {
        raw->loop_count -= corners;
        note(&mesh->thin, line);
        return (struct lx_mesh_report){LX_MSG_COUNT, line};
    }
    if (mesh->face_count == LX_MOST_FACES)
        return (struct lx_mesh_report){LX_MSG_MESH_TOO_LARGE, line};
    if (lx_reserve(&mesh->counts, &raw->count_capacity, mesh->face_count + 1, sizeof(unsigned)) < 0 ||
        lx_reserve(&mesh->origins, &raw->origin_capacity, mesh->face_count + 1, sizeof *mesh->origins) < 0)
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, line};
    mesh->counts[mesh->face_count] = corners;
    mesh->origins[mesh->face_count] = (struct lx_mesh_origin){mesh->face_total, (unsigned)line};
    mesh->face_count++;
    return (struct lx_mesh_report){LX_MSG_COUNT, line};
}

/* ---- bringing corners together ---- */

struct place {
    double at[3];
    unsigned corner;
};

static int compare_places(const void *first, const void *second)
{
    const struct place *a = first, *b = second;
    for (int i = 0; i < 3; i++)
        if (a->at[i] != b->at[i])
            return a->at[i] < b->at[i] ? -1 : 1;
    return a->corner < b->corner ? -1 : a->corner > b->corner;
}

/* For each corner the first one at its place; 0, or -1 when out of memory. */
static int find_same(const struct lx_mesh *mesh, unsigned *same)
{
    struct place *places = lx_new_array(mesh->corner_count, sizeof *places);
    if (!places)
        return -1;
    for (size_t i = 0; i < mesh->corner_count; i++) {
        memcpy(places[i].at, mesh->corners[i], sizeof places[i].at);
        places[i].corner = (unsigned)i;
    }
    qsort(places, mesh->corner_count, sizeof *places, compare_places);
    for (size_t i = 0, first = 0; i < mesh->corner_count; i++) {
        if (memcmp(places[i].at, places[first].at, sizeof places[i].at) != 0)
            first = i;
        same[places[i].corner] = places[first].corner;
    }
    free(places);
    return 0;
}

/* The place of the least corner of a face, where its loop begins when faces are compared. */
static unsigned least_of(const unsigned *loop, unsigned count)
{
    unsigned least = 0;
    for (unsigned i = 1; i < count; i++)
        least = loop[i] < loop[least] ? i : least;
    return least;
}

/* Faces in an order in which equal ones follow each other. */
struct ordered {
    const unsigned *loop;
    unsigned count, least;
    size_t face;
};

static int compare_loops(const void *first, const void *second)
{
    const struct ordered *a = first, *b = second;
    if (a->count != b->count)
        return a->count < b->count ? -1 : 1;
    for (unsigned i = 0; i < a->count; i++) {
        unsigned one = a->loop[(a->least + i) % a->count], other = b->loop[(b->least + i) % b->count];
        if (one != other)
            return one < other ? -1 : 1;
    }
    return 0;
}

static int compare_faces(const void *first, const void *second)
{
    const struct ordered *a = first, *b = second;
    int order = compare_loops(first, second);
    return order ? order : a->face < b->face ? -1 : a->face > b->face;
}

/* Leaves out faces that were there before, with the same corners and the same side outside; false: no memory. */
static bool drop_doubled(struct lx_mesh *mesh)
{
    struct ordered *faces = lx_new_array(mesh->face_count, sizeof *faces);
    unsigned char *is_doubled = lx_new_array(mesh->face_count, 1);
    size_t at = 0, kept_faces = 0, kept = 0;
    for (size_t i = 0; faces && i < mesh->face_count; at += mesh->counts[i++])
        faces[i] = (struct ordered){mesh->loop + at, mesh->counts[i], least_of(mesh->loop + at, mesh->counts[i]), i};
    if (faces && is_doubled) {
        qsort(faces, mesh->face_count, sizeof *faces, compare_faces);
        for (size_t i = 1; i < mesh->face_count; i++)
            is_doubled[faces[i].face] = compare_loops(&faces[i - 1], &faces[i]) == 0;
        at = 0;
        for (size_t i = 0; i < mesh->face_count; i++) {
            unsigned count = mesh->counts[i];
            if (is_doubled[i]) {
                note(&mesh->doubled, mesh->origins[i].line);
            } else {
                memmove(mesh->loop + kept, mesh->loop + at, count * sizeof *mesh->loop);
                mesh->counts[kept_faces] = count;
                mesh->origins[kept_faces++] = mesh->origins[i];
                kept += count;
            }
            at += count;
        }
        mesh->face_count = kept_faces;
    }
    bool is_done = faces && is_doubled;
    free(faces);
    free(is_doubled);
    return is_done;
}

/* Leaves out corners that follow one at the same place, and faces of which nothing but an edge is left. */
static void tidy_faces(struct lx_mesh *mesh, const unsigned *same)
{
    size_t kept_faces = 0, kept = 0, at = 0;
    for (size_t face = 0; face < mesh->face_count; face++) {
        size_t start = kept, stop = at + mesh->counts[face];
        for (; at < stop; at++) {
            unsigned corner = same[mesh->loop[at]];
            if (kept == start || mesh->loop[kept - 1] != corner)
                mesh->loop[kept++] = corner;
        }
        while (kept - start > 1 && mesh->loop[kept - 1] == mesh->loop[start])
            kept--;
        if (kept - start < 3) {
            kept = start;
            note(&mesh->thin, mesh->origins[face].line);
            continue;
        }
        mesh->counts[kept_faces] = (unsigned)(kept - start);
        mesh->origins[kept_faces++] = mesh->origins[face];
    }
    mesh->face_count = kept_faces;
}

/* Leaves out the corners of no face; `numbers` has room for one number a corner. */
static void drop_unused(struct lx_mesh *mesh, unsigned *numbers)
{
    size_t loop_count = 0, kept = 0;
    for (size_t face = 0; face < mesh->face_count; face++)
        loop_count += mesh->counts[face];
    memset(numbers, 0, mesh->corner_count * sizeof *numbers);
    for (size_t i = 0; i < loop_count; i++)
        numbers[mesh->loop[i]] = 1;
    for (size_t i = 0; i < mesh->corner_count; i++) {
        if (!numbers[i])
            continue;
        numbers[i] = (unsigned)kept;
        memmove(mesh->corners[kept++], mesh->corners[i], sizeof(double[3]));
    }
    for (size_t i = 0; i < loop_count; i++)
        mesh->loop[i] = numbers[mesh->loop[i]];
    mesh->corner_count = kept;
}

/* Tidies a mesh after corners were found to be the same; false: no memory. */
static bool tidy(struct lx_mesh *mesh, unsigned *same)
{
    tidy_faces(mesh, same);
    drop_unused(mesh, same);
    return drop_doubled(mesh);
}

static struct lx_mesh_report finish(struct lx_mesh *mesh)
{
    unsigned *numbers = lx_new_array(mesh->corner_count, sizeof *numbers);
    bool is_done = numbers && find_same(mesh, numbers) == 0 && tidy(mesh, numbers);
    free(numbers);
    if (!is_done)
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, 0};
    return (struct lx_mesh_report){mesh->face_count ? LX_MSG_COUNT : LX_MSG_MESH_EMPTY, 0};
}

/* ---- corners within the rounding of others ---- */

/* A corner and the cell of a grid in which it lies. */
struct celled {
    double cell[3];
    unsigned corner;
};

static int compare_cells(const void *first, const void *second)
{
    const struct celled *a = first, *b = second;
    for (int i = 0; i < 3; i++)
        if (a->cell[i] != b->cell[i])
            return a->cell[i] < b->cell[i] ? -1 : 1;
    return a->corner < b->corner ? -1 : a->corner > b->corner;
}

/* The first corner, but none behind `corner`, of the cell that is nearer than `step` to it along each axis. */
static unsigned near_in_cell(const struct lx_mesh *mesh, const struct celled *cells, const double cell[3],
                             unsigned corner, double step)
{
    struct celled wanted = {{cell[0], cell[1], cell[2]}, 0};
    size_t low = 0, high = mesh->corner_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (compare_cells(&cells[middle], &wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    const double *place = mesh->corners[corner];
    for (; low < mesh->corner_count && cells[low].corner < corner; low++) {
        const double *at = mesh->corners[cells[low].corner];
        if (memcmp(cells[low].cell, cell, sizeof wanted.cell) != 0)
            break;
        if (fabs(at[0] - place[0]) <= step && fabs(at[1] - place[1]) <= step && fabs(at[2] - place[2]) <= step)
            return cells[low].corner;
    }
    return corner;
}

/* For each corner the first one within the step, of those that stay. */
static unsigned find_near(const struct lx_mesh *mesh, const struct celled *cells, double step, unsigned *same)
{
    unsigned joined = 0;
    for (unsigned i = 0; i < mesh->corner_count; i++) {
        same[i] = i;
        for (int k = 0; k < 27 && same[i] == i; k++) {
            double cell[3];
            for (int axis = 0, digit = k; axis < 3; axis++, digit /= 3)
                cell[axis] = floor(mesh->corners[i][axis] / (2 * step)) + (digit % 3 - 1) + 0.0;
            same[i] = same[near_in_cell(mesh, cells, cell, i, step)];
        }
        joined += same[i] != i;
    }
    return joined;
}

double lx_mesh_size(const struct lx_mesh *mesh)
{
    double size = 0;
    for (int k = 0; k < 3; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < mesh->corner_count; i++) {
            low = fmin(low, mesh->corners[i][k]);
            high = fmax(high, mesh->corners[i][k]);
        }
        size = fmax(size, high - low);
    }
    return size;
}

bool lx_mesh_join(struct lx_mesh *mesh)
{
    static const double SUMS = 1e-9; /* roundings of sums, of the size */
    double size = lx_mesh_size(mesh), step = fmax(2 * mesh->rounding * (1 + 1e-6), SUMS * size);
    struct celled *cells = lx_new_array(mesh->corner_count, sizeof *cells);
    unsigned *same = lx_new_array(mesh->corner_count, sizeof *same), joined = 0;
    if (cells && same && size > 0) {
        for (unsigned i = 0; i < mesh->corner_count; i++) {
            cells[i].corner = i;
            for (int axis = 0; axis < 3; axis++)
                cells[i].cell[axis] = floor(mesh->corners[i][axis] / (2 * step)) + 0.0;
        }
        qsort(cells, mesh->corner_count, sizeof *cells, compare_cells);
        joined = find_near(mesh, cells, step, same);
    }
    bool is_done = joined > 0 && tidy(mesh, same);
    mesh->joined += joined;
    free(cells);
    free(same);
    return is_done && mesh->face_count > 0;
}

/* ---- reading ---- */

static bool has_ending(const char *name, const char *ending)
{
    size_t length = strlen(name), wanted = strlen(ending);
    return length >= wanted && strcasecmp(name + length - wanted, ending) == 0;
}

/* The reader that the first word tells, or else the ending of the name; NULL: neither. */
static struct lx_mesh_report (*find_reader(const char *name, char *text, size_t length))(struct lx_raw_mesh *)
{
    static const char *const keywords[] = {"v", "vn", "vt", "vp", "f", "g", "o", "s", "mtllib", "usemtl", NULL};
    struct lx_lines lines = {.next = text, .end = text + length};
    const char *word;
    size_t size;
    if (!lx_next_line(&lines) || !lx_next_word(&lines, &word, &size))
        return NULL;
    double number;
    if (lx_is_off_word(word, size) || (has_ending(name, ".off") && lx_read_number(word, size, &number)))
        return lx_read_off;
    for (size_t i = 0; keywords[i]; i++)
        if (lx_word_is(word, size, keywords[i]))
            return lx_read_obj;
    return has_ending(name, ".obj") ? lx_read_obj : NULL;
}

/* Makes every line end in LF, and UTF-16 UTF-8; returns the text, the caller's where it is another one, or NULL. */
static char *plain_text(char *text, size_t *length)
{
    size_t mark;
    enum lx_encoding encoding = lx_find_encoding(text, *length, &mark);
    if (encoding != LX_UTF8) {
        text = lx_text_of_utf16(text, length, mark, encoding);
        if (!text)
            return NULL;
    } else {
        memset(text, ' ', mark);
    }
    for (char *at = text; (at = memchr(at, '\r', *length - (size_t)(at - text))) != NULL;)
        *at = at + 1 < text + *length && at[1] == '\n' ? ' ' : '\n';
    return text;
}

struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, struct lx_mesh **mesh)
{
    struct lx_raw_mesh raw = {.mesh = lx_new_array(1, sizeof *raw.mesh)};
    char *plain = plain_text(text, &length);
    if (!raw.mesh || !plain) {
        free(raw.mesh);
        free(plain != text ? plain : NULL);
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, 0};
    }
    raw.text = plain;
    raw.length = length;
    lx_kept_init(&raw.mesh->kept, lx_mesh_free);
    struct lx_mesh_report (*reader)(struct lx_raw_mesh *) = find_reader(name, plain, length);
    struct lx_mesh_report report = reader ? reader(&raw) : (struct lx_mesh_report){LX_MSG_MESH_FORMAT, 0};
    if (report.message == LX_MSG_COUNT) {
        raw.mesh->rounding = rounding_of(&raw.digits);
        report = finish(raw.mesh);
    }
    if (plain != text)
        free(plain);
    if (report.message == LX_MSG_COUNT)
        *mesh = raw.mesh;
    else
        lx_mesh_free(&raw.mesh->kept);
    return report;
}
