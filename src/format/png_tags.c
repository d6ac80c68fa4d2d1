/* SPDX-License-Identifier: MIT */
/*
 * The texts that a PNG picture carries, found by walking from chunk to chunk.  libpng would have to decode the whole
 * picture to reach texts behind it, and makes room for whatever length a chunk claims; here no more is read than the
 * file has, checksums of everything but the picture are checked, and a compressed text is unpacked only as far as the
 * limit.  Format: PNG (ISO/IEC 15948) 5.3, 11.3.4.
 */
#include "png_tags.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "../base/memory.h"
#include "format.h"

enum {
    HEADER = 8,   /* of a chunk: its length and its type */
    CHECKSUM = 4, /* behind it */
    LONGEST_KEY = 79,
    PART = 16 * 1024,
    MOST_CHECKED = 128 << 20 /* bytes beside the picture */
};

struct chunk {
    uint64_t start; /* of its data */
    uint32_t length;
    char type[5];
};

static const char NAME[] = "PNG";

static uint32_t big_endian(const unsigned char bytes[4])
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static luxel_status read_chunk(struct lx_source *source, uint64_t at, struct chunk *chunk)
{
    unsigned char bytes[HEADER];
    luxel_status status = lx_source_read(source, at, bytes, sizeof bytes);
    if (status != LUXEL_OK)
        return status;
    *chunk = (struct chunk){.start = at + HEADER, .length = big_endian(bytes)};
    memcpy(chunk->type, bytes + 4, 4);
    for (size_t i = 0; i < 4; i++)
        if (!((bytes[4 + i] >= 'A' && bytes[4 + i] <= 'Z') || (bytes[4 + i] >= 'a' && bytes[4 + i] <= 'z')))
            return lx_bad_file(source, NAME, "chunk");
    if (chunk->length > INT32_MAX)
        return lx_bad_file(source, NAME, chunk->type);
    if (chunk->start + chunk->length + CHECKSUM > lx_source_size(source))
        return lx_source_refuse(source, LX_MSG_FILE_ENDS, NULL);
    return LUXEL_OK;
}

/* Whether type and data belong to the checksum behind them. */
static luxel_status check_chunk(struct lx_source *source, const struct chunk *chunk)
{
    unsigned char part[PART];
    uLong sum = crc32(0, (const Bytef *)chunk->type, 4);
    for (uint32_t done = 0; done < chunk->length;) {
        uint32_t count = chunk->length - done < PART ? chunk->length - done : PART;
        if (lx_source_read(source, chunk->start + done, part, count) != LUXEL_OK)
            return lx_source_status(source);
        sum = crc32(sum, part, count);
        done += count;
    }
    luxel_status status = lx_source_read(source, chunk->start + chunk->length, part, CHECKSUM);
    if (status == LUXEL_OK && big_endian(part) != sum)
        status = lx_source_refuse(source, LX_MSG_BAD_CHECKSUM, LX_ARGS(NAME));
    return status;
}

/* Unpacks a stream into a text of malloc()'s; a stream that does not end well, or beyond the limit, is refused. */
static luxel_status unpack(struct lx_source *source, const char *key, const unsigned char *packed, size_t length,
                           char **text, size_t *text_length)
{
    size_t capacity = 0;
    z_stream stream = {.next_in = (z_const Bytef *)(uintptr_t)packed, .avail_in = (uInt)length};
    if (inflateInit(&stream) != Z_OK)
        return lx_source_out_of_memory(source);
    int answer = Z_OK;
    *text = NULL;
    while (answer == Z_OK && stream.total_out <= LX_LARGEST_TAG) {
        size_t used = stream.total_out;
        if (lx_reserve(text, &capacity, used + PART, 1) < 0) {
            answer = Z_MEM_ERROR;
            break;
        }
        stream.next_out = (Bytef *)*text + used;
        stream.avail_out = (uInt)(capacity - used - 1); /* a 0 byte will follow */
        answer = inflate(&stream, Z_NO_FLUSH);
    }
    *text_length = stream.total_out;
    inflateEnd(&stream);
    if (answer == Z_STREAM_END && *text_length <= LX_LARGEST_TAG)
        return LUXEL_OK;
    free(*text);
    *text = NULL;
    if (answer == Z_MEM_ERROR)
        return lx_source_out_of_memory(source);
    return answer == Z_OK || answer == Z_STREAM_END ? lx_tag_too_large(source, key, NAME)
                                                    : lx_bad_file(source, NAME, key);
}

