/* SPDX-License-Identifier: MIT */
/* Properties of a sweep that follow from its study: its identity, its shards, the shapes and sizes of its arrays. */
#include "sweep.h"

#include <stdlib.h>
#include <string.h>

#include "../cli.h"
#include "../message.h"

const char *const sweep_statistics[SWEEP_STATISTICS] = {"maximum", "minimum", "mean", "lit", "surface_pixels"};

/* The sum of all that the bytes depend on: the study, the library, and its instruction set. */
static void identify(struct sweep *sweep)
{
    char *text = luxel_study_identity(sweep->study);
    struct sha256 sum;

    if (!text) {
        message_error(_("out of memory"));
        exit(EXIT_SCENE);
    }
    sha256_begin(&sum, sweep->by_instructions);
    sha256_add(&sum, text, strlen(text));
    sha256_add(&sum, "\nluxel ", 7);
    sha256_add(&sum, luxel_version(), strlen(luxel_version()));
    sha256_add(&sum, "\n", 1);
    sha256_add(&sum, sweep->instruction_set, strlen(sweep->instruction_set));
    sha256_end(&sum, sweep->identity);
    luxel_text_free(text);
}

void sweep_init(struct sweep *sweep, const luxel_study *study, const char *study_name)
{
    const luxel_scene *base = luxel_study_base(study);
    const unsigned shard = luxel_study_shard(study);
    const char *set = luxel_instruction_set_chosen(NULL);

    *sweep = (struct sweep){
        .study = study,
        .study_name = study_name,
        .folder = {.folder = -1, .lock = -1, .work = -1, .parts = 1},
        .instruction_set = set ? set : "", /* none: sweep_check() says so */
        .scenes = luxel_study_count(study),
        .points = luxel_scene_point_count(base),
        .lights = luxel_scene_light_count(base),
        .in_color = luxel_scene_has_color(base),
        .by_instructions = sha256_has_instructions(),
    };
    sweep->shards = (sweep->scenes + shard - 1) / shard;
    luxel_scene_resolution(base, &sweep->columns, &sweep->rows);
    pthread_mutex_init(&sweep->mutex, NULL);
    identify(sweep);
}

void sweep_clear(struct sweep *sweep)
{
    folder_close(&sweep->folder);
    pthread_mutex_destroy(&sweep->mutex);
}

size_t sweep_scenes_of(const struct sweep *sweep, uint64_t shard)
{
    const unsigned size = luxel_study_shard(sweep->study);
    const uint64_t left = sweep->scenes - shard * size;

    return left < size ? (size_t)left : size;
}

/* Whether the numbers of an output are red, green and blue. */
static bool has_channels(const struct sweep *sweep, luxel_study_output output)
{
    return sweep->in_color &&
           (output == LUXEL_STUDY_BRIGHTNESS || output == LUXEL_STUDY_IRRADIANCE || output == LUXEL_STUDY_PROBES);
}

void sweep_shape(const struct sweep *sweep, luxel_study_output output, size_t shape[ARRAY_DIMENSIONS])
{
    memset(shape, 0, ARRAY_DIMENSIONS * sizeof *shape);
    switch (output) {
    case LUXEL_STUDY_NORMALS:
    case LUXEL_STUDY_POSITIONS:
    case LUXEL_STUDY_BRIGHTNESS:
    case LUXEL_STUDY_IRRADIANCE:
    case LUXEL_STUDY_MASK:
    case LUXEL_STUDY_DEPTH:
    case LUXEL_STUDY_SURFACES:
        shape[0] = sweep->rows;
        shape[1] = sweep->columns;
        shape[2] =
            output == LUXEL_STUDY_NORMALS || output == LUXEL_STUDY_POSITIONS || has_channels(sweep, output) ? 3 : 0;
        break;
    case LUXEL_STUDY_PROBES:
        shape[0] = sweep->points;
        shape[1] = has_channels(sweep, output) ? 3 : 0;
        break;
    case LUXEL_STUDY_STATISTICS: shape[0] = SWEEP_STATISTICS; break;
    case LUXEL_STUDY_LIGHT_POSITIONS:
        shape[0] = sweep->lights;
        shape[1] = 3;
        break;
    case LUXEL_STUDY_OUTPUTS: break;
    }
}

/* Whether there are kernels, and what is wanted of places is there to be had. */
int sweep_check(const struct sweep *sweep)
{
    if (!*sweep->instruction_set) {
        const char *forced = getenv("LUXEL_ISA");

        message_error(_("LUXEL_ISA=%s: this machine has no such instruction set"), forced ? forced : "");
        message_hint(_("luxel --version tells the set that is taken without LUXEL_ISA"));
        return EXIT_USAGE;
    }
    if (luxel_study_wanted(sweep->study, LUXEL_STUDY_PROBES) != LUXEL_STUDY_NONE && sweep->points == 0) {
        message_error(_("%s wants probes, and its scene has no points"), sweep->study_name);
        message_hint(_("add points to the scene: set: ['points=[[0, 0]]']"));
        return EXIT_SCENE;
    }
    if (luxel_study_wanted(sweep->study, LUXEL_STUDY_LIGHT_POSITIONS) != LUXEL_STUDY_NONE && sweep->lights == 0) {
        message_error(_("%s wants light positions, and its scene has no lights"), sweep->study_name);
        return EXIT_SCENE;
    }
    return EXIT_DONE;
}

static uint64_t array_bytes(const struct sweep *sweep, luxel_study_output output, size_t scenes)
{
    const luxel_study_type type = luxel_study_wanted(sweep->study, output);
    size_t shape[ARRAY_DIMENSIONS];
    uint64_t numbers = scenes;

    if (type == LUXEL_STUDY_NONE)
        return 0;
    if (type == LUXEL_STUDY_LP)
        return scenes * 64 * (sweep->lights ? sweep->lights : 1);
    sweep_shape(sweep, output, shape);
    for (size_t i = 0; shape[i]; i++)
        numbers *= shape[i];
    return ARRAY_HEADER + numbers * array_item_size(type);
}

uint64_t sweep_bytes_of(const struct sweep *sweep, size_t scenes)
{
    const uint64_t parameters = luxel_study_parameter_count(sweep->study);
    uint64_t bytes = parameters ? ARRAY_HEADER + scenes * parameters * sizeof(double) : 0;

    for (luxel_study_output k = 0; k < LUXEL_STUDY_OUTPUTS; k++)
        bytes += array_bytes(sweep, k, scenes);
    return bytes;
}

uint64_t sweep_bytes(const struct sweep *sweep)
{
    const uint64_t whole = sweep->shards - 1;

    return whole * sweep_bytes_of(sweep, luxel_study_shard(sweep->study)) +
           sweep_bytes_of(sweep, sweep_scenes_of(sweep, whole));
}
