/* SPDX-License-Identifier: MIT */
/* How long tests by random scenes go on: LUXEL_CAMPAIGN is the share of the usual number in per cent, 1000 for ten
 * times as many; sanitizers and emulators, by which all takes many times as long, are asked for less. */
#ifndef TESTS_UNIT_CAMPAIGN_H
#define TESTS_UNIT_CAMPAIGN_H

#include <stdlib.h>

/* The share of a usual number: of scenes to try, and of what is expected to be met among them. */
static inline size_t in_campaign(size_t usual)
{
    const char *percent = getenv("LUXEL_CAMPAIGN");
    return percent ? usual * strtoul(percent, NULL, 10) / 100 : usual;
}

/* Scenes to try: at least one. */
static inline int scenes_to_try(int usual)
{
    const size_t share = in_campaign((size_t)usual);
    return share > 1 ? (int)share : 1;
}

#endif
