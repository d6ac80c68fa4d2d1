/* SPDX-License-Identifier: MIT */
/*
 * Reading a scene file.  Pipes and devices are read like files, up to the limit, so a text without end is
 * refused like one that is too large.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../base/memory.h"
#include "../base/reason.h"
#include "guard.h"
#include "input.h"

enum { FIRST_BLOCK = 64 * 1024 };

luxel_status lx_refuse_size(const char *source, luxel_diagnostics *diagnostics)
{
    struct lx_place place = {.source = source};
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_TEXT_TOO_LARGE, LX_ARGS("64 MB"));
    return LUXEL_ERROR_SCENE;
}

static luxel_status cannot_read(const char *path, int reason, luxel_diagnostics *diagnostics)
{
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FILE_NOT_READ, LX_ARGS(path, lx_reason(reason)));
    return LUXEL_ERROR_FILE;
}

static luxel_status read_all(int file, const char *path, luxel_diagnostics *diagnostics, char **text, size_t *length)
{
    size_t capacity = 0;
    *text = NULL;
    *length = 0;
    for (;;) {
        if (*length == capacity && lx_reserve((void **)text, &capacity, capacity ? 2 * capacity : FIRST_BLOCK, 1) < 0)
            return lx_out_of_memory(diagnostics);
        ssize_t got = read(file, *text + *length, capacity - *length);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return cannot_read(path, errno, diagnostics);
        if (got == 0)
            return LUXEL_OK;
        *length += (size_t)got;
        if (*length > LX_LARGEST_TEXT)
            return lx_refuse_size(path, diagnostics);
    }
}

luxel_status lx_read_input(const char *path, luxel_diagnostics *diagnostics, char **text, size_t *length)
{
    struct stat about;
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0 || fstat(file, &about) < 0) {
        luxel_status status = cannot_read(path, errno, diagnostics);
        if (file >= 0)
            close(file);
        return status;
    }
    char *read_text = NULL;
    luxel_status status;
    if (S_ISDIR(about.st_mode))
        status = cannot_read(path, EISDIR, diagnostics);
    else if (S_ISREG(about.st_mode) && about.st_size > LX_LARGEST_TEXT)
        status = lx_refuse_size(path, diagnostics);
    else
        status = read_all(file, path, diagnostics, &read_text, length);
    close(file);
    if (status == LUXEL_OK)
        *text = read_text;
    else
        free(read_text);
    return status;
}
