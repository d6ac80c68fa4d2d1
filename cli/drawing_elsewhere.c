/* SPDX-License-Identifier: MIT */
/* The commands that draw, handed to luxel-draw. */
#include "drawing.h"

#include "../front/language.h"
#include "cli.h"
#include "elsewhere.h"
#include "message.h"

static int draw(const struct options *options)
{
    const int reason = elsewhere_run("luxel-draw", options->arguments);

    message_error(_("luxel %s cannot run luxel-draw, which draws: %s"), options->command->name,
                  language_reason(reason));
    message_hint(_("install Luxel with its drawings, or build it where cairo and pango are"));
    return EXIT_FILE;
}

int drawing_figure(const struct options *options)
{
    return draw(options);
}

int drawing_report(const struct options *options)
{
    return draw(options);
}

int drawing_photometry(const struct options *options)
{
    return draw(options);
}
