/* SPDX-License-Identifier: MIT */
/*
 * Handing over to another program: the one beside this program, as it stands where it was built, or the one that was
 * installed with it, wherever that was moved.
 */
#include "elsewhere.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The program at a place relative to this one's folder, if this one's place is known. */
static void try_relative(const char *place, const char *name, char *const *arguments)
{
    char path[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);

    while (length > 0 && path[length - 1] != '/')
        length--;
    if (length > 0 && (size_t)length + strlen(place) + strlen(name) < sizeof path) {
        strcpy(stpcpy(path + length, place), name);
        execv(path, arguments);
    }
}

int elsewhere_run(const char *name, char *const *arguments)
{
    char path[PATH_MAX];

    try_relative("", name, arguments);
    try_relative("../libexec/luxel/", name, arguments);
    snprintf(path, sizeof path, "%s/%s", LUXEL_LIBEXECDIR, name);
    execv(path, arguments);
    return errno;
}
