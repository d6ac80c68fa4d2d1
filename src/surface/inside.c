/* SPDX-License-Identifier: MIT */
/*
 * The sphere that is seen from inside, as an integrating sphere is: what answers for spheres with `inside: true`.  Its
 * normal points to the centre.  Whoever looks from outside sees the farther half, as backs are not drawn; light does
 * not come through its shell, on which its own elements lie, on the inner side.
 */
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/vector.h"
#include "authored.h"
#include "sheet.h"
#include "sphere.h"

/* Places that near to the shell lie on it, as a share of what they are made of. */
static const double TOUCH = 1e-12;

static struct lx_shape inside_shape(const void *parameters)
{
    const struct lx_sphere_parameters *sphere = parameters;
    const double *center = sphere->center_mm;
    struct lx_shape shape = {.type = LX_GENERAL, .kind = &lx_inside_kind, .radius_mm = sphere->radius_mm};
    memcpy(shape.anchor_mm, center, sizeof shape.anchor_mm);
    shape.touch_mm = TOUCH * (sphere->radius_mm + fabs(center[0]) + fabs(center[1]) + fabs(center[2]));
    return shape;
}

static struct lx_hit inside_hit(const struct lx_shape *sphere, const struct lx_ray *ray)
{
    struct lx_hit hit = lx_sphere_meet(sphere, ray, true);
    hit.normal = lx_negate3(hit.normal);
    return hit.exists && hit.t > 0 ? hit : (struct lx_hit){.exists = false};
}

static void inside_normal(const struct lx_shape *sphere, const double offset_mm[3], double normal[3])
{
    for (int i = 0; i < 3; i++)
        normal[i] = -offset_mm[i] / sphere->radius_mm;
}

/* In float64, as the kernels of spheres do it; places are brought back onto the sphere, from which rounding takes them
 * where lines of sight nearly touch it. */
static bool inside_meets(const struct lx_shape *sphere, const double from[3], const double direction[3], double *t,
                         double offset_mm[3])
{
    double w[3];
    const double a = lx_dot(direction, direction);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        w[i] = direction[j] * from[k] - direction[k] * from[j];
    }
    const double below = a * sphere->radius_mm * sphere->radius_mm - lx_dot(w, w);
    if (!(below >= 0))
        return false;
    const double root = sqrt(below);
    *t = (root - lx_dot(direction, from)) / a;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        offset_mm[i] = (w[j] * direction[k] - w[k] * direction[j] + root * direction[i]) / a;
    }
    const double share = sphere->radius_mm / sqrt(lx_dot(offset_mm, offset_mm));
    for (int i = 0; i < 3; i++)
        offset_mm[i] *= share;
    return *t > 0;
}

/* What stands outside lights nothing of it. */
static bool inside_is_dark(const struct lx_shape *sphere, const double place_mm[3])
{
    const double from[3] = {place_mm[0] - sphere->anchor_mm[0], place_mm[1] - sphere->anchor_mm[1],
                            place_mm[2] - sphere->anchor_mm[2]};
    return sqrt(lx_dot(from, from)) > sphere->radius_mm;
}

/* ---- light ---- */

static lx_bounded is_within(const struct lx_shape *sphere, lx_bounded3 from)
{
    return lx_step(lx_sub(lx_exact(sphere->radius_mm + sphere->touch_mm), lx_length3(from)), true);
}

/* Ways with one end inside cross it, those with both do not; what lies on it is inside. */
static lx_bounded inside_blocks(const struct lx_shape *sphere, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    const lx_bounded3 from = lx_sub3(place_mm, lx_exact3(sphere->anchor_mm));
    const lx_bounded starts = is_within(sphere, from);
    const lx_bounded ends = endless ? lx_exact(0) : is_within(sphere, lx_add3(from, towards));
    const lx_bounded any = lx_not(lx_both(lx_not(starts), lx_not(ends)));
    if (lx_is_zero(any))
        return lx_sphere_reached(sphere, place_mm, towards, endless);
    return lx_both(any, lx_not(lx_both(starts, ends)));
}

static bool inside_takes(const struct lx_shape *sphere, const double from[3], const double way[3], bool endless)
{
    const double reach = sphere->radius_mm + sphere->touch_mm, r2 = reach * reach;
    const double end[3] = {from[0] + way[0], from[1] + way[1], from[2] + way[2]};
    const bool starts = lx_dot(from, from) <= r2, ends = !endless && lx_dot(end, end) <= r2;
    if (starts || ends)
        return starts != ends;
    double t = fmax(-lx_dot(from, way) / lx_dot(way, way), 0), nearest[3];
    t = endless ? t : fmin(t, 1);
    for (int i = 0; i < 3; i++)
        nearest[i] = from[i] + t * way[i];
    return lx_dot(nearest, nearest) < sphere->radius_mm * sphere->radius_mm;
}

