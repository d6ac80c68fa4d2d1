/* SPDX-License-Identifier: MIT */
/* Files for the tests of file formats. */
#include "files.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int make_files(void **state)
{
    struct files *files = calloc(1, sizeof *files);

    strcpy(files->folder, "/tmp/luxel-files-XXXXXX");
    *state = files;
    return mkdtemp(files->folder) ? 0 : -1;
}

int remove_files(void **state)
{
    struct files *files = *state;
    DIR *folder = opendir(files->folder);
    const struct dirent *entry;

    while (folder && (entry = readdir(folder)))
        if (entry->d_name[0] != '.')
            unlinkat(dirfd(folder), entry->d_name, 0);
    if (folder)
        closedir(folder);
    int error = rmdir(files->folder); /* fails if a hidden file was left in it */
    free(files);
    return error;
}

void make_file(struct files *files, const char *name, const void *bytes, size_t length)
{
    snprintf(files->path, sizeof files->path, "%s/%s", files->folder, name);
    FILE *file = fopen(files->path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

unsigned char *file_bytes(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *length = (size_t)ftell(file);
    rewind(file);
    unsigned char *bytes = malloc(*length + 1);
    assert_int_equal(fread(bytes, 1, *length, file), *length);
    fclose(file);
    return bytes;
}

void write_and_read(struct files *files, const char *name, const struct lx_image *image, struct lx_loaded *loaded)
{
    snprintf(files->path, sizeof files->path, "%s/%s", files->folder, name);
    assert_int_equal(lx_write_image(files->path, image, NULL), LUXEL_OK);
    *loaded = (struct lx_loaded){0};
    assert_int_equal(lx_read_image(files->path, NULL, loaded), LUXEL_OK);
}

void assert_refused(const struct files *files, luxel_status status, const char *id)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_loaded loaded = {0};

    assert_int_equal(lx_read_image(files->path, diagnostics, &loaded), status);
    lx_loaded_clear(&loaded);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
    luxel_diagnostics_free(diagnostics);
}
