/* SPDX-License-Identifier: MIT */
/*
 * Any changes of a scene: each line is one, KEY=VALUE as `-s` takes it, or -KEY, +LIST INDEX VALUE, >LIST FROM TO; the
 * first line may name a built-in scene.  Whatever was done, the scene's text reads back.
 */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_LINES = 40, LONGEST_LIST = 200 };

static luxel_scene *begin(const char *name)
{
    luxel_scene *scene;
    if (luxel_scene_open_builtin(name, NULL, &scene) != LUXEL_OK)
        fuzz_must(luxel_scene_open_builtin("report", NULL, &scene) == LUXEL_OK, "the built-in scene");
    return scene;
}

static void get(const luxel_scene *scene, const char *line)
{
    char key[LONGEST_LIST], *text;
    bool written;
    snprintf(key, sizeof key, "%.*s", (int)strcspn(line, "="), line);
    if (luxel_scene_get(scene, key, NULL, &written, &text) == LUXEL_OK) {
        fuzz_must(!written || text, "what is written has a value");
        luxel_text_free(text);
    }
}

static void change(luxel_scene *scene, const char *line, luxel_diagnostics *diagnostics)
{
    char list[LONGEST_LIST];
    size_t from = 0, to = 0;
    int value = 0;
    if (line[0] == '-')
        luxel_scene_remove(scene, line + 1, diagnostics);
    else if (line[0] == '+' && sscanf(line + 1, "%199s %zu %n", list, &from, &value) >= 2 && value > 0)
        luxel_scene_insert(scene, list, from, line + 1 + value, diagnostics);
    else if (line[0] == '>' && sscanf(line + 1, "%199s %zu %zu", list, &from, &to) == 3)
        luxel_scene_move(scene, list, from, to, diagnostics);
    else
        luxel_scene_set(scene, line, diagnostics);
    get(scene, line);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1), *rest, *line;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    fuzz_must(text && diagnostics, "memory");
    memcpy(text, data, size);
    text[size] = '\0';
    line = strtok_r(text, "\n", &rest);
    luxel_scene *scene = begin(line ? line : "report");
    for (int i = 0; line && i < MOST_LINES; i++, line = strtok_r(NULL, "\n", &rest))
        change(scene, line, diagnostics);
    fuzz_read_messages(diagnostics);
    fuzz_use_scene(scene);
    luxel_diagnostics_free(diagnostics);
    free(text);
    return 0;
}
