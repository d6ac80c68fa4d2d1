/* SPDX-License-Identifier: MIT */
/* Header <sys/resource.h>, as far as it tells how much memory a process may take. */
#ifndef LX_WINDOWS_SYS_RESOURCE_H
#define LX_WINDOWS_SYS_RESOURCE_H

enum { RLIMIT_AS = 9 };

#define RLIM_INFINITY (~0ULL)

struct rlimit {
    unsigned long long rlim_cur;
};

/* The limit is what the machine has free, less a fifth. */
int getrlimit(int resource, struct rlimit *limit);

#endif
