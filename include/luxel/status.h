/* SPDX-License-Identifier: MIT */
/*
 * What a call of the library ends with.  A function that can fail returns a luxel_status and, where it
 * takes a luxel_diagnostics, puts the details there; its out-parameters are set only on LUXEL_OK.
 */
#ifndef LUXEL_STATUS_H
#define LUXEL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

/* Marks the functions that the shared library exports. */
#if defined(__GNUC__)
#define LUXEL_API __attribute__((visibility("default")))
#else
#define LUXEL_API
#endif

/* Success, or the kind of failure. */
typedef enum luxel_status {
    LUXEL_OK = 0,         /* done */
    LUXEL_ERROR_ARGUMENT, /* the call itself is wrong: a missing pointer, a setting out of its range */
    LUXEL_ERROR_PATH,     /* a key path names no key or element, or an assignment has no '=' */
    LUXEL_ERROR_SCENE,    /* the scene has errors */
    LUXEL_ERROR_FILE,     /* a file could not be read or written */
    LUXEL_ERROR_MEMORY,   /* out of memory, or the picture would not fit in it */
    LUXEL_ERROR_RANGE,    /* a brightness is too large for the precision asked for */
    LUXEL_CANCELLED       /* the progress callback asked to stop */
} luxel_status;

#ifdef __cplusplus
}
#endif
#endif
