/* SPDX-License-Identifier: MIT */
/*
 * Studies: many scenes that are made of one by rules, for data sets and parameter studies.
 *
 * A study file is YAML: a base scene, what varies and how, and which outputs are wanted of each scene.  Scene i is a
 * pure function of the study and i: random numbers come from a generator by counter (Philox 4x32-10, docs/SWEEP.md), so
 * any scene can be made alone, in any order, by any number of machines.
 */
#ifndef LUXEL_STUDY_H
#define LUXEL_STUDY_H

#include <stddef.h>
#include <stdint.h>

#include <luxel/parameter.h>
#include <luxel/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A study, owned by the caller; freed with luxel_study_free(). */
typedef struct luxel_study luxel_study;

/* What is wanted of each scene. */
typedef enum luxel_study_output {
    LUXEL_STUDY_BRIGHTNESS,      /* the picture */
    LUXEL_STUDY_IRRADIANCE,      /* the same of the irradiance */
    LUXEL_STUDY_MASK,            /* 1 where a pixel shows a surface, else 0 */
    LUXEL_STUDY_NORMALS,         /* the unit normal of what a pixel shows; 0, 0, 0 where that is nothing */
    LUXEL_STUDY_DEPTH,           /* how far what a pixel shows is from the observer, along z, in mm; 0: nothing */
    LUXEL_STUDY_PROBES,          /* the exact values of the scene's points */
    LUXEL_STUDY_STATISTICS,      /* maximum, minimum, mean, lit and how many pixels show a surface */
    LUXEL_STUDY_LIGHT_POSITIONS, /* the place of each light in mm; NaN where it has none */
    LUXEL_STUDY_POSITIONS,       /* the place that a pixel shows, in mm; 0, 0, 0 where that is nothing */
    LUXEL_STUDY_SURFACES,        /* the index of the surface that a pixel shows; -1: nothing */
    LUXEL_STUDY_OUTPUTS          /* how many there are */
} luxel_study_output;

/* How the numbers of an output are kept. */
typedef enum luxel_study_type {
    LUXEL_STUDY_NONE,    /* not wanted */
    LUXEL_STUDY_FLOAT16, /* IEEE half precision, rounded to nearest */
    LUXEL_STUDY_FLOAT32, /* single precision */
    LUXEL_STUDY_FLOAT64, /* double precision; pictures are then computed in it */
    LUXEL_STUDY_UINT8,   /* of the mask */
    LUXEL_STUDY_LP,      /* of light positions: a text for programs that relight (.lp) */
    LUXEL_STUDY_INT32    /* of surfaces */
} luxel_study_type;

/*
 * Reads a study file, with all errors at once: of the study, of its base scene, and of each value that is out of its
 * key's range.  What it names is relative to its folder.
 * LUXEL_ERROR_SCENE: it has errors.  LUXEL_ERROR_FILE: it, or what it names, cannot be read.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_study_read_file(const char *path, luxel_diagnostics *diagnostics, luxel_study **study);
/* Reads a study from `length` bytes of text; `source` is the name shown in messages.  What it names is relative to the
 * current folder. */
LUXEL_API luxel_status luxel_study_read_text(const char *text, size_t length, const char *source,
                                             luxel_diagnostics *diagnostics, luxel_study **study);
/* Frees a study; NULL is harmless. */
LUXEL_API void luxel_study_free(luxel_study *study);

/* How many scenes there are. */
LUXEL_API uint64_t luxel_study_count(const luxel_study *study);
/* How many scenes a shard has, which is the unit of work and of files. */
LUXEL_API unsigned luxel_study_shard(const luxel_study *study);
/* The base scene, committed; it is the study's. */
LUXEL_API const luxel_scene *luxel_study_base(const luxel_study *study);
/* How an output is wanted. */
LUXEL_API luxel_study_type luxel_study_wanted(const luxel_study *study, luxel_study_output output);
/* The name of an output, as the study file writes it, such as "brightness"; NULL beyond the last. */
LUXEL_API const char *luxel_study_output_name(luxel_study_output output);
/* The word for a type, such as "float32"; NULL of LUXEL_STUDY_NONE. */
LUXEL_API const char *luxel_study_type_name(luxel_study_type type);

/* The seed of what is random. */
LUXEL_API unsigned luxel_study_seed(const luxel_study *study);
/* The study as the file has it, as UTF-8; it is the study's. */
LUXEL_API const char *luxel_study_text(const luxel_study *study);

/* How many numbers tell what varies: a vector has three, a word or a value that is no number has its index. */
LUXEL_API size_t luxel_study_parameter_count(const luxel_study *study);
/* The name of the p-th of them as a key path, such as "lights[0].position[2]"; free it with luxel_text_free().  NULL
 * beyond the last or when memory is short. */
LUXEL_API char *luxel_study_parameter_name(const luxel_study *study, size_t p);
/* The v-th value that the p-th of them is the index of, as YAML; NULL where it is no index, or beyond the last. */
LUXEL_API const char *luxel_study_parameter_word(const luxel_study *study, size_t p, size_t v);
/* Sets luxel_study_parameter_count() numbers to those of scene i, which must be below the count. */
LUXEL_API void luxel_study_parameters(const luxel_study *study, uint64_t i, double *numbers);

/*
 * A text that tells all that the study's numbers depend on, and nothing else: base scene and the contents of the files
 * that it names, variation, seed, shards, outputs.  Two studies with the same text give the same files.  Free it with
 * luxel_text_free(); NULL when memory is short.
 */
LUXEL_API char *luxel_study_identity(const luxel_study *study);

/*
 * Scene i as a scene of its own, committed.  LUXEL_ERROR_ARGUMENT: no such.  LUXEL_ERROR_SCENE: the values do not go
 * together.  LUXEL_ERROR_FILE, LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_study_scene(const luxel_study *study, uint64_t i, luxel_diagnostics *diagnostics,
                                         luxel_scene **scene);

/* Makes one scene after the other quickly; owned by the caller, and used by one thread at a time. */
typedef struct luxel_study_maker luxel_study_maker;

/* A maker of a study, which must outlive it.  Errors as of luxel_study_scene(). */
LUXEL_API luxel_status luxel_study_maker_new(const luxel_study *study, luxel_diagnostics *diagnostics,
                                             luxel_study_maker **maker);
/* Frees a maker and its scene; NULL is harmless. */
LUXEL_API void luxel_study_maker_free(luxel_study_maker *maker);
/*
 * Scene i to be rendered and probed: equal to that of luxel_study_scene(), but it is the maker's, lasts until the next
 * call, and may have no text of its own: luxel_scene_write_text() and luxel_scene_copy() then fail, and fields of it
 * carry no scene.  Where only numbers differ it takes some microseconds.  Errors as of luxel_study_scene().
 */
LUXEL_API luxel_status luxel_study_make(luxel_study_maker *maker, uint64_t i, luxel_diagnostics *diagnostics,
                                        const luxel_scene **scene);

/* The keys of study files as a list, as luxel_parameters_new_translated() has those of scenes. */
LUXEL_API luxel_parameters *luxel_study_keys(luxel_translate translate, void *data);
/* The JSON Schema (draft-07) of study files, for editors.  Free it with luxel_text_free().  LUXEL_ERROR_MEMORY. */
LUXEL_API luxel_status luxel_study_schema(char **text);

#ifdef __cplusplus
}
#endif
#endif
