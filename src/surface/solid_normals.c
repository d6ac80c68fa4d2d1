/* SPDX-License-Identifier: MIT */
/*
 * Normals to shade a mesh by: those of its file, or at each corner the mean of the faces around it that are within the
 * crease of the one that it is a corner of, weighted by their angles there (Thürmer, Wüthrich 1998).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "solid.h"

static void free_normals(struct lx_kept *kept)
{
    struct lx_mesh_normals *normals = (struct lx_mesh_normals *)kept;
    free(normals->normals);
    free(normals->of);
    free(normals);
}

struct making {
    const struct lx_mesh *mesh;
    const struct lx_solid *solid;
    struct lx_mesh_normals *made;
    size_t capacity;
};

/* The corner k of a triangle in the file. */
static unsigned corner_of(const struct making *making, size_t triangle, int k)
{
    return making->mesh->loop[making->solid->places[triangle][k]];
}

/* The normal of a triangle, of the length 1. */
static void own_normal(const struct making *making, size_t triangle, double normal[3])
{
    const double *corners[3];
    double first[3], second[3];
    for (int k = 0; k < 3; k++)
        corners[k] = making->mesh->corners[corner_of(making, triangle, k)];
    for (int k = 0; k < 3; k++)
        first[k] = corners[1][k] - corners[0][k], second[k] = corners[2][k] - corners[0][k];
    lx_normalize(first);
    lx_normalize(second);
    for (int k = 0; k < 3; k++) {
        const int y = (k + 1) % 3, z = (k + 2) % 3;
        normal[k] = first[y] * second[z] - first[z] * second[y];
    }
    lx_normalize(normal);
}

static bool add_normal(struct making *making, const double normal[3], unsigned *number)
{
    struct lx_mesh_normals *made = making->made;
    if (lx_reserve(&made->normals, &making->capacity, made->count + 1, sizeof *made->normals))
        return false;
    memcpy(made->normals[made->count], normal, sizeof(double[3]));
    *number = (unsigned)made->count++;
    return true;
}

/* ---- those of the file ---- */

static bool is_direction(const double normal[3])
{
    const double square = lx_dot(normal, normal);
    return square > 0 && square < HUGE_VAL;
}

/* The normals of a triangle, all three of them, turned as its corners run; false: memory ran out. */
static bool take_from_file(struct making *making, size_t triangle)
{
    const struct lx_mesh *mesh = making->mesh;
    unsigned *of = making->made->of[triangle];
    double own[3], sum = 0, taken[3][3];
    own_normal(making, triangle, own);
    for (int k = 0; k < 3; k++) {
        const unsigned turn = mesh->turns[making->solid->places[triangle][k]];
        if (turn == LX_NO_NORMAL || !is_direction(mesh->normals[turn]))
            return true;
        memcpy(taken[k], mesh->normals[turn], sizeof taken[k]);
        lx_normalize(taken[k]);
        sum += lx_dot(taken[k], own);
    }
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3 && sum < 0; i++)
            taken[k][i] = -taken[k][i];
        if (!add_normal(making, taken[k], &of[k]))
            return false;
    }
    return true;
}

/* ---- smooth ones ---- */

/* The triangles at each corner of the mesh: those at corner i are of[first[i]] to of[first[i + 1] - 1], as 3 t + k. */
struct fans {
    size_t *first, *of;
    double (*own)[3]; /* normal of each triangle */
};

static bool make_fans(const struct making *making, struct fans *fans)
{
    const size_t corners = making->mesh->corner_count, count = making->solid->count;
    fans->first = lx_new_array(corners + 2, sizeof *fans->first);
    fans->of = lx_new_array(3 * count, sizeof *fans->of);
    fans->own = lx_new_array(count, sizeof *fans->own);
    if (!fans->first || !fans->of || !fans->own)
        return false;
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            fans->first[corner_of(making, i, k) + 2]++;
    for (size_t i = 2; i < corners + 2; i++)
        fans->first[i] += fans->first[i - 1];
    for (size_t i = 0; i < count; i++) {
        own_normal(making, i, fans->own[i]);
        for (int k = 0; k < 3; k++)
            fans->of[fans->first[corner_of(making, i, k) + 1]++] = 3 * i + (size_t)k;
    }
    return true;
}

/* The angle of a triangle at one of its corners. */
static double angle_at(const struct making *making, size_t triangle, int k)
{
    double ways[2][3];
    for (int side = 0; side < 2; side++) {
        const double *from = making->mesh->corners[corner_of(making, triangle, k)];
        const double *to = making->mesh->corners[corner_of(making, triangle, (k + 1 + side) % 3)];
        for (int i = 0; i < 3; i++)
            ways[side][i] = to[i] - from[i];
        lx_normalize(ways[side]);
    }
    return acos(fmax(-1, fmin(1, lx_dot(ways[0], ways[1]))));
}

