/* SPDX-License-Identifier: MIT */
/*
 * Functions of POSIX for files and folders by their paths, as the headers of include/ declare them.  Windows takes
 * paths beyond 260 characters only whole and behind a prefix, which its C library does not know.
 */
#include "files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* From which length on a path has the prefix; names of folders leave room for one of 8.3. */
enum { LONG_PATH = 240 };

static const wchar_t prefix[] = L"\\\\?\\", share_prefix[] = L"\\\\?\\UNC\\";

int lx_windows_error(DWORD error)
{
    switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_NETPATH: return ENOENT;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: return EEXIST;
    case ERROR_DIR_NOT_EMPTY: return ENOTEMPTY;
    case ERROR_DIRECTORY: return ENOTDIR;
    case ERROR_NOT_SAME_DEVICE: return EXDEV;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL: return ENOSPC;
    case ERROR_NOT_ENOUGH_MEMORY: return ENOMEM;
    case ERROR_WRITE_PROTECT: return EROFS;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    case ERROR_ACCESS_DENIED:
    case ERROR_LOCK_VIOLATION:
    case ERROR_SHARING_VIOLATION: return EACCES;
    default: return EIO;
    }
}

/* 0, or -1 with errno, of what a function of Windows returned. */
static int told(bool is_done)
{
    if (!is_done)
        errno = lx_windows_error(GetLastError());
    return is_done ? 0 : -1;
}

wchar_t *lx_windows_wide(const char *path)
{
    wchar_t *wide = malloc(LX_LONGEST_PATH * sizeof *wide);
    if (!wide)
        return NULL;
    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, LX_LONGEST_PATH) == 0) {
        errno = GetLastError() == ERROR_INSUFFICIENT_BUFFER ? ENAMETOOLONG : ENOENT;
        free(wide);
        return NULL;
    }
    const DWORD length = GetFullPathNameW(wide, 0, NULL, NULL);
    if (length < LONG_PATH || wcsncmp(wide, prefix, 4) == 0)
        return wide;
    /* A share, \\server\name, has \\?\UNC\ before it in place of its two backslashes. */
    wchar_t *whole = malloc((length + 8) * sizeof *whole), *full = malloc(length * sizeof *full);
    if (whole && full && GetFullPathNameW(wide, length, full, NULL) > 0) {
        const bool is_share = full[0] == L'\\' && full[1] == L'\\';
        wcscpy(whole, is_share ? share_prefix : prefix);
        wcscat(whole, full + (is_share ? 2 : 0));
    } else {
        free(whole);
        whole = NULL;
        errno = ENOMEM;
    }
    free(full);
    free(wide);
    return whole;
}

/* ---- opening ---- */

static DWORD disposition_of(int flags)
{
    if (flags & O_CREAT)
        return flags & O_EXCL ? CREATE_NEW : flags & O_TRUNC ? CREATE_ALWAYS : OPEN_ALWAYS;
    return flags & O_TRUNC ? TRUNCATE_EXISTING : OPEN_EXISTING;
}

static HANDLE open_handle(const wchar_t *path, DWORD access, DWORD disposition, DWORD flags)
{
    return CreateFileW(path, access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL, disposition, flags,
                       NULL);
}

int lx_windows_open_wide(wchar_t *path, int flags)
{
    const bool is_folder = (flags & O_DIRECTORY) != 0, writes = (flags & (O_WRONLY | O_RDWR)) != 0;
    const DWORD access = (flags & O_WRONLY ? 0 : GENERIC_READ) | (writes ? GENERIC_WRITE : 0);
    HANDLE handle = INVALID_HANDLE_VALUE;
    if (path && is_folder)
        handle = open_handle(path, FILE_LIST_DIRECTORY | FILE_READ_ATTRIBUTES | SYNCHRONIZE, OPEN_EXISTING,
                             FILE_FLAG_BACKUP_SEMANTICS);
    else if (path)
        handle = open_handle(path, access, disposition_of(flags), FILE_ATTRIBUTE_NORMAL);
    if (path && handle == INVALID_HANDLE_VALUE) {
        errno = lx_windows_error(GetLastError());
        const DWORD kind = GetFileAttributesW(path);
        if (errno == EACCES && !is_folder && kind != INVALID_FILE_ATTRIBUTES && kind & FILE_ATTRIBUTE_DIRECTORY)
            errno = EISDIR;
    }
    free(path);
    if (handle == INVALID_HANDLE_VALUE)
        return -1;
    const int file = _open_osfhandle((intptr_t)handle, _O_BINARY | _O_NOINHERIT | (writes ? 0 : _O_RDONLY));
    if (file < 0)
        CloseHandle(handle);
    return file;
}

