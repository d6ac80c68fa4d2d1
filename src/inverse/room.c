/* SPDX-License-Identifier: MIT */
/*
 * Scenes of rooms to begin a design with: the text of one, what an array gives on its work plane, and the least even
 * one that reaches a target, as layouts are searched.  What is written is computed from that very text.
 */
#include <luxel/room.h>

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/arrange.h>
#include <luxel/glare.h>
#include <luxel/photometry.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../base/text.h"
#include "../scene/tidy.h"

enum { MOST_IN_A_LINE = 1000, MOST_LUMINAIRES = 10000, USUAL_TARGET_LX = 500, PANEL_MM = 600 };
/* Sizes in metres: the greatest room; the free border of the work plane; from luminaires that light the ceiling to it;
 * the height of eyes, and their distance from the wall. */
static const double LARGEST_M = 1000, BORDER_M = 0.5, PENDANT_M = 0.5, EYE_M = 1.2, BACK_M = 0.1;

void luxel_room_init(luxel_room *room)
{
    *room = (luxel_room){.reflectances = {0.7, 0.5, 0.2}, .plane_m = 0.75, .maintenance = 0.8};
}

/* A design in the making. */
struct designing {
    const luxel_room *room;
    const char *path;
    const luxel_settings *settings;
    luxel_diagnostics *diagnostics;
    double height_mm; /* of the luminaires */
    double target;    /* 0: none */
};

/* What the scene is to keep; 0: no such limit. */
struct promise {
    double average, uniformity, ugr[2];
};

/* ---- the text ---- */

/* Lengths of scenes: metres as mm, to a hundredth, which is what people write. */
static double as_mm(double metres)
{
    return round(metres * 1e5) / 100 + 0.0;
}

static void add_numbers(struct lx_text *text, const double *numbers, size_t count)
{
    char number[LX_NUMBER_SIZE];
    lx_text_puts(text, "[");
    for (size_t i = 0; i < count; i++)
        lx_text_printf(text, "%s%s", i > 0 ? ", " : "", lx_write_number(numbers[i], number));
    lx_text_puts(text, "]");
}

static void add_key(struct lx_text *text, const char *before, const double *numbers, size_t count, const char *behind)
{
    lx_text_puts(text, before);
    add_numbers(text, numbers, count);
    lx_text_puts(text, behind);
}

static void add_material(struct lx_text *text, const char *key, double reflectance)
{
    char number[LX_NUMBER_SIZE];
    lx_text_printf(text, "%s: {model: lambert, over_pi: true, diffuse: %s}\n", key,
                   lx_write_number(reflectance, number));
}

/* Somebody in a corner looks into the room; the screen stands where he looks. */
static void add_view(struct lx_text *text, const double size_m[3])
{
    const double position[3] = {-0.45 * size_m[0], -0.45 * size_m[1], 0.6 * size_m[2]};
    const double target[3] = {0.1 * size_m[0], 0.1 * size_m[1], 0.4 * size_m[2]};
    const double away = sqrt(pow(target[0] - position[0], 2) + pow(target[1] - position[1], 2));
    const double width = 0.3 * fmax(round(5 * away), 1); /* so that pixels of 600 × 400 are square and round */
    const double screen[2] = {as_mm(width), as_mm(width / 1.5)};
    char first[LX_NUMBER_SIZE], second[LX_NUMBER_SIZE];
    lx_text_printf(text, "screen: {width: %s, height: %s, resolution: [600, 400]}\n", lx_write_number(screen[0], first),
                   lx_write_number(screen[1], second));
    add_key(text, "observer: {position: ", (const double[]){as_mm(position[0]), as_mm(position[1]), as_mm(position[2])},
            3, "");
    add_key(text, ", target: ", (const double[]){as_mm(target[0]), as_mm(target[1]), as_mm(target[2])}, 3,
            ",\n  up: [0, 0, 1], projection: perspective}\n");
}

static void add_surfaces(struct lx_text *text, const luxel_room *room)
{
    const double *size = room->size_m;
    add_key(text, "surfaces:\n  - type: room\n    name: room\n    center: ", (const double[]){0, 0, as_mm(size[2] / 2)},
            3, "\n");
    add_key(text, "    size: ", (const double[]){as_mm(size[0]), as_mm(size[1]), as_mm(size[2])}, 3, "\n    up: z\n");
    add_material(text, "    material", room->reflectances[1]);
    lx_text_puts(text, "    materials:\n");
    add_material(text, "      ceiling", room->reflectances[0]);
    add_material(text, "      floor", room->reflectances[2]);
}

