/* SPDX-License-Identifier: MIT */
/* Header <alloca.h>, which Windows has in another header. */
#include <malloc.h>