int lx_windows_open(const char *path, int flags, ...)
{
    return lx_windows_open_wide(lx_windows_wide(strcmp(path, "/dev/null") == 0 ? "NUL" : path), flags);
}

FILE *lx_windows_fopen(const char *path, const char *mode)
{
    wchar_t *wide = lx_windows_wide(path), wide_mode[8];
    mbstowcs(wide_mode, mode, sizeof wide_mode / sizeof wide_mode[0]);
    FILE *stream = wide ? _wfopen(wide, wide_mode) : NULL;
    free(wide);
    return stream;
}

ssize_t lx_windows_read(int file, void *bytes, size_t count)
{
    return _read(file, bytes, count < INT_MAX ? (unsigned)count : INT_MAX);
}

ssize_t lx_windows_write(int file, const void *bytes, size_t count)
{
    return _write(file, bytes, count < INT_MAX ? (unsigned)count : INT_MAX);
}

/* ---- what there is ---- */

static time_t seconds_of(FILETIME time)
{
    const uint64_t ticks = (uint64_t)time.dwHighDateTime << 32 | time.dwLowDateTime;
    return (time_t)((int64_t)(ticks / 10000000) - 11644473600LL); /* from 1601 on */
}

/* What Windows tells of an open file, where its C library leaves out which one it is. */
static int about_handle(HANDLE handle, struct stat *about)
{
    BY_HANDLE_FILE_INFORMATION found;
    *about = (struct stat){.st_mode = S_IFCHR};
    if (GetFileType(handle) != FILE_TYPE_DISK)
        return 0;
    if (!GetFileInformationByHandle(handle, &found))
        return told(false);
    about->st_mode = found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY ? S_IFDIR | 0777 : S_IFREG | 0666;
    about->st_size = (int64_t)((uint64_t)found.nFileSizeHigh << 32 | found.nFileSizeLow);
    about->st_mtime = seconds_of(found.ftLastWriteTime);
    about->st_dev = found.dwVolumeSerialNumber;
    about->st_ino = (unsigned short)(found.nFileIndexLow ^ found.nFileIndexHigh);
    return 0;
}

