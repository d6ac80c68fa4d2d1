/* SPDX-License-Identifier: MIT */
/* The tables of a luminaire's sheet: intensities, zones, luminances, utilization, glare, backlight and uplight. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../../base/diagnostics.h"
#include "../../base/number.h"
#include "../../base/phrase.h"
#include "luminaire.h"

enum { MOST_CELLS = 14, CELL = LX_NUMBER_SIZE + 24 };

/* A row of numbers behind what it is of; the texts live as long as the row is added. */
struct row {
    char texts[MOST_CELLS][CELL];
    struct lx_span cells[MOST_CELLS + 1];
    size_t count;
};

static void begin_row(struct row *row, const char *english)
{
    row->count = 0;
    row->cells[row->count++] = (struct lx_span){LX_SPAN_TERM, english};
}

static void begin_plain(struct row *row, const char *text)
{
    snprintf(row->texts[0], CELL, "%s", text);
    row->count = 0;
    row->cells[row->count++] = (struct lx_span){LX_SPAN_PLAIN, row->texts[0]};
}

/* Room for the text of the next cell. */
static char *next_cell(struct row *row)
{
    char *text = row->texts[row->count];
    row->cells[row->count++] = (struct lx_span){LX_SPAN_PLAIN, text};
    return text;
}

/* A number with so many decimals; a dash where there is none. */
static void add_fixed(struct row *row, double value, int decimals)
{
    char *text = next_cell(row);
    if (isfinite(value))
        snprintf(text, CELL, "%.*f", decimals, value);
    else
        strcpy(text, "–");
}

/* Three digits, or all that stand before the point. */
static void add_value(struct row *row, double value)
{
    char *text = next_cell(row), number[LX_NUMBER_SIZE];
    if (isfinite(value))
        snprintf(text, CELL, "%s", lx_write_digits(value, value >= 100 ? 1 + (int)floor(log10(value)) : 3, number));
    else
        strcpy(text, "–");
}

static void end_row(const struct lx_luminaire_sheet *sheet, struct row *row)
{
    row->cells[row->count] = (struct lx_span){LX_SPAN_END, NULL};
    lx_document_row(sheet->document, row->cells, false);
}

/* A table of so many columns of numbers behind the first one. */
static void begin_table(const struct lx_luminaire_sheet *sheet, size_t numbers, char first)
{
    char letters[MOST_CELLS + 1] = {first};
    memset(letters + 1, 'r', numbers);
    letters[1 + numbers] = '\0';
    lx_document_table(sheet->document, letters);
}

/* ---- intensities ---- */

enum { MOST_PLANES = 9 };

/* The planes that a table shows: those of its symmetry, 15, 30 or 45 degrees apart. */
static size_t choose_planes(const luxel_photometry *photometry, double planes[MOST_PLANES])
{
    static const struct {
        double from, step;
        size_t count;
    } of[] = {
        [LUXEL_SYMMETRY_NONE] = {0, 45, 8},          [LUXEL_SYMMETRY_AXIAL] = {0, 0, 1},
        [LUXEL_SYMMETRY_QUADRANT] = {0, 15, 7},      [LUXEL_SYMMETRY_BILATERAL_0] = {0, 30, 7},
        [LUXEL_SYMMETRY_BILATERAL_90] = {90, 30, 7},
    };
    const size_t symmetry = photometry->symmetry;
    for (size_t i = 0; i < of[symmetry].count; i++)
        planes[i] = of[symmetry].from + of[symmetry].step * (double)i;
    return of[symmetry].count;
}

/* Types A and B: nine horizontal angles of the table from its first to its last. */
static size_t choose_horizontal(const luxel_photometry *photometry, double planes[MOST_PLANES])
{
    const size_t count = photometry->plane_count < MOST_PLANES ? photometry->plane_count : MOST_PLANES;
    for (size_t i = 0; i < count; i++)
        planes[i] = photometry->planes[count > 1 ? i * (photometry->plane_count - 1) / (count - 1) : 0];
    return count;
}

