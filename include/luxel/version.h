/* SPDX-License-Identifier: MIT */
/* The version of the headers, and of the library that is linked. */
#ifndef LUXEL_VERSION_H
#define LUXEL_VERSION_H

#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The first number of the headers' version. */
#define LUXEL_VERSION_MAJOR 0
/* The second number of the headers' version. */
#define LUXEL_VERSION_MINOR 1
/* The third number of the headers' version. */
#define LUXEL_VERSION_PATCH 0

/* The version of the library that is linked, such as "0.1.0". */
LUXEL_API const char *luxel_version(void);

#ifdef __cplusplus
}
#endif
#endif
