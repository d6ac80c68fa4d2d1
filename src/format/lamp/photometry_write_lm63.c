/* SPDX-License-Identifier: MIT */
/*
 * Writing LM-63-2002: intensities in cd with a multiplier of 1, lengths in metres, lines that keep to its 256
 * characters.  Symmetry about C90-C270, which only 1995 had, is written as a whole turn.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "photometry_write.h"

enum { LONGEST_TEXT = 200, LONGEST_LINE = 120 };

/* Adds a text under a keyword, lines that go on under [MORE]; none is longer than the format allows. */
static void add_text(struct lx_text *text, const char *keyword, const char *words)
{
    bool is_first = true;
    do {
        size_t line = strcspn(words, "\n"), length = line < LONGEST_TEXT ? line : LONGEST_TEXT;
        while (length < line && length > 0 && ((unsigned char)words[length] & 0xc0) == 0x80)
            length--; /* no character is cut in half */
        lx_text_printf(text, "[%s] ", is_first ? keyword : "MORE");
        lx_add_line(text, words, length);
        lx_text_puts(text, "\n");
        words += length;
        words += *words == '\n';
        is_first = false;
    } while (*words);
}

/* What may stand in brackets: a keyword of the file, or none. */
static bool is_keyword(const char *keyword)
{
    size_t length = strlen(keyword);
    return length > 0 && length < 40 && strcspn(keyword, "[]\n") == length && strcmp(keyword, "MORE") != 0;
}

static void add_texts(const luxel_photometry *photometry, struct lx_text *text)
{
    static const char *const required[] = {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"};
    for (size_t i = 0; i < sizeof required / sizeof required[0]; i++) {
        const char *found = luxel_photometry_find_text(photometry, required[i]);
        add_text(text, required[i], found ? found : "-");
    }
    for (size_t i = 0; i < photometry->text_count; i++) {
        bool is_written = false;
        const char *keyword = photometry->texts[i].keyword;
        for (size_t k = 0; k < sizeof required / sizeof required[0]; k++)
            is_written = is_written || strcmp(keyword, required[k]) == 0;
        if (!is_written)
            add_text(text, is_keyword(keyword) ? keyword : "OTHER", photometry->texts[i].text);
    }
    if (photometry->format == LUXEL_PHOTOMETRY_EULUMDAT && photometry->lamp_sets[0].type[0])
        add_text(text, "LAMP", photometry->lamp_sets[0].type);
}

/* Adds numbers in lines that are not too long. */
static void add_numbers(struct lx_text *text, const double *numbers, size_t count)
{
    size_t line = text->length;
    for (size_t i = 0; i < count; i++) {
        if (i > 0) {
            bool is_full = text->length - line > LONGEST_LINE - 25;
            lx_text_puts(text, is_full ? "\n" : " ");
            line = is_full ? text->length : line;
        }
        lx_add_number(text, numbers[i]);
    }
    lx_text_puts(text, "\n");
}

static void add_tilt(const luxel_photometry *photometry, struct lx_text *text)
{
    if (photometry->tilt_count == 0) {
        lx_text_puts(text, "TILT=NONE\n");
        return;
    }
    lx_text_printf(text, "TILT=INCLUDE\n%u\n%zu\n", photometry->tilt_geometry, photometry->tilt_count);
    add_numbers(text, photometry->tilt_angles, photometry->tilt_count);
    add_numbers(text, photometry->tilt_factors, photometry->tilt_count);
}

/* Width, length and height in metres with the signs of 2002. */
static void sign_opening(const luxel_photometry_opening *opening, double sizes[3])
{
    static const signed char signs[][3] = {
        [LUXEL_OPENING_POINT] = {0, 0, 0},
        [LUXEL_OPENING_RECTANGLE] = {1, 1, 0},
        [LUXEL_OPENING_BOX] = {1, 1, 1},
        [LUXEL_OPENING_ELLIPSE] = {-1, -1, 0},
        [LUXEL_OPENING_CYLINDER] = {-1, -1, 1},
        [LUXEL_OPENING_ELLIPSOID] = {-1, -1, -1},
        [LUXEL_OPENING_CYLINDER_LENGTH] = {-1, 1, -1},
        [LUXEL_OPENING_CYLINDER_WIDTH] = {1, -1, -1},
        [LUXEL_OPENING_FACING_LENGTH] = {-1, 0, -1},
        [LUXEL_OPENING_FACING_WIDTH] = {0, -1, -1},
    };
    sizes[0] = signs[opening->shape][0] * opening->width_mm / 1000;
    sizes[1] = signs[opening->shape][1] * opening->length_mm / 1000;
    sizes[2] = signs[opening->shape][2] * opening->height_mm / 1000;
}

static void add_header(const luxel_photometry *photometry, size_t planes, struct lx_text *text)
{
    static const double types[] = {
        [LUXEL_PHOTOMETRY_TYPE_A] = 3, [LUXEL_PHOTOMETRY_TYPE_B] = 2, [LUXEL_PHOTOMETRY_TYPE_C] = 1};
    double lamps = photometry->lamp_sets[0].count, sizes[3];
    lamps = lamps != 0 ? fabs(lamps) : 1;
    double lumens =
        photometry->is_absolute || !(photometry->declared_lumens > 0) ? -1 : photometry->declared_lumens / lamps;
    sign_opening(&photometry->opening, sizes);
    const double numbers[] = {
        lamps,    lumens,   1,       (double)photometry->angle_count, (double)planes, types[photometry->type], 2,
        sizes[0], sizes[1], sizes[2]};
    add_numbers(text, numbers, sizeof numbers / sizeof numbers[0]);
    add_numbers(text, (const double[]){1, 1, photometry->watts}, 3);
}

/* How far the planes go that the file must hold. */
static void find_range(const luxel_photometry *photometry, double *from_deg, double *to_deg)
{
    *from_deg = 0;
    *to_deg = photometry->planes[photometry->plane_count - 1];
    if (photometry->type != LUXEL_PHOTOMETRY_TYPE_C)
        *from_deg = photometry->symmetry == LUXEL_SYMMETRY_LATERAL ? 0 : photometry->planes[0];
    else
        *to_deg = photometry->symmetry == LUXEL_SYMMETRY_AXIAL         ? 0
                  : photometry->symmetry == LUXEL_SYMMETRY_QUADRANT    ? 90
                  : photometry->symmetry == LUXEL_SYMMETRY_BILATERAL_0 ? 180
                                                                       : 360;
}

void lx_write_lm63(const luxel_photometry *photometry, struct lx_text *text, bool *has_memory)
{
    struct lx_written_table table;
    double from, to;
    find_range(photometry, &from, &to);
    *has_memory = lx_take_planes(photometry, from, to, &table);
    if (!*has_memory)
        return;
    lx_text_puts(text, "IESNA:LM-63-2002\n");
    add_texts(photometry, text);
    add_tilt(photometry, text);
    add_header(photometry, table.plane_count, text);
    add_numbers(text, photometry->angles, photometry->angle_count);
    add_numbers(text, table.planes, table.plane_count);
    for (size_t i = 0; i < table.plane_count; i++)
        add_numbers(text, table.intensities + i * photometry->angle_count, photometry->angle_count);
    lx_written_table_clear(&table);
}
