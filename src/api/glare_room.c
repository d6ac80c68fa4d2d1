/* SPDX-License-Identifier: MIT */
/*
 * The room of the tabular method as a scene: its ceiling is the plane of the luminaires, its floor that of the eye, one
 * metre below.  The glare is that of the table; the background is the mean of what the walls receive by reflections,
 * solved with a bound instead of from floor, walls and ceiling that are each evenly lit.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/glare.h>

#include "../base/text.h"
#include "../scene/tidy.h"

enum { H_MM = 1000 };
enum { CEILING, WALLS, FLOOR };             /* as luxel_ugr_reflectance() counts them */
static const double BELOW_CEILING_MM = 0.1; /* of the luminaires, which else lay on it */
static const double WISHED = 0.01;          /* error of the reflected light, of the greatest mean irradiance */

static void write_wall(struct lx_text *text, const char *name, double reflectance)
{
    lx_text_printf(text, "%s: {model: lambert, over_pi: true, diffuse: %.17g}", name, reflectance);
}

/* The eye looks along y; z is up.  The front of a room is its greatest z. */
static void write_room(struct lx_text *text, const char *path, const luxel_ugr_table *table, size_t room, size_t triple)
{
    const double x = luxel_ugr_room(room, 0), y = luxel_ugr_room(room, 1), spacing = table->spacing;
    const size_t across = (size_t)round(x / spacing), along = (size_t)round(y / spacing);
    lx_text_printf(text,
                   "luxel: 1\nunits: photometric\nreflections: all\nscreen: {width: 1, height: 1, resolution: [4, 4]}\n"
                   "observer: {z: %d}\nsurfaces:\n  - type: room\n    center: [0, 0, %g]\n    size: [%g, %g, %d]\n    ",
                   9 * H_MM, H_MM / 2.0, x * H_MM, y * H_MM, H_MM);
    write_wall(text, "material", luxel_ugr_reflectance(triple, WALLS));
    lx_text_puts(text, "\n    materials: {");
    write_wall(text, "front", luxel_ugr_reflectance(triple, CEILING));
    write_wall(text, ", back", luxel_ugr_reflectance(triple, FLOOR));
    lx_text_puts(text, "}\nlights:\n");
    for (size_t i = 0; i < across * along; i++) {
        lx_text_puts(text, "  - {type: luminaire, file: ");
        lx_write_key(text, path, true); /* a string of JSON is one of YAML, too */
        lx_text_printf(text, ", position: [%.17g, %.17g, %.17g], c0: [0, 1, 0]}\n",
                       H_MM * (((double)(i % across) + 0.5) * spacing - x / 2),
                       H_MM * (((double)(i / across) + 0.5) * spacing - y / 2), H_MM - BELOW_CEILING_MM);
    }
}

static luxel_status make_room(const char *path, const luxel_ugr_table *table, size_t room, size_t triple,
                              luxel_diagnostics *diagnostics, luxel_scene **scene)
{
    struct lx_text text = {0};
    write_room(&text, path, table, room, triple);
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

/* The mean indirect illuminance of the four walls over pi. */
static luxel_bounded background_of(const luxel_balance *balance)
{
    luxel_bounded light = {0, 0};
    double area = 0;
    for (size_t i = 0; i < balance->side_count; i++) {
        const luxel_balance_side *side = &balance->sides[i];
        if (side->side != LUXEL_SIDE_FRONT || side->part >= 6 || strcmp(side->part_name, "front") == 0 ||
            strcmp(side->part_name, "back") == 0)
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
    luxel_scene *scene = NULL;
    if (!path || !table || !table->exists || room >= LUXEL_UGR_ROOMS || triple >= LUXEL_UGR_REFLECTANCES || !rating)
        return LUXEL_ERROR_ARGUMENT;
    luxel_settings own;
    luxel_settings_init(&own);
    if (settings)
        own = *settings;
    if (!(own.reflected_error > 0))
        own.reflected_error = WISHED;
    luxel_status status = make_room(path, table, room, triple, diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_find_balance(scene, &own, diagnostics, &balance);
    if (balance) {
        const luxel_bounded light = background_of(balance);
        *rating = (luxel_room_rating){.background = light, .reached = balance->reached};
        for (int way = 0; way < 2; way++)
            rating->ratings[way] =
                table->ratings[room][way][triple] + 8 * log10(table->backgrounds[room][triple] / light.value);
        rating->error = -8 * log10(fmax(0, 1 - light.error / light.value));
    }
    luxel_balance_free(balance);
    luxel_scene_free(scene);
    return status;
}
