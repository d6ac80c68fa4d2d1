/* SPDX-License-Identifier: MIT */
/* Reads scenes from where the command line says, and reports all that is wrong with them in one go. */
#include "load.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../front/language.h"
#include "cli.h"
#include "message.h"

static const char default_scene[] = "report";

size_t load_find_builtin(const char *name)
{
    size_t i = 0;

    while (i < luxel_builtin_scene_count() && strcmp(luxel_builtin_scene_name(i), name ? name : default_scene) != 0)
        i++;
    return i;
}

static void suggest_builtin(const char *typed)
{
    const size_t count = luxel_builtin_scene_count();
    const char **names = message_allocate(count, sizeof *names);

    for (size_t i = 0; i < count; i++)
        names[i] = luxel_builtin_scene_name(i);
    if (luxel_nearest_word(typed, names, count))
        message_did_you_mean(luxel_nearest_word(typed, names, count));
    else if (!strpbrk(typed, "./"))
        message_hint(_("luxel scene --list names the built-in scenes"));
    free(names);
}

/* Reads a little more than the library accepts at most, so that it is the library that refuses. */
int load_standard_input(char **text, size_t *length)
{
    const size_t most = ((size_t)64 << 20) + 1;
    size_t capacity = (size_t)1 << 16;

    *text = message_allocate(capacity, 1);
    *length = 0;
    for (;;) {
        const ssize_t got = read(STDIN_FILENO, *text + *length, capacity - *length);

        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            message_error(_("standard input could not be read: %s"), language_reason(errno));
            return EXIT_FILE;
        }
        *length += (size_t)got;
        if (got == 0 || *length >= most)
            return EXIT_DONE;
        if (*length == capacity) {
            char *bigger = message_allocate(2 * capacity, 1);

            memcpy(bigger, *text, *length);
            free(*text);
            *text = bigger;
            capacity *= 2;
        }
    }
}

static int open_standard_input(struct loaded *loaded)
{
    char *text;
    size_t length;
    int code;

    loaded->name = "<stdin>";
    code = load_standard_input(&text, &length);
    if (code == EXIT_DONE) {
        const luxel_status status =
            luxel_scene_read_text(text, length, loaded->name, loaded->diagnostics, &loaded->scene);

        code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
    }
    free(text);
    return code;
}

static int open_builtin(const char *name, struct loaded *loaded)
{
    luxel_status status;

    status = luxel_scene_open_builtin(name, loaded->diagnostics, &loaded->scene);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
}

static int open_file(const char *path, struct loaded *loaded)
{
    luxel_status status;

    if (access(path, F_OK) != 0 && errno == ENOENT) {
        message_error(_("%s: no such file, and no built-in scene of that name"), path);
        suggest_builtin(path);
        return EXIT_FILE;
    }
    status = luxel_scene_read_file(path, loaded->diagnostics, &loaded->scene);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, loaded->diagnostics);
}

/*
 * A file goes before a built-in scene of the same name, so that a new built-in never takes a file away; but where
 * built-in ones are asked for, they go first, or `luxel scene report > report` would read what it is about to write.
 */
static int open_scene(const char *operand, bool builtin_first, struct loaded *loaded)
{
    const bool is_builtin = load_find_builtin(operand) < luxel_builtin_scene_count();
    const bool is_file = operand && access(operand, F_OK) == 0;

    loaded->name = operand ? operand : default_scene;
    if (operand && strcmp(operand, "-") == 0)
        return open_standard_input(loaded);
    if (!operand || (is_builtin && (builtin_first || !is_file)))
        return open_builtin(loaded->name, loaded);
    return open_file(operand, loaded);
}

struct options load_options(const struct options *options, const struct loaded *loaded)
{
    struct options merged = *options;

    merged.settings.lights = loaded->lights;
    merged.settings.light_count = loaded->light_count;
    if (!luxel_scene_settings(loaded->scene, &merged.settings))
        return merged;
    if (options_given(options, "quantity"))
        merged.settings.quantity = options->settings.quantity;
    if (options_given(options, "precision"))
        merged.settings.precision = options->settings.precision;
    if (options_given(options, "tolerance"))
        merged.settings.tolerance = options->settings.tolerance;
    if (options_given(options, "light-error"))
        merged.settings.light_error = options->settings.light_error;
    if (options_given(options, "reflected-error"))
        merged.settings.reflected_error = options->settings.reflected_error;
    return merged;
}

