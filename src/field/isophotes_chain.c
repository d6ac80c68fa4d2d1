/* SPDX-License-Identifier: MIT */
/* Chaining: from segments between vertices to lines, level by level. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "isophotes.h"

/* No vertex. */
#define NONE ((size_t)-1)

/* All vertices, numbered line by line: first the crossings, then the ends; each has at most one before and behind. */
struct graph {
    const struct lx_iso_search *search;
    size_t count;
    size_t *first_crossing, *first_end; /* of each line of the grid */
    double (*xy_mm)[2];
    size_t *level, *before, *behind;
};

/* A line found: its first vertex, and how many there are. */
struct chain {
    size_t level, first, count;
    bool closed;
};

struct chains {
    struct chain *items;
    size_t count, capacity;
};

/* -- the graph -- */

static void graph_clear(struct graph *graph)
{
    free(graph->first_crossing);
    free(graph->first_end);
    free(graph->xy_mm);
    free(graph->level);
    free(graph->before);
    free(graph->behind);
}

static int graph_new(struct graph *graph)
{
    const struct lx_iso_search *search = graph->search;
    graph->first_crossing = lx_new_array(search->rows, sizeof *graph->first_crossing);
    graph->first_end = lx_new_array(search->rows, sizeof *graph->first_end);
    if (!graph->first_crossing || !graph->first_end)
        return -1;
    for (unsigned i = 0; i < search->rows; i++) {
        graph->first_crossing[i] = graph->count;
        graph->count += search->lines[i].crossings.count;
        graph->first_end[i] = graph->count;
        graph->count += search->lines[i].ends.count;
    }
    graph->xy_mm = lx_new_array(graph->count + 1, sizeof *graph->xy_mm);
    graph->level = lx_new_array(graph->count + 1, sizeof *graph->level);
    graph->before = lx_new_array(graph->count + 1, sizeof *graph->before);
    graph->behind = lx_new_array(graph->count + 1, sizeof *graph->behind);
    if (!graph->xy_mm || !graph->level || !graph->before || !graph->behind)
        return -1;
    for (size_t i = 0; i < graph->count; i++)
        graph->before[i] = graph->behind[i] = NONE;
    return 0;
}

static void place_vertices(struct graph *graph, unsigned line)
{
    const struct lx_iso_search *search = graph->search;
    const struct lx_iso_line *found = &search->lines[line];
    const struct lx_iso_crossing *crossings = found->crossings.items;
    for (size_t i = 0; i < found->crossings.count; i++) {
        size_t vertex = graph->first_crossing[line] + i;
        bool vertical = crossings[i].edge % 2;
        graph->xy_mm[vertex][0] = vertical ? search->x_mm[crossings[i].edge / 2] : crossings[i].at;
        graph->xy_mm[vertex][1] = vertical ? crossings[i].at : search->y_mm[line];
        graph->level[vertex] = crossings[i].level;
    }
    const struct lx_iso_end *ends = found->ends.items;
    for (size_t i = 0; i < found->ends.count; i++) {
        size_t vertex = graph->first_end[line] + i;
        graph->xy_mm[vertex][0] = ends[i].xy_mm[0];
        graph->xy_mm[vertex][1] = ends[i].xy_mm[1];
        graph->level[vertex] = ends[i].level;
    }
}

static size_t vertex_number(const struct graph *graph, unsigned line, struct lx_iso_vertex vertex)
{
    switch (vertex.owner) {
    case LX_ISO_CROSSING_HERE: return graph->first_crossing[line] + vertex.index;
    case LX_ISO_CROSSING_NEXT: return graph->first_crossing[line + 1] + vertex.index;
    case LX_ISO_END: break;
    }
    return graph->first_end[line] + vertex.index;
}

static void link_vertices(struct graph *graph, unsigned line)
{
    const struct lx_iso_list *list = &graph->search->lines[line].segments;
    const struct lx_iso_segment *segments = list->items;
    for (size_t i = 0; i < list->count; i++) {
        size_t from = vertex_number(graph, line, segments[i].from), to = vertex_number(graph, line, segments[i].to);
        if (from == to || graph->behind[from] != NONE || graph->before[to] != NONE)
            continue; /* a degenerate cell must not tie a knot */
        graph->behind[from] = to;
        graph->before[to] = from;
    }
}

/* Whether two vertices are the same place: one on a corner of the grid is found on all its edges. */
static bool is_same_place(const struct graph *graph, size_t a, size_t b)
{
    const struct lx_iso_search *search = graph->search;
    double extent = fabs(search->x_mm[0]) + fabs(search->y_mm[0]) + fabs(search->x_mm[search->columns - 1]);
    double room = 1e-14 * extent;
    return fabs(graph->xy_mm[a][0] - graph->xy_mm[b][0]) <= room &&
           fabs(graph->xy_mm[a][1] - graph->xy_mm[b][1]) <= room;
}

/* Takes vertices out that repeat the place of the one before; returns how many of the chain remain. */
static size_t thin_out(struct graph *graph, struct chain *chain)
{
    size_t kept = 1, last = chain->first, i = graph->behind[last];
    for (; i != NONE && i != chain->first; i = graph->behind[i]) {
        if (is_same_place(graph, last, i))
            continue;
        graph->behind[last] = i;
        last = i;
        kept++;
    }
    graph->behind[last] = i;
    if (chain->closed && kept > 1 && is_same_place(graph, last, chain->first))
        kept--; /* the last of them only closes the line */
    return kept;
}

