/* SPDX-License-Identifier: MIT */
/* Outlines, and the number of sheets on a way. */
#include "outline.h"

#include <math.h>
#include <stdlib.h>

#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../../surface/surface.h"

struct lx_sheet_outline *lx_outline_new(void)
{
    return lx_new_array(1, sizeof(struct lx_sheet_outline));
}

static void free_lays(struct lx_sheet_outline *outline)
{
    for (size_t i = 0; i < outline->lay_count; i++) {
        free(outline->lays[i].lines);
        free(outline->lays[i].parts);
        free(outline->lays[i].slabs);
    }
    free(outline->lays);
}

void lx_outline_free(struct lx_sheet_outline *outline)
{
    if (!outline)
        return;
    free_lays(outline);
    free(outline);
}

unsigned lx_outline_layers(const struct lx_occlusion *occlusion, const double way_mm[3])
{
    const struct lx_obstacles *obstacles = &occlusion->obstacles;
    unsigned count = 0;
    for (size_t i = 0; i < obstacles->layered_count; i++) {
        const struct lx_shape *shape = obstacles->layered[i];
        double from[3];
        for (int k = 0; k < 3; k++)
            from[k] = occlusion->place_mm[k] - shape->anchor_mm[k];
        count += shape->kind->layers(shape, from, way_mm);
    }
    return count;
}

/* Where a plane through the source, from the element, lies that all of it is beyond: n.x = *away. */
static void nearest_plane(const struct lx_occlusion *occlusion, const double center_mm[3], double radius_mm,
                          double n[3], double *away)
{
    for (int k = 0; k < 3; k++)
        n[k] = center_mm[k] - occlusion->place_mm[k];
    *away = lx_normalize(n) - radius_mm;
}

static bool reach_beyond(const struct lx_occlusion *occlusion, const double n[3], double away)
{
    for (size_t i = 0; i < occlusion->obstacles.sheet_count; i++)
        for (int c = 0; c < 3; c++)
            if (lx_dot(n, occlusion->obstacles.sheets[i].corners_mm[c]) > away)
                return true;
    return false;
}

bool lx_outline_may_cut(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter)
{
    double n[3], away;
    const struct lx_facets *facets = emitter->facets;
    if (facets) {
        for (size_t f = 0; f < facets->face_count; f++) {
            const struct lx_face *face = &facets->faces[f];
            const lx_wide3 *corner = &facets->corners_mm[facets->loop[face->first]];
            const double at[3] = {corner->x.high - occlusion->place_mm[0], corner->y.high - occlusion->place_mm[1],
                                  corner->z.high - occlusion->place_mm[2]};
            n[0] = -face->normal.x.high, n[1] = -face->normal.y.high, n[2] = -face->normal.z.high;
            away = lx_dot(n, at);
            if (away > 0 && reach_beyond(occlusion, n, away * (1 - 1e-12)))
                return true;
        }
        return false;
    }
    nearest_plane(occlusion, emitter->center_mm, occlusion->shaft.outline_radius_mm, n, &away);
    return reach_beyond(occlusion, n, away);
}

double lx_outline_unsure(const struct lx_sheet_outline *outline)
{
    double sum = 0;
    for (size_t i = 0; i < outline->lay_count; i++)
        sum += outline->lays[i].unsure;
    return sum;
}

double lx_outline_skipped(const struct lx_sheet_outline *outline)
{
    double sum = 0;
    for (size_t i = 0; i < outline->lay_count; i++)
        sum += outline->lays[i].skipped;
    return sum;
}

double lx_outline_nothing(const struct lx_sheet_outline *outline)
{
    static const double NOTHING = 1e-14, MOST = 1e3; /* of a plane seen along itself the rectangle is endless */
    double sum = 0;
    for (size_t i = 0; i < outline->lay_count; i++)
        sum += NOTHING * fmin(outline->lays[i].area, MOST);
    return sum;
}

size_t lx_outline_most(const struct lx_sheet_outline *outline)
{
    size_t most = 1;
    for (size_t i = 0; i < outline->lay_count; i++)
        for (size_t k = 0; k < outline->lays[i].slab_count; k++)
            most = outline->lays[i].slabs[k].count > most ? outline->lays[i].slabs[k].count : most;
    return most;
}

/* ---- arcs ---- */

/* The slab of an arc, the nearest one where rounding took it out of all. */
static const struct lx_outline_slab *slab_at(const struct lx_trapezoid_map *map, double u)
{
    size_t low = 0, high = map->slab_count;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        *(u < map->slabs[middle].low ? &high : &low) = middle;
    }
    return &map->slabs[low];
}

/* The latitude at which an arc crosses a line, and how far that may be off; borders are beyond the arc's ends. */
static void cross_arc(const struct lx_outline_line *line, double c, double s, double error_mm, int end, double *tau,
                      double *slack)
{
    if (line->kind != LX_OUTLINE_EDGE) {
        *tau = end ? M_PI : -M_PI;
        *slack = 0;
        return;
    }
    const double *a = line->from, *b = line->to, p = a[0] * s - a[1] * c, q = b[0] * s - b[1] * c;
    const double share = p / (p - q);
    double place[3], square = 0;
    for (int k = 0; k < 3; k++) {
        place[k] = share < 0.5 ? a[k] + share * (b[k] - a[k]) : b[k] + (1 - share) * (a[k] - b[k]);
        square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double x = c * place[0] + s * place[1], away = hypot(x, place[2]);
    const double error = error_mm * (1 + sqrt(square) / fabs(p - q));
    *tau = atan2(place[2], x);
    *slack = away > error ? error / away : M_PI;
}

size_t lx_outline_hide(const struct lx_occlusion *occlusion, const struct lx_sweep *sweep, const struct lx_arc *arc,
                       struct lx_hidden *hidden, size_t count)
{
    const struct lx_sheet_outline *outline = occlusion->outline;
    const size_t number = (size_t)(sweep - outline->sweeps->items);
    const struct lx_trapezoid_map *map = &outline->lays[number];
    if (map->slab_count == 0)
        return count;
    const double c = lx_dot(arc->direction, sweep->frame.x), s = lx_dot(arc->direction, sweep->frame.y);
    const struct lx_outline_slab *slab = slab_at(map, s / c);
    for (uint32_t i = 0; i < slab->count; i++) {
        const struct lx_outline_part *part = &map->parts[slab->first + i];
        const uint32_t lines[2] = {part->lower, part->upper};
        struct lx_hidden *made = &hidden[count++];
        for (int end = 0; end < 2; end++) {
            cross_arc(&map->lines[lines[end]], c, s, occlusion->error_mm, end, &made->ends[end], &made->slack[end]);
            made->bounds[end] = (1U << 30) + lines[end];
        }
        if (made->ends[0] > made->ends[1])
            made->ends[0] = made->ends[1];
    }
    return count;
}
