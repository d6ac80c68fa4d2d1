/* SPDX-License-Identifier: MIT */
/*
 * All shards as one HDF5 file, for luxel-hdf5: a dataset for each output, chunked by scenes, with dimension scales, so
 * that h5py and xarray name its axes, and with all that is needed to read it alone: names, words, units, places, the
 * study and its scene.  Times are not tracked and unused space is not kept, so that the bytes depend on the numbers
 * alone.
 */
#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../message.h"
#include "merge.h"

enum { RANK = ARRAY_DIMENSIONS, DEFLATE = 4, CHUNK_BYTES = 1 << 20 };

/* The file on the way. */
struct merging {
    struct sweep *sweep;
    hid_t file;
    hid_t scene;  /* the scale of all datasets: numbers of the scenes */
    bool is_told; /* what failed was reported */
};

static hid_t type_of(luxel_study_type type)
{
    hid_t half;

    switch (type) {
    case LUXEL_STUDY_FLOAT32: return H5Tcopy(H5T_NATIVE_FLOAT);
    case LUXEL_STUDY_UINT8: return H5Tcopy(H5T_NATIVE_UINT8);
    case LUXEL_STUDY_INT32: return H5Tcopy(H5T_NATIVE_INT32);
    case LUXEL_STUDY_FLOAT16: /* IEEE half precision, as h5py and NumPy know it */
        half = H5Tcopy(H5T_NATIVE_FLOAT);
        H5Tset_fields(half, 15, 10, 5, 0, 10);
        H5Tset_size(half, 2);
        H5Tset_ebias(half, 15);
        return half;
    default: return H5Tcopy(H5T_NATIVE_DOUBLE);
    }
}

/* A dataset without its times; `chunk` NULL: in one piece. */
static hid_t create(hid_t file, const char *name, hid_t type, int rank, const hsize_t *shape, const hsize_t *chunk)
{
    const hid_t space = H5Screate_simple(rank, shape, NULL), list = H5Pcreate(H5P_DATASET_CREATE);
    hid_t made;

    H5Pset_obj_track_times(list, 0);
    H5Pset_fill_time(list, H5D_FILL_TIME_NEVER);
    if (chunk) {
        H5Pset_chunk(list, rank, chunk);
        H5Pset_shuffle(list);
        H5Pset_deflate(list, DEFLATE);
    }
    made = H5Dcreate2(file, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT);
    H5Pclose(list);
    H5Sclose(space);
    return made;
}

/* A scale of so many numbers: 0, 1, 2 ... where none are given. */
static hid_t create_scale(struct merging *merging, const char *name, size_t count, const double *numbers)
{
    const hsize_t shape[1] = {count};
    const hid_t type = numbers ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT64;
    const hid_t made = create(merging->file, name, type, 1, shape, NULL);
    uint64_t *counted = message_allocate(count, sizeof *counted);
    bool good = made >= 0;

    for (size_t i = 0; i < count; i++)
        counted[i] = i;
    good = good &&
           H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers ? (const void *)numbers : counted) >= 0 &&
           H5DSset_scale(made, name) >= 0;
    free(counted);
    if (!good && made >= 0)
        H5Dclose(made);
    return good ? made : -1;
}

/* Attaches the scale of this name, which is made the first time. */
static bool attach(struct merging *merging, hid_t dataset, unsigned axis, const char *name, size_t count)
{
    const bool is_there = H5Lexists(merging->file, name, H5P_DEFAULT) > 0;
    const hid_t scale =
        is_there ? H5Dopen2(merging->file, name, H5P_DEFAULT) : create_scale(merging, name, count, NULL);
    const bool good = scale >= 0 && H5DSattach_scale(dataset, scale, axis) >= 0;

    if (scale >= 0)
        H5Dclose(scale);
    return good;
}

/* Names of an output's axes behind that of the scenes. */
static const char *axis_name(size_t output, unsigned axis)
{
    static const char *const pictures[] = {"row", "column", "component"};

    switch (output) {
    case LUXEL_STUDY_PROBES: return axis == 0 ? "point" : "component";
    case LUXEL_STUDY_STATISTICS: return "statistic";
    case LUXEL_STUDY_LIGHT_POSITIONS: return axis == 0 ? "light" : "component";
    case LUXEL_STUDY_OUTPUTS: return "parameter";
    default: return pictures[axis];
    }
}

static bool write_text(hid_t object, const char *name, const char *text)
{
    return H5LTset_attribute_string(object, ".", name, text) >= 0;
}

/* Texts as one attribute, of as many strings. */
static bool write_texts(hid_t object, const char *name, const char *const *texts, size_t count)
{
    const hsize_t shape[1] = {count};
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate_simple(1, shape, NULL);

    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);

    const hid_t made = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const bool good = made >= 0 && H5Awrite(made, type, texts) >= 0;

    if (made >= 0)
        H5Aclose(made);
    H5Sclose(space);
    H5Tclose(type);
    return good;
}

