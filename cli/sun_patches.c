/* SPDX-License-Identifier: MIT */
/* On what parts of surfaces the sun shines: as text, JSON and a table. */
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "csv.h"
#include "json.h"
#include "message.h"
#include "standard_output.h"
#include "sun.h"
#include "text.h"

/* "room, floor", or "surfaces[3]" of what has no name. */
static const char *surface_text(const luxel_sun_patch *patch, char buffer[TEXT_SIZE])
{
    char number[TEXT_SIZE];
    const char *name = patch->surface_name ? patch->surface_name : text_format(number, "surfaces[%zu]", patch->surface);

    return text_format(buffer, patch->part ? "%.180s, %.180s" : "%.180s", name, patch->part ? _(patch->part) : "");
}

static void print_others(const luxel_sun_patches *found)
{
    for (size_t i = 0; i < found->count; i++) {
        const luxel_sun_patch *patch = &found->list[i];

        for (size_t k = 0; k < patch->other_count; k++)
            printf(_("  patch %zu: surfaces[%zu], which is not flat, may take some of it\n"), i + 1, patch->others[k]);
    }
}

static void print_text(const struct loaded *loaded, const luxel_sun_patches *found)
{
    struct text_table *table = text_table_new("rllrl");
    double sum = 0.0;

    text_print_escaped(stdout, loaded->name);
    printf(_(": patches of sun; it stands %.4f° above the horizon\n\n"), found->altitude_deg);
    text_table_row(table, TEXT_CELLS("", _("surface"), _("through"), _("area, m²"), _("corners, mm")));
    for (size_t i = 0; i < found->count; i++) {
        const luxel_sun_patch *patch = &found->list[i];
        char number[TEXT_SIZE], surface[TEXT_SIZE], opening[TEXT_SIZE], area[TEXT_SIZE], corner[TEXT_SIZE];

        sum += patch->area_mm2 / 1e6;
        text_format(number, "%zu", i + 1);
        text_format(area, "%.6g", patch->area_mm2 / 1e6);
        if (patch->has_opening)
            text_format(opening, "surfaces[%zu].openings[%zu]", patch->room, patch->opening);
        for (size_t k = 0; k < patch->corner_count; k++)
            text_table_row(table, TEXT_CELLS(k > 0 ? "" : number, k > 0 ? "" : surface_text(patch, surface),
                                             k > 0 || !patch->has_opening ? "" : opening, k > 0 ? "" : area,
                                             text_lengths(patch->corners_mm[k], 3, corner)));
    }
    text_table_print(table, stdout, 2);
    printf(_("\n  together %.6g m²\n"), sum);
    print_others(found);
}

static void write_patch(struct json *json, const luxel_sun_patch *patch)
{
    json_open(json, NULL, '{');
    json_whole(json, "surface", patch->surface);
    json_text(json, "name", patch->surface_name);
    json_text(json, "part", patch->part);
    if (patch->has_opening) {
        json_whole(json, "room", patch->room);
        json_whole(json, "opening", patch->opening);
    } else {
        json_null(json, "room");
        json_null(json, "opening");
    }
    json_number(json, "area_m2", patch->area_mm2 / 1e6);
    json_open(json, "corners_mm", '[');
    for (size_t i = 0; i < patch->corner_count; i++)
        json_numbers(json, NULL, patch->corners_mm[i], 3);
    json_close(json, ']');
    json_open(json, "others", '[');
    for (size_t i = 0; i < patch->other_count; i++)
        json_whole(json, NULL, patch->others[i]);
    json_close(json, ']');
    json_close(json, '}');
}

static void print_json(const luxel_sun_patches *found)
{
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    json_number(&json, "altitude", found->altitude_deg);
    json_numbers(&json, "towards", found->towards, 3);
    json_open(&json, "patches", '[');
    for (size_t i = 0; i < found->count; i++)
        write_patch(&json, &found->list[i]);
    json_close(&json, ']');
    json_close(&json, '}');
}

/* A line for each corner. */
static void write_table(struct csv *csv, const void *data)
{
    static const char *const headings[] = {"patch",   "surface", "name", "part", "room",
                                           "opening", "area_m2", "x_mm", "y_mm", "z_mm"};
    const luxel_sun_patches *found = data;

    for (size_t i = 0; i < sizeof headings / sizeof *headings; i++)
        csv_text(csv, headings[i]);
    csv_end_line(csv);
    for (size_t i = 0; i < found->count; i++) {
        const luxel_sun_patch *patch = &found->list[i];

        for (size_t k = 0; k < patch->corner_count; k++) {
            csv_whole(csv, i + 1);
            csv_whole(csv, patch->surface);
            csv_text(csv, patch->surface_name ? patch->surface_name : "");
            csv_text(csv, patch->part ? patch->part : "");
            if (patch->has_opening) {
                csv_whole(csv, patch->room);
                csv_whole(csv, patch->opening);
            } else {
                csv_blank(csv);
                csv_blank(csv);
            }
            csv_number(csv, patch->area_mm2 / 1e6);
            for (int axis = 0; axis < 3; axis++)
                csv_number(csv, patch->corners_mm[k][axis]);
            csv_end_line(csv);
        }
    }
}

int sun_print_patches(const struct options *options, const struct loaded *loaded)
{
    luxel_sun_patches *found = NULL;
    const luxel_status status = luxel_find_sun_patches(loaded->scene, loaded->diagnostics, &found);

    if (status != LUXEL_OK)
        return message_failure(status, loaded->diagnostics);
    const int code = csv_write(options, write_table, found);

    if (options->json)
        print_json(found);
    else if (options->csv == CSV_NONE && standard_output_is_free(options))
        print_text(loaded, found);
    luxel_sun_patches_free(found);
    return code;
}
