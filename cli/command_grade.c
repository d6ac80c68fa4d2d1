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
#include "sheets.h"
#include "text.h"

/* "place: pixel; division by π: true", in the user's language or in English; "" where there is none. */
static char *explanation_of(const struct graded *graded, bool translated)
{
    const luxel_judgement *judgement = graded->judgement;
    const enum grade grade = grading_grade(graded);
    size_t size = 256;
    char *text;

    if (grade != GRADE_CONVENTION) {
        text = message_allocate(size, 1);
        if (graded->is_of_pixel)
            snprintf(text, size, "%s: %s", translated ? _("place") : N_("place"),
                     translated ? _("pixel") : N_("pixel"));
        if (grade == GRADE_COARSE)
            snprintf(text, size, "%s", translated ? _("too few digits") : N_("too few digits"));
        if (grade == GRADE_REPEATED)
            snprintf(text, size,
                     translated ? _("the point was answered in line %u already")
                                : N_("the point was answered in line %u already"),
                     graded->first->line);
        return text;
    }
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
    const double factor = grading_factor(graded);
    char *explanation;

    fputs("  ---\n", stdout);
    printf("  verdict: %s\n", grade_words[grading_grade(graded)]);
    if (graded->answer) {
        explanation = explanation_of(graded, true);
        print_number("answer", !isnan(graded->answer->value), graded->answer->value);
        print_number("value", graded->judgement->has_value, graded->judgement->value);
        if (isfinite(factor))
            printf("  factor: %.6g\n  relative: %.6g\n", factor, factor - 1.0);
        if (*explanation) {
            fputs("  explanation: '", stdout);
            for (const char *at = explanation; *at; at++)
                fputs(*at == '\'' ? "''" : (const char[]){*at, '\0'}, stdout);
            fputs("'\n", stdout);
        }
        free(explanation);
    }
    fputs("  ...\n", stdout);
}

static void print_graded(const struct grading *grading, const struct graded *graded, size_t number)
{
    const struct submission *submission = &grading->submissions[graded->submission];
    const bool right = grading_grade(graded) == GRADE_RIGHT;
    char place[TEXT_SIZE];

    printf("%s %zu - ", right ? "ok" : "not ok", number);
    print_description(grading->answers.files[submission->file]);
    if (graded->answer)
        printf(":%u", graded->answer->line);
    fputs(": ", stdout);
    if (submission->student) {
        print_description(submission->student);
        fputs(", ", stdout);
    }
    printf(_("variant %u"), graded->variant);
    fputs(", ", stdout);
    if (graded->point > 0)
        printf("P%u ", graded->point);
    fputs(text_lengths((const double[]){graded->x_mm, graded->y_mm}, 2, place), stdout);
    puts(graded->answer ? "" : _(": no answer"));
    if (!right)
        print_block(graded);
}

/* One of the numbers that a summary tells where they are not 0. */
static void print_count(const char *format, size_t count)
{
    if (count == 0)
        return;
    fputs(", ", stdout);
    printf(format, count);
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
    printf(_(": %zu right, %zu by another convention, %zu wrong"), submission->counts[GRADE_RIGHT],
           submission->counts[GRADE_CONVENTION], submission->counts[GRADE_WRONG]);
    print_count(_("%zu with too few digits"), submission->counts[GRADE_COARSE]);
    print_count(_("%zu repeated"), submission->counts[GRADE_REPEATED]);
    if (submission->answered < submission->asked)
        printf(_("; %zu of %zu points answered"), submission->answered, submission->asked);
    fputc('\n', stdout);
}

