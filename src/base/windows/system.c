/* SPDX-License-Identifier: MIT */
/* Functions of POSIX that Windows lacks, as the headers of include/ declare them: memory, texts, streams, files. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <limits.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <windows.h>

#include "../path.h"

enum { ALIGNMENT = 64 };

void *lx_windows_malloc(size_t bytes)
{
    return _aligned_malloc(bytes ? bytes : 1, ALIGNMENT);
}

void *lx_windows_calloc(size_t count, size_t bytes)
{
    size_t all;
    if (__builtin_mul_overflow(count, bytes, &all))
        return NULL;
    void *memory = lx_windows_malloc(all);
    return memory ? memset(memory, 0, all) : NULL;
}

void *lx_windows_realloc(void *memory, size_t bytes)
{
    return _aligned_realloc(memory, bytes ? bytes : 1, ALIGNMENT);
}

void lx_windows_free(void *memory)
{
    const int before = errno;
    _aligned_free(memory);
    errno = before;
}

void *lx_windows_aligned_alloc(size_t alignment, size_t bytes)
{
    (void)alignment;
    return lx_windows_malloc(bytes);
}

char *lx_windows_strndup(const char *text, size_t most)
{
    const size_t length = strnlen(text, most);
    char *copy = malloc(length + 1);
    if (copy) {
        memcpy(copy, text, length);
        copy[length] = '\0';
    }
    return copy;
}

char *lx_windows_strdup(const char *text)
{
    return lx_windows_strndup(text, strlen(text));
}

char *stpcpy(char *restrict to, const char *restrict from)
{
    const size_t length = strlen(from);
    memcpy(to, from, length + 1);
    return to + length;
}

char *strsep(char **rest, const char *separators)
{
    char *part = *rest;
    if (part) {
        char *end = part + strcspn(part, separators);
        *rest = *end != '\0' ? end + 1 : NULL;
        *end = '\0';
    }
    return part;
}

void *memrchr(const void *bytes, int wanted, size_t length)
{
    const unsigned char *start = bytes;
    while (length > 0)
        if (start[--length] == (unsigned char)wanted)
            return (void *)(uintptr_t)(start + length);
    return NULL;
}

const char *strerrordesc_np(int number)
{
    return number == ENOSPC ? "No space left on device" : strerror(number);
}

const char *lx_windows_basename(const char *path)
{
    return lx_path_name(path);
}

int lx_windows_vasprintf(char **text, const char *format, va_list arguments)
{
    va_list again;
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, again);
    va_end(again);
    *text = length >= 0 ? malloc((size_t)length + 1) : NULL;
    return *text ? vsnprintf(*text, (size_t)length + 1, format, arguments) : -1;
}

int lx_windows_asprintf(char **text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int length = lx_windows_vasprintf(text, format, arguments);
    va_end(arguments);
    return length;
}

/* A stream into memory is a file that the system keeps in memory while it has room, and that vanishes when closed. */
struct memory_stream {
    struct memory_stream *next;
    FILE *stream;
    char **bytes;
    size_t *size;
};

static struct memory_stream *memory_streams;
static pthread_mutex_t memory_streams_mutex = PTHREAD_MUTEX_INITIALIZER;

