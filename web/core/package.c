/* SPDX-License-Identifier: MIT */
/*
 * What the package for npm asks beyond the page: whole results under the names of the Python package, each as exact as
 * the tool's, and the schema of scenes.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "answer.h"
#include "core.h"

static void answer_index(const char *key, bool given, size_t index)
{
    answer_key(key);
    answer_number(given && index != SIZE_MAX ? (double)index : (double)NAN);
}

static void answer_given(const char *key, bool given, double number)
{
    answer_key(key);
    answer_number(given ? number : (double)NAN);
}

static void answer_vector(const char *key, bool given, const double *numbers, size_t count)
{
    answer_key(key);
    answer_numbers(given ? numbers : NULL, count);
}

static void answer_text_of(const char *key, bool given, const char *text)
{
    answer_key(key);
    answer_string(given ? text : NULL);
}

static void answer_truth(const char *key, bool truth)
{
    answer_key(key);
    answer_bool(truth);
}

/* A number with its bound, an object; null where it is not given. */
static void answer_bounded(const char *key, bool given, luxel_bounded amount)
{
    answer_key(key);
    if (!given) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_given("value", true, amount.value);
    answer_given("error", true, amount.error);
    answer_close('}');
}

/* How exactly all is computed from now on, as luxel_settings has it; 0: its defaults. */
PAGE_CALLS(package_settings) void package_settings(double tolerance, double light_error, double reflected_error)
{
    if (!core.is_package || tolerance != core.tolerance || light_error != core.light_error ||
        reflected_error != core.reflected_error)
        drop_evaluator();
    core.is_package = true;
    core.tolerance = tolerance;
    core.light_error = light_error;
    core.reflected_error = reflected_error;
}

/* ---- probes ---- */

static void answer_color(const luxel_color *color)
{
    luxel_chromaticity seen;

    answer_key("color");
    if (!color || !color->exists) {
        answer_string(NULL);
        return;
    }
    luxel_find_chromaticity(color->rgb, &seen);
    answer_open('{');
    answer_vector("rgb", true, color->rgb, 3);
    answer_vector("error", true, color->error, 3);
    answer_vector("xy", seen.has_xy, seen.xy, 2);
    answer_given("cct", seen.has_cct, seen.cct_k);
    answer_given("duv", seen.has_cct, seen.duv);
    answer_vector("uv", seen.has_xy, seen.uv, 2);
    answer_close('}');
}

static void answer_share(const luxel_light_share *share)
{
    answer_open('{');
    answer_index("light", true, share->light);
    answer_text_of("type", true, share->type);
    answer_text_of("name", true, share->name);
    answer_given("irradiance", true, share->irradiance);
    answer_given("diffuse", true, share->diffuse);
    answer_given("specular", true, share->specular);
    answer_given("error", true, share->error);
    answer_index("parts", true, share->parts);
    answer_color(share->color);
    answer_close('}');
}

static void answer_reflected(const luxel_probe *probe)
{
    answer_key("reflected");
    if (!probe->has_reflected) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_given("irradiance", true, probe->reflected_irradiance);
    answer_given("value", true, probe->reflected.value);
    answer_given("error", true, probe->reflected.error);
    answer_close('}');
}

static void answer_whole_probe(const luxel_probe *probe, double albedo)
{
    const bool seen = probe->on_surface;

    answer_open('{');
    answer_vector("screen_mm", probe->has_screen, (const double[]){probe->x_mm, probe->y_mm}, 2);
    answer_vector("pixel", probe->has_pixel, (const double[]){probe->column, probe->row}, 2);
    answer_truth("on_surface", seen);
    answer_given("value", probe->has_value, probe->value);
    answer_given("error", probe->has_value, probe->error);
    answer_truth("tolerance_reached", probe->tolerance_reached && probe->reflected_reached);
    answer_given("pixel_value", probe->has_pixel_value, probe->pixel_value);
    answer_vector("position_mm", seen, probe->position_mm, 3);
    answer_vector("normal", seen, probe->normal, 3);
    answer_vector("view", seen, probe->view, 3);
    answer_given("albedo", albedo >= 0, albedo);
    answer_index("surface", seen, probe->surface);
    answer_text_of("surface_name", seen, probe->surface_name);
    answer_text_of("wall", seen, probe->part_name);
    answer_truth("lies_on_surface", probe->lies_on_surface);
    answer_index("enclosing_surface", probe->is_enclosed, probe->enclosing_surface);
    answer_index("blocking_light", probe->source_on_element, probe->blocking_light);
    answer_reflected(probe);
    answer_color(&probe->color);
    answer_key("shares");
    answer_open('[');
    for (size_t i = 0; probe->has_value && i < probe->share_count; i++)
        answer_share(&probe->shares[i]);
    answer_close(']');
    answer_close('}');
}

