/* SPDX-License-Identifier: MIT */
/* What the tests of the sink share. */
#include "place.h"

#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

int make_place(void **state)
{
    struct place *place = malloc(sizeof *place);

    strcpy(place->folder, "/tmp/luxel-sink-XXXXXX");
    if (mkdtemp(place->folder) == NULL) {
        free(place);
        return -1;
    }
    snprintf(place->file, sizeof place->file, "%s/picture.png", place->folder);
    *state = place;
    return 0;
}

int remove_place(void **state)
{
    struct place *place = *state;
    char path[PATH_MAX];
    DIR *folder = opendir(place->folder);

    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        snprintf(path, sizeof path, "%s/%s", place->folder, entry->d_name);
        unlink(path);
    }
    closedir(folder);
    rmdir(place->folder);
    free(place);
    return 0;
}

int entries(const struct place *place)
{
    DIR *folder = opendir(place->folder);
    int count = -2; /* "." and ".." */

    while (readdir(folder) != NULL) {
        count++;
    }
    closedir(folder);
    return count;
}

void put(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");

    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

void assert_content(const char *path, const char *text)
{
    char found[256] = "";
    FILE *file = fopen(path, "r");

    assert_non_null(file);
    found[fread(found, 1, sizeof found - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(found, text);
}

luxel_status sink_text(const char *path, const struct lx_sink_system *system, const char *text,
                       luxel_diagnostics *diagnostics)
{
    struct lx_sink *sink;
    luxel_status status = lx_sink_open(path, system, diagnostics, &sink);

    if (status != LUXEL_OK) {
        return status;
    }
    lx_sink_write(sink, text, strlen(text));
    return lx_sink_commit(sink);
}

static int no_unnamed(int folder, mode_t mode)
{
    (void)folder;
    (void)mode;
    errno = EOPNOTSUPP;
    return -1;
}

struct lx_sink_system make_system(bool unnamed)
{
    struct lx_sink_system system = lx_sink_real_system;

    if (!unnamed) {
        system.open_unnamed = no_unnamed;
    }
    return system;
}

int in_child(void (*part)(const struct place *), const struct place *place)
{
    int status;
    pid_t child = fork();

    if (child == 0) {
        part(place);
        _exit(0);
    }
    assert_true(child > 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}
