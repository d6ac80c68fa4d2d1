/* SPDX-License-Identifier: MIT */
/* luxel grade: tables of answers judged against the exact values, as TAP, JSON or CSV. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "csv.h"
#include "grading.h"
#include "json.h"
#include "message.h"
#include "options.h"
#include "text.h"

static const char *const verdict_words[] = {"right", "convention", "wrong"};

/* "place: pixel; division by π: true", in the user's language or in English; "" where there is none. */
static char *explanation_of(const struct graded *graded, bool translated)
{
    const luxel_judgement *judgement = graded->judgement;
    size_t size = 256;
    char *text;

    for (size_t i = 0; i < judgement->explanation_count; i++)
        size += strlen(judgement->explanations[i].choice) * 4 + strlen(judgement->explanations[i].convention) * 4 + 64;
    text = message_allocate(size, 1);
    for (size_t i = 0; i < judgement->explanation_count; i++) {
        const luxel_alternative *choice = &judgement->explanations[i];
        const size_t used = strlen(text);

        snprintf(text + used, size - used, "%s%s: %s", i > 0 ? "; " : "",
                 translated ? _(choice->convention) : choice->convention,
                 translated ? _(choice->choice) : choice->choice);
    }
    if (grading_is_coarse(graded))
        snprintf(text, size, "%s", translated ? _("too few digits") : N_("too few digits"));
    return text;
}

/* ---- TAP ---- */

/* A description in TAP ends at '#', which would begin a directive. */
static void print_description(const char *text)
{
    char *escaped = luxel_escaped_text(text);

    for (const char *at = escaped; at && *at; at++) {
        if (*at == '#' || *at == '\\')
            putchar('\\');
        putchar(*at);
    }
    luxel_text_free(escaped);
}

static void print_number(const char *key, bool exists, double value)
{
    if (exists)
        printf("  %s: %.15g\n", key, value + 0.0);
    else
        printf("  %s: null\n", key);
}

/* The block of YAML under what is not right.  Its texts are ours, and quotes are doubled in them. */
static void print_block(const struct graded *graded)
{
    char *explanation = explanation_of(graded, true);

    fputs("  ---\n", stdout);
    printf("  verdict: %s\n", verdict_words[graded->judgement->verdict]);
    print_number("answer", !isnan(graded->answer->value), graded->answer->value);
    print_number("value", graded->judgement->has_value, graded->judgement->value);
    if (*explanation) {
        fputs("  explanation: '", stdout);
        for (const char *at = explanation; *at; at++)
            fputs(*at == '\'' ? "''" : (const char[]){*at, '\0'}, stdout);
        fputs("'\n", stdout);
    }
    fputs("  ...\n", stdout);
    free(explanation);
}

static void print_answer(const struct grading *grading, const struct graded *graded, size_t number)
{
    const struct answer *answer = graded->answer;
    const bool right = graded->judgement->verdict == LUXEL_ANSWER_RIGHT;
    char place[TEXT_SIZE];

    printf("%s %zu - ", right ? "ok" : "not ok", number);
    print_description(grading->answers.files[answer->file]);
    printf(":%u: ", answer->line);
    if (answer->student) {
        print_description(answer->student);
        fputs(", ", stdout);
    }
    printf(_("variant %u"), answer->variant);
    fputs(", ", stdout);
    if (answer->point > 0)
        printf("P%u ", answer->point);
    puts(text_lengths((const double[]){graded->x_mm, graded->y_mm}, 2, place));
    if (!right)
        print_block(graded);
}

/* After the last test, as comments. */
static void print_submission(const struct grading *grading, const struct submission *submission)
{
    fputs("# ", stdout);
    text_print_escaped(stdout, grading->answers.files[submission->file]);
    if (submission->student) {
        fputs(", ", stdout);
        text_print_escaped(stdout, submission->student);
    }
    printf(_(": %zu right, %zu by another convention, %zu wrong\n"), submission->counts[LUXEL_ANSWER_RIGHT],
           submission->counts[LUXEL_ANSWER_CONVENTION], submission->counts[LUXEL_ANSWER_WRONG]);
}

static size_t judged_count(const struct grading *grading)
{
    return grading->counts[0] + grading->counts[1] + grading->counts[2];
}

static void print_tap(const struct grading *grading)
{
    size_t number = 0;

    printf("TAP version 13\n1..%zu\n", judged_count(grading));
    for (size_t i = 0; i < grading->answers.count; i++)
        if (grading->list[i].judgement)
            print_answer(grading, &grading->list[i], ++number);
    for (size_t i = 0; i < grading->submission_count; i++)
        print_submission(grading, &grading->submissions[i]);
}

/* ---- JSON ---- */

/* A text of the user's, which may be no UTF-8. */
static void write_text(struct json *json, const char *key, const char *text)
{
    char *escaped = text ? luxel_escaped_text(text) : NULL;

    json_text(json, key, escaped);
    luxel_text_free(escaped);
}

static void write_explanation(struct json *json, const luxel_alternative *choice)
{
    json_open(json, NULL, '{');
    json_text(json, "convention", choice->convention);
    json_text(json, "choice", choice->choice);
    json_text(json, "assignment", choice->assignment);
    json_close(json, '}');
}

