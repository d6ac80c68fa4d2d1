/* SPDX-License-Identifier: MIT */
/*
 * A row of a form: one value with its label, unit and control, all by the parameter table.  Values come and go as
 * YAML, the way the scene has them.
 *
 * A number has a field, and its label is dragged through the advised range; legal values beyond it are taken, marked.
 * What cannot be taken turns the field red, with the reason below it, and changes nothing.  A number that is a part of
 * a vector stands with the others in one line (vector.h), which has what is said of them.
 *
 * Signals: "edited" (value as YAML) when the user changed it; "reset" on a double click on the label; "menu" (widget)
 * when the menu of the row is wanted; "browse" when a file is to be chosen.
 */
#ifndef LUXEL_APP_ROW_H
#define LUXEL_APP_ROW_H

#include <gtk/gtk.h>
#include <luxel/parameter.h>

#include "scalar.h"

#define APP_TYPE_ROW (app_row_get_type())
G_DECLARE_FINAL_TYPE(AppRow, app_row, APP, ROW, GtkBox)

typedef enum AppRowKind {
    APP_ROW_NUMBER,
    APP_ROW_WHOLE,
    APP_ROW_SWITCH,
    APP_ROW_CHOICE,
    APP_ROW_RANGE,           /* one of the choices, or [low, high] */
    APP_ROW_CHOICE_OR_WHOLE, /* one of the choices, or a whole number */
    APP_ROW_TEXT,
    APP_ROW_DATE, /* a text whose label is dragged through the hours of the day; its field stands below the label, */
    APP_ROW_YAML  /* as that of others does that take their room */
} AppRowKind;

/* The purpose of a row; the texts are copied. */
typedef struct AppRowSpec {
    AppRowKind kind;
    const char *label, *unit, *meaning;
    const char *part;                     /* of a number of a vector: its short name, such as "x"; else NULL */
    const char *choices;                  /* "a, b, c" of APP_ROW_CHOICE */
    luxel_parameter_range legal, advised; /* of numbers */
    const char *advised_words;            /* or NULL */
    const char *hint;                     /* of a text: what is expected */
    const char *missing;                  /* of a number: what holds where none is given; NULL: nothing */
    gboolean is_file;                     /* a text that names a file, which can be chosen */
} AppRowSpec;

GtkWidget *app_row_new(const AppRowSpec *spec);

/* Shows a value, NULL for none; "edited" is not emitted.  A field that is being typed in is left alone. */
void app_row_set(AppRow *self, const char *yaml);
/* Marks the row as wrong, and says why; NULL: it is right. */
void app_row_set_fault(AppRow *self, const char *reason);
/* The text that was typed is not taken: it stays to be mended until the field is left. */
void app_row_refuse(AppRow *self, const char *reason);
/* Shows the value that holds in place of what was typed, which is forgotten; FALSE: there was nothing else. */
gboolean app_row_restore(AppRow *self);
/* The range in force, which a typed one begins with. */
void app_row_suggest(AppRow *self, double low, double high);
/* The note of a part, which stands below the line of its vector. */
GtkWidget *app_row_words(AppRow *self);
/* The unit's name. */
void app_row_set_unit(AppRow *self, const char *unit);
void app_row_set_label(AppRow *self, const char *label);
const char *app_row_label(const AppRow *self);

/* Names a control for those who do not see it, and the part of it that takes the keys, where that is another one. */
void app_name_control(GtkWidget *control, const char *name);

#endif
