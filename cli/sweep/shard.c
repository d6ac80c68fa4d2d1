/* SPDX-License-Identifier: MIT */
/* One shard: its scenes rendered one after the other into its arrays, which are then put in their place. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../clock.h"
#include "../message.h"
#include "sweep.h"

/* The arrays of a shard on the way; the last holds the parameters. */
struct making {
    struct sweep_worker *worker;
    uint64_t shard;
    int folder;
    bool missed; /* the scene's reflected light is less exact than it should be */
    struct array arrays[SWEEP_FILES];
};

static const char sums_name[] = "SHA256SUMS";

static luxel_study_type wanted(const struct sweep *sweep, luxel_study_output output)
{
    return luxel_study_wanted(sweep->study, output);
}

/* ---- workers ---- */

int sweep_worker_init(struct sweep_worker *worker, struct sweep *sweep)
{
    const size_t pixels = (size_t)sweep->columns * sweep->rows;
    const size_t places = 3 * (sweep->points + sweep->lights) + luxel_study_parameter_count(sweep->study);
    luxel_status status;

    *worker = (struct sweep_worker){.sweep = sweep, .diagnostics = message_new_diagnostics()};
    worker->row = message_allocate(places + SWEEP_STATISTICS, sizeof *worker->row);
    if (wanted(sweep, LUXEL_STUDY_DEPTH) != LUXEL_STUDY_NONE)
        worker->geometry.depth_mm = message_allocate(pixels, sizeof(double));
    if (wanted(sweep, LUXEL_STUDY_NORMALS) != LUXEL_STUDY_NONE)
        worker->geometry.normals = message_allocate(pixels, sizeof(double[3]));
    if (wanted(sweep, LUXEL_STUDY_POSITIONS) != LUXEL_STUDY_NONE)
        worker->geometry.positions_mm = message_allocate(pixels, sizeof(double[3]));
    if (wanted(sweep, LUXEL_STUDY_SURFACES) != LUXEL_STUDY_NONE)
        worker->geometry.surfaces = message_allocate(pixels, sizeof(int32_t));
    status = luxel_study_maker_new(sweep->study, worker->diagnostics, &worker->maker);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, worker->diagnostics);
}

void sweep_worker_clear(struct sweep_worker *worker)
{
    luxel_study_maker_free(worker->maker);
    luxel_diagnostics_free(worker->diagnostics);
    free(worker->geometry.depth_mm);
    free(worker->geometry.normals);
    free(worker->geometry.positions_mm);
    free(worker->geometry.surfaces);
    free(worker->row);
}

/* ---- one scene ---- */

/* Adds what is said of a scene's light positions for programs that relight: a name, and the direction of each light as
 * seen from the first surface. */
static int add_directions(struct array *array, const luxel_scene *scene, uint64_t i)
{
    double center[3] = {0}, place[3], direction[3];
    char *line = NULL;
    size_t length;
    FILE *text = open_memstream(&line, &length);
    int failed;

    if (!text)
        return ENOMEM;
    luxel_scene_surface_place(scene, 0, center);
    fprintf(text, "scene-%09llu", (unsigned long long)i);
    for (size_t k = 0; k < luxel_scene_light_count(scene); k++) {
        const bool stands = luxel_scene_light_place(scene, k, place);
        const bool travels = !stands && luxel_scene_light_direction(scene, k, direction);
        double way[3], size = 0.0;

        if (!luxel_scene_light_enabled(scene, k) || (!stands && !travels))
            continue;
        for (int c = 0; c < 3; c++) {
            way[c] = stands ? place[c] - center[c] : -direction[c];
            size += way[c] * way[c];
        }
        size = size > 0.0 ? sqrt(size) : 1.0;
        fprintf(text, " %.9f %.9f %.9f", way[0] / size, way[1] / size, way[2] / size);
    }
    fputc('\n', text);
    failed = fclose(text) == 0 ? array_add_bytes(array, line, length) : ENOMEM;
    free(line);
    return failed;
}

static int add_positions(struct making *making, const luxel_scene *scene, uint64_t i)
{
    struct array *array = &making->arrays[LUXEL_STUDY_LIGHT_POSITIONS];
    double *row = making->worker->row;
    const size_t lights = making->worker->sweep->lights;

    if (array->type == LUXEL_STUDY_LP)
        return add_directions(array, scene, i);
    for (size_t k = 0; k < lights; k++)
        if (!luxel_scene_light_place(scene, k, row + 3 * k))
            row[3 * k] = row[3 * k + 1] = row[3 * k + 2] = (double)NAN;
    return array_add_doubles(array, row, 3 * lights);
}