/* Numbers for a place: x, y; or position, normal, whether it has a view, that, surface. */
enum { SCREEN = 2, ELEMENT = 11 };

static luxel_place place_of(const double *numbers, size_t width)
{
    luxel_place place = {0};

    if (width == SCREEN) {
        place.screen_mm[0] = numbers[0];
        place.screen_mm[1] = numbers[1];
        return place;
    }
    place.is_element = true;
    place.has_view = numbers[6] != 0;
    place.surface = (size_t)numbers[10];
    for (int axis = 0; axis < 3; axis++) {
        place.position_mm[axis] = numbers[axis];
        place.normal[axis] = numbers[3 + axis];
        place.view[axis] = numbers[7 + axis];
    }
    return place;
}

/* The probes of places of so many numbers each; NULL: the diagnostics tell why there are none. */
PAGE_CALLS(package_probe) const char *package_probe(const double *numbers, size_t width, size_t count)
{
    enum { MOST_ALBEDOS = 1000 }; /* as the Python package has it: an albedo is an integral */
    const luxel_settings settings = present_settings();
    luxel_place *places = calloc(count + 1, sizeof *places);
    luxel_probes *probes = NULL;

    for (size_t i = 0; places && i < count; i++)
        places[i] = place_of(numbers + i * width, width);
    if (places && core.scene)
        (void)luxel_probe_places(core.scene, &settings, places, count, fresh_diagnostics(), &probes);
    free(places);
    if (!probes)
        return NULL;
    answer_begin();
    answer_open('[');
    for (size_t i = 0; i < count; i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        answer_whole_probe(probe, count <= MOST_ALBEDOS ? luxel_probe_albedo(core.scene, probe) : (double)NAN);
    }
    answer_close(']');
    luxel_probes_free(probes);
    return answer_text();
}

/* ---- pictures ---- */

static void answer_pixel(const char *key, const luxel_extremum *extremum)
{
    answer_key(key);
    if (!extremum->exists) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_given("value", true, extremum->value);
    answer_given("column", true, extremum->column);
    answer_given("row", true, extremum->row);
    answer_given("x_mm", true, extremum->x_mm);
    answer_given("y_mm", true, extremum->y_mm);
    answer_close('}');
}

/* What the last picture is. */
PAGE_CALLS(package_field) const char *package_field(void)
{
    if (!core.field)
        return NULL;
    const luxel_statistics *statistics = luxel_field_statistics(core.field);
    const unsigned columns = luxel_field_columns(core.field), rows = luxel_field_rows(core.field);
    const double *x = luxel_field_x_mm(core.field), *y = luxel_field_y_mm(core.field);

    answer_begin();
    answer_open('{');
    answer_given("columns", true, columns);
    answer_given("rows", true, rows);
    answer_given("channels", true, luxel_field_channels(core.field));
    answer_text_of("unit", true, luxel_field_unit(core.field));
    answer_text_of("quantity_word", true, luxel_field_quantity_word(core.field));
    answer_vector("x_mm", x != NULL, x, columns);
    answer_vector("y_mm", y != NULL, y, rows);
    answer_key("statistics");
    answer_open('{');
    answer_pixel("maximum", &statistics->maximum);
    answer_pixel("minimum", &statistics->minimum);
    answer_given("mean", statistics->has_surface, statistics->mean);
    answer_given("lit", statistics->has_surface, statistics->lit);
    answer_given("pixels", true, (double)statistics->surface_pixels);
    answer_given("reflected_error", statistics->has_reflected, statistics->reflected_error);
    answer_close('}');
    answer_close('}');
    return answer_text();
}

