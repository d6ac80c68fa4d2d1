/* SPDX-License-Identifier: MIT */
/* Header <libintl.h>, as front/language_windows.c has it: the catalogues are in the program. */
#ifndef LX_WINDOWS_LIBINTL_H
#define LX_WINDOWS_LIBINTL_H

const char *lx_windows_gettext(const char *text);
const char *lx_windows_ngettext(const char *one, const char *many, unsigned long number);

#define gettext lx_windows_gettext
#define ngettext lx_windows_ngettext

#endif
