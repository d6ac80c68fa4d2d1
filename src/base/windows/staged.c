/* SPDX-License-Identifier: MIT */
/*
 * Staged files on Windows: a file of a hidden name beside its place, put there in one step by its handle.
 *
 * Hidden names are few and follow from the target's name, so that leftovers of killed processes can be found.  Whoever
 * writes a hidden file lets nobody else remove it; what can be removed was left by a dead process.
 */
#include "../staged.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../path.h"
#include "files.h"

enum { SLOTS = 8, ATTEMPTS = 1000 };

static int no_unnamed(int folder, mode_t mode)
{
    (void)folder;
    (void)mode;
    errno = EOPNOTSUPP;
    return -1;
}

static ssize_t write_bytes(int file, const void *bytes, size_t count)
{
    DWORD written;
    if (WriteFile((HANDLE)_get_osfhandle(file), bytes, count < INT_MAX ? (DWORD)count : INT_MAX, &written, NULL))
        return (ssize_t)written;
    const DWORD error = GetLastError();
    errno = error == ERROR_NO_DATA || error == ERROR_BROKEN_PIPE ? EPIPE : lx_windows_error(error);
    return -1;
}

static int sync_file(int file)
{
    return FlushFileBuffers((HANDLE)_get_osfhandle(file)) ? 0 : (errno = lx_windows_error(GetLastError()), -1);
}

static int rename_path(int folder, const char *from, const char *to)
{
    (void)folder;
    return rename(from, to);
}

const struct lx_sink_system lx_sink_real_system = {no_unnamed, write_bytes, sync_file, rename_path};

/* The path of hidden name number `slot` of a target. */
static char *hidden_path(struct lx_staged *staged, unsigned slot)
{
    const char *name = lx_path_name(staged->target);
    const size_t folder = (size_t)(name - staged->target);
    lx_staged_hidden_name(name, slot, staged->hidden);
    char *path = malloc(folder + LX_HIDDEN_SIZE);
    if (path) {
        memcpy(path, staged->target, folder);
        strcpy(path + folder, staged->hidden);
    }
    return path;
}

/* Makes the file of one hidden name.  EEXIST: another process has it. */
static int create_hidden(struct lx_staged *staged, unsigned slot)
{
    char *path = hidden_path(staged, slot);
    wchar_t *wide = path ? lx_windows_wide(path) : NULL;
    int error = wide ? 0 : ENOMEM;
    if (wide) {
        DeleteFileW(wide); /* fails while a process has it */
        HANDLE handle = CreateFileW(wide, GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_READ, NULL, CREATE_NEW,
                                    FILE_ATTRIBUTE_NORMAL, NULL);
        error = handle == INVALID_HANDLE_VALUE ? lx_windows_error(GetLastError()) : 0;
        staged->file = error == 0 ? _open_osfhandle((intptr_t)handle, _O_RDWR | _O_BINARY | _O_NOINHERIT) : -1;
        if (error == 0 && staged->file < 0) {
            CloseHandle(handle);
            error = EMFILE;
        }
    }
    free(wide);
    free(path);
    return error;
}

static int create(struct lx_staged *staged)
{
    for (unsigned attempt = 0; attempt < ATTEMPTS; attempt++) {
        for (unsigned slot = 0; slot < SLOTS; slot++) {
            const int error = create_hidden(staged, slot);
            if (error == 0)
                return 0;
            staged->hidden[0] = '\0';
            if (error != EEXIST)
                return error;
        }
        Sleep(1);
    }
    return EBUSY;
}

static int open_direct(struct lx_staged *staged, const char *path)
{
    staged->direct = true;
    staged->file = path ? open(path, O_WRONLY | O_CLOEXEC) : dup(STDOUT_FILENO);
    if (staged->file < 0)
        return errno;
    _setmode(staged->file, _O_BINARY);
    return 0;
}

int lx_staged_open(struct lx_staged *staged, const char *path, const struct lx_sink_system *system)
{
    struct stat about;
    *staged = (struct lx_staged){.system = system, .file = -1, .folder = -1};
    if (lx_staged_is_standard_output(path))
        return open_direct(staged, NULL);
    if (path[0] == '\0')
        return ENOENT;
    const bool exists = stat(path, &about) == 0;
    if (!exists && errno != ENOENT)
        return errno;
    if (exists && S_ISDIR(about.st_mode))
        return EISDIR;
    if (exists && !S_ISREG(about.st_mode))
        return open_direct(staged, path);
    if (exists && access(path, W_OK) != 0) /* the file is protected by its owner */
        return errno;
    if (*lx_path_name(path) == '\0')
        return EISDIR;
    /* The place of a link is where it leads to. */
    staged->target = exists ? realpath(path, NULL) : strdup(path);
    return staged->target ? create(staged) : errno;
}

int lx_staged_publish(struct lx_staged *staged)
{
    if (staged->direct)
        return 0;
    wchar_t *full = malloc(LX_LONGEST_PATH * sizeof *full), *wide = lx_windows_wide(staged->target);
    DWORD length = full && wide ? GetFullPathNameW(wide, LX_LONGEST_PATH, full, NULL) : 0;
    FILE_RENAME_INFO *wanted = length > 0 ? calloc(1, sizeof *wanted + (length + 1) * sizeof(wchar_t)) : NULL;
    int error = ENOMEM;
    if (wanted) {
        wanted->ReplaceIfExists = TRUE;
        wanted->FileNameLength = length * (DWORD)sizeof(wchar_t);
        memcpy(wanted->FileName, full, (length + 1) * sizeof(wchar_t));
        const DWORD size = (DWORD)(sizeof *wanted + length * sizeof(wchar_t));
        HANDLE handle = (HANDLE)_get_osfhandle(staged->file);
        error = SetFileInformationByHandle(handle, FileRenameInfo, wanted, size) ? 0 : lx_windows_error(GetLastError());
    }
    free(wanted);
    free(wide);
    free(full);
    if (error == 0)
        staged->hidden[0] = '\0';
    return error;
}

void lx_staged_close(struct lx_staged *staged)
{
    if (staged->hidden[0] != '\0' && staged->file >= 0) {
        FILE_DISPOSITION_INFO gone = {.DeleteFile = TRUE};
        SetFileInformationByHandle((HANDLE)_get_osfhandle(staged->file), FileDispositionInfo, &gone, sizeof gone);
    }
    if (staged->file >= 0)
        close(staged->file);
    free(staged->target);
}
