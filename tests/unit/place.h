/* SPDX-License-Identifier: MIT */
/* What the tests of the sink share: a folder of its own for each case, files in it, and processes. */
#ifndef TEST_PLACE_H
#define TEST_PLACE_H

/* cmocka.h asks for the next four. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdbool.h>

#include "base/sink.h"

enum { NOBODY = 65534, CANNOT_TRY = 77 }; /* a user without privileges; how a child says that it could not try */

struct place {
    char folder[32];
    char file[64]; /* a path in it */
};

/* Set-up and tear-down of a case; the folder's files are removed, whatever they are. */
int make_place(void **state);
int remove_place(void **state);

/* How many files the folder has, hidden ones included. */
int entries(const struct place *place);

/* Writes a file without a sink, and compares one. */
void put(const char *path, const char *text);
void assert_content(const char *path, const char *text);

/* The real system, with or without unnamed files. */
struct lx_sink_system make_system(bool unnamed);

/* Writes a text through a sink. */
luxel_status sink_text(const char *path, const struct lx_sink_system *system, const char *text,
                       luxel_diagnostics *diagnostics);

/* Runs a part of a test in a process of its own; returns how that ended. */
int in_child(void (*part)(const struct place *), const struct place *place);

/* Each promise that does not depend on how the file is made is tried in both ways. */
#define BOTH_WAYS(name)                                                                                                \
    static void test_##name##_unnamed(void **state)                                                                    \
    {                                                                                                                  \
        name(*state, true);                                                                                            \
    }                                                                                                                  \
    static void test_##name##_hidden(void **state)                                                                     \
    {                                                                                                                  \
        name(*state, false);                                                                                           \
    }
#define CASE(name) cmocka_unit_test_setup_teardown(test_##name, make_place, remove_place)
#define CASES(name) CASE(name##_unnamed), CASE(name##_hidden)

#endif
