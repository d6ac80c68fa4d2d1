/* SPDX-License-Identifier: MIT */
/* Putting the shards of a sweep into one file. */
#ifndef LUXEL_CLI_SWEEP_MERGE_H
#define LUXEL_CLI_SWEEP_MERGE_H

#include "../options.h"
#include "sweep.h"

/* An array of all scenes. */
struct merge_array {
    const char *name;
    luxel_study_type type;
    size_t shape[ARRAY_DIMENSIONS]; /* of one scene, ended by 0 */
    size_t bytes_of_scene;
};

/* `luxel sweep --merge`: returns an enum exit_code. */
int sweep_merge(struct sweep *sweep, const struct options *options);

/* Merging into an HDF5 file: hdf5.c does it, and merge_elsewhere.c leaves it to the program that has hdf5.c. */
int sweep_merge_hdf5(struct sweep *sweep, const struct options *options);

/* Whether all shards are there, else reported; returns an enum exit_code. */
int sweep_check_whole(const struct sweep *sweep);

/* Array of output k, LUXEL_STUDY_OUTPUTS being the parameters; false: there is no such array. */
int sweep_merge_array(const struct sweep *sweep, size_t output, struct merge_array *merged);

/* The numbers of a shard, to be freed; NULL: they cannot be read, which is reported. */
void *sweep_read_shard(const struct sweep *sweep, const struct merge_array *merged, uint64_t shard);

/* Puts a file of the work folder in its place: 0 or an errno value. */
int sweep_put(struct sweep *sweep, const char *staged, const char *path);

#endif
