/* SPDX-License-Identifier: MIT */
/* luxel scene: a built-in scene, or the one that a picture carries, as a file to start from. */
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "text.h"

static void write_scene(struct json *json, const char *name, const char *title, const char *text)
{
    json_open(json, NULL, '{');
    json_text(json, "name", name);
    json_text(json, "title", title);
    if (text)
        json_text(json, "text", text);
    json_close(json, '}');
}

static void print_list(bool as_json)
{
    const size_t count = luxel_builtin_scene_count();

    if (as_json) {
        struct json json = {.stream = stdout};

        json_open(&json, NULL, '{');
        json_open(&json, "scenes", '[');
        for (size_t i = 0; i < count; i++)
            write_scene(&json, luxel_builtin_scene_name(i), luxel_builtin_scene_title(i), NULL);
        json_close(&json, ']');
        json_close(&json, '}');
    } else {
        struct text_table *table = text_table_new("ll");

        for (size_t i = 0; i < count; i++)
            text_table_row(table, TEXT_CELLS(luxel_builtin_scene_name(i), _(luxel_builtin_scene_title(i))));
        text_table_print(table, stdout, 0);
    }
}

/* A built-in scene verbatim as long as nothing was changed: its text carries comments. */
static int print_scene(const struct options *options, const struct loaded *loaded)
{
    const size_t i = load_find_builtin(loaded->name);
    const char *text = luxel_builtin_scene_text(i);
    char *written = NULL;

    if (!text || options->assignment_count > 0) {
        const luxel_status status = luxel_scene_write_text(loaded->scene, &written);

        if (status != LUXEL_OK)
            return message_failure(status, loaded->diagnostics);
        text = written;
    }
    if (options->json) {
        char *name = luxel_escaped_text(loaded->name); /* a file's name may be no UTF-8 */

        write_scene(&(struct json){.stream = stdout}, name, luxel_builtin_scene_title(i), text);
        luxel_text_free(name);
    } else {
        fputs(text, stdout);
    }
    luxel_text_free(written);
    return EXIT_DONE;
}

static int run(const struct options *options)
{
    struct loaded loaded;
    int code;

    if (options->list) {
        if (options->operand || options->assignment_count > 0) {
            message_error(_("luxel scene --list takes neither a NAME nor -s"));
            return EXIT_USAGE;
        }
        print_list(options->json);
        return EXIT_DONE;
    }
    code = load_scene(options, true, &loaded);
    if (code == EXIT_DONE)
        code = print_scene(options, &loaded);
    load_clear(&loaded);
    return code;
}

const struct command command_scene = {
    .name = "scene",
    .bit = COMMAND_SCENE,
    .operand = N_("NAME"),
    .operand_kind = OPERAND_NAME,
    .summary = N_("print a scene as a file to start from"),
    .description = N_("NAME is a built-in scene, or a file: a scene, or a picture that carries its scene. Without a "
                      "NAME it is the scene \"report\". With -s the changed scene is printed."),
    .examples = "luxel scene --list\n"
                "luxel scene report > my.yaml\n"
                "luxel scene sphere.png > sphere.yaml\n"
                "luxel scene -s screen.width=800 > wide.yaml",
    .run = run,
};
