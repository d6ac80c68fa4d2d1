/* SPDX-License-Identifier: MIT */
/* Making solids of meshes: triangles of faces, those without area left out, and their tree. */
#include "solid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"

static void free_solid(struct lx_kept *kept)
{
    struct lx_solid *solid = (struct lx_solid *)kept;
    if (solid->tree)
        lx_kept_release(&solid->tree->kept);
    free(solid->places);
    free(solid);
}

/* Whether three corners span no area that could be told from none: the height of the triangle over its longest side is
 * below the rounding of its place. */
static bool is_flat(const double *a, const double *b, const double *c)
{
    double first[3], second[3], third[3], size = 0;
    for (int k = 0; k < 3; k++) {
        first[k] = b[k] - a[k], second[k] = c[k] - a[k], third[k] = c[k] - b[k];
        size = fmax(size, fmax(fabs(a[k]), fmax(fabs(b[k]), fabs(c[k]))));
    }
    const double normal[3] = {first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
                              first[0] * second[1] - first[1] * second[0]};
    const double longest = sqrt(fmax(lx_dot(first, first), fmax(lx_dot(second, second), lx_dot(third, third))));
    return !(sqrt(lx_dot(normal, normal)) > 4 * 0x1p-52 * size * longest);
}

static size_t triangles_of(const struct lx_mesh *mesh, unsigned *largest)
{
    size_t count = 0;
    *largest = 0;
    for (size_t i = 0; i < mesh->face_count; i++) {
        count += mesh->counts[i] - 2;
        *largest = mesh->counts[i] > *largest ? mesh->counts[i] : *largest;
    }
    return count;
}

/* Takes over the triangles of a face that have an area. */
static void add_face(const struct lx_mesh *mesh, size_t face, size_t at, const unsigned (*cut)[3],
                     struct lx_solid *solid, unsigned (*corners)[3])
{
    for (unsigned i = 0; i + 2 < mesh->counts[face]; i++) {
        const unsigned *loop = mesh->loop + at;
        const unsigned names[3] = {loop[cut[i][0]], loop[cut[i][1]], loop[cut[i][2]]};
        if (is_flat(mesh->corners[names[0]], mesh->corners[names[1]], mesh->corners[names[2]])) {
            if (solid->flat.count++ == 0) {
                solid->flat.line = mesh->origins[face].line;
                solid->flat_face = mesh->origins[face].number;
            }
            continue;
        }
        for (int k = 0; k < 3; k++)
            solid->places[solid->count][k] = (unsigned)at + cut[i][k];
        memcpy(corners[solid->count++], names, sizeof names);
    }
}

/* Cuts all faces; false: memory ran out. */
static bool cut_faces(const struct lx_mesh *mesh, struct lx_solid *solid, unsigned (**corners)[3])
{
    unsigned largest;
    const size_t count = triangles_of(mesh, &largest);
    unsigned *room = lx_new_array(largest, sizeof *room), (*cut)[3] = lx_new_array(largest, sizeof *cut);
    size_t at = 0;
    *corners = lx_new_aligned(count, sizeof **corners);
    solid->places = lx_new_aligned(count, sizeof *solid->places);
    const bool has_room = room && cut && *corners && solid->places;
    for (size_t i = 0; has_room && i < mesh->face_count; at += mesh->counts[i++]) {
        static const unsigned whole[1][3] = {{0, 1, 2}};
        if (mesh->counts[i] > 3)
            lx_cut_polygon((const double(*)[3])mesh->corners, mesh->loop + at, mesh->counts[i], room, cut);
        add_face(mesh, i, at, mesh->counts[i] > 3 ? (const unsigned(*)[3])cut : whole, solid, *corners);
    }
    free(room);
    free(cut);
    return has_room;
}

struct lx_solid *lx_solid_of(const struct lx_mesh *mesh, bool *is_empty)
{
    struct lx_solid *solid = (struct lx_solid *)lx_kept_slot_look(mesh->made[LX_MESH_TREE]);
    *is_empty = false;
    if (solid)
        return solid;
    unsigned(*corners)[3] = NULL;
    solid = lx_new_array(1, sizeof *solid);
    if (!solid)
        return NULL;
    lx_kept_init(&solid->kept, free_solid);
    if (cut_faces(mesh, solid, &corners) && lx_survey_mesh(mesh, &solid->survey)) {
        *is_empty = solid->count == 0;
        if (!*is_empty)
            solid->tree =
                lx_mesh_tree_new((const double(*)[3])mesh->corners, (const unsigned(*)[3])corners, solid->count);
    }
    free(corners);
    if (!solid->tree) {
        lx_kept_release(&solid->kept);
        return NULL;
    }
    lx_kept_slot_put(mesh->made[LX_MESH_TREE], &solid->kept);
    return solid;
}
