/* SPDX-License-Identifier: MIT */
/* EXR pictures without OpenEXR's library: the scene that one carries can be read, its values can not. */
#include "exr_header.h"
#include "format.h"

static luxel_status read_tags(struct lx_source *source, struct lx_tags *tags)
{
    struct lx_exr_header header;
    return lx_exr_read_header(source, &header, tags);
}

const struct lx_format lx_format_exr = {
    .ending = ".exr",
    .name = LX_EXR_NAME,
    .magic = LX_EXR_MAGIC,
    .magic_length = LX_EXR_MAGIC_LENGTH,
    .read_tags = read_tags,
};
