/* SPDX-License-Identifier: MIT */
/* Verdicts by the limits of a scene: of its grids and, where they are asked for, of its observers. */
#ifndef LUXEL_CLI_GRID_LIMITS_H
#define LUXEL_CLI_GRID_LIMITS_H

#include <luxel/luxel.h>

#include "json.h"
#include "load.h"

/* The limits of one grid or observer. */
struct judged {
    luxel_limit list[2 * LUXEL_MOST_LIMITS];
    size_t count;
};

struct judged limits_of_grid(const luxel_scene *scene, size_t i, const luxel_grid *grid);

/* "average at least 500 lx: 517.38 ± 0.21, pass", line by line; nothing where there are none. */
void limits_print(const struct judged *judged, const char *unit);
/* The array "limits"; nothing where there are none. */
void limits_write(struct json *json, const struct judged *judged);

/* The observers of a scene, rated and judged. */
struct observers {
    const luxel_scene *scene;
    luxel_glare **list;
    struct judged *judged;
    size_t count;
};

/* Rates them; observers_clear() is due in every case. */
luxel_status observers_rate(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct observers *observers);
void observers_print(const struct observers *observers);
/* The array "observers". */
void observers_write(struct json *json, const struct observers *observers);
void observers_clear(struct observers *observers);

/* Whether there is something to judge, and observers can be rated; else that is told. */
bool limits_can_judge(const struct loaded *loaded);

/* Whether all limits are kept for certain. */
bool limits_all_pass(const luxel_scene *scene, const luxel_grid *const *grids, size_t count,
                     const struct observers *observers);

#endif
