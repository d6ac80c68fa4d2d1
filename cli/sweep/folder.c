/* SPDX-License-Identifier: MIT */
/* Locks, staging and publishing in the folder of a sweep. */
#include "folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../message.h"

/* Bytes of .lock: parts have theirs behind the first, manifests one beyond all of them. */
static const off_t FIRST_PART = 1, MANIFEST = (off_t)1 << 40;

static const char lock_name[] = ".lock", work_beginning[] = ".work-";

char *folder_shard_name(uint64_t shard, char name[FOLDER_NAME])
{
    snprintf(name, FOLDER_NAME, "shard-%06llu", (unsigned long long)shard);
    return name;
}

/* ---- locks ---- */

static int lock_byte(int file, int command, short type, off_t byte, pid_t *holder)
{
    struct flock lock = {.l_type = type, .l_whence = SEEK_SET, .l_start = byte, .l_len = 1};
    int failed;

    while ((failed = fcntl(file, command, &lock)) != 0 && errno == EINTR)
        ;
    if (failed != 0 && holder && fcntl(file, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK)
        *holder = lock.l_pid;
    return failed;
}

static off_t byte_of_part(const struct folder *folder)
{
    return FIRST_PART + ((off_t)folder->parts << 16) + folder->part;
}

static int refuse_second(const struct folder *folder, pid_t holder)
{
    char process[64] = ""; /* some systems do not tell it */

    if (holder > 0)
        snprintf(process, sizeof process, _(" (process %ld)"), (long)holder);
    if (folder->parts > 1)
        message_error(_("%s: another luxel sweep works in this folder, or does part %u of %u%s"), folder->path,
                      folder->part, folder->parts, process);
    else
        message_error(_("%s: another luxel sweep works in this folder%s"), folder->path, process);
    message_hint(_("wait until it has ended; several processes share the work by --shard 0/N to --shard N-1/N"));
    return EXIT_FILE;
}

static int refuse_file(const struct folder *folder, int reason)
{
    message_error(_("%s cannot be written: %s"), folder->path, language_reason(reason));
    return EXIT_FILE;
}

/* Whether the open lock file still is the one that has the name. */
static bool is_named(const struct folder *folder)
{
    struct stat open_one, named;

    return fstat(folder->lock, &open_one) == 0 && fstatat(folder->folder, lock_name, &named, 0) == 0 &&
           open_one.st_ino == named.st_ino && open_one.st_dev == named.st_dev;
}

static int take_locks(struct folder *folder)
{
    const short whole = folder->parts > 1 ? F_RDLCK : F_WRLCK;
    pid_t holder = 0;

    do {
        if (folder->lock >= 0)
            close(folder->lock);
        folder->lock = openat(folder->folder, lock_name, O_CREAT | O_RDWR | O_CLOEXEC, 0666);
        if (folder->lock < 0)
            return refuse_file(folder, errno);
        if (lock_byte(folder->lock, F_SETLK, whole, 0, &holder) != 0 ||
            lock_byte(folder->lock, F_SETLK, F_WRLCK, byte_of_part(folder), &holder) != 0) {
            if (errno == EACCES || errno == EAGAIN)
                return refuse_second(folder, holder);
            return refuse_file(folder, errno);
        }
    } while (!is_named(folder));
    return EXIT_DONE;
}

void folder_lock_manifest(struct folder *folder, bool wanted)
{
    lock_byte(folder->lock, F_SETLKW, wanted ? F_WRLCK : F_UNLCK, MANIFEST, NULL);
}

/* ---- folders ---- */

/* Removes what is below an open folder, which stays; `beginning`: only what has a name that begins so. */
static void clear_beginning(int folder, const char *beginning)
{
    const int again = openat(folder, ".", O_DIRECTORY | O_RDONLY | O_CLOEXEC);
    DIR *entries = again >= 0 ? fdopendir(again) : NULL;
    struct dirent *entry;

    if (!entries) {
        if (again >= 0)
            close(again);
        return;
    }
    while ((entry = readdir(entries)) != NULL) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0 ||
            strncmp(entry->d_name, beginning, strlen(beginning)) != 0)
            continue;
        if (unlinkat(folder, entry->d_name, 0) != 0) {
            const int below = openat(folder, entry->d_name, O_DIRECTORY | O_RDONLY | O_NOFOLLOW | O_CLOEXEC);

            if (below >= 0) {
                clear_beginning(below, "");
                close(below);
            }
            unlinkat(folder, entry->d_name, AT_REMOVEDIR);
        }
    }
    closedir(entries);
}

static void clear_folder(int folder)
{
    clear_beginning(folder, "");
}

static int open_folder(int above, const char *name)
{
    if (mkdirat(above, name, 0777) != 0 && errno != EEXIST)
        return -1;
    return openat(above, name, O_DIRECTORY | O_RDONLY | O_CLOEXEC);
}

