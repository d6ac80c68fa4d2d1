/* SPDX-License-Identifier: MIT */
/*
 * Highlights behind meshes.  What an outline (outline.h) leaves of a source are trapezoids in the tangents (u, v) of a
 * sweep's longitude and latitude; over each, and over its halves where it is wide for the lobe, the highlight is a
 * product rule of Gauss.  Seen from the element, (1, u, v) lies in a plane at the distance 1, in which du dv is an
 * area.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/vector.h"
#include "../kernel/sector_rules.h"
#include "../world/visibility/outline.h"
#include "partial_highlight.h"

enum { MOST_PENDING = 64, MOST_PARTS = 20000 };

/* Share of what is allowed for parts that are left out, each of them by itself. */
static const double LEFT_OUT = 0.1;

/* Parts that reach farther from their middle are halved, as those that are longer in widths of the lobe. */
static const double WIDEST = 0.4, MOST_WIDTHS = 2.7;

/* Lobes with smaller exponents end steeply. */
static const double SMOOTH = 4;

/* From u to u, between two lines. */
struct part {
    double low, high, start[2], rise[2];
};

struct work {
    const struct lx_partial_highlight *asked;
    const struct lx_sweep_frame *frame;
    struct lx_lobe_at at;
    double most; /* of the highlight, for a solid angle of 1 and S = 1 */
    double sum, left_out;
    size_t node_count, part_count;
    struct lx_beams_double beams;
};

static void flush(struct work *work)
{
    if (work->node_count > 0)
        work->sum += lx_partial_highlight_of_beams(work->asked, &work->beams, work->node_count);
    work->node_count = 0;
}

static void place_at(const struct work *work, double u, double v, double place[3])
{
    const struct lx_sweep_frame *frame = work->frame;
    for (int k = 0; k < 3; k++)
        place[k] = frame->x[k] + u * frame->y[k] + v * frame->z[k];
}

static double height_of(const struct part *part, int line, double u)
{
    return part->start[line] + part->rise[line] * u;
}

/* The rule over a part, with so many nodes each way. */
static void add_nodes(struct work *work, const struct part *part, unsigned across, unsigned along)
{
    struct lx_beams_double *beams = &work->beams;
    const double width = part->high - part->low;
    if (work->node_count + across * along > LX_BLOCK)
        flush(work);
    for (unsigned i = 0; i < across; i++) {
        const double u = part->low + lx_sector_places[across - 1][i] * width;
        const double from = height_of(part, 0, u), height = height_of(part, 1, u) - from;
        for (unsigned k = 0; k < along; k++) {
            const size_t at = work->node_count++;
            double place[3];
            place_at(work, u, from + lx_sector_places[along - 1][k] * height, place);
            beams->x[at] = place[0], beams->y[at] = place[1], beams->z[at] = place[2];
            beams->weight[at] =
                lx_sector_weights[across - 1][i] * lx_sector_weights[along - 1][k] * width * fmax(height, 0);
        }
    }
}

/* How large a part is: as angles, and no more than that. */
struct look {
    double middle[3];
    double across, along; /* lengths, at its middle */
    double reach;         /* the farthest corner from the middle, a sine's bound */
    double area;
};

static struct look look_at(const struct work *work, const struct part *part)
{
    struct look look = {.reach = 0};
    const double u = (part->low + part->high) / 2, width = part->high - part->low;
    const double v = (height_of(part, 0, u) + height_of(part, 1, u)) / 2;
    const double left = height_of(part, 1, part->low) - height_of(part, 0, part->low);
    const double right = height_of(part, 1, part->high) - height_of(part, 0, part->high);
    place_at(work, u, v, look.middle);
    const double away = lx_normalize(look.middle);
    for (int line = 0; line < 2; line++)
        for (int end = 0; end < 2; end++) {
            const double at = end ? part->high : part->low;
            look.reach = fmax(look.reach, hypot(at - u, height_of(part, line, at) - v) / away);
        }
    const double rise = fmax(fabs(part->rise[0]), fabs(part->rise[1]));
    look.across = width * sqrt(1 + rise * rise) / away;
    look.along = fmax(left, right) / away;
    look.area = width * fmax(left + right, 0) / 2;
    return look;
}

/* The halves of a part: left and right, or below and above. */
static void halve(const struct part *part, bool across, struct part halves[2])
{
    halves[0] = halves[1] = *part;
    if (across) {
        halves[0].high = halves[1].low = (part->low + part->high) / 2;
        return;
    }
    halves[0].start[1] = halves[1].start[0] = (part->start[0] + part->start[1]) / 2;
    halves[0].rise[1] = halves[1].rise[0] = (part->rise[0] + part->rise[1]) / 2;
}

