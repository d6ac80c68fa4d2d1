/* SPDX-License-Identifier: MIT */
/* The arguments of luxel sweep's options. */
#include "sweep_options.h"

#include <stdlib.h>
#include <string.h>

#include "argument.h"
#include "cli.h"
#include "message.h"

bool sweep_take_workers(struct options *options, const char *argument)
{
    return argument_whole("--workers", argument, 1, 1024, &options->sweep.workers);
}

bool sweep_take_show(struct options *options, const char *argument)
{
    unsigned scene;
    const bool good = argument_whole("--show", argument, 0, UINT32_MAX, &scene);

    options->sweep.show = good ? scene : 0;
    return good;
}

/* I/N: I of N, from 0 or from 1 on. */
bool sweep_take_shard(struct options *options, const char *argument)
{
    const char *slash = strchr(argument, '/');
    char *part = slash ? strndup(argument, (size_t)(slash - argument)) : NULL;
    bool good = part && argument_whole("--shard", part, 0, 65535, &options->sweep.part) &&
                argument_whole("--shard", slash + 1, 1, 65535, &options->sweep.parts);

    if (!slash)
        message_error(_("--shard must be I/N, part I of N: \"%s\""), argument);
    free(part);
    if (good && options->sweep.part > options->sweep.parts) {
        message_error(_("--shard %s: there is no part %u of %u"), argument, options->sweep.part, options->sweep.parts);
        good = false;
    }
    if (good)
        options->sweep.part %= options->sweep.parts;
    return good;
}
