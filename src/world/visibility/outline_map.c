/* SPDX-License-Identifier: MIT */
/* Laying sweeps out: what is hidden between two places at which lines begin, end or cross. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "outline_map.h"

enum { MOST_ACTIVE = 20000, SLABS_BETWEEN_QUESTIONS = 64 };

/* ---- gaps ---- */

/* Between the borders of a strip: by the lines that they are. */
static bool range_of_strip(const struct map_build *build, double u, double range[2])
{
    unsigned found = 0;
    for (size_t i = 0; i < build->row_count; i++) {
        const struct lx_outline_line *line = &build->map->lines[build->row[i]];
        if (line->kind == LX_OUTLINE_BORDER && found < 2)
            range[found++] = lx_outline_height(line, u);
    }
    return found == 2;
}

/* All of the rectangle around a round source: the shaft holds that, too (obstacle.h). */
static bool range_of_rectangle(const struct map_build *build, double range[2])
{
    const double room = 2e-6 * (build->v[1] - build->v[0]);
    range[0] = build->v[0] + room;
    range[1] = build->v[1] - room;
    return true;
}

/* The range that is looked at on the arc at u: of the source, above the horizons. */
static bool look_range(const struct map_build *build, double u, double range[2])
{
    if (!(build->sweep->kind == LX_SWEEP_STRIP ? range_of_strip(build, u, range) : range_of_rectangle(build, range)))
        return false;
    for (unsigned i = 0; i < build->horizon_count; i++) {
        const double *n = build->horizons[i];
        const struct lx_outline_line *line = NULL;
        for (size_t k = 0; k < build->row_count && !line; k++) {
            const struct lx_outline_line *other = &build->map->lines[build->row[k]];
            line = other->kind == LX_OUTLINE_HORIZON && other->change == (int)i ? other : NULL;
        }
        if (line && n[2] > 0)
            range[0] = fmax(range[0], lx_outline_height(line, u));
        else if (line)
            range[1] = fmin(range[1], lx_outline_height(line, u));
        else if (!(n[0] + n[1] * u + n[2] * (range[0] + range[1]) / 2 > 0))
            return false;
    }
    return range[0] < range[1];
}

/* The lines over u in their order, from that of the slab before. */
static void sort_row(struct map_build *build, double u)
{
    const struct lx_outline_line *lines = build->map->lines;
    for (size_t i = 1; i < build->row_count; i++) {
        const uint32_t moved = build->row[i];
        const double height = lx_outline_height(&lines[moved], u);
        size_t k = i;
        for (; k > 0 && lx_outline_height(&lines[build->row[k - 1]], u) > height; k--)
            build->row[k] = build->row[k - 1];
        build->row[k] = moved;
    }
}

/* Counts sheets in a gap by a ray. */
static int count_by_ray(const struct map_build *build, double u, const struct gap *gap)
{
    static const double SHARE = 0.57313;
    const struct lx_sweep_frame *frame = &build->sweep->frame;
    const double v = gap->low + SHARE * (gap->high - gap->low);
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = build->limit_mm * (frame->x[k] + u * frame->y[k] + v * frame->z[k]);
    return (int)lx_outline_layers(build->occlusion, way);
}

/* The gap that is highest of those for which `known` is, or of all; less than 0: none. */
static long widest(const struct map_build *build, bool known, double besides)
{
    long best = -1;
    double most = 0;
    for (size_t i = 0; i < build->gap_count; i++) {
        const struct gap *gap = &build->gaps[i];
        const double height = gap->high - gap->low;
        if (height > most && height < besides && (!known || gap->count != INT32_MIN)) {
            most = height;
            best = (long)i;
        }
    }
    return best;
}

static int change_of(const struct lx_outline_line *line)
{
    return line->kind == LX_OUTLINE_EDGE ? line->change : 0;
}

