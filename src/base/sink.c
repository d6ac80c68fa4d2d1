/* SPDX-License-Identifier: MIT */
/*
 * Whole-or-nothing output: buffering, files in memory, the first failure and its report.  Names and places are
 * staged.c's.
 */
#include "sink.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "memory.h"
#include "reason.h"
#include "staged.h"

/* Larger pieces are slower: writing 1.6 GB cost Linux 0.7 s in pieces of 6 MB, and 0.2 s in pieces of 256 kB. */
enum { LX_SINK_BUFFER = 1 << 16, LX_LARGEST_WRITE = 1 << 18 };

/* A file in memory. */
struct memory {
    unsigned char *bytes;
    size_t length, capacity, place; /* the next byte goes to `place`, at most at the end */
};

struct lx_sink {
    struct lx_destination destination; /* its path is the member below */
    struct memory memory;              /* where it is memory, */
    struct lx_staged staged;           /* and where it is a path */
    luxel_diagnostics *diagnostics;
    char *path;          /* as the user wrote it */
    luxel_status status; /* what the first failure was reported as */
    size_t used;         /* bytes of buffer */
    unsigned char buffer[LX_SINK_BUFFER];
};

static luxel_status report(luxel_diagnostics *diagnostics, enum lx_message message, const char *path, int error)
{
    if (error == ENOMEM) {
        return lx_out_of_memory(diagnostics);
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, message, LX_ARGS(path, LX_TERM(lx_reason(error))));
    return LUXEL_ERROR_FILE;
}

/* A sink that has no file yet; NULL: memory is short. */
static struct lx_sink *new_sink(const char *path, luxel_diagnostics *diagnostics)
{
    struct lx_sink *made = malloc(sizeof *made);
    char *copy = strdup(path);

    if (made == NULL || copy == NULL) {
        free(made);
        free(copy);
        return NULL;
    }
    made->destination = (struct lx_destination){0};
    made->memory = (struct memory){0};
    made->diagnostics = diagnostics;
    made->path = copy;
    made->status = LUXEL_OK;
    made->used = 0;
    return made;
}

luxel_status lx_sink_open(const char *path, const struct lx_sink_system *system, luxel_diagnostics *diagnostics,
                          struct lx_sink **sink)
{
    struct lx_sink *made = new_sink(path, diagnostics);

    if (made == NULL) {
        return lx_out_of_memory(diagnostics);
    }
    int error = lx_staged_open(&made->staged, path, system != NULL ? system : &lx_sink_real_system);
    if (error != 0) {
        luxel_status status = report(diagnostics, LX_MSG_FILE_NOT_CREATED, path, error);
        lx_sink_abort(made);
        return status;
    }
    *sink = made;
    return LUXEL_OK;
}

luxel_status lx_sink_open_at(const struct lx_destination *destination, luxel_diagnostics *diagnostics,
                             struct lx_sink **sink)
{
    if (destination->bytes == NULL) {
        return lx_sink_open(destination->path, NULL, diagnostics, sink);
    }
    struct lx_sink *made = new_sink(destination->path, diagnostics);

    if (made == NULL) {
        return lx_out_of_memory(diagnostics);
    }
    made->destination.bytes = destination->bytes;
    made->destination.length = destination->length;
    *sink = made;
    return LUXEL_OK;
}

struct lx_destination *lx_destinations_of(const char *const *paths, size_t count)
{
    struct lx_destination *destinations = lx_new_array(count, sizeof *destinations);

    for (size_t i = 0; destinations && i < count; i++)
        destinations[i] = (struct lx_destination){.path = paths[i]};
    return destinations;
}

luxel_status lx_sink_put(const struct lx_destination *destination, const void *bytes, size_t count,
                         luxel_diagnostics *diagnostics)
{
    struct lx_sink *sink;
    luxel_status status = lx_sink_open_at(destination, diagnostics, &sink);

    if (status != LUXEL_OK) {
        return status;
    }
    lx_sink_write(sink, bytes, count);
    return lx_sink_commit(sink);
}

