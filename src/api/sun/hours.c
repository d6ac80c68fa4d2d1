/* SPDX-License-Identifier: MIT */
/* Hours of sun: grids and elements of a scene, each asked when the sun of a day shines on it. */
#include <luxel/sunlight.h>

#include <limits.h>
#include <luxel/grid.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/diagnostics.h"
#include "../../base/memory.h"
#include "../../base/number.h"
#include "../../light/sky/position.h"
#include "../../scene/scene.h"
#include "../../world/cells.h"
#include "../../world/evaluate.h"
#include "../../world/sunlit.h"
#include "../session.h"
#include "site.h"

static const double level_hours[] = {1.5, 3, 4};

static void clear(luxel_sun_hours *hours, size_t count)
{
    for (size_t i = 0; hours && i < count; i++)
        free(hours[i].spans);
}

void luxel_sunlight_free(luxel_sunlight *sunlight)
{
    if (!sunlight)
        return;
    for (size_t i = 0; i < sunlight->grid_count; i++) {
        luxel_sun_grid *grid = &sunlight->grids[i];
        clear(grid->cells, (size_t)grid->columns * grid->rows);
        free((char *)grid->name);
        free(grid->cells);
    }
    clear(sunlight->elements, sunlight->element_count);
    free(sunlight->open.spans);
    free(sunlight->grids);
    free(sunlight->elements);
    free(sunlight);
}

struct finding {
    const struct lx_prepared *prepared;
    struct lx_sun_day day;
    bool has_level; /* whether EN 17037 speaks of such a day */
    struct lx_control *control;
    atomic_bool is_short; /* memory ran out */
    /* what is found now: elements, or the cells of a grid */
    const luxel_place *places;
    const struct lx_lattice *lattice;
    luxel_sun_hours *hours;
};

static void find_hours(struct finding *finding, const struct lx_element *element, const struct lx_asking *asking,
                       luxel_sun_hours *hours)
{
    struct lx_sun_spans spans = {.items = NULL};
    if (lx_find_sunlit(finding->prepared, element, &finding->day, asking, &spans))
        atomic_store(&finding->is_short, true);
    *hours = (luxel_sun_hours){.spans = spans.items, .span_count = spans.count, .level = LUXEL_SUN_NO_LEVEL};
    for (size_t i = 0; i < spans.count; i++)
        hours->total_s += spans.items[i].to_s - spans.items[i].from_s;
    if (!finding->has_level)
        return;
    hours->level = LUXEL_SUN_NOT_KEPT;
    for (size_t i = 0; i < LX_COUNT(level_hours); i++)
        hours->level += hours->total_s >= level_hours[i] * 3600;
}

/* For the pool a place is a row. */
static void find_some(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct finding *finding = data;
    const struct lx_asking asking = {.control = finding->control, .is_caller = is_caller};
    (void)worker;
    for (unsigned i = first; i < last && lx_asking_goes_on(&asking); i++) {
        luxel_place place = {.is_element = true};
        if (finding->lattice) {
            const struct lx_cells *cells = &finding->lattice->cells;
            lx_values3(lx_lattice_place(finding->lattice, i % cells->n[0], i / cells->n[0]), place.position_mm);
            lx_values3(cells->normal, place.normal);
        }
        const struct lx_element element =
            lx_element_at(finding->prepared, finding->lattice ? &place : &finding->places[i]);
        find_hours(finding, &element, &asking, &finding->hours[i]);
    }
}

static luxel_status find_all(struct finding *finding, const luxel_settings *settings, size_t count)
{
    const struct lx_rows_part part = {.last = (unsigned)count, .tile_rows = 1, .work = find_some, .data = finding};
    if (count > UINT_MAX)
        return LUXEL_ERROR_MEMORY;
    if (!lx_rows_run_part(finding->control, lx_thread_count(settings->threads, (unsigned)count), &part))
        return LUXEL_CANCELLED;
    return atomic_load(&finding->is_short) ? LUXEL_ERROR_MEMORY : LUXEL_OK;
}

static luxel_status find_grid(struct finding *finding, const luxel_settings *settings, size_t i, luxel_sun_grid *grid)
{
    const struct lx_grid *asked = (const struct lx_grid *)finding->prepared->scene->grids.items + i;
    const struct lx_cells cells = lx_cells_of(asked);
    struct lx_lattice lattice;
    *grid = (luxel_sun_grid){.columns = asked->n[0],
                             .rows = asked->n[1],
                             .name = asked->name ? lx_copy_text(asked->name, strlen(asked->name)) : NULL,
                             .cells = lx_new_array((size_t)asked->n[0] * asked->n[1], sizeof *grid->cells)};
    luxel_status status = LUXEL_ERROR_MEMORY;
    if (!lx_lattice_make(&cells, &lattice) && grid->cells && (grid->name || !asked->name)) {
        finding->lattice = &lattice;
        finding->hours = grid->cells;
        status = find_all(finding, settings, (size_t)grid->columns * grid->rows);
    }
    lx_lattice_clear(&lattice);
    return status;
}