/* Goes on after an error, to report all of them; a path that names nothing weighs most. */
static luxel_status change_and_commit(const struct options *options, const struct loaded *loaded)
{
    luxel_status worst = LUXEL_OK;

    for (size_t i = 0; i <= options->assignment_count; i++) {
        const luxel_status status = i < options->assignment_count
                                        ? luxel_scene_set(loaded->scene, options->assignments[i], loaded->diagnostics)
                                        : luxel_scene_commit(loaded->scene, loaded->diagnostics);

        if (worst == LUXEL_OK || status == LUXEL_ERROR_PATH)
            worst = status;
    }
    return worst;
}

static int refuse_advice(const struct loaded *loaded)
{
    const luxel_status status = luxel_scene_advise(loaded->scene, loaded->diagnostics);

    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    if (luxel_diagnostics_total(loaded->diagnostics, LUXEL_SEVERITY_ADVICE) == 0)
        return EXIT_DONE;
    message_diagnostics(stderr, loaded->diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ERROR);
    return EXIT_SCENE;
}

/* The light of this name, else of this number; the count of all where there is none. */
static size_t find_light(const luxel_scene *scene, const char *word)
{
    const size_t count = luxel_scene_light_count(scene);
    char *end;
    unsigned long long number;

    for (size_t i = 0; i < count; i++)
        if (luxel_scene_light_name(scene, i) && strcmp(luxel_scene_light_name(scene, i), word) == 0)
            return i;
    if (!isdigit((unsigned char)*word))
        return count;
    number = strtoull(word, &end, 10);
    return *end == '\0' && number < count ? (size_t)number : count;
}

static void refuse_light(const luxel_scene *scene, const char *word)
{
    const size_t count = luxel_scene_light_count(scene);
    const char **names = message_allocate(count + 1, sizeof *names);
    size_t named = 0;

    for (size_t i = 0; i < count; i++)
        if (luxel_scene_light_name(scene, i))
            names[named++] = luxel_scene_light_name(scene, i);
    message_error(_("--lights: the scene has no light \"%s\"; it has %zu, numbered from 0"), word, count);
    message_did_you_mean(luxel_nearest_word(word, names, named));
    free(names);
}

/* Finds the lights that --lights names. */
static int choose_lights(const char *list, struct loaded *loaded)
{
    char *words = strdup(list), *rest = words, *word;
    int code = EXIT_DONE;

    loaded->lights = message_allocate(strlen(list) + 1, sizeof *loaded->lights);
    while (words && (word = strsep(&rest, ",")) != NULL) {
        const size_t light = find_light(loaded->scene, word);

        if (light == luxel_scene_light_count(loaded->scene)) {
            refuse_light(loaded->scene, word);
            code = EXIT_USAGE;
        } else {
            loaded->lights[loaded->light_count++] = light;
        }
    }
    free(words);
    return code;
}

int load_scene(const struct options *options, bool builtin_first, struct loaded *loaded)
{
    luxel_status status;
    int code;

    *loaded = (struct loaded){.diagnostics = message_new_diagnostics()};
    code = open_scene(options->operand, builtin_first, loaded);
    if (code != EXIT_DONE)
        return code;
    status = change_and_commit(options, loaded);
    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    if (options->lights)
        code = choose_lights(options->lights, loaded);
    return code == EXIT_DONE && options->strict ? refuse_advice(loaded) : code;
}

void load_clear(struct loaded *loaded)
{
    free(loaded->lights);
    luxel_scene_free(loaded->scene);
    luxel_diagnostics_free(loaded->diagnostics);
}

int load_and(const struct options *options, int (*action)(const struct options *, const struct loaded *))
{
    struct loaded loaded;
    int code = load_scene(options, false, &loaded);

    if (code == EXIT_DONE) {
        const struct options merged = load_options(options, &loaded);

        code = action(&merged, &loaded);
    }
    load_clear(&loaded);
    return code;
}
