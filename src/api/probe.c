/* SPDX-License-Identifier: MIT */
/* Probes: the reference summed over the lights, and the picture's value at the same pixel. */
#include <luxel/probe.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../scene/scene.h"
#include "../shade/camera.h"
#include "../shade/evaluate.h"
#include "../shade/panels.h"
#include "session.h"

void luxel_probe_free(luxel_probe *probe)
{
    if (!probe)
        return;
    for (size_t i = 0; i < probe->share_count; i++)
        free((char *)probe->shares[i].name);
    free(probe->shares);
    free(probe);
}

/* One share for each enabled light, with its words. */
static int name_shares(const struct lx_scene_parameters *scene, luxel_probe *probe)
{
    probe->shares = lx_new_array(scene->lights.count, sizeof *probe->shares);
    if (!probe->shares)
        return -1;
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_item *item = &scene->lights.items[i];
        const struct lx_light_common *common = item->common;
        if (!common->enabled)
            continue;
        luxel_light_share *share = &probe->shares[probe->share_count++];
        *share = (luxel_light_share){.light = i, .type = item->variant->name};
        if (common->name) {
            share->name = lx_copy_text(common->name, strlen(common->name));
            if (!share->name)
                return -1;
        }
    }
    return 0;
}

/* What is below this share of the sources' radiance is as good as 0: in a source's plane there is only rounding. */
static const double NOTHING = 1e-20;

/* An explicit tolerance is checked, the default one where there are integrals.  Closed forms are as exact as the scene
 * is to float64, which just within a cone's edge or where light sets is less, relative to a value near 0. */
static bool is_reached(const struct lx_session *session, const luxel_probe *probe)
{
    const struct lx_prepared *prepared = &session->prepared;
    bool integrated = false;
    double radiance = 0;
    for (size_t i = 0; i < probe->share_count; i++)
        integrated = integrated || probe->shares[i].parts > 0;
    for (size_t i = 0; i < lx_item_count(&prepared->emitters); i++)
        radiance = fmax(radiance, prepared->emitters.items[i].radiance.value);
    double allowed = fmax(prepared->tolerance * fabs(probe->value), fmax(NOTHING * radiance, DBL_MIN));
    return !(session->settings.tolerance > 0 || integrated) || probe->error <= allowed;
}

/* Adds up the emitters, light by light; stops at one that lies on the element. */
static void sum_lights(const struct lx_session *session, const struct lx_element *element, luxel_probe *probe)
{
    const struct lx_prepared *prepared = &session->prepared;
    lx_bounded total = lx_exact(0);
    size_t next = 0;
    for (size_t s = 0; s < probe->share_count; s++) {
        luxel_light_share *share = &probe->shares[s];
        struct lx_share light;
        if (!lx_light_share(prepared, element, share->light, &next, &light)) {
            probe->source_on_element = true;
            probe->blocking_light = share->light;
            return;
        }
        lx_bounded value = lx_share_value(&light, session->settings.quantity);
        share->parts = light.parts;
        share->irradiance = light.irradiance.value;
        share->diffuse = light.diffuse.value;
        share->specular = light.specular.value;
        share->error = lx_told_error(value);
        total = lx_add(total, value);
    }
    probe->has_value = true;
    probe->value = total.value;
    probe->error = lx_told_error(total);
    probe->tolerance_reached = is_reached(session, probe);
}

static int probe_element(const struct lx_session *session, const struct lx_element *element, luxel_probe *probe)
{
    const lx_bounded3 *place = &element->place_mm, *normal = &element->normal;
    probe->on_surface = true;
    probe->position_mm[0] = place->x.value, probe->position_mm[1] = place->y.value;
    probe->position_mm[2] = place->z.value;
    probe->normal[0] = normal->x.value, probe->normal[1] = normal->y.value, probe->normal[2] = normal->z.value;
    if (name_shares(session->prepared.scene, probe))
        return -1;
    sum_lights(session, element, probe);
    return 0;
}

/* Some pixels around the probe's, which its value in the picture may depend on, shaded alone. */
struct neighbourhood {
    unsigned first, top, columns, rows;
    double x_mm[LX_BLOCK], y_mm[LX_PANEL_SIDE];
};

static struct neighbourhood neighbourhood_of(const struct lx_screen *screen, const luxel_probe *probe, unsigned width,
                                             unsigned height)
{
    struct neighbourhood made = {.first = probe->column / width * width, .top = probe->row / height * height};
    const unsigned columns = screen->resolution[0] - made.first, rows = screen->resolution[1] - made.top;
    made.columns = columns < width ? columns : width;
    made.rows = rows < height ? rows : height;
    for (unsigned i = 0; i < made.columns; i++)
        made.x_mm[i] = lx_column_x_mm(screen, made.first + i);
    for (unsigned j = 0; j < made.rows; j++)
        made.y_mm[j] = lx_row_y_mm(screen, made.top + j);
    return made;
}

static double shade_in_tile(const struct lx_session *session, const struct neighbourhood *tile, size_t row,
                            size_t column, struct lx_shader_memory *memory)
{
    const struct lx_plan *plan = &session->plan;
    double values[LX_BLOCK];
    float singles[LX_BLOCK];
    uint8_t mask[LX_BLOCK];
    lx_shader_enter(plan, memory, tile->y_mm, tile->rows, tile->x_mm, tile->columns);
    if (session->settings.precision == LUXEL_DOUBLE) {
        lx_shade_row(plan, memory, row, NULL, false, values, mask);
        return values[column];
    }
    lx_shade_row_single(plan, memory, row, NULL, false, singles, mask);
    return (double)singles[column];
}

