/* SPDX-License-Identifier: MIT */
/* Light over mirrors: ways from points and directions, and what is seen of extended sources. */
#include "images.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "../surface/beside.h"
#include "../surface/plane.h"
#include "mirrors.h"
#include "visibility/occlusion.h"

/* An element's image by a way over mirrors, and a light that shines on it. */
struct task {
    const struct lx_prepared *prepared;
    const struct lx_mirror_way *way;
    struct lx_element element; /* the image */
    const struct lx_emitter *emitter;
};

/* ---- lights without size ---- */

/* Whether a ball comes near to a way: else nothing in it stands there. */
static bool is_near(const struct lx_shape *shape, lx_bounded3 from, lx_bounded3 way, bool endless)
{
    double offset[3], along[3];
    const lx_bounded3 between = lx_sub3(lx_exact3(shape->anchor_mm), from);
    lx_values3(between, offset);
    lx_values3(way, along);
    const double length = lx_normalize(along), reach = (shape->radius_mm + lx_shape_room(shape)) * (1 + 1e-9);
    const double room = 1e-9 * length + between.x.error + between.y.error + between.z.error;
    double at = fmax(lx_dot(offset, along), 0), square = 0;
    at = endless ? at : fmin(at, length);
    for (int k = 0; k < 3; k++)
        square += (offset[k] - at * along[k]) * (offset[k] - at * along[k]);
    return !(sqrt(square) > reach + room);
}

/* Whether nothing stands in a part of the way, between two mirrors of those that `leg` carries (NULL: the lights'
 * own); `ends`: those mirrors; an element begins the first part. */
static lx_bounded is_open(const struct task *task, const struct lx_mirror_way *leg, const uint32_t ends[2],
                          lx_bounded3 from, lx_bounded3 way, bool endless)
{
    const struct lx_prepared *prepared = task->prepared;
    const bool is_first = leg == task->way;
    lx_bounded open = lx_exact(1);
    for (size_t s = 0; s < prepared->surface_count && !lx_is_zero(open); s++) {
        const struct lx_shape *shape = lx_mirrored_shape(prepared, leg, s);
        const bool is_own = is_first && &prepared->surfaces[s] == task->element.own;
        if (s == ends[0] || s == ends[1] || (!is_own && !is_near(shape, from, way, endless)))
            continue;
        open = lx_both(open, is_first ? lx_not(lx_blocked_by(shape, is_own, &task->element, way, endless))
                                      : lx_not(shape->kind->blocks(shape, from, way, endless)));
    }
    return open;
}

/* 1 where the straight way from the element's image to the light passes through all mirrors, each after the one
 * before, and past what stands between them; else 0. */
static lx_bounded openness(const struct task *task)
{
    const struct lx_prepared *prepared = task->prepared;
    const struct lx_element *element = &task->element;
    const bool endless = lx_is_endless(task->emitter);
    const bool casts = element->is_free ? prepared->shadows_on_free : prepared->shadows;
    const lx_bounded3 way =
        endless ? task->emitter->towards : lx_sub3(lx_exact3(task->emitter->position_mm), element->place_mm);
    const struct lx_mirror_way *leg = task->way;
    lx_bounded3 from = element->place_mm;
    lx_bounded open = lx_exact(1), before = lx_exact(0);
    uint32_t ends[2] = {UINT32_MAX, UINT32_MAX};
    for (; leg && !lx_is_zero(open); leg = lx_rest_of(prepared, leg)) {
        struct lx_shape mirror = *lx_mirrored_shape(prepared, lx_rest_of(prepared, leg), leg->surface);
        mirror.behind_mm = 0; /* it is itself here, and not what stands in the way of light for it */
        open = lx_both(open, mirror.kind->blocks(&mirror, element->place_mm, way, endless));
        const lx_bounded change = lx_dot3(way, lx_shape_axis(&mirror));
        open = lx_both(open, lx_step(change, false));
        if (lx_is_zero(open))
            return open;
        const lx_bounded start =
            lx_dot3(lx_sub3(lx_exact3(mirror.anchor_mm), element->place_mm), lx_shape_axis(&mirror));
        const lx_bounded share = lx_div(start, change);
        open = lx_both(open, lx_step(lx_sub(share, before), true));
        const lx_bounded3 place = lx_add3(element->place_mm, lx_mul3(way, share));
        ends[1] = leg->surface;
        if (casts && !lx_is_zero(open))
            open = lx_both(open, is_open(task, leg, ends, from, lx_sub3(place, from), false));
        ends[0] = leg->surface;
        from = place;
        before = share;
    }
    ends[1] = UINT32_MAX;
    if (!casts || lx_is_zero(open))
        return open;
    const lx_bounded3 last = endless ? way : lx_sub3(lx_exact3(task->emitter->position_mm), from);
    return lx_both(open, is_open(task, NULL, ends, from, last, endless));
}

