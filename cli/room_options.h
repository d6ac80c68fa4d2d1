/* SPDX-License-Identifier: MIT */
/* The options of luxel room and luxel arrange, as the table of options takes them. */
#ifndef LUXEL_CLI_ROOM_OPTIONS_H
#define LUXEL_CLI_ROOM_OPTIONS_H

#include "options.h"

bool room_take_array(struct options *options, const char *argument);
bool room_take_target(struct options *options, const char *argument);
bool room_take_reflectances(struct options *options, const char *argument);
bool room_take_plane(struct options *options, const char *argument);
bool room_take_maintenance(struct options *options, const char *argument);
bool arrange_take_goal(struct options *options, const char *argument);
bool arrange_take_most(struct options *options, const char *argument);

#endif