static luxel_status find(struct finding *finding, const luxel_settings *settings, size_t grid_count,
                         luxel_sunlight *made)
{
    made->grids = lx_new_array(grid_count + 1, sizeof *made->grids);
    made->elements = lx_new_array(made->element_count + 1, sizeof *made->elements);
    if (!made->grids || !made->elements)
        return LUXEL_ERROR_MEMORY;
    find_hours(finding, NULL, NULL, &made->open);
    finding->hours = made->elements;
    luxel_status status = find_all(finding, settings, made->element_count);
    while (status == LUXEL_OK && made->grid_count < grid_count) {
        const size_t i = made->grid_count++;
        status = find_grid(finding, settings, i, &made->grids[i]);
    }
    return status;
}

/* ---- what is asked ---- */

static luxel_status check_number(luxel_diagnostics *diagnostics, const char *name, double value, double low,
                                 double high, const char *range)
{
    return value >= low && value <= high ? LUXEL_OK : lx_setting_out_of_range(diagnostics, name, value, range);
}

/* The day and its site; what is wrong is reported, all of it. */
static luxel_status read_day(const struct lx_scene_parameters *scene, const luxel_sun_day *asked,
                             luxel_diagnostics *diagnostics, struct lx_sun_site *site, struct lx_day *day)
{
    luxel_status status = LX_CHECK_RESERVE(asked, diagnostics);
    const luxel_status least =
        check_number(diagnostics, "least_altitude_deg", asked->least_altitude_deg, 0, 90, LX_N("0 to 90 degrees"));
    status = status == LUXEL_OK ? least : status;
    if (!asked->date || !lx_read_day(asked->date, day)) {
        status = lx_refuse(diagnostics, LX_MSG_SUN_DAY, LX_ARGS(asked->date ? asked->date : ""));
        lx_hint(diagnostics, LX_MSG_HINT_SUN_DAY, NULL);
    }
    lx_find_sun_site(scene, site);
    if (asked->has_place) {
        const luxel_status north =
            check_number(diagnostics, "latitude_deg", asked->latitude_deg, -90, 90, LX_N("-90 to 90 degrees"));
        const luxel_status east =
            check_number(diagnostics, "longitude_deg", asked->longitude_deg, -180, 180, LX_N("-180 to 180 degrees"));
        site->latitude_deg = asked->latitude_deg;
        site->longitude_deg = asked->longitude_deg;
        status = status != LUXEL_OK ? status : north != LUXEL_OK ? north : east;
    } else if (!site->has_place) {
        status = lx_refuse(diagnostics, LX_MSG_SUN_NOWHERE, NULL);
        lx_hint(diagnostics, LX_MSG_HINT_SUN_NOWHERE, NULL);
    }
    return status;
}

static luxel_status check_places(const struct lx_scene_parameters *scene, const luxel_place *places, size_t count,
                                 luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        if (!places[i].is_element || !lx_is_place(&places[i]) || places[i].surface >= lx_material_count(scene))
            status = lx_refuse(diagnostics, LX_MSG_BAD_PLACE, NULL);
    return status;
}

luxel_status luxel_find_sunlight(const luxel_scene *scene, const luxel_settings *settings, const luxel_sun_day *day,
                                 const luxel_place *places, size_t place_count, luxel_diagnostics *diagnostics,
                                 luxel_sunlight **sunlight)
{
    struct lx_prepared prepared = {.scene = NULL};
    struct lx_control control = {.rows = 0};
    struct lx_sun_site site;
    struct lx_day read;
    luxel_settings checked;
    if (!sunlight || !day || (!places && place_count > 0))
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT,
                         LX_ARGS(!sunlight ? "sunlight"
                                 : day     ? "places"
                                           : "day"));
    *sunlight = NULL;
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &checked);
    if (status == LUXEL_OK)
        status = read_day(lx_scene_parameters(scene), day, diagnostics, &site, &read);
    if (status == LUXEL_OK)
        status = check_places(lx_scene_parameters(scene), places, place_count, diagnostics);
    if (status == LUXEL_OK)
        status = lx_session_prepare(scene, &checked, diagnostics, &prepared);
    if (status == LUXEL_OK) {
        struct finding finding = {
            .prepared = &prepared,
            .day = {.site = &site, .midnight = read.midnight, .least_deg = day->least_altitude_deg},
            .has_level = read.month == 2 || (read.month == 3 && read.day <= 21),
            .control = &control,
            .places = places,
        };
        double rows = (double)place_count;
        for (size_t i = 0; i < luxel_scene_grid_count(scene); i++) {
            unsigned columns, lines;
            luxel_scene_grid_resolution(scene, i, &columns, &lines);
            rows += (double)columns * lines;
        }
        control.rows = rows < UINT_MAX ? (unsigned)rows : UINT_MAX;
        control.progress = checked.progress;
        control.data = checked.progress_data;
        luxel_sunlight *made = lx_new_array(1, sizeof *made);
        status = made ? LUXEL_OK : LUXEL_ERROR_MEMORY;
        if (made) {
            *made = (luxel_sunlight){.latitude_deg = site.latitude_deg,
                                     .longitude_deg = site.longitude_deg,
                                     .least_altitude_deg = day->least_altitude_deg,
                                     .zone_minutes = read.zone_minutes,
                                     .element_count = place_count};
            status = find(&finding, &checked, luxel_scene_grid_count(scene), made);
        }
        if (status == LUXEL_ERROR_MEMORY)
            lx_out_of_memory(diagnostics);
        if (status == LUXEL_OK)
            *sunlight = made;
        else
            luxel_sunlight_free(made);
    }
    lx_prepared_clear(&prepared);
    return status;
}
