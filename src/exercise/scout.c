/* SPDX-License-Identifier: MIT */
/*
 * The quick look: the scene's copy gets a screen that just covers its own, with few pixels.  Highlights of extended
 * sources are integrals that take their time, so that with them the picture's own maximum has to do; they are wide.
 */
#include "scout.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../api/refuse.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../light/solid/extended.h"
#include "../surface/mesh_faces.h"
#include "../surface/sheet.h"
#include "../world/prepared.h"

enum {
    SAMPLES = 48,           /* along the shorter side of the screen */
    SAMPLES_ACROSS = 16,    /* at least, over the smallest surface */
    MOST_SAMPLES = 300000,  /* in all */
    MOST_SIDE = 10000,      /* along a side */
    MOST_STEPS = 8,         /* of a climb */
    MOST_EXACT_SOURCES = 64 /* for the continuous maximum */
};

#define TOLERANCE 1e-2    /* of integrals: advice speaks of percents */
#define REFLECTED 2e-2    /* the bound of reflected light, of the maximum */
#define TRIANGLE_COST 5e7 /* of a triangle that reflects, in ns */
#define TUBE_COST 5e10    /* of the side of a cylinder that does, and hides parts of an extended source */
#define EXACT_COST 1e5    /* of the continuous maximum on a surface, in pixels */
#define SURFACE_COST 0.5  /* of a surface that may be seen, or stand in the light of a source, at a pixel in ns */

#define DOME_COST 1e9     /* of the sky at a pixel in ns: more than there is time for */

/* The cost at a pixel, in ns, of each of many surfaces that may hide parts of an extended source; so many are many. */
#define PENUMBRA_COST 40
enum { MANY_SURFACES = 48 };

/* What one source costs at a pixel, about, in ns as measured. */
static double cost_of(const struct lx_emitter *emitter, bool shines, size_t shadows)
{
    if (lx_is_dome(emitter))
        return DOME_COST * (double)(1 + shadows);
    if (!lx_is_extended(emitter))
        return 2 + SURFACE_COST * (double)shadows;
    const double faces = emitter->facets ? (double)emitter->facets->face_count : 4;
    const double penumbrae = shadows > MANY_SURFACES ? PENUMBRA_COST * (double)shadows : 0;
    /* only of the law 1/r^2 the diffuse light is no integral */
    return penumbrae + faces * (!lx_has_closed_form(emitter) ? 25000 : shines ? 1500 : 200);
}

/* What the sources are like. */
struct sources {
    size_t count;
    double cost;       /* of all at a pixel */
    bool are_slow;     /* whether any is extended and makes a highlight */
    bool are_extended; /* whether any is */
    size_t tubes;      /* that stand in their light */
    bool too_many;
};

static int count_sources(const struct lx_scene_parameters *scene, struct sources *sources)
{
    struct lx_prepared prepared;
    int failed = lx_prepare_few(scene, TOLERANCE, LX_SCOUT_SOURCES, &prepared);
    bool shines = false;
    *sources = (struct sources){.count = prepared.emitters.count, .too_many = prepared.emitters.is_short};
    for (size_t i = 0; !failed && i < prepared.surface_count; i++) {
        const struct lx_lobe *lobe = &prepared.surfaces[i].lobe;
        struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
        const int sides = lx_shape_sheets(&prepared.surfaces[i].shape, sheets);
        sources->tubes += sides > 0 && sheets[0].type->obstacle == LX_OBSTACLE_TUBE;
        shines = shines || lx_lobe_shines(lobe);
    }
    for (size_t i = 0; !failed && i < prepared.emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&prepared.emitters, i, &room);
        sources->cost += cost_of(emitter, shines, prepared.shadows ? prepared.surface_count - 1 : 0);
        sources->are_extended = sources->are_extended || lx_is_extended(emitter) || lx_is_dome(emitter);
        sources->are_slow = sources->are_slow || lx_is_dome(emitter) || (shines && lx_is_extended(emitter));
    }
    lx_prepared_clear(&prepared);
    return failed && !sources->too_many ? -1 : 0;
}

/* How far apart the samples lie: near enough for the screen, and for the smallest surface unless they were too many. */
static double choose_step(const struct lx_scene_parameters *scene)
{
    double width = scene->screen.width_mm, height = scene->screen.height_mm;
    double step = fmin(width, height) / SAMPLES;
    const struct lx_frame frame = lx_observer_frame(&scene->observer);
    for (size_t i = 0; i < scene->surfaces.count; i++) {
        const struct lx_item *surface = &scene->surfaces.items[i];
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
        double low[3], high[3];
        lx_surface_extent(kind, surface->parameters, &frame, low, high);
        double size = fmax(high[0] - low[0], high[1] - low[1]);
        if (size > 0)
            step = fmin(step, size / SAMPLES_ACROSS);
    }
    step = fmax(step, sqrt(width / MOST_SAMPLES) * sqrt(height));
    return fmax(step, fmax(width, height) / MOST_SIDE);
}

