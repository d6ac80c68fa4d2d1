/* SPDX-License-Identifier: MIT */
/* The JSON of luxel photometry. */
#include "photometry.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "json.h"

static const char *const type_names[] = {
    [LUXEL_PHOTOMETRY_TYPE_A] = "A", [LUXEL_PHOTOMETRY_TYPE_B] = "B", [LUXEL_PHOTOMETRY_TYPE_C] = "C"};

static void write_flux(struct json *json, const luxel_photometry_figures *figures)
{
    json_open(json, "flux", '{');
    json_number(json, "zone", figures->zone_lumens);
    json_number(json, "linear", figures->linear_lumens);
    json_close(json, '}');
}

static void write_greatest(struct json *json, const luxel_photometry *photometry,
                           const luxel_photometry_figures *figures)
{
    json_open(json, "max", '{');
    json_number(json, "intensity", figures->greatest_cd);
    json_number(json, "c", figures->greatest_c_deg);
    json_number(json, "gamma", figures->greatest_gamma_deg);
    if (photometry->type != LUXEL_PHOTOMETRY_TYPE_C) {
        json_number(json, "horizontal", figures->greatest_plane_deg);
        json_number(json, "vertical", figures->greatest_angle_deg);
    }
    json_close(json, '}');
}

static void write_opening(struct json *json, const luxel_photometry_opening *opening)
{
    json_open(json, "opening", '{');
    json_text(json, "shape", luxel_photometry_opening_name(opening));
    json_number(json, "width_mm", opening->width_mm);
    json_number(json, "length_mm", opening->length_mm);
    json_number(json, "height_mm", opening->height_mm);
    json_close(json, '}');
}

static void write_warnings(struct json *json, const struct luminaire *luminaire)
{
    char *warning;

    json_open(json, "warnings", '[');
    for (size_t i = 0; (warning = luminaire_warning(luminaire, i, true)) != NULL; i++) {
        json_text(json, NULL, warning);
        free(warning);
    }
    json_close(json, ']');
}

/* The CIE flux code as it is written, in whole percent; null where there is none. */
static void write_code(struct json *json, const luxel_photometry_figures *figures)
{
    json_open(json, "cie_flux_code", '[');
    for (int i = 0; i < 5; i++)
        json_number(json, NULL, round(figures->flux_code[i]));
    json_close(json, ']');
    json_numbers(json, "cie_flux_shares", figures->flux_code, 5);
}

static void write_ratios(struct json *json, const luxel_photometry_figures *figures)
{
    json_open(json, "direct_ratios", '{');
    json_open(json, "room_index", '[');
    for (size_t i = 0; i < LUXEL_ROOM_INDICES; i++)
        json_number(json, NULL, luxel_photometry_room_index(i));
    json_close(json, ']');
    json_numbers(json, "ratio", figures->direct_ratios, LUXEL_ROOM_INDICES);
    json_close(json, '}');
    json_open(json, "spacing_criterion", '{');
    json_number(json, "c0_c180", figures->spacing[0]);
    json_number(json, "c90_c270", figures->spacing[1]);
    json_number(json, "diagonal", figures->spacing[2]);
    json_close(json, '}');
}

/* A room by the light that its walls really reflect. */
static void write_room(struct json *json, const struct luminaire *luminaire)
{
    const struct room_ratings *room = &luminaire->room;

    if (!room->exists)
        return;
    json_open(json, "room", '{');
    json_number(json, "across", luxel_ugr_room(room->room, 0));
    json_number(json, "along", luxel_ugr_room(room->room, 1));
    json_numbers(json, "background_by_table", luminaire->glare.backgrounds[room->room], LUXEL_UGR_REFLECTANCES);
    json_open(json, "background", '[');
    for (size_t i = 0; i < LUXEL_UGR_REFLECTANCES; i++) {
        json_open(json, NULL, '{');
        json_number(json, "value", room->background[i].value);
        json_number(json, "error", room->background[i].error);
        json_close(json, '}');
    }
    json_close(json, ']');
    json_numbers(json, "crosswise", room->ratings[0], LUXEL_UGR_REFLECTANCES);
    json_numbers(json, "endwise", room->ratings[1], LUXEL_UGR_REFLECTANCES);
    json_numbers(json, "error", room->errors, LUXEL_UGR_REFLECTANCES);
    json_close(json, '}');
}

