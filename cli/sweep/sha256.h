/* SPDX-License-Identifier: MIT */
/* SHA-256 (FIPS 180-4) of bytes as they come; by the processor's own instructions where it has them. */
#ifndef LUXEL_CLI_SWEEP_SHA256_H
#define LUXEL_CLI_SWEEP_SHA256_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SHA256_HEX = 65 };

struct sha256 {
    uint32_t state[8];
    uint64_t length;
    unsigned char rest[64];
    bool by_instructions;
};

/* Whether this processor has instructions for it; finding out takes tens of microseconds on some machines. */
bool sha256_has_instructions(void);

void sha256_begin(struct sha256 *sum, bool by_instructions);
void sha256_add(struct sha256 *sum, const void *bytes, size_t count);
/* The sum as 64 hexadecimal digits. */
void sha256_end(struct sha256 *sum, char hex[SHA256_HEX]);

#endif