/* Values of a picture, or their channels, added to the array of its output. */
static int add_field(struct array *array, const luxel_field *field)
{
    const bool in_color = luxel_field_channels(field) > 1;
    const size_t pixels = (size_t)luxel_field_columns(field) * luxel_field_rows(field);
    const size_t numbers = pixels * luxel_field_channels(field);
    const float *singles = in_color ? luxel_field_rgb_single(field) : luxel_field_single(field);

    return singles ? array_add_singles(array, singles, numbers)
                   : array_add_doubles(array, in_color ? luxel_field_rgb_double(field) : luxel_field_double(field),
                                       numbers);
}

static int add_statistics(struct making *making, const luxel_field *field)
{
    const luxel_statistics *all = luxel_field_statistics(field);
    const double none = (double)NAN;
    const double row[SWEEP_STATISTICS] = {
        all->maximum.exists ? all->maximum.value : none,
        all->minimum.exists ? all->minimum.value : none,
        all->has_surface ? all->mean : none,
        all->has_surface ? all->lit : none,
        (double)all->surface_pixels,
    };

    return array_add_doubles(&making->arrays[LUXEL_STUDY_STATISTICS], row, SWEEP_STATISTICS);
}

/* Renders one quantity and adds all that comes of its picture. */
static luxel_status add_picture(struct making *making, const luxel_scene *scene, luxel_study_output output,
                                bool carries_rest, int *failed)
{
    const struct sweep *sweep = making->worker->sweep;
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_status status;

    luxel_settings_init(&settings);
    settings.threads = 1;
    settings.quantity = output == LUXEL_STUDY_IRRADIANCE ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
    settings.precision = wanted(sweep, output) == LUXEL_STUDY_FLOAT64 ? LUXEL_DOUBLE : LUXEL_SINGLE;
    status = luxel_render(scene, &settings, making->worker->diagnostics, &field);
    if (status != LUXEL_OK)
        return status;
    if (wanted(sweep, output) != LUXEL_STUDY_NONE)
        *failed = add_field(&making->arrays[output], field);
    if (*failed == 0 && carries_rest && wanted(sweep, LUXEL_STUDY_MASK) != LUXEL_STUDY_NONE)
        *failed = array_add_bytes(&making->arrays[LUXEL_STUDY_MASK], luxel_field_mask(field),
                                  (size_t)sweep->columns * sweep->rows);
    if (*failed == 0 && carries_rest && wanted(sweep, LUXEL_STUDY_STATISTICS) != LUXEL_STUDY_NONE)
        *failed = add_statistics(making, field);
    const luxel_statistics *statistics = luxel_field_statistics(field);

    making->missed = making->missed || (statistics->has_reflected && !statistics->reflected_reached);
    luxel_field_free(field);
    return LUXEL_OK;
}

static luxel_status add_probes(struct making *making, const luxel_scene *scene, int *failed)
{
    const size_t points = making->worker->sweep->points, channels = making->worker->sweep->in_color ? 3 : 1;
    double *row = making->worker->row;

    for (size_t k = 0; k < points; k++) {
        double x, y;
        luxel_probe *probe;
        luxel_status status;

        luxel_scene_point(scene, k, &x, &y);
        status = luxel_probe_screen(scene, NULL, x, y, making->worker->diagnostics, &probe);
        if (status != LUXEL_OK)
            return status;
        for (size_t c = 0; c < channels; c++)
            row[channels * k + c] = !probe->has_value ? (double)NAN : channels > 1 ? probe->color.rgb[c] : probe->value;
        making->missed = making->missed || (probe->has_reflected && !probe->reflected_reached);
        luxel_probe_free(probe);
    }
    *failed = array_add_doubles(&making->arrays[LUXEL_STUDY_PROBES], row, channels * points);
    return LUXEL_OK;
}

static bool wants_geometry(const luxel_geometry *geometry)
{
    return geometry->depth_mm || geometry->normals || geometry->positions_mm || geometry->surfaces;
}