static void head_planes(const struct lx_luminaire_sheet *sheet, const char *corner, const double *planes, size_t count)
{
    struct row row;
    begin_table(sheet, count, 'r');
    begin_row(&row, corner);
    for (size_t i = 0; i < count; i++)
        snprintf(next_cell(&row), CELL, "%s%g", sheet->photometry->type == LUXEL_PHOTOMETRY_TYPE_C ? "C" : "",
                 planes[i]);
    end_row(sheet, &row);
}

void lx_sheet_intensities(const struct lx_luminaire_sheet *sheet)
{
    enum { STEP = 5 };
    const luxel_photometry *photometry = sheet->photometry;
    const bool is_turn = photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    const double end = photometry->angles[photometry->angle_count - 1];
    const double last = sheet->figures.dff >= 100 ? fmin(end, 90) : end; /* nothing goes upwards */
    double planes[MOST_PLANES];
    const size_t count = is_turn ? choose_planes(photometry, planes) : choose_horizontal(photometry, planes);
    struct row row;
    if (!(sheet->figures.greatest_cd > 0))
        return;
    lx_document_paragraph(sheet->document,
                          is_turn ? LX_N("Intensities in cd, by C and γ in degrees.")
                                  : LX_N("Intensities in cd, by the horizontal and the vertical angle in degrees."),
                          NULL);
    head_planes(sheet, is_turn ? "γ" : LX_N("vertical"), planes, count);
    for (double angle = STEP * ceil(photometry->angles[0] / STEP); angle <= last; angle += STEP) {
        char text[CELL];
        snprintf(text, sizeof text, "%g", angle);
        begin_plain(&row, text);
        for (size_t i = 0; i < count; i++)
            add_value(&row, luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, planes[i], angle));
        end_row(sheet, &row);
    }
}

/* ---- zones ---- */

luxel_status lx_sheet_zones(const struct lx_luminaire_sheet *sheet)
{
    double lumens[LUXEL_FLUX_ZONES], sum = 0;
    const double whole = sheet->figures.zone_lumens;
    struct row row;
    if (luxel_photometry_find_zones(sheet->photometry, lumens) != LUXEL_OK)
        return lx_out_of_memory(sheet->diagnostics);
    if (!isfinite(lumens[0]) || !(whole > 0))
        return LUXEL_OK;
    lx_document_heading(sheet->document, 1, LX_N("Flux of zones"), NULL);
    begin_table(sheet, 4, 'r');
    lx_document_row(sheet->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("γ, degrees")), LX_TERM_SPAN(LX_N("flux, lm")), LX_PLAIN("%"),
                             LX_TERM_SPAN(LX_N("from 0 on, lm")), LX_PLAIN("%")),
                    false);
    for (int i = 0; i < LUXEL_FLUX_ZONES; i++) {
        char text[CELL];
        sum += lumens[i];
        if (i >= LUXEL_FLUX_ZONES / 2 && lumens[i] == 0 && sum >= whole * (1 - 1e-9))
            break; /* all light is counted */
        snprintf(text, sizeof text, "%d–%d", 10 * i, 10 * (i + 1));
        begin_plain(&row, text);
        add_fixed(&row, lumens[i], 1);
        add_fixed(&row, 100 * lumens[i] / whole, 1);
        add_fixed(&row, sum, 1);
        add_fixed(&row, 100 * sum / whole, 1);
        end_row(sheet, &row);
    }
    return LUXEL_OK;
}

/* ---- luminances ---- */

