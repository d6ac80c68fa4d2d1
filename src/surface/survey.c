/* SPDX-License-Identifier: MIT */
/*
 * What can be said of a mesh as a body: edges that are not shared by two faces, faces that look the wrong way,
 * volume.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "solid.h"

/* A side of a face: from the lower corner to the higher one, or back. */
struct side {
    unsigned low, high, face;
    bool is_back;
};

/* Sorts sides by their corners, by counting those of each lower corner, and then the few of one by the higher. */
static int compare_sides(const void *first, const void *second)
{
    const struct side *a = first, *b = second;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->face < b->face ? -1 : a->face > b->face;
}

static bool sort_sides(struct side *sides, size_t count, size_t corners)
{
    size_t *starts = lx_new_array(corners + 1, sizeof *starts);
    struct side *sorted = lx_new_aligned(count, sizeof *sorted);
    const bool has_room = starts && sorted;
    for (size_t i = 0; has_room && i < count; i++)
        starts[sides[i].low + 1]++;
    for (size_t i = 0; has_room && i < corners; i++)
        starts[i + 1] += starts[i];
    for (size_t i = 0; has_room && i < count; i++)
        sorted[starts[sides[i].low]++] = sides[i];
    for (size_t i = 0, end = 0; has_room && i < count; i = end) {
        while (end < count && sorted[end].low == sorted[i].low)
            end++;
        if (end - i > 1)
            qsort(sorted + i, end - i, sizeof *sorted, compare_sides);
    }
    if (has_room)
        memcpy(sides, sorted, count * sizeof *sides);
    free(starts);
    free(sorted);
    return has_room;
}

/* The set that a face is in: sets are trees of their members. */
static unsigned root_of(unsigned *sets, unsigned face)
{
    while (sets[face] != face)
        face = sets[face] = sets[sets[face]];
    return face;
}

static void take_edge(const struct lx_mesh *mesh, const struct side *sides, size_t count, unsigned *sets,
                      struct lx_mesh_survey *survey)
{
    const struct lx_mesh_origin origin = mesh->origins[sides[0].face];
    survey->edges++;
    for (size_t i = 1; i < count; i++)
        sets[root_of(sets, sides[i].face)] = root_of(sets, sides[0].face);
    if (count == 1 && survey->open++ == 0)
        survey->open_at = origin;
    if (count > 2 && survey->crowded++ == 0)
        survey->crowded_at = origin;
    if (count == 2 && sides[0].is_back == sides[1].is_back && survey->flipped++ == 0)
        survey->flipped_at = mesh->origins[sides[1].face];
}

/* Six times the volume between a face and a place, in the unit of the mesh. */
static double volume_of(const struct lx_mesh *mesh, const unsigned *loop, unsigned count, const double origin[3])
{
    double sum = 0, first[3];
    for (int k = 0; k < 3; k++)
        first[k] = mesh->corners[loop[0]][k] - origin[k];
    for (unsigned i = 1; i + 1 < count; i++) {
        double b[3], c[3];
        for (int k = 0; k < 3; k++)
            b[k] = mesh->corners[loop[i]][k] - origin[k], c[k] = mesh->corners[loop[i + 1]][k] - origin[k];
        sum += first[0] * (b[1] * c[2] - b[2] * c[1]) + first[1] * (b[2] * c[0] - b[0] * c[2]) +
               first[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
}

static void count_parts(unsigned *sets, size_t faces, struct lx_mesh_survey *survey)
{
    for (unsigned i = 0; i < faces; i++)
        survey->parts += root_of(sets, i) == i;
}

bool lx_survey_mesh(const struct lx_mesh *mesh, struct lx_mesh_survey *survey)
{
    size_t count = 0, at = 0, made = 0;
    for (size_t i = 0; i < mesh->face_count; i++)
        count += mesh->counts[i];
    struct side *sides = lx_new_aligned(count, sizeof *sides);
    unsigned *sets = lx_new_aligned(mesh->face_count, sizeof *sets);
    *survey = (struct lx_mesh_survey){.triangles = count - 2 * mesh->face_count, .corners = mesh->corner_count};
    for (size_t i = 0; sides && sets && i < mesh->face_count; at += mesh->counts[i++]) {
        const unsigned *loop = mesh->loop + at;
        sets[i] = (unsigned)i;
        survey->volume += volume_of(mesh, loop, mesh->counts[i], mesh->corners[0]) / 6;
        for (unsigned k = 0; k < mesh->counts[i]; k++) {
            const unsigned a = loop[k], b = loop[k + 1 < mesh->counts[i] ? k + 1 : 0];
            sides[made++] = (struct side){a < b ? a : b, a < b ? b : a, (unsigned)i, a > b};
        }
    }
    const bool is_good = sides && sets && sort_sides(sides, count, mesh->corner_count);
    for (size_t i = 0, end = 0; is_good && i < count; i = end) {
        while (end < count && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
            end++;
        take_edge(mesh, sides + i, end - i, sets, survey);
    }
    survey->euler = (long)survey->corners - (long)survey->edges + (long)mesh->face_count;
    if (is_good)
        count_parts(sets, mesh->face_count, survey);
    free(sides);
    free(sets);
    return is_good;
}
