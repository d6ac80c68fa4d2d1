/* SPDX-License-Identifier: MIT */
/* Reflected light for whoever asks for values at places: solved once for all of them. */
#ifndef LX_API_REFLECTING_H
#define LX_API_REFLECTING_H

#include "../reflect/reflected.h"
#include "refuse.h"
#include "session.h"

/* The bound that is asked for where settings name none. */
#define LX_DEFAULT_REFLECTED_ERROR 1e-3

/* The bound that settings ask for. */
double lx_reflected_error_of(const luxel_settings *settings);

/*
 * What is reflected to places, of which `reached` tells whether its error is as small as the settings ask for.  Solves
 * for them, and asks at each, in parallel.  LUXEL_OK, LUXEL_CANCELLED, LUXEL_ERROR_MEMORY, which is reported.
 */
struct lx_reflecting {
    const struct lx_prepared *prepared;
    const struct lx_element_kernels *kernels;
    const luxel_settings *settings;
    struct lx_control *control;
    const struct lx_reflected_place *places;
    size_t count;
    lx_bounded *irradiance; /* of each place: set here */
};
luxel_status lx_reflect_places(const struct lx_reflecting *reflecting, luxel_diagnostics *diagnostics);

#endif
