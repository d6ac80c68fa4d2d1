/* SPDX-License-Identifier: MIT */
/*
 * Measuring grids: their keys, the number of their cells, and where those lie that cover a side of a surface, which is
 * known once the surfaces are.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../material/measure.h"
#include "../parameter/check.h"
#include "../surface/part.h"
#include "grids.h"
#include "object.h"
#include "observer.h"

enum { MOST_IN_A_ROW = 65536, MOST_CELLS = 10000000 };

static const char *const spacing_names[] = {"en12464", NULL};

static const struct lx_parameter grid_parameters[] = {
    {
        .name = "name",
        .label = "Name",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_grid, name),
        .meaning = "a name for messages and tables",
    },
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .meaning = "the centre of the measuring plane",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, size_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .legal = LX_ABOVE(0),
        .meaning = "the width and the height of the measuring plane; the height runs along up",
    },
    {
        .name = "axis",
        .label = "Axis",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, axis),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 0, 1]",
        .meaning = "the normal of the measuring plane, of any length: the side that it is lit from",
    },
    {
        .name = "up",
        .label = "Up direction",
        .type = LX_REALS,
        .offset = offsetof(struct lx_grid, up),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 1, 0]",
        .meaning = "the direction along which the height runs, made perpendicular to axis; where it is not given and "
                   "the axis runs along y, (0, 0, 1)",
    },
    {
        .name = "surface",
        .label = "Surface",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_grid, surface),
        .meaning = "instead of center and size: the name of a rectangle, room or box whose side the grid covers, or "
                   "surfaces[N] of one without a name",
    },
    {
        .name = "side",
        .label = "Side",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_grid, side),
        .meaning = "which side of that surface: of a room left, right, floor, ceiling, back or front, which face the "
                   "room; of a box left, right, bottom, top, back or front; of a rectangle front (without it) or back",
    },
    {
        .name = "border",
        .label = "Border",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid, border_mm),
        .unit = LX_UNIT_MM,
        .initial = "0",
        .legal = LX_FROM(0),
        .meaning = "the width of the strip along the edges of that side which is left out",
    },
    {
        .name = "surround",
        .label = "Surrounding area",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid, surround_mm),
        .unit = LX_UNIT_MM,
        .legal = LX_FROM(100),
        .advised = {LX_BETWEEN(500, 5000)},
        .meaning = "the width of the strip around the plane, as far as the walls of its room, that is measured as the "
                   "immediate surrounding area of a task area, which the plane then is; EN 12464-1 wants 500 mm or "
                   "more",
    },
    {
        .name = "background",
        .label = "Background area",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid, background_mm),
        .unit = LX_UNIT_MM,
        .legal = LX_FROM(100),
        .advised = {LX_BETWEEN(1000, 10000)},
        .meaning = "the width of the strip around that, as far as the walls, that is measured as the background area; "
                   "EN 12464-1 wants 3000 mm or more",
    },
    {
        .name = "n",
        .label = "Cells",
        .type = LX_WHOLES,
        .offset = offsetof(struct lx_grid, n),
        .count = 2,
        .legal = LX_BETWEEN(1, MOST_IN_A_ROW),
        .advised = {LX_BETWEEN(2, 500)},
        .meaning = "the number of cells, [columns, rows], at most ten million; the irradiance is measured at the "
                   "centre of each",
    },
    {
        .name = "spacing",
        .label = "Spacing",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_grid, spacing),
        .choices = spacing_names,
        .meaning = "the number of cells by a rule: en12464 makes them at most 0.2 * 5^log10(d) metres wide and high, "
                   "but no more than 10, where d is the longer side in metres, or the shorter one where the longer is "
                   "twice as long or more",
    },
    {
        .name = "measure",
        .label = "Measure",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_grid, measure),
        .choices = lx_measure_names,
        .meaning = "what is measured at the centre of each cell: the illuminance on the plane, or the mean of that on "
                   "the surface of a small body there: on the side of a cylinder along the axis, on that half of "
                   "it which faces along up, on a sphere, or on the half of a sphere that looks along the axis",
    },
    {
        .name = "limits",
        .label = "Limits",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_grid, limits),
        .group = &lx_grid_limits_table,
        .meaning = "what the values are to keep: pass, fail, or undecided where their bounds span the limit",
    },
};

static const struct lx_rule grid_rules[] = {
    {LX_RULE_ONE, "n", NULL, "n|spacing"},
    {LX_RULE_ONE, "center", NULL, "center|surface"},
    {LX_RULE_NEEDED, "size", "center", NULL},
    {LX_RULE_EXCLUSIVE, "surface", "size", NULL},
    {LX_RULE_EXCLUSIVE, "surface", "axis", NULL},
    {LX_RULE_EXCLUSIVE, "surface", "up", NULL},
    {LX_RULE_USED, "side", "surface", NULL},
    {LX_RULE_USED, "border", "surface", NULL},
    {LX_RULE_NEEDED, "surround", "background", NULL},
};

double lx_en12464_spacing_mm(const double size_mm[2])
{
    const double longer = fmax(size_mm[0], size_mm[1]), shorter = fmin(size_mm[0], size_mm[1]);
    const double d_m = (longer >= 2 * shorter ? shorter : longer) / 1000;
    return 1000 * fmin(0.2 * pow(5, log10(d_m)), 10);
}

/* The cells of a plane: as many as n says, or by the spacing, as a whole number that may be too large. */
static void count_cells(const struct lx_grid *grid, bool is_by_n, double cells[2])
{
    const double spacing = lx_en12464_spacing_mm(grid->size_mm);
    for (int i = 0; i < 2; i++) {
        /* what rounding cannot tell from whole cells is whole */
        const double fit = grid->size_mm[i] / spacing;
        cells[i] = is_by_n ? grid->n[i] : fmax(ceil(fit - 1e-9 * fit), 1);
    }
}

