/* SPDX-License-Identifier: MIT */
/*
 * A sweep: the scenes of a study computed shard by shard into a folder.
 *
 * A shard is a folder of arrays and their sums (SHA256SUMS); it appears whole or not at all, and its bytes depend on
 * the study alone.  So work can stop at any moment and go on anywhere: what is missing is computed.
 */
#ifndef LUXEL_CLI_SWEEP_SWEEP_H
#define LUXEL_CLI_SWEEP_SWEEP_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>

#include <luxel/luxel.h>

#include "array.h"
#include "folder.h"

enum { SWEEP_STATISTICS = 5, SWEEP_FILES = LUXEL_STUDY_OUTPUTS + 1 };

struct sweep {
    const luxel_study *study;
    const char *study_name; /* as the user typed it */
    struct folder folder;
    char identity[SHA256_HEX];
    const char *instruction_set;
    uint64_t scenes, shards;
    unsigned columns, rows;
    size_t points, lights; /* of the base scene, and so of every scene */
    bool in_color;         /* whether values have channels, of the base scene, and so of every scene */
    bool by_instructions;  /* sums are */
    atomic_bool stop;      /* something failed, or the user has had enough */
    atomic_ullong done;    /* scenes since the start */
    pthread_mutex_t mutex; /* of what follows, and of what is printed */
    int code;              /* an enum exit_code: the first failure */
    uint64_t missed;       /* scenes computed whose reflected light is less exact than it should be, */
    uint64_t first_missed; /* and the first of them */
};

/* Resources of one worker. */
struct sweep_worker {
    struct sweep *sweep;
    luxel_study_maker *maker;
    luxel_diagnostics *diagnostics;
    luxel_geometry geometry; /* room for what of it is wanted */
    double *row;
};

/* The names of the numbers of an output `statistics`. */
extern const char *const sweep_statistics[SWEEP_STATISTICS];

/* Fills in what follows from the study. */
void sweep_init(struct sweep *sweep, const luxel_study *study, const char *study_name);
void sweep_clear(struct sweep *sweep);
/* Whether what is wanted is there to be had; returns an enum exit_code. */
int sweep_check(const struct sweep *sweep);

/* How many scenes shard `shard` has. */
size_t sweep_scenes_of(const struct sweep *sweep, uint64_t shard);
/* Files of a shard with so many scenes: the arrays and, behind them, their sums; in all, for all shards. */
uint64_t sweep_bytes_of(const struct sweep *sweep, size_t scenes);
uint64_t sweep_bytes(const struct sweep *sweep);

/* Both return an enum exit_code, and have reported what is wrong; a worker is to be cleared in either case. */
int sweep_worker_init(struct sweep_worker *worker, struct sweep *sweep);
int sweep_shard(struct sweep_worker *worker, uint64_t shard);
void sweep_worker_clear(struct sweep_worker *worker);

/* Tells of scenes that missed the bound of their reflected light; returns an enum exit_code. */
int sweep_tell_missed(const struct sweep *sweep);

/* Makes all outputs of scenes of the study for about `seconds`, keeps none, and returns how long one takes in seconds;
 * below 0: one is wrong, which is reported. */
double sweep_time_of_scene(struct sweep_worker *worker, double seconds);

/* Whether a shard is whole. */
bool sweep_has(const struct sweep *sweep, uint64_t shard);

/* Whether a sweep was begun in the folder at this path, else reported; returns an enum exit_code. */
int sweep_check_begun(const struct sweep *sweep, const char *path);

/* Whether the folder is this sweep's, or new; a new one gets its manifest.  Returns an enum exit_code. */
int sweep_claim(struct sweep *sweep);
/* Writes what there is into the manifest; returns an enum exit_code, and how many shards are whole. */
int sweep_write_manifest(struct sweep *sweep, uint64_t *whole);

/* Computes the missing shards of this part with threads; returns an enum exit_code. */
struct sweep_run {
    unsigned workers;
    bool quiet, json;
};
int sweep_work(struct sweep *sweep, const struct sweep_run *how);

/* The shape of an output behind the number of scenes, ended by 0. */
void sweep_shape(const struct sweep *sweep, luxel_study_output output, size_t shape[ARRAY_DIMENSIONS]);

#endif
