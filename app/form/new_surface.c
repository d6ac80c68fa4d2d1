/* SPDX-License-Identifier: MIT */
/* A new surface is put together in a copy of the document, in which is counted how much of the screen shows it. */
#include "new_surface.h"

#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../picture/marks.h"
#include "../picture/picture.h"

enum { PLACES = 24 /* of the screen, across and down, at which is looked what it shows */ };
static const double WANTED = 0.15;     /* radius, of the shorter side of the screen */
static const double ASIDE = 0.3;       /* of the screen, from the first surface */
static const double LEAST_SEEN = 0.02; /* of the places */
static const double GAP_MM = 20, AROUND = 1.25;

static char *key_of(gsize surface, const char *name)
{
    return g_strdup_printf("surfaces[%zu]%s%s", surface, *name ? "." : "", name);
}

static gsize read_key(const AppDocument *document, gsize surface, const char *name, double numbers[3])
{
    gboolean written;
    char *key = key_of(surface, name), *text = app_document_get(document, key, &written);
    const gsize count = text ? app_list_read(text, numbers, 3) : 0;
    g_free(text);
    g_free(key);
    return count;
}

static void write_key(AppDocument *document, gsize surface, const char *name, const double *numbers, gsize count)
{
    char number[APP_NUMBER_SIZE], *key = key_of(surface, name);
    char *text = count == 1 ? g_strdup(app_number_write(*numbers, number)) : app_list_write(numbers, count);
    app_document_set(document, key, text, NULL);
    g_free(text);
    g_free(key);
}

/* The document's scene, committed; NULL where it has faults. */
static luxel_scene *committed(const AppDocument *document)
{
    luxel_scene *scene = app_document_copy_scene(document);
    if (scene)
        app_scene_leave_direct(scene); /* what is asked of it needs no other light */
    if (scene && luxel_scene_commit(scene, NULL) == LUXEL_OK)
        return scene;
    luxel_scene_free(scene);
    return NULL;
}

static void screen_of(const AppDocument *document, double size[2])
{
    size[0] = app_document_get_number(document, "screen.width");
    size[1] = app_document_get_number(document, "screen.height");
}

/* Which share of the screen shows each of two surfaces; FALSE: the scene has faults. */
static gboolean look(const AppDocument *document, const gsize surfaces[2], double seen[2])
{
    luxel_scene *scene = committed(document);
    luxel_evaluator *evaluator = NULL;
    double size[2];
    screen_of(document, size);
    seen[0] = seen[1] = 0;
    const gboolean done = scene && luxel_evaluator_new(scene, NULL, NULL, &evaluator) == LUXEL_OK;
    for (int i = 0; done && i < PLACES * PLACES; i++) {
        const double x = ((i % PLACES + 0.5) / PLACES - 0.5) * size[0];
        const double y = ((double)(i / PLACES) + 0.5) / PLACES - 0.5;
        luxel_value value;
        luxel_trace_screen(evaluator, x, y * size[1], &value);
        for (int k = 0; k < 2; k++)
            seen[k] += value.on_surface && value.surface == surfaces[k] ? 1.0 / (PLACES * PLACES) : 0;
    }
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
    return done;
}

/* The surface as large as suits the screen; its radius. */
static double suit(AppDocument *trial, gsize surface)
{
    static const char *const lengths[] = {"radius", "height", "size"};
    double screen[2], radius = 0;
    luxel_scene *scene = committed(trial);
    screen_of(trial, screen);
    if (scene)
        luxel_scene_surface_radius(scene, surface, &radius);
    luxel_scene_free(scene);
    if (!(radius > 0))
        return 0;
    const double factor = WANTED * MIN(screen[0], screen[1]) / radius;
    for (gsize i = 0; i < G_N_ELEMENTS(lengths); i++) {
        double numbers[3];
        char text[APP_NUMBER_SIZE];
        const gsize count = read_key(trial, surface, lengths[i], numbers);
        for (gsize k = 0; k < count; k++)
            numbers[k] = g_ascii_strtod(app_number_plain(factor * numbers[k], 2, text), NULL);
        if (count > 0)
            write_key(trial, surface, lengths[i], numbers, count);
    }
    return factor * radius;
}

/* The middle of the first surface and how far up it reaches. */
static double first_surface(const AppDocument *document, double center[3])
{
    luxel_scene *scene = committed(document);
    double radius = 0;
    memset(center, 0, 3 * sizeof *center);
    if (scene && luxel_scene_surface_count(scene) > 0) {
        luxel_scene_surface_place(scene, 0, center);
        double numbers[3];
        /* a flat one does not reach up */
        if (read_key(document, 0, "radius", numbers) == 1 || read_key(document, 0, "file", numbers) > 0)
            luxel_scene_surface_radius(scene, 0, &radius);
    }
    luxel_scene_free(scene);
    return center[2] + radius;
}

/* Whether another surface than the first has its middle where a new one would come to lie. */
static gboolean is_taken(const luxel_scene *scene, const double place[3], gsize surface, double radius)
{
    for (gsize i = 1; scene && i < surface; i++) {
        double other[3], apart = 0;
        if (luxel_scene_surface_place(scene, i, other) != LUXEL_OK)
            continue;
        for (int k = 0; k < 3; k++)
            apart += (other[k] - place[k]) * (other[k] - place[k]);
        if (sqrt(apart) < 1.5 * radius)
            return TRUE;
    }
    return FALSE;
}

