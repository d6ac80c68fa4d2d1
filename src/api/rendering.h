/* SPDX-License-Identifier: MIT */
/* Computing a picture strip by strip: what luxel_render() and luxel_render_files() share. */
#ifndef LX_API_RENDERING_H
#define LX_API_RENDERING_H

#include "../field/field.h"
#include "../picture/polynomial/panels.h"
#include "reaching.h"

/* Rows that are held at a time, and what was gathered of each. */
struct lx_held {
    struct lx_strip strip;
    struct lx_row_statistics *rows;
    double *reflected_errors; /* of each row; NULL: nothing is reflected */
};

struct lx_rendering {
    const struct lx_session *session;
    const struct lx_plan *plan; /* of it */
    struct luxel_field *field;  /* a frame; gets its statistics before the last strip is handed on */
    luxel_diagnostics *diagnostics;
    struct lx_control control;
    unsigned threads;
    struct lx_shader_memory **memories; /* one for each thread */
    struct lx_panels_memory **panels;   /* where the plan has panels, likewise; and of each: */
    struct lx_panel_rows *panel_rows;   /* row of panels of a strip, */
    struct lx_render_piece *pieces;     /* and piece of these */
    struct lx_held held[2];             /* the second has room only where the first has not for all rows */
    struct lx_held *computed;           /* these rows are being computed, */
    struct lx_held *finished;           /* and these, which come before, handed on; NULL: none yet */
    struct lx_reaching reaching;
    struct lx_tally tally;
    double reflected_error; /* of what was added to the rows that were put away */
    luxel_status status;
    /* For the user: what takes the strips, from the top on, each once, in the calling thread; NULL: nothing. */
    void (*take)(void *data, const struct lx_strip *strip);
    void *take_data;
};

/* A field without values that knows all else of the session's picture; the caller's, even where it fails.  `scene`:
 * whose text it keeps, NULL: none. */
luxel_status lx_new_frame(const struct lx_session *session, const luxel_scene *scene, luxel_diagnostics *diagnostics,
                          struct luxel_field **frame);

/* How many threads will compute the picture of a frame: where the settings leave it open, no more than pay. */
unsigned lx_rendering_threads(const struct lx_session *session, const struct luxel_field *field);

/*
 * Makes room to compute the picture of a frame in strips of `height` rows.  Session and field must outlive it; release
 * with lx_rendering_clear() whatever it returns.
 */
luxel_status lx_rendering_open(struct lx_rendering *rendering, const struct lx_session *session,
                               struct luxel_field *field, unsigned height, luxel_diagnostics *diagnostics);
luxel_status lx_rendering_run(struct lx_rendering *rendering);
void lx_rendering_clear(struct lx_rendering *rendering);

/* An error as a share of a picture's maximum: HUGE_VAL where that is 0. */
double lx_share_of_maximum(const luxel_statistics *statistics, double error);

/* Advice where light or sights go over more mirrors than the scene counts. */
void lx_report_mirrored_error(const luxel_scene *scene, const luxel_statistics *statistics,
                              luxel_diagnostics *diagnostics);

#endif