static double shade_in_panel(const struct lx_session *session, const struct neighbourhood *panel, size_t row,
                             size_t column, struct lx_shader_memory *memory, struct lx_panels_memory *panels)
{
    float values[LX_PANEL_SIDE * LX_PANEL_SIDE];
    uint8_t mask[LX_PANEL_SIDE * LX_PANEL_SIDE];
    unsigned shown[LX_PANEL_SIDE];
    struct lx_control control = {.rows = 1};
    const struct lx_canvas canvas = {panel->first, panel->top, panel->x_mm, panel->y_mm, values, mask, LX_PANEL_SIDE};
    lx_shade_panels(&session->plan, panels, memory, &control, false, &canvas, panel->top, panel->first, 1, shown);
    return (double)values[row * LX_PANEL_SIDE + column];
}

/* The value that the picture has at the probe's pixel. */
static int probe_pixel(const struct lx_session *session, luxel_probe *probe)
{
    const struct lx_plan *plan = &session->plan;
    const struct lx_screen *screen = &session->prepared.scene->screen;
    struct lx_shader_memory *memory = lx_shader_memory_new(plan);
    struct lx_panels_memory *panels = plan->in_panels ? lx_panels_memory_new(plan) : NULL;
    const bool has_room = memory && (panels || !plan->in_panels);
    if (has_room) {
        const unsigned width = panels ? LX_PANEL_SIDE : lx_tile_columns(plan, screen->resolution[0]);
        const struct neighbourhood near = neighbourhood_of(screen, probe, width, panels ? LX_PANEL_SIDE : LX_TILE_ROWS);
        const size_t row = probe->row - near.top, column = probe->column - near.first;
        probe->pixel_value = panels ? shade_in_panel(session, &near, row, column, memory, panels)
                                    : shade_in_tile(session, &near, row, column, memory);
        probe->has_pixel_value = isfinite(probe->pixel_value);
    }
    lx_panels_memory_free(panels);
    lx_shader_memory_free(memory);
    return has_room ? 0 : -1;
}

static luxel_status finish(struct lx_session *session, int failed, luxel_diagnostics *diagnostics, luxel_probe *made,
                           luxel_probe **probe)
{
    luxel_status status = LUXEL_OK;
    lx_session_clear(session);
    if (failed) {
        status = lx_out_of_memory(diagnostics);
    } else if (made->has_value && !isfinite(made->value)) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_VALUE_TOO_LARGE, LX_ARGS("double"));
        lx_hint(diagnostics, LX_MSG_LOWER_STRENGTHS, NULL);
        status = LUXEL_ERROR_RANGE;
    }
    if (status == LUXEL_OK)
        *probe = made;
    else
        luxel_probe_free(made);
    return status;
}

static luxel_status open_session(const luxel_scene *scene, const luxel_settings *settings, bool is_finite,
                                 luxel_diagnostics *diagnostics, struct lx_session *session)
{
    luxel_status status = lx_session_open(scene, settings, diagnostics, session);
    if (status == LUXEL_OK && !is_finite) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_BAD_PLACE, NULL);
        status = LUXEL_ERROR_ARGUMENT;
    }
    if (status != LUXEL_OK)
        lx_session_clear(session);
    return status;
}

luxel_status luxel_probe_screen(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                                luxel_diagnostics *diagnostics, luxel_probe **probe)
{
    struct lx_session session;
    luxel_status status = open_session(scene, settings, isfinite(x_mm) && isfinite(y_mm), diagnostics, &session);
    if (status != LUXEL_OK)
        return status;
    luxel_probe *made = lx_new_array(1, sizeof *made);
    int failed = made == NULL;
    if (made) {
        struct lx_element element;
        made->has_screen = true;
        made->x_mm = x_mm;
        made->y_mm = y_mm;
        made->tolerance_reached = true;
        made->has_pixel = lx_pixel_at(&session.prepared.scene->screen, x_mm, y_mm, &made->column, &made->row);
        if (lx_element_seen(&session.prepared, x_mm, y_mm, &element))
            failed = probe_element(&session, &element, made);
        if (!failed && made->on_surface && made->has_pixel)
            failed = probe_pixel(&session, made);
    }
    return finish(&session, failed, diagnostics, made, probe);
}

luxel_status luxel_probe_element(const luxel_scene *scene, const luxel_settings *settings, const double position_mm[3],
                                 const double normal[3], luxel_diagnostics *diagnostics, luxel_probe **probe)
{
    struct lx_session session;
    bool is_finite = true, is_zero = true;
    for (int i = 0; i < 3; i++) {
        is_finite = is_finite && isfinite(position_mm[i]) && isfinite(normal[i]);
        is_zero = is_zero && normal[i] == 0;
    }
    luxel_status status = open_session(scene, settings, is_finite && !is_zero, diagnostics, &session);
    if (status != LUXEL_OK)
        return status;
    luxel_probe *made = lx_new_array(1, sizeof *made);
    int failed = made == NULL;
    if (made) {
        struct lx_element element = lx_element_at(&session.prepared, position_mm, normal);
        made->tolerance_reached = true;
        failed = probe_element(&session, &element, made);
    }
    return finish(&session, failed, diagnostics, made, probe);
}

const char *luxel_scene_unit(const luxel_scene *scene, luxel_quantity quantity)
{
    struct lx_prepared prepared;
    const char *unit = "relative";
    if (!scene || !luxel_scene_is_committed(scene))
        return unit;
    if (lx_prepare(lx_scene_parameters(scene), LX_DEFAULT_TOLERANCE, NULL, &prepared) == 0)
        unit = lx_unit_of(&prepared, quantity);
    lx_prepared_clear(&prepared);
    return unit;
}
