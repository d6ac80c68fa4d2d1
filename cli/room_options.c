/* SPDX-License-Identifier: MIT */
/* The arguments of the options of luxel room and luxel arrange; how far numbers may go the library says. */
#include "room_options.h"

#include <math.h>

#include "argument.h"
#include "cli.h"
#include "message.h"

bool room_take_array(struct options *options, const char *argument)
{
    double numbers[2];

    if (!argument_numbers("--array", "N,M", argument, numbers, 2))
        return false;
    for (int i = 0; i < 2; i++) {
        if (!(numbers[i] >= 1.0 && numbers[i] <= 1000.0 && numbers[i] == floor(numbers[i]))) {
            message_error(_("--array %s: expected two whole numbers from 1 to 1000"), argument);
            return false;
        }
        options->room.array[i] = (unsigned)numbers[i];
    }
    return true;
}

bool room_take_target(struct options *options, const char *argument)
{
    if (!argument_number("--target", argument, &options->room.target))
        return false;
    if (options->room.target > 0.0)
        return true;
    message_error(_("--target %s: expected a number above 0"), argument);
    return false;
}

bool room_take_reflectances(struct options *options, const char *argument)
{
    return argument_numbers("--reflectances", "C,W,F", argument, options->room.reflectances, 3);
}

bool room_take_plane(struct options *options, const char *argument)
{
    return argument_number("--plane", argument, &options->room.plane_m);
}

bool room_take_maintenance(struct options *options, const char *argument)
{
    return argument_number("--maintenance", argument, &options->room.maintenance);
}

bool arrange_take_goal(struct options *options, const char *argument)
{
    options->arrange.goals[options->arrange.goal_count++] = argument;
    return true;
}

bool arrange_take_most(struct options *options, const char *argument)
{
    return argument_whole("--most", argument, 1, 10000, &options->arrange.most);
}
