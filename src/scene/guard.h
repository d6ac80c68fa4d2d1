/* SPDX-License-Identifier: MIT */
/* What a text must be before the YAML parser may see it. */
#ifndef LX_SCENE_GUARD_H
#define LX_SCENE_GUARD_H

#include "../base/diagnostics.h"

enum { LX_DEEPEST = 32, LX_LARGEST_TEXT = 64 << 20 };

/*
 * Checks the text of the place from place->start on: UTF-8, no control characters, and nothing that the parser
 * would have to keep in memory as a whole.  LUXEL_ERROR_SCENE: not so, and reported.
 */
luxel_status lx_guard_text(const struct lx_place *place, luxel_diagnostics *diagnostics);

#endif
