/* SPDX-License-Identifier: MIT */
/*
 * Parameters: every key of a scene with its type, unit, default, ranges and meaning, for help texts, forms
 * and references.  A list is the caller's and never changes, so several threads may read it; every pointer in
 * it lives as long as the list.
 */
#ifndef LUXEL_PARAMETER_H
#define LUXEL_PARAMETER_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct luxel_parameter {
    const char *path;          /* "screen.width", "lights[].intensity"; a list element is [] */
    const char *variant;       /* the type of surface or light it belongs to ("spot"), NULL for all */
    const char *type;          /* in words: "number", "whole number", "3 numbers", "one of", "yes or no", ... */
    const char *choices;       /* "nodes, centers", or NULL */
    const char *unit;          /* radiometric unit in UTF-8, "" where it has none */
    const char *default_value; /* as YAML; NULL where there is none */
    bool required;
    const char *legal;         /* the legal range in words, or NULL: any */
    const char *advised;       /* the advised range in words, or NULL: none */
    const char *meaning;       /* one sentence, English */
} luxel_parameter;

typedef struct luxel_parameters luxel_parameters;

/* The list of all parameters, in the order of the scene file; NULL when memory is short. */
LUXEL_API luxel_parameters *luxel_parameters_new(void);
LUXEL_API void luxel_parameters_free(luxel_parameters *parameters);

LUXEL_API size_t luxel_parameters_count(const luxel_parameters *parameters);
/* NULL beyond the last. */
LUXEL_API const luxel_parameter *luxel_parameters_get(const luxel_parameters *parameters, size_t i);

#ifdef __cplusplus
}
#endif
#endif
