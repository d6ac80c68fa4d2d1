/* SPDX-License-Identifier: MIT */
/*
 * Rooms of tabular methods as scenes: the ceiling is the plane of the luminaires, the floor that of the eye or of work,
 * one metre below.  Of glare only the background is found anew, as the mean of what the walls receive by reflections;
 * of utilization all that the floor receives.  Both are solved with a bound instead of from floor, walls and ceiling
 * that are each evenly lit.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/glare.h>
#include <luxel/utilization.h>

#include "../base/text.h"
#include "../scene/tidy.h"

enum { H_MM = 1000 };
enum { CEILING, WALLS, FLOOR };             /* as luxel_ugr_reflectance() counts them */
static const double BELOW_CEILING_MM = 0.1; /* of the luminaires, which else lay on it */
static const double WISHED = 0.01;          /* error of the reflected light, of the greatest mean irradiance */

struct room {
    double size[2]; /* across and along, in heights */
    size_t n[2];    /* of luminaires */
    double reflectances[3];
};

static void write_wall(struct lx_text *text, const char *name, double reflectance)
{
    lx_text_printf(text, "%s: {model: lambert, over_pi: true, diffuse: %.17g}", name, reflectance);
}

/* The eye looks along y; z is up.  The front of a room is its greatest z. */
static void write_room(struct lx_text *text, const char *path, const struct room *room)
{
    const double x = room->size[0], y = room->size[1];
    lx_text_printf(
        text,
        "luxel: 1\nunits: photometric\nreflections: all\nscreen: {width: 1, height: 1, resolution: [4, 4]}\n"
        "observer: {z: %d}\nsurfaces:\n  - type: room\n    center: [0, 0, %g]\n    size: [%.17g, %.17g, %d]\n    ",
        9 * H_MM, H_MM / 2.0, x * H_MM, y * H_MM, H_MM);
    write_wall(text, "material", room->reflectances[WALLS]);
    lx_text_puts(text, "\n    materials: {");
    write_wall(text, "front", room->reflectances[CEILING]);
    write_wall(text, ", back", room->reflectances[FLOOR]);
    lx_text_puts(text, "}\nlights:\n");
    for (size_t i = 0; i < room->n[0] * room->n[1]; i++) {
        lx_text_puts(text, "  - {type: luminaire, file: ");
        lx_write_key(text, path, true); /* a string of JSON is one of YAML, too */
        lx_text_printf(text, ", position: [%.17g, %.17g, %.17g], c0: [0, 1, 0]}\n",
                       H_MM * x * (((double)(i % room->n[0]) + 0.5) / (double)room->n[0] - 0.5),
                       H_MM * y * (((double)(i / room->n[0]) + 0.5) / (double)room->n[1] - 0.5),
                       H_MM - BELOW_CEILING_MM);
    }
}

static luxel_status make_room(const char *path, const struct room *room, luxel_diagnostics *diagnostics,
                              luxel_scene **scene)
{
    struct lx_text text = {0};
    write_room(&text, path, room);
    char *yaml = lx_text_take(&text);
    if (!yaml)
        return LUXEL_ERROR_MEMORY;
    luxel_status status = luxel_scene_read_text(yaml, strlen(yaml), "room", diagnostics, scene);
    free(yaml);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(*scene, diagnostics);
    if (status == LUXEL_OK)
        luxel_diagnostics_clear(diagnostics); /* advice about such a scene */
    return status;
}

/* Solves the room; the balance is the caller's. */
static luxel_status solve(const char *path, const struct room *room, const luxel_settings *settings,
                          luxel_diagnostics *diagnostics, luxel_balance **balance)
{
    luxel_scene *scene = NULL;
    luxel_settings own;
    luxel_settings_init(&own);
    if (settings)
        own = *settings;
    if (!(own.reflected_error > 0))
        own.reflected_error = WISHED;
    luxel_status status = make_room(path, room, diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_find_balance(scene, &own, diagnostics, balance);
    luxel_scene_free(scene);
    return status;
}

static bool is_part(const luxel_balance_side *side, const char *name)
{
    return side->side == LUXEL_SIDE_FRONT && side->part < 6 && strcmp(side->part_name, name) == 0;
}

/* The mean indirect illuminance of the four walls over pi. */
static luxel_bounded background_of(const luxel_balance *balance)
{
    luxel_bounded light = {0, 0};
    double area = 0;
    for (size_t i = 0; i < balance->side_count; i++) {
        const luxel_balance_side *side = &balance->sides[i];
        if (side->side != LUXEL_SIDE_FRONT || side->part >= 6 || is_part(side, "front") || is_part(side, "back"))
            continue;
        light.value += side->area_m2 * (side->irradiance.value - side->direct.value);
        light.error += side->area_m2 * (side->irradiance.error + side->direct.error);
        area += side->area_m2;
    }
    return (luxel_bounded){light.value / area / M_PI, light.error / area / M_PI};
}

luxel_status luxel_find_room_rating(const char *path, const luxel_ugr_table *table, size_t room, size_t triple,
                                    const luxel_settings *settings, luxel_diagnostics *diagnostics,
                                    luxel_room_rating *rating)
{
    luxel_balance *balance = NULL;
    if (!path || !table || !table->exists || room >= LUXEL_UGR_ROOMS || triple >= LUXEL_UGR_REFLECTANCES || !rating)
        return LUXEL_ERROR_ARGUMENT;
    struct room made;
    for (size_t i = 0; i < 2; i++) {
        made.size[i] = luxel_ugr_room(room, i);
        made.n[i] = (size_t)round(made.size[i] / table->spacing);
    }
    for (size_t i = 0; i < 3; i++)
        made.reflectances[i] = luxel_ugr_reflectance(triple, i);
    const luxel_status status = solve(path, &made, settings, diagnostics, &balance);
    if (balance) {
        const luxel_bounded light = background_of(balance);
        *rating = (luxel_room_rating){.background = light, .reached = balance->reached};
        for (int way = 0; way < 2; way++)
            rating->ratings[way] =
                table->ratings[room][way][triple] + 8 * log10(table->backgrounds[room][triple] / light.value);
        rating->error = -8 * log10(fmax(0, 1 - light.error / light.value));
    }
    luxel_balance_free(balance);
    return status;
}

luxel_status luxel_find_room_utilization(const char *path, const luxel_utilization_table *table, size_t k,
                                         size_t triple, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                                         luxel_room_utilization *utilization)
{
    luxel_balance *balance = NULL;
    if (!path || !table || !table->exists || k >= LUXEL_ROOM_INDICES || triple >= LUXEL_UTILIZATION_REFLECTANCES ||
        !utilization)
        return LUXEL_ERROR_ARGUMENT;
    const double side = 2 * luxel_photometry_room_index(k);
    const size_t n = (size_t)round(side); /* as far apart as they are high */
    struct room made = {.size = {side, side}, .n = {n, n}};
    for (size_t i = 0; i < 3; i++)
        made.reflectances[i] = luxel_utilization_reflectance(triple, i);
    const luxel_status status = solve(path, &made, settings, diagnostics, &balance);
    const double lumens = (double)(n * n) * table->lumens;
    for (size_t i = 0; balance && i < balance->side_count; i++) {
        const luxel_balance_side *part = &balance->sides[i];
        if (is_part(part, "back"))
            *utilization = (luxel_room_utilization){.factor = {part->area_m2 * part->irradiance.value / lumens,
                                                               part->area_m2 * part->irradiance.error / lumens},
                                                    .reached = balance->reached};
    }
    luxel_balance_free(balance);
    return status;
}
