/* SPDX-License-Identifier: MIT */
/* Writing luminaires: what both formats need. */
#ifndef LX_FORMAT_PHOTOMETRY_WRITE_H
#define LX_FORMAT_PHOTOMETRY_WRITE_H

#include "../../base/text.h"
#include "photometry.h"

/* The planes of a table that a file holds: rows of the complete one, or values between two of them. */
struct lx_written_table {
    double *planes;
    double *intensities; /* of all planes, one after the other */
    size_t plane_count;
};

/*
 * The planes that a symmetry leaves, from C = `from` on; of a whole turn that begins elsewhere than at 0 the plane at
 * 0 is added where it is wanted.  False: no memory.
 */
bool lx_take_planes(const luxel_photometry *photometry, double from_deg, double to_deg, struct lx_written_table *table);
void lx_written_table_clear(struct lx_written_table *table);

/* Adds a number with as many digits as it needs to be read back. */
void lx_add_number(struct lx_text *text, double number);

/* A text in one line, what cannot stand in it left out. */
void lx_add_line(struct lx_text *text, const char *line, size_t length);

void lx_write_lm63(const luxel_photometry *photometry, struct lx_text *text, bool *has_memory);
void lx_write_eulumdat(const luxel_photometry *photometry, struct lx_text *text, bool *has_memory);

#endif