static struct lx_lighting light_by_point(const struct task *task)
{
    const struct lx_element *element = &task->element;
    const lx_bounded open = openness(task);
    struct lx_lighting lighting = {.irradiance = lx_exact(0)};
    if (lx_is_zero(open))
        return lighting;
    const struct lx_sample sample = lx_emitter_sample(task->emitter, element->place_mm);
    const struct lx_reflection reflection =
        lx_lobe_reflect(element->lobe, element->normal, element->view, sample.towards);
    const lx_bounded e_perp = lx_mul(sample.e_perp, open);
    lighting.irradiance = lx_mul(e_perp, reflection.cosine);
    lighting.diffuse = lx_mul(e_perp, reflection.diffuse);
    lighting.specular = lx_mul(e_perp, reflection.specular);
    return lighting;
}

/* ---- extended lights ---- */

/* How a source stands to the apertures of a way. */
enum standing { COMES, IS_CUT, IS_AWAY };

/* Whether nothing of the source may come through an aperture, as the place sees it. */
static bool is_beside(const struct lx_aperture *aperture, const struct lx_emitter *emitter, const double place[3])
{
    for (unsigned i = 0; i < aperture->count; i++) {
        double inwards[3], nearest;
        lx_aperture_inwards(aperture, i, place, inwards);
        const double reach = lx_emitter_extent(emitter, place, inwards, &nearest);
        if (reach < -1e-12 * (fabs(reach) + fabs(nearest) + lx_emitter_radius(emitter)))
            return true;
    }
    return false;
}

static enum standing stand(const struct task *task, const double place[3])
{
    enum standing standing = COMES;
    for (unsigned j = 0; j < task->way->count; j++) {
        const struct lx_aperture *aperture = &task->way->apertures[j];
        const double height = aperture->height_mm - lx_dot(aperture->normal, place);
        const double touch = 1e-12 * (fabs(aperture->height_mm) + lx_distance(aperture->corners_mm[0], place));
        double nearest;
        const double farthest = lx_emitter_extent(task->emitter, place, aperture->normal, &nearest);
        if (height <= touch || farthest <= height + touch || is_beside(aperture, task->emitter, place))
            return IS_AWAY;
        if (nearest < height - touch)
            standing = IS_CUT;
    }
    return standing;
}

