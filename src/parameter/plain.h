/* SPDX-License-Identifier: MIT */
/* What YAML makes of a scalar without quotes. */
#ifndef LX_PARAMETER_PLAIN_H
#define LX_PARAMETER_PLAIN_H

#include <stdbool.h>

/* Whether a plain scalar is a text to YAML 1.2, and not a number, a truth value or null. */
bool lx_plain_is_text(const char *text);

/* Whether it may be written without quotes anywhere and is a text to every version of YAML. */
bool lx_plain_is_safe(const char *text);

/* Whether it may be written without quotes anywhere, whatever it means. */
bool lx_plain_is_writable(const char *text);

#endif
