/* SPDX-License-Identifier: MIT */
/* Reading drawn files. */
#include "take_file.h"

#include <stdio.h>
#include <stdlib.h>

char *take_file(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    char *bytes = NULL;
    if (!file)
        return NULL;
    fseek(file, 0, SEEK_END);
    *length = (size_t)ftell(file);
    rewind(file);
    bytes = malloc(*length);
    if (bytes && fread(bytes, 1, *length, file) != *length) {
        free(bytes);
        bytes = NULL;
    }
    fclose(file);
    remove(path);
    return bytes;
}