static void write_reflectances(struct json *json, size_t count, double (*reflectance)(size_t i, size_t part))
{
    static const char *const parts[] = {"ceiling", "walls", "floor"};

    json_open(json, "reflectances", '[');
    for (size_t i = 0; i < count; i++) {
        json_open(json, NULL, '{');
        for (size_t part = 0; part < 3; part++)
            json_number(json, parts[part], reflectance(i, part));
        json_close(json, '}');
    }
    json_close(json, ']');
}

/* The ratings; null: the luminaire has none. */
static void write_glare(struct json *json, const struct luminaire *luminaire)
{
    const luxel_ugr_table *glare = &luminaire->glare;
    static const char *const ways[] = {"crosswise", "endwise"};

    if (!glare->exists) {
        json_null(json, "ugr");
        return;
    }
    json_open(json, "ugr", '{');
    json_number(json, "spacing", glare->spacing);
    write_reflectances(json, LUXEL_UGR_REFLECTANCES, luxel_ugr_reflectance);
    json_open(json, "rooms", '[');
    for (size_t i = 0; i < LUXEL_UGR_ROOMS; i++) {
        json_open(json, NULL, '{');
        json_number(json, "across", luxel_ugr_room(i, 0));
        json_number(json, "along", luxel_ugr_room(i, 1));
        for (int way = 0; way < 2; way++)
            json_numbers(json, ways[way], glare->ratings[i][way], LUXEL_UGR_REFLECTANCES);
        json_close(json, '}');
    }
    json_close(json, ']');
    write_room(json, luminaire);
    json_close(json, '}');
}

/* Utilization factors by room index; null: there are none. */
static void write_utilization(struct json *json, const luxel_utilization_table *table)
{
    if (!table->exists) {
        json_null(json, "utilization");
        return;
    }
    json_open(json, "utilization", '{');
    json_number(json, "lumens", table->lumens);
    write_reflectances(json, LUXEL_UTILIZATION_REFLECTANCES, luxel_utilization_reflectance);
    json_open(json, "rooms", '[');
    for (size_t k = 0; k < LUXEL_ROOM_INDICES; k++) {
        json_open(json, NULL, '{');
        json_number(json, "room_index", luxel_photometry_room_index(k));
        json_numbers(json, "factors", table->factors[k], LUXEL_UTILIZATION_REFLECTANCES);
        json_close(json, '}');
    }
    json_close(json, ']');
    json_close(json, '}');
}

/* Backlight, uplight and glare outdoors; null: types A and B. */
static void write_bug(struct json *json, const luxel_bug_rating *bug)
{
    static const char *const names[] = {"fl", "fm", "fh", "fvh", "bl", "bm", "bh", "bvh", "ul", "uh"};

    if (!bug->exists) {
        json_null(json, "bug");
        return;
    }
    json_open(json, "bug", '{');
    json_whole(json, "backlight", bug->backlight);
    json_whole(json, "uplight", bug->uplight);
    json_whole(json, "glare", bug->glare);
    json_number(json, "front_c", bug->front_c_deg);
    json_bool(json, "around", bug->is_around);
    json_open(json, "lumens", '{');
    for (size_t i = 0; i < LUXEL_BUG_ZONES; i++)
        json_number(json, names[i], bug->lumens[i]);
    json_close(json, '}');
    json_close(json, '}');
}

