/* SPDX-License-Identifier: MIT */
/* The time that has gone. */
#ifndef LUXEL_CLI_CLOCK_H
#define LUXEL_CLI_CLOCK_H

/* Seconds of a clock that only goes forward. */
double clock_seconds(void);

#endif
