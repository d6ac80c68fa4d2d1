/* SPDX-License-Identifier: MIT */
/* luxel set: changes values of a scene file in place, and leaves its comments and layout as they are. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "json.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "outputs.h"

/* Whether a file holds exactly this text; one that cannot be read does not. */
static bool holds(const char *path, const char *text)
{
    const size_t length = strlen(text);
    char *bytes = message_allocate(length + 1, 1);
    FILE *file = fopen(path, "rb");
    bool same = false;

    if (file) {
        same = fread(bytes, 1, length + 1, file) == length && !ferror(file) && memcmp(bytes, text, length) == 0;
        fclose(file);
    }
    free(bytes);
    return same;
}

static int print(const struct options *options, const struct loaded *loaded, const char *text)
{
    if (options->json) {
        struct json json = {.stream = stdout};
        char *name = luxel_escaped_text(loaded->name); /* a file's name may be no UTF-8 */

        json_open(&json, NULL, '{');
        json_text(&json, "name", name);
        json_text(&json, "text", text);
        json_close(&json, '}');
        luxel_text_free(name);
    } else {
        fputs(text, stdout);
    }
    return EXIT_DONE;
}

static int write_file(const struct loaded *loaded, const char *path)
{
    const luxel_status status = luxel_scene_write_file(loaded->scene, path, loaded->diagnostics);

    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
}

static bool is_dash(const char *path)
{
    return strcmp(path, "-") == 0;
}

/* To the files of -o; all of them are tried. */
static int write_outputs(const struct options *options, const struct loaded *loaded, const char *text)
{
    bool *written = message_allocate(options->output_count, sizeof *written);
    int worst = EXIT_DONE;
    bool is_printed = false;

    for (size_t i = 0; i < options->output_count; i++) {
        const char *path = options->outputs[i];
        const int code = is_dash(path) ? print(options, loaded, text) : write_file(loaded, path);

        is_printed = is_printed || is_dash(path);
        written[i] = code == EXIT_DONE && !is_dash(path);
        worst = code != EXIT_DONE ? code : worst;
    }
    if (!is_printed)
        outputs_tell(options, options->outputs, written, options->output_count);
    free(written);
    return worst;
}

/* A file that would stay as it is is not touched. */
static int rewrite(const struct options *options, const struct loaded *loaded, const char *text)
{
    const bool same = holds(options->operand, text);
    const int code = same ? EXIT_DONE : write_file(loaded, options->operand);

    if (code == EXIT_DONE)
        outputs_tell(options, &options->operand, (const bool[]){!same}, 1);
    return code;
}

/* To where the scene came from: its file, or else standard output. */
static int write_back(const struct options *options, const struct loaded *loaded, const char *text)
{
    luxel_settings settings;
    struct stat about;

    luxel_settings_init(&settings);
    if (options->dry_run)
        return print(options, loaded, text);
    if (luxel_scene_settings(loaded->scene, &settings)) {
        message_error(_("%s is a picture: its scene cannot be changed in place"), loaded->name);
        message_hint(_("-o FILE writes the changed scene"));
        return EXIT_USAGE;
    }
    if (strcmp(options->operand, "-") == 0 || stat(options->operand, &about) != 0 || !S_ISREG(about.st_mode))
        return print(options, loaded, text);
    return rewrite(options, loaded, text);
}

/* A scene may be written that no picture can be made of, as another change may mend it; `luxel check` refuses it. */
static void judge(const struct loaded *loaded)
{
    luxel_diagnostics_clear(loaded->diagnostics);
    if (luxel_scene_surface_count(loaded->scene) == 0 ||
        luxel_scene_check_view(loaded->scene, loaded->diagnostics) == LUXEL_OK)
        return;
    message_note(_("no picture can be made of this scene:"));
    message_diagnostics(stderr, loaded->diagnostics, LUXEL_SEVERITY_ERROR, LUXEL_SEVERITY_ADVICE);
}

static int set(const struct options *options, const struct loaded *loaded)
{
    char *text = NULL;
    const luxel_status status = luxel_scene_write_text(loaded->scene, &text);
    int code;

    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    if (options->output_count > 0 && !options->dry_run)
        code = write_outputs(options, loaded, text);
    else
        code = write_back(options, loaded, text);
    luxel_text_free(text);
    if (code == EXIT_DONE && !options->quiet)
        judge(loaded);
    return code;
}

/* A scene under the name of a picture would be one that nothing can show. */
static bool names_scenes(const struct options *options)
{
    for (size_t i = 0; i < options->output_count; i++)
        if (luxel_check_output_name(options->outputs[i], NULL) == LUXEL_OK) {
            message_error(_("-o %s: luxel set writes scenes, not pictures"), options->outputs[i]);
            message_hint(_("luxel render -s KEY=VALUE -o FILE writes the picture of a changed scene"));
            return false;
        }
    return true;
}

static int run(const struct options *options)
{
    struct loaded loaded;
    int code;

    if (!names_scenes(options))
        return EXIT_USAGE;
    if (!options->operand || options->assignment_count == 0) {
        message_error(_("luxel set needs a SCENE and what to change in it"));
        message_hint(_("for example: luxel set my.yaml 'lights[0].intensity=20'"));
        return EXIT_USAGE;
    }
    code = outputs_check_places(options);
    if (code != EXIT_DONE)
        return code;
    code = load_scene(options, false, &loaded);
    if (code == EXIT_DONE)
        code = set(options, &loaded);
    load_clear(&loaded);
    return code;
}

const struct command command_set = {
    .name = "set",
    .bit = COMMAND_SET,
    .operand = N_("SCENE"),
    .more = N_("KEY=VALUE"),
    .more_kind = OPERAND_NONE,
    .endings = ".yaml .yml .json",
    .summary = N_("change values of a scene file, keeping its comments and layout"),
    .description = N_("Writes the new values into the file and leaves the rest of it as it is. A scene that would have "
                      "errors is not written; of one that no picture can be made of it says why. What is read from "
                      "standard input, or a built-in scene, goes to "
                      "standard output."),
    .examples = "luxel set my.yaml 'lights[0].intensity=20' screen.sampling=nodes\n"
                "luxel set my.yaml 'surfaces[0].material.shininess=60' --dry-run\n"
                "luxel set report observer.view=observer -o my.yaml",
    .run = run,
};