/* Appends what lies around an aperture, as far as the source may be seen there. */
static int frame_aperture(const struct task *task, const struct lx_aperture *aperture, const double place[3],
                          struct lx_obstacles *obstacles)
{
    const double *light = lx_emitter_center(task->emitter);
    double middle[3], within = HUGE_VAL, reach = lx_emitter_radius(task->emitter), size = 0;
    lx_aperture_middle(aperture, middle);
    for (unsigned i = 0; i < aperture->count; i++) {
        const double *a = aperture->corners_mm[i], *b = aperture->corners_mm[(i + 1) % aperture->count];
        double edge[3], offset[3], product[3];
        for (int k = 0; k < 3; k++)
            edge[k] = b[k] - a[k], offset[k] = middle[k] - a[k];
        lx_cross(edge, offset, product);
        within = fmin(within, sqrt(lx_dot(product, product) / lx_dot(edge, edge)));
        size = fmax(size, lx_distance(a, middle));
    }
    reach += 2 * (lx_distance(light, place) + lx_distance(middle, place)) + size;
    const double share = 1 + 2 * reach / within;
    for (unsigned i = 0; i < aperture->count; i++) {
        struct lx_obstacle quad = {.type = LX_OBSTACLE_POLYGON, .corner_count = 4};
        const double *a = aperture->corners_mm[i], *b = aperture->corners_mm[(i + 1) % aperture->count];
        for (int k = 0; k < 3; k++) {
            quad.corners_mm[0][k] = a[k];
            quad.corners_mm[1][k] = b[k];
            quad.corners_mm[2][k] = middle[k] + share * (b[k] - middle[k]);
            quad.corners_mm[3][k] = middle[k] + share * (a[k] - middle[k]);
        }
        if (lx_obstacles_append(obstacles, &quad))
            return -1;
    }
    return 0;
}

/* A plane beyond which a part of the way does not lead: what lies at sign (n.x - height) < 0 is not in its way. */
struct border {
    double normal[3], height_mm;
    int sign;
};

/* Cuts a polygon to a border; the polygon's corners may become one more. */
static unsigned cut(double corners[][3], unsigned count, const struct border *border)
{
    double kept[2 * LX_OBSTACLE_CORNERS][3];
    unsigned made = 0;
    for (unsigned i = 0; i < count; i++) {
        const unsigned next = (i + 1) % count;
        const double at = border->sign * (lx_dot(border->normal, corners[i]) - border->height_mm);
        const double then = border->sign * (lx_dot(border->normal, corners[next]) - border->height_mm);
        if (at >= 0)
            memcpy(kept[made++], corners[i], sizeof kept[0]);
        if ((at < 0) == (then < 0))
            continue;
        for (int k = 0; k < 3; k++)
            kept[made][k] = corners[i][k] + at / (at - then) * (corners[next][k] - corners[i][k]);
        made++;
    }
    memcpy(corners, kept, made * sizeof kept[0]);
    return made;
}

/* Cuts obstacles from the first on to the borders; those that are no polygons are taken as they are, or left out.
 * Sets *is_cut where there are some of these.  0, or -1. */
static int cut_obstacles(const struct border *borders, unsigned count, bool takes_bodies, size_t first,
                         struct lx_obstacles *obstacles, bool *is_cut)
{
    const size_t end = obstacles->count;
    size_t kept = first;
    if (obstacles->count == first)
        return 0;
    for (size_t i = first; i < end; i++) {
        const struct lx_obstacle obstacle = obstacles->items[i];
        double corners[2 * LX_OBSTACLE_CORNERS][3];
        unsigned corner_count = obstacle.corner_count;
        if (obstacle.type != LX_OBSTACLE_POLYGON) {
            *is_cut = *is_cut || obstacle.type != LX_OBSTACLE_SPACE;
            if (takes_bodies || obstacle.type == LX_OBSTACLE_SPACE)
                obstacles->items[kept++] = obstacle;
            continue;
        }
        memcpy(corners, obstacle.corners_mm, sizeof obstacle.corners_mm);
        for (unsigned b = 0; b < count && corner_count >= 3; b++)
            corner_count = cut(corners, corner_count, &borders[b]);
        for (unsigned c = 1; corner_count >= 3 && c + 1 < corner_count; c += 2) {
            struct lx_obstacle part = obstacle;
            part.corner_count = c + 2 < corner_count ? 4 : 3;
            memcpy(part.corners_mm[0], corners[0], sizeof corners[0]);
            memcpy(part.corners_mm[1], corners[c], (part.corner_count - 1) * sizeof corners[0]);
            if (c == 1)
                obstacles->items[kept++] = part;
            else if (lx_obstacles_append(obstacles, &part))
                return -1;
        }
    }
    if (kept < end) {
        memmove(&obstacles->items[kept], &obstacles->items[end], (obstacles->count - end) * sizeof *obstacles->items);
        obstacles->count -= end - kept;
    }
    return 0;
}

