/* SPDX-License-Identifier: MIT */
/* Parts of an explanation. */
#ifndef LUXEL_APP_EXPLAINED_H
#define LUXEL_APP_EXPLAINED_H

#include <glib.h>

/*
 * What a text of luxel_explain() says of a light, without its heading and without blank lines; the caller's.  NULL: it
 * says nothing of it, as there is no value, or the light is off.
 */
char *app_explained_light(const char *text, gsize light);

#endif
