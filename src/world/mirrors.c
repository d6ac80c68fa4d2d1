/* SPDX-License-Identifier: MIT */
/* Making the ways over mirrors, carrying elements along them, and following sights. */
#include "mirrors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/pose.h"
#include "../base/vector.h"
#include "../surface/plane.h"
#include "among.h"
#include "camera.h"

enum {
    MOST_WAYS = 20000,         /* to be computed */
    MOST_SHAPES = 400000,      /* carried by all of them */
    MOST_DEEPER = 512,         /* ways that bounds know one by one, */
    DEEPER = 16,               /* over so many mirrors more */
    MOST_CORNERS = 4 + 2 * 80, /* of an aperture: each plane adds one */
    MOST_SIGHTS = 10000,       /* mirrors that a sight is followed over */
};

/* What of an aperture is no wider than this share of its size is none: planes that are the same but for rounding. */
static const double THIN = 1e-10;

/* ---- apertures ---- */

/* Cuts a polygon to where sign (n.x - height) >= 0; returns how many corners are left, 0 where that is no area. */
static unsigned cut(double corners[][3], unsigned count, const double n[3], double height, int sign)
{
    double kept[MOST_CORNERS][3], at[MOST_CORNERS], size = 0, most = 0;
    unsigned made = 0;
    for (unsigned i = 0; i < count; i++) {
        at[i] = sign * (lx_dot(n, corners[i]) - height);
        size = fmax(size, lx_distance(corners[i], corners[0]));
        most = fmax(most, at[i]);
    }
    if (!(most > THIN * size))
        return 0;
    for (unsigned i = 0; i < count; i++) {
        const unsigned next = (i + 1) % count;
        if (at[i] >= 0 && made < MOST_CORNERS)
            memcpy(kept[made++], corners[i], sizeof kept[0]);
        if ((at[i] >= 0) == (at[next] >= 0) || at[i] == 0 || at[next] == 0 || made == MOST_CORNERS)
            continue;
        for (int k = 0; k < 3; k++)
            kept[made][k] = corners[i][k] + at[i] / (at[i] - at[next]) * (corners[next][k] - corners[i][k]);
        made++;
    }
    memcpy(corners, kept, made * sizeof kept[0]);
    return made >= 3 ? made : 0;
}

