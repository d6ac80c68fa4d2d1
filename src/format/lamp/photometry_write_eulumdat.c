/* SPDX-License-Identifier: MIT */
/*
 * Writing EULUMDAT: intensities in cd/klm of the declared lumens, or of the flux by the zone rule where there are none,
 * which the number of lamps then marks as absolute.  Texts are ISO 8859-1 where that has all their characters, else
 * UTF-8.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "photometry_write.h"

/* A file while it is written. */
struct writing {
    const luxel_photometry *photometry;
    luxel_photometry_figures figures;
    struct lx_text *text;
    double lumens; /* that the intensities belong to */
};

static void add_end(struct writing *writing)
{
    lx_text_puts(writing->text, "\r\n");
}

static void add_number(struct writing *writing, double number)
{
    lx_add_number(writing->text, isfinite(number) ? number : 0);
    add_end(writing);
}

/* The first line of a text; others have no place. */
static void add_text(struct writing *writing, const char *words)
{
    if (words)
        lx_add_line(writing->text, words, strcspn(words, "\n"));
    add_end(writing);
}

static void add_keyword(struct writing *writing, const char *keyword)
{
    add_text(writing, luxel_photometry_find_text(writing->photometry, keyword));
}

/* ---- planes ---- */

/* Whether the planes that EULUMDAT finds by their number stand at the quarters of the turn. */
static bool has_quarters(const luxel_photometry *photometry)
{
    size_t count = photometry->plane_count - 1;
    for (size_t i = 0; i < 4; i++)
        if (count % 4 != 0 || fabs(photometry->planes[i * count / 4] - 90.0 * (double)i) > 1e-6)
            return false;
    return true;
}

static bool has_halves(const luxel_photometry *photometry)
{
    size_t count = photometry->plane_count - 1;
    return count % 2 == 0 && photometry->planes[0] == 0 && fabs(photometry->planes[count / 2] - 180) <= 1e-6;
}

/* Whether the last plane, which EULUMDAT leaves out, is not the first one again. */
static bool has_seam(const luxel_photometry *photometry)
{
    size_t angles = photometry->angle_count;
    return memcmp(photometry->intensities, photometry->intensities + (photometry->plane_count - 1) * angles,
                  angles * sizeof *photometry->intensities) != 0;
}

/* Isym: that of the table where its planes allow it, else none. */
static int find_symmetry(const luxel_photometry *photometry)
{
    switch (photometry->symmetry) {
    case LUXEL_SYMMETRY_AXIAL: return 1;
    case LUXEL_SYMMETRY_BILATERAL_0: return has_halves(photometry) ? 2 : 0;
    case LUXEL_SYMMETRY_BILATERAL_90: return has_quarters(photometry) ? 3 : 0;
    case LUXEL_SYMMETRY_QUADRANT: return has_quarters(photometry) ? 4 : 0;
    default: return 0;
    }
}

/* The step of angles that have one; 0: they have none. */
static double find_step(const double *angles, size_t count)
{
    double step = count > 1 ? angles[1] - angles[0] : 0;
    for (size_t i = 1; i < count; i++)
        if (fabs(angles[i] - angles[i - 1] - step) > 1e-9)
            return 0;
    return step;
}

/* ---- the head ---- */

static void add_sizes(struct writing *writing)
{
    const luxel_photometry_opening *opening = &writing->photometry->opening;
    const double *housing = writing->photometry->housing_mm;
    bool has_housing = housing[0] > 0;
    bool is_round = opening->width_mm == opening->length_mm &&
                    (opening->shape == LUXEL_OPENING_ELLIPSE || opening->shape == LUXEL_OPENING_CYLINDER ||
                     opening->shape == LUXEL_OPENING_ELLIPSOID);
    double length = is_round ? 0 : opening->length_mm;
    add_number(writing, has_housing ? housing[0] : opening->width_mm);
    add_number(writing, has_housing ? housing[1] : length);
    add_number(writing, has_housing ? housing[2] : opening->height_mm);
    add_number(writing, opening->width_mm);
    add_number(writing, length);
    for (int i = 0; i < 4; i++)
        add_number(writing, opening->height_mm);
}

