/* SPDX-License-Identifier: MIT */
/*
 * Any text as a luminaire file.  One that is read holds a table whose angles rise and whose intensities are finite and
 * not negative; every number that is read off it keeps within what that table allows.
 */
#include <math.h>

#include "fuzz.h"

static const double PI = 3.14159265358979323846;

static void check_rising(const double *angles, size_t count)
{
    fuzz_must(count >= 2, "a table has two angles or more");
    for (size_t i = 1; i < count; i++)
        fuzz_must(angles[i] > angles[i - 1], "angles rise");
}

static void check_table(const luxel_photometry *photometry)
{
    const size_t count = photometry->plane_count * photometry->angle_count;
    check_rising(photometry->planes, photometry->plane_count);
    check_rising(photometry->angles, photometry->angle_count);
    if (photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        fuzz_must(fabs(photometry->planes[photometry->plane_count - 1] - photometry->planes[0] - 360) < 1e-5,
                  "planes go all around");
    for (size_t i = 0; i < count; i++)
        fuzz_must(isfinite(photometry->intensities[i]) && photometry->intensities[i] >= 0, "an intensity is finite");
    fuzz_must(photometry->lamp_set_count > 0 && photometry->version, "what every file has");
    for (size_t i = 0; i < photometry->text_count; i++)
        fuzz_must(photometry->texts[i].keyword && photometry->texts[i].text, "a text is there");
}

static void check_figures(const luxel_photometry *photometry)
{
    luxel_photometry_figures figures;
    fuzz_must(luxel_photometry_find_figures(photometry, &figures) == LUXEL_OK, "figures can be computed");
    double most = 4 * PI * figures.greatest_cd * (1 + 1e-9);
    if (isinf(most))
        return; /* near the end of the numbers */
    fuzz_must(figures.zone_lumens >= 0 && figures.zone_lumens <= most, "the flux fits the greatest intensity");
    fuzz_must(figures.linear_lumens >= -1e-9 * most && figures.linear_lumens <= most, "by the other rule, too");
    fuzz_must(isnan(figures.dff) || (figures.dff >= 0 && figures.dff <= 100), "a share is a share");
    fuzz_must(isnan(figures.beam_deg) || (figures.beam_deg >= 0 && figures.beam_deg <= 360), "an angle is an angle");
    fuzz_must(isnan(figures.field_deg) || figures.field_deg >= figures.beam_deg - 1e-9, "the field holds the beam");
    for (int i = 0; i < 3; i++)
        fuzz_must(isnan(figures.spacing[i]) || figures.spacing[i] >= 0, "a distance is not negative");
}

static void check_map(const luxel_photometry *photometry)
{
    luxel_photometry_figures figures;
    luxel_photometry_find_figures(photometry, &figures);
    for (double plane = -400; plane <= 400; plane += 36.7)
        for (double angle = -190; angle <= 190; angle += 23.9)
            for (int how = 0; how < 2; how++) {
                double found =
                    luxel_photometry_intensity(photometry, (luxel_photometry_interpolation)how, plane, angle);
                fuzz_must(found >= -1e-6 * figures.greatest_cd && found <= figures.greatest_cd * (1 + 1e-6),
                          "between the places of the table");
            }
}

/* A luminaire that is written and read back has the same intensities. */
static void write_and_read(const luxel_photometry *photometry, const char *ending, double rounding)
{
    struct fuzz_file file = fuzz_open("", 0, ending);
    luxel_photometry *again = NULL;
    luxel_photometry_figures figures;
    luxel_photometry_find_figures(photometry, &figures);
    luxel_status status = luxel_photometry_write(photometry, file.path, NULL);
    fuzz_must(status == LUXEL_OK || photometry->type != LUXEL_PHOTOMETRY_TYPE_C, "a luminaire can be written");
    if (status == LUXEL_OK && figures.zone_lumens > 1e-200 && figures.zone_lumens < 1e200) {
        fuzz_must(luxel_photometry_read(file.path, NULL, &again) == LUXEL_OK, "what is written can be read");
        /* EULUMDAT has tables of type C alone: others are brought to that */
        const bool is_kept = again->type == photometry->type;
        fuzz_must(is_kept || again->type == LUXEL_PHOTOMETRY_TYPE_C, "the type that the format has");
        for (size_t i = 0; is_kept && i < photometry->plane_count; i++)
            for (size_t j = 0; j < photometry->angle_count; j++) {
                double had = photometry->intensities[i * photometry->angle_count + j];
                double has = luxel_photometry_intensity(again, LUXEL_INTERPOLATE_ANGLE, photometry->planes[i],
                                                        photometry->angles[j]);
                bool is_seam = i + 1 == photometry->plane_count && photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
                fuzz_must(is_seam || fabs(has - had) <= rounding * figures.greatest_cd, "and is the same");
            }
    }
    luxel_photometry_free(again);
    fuzz_close(&file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_photometry *photometry = NULL;
    luxel_status status =
        luxel_photometry_read_bytes(data, size, size % 2 ? "fuzz.ies" : "fuzz.ldt", diagnostics, &photometry);
    fuzz_must((status == LUXEL_OK) == (photometry != NULL), "a file that is read is there");
    fuzz_must((status == LUXEL_OK) == (luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR) == 0),
              "an error has a message");
    fuzz_read_messages(diagnostics);
    if (photometry) {
        check_table(photometry);
        check_figures(photometry);
        check_map(photometry);
        write_and_read(photometry, ".ies", 1e-9);
        write_and_read(photometry, ".ldt", 1e-9);
    }
    luxel_photometry_free(photometry);
    luxel_diagnostics_free(diagnostics);
    return 0;
}
