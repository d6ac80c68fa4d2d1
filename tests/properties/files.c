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

/* One file for each kind, written anew for each scene, in a folder that goes when the program ends. */
static struct {
    char folder[PATH_MAX], cloud[PATH_MAX + 16], mesh[PATH_MAX + 16];
} files;

static void remove_files(void)
{
    unlink(files.cloud);
    unlink(files.mesh);
    rmdir(files.folder);
}

static void make_folder(void)
{
    const char *room = getenv("TMPDIR");
    if (files.folder[0])
        return;
    snprintf(files.folder, sizeof files.folder, "%s/luxel-properties-XXXXXX", room && *room ? room : "/tmp");
    if (!mkdtemp(files.folder))
        abort();
    snprintf(files.cloud, sizeof files.cloud, "%s/cloud.csv", files.folder);
    snprintf(files.mesh, sizeof files.mesh, "%s/box.off", files.folder);
    atexit(remove_files);
}

static FILE *begin(const char *path)
{
    make_folder();
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

static void write_cloud(const struct draft *draft)
{
    FILE *file = begin(files.cloud);
    for (size_t i = 0; i < draft->light_count; i++) {
        const struct draft_light_numbers *numbers = &draft->lights[i].numbers;
        if (draft->lights[i].words.type == DRAFT_POINT)
            fprintf(file, "%.17g,%.17g,%.17g,%.17g\n", numbers->place[0], numbers->place[1], numbers->place[2],
                    numbers->strength);
    }
    end(file);
}

bool reads_clouds(struct trial *trial)
{
    struct draft one_by_one = *trial->draft;
    if (make_alike(&one_by_one) == 0)
        return true;
    write_cloud(&one_by_one);
    struct draft together = one_by_one;
    together.cloud = files.cloud;
    return is_alike(trial, &one_by_one, &together, 1e-12);
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

static void write_box(const struct draft_light_numbers *numbers)
{
    static const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    FILE *file = begin(files.mesh);
    fprintf(file, "OFF\n8 6 12\n");
    for (int corner = 0; corner < 8; corner++)
        for (int k = 0; k < 3; k++)
            fprintf(file, "%.17g%c",
                    numbers->place[k] + (corner >> k & 1 ? numbers->size[k] / 2 : -numbers->size[k] / 2),
                    k < 2 ? ' ' : '\n');
    for (int face = 0; face < 6; face++)
        fprintf(file, "4 %d %d %d %d\n", faces[face][0], faces[face][1], faces[face][2], faces[face][3]);
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
    write_box(&light->numbers);
    struct draft mesh = box;
    mesh.mesh = files.mesh;
    return is_alike(trial, &box, &mesh, 1e-13);
}
