/* SPDX-License-Identifier: MIT */
/* The state of a file, which tells it from what it was, by Windows' record of it: volume, number, size, time. */
#include <stdint.h>
#include <stdlib.h>

#include "../base/builtin_file.h"
#include "../base/windows/files.h"
#include "kept.h"

/* Ticks of 100 ns after which the times of a file tell it from a later change. */
static const int64_t SETTLING = 2 * 10000000LL;

static int64_t ticks_of(FILETIME time)
{
    return (int64_t)((uint64_t)time.dwHighDateTime << 32 | time.dwLowDateTime);
}

struct lx_file_state lx_file_state_of(const char *path)
{
    struct lx_file_state state = {.is_known = false};
    BY_HANDLE_FILE_INFORMATION about;
    FILETIME now;
    if (lx_builtin_file_of(path))
        return (struct lx_file_state){.is_known = true}; /* it never changes */
    wchar_t *wide = lx_windows_wide(path);
    HANDLE file = wide ? CreateFileW(wide, 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL,
                                     OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, NULL)
                       : INVALID_HANDLE_VALUE;
    free(wide);
    if (file == INVALID_HANDLE_VALUE)
        return state;
    if (GetFileType(file) == FILE_TYPE_DISK && GetFileInformationByHandle(file, &about)) {
        GetSystemTimeAsFileTime(&now);
        const int64_t modified = ticks_of(about.ftLastWriteTime);
        state.is_known = ticks_of(now) - modified > SETTLING;
        state.modified_s = modified / 10000000;
        state.modified_ns = modified % 10000000 * 100;
        state.device = about.dwVolumeSerialNumber;
        state.inode = (uint64_t)about.nFileIndexHigh << 32 | about.nFileIndexLow;
        state.size = (int64_t)((uint64_t)about.nFileSizeHigh << 32 | about.nFileSizeLow);
    }
    CloseHandle(file);
    return state;
}