static void write_lamps(struct json *json, const luxel_photometry *photometry)
{
    json_open(json, "lamps", '[');
    for (size_t i = 0; i < photometry->lamp_set_count; i++) {
        const luxel_photometry_lamp_set *lamps = &photometry->lamp_sets[i];

        json_open(json, NULL, '{');
        json_number(json, "count", lamps->count);
        json_text(json, "type", lamps->type);
        json_number(json, "lumens", lamps->lumens);
        json_number(json, "watts", lamps->watts);
        json_text(json, "color_temperature", lamps->temperature);
        json_text(json, "color_rendering", lamps->rendering);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static void write_texts(struct json *json, const luxel_photometry *photometry)
{
    json_open(json, "texts", '[');
    for (size_t i = 0; i < photometry->text_count; i++) {
        json_open(json, NULL, '{');
        json_text(json, "keyword", photometry->texts[i].keyword);
        json_text(json, "text", photometry->texts[i].text);
        json_close(json, '}');
    }
    json_close(json, ']');
}

/* The angles of the complete table. */
static void write_angles(struct json *json, const luxel_photometry *photometry)
{
    const bool is_turn = photometry->type == LUXEL_PHOTOMETRY_TYPE_C;

    json_numbers(json, is_turn ? "c_angles" : "horizontal_angles", photometry->planes, photometry->plane_count);
    json_numbers(json, is_turn ? "gamma_angles" : "vertical_angles", photometry->angles, photometry->angle_count);
}

static void write_tilt(struct json *json, const luxel_photometry *photometry)
{
    if (photometry->tilt_count == 0) {
        json_null(json, "tilt");
        return;
    }
    json_open(json, "tilt", '{');
    json_whole(json, "geometry", photometry->tilt_geometry);
    json_numbers(json, "angles", photometry->tilt_angles, photometry->tilt_count);
    json_numbers(json, "factors", photometry->tilt_factors, photometry->tilt_count);
    json_close(json, '}');
}

void luminaire_print_json(const struct luminaire *luminaire)
{
    const luxel_photometry *photometry = luminaire->photometry;
    const luxel_photometry_figures *figures = &luminaire->figures;
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_text(&json, "format", luxel_photometry_format_name(photometry));
    json_text(&json, "type", type_names[photometry->type]);
    json_text(&json, "symmetry", luxel_photometry_symmetry_name(photometry->symmetry));
    json_whole(&json, "planes", photometry->declared_planes);
    json_whole(&json, "angles", photometry->angle_count);
    json_number(&json, "declared_lumens", photometry->declared_lumens);
    write_flux(&json, figures);
    json_number(&json, "lorl", figures->lorl);
    json_number(&json, "dff", figures->dff);
    write_greatest(&json, photometry, figures);
    json_number(&json, "beam_angle", figures->beam_deg);
    json_number(&json, "field_angle", figures->field_deg);
    write_opening(&json, &photometry->opening);
    write_warnings(&json, luminaire);
    json_text(&json, "version", photometry->version);
    json_whole(&json, "stored_planes", photometry->stored_planes);
    json_bool(&json, "absolute", photometry->is_absolute);
    json_number(&json, "multiplier", photometry->multiplier);
    json_number(&json, "watts", photometry->watts);
    json_number(&json, "declared_lorl", photometry->declared_lorl);
    json_number(&json, "declared_dff", photometry->declared_dff);
    json_numbers(&json, "beam_angles", figures->beam_sections_deg, 2);
    json_numbers(&json, "field_angles", figures->field_sections_deg, 2);
    write_code(&json, figures);
    write_ratios(&json, figures);
    write_glare(&json, luminaire);
    json_numbers(&json, "zone_lumens", luminaire->zones, LUXEL_FLUX_ZONES);
    write_utilization(&json, &luminaire->utilization);
    write_bug(&json, &luminaire->bug);
    write_lamps(&json, photometry);
    write_tilt(&json, photometry);
    write_angles(&json, photometry);
    write_texts(&json, photometry);
    json_close(&json, '}');
}