static void print_tap(const struct grading *grading)
{
    size_t number = 0;

    printf("TAP version 13\n1..%zu\n", grading_total(grading));
    for (size_t i = 0; i < grading->count; i++)
        if (grading_tells(&grading->list[i]))
            print_graded(grading, &grading->list[i], ++number);
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

/* Whose it is, and which point or place. */
static void write_place(struct json *json, const struct grading *grading, const struct graded *graded)
{
    const struct submission *submission = &grading->submissions[graded->submission];

    write_text(json, "file", grading->answers.files[submission->file]);
    if (graded->answer)
        json_whole(json, "line", graded->answer->line);
    write_text(json, "student", submission->student);
    json_whole(json, "variant", graded->variant);
    if (graded->point > 0)
        json_whole(json, "point", graded->point);
    else
        json_null(json, "point");
    json_numbers(json, "screen", (const double[]){graded->x_mm, graded->y_mm}, 2);
}

static void write_answer(struct json *json, const struct grading *grading, const struct graded *graded)
{
    const luxel_judgement *judgement = graded->judgement;
    const enum grade grade = grading_grade(graded);

    json_open(json, NULL, '{');
    write_place(json, grading, graded);
    json_number(json, "answer", graded->answer->value);
    json_text(json, "verdict", grade_words[grade]);
    json_bool(json, "too_few_digits", judgement->verdict == LUXEL_ANSWER_COARSE);
    if (graded->first)
        json_whole(json, "first_line", graded->first->line);
    json_number(json, "value", judgement->has_value ? judgement->value : (double)NAN);
    json_number(json, "error", judgement->has_value ? judgement->error : (double)NAN);
    json_number(json, "factor", grading_factor(graded));
    json_number(json, "relative", grading_factor(graded) - 1.0);
    json_text(json, "accepted", graded->is_of_pixel ? "pixel" : NULL);
    json_open(json, "explanations", '[');
    for (size_t i = 0; i < judgement->explanation_count; i++)
        write_explanation(json, &judgement->explanations[i]);
    json_close(json, ']');
    json_close(json, '}');
}

static void write_missing(struct json *json, const struct grading *grading)
{
    json_open(json, "missing_points", '[');
    for (size_t i = 0; i < grading->count; i++) {
        if (grading->list[i].answer)
            continue;
        json_open(json, NULL, '{');
        write_place(json, grading, &grading->list[i]);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static void write_counts(struct json *json, const size_t counts[GRADE_COUNT])
{
    for (size_t i = 0; i < GRADE_COUNT; i++)
        json_whole(json, grade_words[i], counts[i]);
}

static void write_submission(struct json *json, const struct grading *grading, const struct submission *submission)
{
    json_open(json, NULL, '{');
    write_text(json, "file", grading->answers.files[submission->file]);
    write_text(json, "student", submission->student);
    json_whole(json, "asked", submission->asked);
    json_whole(json, "answered", submission->answered);
    write_counts(json, submission->counts);
    json_close(json, '}');
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
    write_missing(&json, grading);
    json_open(&json, "submissions", '[');
    for (size_t i = 0; i < grading->submission_count; i++)
        write_submission(&json, grading, &grading->submissions[i]);
    json_close(&json, ']');
    write_counts(&json, grading->counts);
    json_whole(&json, "mistakes", grading->answers.mistakes);
    json_close(&json, '}');
}

/* ---- CSV ---- */

static void write_row(struct csv *csv, const struct grading *grading, const struct graded *graded)
{
    const struct submission *submission = &grading->submissions[graded->submission];
    const struct answer *answer = graded->answer;
    const luxel_judgement *judgement = graded->judgement;
    char *explanation = answer ? explanation_of(graded, false) : NULL;

    csv_text(csv, grading->answers.files[submission->file]);
    if (answer)
        csv_whole(csv, answer->line);
    else
        csv_blank(csv);
    csv_text(csv, submission->student ? submission->student : "");
    csv_whole(csv, graded->variant);
    if (graded->point > 0)
        csv_whole(csv, graded->point);
    else
        csv_blank(csv);
    csv_number(csv, graded->x_mm);
    csv_number(csv, graded->y_mm);
    csv_number(csv, answer ? answer->value : (double)NAN);
    csv_number(csv, judgement && judgement->has_value ? judgement->value : (double)NAN);
    csv_text(csv, grade_words[grading_grade(graded)]);
    csv_text(csv, explanation ? explanation : "");
    csv_number(csv, grading_factor(graded));
    csv_end_line(csv);
    free(explanation);
}

static void write_csv(struct csv *csv, const void *data)
{
    static const char *const names[] = {"file", "line",   "student", "variant", "point",       "x_mm",
                                        "y_mm", "answer", "value",   "verdict", "explanation", "factor"};
    const struct grading *grading = data;

    for (size_t i = 0; i < COUNT_OF(names); i++)
        csv_text(csv, names[i]);
    csv_end_line(csv);
    for (size_t i = 0; i < grading->count; i++)
        if (grading_tells(&grading->list[i]))
            write_row(csv, grading, &grading->list[i]);
}

/* ---- one line a student ---- */

/* The name of a submission, of its student or else of its file. */
static char *name_of(const struct grading *grading, const struct submission *submission)
{
    const char *path = grading->answers.files[submission->file];
    char *name = strdup(submission->student ? submission->student : basename(path));
    char *dot = name && !submission->student ? strrchr(name, '.') : NULL;

    if (dot && dot > name)
        *dot = '\0';
    return name;
}

static void write_students(struct csv *csv, const void *data)
{
    static const char *const names[] = {"file", "student", "variants", "asked", "answered"};
    const struct grading *grading = data;

    for (size_t i = 0; i < COUNT_OF(names); i++)
        csv_text(csv, names[i]);
    for (size_t i = 0; i < GRADE_COUNT; i++)
        csv_text(csv, grade_words[i]);
    csv_end_line(csv);
    for (size_t i = 0; i < grading->submission_count; i++) {
        const struct submission *submission = &grading->submissions[i];
        char *name = name_of(grading, submission), *variants = sheets_variants(grading, i);

        csv_text(csv, grading->answers.files[submission->file]);
        csv_text(csv, name ? name : "");
        csv_text(csv, variants);
        csv_whole(csv, submission->asked);
        csv_whole(csv, submission->answered);
        for (size_t k = 0; k < GRADE_COUNT; k++)
            csv_whole(csv, submission->counts[k]);
        csv_end_line(csv);
        free(variants);
        free(name);
    }
}

/* ---- the command ---- */

static int print(const struct options *options, const struct grading *grading)
{
    int code = EXIT_DONE;

    if (options->json)
        print_json(grading);
    else if (options->csv != CSV_NONE)
        code = csv_write(options, options->by_student ? write_students : write_csv, grading);
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
    if (options->json && (options->csv != CSV_NONE || options->by_student)) {
        message_error(options->by_student ? _("--json and --students are mutually exclusive; its \"submissions\" are "
                                              "the students")
                                          : _("--json and --csv are mutually exclusive"));
        return EXIT_USAGE;
    }
    code = grading_make(options, &grading);
    if (code == EXIT_DONE && (grading_total(&grading) > 0 || options->json))
        code = print(options, &grading);
    if (code == EXIT_DONE && (grading.answers.mistakes > 0 || grading_total(&grading) == 0)) {
        if (grading.answers.mistakes == 0)
            message_error(_("there are no answers to judge"));
        code = EXIT_FILE;
    } else if (code == EXIT_DONE && grading.counts[GRADE_RIGHT] < grading_total(&grading)) {
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
        "Each ANSWERS is a table of values separated by commas, semicolons or tabs, or a folder of such .csv and .tsv "
        "files, whose first line names the columns: variant,point,value or variant,x,y,value, and student where there "
        "are several. Decimal commas are understood; \"off\" is the answer for a place off the surface, and an empty "
        "cell, \"-\", \"?\" or \"n/a\" is none. An answer is right if it agrees "
        "with the exact value to --tolerance (default 0.001) and the rounding of its digits, of which three are "
        "asked for; the exact value correctly rounded to fewer has too few digits. Of a wrong one it is said which "
        "convention, or which two, would give it, and how many times the right value it is. Each point of a variant is "
        "to be answered once: points without an "
        "answer are listed, and a second answer to a point does not count. The exit code is 0 where all is right, "
        "else 1. The result is TAP, with a summary of each submission. --json has answers (file, line, student, "
        "variant, point, screen, answer, verdict: right, convention, wrong, too_few_digits or repeated, first_line, "
        "value, error, factor, relative, accepted, explanations), missing_points, submissions (with asked and "
        "answered), the totals and the number "
        "of mistakes in the tables. With -s all variants are changed alike."),
    .examples = "luxel grade answers.csv\n"
                "luxel grade submissions/ --students --csv=excel-ru > marks.csv\n"
                "luxel grade answers.csv --accept pixel\n"
                "luxel grade answers.csv --tolerance 0.01 -s 'lights[0].attenuation=inverse-square'",
    .run = run,
};
