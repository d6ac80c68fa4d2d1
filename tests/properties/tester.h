/* SPDX-License-Identifier: MIT */
/* Tries properties on random scenes, and tells the smallest scene that breaks one. */
#ifndef LUXEL_PROPERTIES_TESTER_H
#define LUXEL_PROPERTIES_TESTER_H

#include <signal.h>
#include <stdio.h>

#include "properties.h"

struct tester_options {
    uint64_t seed; /* of the first scene; the others follow */
    unsigned long scenes;
    unsigned extended_one_in;          /* one light in so many is extended */
    const char *only;                  /* the name of the only property to try, then on every scene; NULL: all */
    FILE *progress;                    /* NULL: none */
    const volatile sig_atomic_t *stop; /* NULL, or what makes it end before all scenes are tried */
};

/* Writes TAP, a case a property; the number of properties that do not hold. */
size_t tester_run(const struct property *properties, size_t count, const struct tester_options *options, FILE *out);

#endif