/* All of a mirror, a plate, as an aperture in room for its corners. */
static struct lx_aperture whole_aperture(const struct lx_shape *plate, double (*corners)[3])
{
    struct lx_aperture aperture = {.count = 4, .corners_mm = corners};
    const double width = plate->half_mm[0] - plate->touch_mm, height = plate->half_mm[1] - plate->touch_mm;
    for (unsigned k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            corners[k][i] = plate->anchor_mm[i] + (k == 1 || k == 2 ? width : -width) * plate->across[i] +
                            (k >= 2 ? height : -height) * plate->upward[i];
    memcpy(aperture.normal, plate->axis, sizeof aperture.normal);
    aperture.height_mm = lx_dot(plate->axis, plate->anchor_mm);
    return aperture;
}

/* Makes the apertures of a way; 1: something may come through, 0: nothing does, -1: memory ran out. */
static int make_apertures(const struct lx_prepared *prepared, struct lx_mirror_way *way)
{
    const struct lx_mirror_way *rest = lx_rest_of(prepared, way);
    double(*room)[3] = lx_new_array((size_t)way->count * MOST_CORNERS, sizeof *room);
    struct lx_aperture *made = lx_new_array(way->count, sizeof *made);
    struct lx_shape plate = prepared->surfaces[way->surface].shape;
    bool is_open = room && made;
    size_t corners = 0;
    if (rest)
        plate = lx_shape_carried(&plate, &rest->frame);
    if (is_open)
        made[0] = whole_aperture(&plate, room);
    for (unsigned j = 1; is_open && j < way->count; j++) {
        const struct lx_aperture *other = &rest->apertures[j - 1];
        made[j] = *other;
        made[j].corners_mm = room + (size_t)j * MOST_CORNERS;
        memcpy(made[j].corners_mm, other->corners_mm, other->count * sizeof *room);
        made[j].count = cut(made[j].corners_mm, other->count, made[0].normal, made[0].height_mm, 1);
        made[0].count = cut(made[0].corners_mm, made[0].count, other->normal, other->height_mm, -1);
        is_open = made[j].count > 0 && made[0].count > 0;
    }
    for (unsigned j = 0; is_open && j < way->count; j++)
        corners += made[j].count;
    way->corners_mm = is_open ? lx_new_array(corners, sizeof *way->corners_mm) : NULL;
    const bool failed = !room || !made || (is_open && !way->corners_mm);
    size_t next = 0;
    for (unsigned j = 0; is_open && !failed && j < way->count; j++) {
        memcpy(way->corners_mm + next, made[j].corners_mm, made[j].count * sizeof *room);
        made[j].corners_mm = way->corners_mm + next;
        next += made[j].count;
    }
    free(room);
    if (is_open && !failed)
        way->apertures = made;
    else
        free(made);
    return failed ? -1 : is_open;
}

void lx_aperture_middle(const struct lx_aperture *aperture, double middle[3])
{
    middle[0] = middle[1] = middle[2] = 0;
    for (unsigned i = 0; i < aperture->count; i++)
        for (int k = 0; k < 3; k++)
            middle[k] += aperture->corners_mm[i][k] / aperture->count;
}

void lx_aperture_inwards(const struct lx_aperture *aperture, unsigned i, const double place[3], double inwards[3])
{
    double a[3], b[3], middle[3];
    lx_aperture_middle(aperture, middle);
    for (int k = 0; k < 3; k++) {
        a[k] = aperture->corners_mm[i][k] - place[k];
        b[k] = aperture->corners_mm[(i + 1) % aperture->count][k] - place[k];
        middle[k] -= place[k];
    }
    lx_cross(a, b, inwards);
    lx_normalize(inwards);
    const double sign = lx_dot(inwards, middle) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        inwards[k] *= sign;
}

/* ---- ways ---- */

/* The unit normal of a mirror, as exactly as it is known. */
static lx_wide3 normal_of(const struct lx_shape *plate)
{
    return lx_wide3_unit(lx_wide3_of(plate->normal));
}

/* A direction mirrored at the normal n, and a place at the plane. */
static lx_wide3 mirror_wide(lx_wide3 direction, lx_wide3 n)
{
    return lx_wide3_sub(direction, lx_wide3_mul(n, lx_wide_scale(lx_wide3_dot(direction, n), 2)));
}

/* The frame of what lies before a mirror, behind which another frame carries. */
static struct lx_frame mirrored_frame(const struct lx_frame *behind, const struct lx_shape *plate)
{
    const lx_wide3 n = normal_of(plate), anchor = lx_wide3_of(plate->anchor_mm);
    struct lx_frame frame = {.is_own = false};
    for (int i = 0; i < 3; i++) {
        frame.axes[i] = mirror_wide(behind->axes[i], n);
        frame.rounded[i] = lx_wide3_direction(frame.axes[i]);
    }
    const lx_wide3 origin = lx_wide3_sub(lx_wide3_of(behind->origin_mm), anchor);
    lx_wide3_values(lx_wide3_add(mirror_wide(origin, n), anchor), frame.origin_mm);
    return frame;
}

static void clear_way(struct lx_mirror_way *way)
{
    free(way->shapes);
    free(way->apertures);
    free(way->corners_mm);
}

/* Appends the way over a mirror and the rest, if something may come along it; 0, or -1. */
static int append_way(struct lx_prepared *prepared, uint32_t surface, size_t rest, bool is_deeper)
{
    struct lx_mirrors *mirrors = &prepared->mirrors;
    const struct lx_frame own = lx_frame_own();
    if (lx_reserve(&mirrors->ways, &mirrors->capacity, mirrors->way_count + 1, sizeof *mirrors->ways))
        return -1;
    const struct lx_mirror_way *before = rest == LX_NO_WAY ? NULL : &mirrors->ways[rest];
    struct lx_mirror_way *way = &mirrors->ways[mirrors->way_count];
    *way = (struct lx_mirror_way){.count = before ? before->count + 1 : 1, .surface = surface, .rest = rest};
    const int is_open = make_apertures(prepared, way);
    if (is_open <= 0)
        return is_open;
    way->frame = mirrored_frame(before ? &before->frame : &own, &prepared->surfaces[surface].shape);
    mirrors->way_count++;
    if (is_deeper)
        return 0;
    mirrors->is_short = mirrors->way_count > MOST_WAYS || mirrors->way_count * prepared->surface_count > MOST_SHAPES;
    way->shapes = mirrors->is_short ? NULL : lx_new_array(prepared->surface_count, sizeof *way->shapes);
    for (size_t s = 0; way->shapes && s < prepared->surface_count; s++)
        way->shapes[s] = lx_shape_carried(&prepared->surfaces[s].shape, &way->frame);
    return way->shapes ? 0 : -1;
}

/* Appends the ways that have one mirror more than those of some. */
static int lengthen(struct lx_prepared *prepared, size_t first, size_t end, bool is_deeper)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    for (size_t i = first; i < end; i++)
        for (size_t m = 0; m < mirrors->count; m++)
            if (mirrors->surfaces[m] != mirrors->ways[i].surface &&
                append_way(prepared, mirrors->surfaces[m], i, is_deeper))
                return -1;
    return 0;
}

