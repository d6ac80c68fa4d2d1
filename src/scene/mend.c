/* SPDX-License-Identifier: MIT */
/*
 * Words what mends advice.  A number that lies outside its advised range is brought to its nearest end; the scene must
 * be valid with it, so a copy tries.  The screen's size and resolution are changed together, since pixels are square.
 */
#include "mend.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../parameter/words.h"

enum { MOST_NODES = 5000, ASSIGNMENT_SIZE = 256 };

void lx_mend_add(struct lx_text *text, const char *format, ...)
{
    char words[ASSIGNMENT_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    lx_text_printf(text, "%s-s '%s'", text->length ? " " : "", words);
}

void lx_mend_hint(struct lx_walk *walk, struct lx_text *text)
{
    walk->out_of_memory = walk->out_of_memory || text->failed;
    if (text->length && !text->failed)
        lx_hint(walk->diagnostics, LX_MSG_HINT_TRY, LX_ARGS(text->bytes));
    lx_text_clear(text);
}

/* The advised range of a number of the screen. */
static const struct lx_interval *screen_range(const char *key)
{
    const struct lx_parameter *screen = lx_find_parameter(&lx_scene_table, "screen");
    return &lx_find_parameter(screen->group, key)->advised[0];
}

static bool is_within(const struct lx_interval *range, double low, double high)
{
    return low >= range->low && high <= range->high;
}

/* Width and height, scaled together into their range. */
static void mend_size(const struct lx_screen *screen, struct lx_text *text)
{
    const struct lx_interval *range = screen_range("width");
    char width[LX_NUMBER_SIZE], height[LX_NUMBER_SIZE];
    double least = fmin(screen->width_mm, screen->height_mm), most = fmax(screen->width_mm, screen->height_mm);
    double factor = least < range->low ? range->low / least : range->high / most;
    if (!is_within(range, least * factor * (1 + 1e-12), most * factor * (1 - 1e-12)))
        return;
    lx_mend_add(text, "screen.width=%s", lx_write_digits(screen->width_mm * factor, 12, width));
    lx_mend_add(text, "screen.height=%s", lx_write_digits(screen->height_mm * factor, 12, height));
}

static unsigned common_divisor(unsigned a, unsigned b)
{
    while (b) {
        unsigned rest = a % b;
        a = b, b = rest;
    }
    return a;
}

/* Another resolution of the same proportions, which keeps the pixels square. */
static void mend_resolution(const struct lx_screen *screen, struct lx_text *text)
{
    const struct lx_interval *range = screen_range("resolution");
    unsigned divisor = common_divisor(screen->resolution[0], screen->resolution[1]);
    unsigned a = screen->resolution[0] / divisor, b = screen->resolution[1] / divisor;
    unsigned least = a < b ? a : b, most = a < b ? b : a, low = (unsigned)range->low, high = (unsigned)range->high;
    unsigned times = least * divisor < low ? (low + least - 1) / least : high / most;
    if (is_within(range, least * times, most * times))
        lx_mend_add(text, "screen.resolution=[%u, %u]", a * times, b * times);
}

/* Whether the scene is valid with the value. */
static bool is_valid_with(const luxel_scene *scene, const char *assignment)
{
    if (scene->document.node_count > MOST_NODES)
        return false;
    luxel_scene *copy = luxel_scene_copy(scene);
    bool valid = copy && luxel_scene_set(copy, assignment, NULL) == LUXEL_OK &&
                 luxel_scene_commit(copy, NULL) == LUXEL_OK && luxel_scene_check_view(copy, NULL) == LUXEL_OK;
    luxel_scene_free(copy);
    return valid;
}

static void mend_value(struct lx_walk *walk, const struct lx_step *step, double nearest, struct lx_text *text)
{
    char number[LX_NUMBER_SIZE];
    struct lx_text assignment = {0};
    lx_add_path(&assignment, step);
    lx_text_printf(&assignment, "=%s", lx_write_number(nearest, number));
    walk->out_of_memory = walk->out_of_memory || assignment.failed;
    if (!assignment.failed && is_valid_with(walk->scene, assignment.bytes))
        lx_mend_add(text, "%s", assignment.bytes);
    lx_text_clear(&assignment);
}

void lx_mend_number(struct lx_walk *walk, const struct lx_step *step, double nearest)
{
    struct lx_text text = {0};
    const struct lx_step *up = step->key ? step->up : step->up->up;
    const char *key = step->key ? step->key : step->up->key;
    bool is_screen = up && !up->up && up->key && strcmp(up->key, "screen") == 0;
    if (is_screen && strcmp(key, "resolution") == 0)
        mend_resolution(&walk->scene->parameters.screen, &text);
    else if (is_screen)
        mend_size(&walk->scene->parameters.screen, &text);
    else
        mend_value(walk, step, nearest, &text);
    lx_mend_hint(walk, &text);
}
