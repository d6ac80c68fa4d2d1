/* SPDX-License-Identifier: MIT */
/* Laying sweeps out: what is hidden between two places at which lines begin, end or cross. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "outline_lay.h"

enum { MOST_ACTIVE = 20000, SLABS_BETWEEN_QUESTIONS = 64 };

/* ---- gaps ---- */

/* Between the borders of a strip: by the lines that they are. */
static bool range_of_strip(const struct laying *laying, double u, double range[2])
{
    unsigned found = 0;
    for (size_t i = 0; i < laying->row_count; i++) {
        const struct lx_outline_line *line = &laying->lay->lines[laying->row[i]];
        if (line->kind == LX_OUTLINE_BORDER && found < 2)
            range[found++] = lx_outline_height(line, u);
    }
    return found == 2;
}

/* All of the rectangle around a round source: the shaft holds that, too (obstacle.h). */
static bool range_of_rectangle(const struct laying *laying, double range[2])
{
    const double room = 2e-6 * (laying->v[1] - laying->v[0]);
    range[0] = laying->v[0] + room;
    range[1] = laying->v[1] - room;
    return true;
}

/* What is looked at on the arc at u: of the source, above the horizons. */
static bool look_range(const struct laying *laying, double u, double range[2])
{
    if (!(laying->sweep->kind == LX_SWEEP_STRIP ? range_of_strip(laying, u, range) : range_of_rectangle(laying, range)))
        return false;
    for (unsigned i = 0; i < laying->horizon_count; i++) {
        const double *n = laying->horizons[i];
        const struct lx_outline_line *line = NULL;
        for (size_t k = 0; k < laying->row_count && !line; k++) {
            const struct lx_outline_line *other = &laying->lay->lines[laying->row[k]];
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
static void sort_row(struct laying *laying, double u)
{
    const struct lx_outline_line *lines = laying->lay->lines;
    for (size_t i = 1; i < laying->row_count; i++) {
        const uint32_t moved = laying->row[i];
        const double height = lx_outline_height(&lines[moved], u);
        size_t k = i;
        for (; k > 0 && lx_outline_height(&lines[laying->row[k - 1]], u) > height; k--)
            laying->row[k] = laying->row[k - 1];
        laying->row[k] = moved;
    }
}

/* Counts sheets in a gap by a ray. */
static int count_by_ray(const struct laying *laying, double u, const struct gap *gap)
{
    static const double SHARE = 0.57313;
    const struct lx_sweep_frame *frame = &laying->sweep->frame;
    const double v = gap->low + SHARE * (gap->high - gap->low);
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = laying->limit_mm * (frame->x[k] + u * frame->y[k] + v * frame->z[k]);
    return (int)lx_outline_layers(laying->occlusion, way);
}

/* The gap that is highest of those for which `known` is, or of all; less than 0: none. */
static long widest(const struct laying *laying, bool known, double besides)
{
    long best = -1;
    double most = 0;
    for (size_t i = 0; i < laying->gap_count; i++) {
        const struct gap *gap = &laying->gaps[i];
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
static void spread_count(struct laying *laying, size_t from, int count)
{
    const struct lx_outline_line *lines = laying->lay->lines;
    laying->gaps[from].count = count;
    for (size_t i = from + 1; i < laying->gap_count; i++)
        laying->gaps[i].count = laying->gaps[i - 1].count + change_of(&lines[laying->row[i]]);
    for (size_t i = from; i > 0; i--)
        laying->gaps[i - 1].count = laying->gaps[i].count - change_of(&lines[laying->row[i]]);
}

/* Gaps between the lines, what is looked at in them, and what the slab before knew of them. */
static void make_gaps(struct laying *laying, double u, const double range[2])
{
    const struct lx_outline_line *lines = laying->lay->lines;
    laying->gap_count = laying->row_count > 0 ? laying->row_count - 1 : 0;
    for (size_t i = 0; i < laying->gap_count; i++) {
        struct gap *gap = &laying->gaps[i];
        const uint32_t a = laying->row[i], b = laying->row[i + 1];
        gap->low = fmax(range[0], lx_outline_height(&lines[a], u));
        gap->high = fmin(range[1], lx_outline_height(&lines[b], u));
        gap->count = INT32_MIN;
        const int at = laying->places[a];
        if (at >= 0 && laying->places[b] == at + 1 && laying->inside[at] && gap->high > gap->low)
            gap->count = laying->counts[at];
    }
}

/*
 * How many sheets there are in each gap: by one that the slab before has, too, or by a ray; where they are told by a
 * ray, another one tries them, and where they differ each gap is told by itself.
 */
static void count_gaps(struct laying *laying, double u, double width, unsigned number)
{
    enum { OFTEN = 24 };
    static const double THIN = 1e-3;
    const long all = widest(laying, false, HUGE_VAL), known = widest(laying, true, HUGE_VAL);
    if (all < 0)
        return;
    const struct gap *wide = &laying->gaps[all];
    const double height = wide->high - wide->low;
    const bool goes_on = known >= 0 && laying->gaps[known].high - laying->gaps[known].low > THIN * height;
    if (goes_on) {
        spread_count(laying, (size_t)known, laying->gaps[known].count);
        if (number % OFTEN != 0)
            return;
    } else {
        spread_count(laying, (size_t)all, count_by_ray(laying, u, wide));
    }
    const long other = goes_on ? all : widest(laying, false, height);
    if (other < 0 || (!goes_on && laying->gaps[other].high - laying->gaps[other].low < THIN * height))
        return;
    if (count_by_ray(laying, u, &laying->gaps[other]) == laying->gaps[other].count)
        return;
    for (size_t i = 0; i < laying->gap_count; i++) {
        struct gap *gap = &laying->gaps[i];
        if (!(gap->high > gap->low))
            continue;
        const int told = count_by_ray(laying, u, gap);
        if ((told > 0) != (gap->count > 0))
            laying->lay->unsure += width * (gap->high - gap->low);
        gap->count = told;
    }
}

/* ---- slabs ---- */

/* Whether the last slab has the same parts as the one that begins with `first`. */
static bool is_same(const struct lx_outline_lay *lay, const struct lx_outline_slab *slab)
{
    const struct lx_outline_slab *last = &lay->slabs[lay->slab_count - 1];
    return last->floor == slab->floor && last->ceiling == slab->ceiling && last->count == slab->count &&
           (slab->count == 0 ||
            memcmp(&lay->parts[last->first], &lay->parts[slab->first], slab->count * sizeof *lay->parts) == 0);
}

/* The hidden parts of a slab, joined to the last one where they are the same.  The borders of a strip are lines
 * themselves; those of other sources may cross lines within a slab, so that all of its gaps matter. */
static int add_slab(struct laying *laying, double low, double high)
{
    struct lx_outline_lay *lay = laying->lay;
    struct lx_outline_slab slab = {.low = low, .high = high, .first = (uint32_t)lay->part_count};
    const bool is_strip = laying->sweep->kind == LX_SWEEP_STRIP;
    bool any = false, goes_on = false;
    if (lx_reserve(&lay->parts, &lay->part_capacity, lay->part_count + laying->gap_count + 1, sizeof *lay->parts) ||
        lx_reserve(&lay->slabs, &lay->slab_capacity, lay->slab_count + 1, sizeof *lay->slabs))
        return -1;
    for (size_t i = 0; i < laying->gap_count; i++) {
        const struct gap *gap = &laying->gaps[i];
        if (gap->count == INT32_MIN || (is_strip && !(gap->high > gap->low))) {
            goes_on = false;
            continue;
        }
        slab.floor = any ? slab.floor : laying->row[i];
        slab.ceiling = laying->row[i + 1];
        any = true;
        if (gap->count > 0 && goes_on)
            lay->parts[lay->part_count - 1].upper = laying->row[i + 1];
        else if (gap->count > 0)
            lay->parts[lay->part_count++] = (struct lx_outline_part){laying->row[i], laying->row[i + 1]};
        goes_on = gap->count > 0;
    }
    slab.count = (uint32_t)lay->part_count - slab.first;
    if (lay->slab_count > 0 && is_same(lay, &slab)) {
        lay->slabs[lay->slab_count - 1].high = high;
        lay->part_count = slab.first;
        return 0;
    }
    lay->slabs[lay->slab_count++] = slab;
    return 0;
}

/* Keeps what the next slab may go on with. */
static void remember(struct laying *laying)
{
    for (size_t i = 0; i < laying->row_count; i++)
        laying->places[laying->row[i]] = (int)i;
    for (size_t i = 0; i < laying->gap_count; i++) {
        laying->counts[i] = laying->gaps[i].count;
        laying->inside[i] = laying->gaps[i].high > laying->gaps[i].low;
    }
}

static void forget(struct laying *laying)
{
    for (size_t i = 0; i < laying->row_count; i++)
        laying->places[laying->row[i]] = -1;
}

/* Lines that end are taken out of the row, those that begin appended; room for what is in it. */
static int change_row(struct laying *laying, double low, size_t *next)
{
    const struct lx_outline_lay *lay = laying->lay;
    size_t kept = 0;
    for (size_t i = 0; i < laying->row_count; i++) {
        const uint32_t line = laying->row[i];
        if (lay->lines[line].high > low)
            laying->row[kept++] = line;
        else
            laying->places[line] = -1;
    }
    laying->row_count = kept;
    for (; *next < lay->line_count && lay->lines[*next].low <= low; (*next)++) {
        if (!(lay->lines[*next].high > low))
            continue;
        const size_t needed = laying->row_count + 2;
        if (lx_reserve(&laying->row, &laying->row_capacity, needed, sizeof *laying->row) ||
            lx_reserve(&laying->gaps, &laying->gap_capacity, needed, sizeof *laying->gaps) ||
            lx_reserve(&laying->counts, &laying->count_capacity, needed, sizeof *laying->counts) ||
            lx_reserve(&laying->inside, &laying->inside_capacity, needed, sizeof *laying->inside))
            return -1;
        laying->row[laying->row_count++] = (uint32_t)*next;
    }
    return 0;
}

/* Whether an edge stands upright where a slab begins. */
static bool is_at_wall(const struct laying *laying, double low, double start, size_t *wall)
{
    bool found = false;
    for (; *wall < laying->wall_count && laying->walls[*wall] <= start; (*wall)++)
        found = found || laying->walls[*wall] >= low;
    return found;
}

/* A slab from `low`; its lines are those that go on behind `start`. */
static int make_slab(struct laying *laying, double low, double start, double high, unsigned number)
{
    static const double SHARE = 0.46371;
    const double u = start + SHARE * (high - start);
    double range[2] = {0, 0};
    sort_row(laying, u);
    if (!look_range(laying, u, range))
        range[0] = range[1] = 0;
    make_gaps(laying, u, range);
    count_gaps(laying, u, high - low, number);
    if (add_slab(laying, low, high))
        return -1;
    remember(laying);
    return 0;
}

static int make_slabs(struct laying *laying, const struct lx_asking *asking)
{
    static const double NARROW = 1e-13, ROUNDING = 4e-16, UNSURE = 1e-11;
    struct lx_outline_lay *lay = laying->lay;
    const double *ends = laying->u, height = laying->v[1] - laying->v[0];
    const double least = NARROW * (ends[1] - ends[0]) + ROUNDING * (fabs(ends[0]) + fabs(ends[1]));
    size_t next = 0, wall = 0;
    lay->area = (ends[1] - ends[0]) * height;
    if (ends[1] - ends[0] < UNSURE * (fabs(ends[0]) + fabs(ends[1]))) /* a strip between corners of one longitude */
        lay->skipped += (ends[1] - ends[0]) * height;
    if (lx_reserve(&laying->places, &laying->place_capacity, lay->line_count + 1, sizeof *laying->places))
        return -1;
    for (size_t i = 0; i < lay->line_count; i++)
        laying->places[i] = -1;
    /* events that are very near to each other are one, and a slab begins at the last of them */
    double low = ends[0], start = low;
    for (size_t i = 0; i < laying->event_count; i++) {
        const double high = laying->events[i];
        if (!(high - start > least)) {
            lay->skipped += fmax(high - start, 0) * height;
            start = fmax(start, high);
            continue;
        }
        if (i % SLABS_BETWEEN_QUESTIONS == 0 && !lx_asking_goes_on(asking))
            return 0;
        if (is_at_wall(laying, low, start, &wall) || start > low)
            forget(laying);
        if (change_row(laying, start, &next))
            return -1;
        laying->occlusion->outline->is_broken |= laying->row_count > MOST_ACTIVE;
        if (laying->row_count > MOST_ACTIVE)
            return 0;
        if (make_slab(laying, low, start, high, (unsigned)i))
            return -1;
        low = start = high;
    }
    if (lay->slab_count > 0)
        lay->slabs[lay->slab_count - 1].high = ends[1];
    return 0;
}

static void free_laying(struct laying *laying)
{
    free(laying->events);
    free(laying->walls);
    free(laying->gaps);
    free(laying->row);
    free(laying->places);
    free(laying->counts);
    free(laying->inside);
}

/* ---- the whole ---- */

static int lay_sweep(struct laying *laying, const struct lx_asking *asking)
{
    struct lx_outline_lay *lay = laying->lay;
    lay->line_count = lay->part_count = lay->slab_count = 0;
    lay->unsure = lay->skipped = lay->area = 0;
    laying->event_count = laying->wall_count = laying->row_count = laying->gap_count = 0;
    laying->horizon_count = 0;
    if (lx_outline_draw(laying))
        return -1;
    return laying->occlusion->outline->is_broken || laying->event_count == 0 ? 0 : make_slabs(laying, asking);
}

int lx_outline_lay(const struct lx_occlusion *occlusion, const struct lx_sweeps *sweeps, const struct lx_asking *asking)
{
    struct lx_sheet_outline *outline = occlusion->outline;
    struct laying laying = {.occlusion = occlusion};
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
        laying.sweep = &sweeps->items[i];
        laying.lay = &outline->lays[i];
        failed = lay_sweep(&laying, asking);
    }
    free_laying(&laying);
    return failed;
}