void lx_sheet_luminances(const struct lx_luminaire_sheet *sheet)
{
    enum { FROM = 45, TO = 85, STEP = 5 };
    const luxel_photometry *photometry = sheet->photometry;
    double planes[MOST_PLANES];
    size_t count;
    struct row row;
    if (photometry->type != LUXEL_PHOTOMETRY_TYPE_C || photometry->opening.shape == LUXEL_OPENING_POINT)
        return;
    count = choose_planes(photometry, planes);
    lx_document_heading(sheet->document, 1, LX_N("Luminances"), NULL);
    lx_document_paragraph(sheet->document,
                          LX_N("Mean luminances of the luminous opening in cd/m²: the intensity over the area that it "
                               "shows in that direction."),
                          NULL);
    head_planes(sheet, "γ", planes, count);
    for (int angle = FROM; angle <= TO; angle += STEP) {
        char text[CELL];
        snprintf(text, sizeof text, "%d", angle);
        begin_plain(&row, text);
        for (size_t i = 0; i < count; i++)
            add_value(&row, luxel_photometry_luminance(photometry, planes[i], angle));
        end_row(sheet, &row);
    }
}

/* ---- utilization ---- */

static const char *const part_names[] = {LX_N("ceiling, %"), LX_N("walls, %"), LX_N("floor, %")};

static void add_reflected(const struct lx_luminaire_sheet *sheet)
{
    struct row row;
    if (!sheet->has_reflected) {
        lx_document_paragraph(sheet->document,
                              LX_N("Factors by the light that surfaces really reflect are told of files whose light "
                                   "goes downwards."),
                              NULL);
        return;
    }
    lx_document_paragraph(sheet->document,
                          LX_N("The factors of 70, 50 and 20 % by the light that the surfaces of square rooms really "
                               "reflect, any number of times, under luminaires on the ceiling about as far apart as "
                               "they are high:"),
                          NULL);
    begin_table(sheet, 3, 'l');
    lx_document_row(sheet->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("room index k")), LX_TERM_SPAN(LX_N("by the table, %")),
                             LX_TERM_SPAN(LX_N("by reflections, %")), LX_TERM_SPAN(LX_N("error at most"))),
                    false);
    for (size_t k = 0; k < LX_SHEET_ROOMS; k++) {
        const luxel_bounded factor = sheet->reflected[k].factor;
        char text[CELL], number[LX_NUMBER_SIZE];
        snprintf(text, sizeof text, "%.3g", luxel_photometry_room_index(k));
        begin_plain(&row, text);
        add_fixed(&row, 100 * sheet->utilization.factors[k][LX_SHEET_TRIPLE], 1);
        add_fixed(&row, 100 * factor.value, 2);
        snprintf(next_cell(&row), CELL, "%s", lx_write_bound(100 * factor.error + 0.005, 2, number));
        end_row(sheet, &row);
    }
}

void lx_sheet_utilization(const struct lx_luminaire_sheet *sheet)
{
    struct row row;
    if (!sheet->utilization.exists)
        return;
    lx_document_heading(sheet->document, 1, LX_N("Utilization factors"), NULL);
    lx_document_paragraph(sheet->document,
                          LX_N("The share of the light that reaches the work plane of a room, in %, by the tabular "
                               "method, for room indices k and reflectances of ceiling, walls and floor."),
                          NULL);
    begin_table(sheet, LUXEL_UTILIZATION_REFLECTANCES, 'l');
    for (size_t part = 0; part < sizeof part_names / sizeof *part_names; part++) {
        begin_row(&row, part_names[part]);
        for (size_t i = 0; i < LUXEL_UTILIZATION_REFLECTANCES; i++)
            add_fixed(&row, 100 * luxel_utilization_reflectance(i, part), 0);
        end_row(sheet, &row);
    }
    for (size_t k = 0; k < LUXEL_ROOM_INDICES; k++) {
        char text[CELL];
        snprintf(text, sizeof text, "k = %.3g", luxel_photometry_room_index(k));
        begin_plain(&row, text);
        for (size_t i = 0; i < LUXEL_UTILIZATION_REFLECTANCES; i++)
            add_fixed(&row, 100 * sheet->utilization.factors[k][i], 1);
        end_row(sheet, &row);
    }
    add_reflected(sheet);
}

/* ---- glare ---- */

