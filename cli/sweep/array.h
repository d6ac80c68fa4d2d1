/* SPDX-License-Identifier: MIT */
/* Files of a shard while they are written: NPY arrays, converted and hashed as their numbers come, and plain texts. */
#ifndef LUXEL_CLI_SWEEP_ARRAY_H
#define LUXEL_CLI_SWEEP_ARRAY_H

#include <luxel/study.h>

#include "sha256.h"

enum { ARRAY_NAME = 64, ARRAY_HEADER = 128, ARRAY_DIMENSIONS = 4 };

struct array {
    char name[ARRAY_NAME];
    int file;
    luxel_study_type type;
    struct sha256 sum;
    void *converted; /* room for what a call adds */
    size_t room;
};

/* The size of a number; 1 for a text. */
size_t array_item_size(luxel_study_type type);

/*
 * Creates NAME.npy, or NAME.lp, in an open folder, or nowhere where that is below 0; the shape ends with 0.  Each
 * function returns 0 or an errno value; ERANGE: a number is too large for its type.  array_close() is due in
 * either case; it makes the file durable unless `hex`, which takes its sum, is NULL.
 */
int array_open(struct array *array, int folder, const char *name, luxel_study_type type, const size_t *shape,
               bool by_instructions);
int array_add_singles(struct array *array, const float *numbers, size_t count);
int array_add_doubles(struct array *array, const double *numbers, size_t count);
int array_add_bytes(struct array *array, const void *bytes, size_t count);
int array_close(struct array *array, char hex[SHA256_HEX]);

/* The nearest number of IEEE half precision, ties to even. */
uint16_t array_half(double number);

#endif
