/* SPDX-License-Identifier: MIT */
/*
 * Parameters: every key of a scene with its type, unit, default, ranges and meaning, for help texts, forms
 * and references; the kinds of surfaces and lights; and all of it as a JSON Schema for editors.  A list is the
 * caller's and never changes, so several threads may read it; every pointer in it lives as long as the list.
 */
#ifndef LUXEL_PARAMETER_H
#define LUXEL_PARAMETER_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One key of a scene; the texts are English, in UTF-8. */
/* What must hold between a key and another one of the same mapping. */
typedef enum luxel_rule_kind {
    LUXEL_RULE_EXCLUDES, /* the two must not both be given */
    LUXEL_RULE_NEEDED,   /* the key must be given where the other is one of the choices */
    LUXEL_RULE_USED,     /* the key has an effect only where the other is one of the choices */
    LUXEL_RULE_AT_MOST,  /* the key must not be greater than the other */
    LUXEL_RULE_DIFFERS,  /* the two, if both are given, must not be the same vector */
    LUXEL_RULE_POSITIVE  /* the key must be > 0 where the other is one of the choices */
} luxel_rule_kind;

typedef struct luxel_rule {
    luxel_rule_kind kind;
    const char *other;
    const char *choices; /* "lambertian, cosine", or NULL where the kind has none */
} luxel_rule;

typedef struct luxel_parameter {
    const char *path;          /* "screen.width", "lights[].intensity"; a list element is [] */
    const char *variant;       /* the type of surface or light it belongs to ("spot"), NULL for all */
    const char *type;          /* in words: "number", "whole number", "3 numbers", "one of", "yes or no", ... */
    const char *choices;       /* "nodes, centers", or NULL */
    const char *unit;          /* radiometric unit in UTF-8, "" where it has none */
    const char *default_value; /* as YAML; NULL where there is none */
    bool required;             /* whether a scene must write it */
    const char *legal;         /* the legal range in words, or NULL: any */
    const char *advised;       /* the advised range in words, or NULL: none */
    const char *meaning;       /* one sentence, English */
    const luxel_rule *rules;   /* rule_count of them */
    size_t rule_count;
} luxel_parameter;

/* One kind of surface or light: what the key `type` of a list's element may be. */
typedef struct luxel_kind {
    const char *list;    /* "surfaces" or "lights" */
    const char *name;    /* "spot" */
    const char *meaning; /* a few words, English */
    const char *example; /* an element of the list as YAML on one line */
} luxel_kind;

/* A list of parameters, owned by the caller; made by luxel_parameters_new(). */
typedef struct luxel_parameters luxel_parameters;

/* The list of all parameters, in the order of the scene file; NULL when memory is short. */
LUXEL_API luxel_parameters *luxel_parameters_new(void);
/* Frees the list and every text in it; NULL is harmless. */
LUXEL_API void luxel_parameters_free(luxel_parameters *parameters);

/* The number of parameters in the list. */
LUXEL_API size_t luxel_parameters_count(const luxel_parameters *parameters);
/* The i-th parameter, which lives as long as the list; NULL beyond the last. */
LUXEL_API const luxel_parameter *luxel_parameters_get(const luxel_parameters *parameters, size_t i);

/* How many kinds of surfaces and lights there are, and the i-th of them (NULL beyond the last). */
LUXEL_API size_t luxel_parameters_kind_count(const luxel_parameters *parameters);
LUXEL_API const luxel_kind *luxel_parameters_kind(const luxel_parameters *parameters, size_t i);

/*
 * The JSON Schema (draft-07) of scene files, for editors: the keys with their types, ranges, defaults, meanings and
 * the rules between them.  What a schema cannot say is listed in its "$comment".  The text is the caller's: free it
 * with luxel_text_free().  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_schema(char **text);

#ifdef __cplusplus
}
#endif
#endif
