/* SPDX-License-Identifier: MIT */
/*
 * Coordinates on the side of a cylinder, in which extrema are looked for and its outline is drawn: the cosine and sine
 * of the angle about the axis, from `across` to `upward`, and the height along it in mm.
 */
#include <math.h>

#include "cylinder.h"

static void locate_on_cylinder(const struct lx_shape *cylinder, const double offset_mm[3], const double normal[3],
                               double at[3])
{
    at[0] = lx_dot(normal, cylinder->across), at[1] = lx_dot(normal, cylinder->upward);
    const double length = hypot(at[0], at[1]);
    at[0] /= length, at[1] /= length;
    at[2] = lx_dot(offset_mm, cylinder->axis);
}

static void place_on_cylinder(const struct lx_shape *cylinder, const double at[3], double place_mm[3], double normal[3])
{
    for (int i = 0; i < 3; i++) {
        normal[i] = at[0] * cylinder->across[i] + at[1] * cylinder->upward[i];
        place_mm[i] = cylinder->anchor_mm[i] + lx_cylinder_radius(cylinder) * normal[i] + at[2] * cylinder->axis[i];
    }
}

static void element_on_cylinder(const struct lx_shape *cylinder, const double at[3], lx_bounded3 *place_mm,
                                lx_bounded3 *normal)
{
    const lx_bounded3 unit = lx_unit3(lx_exact3((const double[]){at[0], at[1], 0}));
    *normal = lx_add3(lx_mul3(lx_shape_across(cylinder), unit.x), lx_mul3(lx_shape_upward(cylinder), unit.y));
    const lx_bounded3 offset = lx_add3(lx_mul3(*normal, lx_exact(lx_cylinder_radius(cylinder))),
                                       lx_mul3(lx_shape_axis(cylinder), lx_exact(at[2])));
    *place_mm = lx_add3(lx_exact3(cylinder->anchor_mm), offset);
}

static void directions_on_cylinder(const struct lx_shape *cylinder, const double at[3], double first[3],
                                   double second[3])
{
    (void)cylinder;
    first[0] = -at[1], first[1] = at[0], first[2] = 0;
    second[0] = second[1] = 0, second[2] = 1;
}

static void move_on_cylinder(const struct lx_shape *cylinder, const double at[3], const double first[3],
                             const double second[3], const double step_mm[2], double moved[3])
{
    const double radius = lx_cylinder_radius(cylinder);
    for (int i = 0; i < 3; i++)
        moved[i] = at[i] + (step_mm[0] * first[i] + step_mm[1] * second[i]) / (i < 2 ? radius : 1);
    const double length = hypot(moved[0], moved[1]);
    moved[0] /= length, moved[1] /= length;
}

/* The cosine between the normal and the way to the observer. */
static double facing_of(const struct lx_shape *cylinder, const struct lx_origin *eye, const double at[3])
{
    double place[3], normal[3], way[3];
    place_on_cylinder(cylinder, at, place, normal);
    lx_way_to(eye, place, way);
    lx_normalize(way);
    return lx_dot(normal, way);
}

/* The limb, and the two ends. */
static double wall_of_cylinder(const struct lx_shape *cylinder, const struct lx_origin *eye, unsigned i,
                               const double at[3])
{
    if (i == 0)
        return lx_cylinder_radius(cylinder) * facing_of(cylinder, eye, at);
    const double half = lx_cylinder_half(cylinder) - cylinder->touch_mm;
    return i == 1 ? half + at[2] : half - at[2];
}

/* The angle of the meridian that faces the observer; returns how far to both sides the side does: 0, nowhere. */
static double front_of(const struct lx_shape *cylinder, const struct lx_origin *eye, double *middle)
{
    double way[3];
    const bool endless = lx_way_to(eye, cylinder->anchor_mm, way);
    const double x = lx_dot(way, cylinder->across), y = lx_dot(way, cylinder->upward), away = hypot(x, y);
    *middle = away > 0 ? atan2(y, x) : 0;
    if (endless)
        return away > 0 ? M_PI_2 : 0;
    return away > lx_cylinder_radius(cylinder) ? acos(lx_cylinder_radius(cylinder) / away) : 0;
}

static void set_at(double angle, double height, double at[3])
{
    at[0] = cos(angle), at[1] = sin(angle), at[2] = height;
}

