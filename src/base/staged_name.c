/* SPDX-License-Identifier: MIT */
/* Names of staged files, which are the same on every system. */
#include "staged.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

void lx_staged_hidden_name(const char *target, unsigned slot, char name[LX_HIDDEN_SIZE])
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325); /* FNV-1a */

    for (const char *c = target; *c != '\0'; c++)
        hash = (hash ^ (unsigned char)*c) * UINT64_C(0x100000001b3);
    snprintf(name, LX_HIDDEN_SIZE, ".luxel-%016llx-%u.part", (unsigned long long)hash, slot);
}

bool lx_staged_is_standard_output(const char *path)
{
    static const char name[] = "/dev/stdout";
    const size_t length = sizeof name - 1;

    return strncmp(path, name, length) == 0 && (path[length] == '\0' || path[length] == '.');
}