static void add_lights(struct lx_text *text, const struct designing *designing, const unsigned n[2])
{
    const luxel_room *room = designing->room;
    const double place[3] = {0, 0, designing->height_mm};
    lx_text_printf(
        text, "lights:\n  # %u × %u: columns along x, rows along y, the outer ones half a spacing from the walls\n",
        n[0], n[1]);
    if (room->file) {
        lx_text_puts(text, "  - type: luminaire\n    name: luminaires\n    file: ");
        lx_write_key(text, room->file, false);
        add_key(text, "\n    position: ", place, 3, "\n");
    } else {
        lx_text_printf(text,
                       "  # Panels that shine by Lambert's law; for a luminaire: type: luminaire, file, position\n"
                       "  - type: planar\n    name: panels\n    power: %d\n",
                       LUXEL_PANEL_LUMENS);
        add_key(text, "    rectangle: {center: ", place, 3, ", ");
        lx_text_printf(text, "size: [%d, %d]}\n", PANEL_MM, PANEL_MM);
    }
    lx_text_printf(text, "    array: {n: [%u, %u], ", n[0], n[1]);
    add_key(text, "spacing: ", (const double[]){as_mm(room->size_m[0] / n[0]), as_mm(room->size_m[1] / n[1])}, 2,
            "}\n");
}

/* The work plane keeps a border free where the room is wide enough to leave as much between them. */
static double width_of_plane(double room_m)
{
    return room_m >= 4 * BORDER_M ? room_m - 2 * BORDER_M : room_m;
}

static void add_grid(struct lx_text *text, const luxel_room *room, const struct promise *promise)
{
    const double size[2] = {as_mm(width_of_plane(room->size_m[0])), as_mm(width_of_plane(room->size_m[1]))};
    const bool has_border = size[0] < as_mm(room->size_m[0]) || size[1] < as_mm(room->size_m[1]);
    char number[LX_NUMBER_SIZE];
    lx_text_printf(text, "grids:\n  # The work plane%s, with the spacing of EN 12464-1\n  - name: work plane\n",
                   has_border ? " but for a border of 0.5 m" : "");
    add_key(text, "    center: ", (const double[]){0, 0, as_mm(room->plane_m)}, 3, "\n");
    add_key(text, "    size: ", size, 2, "\n    spacing: en12464\n");
    if (promise->average > 0 || promise->uniformity > 0) {
        lx_text_puts(text, "    limits: {");
        if (promise->average > 0)
            lx_text_printf(text, "average: %s", lx_write_number(promise->average, number));
        if (promise->uniformity > 0)
            lx_text_printf(text, "%suniformity: %s", promise->average > 0 ? ", " : "",
                           lx_write_number(promise->uniformity, number));
        lx_text_puts(text, "}\n");
    }
}

/* Two observers sit before the middles of walls and look across the room. */
static void make_sight(const luxel_room *room, int i, luxel_glare_sight *sight)
{
    *sight = (luxel_glare_sight){.eye_mm = {0, 0, as_mm(EYE_M)}};
    sight->eye_mm[i == 0 ? 0 : 1] = -as_mm(room->size_m[i == 0 ? 0 : 1] / 2 - BACK_M);
    sight->view[i == 0 ? 0 : 1] = 1;
}

static bool has_observers(const struct designing *designing)
{
    const double *size = designing->room->size_m;
    return designing->height_mm > as_mm(EYE_M) && size[0] > 4 * BACK_M && size[1] > 4 * BACK_M;
}

static void add_observers(struct lx_text *text, const struct designing *designing, const struct promise *promise)
{
    static const char *const names[] = {"along x", "along y"};
    char number[LX_NUMBER_SIZE];
    if (!has_observers(designing))
        return;
    lx_text_puts(text, "observers:\n  # Seated before the middles of two walls\n");
    for (int i = 0; i < 2; i++) {
        luxel_glare_sight sight;
        make_sight(designing->room, i, &sight);
        lx_text_printf(text, "  - {name: %s, ", names[i]);
        add_key(text, "eye: ", sight.eye_mm, 3, ", ");
        add_key(text, "view: ", sight.view, 3, "");
        if (promise->ugr[i] > 0)
            lx_text_printf(text, ", limits: {ugr: %s}", lx_write_number(promise->ugr[i], number));
        lx_text_puts(text, "}\n");
    }
}

