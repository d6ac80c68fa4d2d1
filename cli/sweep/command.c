/* SPDX-License-Identifier: MIT */
/* The run of luxel sweep: the scenes of a study, shown one by one, counted, computed into a folder, or put into one
 * file. */
#include <errno.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <luxel/luxel.h>

#include "../cli.h"
#include "../json.h"
#include "../load.h"
#include "../message.h"
#include "../options.h"
#include "command.h"
#include "merge.h"
#include "../text.h"

static unsigned processors(void)
{
    cpu_set_t set;

    return sched_getaffinity(0, sizeof set, &set) == 0 ? (unsigned)CPU_COUNT(&set) : 1;
}

static int read_study(const struct options *options, luxel_diagnostics *diagnostics, luxel_study **study)
{
    luxel_status status;

    if (!options->operand) {
        message_error(_("luxel sweep needs a study file"));
        message_hint(_("luxel help sweep shows one"));
        return EXIT_USAGE;
    }
    if (strcmp(options->operand, "-") == 0) {
        char *text;
        size_t length;
        const int code = load_standard_input(&text, &length);

        status = code == EXIT_DONE ? luxel_study_read_text(text, length, "<stdin>", diagnostics, study) : LUXEL_OK;
        free(text);
        if (code != EXIT_DONE)
            return code;
    } else {
        status = luxel_study_read_file(options->operand, diagnostics, study);
    }
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
}

static int show(const struct options *options, const luxel_study *study, luxel_diagnostics *diagnostics)
{
    luxel_scene *scene;
    luxel_status status;
    char *text;

    if (options->sweep.show >= luxel_study_count(study)) {
        message_error(_("--show %llu: the study has %llu scenes, from 0 on"), (unsigned long long)options->sweep.show,
                      (unsigned long long)luxel_study_count(study));
        return EXIT_USAGE;
    }
    status = luxel_study_scene(study, options->sweep.show, diagnostics, &scene);
    if (status != LUXEL_OK)
        return message_failure(status, diagnostics);
    status = luxel_scene_write_text(scene, &text);
    luxel_scene_free(scene);
    if (status != LUXEL_OK)
        return message_failure(status, diagnostics);
    fputs(text, stdout);
    luxel_text_free(text);
    return EXIT_DONE;
}

/* How much it is: scenes, bytes, and the time as far as some scenes tell. */
static int estimate(const struct options *options, struct sweep *sweep, unsigned workers)
{
    struct sweep_worker worker;
    const int code = sweep_worker_init(&worker, sweep);
    const double seconds_of_one = code == EXIT_DONE ? sweep_time_of_scene(&worker, 0.3) : 0.0;
    const double bytes = (double)sweep_bytes(sweep);
    const double seconds = seconds_of_one * (double)sweep->scenes / workers;

    sweep_worker_clear(&worker);
    if (code != EXIT_DONE || seconds_of_one < 0.0)
        return code != EXIT_DONE ? code : EXIT_SCENE;
    if (options->json) {
        struct json json = {.stream = stdout};

        json_open(&json, NULL, '{');
        json_whole(&json, "scenes", sweep->scenes);
        json_whole(&json, "shards", sweep->shards);
        json_whole(&json, "bytes", sweep_bytes(sweep));
        json_number(&json, "seconds_per_scene", seconds_of_one);
        json_whole(&json, "workers", workers);
        json_number(&json, "seconds", seconds);
        json_text(&json, "identity", sweep->identity);
        json_close(&json, '}');
        return EXIT_DONE;
    }
    printf(_("scenes: %llu, shards: %llu, size: %.1f MB\n"), (unsigned long long)sweep->scenes,
           (unsigned long long)sweep->shards, bytes * 1e-6);
    printf(ngettext("about %.3g s with %u worker, %.0f µs a scene\n", "about %.3g s with %u workers, %.0f µs a scene\n",
                    workers),
           seconds, workers, seconds_of_one * 1e6);
    return EXIT_DONE;
}

static int compute(const struct options *options, struct sweep *sweep, unsigned workers)
{
    const struct sweep_run how = {workers, options->quiet, options->json};
    int code = folder_open(&sweep->folder, options->outputs[0], options->sweep.part, options->sweep.parts);

    if (code == EXIT_DONE)
        code = sweep_claim(sweep);
    if (code == EXIT_DONE)
        code = sweep_work(sweep, &how);
    return code;
}

/* Merges what is there: no folder is begun for it. */
static int merge(const struct options *options, struct sweep *sweep)
{
    int code = sweep_check_begun(sweep, options->outputs[0]);

    if (code == EXIT_DONE)
        code = folder_open(&sweep->folder, options->outputs[0], 0, 1);
    if (code == EXIT_DONE)
        code = sweep_claim(sweep);
    return code == EXIT_DONE ? sweep_merge(sweep, options) : code;
}

static int with_study(const struct options *options, const luxel_study *study, luxel_diagnostics *diagnostics)
{
    const unsigned workers = options->sweep.workers ? options->sweep.workers : processors();
    struct sweep sweep;
    int code;

    if (options_given(options, "show"))
        return show(options, study, diagnostics);
    if (!options->dry_run && options->output_count != 1) {
        message_error(_("luxel sweep needs one folder to write to: -o FOLDER"));
        message_hint(_("--dry-run tells how much it is, --show 0 prints the first scene"));
        return EXIT_USAGE;
    }
    sweep_init(&sweep, study, options->operand);
    code = sweep_check(&sweep);
    if (code == EXIT_DONE)
        code = options->dry_run                  ? estimate(options, &sweep, workers)
               : options_given(options, "merge") ? merge(options, &sweep)
                                                 : compute(options, &sweep, workers);
    sweep_clear(&sweep);
    return code;
}

int sweep_command_run(const struct options *options)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    luxel_study *study = NULL;
    int code = read_study(options, diagnostics, &study);

    if (code == EXIT_DONE)
        code = with_study(options, study, diagnostics);
    luxel_study_free(study);
    luxel_diagnostics_free(diagnostics);
    return code;
}
