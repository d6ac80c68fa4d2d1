/* SPDX-License-Identifier: MIT */
/*
 * Surveys of meshes: their sides are sorted by the corners that they join, which brings those of an edge together;
 * faces are put into sets of those that share edges, and of those that share them with one other face alone.
 */
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "mesh_survey.h"

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

/* Faces by what they go on with over edges of two: a face points to another one of its sheet, and says whether it
 * looks to the other side than that. */
struct link {
    unsigned towards;
    bool is_turned;
};

/* The face that all of a sheet point to in the end; *is_turned: whether this one looks to the other side. */
static unsigned sheet_of(struct link *links, unsigned face, bool *is_turned)
{
    bool turned = false;
    *is_turned = false;
    while (links[face].towards != face) {
        struct link *link = &links[face];
        const struct link next = links[link->towards];
        if (next.towards != link->towards) {
            link->is_turned ^= next.is_turned;
            link->towards = next.towards;
        }
        turned ^= link->is_turned;
        face = link->towards;
    }
    *is_turned = turned;
    return face;
}

/* Joins the sheets of two faces that share an edge; `flipped`: both run along it the same way. */
static void join_sheets(struct link *links, unsigned first, unsigned second, bool flipped,
                        struct lx_mesh_survey *survey)
{
    bool first_turned, second_turned;
    const unsigned a = sheet_of(links, first, &first_turned), b = sheet_of(links, second, &second_turned);
    const bool is_turned = first_turned != (second_turned != flipped);
    if (a == b)
        survey->is_one_sided |= is_turned;
    else
        links[b] = (struct link){a, is_turned};
}

/* Faces that look to the other side than most of their sheet. */
static bool count_turned(const struct lx_mesh *mesh, struct link *links, struct lx_mesh_survey *survey)
{
    unsigned(*votes)[2] = lx_new_array(mesh->face_count, sizeof *votes);
    bool is_turned;
    for (unsigned i = 0; votes && i < mesh->face_count; i++) {
        const unsigned sheet = sheet_of(links, i, &is_turned);
        votes[sheet][is_turned]++;
    }
    for (unsigned i = 0; votes && i < mesh->face_count; i++) {
        const unsigned sheet = sheet_of(links, i, &is_turned);
        if (is_turned == (votes[sheet][1] > votes[sheet][0]) || survey->turned_faces++ > 0)
            continue;
        survey->turned_at = mesh->origins[i];
    }
    free(votes);
    return votes || mesh->face_count == 0;
}

static void take_edge(const struct lx_mesh *mesh, const struct side *sides, size_t count, unsigned *sets,
                      struct link *links, struct lx_mesh_survey *survey)
{
    const struct lx_mesh_origin origin = mesh->origins[sides[0].face];
    survey->edges++;
    for (size_t i = 1; i < count; i++)
        sets[root_of(sets, sides[i].face)] = root_of(sets, sides[0].face);
    if (count == 2)
        join_sheets(links, sides[0].face, sides[1].face, sides[0].is_back == sides[1].is_back, survey);
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

/* The sides of all faces; adds up the volume. */
static void make_sides(const struct lx_mesh *mesh, struct side *sides, struct lx_mesh_survey *survey)
{
    size_t at = 0;
    for (size_t i = 0; i < mesh->face_count; at += mesh->counts[i++]) {
        const unsigned *loop = mesh->loop + at;
        survey->volume += volume_of(mesh, loop, mesh->counts[i], mesh->corners[0]) / 6;
        for (unsigned k = 0; k < mesh->counts[i]; k++) {
            const unsigned a = loop[k], b = loop[k + 1 < mesh->counts[i] ? k + 1 : 0];
            *sides++ = (struct side){a < b ? a : b, a < b ? b : a, (unsigned)i, a > b};
        }
    }
}

bool lx_survey_mesh(const struct lx_mesh *mesh, struct lx_mesh_survey *survey)
{
    size_t count = 0;
    for (size_t i = 0; i < mesh->face_count; i++)
        count += mesh->counts[i];
    struct side *sides = lx_new_aligned(count, sizeof *sides);
    unsigned *sets = lx_new_aligned(mesh->face_count, sizeof *sets);
    struct link *links = lx_new_aligned(mesh->face_count, sizeof *links);
    *survey = (struct lx_mesh_survey){.triangles = count - 2 * mesh->face_count, .corners = mesh->corner_count};
    bool is_good = sides && sets && links;
    if (is_good)
        make_sides(mesh, sides, survey);
    for (unsigned i = 0; is_good && i < mesh->face_count; i++)
        sets[i] = i, links[i] = (struct link){i, false};
    is_good = is_good && sort_sides(sides, count, mesh->corner_count);
    for (size_t i = 0, end = 0; is_good && i < count; i = end) {
        while (end < count && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
            end++;
        take_edge(mesh, sides + i, end - i, sets, links, survey);
    }
    survey->euler = (long)survey->corners - (long)survey->edges + (long)mesh->face_count;
    is_good = is_good && count_turned(mesh, links, survey);
    if (is_good)
        count_parts(sets, mesh->face_count, survey);
    free(sides);
    free(sets);
    free(links);
    return is_good;
}
