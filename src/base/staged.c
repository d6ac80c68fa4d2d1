/* SPDX-License-Identifier: MIT */
/*
 * Staged files: where the file really goes, and how it gets there in one step.
 *
 * The file is made without a name (O_TMPFILE), so that it vanishes with its process.  A link gives it its name.
 * But a link cannot replace an existing file; then it is linked under a hidden name first and renamed.  On file
 * systems without unnamed files it has the hidden name all the time.
 *
 * Hidden names are few and follow from the target's name, so that leftovers of killed processes can be found.
 * Whoever owns a hidden file holds a lock (flock) on it, from before the name exists until the name is gone, and
 * only the holder of that lock may remove or rename it.  So a hidden file that can be locked, and then still
 * has its name, was left by a dead process; and processes that write the same target never touch each other's.
 */
#include "staged.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum {
    LX_SLOTS = 8,       /* hidden names per target, so many processes at once */
    LX_ATTEMPTS = 1000, /* times to look for a free one, a millisecond apart */
    LX_LINKS = 40,      /* symbolic links to follow, like the kernel */
    LX_PROC_SIZE = 32
};

static const mode_t NEW_FILE = 0666; /* the umask takes its bits away */
static const mode_t PERMISSIONS = 0777;

static int open_unnamed(int folder, mode_t mode)
{
    return openat(folder, ".", O_TMPFILE | O_RDWR | O_CLOEXEC, mode);
}

static int rename_within(int folder, const char *from, const char *to)
{
    return renameat(folder, from, folder, to);
}

const struct lx_sink_system lx_sink_real_system = {open_unnamed, write, fsync, rename_within};

/* The name by which an open file without one can be linked. */
static void proc_name(int file, char name[LX_PROC_SIZE])
{
    snprintf(name, LX_PROC_SIZE, "/proc/self/fd/%d", file);
}

/* Whether the name in the folder still means this open file. */
static bool has_name(int folder, const char *name, int file)
{
    struct stat named, opened;

    return fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) == 0 && fstat(file, &opened) == 0 &&
           named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

/* Removes the hidden file of this name if its process is dead. */
static void sweep(int folder, const char *name)
{
    int file = openat(folder, name, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);

    if (file < 0) {
        return;
    }
    if (flock(file, LOCK_EX | LOCK_NB) == 0 && has_name(folder, name, file)) {
        unlinkat(folder, name, 0);
    }
    close(file);
}

static void sweep_all(int folder, const char *target)
{
    char name[LX_HIDDEN_SIZE];

    for (unsigned slot = 0; slot < LX_SLOTS; slot++) {
        lx_staged_hidden_name(target, slot, name);
        sweep(folder, name);
    }
}

/* Makes a file of this hidden name, with its lock.  EEXIST: another process has it. */
static int create_hidden(struct lx_staged *staged, const char *name)
{
    int file = openat(staged->folder, name, O_CREAT | O_EXCL | O_RDWR | O_NOFOLLOW | O_CLOEXEC, NEW_FILE);

    if (file < 0) {
        return errno;
    }
    /* Before we had the lock, another process may have taken the new file for a leftover. */
    if ((flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) || !has_name(staged->folder, name, file)) {
        close(file);
        return EEXIST;
    }
    staged->file = file;
    return 0;
}

