/* SPDX-License-Identifier: MIT */
/* The control of a date: a field of text, and a label that is dragged through the hours of its day. */
#include <math.h>

#include "date.h"
#include "row_private.h"

enum {
    WAY = 600, /* dots that a drag takes through a day */
    GRAIN = 5, /* minutes */
    FINE_GRAIN = 1,
    COARSE_GRAIN = 60
};

static gboolean begins(AppRow *self)
{
    self->start = app_date_minutes(gtk_editable_get_text(GTK_EDITABLE(self->control)));
    return self->start >= 0;
}

static void moves(AppRow *self, double dots, gboolean fine, gboolean coarse)
{
    const int grain = fine ? FINE_GRAIN : coarse ? COARSE_GRAIN : GRAIN;
    const double way = dots * APP_DATE_DAY_MINUTES / WAY * (fine ? 0.1 : 1);
    const int minutes = (int)lround((self->start + way) / grain) * grain;
    char *date = app_date_at(gtk_editable_get_text(GTK_EDITABLE(self->control)),
                             CLAMP(minutes, 0, APP_DATE_DAY_MINUTES - grain));
    gtk_editable_set_text(GTK_EDITABLE(self->control), date);
    app_row_enter(self);
    g_free(date);
}

void app_row_make_date(AppRow *self)
{
    static const AppRowHand hand = {begins, moves};
    app_row_make_draggable(self, &hand);
}
