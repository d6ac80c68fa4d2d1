/* SPDX-License-Identifier: MIT */
/* Memory that runs out: one allocation fails, of those that pass through here (linked with --wrap of all: see
 * meson.build). */
#ifndef TESTS_UNIT_SHORTAGE_H
#define TESTS_UNIT_SHORTAGE_H

#include <stdbool.h>

/* From now on allocation `number` (from 0) fails, unless shortage_end() comes before. */
void shortage_begin(long number);
void shortage_end(void);

/* Whether it has failed since shortage_begin(). */
bool shortage_met(void);

#endif
