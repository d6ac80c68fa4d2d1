/* SPDX-License-Identifier: MIT */
/*
 * Fits: the keys of a scene that make it give what was measured, with error bars.
 *
 * Readings are values of a scene at places: those of a meter, or the pixels of a picture.  Free keys are changed until
 * the squares of what is left, in standard deviations of the noise, are least (Levenberg and Marquardt), from several
 * starts.  The errors are those of the linear problem there: s² (J'J)⁻¹ with the derivatives J of <luxel/derive.h>.
 *
 * What the readings do not determine, such as the strength of a lamp beside the reflectance of what it lights, has no
 * number: luxel_fit_undetermined() names it.  It is found from the directions in which the scene can change without the
 * readings (the null space of J), and from fits that end elsewhere and are as good.
 *
 * Threads as luxel.h says.
 */
#ifndef LUXEL_FIT_H
#define LUXEL_FIT_H

#include <luxel/field.h>
#include <luxel/probe.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The weight of a reading that is off by r standard deviations. */
typedef enum luxel_loss {
    LUXEL_LOSS_GAUSSIAN, /* r² */
    LUXEL_LOSS_HUBER,    /* that up to 1.345, then along a line: outliers pull, but no more than others */
    LUXEL_LOSS_TUKEY     /* a bowl (Tukey's biweight) that is flat from 4.685 on: outliers do not count */
} luxel_loss;

/* What is known of measured values; {0} and the first three, or of a picture {0} alone, will do. */
typedef struct luxel_readings {
    const luxel_place *places; /* where they were taken; of a picture not used */
    const double *values;      /* in the scene's unit; NaN: left out.  Of a picture not used */
    size_t count;              /* how many */
    double noise;              /* the standard deviation of each, */
    double relative_noise; /* and as a share of it (both: their squares add).  Both 0: it is told by how they scatter */
    double saturated;      /* values from here on say only that the truth is no less; 0: none */
    double quantum;        /* the step between the levels that the values are rounded to; 0: none */
    bool is_truncated;     /* whether they were rounded down, else to the nearest level */
    bool is_relative;      /* whether all are known only up to one factor, as grey levels are */
    luxel_loss loss;       /* what readings that are off count for */
    unsigned starts;       /* from so many places; 0: as many as pay */
    void *reserved[4];     /* for later versions: NULL */
} luxel_readings;

/* A number of a free key.  One that is not determined has no value. */
typedef struct luxel_fit_parameter {
    const char *key;    /* with an index where the key has several numbers: lights[0].position[2] */
    const char *unit;   /* in UTF-8, "" for none */
    bool is_determined; /* else all numbers are NaN */
    bool has_errors;    /* false where there are no more readings than unknowns, and their noise is not known */
    bool is_at_limit;   /* the value is the least or greatest legal one, and the readings ask for more */
    double value;       /* in the key's unit */
    double sd;          /* standard deviation: the truth is within in 68.3 of 100 cases; NaN without errors */
    double low;         /* the interval that holds the truth in 95 of 100 cases begins here; NaN without errors */
    double high;        /* and ends here */
    void *reserved[2];  /* for later versions: NULL */
} luxel_fit_parameter;

/* A fit.  Its texts and arrays live as long as it does. */
typedef struct luxel_fit {
    const luxel_fit_parameter *parameters; /* the free numbers, in the order of the keys */
    size_t count;                          /* of them; one more where readings are relative: the factor, "factor" */
    size_t rank;                           /* how many numbers, or combinations of them, are determined */
    size_t readings;                       /* that were used */
    size_t saturated;                      /* of these, how many are saturated */
    size_t without_derivative; /* how many do not count for the errors, as the value has no derivative there */
    size_t outliers;           /* with a loss that is not gaussian: how many are off by more than 3.5 of them */
    bool noise_is_estimated;   /* from how the readings scatter */
    double noise;              /* estimated: the standard deviation of a reading; else its mean, told */
    double chi2;               /* the sum of squares in standard deviations, of readings that are not saturated */
    size_t dof;                /* degrees of freedom: how many these are more than the rank */
    const double *correlation; /* count x count; NaN for what is not determined or has no errors */
    const double *residuals;   /* a number for each reading, or pixel of a picture row by row: the reading less what the
                                  fitted scene gives (times the factor); NaN of those that were not used */
    size_t starts;             /* how many were taken, */
    size_t agreed;             /* and how many of them ended here */
    bool has_converged;        /* false: it was still changing after the most steps that are taken */
    size_t undetermined;       /* how many texts luxel_fit_undetermined() has */
    void *reserved[4];         /* for later versions: NULL */
} luxel_fit;

/*
 * Fits `key_count` keys, paths as luxel_derive_places() takes them, to readings; their numbers in the scene are the
 * first start.  *fit is the caller's: free it with luxel_fit_free().  It succeeds, too, where not all is determined.
 * Progress and cancelling as of luxel_render().
 * LUXEL_ERROR_ARGUMENT: no key, or two that have a number in common; fewer readings than numbers of keys, all of them
 * saturated, or some off the surface; noise and the like below 0 or not finite.  LUXEL_ERROR_PATH: keys, as
 * luxel_derive_places() has it.
 */
LUXEL_API luxel_status luxel_fit_readings(const luxel_scene *scene, const luxel_settings *settings,
                                          const luxel_readings *readings, const char *const *keys, size_t key_count,
                                          luxel_diagnostics *diagnostics, luxel_fit **fit);

/*
 * Fits keys to a picture of as many columns and rows as the scene has pixels; `readings` tell of its pixels.  Pixels
 * that are 0 and show no surface in the scene are left out.
 * Errors as luxel_fit_readings(); LUXEL_ERROR_ARGUMENT: another size, or a unit that is not that of the scene's values.
 */
LUXEL_API luxel_status luxel_fit_picture(const luxel_scene *scene, const luxel_settings *settings,
                                         const luxel_field *picture, const luxel_readings *readings,
                                         const char *const *keys, size_t key_count, luxel_diagnostics *diagnostics,
                                         luxel_fit **fit);

/* The fitted scene, committed: numbers that are not determined are somewhere on what fits as well. */
LUXEL_API const luxel_scene *luxel_fit_scene(const luxel_fit *fit);

/*
 * What the readings do not determine, such as "lights[0].position[2], lights[0].intensity: only one combination of
 * these is determined".  `translate` as of luxel_diagnostics_message().  The text is the caller's: free it with
 * luxel_text_free(); NULL beyond the last, or without memory.
 */
LUXEL_API char *luxel_fit_undetermined(const luxel_fit *fit, size_t i, luxel_translate translate, void *data);

/*
 * What they do: "4 readings, 3 determined: lights[0].position[0], lights[0].position[1], one combination of
 * lights[0].position[2], lights[0].intensity".  The text is the caller's; NULL without memory.
 */
LUXEL_API char *luxel_fit_determined(const luxel_fit *fit, luxel_translate translate, void *data);

/* Frees a fit; NULL is harmless. */
LUXEL_API void luxel_fit_free(luxel_fit *fit);

/*
 * Reads the levels of a grey .png picture of 8 or 16 bits as a field of double precision, all of it on the mask:
 * *greatest is 255 or 65535.  How a level goes with a value, the picture's maker knows.
 * LUXEL_ERROR_FILE: it cannot be read, or is none.  The field is the caller's.
 */
LUXEL_API luxel_status luxel_read_levels(const char *path, luxel_diagnostics *diagnostics, luxel_field **field,
                                         double *greatest);

#ifdef __cplusplus
}
#endif
#endif
