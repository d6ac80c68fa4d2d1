/* SPDX-License-Identifier: MIT */
/*
 * luxel sweep --merge: all shards as one file.  FILE.npy holds one output of all scenes; .h5 files, which need HDF5,
 * are another program's (merge_elsewhere.c).
 */
#include "merge.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../message.h"

int sweep_check_whole(const struct sweep *sweep)
{
    for (uint64_t shard = 0; shard < sweep->shards; shard++)
        if (!sweep_has(sweep, shard)) {
            message_error(_("%s is not complete: shard %llu is missing"), sweep->folder.path,
                          (unsigned long long)shard);
            message_hint(_("luxel sweep %s -o %s computes what is missing"), sweep->study_name, sweep->folder.path);
            return EXIT_FILE;
        }
    return EXIT_DONE;
}

/* The output that the name of the file begins with; parameters are behind the last, and beyond them none. */
static size_t output_of(const struct sweep *sweep, const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    const size_t length = strcspn(name, ".");

    for (size_t k = 0; k < LUXEL_STUDY_OUTPUTS; k++) {
        const char *output = luxel_study_output_name((luxel_study_output)k);
        const luxel_study_type type = luxel_study_wanted(sweep->study, (luxel_study_output)k);

        if (strlen(output) == length && strncmp(name, output, length) == 0 && type != LUXEL_STUDY_NONE &&
            type != LUXEL_STUDY_LP)
            return k;
    }
    return length == strlen("parameters") && strncmp(name, "parameters", length) == 0 ? LUXEL_STUDY_OUTPUTS
                                                                                      : LUXEL_STUDY_OUTPUTS + 1;
}

int sweep_merge_array(const struct sweep *sweep, size_t output, struct merge_array *merged)
{
    *merged = (struct merge_array){.name = "parameters", .type = LUXEL_STUDY_FLOAT64};
    merged->shape[0] = luxel_study_parameter_count(sweep->study);
    if (output < LUXEL_STUDY_OUTPUTS) {
        merged->name = luxel_study_output_name((luxel_study_output)output);
        merged->type = luxel_study_wanted(sweep->study, (luxel_study_output)output);
        sweep_shape(sweep, (luxel_study_output)output, merged->shape);
    }
    merged->bytes_of_scene = array_item_size(merged->type);
    for (size_t i = 0; merged->shape[i]; i++)
        merged->bytes_of_scene *= merged->shape[i];
    return merged->type != LUXEL_STUDY_NONE && merged->type != LUXEL_STUDY_LP && merged->shape[0] > 0;
}

/* Whether the bytes of a file are those of its sum in SHA256SUMS of its shard. */
static bool has_its_sum(const struct sweep *sweep, const char *folder, const char *name, const char *bytes,
                        size_t length)
{
    char path[FOLDER_NAME + ARRAY_NAME], line[SHA256_HEX + ARRAY_NAME + 4], hex[SHA256_HEX];
    struct sha256 sum;
    size_t sums_length;

    snprintf(path, sizeof path, "%s/SHA256SUMS", folder);
    sha256_begin(&sum, sweep->by_instructions);
    sha256_add(&sum, bytes, length);
    sha256_end(&sum, hex);
    snprintf(line, sizeof line, "%s  %s\n", hex, name);

    char *sums = folder_read(&sweep->folder, path, &sums_length);
    const bool is_good = sums && strstr(sums, line);

    free(sums);
    return is_good;
}

void *sweep_read_shard(const struct sweep *sweep, const struct merge_array *merged, uint64_t shard)
{
    char name[FOLDER_NAME], file[ARRAY_NAME], path[2 * FOLDER_NAME + ARRAY_NAME];
    size_t length;

    folder_shard_name(shard, name);
    snprintf(file, sizeof file, "%s.npy", merged->name);
    snprintf(path, sizeof path, "%s/%s", name, file);

    char *text = folder_read(&sweep->folder, path, &length);
    const bool is_whole = text && length == ARRAY_HEADER + sweep_scenes_of(sweep, shard) * merged->bytes_of_scene;

    if (is_whole && has_its_sum(sweep, name, file, text, length)) {
        memmove(text, text + ARRAY_HEADER, length - ARRAY_HEADER);
        return text;
    }
    if (is_whole) {
        message_error(_("%s/%s is damaged: its SHA-256 is not the one in SHA256SUMS beside it"), sweep->folder.path,
                      path);
        message_hint(_("remove the folder %s/%s; luxel sweep %s -o %s computes it again"), sweep->folder.path, name,
                     sweep->study_name, sweep->folder.path);
    } else {
        message_error(_("%s/%s cannot be read: %s"), sweep->folder.path, path,
                      language_reason(text || !errno ? EIO : errno));
    }
    free(text);
    return NULL;
}

