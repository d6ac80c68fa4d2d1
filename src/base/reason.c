/* SPDX-License-Identifier: MIT */
/* Why a system call failed, in words.  strerror() depends on the locale and may share a buffer. */
#include "reason.h"

#include <stddef.h>
#include <string.h>

const char *lx_reason(int number)
{
    const char *text = strerrordesc_np(number);

    return text != NULL ? text : "unknown error";
}
