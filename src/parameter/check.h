/* SPDX-License-Identifier: MIT */
/*
 * For the check() of a table: what no rule can say about the keys of a mapping, such as corners that lie in no plane
 * or a file that is not there, reported where the user wrote it.
 */
#ifndef LX_PARAMETER_CHECK_H
#define LX_PARAMETER_CHECK_H

#include "../base/source.h"
#include "../format/kept.h"
#include "decode.h"

#define LX_ALL_OF_IT SIZE_MAX

/*
 * Reports an error at the value of `key`, or at element `element` of it (LX_ALL_OF_IT: at all of it); where the key is
 * not written, at its mapping.  {0} is the key; `arguments`, as lx_report() takes them, are {1}, {2} ...
 */
void lx_check_report(const struct lx_check *check, const char *key, size_t element, enum lx_message message,
                     const char *const *arguments);

/* Reports advice at all of the key's value. */
void lx_check_advise(const struct lx_check *check, const char *key, enum lx_message message,
                     const char *const *arguments);

/* Gives that report a hint. */
void lx_check_hint(const struct lx_check *check, enum lx_message message, const char *const *arguments);

/* Reports a key `up` that was given and is parallel to the axis (of any length but 0). */
void lx_check_pose(const struct lx_check *check, const double axis[3], const double up[3]);

/* The path of a file that a scene names: from the folder of the walk on, or built-in.  NULL where memory ran out. */
char *lx_check_path(const struct lx_check *check, const char *file);

/*
 * What the scene has read of a path already, as the kind that `free` frees: one more user of it.  NULL: nothing; then
 * lx_check_keep() is to get what is read, and becomes one more user of it.
 */
struct lx_kept *lx_check_kept(const struct lx_check *check, const char *path, void (*free)(struct lx_kept *kept));
void lx_check_keep(const struct lx_check *check, const char *path, struct lx_kept *kept);

/*
 * A file of at most `most` bytes that the value of `key` names, to close with lx_check_close().  NULL: it cannot be
 * read or is too large, which is reported there, or memory ran out.
 */
struct lx_source *lx_check_open(const struct lx_check *check, const char *key, const char *path, size_t most);

/* Closes it (NULL is harmless); false where not all that was asked for could be read, which is reported at the key. */
bool lx_check_close(const struct lx_check *check, const char *key, struct lx_source *source);

/*
 * The text of a file of at most `most` bytes that the value of `key` names, with a 0 byte behind it: the caller's.
 * NULL: it cannot be read or is too large, which is reported there, or memory ran out.
 */
char *lx_check_read(const struct lx_check *check, const char *key, const char *path, size_t most, size_t *length);

#endif
