/* SPDX-License-Identifier: MIT */
/* Comma-separated values, to standard output and to files. */
#include "csv.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"
#include "text.h"

void csv_begin(struct csv *csv, FILE *stream, enum option_csv variant)
{
    *csv = (struct csv){.stream = stream, .variant = variant};
    if (variant == CSV_EXCEL_RU)
        fputs("\xef\xbb\xbf", stream);
}

static void separate(struct csv *csv)
{
    if (csv->in_line)
        fputc(csv->variant == CSV_EXCEL_RU ? ';' : ',', csv->stream);
    csv->in_line = true;
}

void csv_text(struct csv *csv, const char *text)
{
    separate(csv);
    if (!strpbrk(text, ",;\"\r\n")) {
        fputs(text, csv->stream);
        return;
    }
    fputc('"', csv->stream);
    for (; *text; text++)
        fputs(*text == '"' ? "\"\"" : (const char[]){*text, '\0'}, csv->stream);
    fputc('"', csv->stream);
}

void csv_heading(struct csv *csv, const char *name, const char *unit)
{
    char heading[TEXT_SIZE];

    csv_text(csv, text_format(heading, "%s%s%s", name, *unit ? "_" : "", unit));
}

void csv_number(struct csv *csv, double value)
{
    char number[64];
    char *point;

    if (!isfinite(value)) {
        csv_blank(csv);
        return;
    }
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(number, sizeof number, "%.*g", digits, value + 0.0); /* -0 becomes 0 */
        if (strtod(number, NULL) == value)
            break;
    }
    point = strchr(number, '.');
    if (point && csv->variant == CSV_EXCEL_RU)
        *point = ',';
    separate(csv);
    fputs(number, csv->stream);
}

void csv_whole(struct csv *csv, size_t value)
{
    separate(csv);
    fprintf(csv->stream, "%zu", value);
}

void csv_blank(struct csv *csv)
{
    separate(csv);
}

void csv_end_line(struct csv *csv)
{
    fputs("\r\n", csv->stream);
    csv->in_line = false;
}

static int write_file(const char *path, const char *bytes, size_t size)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    const luxel_status status = luxel_text_write(path, bytes, size, diagnostics);
    const int code = status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);

    luxel_diagnostics_free(diagnostics);
    return code;
}

int csv_write(const struct options *options, void (*write)(struct csv *csv, const void *data), const void *data)
{
    const enum option_csv variant = options->csv == CSV_EXCEL_RU ? CSV_EXCEL_RU : CSV_RFC4180;
    char *bytes = NULL;
    size_t size = 0;
    struct csv csv;
    int code = EXIT_DONE;
    FILE *memory;

    if (options->csv != CSV_NONE) {
        csv_begin(&csv, stdout, variant);
        write(&csv, data);
    }
    if (options->output_count == 0)
        return EXIT_DONE;
    memory = open_memstream(&bytes, &size);
    if (memory) {
        csv_begin(&csv, memory, variant);
        write(&csv, data);
    }
    if (!memory || ferror(memory) || fclose(memory) != 0) {
        message_error(_("out of memory"));
        free(bytes);
        return EXIT_SCENE;
    }
    for (size_t i = 0; i < options->output_count; i++) {
        const int file_code = write_file(options->outputs[i], bytes, size);

        code = file_code == EXIT_DONE ? code : file_code;
    }
    free(bytes);
    return code;
}
