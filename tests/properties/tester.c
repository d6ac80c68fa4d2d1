/* SPDX-License-Identifier: MIT */
/* The loop over scenes and properties, and what is told of failures. */
#include "tester.h"

#include <stdlib.h>
#include <string.h>

#include "shrink.h"

enum { MOST_REPORTS = 2, MOST_PROPERTIES = 32, BETWEEN_PROGRESS = 500 };

/* What became of a property. */
struct record {
    unsigned long tried, failed;
    char *reports[MOST_REPORTS];
};

struct tester {
    const struct property *properties;
    size_t count;
    const struct tester_options *options;
    struct record records[MOST_PROPERTIES];
    unsigned long scenes, legal, pixels, vague, excused;
};

static bool is_wanted(const struct tester *tester, size_t i)
{
    return !tester->options->only || strcmp(tester->options->only, tester->properties[i].name) == 0;
}

/* Whether a property is tried on a scene, which its seed tells.  Extended sources take a hundred times as long. */
static bool is_due(const struct tester *tester, size_t i, const struct draft *draft, uint64_t seed)
{
    const unsigned one_in = tester->properties[i].one_in * (draft_has_extended(draft) ? 4 : 1);
    return is_wanted(tester, i) && (tester->options->only || (seed + i) % one_in == 0);
}

static bool breaks(const struct draft *draft, void *data)
{
    const struct property *property = data;
    struct trial trial;
    trial_open(draft, &trial);
    const bool holds = !trial.scene || property->holds(&trial);
    trial_close(&trial);
    return !holds;
}

/* The text with a mark before each line. */
static void write_lines(FILE *out, const char *text)
{
    while (*text) {
        const int length = (int)strcspn(text, "\n");
        fprintf(out, "#   %.*s\n", length, text);
        text += length + (text[length] == '\n');
    }
}

/* Makes the draft as simple as it can be, and tells what is wrong with it. */
static char *report(const struct tester *tester, const struct property *property, const struct draft *failing,
                    uint64_t seed)
{
    char *text, *made;
    size_t length;
    struct draft draft = *failing;
    struct trial trial;
    shrink(&draft, breaks, (void *)property);
    trial_open(&draft, &trial);
    property->holds(&trial);
    FILE *out = open_memstream(&made, &length);
    if (!out)
        abort();
    text = draft_write(&draft);
    fprintf(out, "# %s (repeat: properties --seed %llu --scenes 1 --only %s", property->name, (unsigned long long)seed,
            property->name);
    if (tester->options->extended_one_in != DRAFT_EXTENDED_ONE_IN)
        fprintf(out, " --extended %u", tester->options->extended_one_in);
    fprintf(out, ")\n");
    write_lines(out, trial.complaint);
    write_lines(out, text);
    free(text);
    trial_close(&trial);
    if (fclose(out))
        abort();
    return made;
}

static void note_failure(struct tester *tester, size_t i, const struct draft *draft, uint64_t seed)
{
    struct record *record = &tester->records[i];
    if (record->failed++ >= MOST_REPORTS)
        return;
    char *text = report(tester, &tester->properties[i], draft, seed);
    record->reports[record->failed - 1] = text;
    if (tester->options->progress)
        fprintf(tester->options->progress, "\r%s", text);
}

static void try_scene(struct tester *tester, uint64_t seed)
{
    struct choices choices = choices_of_seed(seed);
    struct draft draft;
    struct trial trial;
    draft_make(&choices, tester->options->extended_one_in, &draft);
    trial_open(&draft, &trial);
    tester->scenes++;
    tester->legal += trial.scene != NULL;
    for (size_t i = 0; trial.scene && i < tester->count; i++) {
        if (!is_due(tester, i, &draft, seed))
            continue;
        tester->records[i].tried++;
        if (!tester->properties[i].holds(&trial))
            note_failure(tester, i, &draft, seed);
    }
    tester->pixels += trial.pixels;
    tester->vague += trial.vague;
    tester->excused += trial.excused;
    trial_close(&trial);
}

static void show_progress(const struct tester *tester, unsigned long done)
{
    if (tester->options->progress && done % BETWEEN_PROGRESS == 0) {
        fprintf(tester->options->progress, "\r%lu of %lu scenes", done, tester->options->scenes);
        fflush(tester->options->progress);
    }
}

static void write_result(const struct property *property, struct record *record, size_t number, FILE *out)
{
    fprintf(out, "%sok %zu - %s: %s", record->failed ? "not " : "", number, property->name, property->meaning);
    if (record->tried)
        fprintf(out, " (%lu scenes, %lu failed)\n", record->tried, record->failed);
    else
        fprintf(out, " # SKIP no scene was due\n");
    for (int i = 0; i < MOST_REPORTS; i++) {
        fputs(record->reports[i] ? record->reports[i] : "", out);
        free(record->reports[i]);
    }
}

static size_t write_results(struct tester *tester, FILE *out)
{
    size_t broken = 0, number = 0, tried = 0;
    for (size_t i = 0; i < tester->count; i++) {
        if (!is_wanted(tester, i))
            continue;
        broken += tester->records[i].failed > 0;
        tried += tester->records[i].tried;
        write_result(&tester->properties[i], &tester->records[i], ++number, out);
    }
    fprintf(out, "1..%zu\n# %lu of %lu scenes are legal\n", number, tester->legal, tester->scenes);
    fprintf(out, "# %lu pixels against the truth, %lu of them where it is vague, %lu by their neighbourhood\n",
            tester->pixels, tester->vague, tester->excused);
    return tried > 0 ? broken : 1;
}

size_t tester_run(const struct property *properties, size_t count, const struct tester_options *options, FILE *out)
{
    struct tester tester = {.properties = properties, .count = count, .options = options};
    if (count > MOST_PROPERTIES)
        abort();
    for (unsigned long i = 0; i < options->scenes && !(options->stop && *options->stop); i++) {
        try_scene(&tester, options->seed + i);
        show_progress(&tester, i + 1);
    }
    if (options->progress)
        fprintf(options->progress, "\n");
    return write_results(&tester, out);
}
