/* SPDX-License-Identifier: MIT */
/* Scenes for tests: small texts, changed word by word, and what is said about them. */
#ifndef TESTS_UNIT_SCENES_H
#define TESTS_UNIT_SCENES_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <luxel/luxel.h>

/* A scene without an error and without advice. */
extern const char good_scene[];

/* The good scene with the first `old` in it replaced; free it with free(). */
char *changed(const char *old, const char *new_words);

/* Reads and commits a text; where it cannot be read, *scene is NULL.  Returns the status of the last call made. */
luxel_status load(const char *text, luxel_diagnostics *diagnostics, luxel_scene **scene);

/* A built-in scene, committed. */
luxel_scene *builtin(const char *name);

/* A text of several lines, a built-in scene by its name, or the variant of a number, with some changes made
 * (NULL: none), committed. */
luxel_scene *opened_with(const char *name, const char *const *changes, size_t count);

/* What an error must look like: NULL and 0 for what does not matter. */
struct expected {
    const char *id;
    unsigned line, column;
    const char *key;
    const char *message; /* a part of it */
    const char *hint;    /* a part of it */
    char end;            /* nothing: see below */
};

/* So described, in order or by name, the rest not mattering (the last member keeps compilers from asking for it). */
#define WANTED(...) ((struct expected){__VA_ARGS__, .end = 0})

/* Asserts that entry i is as expected. */
void expect_entry(const luxel_diagnostics *diagnostics, size_t i, struct expected expected);

/* Asserts that the good scene, so changed, or its picture, has exactly one error, as expected. */
void expect_error(const char *old, const char *new_words, struct expected expected);

/* Asserts that the scene of the text, or its picture, has exactly one error, as expected. */
void expect_text_error(const char *text, struct expected expected);

#endif