/* An element that looks out of it lies on the outer side, and loses the light from below its tangent plane. */
static lx_bounded inside_hides(const struct lx_shape *sphere, lx_bounded3 place_mm, double facing, lx_bounded3 towards,
                               bool endless)
{
    if (facing >= 0)
        return inside_blocks(sphere, place_mm, towards, endless);
    return lx_step(lx_negate(lx_dot3(lx_sub3(place_mm, lx_exact3(sphere->anchor_mm)), towards)), false);
}

static struct lx_obstacle shell_of(const struct lx_shape *sphere, bool is_around)
{
    struct lx_obstacle ball = {.type = LX_OBSTACLE_BALL, .is_around = is_around, .radius_mm = sphere->radius_mm};
    memcpy(ball.center_mm, sphere->anchor_mm, sizeof ball.center_mm);
    ball.touch_mm = sphere->touch_mm;
    return ball;
}

/* An element inside loses nothing of a source that is all inside. */
static int inside_gather(const struct lx_shape *sphere, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    double offset[3], end[3];
    if (!lx_shaft_meets_ball(shaft, sphere->anchor_mm, sphere->radius_mm))
        return 0;
    for (int i = 0; i < 3; i++) {
        offset[i] = shaft->from_mm[i] - sphere->anchor_mm[i];
        end[i] = shaft->to_mm[i] - sphere->anchor_mm[i];
    }
    const double reach = sphere->radius_mm + sphere->touch_mm;
    const bool starts = sqrt(lx_dot(offset, offset)) + shaft->from_radius_mm <= reach;
    if (starts && sqrt(lx_dot(end, end)) + shaft->to_radius_mm <= reach)
        return 0;
    const struct lx_obstacle shell = shell_of(sphere, sqrt(lx_dot(offset, offset)) <= reach);
    return lx_obstacles_append(obstacles, &shell);
}

static int inside_gather_beside(const struct lx_shape *sphere, double facing, const struct lx_obstacle *beyond,
                                const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    const struct lx_obstacle shell = shell_of(sphere, true);
    (void)shaft;
    return lx_obstacles_append(obstacles, facing >= 0 ? &shell : beyond);
}

static double inside_distance(const struct lx_shape *sphere, const double offset_mm[3], double direction[3])
{
    const double length = sqrt(lx_dot(offset_mm, offset_mm));
    for (int i = 0; i < 3; i++)
        direction[i] = length > 0 ? -offset_mm[i] / length : i == 2;
    return sphere->radius_mm - length;
}

/* ---- edges ---- */

static bool holds_within(const struct lx_shape *sphere, const double place_mm[3])
{
    const double from[3] = {place_mm[0] - sphere->anchor_mm[0], place_mm[1] - sphere->anchor_mm[1],
                            place_mm[2] - sphere->anchor_mm[2]};
    return sqrt(lx_dot(from, from)) <= sphere->radius_mm * (1 + 1e-9);
}

/* Light from one side reaches nothing on the other: its shadow has no edge there. */
static double inside_beside(const struct lx_shape *sphere, const double place[3], const double way[3], bool endless)
{
    const double end[3] = {place[0] + way[0], place[1] + way[1], place[2] + way[2]};
    const bool starts = holds_within(sphere, place), ends = !endless && holds_within(sphere, end);
    if (starts || ends)
        return starts == ends ? sphere->radius_mm : -sphere->radius_mm;
    return lx_sphere_beside(sphere, place, way, endless);
}

/* From what is inside an observer outside sees through the near half. */
static double inside_beside_sight(const struct lx_shape *sphere, const double place_mm[3], const struct lx_origin *eye)
{
    double way[3];
    if (holds_within(sphere, place_mm))
        return sphere->radius_mm;
    const bool endless = lx_way_to(eye, place_mm, way);
    return inside_beside(sphere, place_mm, way, endless);
}

static bool stands_within(const struct lx_shape *sphere, const struct lx_origin *eye)
{
    return !eye->endless && holds_within(sphere, eye->at);
}

/* To an observer inside it is all around: the outline is a ring beside him, far outside of any screen. */
static void inside_outline(const struct lx_shape *sphere, const struct lx_origin *eye, int i, int steps,
                           double place_mm[3], double inside_mm[3])
{
    if (!stands_within(sphere, eye)) {
        lx_sphere_outline(sphere, eye, i, steps, place_mm, inside_mm);
        return;
    }
    const double turn = 2 * M_PI * i / steps, beside[3] = {cos(turn), sin(turn), -2e-3};
    for (int k = 0; k < 3; k++) {
        place_mm[k] = eye->at[k] + 2 * sphere->radius_mm * beside[k];
        inside_mm[k] = eye->at[k] + sphere->radius_mm * beside[k];
    }
}

/* ---- coordinates: the direction from the centre ---- */

static void locate_inside(const struct lx_shape *sphere, const double offset_mm[3], const double normal[3],
                          double at[3])
{
    (void)sphere, (void)offset_mm;
    for (int i = 0; i < 3; i++)
        at[i] = -normal[i];
    lx_normalize(at);
}

