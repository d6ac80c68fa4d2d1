/* SPDX-License-Identifier: MIT */
/* A function that the linker puts in place of one of the library's (--wrap): its head, and the original behind it. */
#ifndef TESTS_UNIT_WRAPPED_H
#define TESTS_UNIT_WRAPPED_H

/* The head of the function that stands in; REAL(name)(...) calls the one that it stands in for.  The names with two
 * underscores are the linker's. */
#define REAL(name) __real_##name
#define WRAPPED(type, name, ...)                                                                                       \
    type __real_##name(__VA_ARGS__); /* NOLINT */                                                                      \
    type __wrap_##name(__VA_ARGS__); /* NOLINT */                                                                      \
    type __wrap_##name(__VA_ARGS__)  /* NOLINT */

#endif