/* Sets the cells; false: they are too many, as many as `cells` says. */
static bool set_cells(struct lx_grid *grid, bool is_by_n, double cells[2])
{
    count_cells(grid, is_by_n, cells);
    if (!(cells[0] <= MOST_IN_A_ROW && cells[1] <= MOST_IN_A_ROW && cells[0] * cells[1] <= MOST_CELLS))
        return false;
    for (int i = 0; i < 2; i++)
        grid->n[i] = (unsigned)cells[i];
    return true;
}

static void check_grid(const struct lx_check *check, void *parameters)
{
    struct lx_grid *grid = parameters;
    const bool is_by_n = lx_is_given(check->table, grid, "n");
    double cells[2];
    lx_check_pose(check, grid->axis, grid->up);
    if (grid->surface && !is_by_n) /* which is not known yet */
        return;
    if (set_cells(grid, is_by_n, cells))
        return;
    char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE], most[LX_NUMBER_SIZE];
    lx_check_report(check, is_by_n ? "n" : "size", LX_ALL_OF_IT, LX_MSG_TOO_MANY_CELLS,
                    LX_ARGS(lx_write_number(cells[0], columns), lx_write_number(cells[1], rows),
                            lx_write_number(MOST_CELLS, most)));
}

const struct lx_table lx_grid_table = {
    .parameters = grid_parameters,
    .count = LX_COUNT(grid_parameters),
    .rules = grid_rules,
    .rule_count = LX_COUNT(grid_rules),
    .size = sizeof(struct lx_grid),
    .check = check_grid,
};

/* ---- on sides of surfaces ---- */

/* Where something about a grid is reported. */
struct at {
    struct lx_walk *walk;
    size_t grid;
};

/* Reports at a key of the grid; arguments as lx_walk_tell() takes them. */
static void report(const struct at *at, const char *key, enum lx_message message, const char *const *arguments)
{
    const struct lx_document *document = at->walk->document;
    const lx_node_id list = lx_document_find(document, document->root, "grids");
    const lx_node_id mapping = list ? lx_document_element(document, list, at->grid) : 0;
    const lx_node_id value = mapping ? lx_document_find(document, mapping, key) : 0;
    const struct lx_step of_list = {NULL, "grids", 0}, item = {&of_list, NULL, at->grid}, step = {&item, key, 0};
    lx_walk_tell(at->walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, value ? value : mapping), &step, message,
                 arguments);
}

/* How a surface, or part of one, lies that a grid can cover; false: it is not flat. */
static bool is_flat(const struct lx_item *surface, unsigned number, struct lx_flat *flat)
{
    struct lx_part part;
    lx_part_make((const struct lx_surface_kind *)surface->variant, surface->parameters, number, &part);
    return lx_part_flat(&part, flat);
}

/* The name of a surface, or its number as a grid may call it. */
static const char *name_of(const struct lx_list *surfaces, size_t i, char number[40])
{
    const char *name = ((const struct lx_surface_common *)surfaces->items[i].common)->name;
    snprintf(number, 40, "surfaces[%zu]", i);
    return name ? name : number;
}

/* Reports that no surface with flat sides is called so, and which are. */
static void report_surfaces(const struct at *at, const struct lx_list *surfaces, const char *wanted)
{
    struct lx_text text = {0};
    for (size_t i = 0; i < surfaces->count; i++) {
        char number[40];
        struct lx_flat flat;
        if (is_flat(&surfaces->items[i], 0, &flat))
            lx_text_printf(&text, "%s%s", text.length > 0 ? ", " : "", name_of(surfaces, i, number));
    }
    report(at, "surface", LX_MSG_WRONG_CHOICE, LX_ARGS(text.length > 0 ? text.bytes : "–", wanted));
    lx_text_clear(&text);
}

/* The surface of this name, or of the number that it has; NULL: there is none with flat sides. */
static const struct lx_item *find_surface(const struct lx_list *surfaces, const char *wanted)
{
    for (size_t i = 0; i < surfaces->count; i++) {
        char own[40], number[40];
        struct lx_flat flat;
        const char *name = name_of(surfaces, i, own);
        snprintf(number, sizeof number, "surfaces[%zu]", i);
        if (strcmp(name, wanted) == 0 || strcmp(number, wanted) == 0)
            return is_flat(&surfaces->items[i], 0, &flat) ? &surfaces->items[i] : NULL;
    }
    return NULL;
}

