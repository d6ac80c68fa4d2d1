/* SPDX-License-Identifier: MIT */
/* Why a system call failed, in words.  strerror() depends on the locale and may share a buffer. */
#include "reason.h"

#include <stddef.h>
#include <string.h>

const char *lx_reason(int number)
{
#ifdef __GLIBC__
    const char *text = strerrordesc_np(number);
#else
    const char *text = strerror(number); /* of the C library of the web page, whose texts are constant */
#endif

    return text != NULL ? text : "unknown error";
}
