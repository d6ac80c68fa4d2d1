/* SPDX-License-Identifier: MIT */
/* <alloca.h>, which Windows has in another header. */
#include <malloc.h>
