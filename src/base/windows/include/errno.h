/* SPDX-License-Identifier: MIT */
/* Header <errno.h> with what Windows lacks. */
#ifndef LX_WINDOWS_ERRNO_H
#define LX_WINDOWS_ERRNO_H

#include_next <errno.h>

#define EDQUOT 10069

#endif
