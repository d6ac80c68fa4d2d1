/* SPDX-License-Identifier: MIT */
/* Files of a picture in the making: it comes strip by strip, or all at once. */
#ifndef LX_API_OUTPUT_H
#define LX_API_OUTPUT_H

#include "../base/sink.h"
#include "../field/field.h"

struct lx_output;

/* Whether luxel_field_write_as() takes this; else says why not.  LUXEL_ERROR_ARGUMENT. */
luxel_status lx_output_check(const char *path, const luxel_field_output *how, luxel_diagnostics *diagnostics);

/* Whether a file of that name carries texts, the scene's among them. */
bool lx_output_carries(const char *path);

/*
 * Begins a file for the picture of a field, which may be a frame; it must live as long as the output, as `diagnostics`
 * and the destination's path must.  LUXEL_ERROR_ARGUMENT, LUXEL_ERROR_FILE, LUXEL_ERROR_MEMORY.
 */
luxel_status lx_output_open(const struct luxel_field *field, const struct lx_destination *destination,
                            const luxel_field_output *how, luxel_diagnostics *diagnostics, struct lx_output **output);

/* Whether it can be written only from all values: then strips before the last are kept in a file beside it. */
bool lx_output_waits(const struct lx_output *output);

/* Whether it must get the whole picture as one strip, because it goes where nothing can be kept or put in order. */
bool lx_output_wants_all(const struct lx_output *output);

/* Writes the next strip.  If it is the whole picture, the field has its statistics.  A failure is kept. */
void lx_output_add(struct lx_output *output, const struct lx_strip *strip);

/*
 * Writes the next rows of those that were kept, once the field has its statistics, into and out of a strip that has
 * room for them; of one that does not wait nothing is kept.  A failure is kept.
 */
void lx_output_catch_up(struct lx_output *output, struct lx_strip *strip);

/* Puts the file in its place, or gives it up (NULL is harmless); both free the output. */
luxel_status lx_output_commit(struct lx_output *output);
void lx_output_abort(struct lx_output *output);

#endif
