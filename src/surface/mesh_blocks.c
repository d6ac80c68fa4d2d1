/* SPDX-License-Identifier: MIT */
/*
 * What a mesh takes light from.  The tree tells which triangles a way may cross, each of which answers for itself with
 * bounds: crossed, not crossed, in doubt.  A way through an edge leaves both triangles there in doubt although it
 * surely crosses one of them; so doubts are paired: where every edge in doubt has triangles on both of its sides, as
 * seen along the way, what they cover together has no gap there.
 *
 * A triangle that a way begins on, or so near that rounding cannot tell, is not in its way.  Whether light comes to an
 * element from behind its own face is told by `hides`.
 */
#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "mesh.h"
#include "plane.h"

bool lx_mesh_takes(const struct lx_shape *shape, const double from_mm[3], const double way[3], bool endless)
{
    const struct lx_mesh_body *body = shape->body;
    struct lx_tree_ray ray = {.from = 0, .to = endless ? HUGE_VAL : 1};
    lx_mesh_enter(shape, from_mm, ray.origin);
    lx_mesh_enter(shape, way, ray.direction);
    return lx_tree_is_met(body->tree, &ray, shape->touch_mm / lx_mesh_size_of(shape));
}

/* ---- one triangle ---- */

/* A way in the frame of the tree. */
struct way {
    lx_bounded3 place, towards;
    double at[3]; /* the place without bounds */
    double touch, length;
    bool endless;
};

static lx_bounded3 enter_bounded(const struct lx_shape *shape, lx_bounded3 vector)
{
    const lx_bounded size = lx_exact(lx_mesh_size_of(shape));
    return (lx_bounded3){lx_div(lx_dot3(lx_shape_across(shape), vector), size),
                         lx_div(lx_dot3(lx_shape_upward(shape), vector), size),
                         lx_div(lx_dot3(lx_shape_axis(shape), vector), size)};
}

static struct way way_of(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    lx_bounded3 offset = lx_sub3(place_mm, lx_exact3(shape->anchor_mm));
    offset.x.error += shape->own[1], offset.y.error += shape->own[1], offset.z.error += shape->own[1];
    struct way way = {
        .place = enter_bounded(shape, offset),
        .towards = enter_bounded(shape, towards),
        .touch = shape->touch_mm / lx_mesh_size_of(shape),
        .endless = endless,
    };
    way.at[0] = way.place.x.value, way.at[1] = way.place.y.value, way.at[2] = way.place.z.value;
    way.length = sqrt(lx_square3(way.towards).value);
    return way;
}

/* How a way and a triangle are: signs of the three determinants of its edges, 0 where they are in doubt, as seen along
 * the way; side: -1 where it runs clockwise. */
struct crossing {
    int signs[3];
    int side;
    bool may, sure_along; /* crosses it perhaps; surely, if it does not pass outside of it */
};

static int sign_of(lx_bounded a)
{
    return a.value > a.error ? 1 : a.value < -a.error ? -1 : 0;
}

/* Whether a way comes from one side of the triangle's plane to the other before it ends. */
static void judge_along(const struct way *way, lx_bounded3 corner, lx_bounded3 normal, struct crossing *crossing)
{
    const lx_bounded start = lx_dot3(normal, lx_sub3(way->place, corner));
    const lx_bounded change = lx_dot3(normal, way->towards);
    const double room = way->touch * sqrt(lx_square3(normal).value);
    const lx_bounded end = lx_add(start, change);
    const int from = sign_of(start), turn = sign_of(change);
    const bool is_beyond = way->endless || sign_of(end) == -from;
    const bool is_short = !way->endless && (sign_of(end) == from && from != 0);
    /* what ends on the triangle is not hidden by it */
    const bool touches_end = !way->endless && fabs(end.value) <= room + end.error;
    crossing->side = -turn;
    crossing->may = !is_short && !touches_end && !(from != 0 && turn == from);
    crossing->sure_along = from != 0 && turn == -from && is_beyond;
}

static struct crossing cross_triangle(const struct way *way, const struct lx_tree_triangle *triangle)
{
    struct crossing crossing = {.may = false};
    lx_bounded3 corners[3], from[3];
    if (lx_triangle_square(triangle, way->at) <= way->touch * way->touch)
        return crossing;
    for (int c = 0; c < 3; c++) {
        const double *at = triangle->corners[c];
        corners[c] = (lx_bounded3){lx_rounded(at[0], 0, 1), lx_rounded(at[1], 0, 1), lx_rounded(at[2], 0, 1)};
        from[c] = lx_sub3(corners[c], way->place);
    }
    judge_along(way, corners[0], lx_cross3(lx_sub3(corners[1], corners[0]), lx_sub3(corners[2], corners[0])),
                &crossing);
    int above = 0, below = 0;
    for (int c = 0; c < 3 && crossing.may; c++) {
        const lx_bounded volume = lx_dot3(lx_cross3(from[(c + 1) % 3], from[(c + 2) % 3]), way->towards);
        crossing.signs[c] = sign_of(volume);
        above += crossing.signs[c] > 0;
        below += crossing.signs[c] < 0;
    }
    crossing.may = crossing.may && !(above > 0 && below > 0);
    return crossing;
}

static bool is_sure(const struct crossing *crossing)
{
    return crossing->sure_along && crossing->signs[0] == crossing->signs[1] &&
           crossing->signs[1] == crossing->signs[2] && crossing->signs[0] != 0;
}

/* ---- doubts ---- */

enum { MOST_DOUBTS = 32 };

struct doubts {
    struct crossing crossings[MOST_DOUBTS];
    const struct lx_tree_triangle *triangles[MOST_DOUBTS];
    unsigned count;
    bool overflowed;
};

