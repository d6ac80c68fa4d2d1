/* SPDX-License-Identifier: MIT */
/* The texts that a PNG picture carries: its iTXt, zTXt and tEXt chunks. */
#ifndef LX_FORMAT_PNG_TAGS_H
#define LX_FORMAT_PNG_TAGS_H

#include "tags.h"

#define LX_PNG_MAGIC "\x89PNG\r\n\x1a\n"
enum { LX_PNG_MAGIC_LENGTH = 8 };

/* Reads the tags of a PNG picture of any kind.  The picture itself is passed over. */
luxel_status lx_png_read_tags(struct lx_source *source, struct lx_tags *tags);

#endif
