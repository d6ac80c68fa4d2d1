/* SPDX-License-Identifier: MIT */
/*
 * Sources: the bytes of a file, of a pipe or of memory, read at any offset.  Like a sink, a source keeps its first
 * failure and reports it once, under its name, so that a reader of a format need not look at every call.
 *
 * Built-in files (builtin_file.h) are read by their paths, like others.
 *
 * A regular file is read where it stands, whatever its size.  What cannot be read at any offset (a pipe, a device)
 * is taken into memory first, up to a limit, so that an endless one comes to an end.
 *
 * Threads: one source belongs to one thread at a time; separate sources are independent.
 */
#ifndef LX_BASE_SOURCE_H
#define LX_BASE_SOURCE_H

#include <stddef.h>
#include <stdint.h>

#include "diagnostics.h"

struct lx_source;

/*
 * Opens a file.  Of a pipe at most `most` bytes and one more are taken: a source of more than `most` bytes may go on
 * behind them.  `diagnostics` takes the reports of this and of all later calls and must outlive the source.
 * LUXEL_ERROR_FILE: it cannot be read.  LUXEL_ERROR_MEMORY.
 */
luxel_status lx_source_open(const char *path, size_t most, luxel_diagnostics *diagnostics, struct lx_source **source);

/*
 * A source for a file whose failures others report, at a place of their own: always a source, which may have failed
 * already; NULL: memory ran out.  Devices are refused: some have no end, and reading up to the limit takes seconds.
 */
struct lx_source *lx_source_try(const char *path, size_t most);

/* Why the file cannot be read, a term (phrase.h); NULL where it can. */
const char *lx_source_reason(const struct lx_source *source);

/* A source of bytes in memory, which must outlive it, under a name for its reports. */
luxel_status lx_source_of_bytes(const char *name, const void *bytes, size_t length, luxel_diagnostics *diagnostics,
                                struct lx_source **source);

/* NULL is harmless. */
void lx_source_close(struct lx_source *source);

const char *lx_source_name(const struct lx_source *source);
uint64_t lx_source_size(const struct lx_source *source);
luxel_diagnostics *lx_source_diagnostics(const struct lx_source *source);

/* LUXEL_OK, or what the source failed with. */
luxel_status lx_source_status(const struct lx_source *source);

/*
 * Reads exactly so many bytes from an offset on.  After a failure it does nothing and returns the same status.
 * LUXEL_ERROR_FILE: the source ends before them, or cannot be read.
 */
luxel_status lx_source_read(struct lx_source *source, uint64_t offset, void *bytes, size_t count);

/*
 * Makes the source fail with this status because what it holds is not as it should be, unless it has failed already.
 * The message is reported at the source's name, with the arguments (NULL: none).  Returns what it failed with.
 */
luxel_status lx_source_fail(struct lx_source *source, luxel_status status, enum lx_message message,
                            const char *const *arguments);

/* lx_source_fail() because of what the source holds, with the status of lx_source_judge(). */
luxel_status lx_source_refuse(struct lx_source *source, enum lx_message message, const char *const *arguments);

/*
 * From here on what the source holds is refused with this status (LUXEL_ERROR_FILE before), at the beginning of the
 * source, which reports show as this text (as long as the source lives).
 */
void lx_source_judge(struct lx_source *source, luxel_status refusal, const char *text, size_t length);

/* Makes the source fail, as lx_source_refuse() does, because of what the caller has reported itself. */
luxel_status lx_source_give_up(struct lx_source *source);

/* lx_source_fail() for memory that ran out. */
luxel_status lx_source_out_of_memory(struct lx_source *source);

#endif
