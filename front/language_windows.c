/* SPDX-License-Identifier: MIT */
/*
 * The user's language on Windows, whose catalogue is in the program, and a console that shows it.  LANGUAGE, LC_ALL,
 * LC_MESSAGES or LANG choose it as elsewhere; without them the language of Windows does.
 */
#include "language.h"

#include <fcntl.h>
#include <io.h>
#include <libintl.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "words.h"

/* A catalogue as msgfmt makes it: a head of words, then sorted tables of lengths and places of the texts. */
enum { HEAD_COUNT = 2, HEAD_TEXTS = 3, HEAD_TRANSLATIONS = 4 };

/* po/ru.po, as msgfmt makes it. */
extern const unsigned char language_russian[];

static const unsigned char *catalogue; /* NULL: messages stay English */

static uint32_t word_at(size_t place)
{
    uint32_t word;

    memcpy(&word, catalogue + place, sizeof word);
    return word;
}

static const char *text_at(size_t table, size_t i)
{
    return (const char *)catalogue + word_at(word_at(4 * table) + 8 * i + 4);
}

/* The translation of a text, in all its forms; NULL: there is none. */
static const char *find(const char *text)
{
    size_t first = 0, end = catalogue && *text ? word_at(4 * HEAD_COUNT) : 0;

    while (first < end) {
        const size_t middle = first + (end - first) / 2;
        const int order = strcmp(text, text_at(HEAD_TEXTS, middle));

        if (order == 0)
            return text_at(HEAD_TRANSLATIONS, middle);
        if (order < 0)
            end = middle;
        else
            first = middle + 1;
    }
    return NULL;
}

const char *lx_windows_gettext(const char *text)
{
    const char *found = find(text);

    return found ? found : text;
}

/* Russian's forms: 1 луч, 2 луча, 5 лучей. */
static unsigned russian_form(unsigned long number)
{
    const unsigned long ten = number % 10, hundred = number % 100;

    if (ten == 1 && hundred != 11)
        return 0;
    return ten >= 2 && ten <= 4 && (hundred < 10 || hundred >= 20) ? 1 : 2;
}

const char *lx_windows_ngettext(const char *one, const char *many, unsigned long number)
{
    const char *found = find(one);

    if (!found)
        return number == 1 ? one : many;
    for (unsigned form = russian_form(number); form > 0; form--)
        found += strlen(found) + 1;
    return found;
}

/* The first language that the environment names; NULL: none. */
static const char *wanted_language(void)
{
    static const char *const names[] = {"LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"};

    for (size_t i = 0; i < COUNT_OF(names); i++) {
        const char *value = getenv(names[i]);

        if (value && *value)
            return value;
    }
    return NULL;
}

/* Shows UTF-8 and colours, and changes no line's end. */
static void prepare_streams(void)
{
    const DWORD streams[] = {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE};
    DWORD mode;

    for (int i = 0; i < 3; i++)
        _setmode(i, _O_BINARY);
    SetConsoleOutputCP(CP_UTF8);
    for (size_t i = 0; i < COUNT_OF(streams); i++)
        if (GetConsoleMode(GetStdHandle(streams[i]), &mode))
            SetConsoleMode(GetStdHandle(streams[i]), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

void language_begin(void)
{
    const char *wanted = wanted_language();

    prepare_streams();
    if (wanted ? strncmp(wanted, "ru", 2) == 0 : PRIMARYLANGID(GetUserDefaultUILanguage()) == LANG_RUSSIAN)
        catalogue = language_russian;
}

const char *language_reason(int number)
{
    return gettext(strerrordesc_np(number));
}