/* What the columns of the parameters are: "names", and of a column of indices "values_COLUMN", what each stands for. */
static bool explain_parameters(const struct sweep *sweep, hid_t dataset)
{
    const size_t count = luxel_study_parameter_count(sweep->study);
    char **names = message_allocate(count, sizeof *names), key[32];
    bool good = true;

    for (size_t p = 0; p < count; p++) {
        size_t words = 0;

        names[p] = luxel_study_parameter_name(sweep->study, p);
        good = good && names[p];
        while (luxel_study_parameter_word(sweep->study, p, words))
            words++;

        const char **values = message_allocate(words + 1, sizeof *values);

        for (size_t v = 0; v < words; v++)
            values[v] = luxel_study_parameter_word(sweep->study, p, v);
        snprintf(key, sizeof key, "values_%zu", p);
        good = good && (words == 0 || write_texts(dataset, key, values, words));
        free((void *)values);
    }
    good = good && write_texts(dataset, "names", (const char *const *)names, count);
    for (size_t p = 0; p < count; p++)
        luxel_text_free(names[p]);
    free(names);
    return good;
}

/* The unit of an output's numbers; NULL: they have several. */
static const char *unit_of(const struct sweep *sweep, size_t output)
{
    const luxel_scene *base = luxel_study_base(sweep->study);

    switch (output) {
    case LUXEL_STUDY_BRIGHTNESS:
    case LUXEL_STUDY_PROBES: return luxel_scene_unit(base, LUXEL_BRIGHTNESS);
    case LUXEL_STUDY_IRRADIANCE: return luxel_scene_unit(base, LUXEL_IRRADIANCE);
    case LUXEL_STUDY_MASK:
    case LUXEL_STUDY_NORMALS:
    case LUXEL_STUDY_SURFACES: return "1";
    case LUXEL_STUDY_DEPTH:
    case LUXEL_STUDY_POSITIONS:
    case LUXEL_STUDY_LIGHT_POSITIONS: return "mm";
    default: return NULL;
    }
}

/* What the numbers of an output mean. */
static bool explain(const struct sweep *sweep, size_t output, hid_t dataset)
{
    const char *unit = unit_of(sweep, output);

    if (output == LUXEL_STUDY_OUTPUTS)
        return explain_parameters(sweep, dataset);
    if (output == LUXEL_STUDY_STATISTICS)
        return write_texts(dataset, "names", sweep_statistics, SWEEP_STATISTICS);
    return !unit || write_text(dataset, "units", unit);
}

/* Writes all shards of an array, one after the other. */
static bool write_shards(struct merging *merging, const struct merge_array *merged, hid_t dataset, hid_t type, int rank,
                         const hsize_t *shape)
{
    const struct sweep *sweep = merging->sweep;
    const hid_t space = H5Dget_space(dataset);
    hsize_t start[RANK + 1] = {0}, count[RANK + 1];
    bool good = space >= 0;

    for (uint64_t shard = 0; shard < sweep->shards && good; shard++) {
        void *numbers = sweep_read_shard(sweep, merged, shard);
        hid_t memory;

        merging->is_told = merging->is_told || !numbers;
        memcpy(count, shape, sizeof count);
        count[0] = sweep_scenes_of(sweep, shard);
        start[0] = shard * luxel_study_shard(sweep->study);
        memory = H5Screate_simple(rank, count, NULL);
        good = numbers && H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, count, NULL) >= 0 &&
               H5Dwrite(dataset, type, memory, space, H5P_DEFAULT, numbers) >= 0;
        H5Sclose(memory);
        free(numbers);
    }
    H5Sclose(space);
    return good;
}

static bool merge_array(struct merging *merging, size_t output)
{
    const struct sweep *sweep = merging->sweep;
    struct merge_array merged;
    hsize_t shape[RANK + 1] = {sweep->scenes}, chunk[RANK + 1] = {1};
    int rank = 1;

    if (!sweep_merge_array(sweep, output, &merged))
        return true;
    for (; merged.shape[rank - 1]; rank++)
        shape[rank] = chunk[rank] = merged.shape[rank - 1];
    chunk[0] = merged.bytes_of_scene < CHUNK_BYTES ? CHUNK_BYTES / merged.bytes_of_scene : 1;
    chunk[0] = chunk[0] < shape[0] ? chunk[0] : shape[0];

    const hid_t type = type_of(merged.type), dataset = create(merging->file, merged.name, type, rank, shape, chunk);
    bool good = dataset >= 0 && H5DSattach_scale(dataset, merging->scene, 0) >= 0;

    for (int axis = 1; axis < rank && good; axis++)
        good = attach(merging, dataset, (unsigned)axis, axis_name(output, (unsigned)axis - 1), merged.shape[axis - 1]);
    good = good && explain(sweep, output, dataset) && write_shards(merging, &merged, dataset, type, rank, shape);
    if (dataset >= 0)
        H5Dclose(dataset);
    H5Tclose(type);
    return good;
}