/* How many nodes do along a length for the cosines alone. */
static unsigned least_order(double length)
{
    return length < 0.01 ? 1 : length < 0.15 ? 2 : length < 0.4 ? 3 : 4;
}

/* Adds a part; false: there are too many. */
static bool add_part(struct work *work, const struct part *whole)
{
    struct part pending[MOST_PENDING];
    size_t count = 1;
    pending[0] = *whole;
    while (count > 0) {
        const struct part part = pending[--count];
        const struct look look = look_at(work, &part);
        if (++work->part_count > MOST_PARTS)
            return false;
        const double sine = fmin(look.reach, 1), cosine = sqrt(1 - sine * sine);
        const double bound =
            work->most * look.area *
            (sine < 1 ? lx_sector_power(work->asked->lobe, work->at.mirrored, look.middle, cosine, sine) : 1);
        if (work->left_out + bound <= LEFT_OUT * work->asked->allowed) {
            work->left_out += bound;
            continue;
        }
        const double width = lx_sector_width(work->asked->lobe, work->asked->view, look.middle, sine);
        const double longest = fmax(look.across, look.along);
        if (longest > 2 * WIDEST || longest > 2 * MOST_WIDTHS * width) {
            if (count + 2 > MOST_PENDING)
                return false;
            halve(&part, look.across > look.along, pending + count);
            count += 2;
            continue;
        }
        add_nodes(work, &part, lx_sector_order(least_order(look.across), look.across / 2 / width),
                  lx_sector_order(least_order(look.along), look.along / 2 / width));
    }
    return true;
}

/* All that is seen of a sweep. */
static bool add_lay(struct work *work, const struct lx_trapezoid_map *map)
{
    for (size_t i = 0; i < map->slab_count; i++) {
        const struct lx_outline_slab *slab = &map->slabs[i];
        uint32_t from = slab->floor;
        if (slab->floor == slab->ceiling)
            continue; /* nothing is looked at */
        for (uint32_t k = 0; k <= slab->count; k++) {
            const uint32_t to = k < slab->count ? map->parts[slab->first + k].lower : slab->ceiling;
            const struct lx_outline_line *lower = &map->lines[from], *upper = &map->lines[to];
            const struct part part = {slab->low, slab->high, {lower->start, upper->start}, {lower->rise, upper->rise}};
            if (from != to && !add_part(work, &part))
                return false;
            from = k < slab->count ? map->parts[slab->first + k].upper : from;
        }
    }
    return true;
}

bool lx_partial_highlight_outline(const struct lx_partial_highlight *partial, const struct lx_asking *asking,
                                  double *sum)
{
    const struct lx_emitter *emitter = partial->source->emitter;
    struct lx_occlusion with_horizon = *partial->occlusion, *const occlusion = &with_horizon;
    struct lx_sweeps sweeps = {0};
    struct work work; /* large: what is not needed stays as it is */
    if (!emitter->facets || emitter->attenuation != LX_INVERSE_SQUARE || !lx_outline_is_alone(occlusion) ||
        partial->lobe->exponent.value < SMOOTH ||
        (LX_ENDS_AT_HORIZON(partial->lobe->highlight) && !lx_outline_add_horizon(occlusion, partial->normal)))
        return false;
    bool is_good = lx_sweeps_make(emitter, occlusion->place_mm, partial->normal, true, &sweeps) == 0 &&
                   lx_trapezoid_map(occlusion, &sweeps, asking) == 0 && !occlusion->outline->is_broken;
    work.asked = partial;
    work.most = emitter->radiance.value * partial->lobe->specular;
    work.sum = work.left_out = 0;
    work.node_count = work.part_count = 0;
    lx_lobe_at_set(partial->normal, partial->view, &work.at);
    if (is_good)
        is_good = work.most * (lx_outline_unsure(occlusion->outline) + lx_outline_skipped(occlusion->outline)) <=
                  LEFT_OUT * partial->allowed;
    for (size_t i = 0; i < sweeps.count && is_good; i++) {
        work.frame = &sweeps.items[i].frame;
        is_good = add_lay(&work, &occlusion->outline->lays[i]);
        flush(&work);
    }
    free(sweeps.items);
    *sum = is_good ? fmax(work.sum, 0) : 0;
    return is_good && lx_asking_goes_on(asking);
}
