/* SPDX-License-Identifier: MIT */
/*
 * Writing tables of probes.  Those of .csv have names in their first line under which luxel probe --points reads free
 * elements again: x_mm, y_mm, z_mm, nx, ny, nz.  An .npy file holds the values alone, float64 in the order of the
 * places, NaN where there is none.
 */
#include "probe_table.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cli.h"
#include "csv.h"
#include "message.h"
#include "outputs.h"

static const char *const endings[] = {".csv", ".npy", ".json"};
enum { ENDING_CSV, ENDING_NPY, ENDING_JSON, ENDINGS };

static size_t ending_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    size_t i = 0;

    while (i < ENDINGS && !(dot && strcasecmp(dot, endings[i]) == 0))
        i++;
    return i;
}

luxel_status probe_table_check_name(const char *path, luxel_diagnostics *diagnostics)
{
    return luxel_check_ending(path, endings, ENDINGS, diagnostics);
}

bool probe_table_is_json(const struct options *options)
{
    for (size_t i = 0; i < options->output_count; i++)
        if (ending_of(options->outputs[i]) == ENDING_JSON)
            return true;
    return false;
}

static void write_numbers_if(struct csv *csv, bool exist, const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (exist)
            csv_number(csv, numbers[i]);
        else
            csv_blank(csv);
}

static void write_line(struct csv *csv, const luxel_probe *probe, size_t number, bool in_color)
{
    csv_whole(csv, number);
    write_numbers_if(csv, probe->has_screen, (const double[]){probe->x_mm, probe->y_mm}, 2);
    write_numbers_if(csv, probe->on_surface, probe->position_mm, 3);
    write_numbers_if(csv, probe->on_surface, probe->normal, 3);
    write_numbers_if(csv, probe->has_value, (const double[]){probe->value, probe->error}, 2);
    if (in_color)
        write_numbers_if(csv, probe->color.exists, probe->color.rgb, 3);
    if (probe->on_surface && probe->surface != SIZE_MAX)
        csv_whole(csv, probe->surface);
    else
        csv_blank(csv);
    csv_end_line(csv);
}

static void write_csv(FILE *stream, const struct result *result)
{
    static const char *const names[] = {"point", "screen_x_mm", "screen_y_mm", "x_mm", "y_mm",
                                        "z_mm",  "nx",          "ny",          "nz"};
    static const char *const channels[] = {"red", "green", "blue"};
    const bool in_color = luxel_scene_has_color(result->scene);
    struct csv csv;

    csv_begin(&csv, stream, CSV_RFC4180);
    for (size_t i = 0; i < COUNT_OF(names); i++)
        csv_text(&csv, names[i]);
    csv_heading(&csv, "value", result_unit(result));
    csv_heading(&csv, "error", result_unit(result));
    for (size_t c = 0; in_color && c < COUNT_OF(channels); c++)
        csv_heading(&csv, channels[c], result_unit(result));
    csv_text(&csv, "surface");
    csv_end_line(&csv);
    for (size_t i = 0; i < result->count; i++)
        write_line(&csv, luxel_probes_get(result->probes, i), i + 1, in_color);
}

/* NPY 1.0: magic, version, length of the header, the header with blanks up to a multiple of 64, numbers. */
static void write_npy(FILE *stream, const struct result *result)
{
    enum { BEGINNING = 10, MULTIPLE = 64 };
    char header[2 * MULTIPLE];
    int length =
        snprintf(header, sizeof header, "{'descr': '<f8', 'fortran_order': False, 'shape': (%zu,), }", result->count);
    const int padded = (BEGINNING + length + MULTIPLE) / MULTIPLE * MULTIPLE - BEGINNING;

    memset(header + length, ' ', (size_t)(padded - length));
    header[padded - 1] = '\n';
    fwrite("\x93NUMPY\x01\x00", 1, 8, stream);
    fputc(padded & 0xff, stream);
    fputc(padded >> 8, stream);
    fwrite(header, 1, (size_t)padded, stream);
    for (size_t i = 0; i < result->count; i++) {
        const luxel_probe *probe = luxel_probes_get(result->probes, i);
        const double value = probe->has_value ? probe->value : (double)NAN;
        uint64_t bits;

        memcpy(&bits, &value, sizeof bits);
        for (unsigned byte = 0; byte < sizeof bits; byte++)
            fputc((int)(bits >> (8 * byte) & 0xff), stream);
    }
}

static int write_file(const struct result *result, const char *path, luxel_diagnostics *diagnostics)
{
    static void (*const writers[ENDINGS])(FILE *, const struct result *) = {write_csv, write_npy, result_write_json};
    char *bytes = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&bytes, &size);
    luxel_status status;

    if (memory)
        writers[ending_of(path)](memory, result);
    if (!memory || ferror(memory) || fclose(memory) != 0) {
        message_error(_("out of memory"));
        free(bytes);
        return EXIT_SCENE;
    }
    status = luxel_text_write(path, bytes, size, diagnostics);
    free(bytes);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
}

int probe_table_write(const struct result *result)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    int code = EXIT_DONE;

    for (size_t i = 0; i < result->options->output_count; i++) {
        const int file_code = write_file(result, result->options->outputs[i], diagnostics);

        code = file_code == EXIT_DONE ? code : file_code;
        luxel_diagnostics_clear(diagnostics);
    }
    luxel_diagnostics_free(diagnostics);
    return code;
}