/* Gives the copy the coarse screen, which may reach a little beyond its own. */
static luxel_status coarsen(luxel_scene *copy, const struct lx_scene_parameters *scene, double step)
{
    char width[LX_NUMBER_SIZE], height[LX_NUMBER_SIZE], words[200];
    double columns = fmax(2, ceil(scene->screen.width_mm / step)), rows = fmax(2, ceil(scene->screen.height_mm / step));
    snprintf(words, sizeof words, "screen={width: %s, height: %s, resolution: [%u, %u]}",
             lx_write_number(columns * step, width), lx_write_number(rows * step, height), (unsigned)columns,
             (unsigned)rows);
    luxel_status status = luxel_scene_set(copy, words, NULL);
    return status == LUXEL_OK ? luxel_scene_commit(copy, NULL) : status;
}

/* The part of the coarse picture that the scene's own screen shows. */
static luxel_region own_screen(const struct lx_screen *screen)
{
    return (luxel_region){.type = LUXEL_REGION_RECTANGLE, .size_mm = {screen->width_mm, screen->height_mm}};
}

/* Where a pixel of the coarse picture lies: on the rim or the border if one beside it is off the surface or out. */
static luxel_peak_place place_of(const luxel_field *field, const luxel_region *region, const luxel_extremum *pixel)
{
    static const int ways[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const double *x = luxel_field_x_mm(field), *y = luxel_field_y_mm(field);
    unsigned columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    luxel_peak_place place = LUXEL_PEAK_INSIDE;
    for (int i = 0; i < 4; i++) {
        unsigned column = pixel->column + (unsigned)ways[i][0], row = pixel->row + (unsigned)ways[i][1];
        if (column >= columns || row >= rows || !luxel_region_holds(region, x[column], y[row]))
            return LUXEL_PEAK_BORDER;
        if (!luxel_field_mask(field)[(size_t)row * columns + column])
            place = LUXEL_PEAK_LIMB;
    }
    return place;
}

/* Climbs from a pixel to a higher place nearby, by ever smaller steps along x and y. */
static void climb(const luxel_evaluator *evaluator, const luxel_region *region, double step, luxel_peak *peak)
{
    static const int ways[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    double least = step / 16;
    for (int i = 0; i < MOST_STEPS && step >= least; i++) {
        bool higher = false;
        for (int way = 0; way < 4 && !higher; way++) {
            double x = peak->x_mm + step * ways[way][0], y = peak->y_mm + step * ways[way][1];
            if (!luxel_region_holds(region, x, y))
                continue;
            luxel_value value;
            luxel_evaluate_screen(evaluator, x, y, &value, NULL);
            higher = value.has_value && value.value > peak->value;
            if (higher)
                peak->x_mm = x, peak->y_mm = y, peak->value = value.value;
        }
        if (!higher)
            step /= 2;
    }
}

/* The picture's own maximum and where it is, and how high it is nearby. */
static void take_pixel(const luxel_evaluator *evaluator, const luxel_field *field, const luxel_region *region,
                       const luxel_summary *summary, double step, luxel_peak *peak)
{
    const luxel_extremum *maximum = &summary->maximum;
    luxel_value value;
    luxel_evaluate_screen(evaluator, maximum->x_mm, maximum->y_mm, &value, NULL);
    *peak = (luxel_peak){.exists = maximum->exists,
                         .value = maximum->value,
                         .surface = value.surface,
                         .part = value.part,
                         .x_mm = maximum->x_mm,
                         .y_mm = maximum->y_mm};
    /* where all is of one value, or nearly, no place is the brightest */
    bool is_level = maximum->value - summary->mean <= 1e-3 * maximum->value;
    peak->place = is_level ? LUXEL_PEAK_PLATEAU : place_of(field, region, maximum);
    if (maximum->exists && !is_level)
        climb(evaluator, region, step / 2, peak);
}

static double share_above(const luxel_field *field, const luxel_region *region, double high)
{
    const double *x = luxel_field_x_mm(field), *y = luxel_field_y_mm(field);
    unsigned columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    size_t seen = 0, above = 0;
    for (unsigned row = 0; row < rows; row++)
        for (unsigned column = 0; column < columns; column++) {
            if (!luxel_field_mask(field)[(size_t)row * columns + column] ||
                !luxel_region_holds(region, x[column], y[row]))
                continue;
            seen++;
            above += luxel_field_value(field, column, row) > high;
        }
    return seen > 0 ? (double)above / (double)seen : 0;
}

static int find_strongest(const luxel_evaluator *evaluator, const luxel_peak *peak, size_t *strongest)
{
    size_t count = luxel_evaluator_light_count(evaluator);
    double *shares = lx_new_array(count + 1, sizeof *shares);
    luxel_value value;
    if (!shares)
        return -1;
    luxel_evaluate_screen(evaluator, peak->x_mm, peak->y_mm, &value, shares);
    *strongest = 0;
    for (size_t i = 1; i < count; i++)
        if (shares[i] > shares[*strongest])
            *strongest = i;
    free(shares);
    return 0;
}

/* Reads the scout off the coarse picture of the copy. */
static luxel_status look(const luxel_evaluator *evaluator, const luxel_field *field,
                         const struct lx_scene_parameters *scene, const luxel_region *region, struct lx_scout *scout)
{
    luxel_summary summary;
    luxel_peak peak = {0};
    luxel_status status = luxel_field_summary(field, region, NULL, &summary);
    if (status != LUXEL_OK)
        return status;
    if (scout->is_coarse) {
        take_pixel(evaluator, field, region, &summary, scout->sample_mm, &peak);
    } else {
        luxel_extrema extrema;
        status = luxel_find_extrema(evaluator, field, region, NULL, &extrema);
        if (status != LUXEL_OK)
            return status;
        peak = extrema.maximum;
    }
    scout->is_seen = peak.exists;
    scout->maximum = peak.value;
    scout->surface = peak.surface;
    scout->part = peak.part;
    scout->place = peak.place;
    if (scene->picture.range.choice < 0)
        scout->white = share_above(field, region, scene->picture.range.high);
    return find_strongest(evaluator, &peak, &scout->strongest) ? LUXEL_ERROR_MEMORY : LUXEL_OK;
}

/* The cost of triangles of meshes, and of tubes before extended sources, where they send light on. */
static double reflecting_cost(const struct lx_scene_parameters *scene, const struct sources *sources)
{
    double sum = sources->are_extended ? TUBE_COST * (double)sources->tubes : 0;
    for (size_t i = 0; i < scene->surfaces.count; i++) {
        const struct lx_item *item = &scene->surfaces.items[i];
        const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
        if (!kind->mesh)
            continue;
        const struct lx_shape shape = lx_surface_shape(kind, item->parameters);
        sum += TRIANGLE_COST * (double)lx_mesh_count(&shape);
    }
    return lx_wants_reflections(scene) ? sum : 0;
}

/* `copy` is committed, with the scene's own screen. */
static luxel_status scout_copy(luxel_scene *copy, double *effort, struct lx_scout *scout)
{
    const struct lx_scene_parameters *scene = lx_scene_parameters(copy);
    luxel_region region = own_screen(&scene->screen);
    luxel_settings settings;
    luxel_evaluator *evaluator = NULL;
    luxel_field *field = NULL;
    struct sources sources;
    if (count_sources(scene, &sources))
        return LUXEL_ERROR_MEMORY;
    double surfaces = (double)scene->surfaces.count, exact_cost = EXACT_COST * sources.cost * surfaces;
    scout->is_coarse = sources.are_slow || sources.count > MOST_EXACT_SOURCES || exact_cost > LX_SCOUT_EFFORT;
    scout->sample_mm = choose_step(scene);
    double pixels = scene->screen.width_mm / scout->sample_mm * (scene->screen.height_mm / scout->sample_mm);
    double cost = pixels * (sources.cost + SURFACE_COST * surfaces + 20) + (scout->is_coarse ? 0 : exact_cost);
    cost += reflecting_cost(scene, &sources);
    scout->too_large = sources.too_many || cost > *effort;
    if (scout->too_large)
        return LUXEL_OK;
    *effort -= cost;
    luxel_status status = coarsen(copy, scene, scout->sample_mm);
    luxel_settings_init(&settings);
    settings.tolerance = TOLERANCE;
    settings.reflected_error = REFLECTED;
    if (status == LUXEL_OK)
        status = luxel_render(copy, &settings, NULL, &field);
    if (status == LUXEL_OK)
        status = luxel_evaluator_new(copy, &settings, NULL, &evaluator);
    if (status == LUXEL_OK)
        status = look(evaluator, field, lx_scene_parameters(copy), &region, scout);
    luxel_evaluator_free(evaluator);
    luxel_field_free(field);
    return status;
}

luxel_status lx_scout(const luxel_scene *scene, const char *const *assignments, double *effort, struct lx_scout *scout)
{
    *scout = (struct lx_scout){0};
    luxel_scene *copy = luxel_scene_copy(scene);
    luxel_status status = copy ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    for (; status == LUXEL_OK && assignments && *assignments; assignments++)
        status = luxel_scene_set(copy, *assignments, NULL);
    if (status == LUXEL_OK && !luxel_scene_is_committed(copy))
        status = luxel_scene_commit(copy, NULL);
    if (status == LUXEL_OK)
        status = scout_copy(copy, effort, scout);
    luxel_scene_free(copy);
    return status;
}
