/* SPDX-License-Identifier: MIT */
/* What the tests of the app share: documents, moments and shots of scenes, and waiting in the main loop. */
#ifndef TESTS_APP_SCENES_H
#define TESTS_APP_SCENES_H

/* cmocka.h asks for the next four. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../../app/files/document.h"
#include "../../app/picture/picture.h"

/* A document of a built-in scene, or of a text; the caller's, g_object_unref(). */
AppDocument *document_of_builtin(const char *name);
AppDocument *document_of_text(const char *text);

/* Changes a value in a step of its own, which must be possible. */
void set(AppDocument *document, const char *key, const char *value);

/* Asserts what a key has, as YAML. */
void assert_key(const AppDocument *document, const char *key, const char *value);

/* The document's scene, committed; the caller's.  Fails where it has faults. */
AppMoment *moment_of(const AppDocument *document);

/* A whole picture of the document's scene, computed at once; the caller's. */
AppShot *shot_of(const AppDocument *document, luxel_quantity quantity);

/* Lets the main loop run until `is_done`; fails after two minutes. */
void wait_until(gboolean (*is_done)(gpointer data), gpointer data);

/* Lets the main loop run so long. */
void run_for(guint milliseconds);

#endif
