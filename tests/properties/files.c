/* SPDX-License-Identifier: MIT */
/* Sources that are read from files: they light as the same sources do that are written out. */
#include "properties.h"
#include "truth.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { KINDS = 2 };

/* One file for each kind, written anew for each scene, in a folder that goes when the program ends. */
static char folder[PATH_MAX], cloud_files[KINDS][PATH_MAX + 16], mesh_files[KINDS][PATH_MAX + 16];

static void remove_files(void)
{
    for (int kind = 0; kind < KINDS; kind++) {
        unlink(cloud_files[kind]);
        unlink(mesh_files[kind]);
    }
    rmdir(folder);
}

static void make_folder(void)
{
    const char *room = getenv("TMPDIR");
    if (folder[0])
        return;
    snprintf(folder, sizeof folder, "%s/luxel-properties-XXXXXX", room && *room ? room : "/tmp");
    if (!mkdtemp(folder))
        abort();
    for (int kind = 0; kind < KINDS; kind++) {
        snprintf(cloud_files[kind], sizeof cloud_files[kind], "%s/cloud.%s", folder, kind ? "npy" : "csv");
        snprintf(mesh_files[kind], sizeof mesh_files[kind], "%s/box.%s", folder, kind ? "obj" : "off");
    }
    atexit(remove_files);
}

static FILE *begin(const char *path)
{
    FILE *file = fopen(path, "w");
    if (!file)
        abort();
    return file;
}

static void end(FILE *file)
{
    if (fclose(file))
        abort();
}

/*
 * Whether the picture of a scene with files is that of one without, to a share of each value and a slack, or else shows
 * what is true nearby: of sources far away, or just above the horizon, pictures know but that.
 */
static bool is_alike(struct trial *trial, const struct draft *without, const struct draft *with, double share)
{
    const luxel_settings settings = trial_settings(LUXEL_DOUBLE);
    struct trial plain;
    trial_open(without, &plain);
    const luxel_field *expected = plain.scene ? trial_picture(&plain, LUXEL_DOUBLE) : NULL;
    luxel_field *picture = expected ? trial_render_draft(with, &settings) : NULL;
    const double slack = expected && draft_has_extended(without) ? 2 * trial_slack(&plain, expected) : 1e-300;
    bool holds = !expected || picture || trial_fails(trial, "with a file: illegal, or beyond the range");
    for (unsigned row = 0; holds && expected && row < luxel_field_rows(expected); row++)
        for (unsigned column = 0; holds && column < luxel_field_columns(expected); column++) {
            const double one = luxel_field_value(expected, column, row), two = luxel_field_value(picture, column, row);
            holds = fabs(one - two) <= slack + share * one || truth_allows(&plain, column, row, two, slack / 2) ||
                    trial_fails(trial, "pixel [%u, %u]: %.17g, with a file %.17g", column, row, one, two);
        }
    luxel_field_free(picture);
    trial_close(&plain);
    return holds;
}

/* ---- clouds ---- */

/* Makes all points shine as the first does; how many there are. */
static size_t make_alike(struct draft *draft)
{
    const struct draft_light *first = NULL;
    size_t count = 0;
    for (size_t i = 0; i < draft->light_count; i++) {
        struct draft_light *light = &draft->lights[i];
        if (light->words.type != DRAFT_POINT)
            continue;
        if (count++ == 0)
            first = light;
        struct draft_light alike = *first;
        memcpy(alike.numbers.place, light->numbers.place, sizeof alike.numbers.place);
        alike.numbers.strength = light->numbers.strength;
        *light = alike;
    }
    return count;
}

/* What NumPy's save() writes first of `rows` rows of four numbers, on machines whose lowest byte comes first. */
static void begin_array(FILE *file, size_t rows)
{
    enum { HEAD = 128, MAGIC = 10 };
    char text[HEAD - MAGIC];
    const int length =
        snprintf(text, sizeof text, "{'descr': '<f8', 'fortran_order': False, 'shape': (%zu, 4), }", rows);
    memset(text + length, ' ', sizeof text - (size_t)length);
    text[sizeof text - 1] = '\n';
    fwrite("\x93NUMPY\1\0", 1, MAGIC - 2, file);
    fputc(sizeof text, file);
    fputc(0, file);
    fwrite(text, 1, sizeof text, file);
}

