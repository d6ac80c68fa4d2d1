/* SPDX-License-Identifier: MIT */
/* Why a system call failed, in words: the same ones in every locale, and safe in every thread. */
#ifndef LX_BASE_REASON_H
#define LX_BASE_REASON_H

/* A constant English text for an errno value, such as "No space left on device"; never NULL. */
const char *lx_reason(int number);

#endif
