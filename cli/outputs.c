/* SPDX-License-Identifier: MIT */
/* Names of files that are to be written: whether they can be, and whether two of them are one file. */
#include "outputs.h"

#include <errno.h>
#include <libgen.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../front/language.h"
#include "cli.h"
#include "json.h"
#include "message.h"

/* The full path of an output that may not exist yet, to tell whether two outputs are one; NULL if unknown. */
static char *full_path(const char *path)
{
    char *folder_copy, *name_copy, *folder, *joined = NULL;
    char *existing = realpath(path, NULL);

    if (existing)
        return existing;
    folder_copy = strdup(path);
    name_copy = strdup(path);
    folder = folder_copy ? realpath(dirname(folder_copy), NULL) : NULL;
    if (folder && name_copy && asprintf(&joined, "%s/%s", folder, basename(name_copy)) < 0)
        joined = NULL;
    free(folder);
    free(folder_copy);
    free(name_copy);
    return joined;
}

static bool same_target(const char *a, const char *b)
{
    char *full_a = full_path(a), *full_b = full_path(b);
    const bool same = strcmp(a, b) == 0 || (full_a && full_b && strcmp(full_a, full_b) == 0);

    free(full_a);
    free(full_b);
    return same;
}

/* The error that a file will meet, as far as it can be known without making it; 0: none. */
static int why_not(const char *path)
{
    char *copy = strdup(path);
    const char *folder = copy ? dirname(copy) : NULL;
    struct stat about;
    int error = 0;

    if (folder && stat(folder, &about) != 0)
        error = errno;
    else if (folder && !S_ISDIR(about.st_mode))
        error = ENOTDIR;
    else if (stat(path, &about) == 0 && S_ISDIR(about.st_mode))
        error = EISDIR;
    free(copy);
    return error;
}

int outputs_check_places(const struct options *options)
{
    size_t bad = 0;

    for (size_t i = 0; i < options->output_count; i++)
        bad += strcmp(options->outputs[i], "-") != 0 && why_not(options->outputs[i]) != 0;
    if (bad == 0 || bad < options->output_count)
        return EXIT_DONE; /* the others are worth writing, and what fails is reported then */
    for (size_t i = 0; i < bad; i++)
        message_error(_("cannot create %s: %s"), options->outputs[i], language_reason(why_not(options->outputs[i])));
    return EXIT_FILE;
}

static void print_json(const char *const *files, const bool *written, size_t count)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_open(&json, "files", '[');
    for (size_t i = 0; i < count; i++) {
        char *name = written[i] ? luxel_escaped_text(files[i]) : NULL; /* a file's name may be no UTF-8 */

        if (name)
            json_text(&json, NULL, name);
        luxel_text_free(name);
    }
    json_close(&json, ']');
    json_close(&json, '}');
}

void outputs_tell(const struct options *options, const char *const *files, const bool *written, size_t count)
{
    if (options->json) {
        print_json(files, written, count);
        return;
    }
    for (size_t i = 0; i < count && !options->quiet && isatty(STDERR_FILENO); i++)
        if (written[i] && strcmp(files[i], options->standard_output) != 0)
            message_note(_("%s is written"), files[i]);
}

/* A hint at the command that draws the picture which one for tables was asked for. */
static void hint_figure(const struct options *options, const char *path)
{
    static const char *const drawn[] = {".png", ".svg", ".pdf"};
    const char *scene = options->operand ? options->operand : "report";

    if (options->command->bit & (COMMAND_GRID | COMMAND_ISOPHOTES) &&
        luxel_check_ending(path, (const char *const[]){".dxf"}, 1, NULL) == LUXEL_OK)
        message_hint(_("this writes the isolux lines of a grid: luxel isophotes %s --grid 1 -o %s"), scene, path);
    if (!(options->command->bit & (COMMAND_GRID | COMMAND_ISOPHOTES | COMMAND_PROFILE)) ||
        luxel_check_ending(path, drawn, COUNT_OF(drawn), NULL) != LUXEL_OK)
        return;
    message_hint(_("this draws it: luxel figure %s -o %s%s"), scene, path,
                 options->command->bit == COMMAND_GRID      ? " --grid 1"
                 : options->command->bit == COMMAND_PROFILE ? " --section"
                                                            : "");
}

int outputs_check(const struct options *options, luxel_status (*check)(const char *, luxel_diagnostics *))
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status = check(options->outputs[i], diagnostics);

        if (status != LUXEL_OK) {
            code = message_failure(status, diagnostics);
            hint_figure(options, options->outputs[i]);
        }
        luxel_diagnostics_clear(diagnostics);
        for (size_t k = 0; k < i; k++)
            if (same_target(options->outputs[i], options->outputs[k])) {
                message_error(_("-o %s and -o %s are the same file"), options->outputs[k], options->outputs[i]);
                code = EXIT_USAGE;
            }
    }
    luxel_diagnostics_free(diagnostics);
    return code == EXIT_DONE ? outputs_check_places(options) : code;
}

luxel_status outputs_check_csv(const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".csv"};

    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}
