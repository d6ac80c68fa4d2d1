/* SPDX-License-Identifier: MIT */
/* Reflected light for whoever asks for light at places: solved once for all of them. */
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

/* Elements that somebody has the direct light of, and asks what is reflected to. */
struct lx_reflecting {
    struct lx_control *control;
    size_t count;
    /* Element i and the direct irradiance there; false: nothing is asked of it. */
    bool (*element)(const void *data, size_t i, struct lx_element *element, double *direct);
    /* Takes the irradiance that is reflected to it; called in their order. */
    void (*take)(void *data, size_t i, lx_bounded irradiance);
    void *data;
    struct lx_kept_slot *slot;          /* where the solution is left for whoever asks next; NULL: nowhere */
    const struct lx_reflected_key *key; /* of the plane of a grid that they lie in; NULL: they do not */
    const struct lx_response *response; /* by which light counts; NULL: by the cosine, as irradiance */
};

/*
 * Finds what is reflected to elements, which the session's world knows from then on: solves for them, unless what it
 * knows, or what was left, is to serve all or is exact enough, or `is_known` says that it was found for the same, and
 * asks at each, in parallel.  LUXEL_OK, LUXEL_CANCELLED, LUXEL_ERROR_MEMORY, which is reported.
 */
luxel_status lx_reflect_places(struct lx_session *session, const struct lx_reflecting *reflecting, bool is_known,
                               luxel_diagnostics *diagnostics);

/* The answer of a session's world for reflected light: its member `reflect`. */
void lx_reflect_elements(const struct lx_world *world, const struct lx_elements *elements,
                         const struct lx_asking *asking, struct lx_received *received);

/* Whether the solution that the session's world has, if any, is enough for a request. */
static inline bool lx_reflected_serves(const struct lx_session *session, const struct lx_reflected_request *request)
{
    const struct lx_radiosity *reflected = session->world.reflected;
    return reflected && (session->settings.share_reflected || lx_reflected_is_reached(reflected, request) ||
                         (lx_reflected_is_cut(reflected, request->within, request->is_enough) &&
                          lx_reflected_is_for(reflected, request)));
}

/* The key of a solution for any places, and the one that was left in a slot and was made with such, for a plane or not,
 * to be released; NULL: none. */
struct lx_reflected_key lx_reflected_key_of_places(const struct lx_session *session);
struct lx_radiosity *lx_reflected_of_places(struct lx_kept_slot *slot, const struct lx_reflected_key *key);

/* The key of a solution for the plane of the i-th grid, and the solution that the scene keeps, to be released; NULL:
 * none. */
struct lx_reflected_key lx_reflected_key_of_plane(const struct lx_session *session, size_t i);
struct lx_radiosity *lx_reflected_of_plane(const luxel_scene *scene, const struct lx_session *session, size_t i);

/*
 * Finds what surfaces reflect in the session's picture, if the scene wants light to be reflected, for its world; from
 * the scene where it was found before, whose next user finds it there.  LUXEL_OK, LUXEL_CANCELLED,
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
