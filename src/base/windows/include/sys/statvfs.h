/* SPDX-License-Identifier: MIT */
/* Header <sys/statvfs.h>, as far as it tells how much room there is. */
#ifndef LX_WINDOWS_SYS_STATVFS_H
#define LX_WINDOWS_SYS_STATVFS_H

struct statvfs {
    unsigned long long f_bavail, f_frsize;
};

int fstatvfs(int folder, struct statvfs *about);

#endif
