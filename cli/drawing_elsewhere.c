/* SPDX-License-Identifier: MIT */
/*
 * The commands that draw, handed to luxel-draw: the one beside this program, as it stands where it was built, or else
 * the installed one.
 */
#include <errno.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

#include "cli.h"
#include "drawing.h"
#include "language.h"
#include "message.h"

#define NAME "/luxel-draw"

/* The program beside this one; false if this one's place is not known. */
static bool neighbour(char path[PATH_MAX + sizeof NAME])
{
    const ssize_t length = readlink("/proc/self/exe", path, PATH_MAX);
    char *slash;

    if (length <= 0 || length >= PATH_MAX)
        return false;
    path[length] = '\0';
    slash = strrchr(path, '/');
    if (!slash)
        return false;
    strcpy(slash, NAME);
    return true;
}

static int draw(const struct options *options)
{
    char path[PATH_MAX + sizeof NAME];

    if (neighbour(path))
        execv(path, options->arguments);
    execv(LUXEL_LIBEXECDIR NAME, options->arguments);
    message_error(_("luxel %s cannot run luxel-draw, which draws: %s"), options->command->name, language_reason(errno));
    message_hint(_("install the library luxel-figure with its program, or build Luxel where cairo and pango are"));
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
