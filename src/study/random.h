/* SPDX-License-Identifier: MIT */
/* Random numbers by counter: Philox 4x32 with ten rounds (Salmon et al. 2011), so that any number can be had alone. */
#ifndef LX_STUDY_RANDOM_H
#define LX_STUDY_RANDOM_H

#include <stdint.h>

/* The four words of a counter under a key. */
void lx_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t words[4]);

/* Draw `draw` of axis `axis` of a scene: from 0 to below 1, in steps of 2^-53. */
double lx_draw(uint64_t seed, uint64_t scene, uint32_t axis, uint32_t draw);

#endif
