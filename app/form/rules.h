/* SPDX-License-Identifier: MIT */
/* What the rules of the parameter table mean for a form: which keys are shown, and which edits belong together. */
#ifndef LUXEL_APP_RULES_H
#define LUXEL_APP_RULES_H

#include "edits.h"

/* The keys of one group or element: the table, and the path of the element in the document. */
typedef struct AppKeys {
    const AppDocument *document;
    const luxel_parameters *parameters;
    const char *type; /* of the element, or NULL */
    gsize index;      /* of the element */
} AppKeys;

/* The path of a parameter in the document: "lights[].intensity" of element 2 is "lights[2].intensity"; the caller's. */
char *app_keys_path(const AppKeys *keys, const luxel_parameter *parameter);
/* The parameter beside another one with this name, such as "k" beside "lights[].attenuation"; NULL: none. */
const luxel_parameter *app_keys_beside(const AppKeys *keys, const luxel_parameter *parameter, const char *name);
/* Whether a parameter is one of the element's type. */
gboolean app_keys_has(const AppKeys *keys, const luxel_parameter *parameter);
/* Whether a group of keys is there or not as a whole, and stands for nothing where it is not, such as an array. */
gboolean app_keys_is_optional(const AppKeys *keys, const luxel_parameter *group);
/* Whether its value has a say now. */
gboolean app_keys_is_shown(const AppKeys *keys, const luxel_parameter *parameter);

/*
 * What giving a parameter a value takes: the value, the keys that it makes necessary, square pixels.  `component` -1,
 * or which of its numbers it is.
 */
void app_keys_set(const AppKeys *keys, const luxel_parameter *parameter, int component, const char *yaml,
                  AppEdits *edits);

/* The keys that could be given instead of this one, such as radiance for intensity: names of keys beside it. */
GPtrArray *app_keys_instead(const AppKeys *keys, const luxel_parameter *parameter);
/* Gives another key instead of this one, with a value that keeps what it means where that is known. */
void app_keys_switch(const AppKeys *keys, const luxel_parameter *from, const luxel_parameter *to, AppEdits *edits);

#endif
