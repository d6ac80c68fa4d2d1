/* SPDX-License-Identifier: MIT */
/*
 * Any command line: its arguments end with zero bytes, as those of /proc/PID/cmdline.  It is read as the tool reads it,
 * and what it says of a built-in scene (-s, -p, --at, --view, --material, settings) is done.
 * A refusal has words, and harmless ones.
 */
#include "fuzz.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "../cli/cli.h"
#include "../cli/load.h"

enum { MOST_ARGUMENTS = 40 };

/* Points into `text`, which ends with a zero byte; NULL behind the last one. */
static int cut(char *text, size_t size, char *arguments[MOST_ARGUMENTS + 2])
{
    int count = 0;
    arguments[count++] = "luxel";
    for (char *at = text; at < text + size && count <= MOST_ARGUMENTS; at += strlen(at) + 1)
        arguments[count++] = at;
    arguments[count] = NULL;
    return count;
}

static void use_elements(const struct options *options, const luxel_scene *scene)
{
    luxel_settings settings = options->settings;
    settings.tolerance = 1e-4;
    for (size_t i = 0; i < options->place_count; i++) {
        const double *numbers = options->places[i].numbers;
        luxel_place place = {
            .is_element = true, .has_view = options_given(options, "view"), .surface = options->material};
        luxel_probe *probe;
        memcpy(place.position_mm, numbers, sizeof place.position_mm);
        memcpy(place.normal, numbers + 3, sizeof place.normal);
        memcpy(place.view, options->view, sizeof place.view);
        if (options->places[i].is_element && luxel_probe_place(scene, &settings, &place, NULL, &probe) == LUXEL_OK)
            luxel_probe_free(probe);
    }
}

/* Files are for the other targets. */
static int use(struct options *options)
{
    struct loaded loaded;
    if (load_find_builtin(options->operand) == luxel_builtin_scene_count())
        options->operand = NULL;
    int code = load_scene(options, true, &loaded);
    if (code == EXIT_DONE) {
        use_elements(options, loaded.scene);
        fuzz_use_scene(loaded.scene);
        loaded.scene = NULL;
    }
    load_clear(&loaded);
    return code;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1), *arguments[MOST_ARGUMENTS + 2];
    struct fuzz_words words;
    struct options options;
    fuzz_must(text != NULL, "memory");
    memcpy(text, data, size);
    text[size] = '\0';
    fuzz_listen(&words);
    optind = 0; /* getopt begins anew */
    int code = options_read(cut(text, size, arguments), arguments, &options);
    if (code == EXIT_DONE)
        code = use(&options);
    options_clear(&options);
    fuzz_must((code == EXIT_DONE) == (fuzz_heard(&words) == 0), "a refusal, and nothing else, has words");
    free(text);
    return 0;
}
