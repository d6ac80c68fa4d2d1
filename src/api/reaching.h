/* SPDX-License-Identifier: MIT */
/*
 * The least value of a picture where light arrives, found row by row beside the picture.  Only pixels that are no
 * brighter than the least so far are asked about, so that hardly more than the dark part of the picture is.
 */
#ifndef LX_API_REACHING_H
#define LX_API_REACHING_H

#include "../field/field.h"
#include "../picture/reach.h"
#include "session.h"

struct lx_reaching {
    bool is_open;  /* else nothing is asked, as it need not be or would cost too much */
    bool is_plain; /* light arrives wherever there is any: it is the least value above 0 */
    struct lx_reach reach;
    struct lx_reaching_worker *workers; /* one for each thread */
    unsigned count;
};

/*
 * For a picture of the session that so many threads compute.  Zero-initialise; release with lx_reaching_clear()
 * whatever it returns.  It is looked for only where the settings ask for it, and not in quick looks, nor where many
 * points are taken together.
 */
luxel_status lx_reaching_open(struct lx_reaching *reaching, const struct lx_session *session, unsigned threads,
                              luxel_diagnostics *diagnostics);
void lx_reaching_clear(struct lx_reaching *reaching);

/* Adds to what was gathered of a finished row, in the thread of that number. */
void lx_reaching_row(struct lx_reaching *reaching, unsigned worker, const struct luxel_field *field,
                     const struct lx_strip *strip, unsigned row, struct lx_row_statistics *gathered);

#endif
