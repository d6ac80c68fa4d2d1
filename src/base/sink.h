/* SPDX-License-Identifier: MIT */
/*
 * Whole-or-nothing output: a sink takes the bytes of a file, and the file appears under its name only when
 * all of them are safely written.  Until then, and after any failure, whatever stood there stays.
 *
 * Where the path is a symbolic link, the file it points to is written and the link stays.  A file that is
 * replaced keeps its permission bits and, as far as the process may, its owner and group; one that the process
 * may not write is refused, although its folder would let it be replaced.  A path to something that is no regular
 * file (a device, a pipe, /dev/stdout) is written to directly, and what was written cannot be taken back.
 *
 * Several processes may write the same file at the same time: it ends as the whole file of one of them.
 * A process that is killed leaves nothing behind where the file system has unnamed files.  Elsewhere, or when
 * it dies in the instant in which the file gets its name, a hidden file ".luxel-..." stays, which the next
 * sink for the same file removes.
 *
 * A sink for memory is a file of the process alone: it takes, seeks and reads back as a regular one.
 *
 * Threads: one sink belongs to one thread at a time; separate sinks are independent.
 */
#ifndef LX_BASE_SINK_H
#define LX_BASE_SINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>
#include <unistd.h> /* which may give functions, and members of their names, other names */

#include "diagnostics.h"

struct lx_sink;

/* Where the bytes of a file go: to a path, or to memory, where nothing stands until all of them are there. */
struct lx_destination {
    const char *path;      /* of what is kept in memory only a name, for messages and by its ending for formats */
    unsigned char **bytes; /* NULL: to the path.  Else lx_sink_commit() sets it to the bytes, which are the caller's, */
    size_t *length;        /* and this to how many there are */
};

/* The system calls that a test replaces to see what happens when they fail.  Each works like its namesake. */
struct lx_sink_system {
    int (*open_unnamed)(int folder, mode_t mode); /* openat(folder, ".", O_TMPFILE ...) */
    ssize_t (*write)(int file, const void *bytes, size_t count);
    int (*sync)(int file);
    int (*rename)(int folder, const char *from, const char *to);
};

extern const struct lx_sink_system lx_sink_real_system;

/*
 * Opens a sink for the file at `path`.  `system` NULL: the real one; else it must outlive the sink, as
 * `diagnostics` must, which takes the reports of this and of all later calls.
 * LUXEL_ERROR_FILE: no file can be made there.  LUXEL_ERROR_MEMORY.
 */
luxel_status lx_sink_open(const char *path, const struct lx_sink_system *system, luxel_diagnostics *diagnostics,
                          struct lx_sink **sink);

/* Opens a sink for a destination, as lx_sink_open() does; what it points to for the bytes must outlive the sink. */
luxel_status lx_sink_open_at(const struct lx_destination *destination, luxel_diagnostics *diagnostics,
                             struct lx_sink **sink);

/* The files of these paths as destinations, to be freed with free(); NULL: memory is short. */
struct lx_destination *lx_destinations_of(const char *const *paths, size_t count);

/* Writes a whole file at once, or not at all. */
luxel_status lx_sink_put(const struct lx_destination *destination, const void *bytes, size_t count,
                         luxel_diagnostics *diagnostics);

/*
 * Appends bytes.  After a failure, which is reported once, it does nothing and returns the same status, so
 * that a writer need not look at every call: lx_sink_commit() fails too.
 */
luxel_status lx_sink_write(struct lx_sink *sink, const void *bytes, size_t count);

/* Whether the file takes its bytes in one order only: it is a device, a pipe. */
bool lx_sink_is_direct(const struct lx_sink *sink);

/* Goes to a place in the file, where the next bytes are written; not of a direct one.  Fails as lx_sink_write(). */
luxel_status lx_sink_seek(struct lx_sink *sink, uint64_t place);

/* Reads bytes that were written; not of a direct one.  Fails as lx_sink_write(). */
luxel_status lx_sink_read_back(struct lx_sink *sink, uint64_t place, void *bytes, size_t count);

/*
 * Fails where the disk has not this much room, so that a full disk is known before a long work and not after it.
 * Where the file system cannot tell, it does nothing.
 */
luxel_status lx_sink_reserve(struct lx_sink *sink, uint64_t bytes);

/* LUXEL_OK, or what the sink failed with. */
luxel_status lx_sink_status(const struct lx_sink *sink);

/*
 * Makes the sink fail because what would write to it cannot go on, unless it has failed already.  Reports
 * `message` with the path as {0} and `detail` as {1}; returns LUXEL_ERROR_FILE, or what it had failed with.
 */
luxel_status lx_sink_fail(struct lx_sink *sink, enum lx_message message, const char *detail);

/* lx_sink_fail() for memory that ran out; returns LUXEL_ERROR_MEMORY, or what it had failed with. */
luxel_status lx_sink_out_of_memory(struct lx_sink *sink);

/* Makes the file durable and puts it in its place.  Frees the sink, whether that succeeds or not. */
luxel_status lx_sink_commit(struct lx_sink *sink);

/* Gives the file up: nothing is left of it.  Frees the sink; NULL is harmless. */
void lx_sink_abort(struct lx_sink *sink);

#endif