static void add_found(struct lx_text *text, const struct designing *designing, const luxel_room_design *design)
{
    const luxel_room_array *smaller = &design->smaller;
    char average[LX_NUMBER_SIZE], target[LX_NUMBER_SIZE];
    if (!(designing->target > 0) || designing->room->array[0] > 0)
        return;
    lx_text_printf(text, "# %u × %u luminaires are the fewest in a regular array for %s lx on the work plane: %s lx",
                   design->chosen.n[0], design->chosen.n[1], lx_write_number(designing->target, target),
                   lx_write_digits(design->chosen.average.value, 4, average));
    if (smaller->n[0] > 0)
        lx_text_printf(text, ";\n# %u × %u give %s lx", smaller->n[0], smaller->n[1],
                       lx_write_digits(smaller->average.value, 4, average));
    lx_text_puts(text, "\n");
}

static char *write_scene(const struct designing *designing, const luxel_room_design *design,
                         const struct promise *promise)
{
    const luxel_room *room = designing->room;
    struct lx_text text = {0};
    char x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE], z[LX_NUMBER_SIZE], number[LX_NUMBER_SIZE];
    lx_text_printf(&text, "# A room of %s × %s m, %s m high\n", lx_write_number(room->size_m[0], x),
                   lx_write_number(room->size_m[1], y), lx_write_number(room->size_m[2], z));
    add_found(&text, designing, design);
    lx_text_printf(&text,
                   "# Lengths are in mm, z is up, and the middle of the floor is the origin\n"
                   "luxel: 1\nunits: photometric\nreflections: all\n"
                   "maintenance_factor: %s  # of all luminaires: values are maintained ones\n",
                   lx_write_number(room->maintenance, number));
    add_view(&text, room->size_m);
    add_surfaces(&text, room);
    add_lights(&text, designing, design->chosen.n);
    add_grid(&text, room, promise);
    add_observers(&text, designing, promise);
    return lx_text_take(&text);
}

/* ---- what an array gives ---- */

static luxel_status open_scene(const struct designing *designing, const luxel_room_design *design, luxel_scene **scene)
{
    luxel_diagnostics *diagnostics = designing->diagnostics;
    char *text = write_scene(designing, design, &(struct promise){.average = 0});
    if (!text)
        return lx_out_of_memory(diagnostics);
    luxel_status status = luxel_scene_read_text(text, strlen(text), "room", diagnostics, scene);
    free(text);
    if (status == LUXEL_OK && designing->path)
        status = luxel_scene_set_folder_of(*scene, designing->path);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(*scene, diagnostics);
    return status;
}

/* Where U0 lies at least. */
static double least_uniformity(const luxel_grid *grid)
{
    const double most = grid->average.value + grid->average.error;
    return most > 0 ? (grid->minimum.value - grid->error) / most * (1 - 8 * DBL_EPSILON) : 0;
}

static luxel_status measure(const struct designing *designing, const luxel_scene *scene, luxel_room_array *array,
                            double *uniformity)
{
    luxel_grid *grid = NULL;
    const luxel_status status = luxel_find_grid_values(scene, designing->settings, 0, designing->diagnostics, &grid);
    if (status == LUXEL_OK) {
        array->average = grid->average;
        array->uniformity = grid->u0;
        *uniformity = least_uniformity(grid);
    }
    luxel_grid_free(grid);
    return status;
}

/* ---- the search ---- */

enum { AVERAGE, UNIFORMITY }; /* the limits that a layout is asked for */

static luxel_room_array array_of(const luxel_layout *layout)
{
    return (luxel_room_array){.n = {layout->n[0], layout->n[1]},
                              .average = layout->limits[AVERAGE].limit.value,
                              .uniformity = layout->limits[UNIFORMITY].limit.value.value};
}

/* The more uniform one of the layouts that are smallest: they come by rising numbers. */
static const luxel_layout *choose(const luxel_arrangement *found)
{
    const luxel_layout *best = &found->found[0];
    for (size_t i = 1; i < found->count; i++)
        if (found->found[i].n[0] * found->found[i].n[1] == found->found[0].n[0] * found->found[0].n[1] &&
            array_of(&found->found[i]).uniformity > array_of(best).uniformity)
            best = &found->found[i];
    return best;
}

