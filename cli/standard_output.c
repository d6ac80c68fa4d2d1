/* SPDX-License-Identifier: MIT */
/* Standard output as the file of `-o -`: its format, and what else may not be printed then. */
#include "standard_output.h"

#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "cli.h"
#include "message.h"
#include "text.h"

/* The library takes standard output by this name, with an extension behind it. */
#define STANDARD_OUTPUT "/dev/stdout"

static bool is_standard_output(const char *path)
{
    static const char *const names[] = {"-", STANDARD_OUTPUT, "/dev/fd/1", "/proc/self/fd/1"};

    for (size_t i = 0; i < COUNT_OF(names); i++)
        if (strcmp(path, names[i]) == 0)
            return true;
    return false;
}

/* Bytes that a terminal would not show. */
static bool is_binary(const char *format)
{
    static const char *const binary[] = {"png", "npy", "pfm", "exr", "pdf"};

    for (size_t i = 0; i < COUNT_OF(binary); i++)
        if (strcasecmp(format, binary[i]) == 0)
            return true;
    return false;
}

/* "png, npy, csv": the formats that a command writes, from its extensions ".png .npy .csv". */
static const char *list_formats(const struct command *command, char list[TEXT_SIZE])
{
    char endings[TEXT_SIZE];
    size_t used = 0;

    for (const char *at = command_endings(command, endings, sizeof endings); *at && used + 2 < TEXT_SIZE; at++) {
        if (*at == ' ')
            list[used++] = ',';
        if (*at != '.')
            list[used++] = *at;
    }
    list[used] = '\0';
    return list;
}

/* Whether a format is among those of the list. */
static bool is_listed(const char *format, const char *list)
{
    const size_t length = strlen(format);

    for (const char *at = list; *at; at += strspn(at, ", ")) {
        const size_t word = strcspn(at, ",");

        if (word == length && strncasecmp(at, format, length) == 0)
            return true;
        at += word;
    }
    return false;
}

/* The format of standard output; NULL: none or a wrong one was named. */
static const char *choose_format(const struct options *options, const char *output)
{
    const char *wanted = options->format_word ? options->format_word : options->command->default_format;
    char list[TEXT_SIZE];

    list_formats(options->command, list);
    if (!wanted) {
        message_error(_("-o %s: standard output needs a format"), output);
        message_hint(_("add --format NAME, which is one of %s"), list);
        return NULL;
    }
    if (!is_listed(wanted, list)) {
        message_error(_("%s %s: expected one of %s"), "--format", wanted, list);
        return NULL;
    }
    if (is_binary(wanted) && isatty(STDOUT_FILENO)) {
        message_error(_("-o %s: a terminal cannot show a .%s file"), output, wanted);
        message_hint(_("send it to a program or a file: | or >"));
        return NULL;
    }
    return wanted;
}

/* luxel explain prints its document wherever no other file is named, in the form that --format says. */
static bool resolve_document(struct options *options)
{
    size_t kept = 0, count = options->output_count;

    for (size_t i = 0; i < count; i++)
        if (!is_standard_output(options->outputs[i]))
            options->outputs[kept++] = options->outputs[i];
    options->output_count = kept;
    options->prints_document = kept == 0 || kept < count || options->format_word;
    return !options->format_word || options_take_document_format(options);
}

bool standard_output_resolve(struct options *options)
{
    if (!options->command || options->help || (options->command->bit & COMMAND_SET))
        return true;
    if (options->command->bit & COMMAND_EXPLAIN)
        return resolve_document(options);
    for (size_t i = 0; i < options->output_count; i++) {
        const char *format;

        if (!is_standard_output(options->outputs[i]))
            continue;
        format = choose_format(options, options->outputs[i]);
        if (!format)
            return false;
        snprintf(options->standard_output, sizeof options->standard_output, STANDARD_OUTPUT ".%s", format);
        options->outputs[i] = options->standard_output;
    }
    if (options->standard_output[0] == '\0' && options->format_word) {
        message_error(_("--format names the format of standard output, and no file of -o is that"));
        message_hint(_("add -o - or let the extension of FILE name the format"));
        return false;
    }
    if (options->standard_output[0] != '\0' && (options->json || options->csv != CSV_NONE)) {
        message_error(_("-o - and %s cannot both have standard output"), options->json ? "--json" : "--csv");
        return false;
    }
    return true;
}

bool standard_output_is_free(const struct options *options)
{
    return options->standard_output[0] == '\0' && !(options->quiet && options->output_count > 0);
}

bool standard_output_is_named(const char *text)
{
    return strstr(text, STANDARD_OUTPUT ".") != NULL;
}

bool standard_output_reader_left(void)
{
    struct pollfd out = {.fd = STDOUT_FILENO, .events = POLLOUT};

    return poll(&out, 1, 0) > 0 && (out.revents & (POLLERR | POLLHUP)) != 0;
}