/* Corners with more triangles are no place of a smooth surface: each triangle keeps its own normal there. */
enum { LARGEST_FAN = 512 };

/* The mean normal at a corner of a triangle; *all: of all that are there. */
static void mean_at(const struct making *making, const struct fans *fans, size_t triangle, int k, double least,
                    double mean[3], bool *all)
{
    const unsigned corner = corner_of(making, triangle, k);
    *all = fans->first[corner + 1] - fans->first[corner] <= LARGEST_FAN;
    if (!*all) {
        memcpy(mean, fans->own[triangle], sizeof(double[3]));
        return;
    }
    mean[0] = mean[1] = mean[2] = 0;
    for (size_t i = fans->first[corner]; i < fans->first[corner + 1]; i++) {
        const size_t other = fans->of[i] / 3;
        if (lx_dot(fans->own[other], fans->own[triangle]) < least) {
            *all = false;
            continue;
        }
        const double angle = angle_at(making, other, (int)(fans->of[i] % 3));
        for (int axis = 0; axis < 3; axis++)
            mean[axis] += angle * fans->own[other][axis];
    }
    if (!(lx_normalize(mean) > 0))
        memcpy(mean, fans->own[triangle], sizeof(double[3]));
}

/* Corners all of whose triangles are smooth to each other have one normal. */
static bool make_smooth(struct making *making, double crease)
{
    struct fans fans = {0};
    const double least = cos(crease * (M_PI / 180)) - 1e-12;
    unsigned *shared = lx_new_array(making->mesh->corner_count, sizeof *shared);
    bool is_good = make_fans(making, &fans) && shared;
    for (size_t i = 0; is_good && i < making->mesh->corner_count; i++)
        shared[i] = LX_NO_NORMAL;
    for (size_t i = 0; is_good && i < making->solid->count; i++)
        for (int k = 0; k < 3 && is_good; k++) {
            const unsigned corner = corner_of(making, i, k);
            double mean[3];
            bool all;
            if (shared[corner] != LX_NO_NORMAL) {
                making->made->of[i][k] = shared[corner];
                continue;
            }
            mean_at(making, &fans, i, k, least, mean, &all);
            is_good = add_normal(making, mean, &making->made->of[i][k]);
            bool is_shared = all && is_good;
            for (size_t n = fans.first[corner]; is_shared && n < fans.first[corner + 1]; n++)
                for (size_t m = fans.first[corner]; is_shared && m < n; m++)
                    is_shared = lx_dot(fans.own[fans.of[n] / 3], fans.own[fans.of[m] / 3]) >= least;
            if (is_shared)
                shared[corner] = making->made->of[i][k];
        }
    free(fans.first);
    free(fans.of);
    free(fans.own);
    free(shared);
    return is_good;
}

/* ---- keeping them ---- */

struct lx_mesh_normals *lx_normals_of(const struct lx_mesh *mesh, const struct lx_solid *solid,
                                      enum lx_solid_normals way, double crease)
{
    struct lx_mesh_normals *made = (struct lx_mesh_normals *)lx_kept_slot_look(mesh->made[LX_MESH_NORMALS]);
    if (way == LX_NORMALS_AUTO)
        way = mesh->turns ? LX_NORMALS_FILE : LX_NORMALS_FLAT;
    if (made && made->way == way && (way != LX_NORMALS_SMOOTH || made->crease == crease))
        return made;
    if (made)
        lx_kept_release(&made->kept);
    made = lx_new_array(1, sizeof *made);
    if (!made)
        return NULL;
    lx_kept_init(&made->kept, free_normals);
    made->way = way;
    made->crease = crease;
    struct making making = {.mesh = mesh, .solid = solid, .made = made};
    bool is_good = true;
    if (way != LX_NORMALS_FLAT) {
        made->of = lx_new_aligned(solid->count, sizeof *made->of);
        is_good = made->of != NULL;
        for (size_t i = 0; is_good && i < solid->count; i++)
            made->of[i][0] = made->of[i][1] = made->of[i][2] = LX_NO_NORMAL;
    }
    if (is_good && way == LX_NORMALS_SMOOTH)
        is_good = make_smooth(&making, crease);
    for (size_t i = 0; is_good && way == LX_NORMALS_FILE && mesh->turns && i < solid->count; i++)
        is_good = take_from_file(&making, i);
    if (!is_good) {
        lx_kept_release(&made->kept);
        return NULL;
    }
    lx_kept_slot_put(mesh->made[LX_MESH_NORMALS], &made->kept);
    return made;
}
