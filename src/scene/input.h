/* SPDX-License-Identifier: MIT */
/* Reading a scene file as a whole, within the limit of its size. */
#ifndef LX_SCENE_INPUT_H
#define LX_SCENE_INPUT_H

#include "../base/diagnostics.h"

/* Reads at most LX_LARGEST_TEXT bytes; the text is the caller's, to be freed with free(). */
luxel_status lx_read_input(const char *path, luxel_diagnostics *diagnostics, char **text, size_t *length);

/* Reports that a text is beyond the limit; returns LUXEL_ERROR_SCENE. */
luxel_status lx_refuse_size(const char *source, luxel_diagnostics *diagnostics);

#endif
