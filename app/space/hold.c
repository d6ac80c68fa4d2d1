/* SPDX-License-Identifier: MIT */
/* The thing leads; what is held with it follows by the way that it has made. */
#include "hold.h"

#include <math.h>
#include <string.h>

#include "../picture/marks.h"

void app_hold_move(AppThing *thing, const AppProjection *projection, const double to_mm[3], double grain_mm,
                   const GArray *together, const AppTurn *turn, AppDocument *document)
{
    double step[3];
    memcpy(step, thing->at_mm, sizeof step);
    app_document_set_topic(document, together ? "lights" : NULL);
    const gboolean done = projection ? app_space_move(thing, *projection, to_mm, grain_mm, document)
                                     : app_space_carry(thing, to_mm, grain_mm, document);
    if (done)
        app_turn_follow(turn, document);
    if (done && together && thing->kind == APP_THING_LAMP) {
        for (int k = 0; k < 3; k++)
            step[k] = thing->at_mm[k] - step[k];
        for (guint i = 0; i < together->len; i++) {
            const AppMark mark = {.kind = APP_MARK_SOURCE, .index = g_array_index(together, gsize, i)};
            if (mark.index != thing->index) /* light from far away stands nowhere, and stays */
                app_mark_shift(&mark, step, document);
        }
    }
    app_document_set_topic(document, NULL);
}

double app_hold_grain(double pixel_mm, gboolean fine, gboolean round)
{
    if (!round)
        return pow(10, floor(log10(pixel_mm * (fine ? 0.1 : 1))));
    const double power = pow(10, floor(log10(8 * pixel_mm))), share = 8 * pixel_mm / power;
    return power * (share < 2 ? 2 : share < 5 ? 5 : 10);
}
