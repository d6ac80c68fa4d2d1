/* SPDX-License-Identifier: MIT */
/*
 * What a pixel may show.  A picture is held against the exact value at the sample.  Only where it misses that, its
 * neighbourhood is looked at, light by light, for what a good program may show just as well:
 *
 * - the truth a few roundings of float64 away from the sample, and with the lights a few roundings away from where they
 *   stand: places on a screen, and on a surface of the radius R, are themselves rounded;
 * - where surfaces meet to such roundings, what either shows;
 * - the truth on the other side of a jump (a hard cone, a gated highlight, the edge of a shadow, an outline) that lies
 *   within 1e-6 mm of the sample, as SPEC has it.  That a change is a jump and no slope is told by halving the way
 *   until there is no number between its ends.
 *
 * The picture must show one of these values, or one between, so an excused pixel cannot show anything it likes.
 */
#ifndef LUXEL_PROPERTIES_TRUTH_H
#define LUXEL_PROPERTIES_TRUTH_H

#include "trial.h"

/* Whether a value is the truth at a pixel, or one of those nearby, to the slack. */
bool truth_allows(struct trial *trial, unsigned column, unsigned row, double shown, double slack);

/* Whether a source lies on an element that a pixel shows, to rounding: from where it shines, then, nobody can tell. */
bool truth_is_touched(struct trial *trial);

/* Whether the pixel shows a surface where one is seen, but for pixels on an outline. */
bool truth_shows(struct trial *trial, unsigned column, unsigned row, bool is_shown);

#endif
