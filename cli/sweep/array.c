/* SPDX-License-Identifier: MIT */
/* NPY files (version 1.0, a header of 128 bytes) as a stream of numbers. */
#include "array.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define ORDER ">"
#else
#define ORDER "<"
#endif

size_t array_item_size(luxel_study_type type)
{
    switch (type) {
    case LUXEL_STUDY_FLOAT16: return 2;
    case LUXEL_STUDY_INT32:
    case LUXEL_STUDY_FLOAT32: return 4;
    case LUXEL_STUDY_FLOAT64: return 8;
    default: return 1;
    }
}

/* Half of a float: what is too large is infinite. */
static uint16_t half_of_single(float number)
{
    const uint32_t bias = 0x38000000, half_ulp = 0xfff;
    uint32_t bits;

    memcpy(&bits, &number, sizeof bits);
    const uint16_t sign = (uint16_t)(bits >> 16 & 0x8000);

    bits &= 0x7fffffff;
    if (bits > 0x7f800000)
        return sign | 0x7e00;
    if (bits >= 0x47800000)
        return sign | 0x7c00;
    if (bits < 0x38800000) { /* below the normal numbers, in steps of 2^-24: a sum rounds as it should */
        const float lifted = fabsf(number) + 0.5f;

        memcpy(&bits, &lifted, sizeof bits);
        return (uint16_t)(sign | (bits - 0x3f000000));
    }
    bits += half_ulp + (bits >> 13 & 1);
    return (uint16_t)(sign | (bits - bias) >> 13);
}

/* Rounded to odd on the way, so that the second rounding is that of the number itself. */
uint16_t array_half(double number)
{
    float single = (float)number;
    uint32_t bits;

    if (isnan(number) || isinf(single) || (double)single == number)
        return half_of_single(single);
    if (fabs((double)single) > fabs(number))
        single = nextafterf(single, 0.0f);
    memcpy(&bits, &single, sizeof bits);
    bits |= 1;
    memcpy(&single, &bits, sizeof bits);
    return half_of_single(single);
}

static int write_all(struct array *array, const void *bytes, size_t count)
{
    const char *at = bytes;

    sha256_add(&array->sum, bytes, count);
    while (count > 0) {
        const ssize_t written = write(array->file, at, count);

        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return errno;
        at += written;
        count -= (size_t)written;
    }
    return 0;
}

/* The header, padded so that the numbers begin at a multiple of 64. */
static int write_header(struct array *array, const size_t *shape)
{
    static const char *const kinds[] = {[LUXEL_STUDY_FLOAT16] = ORDER "f2",
                                        [LUXEL_STUDY_FLOAT32] = ORDER "f4",
                                        [LUXEL_STUDY_FLOAT64] = ORDER "f8",
                                        [LUXEL_STUDY_UINT8] = "|u1",
                                        [LUXEL_STUDY_INT32] = ORDER "i4"};
    char header[ARRAY_HEADER + 1], numbers[ARRAY_HEADER] = "";
    size_t used = 0;
    int length;

    for (size_t i = 0; shape[i]; i++)
        used += (size_t)snprintf(numbers + used, sizeof numbers - used, "%s%zu", i ? ", " : "", shape[i]);
    if (shape[0] && !shape[1])
        snprintf(numbers + used, sizeof numbers - used, ",");
    memcpy(header, "\x93NUMPY\x01\x00\x76\x00", 10);
    length = snprintf(header + 10, sizeof header - 10, "{'descr': '%s', 'fortran_order': False, 'shape': (%s), }",
                      kinds[array->type], numbers);
    memset(header + 10 + length, ' ', ARRAY_HEADER - 10 - (size_t)length);
    header[ARRAY_HEADER - 1] = '\n';
    return write_all(array, header, ARRAY_HEADER);
}

int array_open(struct array *array, int folder, const char *name, luxel_study_type type, const size_t *shape,
               bool by_instructions)
{
    *array = (struct array){.type = type};
    snprintf(array->name, sizeof array->name, "%s.%s", name, type == LUXEL_STUDY_LP ? "lp" : "npy");
    sha256_begin(&array->sum, by_instructions);
    array->file = folder < 0 ? open("/dev/null", O_WRONLY | O_CLOEXEC)
                             : openat(folder, array->name, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
    if (array->file < 0)
        return errno;
    return type == LUXEL_STUDY_LP ? 0 : write_header(array, shape);
}

/* Room for so many bytes; NULL where memory ran out. */
static void *make_room(struct array *array, size_t bytes)
{
    if (bytes > array->room) {
        free(array->converted);
        array->converted = malloc(bytes);
        array->room = array->converted ? bytes : 0;
    }
    return array->converted;
}

int array_add_bytes(struct array *array, const void *bytes, size_t count)
{
    return write_all(array, bytes, count);
}

int array_add_singles(struct array *array, const float *numbers, size_t count)
{
    const size_t bytes = count * array_item_size(array->type);
    uint16_t *halves;
    double *doubles;

    if (array->type == LUXEL_STUDY_FLOAT32)
        return write_all(array, numbers, bytes);
    if (!make_room(array, bytes))
        return ENOMEM;
    halves = array->converted;
    doubles = array->converted;
    for (size_t i = 0; i < count; i++)
        if (array->type == LUXEL_STUDY_FLOAT64)
            doubles[i] = (double)numbers[i];
        else if (((halves[i] = half_of_single(numbers[i])) & 0x7fff) == 0x7c00)
            return ERANGE;
    return write_all(array, array->converted, bytes);
}

int array_add_doubles(struct array *array, const double *numbers, size_t count)
{
    const size_t bytes = count * array_item_size(array->type);
    uint16_t *halves;
    float *singles;

    if (array->type == LUXEL_STUDY_FLOAT64)
        return write_all(array, numbers, bytes);
    if (!make_room(array, bytes))
        return ENOMEM;
    halves = array->converted;
    singles = array->converted;
    for (size_t i = 0; i < count; i++)
        if (array->type == LUXEL_STUDY_FLOAT32)
            singles[i] = (float)numbers[i];
        else if (((halves[i] = array_half(numbers[i])) & 0x7fff) == 0x7c00)
            return ERANGE;
    return write_all(array, array->converted, bytes);
}

int array_close(struct array *array, char hex[SHA256_HEX])
{
    int failed = 0;

    free(array->converted);
    array->converted = NULL;
    if (array->file <= 0)
        return 0;
    if (hex) {
        sha256_end(&array->sum, hex);
        failed = fsync(array->file) == 0 ? 0 : errno;
    }
    if (close(array->file) != 0 && failed == 0)
        failed = errno;
    array->file = -1;
    return failed;
}