void lx_sheet_glare(const struct lx_luminaire_sheet *sheet)
{
    const luxel_ugr_table *glare = &sheet->glare;
    char spacing[LX_NUMBER_SIZE];
    struct row row;
    if (!glare->exists)
        return;
    lx_document_heading(sheet->document, 1, LX_N("Unified glare ratings"), NULL);
    lx_document_paragraph(sheet->document,
                          LX_N("UGR by the tabular method of CIE 190, luminaires {0} of their height H above the eye "
                               "apart: the five columns on the left crosswise (C0-C180 along the line of sight), those "
                               "on the right endwise."),
                          LX_SPANS(LX_PLAIN(lx_write_digits(glare->spacing, 3, spacing))));
    begin_table(sheet, 2 * LUXEL_UGR_REFLECTANCES, 'l');
    for (size_t part = 0; part < sizeof part_names / sizeof *part_names; part++) {
        begin_row(&row, part_names[part]);
        for (size_t i = 0; i < 2 * LUXEL_UGR_REFLECTANCES; i++)
            add_fixed(&row, 100 * luxel_ugr_reflectance(i % LUXEL_UGR_REFLECTANCES, part), 0);
        end_row(sheet, &row);
    }
    for (size_t room = 0; room < LUXEL_UGR_ROOMS; room++) {
        char text[CELL];
        snprintf(text, sizeof text, "%.3gH × %.3gH", luxel_ugr_room(room, 0), luxel_ugr_room(room, 1));
        begin_plain(&row, text);
        for (size_t i = 0; i < 2 * LUXEL_UGR_REFLECTANCES; i++)
            add_fixed(&row, glare->ratings[room][i / LUXEL_UGR_REFLECTANCES][i % LUXEL_UGR_REFLECTANCES], 1);
        end_row(sheet, &row);
    }
}

/* ---- backlight, uplight, glare outdoors ---- */

void lx_sheet_bug(const struct lx_luminaire_sheet *sheet)
{
    static const char *const names[] = {
        [LUXEL_BUG_FORWARD_LOW] = "FL",  [LUXEL_BUG_FORWARD_MID] = "FM",
        [LUXEL_BUG_FORWARD_HIGH] = "FH", [LUXEL_BUG_FORWARD_VERY_HIGH] = "FVH",
        [LUXEL_BUG_BACK_LOW] = "BL",     [LUXEL_BUG_BACK_MID] = "BM",
        [LUXEL_BUG_BACK_HIGH] = "BH",    [LUXEL_BUG_BACK_VERY_HIGH] = "BVH",
        [LUXEL_BUG_UP_LOW] = "UL",       [LUXEL_BUG_UP_HIGH] = "UH",
    };
    const luxel_bug_rating *bug = &sheet->bug;
    char rating[80], front[40];
    struct row row;
    if (!bug->exists)
        return;
    snprintf(rating, sizeof rating, "B%u U%u G%u", bug->backlight, bug->uplight, bug->glare);
    snprintf(front, sizeof front, "%.0f", bug->front_c_deg);
    lx_document_heading(sheet->document, 1, LX_N("Backlight, uplight, glare"), NULL);
    lx_document_paragraph(
        sheet->document,
        bug->is_around ? LX_N("Outdoors, hung as the file has it, the luminaire is rated {0} (IES TM-15-11, "
                              "addendum A) by the flux of these zones, with the front at C = {1}°; it lights all "
                              "sides alike, as type V does.")
                       : LX_N("Outdoors, hung as the file has it, the luminaire is rated {0} (IES TM-15-11, "
                              "addendum A) by the flux of these zones, with the front at C = {1}°."),
        LX_SPANS(LX_PLAIN(rating), LX_PLAIN(front)));
    begin_table(sheet, LUXEL_BUG_ZONES, 'l');
    begin_row(&row, LX_N("zone"));
    for (size_t i = 0; i < LUXEL_BUG_ZONES; i++)
        snprintf(next_cell(&row), CELL, "%s", names[i]);
    end_row(sheet, &row);
    begin_row(&row, "lm");
    for (size_t i = 0; i < LUXEL_BUG_ZONES; i++)
        add_fixed(&row, bug->lumens[i], bug->lumens[i] < 100 ? 1 : 0);
    end_row(sheet, &row);
}
