/* SPDX-License-Identifier: MIT */
/* Endings of files' names. */
#include "ending.h"

#include <string.h>
#include <strings.h>

#include "diagnostics.h"
#include "path.h"
#include "text.h"

luxel_status lx_find_ending(const char *path, const char *const *endings, size_t count, luxel_diagnostics *diagnostics,
                            size_t *found)
{
    const char *name = lx_path_name(path), *dot = strrchr(name, '.');
    const char *ending = dot && dot != name ? dot : NULL;
    struct lx_text known = {0};
    for (*found = 0; *found < count; ++*found) {
        if (ending && strcasecmp(ending, endings[*found]) == 0) {
            lx_text_clear(&known);
            return LUXEL_OK;
        }
        lx_text_puts(&known, *found > 0 ? ", " : "");
        lx_text_puts(&known, endings[*found]);
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, ending ? LX_MSG_UNKNOWN_ENDING : LX_MSG_NO_ENDING,
              LX_ARGS(path, ending));
    if (known.bytes)
        lx_hint(diagnostics, LX_MSG_KNOWN_ENDINGS, LX_ARGS(known.bytes));
    lx_text_clear(&known);
    return LUXEL_ERROR_ARGUMENT;
}

bool lx_has_ending(const char *path, const char *ending)
{
    const size_t length = strlen(path), wanted = strlen(ending);
    return length >= wanted && strcasecmp(path + length - wanted, ending) == 0;
}
