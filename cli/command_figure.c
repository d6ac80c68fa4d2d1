/* SPDX-License-Identifier: MIT */
/* luxel figure: a picture for people.  What it does is in draw/. */
#include "cli.h"
#include "drawing.h"

const struct command command_figure = {
    .name = "figure",
    .bit = COMMAND_FIGURE,
    .operand = N_("SCENE"),
    .endings = ".png .svg .pdf",
    .summary = N_("draw a figure: false colour with axes, isophotes and sections"),
    .description = N_("Draws the picture of the scene for people: in false colour with a colour bar in the unit of the "
                      "values, axes in mm, labelled isophotes, the outlines of the surfaces, the points and the true "
                      "maximum, and below it, if wanted, the plots of two sections.  "
                      "With --grid it draws a measuring plane instead: its irradiance in false colour with isolux "
                      "lines, the values at its points and where lights stand before it; with --daylight its "
                      "daylight factors in percent instead."),
    .examples = "luxel figure -o figure.pdf\n"
                "luxel figure my.yaml -o figure.svg --palette cividis --levels 5 --section=maximum\n"
                "luxel figure office --grid floor -o floor.pdf\n"
                "luxel figure room.yaml --grid desk --daylight -o factors.svg\n"
                "luxel figure my.yaml -o slide.png --dark --width 300 --title 'Two lamps'",
    .run = drawing_figure,
};
