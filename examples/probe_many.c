/* SPDX-License-Identifier: MIT */
/*
 * Exact values at many places, of a scene that is prepared once for all of them, by several threads:
 *
 *     probe_many [FILE.yaml [PLACES]]
 *
 * Without a file it takes the built-in scene "report".  PLACES is a table or an array of free surface elements with the
 * columns x, y, z, nx, ny, nz; without it 100 x 100 points of the screen are probed.
 */
#include <luxel/luxel.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 100 };

static const luxel_table_column columns[] = {
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"x", NULL}},
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"y", NULL}},
    {.type = LUXEL_TABLE_LENGTH, .is_required = true, .names = (const char *const[]){"z", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = true, .names = (const char *const[]){"nx", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = true, .names = (const char *const[]){"ny", NULL}},
    {.type = LUXEL_TABLE_NUMBER, .is_required = true, .names = (const char *const[]){"nz", NULL}},
};

static void print_message(const luxel_diagnostics *diagnostics)
{
    char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);

    fprintf(stderr, "%s\n", message ? message : "no memory is left");
    luxel_text_free(message);
}

/* The centres of SIDE x SIDE parts of a square on the screen, 500 mm wide. */
static luxel_place *screen_places(size_t *count)
{
    luxel_place *places = calloc((size_t)SIDE * SIDE, sizeof *places);

    for (size_t i = 0; places && i < (size_t)SIDE * SIDE; i++) {
        places[i].screen_mm[0] = ((double)(i % SIDE) + 0.5) * 500.0 / SIDE - 250.0;
        places[i].screen_mm[1] = 250.0 - ((double)(i / SIDE) + 0.5) * 500.0 / SIDE;
    }
    *count = (size_t)SIDE * SIDE;
    return places;
}

/* The elements of a table.  Rows that are wrong are reported, and none of the others is returned then. */
static luxel_status read_places(const char *path, luxel_diagnostics *diagnostics, luxel_place **places, size_t *count)
{
    luxel_table *table = NULL;
    const luxel_table_row *row;
    size_t room = 0;
    luxel_status status =
        luxel_table_open(path, columns, sizeof columns / sizeof columns[0], false, diagnostics, &table);

    *places = NULL;
    *count = 0;
    while (status == LUXEL_OK && luxel_table_next(table, &row)) {
        if (!row) {
            status = LUXEL_ERROR_FILE;
        } else if (*count == room) {
            luxel_place *more = realloc(*places, (room = 2 * room + 1024) * sizeof *more);

            status = more ? LUXEL_OK : LUXEL_ERROR_MEMORY;
            *places = more ? more : *places;
        }
        if (status == LUXEL_OK) {
            luxel_place *place = memset(&(*places)[(*count)++], 0, sizeof *place);

            place->is_element = true;
            memcpy(place->position_mm, row->numbers, sizeof place->position_mm);
            memcpy(place->normal, row->numbers + 3, sizeof place->normal);
        }
    }
    luxel_table_free(table);
    return status;
}

/* How many places have a value, and the greatest one.  Off the surfaces there is none. */
static void print_probes(const luxel_probes *probes, const char *unit)
{
    const luxel_probe *greatest = NULL;
    double sum = 0.0, error = 0.0;
    size_t values = 0;

    for (size_t i = 0; i < luxel_probes_count(probes); i++) {
        const luxel_probe *probe = luxel_probes_get(probes, i);
        if (!probe->has_value)
            continue;
        values++;
        sum += probe->value;
        error = fmax(error, probe->error);
        if (!greatest || probe->value > greatest->value)
            greatest = probe;
    }
    printf("%zu places, %zu with a value\n", luxel_probes_count(probes), values);
    if (greatest)
        printf("mean %.9g %s, errors at most %.1e\ngreatest %.12g %s at (%.6g, %.6g, %.6g) mm\n", sum / (double)values,
               unit, error, greatest->value, unit, greatest->position_mm[0], greatest->position_mm[1],
               greatest->position_mm[2]);
}

static luxel_status probe(const luxel_scene *scene, const char *path, luxel_diagnostics *diagnostics)
{
    luxel_place *places = NULL;
    luxel_probes *probes = NULL;
    size_t count = 0;
    luxel_status status = LUXEL_OK;

    if (path)
        status = read_places(path, diagnostics, &places, &count);
    else if (!(places = screen_places(&count)))
        status = LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        status = luxel_probe_places(scene, NULL, places, count, diagnostics, &probes);
    if (status == LUXEL_OK)
        print_probes(probes, luxel_scene_unit(scene, LUXEL_BRIGHTNESS));
    luxel_probes_free(probes);
    free(places);
    return status;
}

int main(int argc, char **argv)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_status status = argc > 1 ? luxel_scene_read_file(argv[1], diagnostics, &scene)
                                   : luxel_scene_open_builtin("report", diagnostics, &scene);

    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status == LUXEL_OK)
        status = probe(scene, argc > 2 ? argv[2] : NULL, diagnostics);
    if (status != LUXEL_OK)
        print_message(diagnostics);

    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    return status == LUXEL_OK ? 0 : 1;
}