/* Once around what is seen: along the lower end, up a limb, back along the upper end, and down. */
static void around_front(const struct lx_shape *cylinder, const struct lx_origin *eye, int i, int count, double inset,
                         double at[3])
{
    double middle, square[2], half = lx_cylinder_half(cylinder) - cylinder->touch_mm;
    const double width = front_of(cylinder, eye, &middle);
    lx_around_square(i % count, count, square);
    set_at(middle + (1 - inset) * width * square[0], (1 - inset) * half * square[1], at);
}

static void rim_of_cylinder(const struct lx_shape *cylinder, const struct lx_origin *eye, int i, int count,
                            double at[3])
{
    around_front(cylinder, eye, i, count, 0, at);
}

static void middle_of_cylinder(const struct lx_shape *cylinder, const struct lx_origin *eye, double at[3])
{
    double middle;
    front_of(cylinder, eye, &middle);
    set_at(middle, 0, at);
}

void lx_cylinder_outline(const struct lx_shape *cylinder, const struct lx_origin *eye, int i, int steps,
                         double place_mm[3], double inside_mm[3])
{
    double at[3], normal[3];
    around_front(cylinder, eye, i, steps, 0, at);
    place_on_cylinder(cylinder, at, place_mm, normal);
    around_front(cylinder, eye, i, steps, 1e-3, at);
    place_on_cylinder(cylinder, at, inside_mm, normal);
}

static bool is_near_limb(const struct lx_shape *cylinder, const struct lx_origin *eye, const double at[3],
                         double inside_mm[3])
{
    double middle, normal[3], inner[3];
    front_of(cylinder, eye, &middle);
    const double turn = remainder(atan2(at[1], at[0]) - middle, 2 * M_PI);
    set_at(middle + turn - copysign(fmin(0.1, fabs(turn)), turn), (1 - 1e-3) * at[2], inner);
    place_on_cylinder(cylinder, inner, inside_mm, normal);
    return facing_of(cylinder, eye, at) < 1e-3;
}

/* Where a light is from the axis: its direction across, how far from the side, and its height; of a light without end
 * the height is not known. */
struct stand {
    double aside[3], gap, height;
    bool endless;
};

static struct stand stand_of(const struct lx_shape *cylinder, const struct lx_origin *origin)
{
    double way[3];
    struct stand stand = {.endless = lx_way_to(origin, cylinder->anchor_mm, way)};
    lx_cylinder_split(cylinder, way, stand.aside, &stand.height);
    stand.gap = fmax(lx_normalize(stand.aside) - lx_cylinder_radius(cylinder), 1e-6 * lx_cylinder_radius(cylinder));
    return stand;
}

static void towards(const struct lx_shape *cylinder, const double aside[3], double height, double at[3])
{
    const double half = lx_cylinder_half(cylinder) - cylinder->touch_mm;
    set_at(atan2(lx_dot(aside, cylinder->upward), lx_dot(aside, cylinder->across)), fmax(-half, fmin(half, height)),
           at);
}

/* Nearest to the light, farthest from it, and about where the side mirrors it: between both, as far from each along the
 * axis as across it. */
static int guess_on_cylinder(const struct lx_shape *cylinder, const struct lx_origin *light,
                             const struct lx_origin *viewer, bool for_least, double at[LX_MOST_GUESSES][3])
{
    const struct stand one = stand_of(cylinder, light), other = stand_of(cylinder, viewer);
    double between[3], opposite[3];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        between[i] = one.aside[i] + other.aside[i];
        opposite[i] = -one.aside[i];
    }
    const double height = one.endless && other.endless ? 0
                          : one.endless                ? other.height
                          : other.endless              ? one.height
                                          : (one.height * other.gap + other.height * one.gap) / (one.gap + other.gap);
    towards(cylinder, one.aside, one.endless ? 0 : one.height, at[count++]);
    if (for_least)
        towards(cylinder, opposite, one.endless ? 0 : one.height, at[count++]);
    if (lx_normalize(between) > 0)
        towards(cylinder, between, height, at[count++]);
    return count;
}

const struct lx_surface_chart lx_cylinder_chart = {
    .locate = locate_on_cylinder,
    .place = place_on_cylinder,
    .element = element_on_cylinder,
    .directions = directions_on_cylinder,
    .move = move_on_cylinder,
    .walls = 3,
    .wall = wall_of_cylinder,
    .rim = rim_of_cylinder,
    .middle = middle_of_cylinder,
    .is_near_limb = is_near_limb,
    .guess = guess_on_cylinder,
};