static FILE *open_vanishing(void)
{
    wchar_t folder[MAX_PATH + 1], name[MAX_PATH + 1];
    if (GetTempPathW(MAX_PATH, folder) == 0 || GetTempFileNameW(folder, L"lux", 0, name) == 0)
        return NULL;
    HANDLE handle = CreateFileW(name, GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_DELETE, NULL, CREATE_ALWAYS,
                                FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
    const int file = handle != INVALID_HANDLE_VALUE ? _open_osfhandle((intptr_t)handle, _O_RDWR | _O_BINARY) : -1;
    FILE *stream = file >= 0 ? _fdopen(file, "w+b") : NULL;
    if (!stream && file >= 0)
        close(file);
    else if (!stream && handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
    return stream;
}

FILE *open_memstream(char **bytes, size_t *size)
{
    struct memory_stream *made = malloc(sizeof *made);
    FILE *stream = made ? open_vanishing() : NULL;
    if (!stream) {
        free(made);
        return NULL;
    }
    *bytes = NULL;
    *size = 0;
    pthread_mutex_lock(&memory_streams_mutex);
    *made = (struct memory_stream){memory_streams, stream, bytes, size};
    memory_streams = made;
    pthread_mutex_unlock(&memory_streams_mutex);
    return stream;
}

static struct memory_stream *take_memory_stream(const FILE *stream)
{
    pthread_mutex_lock(&memory_streams_mutex);
    struct memory_stream **at = &memory_streams;
    while (*at && (*at)->stream != stream)
        at = &(*at)->next;
    struct memory_stream *found = *at;
    if (found)
        *at = found->next;
    pthread_mutex_unlock(&memory_streams_mutex);
    return found;
}

/* Whether all that was written could be taken into memory. */
static bool read_all(const struct memory_stream *memory)
{
    if (fflush(memory->stream) != 0 || ferror(memory->stream) || fseeko(memory->stream, 0, SEEK_END) != 0)
        return false;
    const long long length = ftello(memory->stream);
    char *bytes = length >= 0 ? malloc((size_t)length + 1) : NULL;
    if (!bytes)
        return false;
    rewind(memory->stream);
    if (fread(bytes, 1, (size_t)length, memory->stream) != (size_t)length) {
        free(bytes);
        return false;
    }
    bytes[length] = '\0';
    *memory->bytes = bytes;
    *memory->size = (size_t)length;
    return true;
}

#undef fclose
int lx_windows_fclose(FILE *stream)
{
    struct memory_stream *memory = take_memory_stream(stream);
    const bool is_whole = !memory || read_all(memory);
    free(memory);
    const int status = fclose(stream);
    return is_whole ? status : EOF;
}

int fallocate(int file, int mode, long long from, long long bytes)
{
    FILE_ALLOCATION_INFO wanted = {.AllocationSize.QuadPart = from + bytes};
    (void)mode;
    if (SetFileInformationByHandle((HANDLE)_get_osfhandle(file), FileAllocationInfo, &wanted, sizeof wanted))
        return 0;
    errno = GetLastError() == ERROR_DISK_FULL ? ENOSPC : EOPNOTSUPP;
    return -1;
}

ssize_t pread(int file, void *bytes, size_t count, long long place)
{
    OVERLAPPED at = {.Offset = (DWORD)place, .OffsetHigh = (DWORD)(place >> 32)};
    DWORD got = 0;
    if (ReadFile((HANDLE)_get_osfhandle(file), bytes, count < INT_MAX ? (DWORD)count : INT_MAX, &got, &at))
        return (ssize_t)got;
    if (GetLastError() == ERROR_HANDLE_EOF)
        return 0;
    errno = EIO;
    return -1;
}

int sigaction(int signal_number, const struct sigaction *action, struct sigaction *before)
{
    (void)before;
    return signal(signal_number, action->sa_handler) == SIG_ERR ? -1 : 0;
}

/* A pipe without a reader does not even take nothing, or the C library has just called it an invalid argument. */
int poll(struct pollfd *files, unsigned count, int timeout_ms)
{
    const bool is_told = errno == EINVAL || errno == EPIPE;
    HANDLE handle = (HANDLE)_get_osfhandle(files->fd);
    DWORD written;
    (void)count;
    (void)timeout_ms;
    files->revents = 0;
    if (GetFileType(handle) == FILE_TYPE_PIPE && (is_told || !WriteFile(handle, "", 0, &written, NULL)))
        files->revents = POLLERR;
    return files->revents != 0;
}

int getrlimit(int resource, struct rlimit *limit)
{
    MEMORYSTATUSEX memory = {.dwLength = sizeof memory};
    if (resource != RLIMIT_AS || !GlobalMemoryStatusEx(&memory))
        return -1;
    limit->rlim_cur = memory.ullAvailPhys / 5 * 4;
    return 0;
}

long sysconf(int name)
{
    SYSTEM_INFO system;
    GetSystemInfo(&system);
    return name == _SC_NPROCESSORS_ONLN ? (long)system.dwNumberOfProcessors : (long)system.dwPageSize;
}