/* To another file system: beside the place by bytes, and then into it. */
static int copy_to(struct sweep *sweep, const char *staged, const char *path)
{
    enum { ROOM = 1 << 20 };
    const size_t length = strlen(path);
    char *beside = message_allocate(length + sizeof ".part", 1), *room = message_allocate(ROOM, 1);
    const int from = openat(sweep->folder.work, staged, O_RDONLY | O_CLOEXEC);
    ssize_t got = 0;
    int failed = from < 0 ? errno : 0, to = -1;

    memcpy(beside, path, length);
    memcpy(beside + length, ".part", sizeof ".part");
    if (failed == 0 && (to = open(beside, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666)) < 0)
        failed = errno;
    while (failed == 0 && (got = read(from, room, ROOM)) > 0)
        for (ssize_t at = 0; at < got && failed == 0;) {
            const ssize_t put = write(to, room + at, (size_t)(got - at));

            failed = put < 0 ? errno : 0;
            at += put;
        }
    if (failed == 0 && (got < 0 || fsync(to) != 0))
        failed = errno;
    if (from >= 0)
        close(from);
    if (to >= 0 && close(to) != 0 && failed == 0)
        failed = errno;
    if (failed == 0 && rename(beside, path) != 0)
        failed = errno;
    if (failed != 0 && to >= 0)
        unlink(beside);
    free(beside);
    free(room);
    return failed;
}

int sweep_put(struct sweep *sweep, const char *staged, const char *path)
{
    if (renameat(sweep->folder.work, staged, AT_FDCWD, path) == 0)
        return 0;
    return errno == EXDEV ? copy_to(sweep, staged, path) : errno;
}

/* One array of all scenes; beside its place first, which it gets when it is whole. */
static int write_npy(struct sweep *sweep, const struct merge_array *merged, const char *path)
{
    size_t shape[ARRAY_DIMENSIONS + 1] = {(size_t)sweep->scenes, merged->shape[0], merged->shape[1], merged->shape[2]};
    char staged[ARRAY_NAME + 8], hex[SHA256_HEX];
    struct array array;
    int failed = array_open(&array, sweep->folder.work, merged->name, merged->type, shape, sweep->by_instructions);
    bool is_read = true;

    snprintf(staged, sizeof staged, "%s", array.name);
    for (uint64_t shard = 0; shard < sweep->shards && failed == 0 && is_read; shard++) {
        void *numbers = sweep_read_shard(sweep, merged, shard);

        is_read = numbers != NULL;
        if (is_read)
            failed = array_add_bytes(&array, numbers, sweep_scenes_of(sweep, shard) * merged->bytes_of_scene);
        free(numbers);
    }
    const int closed = array_close(&array, failed == 0 && is_read ? hex : NULL);

    if (!is_read) /* which has been reported */
        return EXIT_FILE;
    failed = failed ? failed : closed;
    if (failed == 0)
        failed = sweep_put(sweep, staged, path);
    if (failed == 0)
        return EXIT_DONE;
    message_error(_("%s cannot be written: %s"), path, language_reason(failed));
    return EXIT_FILE;
}

int sweep_merge(struct sweep *sweep, const struct options *options)
{
    const char *path = options->sweep.merge, *dot = strrchr(path, '.');
    struct merge_array merged;
    size_t output;

    const int code = sweep_check_whole(sweep);

    if (code != EXIT_DONE)
        return code;
    if (dot && (strcmp(dot, ".h5") == 0 || strcmp(dot, ".hdf5") == 0))
        return sweep_merge_hdf5(sweep, options);
    output = output_of(sweep, path);
    if (!dot || strcmp(dot, ".npy") != 0 || output > LUXEL_STUDY_OUTPUTS) {
        message_error(_("--merge %s: it must be a .h5 file, or a .npy file that is called as the output it holds"),
                      path);
        message_hint(_("for example --merge brightness.npy or --merge parameters.npy"));
        return EXIT_USAGE;
    }
    if (!sweep_merge_array(sweep, output, &merged)) {
        message_error(_("--merge %s: nothing varies"), path);
        return EXIT_USAGE;
    }
    return write_npy(sweep, &merged, path);
}
