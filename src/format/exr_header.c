/* SPDX-License-Identifier: MIT */
/*
 * The header of an EXR file, read attribute by attribute without making room for what it claims.  OpenEXR reads it
 * once more where the picture is wanted, but by then it is known to be one that Luxel takes.
 * Format: https://openexr.com/en/latest/OpenEXRFileLayout.html
 */
#include "exr_header.h"

#include <stdio.h>
#include <string.h>

#include "../base/memory.h"
#include "format.h"

enum {
    VERSION = 2,
    FLAG_TILES = 0x200,
    FLAG_LONG_NAMES = 0x400,
    FLAG_DEEP = 0x800,
    FLAG_PARTS = 0x1000,
    LONGEST_NAME = 255,
    MOST_ATTRIBUTES = 10000,
    MOST_CHANNEL_BYTES = 64 * 1024
};

struct attribute {
    char name[LONGEST_NAME + 1], type[LONGEST_NAME + 1];
    uint64_t start; /* of its value */
    uint32_t size;
};

static uint32_t little_endian(const unsigned char bytes[4])
{
    return (uint32_t)bytes[3] << 24 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[1] << 8 | bytes[0];
}

static luxel_status read_number(struct lx_source *source, uint64_t at, uint32_t *number)
{
    unsigned char bytes[4];
    luxel_status status = lx_source_read(source, at, bytes, sizeof bytes);
    if (status == LUXEL_OK)
        *number = little_endian(bytes);
    return status;
}

/* A text that ends with 0, which *at is moved behind. */
static luxel_status read_name(struct lx_source *source, uint64_t *at, char name[LONGEST_NAME + 1])
{
    uint64_t left = *at < lx_source_size(source) ? lx_source_size(source) - *at : 1;
    size_t count = left < LONGEST_NAME + 1 ? (size_t)left : LONGEST_NAME + 1;
    luxel_status status = lx_source_read(source, *at, name, count);
    if (status != LUXEL_OK)
        return status;
    const char *end = memchr(name, 0, count);
    if (!end)
        return count == left ? lx_source_refuse(source, LX_MSG_FILE_ENDS, NULL)
                             : lx_bad_file(source, LX_EXR_NAME, "header");
    *at += (uint64_t)(end - name) + 1;
    return LUXEL_OK;
}

/* The next attribute, which *at is moved behind; the end of the header is one without a name. */
static luxel_status read_attribute(struct lx_source *source, uint64_t *at, struct attribute *attribute)
{
    luxel_status status = read_name(source, at, attribute->name);
    if (status != LUXEL_OK || attribute->name[0] == '\0')
        return status;
    status = read_name(source, at, attribute->type);
    if (status == LUXEL_OK)
        status = read_number(source, *at, &attribute->size);
    if (status != LUXEL_OK)
        return status;
    attribute->start = *at + 4;
    *at = attribute->start + attribute->size;
    if (attribute->size > INT32_MAX)
        return lx_bad_file(source, LX_EXR_NAME, attribute->name);
    return *at > lx_source_size(source) ? lx_source_refuse(source, LX_MSG_FILE_ENDS, NULL) : LUXEL_OK;
}

static luxel_status take_window(struct lx_source *source, const struct attribute *attribute,
                                struct lx_exr_header *header)
{
    unsigned char bytes[16];
    if (attribute->size != sizeof bytes)
        return lx_bad_file(source, LX_EXR_NAME, attribute->name);
    luxel_status status = lx_source_read(source, attribute->start, bytes, sizeof bytes);
    for (size_t i = 0; status == LUXEL_OK && i < 4; i++)
        header->window[i] = (int32_t)little_endian(bytes + 4 * i);
    header->has_window = true;
    return status;
}

static luxel_status take_compression(struct lx_source *source, const struct attribute *attribute,
                                     struct lx_exr_header *header)
{
    unsigned char number = 0;
    if (attribute->size != 1)
        return lx_bad_file(source, LX_EXR_NAME, attribute->name);
    luxel_status status = lx_source_read(source, attribute->start, &number, 1);
    header->compression = number;
    return status;
}

static void add_name(struct lx_exr_header *header, const char *name)
{
    size_t used = strlen(header->channel_names);
    snprintf(header->channel_names + used, sizeof header->channel_names - used, "%s%s", used ? ", " : "", name);
}