/* Red, green and blue of each pixel of the last picture, or NULL where it is grey. */
PAGE_CALLS(package_rgb) const float *package_rgb(void)
{
    return core.field ? luxel_field_rgb_single(core.field) : NULL;
}

static void answer_peak(const char *key, const luxel_peak *peak)
{
    static const char *const PLACES[] = {"inside", "limb", "border", "jump", "plateau"};

    answer_key(key);
    if (!peak->exists) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_given("value", true, peak->value);
    answer_given("error", true, peak->error);
    answer_given("x_mm", true, peak->x_mm);
    answer_given("y_mm", true, peak->y_mm);
    answer_index("surface", true, peak->surface);
    answer_text_of("wall", true, luxel_scene_part_name(core.scene, peak->surface, peak->part));
    answer_vector("position_mm", true, peak->position_mm, 3);
    answer_vector("normal", true, peak->normal, 3);
    answer_text_of("place", true, PLACES[peak->place]);
    answer_close('}');
}

/* The true extrema, between the pixels; NULL: the diagnostics tell why there are none. */
PAGE_CALLS(package_extrema) const char *package_extrema(void)
{
    const luxel_settings settings = present_settings();
    const luxel_evaluator *evaluator = present_evaluator();
    luxel_field *field = NULL;
    luxel_extrema extrema;

    if (!evaluator || luxel_render(core.scene, &settings, fresh_diagnostics(), &field) != LUXEL_OK)
        return NULL;
    const luxel_status status = luxel_find_extrema(evaluator, field, NULL, core.diagnostics, &extrema);
    luxel_field_free(field);
    if (status != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('{');
    answer_peak("maximum", &extrema.maximum);
    answer_peak("minimum", &extrema.minimum);
    answer_close('}');
    return answer_text();
}

/* ---- grids ---- */

static void answer_cell(const char *key, const luxel_grid *grid, const luxel_grid_extremum *extremum)
{
    answer_key(key);
    if (grid->measured == 0) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_given("value", true, extremum->value);
    answer_given("column", true, extremum->column);
    answer_given("row", true, extremum->row);
    answer_vector("position_mm", true, extremum->position_mm, 3);
    answer_close('}');
}

/* Rows of numbers, null where a cell has no value. */
static void answer_rows(const char *key, const luxel_grid *grid, const double *numbers)
{
    answer_key(key);
    answer_open('[');
    for (size_t row = 0; row < grid->rows; row++) {
        answer_open('[');
        for (size_t i = row * grid->columns; i < (row + 1) * grid->columns; i++)
            answer_number(grid->mask[i] ? numbers[i] : (double)NAN);
        answer_close(']');
    }
    answer_close(']');
}

static void answer_plane(const luxel_grid *grid)
{
    const bool flows = grid->has_mean && grid->flux_unit;

    answer_given("mean", grid->has_mean, grid->mean.value);
    answer_given("mean_error", grid->has_mean, grid->mean.error);
    answer_given("flux", flows, grid->flux.value);
    answer_given("flux_error", flows, grid->flux.error);
    answer_text_of("flux_unit", flows, grid->flux_unit);
    answer_given("sampling_error", grid->has_sampling_error, grid->sampling_error);
    answer_truth("sampling_is_bound", grid->sampling_is_bound);
    answer_truth("is_coarse", grid->is_coarse);
}

static void answer_grid(size_t i, const luxel_grid *grid)
{
    answer_open('{');
    answer_text_of("name", true, grid->name);
    answer_text_of("measure", true, grid->measure);
    answer_given("columns", true, grid->columns);
    answer_given("rows", true, grid->rows);
    answer_vector("center_mm", true, grid->center_mm, 3);
    answer_vector("size_mm", true, grid->size_mm, 2);
    answer_vector("axis", true, grid->axis, 3);
    answer_vector("up", true, grid->up, 3);
    answer_vector("across", true, grid->across, 3);
    answer_text_of("unit", true, grid->unit);
    answer_rows("values", grid, grid->values);
    answer_rows("errors", grid, grid->errors);
    answer_given("measured", true, (double)grid->measured);
    answer_given("enclosed", true, (double)grid->enclosed);
    answer_given("error", true, grid->error);
    answer_given("average", grid->measured > 0, grid->average.value);
    answer_given("average_error", grid->measured > 0, grid->average.error);
    answer_cell("minimum", grid, &grid->minimum);
    answer_cell("maximum", grid, &grid->maximum);
    answer_given("u0", grid->has_evenness, grid->u0);
    answer_given("ud", grid->has_evenness, grid->ud);
    answer_plane(grid);
    answer_grid_limits(core.scene, i, grid);
    answer_truth("tolerance_reached", grid->tolerance_reached && (!grid->has_reflected || grid->reflected_reached));
    answer_close('}');
}

/* The i-th grid, measured; NULL: the diagnostics tell why there is none. */
PAGE_CALLS(package_grid) const char *package_grid(size_t i)
{
    const luxel_settings settings = present_settings();
    luxel_grid *grid = NULL;

    if (!core.scene || luxel_find_grid(core.scene, &settings, i, fresh_diagnostics(), &grid) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_grid(i, grid);
    luxel_grid_free(grid);
    return answer_text();
}

/* ---- reflected light ---- */

static void answer_side(const luxel_balance_side *side)
{
    answer_open('{');
    answer_index("surface", true, side->surface);
    answer_text_of("surface_name", true, side->surface_name);
    answer_text_of("wall", true, side->part_name);
    answer_text_of("side", true, luxel_surface_side_name(side->side));
    answer_given("area_m2", true, side->area_m2);
    answer_given("reflectance", true, side->reflectance);
    answer_bounded("direct", true, side->direct);
    answer_bounded("irradiance", true, side->irradiance);
    answer_close('}');
}

static void answer_balance(const luxel_balance *balance)
{
    answer_open('{');
    answer_text_of("unit", true, balance->unit);
    answer_text_of("flux_unit", true, balance->flux_unit);
    answer_key("sides");
    answer_open('[');
    for (size_t i = 0; i < balance->side_count; i++)
        answer_side(&balance->sides[i]);
    answer_close(']');
    answer_bounded("emitted", balance->has_emitted, balance->emitted);
    answer_bounded("missed", balance->has_emitted, balance->missed);
    answer_bounded("arrives", true, balance->arrives);
    answer_bounded("absorbed", true, balance->absorbed);
    answer_bounded("escaped", true, balance->escaped);
    answer_bounded("pending", true, balance->pending);
    answer_bounded("difference", true, balance->difference);
    answer_truth("closes", balance->closes);
    answer_truth("reached", balance->reached);
    answer_close('}');
}

/* The balance of the flux, null where surfaces reflect no light; NULL: the diagnostics tell why there is none. */
PAGE_CALLS(package_balance) const char *package_balance(void)
{
    const luxel_settings settings = present_settings();
    luxel_balance *balance = NULL;

    if (!core.scene || luxel_find_balance(core.scene, &settings, fresh_diagnostics(), &balance) != LUXEL_OK)
        return NULL;
    answer_begin();
    if (balance)
        answer_balance(balance);
    else
        answer_string(NULL);
    luxel_balance_free(balance);
    return answer_text();
}

/* ---- what a scene is ---- */

/* The conventions that decide its numbers, such as {"sampling": "nodes"}. */
PAGE_CALLS(package_conventions) const char *package_conventions(void)
{
    luxel_conventions *found = NULL;

    if (!core.scene || luxel_find_conventions(core.scene, NULL, &found) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('{');
    for (size_t i = 0; i < found->count; i++)
        answer_text_of(found->list[i].key, true, found->list[i].value);
    answer_close('}');
    luxel_conventions_free(found);
    return answer_text();
}

/* Puts what is legal but odd about the scene into the messages. */
PAGE_CALLS(package_advise) void package_advise(void)
{
    if (core.scene)
        (void)luxel_scene_advise(core.scene, fresh_diagnostics());
}

/* The JSON Schema of scenes; NULL: memory is short. */
PAGE_CALLS(package_schema) const char *package_schema(void)
{
    static char *schema;

    luxel_text_free(schema);
    schema = NULL;
    return luxel_scene_schema(&schema) == LUXEL_OK ? schema : NULL;
}