/* What was gathered of a shape that was mirrored runs the other way round. */
static void turn_outline(struct lx_obstacles *obstacles, size_t edges, size_t sheets)
{
    for (size_t i = edges; i < obstacles->edge_count; i++)
        obstacles->edges[i].change = -obstacles->edges[i].change;
    for (size_t i = sheets; i < obstacles->sheet_count; i++)
        obstacles->sheets[i].turn = -obstacles->sheets[i].turn;
}

/* Gathers what stands in a part of the ways, between the mirrors `ends` (UINT32_MAX: none). */
static int gather_leg(const struct task *task, const struct lx_mirror_way *leg, const uint32_t ends[2],
                      const struct lx_aperture *const apertures[2], bool takes_bodies, struct lx_occlusion *occlusion,
                      bool *is_cut)
{
    const struct lx_prepared *prepared = task->prepared;
    const struct lx_element *element = &task->element;
    struct lx_obstacles *obstacles = &occlusion->obstacles;
    double normal[3];
    lx_values3(element->normal, normal);
    for (size_t s = 0; s < prepared->surface_count; s++) {
        const struct lx_shape *shape = lx_mirrored_shape(prepared, leg, s);
        const bool is_own = leg == task->way && &prepared->surfaces[s] == element->own;
        struct border borders[2];
        unsigned count = 0;
        bool is_behind = s == ends[0] || s == ends[1];
        for (int e = 0; e < 2 && !is_behind; e++) {
            if (ends[e] == UINT32_MAX)
                continue;
            const enum lx_mirror_side side = lx_side_of_mirror(prepared, s, ends[e]);
            is_behind = side == LX_BEHIND_MIRROR;
            if (side != LX_ACROSS_MIRROR)
                continue;
            borders[count].height_mm = apertures[e]->height_mm;
            memcpy(borders[count].normal, apertures[e]->normal, sizeof borders[count].normal);
            borders[count++].sign = e == 0 ? 1 : -1; /* behind the mirror that is nearer to the element */
        }
        if (is_behind)
            continue;
        const size_t items = obstacles->count, edges = obstacles->edge_count, sheets = obstacles->sheet_count,
                     layered = obstacles->layered_count;
        const bool is_turned =
            is_own && element->is_free && lx_shape_is_turned(shape, element->place_mm, element->normal);
        if (lx_occlusion_gather(shape, is_own, is_turned, normal, occlusion))
            return -1;
        if (leg && leg->count % 2 == 1)
            turn_outline(obstacles, edges, sheets);
        if (count == 0)
            continue;
        if (cut_obstacles(borders, count, takes_bodies, items, obstacles, is_cut))
            return -1;
        *is_cut = *is_cut || obstacles->layered_count > layered;
        if (!takes_bodies) {
            obstacles->edge_count = edges;
            obstacles->sheet_count = sheets;
            obstacles->layered_count = layered;
        }
    }
    return 0;
}

