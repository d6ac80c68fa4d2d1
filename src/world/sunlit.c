/* SPDX-License-Identifier: MIT */
/* The sun on an element, stretch by stretch of its day. */
#include "sunlit.h"

#include <math.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "visibility/occlusion.h"

/* Stretches to begin with, in which the sun goes less than 4 degrees. */
static const double FIRST_S = 900;
/* How much wider than half the way between its ends a disk is that holds a stretch of the way, which is a part of a
 * circle but for what the sun moves among the stars. */
static const double WIDER = 1.01, LEAST_RAD = 1e-9;

struct looking {
    const struct lx_prepared *prepared;
    const struct lx_element *element;
    const struct lx_sun_day *day;
    const struct lx_asking *asking;
    double place_mm[3], normal[3], away_mm;
    struct lx_sun_spans *spans;
};

enum seen { HIDDEN, SEEN, UNKNOWN };

static double look(const struct looking *looking, double seconds, double towards[3])
{
    return lx_sun_site_look(looking->day->site, looking->day->midnight + seconds / LX_DAY_S, towards);
}

static bool is_seen(const struct looking *looking, double seconds)
{
    struct lx_emitter sun;
    double towards[3];
    if (!(look(looking, seconds, towards) > looking->day->least_deg))
        return false;
    lx_sun_as_direction(towards, &sun);
    return !looking->element || (lx_dot(looking->normal, towards) > 0 &&
                                 lx_openness_of(looking->prepared, looking->element, &sun).value > 0);
}

/* What can be told at once of a disk of the sky. */
static enum seen ask_obstacles(const struct looking *looking, const double towards[3], double radius_rad)
{
    struct lx_emitter disk;
    struct lx_occlusion occlusion = {.place_mm = {0}};
    enum seen seen = UNKNOWN;
    lx_sky_disk(towards, radius_rad, looking->place_mm, looking->away_mm, &disk);
    if (!lx_occlusion_make(looking->prepared, looking->element, &disk, true, &occlusion))
        seen = !lx_is_occluded(&occlusion) ? SEEN : lx_occlusion_hides_all(&occlusion, &disk) ? HIDDEN : UNKNOWN;
    lx_occlusion_clear(&occlusion);
    return seen;
}

static enum seen ask(const struct looking *looking, double from_s, double to_s)
{
    double first[3], last[3], middle[3];
    look(looking, from_s, first);
    look(looking, to_s, last);
    const double altitude_rad = look(looking, (from_s + to_s) / 2, middle) * (M_PI / 180);
    const double wide_rad = fmax(lx_angle_between(first, middle), lx_angle_between(last, middle)) * WIDER + LEAST_RAD;
    const double above_rad = altitude_rad - looking->day->least_deg * (M_PI / 180);
    if (above_rad < -wide_rad)
        return HIDDEN;
    const double before_rad = looking->element ? asin(fmax(-1, fmin(lx_dot(looking->normal, middle), 1))) : M_PI;
    if (before_rad < -wide_rad)
        return HIDDEN;
    if (above_rad <= wide_rad || before_rad <= wide_rad)
        return UNKNOWN;
    if (!looking->element || !looking->prepared->shadows_on_free)
        return SEEN;
    return ask_obstacles(looking, middle, wide_rad);
}

static int append(struct lx_sun_spans *spans, double from_s, double to_s)
{
    if (spans->count > 0 && spans->items[spans->count - 1].to_s == from_s) {
        spans->items[spans->count - 1].to_s = to_s;
        return 0;
    }
    if (lx_reserve(&spans->items, &spans->capacity, spans->count + 1, sizeof *spans->items))
        return -1;
    spans->items[spans->count++] = (luxel_sun_span){from_s, to_s};
    return 0;
}

/* A stretch too short to be halved, of which the ends tell. */
static int end(const struct looking *looking, double from_s, double to_s)
{
    const bool is_first = is_seen(looking, from_s), is_last = is_seen(looking, to_s);
    double low = from_s, high = to_s;
    if (is_first == is_last)
        return is_first ? append(looking->spans, from_s, to_s) : 0;
    while (high - low > LX_SUN_TIME_S) {
        const double middle = (low + high) / 2;
        if (is_seen(looking, middle) == is_first)
            low = middle;
        else
            high = middle;
    }
    const double change = (low + high) / 2;
    return is_first ? append(looking->spans, from_s, change) : append(looking->spans, change, to_s);
}

static int walk(const struct looking *looking, double from_s, double to_s)
{
    if (!lx_asking_goes_on(looking->asking))
        return 0;
    const enum seen seen = ask(looking, from_s, to_s);
    if (seen != UNKNOWN)
        return seen == SEEN ? append(looking->spans, from_s, to_s) : 0;
    if (to_s - from_s <= LX_SUN_STEP_S)
        return end(looking, from_s, to_s);
    const double middle = (from_s + to_s) / 2;
    return walk(looking, from_s, middle) ? -1 : walk(looking, middle, to_s);
}

int lx_find_sunlit(const struct lx_prepared *prepared, const struct lx_element *element, const struct lx_sun_day *day,
                   const struct lx_asking *asking, struct lx_sun_spans *spans)
{
    struct looking looking = {.prepared = prepared, .element = element, .day = day, .asking = asking, .spans = spans};
    if (element) {
        lx_values3(element->place_mm, looking.place_mm);
        lx_values3(element->normal, looking.normal);
        looking.away_mm = lx_beyond_all(prepared, looking.place_mm);
    }
    for (double from = 0; from < LX_DAY_S; from += FIRST_S)
        if (walk(&looking, from, from + FIRST_S))
            return -1;
    return 0;
}
