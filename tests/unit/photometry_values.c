/* SPDX-License-Identifier: MIT */
/*
 * What the library reads from a luminaire file, for test_photometry.py: photometry_values FILE prints a line of facts,
 * after it has written the luminaire to a second FILE, if there is one; then answers each line of standard
 * input: `angle P A` and `cosine P A` with the intensity there, `direction P A` with the unit vector and the angles
 * that it is turned back into.
 */
#include <stdio.h>
#include <string.h>

#include <luxel/luxel.h>

static void print_facts(const luxel_photometry *photometry)
{
    luxel_photometry_figures figures;
    luxel_photometry_find_figures(photometry, &figures);
    printf("%s|%c|%s|%zu|%zu|%zu|%.17g|%.17g|%.17g|%.17g|%.17g|%.17g|%.17g|%s|%.17g|%.17g|%.17g|%.17g|%zu|%.17g\n",
           luxel_photometry_format_name(photometry), "ABC"[photometry->type],
           luxel_photometry_symmetry_name(photometry->symmetry), photometry -> declared_planes,
           photometry -> stored_planes, photometry -> angle_count, photometry -> declared_lumens, figures.zone_lumens,
           figures.linear_lumens, figures.greatest_cd, figures.dff, figures.beam_deg, figures.field_deg,
           luxel_photometry_opening_name(&photometry->opening), photometry->opening.width_mm,
           photometry->opening.length_mm, photometry->opening.height_mm, photometry->multiplier, photometry->tilt_count,
           photometry->watts);
}

static void answer(const luxel_photometry *photometry, const char *what, double plane, double angle)
{
    double direction[3];
    if (strcmp(what, "direction") == 0) {
        luxel_photometry_direction(photometry, plane, angle, direction);
        luxel_photometry_angles(photometry, direction, &plane, &angle);
        printf("%.17g %.17g %.17g %.17g %.17g\n", direction[0], direction[1], direction[2], plane, angle);
        return;
    }
    luxel_photometry_interpolation how =
        strcmp(what, "cosine") == 0 ? LUXEL_INTERPOLATE_COSINE : LUXEL_INTERPOLATE_ANGLE;
    printf("%.17g\n", luxel_photometry_intensity(photometry, how, plane, angle));
}

int main(int argc, char **argv)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_photometry *photometry = NULL;
    char what[16];
    double plane, angle;
    luxel_status status = argc > 1 ? luxel_photometry_read(argv[1], diagnostics, &photometry) : LUXEL_ERROR_ARGUMENT;
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
        char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
        fprintf(stderr, "%s %s:%u:%u: %s\n", entry->severity == LUXEL_SEVERITY_ERROR ? "error" : "warning", entry->id,
                entry->line, entry->column, message);
        luxel_text_free(message);
    }
    if (status == LUXEL_OK && argc > 2)
        status = luxel_photometry_write(photometry, argv[2], NULL);
    if (status == LUXEL_OK) {
        print_facts(photometry);
        while (scanf("%15s %lf %lf", what, &plane, &angle) == 3)
            answer(photometry, what, plane, angle);
    }
    luxel_photometry_free(photometry);
    luxel_diagnostics_free(diagnostics);
    return (int)status;
}