static void place_inside(const struct lx_shape *sphere, const double at[3], double place_mm[3], double normal[3])
{
    for (int i = 0; i < 3; i++) {
        place_mm[i] = sphere->anchor_mm[i] + sphere->radius_mm * at[i];
        normal[i] = -at[i];
    }
}

static void element_inside(const struct lx_shape *sphere, const double at[3], lx_bounded3 *place_mm,
                           lx_bounded3 *normal)
{
    const lx_bounded3 outwards = lx_unit3(lx_exact3(at));
    *normal = lx_negate3(outwards);
    *place_mm = lx_add3(lx_exact3(sphere->anchor_mm), lx_mul3(outwards, lx_exact(sphere->radius_mm)));
}

/* What is seen from outside is the rest of what faces the observer. */
static double wall_inside(const struct lx_shape *sphere, const struct lx_origin *eye, unsigned i, const double at[3])
{
    double front[3];
    (void)i;
    if (stands_within(sphere, eye))
        return sphere->radius_mm;
    const double rim = lx_sphere_front(sphere, eye, front);
    return sphere->radius_mm * (rim - lx_dot(at, front));
}

static void rim_inside(const struct lx_shape *sphere, const struct lx_origin *eye, int i, int count, double at[3])
{
    const struct lx_origin above = {.endless = true, .at = {0, 0, 1}};
    lx_sphere_rim(sphere, stands_within(sphere, eye) ? &above : eye, i, count, at);
}

static void middle_inside(const struct lx_shape *sphere, const struct lx_origin *eye, double at[3])
{
    const struct lx_origin above = {.endless = true, .at = {0, 0, 1}};
    lx_sphere_front(sphere, stands_within(sphere, eye) ? &above : eye, at);
    for (int i = 0; i < 3; i++)
        at[i] = -at[i];
}

static bool is_near_limb(const struct lx_shape *sphere, const struct lx_origin *eye, const double at[3],
                         double inside_mm[3])
{
    double front[3];
    memcpy(inside_mm, sphere->anchor_mm, 3 * sizeof *inside_mm);
    if (stands_within(sphere, eye))
        return false;
    const double rim = lx_sphere_front(sphere, eye, front);
    return lx_dot(at, front) > rim - 1e-3;
}

/* Where a light within is nearest, and farthest. */
static int guess_inside(const struct lx_shape *sphere, const struct lx_origin *light, const struct lx_origin *viewer,
                        bool for_least, double at[LX_MOST_GUESSES][3])
{
    (void)viewer, (void)for_least;
    lx_way_to(light, sphere->anchor_mm, at[0]);
    if (!(lx_normalize(at[0]) > 0))
        at[0][2] = 1;
    for (int i = 0; i < 3; i++)
        at[1][i] = -at[0][i];
    return 2;
}

static const struct lx_surface_chart inside_chart = {
    .locate = locate_inside,
    .place = place_inside,
    .element = element_inside,
    .directions = lx_sphere_directions,
    .move = lx_sphere_move,
    .walls = 1,
    .wall = wall_inside,
    .rim = rim_inside,
    .middle = middle_inside,
    .is_near_limb = is_near_limb,
    .guess = guess_inside,
};

static int inside_sheets(const struct lx_shape *sphere, struct lx_smooth_sheet *sheets)
{
    return lx_sheets_of_ball(sphere, true, sheets);
}

static const struct lx_surface_words inside_words = {
    .height = "z = z_C - \\sqrt{R^2 - (x - x_C)^2 - (y - y_C)^2}",
    .height_in_numbers = "@Z - \\sqrt{@R^2 - (@x - @X)^2 - (@y - @Y)^2} = @z",
    .normal = "\\frac{\\mathbf{C} - \\mathbf{P}}{R}",
    .sentence = LX_N("The normal of a sphere with the centre {0} and the radius {1} that is seen from inside is {2}."),
    .formulas = {"\\mathbf{C}", "R", "\\mathbf{N} = (\\mathbf{C} - \\mathbf{P}) / R"},
};

/* Its parameters are those of spheres, and `sphere` is what it is called. */
const struct lx_surface_kind lx_inside_kind = {
    .variant = {.name = "sphere"},
    .extent = lx_sphere_extent,
    .farthest = lx_sphere_farthest,
    .shape = inside_shape,
    .hit = inside_hit,
    .meets = inside_meets,
    .blocks = inside_blocks,
    .takes = inside_takes,
    .holds = lx_sphere_holds,
    .normal = inside_normal,
    .hides_itself = true,
    .hides = inside_hides,
    .gather = inside_gather,
    .gather_beside = inside_gather_beside,
    .standing = lx_standing_within,
    .is_dark = inside_is_dark,
    .distance = inside_distance,
    .beside_sight = inside_beside_sight,
    .beside = inside_beside,
    .shadow_edges = 2,
    .shadow_edge = lx_sphere_shadow_edge,
    .outline = inside_outline,
    .sheets = inside_sheets,
    .chart = &inside_chart,
    .words = &inside_words,
};
