/* SPDX-License-Identifier: MIT */
/*
 * Parameters: every key of a scene with its type, unit, default, ranges and meaning, for help texts, forms
 * and references; the kinds of surfaces and lights; and all of it as a JSON Schema for editors.  A list is the
 * caller's; every pointer in it lives as long as the list.
 */
#ifndef LUXEL_PARAMETER_H
#define LUXEL_PARAMETER_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/diagnostics.h>
#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What must hold between a key and another one of the same mapping. */
typedef enum luxel_parameter_rule_kind {
    LUXEL_RULE_EXCLUDES, /* the two must not both be given */
    LUXEL_RULE_NEEDED,   /* the key must be given where the other is one of the choices; where there are no choices,
                          * where the other is given */
    LUXEL_RULE_USED,     /* the key has an effect only where the other is one of the choices; where there are no
                          * choices, where the other is given */
    LUXEL_RULE_AT_MOST,  /* the key must not be greater than the other */
    LUXEL_RULE_DIFFERS,  /* the two, if both are given, must not be the same vector */
    LUXEL_RULE_POSITIVE, /* the key must be > 0 where the other is one of the choices */
    LUXEL_RULE_ONE_OF    /* exactly one of the choices, which are keys and this is one of them, must be given */
} luxel_parameter_rule_kind;

/* One such rule, as the key sees it that has the rule. */
typedef struct luxel_parameter_rule {
    luxel_parameter_rule_kind kind; /* what must hold */
    const char *other;              /* the other key's name; NULL of LUXEL_RULE_ONE_OF */
    const char *choices; /* words of the other key, "lambertian, cosine", or keys; NULL where the kind has none */
} luxel_parameter_rule;

/* What kind of value a key takes. */
typedef enum luxel_parameter_type {
    LUXEL_PARAMETER_NUMBER,          /* a number */
    LUXEL_PARAMETER_WHOLE_NUMBER,    /* a whole number, 0 or greater */
    LUXEL_PARAMETER_YES_OR_NO,       /* true or false */
    LUXEL_PARAMETER_CHOICE,          /* one of the choices */
    LUXEL_PARAMETER_TEXT,            /* a text */
    LUXEL_PARAMETER_NUMBERS,         /* a list of `count` numbers */
    LUXEL_PARAMETER_WHOLE_NUMBERS,   /* a list of `count` whole numbers */
    LUXEL_PARAMETER_CHOICE_OR_PAIR,  /* one of the choices, or [low, high] */
    LUXEL_PARAMETER_GROUP,           /* a mapping, whose keys are parameters of their own */
    LUXEL_PARAMETER_POINTS,          /* a list of pairs of numbers */
    LUXEL_PARAMETER_VECTORS,         /* a list of triples of numbers */
    LUXEL_PARAMETER_CHOICE_OR_WHOLE, /* one of the choices, or a whole number */
    LUXEL_PARAMETER_GROUPS,          /* a list of mappings, all with the same keys, which are parameters of their own */
    LUXEL_PARAMETER_VARIANTS,        /* the same with keys by each one's `type`: surfaces, lights */
    LUXEL_PARAMETER_ANY              /* of a study: whatever `meaning` says */
} luxel_parameter_type;

/* A range of numbers. */
typedef struct luxel_parameter_range {
    bool given;    /* false: any number */
    double low;    /* the least number; -infinity where there is none */
    double high;   /* the greatest number; infinity where there is none */
    bool low_open; /* the numbers are greater than low, which is not one of them */
} luxel_parameter_range;

/* One key of a scene; the texts are English unless the list was translated, in UTF-8. */
typedef struct luxel_parameter {
    const char *path;                  /* "screen.width", "lights[].intensity"; a list element is [] */
    const char *variant;               /* the type of surface or light it belongs to ("spot"), NULL for all */
    const char *type;                  /* in words: "number", "whole number", "3 numbers", "one of", "true or false" */
    const char *choices;               /* "centers, nodes", or NULL */
    const char *unit;                  /* radiometric unit in UTF-8, "" where it has none */
    const char *default_value;         /* as YAML; NULL where there is none */
    bool required;                     /* whether a scene must write it, where it writes what the key stands in */
    const char *legal;                 /* the legal range in words, or NULL: any */
    const char *advised;               /* the advised range in words, or NULL: none */
    const char *meaning;               /* one sentence */
    const luxel_parameter_rule *rules; /* what must hold between it and other keys: rule_count of them */
    size_t rule_count;                 /* how many rules it has */
    const char *label;                 /* a short name for forms, capitalised: "Radius" */
    luxel_parameter_type value_type;   /* what `type` says in words */
    unsigned count;                    /* how many numbers a value has, or each of a list of points; 1 of all others */
    luxel_parameter_range legal_range; /* of each number, in its unit */
    const char *photometric_unit;      /* the unit where the scene's `units` are photometric; "" where it has none */
    luxel_parameter_range
        advised_range[3]; /* for sliders: by number, the same for all where `advised` tells just one */
} luxel_parameter;

/* One kind of surface or light: what the key `type` of a list's element may be. */
typedef struct luxel_parameter_kind {
    const char *list;    /* "surfaces" or "lights" */
    const char *name;    /* "spot" */
    const char *meaning; /* a few words */
    const char *example; /* an element of the list as YAML on one line, or NULL */
} luxel_parameter_kind;

/* A list of parameters, owned by the caller; made by luxel_parameters_new(). */
typedef struct luxel_parameters luxel_parameters;

/* The list of all parameters, in the order of the scene file; NULL when memory is short. */
LUXEL_API luxel_parameters *luxel_parameters_new(void);
/*
 * The list with types, units, ranges, labels and meanings in the language of `translate` (NULL: English), which
 * is called with `data` while the list is made; keys, choices and values stay as they are.  NULL when memory is short.
 */
LUXEL_API luxel_parameters *luxel_parameters_new_translated(luxel_translate translate, void *data);
/* Frees the list and every text in it; NULL is harmless. */
LUXEL_API void luxel_parameters_free(luxel_parameters *parameters);

/* The number of parameters in the list. */
LUXEL_API size_t luxel_parameters_count(const luxel_parameters *parameters);
/* The i-th parameter, which lives as long as the list; NULL beyond the last. */
LUXEL_API const luxel_parameter *luxel_parameters_get(const luxel_parameters *parameters, size_t i);

/* The number of kinds of surfaces and lights. */
LUXEL_API size_t luxel_parameters_kind_count(const luxel_parameters *parameters);
/* The i-th kind, which lives as long as the list; NULL beyond the last. */
LUXEL_API const luxel_parameter_kind *luxel_parameters_kind(const luxel_parameters *parameters, size_t i);

/*
 * The English label of a choice, or of a kind's name, for forms, which callers translate: "inverse square" of
 * "inverse-square"; scenes are written with the choice.  NULL: no key has such a choice.
 */
LUXEL_API const char *luxel_parameter_choice_label(const char *choice);

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
