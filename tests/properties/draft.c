/* SPDX-License-Identifier: MIT */
/* What drafts are at their simplest, how they are written, and turned. */
#include "draft.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct draft_surface draft_plain_surface = {
    .numbers = {.center = {0, 0, 0},
                .size = {1, 1},
                .axis = {0, 0, 1},
                .up = {0, 1, 0},
                .diffuse = 1,
                .specular = 0,
                .shininess = 1,
                .ambient = 1},
};

const struct draft_light draft_plain_light = {
    .numbers = {.place = {0, 0, 2},
                .towards = {0, 0, -1},
                .up = {0, 1, 0},
                .strength = 1,
                .k = 1,
                .exponent = 1,
                .inner = 0,
                .outer = 90,
                .size = {1, 1, 1}},
};

const struct draft draft_plain = {
    .words = {.columns = 1, .rows = 1},
    .numbers = {.pitch = 1, .observer_z = 2},
    .grid = {.numbers = {.center = {0, 0, 0}, .size = {1, 1}, .axis = {0, 0, 1}, .up = {0, 1, 0}}},
};

bool draft_is_extended(const struct draft_light *light)
{
    return (light->words.type == DRAFT_PLANAR || light->words.type == DRAFT_VOLUME) && light->words.parts == 0;
}

bool draft_has_extended(const struct draft *draft)
{
    bool has = false;
    for (size_t i = 0; i < draft->light_count; i++)
        has = has || draft_is_extended(&draft->lights[i]);
    return has;
}

bool draft_is_symmetric(const struct draft *draft)
{
    for (size_t i = 0; i < draft->light_count; i++) {
        const struct draft_light_words *words = &draft->lights[i].words;
        const bool is_wide = words->type == DRAFT_PLANAR || words->type == DRAFT_VOLUME;
        if (is_wide && (words->parts || (words->type == DRAFT_VOLUME && words->facets)))
            return false;
    }
    return true;
}

/* ---- writing ---- */

static void write_vector(FILE *text, const char *key, const double v[3])
{
    fprintf(text, ", %s: [%.17g, %.17g, %.17g]", key, v[0], v[1], v[2]);
}

static void write_surface(FILE *text, const struct draft_surface *surface)
{
    static const char *const models[] = {"lambert", "blinn-phong", "phong"};
    static const char *const highlights[] = {"plain", "gated", "cosine"};
    const struct draft_surface_words *words = &surface->words;
    const struct draft_surface_numbers *numbers = &surface->numbers;
    fprintf(text, "  - {type: %s", words->type == DRAFT_SPHERE ? "sphere" : "rectangle");
    write_vector(text, "center", numbers->center);
    if (words->type == DRAFT_SPHERE) {
        fprintf(text, ", radius: %.17g", numbers->size[0]);
    } else {
        fprintf(text, ", size: [%.17g, %.17g]", numbers->size[0], numbers->size[1]);
        write_vector(text, "axis", numbers->axis);
        write_vector(text, "up", numbers->up);
    }
    fprintf(text, ", material: {model: %s, diffuse: %.17g", models[words->model], numbers->diffuse);
    if (words->model != 0)
        fprintf(text, ", specular: %.17g, shininess: %.17g, highlight: %s, normalized: %s", numbers->specular,
                numbers->shininess, highlights[words->highlight], words->normalized ? "true" : "false");
    if (words->has_ambient)
        fprintf(text, ", ambient: %.17g", numbers->ambient);
    fprintf(text, ", over_pi: %s}}\n", words->over_pi ? "true" : "false");
}

static void write_aim(FILE *text, const struct draft_light *light)
{
    write_vector(text, light->words.is_aimed ? "aim" : "axis", light->numbers.towards);
}

static void write_law(FILE *text, const struct draft_light *light)
{
    static const char *const laws[] = {"inverse-square", "none", "practical", "polynomial"};
    fprintf(text, ", attenuation: %s", laws[light->words.law]);
    if (light->words.law == DRAFT_PRACTICAL)
        fprintf(text, ", k: %.17g", light->numbers.k);
    if (light->words.law == DRAFT_POLYNOMIAL)
        write_vector(text, "coefficients", light->numbers.coefficients);
}