static void write_answer(struct json *json, const struct grading *grading, const struct graded *graded)
{
    const struct answer *answer = graded->answer;
    const luxel_judgement *judgement = graded->judgement;

    json_open(json, NULL, '{');
    write_text(json, "file", grading->answers.files[answer->file]);
    json_whole(json, "line", answer->line);
    write_text(json, "student", answer->student);
    json_whole(json, "variant", answer->variant);
    if (answer->point > 0)
        json_whole(json, "point", answer->point);
    else
        json_null(json, "point");
    json_numbers(json, "screen", (const double[]){graded->x_mm, graded->y_mm}, 2);
    json_number(json, "answer", answer->value);
    json_text(json, "verdict", verdict_words[judgement->verdict]);
    json_bool(json, "too_few_digits", grading_is_coarse(graded));
    json_number(json, "value", judgement->has_value ? judgement->value : (double)NAN);
    json_number(json, "error", judgement->has_value ? judgement->error : (double)NAN);
    json_open(json, "explanations", '[');
    for (size_t i = 0; i < judgement->explanation_count; i++)
        write_explanation(json, &judgement->explanations[i]);
    json_close(json, ']');
    json_close(json, '}');
}

static void write_counts(struct json *json, const size_t counts[3])
{
    for (size_t i = 0; i < COUNT_OF(verdict_words); i++)
        json_whole(json, verdict_words[i], counts[i]);
}

static void print_json(const struct grading *grading)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_number(&json, "tolerance", grading->tolerance);
    json_open(&json, "answers", '[');
    for (size_t i = 0; i < grading->answers.count; i++)
        if (grading->list[i].judgement)
            write_answer(&json, grading, &grading->list[i]);
    json_close(&json, ']');
    json_open(&json, "submissions", '[');
    for (size_t i = 0; i < grading->submission_count; i++) {
        json_open(&json, NULL, '{');
        write_text(&json, "file", grading->answers.files[grading->submissions[i].file]);
        write_text(&json, "student", grading->submissions[i].student);
        write_counts(&json, grading->submissions[i].counts);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    write_counts(&json, grading->counts);
    json_whole(&json, "mistakes", grading->answers.mistakes);
    json_close(&json, '}');
}

/* ---- CSV ---- */

static void write_row(struct csv *csv, const struct grading *grading, const struct graded *graded)
{
    const struct answer *answer = graded->answer;
    const luxel_judgement *judgement = graded->judgement;
    char *explanation = explanation_of(graded, false);

    csv_text(csv, grading->answers.files[answer->file]);
    csv_whole(csv, answer->line);
    csv_text(csv, answer->student ? answer->student : "");
    csv_whole(csv, answer->variant);
    if (answer->point > 0)
        csv_whole(csv, answer->point);
    else
        csv_blank(csv);
    csv_number(csv, graded->x_mm);
    csv_number(csv, graded->y_mm);
    csv_number(csv, answer->value);
    csv_number(csv, judgement->has_value ? judgement->value : (double)NAN);
    csv_text(csv, verdict_words[judgement->verdict]);
    csv_text(csv, explanation);
    csv_end_line(csv);
    free(explanation);
}

static void write_csv(struct csv *csv, const void *data)
{
    static const char *const names[] = {"file", "line",   "student", "variant", "point",      "x_mm",
                                        "y_mm", "answer", "value",   "verdict", "explanation"};
    const struct grading *grading = data;

    for (size_t i = 0; i < COUNT_OF(names); i++)
        csv_text(csv, names[i]);
    csv_end_line(csv);
    for (size_t i = 0; i < grading->answers.count; i++)
        if (grading->list[i].judgement)
            write_row(csv, grading, &grading->list[i]);
}

/* ---- the command ---- */

static int print(const struct options *options, const struct grading *grading)
{
    int code = EXIT_DONE;

    if (options->json)
        print_json(grading);
    else if (options->csv != CSV_NONE)
        code = csv_write(options, write_csv, grading);
    else
        print_tap(grading);
    return code;
}

static int run(const struct options *options)
{
    struct grading grading;
    int code;

    if (!options->operand) {
        message_error(_("luxel grade needs a table of answers, or a folder of them"));
        return EXIT_USAGE;
    }
    if (options->json && options->csv != CSV_NONE) {
        message_error(_("--json and --csv exclude each other"));
        return EXIT_USAGE;
    }
    code = grading_make(options, &grading);
    if (code == EXIT_DONE && (judged_count(&grading) > 0 || options->json))
        code = print(options, &grading);
    if (code == EXIT_DONE && (grading.answers.mistakes > 0 || judged_count(&grading) == 0)) {
        if (grading.answers.mistakes == 0)
            message_error(_("there are no answers to judge"));
        code = EXIT_FILE;
    } else if (code == EXIT_DONE && grading.counts[LUXEL_ANSWER_RIGHT] < judged_count(&grading)) {
        code = EXIT_DIFFERENCE;
    }
    grading_clear(&grading);
    return code;
}

const struct command command_grade = {
    .name = "grade",
    .bit = COMMAND_GRADE,
    .operand = N_("ANSWERS"),
    .operand_kind = OPERAND_FILE,
    .more = N_("[ANSWERS]"),
    .more_kind = OPERAND_FILE,
    .summary = N_("judge tables of answers to variants of the exercise"),
    .description = N_(
        "Each ANSWERS is a table of comma-separated values, or a folder of them, whose first line names the columns: "
        "variant,point,value or variant,x,y,value, and student where there are several. Semicolons and decimal "
        "commas are understood; \"off\" is the answer for a place off the surface. An answer is right if it agrees "
        "with the exact value to --tolerance (default 0.001) and the rounding of its digits, of which three are "
        "asked for. Of a wrong one it is said which convention, or which two, would give it. The result is TAP, "
        "with a summary of each submission. --json has answers (file, line, student, variant, point, screen, answer, "
        "verdict: right, convention or wrong, too_few_digits, value, error, explanations), submissions, the totals "
        "and the number of mistakes in the tables. With -s all variants are changed alike."),
    .examples = "luxel grade answers.csv\n"
                "luxel grade submissions/ --csv=excel-ru > marks.csv\n"
                "luxel grade answers.csv --tolerance 0.01 -s lights[0].attenuation=inverse-square",
    .run = run,
};