static luxel_status add_geometry(struct making *making, const luxel_scene *scene, int *failed)
{
    const struct sweep_worker *worker = making->worker;
    const luxel_geometry *geometry = &worker->geometry;
    const size_t pixels = (size_t)worker->sweep->columns * worker->sweep->rows;
    luxel_settings settings;

    luxel_settings_init(&settings);
    settings.threads = 1;
    const luxel_status status = luxel_find_geometry(scene, &settings, worker->diagnostics, geometry);

    if (status == LUXEL_OK && geometry->depth_mm)
        *failed = array_add_doubles(&making->arrays[LUXEL_STUDY_DEPTH], geometry->depth_mm, pixels);
    if (status == LUXEL_OK && *failed == 0 && geometry->normals)
        *failed = array_add_doubles(&making->arrays[LUXEL_STUDY_NORMALS], geometry->normals[0], 3 * pixels);
    if (status == LUXEL_OK && *failed == 0 && geometry->positions_mm)
        *failed = array_add_doubles(&making->arrays[LUXEL_STUDY_POSITIONS], geometry->positions_mm[0], 3 * pixels);
    if (status == LUXEL_OK && *failed == 0 && geometry->surfaces)
        *failed = array_add_bytes(&making->arrays[LUXEL_STUDY_SURFACES], geometry->surfaces, pixels * sizeof(int32_t));
    return status;
}

/* Whether the numbers of points, lights and channels are those that the arrays have room for. */
static bool fits(const struct sweep *sweep, const luxel_scene *scene)
{
    const bool points = luxel_scene_point_count(scene) == sweep->points;
    const bool lights = luxel_scene_light_count(scene) == sweep->lights;

    return luxel_scene_has_color(scene) == sweep->in_color &&
           (points || wanted(sweep, LUXEL_STUDY_PROBES) == LUXEL_STUDY_NONE) &&
           (lights || wanted(sweep, LUXEL_STUDY_LIGHT_POSITIONS) == LUXEL_STUDY_NONE ||
            wanted(sweep, LUXEL_STUDY_LIGHT_POSITIONS) == LUXEL_STUDY_LP);
}

static luxel_status add_scene(struct making *making, uint64_t i, int *failed)
{
    struct sweep_worker *worker = making->worker;
    const struct sweep *sweep = worker->sweep;
    const bool irradiance = wanted(sweep, LUXEL_STUDY_IRRADIANCE) != LUXEL_STUDY_NONE;
    const bool brightness = wanted(sweep, LUXEL_STUDY_BRIGHTNESS) != LUXEL_STUDY_NONE;
    const bool rest = wanted(sweep, LUXEL_STUDY_MASK) != LUXEL_STUDY_NONE ||
                      wanted(sweep, LUXEL_STUDY_STATISTICS) != LUXEL_STUDY_NONE;
    const luxel_scene *scene = NULL;
    luxel_status status = luxel_study_make(worker->maker, i, worker->diagnostics, &scene);

    *failed = status == LUXEL_OK && !fits(sweep, scene) ? EDOM : 0;
    if (status == LUXEL_OK && *failed == 0 && making->arrays[LUXEL_STUDY_OUTPUTS].file > 0) {
        luxel_study_parameters(sweep->study, i, worker->row);
        *failed = array_add_doubles(&making->arrays[LUXEL_STUDY_OUTPUTS], worker->row,
                                    luxel_study_parameter_count(sweep->study));
    }
    if (status == LUXEL_OK && *failed == 0 && (brightness || (rest && !irradiance)))
        status = add_picture(making, scene, LUXEL_STUDY_BRIGHTNESS, true, failed);
    if (status == LUXEL_OK && *failed == 0 && irradiance)
        status = add_picture(making, scene, LUXEL_STUDY_IRRADIANCE, !brightness, failed);
    if (status == LUXEL_OK && *failed == 0 && wants_geometry(&worker->geometry))
        status = add_geometry(making, scene, failed);
    if (status == LUXEL_OK && *failed == 0 && wanted(sweep, LUXEL_STUDY_PROBES) != LUXEL_STUDY_NONE)
        status = add_probes(making, scene, failed);
    if (status == LUXEL_OK && *failed == 0 && wanted(sweep, LUXEL_STUDY_LIGHT_POSITIONS) != LUXEL_STUDY_NONE)
        *failed = add_positions(making, scene, i);
    return status;
}

/* ---- a shard ---- */