/* `cloud`: NULL, or the file that tells place and intensity. */
static void write_point(FILE *text, const struct draft_light *light, const char *cloud)
{
    static const char *const patterns[] = {"isotropic", "lambertian", "cosine"};
    if (cloud) {
        fprintf(text, ", file: \"%s\"", cloud);
    } else {
        write_vector(text, "position", light->numbers.place);
        fprintf(text, ", intensity: %.17g", light->numbers.strength);
    }
    fprintf(text, ", pattern: %s", patterns[light->words.pattern]);
    if (light->words.pattern == DRAFT_COSINE)
        fprintf(text, ", exponent: %.17g", light->numbers.exponent);
    if (light->words.pattern != DRAFT_ISOTROPIC)
        write_aim(text, light);
    write_law(text, light);
}

static void write_spot(FILE *text, const struct draft_light *light)
{
    static const char *const falloffs[] = {"smoothstep", "squared", "linear", "hard"};
    const struct draft_light_numbers *numbers = &light->numbers;
    write_vector(text, "position", numbers->place);
    write_aim(text, light);
    fprintf(text, ", intensity: %.17g, inner: %.17g, outer: %.17g, falloff: %s, exponent: %.17g", numbers->strength,
            numbers->inner, numbers->outer, falloffs[light->words.falloff], numbers->exponent);
    write_law(text, light);
}

static void write_corners(FILE *text, const struct draft_light *light)
{
    fprintf(text, ", vertices: [");
    for (unsigned i = 0; i < light->words.corners; i++) {
        const double *corner = light->numbers.corners[i];
        fprintf(text, "%s[%.17g, %.17g, %.17g]", i ? ", " : "", corner[0], corner[1], corner[2]);
    }
    fprintf(text, "]");
}

static void write_outline(FILE *text, const struct draft_light *light)
{
    const double *size = light->numbers.size, *center = light->numbers.place;
    if (light->words.shape == DRAFT_POLYGON) {
        write_corners(text, light);
        return;
    }
    const bool is_disk = light->words.shape == DRAFT_DISK;
    fprintf(text, ", %s: {center: [%.17g, %.17g, %.17g]", is_disk ? "disk" : "rectangle", center[0], center[1],
            center[2]);
    if (is_disk) {
        fprintf(text, ", radius: %.17g", size[0]);
    } else {
        fprintf(text, ", size: [%.17g, %.17g]", size[0], size[1]);
        write_vector(text, "up", light->numbers.up);
    }
    write_aim(text, light);
    fprintf(text, "}");
}

/* `mesh`: NULL, or the file that a box is read from. */
static void write_body(FILE *text, const struct draft_light *light, const char *mesh)
{
    static const char *const bodies[] = {"box", "sphere", "cylinder"};
    const double *size = light->numbers.size, *center = light->numbers.place;
    const unsigned shape = light->words.shape;
    if (mesh && shape == DRAFT_BOX) {
        fprintf(text, ", mesh: \"%s\"", mesh);
        return;
    }
    fprintf(text, ", %s: {center: [%.17g, %.17g, %.17g]", bodies[shape], center[0], center[1], center[2]);
    if (shape == DRAFT_BOX)
        write_vector(text, "size", size);
    else
        fprintf(text, ", radius: %.17g", size[0]);
    if (shape == DRAFT_CYLINDER) {
        fprintf(text, ", height: %.17g", size[1]);
        write_vector(text, "axis", light->numbers.towards);
    }
    if (shape != DRAFT_BOX && light->words.facets)
        fprintf(text, ", facets: %u", light->words.facets);
    fprintf(text, "}");
}

static void write_extended(FILE *text, const struct draft_light *light, const char *mesh)
{
    static const char *const measures[] = {"radiance", "power", "intensity"};
    if (light->words.type == DRAFT_PLANAR)
        write_outline(text, light);
    else
        write_body(text, light, mesh);
    fprintf(text, ", %s: %.17g", measures[light->words.measure], light->numbers.strength);
    write_law(text, light);
    if (light->words.parts)
        fprintf(text, ", parts: %u", light->words.parts);
}

static void write_light(FILE *text, const struct draft *draft, const struct draft_light *light)
{
    static const char *const types[] = {"point", "distant", "ambient", "spot", "planar", "volume"};
    const bool is_cloud = light->words.type == DRAFT_POINT && draft->cloud;
    fprintf(text, "  - {type: %s", is_cloud ? "points" : types[light->words.type]);
    switch ((enum draft_light_type)light->words.type) {
    case DRAFT_POINT: write_point(text, light, draft->cloud); break;
    case DRAFT_SPOT: write_spot(text, light); break;
    case DRAFT_DISTANT: write_vector(text, "direction", light->numbers.towards); /* fall through */
    case DRAFT_AMBIENT: fprintf(text, ", irradiance: %.17g", light->numbers.strength); break;
    case DRAFT_PLANAR:
    case DRAFT_VOLUME: write_extended(text, light, draft->mesh); break;
    }
    fprintf(text, "}\n");
}

