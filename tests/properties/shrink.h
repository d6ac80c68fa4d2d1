/* SPDX-License-Identifier: MIT */
/*
 * Making a draft that fails simpler for as long as it fails: fewer lights and surfaces, the plain value of each word
 * and number, fewer digits, smaller exponents, fewer pixels.
 */
#ifndef LUXEL_PROPERTIES_SHRINK_H
#define LUXEL_PROPERTIES_SHRINK_H

#include "draft.h"

/* Whether a draft fails as the first one did. */
typedef bool shrink_fails(const struct draft *draft, void *data);

void shrink(struct draft *draft, shrink_fails *fails, void *data);

#endif
