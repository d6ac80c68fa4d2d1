/* SPDX-License-Identifier: MIT */
/* Curves of sections: profiles of a shot, or the difference of those of two. */
#ifndef LUXEL_APP_CURVE_H
#define LUXEL_APP_CURVE_H

#include <glib.h>
#include <luxel/profile.h>

/* A profile with its own arrays. */
typedef struct AppCurve {
    luxel_profile profile;
    gboolean is_difference;
    double low, high; /* of the axis of a difference, with zero in the middle */
} AppCurve;

/* What the library found, which is taken over; less `minus` (NULL: nothing), which is along the same way. */
AppCurve *app_curve_new(luxel_profile *profile, const luxel_profile *minus);
void app_curve_free(AppCurve *curve); /* NULL is harmless */

#endif
