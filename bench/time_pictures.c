/* SPDX-License-Identifier: MIT */
/*
 * Times the pictures of scenes: time_pictures ROUNDS THREADS SIDE SCENE...  Scenes are files or built-in names, SIDE
 * their pixels along the longer side; 0: as they are.  Each round renders all of them in turn, so that all meet the
 * same moods of the machine; the least time of each is printed in ms, one a line.  By one thread it is processor time,
 * which other programs weigh on least.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <luxel/luxel.h>

/* A picture that takes less is rendered again within a round, until so much time has gone. */
static const double LEAST_MS = 20;

static double now_ms(unsigned threads)
{
    struct timespec now;
    clock_gettime(threads == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

/* Gives the scene so many pixels along the longer side, as square as they were. */
static luxel_status resize(luxel_scene *scene, double side, luxel_diagnostics *diagnostics)
{
    char resolution[64];
    unsigned columns, rows;
    luxel_status status = luxel_scene_resolution(scene, &columns, &rows);
    if (status != LUXEL_OK)
        return status;
    const double scale = side / (columns > rows ? columns : rows);
    snprintf(resolution, sizeof resolution, "screen.resolution=[%.0f, %.0f]", scale * columns, scale * rows);
    return luxel_scene_set(scene, resolution, diagnostics);
}

static luxel_scene *open_scene(const char *name, double side)
{
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_status status = strchr(name, '.') ? luxel_scene_read_file(name, diagnostics, &scene)
                                            : luxel_scene_open_builtin(name, diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    if (status == LUXEL_OK && side > 0)
        status = resize(scene, side, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    luxel_diagnostics_free(diagnostics);
    if (status == LUXEL_OK)
        return scene;
    fprintf(stderr, "%s is no scene\n", name);
    exit(3);
}

/* The time of one picture, the least of some. */
static double time_picture(const luxel_scene *scene, unsigned threads)
{
    double best = 1e300, gone = 0;
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = threads;
    while (gone < LEAST_MS) {
        luxel_field *field = NULL;
        const double begun = now_ms(threads);
        if (luxel_render(scene, &settings, NULL, &field) != LUXEL_OK)
            exit(1);
        const double taken = now_ms(threads) - begun;
        luxel_field_free(field);
        best = taken < best ? taken : best;
        gone += taken > 0.1 ? taken : 0.1;
    }
    return best;
}

int main(int argc, char **argv)
{
    enum { OPTIONS = 4 };
    if (argc <= OPTIONS) {
        fprintf(stderr, "usage: time_pictures ROUNDS THREADS SIDE SCENE...\n");
        return 2;
    }
    const long rounds = strtol(argv[1], NULL, 10);
    const unsigned threads = (unsigned)strtoul(argv[2], NULL, 10);
    const size_t count = (size_t)argc - OPTIONS;
    luxel_scene **scenes = calloc(count, sizeof *scenes);
    double *best = calloc(count, sizeof *best);
    if (!scenes || !best)
        return 1;
    for (size_t i = 0; i < count; i++)
        scenes[i] = open_scene(argv[i + OPTIONS], strtod(argv[3], NULL));
    for (long round = 0; round < rounds; round++)
        for (size_t i = 0; i < count; i++) {
            const double taken = time_picture(scenes[i], threads);
            best[i] = round == 0 || taken < best[i] ? taken : best[i];
        }
    for (size_t i = 0; i < count; i++) {
        printf("%.4f\n", best[i]);
        luxel_scene_free(scenes[i]);
    }
    free(scenes);
    free(best);
    return 0;
}
