/* SPDX-License-Identifier: MIT */
/* Header <stdio.h> with what Windows lacks: streams into memory, and texts that are allocated. */
#ifndef LX_WINDOWS_STDIO_H
#define LX_WINDOWS_STDIO_H

#include_next <stdio.h>

#include <stdarg.h>

/* Ended by fclose() alone, which sets *bytes and *size. */
FILE *open_memstream(char **bytes, size_t *size);
int lx_windows_fclose(FILE *stream);
int lx_windows_vasprintf(char **text, const char *format, va_list arguments);
int lx_windows_asprintf(char **text, const char *format, ...);

#define fclose lx_windows_fclose
#define vasprintf lx_windows_vasprintf
#define asprintf lx_windows_asprintf

#endif