static int make_ways(struct lx_prepared *prepared, unsigned most)
{
    struct lx_mirrors *mirrors = &prepared->mirrors;
    size_t first = 0;
    for (size_t m = 0; m < mirrors->count; m++)
        if (append_way(prepared, mirrors->surfaces[m], LX_NO_WAY, false))
            return -1;
    for (unsigned count = 2; count <= most + DEEPER; count++) {
        const size_t end = mirrors->way_count;
        const bool is_deeper = count > most;
        if (count == most + 1)
            mirrors->computed = end;
        if (is_deeper && end - mirrors->computed > MOST_DEEPER)
            break;
        if (lengthen(prepared, first, end, is_deeper))
            return -1;
        first = end;
        mirrors->deepest = count;
        if (mirrors->way_count == end) {
            mirrors->ends = true;
            break;
        }
    }
    if (mirrors->computed == 0)
        mirrors->computed = mirrors->way_count;
    return 0;
}

/* ---- surfaces beside mirrors ---- */

enum lx_mirror_side lx_side_of_mirror(const struct lx_prepared *prepared, size_t surface, size_t mirror)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    size_t m = 0;
    while (mirrors->surfaces[m] != mirror)
        m++;
    return (enum lx_mirror_side)mirrors->sides[m * prepared->surface_count + surface];
}

static enum lx_mirror_side side_of(const struct lx_prepared_surface *surface, const struct lx_shape *plate)
{
    const double back[3] = {-plate->axis[0], -plate->axis[1], -plate->axis[2]};
    const double height = lx_dot(plate->axis, plate->anchor_mm);
    const double room = plate->touch_mm + lx_shape_room(&surface->shape);
    const double high = lx_surface_farthest(surface->kind, surface->parameters, plate->axis) - height;
    const double low = -lx_surface_farthest(surface->kind, surface->parameters, back) - height;
    return low >= -room ? LX_BEFORE_MIRROR : high <= room ? LX_BEHIND_MIRROR : LX_ACROSS_MIRROR;
}

/* ---- facing mirrors ---- */

/* Directions and heights that are the same but for rounding. */
static const double SAME = 1e-9;

/* Planes of mirrors at right angles to one axis. */
struct stack {
    double axis[3], heights_mm[2];
    unsigned planes;
};

