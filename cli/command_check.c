/* SPDX-License-Identifier: MIT */
/* luxel check: is the scene valid, and what would an experienced user look at again? */
#include <luxel/luxel.h>

#include "advice.h"
#include "cli.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "text.h"

static void print_text(const struct loaded *loaded, const struct meshes *meshes, bool quiet)
{
    if (!quiet) {
        text_print_escaped(stdout, loaded->name);
        fputs(_(": valid\n"), stdout);
        meshes_print(meshes);
    }
    message_diagnostics(stdout, loaded->diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ADVICE);
}

/* Prints the names of the scene's grids or lights, one a line; those without one are left out. */
static void print_names(const luxel_scene *scene, bool of_grids)
{
    const size_t count = of_grids ? luxel_scene_grid_count(scene) : luxel_scene_light_count(scene);

    for (size_t i = 0; i < count; i++) {
        const char *name = of_grids ? luxel_scene_grid_name(scene, i) : luxel_scene_light_name(scene, i);

        if (name) {
            text_print_escaped(stdout, name);
            fputc('\n', stdout);
        }
    }
}

/* A scene that could not be read at all has no result. */
static int report(const struct options *options, const struct loaded *loaded, struct meshes *meshes, int code)
{
    if (code == EXIT_DONE) {
        const int gathered = advice_gather(options, loaded);

        if (gathered != EXIT_DONE)
            return gathered;
        if (!meshes_gather(loaded->scene, meshes))
            return message_failure(LUXEL_ERROR_MEMORY, loaded->diagnostics);
    }
    if (options->json && code != EXIT_FILE)
        advice_print_json(loaded, code == EXIT_DONE, options->strict, code == EXIT_DONE ? meshes : NULL);
    else if (code == EXIT_DONE)
        print_text(loaded, meshes, options->quiet);
    return code;
}

static int run(const struct options *options)
{
    struct loaded loaded;
    struct meshes meshes = {.list = NULL};
    int code = load_scene(options, false, &loaded);

    if (code == EXIT_DONE && options_given(options, "names")) {
        print_names(loaded.scene, options->names == 0);
    } else {
        if (code == EXIT_DONE)
            code = advice_check_view(&loaded);
        code = report(options, &loaded, &meshes, code);
    }
    meshes_clear(&meshes);
    load_clear(&loaded);
    return code;
}

const struct command command_check = {
    .name = "check",
    .bit = COMMAND_CHECK,
    .operand = N_("SCENE"),
    .summary = N_("validate a scene and list advice about it"),
    .description = N_("Reports every error with its place. For a valid scene it lists what lies outside the advised "
                      "ranges, has no effect or is out of view, with what would mend it; with --strict that makes the "
                      "scene fail. Advice about the peak and the picture, as luxel advise gives it, never does. "
                      "Of each mesh it tells how many triangles it has, whether it is closed, its Euler number, its "
                      "volume, faces that look the wrong way, and its size."),
    .examples = "luxel check my.yaml\n"
                "luxel check my.yaml --strict --json",
    .run = run,
};
