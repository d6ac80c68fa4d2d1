/* SPDX-License-Identifier: MIT */
/*
 * Functions of POSIX that begin at an open folder, and locks of bytes, as the headers of include/ declare them.  A
 * folder is opened as a file is, and Windows tells its path, which stays right where it is moved.
 */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "files.h"

/* The wide path of a name in an open folder; NULL and errno. */
static wchar_t *path_at(int folder, const char *name)
{
    if (folder == AT_FDCWD)
        return lx_windows_wide(name);
    wchar_t *path = malloc(LX_LONGEST_PATH * sizeof *path);
    const DWORD length = path ? GetFinalPathNameByHandleW((HANDLE)_get_osfhandle(folder), path, LX_LONGEST_PATH, 0) : 0;
    if (length == 0 || length >= LX_LONGEST_PATH) {
        errno = path ? EBADF : ENOMEM;
        free(path);
        return NULL;
    }
    if (strcmp(name, ".") == 0)
        return path;
    path[length] = L'\\';
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, name, -1, path + length + 1,
                            LX_LONGEST_PATH - (int)length - 1) == 0) {
        errno = ENAMETOOLONG;
        free(path);
        return NULL;
    }
    for (wchar_t *at = path + length + 1; *at != L'\0'; at++)
        *at = *at == L'/' ? L'\\' : *at;
    return path;
}

int openat(int folder, const char *name, int flags, ...)
{
    return lx_windows_open_wide(path_at(folder, name), flags);
}

DIR *fdopendir(int folder)
{
    DIR *entries = lx_windows_opendir_wide(path_at(folder, "."));
    if (entries)
        close(folder);
    return entries;
}

int fstatat(int folder, const char *name, struct stat *about, int flags)
{
    (void)flags;
    return lx_windows_stat_wide(path_at(folder, name), about);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to)
{
    return lx_windows_rename_wide(path_at(from_folder, from), path_at(to_folder, to));
}

/* 0, or -1 with errno, of a change of a path, which is freed. */
static int change(wchar_t *path, BOOL(WINAPI *function)(const wchar_t *))
{
    const int failed = path && function(path) ? 0 : -1;
    if (path && failed)
        errno = lx_windows_error(GetLastError());
    free(path);
    return failed;
}

static BOOL WINAPI make_folder(const wchar_t *path)
{
    return CreateDirectoryW(path, NULL);
}

int mkdirat(int folder, const char *name, int mode)
{
    (void)mode;
    return change(path_at(folder, name), make_folder);
}

int unlinkat(int folder, const char *name, int flags)
{
    return change(path_at(folder, name), flags & AT_REMOVEDIR ? RemoveDirectoryW : DeleteFileW);
}

int fstatvfs(int folder, struct statvfs *about)
{
    ULARGE_INTEGER bytes;
    wchar_t *path = path_at(folder, ".");
    const BOOL is_told = path && GetDiskFreeSpaceExW(path, &bytes, NULL, NULL);
    free(path);
    *about = (struct statvfs){.f_bavail = is_told ? bytes.QuadPart : 0, .f_frsize = 1};
    return is_told ? 0 : -1;
}

static int lock_bytes(HANDLE file, int command, const struct flock *lock)
{
    const unsigned long long from = (unsigned long long)lock->l_start,
                             length = lock->l_len > 0 ? (unsigned long long)lock->l_len : ~0ULL - from;
    OVERLAPPED at = {.Offset = (DWORD)from, .OffsetHigh = (DWORD)(from >> 32)};
    const DWORD kind = (lock->l_type == F_WRLCK ? LOCKFILE_EXCLUSIVE_LOCK : 0) |
                       (command == F_SETLK ? LOCKFILE_FAIL_IMMEDIATELY : 0);
    const BOOL is_done = lock->l_type == F_UNLCK ? UnlockFileEx(file, 0, (DWORD)length, (DWORD)(length >> 32), &at)
                                                 : LockFileEx(file, kind, 0, (DWORD)length, (DWORD)(length >> 32), &at);
    if (!is_done)
        errno = GetLastError() == ERROR_IO_PENDING ? EACCES : lx_windows_error(GetLastError());
    return is_done ? 0 : -1;
}

int fcntl(int file, int command, ...)
{
    HANDLE handle = (HANDLE)_get_osfhandle(file);
    va_list arguments;
    va_start(arguments, command);
    struct flock *lock = command == F_GETFD ? NULL : va_arg(arguments, struct flock *);
    va_end(arguments);
    if (handle == INVALID_HANDLE_VALUE) {
        errno = EBADF;
        return -1;
    }
    if (command == F_GETLK)
        lock->l_type = F_UNLCK; /* Windows does not tell who has a lock */
    return command == F_SETLK || command == F_SETLKW ? lock_bytes(handle, command, lock) : 0;
}

int sched_getaffinity(int process, size_t size, cpu_set_t *set)
{
    DWORD_PTR all;
    (void)process;
    (void)size;
    return GetProcessAffinityMask(GetCurrentProcess(), &set->mask, &all) ? 0 : -1;
}
