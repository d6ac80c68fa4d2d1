/* SPDX-License-Identifier: MIT */
/* Measuring grids by their names or numbers. */
#include "grid_named.h"

#include <string.h>

#include "cli.h"
#include "message.h"
#include "text.h"

size_t grid_named(const char *wanted, const struct loaded *loaded)
{
    enum { MOST_NAMES = 64 };
    const size_t count = luxel_scene_grid_count(loaded->scene);
    const char *names[MOST_NAMES];
    size_t named = 0, found = 0;
    char number[TEXT_SIZE];

    for (size_t i = 0; i < count; i++) {
        const char *name = luxel_scene_grid_name(loaded->scene, i);

        if (name && strcmp(name, wanted) == 0)
            found = found > 0 ? found : i + 1;
        if (name && named < MOST_NAMES)
            names[named++] = name;
    }
    for (size_t i = 0; i < count && found == 0; i++)
        if (strcmp(text_format(number, "%zu", i + 1), wanted) == 0)
            found = i + 1;
    if (found > 0)
        return found;
    const char *nearest = luxel_nearest_word(wanted, names, named);
    message_error(_("--grid %s: %s has no measuring grid of this name or number"), wanted, loaded->name);
    if (count == 0)
        message_hint(_("add some under the key grids, or try %s"),
                     "-s 'grids=[{center: [0,0,0], size: [1000,1000], n: [10,10]}]'");
    else if (nearest)
        message_did_you_mean(nearest);
    else
        message_hint(_("its grids are numbered from 1 to %zu; luxel grid %s shows them"), count, loaded->name);
    return 0;
}
