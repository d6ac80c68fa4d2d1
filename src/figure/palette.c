/* SPDX-License-Identifier: MIT */
/* Palettes: their names and the colour at any place of them. */
#include <luxel/figure.h>

#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "palette_tables.h"
#include "palette_turbo.h"

struct palette {
    const char *name, *meaning;
    const unsigned char (*colors)[3]; /* NULL: grey */
};

static const struct palette palettes[] = {
    {"viridis", LX_N("blue over green to yellow, even to the eye and to those who are colour-blind"), viridis_colors},
    {"cividis", LX_N("blue to yellow, the same to those who are colour-blind"), cividis_colors},
    {"inferno", LX_N("black over red to pale yellow, even to the eye"), inferno_colors},
    {"magma", LX_N("black over purple to pale pink, even to the eye"), magma_colors},
    {"plasma", LX_N("blue over red to yellow, even to the eye"), plasma_colors},
    {"coolwarm", LX_N("blue over grey to red, for values on both sides of a middle"), coolwarm_colors},
    {"turbo", LX_N("blue over green to red, the rainbow that shows most steps, not even to the eye"), turbo_colors},
    {"grey", LX_N("black to white, as the exercise asks"), NULL},
};

enum { PALETTES = sizeof palettes / sizeof palettes[0] };

const char *luxel_palette_name(size_t i)
{
    return i < PALETTES ? palettes[i].name : NULL;
}

const char *luxel_palette_meaning(size_t i)
{
    return i < PALETTES ? palettes[i].meaning : NULL;
}

bool luxel_palette_color(const char *name, double t, double color[3])
{
    size_t found = 0;
    while (name && found < PALETTES && strcmp(palettes[found].name, name) != 0)
        found++;
    if (found == PALETTES)
        return false;
    t = t > 0 ? fmin(t, 1) : 0; /* no number is 0, too */
    double place = t * (LX_PALETTE_STEPS - 1);
    size_t step = (size_t)fmin(floor(place), LX_PALETTE_STEPS - 2);
    for (int i = 0; i < 3; i++) {
        const unsigned char(*colors)[3] = palettes[found].colors;
        double share = place - (double)step;
        color[i] = colors ? (colors[step][i] * (1 - share) + colors[step + 1][i] * share) / 255 : t;
    }
    return true;
}
