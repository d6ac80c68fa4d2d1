/* SPDX-License-Identifier: MIT */
/* EXR pictures without OpenEXR's library: the scene that one carries can be read, its values can not. */
#include "exr_header.h"
#include "format.h"

const struct lx_format lx_format_exr = {
    .ending = ".exr",
    .name = LX_EXR_NAME,
    .magic = LX_EXR_MAGIC,
    .magic_length = LX_EXR_MAGIC_LENGTH,
    .read_tags = lx_exr_read_tags,
};
