/* SPDX-License-Identifier: MIT */
/* Header <string.h> with what Windows lacks. */
#ifndef LX_WINDOWS_STRING_H
#define LX_WINDOWS_STRING_H

#include_next <string.h>

char *lx_windows_strdup(const char *text);
char *lx_windows_strndup(const char *text, size_t most);
char *strsep(char **rest, const char *separators);
char *stpcpy(char *restrict to, const char *restrict from);
void *memrchr(const void *bytes, int wanted, size_t length);
const char *strerrordesc_np(int number);

/* GNU's, which changes nothing. */
const char *lx_windows_basename(const char *path);
#define basename lx_windows_basename

#undef strdup
#undef strndup
#define strdup lx_windows_strdup
#define strndup lx_windows_strndup

#endif
