/* SPDX-License-Identifier: MIT */
/* Chaining: segments that share a place become lines, each begun at its first segment in the order of the cells. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "isophotes.h"

/* An open hash table from the key of a place to the segment that begins, or ends, there. */
struct table {
    size_t *slots; /* index + 1; 0: empty */
    size_t mask;
};

static size_t hash_of(uint64_t key)
{
    key ^= key >> 33;
    key *= UINT64_C(0xff51afd7ed558ccd);
    key ^= key >> 33;
    return (size_t)key;
}

static uint64_t key_of(const struct lx_segment *segment, bool begins)
{
    return begins ? segment->from_key : segment->to_key;
}

static int make_table(const struct lx_segments *segments, bool begins, struct table *table)
{
    size_t size = 16;
    while (size < 2 * segments->count)
        size *= 2;
    table->slots = lx_new_array(size, sizeof *table->slots);
    table->mask = size - 1;
    for (size_t i = 0; table->slots && i < segments->count; i++) {
        size_t slot = hash_of(key_of(&segments->items[i], begins)) & table->mask;
        while (table->slots[slot])
            slot = (slot + 1) & table->mask;
        table->slots[slot] = i + 1;
    }
    return table->slots ? 0 : -1;
}

/* The segment that begins (or ends) at the key, as its index + 1; 0: none. */
static size_t find(const struct lx_segments *segments, const struct table *table, bool begins, uint64_t key)
{
    size_t slot = hash_of(key) & table->mask;
    while (table->slots[slot]) {
        if (key_of(&segments->items[table->slots[slot] - 1], begins) == key)
            return table->slots[slot];
        slot = (slot + 1) & table->mask;
    }
    return 0;
}

/* A line under way. */
struct line {
    double *x_mm, *y_mm;
    size_t count, x_capacity, y_capacity;
};

/* Places that are the same (a vertex at a corner of cells) are one vertex. */
static int add_vertex(struct line *line, const double at[2])
{
    if (line->count > 0 && line->x_mm[line->count - 1] == at[0] && line->y_mm[line->count - 1] == at[1])
        return 0;
    if (lx_reserve(&line->x_mm, &line->x_capacity, line->count + 1, sizeof *line->x_mm) < 0 ||
        lx_reserve(&line->y_mm, &line->y_capacity, line->count + 1, sizeof *line->y_mm) < 0)
        return -1;
    line->x_mm[line->count] = at[0];
    line->y_mm[line->count++] = at[1];
    return 0;
}

static int finish_line(struct line *line, double level, bool closed, struct lx_lines *lines)
{
    size_t last = line->count - 1;
    if (closed && last > 0 && line->x_mm[0] == line->x_mm[last] && line->y_mm[0] == line->y_mm[last])
        line->count--;
    if (line->count < 2) {
        free(line->x_mm);
        free(line->y_mm);
        return 0;
    }
    if (lx_reserve(&lines->items, &lines->capacity, lines->count + 1, sizeof *lines->items) < 0)
        return -1;
    lines->items[lines->count++] = (luxel_isophote){.level = level,
                                                    .closed = closed && line->count > 2,
                                                    .count = line->count,
                                                    .x_mm = line->x_mm,
                                                    .y_mm = line->y_mm};
    return 0;
}

/* Follows a line from one of its segments to its end, or round. */
static int follow(const struct lx_segments *segments, const struct table *begins, uint8_t *used, size_t first,
                  double level, struct lx_lines *lines)
{
    struct line line = {0};
    bool closed = false;
    int failed = add_vertex(&line, segments->items[first].from);
    for (size_t i = first; failed == 0;) {
        used[i] = 1;
        failed = add_vertex(&line, segments->items[i].to);
        size_t next = find(segments, begins, true, segments->items[i].to_key);
        closed = next == first + 1;
        if (next == 0 || used[next - 1])
            break;
        i = next - 1;
    }
    if (failed == 0)
        failed = finish_line(&line, level, closed, lines);
    if (failed != 0) {
        free(line.x_mm);
        free(line.y_mm);
    }
    return failed;
}

int lx_chain_segments(const struct lx_segments *segments, double level, struct lx_lines *lines)
{
    struct table begins = {0}, ends = {0};
    uint8_t *used = lx_new_array(segments->count + 1, 1);
    int failed = !used || make_table(segments, true, &begins) < 0 || make_table(segments, false, &ends) < 0 ? -1 : 0;
    /* first the lines that begin somewhere, then those that go round */
    for (int round = 0; round < 2; round++)
        for (size_t i = 0; failed == 0 && i < segments->count; i++)
            if (!used[i] && (round == 1 || !find(segments, &ends, false, segments->items[i].from_key)))
                failed = follow(segments, &begins, used, i, level, lines);
    free(begins.slots);
    free(ends.slots);
    free(used);
    return failed;
}
