/* SPDX-License-Identifier: MIT */
/* luxel room: the scene of a room with luminaires under its ceiling, to begin a lighting design with. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <luxel/luxel.h>

#include "argument.h"
#include "cli.h"
#include "message.h"
#include "options.h"
#include "outputs.h"
#include "text.h"
#include "work.h"

static luxel_status check_name(const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".yaml", ".yml"};

    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}

/* A name of a file as a scene in the folder of another one is to write it. */
static char *beside(const char *file, const char *scene)
{
    const char *slash = scene ? strrchr(scene, '/') : NULL;
    const size_t folder = slash ? (size_t)(slash + 1 - scene) : 0;
    char here[4096], *name;
    size_t size;

    if (folder > 0 && strncmp(file, scene, folder) == 0)
        file += folder;
    else if (folder > 0 && file[0] != '/' && strncmp(file, "builtin:", strlen("builtin:")) != 0 &&
             getcwd(here, sizeof here)) {
        size = strlen(here) + strlen(file) + 2;
        name = message_allocate(size, 1);
        snprintf(name, size, "%s/%s", here, file);
        return name;
    }
    size = strlen(file) + 1;
    name = message_allocate(size, 1);
    memcpy(name, file, size);
    return name;
}

static void print_array(const char *words, const luxel_room_array *array)
{
    char average[TEXT_SIZE];

    printf(words, array->n[0], array->n[1], array->n[0] * array->n[1],
           text_value_bound(average, 6, array->average.value, array->average.error), array->uniformity);
}

/* The array of luminaires of a scene that went into a file, and the next smaller one. */
static void print_found(const luxel_room_design *design)
{
    print_array(_("%u × %u = %u luminaires: average %s lx, U0 %.4f\n"), &design->chosen);
    if (design->smaller.n[0] > 0)
        print_array(_("%u × %u = %u, the next smaller array: average %s lx, U0 %.4f\n"), &design->smaller);
}

static int write_out(const struct options *options, const luxel_room_design *design, luxel_diagnostics *diagnostics)
{
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status =
            luxel_text_write(options->outputs[i], design->text, strlen(design->text), diagnostics);

        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        luxel_diagnostics_clear(diagnostics);
    }
    if (options->output_count == 0)
        fputs(design->text, stdout);
    else if (code == EXIT_DONE && !options->quiet)
        print_found(design);
    return code;
}

static int run(const struct options *options)
{
    luxel_room room = options->room;
    const char *scene = options->output_count > 0 ? options->outputs[0] : NULL;
    luxel_room_design design = {.text = NULL};
    luxel_diagnostics *diagnostics;
    struct work work;
    char *file;
    int code;

    if (!options->operand) {
        message_error(_("luxel room needs the lengths of a room in metres"));
        message_hint(_("for example: luxel room 8,6,2.8"));
        return EXIT_USAGE;
    }
    if (!argument_numbers("luxel room", "X,Y,Z", options->operand, room.size_m, 3))
        return EXIT_USAGE;
    code = outputs_check(options, check_name);
    if (code != EXIT_DONE)
        return code;
    diagnostics = message_new_diagnostics();
    file = room.file ? beside(room.file, scene) : NULL;
    room.file = file;
    work_begin(&work, options);
    code = work_end(&work, luxel_design_room(&room, scene, &work.settings, diagnostics, &design), diagnostics);
    if (design.text)
        code = write_out(options, &design, diagnostics);
    luxel_text_free(design.text);
    luxel_diagnostics_free(diagnostics);
    free(file);
    return code;
}

const struct command command_room = {
    .name = "room",
    .bit = COMMAND_ROOM,
    .operand = N_("X,Y,Z"),
    .operand_kind = OPERAND_NONE,
    .endings = ".yaml .yml",
    .default_format = "yaml",
    .summary = N_("write the scene of a room with luminaires under its ceiling"),
    .description = N_(
        "Writes the scene of a room, X by Y metres and Z high, to begin a lighting design with: luminaires in a "
        "regular "
        "array, level with the ceiling, or half a metre below it where they light it; the work plane as a measuring "
        "grid "
        "with the spacing of EN 12464-1, but for a border of half a metre; two seated observers; reflected light. "
        "The array is that of --array, or else the least regular one whose mean reaches --target, computed with "
        "reflections, and the numbers of the next smaller one are told. Limits are the target, and the steps of "
        "EN 12464-1 that the room keeps, so that luxel grid --limits passes. Without --file the luminaires are panels "
        "of 3600 lm."),
    .examples = "luxel room 8,6,2.8 --file lamp.ldt --array 4,3 -o office.yaml\n"
                "luxel room 8,6,2.8 --file lamp.ldt --target 500 --maintenance 0.67 -o office.yaml\n"
                "luxel room 5,4,3 > room.yaml",
    .run = run,
};
