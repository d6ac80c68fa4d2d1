/* SPDX-License-Identifier: MIT */
/* Where marks are, and from motions on the screen to numbers in the scene. */
#include "marks.h"

#include <math.h>
#include <string.h>

#include "../base/geometry.h"
#include "../base/number.h"
#include "../base/scalar.h"
#include "measures.h"

static const double FINE = 0.1;

/* What a scene has; the caller's. */
static char *value_of(const luxel_scene *scene, const char *key)
{
    char *text = NULL;
    if (luxel_scene_get(scene, key, NULL, NULL, &text) != LUXEL_OK)
        text = NULL;
    char *copy = g_strdup(text);
    luxel_text_free(text);
    return copy;
}

/* Half the shorter side of the screen: the radius of the disk on which distant light is marked. */
static double dome_radius(const AppDocument *document)
{
    const double width = app_document_get_number(document, "screen.width");
    const double height = app_document_get_number(document, "screen.height");
    return 0.5 * MIN(width, height);
}

/* ---- where they are ---- */

/* As wide as half of the shorter side of the moment's screen. */
static double dome_of(const luxel_scene *scene)
{
    char *width = value_of(scene, "screen.width"), *height = value_of(scene, "screen.height");
    const double radius = 0.5 * MIN(width ? g_ascii_strtod(width, NULL) : 0, height ? g_ascii_strtod(height, NULL) : 0);
    g_free(width);
    g_free(height);
    return radius;
}

/* "2 fill", of a source without a name "2"; as many whole letters as there is room for. */
static void label_light(const luxel_scene *scene, gsize i, AppMark *mark)
{
    char key[64];
    g_snprintf(key, sizeof key, "lights[%zu].name", i);
    char *yaml = value_of(scene, key), *name = yaml ? app_yaml_unquote(yaml) : g_strdup("");
    char *label = g_strdup_printf("%zu%s%s", i + 1, *name ? " " : "", name);
    gsize size = strlen(label);
    if (size >= sizeof mark->label)
        size = (gsize)(g_utf8_find_prev_char(label, label + sizeof mark->label) - label);
    memcpy(mark->label, label, size);
    mark->label[size] = '\0';
    g_free(label);
    g_free(name);
    g_free(yaml);
}

static gboolean mark_light(const AppMoment *moment, gsize i, AppMark *mark)
{
    double direction[3];
    *mark = (AppMark){.kind = APP_MARK_SOURCE, .index = i, .is_on = app_moment_is_on(moment, i)};
    label_light(moment->scene, i, mark);
    if (luxel_scene_light_place(moment->scene, i, mark->place_mm))
        return luxel_scene_project(moment->scene, mark->place_mm, mark->screen_mm);
    if (!luxel_scene_light_direction(moment->scene, i, direction))
        return FALSE;
    const double radius = dome_of(moment->scene);
    mark->is_distant = TRUE;
    mark->is_behind = direction[2] > 0;
    for (int k = 0; k < 3; k++)
        mark->place_mm[k] = -direction[k];
    mark->screen_mm[0] = -direction[0] * radius;
    mark->screen_mm[1] = -direction[1] * radius;
    return TRUE;
}

GArray *app_marks_of(const AppMoment *moment)
{
    GArray *marks = g_array_new(FALSE, TRUE, sizeof(AppMark));
    const luxel_scene *scene = moment->scene;
    AppMark mark;
    for (gsize i = 0; i < luxel_scene_surface_count(scene); i++) {
        mark = (AppMark){.kind = APP_MARK_SURFACE, .index = i};
        if (luxel_scene_surface_place(scene, i, mark.place_mm) == LUXEL_OK &&
            luxel_scene_project(scene, mark.place_mm, mark.screen_mm))
            g_array_append_val(marks, mark);
    }
    for (gsize i = 0; i < MIN(luxel_scene_light_count(scene), APP_MOST_POINTS); i++)
        if (mark_light(moment, i, &mark))
            g_array_append_val(marks, mark);
    for (gsize i = 0; i < MIN(luxel_scene_point_count(scene), APP_MOST_POINTS); i++) {
        mark = (AppMark){.kind = APP_MARK_POINT, .index = i};
        g_snprintf(mark.label, sizeof mark.label, "P%zu", i + 1);
        luxel_scene_point(scene, i, &mark.screen_mm[0], &mark.screen_mm[1]);
        memcpy(mark.place_mm, mark.screen_mm, sizeof mark.screen_mm);
        g_array_append_val(marks, mark);
    }
    return marks;
}

