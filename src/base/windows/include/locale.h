/* SPDX-License-Identifier: MIT */
/* Header <locale.h> with what Windows lacks.  Programs there keep the "C" locale, so its objects have nothing to do. */
#ifndef LX_WINDOWS_LOCALE_H
#define LX_WINDOWS_LOCALE_H

#include_next <locale.h>

typedef int locale_t;

enum { LC_ALL_MASK = 1 };

#define newlocale(mask, name, base) ((void)(mask), (void)(name), (base))

static inline locale_t uselocale(locale_t locale)
{
    return locale;
}

#define freelocale(locale) ((void)(locale))
#define strtod_l(text, end, locale) ((void)(locale), strtod(text, end))

#endif