int lx_windows_stat_wide(wchar_t *path, struct stat *about)
{
    HANDLE handle = path ? open_handle(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS)
                         : INVALID_HANDLE_VALUE;
    int failed = handle == INVALID_HANDLE_VALUE ? path ? told(false) : -1 : about_handle(handle, about);
    if (handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
    free(path);
    return failed;
}

int lx_windows_stat(const char *path, struct stat *about)
{
    return lx_windows_stat_wide(lx_windows_wide(path), about);
}

int lx_windows_fstat(int file, struct stat *about)
{
    return about_handle((HANDLE)_get_osfhandle(file), about);
}

int lx_windows_access(const char *path, int mode)
{
    wchar_t *wide = lx_windows_wide(path);
    const int failed = wide ? _waccess(wide, mode & ~X_OK) : -1;
    free(wide);
    return failed;
}

char *realpath(const char *path, char *buffer)
{
    wchar_t *wide = lx_windows_wide(path), *found = malloc(LX_LONGEST_PATH * sizeof *found);
    char *text = malloc(PATH_MAX * 4);
    HANDLE handle =
        wide ? open_handle(wide, 0, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS) : INVALID_HANDLE_VALUE;
    DWORD length = found && handle != INVALID_HANDLE_VALUE
                       ? GetFinalPathNameByHandleW(handle, found, LX_LONGEST_PATH, 0)
                       : 0;
    if (length == 0 && found && handle != INVALID_HANDLE_VALUE) /* old ones know no long paths: links stay links */
        length = GetFullPathNameW(wide, LX_LONGEST_PATH, found, NULL);
    (void)buffer;
    bool is_found = length > 0 && length < LX_LONGEST_PATH && text;
    if (is_found) {
        const bool is_share = wcsncmp(found, share_prefix, 8) == 0; /* its text begins with two slashes again */
        const wchar_t *start = is_share ? found + 6 : wcsncmp(found, prefix, 4) == 0 ? found + 4 : found;
        is_found = WideCharToMultiByte(CP_UTF8, 0, start, -1, text, PATH_MAX * 4, NULL, NULL) > 0;
        for (char *at = text; is_found && *at; at++)
            *at = *at == '\\' ? '/' : *at;
        if (is_found && is_share)
            text[0] = '/';
    }
    if (handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
    free(wide);
    free(found);
    if (!is_found) {
        free(text);
        text = NULL;
        errno = ENOENT;
    }
    return text;
}

/* ---- changes ---- */

int lx_windows_mkdir(const char *path, int mode)
{
    wchar_t *wide = lx_windows_wide(path);
    (void)mode;
    const int failed = wide ? told(CreateDirectoryW(wide, NULL)) : -1;
    free(wide);
    return failed;
}

int lx_windows_unlink(const char *path)
{
    wchar_t *wide = lx_windows_wide(path);
    const int failed = wide ? told(DeleteFileW(wide)) : -1;
    free(wide);
    return failed;
}

int lx_windows_rename_wide(wchar_t *from, wchar_t *to)
{
    int failed = from && to ? told(MoveFileExW(from, to, MOVEFILE_REPLACE_EXISTING)) : -1;
    const DWORD there = failed && to && errno == EACCES ? GetFileAttributesW(to) : INVALID_FILE_ATTRIBUTES;
    if (there != INVALID_FILE_ATTRIBUTES && there & FILE_ATTRIBUTE_DIRECTORY)
        errno = EEXIST;
    free(from);
    free(to);
    return failed;
}

int lx_windows_rename(const char *from, const char *to)
{
    return lx_windows_rename_wide(lx_windows_wide(from), lx_windows_wide(to));
}

int fsync(int file)
{
    struct stat about;
    HANDLE handle = (HANDLE)_get_osfhandle(file);
    if (about_handle(handle, &about) == 0 && S_ISDIR(about.st_mode))
        return 0; /* folders are kept in a journal */
    return told(FlushFileBuffers(handle));
}

/* ---- what is in a folder ---- */

struct lx_windows_folder {
    HANDLE search;
    WIN32_FIND_DATAW found;
    bool is_first;
    struct dirent entry;
};

DIR *lx_windows_opendir_wide(wchar_t *path)
{
    DIR *folder = path ? calloc(1, sizeof *folder) : NULL;
    if (folder) {
        const size_t length = wcslen(path);
        wchar_t *all = realloc(path, (length + 3) * sizeof *all);
        path = all ? all : path;
        folder->search = INVALID_HANDLE_VALUE;
        if (all) {
            wcscpy(all + length, L"\\*");
            folder->search = FindFirstFileW(all, &folder->found);
        }
        folder->is_first = true;
        if (folder->search == INVALID_HANDLE_VALUE) {
            errno = all ? lx_windows_error(GetLastError()) : ENOMEM;
            free(folder);
            folder = NULL;
        }
    }
    free(path);
    return folder;
}

DIR *opendir(const char *path)
{
    return lx_windows_opendir_wide(lx_windows_wide(path));
}

struct dirent *readdir(DIR *folder)
{
    if (!folder->is_first && !FindNextFileW(folder->search, &folder->found))
        return NULL;
    folder->is_first = false;
    WideCharToMultiByte(CP_UTF8, 0, folder->found.cFileName, -1, folder->entry.d_name, sizeof folder->entry.d_name,
                        NULL, NULL);
    return &folder->entry;
}

int closedir(DIR *folder)
{
    FindClose(folder->search);
    free(folder);
    return 0;
}

static void free_entries(struct dirent **entries, size_t count)
{
    while (count > 0)
        free(entries[--count]);
    free(entries);
}

static bool add_entry(struct dirent ***entries, size_t count, const struct dirent *entry)
{
    struct dirent **more = realloc(*entries, (count + 1) * sizeof *more), *copy = malloc(sizeof *copy);
    if (more)
        *entries = more;
    if (!more || !copy) {
        free(copy);
        return false;
    }
    *copy = *entry;
    more[count] = copy;
    return true;
}

int scandir(const char *path, struct dirent ***entries, int (*is_wanted)(const struct dirent *),
            int (*compare)(const struct dirent **, const struct dirent **))
{
    DIR *folder = opendir(path);
    struct dirent **found = NULL;
    size_t count = 0;
    if (!folder)
        return -1;
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (!is_wanted(entry))
            continue;
        if (!add_entry(&found, count, entry)) {
            free_entries(found, count);
            closedir(folder);
            errno = ENOMEM;
            return -1;
        }
        count++;
    }
    closedir(folder);
    if (count > 0)
        qsort(found, count, sizeof *found, (int (*)(const void *, const void *))(void (*)(void))compare);
    *entries = found;
    return (int)count;
}