/* Reports a side that is missing or that the surface does not have. */
static void report_side(const struct at *at, const struct lx_grid *grid, const struct lx_surface_kind *kind)
{
    struct lx_text text = {0};
    for (unsigned i = 0; kind->part_names && i < lx_part_count(kind); i++)
        lx_text_printf(&text, "%s%s", i > 0 ? ", " : "", lx_part_name(kind, i));
    const char *known = kind->part_names && text.bytes ? text.bytes : "front, back";
    if (grid->side) {
        report(at, "side", LX_MSG_WRONG_CHOICE, LX_ARGS(known, grid->side));
    } else {
        report(at, "side", LX_MSG_NEEDED_BESIDE, LX_ARGS(grid->surface));
        lx_hint(at->walk->diagnostics, LX_MSG_HINT_EXPECTED, LX_ARGS(known));
    }
    lx_text_clear(&text);
}

/* The part of a surface that the grid names, and whether it is meant from behind; false: there is none. */
static bool find_part(const struct at *at, const struct lx_grid *grid, const struct lx_surface_kind *kind,
                      unsigned *part, bool *is_back)
{
    const char *side = grid->side ? grid->side : kind->part_names ? "" : "front";
    *is_back = !kind->part_names && strcmp(side, "back") == 0;
    *part = 0;
    if (!kind->part_names && (*is_back || strcmp(side, "front") == 0))
        return true;
    for (; kind->part_names && *part < lx_part_count(kind); (*part)++)
        if (strcmp(lx_part_name(kind, *part), side) == 0)
            return true;
    report_side(at, grid, kind);
    return false;
}

/* Turns a side of a room or box so that its up is that of the scene, as far as its edges go that way. */
static void set_upright(const struct lx_scene_parameters *scene, struct lx_flat *side)
{
    const double *up = lx_scene_up(scene);
    double across[3];
    lx_cross(side->up, side->axis, across);
    const double along = up ? lx_dot(across, up) : 0;
    if (!up || !(fabs(along) > fabs(lx_dot(side->up, up))))
        return;
    for (int i = 0; i < 3; i++)
        side->up[i] = along < 0 ? 0.0 - across[i] : across[i];
    const double width = side->size_mm[0];
    side->size_mm[0] = side->size_mm[1];
    side->size_mm[1] = width;
}

/* Lays the grid on a side, from its front or its back. */
static void cover(const struct at *at, struct lx_grid *grid, const struct lx_flat *side, bool is_back)
{
    const double half = fmin(side->size_mm[0], side->size_mm[1]) / 2;
    char numbers[3][LX_NUMBER_SIZE];
    double cells[2];
    memcpy(grid->center_mm, side->center_mm, sizeof grid->center_mm);
    memcpy(grid->up, side->up, sizeof grid->up);
    for (int i = 0; i < 3; i++)
        grid->axis[i] = is_back ? 0.0 - side->axis[i] : side->axis[i];
    for (int i = 0; i < 2; i++)
        grid->size_mm[i] = side->size_mm[i] - 2 * grid->border_mm;
    if (!(grid->border_mm < half))
        report(at, "border", LX_MSG_WRONG_ORDER,
               LX_ARGS(LX_TERM(LX_N("half of the side")), lx_write_number(half, numbers[0])));
    else if (!set_cells(grid, lx_is_given(&lx_grid_table, grid, "n"), cells))
        report(at, "surface", LX_MSG_TOO_MANY_CELLS,
               LX_ARGS(lx_write_number(cells[0], numbers[0]), lx_write_number(cells[1], numbers[1]),
                       lx_write_number(MOST_CELLS, numbers[2])));
}

static void place_grid(const struct at *at, struct lx_grid *grid, const struct lx_scene_parameters *scene)
{
    const struct lx_list *surfaces = &scene->surfaces;
    const struct lx_item *surface = find_surface(surfaces, grid->surface);
    struct lx_flat side;
    unsigned number;
    bool is_back;
    if (!surface)
        report_surfaces(at, surfaces, grid->surface);
    else if (find_part(at, grid, (const struct lx_surface_kind *)surface->variant, &number, &is_back) &&
             is_flat(surface, number, &side)) {
        if (((const struct lx_surface_kind *)surface->variant)->part_names)
            set_upright(scene, &side);
        cover(at, grid, &side, is_back);
    }
}

void lx_place_grids(struct lx_walk *walk, luxel_scene *scene)
{
    const struct lx_list *surfaces = &scene->parameters.surfaces;
    for (size_t i = 0; i < surfaces->count; i++)
        if (!surfaces->items[i].variant)
            return; /* with errors of its own */
    for (size_t i = 0; i < scene->parameters.grids.count; i++) {
        struct lx_grid *grid = (struct lx_grid *)scene->parameters.grids.items + i;
        if (grid->surface)
            place_grid(&(struct at){walk, i}, grid, &scene->parameters);
    }
}
