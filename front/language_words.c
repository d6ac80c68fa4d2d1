/* SPDX-License-Identifier: MIT */
/* Words of the user's language, which are the same wherever its catalogue lies. */
#include "language.h"

#include <libintl.h>
#include <string.h>

#include "words.h"

const char *language_translate(const char *english, void *data)
{
    (void)data;
    return gettext(english);
}

const char *language_code(void)
{
    /* TRANSLATORS: the code of your language by BCP 47, such as ru */
    return _("en");
}

char language_decimal_mark(void)
{
    static const char mark[] = "decimal point";

    /* TRANSLATORS: to be translated where your language has a comma there, and left out where it has a point */
    return strcmp(_("decimal point"), mark) == 0 ? '.' : ',';
}
