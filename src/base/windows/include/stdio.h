/* SPDX-License-Identifier: MIT */
/* Header <stdio.h> with what Windows lacks: streams into memory, texts that are allocated, long paths. */
#ifndef LX_WINDOWS_STDIO_H
#define LX_WINDOWS_STDIO_H

#include_next <stdio.h>

#include <stdarg.h>

/* Ended by fclose() alone, which sets *bytes and *size. */
FILE *open_memstream(char **bytes, size_t *size);
int lx_windows_fclose(FILE *stream);
int lx_windows_vasprintf(char **text, const char *format, va_list arguments);
int lx_windows_asprintf(char **text, const char *format, ...);

FILE *lx_windows_fopen(const char *path, const char *mode);
int lx_windows_rename(const char *from, const char *to);
int renameat(int from_folder, const char *from, int to_folder, const char *to);

#define fclose lx_windows_fclose
#define fopen lx_windows_fopen
#define rename lx_windows_rename
#define vasprintf lx_windows_vasprintf
#define asprintf lx_windows_asprintf

#endif
