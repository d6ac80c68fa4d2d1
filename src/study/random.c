/* SPDX-License-Identifier: MIT */
/* Philox 4x32-10, and uniform numbers of its words. */
#include "random.h"

void lx_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t words[4])
{
    enum { ROUNDS = 10 };
    uint32_t x0 = counter[0], x1 = counter[1], x2 = counter[2], x3 = counter[3], k0 = key[0], k1 = key[1];
    for (int round = 0; round < ROUNDS; round++) {
        const uint64_t a = UINT64_C(0xD2511F53) * x0, b = UINT64_C(0xCD9E8D57) * x2;
        x0 = (uint32_t)(b >> 32) ^ x1 ^ k0;
        x1 = (uint32_t)b;
        x2 = (uint32_t)(a >> 32) ^ x3 ^ k1;
        x3 = (uint32_t)a;
        k0 += 0x9E3779B9;
        k1 += 0xBB67AE85;
    }
    words[0] = x0;
    words[1] = x1;
    words[2] = x2;
    words[3] = x3;
}

double lx_draw(uint64_t seed, uint64_t scene, uint32_t axis, uint32_t draw)
{
    const uint32_t counter[4] = {(uint32_t)scene, (uint32_t)(scene >> 32), axis, draw / 2};
    const uint32_t key[2] = {(uint32_t)seed, (uint32_t)(seed >> 32)};
    uint32_t words[4];
    lx_philox(counter, key, words);
    const uint32_t *pair = words + draw % 2 * 2;
    return (double)(((uint64_t)pair[1] << 32 | pair[0]) >> 11) * 0x1p-53;
}
