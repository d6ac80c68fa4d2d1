/* SPDX-License-Identifier: MIT */
/* Meshes: what OFF and OBJ files have in common, and corners at one place brought together. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

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

bool lx_read_corner(struct lx_lines *lines, double corner[3])
{
    const char *word;
    size_t length;
    for (int i = 0; i < 3; i++) {
        if (!lx_next_word(lines, &word, &length) || !lx_read_number(word, length, &corner[i]))
            return false;
        corner[i] += 0.0; /* -0 and 0 are one place */
    }
    return true;
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
    if (mesh->face_count == LX_MOST_FACES)
        return (struct lx_mesh_report){LX_MSG_MESH_TOO_LARGE, line};
    if (lx_reserve(&mesh->counts, &raw->count_capacity, mesh->face_count + 1, sizeof(unsigned)) < 0 ||
        lx_reserve(&mesh->origins, &raw->origin_capacity, mesh->face_count + 1, sizeof *mesh->origins) < 0)
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, line};
    mesh->counts[mesh->face_count] = corners;
    mesh->origins[mesh->face_count] = (struct lx_mesh_origin){(unsigned)mesh->face_count + 1, (unsigned)line};
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

/* For each corner the first one at its place; 0, or -1 when memory ran out. */
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

static struct lx_mesh_report finish(struct lx_mesh *mesh)
{
    unsigned *numbers = lx_new_array(mesh->corner_count, sizeof *numbers);
    if (!numbers || find_same(mesh, numbers) < 0) {
        free(numbers);
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, 0};
    }
    tidy_faces(mesh, numbers);
    drop_unused(mesh, numbers);
    free(numbers);
    return (struct lx_mesh_report){mesh->face_count ? LX_MSG_COUNT : LX_MSG_MESH_EMPTY, 0};
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

struct lx_mesh_report lx_mesh_read(const char *name, char *text, size_t length, struct lx_mesh **mesh)
{
    struct lx_raw_mesh raw = {.text = text, .length = length, .mesh = lx_new_array(1, sizeof *raw.mesh)};
    if (!raw.mesh)
        return (struct lx_mesh_report){LX_MSG_OUT_OF_MEMORY, 0};
    lx_kept_init(&raw.mesh->kept, lx_mesh_free);
    struct lx_mesh_report (*reader)(struct lx_raw_mesh *) = find_reader(name, text, length);
    struct lx_mesh_report report = reader ? reader(&raw) : (struct lx_mesh_report){LX_MSG_MESH_FORMAT, 0};
    if (report.message == LX_MSG_COUNT)
        report = finish(raw.mesh);
    if (report.message == LX_MSG_COUNT)
        *mesh = raw.mesh;
    else
        lx_mesh_free(&raw.mesh->kept);
    return report;
}
