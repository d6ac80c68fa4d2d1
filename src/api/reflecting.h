/* SPDX-License-Identifier: MIT */
/* Reflected light for whoever asks for values at places: solved once for all of them. */
#ifndef LX_API_REFLECTING_H
#define LX_API_REFLECTING_H

#include "../picture/shader.h"
#include "../reflect/reflected.h"
#include "refuse.h"
#include "session.h"

/* The bound that settings ask for, at probes, grids and eyes; and in pictures and means of surfaces. */
double lx_reflected_error_of(const luxel_settings *settings);
double lx_pictured_error_of(const luxel_settings *settings);

/* Hints at surfaces that lie on one another, where that keeps the bound that was just reported from being small. */
void lx_hint_overlap(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                     luxel_diagnostics *diagnostics);

/*
 * What is reflected to places, of which `reached` tells whether its error is as small as the settings ask for.  Solves
 * for them, and asks at each, in parallel.  LUXEL_OK, LUXEL_CANCELLED, LUXEL_ERROR_MEMORY, which is reported.
 */
struct lx_reflecting {
    const struct lx_radiosity *picture; /* found for the picture, taken if it is shared or exact enough; NULL: none */
    const struct lx_prepared *prepared;
    const struct lx_element_kernels *kernels;
    const luxel_settings *settings;
    struct lx_control *control;
    const struct lx_reflected_place *places;
    size_t count;
    lx_bounded *irradiance;             /* of each place: set here */
    struct lx_kept_slot *slot;          /* where the solution is left for whoever asks next; NULL: nowhere */
    const struct lx_reflected_key *key; /* and with what it was made */
};
luxel_status lx_reflect_places(const struct lx_reflecting *reflecting, luxel_diagnostics *diagnostics);

/* Asks at places what a solution that was found tells, however large the errors are. */
luxel_status lx_ask_places(const struct lx_reflecting *reflecting, const struct lx_radiosity *reflected,
                           luxel_diagnostics *diagnostics);

/* The key of a solution for the plane of the i-th grid, and the solution that the scene keeps, to be released; NULL:
 * none. */
struct lx_reflected_key lx_reflected_key_of_plane(const struct lx_session *session, size_t i);
struct lx_radiosity *lx_reflected_of_plane(const luxel_scene *scene, const struct lx_session *session, size_t i);

/*
 * Finds what surfaces reflect in the session's picture, if the scene wants light to be reflected: session->reflected,
 * from the scene where it was found before, whose next user finds it there.  LUXEL_OK, LUXEL_CANCELLED,
 * LUXEL_ERROR_MEMORY, which is reported.
 */
luxel_status lx_reflect_picture(const luxel_scene *scene, struct lx_session *session, luxel_diagnostics *diagnostics);

/* Does so where the settings say that the picture's solution serves all that is asked. */
luxel_status lx_reflect_shared(const luxel_scene *scene, struct lx_session *session, luxel_diagnostics *diagnostics);

/* The solution that the scene keeps of a picture by the session's settings, to be released; NULL: none. */
struct lx_radiosity *lx_reflected_of_picture(const luxel_scene *scene, const struct lx_session *session);

/* Finished pixels of direct light in a row, through (x_mm[i], y_mm): float or double as the settings say, and which of
 * them show a surface. */
struct lx_lit_row {
    double y_mm;
    const double *x_mm;
    size_t count;
    void *values;
    const uint8_t *mask;
};

/* Adds what is reflected, with the scratch memory of the plan's shader.  Returns a bound of the errors of that. */
double lx_reflect_row(const struct lx_session *session, struct lx_shader_memory *memory, const struct lx_lit_row *row);

#endif