/* Counts all gaps from one on. */
static void spread_count(struct map_build *build, size_t from, int count)
{
    const struct lx_outline_line *lines = build->map->lines;
    build->gaps[from].count = count;
    for (size_t i = from + 1; i < build->gap_count; i++)
        build->gaps[i].count = build->gaps[i - 1].count + change_of(&lines[build->row[i]]);
    for (size_t i = from; i > 0; i--)
        build->gaps[i - 1].count = build->gaps[i].count - change_of(&lines[build->row[i]]);
}

/* Gaps between the lines, what is looked at in them, and what the slab before knew of them. */
static void make_gaps(struct map_build *build, double u, const double range[2])
{
    const struct lx_outline_line *lines = build->map->lines;
    build->gap_count = build->row_count > 0 ? build->row_count - 1 : 0;
    for (size_t i = 0; i < build->gap_count; i++) {
        struct gap *gap = &build->gaps[i];
        const uint32_t a = build->row[i], b = build->row[i + 1];
        gap->low = fmax(range[0], lx_outline_height(&lines[a], u));
        gap->high = fmin(range[1], lx_outline_height(&lines[b], u));
        gap->count = INT32_MIN;
        const int at = build->places[a];
        if (at >= 0 && build->places[b] == at + 1 && build->inside[at] && gap->high > gap->low)
            gap->count = build->counts[at];
    }
}

/*
 * How many sheets there are in each gap: by one that the slab before has, too, or by a ray; where they are told by a
 * ray, another one tries them, and where they differ each gap is told by itself.
 */
static void count_gaps(struct map_build *build, double u, double width, unsigned number)
{
    enum { OFTEN = 24 };
    static const double THIN = 1e-3;
    const long all = widest(build, false, HUGE_VAL), known = widest(build, true, HUGE_VAL);
    if (all < 0)
        return;
    const struct gap *wide = &build->gaps[all];
    const double height = wide->high - wide->low;
    const bool goes_on = known >= 0 && build->gaps[known].high - build->gaps[known].low > THIN * height;
    if (goes_on) {
        spread_count(build, (size_t)known, build->gaps[known].count);
        if (number % OFTEN != 0)
            return;
    } else {
        spread_count(build, (size_t)all, count_by_ray(build, u, wide));
    }
    const long other = goes_on ? all : widest(build, false, height);
    if (other < 0 || (!goes_on && build->gaps[other].high - build->gaps[other].low < THIN * height))
        return;
    if (count_by_ray(build, u, &build->gaps[other]) == build->gaps[other].count)
        return;
    for (size_t i = 0; i < build->gap_count; i++) {
        struct gap *gap = &build->gaps[i];
        if (!(gap->high > gap->low))
            continue;
        const int told = count_by_ray(build, u, gap);
        if ((told > 0) != (gap->count > 0))
            build->map->unsure += width * (gap->high - gap->low);
        gap->count = told;
    }
}

/* ---- slabs ---- */

/* Whether the last slab has the same parts as the one that begins with `first`. */
static bool is_same(const struct lx_trapezoid_map *map, const struct lx_outline_slab *slab)
{
    const struct lx_outline_slab *last = &map->slabs[map->slab_count - 1];
    return last->floor == slab->floor && last->ceiling == slab->ceiling && last->count == slab->count &&
           (slab->count == 0 ||
            memcmp(&map->parts[last->first], &map->parts[slab->first], slab->count * sizeof *map->parts) == 0);
}

/* The hidden parts of a slab, joined to the last one where they are the same.  The borders of a strip are lines
 * themselves; those of other sources may cross lines within a slab, so that all of its gaps matter. */
