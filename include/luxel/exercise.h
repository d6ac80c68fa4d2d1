/* SPDX-License-Identifier: MIT */
/*
 * Exercises: numbered variants of the exercise that students are given, and the judgement of their answers.
 */
#ifndef LUXEL_EXERCISE_H
#define LUXEL_EXERCISE_H

#include <luxel/alternatives.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Variants are numbered from 1 to this. */
#define LUXEL_LAST_VARIANT 1000000u

/*
 * The YAML text of the variant with this number: always the same for the same number, all values round and within the
 * ranges of the exercise, a pronounced peak in view, the whole sphere in view, one or two sources, five points.
 * The text is the caller's: free it with luxel_text_free().  LUXEL_ERROR_ARGUMENT: no such number.
 */
LUXEL_API luxel_status luxel_variant_text(unsigned number, luxel_diagnostics *diagnostics, char **text);

/*
 * Appends advice about what a committed scene shows: that it is dark, that its peak lies on the edge of the screen or
 * of a surface, that the highlight does not stand out, is too wide or too narrow, that the picture's range does not
 * fit, that sources are so near or far that their attenuation spoils the picture or makes no difference.  Where a
 * change mends it, the hint says which: assignments as luxel_scene_set() takes them, each behind -s and in single
 * quotes. It takes a quick look at a coarse picture, by the default settings; scenes of more than 4096 sources are not
 * looked at.  luxel_scene_advise() gives the advice that needs no look.
 * LUXEL_ERROR_ARGUMENT: the scene is not committed.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_advise_peak(const luxel_scene *scene, luxel_diagnostics *diagnostics);

/* What an answer is found to be. */
typedef enum luxel_judgement_verdict {
    LUXEL_ANSWER_RIGHT,      /* within the tolerance of the exact value */
    LUXEL_ANSWER_CONVENTION, /* within the tolerance of what another convention gives: `explanations` name it */
    LUXEL_ANSWER_WRONG,      /* neither */
    LUXEL_ANSWER_COARSE      /* the exact value, correctly rounded, but to fewer than the three digits asked for */
} luxel_judgement_verdict;

/* The judgement of one answer.  Its arrays and texts live as long as it. */
typedef struct luxel_judgement {
    luxel_judgement_verdict verdict; /* what the answer is found to be */
    bool has_value;                  /* whether there is a right value: false off every surface */
    double value;                    /* the exact value */
    double error;                    /* bounds |value - truth| */
    size_t explanation_count;        /* for LUXEL_ANSWER_CONVENTION: choices that together give the answer: one, or
                                          two where no single one does */
    const luxel_alternative *explanations; /* explanation_count of them */
} luxel_judgement;

/*
 * Judges the answer for a point of the screen.  `rounding` is half a unit of the last digit that was given (0: all of
 * them were).  Rounding comes first: what lies within the rounding (and tolerance |value|) of the exact value is right
 * if it does so with three digits, half a unit of the third or 1e-4 of the largest value of the scene's points being
 * allowed; else it is LUXEL_ANSWER_COARSE, whatever conventions come near, too.  Of other answers
 * one is sought that explains it, to within the tolerance and the rounding, of which no more than 0.5 % of the answer
 * counts; where two choices together must, a tenth of the tolerance.  Beside luxel_find_alternatives() it knows answers
 * that are the irradiance, a share of the picture's maximum, or a grey level; their `convention` is "what is given".
 * An answer NaN stands for "off the surface", which is right where that is so.  The judgement is the caller's: free it
 * with luxel_judgement_free().  Errors as luxel_probe_screen().  LUXEL_ERROR_ARGUMENT: tolerance or rounding negative
 * or not finite, too.
 */
LUXEL_API luxel_status luxel_judge_answer(const luxel_scene *scene, const luxel_settings *settings, double x_mm,
                                          double y_mm, double answer, double tolerance, double rounding,
                                          luxel_diagnostics *diagnostics, luxel_judgement **judgement);

/*
 * Judges an answer that may have been read off the picture: by the value at the sample of the pixel that the point
 * falls in; off the screen, where there is none, by that at the point.  All else is as for luxel_judge_answer().
 */
LUXEL_API luxel_status luxel_judge_pixel_answer(const luxel_scene *scene, const luxel_settings *settings, double x_mm,
                                                double y_mm, double answer, double tolerance, double rounding,
                                                luxel_diagnostics *diagnostics, luxel_judgement **judgement);

/* Frees a judgement; NULL is harmless. */
LUXEL_API void luxel_judgement_free(luxel_judgement *judgement);

#ifdef __cplusplus
}
#endif
#endif