static void write_cloud(const struct draft *draft, size_t count, bool is_array)
{
    FILE *file = begin(cloud_files[is_array]);
    if (is_array)
        begin_array(file, count);
    for (size_t i = 0; i < draft->light_count; i++) {
        const struct draft_light_numbers *numbers = &draft->lights[i].numbers;
        const double row[] = {numbers->place[0], numbers->place[1], numbers->place[2], numbers->strength};
        if (draft->lights[i].words.type != DRAFT_POINT)
            continue;
        if (is_array)
            fwrite(row, sizeof row, 1, file);
        else
            fprintf(file, "%.17g,%.17g,%.17g,%.17g\n", row[0], row[1], row[2], row[3]);
    }
    end(file);
}

bool reads_clouds(struct trial *trial)
{
    struct draft one_by_one = *trial->draft;
    const size_t count = make_alike(&one_by_one);
    bool holds = true;
    make_folder();
    for (int kind = 0; kind < KINDS && holds && count > 0; kind++) {
        write_cloud(&one_by_one, count, kind == 1);
        struct draft together = one_by_one;
        together.cloud = cloud_files[kind];
        holds = is_alike(trial, &one_by_one, &together, 1e-12);
    }
    return holds;
}

/* ---- meshes ---- */

/* Rounds the middle and the half size of a box so that its corners are exact numbers. */
static void round_corners(struct draft_light_numbers *numbers)
{
    double largest = 0;
    for (int k = 0; k < 3; k++)
        largest = fmax(largest, fmax(fabs(numbers->place[k]), numbers->size[k]));
    int exponent;
    frexp(largest, &exponent);
    const double step = ldexp(1, exponent - 40);
    for (int k = 0; k < 3; k++) {
        numbers->place[k] = nearbyint(numbers->place[k] / step) * step;
        numbers->size[k] = fmax(nearbyint(numbers->size[k] / step / 2), 1) * step * 2;
    }
}

static void write_box(const struct draft_light_numbers *numbers, bool is_object)
{
    static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    FILE *file = begin(mesh_files[is_object]);
    fputs(is_object ? "" : "OFF\n8 6 12\n", file);
    for (int corner = 0; corner < 8; corner++) {
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = numbers->place[k] + (corner >> k & 1 ? numbers->size[k] / 2 : -numbers->size[k] / 2);
        fprintf(file, "%s%.17g %.17g %.17g\n", is_object ? "v " : "", at[0], at[1], at[2]);
    }
    const int first = is_object ? 1 : 0; /* the corners' numbers begin with it */
    for (int face = 0; face < 6; face++)
        fprintf(file, "%c %d %d %d %d\n", is_object ? 'f' : '4', first + faces[face][0], first + faces[face][1],
                first + faces[face][2], first + faces[face][3]);
    end(file);
}

/* A box where the first light stands, in place of all lights. */
bool reads_meshes(struct trial *trial)
{
    enum { MOST_PIXELS = 3 };
    struct draft box = *trial->draft;
    struct draft_light *light = &box.lights[0];
    if (box.light_count == 0)
        return true;
    box.light_count = 1;
    if (!draft_is_extended(light))
        for (int k = 0; k < 3; k++)
            light->numbers.size[k] = box.surfaces[0].numbers.size[0] * (0.2 + 0.15 * k);
    light->words.type = DRAFT_VOLUME;
    light->words.shape = DRAFT_BOX;
    light->words.measure = DRAFT_RADIANCE;
    light->words.parts = 0;
    round_corners(&light->numbers);
    box.words.columns = box.words.columns < MOST_PIXELS ? box.words.columns : MOST_PIXELS;
    box.words.rows = box.words.rows < MOST_PIXELS ? box.words.rows : MOST_PIXELS;
    bool holds = true;
    make_folder();
    for (int kind = 0; kind < KINDS && holds; kind++) {
        write_box(&light->numbers, kind == 1);
        struct draft mesh = box;
        mesh.mesh = mesh_files[kind];
        holds = is_alike(trial, &box, &mesh, 1e-13);
    }
    return holds;
}