char *app_place_key(const AppDocument *document, AppMarkKind kind, gsize index)
{
    static const char *const places[] = {"position",      "rectangle.center", "disk.center", "box.center",
                                         "sphere.center", "cylinder.center",  "vertices"};
    if (kind == APP_MARK_SURFACE) {
        char *type_key = g_strdup_printf("surfaces[%zu].type", index);
        char *type = app_document_get(document, type_key, NULL);
        const gboolean is_mesh = g_strcmp0(type, "mesh") == 0;
        g_free(type);
        g_free(type_key);
        return g_strdup_printf("surfaces[%zu].%s", index, is_mesh ? "position" : "center");
    }
    if (kind == APP_MARK_POINT)
        return g_strdup_printf("points[%zu]", index);
    for (gsize i = 0; kind == APP_MARK_SOURCE && i < G_N_ELEMENTS(places); i++) {
        gboolean written;
        char *key = g_strdup_printf("lights[%zu].%s", index, places[i]);
        g_free(app_document_get(document, key, &written));
        if (written)
            return key;
        g_free(key);
    }
    return NULL;
}

/* ---- moving them ---- */

/* A power of ten that numbers are rounded to: below what the view resolves. */
static double grain_of(const AppTouch *touch)
{
    double grain = touch->mm_per_pixel * (touch->fine ? FINE : 1);
    return grain > 0 ? pow(10, floor(log10(grain))) : 0;
}

/* A round step of some eight pixels: 1, 2 or 5 times a power of ten. */
static double snap_of(const AppTouch *touch)
{
    double wanted = 8 * touch->mm_per_pixel, power = pow(10, floor(log10(wanted)));
    return wanted / power < 2 ? 2 * power : wanted / power < 5 ? 5 * power : 10 * power;
}

static double round_to(double value, double step)
{
    /* by the inverse, which is a whole number for steps below 1, so that 0.3 is 0.3 */
    return !(step > 0) ? value
           : step < 1  ? round(value * round(1 / step)) / round(1 / step)
                       : round(value / step) * step;
}

static gboolean set_numbers(AppDocument *document, const char *key, const double *numbers, gsize count)
{
    char *list = app_list_write(numbers, count);
    gboolean done = app_document_set(document, key, list, NULL);
    g_free(list);
    return done;
}

/* A polygon is moved with all its corners. */
static gboolean shift_vertices(AppDocument *document, const char *key, const double from[3], const double to[3])
{
    gsize count = app_document_size(document, key);
    double *numbers = g_new0(double, 3 * count + 3);
    char *text = app_document_get(document, key, NULL), number[APP_NUMBER_SIZE];
    GString *value = g_string_new("[");
    gsize found = app_list_read(text, numbers, 3 * count);
    for (gsize i = 0; i < found; i++) {
        g_string_append(value, i % 3 == 0 ? i ? "], [" : "[" : ", ");
        g_string_append(value, app_number_write(round_to(numbers[i] + to[i % 3] - from[i % 3], 1e-6), number));
    }
    g_string_append(value, "]]");
    gboolean done = found == 3 * count && found > 0 && app_document_set(document, key, value->str, NULL);
    g_string_free(value, TRUE);
    g_free(text);
    g_free(numbers);
    return done;
}

/* Whether the key of a surface tells where its file's origin lies, which its mark may be far from. */
static gboolean is_offset(const AppMark *mark, const char *key)
{
    return mark->kind == APP_MARK_SURFACE && g_str_has_suffix(key, ".position");
}

