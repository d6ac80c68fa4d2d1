/* SPDX-License-Identifier: MIT */
/* Reading the picture of an EXR file. */
#ifndef LX_FORMAT_EXR_READ_H
#define LX_FORMAT_EXR_READ_H

#include "format.h"

/*
 * Reads a picture of scan lines with a single channel, whatever its name, of float32, float16 or whole numbers,
 * compressed without loss or not at all; and its tags.
 */
luxel_status lx_exr_read(struct lx_source *source, struct lx_loaded *loaded);

#endif
