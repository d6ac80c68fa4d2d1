/* SPDX-License-Identifier: MIT */
/* Collecting places to probe. */
#include "places.h"

#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"

luxel_place *places_add(struct places *places)
{
    if (places->count == places->capacity) {
        const size_t capacity = places->capacity ? 2 * places->capacity : 16;
        luxel_place *larger = message_allocate(capacity, sizeof *larger);

        if (places->count > 0)
            memcpy(larger, places->list, places->count * sizeof *larger);
        free(places->list);
        places->list = larger;
        places->capacity = capacity;
    }
    return &places->list[places->count++];
}

void places_set_element(luxel_place *place, const double numbers[6])
{
    place->is_element = true;
    memcpy(place->position_mm, numbers, sizeof place->position_mm);
    memcpy(place->normal, numbers + 3, sizeof place->normal);
}

static int collect_given(const struct options *options, luxel_diagnostics *diagnostics, struct places *places)
{
    for (size_t i = 0; i < options->place_count; i++) {
        const struct option_place *given = &options->places[i];

        if (given->file) {
            const int code = places_read(given->file, diagnostics, options->quiet, places);

            if (code != EXIT_DONE)
                return code;
        } else if (given->is_element) {
            places_set_element(places_add(places), given->numbers);
        } else {
            memcpy(places_add(places)->screen_mm, given->numbers, 2 * sizeof given->numbers[0]);
        }
    }
    return EXIT_DONE;
}

/* --view and --material count for free elements alone, so there must be some. */
static int apply_options(const struct options *options, const luxel_scene *scene, const struct places *places)
{
    const bool has_view = options_given(options, "view"), has_material = options_given(options, "material");
    const size_t surfaces = luxel_scene_surface_count(scene);
    size_t elements = 0;

    for (size_t i = 0; i < places->count; i++) {
        luxel_place *place = &places->list[i];

        elements += place->is_element;
        place->has_view = has_view;
        memcpy(place->view, options->view, sizeof place->view);
        place->surface = options->material;
    }
    if ((has_view || has_material) && elements == 0) {
        message_error(_("%s counts for free elements alone, and there are none"), has_view ? "--view" : "--material");
        message_hint(_("name some with --at X,Y,Z,NX,NY,NZ, or --points FILE with x, y, z, nx, ny, nz"));
        return EXIT_USAGE;
    }
    if (has_material && options->material >= surfaces) {
        message_error(_("--material %u: the scene has no surfaces[%u]"), options->material, options->material);
        message_hint(_("surfaces are counted from 0, as in paths; the last one is surfaces[%zu]"), surfaces - 1);
        return EXIT_USAGE;
    }
    return EXIT_DONE;
}

int places_collect(const struct options *options, const luxel_scene *scene, luxel_diagnostics *diagnostics,
                   struct places *places)
{
    int code = EXIT_DONE;

    *places = (struct places){.list = NULL};
    if (options->place_count > 0)
        code = collect_given(options, diagnostics, places);
    else
        for (size_t i = 0; i < luxel_scene_point_count(scene); i++) {
            luxel_place *place = places_add(places);

            luxel_scene_point(scene, i, &place->screen_mm[0], &place->screen_mm[1]);
        }
    return code == EXIT_DONE ? apply_options(options, scene, places) : code;
}

void places_clear(struct places *places)
{
    free(places->list);
    *places = (struct places){.list = NULL};
}

luxel_conventions_use places_use(const struct options *options, const luxel_scene *scene, const luxel_probes *probes,
                                 bool *surfaces)
{
    const bool brightness = options->settings.quantity != LUXEL_IRRADIANCE;
    luxel_conventions_use use = {.brightness = brightness, .surfaces = surfaces};
    const size_t count = luxel_probes_count(probes);
    size_t elements = 0, materials = 0;

    memset(surfaces, 0, luxel_scene_surface_count(scene) * sizeof *surfaces);
    for (size_t i = 0; i < count; i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        elements += !probe->has_screen;
        use.screen = use.screen || probe->has_screen;
        use.pixels = use.pixels || probe->has_pixel;
        if (probe->on_surface && probe->surface != SIZE_MAX) {
            materials += !surfaces[probe->surface];
            surfaces[probe->surface] = true;
        }
    }
    if (materials == 0)
        use.surfaces = NULL;
    use.has_view = brightness && elements > 0 && options_given(options, "view");
    use.only_view = use.has_view && elements == count;
    memcpy(use.view, options->view, sizeof use.view);
    return use;
}