/* Counts a scene that missed the bound of its reflected light. */
static void note_missed(struct sweep *sweep, uint64_t i)
{
    pthread_mutex_lock(&sweep->mutex);
    if (sweep->missed == 0 || i < sweep->first_missed)
        sweep->first_missed = i;
    sweep->missed++;
    pthread_mutex_unlock(&sweep->mutex);
}

int sweep_tell_missed(const struct sweep *sweep)
{
    if (sweep->missed == 0)
        return EXIT_DONE;
    message_error(ngettext("the reflected light of %llu scene is less exact than it should be: scene %llu",
                           "the reflected light of %llu scenes is less exact than it should be: scene %llu first",
                           (unsigned long)sweep->missed),
                  (unsigned long long)sweep->missed, (unsigned long long)sweep->first_missed);
    message_hint(_("they are kept all the same; luxel sweep STUDY --show N prints a scene, and luxel render tells how "
                   "exact it is"));
    return EXIT_TOLERANCE;
}

/* Reports once, and stops everybody. */
static int fail_scene(struct making *making, uint64_t i, luxel_status status, int failed)
{
    struct sweep *sweep = making->worker->sweep;
    int code = EXIT_SCENE;

    pthread_mutex_lock(&sweep->mutex);
    if (!atomic_exchange(&sweep->stop, true)) {
        if (status != LUXEL_OK) {
            message_error(_("scene %llu of the study cannot be computed:"), (unsigned long long)i);
            code = message_failure(status, making->worker->diagnostics);
        } else if (failed == ERANGE) {
            message_error(_("scene %llu has a value that is too large for its type; float32 holds it"),
                          (unsigned long long)i);
        } else if (failed == EDOM) {
            message_error(_("scene %llu has another number of lights, points or channels than the base scene, which "
                            "outputs of them do not allow"),
                          (unsigned long long)i);
        } else {
            message_error(_("%s cannot be written: %s"), sweep->folder.path, language_reason(failed));
            message_hint(_("what is done is kept: the same command goes on from there"));
            code = EXIT_FILE;
        }
        sweep->code = code;
    }
    code = sweep->code ? sweep->code : code;
    pthread_mutex_unlock(&sweep->mutex);
    return code;
}

static int open_arrays(struct making *making)
{
    const struct sweep *sweep = making->worker->sweep;
    const size_t scenes = sweep_scenes_of(sweep, making->shard);
    size_t shape[ARRAY_DIMENSIONS + 1] = {scenes, luxel_study_parameter_count(sweep->study)};
    int failed = 0;

    if (shape[1] > 0)
        failed = array_open(&making->arrays[LUXEL_STUDY_OUTPUTS], making->folder, "parameters", LUXEL_STUDY_FLOAT64,
                            shape, sweep->by_instructions);

    for (luxel_study_output k = 0; k < LUXEL_STUDY_OUTPUTS && failed == 0; k++) {
        if (wanted(sweep, k) == LUXEL_STUDY_NONE)
            continue;
        sweep_shape(sweep, k, shape + 1);
        failed = array_open(&making->arrays[k], making->folder, luxel_study_output_name(k), wanted(sweep, k), shape,
                            sweep->by_instructions);
        if (failed == 0 && wanted(sweep, k) == LUXEL_STUDY_LP) {
            char count[32];

            snprintf(count, sizeof count, "%zu\n", scenes);
            failed = array_add_bytes(&making->arrays[k], count, strlen(count));
        }
    }
    return failed;
}

/* Makes the arrays durable, their sums beside them. */
static int close_arrays(struct making *making, bool whole)
{
    char sums[SWEEP_FILES * (SHA256_HEX + ARRAY_NAME + 4)] = "", hex[SHA256_HEX];
    size_t used = 0;
    int failed = 0, file;

    for (size_t k = 0; k < SWEEP_FILES; k++) {
        struct array *array = &making->arrays[k];
        const bool is_open = array->file > 0;
        const int this_failed = array_close(array, whole ? hex : NULL);

        failed = failed ? failed : this_failed;
        if (whole && is_open)
            used += (size_t)snprintf(sums + used, sizeof sums - used, "%s  %s\n", hex, array->name);
    }
    if (!whole || failed != 0)
        return failed;
    file = openat(making->folder, sums_name, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0)
        return errno;
    if (write(file, sums, used) != (ssize_t)used || fsync(file) != 0)
        failed = errno ? errno : ENOSPC;
    if (close(file) != 0 && failed == 0)
        failed = errno;
    return failed;
}