/* The largest of the layouts that miss the target, of equal ones that which gives most: they come by what they give. */
static const luxel_layout *next_smaller(const luxel_arrangement *found)
{
    const luxel_layout *largest = NULL;
    for (size_t i = 0; i < found->missed_count; i++)
        if (!largest || found->missed[i].n[0] * found->missed[i].n[1] > largest->n[0] * largest->n[1])
            largest = &found->missed[i];
    return largest;
}

static luxel_status search(const struct designing *designing, luxel_room_design *design)
{
    luxel_scene *scene = NULL;
    luxel_arrangement *found = NULL;
    char target[LX_NUMBER_SIZE], goal[LX_NUMBER_SIZE + 16], number[LX_NUMBER_SIZE];
    snprintf(goal, sizeof goal, "average>=%s", lx_write_number(designing->target, target));
    /* any uniformity will do, but which it is has to be told */
    const char *const goals[] = {goal, "U0>=1e-9"};
    const luxel_arranging wanted = {.goals = goals, .goal_count = 2, .is_even = true, .most = MOST_LUMINAIRES};
    luxel_status status = open_scene(designing, &(luxel_room_design){.chosen = {.n = {1, 1}}}, &scene);
    if (status == LUXEL_OK)
        status = luxel_arrange(scene, designing->settings, &wanted, designing->diagnostics, &found);
    if (status == LUXEL_OK && found->count == 0)
        status = lx_refuse(designing->diagnostics, LX_MSG_ROOM_TOO_MANY,
                           LX_ARGS(lx_write_number(MOST_LUMINAIRES, number), target));
    if (status == LUXEL_OK) {
        const luxel_layout *smaller = next_smaller(found);
        design->chosen = array_of(choose(found)); /* which is measured again with the scene */
        if (smaller)
            design->smaller = array_of(smaller);
    }
    luxel_arrangement_free(found);
    luxel_scene_free(scene);
    return status;
}

/* ---- what is promised ---- */

/* The greatest step that is no more than a value; 0: none. */
static double step_below(const double *steps, size_t count, double value)
{
    double step = 0;
    for (size_t i = 0; i < count && steps[i] <= value; i++)
        step = steps[i];
    return step;
}

/* The least class of glare that holds a rating; 0: none. */
static double class_of(const luxel_glare *glare)
{
    static const double classes[] = {13, 16, 19, 22, 25, 28};
    for (size_t i = 0; i < sizeof classes / sizeof *classes && glare->has_rating; i++)
        if (glare->rating.value + glare->rating.error <= classes[i])
            return classes[i];
    return 0;
}

/* The limits that the scene keeps: the target, and the steps of EN 12464-1 that it reaches. */
static luxel_status make_promise(const struct designing *designing, luxel_room_design *design, struct promise *promise)
{
    static const double illuminances[] = {5,   7.5, 10,  15,  20,   30,   50,   75,   100,  150,
                                          200, 300, 500, 750, 1000, 1500, 2000, 3000, 5000, 7500};
    static const double uniformities[] = {0.1, 0.4, 0.6, 0.7, 0.8};
    luxel_scene *scene = NULL;
    double uniformity = 0;
    luxel_status status = open_scene(designing, design, &scene);
    if (status == LUXEL_OK)
        status = measure(designing, scene, &design->chosen, &uniformity);
    const luxel_bounded *average = &design->chosen.average;
    promise->average = designing->target > 0 ? designing->target
                                             : step_below(illuminances, sizeof illuminances / sizeof *illuminances,
                                                          average->value - average->error);
    promise->uniformity = step_below(uniformities, sizeof uniformities / sizeof *uniformities, uniformity);
    for (int i = 0; i < 2 && status == LUXEL_OK && has_observers(designing); i++) {
        luxel_glare *glare = NULL;
        luxel_glare_sight sight;
        make_sight(designing->room, i, &sight);
        status = luxel_find_glare(scene, designing->settings, &sight, designing->diagnostics, &glare);
        promise->ugr[i] = glare ? class_of(glare) : 0;
        luxel_glare_free(glare);
    }
    luxel_scene_free(scene);
    return status;
}

/* ---- what is asked ---- */