/* A mesh is moved as far as its mark. */
static gboolean shift_offset(AppDocument *document, const char *key, const double from[3], const double to[3])
{
    double now[3] = {0, 0, 0};
    char *text = app_document_get(document, key, NULL);
    app_list_read(text, now, 3);
    g_free(text);
    for (int i = 0; i < 3; i++)
        now[i] = round_to(now[i] + to[i] - from[i], 1e-6);
    return set_numbers(document, key, now, 3);
}

/* Gives a mark its new place, or direction. */
static gboolean put(AppDocument *document, const AppMark *mark, const double place[3])
{
    if (mark->is_distant) {
        char *key = g_strdup_printf("lights[%zu].direction", mark->index);
        const double direction[3] = {-place[0], -place[1], -place[2]};
        gboolean done = set_numbers(document, key, direction, 3);
        g_free(key);
        return done;
    }
    char *key = app_place_key(document, mark->kind, mark->index);
    gboolean done = FALSE;
    if (key && g_str_has_suffix(key, ".vertices"))
        done = shift_vertices(document, key, mark->place_mm, place);
    else if (key && is_offset(mark, key))
        done = shift_offset(document, key, mark->place_mm, place);
    else if (key)
        done = set_numbers(document, key, place, mark->kind == APP_MARK_POINT ? 2 : 3);
    g_free(key);
    return done;
}

/* Where the document has a mark, of which the last picture may be behind it; the mark's own place where that is no list
 * of numbers, as of corners. */
static void find_place(AppDocument *document, const AppMark *mark, double place[3])
{
    const gsize count = mark->kind == APP_MARK_POINT ? 2 : 3;
    double now[3];
    char *key = app_place_key(document, mark->kind, mark->index);
    const gboolean is_place = key && !g_str_has_suffix(key, ".vertices") && !is_offset(mark, key);
    char *text = is_place ? app_document_get(document, key, NULL) : NULL;
    memcpy(place, mark->place_mm, sizeof mark->place_mm);
    if (app_list_read(text, now, count) == count)
        memcpy(place, now, count * sizeof *place);
    g_free(key);
    g_free(text);
}

void app_hand_take(AppHand *hand, const AppMark *mark, const double pointer_mm[2], const double shown_mm[2])
{
    *hand = (AppHand){.mark = *mark, .gain = 1};
    memcpy(hand->start_mm, mark->place_mm, sizeof hand->start_mm);
    for (int k = 0; k < 2; k++) {
        hand->grip_mm[k] = pointer_mm[k] - shown_mm[k]; /* the mark stays under the pointer as it was taken */
        hand->pointer_mm[k] = hand->last_mm[k] = pointer_mm[k];
    }
    double out = hypot(mark->screen_mm[0], mark->screen_mm[1]), shown = hypot(shown_mm[0], shown_mm[1]);
    if (shown > 0 && out > shown * (1 + 1e-9))
        hand->gain = out / shown;
}

/* Where on the dome the pointer is; beyond its rim the light comes from the horizon. */
static void dome_place(const AppHand *hand, const double shown[2], double radius, double snap, double place[3])
{
    double x = shown[0] / radius, y = shown[1] / radius, out = hypot(x, y);
    if (out > 1) {
        x /= out;
        y /= out;
    }
    place[0] = round_to(x, snap > 0 ? 0.05 : 1e-4);
    place[1] = round_to(y, snap > 0 ? 0.05 : 1e-4);
    double z = sqrt(MAX(0, 1 - place[0] * place[0] - place[1] * place[1]));
    place[2] = round_to(hand->mark.is_behind ? -z : z, 1e-4);
    if (place[0] == 0 && place[1] == 0 && place[2] == 0)
        place[2] = 1;
}

/* Motions are collected, so that those with Shift count a tenth from where it was pressed. */
static void follow_pointer(AppHand *hand, const AppTouch *touch)
{
    for (int k = 0; k < 2; k++) {
        hand->pointer_mm[k] += (touch->pointer_mm[k] - hand->last_mm[k]) * (touch->fine ? FINE : 1);
        hand->last_mm[k] = touch->pointer_mm[k];
    }
}

