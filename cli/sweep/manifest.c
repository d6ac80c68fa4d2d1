/* SPDX-License-Identifier: MIT */
/* The manifest of a sweep: what the folder holds, with the sum of each file, and whose it is. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../json.h"
#include "../message.h"
#include "sweep.h"

static const char manifest_name[] = "manifest.json", identity_key[] = "\"identity\": \"";

/* The sums of a shard as members of "files"; false: they cannot be read. */
static bool add_sums(struct json *json, const struct sweep *sweep, uint64_t shard)
{
    char name[FOLDER_NAME], path[2 * FOLDER_NAME + ARRAY_NAME], hex[SHA256_HEX];
    size_t length;
    struct sha256 sum;

    snprintf(path, sizeof path, "%s/SHA256SUMS", folder_shard_name(shard, name));

    char *text = folder_read(&sweep->folder, path, &length);

    if (!text)
        return false;
    sha256_begin(&sum, sweep->by_instructions);
    sha256_add(&sum, text, length);
    sha256_end(&sum, hex);
    json_text(json, path, hex);
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        char file[ARRAY_NAME];

        if (sscanf(line, "%64[0-9a-f]  %63s", hex, file) != 2)
            continue;
        snprintf(path, sizeof path, "%s/%s", name, file);
        json_text(json, path, hex);
    }
    free(text);
    return true;
}

static void add_parameters(struct json *json, const struct sweep *sweep)
{
    json_open(json, "parameters", '[');
    for (size_t p = 0; p < luxel_study_parameter_count(sweep->study); p++) {
        char *name = luxel_study_parameter_name(sweep->study, p);

        json_open(json, NULL, '{');
        json_text(json, "name", name);
        if (luxel_study_parameter_word(sweep->study, p, 0)) {
            json_open(json, "values", '[');
            for (size_t v = 0; luxel_study_parameter_word(sweep->study, p, v); v++)
                json_text(json, NULL, luxel_study_parameter_word(sweep->study, p, v));
            json_close(json, ']');
        }
        json_close(json, '}');
        luxel_text_free(name);
    }
    json_close(json, ']');
}

static void add_outputs(struct json *json, const struct sweep *sweep)
{
    const luxel_scene *base = luxel_study_base(sweep->study);

    json_open(json, "outputs", '{');
    for (luxel_study_output k = 0; k < LUXEL_STUDY_OUTPUTS; k++)
        if (luxel_study_wanted(sweep->study, k) != LUXEL_STUDY_NONE)
            json_text(json, luxel_study_output_name(k), luxel_study_type_name(luxel_study_wanted(sweep->study, k)));
    json_close(json, '}');
    json_open(json, "units", '{');
    json_text(json, "brightness", luxel_scene_unit(base, LUXEL_BRIGHTNESS));
    json_text(json, "irradiance", luxel_scene_unit(base, LUXEL_IRRADIANCE));
    json_close(json, '}');
    if (luxel_study_wanted(sweep->study, LUXEL_STUDY_STATISTICS) != LUXEL_STUDY_NONE) {
        json_open(json, "statistics", '[');
        for (size_t i = 0; i < SWEEP_STATISTICS; i++)
            json_text(json, NULL, sweep_statistics[i]);
        json_close(json, ']');
    }
}

/* All that a manifest says; counts the whole shards. */
static void compose(FILE *stream, const struct sweep *sweep, uint64_t *whole)
{
    struct json json = {.stream = stream};

    *whole = 0;
    for (uint64_t shard = 0; shard < sweep->shards; shard++)
        *whole += sweep_has(sweep, shard);
    json_open(&json, NULL, '{');
    json_whole(&json, "sweep", 1);
    json_text(&json, "identity", sweep->identity);
    json_text(&json, "luxel", luxel_version());
    json_text(&json, "instruction_set", sweep->instruction_set);
    json_whole(&json, "scenes", sweep->scenes);
    json_whole(&json, "shards", sweep->shards);
    json_whole(&json, "shard", luxel_study_shard(sweep->study));
    json_wholes(&json, "resolution", (const unsigned[]){sweep->columns, sweep->rows}, 2);
    add_parameters(&json, sweep);
    add_outputs(&json, sweep);
    json_bool(&json, "complete", *whole == sweep->shards);
    json_open(&json, "files", '{');
    for (uint64_t shard = 0; shard < sweep->shards; shard++)
        if (sweep_has(sweep, shard))
            add_sums(&json, sweep, shard);
    json_close(&json, '}');
    json_close(&json, '}');
}

int sweep_write_manifest(struct sweep *sweep, uint64_t *whole)
{
    char *text = NULL;
    size_t length;
    int failed;

    folder_lock_manifest(&sweep->folder, true);

    FILE *stream = open_memstream(&text, &length);

    if (!stream) {
        message_error(_("out of memory"));
        return EXIT_SCENE;
    }
    compose(stream, sweep, whole);
    fclose(stream);
    failed = folder_write(&sweep->folder, manifest_name, text, length);
    folder_lock_manifest(&sweep->folder, false);
    free(text);
    if (failed == 0)
        return EXIT_DONE;
    message_error(_("%s/%s cannot be written: %s"), sweep->folder.path, manifest_name, language_reason(failed));
    return EXIT_FILE;
}

int sweep_check_begun(const struct sweep *sweep, const char *path)
{
    char *name = message_allocate(strlen(path) + sizeof "/" + sizeof manifest_name, 1);
    int failed;

    stpcpy(stpcpy(stpcpy(name, path), "/"), manifest_name);
    failed = access(name, F_OK) == 0 ? 0 : errno;
    free(name);
    if (failed == 0)
        return EXIT_DONE;
    message_error(_("%s/%s cannot be read: %s"), path, manifest_name, language_reason(failed));
    message_hint(_("luxel sweep %s -o %s computes what is missing"), sweep->study_name, path);
    return EXIT_FILE;
}

int sweep_claim(struct sweep *sweep)
{
    size_t length;
    char *text = folder_read(&sweep->folder, manifest_name, &length);
    const char *found = text ? strstr(text, identity_key) : NULL;
    const bool same = found && strncmp(found + strlen(identity_key), sweep->identity, SHA256_HEX - 1) == 0;
    uint64_t whole;

    if (!text)
        return sweep_write_manifest(sweep, &whole);
    if (same) {
        free(text);
        return EXIT_DONE;
    }
    if (!found)
        message_error(_("%s holds a manifest.json that is none of a sweep"), sweep->folder.path);
    else
        message_error(_("%s holds another sweep: its identity is %.12s, that of %s is %.12s"), sweep->folder.path,
                      found + strlen(identity_key), sweep->study_name, sweep->identity);
    message_hint(_("take another folder; the study, its scene, the version of Luxel (here %s) and the instruction set "
                   "(here %s, LUXEL_ISA chooses it) must be those that the folder was begun with"),
                 luxel_version(), sweep->instruction_set);
    free(text);
    return EXIT_FILE;
}
