/* SPDX-License-Identifier: MIT */
/*
 * Tidying meshes: corners at one place become one, faces that are there twice count once, and what is left of no use
 * goes.  Equal things are found by tables of hashes, with open addressing, so that a million of them take no longer
 * than a million single ones.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "mesh_read.h"

void lx_mesh_take_note(struct lx_mesh_note *about, size_t line)
{
    about->line = about->count++ ? about->line : (unsigned)line;
}

/* ---- tables of hashes ---- */

enum { EMPTY = -1 };

/* Room for items by their hashes: at least twice as many places as there are items, a power of two. */
struct table {
    int32_t *items; /* their numbers, or EMPTY */
    size_t mask;
};

static bool make_table(size_t count, struct table *table)
{
    size_t size = 16;
    while (size < 2 * count)
        size *= 2;
    table->mask = size - 1;
    table->items = lx_new_aligned(size, sizeof *table->items);
    if (table->items)
        memset(table->items, 0xff, size * sizeof *table->items);
    return table->items != NULL;
}

/* The finalizer of SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

static uint64_t hash_place(const double place[3])
{
    uint64_t bits[3];
    memcpy(bits, place, sizeof bits);
    return mix(bits[0] + mix(bits[1] + mix(bits[2])));
}

/* For each corner the first one at its place; 0, or -1 when out of memory. */
static int find_same(const struct lx_mesh *mesh, unsigned *same)
{
    struct table table;
    if (!make_table(mesh->corner_count, &table))
        return -1;
    for (size_t i = 0; i < mesh->corner_count; i++) {
        const double *place = mesh->corners[i];
        size_t at = hash_place(place) & table.mask;
        while (table.items[at] != EMPTY && memcmp(mesh->corners[table.items[at]], place, sizeof(double[3])) != 0)
            at = (at + 1) & table.mask;
        if (table.items[at] == EMPTY)
            table.items[at] = (int32_t)i;
        same[i] = (unsigned)table.items[at];
    }
    free(table.items);
    return 0;
}

/* ---- faces ---- */

/* The place of the least corner of a face, where its loop begins when faces are compared. */
static unsigned least_of(const unsigned *loop, unsigned count)
{
    unsigned least = 0;
    for (unsigned i = 1; i < count; i++)
        least = loop[i] < loop[least] ? i : least;
    return least;
}

/* The loop of a face, from its least corner on. */
struct turned {
    const unsigned *loop;
    unsigned count, least;
};

static struct turned turned_of(const unsigned *loop, unsigned count)
{
    return (struct turned){loop, count, least_of(loop, count)};
}

static unsigned turned_at(const struct turned *face, unsigned i)
{
    const unsigned at = face->least + i;
    return face->loop[at < face->count ? at : at - face->count];
}

static bool are_equal(const struct turned *a, const struct turned *b)
{
    if (a->count != b->count)
        return false;
    for (unsigned i = 0; i < a->count; i++)
        if (turned_at(a, i) != turned_at(b, i))
            return false;
    return true;
}

static uint64_t hash_face(const struct turned *face)
{
    uint64_t hash = face->count;
    for (unsigned i = 0; i < face->count; i++)
        hash = mix(hash + turned_at(face, i));
    return hash;
}

/* Moves the corners of a face towards the front of the loop. */
static void move_face(struct lx_mesh *mesh, size_t from, size_t to, unsigned count)
{
    memmove(mesh->loop + to, mesh->loop + from, count * sizeof *mesh->loop);
    if (mesh->turns)
        memmove(mesh->turns + to, mesh->turns + from, count * sizeof *mesh->turns);
}

/* Leaves out faces that were there before, with the same corners and the same side outside; false: no memory. */
static bool drop_doubled(struct lx_mesh *mesh)
{
    struct table table = {0};
    size_t *starts = lx_new_aligned(mesh->face_count + 1, sizeof *starts); /* of the faces that stay */
    size_t at = 0, kept_faces = 0, kept = 0;
    if (!starts || !make_table(mesh->face_count, &table)) {
        free(starts);
        return false;
    }
    for (size_t i = 0; i < mesh->face_count; i++) {
        const unsigned count = mesh->counts[i];
        const struct turned face = turned_of(mesh->loop + at, count);
        size_t place = hash_face(&face) & table.mask;
        for (; table.items[place] != EMPTY; place = (place + 1) & table.mask) {
            const size_t other = (size_t)table.items[place];
            const struct turned before = turned_of(mesh->loop + starts[other], mesh->counts[other]);
            if (are_equal(&face, &before))
                break;
        }
        if (table.items[place] != EMPTY) {
            lx_mesh_take_note(&mesh->doubled, mesh->origins[i].line);
        } else {
            table.items[place] = (int32_t)kept_faces;
            starts[kept_faces] = kept;
            move_face(mesh, at, kept, count);
            mesh->counts[kept_faces] = count;
            mesh->origins[kept_faces++] = mesh->origins[i];
            kept += count;
        }
        at += count;
    }
    mesh->face_count = kept_faces;
    free(table.items);
    free(starts);
    return true;
}

/* Leaves out corners that follow one at the same place, and faces of which nothing but an edge is left. */
static void tidy_faces(struct lx_mesh *mesh, const unsigned *same)
{
    size_t kept_faces = 0, kept = 0, at = 0;
    for (size_t face = 0; face < mesh->face_count; face++) {
        size_t start = kept, stop = at + mesh->counts[face];
        for (; at < stop; at++) {
            unsigned corner = same[mesh->loop[at]];
            if (kept > start && mesh->loop[kept - 1] == corner)
                continue;
            if (mesh->turns)
                mesh->turns[kept] = mesh->turns[at];
            mesh->loop[kept++] = corner;
        }
        while (kept - start > 1 && mesh->loop[kept - 1] == mesh->loop[start])
            kept--;
        if (kept - start < 3) {
            kept = start;
            lx_mesh_take_note(&mesh->thin, mesh->origins[face].line);
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

struct lx_mesh_report lx_mesh_tidy(struct lx_mesh *mesh)
{
    unsigned *numbers = lx_new_array(mesh->corner_count, sizeof *numbers);
    bool is_done = numbers && find_same(mesh, numbers) == 0 && tidy(mesh, numbers);
    free(numbers);
    if (!is_done)
        return (struct lx_mesh_report){.message = LX_MSG_OUT_OF_MEMORY};
    return (struct lx_mesh_report){.message = mesh->face_count ? LX_MSG_COUNT : LX_MSG_MESH_EMPTY};
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

void lx_mesh_sizes(const struct lx_mesh *mesh, double sizes[3])
{
    for (int k = 0; k < 3; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < mesh->corner_count; i++) {
            low = fmin(low, mesh->corners[i][k]);
            high = fmax(high, mesh->corners[i][k]);
        }
        sizes[k] = fmax(high - low, 0);
    }
}

double lx_mesh_size(const struct lx_mesh *mesh)
{
    double sizes[3];
    lx_mesh_sizes(mesh, sizes);
    return fmax(sizes[0], fmax(sizes[1], sizes[2]));
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