/* 0 or an errno value. */
static int write_memory(struct memory *memory, const unsigned char *bytes, size_t count)
{
    if (count == 0) {
        return 0;
    }
    if (count > SIZE_MAX - memory->place ||
        lx_reserve(&memory->bytes, &memory->capacity, memory->place + count, 1) < 0) {
        return ENOMEM;
    }
    memcpy(memory->bytes + memory->place, bytes, count);
    memory->place += count;
    memory->length = memory->place > memory->length ? memory->place : memory->length;
    return 0;
}

/* Writes all of the bytes, in as many calls as the system wants.  0 or an errno value. */
static int write_staged(const struct lx_staged *staged, const unsigned char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t written =
            staged->system->write(staged->file, bytes, count < LX_LARGEST_WRITE ? count : LX_LARGEST_WRITE);

        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return written < 0 ? errno : EIO; /* a file that takes nothing would keep us here for ever */
        }
        bytes += written;
        count -= (size_t)written;
    }
    return 0;
}

static int write_all(struct lx_sink *sink, const unsigned char *bytes, size_t count)
{
    return sink->destination.bytes != NULL ? write_memory(&sink->memory, bytes, count)
                                           : write_staged(&sink->staged, bytes, count);
}

/* Writes out the buffer and then the bytes. */
static void flush_with(struct lx_sink *sink, const void *bytes, size_t count)
{
    int error = write_all(sink, sink->buffer, sink->used);

    sink->used = 0;
    if (error == 0) {
        error = write_all(sink, bytes, count);
    }
    if (error != 0) {
        sink->status = report(sink->diagnostics, LX_MSG_FILE_NOT_WRITTEN, sink->path, error);
    }
}

luxel_status lx_sink_write(struct lx_sink *sink, const void *bytes, size_t count)
{
    if (sink->status != LUXEL_OK || count == 0) {
        return sink->status;
    }
    if (count >= LX_SINK_BUFFER) {
        flush_with(sink, bytes, count);
        return sink->status;
    }
    if (count > LX_SINK_BUFFER - sink->used) {
        flush_with(sink, NULL, 0);
    }
    memcpy(sink->buffer + sink->used, bytes, count);
    sink->used += count;
    return sink->status;
}

bool lx_sink_is_direct(const struct lx_sink *sink)
{
    return sink->destination.bytes == NULL && sink->staged.direct;
}

/* Goes to a place of a file in memory, filling up with zeros as far as the file does not reach, as files do. */
static int seek_memory(struct memory *memory, uint64_t place)
{
    if (place > memory->length) {
        if (place > SIZE_MAX || lx_reserve(&memory->bytes, &memory->capacity, (size_t)place, 1) < 0) {
            return ENOMEM;
        }
        memset(memory->bytes + memory->length, 0, (size_t)place - memory->length);
        memory->length = (size_t)place;
    }
    memory->place = (size_t)place;
    return 0;
}

static int seek(struct lx_sink *sink, uint64_t place)
{
    if (sink->destination.bytes != NULL) {
        return seek_memory(&sink->memory, place);
    }
    return lseek(sink->staged.file, (off_t)place, SEEK_SET) < 0 ? errno : 0;
}

luxel_status lx_sink_seek(struct lx_sink *sink, uint64_t place)
{
    if (sink->status == LUXEL_OK) {
        flush_with(sink, NULL, 0);
    }
    int error = sink->status == LUXEL_OK ? seek(sink, place) : 0;

    if (error != 0) {
        sink->status = report(sink->diagnostics, LX_MSG_FILE_NOT_WRITTEN, sink->path, error);
    }
    return sink->status;
}

/* Some bytes that were written, as pread() does. */
static ssize_t read_some(const struct lx_sink *sink, uint64_t place, void *bytes, size_t count)
{
    const struct memory *memory = &sink->memory;

    if (sink->destination.bytes == NULL) {
        return pread(sink->staged.file, bytes, count < LX_LARGEST_WRITE ? count : LX_LARGEST_WRITE, (off_t)place);
    }
    size_t left = place < memory->length ? memory->length - (size_t)place : 0, got = count < left ? count : left;

    got = got < LX_LARGEST_WRITE ? got : LX_LARGEST_WRITE;
    if (got > 0) {
        memcpy(bytes, memory->bytes + place, got);
    }
    return (ssize_t)got;
}

