/* SPDX-License-Identifier: MIT */
/* Choices from bytes or from a seed. */
#include "choices.h"

#include <math.h>

struct choices choices_of_bytes(const uint8_t *data, size_t size)
{
    return (struct choices){.at = data, .end = data + size};
}

struct choices choices_of_seed(uint64_t seed)
{
    return (struct choices){.state = seed};
}

/* splitmix64: seeds that stand side by side give streams that have nothing in common. */
static uint64_t next(struct choices *choices)
{
    uint64_t mixed = choices->state += UINT64_C(0x9E3779B97F4A7C15);
    mixed = (mixed ^ (mixed >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    mixed = (mixed ^ (mixed >> 27)) * UINT64_C(0x94D049BB133111EB);
    return mixed ^ (mixed >> 31);
}

static unsigned next_byte(struct choices *choices)
{
    return choices->at < choices->end ? *choices->at++ : 0;
}

unsigned choose(struct choices *choices, unsigned count)
{
    return choices->at ? next_byte(choices) % count : (unsigned)((next(choices) >> 32) * count >> 32);
}

bool choose_rarely(struct choices *choices, unsigned one_in)
{
    return choose(choices, one_in) == one_in - 1;
}

/* From 0 up to, but not, 1. */
static double share(struct choices *choices)
{
    if (!choices->at)
        return (double)(next(choices) >> 11) * 0x1p-53;
    const unsigned high = next_byte(choices);
    return (high * 256 + next_byte(choices)) * 0x1p-16;
}

double choose_between(struct choices *choices, double low, double high)
{
    return low + (high - low) * share(choices);
}

double choose_size(struct choices *choices, double low, double high)
{
    return low * pow(high / low, share(choices));
}
