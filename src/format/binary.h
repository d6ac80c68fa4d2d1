/* SPDX-License-Identifier: MIT */
/* Numbers in binary files, of either byte order, and words in files that are no texts. */
#ifndef LX_FORMAT_BINARY_H
#define LX_FORMAT_BINARY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum lx_binary_type { LX_INT8, LX_UINT8, LX_INT16, LX_UINT16, LX_INT32, LX_UINT32, LX_FLOAT32, LX_FLOAT64 };

static inline size_t lx_binary_size(enum lx_binary_type type)
{
    static const size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[type];
}

/* A number of so many bytes. */
static inline uint64_t lx_binary_bits(const char *at, size_t size, bool is_big)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < size; i++)
        bits |= (uint64_t)(unsigned char)at[i] << 8 * (is_big ? size - 1 - i : i);
    return bits;
}

static inline double lx_binary_number(const char *at, enum lx_binary_type type, bool is_big)
{
    const uint64_t bits = lx_binary_bits(at, lx_binary_size(type), is_big);
    const uint32_t half = (uint32_t)bits;
    float single;
    double number;
    switch (type) {
    case LX_INT8: return (int8_t)bits;
    case LX_INT16: return (int16_t)bits;
    case LX_INT32: return (int32_t)bits;
    case LX_FLOAT32: memcpy(&single, &half, sizeof single); return (double)single;
    case LX_FLOAT64: memcpy(&number, &bits, sizeof number); return number;
    default: return (double)bits;
    }
}

/* Where a word begins, at the start of a line; NULL: nowhere. */
static inline char *lx_find_text(char *text, size_t length, const char *word)
{
    const size_t size = strlen(word);
    for (char *at = text, *end = text + length; at && (size_t)(end - at) >= size;) {
        if (memcmp(at, word, size) == 0)
            return at;
        const char *feed = memchr(at, '\n', (size_t)(end - at)), *back = memchr(at, '\r', (size_t)(end - at));
        const char *stop = !feed ? back : !back || feed < back ? feed : back;
        at = stop ? at + (stop + 1 - at) : NULL;
    }
    return NULL;
}

#endif