/* -- lines -- */

/* The vertices of each chain found are marked by `before` pointing to themselves. */
static int find_chains(struct graph *graph, struct chains *chains)
{
    for (int closed = 0; closed < 2; closed++)
        for (size_t i = 0; i < graph->count; i++) {
            if (graph->before[i] == i || graph->behind[i] == NONE || (!closed && graph->before[i] != NONE))
                continue;
            struct chain chain = {.level = graph->level[i], .first = i, .closed = closed};
            size_t vertex = i;
            do {
                graph->before[vertex] = vertex;
                vertex = graph->behind[vertex];
            } while (vertex != NONE && vertex != i);
            chain.count = thin_out(graph, &chain);
            if (chain.count < (closed ? 3u : 2u))
                continue;
            if (lx_reserve(&chains->items, &chains->capacity, chains->count + 1, sizeof chain))
                return -1;
            chains->items[chains->count++] = chain;
        }
    return 0;
}

/* Where each level's chains begin in their list, once it is sorted by levels: that of the first level behind it. */
static size_t *sort_chains(const struct lx_iso_search *search, struct chains *chains)
{
    size_t *first = lx_new_array(search->level_count + 2, sizeof *first);
    struct chain *sorted = lx_new_array(chains->count + 1, sizeof *sorted);
    if (!first || !sorted) {
        free(first);
        free(sorted);
        return NULL;
    }
    for (size_t i = 0; i < chains->count; i++)
        first[chains->items[i].level + 2]++;
    for (size_t k = 2; k < search->level_count + 2; k++)
        first[k] += first[k - 1];
    for (size_t i = 0; i < chains->count; i++)
        sorted[first[chains->items[i].level + 1]++] = chains->items[i];
    free(chains->items);
    chains->items = sorted;
    return first;
}

/* The place of a level in the sorted list. */
static size_t find_level(const struct lx_iso_search *search, double level)
{
    return lx_iso_first_level(search, level) - 1;
}

/* One block holds the result: the head, the lines, the coordinates. */
static struct luxel_isophotes *new_result(size_t lines, size_t vertices, luxel_isophote **own_lines, double **numbers)
{
    struct luxel_isophotes *made = lx_new_array(1, sizeof *made);
    *own_lines = lx_new_array(lines + 1, sizeof **own_lines);
    *numbers = lx_new_array(vertices + 1, 2 * sizeof **numbers);
    if (made && *own_lines && *numbers) {
        /* the coordinates are known by the first line, or by the one behind the last */
        (*own_lines)[0].x_mm = *numbers;
        *made = (struct luxel_isophotes){.count = lines, .lines = *own_lines};
        return made;
    }
    free(made);
    free(*own_lines);
    free(*numbers);
    return NULL;
}

static void fill_line(const struct graph *graph, const struct chain *chain, double level, luxel_isophote *line,
                      double **numbers)
{
    double *x = *numbers, *y = x + chain->count;
    size_t vertex = chain->first;
    for (size_t i = 0; i < chain->count; i++, vertex = graph->behind[vertex]) {
        x[i] = graph->xy_mm[vertex][0];
        y[i] = graph->xy_mm[vertex][1];
    }
    *line = (luxel_isophote){.level = level, .closed = chain->closed, .count = chain->count, .x_mm = x, .y_mm = y};
    *numbers = y + chain->count;
}

static struct luxel_isophotes *make_result(const struct graph *graph, const struct chain *chains, const size_t *first,
                                           const double *levels, size_t count)
{
    size_t lines = 0, vertices = 0;
    luxel_isophote *own_lines;
    double *numbers;
    for (size_t k = 0; k < count; k++) {
        size_t level = find_level(graph->search, levels[k]);
        for (size_t i = first[level]; i < first[level + 1]; i++) {
            lines++;
            vertices += chains[i].count;
        }
    }
    struct luxel_isophotes *made = new_result(lines, vertices, &own_lines, &numbers);
    if (!made)
        return NULL;
    for (size_t k = 0; k < count; k++) {
        size_t level = find_level(graph->search, levels[k]);
        for (size_t i = first[level]; i < first[level + 1]; i++)
            fill_line(graph, &chains[i], levels[k], own_lines++, &numbers);
    }
    return made;
}

struct luxel_isophotes *lx_iso_chain(const struct lx_iso_search *search, const double *levels, size_t count)
{
    struct graph graph = {.search = search};
    struct chains chains = {.items = NULL};
    struct luxel_isophotes *made = NULL;
    size_t *first = NULL;
    if (graph_new(&graph) == 0) {
        for (unsigned line = 0; line < search->rows; line++)
            place_vertices(&graph, line);
        for (unsigned line = 0; line + 1 < search->rows; line++)
            link_vertices(&graph, line);
        if (find_chains(&graph, &chains) == 0)
            first = sort_chains(search, &chains);
        if (first)
            made = make_result(&graph, chains.items, first, levels, count);
    }
    free(first);
    free(chains.items);
    graph_clear(&graph);
    return made;
}

void luxel_isophotes_free(luxel_isophotes *isophotes)
{
    if (!isophotes)
        return;
    free((void *)isophotes->lines[0].x_mm);
    free((void *)isophotes->lines);
    free(isophotes);
}
