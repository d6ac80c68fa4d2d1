/* SPDX-License-Identifier: MIT */
/* The version of the library. */
#include <luxel/version.h>

#define WORD(number) #number
#define VERSION(major, minor, patch) WORD(major) "." WORD(minor) "." WORD(patch)

const char *luxel_version(void)
{
    return VERSION(LUXEL_VERSION_MAJOR, LUXEL_VERSION_MINOR, LUXEL_VERSION_PATCH);
}
