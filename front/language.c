/* SPDX-License-Identifier: MIT */
/*
 * The user's language.  Only the locale's category of messages is set, so that neither numbers nor letters depend
 * on it.  Translations are UTF-8, as scenes are; where messages are wanted in another encoding the tool stays English.
 */
#include "language.h"

#include <langinfo.h>
#include <limits.h>
#include <locale.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "words.h"

static const char domain[] = "luxel";

/* What the environment asks for, such as "ru_RU.UTF-8"; NULL: nothing. */
static const char *wanted_locale(void)
{
    static const char *const names[] = {"LC_ALL", "LC_MESSAGES", "LANG"};

    for (size_t i = 0; i < COUNT_OF(names); i++) {
        const char *value = getenv(names[i]);

        if (value && *value)
            return value;
    }
    return NULL;
}

/*
 * Many machines lack the locale that their user asks for, since it has to be generated.  Catalogues need none: any
 * locale with UTF-8 will do, and LANGUAGE says which of them.
 */
static bool stand_in(void)
{
    const char *wanted = wanted_locale();
    const char *encoding = wanted ? strchr(wanted, '.') : NULL;

    if (!encoding || (strncasecmp(encoding, ".utf-8", 6) != 0 && strncasecmp(encoding, ".utf8", 5) != 0))
        return false;
    if (!setlocale(LC_MESSAGES, "C.UTF-8"))
        return false;
    /* An empty LANGUAGE counts as none. */
    const char *chosen = getenv("LANGUAGE");
    return (chosen && *chosen) || setenv("LANGUAGE", wanted, 1) == 0;
}

/* Whether a folder holds catalogues; the Russian one is always among them. */
static bool has_catalogues(const char *folder)
{
    char path[PATH_MAX];

    return snprintf(path, sizeof path, "%s/ru/LC_MESSAGES/%s.mo", folder, domain) < PATH_MAX && access(path, R_OK) == 0;
}

/* Beside the program, wherever it was moved (installed, or in the build folder); else where it was to be installed. */
static const char *find_catalogues(char folder[PATH_MAX])
{
    static const char *const places[] = {"/../share/locale", "/../../share/locale", "/../po"};
    char program[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    char *slash;

    program[length > 0 ? length : 0] = '\0';
    slash = strrchr(program, '/');
    if (!slash)
        return LUXEL_LOCALEDIR;
    *slash = '\0';
    for (size_t i = 0; i < COUNT_OF(places); i++)
        if (snprintf(folder, PATH_MAX, "%s%s", program, places[i]) < PATH_MAX && has_catalogues(folder))
            return folder;
    return LUXEL_LOCALEDIR;
}

void language_begin(void)
{
    char folder[PATH_MAX];
    const char *locale = setlocale(LC_MESSAGES, "");

    if (!locale && !stand_in())
        return;
    if (strcmp(setlocale(LC_MESSAGES, NULL), "C") == 0)
        return;
    if (strcmp(nl_langinfo(_NL_MESSAGES_CODESET), "UTF-8") != 0) {
        setlocale(LC_MESSAGES, "C");
        return;
    }
    bindtextdomain(domain, find_catalogues(folder));
    bind_textdomain_codeset(domain, "UTF-8");
    textdomain(domain);
}

const char *language_reason(int number)
{
    const char *english = strerrordesc_np(number);

    return english ? gettext(english) : _("unknown error");
}
