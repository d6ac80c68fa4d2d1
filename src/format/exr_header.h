/* SPDX-License-Identifier: MIT */
/* The header of an EXR file, as far as tags and the choice of what can be read need it. */
#ifndef LX_FORMAT_EXR_HEADER_H
#define LX_FORMAT_EXR_HEADER_H

#include "tags.h"

#define LX_EXR_NAME "EXR"
#define LX_EXR_MAGIC "\x76\x2f\x31\x01"
enum { LX_EXR_MAGIC_LENGTH = 4, LX_EXR_CHANNELS_SIZE = 64 };

/* What the header says; of a file of several parts, the first one's. */
struct lx_exr_header {
    bool is_plain;                            /* one part of scan lines with one value a pixel */
    bool has_window;                          /* whether the next one was there */
    int32_t window[4];                        /* least x, least y, greatest x, greatest y */
    int compression;                          /* its number in the file; -1: none was there */
    unsigned channels;                        /* how many */
    bool is_sampled;                          /* whether a channel leaves pixels out */
    char channel_names[LX_EXR_CHANNELS_SIZE]; /* "R, G, B", cut where it is too long */
    bool has_odd_preview;                     /* a preview whose size is not that of its attribute */
};

/*
 * Reads the header; adds the tags that it carries unless `tags` is NULL.  No attribute reaches beyond the file, and
 * only tags are kept.
 */
luxel_status lx_exr_read_header(struct lx_source *source, struct lx_exr_header *header, struct lx_tags *tags);

/* Adds the tags that the header carries. */
luxel_status lx_exr_read_tags(struct lx_source *source, struct lx_tags *tags);

#endif
