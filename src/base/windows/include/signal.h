/* SPDX-License-Identifier: MIT */
/* Header <signal.h> with what Windows lacks: a handler of Ctrl-C, which runs in a thread of its own there. */
#ifndef LX_WINDOWS_SIGNAL_H
#define LX_WINDOWS_SIGNAL_H

#include_next <signal.h>

#define SIGPIPE 13 /* which nothing raises there, nor the other */
#define SIGXFSZ 25

struct sigaction {
    void (*sa_handler)(int signal_number);
};

int sigaction(int signal_number, const struct sigaction *action, struct sigaction *before);

#endif