/* From here on the motion up and down changes the height, or no longer does. */
static void change_way(AppHand *hand, const AppTouch *touch)
{
    if (touch->height == hand->was_height)
        return;
    if (touch->height)
        hand->height_grip = hand->pointer_mm[1];
    else {
        hand->start_mm[2] = hand->mark.place_mm[2]; /* as it was rounded */
        hand->grip_mm[1] += hand->pointer_mm[1] - hand->height_grip;
    }
    hand->was_height = touch->height;
}

gboolean app_hand_move(AppHand *hand, const AppTouch *touch, const AppMoment *moment, AppDocument *document)
{
    const double grain = touch->snap ? snap_of(touch) : grain_of(touch);
    double shown[2], place[3];
    gboolean all = FALSE;
    follow_pointer(hand, touch);
    if (hand->mark.kind == APP_MARK_SURFACE || hand->mark.kind == APP_MARK_SOURCE)
        change_way(hand, touch);
    for (int k = 0; k < 2; k++)
        shown[k] = (hand->pointer_mm[k] - hand->grip_mm[k]) * hand->gain;
    if (hand->mark.is_distant) {
        dome_place(hand, shown, dome_radius(document), touch->snap, place);
        return put(document, &hand->mark, place);
    }
    if (hand->was_height) {
        double rise = (hand->pointer_mm[1] - hand->height_grip) * hand->gain;
        find_place(document, &hand->mark, place);
        place[2] = round_to(hand->start_mm[2] + rise, grain * hand->gain);
    } else if (hand->mark.kind == APP_MARK_POINT) {
        memcpy(place, shown, sizeof shown);
    } else {
        /* the height above the screen stays; where perspective makes the place of a pixel depend on it, the moment
         * knows */
        double height;
        if (!luxel_scene_height(moment->scene, hand->start_mm, &height) ||
            !luxel_scene_unproject(moment->scene, shown, height, place))
            return FALSE;
        all = place[2] != hand->start_mm[2]; /* of a screen that stands elsewhere */
    }
    for (int k = 0; k < (all ? 3 : 2) && !hand->was_height; k++)
        place[k] = round_to(place[k], grain * (touch->snap ? 1 : hand->gain > 3 ? 10 : 1));
    gboolean done = put(document, &hand->mark, place);
    if (done)
        memcpy(hand->mark.place_mm, place, sizeof place);
    return done;
}

gboolean app_mark_direction(AppDocument *document, gsize light, double unit[3])
{
    double direction[3];
    char *type_key = g_strdup_printf("lights[%zu].type", light), *key = g_strdup_printf("lights[%zu].direction", light);
    char *type = app_document_get(document, type_key, NULL), *text = app_document_get(document, key, NULL);
    const gboolean is_distant = g_strcmp0(type, "distant") == 0 && app_list_read(text, direction, 3) == 3;
    g_free(type_key);
    g_free(key);
    g_free(type);
    g_free(text);
    return is_distant && app_unit(direction, unit);
}

gboolean app_mark_shift(const AppMark *mark, const double step_mm[3], AppDocument *document)
{
    double place[3];
    if (mark->is_distant) {
        const double radius = dome_radius(document);
        AppHand hand = {.mark = *mark};
        double unit[3];
        if (!app_mark_direction(document, mark->index, unit)) /* the mark may be behind it */
            for (int k = 0; k < 3; k++)
                unit[k] = -mark->place_mm[k];
        const double shown[2] = {step_mm[0] - unit[0] * radius, step_mm[1] - unit[1] * radius};
        dome_place(&hand, shown, radius, 0, place);
        return put(document, mark, place);
    }
    find_place(document, mark, place);
    for (int k = 0; k < 3; k++)
        place[k] = round_to(place[k] + step_mm[k], 1e-6);
    return put(document, mark, place);
}