/* Puts the plane of a mirror among the others; false: it stands askew to some, or is a third one of its kind. */
static bool add_plane(const struct lx_shape *plate, struct stack stacks[3], unsigned *count)
{
    const double room = SAME * (plate->radius_mm + fabs(lx_dot(plate->axis, plate->anchor_mm)));
    for (unsigned k = 0; k < *count; k++) {
        struct stack *stack = &stacks[k];
        const double cosine = fabs(lx_dot(plate->axis, stack->axis));
        const double height = lx_dot(stack->axis, plate->anchor_mm);
        if (cosine <= SAME)
            continue;
        if (cosine < 1 - SAME)
            return false;
        for (unsigned p = 0; p < stack->planes; p++)
            if (fabs(height - stack->heights_mm[p]) <= room)
                return true;
        if (stack->planes == 2)
            return false;
        stack->heights_mm[stack->planes++] = height;
        return true;
    }
    if (*count == 3)
        return false;
    stacks[*count].planes = 1;
    stacks[*count].heights_mm[0] = lx_dot(plate->axis, plate->anchor_mm);
    memcpy(stacks[(*count)++].axis, plate->axis, sizeof plate->axis);
    return true;
}

/* Whether all mirrors lie in such planes, and how: then something is known of what is deeper. */
static void find_pairs(struct lx_prepared *prepared)
{
    struct lx_mirrors *mirrors = &prepared->mirrors;
    const struct lx_shape *first = &prepared->surfaces[mirrors->surfaces[0]].shape;
    struct stack stacks[3];
    unsigned count = 0;
    for (size_t m = 0; m < mirrors->count; m++) {
        const struct lx_shape *plate = &prepared->surfaces[mirrors->surfaces[m]].shape;
        if (!add_plane(plate, stacks, &count))
            return;
        mirrors->pair_size_mm =
            fmax(mirrors->pair_size_mm, 2 * (lx_distance(first->anchor_mm, plate->anchor_mm) + plate->radius_mm));
    }
    for (unsigned k = 0; k < count; k++) {
        if (stacks[k].planes == 1) {
            mirrors->other_planes++;
            continue;
        }
        mirrors->pair_gaps_mm[mirrors->pair_count] = fabs(stacks[k].heights_mm[1] - stacks[k].heights_mm[0]);
        memcpy(mirrors->pair_axes[mirrors->pair_count++], stacks[k].axis, sizeof stacks[k].axis);
    }
}

/*
 * Sums over the images that two pairs of facing planes make by so many mirrors or more, i of the one pair and k of the
 * other: one image for each end of a pair that it goes out by, no nearer than i - 1 and k - 1 gaps.  Beyond some number
 * n = i + k of mirrors there are 4 (n + 1) at most, at least (n - 2) / sqrt(2) of the smaller gap away.
 */
static void sum_lattice(struct lx_mirrors *mirrors)
{
    enum { FARTHER = 100 };
    const unsigned first = mirrors->deepest + 1 - mirrors->other_planes, last = first + FARTHER;
    const double *gaps = mirrors->pair_gaps_mm, least = fmin(gaps[0], gaps[1]);
    mirrors->nearest_mm = HUGE_VAL;
    for (unsigned n = first; n < last; n++)
        for (unsigned i = 0; i <= n; i++) {
            const unsigned k = n - i, ends = (i > 0 ? 2U : 1U) * (k > 0 ? 2U : 1U);
            const double distance = hypot(i > 1 ? (i - 1) * gaps[0] : 0, k > 1 ? (k - 1) * gaps[1] : 0);
            mirrors->nearest_mm = fmin(mirrors->nearest_mm, distance);
            mirrors->cubes_per_mm3 += ends / (distance * distance * distance);
        }
    const double beyond = last - 3;
    mirrors->cubes_per_mm3 += 8 * sqrt(2) / (least * least * least) * (1 / beyond + 1.5 / (beyond * beyond));
    lx_cross(mirrors->pair_axes[0], mirrors->pair_axes[1], mirrors->third_axis);
    lx_normalize(mirrors->third_axis);
}

