/* SPDX-License-Identifier: MIT */
/*
 * Stands before the C library's calls for files and makes them fail as LUXEL_FAULT says, "CALL SKIP BYTES ERROR": the
 * call of this name fails with this error, after it went well so many times; write() fails for good once so many bytes
 * (-1: no matter) were written.  "trickle" makes reading and writing interrupted and slow: every second call ends with
 * EINTR, the others move one byte.  The standard streams are left alone.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/* These are found before the C library's only if they are to be seen. */
#pragma GCC visibility push(default)

static struct {
    char call[16];
    long skip, bytes;
    int error;
    bool trickles, waits;
} fault = {.bytes = -1};

__attribute__((constructor)) static void read_fault(void)
{
    const char *words = getenv("LUXEL_FAULT");

    if (words && strcmp(words, "trickle") == 0)
        fault.trickles = true;
    else if (words && sscanf(words, "%15s %ld %ld %d", fault.call, &fault.skip, &fault.bytes, &fault.error) != 4)
        abort();
}

static bool fails(const char *call)
{
    if (strcmp(call, fault.call) != 0 || fault.bytes >= 0 || fault.skip-- != 0)
        return false;
    errno = fault.error;
    return true;
}

/* How many bytes may be moved of so many; -1: none, by errno. */
static ssize_t allowed(int file, const char *call, size_t count)
{
    if (file <= STDERR_FILENO || count == 0)
        return (ssize_t)count;
    if (fault.trickles) {
        fault.waits = !fault.waits;
        errno = EINTR;
        return fault.waits ? -1 : 1;
    }
    if (fault.bytes < 0 || strcmp(call, fault.call) != 0)
        return fails(call) ? -1 : (ssize_t)count;
    errno = fault.error;
    size_t left = (size_t)fault.bytes < count ? (size_t)fault.bytes : count;
    fault.bytes -= (long)left;
    return left > 0 ? (ssize_t)left : -1;
}

ssize_t read(int file, void *bytes, size_t count)
{
    ssize_t most = allowed(file, "read", count);

    return most < 0 ? -1 : syscall(SYS_read, file, bytes, most);
}

ssize_t pread64(int file, void *bytes, size_t count, off64_t offset)
{
    ssize_t most = allowed(file, "pread", count);

    return most < 0 ? -1 : syscall(SYS_pread64, file, bytes, most, offset);
}

ssize_t write(int file, const void *bytes, size_t count)
{
    ssize_t most = allowed(file, "write", count);

    return most < 0 ? -1 : syscall(SYS_write, file, bytes, most);
}

int fsync(int file)
{
    return fails("fsync") ? -1 : (int)syscall(SYS_fsync, file);
}

int close(int file)
{
    bool failed = fails("close");
    int result = (int)syscall(SYS_close, file);

    if (failed)
        errno = fault.error;
    return failed ? -1 : result;
}

int fchmod(int file, mode_t mode)
{
    return fails("fchmod") ? -1 : (int)syscall(SYS_fchmod, file, mode);
}

int flock(int file, int operation)
{
    return fails("flock") ? -1 : (int)syscall(SYS_flock, file, operation);
}

int linkat(int from_folder, const char *from, int to_folder, const char *to, int flags)
{
    return fails("linkat") ? -1 : (int)syscall(SYS_linkat, from_folder, from, to_folder, to, flags);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to)
{
    return fails("renameat") ? -1 : (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, 0);
}

int openat64(int folder, const char *path, int flags, ...)
{
    mode_t mode = 0;

    if (flags & (O_CREAT | __O_TMPFILE)) {
        va_list arguments;

        va_start(arguments, flags);
        mode = va_arg(arguments, mode_t);
        va_end(arguments);
    }
    return fails("openat") ? -1 : (int)syscall(SYS_openat, folder, path, flags, mode);
}

int open64(const char *path, int flags, ...)
{
    mode_t mode = 0;

    if (flags & (O_CREAT | __O_TMPFILE)) {
        va_list arguments;

        va_start(arguments, flags);
        mode = va_arg(arguments, mode_t);
        va_end(arguments);
    }
    return fails("open") ? -1 : (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}