luxel_status lx_sink_read_back(struct lx_sink *sink, uint64_t place, void *bytes, size_t count)
{
    unsigned char *next = bytes;

    if (sink->status == LUXEL_OK) {
        flush_with(sink, NULL, 0);
    }
    while (sink->status == LUXEL_OK && count > 0) {
        ssize_t got = read_some(sink, place, next, count);

        if (got > 0) {
            next += got;
            place += (uint64_t)got;
            count -= (size_t)got;
        } else if (got == 0 || errno != EINTR) {
            sink->status = report(sink->diagnostics, LX_MSG_FILE_NOT_WRITTEN, sink->path, got < 0 ? errno : EIO);
        }
    }
    return sink->status;
}

#ifdef __EMSCRIPTEN__
/* WebAssembly has no disk that could be full. */
#define fallocate(file, mode, from, bytes) ((void)(bytes), 0)
#endif

luxel_status lx_sink_reserve(struct lx_sink *sink, uint64_t bytes)
{
    if (sink->status == LUXEL_OK && sink->destination.bytes == NULL && !sink->staged.direct &&
        fallocate(sink->staged.file, FALLOC_FL_KEEP_SIZE, 0, (off_t)bytes) != 0 &&
        (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)) {
        sink->status = report(sink->diagnostics, LX_MSG_FILE_NOT_WRITTEN, sink->path, errno);
    }
    return sink->status;
}

luxel_status lx_sink_status(const struct lx_sink *sink)
{
    return sink->status;
}

luxel_status lx_sink_fail(struct lx_sink *sink, enum lx_message message, const char *detail)
{
    if (sink->status == LUXEL_OK) {
        lx_report(sink->diagnostics, LUXEL_SEVERITY_ERROR, NULL, message, LX_ARGS(sink->path, LX_TERM(detail)));
        sink->status = LUXEL_ERROR_FILE;
    }
    return sink->status;
}

luxel_status lx_sink_out_of_memory(struct lx_sink *sink)
{
    if (sink->status == LUXEL_OK) {
        sink->status = lx_out_of_memory(sink->diagnostics);
    }
    return sink->status;
}

/* Makes a file durable and puts it in its place. */
static void publish(struct lx_sink *sink)
{
    /* The bytes must be on the disk before the name is: otherwise a power cut could leave an empty file there. */
    if (!sink->staged.direct && sink->staged.system->sync(sink->staged.file) != 0 &&
        errno != EINVAL) { /* EINVAL: a file system without fsync */
        sink->status = report(sink->diagnostics, LX_MSG_FILE_NOT_WRITTEN, sink->path, errno);
    }
    if (sink->status == LUXEL_OK) {
        int error = lx_staged_publish(&sink->staged);

        if (error != 0) {
            sink->status = report(sink->diagnostics, LX_MSG_FILE_NOT_REPLACED, sink->path, error);
        }
    }
}

/* Hands the bytes over; even of an empty file there are some, so that they can be told from none. */
static void hand_over(struct lx_sink *sink)
{
    struct memory *memory = &sink->memory;

    if (memory->bytes == NULL && lx_reserve(&memory->bytes, &memory->capacity, 1, 1) < 0) {
        lx_sink_out_of_memory(sink);
        return;
    }
    *sink->destination.bytes = memory->bytes;
    *sink->destination.length = memory->length;
    memory->bytes = NULL;
}

luxel_status lx_sink_commit(struct lx_sink *sink)
{
    if (sink->status == LUXEL_OK) {
        flush_with(sink, NULL, 0);
    }
    if (sink->status == LUXEL_OK) {
        (sink->destination.bytes != NULL ? hand_over : publish)(sink);
    }
    luxel_status status = sink->status;
    lx_sink_abort(sink);
    return status;
}

void lx_sink_abort(struct lx_sink *sink)
{
    if (sink != NULL) {
        if (sink->destination.bytes == NULL) {
            lx_staged_close(&sink->staged);
        }
        free(sink->memory.bytes);
        free(sink->path);
        free(sink);
    }
}