static int add_slab(struct map_build *build, double low, double high)
{
    struct lx_trapezoid_map *map = build->map;
    struct lx_outline_slab slab = {.low = low, .high = high, .first = (uint32_t)map->part_count};
    const bool is_strip = build->sweep->kind == LX_SWEEP_STRIP;
    bool any = false, goes_on = false;
    if (lx_reserve(&map->parts, &map->part_capacity, map->part_count + build->gap_count + 1, sizeof *map->parts) ||
        lx_reserve(&map->slabs, &map->slab_capacity, map->slab_count + 1, sizeof *map->slabs))
        return -1;
    for (size_t i = 0; i < build->gap_count; i++) {
        const struct gap *gap = &build->gaps[i];
        if (gap->count == INT32_MIN || (is_strip && !(gap->high > gap->low))) {
            goes_on = false;
            continue;
        }
        slab.floor = any ? slab.floor : build->row[i];
        slab.ceiling = build->row[i + 1];
        any = true;
        if (gap->count > 0 && goes_on)
            map->parts[map->part_count - 1].upper = build->row[i + 1];
        else if (gap->count > 0)
            map->parts[map->part_count++] = (struct lx_outline_part){build->row[i], build->row[i + 1]};
        goes_on = gap->count > 0;
    }
    slab.count = (uint32_t)map->part_count - slab.first;
    if (map->slab_count > 0 && is_same(map, &slab)) {
        map->slabs[map->slab_count - 1].high = high;
        map->part_count = slab.first;
        return 0;
    }
    map->slabs[map->slab_count++] = slab;
    return 0;
}

/* Keeps what the next slab may go on with. */
static void remember(struct map_build *build)
{
    for (size_t i = 0; i < build->row_count; i++)
        build->places[build->row[i]] = (int)i;
    for (size_t i = 0; i < build->gap_count; i++) {
        build->counts[i] = build->gaps[i].count;
        build->inside[i] = build->gaps[i].high > build->gaps[i].low;
    }
}

static void forget(struct map_build *build)
{
    for (size_t i = 0; i < build->row_count; i++)
        build->places[build->row[i]] = -1;
}

/* Lines that end are taken out of the row, those that begin appended; room for what is in it. */
static int change_row(struct map_build *build, double low, size_t *next)
{
    const struct lx_trapezoid_map *map = build->map;
    size_t kept = 0;
    for (size_t i = 0; i < build->row_count; i++) {
        const uint32_t line = build->row[i];
        if (map->lines[line].high > low)
            build->row[kept++] = line;
        else
            build->places[line] = -1;
    }
    build->row_count = kept;
    for (; *next < map->line_count && map->lines[*next].low <= low; (*next)++) {
        if (!(map->lines[*next].high > low))
            continue;
        const size_t needed = build->row_count + 2;
        if (lx_reserve(&build->row, &build->row_capacity, needed, sizeof *build->row) ||
            lx_reserve(&build->gaps, &build->gap_capacity, needed, sizeof *build->gaps) ||
            lx_reserve(&build->counts, &build->count_capacity, needed, sizeof *build->counts) ||
            lx_reserve(&build->inside, &build->inside_capacity, needed, sizeof *build->inside))
            return -1;
        build->row[build->row_count++] = (uint32_t)*next;
    }
    return 0;
}

/* Whether an edge stands upright where a slab begins. */
static bool is_at_wall(const struct map_build *build, double low, double start, size_t *wall)
{
    bool found = false;
    for (; *wall < build->wall_count && build->walls[*wall] <= start; (*wall)++)
        found = found || build->walls[*wall] >= low;
    return found;
}

/* A slab from `low`; its lines are those that go on behind `start`. */
static int make_slab(struct map_build *build, double low, double start, double high, unsigned number)
{
    static const double SHARE = 0.46371;
    const double u = start + SHARE * (high - start);
    double range[2] = {0, 0};
    sort_row(build, u);
    if (!look_range(build, u, range))
        range[0] = range[1] = 0;
    make_gaps(build, u, range);
    count_gaps(build, u, high - low, number);
    if (add_slab(build, low, high))
        return -1;
    remember(build);
    return 0;
}