/* The names of the edge across from corner c, and in which sense it is run through as seen along the way. */
static int edge_of(const struct doubts *doubts, unsigned i, int c, uint32_t names[2])
{
    const struct lx_tree_triangle *triangle = doubts->triangles[i];
    const uint32_t a = triangle->names[(c + 1) % 3], b = triangle->names[(c + 2) % 3];
    names[0] = a < b ? a : b;
    names[1] = a < b ? b : a;
    return (a < b ? 1 : -1) * doubts->crossings[i].side;
}

/* Whether another triangle of the doubts lies on the other side of an edge. */
static bool is_paired(const struct doubts *doubts, unsigned i, int c)
{
    uint32_t names[2], others[2];
    const int sense = edge_of(doubts, i, c, names);
    for (unsigned j = 0; j < doubts->count; j++)
        for (int d = 0; d < 3 && j != i; d++)
            if (doubts->crossings[j].sure_along && edge_of(doubts, j, d, others) == -sense && sense != 0 &&
                others[0] == names[0] && others[1] == names[1])
                return true;
    return false;
}

/* Whether a triangle in doubt, and with it all that are joined to it by edges in doubt, leave no gap. */
static bool closes(const struct doubts *doubts, unsigned i)
{
    bool is_known[MOST_DOUBTS] = {false};
    unsigned stack[MOST_DOUBTS], depth = 1;
    stack[0] = i;
    is_known[i] = true;
    while (depth > 0) {
        const unsigned at = stack[--depth];
        for (int c = 0; c < 3; c++) {
            uint32_t names[2], others[2];
            if (doubts->crossings[at].signs[c] != 0)
                continue;
            if (!doubts->crossings[at].sure_along || !is_paired(doubts, at, c))
                return false;
            edge_of(doubts, at, c, names);
            for (unsigned j = 0; j < doubts->count; j++)
                for (int d = 0; d < 3 && !is_known[j]; d++) {
                    edge_of(doubts, j, d, others);
                    if (others[0] == names[0] && others[1] == names[1] && depth < MOST_DOUBTS) {
                        is_known[j] = true;
                        stack[depth++] = j;
                    }
                }
        }
    }
    return true;
}

static double greatest_error(lx_bounded3 a)
{
    return fmax(a.x.error, fmax(a.y.error, a.z.error));
}

lx_bounded lx_mesh_blocks(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    static const double MOST_ERROR = 1e-7; /* in the tree: boxes have room for that */
    const struct lx_mesh_body *body = shape->body;
    const struct way way = way_of(shape, place_mm, towards, endless);
    struct doubts doubts = {.count = 0};
    struct lx_tree_walk walk;
    struct lx_tree_ray ray = {.from = 0, .to = endless ? HUGE_VAL : 1};
    const struct lx_tree_triangle *triangle;
    memcpy(ray.origin, way.at, sizeof ray.origin);
    ray.direction[0] = way.towards.x.value, ray.direction[1] = way.towards.y.value,
    ray.direction[2] = way.towards.z.value;
    const double away = sqrt(lx_dot(way.at, way.at)) + body->tree->farthest;
    const double error = greatest_error(way.place) + away * greatest_error(way.towards) / way.length;
    if (!(error <= MOST_ERROR))
        return (lx_bounded){
            lx_mesh_takes(shape,
                          (double[]){place_mm.x.value - shape->anchor_mm[0], place_mm.y.value - shape->anchor_mm[1],
                                     place_mm.z.value - shape->anchor_mm[2]},
                          (double[]){towards.x.value, towards.y.value, towards.z.value}, endless),
            1};
    lx_tree_begin(&walk, body->tree, &ray);
    while ((triangle = lx_tree_next(&walk)) != NULL) {
        const struct crossing crossing = cross_triangle(&way, triangle);
        if (!crossing.may)
            continue;
        if (is_sure(&crossing))
            return lx_exact(1);
        doubts.overflowed = doubts.count == MOST_DOUBTS;
        if (doubts.overflowed)
            break;
        doubts.triangles[doubts.count] = triangle;
        doubts.crossings[doubts.count++] = crossing;
    }
    for (unsigned i = 0; i < doubts.count && !doubts.overflowed; i++)
        if (closes(&doubts, i))
            return lx_exact(1);
    return (lx_bounded){doubts.count > 0, doubts.count > 0};
}

/* Light comes from behind its own face to no element, and through the rest of the mesh to none, either. */
lx_bounded lx_mesh_hides(const struct lx_shape *shape, lx_bounded3 place_mm, double facing, lx_bounded3 towards,
                         bool endless)
{
    const struct lx_mesh_body *body = shape->body;
    const struct way way = way_of(shape, place_mm, towards, endless);
    lx_bounded3 corners[3];
    double distance;
    const struct lx_tree_triangle *triangle = lx_tree_nearest(body->tree, way.at, HUGE_VAL, &distance);
    if (!triangle)
        return lx_exact(0);
    for (int c = 0; c < 3; c++) {
        const double *at = triangle->corners[c];
        corners[c] = (lx_bounded3){lx_rounded(at[0], 0, 1), lx_rounded(at[1], 0, 1), lx_rounded(at[2], 0, 1)};
    }
    const lx_bounded3 normal = lx_cross3(lx_sub3(corners[1], corners[0]), lx_sub3(corners[2], corners[0]));
    const lx_bounded above = lx_dot3(normal, way.towards);
    const lx_bounded behind = lx_step(facing < 0 ? above : lx_negate(above), false);
    if (behind.value > 0 && behind.error == 0)
        return behind;
    return lx_not(lx_both(lx_not(behind), lx_not(lx_mesh_blocks(shape, place_mm, towards, endless))));
}
