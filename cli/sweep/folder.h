/* SPDX-License-Identifier: MIT */
/*
 * The folder of a sweep: who works in it, and how shards and the manifest appear in it whole or not at all.
 *
 * Locks are those of fcntl() on bytes of the file .lock, which vanish with their process and work on network file
 * systems: byte 0 exclusively for a whole sweep and shared for its parts, another byte for each part.  What is not
 * finished is in .work-I-N of part I of N, which only the holder of that lock touches.
 */
#ifndef LUXEL_CLI_SWEEP_FOLDER_H
#define LUXEL_CLI_SWEEP_FOLDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { FOLDER_NAME = 48 };

struct folder {
    const char *path;
    int folder, lock, work; /* open files; -1: not open */
    unsigned part, parts;   /* this process does part `part` of `parts` */
    char work_name[FOLDER_NAME];
};

/* "shard-000012" */
char *folder_shard_name(uint64_t shard, char name[FOLDER_NAME]);

/* Makes the folder where it is not there, locks it, and clears what a dead process left.  Returns an enum exit_code,
 * and has reported what is wrong.  folder_close() is due in either case. */
int folder_open(struct folder *folder, const char *path, unsigned part, unsigned parts);
void folder_close(struct folder *folder);

/* Waits for the manifest's lock, and gives it back. */
void folder_lock_manifest(struct folder *folder, bool wanted);

/* An empty folder for a shard, open; -1: it cannot be, and errno tells why. */
int folder_stage(struct folder *folder, uint64_t shard);

/* Puts a finished shard in its place; 0 or an errno value.  Where it is there already this one is dropped. */
int folder_publish(struct folder *folder, uint64_t shard, int staged);

/* Drops what was staged of a shard. */
void folder_drop(struct folder *folder, uint64_t shard);

/* Takes a shard that is not whole out of the folder. */
void folder_retract(struct folder *folder, uint64_t shard);

/* Writes a file of the folder whole: 0 or an errno value. */
int folder_write(struct folder *folder, const char *name, const char *text, size_t length);

/* A text file below the folder, ended by a 0 byte, to be freed; NULL where it cannot be read. */
char *folder_read(const struct folder *folder, const char *name, size_t *length);

/* Bytes that are free where the folder is; the greatest number where that is not known. */
uint64_t folder_free_bytes(const struct folder *folder);

#endif