int lx_mirrors_make(struct lx_prepared *prepared, unsigned most, const struct lx_prepared *from)
{
    struct lx_mirrors *mirrors = &prepared->mirrors;
    const size_t surfaces = prepared->surface_count;
    *mirrors = (struct lx_mirrors){.count = 0};
    for (size_t s = 0; s < surfaces; s++)
        mirrors->count += prepared->surfaces[s].is_mirror;
    if (mirrors->count == 0)
        return 0;
    mirrors->surfaces = lx_new_array(mirrors->count, sizeof *mirrors->surfaces);
    mirrors->sides = lx_new_array(mirrors->count * surfaces, sizeof *mirrors->sides);
    if (!mirrors->surfaces || !mirrors->sides)
        return -1;
    for (size_t s = 0, m = 0; s < surfaces; s++)
        if (prepared->surfaces[s].is_mirror)
            mirrors->surfaces[m++] = (uint32_t)s;
    for (size_t m = 0; m < mirrors->count && !from; m++)
        for (size_t s = 0; s < surfaces; s++)
            mirrors->sides[m * surfaces + s] =
                (uint8_t)side_of(&prepared->surfaces[s], &prepared->surfaces[mirrors->surfaces[m]].shape);
    if (from)
        memcpy(mirrors->sides, from->mirrors.sides, mirrors->count * surfaces);
    find_pairs(prepared);
    const int status = make_ways(prepared, most);
    if (status == 0 && mirrors->pair_count == 2)
        sum_lattice(mirrors);
    return status;
}

void lx_mirrors_clear(struct lx_mirrors *mirrors)
{
    for (size_t i = 0; i < mirrors->way_count; i++)
        clear_way(&mirrors->ways[i]);
    free(mirrors->ways);
    free(mirrors->surfaces);
    free(mirrors->sides);
    *mirrors = (struct lx_mirrors){.count = 0};
}

/* ---- elements ---- */

static lx_bounded carry_component(const struct lx_frame *frame, int i, const double carried[3], lx_bounded3 place)
{
    const lx_bounded3 *axis = &frame->rounded[i];
    const double inherited =
        fabs(axis->x.value) * place.x.error + fabs(axis->y.value) * place.y.error + fabs(axis->z.value) * place.z.error;
    double size = fabs(carried[i]);
    for (int k = 0; k < 3; k++)
        size += fabs(frame->origin_mm[k]);
    return (lx_bounded){carried[i], inherited * (1 + 8 * DBL_EPSILON) + 2 * DBL_EPSILON * size};
}

struct lx_element lx_mirrored_element(const struct lx_mirror_way *way, const struct lx_element *element)
{
    struct lx_element mirrored = *element;
    double place[3], carried[3];
    lx_values3(element->place_mm, place);
    lx_frame_carry(&way->frame, place, carried);
    mirrored.place_mm = (lx_bounded3){carry_component(&way->frame, 0, carried, element->place_mm),
                                      carry_component(&way->frame, 1, carried, element->place_mm),
                                      carry_component(&way->frame, 2, carried, element->place_mm)};
    mirrored.normal = lx_frame_turn_bounded(&way->frame, element->normal);
    mirrored.view = lx_frame_turn_bounded(&way->frame, element->view);
    return mirrored;
}

/* ---- sights ---- */

/* A direction mirrored at a mirror, and a place. */
static lx_bounded3 mirror_direction(const struct lx_shape *plate, lx_bounded3 direction)
{
    const lx_bounded3 n = lx_shape_axis(plate);
    return lx_sub3(direction, lx_mul3(n, lx_scale(lx_dot3(direction, n), 2)));
}

static lx_bounded3 mirror_place(const struct lx_shape *plate, lx_bounded3 place)
{
    const lx_bounded3 anchor = lx_exact3(plate->anchor_mm);
    return lx_add3(mirror_direction(plate, lx_sub3(place, anchor)), anchor);
}