/* The place of each row's or column's samples on the screen, along its axis. */
static bool write_places(struct merging *merging, const char *name, const char *axis, const double *places_mm,
                         size_t count)
{
    const hsize_t shape[1] = {count};
    const hid_t dataset = create(merging->file, name, H5T_NATIVE_DOUBLE, 1, shape, NULL);
    const bool good = dataset >= 0 &&
                      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, places_mm) >= 0 &&
                      attach(merging, dataset, 0, axis, count) && write_text(dataset, "units", "mm");

    if (dataset >= 0)
        H5Dclose(dataset);
    return good;
}

/* Where pixels lie in all scenes: of a study that does not vary the screen, and keeps pictures. */
static bool write_screen(struct merging *merging)
{
    const struct sweep *sweep = merging->sweep;
    const size_t no_light = 0;
    luxel_settings settings;
    luxel_field *dark = NULL;
    bool varies = false;

    for (size_t p = 0; p < luxel_study_parameter_count(sweep->study); p++) {
        char *name = luxel_study_parameter_name(sweep->study, p);

        varies = varies || !name || strncmp(name, "screen", strlen("screen")) == 0;
        luxel_text_free(name);
    }
    if (varies || H5Lexists(merging->file, "row", H5P_DEFAULT) <= 0)
        return true;
    luxel_settings_init(&settings);
    settings.lights = &no_light; /* none of them: it is the places that are wanted */
    const bool good = luxel_render(luxel_study_base(sweep->study), &settings, NULL, &dark) == LUXEL_OK &&
                      write_places(merging, "x_mm", "column", luxel_field_x_mm(dark), sweep->columns) &&
                      write_places(merging, "y_mm", "row", luxel_field_y_mm(dark), sweep->rows);

    luxel_field_free(dark);
    return good;
}

/* The names of the parameters and of the statistics, one a line, and what the file was made of. */
static bool write_origin(struct merging *merging)
{
    const struct sweep *sweep = merging->sweep;
    const unsigned seed = luxel_study_seed(sweep->study);
    char *names = NULL, *base = NULL;
    size_t length;
    FILE *text = open_memstream(&names, &length);
    bool good = text != NULL;

    for (size_t p = 0; good && p < luxel_study_parameter_count(sweep->study); p++) {
        char *name = luxel_study_parameter_name(sweep->study, p);

        fprintf(text, "%s%s", p ? "\n" : "", name ? name : "");
        luxel_text_free(name);
    }
    good = good && fclose(text) == 0 && write_text(merging->file, "parameters", names) &&
           write_text(merging->file, "statistics", "maximum\nminimum\nmean\nlit\nsurface_pixels") &&
           write_text(merging->file, "identity", sweep->identity) &&
           write_text(merging->file, "luxel", luxel_version()) &&
           write_text(merging->file, "instruction_set", sweep->instruction_set) &&
           H5LTset_attribute_uint(merging->file, ".", "seed", &seed, 1) >= 0 &&
           write_text(merging->file, "study", luxel_study_text(sweep->study)) &&
           luxel_scene_write_text(luxel_study_base(sweep->study), &base) == LUXEL_OK &&
           write_text(merging->file, "scene", base);
    luxel_text_free(base);
    free(names);
    return good;
}

/* The file at a path, which is that of the work folder. */
static bool write_file(struct merging *merging, const char *path)
{
    struct sweep *sweep = merging->sweep;
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    bool good;

    H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
    merging->file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    if (merging->file < 0)
        return false;
    merging->scene = create_scale(merging, "scene", (size_t)sweep->scenes, NULL);
    good = merging->scene >= 0;
    for (size_t k = 0; k <= LUXEL_STUDY_OUTPUTS && good; k++)
        good = merge_array(merging, k);
    good = good && write_screen(merging) && write_origin(merging);
    if (merging->scene >= 0)
        H5Dclose(merging->scene);
    return H5Fclose(merging->file) >= 0 && good;
}

int sweep_merge_hdf5(struct sweep *sweep, const struct options *options)
{
    char *path = message_allocate(strlen(sweep->folder.path) + FOLDER_NAME + 16, 1);
    struct merging merging = {.sweep = sweep};
    int failed = 0, file;

    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    sprintf(path, "%s/%s/merged.h5", sweep->folder.path, sweep->folder.work_name);
    errno = 0;
    if (!write_file(&merging, path))
        failed = errno ? errno : EIO;
    free(path);
    if (merging.is_told)
        return EXIT_FILE;
    file = failed == 0 ? openat(sweep->folder.work, "merged.h5", O_RDONLY | O_CLOEXEC) : -1;
    if (failed == 0 && (file < 0 || fsync(file) != 0))
        failed = errno;
    if (file >= 0)
        close(file);
    if (failed == 0)
        failed = sweep_put(sweep, "merged.h5", options->sweep.merge);
    if (failed == 0)
        return EXIT_DONE;
    message_error(_("%s cannot be written: %s"), options->sweep.merge, language_reason(failed));
    return EXIT_FILE;
}
