/* SPDX-License-Identifier: MIT */
/* Recent files: the scenes that were opened and saved, as the desktop remembers them. */
#ifndef LUXEL_APP_RECENT_H
#define LUXEL_APP_RECENT_H

#include <glib.h>

enum { APP_MOST_RECENT = 10 };

void app_recent_add(const char *path);

/* Those that are still there, the latest first, NULL-terminated; the caller's, g_strfreev(). */
char **app_recent_paths(void);

#endif