/* For each channel its name, type, flags and the steps between its samples in x and y. */
static luxel_status take_channels(struct lx_source *source, const struct attribute *attribute,
                                  struct lx_exr_header *header)
{
    uint64_t at = attribute->start, end = at + attribute->size;
    char name[LONGEST_NAME + 1];
    if (attribute->size > MOST_CHANNEL_BYTES || header->channels > 0)
        return lx_bad_file(source, LX_EXR_NAME, attribute->name);
    for (;;) {
        uint32_t steps[2] = {0};
        luxel_status status = read_name(source, &at, name);
        if (status != LUXEL_OK)
            return status;
        if (at > end)
            return lx_bad_file(source, LX_EXR_NAME, attribute->name);
        if (name[0] == '\0')
            return LUXEL_OK;
        status = read_number(source, at + 8, &steps[0]);
        if (status == LUXEL_OK)
            status = read_number(source, at + 12, &steps[1]);
        if (status != LUXEL_OK)
            return status;
        at += 16;
        add_name(header, name);
        header->channels++;
        header->is_sampled |= steps[0] != 1 || steps[1] != 1;
    }
}

static luxel_status take_tag(struct lx_source *source, const struct attribute *attribute, struct lx_tags *tags)
{
    if (lx_tags_find(tags, attribute->name)) /* the first counts */
        return LUXEL_OK;
    if (lx_tags_are_full(tags, attribute->size))
        return lx_tag_too_large(source, attribute->name, LX_EXR_NAME);
    char *text = lx_new_array((size_t)attribute->size + 1, 1);
    if (!text)
        return lx_source_out_of_memory(source);
    lx_source_read(source, attribute->start, text, attribute->size);
    if (lx_tags_add(tags, attribute->name, text, attribute->size) < 0)
        return lx_source_out_of_memory(source);
    return lx_source_status(source);
}

/* OpenEXR trusts the size that a preview claims before it looks at the attribute's. */
static luxel_status take_preview(struct lx_source *source, const struct attribute *attribute,
                                 struct lx_exr_header *header)
{
    uint32_t width = 0, height = 0;
    luxel_status status = read_number(source, attribute->start, &width);
    if (status == LUXEL_OK)
        status = read_number(source, attribute->start + 4, &height);
    header->has_odd_preview |=
        width > INT16_MAX || height > INT16_MAX || (uint64_t)width * height * 4 + 8 != attribute->size;
    return status;
}

static luxel_status take_attribute(struct lx_source *source, const struct attribute *attribute,
                                   struct lx_exr_header *header, struct lx_tags *tags)
{
    if (strcmp(attribute->type, "preview") == 0)
        return take_preview(source, attribute, header);
    if (strcmp(attribute->name, "dataWindow") == 0)
        return take_window(source, attribute, header);
    if (strcmp(attribute->name, "compression") == 0)
        return take_compression(source, attribute, header);
    if (strcmp(attribute->name, "channels") == 0)
        return take_channels(source, attribute, header);
    if (tags && lx_is_our_tag(attribute->name) && strcmp(attribute->type, "string") == 0)
        return take_tag(source, attribute, tags);
    return LUXEL_OK;
}

luxel_status lx_exr_read_header(struct lx_source *source, struct lx_exr_header *header, struct lx_tags *tags)
{
    char magic[LX_EXR_MAGIC_LENGTH];
    uint32_t version = 0;
    uint64_t at = 8;
    *header = (struct lx_exr_header){.compression = -1};
    luxel_status status = lx_source_read(source, 0, magic, sizeof magic);
    if (status == LUXEL_OK)
        status = read_number(source, 4, &version);
    if (status != LUXEL_OK)
        return status;
    if (memcmp(magic, LX_EXR_MAGIC, sizeof magic) != 0)
        return lx_bad_file(source, LX_EXR_NAME, "magic");
    if ((version & 0xff) != VERSION ||
        (version & ~(uint32_t)(0xff | FLAG_TILES | FLAG_LONG_NAMES | FLAG_DEEP | FLAG_PARTS)))
        return lx_bad_file(source, LX_EXR_NAME, "version");
    header->is_plain = (version & (FLAG_TILES | FLAG_DEEP | FLAG_PARTS)) == 0;
    for (unsigned i = 0; i < MOST_ATTRIBUTES; i++) {
        struct attribute attribute;
        status = read_attribute(source, &at, &attribute);
        if (status != LUXEL_OK || attribute.name[0] == '\0')
            return status;
        status = take_attribute(source, &attribute, header, tags);
        if (status != LUXEL_OK)
            return status;
    }
    return lx_bad_file(source, LX_EXR_NAME, "header");
}

luxel_status lx_exr_read_tags(struct lx_source *source, struct lx_tags *tags)
{
    struct lx_exr_header header;
    return lx_exr_read_header(source, &header, tags);
}