/* Gathers what is in the way, with bodies that stand across the plane of a mirror, or without them.  0, or -1. */
static int gather(const struct task *task, bool takes_bodies, struct lx_occlusion *occlusion, bool *is_cut)
{
    const struct lx_prepared *prepared = task->prepared;
    const struct lx_element *element = &task->element;
    const struct lx_mirror_way *leg = task->way;
    const struct lx_aperture *apertures[2] = {NULL, NULL};
    uint32_t ends[2] = {UINT32_MAX, UINT32_MAX};
    double place[3], normal[3];
    lx_values3(element->place_mm, place);
    lx_values3(element->normal, normal);
    lx_occlusion_begin(place, lx_lobe_reaches_below(element->lobe) ? NULL : normal, task->emitter, occlusion);
    for (unsigned j = 0; j <= task->way->count; j++, leg = leg ? lx_rest_of(prepared, leg) : NULL) {
        apertures[1] = leg ? &task->way->apertures[j] : NULL;
        ends[1] = leg ? leg->surface : UINT32_MAX;
        if ((leg && frame_aperture(task, apertures[1], place, &occlusion->obstacles)) ||
            (prepared->shadows_extended && gather_leg(task, leg, ends, apertures, takes_bodies, occlusion, is_cut)))
            return -1;
        apertures[0] = apertures[1];
        ends[0] = ends[1];
    }
    double error = lx_error3(element->place_mm);
    for (int k = 0; k < 3; k++)
        error += 8 * DBL_EPSILON * (fabs(task->way->frame.origin_mm[k]) + fabs(place[k]));
    return lx_occlusion_settle(task->emitter, error, occlusion);
}

/* A number of which is known that it is in either of two ranges, or between them. */
static lx_bounded between(lx_bounded a, lx_bounded b)
{
    const double low = fmin(a.value - a.error, b.value - b.error), high = fmax(a.value + a.error, b.value + b.error);
    const double value = low + (high - low) / 2;
    return (lx_bounded){value, fmax(high - value, value - low) * (1 + 4 * DBL_EPSILON)};
}

static struct lx_lighting between_lights(const struct lx_lighting *a, const struct lx_lighting *b)
{
    return (struct lx_lighting){
        .irradiance = between(a->irradiance, b->irradiance),
        .diffuse = between(a->diffuse, b->diffuse),
        .specular = between(a->specular, b->specular),
        .parts = a->parts + b->parts,
    };
}

static struct lx_lighting light_by_extended(const struct task *task)
{
    const struct lx_lighting nothing = {.irradiance = lx_exact(0)}, unknown = {.irradiance = {0, HUGE_VAL},
                                                                               .diffuse = {0, HUGE_VAL},
                                                                               .specular = {0, HUGE_VAL}};
    double place[3];
    lx_values3(task->element.place_mm, place);
    const enum standing standing = stand(task, place);
    struct lx_lighting lights[2];
    bool is_cut = false;
    if (standing == IS_AWAY)
        return nothing;
    for (int i = 0; i < 2; i++) {
        struct lx_occlusion occlusion = {.place_mm = {0}};
        lights[i] = unknown;
        if (gather(task, i == 0, &occlusion, &is_cut) == 0)
            lights[i] = occlusion.is_dark
                            ? nothing
                            : lx_light_behind(task->prepared, &task->element, task->emitter, &occlusion, 0);
        lx_occlusion_clear(&occlusion);
        if (!is_cut)
            break;
    }
    const struct lx_lighting light = is_cut ? between_lights(&lights[0], &lights[1]) : lights[0];
    return standing == IS_CUT ? between_lights(&light, &nothing) : light;
}

void lx_add_images(const struct lx_prepared *prepared, const struct lx_element *element,
                   const struct lx_emitter *emitter, struct lx_lighting *lighting)
{
    const struct lx_mirrors *mirrors = &prepared->mirrors;
    if (lx_is_uniform(emitter))
        return;
    for (size_t i = 0; i < mirrors->computed; i++) {
        const struct lx_mirror_way *way = &mirrors->ways[i];
        if (element->own == &prepared->surfaces[way->surface])
            continue; /* it lies on that mirror, or looks away from it */
        const struct task task = {prepared, way, lx_mirrored_element(way, element), emitter};
        const struct lx_lighting image = lx_is_extended(emitter) ? light_by_extended(&task) : light_by_point(&task);
        lighting->irradiance = lx_add(lighting->irradiance, image.irradiance);
        lighting->diffuse = lx_add(lighting->diffuse, image.diffuse);
        lighting->specular = lx_add(lighting->specular, image.specular);
        lighting->parts += image.parts;
    }
    lx_add_rest(prepared, element, emitter, lighting);
}