static void set_ray(lx_bounded3 origin, lx_bounded3 direction, struct lx_ray *ray)
{
    lx_values3(origin, ray->origin_mm);
    lx_values3(direction, ray->direction);
    ray->origin_error[0] = origin.x.error, ray->origin_error[1] = origin.y.error, ray->origin_error[2] = origin.z.error;
    ray->direction_error[0] = direction.x.error, ray->direction_error[1] = direction.y.error,
    ray->direction_error[2] = direction.z.error;
}

/* The nearest surface on a line of sight; NULL: there is none. */
static const struct lx_prepared_surface *meet_nearest(const struct lx_prepared *prepared, const struct lx_ray *ray,
                                                      struct lx_hit *nearest)
{
    const struct lx_prepared_surface *met = NULL;
    struct lx_found found;
    const bool is_found = lx_among_ray(prepared, ray, &found);
    const size_t count = lx_found_count(&found, is_found, prepared->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[lx_found_at(&found, is_found, i)];
        const struct lx_hit hit = surface->kind->hit(&surface->shape, ray);
        if (!hit.exists || (met && hit.t >= nearest->t))
            continue;
        *nearest = hit;
        met = surface;
    }
    return met;
}

/* Whether a sight meets a mirror straight on, and so comes back on itself for ever. */
static bool goes_to_and_fro(const struct lx_shape *plate, const struct lx_ray *ray)
{
    return fabs(lx_dot(plate->axis, ray->direction)) >=
           (1 - 4 * DBL_EPSILON) * sqrt(lx_dot(ray->direction, ray->direction));
}

bool lx_sight_meets(const struct lx_prepared *prepared, struct lx_ray ray, lx_bounded3 eye, bool is_endless,
                    unsigned mirrors, struct lx_element *element)
{
    const struct lx_prepared_surface *surface;
    struct lx_hit hit;
    const unsigned before = mirrors;
    while ((surface = meet_nearest(prepared, &ray, &hit)) != NULL) {
        *element =
            (struct lx_element){.place_mm = hit.place_mm, .normal = hit.normal, .lobe = &surface->lobe, .own = surface};
        if (!surface->is_mirror)
            break;
        eye = is_endless ? mirror_direction(&surface->shape, eye) : mirror_place(&surface->shape, eye);
        set_ray(hit.place_mm, mirror_direction(&surface->shape, lx_ray_direction(&ray)), &ray);
        if (mirrors++ == MOST_SIGHTS)
            break;
    }
    if (!surface && mirrors == before)
        return false;
    if (mirrors == 0) {
        element->view = lx_view_from(&prepared->camera, element->place_mm);
        return true;
    }
    element->mirrors = mirrors;
    element->view = is_endless ? eye : lx_unit3(lx_sub3(eye, element->place_mm));
    if (!surface)
        element->shown = LX_SHOWN_NOTHING;
    else if (surface->is_mirror)
        element->shown = goes_to_and_fro(&surface->shape, &ray) ? LX_SHOWN_NOTHING : LX_SHOWN_UNKNOWN;
    else
        element->shown = mirrors > prepared->scene->mirrors ? LX_SHOWN_BEYOND : LX_SHOWN;
    return true;
}

struct lx_element lx_element_shown(const struct lx_prepared *prepared, const struct lx_element *element)
{
    struct lx_element shown = *element;
    struct lx_ray ray = {.origin_mm = {0}};
    const struct lx_prepared_surface *own = element->own;
    if (!own || !own->is_mirror)
        return shown;
    shown.shown = LX_SHOWN_NOTHING;
    if (!(lx_dot3(element->view, lx_shape_axis(&own->shape)).value > 0))
        return shown;
    const lx_bounded3 eye = mirror_direction(&own->shape, element->view);
    set_ray(element->place_mm, lx_negate3(eye), &ray);
    struct lx_element met;
    if (lx_sight_meets(prepared, ray, eye, true, 1, &met))
        shown = met;
    return shown;
}
