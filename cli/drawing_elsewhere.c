/* SPDX-License-Identifier: MIT */
/*
 * The commands that draw, handed to luxel-draw: the one beside this program, as it stands where it was built, or the
 * one that was installed with it, wherever that was moved.
 */
#include <errno.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

#include "../front/language.h"
#include "cli.h"
#include "drawing.h"
#include "message.h"

#define NAME "luxel-draw"

/* The program at a place relative to this one's folder, if this one's place is known. */
static void try_relative(const char *place, char *const *arguments)
{
    char path[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);

    while (length > 0 && path[length - 1] != '/')
        length--;
    if (length > 0 && (size_t)length + strlen(place) < sizeof path) {
        strcpy(path + length, place);
        execv(path, arguments);
    }
}

static int draw(const struct options *options)
{
    try_relative(NAME, options->arguments);
    try_relative("../libexec/luxel/" NAME, options->arguments);
    execv(LUXEL_LIBEXECDIR "/" NAME, options->arguments);
    message_error(_("luxel %s cannot run luxel-draw, which draws: %s"), options->command->name, language_reason(errno));
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
