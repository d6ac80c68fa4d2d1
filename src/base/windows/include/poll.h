/* SPDX-License-Identifier: MIT */
/* Header <poll.h>, as far as it tells whether the reader of a pipe has left. */
#ifndef LX_WINDOWS_POLL_H
#define LX_WINDOWS_POLL_H

enum { POLLOUT = 4, POLLERR = 8, POLLHUP = 16 };

struct pollfd {
    int fd;
    short events, revents;
};

/* One file, without waiting. */
int poll(struct pollfd *files, unsigned count, int timeout_ms);

#endif
