/* SPDX-License-Identifier: MIT */
/*
 * Prints the exact brightness at a scene's measuring points, each with a bound of its error and what every light
 * gives to it:
 *
 *     probe_points [FILE.yaml]
 *
 * Without a file it takes the built-in scene "report".  A probe needs no picture: it computes one element only.
 */
#include <luxel/luxel.h>

#include <stdio.h>

static void print_message(const luxel_diagnostics *diagnostics)
{
    char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);

    fprintf(stderr, "%s\n", message ? message : "no memory is left");
    luxel_text_free(message);
}

/* A point may lie off every surface, or on a light source: then there is no value, and no share. */
static void print_probe(const luxel_probe *probe, const char *unit)
{
    printf("(%g, %g) mm: ", probe->x_mm, probe->y_mm);
    if (!probe->has_value) {
        printf("%s\n", probe->source_on_element ? "a source lies here" : "off the surface");
        return;
    }
    printf("%.12g %s, error at most %.1e\n", probe->value, unit, probe->error);
    for (size_t i = 0; i < probe->share_count; i++) {
        const luxel_light_share *share = &probe->shares[i];

        printf("    light %zu (%s): diffuse %.9g, highlight %.9g\n", share->light,
               share->name ? share->name : share->type, share->diffuse, share->specular);
    }
}

static luxel_status print_points(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    const char *unit = luxel_scene_unit(scene, LUXEL_BRIGHTNESS);
    luxel_status status = LUXEL_OK;

    for (size_t i = 0; i < luxel_scene_point_count(scene) && status == LUXEL_OK; i++) {
        luxel_probe *probe = NULL;
        double x_mm = 0.0, y_mm = 0.0;

        status = luxel_scene_point(scene, i, &x_mm, &y_mm);
        if (status == LUXEL_OK)
            status = luxel_probe_screen(scene, NULL, x_mm, y_mm, diagnostics, &probe);
        if (status == LUXEL_OK)
            print_probe(probe, unit);
        luxel_probe_free(probe);
    }
    return status;
}

int main(int argc, char **argv)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_status status = argc > 1 ? luxel_scene_read_file(argv[1], diagnostics, &scene)
                                   : luxel_scene_open_builtin("report", diagnostics, &scene);

    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status == LUXEL_OK)
        status = print_points(scene, diagnostics);
    if (status != LUXEL_OK)
        print_message(diagnostics);

    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    return status == LUXEL_OK ? 0 : 1;
}