int folder_open(struct folder *folder, const char *path, unsigned part, unsigned parts)
{
    int code;

    *folder = (struct folder){.path = path, .folder = -1, .lock = -1, .work = -1, .part = part, .parts = parts};
    folder->folder = open_folder(AT_FDCWD, path);
    if (folder->folder < 0) {
        message_error(_("%s cannot be created: %s"), path, language_reason(errno));
        return EXIT_FILE;
    }
    code = take_locks(folder);
    if (code != EXIT_DONE)
        return code;
    if (parts == 1) /* nobody else is here: what there is was left by the dead */
        clear_beginning(folder->folder, work_beginning);
    snprintf(folder->work_name, sizeof folder->work_name, ".work-%u-%u", part, parts);
    folder->work = open_folder(folder->folder, folder->work_name);
    if (folder->work < 0)
        return refuse_file(folder, errno);
    clear_folder(folder->work);
    return EXIT_DONE;
}

/* The lock file goes with the last who uses it. */
void folder_close(struct folder *folder)
{
    struct flock all = {.l_type = F_WRLCK, .l_whence = SEEK_SET};

    if (folder->work >= 0) {
        clear_folder(folder->work);
        close(folder->work);
        unlinkat(folder->folder, folder->work_name, AT_REMOVEDIR);
    }
    if (folder->lock >= 0) {
        lock_byte(folder->lock, F_SETLK, F_UNLCK, 0, NULL); /* its own may not be in the way of all */
        lock_byte(folder->lock, F_SETLK, F_UNLCK, byte_of_part(folder), NULL);
        if (folder->work >= 0 && fcntl(folder->lock, F_SETLK, &all) == 0) {
            clear_beginning(folder->folder, work_beginning);
            unlinkat(folder->folder, lock_name, 0);
        }
        close(folder->lock);
    }
    if (folder->folder >= 0)
        close(folder->folder);
    folder->folder = folder->lock = folder->work = -1;
}

/* ---- shards ---- */

int folder_stage(struct folder *folder, uint64_t shard)
{
    char name[FOLDER_NAME];
    const int staged = open_folder(folder->work, folder_shard_name(shard, name));

    if (staged >= 0)
        clear_folder(staged);
    return staged;
}

void folder_drop(struct folder *folder, uint64_t shard)
{
    char name[FOLDER_NAME];
    const int staged = openat(folder->work, folder_shard_name(shard, name), O_DIRECTORY | O_RDONLY | O_CLOEXEC);

    if (staged < 0)
        return;
    clear_folder(staged);
    close(staged);
    unlinkat(folder->work, name, AT_REMOVEDIR);
}

int folder_publish(struct folder *folder, uint64_t shard, int staged)
{
    char name[FOLDER_NAME];

    folder_shard_name(shard, name);
    if (fsync(staged) != 0)
        return errno;
    if (renameat(folder->work, name, folder->folder, name) != 0) {
        const int reason = errno;

        folder_drop(folder, shard);
        return reason == EEXIST || reason == ENOTEMPTY ? 0 : reason;
    }
    return fsync(folder->folder) == 0 ? 0 : errno;
}

void folder_retract(struct folder *folder, uint64_t shard)
{
    char name[FOLDER_NAME];

    folder_drop(folder, shard);
    if (renameat(folder->folder, folder_shard_name(shard, name), folder->work, name) == 0)
        folder_drop(folder, shard);
}

/* ---- files ---- */

int folder_write(struct folder *folder, const char *name, const char *text, size_t length)
{
    const int file = openat(folder->work, name, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
    int failed = file < 0 ? errno : 0;

    while (failed == 0 && length > 0) {
        const ssize_t written = write(file, text, length);

        if (written < 0 && errno != EINTR)
            failed = errno;
        text += written > 0 ? written : 0;
        length -= written > 0 ? (size_t)written : 0;
    }
    if (failed == 0 && fsync(file) != 0)
        failed = errno;
    if (file >= 0 && close(file) != 0 && failed == 0)
        failed = errno;
    if (failed == 0 && renameat(folder->work, name, folder->folder, name) != 0)
        failed = errno;
    if (failed == 0 && fsync(folder->folder) != 0)
        failed = errno;
    return failed;
}

char *folder_read(const struct folder *folder, const char *name, size_t *length)
{
    const int file = openat(folder->folder, name, O_RDONLY | O_CLOEXEC);
    struct stat about;
    char *text = NULL;

    if (file >= 0 && fstat(file, &about) == 0 && S_ISREG(about.st_mode)) {
        text = malloc((size_t)about.st_size + 1);
        *length = 0;
        while (text && *length < (size_t)about.st_size) {
            const ssize_t got = read(file, text + *length, (size_t)about.st_size - *length);

            if (got < 0 && errno == EINTR)
                continue;
            if (got <= 0)
                break;
            *length += (size_t)got;
        }
        if (text)
            text[*length] = '\0';
    }
    if (file >= 0)
        close(file);
    return text;
}

uint64_t folder_free_bytes(const struct folder *folder)
{
    struct statvfs about;

    return fstatvfs(folder->folder, &about) == 0 ? (uint64_t)about.f_bavail * about.f_frsize : UINT64_MAX;
}
