/* SPDX-License-Identifier: MIT */
/* Where to begin along edges, of which pixels tell little: the rims of the surfaces, the screen and the region. */
#include "extrema.h"

/* Places along a rim: fewer where a value is costly, and where there are many surfaces. */
enum { RIM_PLACES = 96, RIM_PLACES_COSTLY = 16, LEAST_RIM_PLACES = 12, MOST_RIM_PLACES = 768 };
/* Places along each side of screen or region, and in each direction inside a region. */
enum { BORDER_PLACES = 40, BORDER_PLACES_COSTLY = 2, REGION_PLACES = 5 };
enum { RING_PLACES = 4 * BORDER_PLACES };

/* Places in a ring, one beside the other. */
struct ring {
    struct lx_spot spots[RING_PLACES];
    double values[RING_PLACES]; /* -HUGE_VAL: nothing is seen there, and the spot is none */
    int count;
};

/* The peaks of a ring. */
static void gather_ring(struct lx_gathering *gathering, const struct ring *ring)
{
    for (int i = 0; i < ring->count; i++) {
        double value = ring->values[i], margin = 0.02 * fabs(value);
        bool lone = false, peak = value > -HUGE_VAL;
        for (int step = -1; peak && step <= 1; step += 2) {
            int next = (i + step + ring->count) % ring->count;
            double beside = ring->values[next];
            if (beside > -HUGE_VAL && ring->spots[next].surface != ring->spots[i].surface)
                beside = -HUGE_VAL;
            peak = beside <= value;
            lone = lone || beside == -HUGE_VAL;
            margin = fmax(margin, 2 * (value - beside));
        }
        if (peak)
            lx_gather_spot(gathering, &ring->spots[i], value,
                           lone ? lx_unreported_margin(gathering->search, value) : margin);
    }
}

static bool is_in_box(const struct lx_gathering *gathering, const double screen_mm[2])
{
    return screen_mm[0] >= gathering->low[0] && screen_mm[0] <= gathering->high[0] &&
           screen_mm[1] >= gathering->low[1] && screen_mm[1] <= gathering->high[1];
}

/* What is seen beside the rim of a surface, of another one behind. */
static bool look_beside(struct lx_gathering *gathering, const struct lx_spot *rim, const double center[2],
                        struct lx_spot *spot, double *value)
{
    double place[3], normal[3], screen[2];
    lx_spot_place(gathering->search, rim, place, normal);
    lx_screen_of(gathering->search, place, screen);
    for (int i = 0; i < 2; i++)
        screen[i] += 1e-6 * (screen[i] - center[i]);
    return is_in_box(gathering, screen) && lx_look_through(gathering, screen, spot, value);
}

static int rim_places(const struct lx_extremum_search *search)
{
    size_t all = search->costly ? RIM_PLACES_COSTLY : RIM_PLACES,
           share = MOST_RIM_PLACES / search->prepared->surface_count;
    return (int)(share < LEAST_RIM_PLACES ? LEAST_RIM_PLACES : share < all ? share : all);
}

void lx_gather_rim(struct lx_gathering *gathering, size_t surface)
{
    struct lx_extremum_search *search = gathering->search;
    const struct lx_shape *shape = &search->prepared->surfaces[surface].shape;
    struct ring ring = {.count = rim_places(search) / 4 * 4}, behind;
    double center[2];
    const struct lx_origin eye = lx_eye_of(search);
    for (int i = 0; i < ring.count; i++) {
        ring.spots[i].surface = surface;
        shape->kind->chart->rim(shape, &eye, i, ring.count, ring.spots[i].at);
    }
    behind.count = search->prepared->surface_count > 1 ? ring.count : 0;
    if (!lx_screen_of(search, shape->anchor_mm, center))
        center[0] = center[1] = 0;
    for (int i = 0; i < ring.count; i++) {
        if (!lx_look_at_spot(search, &ring.spots[i], &ring.values[i]))
            ring.values[i] = -HUGE_VAL;
        if (behind.count > 0 && !look_beside(gathering, &ring.spots[i], center, &behind.spots[i], &behind.values[i]))
            behind.values[i] = -HUGE_VAL;
    }
    gather_ring(gathering, &ring);
    gather_ring(gathering, &behind);
}

void lx_gather_border(struct lx_gathering *gathering)
{
    const luxel_region *region = gathering->search->region;
    struct ring ring = {.count = 4 * (gathering->search->costly ? BORDER_PLACES_COSTLY : BORDER_PLACES)};
    int grid = region && region->type != LUXEL_REGION_ALL ? REGION_PLACES : 0;
    double middle[2], half[2], at[2];
    for (int k = 0; k < 2; k++) {
        middle[k] = (gathering->low[k] + gathering->high[k]) / 2;
        half[k] = (gathering->high[k] - gathering->low[k]) / 2;
    }
    for (int i = 0; i < ring.count; i++) {
        lx_around_square(i, ring.count, at);
        for (int k = 0; k < 2; k++)
            at[k] = middle[k] + at[k] * half[k];
        if (!lx_look_through(gathering, at, &ring.spots[i], &ring.values[i]))
            ring.values[i] = -HUGE_VAL;
    }
    gather_ring(gathering, &ring);
    for (int i = 0; i < grid * grid; i++) { /* a region may be smaller than a pixel */
        double part[2] = {i % grid / (grid - 1.0), i / grid / (grid - 1.0)}, value;
        struct lx_spot spot;
        for (int k = 0; k < 2; k++)
            at[k] = middle[k] + (2 * part[k] - 1) * half[k];
        if (lx_look_through(gathering, at, &spot, &value))
            lx_gather_spot(gathering, &spot, value, lx_unreported_margin(gathering->search, value));
    }
}