static void add_lamps(struct writing *writing)
{
    const luxel_photometry *photometry = writing->photometry;
    bool is_other = photometry->format != LUXEL_PHOTOMETRY_EULUMDAT;
    add_number(writing, (double)photometry->lamp_set_count);
    for (size_t i = 0; i < photometry->lamp_set_count; i++) {
        const luxel_photometry_lamp_set *lamps = &photometry->lamp_sets[i];
        bool is_absolute = is_other && (photometry->is_absolute || !(photometry->declared_lumens > 0));
        double count = lamps->count != 0 ? lamps->count : 1;
        add_number(writing, is_absolute ? -fabs(count) : count);
        add_text(writing, lamps->type);
        add_number(writing, i == 0 ? writing->lumens : lamps->lumens);
        add_text(writing, lamps->temperature);
        add_text(writing, lamps->rendering);
        add_number(writing, lamps->watts);
    }
}

static void add_head(struct writing *writing, int symmetry, size_t planes)
{
    const luxel_photometry *photometry = writing->photometry;
    const luxel_photometry_figures *figures = &writing->figures;
    add_keyword(writing, "MANUFAC");
    add_number(writing, symmetry == 1 ? 1 : 3);
    add_number(writing, symmetry);
    add_number(writing, (double)planes);
    add_number(writing, symmetry == 1 ? 0 : find_step(photometry->planes, photometry->plane_count));
    add_number(writing, (double)photometry->angle_count);
    add_number(writing, find_step(photometry->angles, photometry->angle_count));
    add_keyword(writing, "TEST");
    add_keyword(writing, "LUMINAIRE");
    add_keyword(writing, "LUMCAT");
    add_keyword(writing, "_FILE");
    add_keyword(writing, "ISSUEDATE");
    add_sizes(writing);
    add_number(writing, figures->dff);
    add_number(writing, 100 * figures->zone_lumens / writing->lumens);
    add_number(writing, 1); /* conversion factor */
    add_number(writing, 0); /* tilt */
    add_lamps(writing);
    for (size_t i = 0; i < LUXEL_ROOM_INDICES; i++)
        add_number(writing, figures->direct_ratios[i]);
}

/* ---- the table ---- */

/* The number of cd/klm that reads back as an intensity, or, where rounding leaves none, the nearest to it. */
static double per_kilolumen(double intensity, double lumens)
{
    double value = intensity / lumens * 1000, best = value;
    for (int i = -2; i <= 2; i++) {
        double near = value;
        for (int step = 0; step < abs(i); step++)
            near = nextafter(near, i < 0 ? -HUGE_VAL : HUGE_VAL);
        if (fabs(near * lumens / 1000 - intensity) < fabs(best * lumens / 1000 - intensity))
            best = near;
    }
    return best > 0 ? best : 0;
}

static void add_table(struct writing *writing, int symmetry, size_t planes)
{
    static const int parts[] = {1, 1, 2, 2, 4};
    const luxel_photometry *photometry = writing->photometry;
    size_t angles = photometry->angle_count, first = symmetry == 3 ? 3 * planes / 4 : 0;
    size_t stored = symmetry == 0 ? planes : symmetry == 1 ? 1 : planes / (size_t)parts[symmetry] + 1;
    for (size_t i = 0; i < planes; i++)
        add_number(writing, photometry->planes[i]);
    for (size_t j = 0; j < angles; j++)
        add_number(writing, photometry->angles[j]);
    for (size_t i = 0; i < stored; i++)
        for (size_t j = 0; j < angles; j++)
            add_number(writing,
                       per_kilolumen(photometry->intensities[(first + i) % planes * angles + j], writing->lumens));
}

/* ISO 8859-1 instead of UTF-8 where it has all characters. */
static void make_latin(struct lx_text *text)
{
    uint32_t code;
    size_t to = 0;
    for (size_t i = 0; i < text->length; i += lx_next_character(text->bytes + i, text->length - i, &code))
        if (lx_next_character(text->bytes + i, text->length - i, &code) == 0 || code > 0xff)
            return;
    for (size_t i = 0; i < text->length;) {
        i += lx_next_character(text->bytes + i, text->length - i, &code);
        text->bytes[to++] = (char)code;
    }
    text->length = to;
}

void lx_write_eulumdat(const luxel_photometry *photometry, struct lx_text *text, bool *has_memory)
{
    struct writing writing = {.photometry = photometry, .text = text};
    int symmetry = find_symmetry(photometry);
    size_t planes = symmetry == 1 ? 1 : photometry->plane_count - !has_seam(photometry);
    *has_memory = luxel_photometry_find_figures(photometry, &writing.figures) == LUXEL_OK;
    if (!*has_memory)
        return;
    writing.lumens = photometry->declared_lumens > 0   ? photometry->declared_lumens
                     : writing.figures.zone_lumens > 0 ? writing.figures.zone_lumens
                                                       : 1000;
    add_head(&writing, symmetry, planes);
    add_table(&writing, symmetry, planes);
    if (!text->failed)
        make_latin(text);
}