/*
 * Beside the first surface at its height, before it, below the observer: the first place where both are seen, else the
 * one where the new one is seen best.
 */
static void stand(AppDocument *trial, gsize surface, double radius)
{
    static const double sides[][2] = {{ASIDE, 0}, {-ASIDE, 0}, {0, -ASIDE}, {0, ASIDE}, {0, 0}};
    double center[3], screen[2], best[3] = {0}, most = -1;
    const double top = first_surface(trial, center), observer = app_document_get_number(trial, "observer.z");
    const double heights[] = {center[2], top + GAP_MM + radius, observer - GAP_MM - radius};
    const gsize both[2] = {surface, 0};
    luxel_scene *before = committed(trial);
    screen_of(trial, screen);
    for (gsize i = 0; i < G_N_ELEMENTS(heights) * G_N_ELEMENTS(sides); i++) {
        const double *side = sides[i % G_N_ELEMENTS(sides)];
        const double place[3] = {round(center[0] + side[0] * screen[0]), round(center[1] + side[1] * screen[1]),
                                 round(heights[i / G_N_ELEMENTS(sides)])};
        double seen[2];
        if (is_taken(before, place, surface, radius))
            continue;
        write_key(trial, surface, "center", place, 3);
        if (!look(trial, both, seen))
            continue;
        if (seen[0] > most) {
            most = seen[0];
            memcpy(best, place, sizeof best);
        }
        if (seen[0] >= LEAST_SEEN && seen[1] >= LEAST_SEEN) {
            memcpy(best, place, sizeof best);
            break;
        }
    }
    luxel_scene_free(before);
    if (most >= 0)
        write_key(trial, surface, "center", best, 3);
}

/* A room around the lights, the observer and what the first surface takes. */
static void enclose(AppDocument *trial, gsize room)
{
    double center[3], reach[3], screen[2], place[3];
    const double top = first_surface(trial, center);
    luxel_scene *scene = committed(trial);
    screen_of(trial, screen);
    for (int k = 0; k < 2; k++)
        reach[k] = MAX(screen[k], top - center[2]);
    reach[2] = MAX(fabs(app_document_get_number(trial, "observer.z") - center[2]), top - center[2]);
    for (gsize i = 0; scene && i < luxel_scene_light_count(scene); i++)
        for (int k = 0; k < 3 && luxel_scene_light_place(scene, i, place); k++)
            reach[k] = MAX(reach[k], fabs(place[k] - center[k]));
    for (int k = 0; k < 3; k++)
        reach[k] = ceil(2 * AROUND * reach[k] / 100) * 100;
    luxel_scene_free(scene);
    write_key(trial, room, "center", center, 3);
    write_key(trial, room, "size", reach, 3);
}

static const char *example_of(const luxel_parameters *parameters, const char *name)
{
    for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++) {
        const luxel_parameter_kind *kind = luxel_parameters_kind(parameters, i);
        if (strcmp(kind->list, "surfaces") == 0 && strcmp(kind->name, name) == 0)
            return kind->example;
    }
    return NULL;
}

char *app_new_surface(const AppDocument *document, const luxel_parameters *parameters, const char *kind)
{
    const gsize surface = app_document_size(document, "surfaces");
    const char *example = example_of(parameters, kind);
    const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "surfaces", .value = example, .index = surface};
    AppDocument *trial = app_document_copy(document);
    char *key = key_of(surface, ""), *yaml = NULL;
    if (example && app_document_edit(trial, &edit, 1, NULL, NULL)) {
        if (strcmp(kind, "room") == 0)
            enclose(trial, surface);
        else
            stand(trial, surface, suit(trial, surface));
        yaml = app_document_get(trial, key, NULL);
    }
    g_object_unref(trial);
    g_free(key);
    return yaml;
}

char *app_doubled_surface(const AppDocument *document, gsize chosen)
{
    const gsize surface = app_document_size(document, "surfaces"), both[2] = {surface, chosen};
    static const double sides[] = {ASIDE, -ASIDE, ASIDE / 3};
    char *key = key_of(chosen, ""), *yaml = app_document_get(document, key, NULL);
    double screen[2], center[3];
    luxel_scene *scene = committed(document);
    gboolean found = FALSE;
    screen_of(document, screen);
    const gboolean placed = scene && luxel_scene_surface_place(scene, chosen, center) == LUXEL_OK;
    luxel_scene_free(scene);
    for (gsize i = 0; yaml && placed && !found && i < G_N_ELEMENTS(sides); i++) {
        const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "surfaces", .value = yaml, .index = surface};
        const AppMark mark = {
            .kind = APP_MARK_SURFACE, .index = surface, .is_on = TRUE, .place_mm = {center[0], center[1], center[2]}};
        const double step[3] = {round(sides[i] * screen[0])};
        double seen[2];
        char *whole = key_of(surface, "");
        AppDocument *trial = app_document_copy(document);
        if (app_document_edit(trial, &edit, 1, NULL, NULL) && app_mark_shift(&mark, step, trial) &&
            look(trial, both, seen) && seen[0] >= LEAST_SEEN) {
            found = TRUE;
            g_free(yaml);
            yaml = app_document_get(trial, whole, NULL);
        }
        g_object_unref(trial);
        g_free(whole);
    }
    g_free(key);
    return yaml;
}
