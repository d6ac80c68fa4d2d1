/* SPDX-License-Identifier: MIT */
/* Sources: files read in place, pipes taken into memory, and the first failure with its report. */
#include "source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "builtin_file.h"
#include "memory.h"
#include "reason.h"

enum { FIRST_BLOCK = 64 * 1024, LARGEST_READ = 1 << 30 };

struct lx_source {
    luxel_diagnostics *diagnostics;
    char *name;
    luxel_status status;  /* what the first failure was reported as */
    luxel_status refusal; /* what it holds is refused with */
    const char *reason;   /* why the system does not give it */
    const char *start;    /* what stands for its beginning in reports; NULL: nothing */
    size_t start_length;
    int file;                   /* -1: everything is in memory */
    const unsigned char *bytes; /* what is in memory */
    unsigned char *owned;       /* the same where it must be freed */
    uint64_t size;
};

luxel_status lx_source_fail(struct lx_source *source, luxel_status status, enum lx_message message,
                            const char *const *arguments)
{
    struct lx_place place = {
        .source = source->name, .text = source->start, .length = source->start_length, .end = source->start_length};
    if (source->status == LUXEL_OK) {
        source->status = status;
        lx_report(source->diagnostics, LUXEL_SEVERITY_ERROR, &place, message, arguments);
    }
    return source->status;
}

luxel_status lx_source_refuse(struct lx_source *source, enum lx_message message, const char *const *arguments)
{
    return lx_source_fail(source, source->refusal, message, arguments);
}

luxel_status lx_source_give_up(struct lx_source *source)
{
    if (source->status == LUXEL_OK)
        source->status = source->refusal;
    return source->status;
}

void lx_source_judge(struct lx_source *source, luxel_status refusal, const char *text, size_t length)
{
    source->refusal = refusal;
    source->start = text;
    source->start_length = length;
}

luxel_status lx_source_out_of_memory(struct lx_source *source)
{
    if (source->status == LUXEL_OK)
        source->status = lx_out_of_memory(source->diagnostics);
    return source->status;
}

/* A file that the system does not give: without a place, like one that cannot be written. */
static luxel_status cannot_read(struct lx_source *source, const char *reason)
{
    if (source->status == LUXEL_OK) {
        source->status = LUXEL_ERROR_FILE;
        source->reason = reason;
        lx_report(source->diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FILE_NOT_READ,
                  LX_ARGS(source->name, LX_TERM(source->reason)));
    }
    return source->status;
}

static luxel_status new_source(const char *name, luxel_diagnostics *diagnostics, struct lx_source **result)
{
    struct lx_source *source = lx_new_array(1, sizeof *source);
    char *copy = lx_copy_text(name, strlen(name));
    if (!source || !copy) {
        free(source);
        free(copy);
        return lx_out_of_memory(diagnostics);
    }
    *source = (struct lx_source){.diagnostics = diagnostics, .name = copy, .refusal = LUXEL_ERROR_FILE, .file = -1};
    *result = source;
    return LUXEL_OK;
}

/* Takes what the file gives until its end, or one byte beyond the limit. */
static luxel_status take_all(struct lx_source *source, size_t most)
{
    size_t length = 0, capacity = 0;
    while (length <= most) {
        if (length == capacity &&
            lx_reserve(&source->owned, &capacity, capacity ? 2 * capacity : (size_t)FIRST_BLOCK, 1) < 0)
            return lx_source_out_of_memory(source);
        size_t room = capacity - length, left = most - length;
        if (room > left)
            room = left + 1;
        ssize_t got = read(source->file, source->owned + length, room < LARGEST_READ ? room : LARGEST_READ);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return cannot_read(source, lx_reason(errno));
        if (got == 0)
            break;
        length += (size_t)got;
    }
    source->bytes = source->owned;
    source->size = length;
    close(source->file);
    source->file = -1;
    return LUXEL_OK;
}

static luxel_status open_builtin(struct lx_source *source)
{
    const struct lx_builtin_file *file = lx_builtin_file_of(source->name);
    if (!file)
        return cannot_read(source, LX_N("There is no built-in file of that name"));
    source->bytes = file->bytes;
    source->size = file->length;
    return LUXEL_OK;
}

static luxel_status open_file(struct lx_source *source, size_t most, bool may_be_device)
{
    struct stat about;
    if (lx_is_builtin_path(source->name))
        return open_builtin(source);
    source->file = open(source->name, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (source->file < 0 || fstat(source->file, &about) < 0)
        return cannot_read(source, lx_reason(errno));
    if (S_ISDIR(about.st_mode))
        return cannot_read(source, lx_reason(EISDIR));
    if (S_ISCHR(about.st_mode) && !may_be_device)
        return cannot_read(source, LX_N("Is a device"));
    source->size = (uint64_t)about.st_size;
    /* Files made up by the system, as in /proc, say that they are empty. */
    return S_ISREG(about.st_mode) && about.st_size > 0 ? LUXEL_OK : take_all(source, most);
}

luxel_status lx_source_open(const char *path, size_t most, luxel_diagnostics *diagnostics, struct lx_source **source)
{
    struct lx_source *made = NULL;
    luxel_status status = new_source(path, diagnostics, &made);
    if (status == LUXEL_OK)
        status = open_file(made, most, true);
    if (status == LUXEL_OK)
        *source = made;
    else
        lx_source_close(made);
    return status;
}

struct lx_source *lx_source_try(const char *path, size_t most)
{
    struct lx_source *source = NULL;
    if (new_source(path, NULL, &source) == LUXEL_OK)
        open_file(source, most, false);
    return source;
}

const char *lx_source_reason(const struct lx_source *source)
{
    return source->reason;
}

luxel_status lx_source_of_bytes(const char *name, const void *bytes, size_t length, luxel_diagnostics *diagnostics,
                                struct lx_source **source)
{
    luxel_status status = new_source(name, diagnostics, source);
    if (status == LUXEL_OK) {
        (*source)->bytes = bytes;
        (*source)->size = length;
    }
    return status;
}

void lx_source_close(struct lx_source *source)
{
    if (!source)
        return;
    if (source->file >= 0)
        close(source->file);
    free(source->owned);
    free(source->name);
    free(source);
}

const char *lx_source_name(const struct lx_source *source)
{
    return source->name;
}

uint64_t lx_source_size(const struct lx_source *source)
{
    return source->size;
}

luxel_diagnostics *lx_source_diagnostics(const struct lx_source *source)
{
    return source->diagnostics;
}

luxel_status lx_source_status(const struct lx_source *source)
{
    return source->status;
}

luxel_status lx_source_read(struct lx_source *source, uint64_t offset, void *bytes, size_t count)
{
    if (source->status != LUXEL_OK)
        return source->status;
    if (offset > source->size || count > source->size - offset)
        return lx_source_refuse(source, LX_MSG_FILE_ENDS, NULL);
    if (source->file < 0 && count > 0)
        memcpy(bytes, source->bytes + offset, count);
    for (size_t done = 0; source->file >= 0 && done < count;) {
        size_t left = count - done;
        ssize_t got = pread(source->file, (char *)bytes + done, left < LARGEST_READ ? left : LARGEST_READ,
                            (off_t)(offset + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return cannot_read(source, lx_reason(errno));
        if (got == 0) /* it became shorter in the meantime */
            return lx_source_refuse(source, LX_MSG_FILE_ENDS, NULL);
        done += (size_t)got;
    }
    return LUXEL_OK;
}