static int make_slabs(struct map_build *build, const struct lx_asking *asking)
{
    static const double NARROW = 1e-13, ROUNDING = 4e-16, UNSURE = 1e-11;
    struct lx_trapezoid_map *map = build->map;
    const double *ends = build->u, height = build->v[1] - build->v[0];
    const double least = NARROW * (ends[1] - ends[0]) + ROUNDING * (fabs(ends[0]) + fabs(ends[1]));
    size_t next = 0, wall = 0;
    map->area = (ends[1] - ends[0]) * height;
    if (ends[1] - ends[0] < UNSURE * (fabs(ends[0]) + fabs(ends[1]))) /* a strip between corners of one longitude */
        map->skipped += (ends[1] - ends[0]) * height;
    if (lx_reserve(&build->places, &build->place_capacity, map->line_count + 1, sizeof *build->places))
        return -1;
    for (size_t i = 0; i < map->line_count; i++)
        build->places[i] = -1;
    /* events that are very near to each other are one, and a slab begins at the last of them */
    double low = ends[0], start = low;
    for (size_t i = 0; i < build->event_count; i++) {
        const double high = build->events[i];
        if (!(high - start > least)) {
            map->skipped += fmax(high - start, 0) * height;
            start = fmax(start, high);
            continue;
        }
        if (i % SLABS_BETWEEN_QUESTIONS == 0 && !lx_asking_goes_on(asking))
            return 0;
        if (is_at_wall(build, low, start, &wall) || start > low)
            forget(build);
        if (change_row(build, start, &next))
            return -1;
        build->occlusion->outline->is_broken |= build->row_count > MOST_ACTIVE;
        if (build->row_count > MOST_ACTIVE)
            return 0;
        if (make_slab(build, low, start, high, (unsigned)i))
            return -1;
        low = start = high;
    }
    if (map->slab_count > 0)
        map->slabs[map->slab_count - 1].high = ends[1];
    return 0;
}

static void free_laying(struct map_build *build)
{
    free(build->events);
    free(build->walls);
    free(build->gaps);
    free(build->row);
    free(build->places);
    free(build->counts);
    free(build->inside);
}

/* ---- the whole ---- */

static int lay_sweep(struct map_build *build, const struct lx_asking *asking)
{
    struct lx_trapezoid_map *map = build->map;
    map->line_count = map->part_count = map->slab_count = 0;
    map->unsure = map->skipped = map->area = 0;
    build->event_count = build->wall_count = build->row_count = build->gap_count = 0;
    build->horizon_count = 0;
    if (lx_outline_draw(build))
        return -1;
    return build->occlusion->outline->is_broken || build->event_count == 0 ? 0 : make_slabs(build, asking);
}

int lx_trapezoid_map(const struct lx_occlusion *occlusion, const struct lx_sweeps *sweeps,
                     const struct lx_asking *asking)
{
    struct lx_sheet_outline *outline = occlusion->outline;
    struct map_build build = {.occlusion = occlusion};
    const size_t before = outline->lay_count;
    size_t capacity = before;
    int failed = 0;
    outline->sweeps = sweeps;
    outline->is_doubtful = outline->is_broken = false;
    if (sweeps->count > before) {
        if (lx_reserve(&outline->lays, &capacity, sweeps->count, sizeof *outline->lays))
            return -1;
        memset(outline->lays + before, 0, (sweeps->count - before) * sizeof *outline->lays);
        outline->lay_count = sweeps->count;
    }
    for (size_t i = 0; i < outline->lay_count; i++)
        outline->lays[i].line_count = outline->lays[i].part_count = outline->lays[i].slab_count = 0,
        outline->lays[i].unsure = outline->lays[i].skipped = outline->lays[i].area = 0;
    for (size_t i = 0; i < sweeps->count && !failed; i++) {
        build.sweep = &sweeps->items[i];
        build.map = &outline->lays[i];
        failed = lay_sweep(&build, asking);
    }
    free_laying(&build);
    return failed;
}