static luxel_status check_room(const luxel_room *room, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    char numbers[3][LX_NUMBER_SIZE];
    bool has_size = true, reflects = true;
    for (int i = 0; i < 3; i++) {
        has_size = has_size && room->size_m[i] > 0 && room->size_m[i] <= LARGEST_M;
        reflects = reflects && room->reflectances[i] >= 0 && room->reflectances[i] < 1;
        lx_write_number(room->size_m[i], numbers[i]);
    }
    if (!has_size)
        status = lx_refuse(diagnostics, LX_MSG_ROOM_SIZE, LX_ARGS(numbers[0], numbers[1], numbers[2]));
    else if (!(room->plane_m >= 0 && room->plane_m < room->size_m[2]))
        status =
            lx_refuse(diagnostics, LX_MSG_ROOM_PLANE, LX_ARGS(lx_write_number(room->plane_m, numbers[0]), numbers[2]));
    if (!reflects)
        status = lx_refuse(diagnostics, LX_MSG_ROOM_REFLECTANCES, NULL);
    if (!(room->maintenance > 0 && room->maintenance <= 1))
        status = lx_refuse(diagnostics, LX_MSG_ROOM_MAINTENANCE, NULL);
    if (room->array[0] > MOST_IN_A_LINE || room->array[1] > MOST_IN_A_LINE ||
        (room->array[0] == 0) != (room->array[1] == 0))
        status = lx_refuse(diagnostics, LX_MSG_ROOM_ARRAY, NULL);
    if (!(room->target >= 0 && isfinite(room->target)))
        status = lx_refuse(diagnostics, LX_MSG_ROOM_TARGET, NULL);
    return status;
}

/* The file's flux upwards decides how high the luminaires hang. */
static luxel_status find_height(struct designing *designing)
{
    const luxel_room *room = designing->room;
    luxel_photometry *photometry = NULL;
    luxel_photometry_figures figures = {.dff = 100};
    luxel_status status = LUXEL_OK;
    if (room->file) {
        struct lx_text path = {0};
        const char *slash = designing->path ? strrchr(designing->path, '/') : NULL;
        if (slash && room->file[0] != '/' && strncmp(room->file, "builtin:", 8) != 0)
            lx_text_add(&path, designing->path, (size_t)(slash + 1 - designing->path));
        lx_text_puts(&path, room->file);
        status = path.failed ? lx_out_of_memory(designing->diagnostics)
                             : luxel_photometry_read(path.bytes, designing->diagnostics, &photometry);
        lx_text_clear(&path);
        if (status == LUXEL_OK)
            luxel_diagnostics_clear(designing->diagnostics); /* advice about the file */
        if (status == LUXEL_OK && luxel_photometry_find_figures(photometry, &figures) != LUXEL_OK)
            status = lx_out_of_memory(designing->diagnostics);
        luxel_photometry_free(photometry);
    }
    const bool hangs = 100 - figures.dff > LUXEL_ROOM_UPWARDS;
    designing->height_mm =
        as_mm(hangs ? fmax(room->size_m[2] - PENDANT_M, (room->size_m[2] + room->plane_m) / 2) : room->size_m[2]);
    return status;
}

luxel_status luxel_design_room(const luxel_room *room, const char *path, const luxel_settings *settings,
                               luxel_diagnostics *diagnostics, luxel_room_design *design)
{
    if (!room || !design)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(room ? "design" : "room"));
    *design = (luxel_room_design){.text = NULL};
    struct designing designing = {.room = room, .path = path, .settings = settings, .diagnostics = diagnostics};
    struct promise promise = {.average = 0};
    luxel_status status = LX_CHECK_RESERVE(room, diagnostics);
    if (status == LUXEL_OK)
        status = check_room(room, diagnostics);
    if (status == LUXEL_OK)
        status = find_height(&designing);
    if (status != LUXEL_OK)
        return status;
    designing.target = room->target > 0 || room->array[0] > 0 ? room->target : USUAL_TARGET_LX;
    if (room->array[0] > 0)
        memcpy(design->chosen.n, room->array, sizeof design->chosen.n);
    else
        status = search(&designing, design);
    if (status == LUXEL_OK)
        status = make_promise(&designing, design, &promise);
    if (status == LUXEL_OK && !(design->text = write_scene(&designing, design, &promise)))
        status = lx_out_of_memory(diagnostics);
    return status;
}