/* Gives the unnamed file, which is locked already, a name. */
static int link_unnamed(const struct lx_staged *staged, const char *name)
{
    char unnamed[LX_PROC_SIZE];

    proc_name(staged->file, unnamed);
    return linkat(AT_FDCWD, unnamed, staged->folder, name, AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

/* Makes the file under a free hidden name, or gives that name to the one there is. */
static int take_hidden_name(struct lx_staged *staged)
{
    static const struct timespec pause = {.tv_nsec = 1000000};
    char name[LX_HIDDEN_SIZE];

    for (unsigned attempt = 0; attempt < LX_ATTEMPTS; attempt++) {
        for (unsigned slot = 0; slot < LX_SLOTS; slot++) {
            lx_staged_hidden_name(staged->target, slot, name);
            sweep(staged->folder, name);
            int error = staged->file < 0 ? create_hidden(staged, name) : link_unnamed(staged, name);
            if (error == 0) {
                memcpy(staged->hidden, name, sizeof name);
            }
            if (error != EEXIST) {
                return error;
            }
        }
        nanosleep(&pause, NULL);
    }
    return EBUSY;
}

/* Opens the file to write to: unnamed if that is possible and can be named later, else hidden. */
static int create(struct lx_staged *staged)
{
    char name[LX_PROC_SIZE];
    struct stat status;

    sweep_all(staged->folder, staged->target);
    staged->file = staged->system->open_unnamed(staged->folder, NEW_FILE);
    if (staged->file < 0) {
        return take_hidden_name(staged);
    }
    proc_name(staged->file, name);
    if (lstat(name, &status) != 0) { /* no /proc: it could never get a name */
        close(staged->file);
        staged->file = -1;
        return take_hidden_name(staged);
    }
    flock(staged->file, LOCK_EX | LOCK_NB); /* where there are no locks, nothing is swept either */
    return 0;
}

/* Takes over what a new file should inherit from the one that it replaces, if there is one. */
static int inherit(const struct lx_staged *staged)
{
    struct stat old, new;

    if (fstatat(staged->folder, staged->target, &old, AT_SYMLINK_NOFOLLOW) != 0) {
        return errno == ENOENT ? 0 : errno;
    }
    /* Renaming would replace a file that its owner protected. */
    if (faccessat(staged->folder, staged->target, W_OK, AT_EACCESS) != 0 || fstat(staged->file, &new) != 0) {
        return errno;
    }
    if (old.st_uid != new.st_uid || old.st_gid != new.st_gid) {
        if (fchown(staged->file, old.st_uid, old.st_gid) != 0 && fchown(staged->file, (uid_t)-1, old.st_gid) != 0) {
            /* Not ours to give away: the group's rights were meant for another group. */
            old.st_mode &= ~(mode_t)S_IRWXG;
        }
    }
    return fchmod(staged->file, old.st_mode & PERMISSIONS) == 0 ? 0 : errno;
}

/*
 * Follows the symbolic links at the end of the path; *place is the caller's.  Links of the process' own open
 * files are left alone: their text is no path.
 */
static int follow(const char *path, char **place)
{
    char link[PATH_MAX];

    *place = strdup(path);
    for (unsigned count = 0; *place != NULL && count < LX_LINKS; count++) {
        ssize_t length = readlink(*place, link, sizeof link);
        bool in_proc = strncmp(*place, "/proc/", 6) == 0 || strncmp(*place, "/dev/fd/", 8) == 0;

        if (length < 0 || in_proc) {
            return 0; /* no link, or nothing there yet */
        }
        if ((size_t)length == sizeof link) {
            return ENAMETOOLONG;
        }
        const char *slash = strrchr(*place, '/');
        size_t kept = link[0] == '/' || slash == NULL ? 0 : (size_t)(slash - *place) + 1;
        char *next = malloc(kept + (size_t)length + 1);
        if (next != NULL) {
            memcpy(next, *place, kept);
            memcpy(next + kept, link, (size_t)length);
            next[kept + (size_t)length] = '\0';
        }
        free(*place);
        *place = next;
    }
    return *place == NULL ? ENOMEM : ELOOP;
}

/* Opens the folder of a place and keeps the name in it. */
static int open_folder(struct lx_staged *staged, char *place)
{
    char *slash = strrchr(place, '/');
    const char *name = slash != NULL ? slash + 1 : place;

    if (name[0] == '\0') {
        return place[0] == '\0' ? ENOENT : EISDIR;
    }
    staged->target = strdup(name);
    if (staged->target == NULL) {
        return ENOMEM;
    }
    if (slash != NULL) {
        slash[slash == place] = '\0'; /* "/name" stands in "/" */
    }
    const char *folder = slash != NULL ? place : ".";
    staged->folder = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (staged->folder < 0 && errno == EACCES) { /* a folder to write in but not to list */
        staged->folder = open(folder, O_PATH | O_DIRECTORY | O_CLOEXEC);
    }
    return staged->folder >= 0 ? 0 : errno;
}

/* Opens something that cannot be replaced.  No retry after EINTR: a pipe that nobody reads must not trap us. */
static int open_direct(struct lx_staged *staged, const char *place)
{
    staged->direct = true;
    staged->file = open(place, O_WRONLY | O_NOCTTY | O_CLOEXEC);
    return staged->file >= 0 ? 0 : errno;
}

int lx_staged_open(struct lx_staged *staged, const char *path, const struct lx_sink_system *system)
{
    struct stat status;
    char *place = NULL;
    int error;

    *staged = (struct lx_staged){.system = system, .file = -1, .folder = -1};
    if (lx_staged_is_standard_output(path)) { /* as it is open: what it appends to stays, and it may be a socket */
        staged->direct = true;
        staged->file = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
        return staged->file >= 0 ? 0 : errno;
    }
    if (stat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode)) {
            return EISDIR;
        }
        if (!S_ISREG(status.st_mode)) {
            return open_direct(staged, path);
        }
    } else if (errno != ENOENT) {
        return errno;
    }
    error = follow(path, &place);
    if (error == 0 && (strncmp(place, "/proc/", 6) == 0 || strncmp(place, "/dev/fd/", 8) == 0)) {
        error = open_direct(staged, place);
    } else if (error == 0) {
        error = open_folder(staged, place);
        if (error == 0) {
            error = create(staged);
        }
        if (error == 0) {
            error = inherit(staged);
        }
    }
    free(place);
    return error;
}

static int publish(struct lx_staged *staged)
{
    if (staged->hidden[0] == '\0') {
        int error = link_unnamed(staged, staged->target);

        if (error == EEXIST) {
            error = take_hidden_name(staged);
        } else if (error == 0) {
            return 0;
        }
        if (error != 0) {
            return error;
        }
    }
    if (staged->system->rename(staged->folder, staged->hidden, staged->target) != 0) {
        return errno;
    }
    staged->hidden[0] = '\0';
    return 0;
}

/* Signals wait until it is done: one that ends the process between two names would leave the hidden one. */
int lx_staged_publish(struct lx_staged *staged)
{
    sigset_t all, before;

    if (staged->direct) {
        return 0;
    }
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    int error = publish(staged);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (error == 0) {
        fsync(staged->folder); /* the file is whole and in place, whatever this says */
    }
    return error;
}

void lx_staged_close(struct lx_staged *staged)
{
    if (staged->hidden[0] != '\0') {
        unlinkat(staged->folder, staged->hidden, 0);
    }
    if (staged->file >= 0) {
        close(staged->file);
    }
    if (staged->folder >= 0) {
        close(staged->folder);
    }
    free(staged->target);
}
