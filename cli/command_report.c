/* SPDX-License-Identifier: MIT */
/* luxel report: what the exercise asks students to hand in, or a lighting designer hands over.  See draw/. */
#include "cli.h"
#include "drawing.h"

const struct command command_report = {
    .name = "report",
    .bit = COMMAND_REPORT,
    .operand = N_("SCENE"),
    .endings = ".pdf .html .md .tex .csv",
    .summary = N_("write the report of the exercise, or of a lighting design"),
    .description = N_("Writes the report that the exercise asks for: the task with its parameters, the formulas of "
                      "exactly the conventions that were used, the pictures, the sections, the table of points, the "
                      "extrema, conclusions, and the scene to reproduce them. A .html is one file without "
                      "outside links, and a .csv has the tables alone. With --for lighting it is what a lighting "
                      "designer hands over: the limits with "
                      "their verdicts, the plan, the luminaires with totals, each measuring grid as figure and table, "
                      "the glare of observers, the light on surfaces, and the conventions."),
    .examples = "luxel report -o report.pdf --author 'A. Student' --group 4321\n"
                "luxel report my.yaml -o report.html --title 'Laboratory work 4'\n"
                "luxel report office.yaml --for lighting -o office.pdf -o tables.csv",
    .run = drawing_report,
};
