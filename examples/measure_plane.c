/* SPDX-License-Identifier: MIT */
/*
 * Measures how evenly a plane is lit, with finer and finer cells until the average stays the same to a thousandth:
 *
 *     measure_plane [FILE.yaml]
 *
 * It takes the first measuring grid of the scene; without a file a lamp 3 m above a floor of 4 m x 4 m.
 */
#include <luxel/luxel.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char lamp_over_floor[] =
    "luxel: 1\n"
    "units: photometric\n"
    "screen: {width: 100, height: 100, resolution: [100, 100]}\n"
    "observer: {z: 9000}\n"
    "surfaces: [{type: sphere, center: [0, 0, 0], radius: 10}]\n"
    "lights: [{type: point, pattern: lambertian, position: [0, 0, 3000], intensity: 1000}]\n"
    "grids: [{name: floor, center: [0, 0, 0], size: [4000, 4000], n: [1, 1]}]\n";

static void print_message(const luxel_diagnostics *diagnostics)
{
    char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);

    fprintf(stderr, "%s\n", message ? message : "no memory is left");
    luxel_text_free(message);
}

/* Measures the first grid with n x n cells. */
static luxel_status measure(luxel_scene *scene, unsigned n, luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    char assignment[64];
    luxel_status status;

    snprintf(assignment, sizeof assignment, "grids[0].n=[%u,%u]", n, n);
    status = luxel_scene_set(scene, assignment, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    return status == LUXEL_OK ? luxel_find_grid(scene, NULL, 0, diagnostics, grid) : status;
}

/* Average and extrema of the cells; the flux of the plane itself, where it is known. */
static void print_grid(const luxel_grid *grid)
{
    printf("%u x %u cells: average %.6g, minimum %.6g, maximum %.6g %s, U0 %.3f", grid->columns, grid->rows,
           grid->average.value, grid->minimum.value, grid->maximum.value, grid->unit, grid->u0);
    if (grid->flux_unit)
        printf(", flux %.6g %s", grid->flux.value, grid->flux_unit);
    printf("\n");
}

static luxel_status refine(luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    double before = 0.0;
    bool stays = false;

    for (unsigned n = 2; n <= 512 && !stays && status == LUXEL_OK; n *= 2) {
        luxel_grid *grid = NULL;

        status = measure(scene, n, diagnostics, &grid);
        if (status == LUXEL_OK) {
            print_grid(grid);
            stays = fabs(grid->average.value - before) <= 1e-3 * grid->average.value;
            before = grid->average.value;
        }
        luxel_grid_free(grid);
    }
    return status;
}

int main(int argc, char **argv)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_status status = argc > 1 ? luxel_scene_read_file(argv[1], diagnostics, &scene)
                                   : luxel_scene_read_text(lamp_over_floor, strlen(lamp_over_floor), "lamp over floor",
                                                           diagnostics, &scene);

    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status == LUXEL_OK)
        status = refine(scene, diagnostics);
    if (status != LUXEL_OK)
        print_message(diagnostics);

    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    return status == LUXEL_OK ? 0 : 1;
}
