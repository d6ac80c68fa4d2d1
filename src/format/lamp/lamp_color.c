/* SPDX-License-Identifier: MIT */
/* Reading colour temperatures and codes of lamps out of words. */
#include "lamp_color.h"

#include <stdlib.h>
#include <string.h>

static const char digits[] = "0123456789";

/* Colour temperatures of codes, in hundreds of kelvins. */
static const unsigned char hundreds[] = {18, 20, 22, 25, 27, 30, 35, 40, 45, 50, 55, 57, 60, 65, 80};

static void add(struct lx_lamp_color *color, double kelvin)
{
    for (size_t i = 0; i < color->count; i++)
        if (color->kelvins[i] == kelvin)
            return;
    if (color->count < LX_MOST_KELVINS)
        color->kelvins[color->count++] = kelvin;
}

/* Whether the unit stands here, blanks and a degree sign before it. */
static bool has_unit(const char *text)
{
    text += strspn(text, " ");
    if (strncmp(text, "°", strlen("°")) == 0)
        text += strlen("°");
    return *text == 'K' || *text == 'k';
}

/* The number of kelvins that a run of digits begins, 0: none, and where it ends: "4,000 K" has two runs. */
static double kelvins_at(const char *text, bool needs_unit, const char **end)
{
    const size_t length = strspn(text, digits);
    double kelvin = (double)strtol(text, NULL, 10);
    *end = text + length;
    if (length <= 2 && **end != '\0' && strchr(" ,.", **end) && strspn(*end + 1, digits) == 3 && has_unit(*end + 4)) {
        kelvin = 1000 * kelvin + (double)strtol(*end + 1, NULL, 10);
        *end += 4;
    } else if (length < 4 || length > 5 || (needs_unit && !has_unit(*end))) {
        return 0;
    }
    return kelvin >= 1000 && kelvin <= 25000 ? kelvin : 0;
}

static bool is_code(const char *text)
{
    return strspn(text, digits) == 3 && text[0] >= '6' && text[0] <= '9' &&
           memchr(hundreds, (int)strtol(text + 1, NULL, 10), sizeof hundreds) != NULL;
}

void lx_read_lamp_color(const char *words, bool needs_unit, struct lx_lamp_color *color)
{
    const char *end;
    *color = (struct lx_lamp_color){.count = 0};
    for (const char *at = words; *(at += strcspn(at, digits)); at = end) {
        const double kelvin = kelvins_at(at, needs_unit, &end);
        if (kelvin > 0)
            add(color, kelvin);
    }
    if (color->count > 0 || needs_unit)
        return;
    for (const char *at = words; *(at += strcspn(at, digits)); at += strspn(at, digits))
        if (is_code(at)) {
            memcpy(color->code, at, 3);
            add(color, 100 * (double)strtol(at + 1, NULL, 10));
        }
}

struct lx_lamp_color lx_lamp_color_of(const luxel_photometry *photometry)
{
    struct lx_lamp_color color = {.count = 0};
    for (size_t i = 0; i < photometry->lamp_set_count && color.count == 0; i++)
        lx_read_lamp_color(photometry->lamp_sets[i].temperature, false, &color);
    for (size_t i = 0; i < photometry->lamp_set_count && color.count == 0; i++)
        lx_read_lamp_color(photometry->lamp_sets[i].type, true, &color);
    return color;
}
