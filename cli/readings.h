/* SPDX-License-Identifier: MIT */
/* Readings that luxel fit fits a scene to: a picture, or values at points. */
#ifndef LUXEL_CLI_READINGS_H
#define LUXEL_CLI_READINGS_H

#include "load.h"
#include "places.h"

struct readings {
    luxel_readings list;  /* as the library takes them */
    struct places places; /* of values */
    double *values;
    size_t capacity;
    luxel_field *picture; /* NULL: they are values */
};

/* Take the arguments of --noise and --saturated; report what is wrong. */
bool readings_take_noise(struct options *options, const char *argument);
bool readings_take_saturated(struct options *options, const char *argument);

/*
 * Reads the file of --picture or --values, with what the options say of noise and the like.  Returns an enum exit_code;
 * errors are printed here.  readings_clear() is due in every case.
 */
int readings_read(const struct options *options, const struct loaded *loaded, struct readings *readings);
void readings_clear(struct readings *readings);

#endif
