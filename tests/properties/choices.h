/* SPDX-License-Identifier: MIT */
/*
 * A stream of choices, from which everything random in a scene is made: from bytes, so that a fuzzing engine can steer
 * it, or from a seed.  Bytes that have run out choose the first, which is the simplest, of everything.
 */
#ifndef LUXEL_PROPERTIES_CHOICES_H
#define LUXEL_PROPERTIES_CHOICES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct choices {
    const uint8_t *at, *end; /* NULL: from the state */
    uint64_t state;
};

struct choices choices_of_bytes(const uint8_t *data, size_t size);
struct choices choices_of_seed(uint64_t seed);

/* One of 0 ... count - 1; count is at most 256. */
unsigned choose(struct choices *choices, unsigned count);
/* Whether the last one of so many was chosen. */
bool choose_rarely(struct choices *choices, unsigned one_in);
/* A number from low up to, but not, high; and one whose logarithm is even. */
double choose_between(struct choices *choices, double low, double high);
double choose_size(struct choices *choices, double low, double high);

#endif