/* The place of the byte behind the next 0 byte from `at` on; 0 where there is none. */
static size_t behind_zero(const unsigned char *data, size_t length, size_t at)
{
    const unsigned char *zero = at < length ? memchr(data + at, 0, length - at) : NULL;
    return zero ? (size_t)(zero - data) + 1 : 0;
}

/* Where the text of a chunk's data begins, and whether it is compressed; 0 where they are not well-formed. */
static size_t find_text(const char *type, const unsigned char *data, size_t length, bool *compressed)
{
    size_t at = behind_zero(data, length, 0);
    *compressed = strcmp(type, "zTXt") == 0;
    if (strcmp(type, "tEXt") == 0 || at == 0)
        return at;
    if (*compressed)
        return at < length && data[at] == 0 ? at + 1 : 0;
    if (at + 2 > length || data[at] > 1 || (data[at] == 1 && data[at + 1] != 0))
        return 0;
    *compressed = data[at] == 1;
    at = behind_zero(data, length, at + 2);             /* the language */
    return at == 0 ? 0 : behind_zero(data, length, at); /* the translated key */
}

static luxel_status add_text(struct lx_source *source, const struct chunk *chunk, const char *key,
                             const unsigned char *data, struct lx_tags *tags)
{
    bool compressed = false;
    size_t at = find_text(chunk->type, data, chunk->length, &compressed), length = chunk->length - at;
    char *text = NULL;
    if (at == 0)
        return lx_bad_file(source, NAME, key);
    if (compressed) {
        luxel_status status = unpack(source, key, data + at, length, &text, &length);
        if (status != LUXEL_OK)
            return status;
    } else {
        text = lx_copy_text((const char *)data + at, length);
    }
    if (text && lx_tags_are_full(tags, length)) {
        free(text);
        return lx_tag_too_large(source, key, NAME);
    }
    if (!text || lx_tags_add(tags, key, text, length) < 0)
        return lx_source_out_of_memory(source);
    return LUXEL_OK;
}

/* Takes the text of a chunk if its key is one of ours; its checksum is right. */
static luxel_status take_text(struct lx_source *source, const struct chunk *chunk, struct lx_tags *tags)
{
    char key[LONGEST_KEY + 2] = "";
    size_t start = chunk->length < LONGEST_KEY + 1 ? chunk->length : LONGEST_KEY + 1;
    luxel_status status = lx_source_read(source, chunk->start, key, start);
    if (status != LUXEL_OK || !lx_is_our_tag(key) || lx_tags_find(tags, key)) /* of several the first counts */
        return status;
    if (chunk->length > LX_LARGEST_TAG + 2 * sizeof key)
        return lx_tag_too_large(source, key, NAME);
    unsigned char *data = lx_new_array(chunk->length, 1);
    if (!data)
        return lx_source_out_of_memory(source);
    status = lx_source_read(source, chunk->start, data, chunk->length);
    if (status == LUXEL_OK)
        status = add_text(source, chunk, key, data, tags);
    free(data);
    return status;
}

luxel_status lx_png_read_tags(struct lx_source *source, struct lx_tags *tags)
{
    struct chunk chunk = {.type = ""};
    uint64_t at = LX_PNG_MAGIC_LENGTH, checked = 0;
    luxel_status status = LUXEL_OK;
    while (status == LUXEL_OK && strcmp(chunk.type, "IEND") != 0) {
        status = read_chunk(source, at, &chunk);
        if (status != LUXEL_OK)
            break;
        if (at == LX_PNG_MAGIC_LENGTH && strcmp(chunk.type, "IHDR") != 0)
            return lx_bad_file(source, NAME, "IHDR");
        at = chunk.start + chunk.length + CHECKSUM;
        if (strcmp(chunk.type, "IDAT") == 0) {
            if (tags->count > 0) /* they stand together, and a damaged picture takes nothing from them */
                break;
            continue;
        }
        bool is_text =
            strcmp(chunk.type, "iTXt") == 0 || strcmp(chunk.type, "zTXt") == 0 || strcmp(chunk.type, "tEXt") == 0;
        checked += chunk.length;
        status = checked > MOST_CHECKED ? lx_bad_file(source, NAME, chunk.type) : check_chunk(source, &chunk);
        if (status == LUXEL_OK && is_text)
            status = take_text(source, &chunk, tags);
    }
    return status;
}
