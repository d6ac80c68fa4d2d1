/* SPDX-License-Identifier: MIT */
/* Words for sources that are chosen together. */
#ifndef LUXEL_APP_SEVERAL_H
#define LUXEL_APP_SEVERAL_H

#include "../files/document.h"

/* How many lights (gsize) are changed together, and whether a drag leaves some; the caller's; NULL: just one. */
char *app_several_tell(const AppDocument *document, const GArray *lights);

#endif