int sweep_shard(struct sweep_worker *worker, uint64_t shard)
{
    struct sweep *sweep = worker->sweep;
    struct making making = {.worker = worker, .shard = shard};
    const uint64_t first = shard * luxel_study_shard(sweep->study);
    const size_t scenes = sweep_scenes_of(sweep, shard);
    luxel_status status = LUXEL_OK;
    int failed, closed;
    size_t i = 0;

    making.folder = folder_stage(&sweep->folder, shard);
    failed = making.folder >= 0 ? open_arrays(&making) : errno;
    for (; i < scenes && failed == 0 && status == LUXEL_OK && !atomic_load(&sweep->stop); i++) {
        making.missed = false;
        status = add_scene(&making, first + i, &failed);
        if (making.missed && status == LUXEL_OK && failed == 0)
            note_missed(sweep, first + i);
        atomic_fetch_add(&sweep->done, status == LUXEL_OK && failed == 0);
    }
    closed = close_arrays(&making, i == scenes && failed == 0 && status == LUXEL_OK);
    failed = failed ? failed : closed;
    if (i == scenes && failed == 0 && status == LUXEL_OK)
        failed = folder_publish(&sweep->folder, shard, making.folder);
    else if (making.folder >= 0)
        folder_drop(&sweep->folder, shard);
    if (making.folder >= 0)
        close(making.folder);
    if (failed != 0 || status != LUXEL_OK)
        return fail_scene(&making, first + (i > 0 ? i - 1 : 0), status, failed);
    return EXIT_DONE;
}

/* ---- what is there ---- */

bool sweep_has(const struct sweep *sweep, uint64_t shard)
{
    char name[FOLDER_NAME], path[2 * FOLDER_NAME + ARRAY_NAME];
    const size_t scenes = sweep_scenes_of(sweep, shard);
    uint64_t bytes = 0;
    struct stat about;

    folder_shard_name(shard, name);
    for (size_t k = 0; k <= SWEEP_FILES; k++) {
        const bool is_sums = k == SWEEP_FILES, is_parameters = k == LUXEL_STUDY_OUTPUTS;
        const luxel_study_type type = k < LUXEL_STUDY_OUTPUTS ? wanted(sweep, (luxel_study_output)k) : LUXEL_STUDY_NONE;

        if ((k < LUXEL_STUDY_OUTPUTS && type == LUXEL_STUDY_NONE) ||
            (is_parameters && luxel_study_parameter_count(sweep->study) == 0))
            continue;
        snprintf(path, sizeof path, "%s/%s%s", name,
                 is_sums         ? sums_name
                 : is_parameters ? "parameters"
                                 : luxel_study_output_name((luxel_study_output)k),
                 is_sums                  ? ""
                 : type == LUXEL_STUDY_LP ? ".lp"
                                          : ".npy");
        if (fstatat(sweep->folder.folder, path, &about, 0) != 0 || about.st_size == 0)
            return false;
        if (!is_sums && type != LUXEL_STUDY_LP)
            bytes += (uint64_t)about.st_size;
    }
    if (wanted(sweep, LUXEL_STUDY_LIGHT_POSITIONS) == LUXEL_STUDY_LP)
        bytes += scenes * 64 * (sweep->lights ? sweep->lights : 1);
    return bytes == sweep_bytes_of(sweep, scenes);
}

double sweep_time_of_scene(struct sweep_worker *worker, double seconds)
{
    const struct sweep *sweep = worker->sweep;
    const double start = clock_seconds();
    const uint64_t step = sweep->scenes > 997 ? sweep->scenes / 997 : 1;
    struct making making = {.worker = worker, .folder = -1};
    luxel_status status = LUXEL_OK;
    uint64_t scenes = 0, i = 0;
    double now = start;
    int failed = open_arrays(&making);

    while (now - start < seconds && failed == 0 && status == LUXEL_OK) {
        status = add_scene(&making, i, &failed);
        if (failed != 0 || status != LUXEL_OK)
            break;
        i = (i + step) % sweep->scenes;
        scenes++;
        now = clock_seconds();
    }
    close_arrays(&making, false);
    if (failed == 0 && status == LUXEL_OK)
        return (now - start) / (double)scenes;
    fail_scene(&making, i, status, failed);
    return -1.0;
}