static void write_grid(FILE *text, const struct draft_grid *grid)
{
    const struct draft_grid_numbers *numbers = &grid->numbers;
    fprintf(text, "grids:\n  - {n: [%u, %u]", grid->words.columns, grid->words.rows);
    write_vector(text, "center", numbers->center);
    fprintf(text, ", size: [%.17g, %.17g]", numbers->size[0], numbers->size[1]);
    write_vector(text, "axis", numbers->axis);
    write_vector(text, "up", numbers->up);
    fprintf(text, "}\n");
}

/* A cloud stands where the first of its points does. */
static void write_lights(FILE *text, const struct draft *draft)
{
    bool has_cloud = false;
    fprintf(text, draft->light_count ? "lights:\n" : "lights: []\n");
    for (size_t i = 0; i < draft->light_count; i++) {
        const bool is_in_cloud = draft->cloud && draft->lights[i].words.type == DRAFT_POINT;
        if (!(is_in_cloud && has_cloud))
            write_light(text, draft, &draft->lights[i]);
        has_cloud = has_cloud || is_in_cloud;
    }
}

char *draft_write(const struct draft *draft)
{
    char *made;
    size_t length;
    FILE *text = open_memstream(&made, &length);
    if (!text)
        abort();
    const struct draft_words *words = &draft->words;
    const double pitch = draft->numbers.pitch;
    fprintf(text, "luxel: 1\nshadows: %s\n", words->no_shadows ? "none" : "points");
    fprintf(text, "screen: {width: %.17g, height: %.17g, resolution: [%u, %u], sampling: %s}\n", pitch * words->columns,
            pitch * words->rows, words->columns, words->rows, words->nodes ? "nodes" : "centers");
    fprintf(text, "observer: {z: %.17g, projection: %s, view: %s}\nsurfaces:\n", draft->numbers.observer_z,
            words->perspective ? "perspective" : "orthographic", words->from_observer ? "observer" : "parallel");
    for (size_t i = 0; i < draft->surface_count; i++)
        write_surface(text, &draft->surfaces[i]);
    write_lights(text, draft);
    if (draft->grid.words.columns && draft->grid.words.rows)
        write_grid(text, &draft->grid);
    if (fclose(text))
        abort();
    return made;
}

/* ---- turning ---- */

static void turn_vector(double v[3], struct draft_map map)
{
    const double x = v[0], y = v[1];
    /* without 0 x, which would make -0 or, of infinities, no number */
    v[0] = map.xx ? map.xx * x : map.xy * y;
    v[1] = map.yx ? map.yx * x : map.yy * y;
}

/* Corners are counter-clockwise as seen from the lit side, and a mirror makes them clockwise. */
static void turn_corners(struct draft_light *light, struct draft_map map)
{
    double turned[DRAFT_CORNERS][3];
    const unsigned count = light->words.corners;
    const bool mirrors = map.xx * map.yy - map.xy * map.yx < 0;
    for (unsigned i = 0; i < count; i++) {
        memcpy(turned[i], light->numbers.corners[mirrors ? count - 1 - i : i], sizeof turned[i]);
        turn_vector(turned[i], map);
    }
    memcpy(light->numbers.corners, turned, count * sizeof *turned);
}

static void turn_light(struct draft_light *light, struct draft_map map)
{
    double *size = light->numbers.size;
    turn_vector(light->numbers.place, map);
    turn_vector(light->numbers.towards, map);
    turn_vector(light->numbers.up, map);
    turn_corners(light, map);
    if (map.xy && light->words.type == DRAFT_VOLUME && light->words.shape == DRAFT_BOX) {
        const double along_x = size[0];
        size[0] = size[1];
        size[1] = along_x;
    }
}

void draft_turn(struct draft *draft, struct draft_map map)
{
    for (size_t i = 0; i < draft->surface_count; i++) {
        struct draft_surface_numbers *numbers = &draft->surfaces[i].numbers;
        turn_vector(numbers->center, map);
        turn_vector(numbers->axis, map);
        turn_vector(numbers->up, map);
    }
    for (size_t i = 0; i < draft->light_count; i++)
        turn_light(&draft->lights[i], map);
    turn_vector(draft->grid.numbers.center, map);
    turn_vector(draft->grid.numbers.axis, map);
    turn_vector(draft->grid.numbers.up, map);
    if (map.xy) {
        const unsigned columns = draft->words.columns;
        draft->words.columns = draft->words.rows;
        draft->words.rows = columns;
    }
}
