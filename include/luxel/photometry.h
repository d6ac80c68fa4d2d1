/* SPDX-License-Identifier: MIT */
/*
 * Luminaire files: how much light a luminaire sends where, as laboratories measured it: IES LM-63 of 1986 to 2019 and
 * EULUMDAT.  A file becomes one table of luminous intensities in candela, complete whatever symmetry the file has
 * used; docs/PHOTOMETRY.md tells what is understood, and how the numbers below are computed.
 *
 * Directions have three components: along the axis a, along C = 0 (c0), and along c0 × a.  The axis of type C and of
 * EULUMDAT is nadir, gamma = 0, so (C, gamma) is (cos gamma, sin gamma cos C, sin gamma sin C).  Types A and B have
 * their beam along the axis, their horizontal angles towards c0 and their vertical ones towards c0 × a.
 */
#ifndef LUXEL_PHOTOMETRY_H
#define LUXEL_PHOTOMETRY_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/diagnostics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The kinds of files. */
typedef enum luxel_photometry_format { LUXEL_PHOTOMETRY_LM_63, LUXEL_PHOTOMETRY_EULUMDAT } luxel_photometry_format;

/* The systems of coordinates. */
typedef enum luxel_photometry_type {
    LUXEL_PHOTOMETRY_TYPE_A, /* horizontal X, vertical Y, polar axis up: (cos Y cos X, cos Y sin X, sin Y) */
    LUXEL_PHOTOMETRY_TYPE_B, /* horizontal H, vertical V, polar axis sideways: (cos H cos V, sin H, cos H sin V) */
    LUXEL_PHOTOMETRY_TYPE_C  /* planes C about the vertical, gamma from nadir; EULUMDAT has no other */
} luxel_photometry_type;

/* What the file leaves out because it repeats. */
typedef enum luxel_photometry_symmetry {
    LUXEL_SYMMETRY_NONE,
    LUXEL_SYMMETRY_AXIAL,        /* one plane */
    LUXEL_SYMMETRY_QUADRANT,     /* C = 0 to 90 */
    LUXEL_SYMMETRY_BILATERAL_0,  /* about the plane C0-C180: C = 0 to 180 */
    LUXEL_SYMMETRY_BILATERAL_90, /* about the plane C90-C270: C = 90 to 270 */
    LUXEL_SYMMETRY_LATERAL       /* of types A and B: horizontal angles from 0 on */
} luxel_photometry_symmetry;

/* Shapes of luminous openings. */
typedef enum luxel_photometry_opening_shape {
    LUXEL_OPENING_POINT,
    LUXEL_OPENING_RECTANGLE,
    LUXEL_OPENING_BOX,             /* with luminous sides */
    LUXEL_OPENING_ELLIPSE,         /* a disk where width and length are the same */
    LUXEL_OPENING_CYLINDER,        /* upright, round or elliptic, with luminous sides */
    LUXEL_OPENING_ELLIPSOID,       /* a sphere where all three are the same */
    LUXEL_OPENING_CYLINDER_LENGTH, /* lying, its axis along the length */
    LUXEL_OPENING_CYLINDER_WIDTH,  /* lying, its axis along the width */
    LUXEL_OPENING_FACING_LENGTH,   /* an upright ellipse that faces along the length */
    LUXEL_OPENING_FACING_WIDTH     /* an upright ellipse that faces along the width */
} luxel_photometry_opening_shape;

/* A luminous opening; lengths in mm.  EULUMDAT calls "length" what LM-63 calls width, and here it is the width, too. */
typedef struct luxel_photometry_opening {
    luxel_photometry_opening_shape shape; /* which of its lengths count */
    double width_mm;                      /* along C90-C270 */
    double length_mm;                     /* along C0-C180 */
    double height_mm;                     /* along the axis; the greatest of the four that EULUMDAT gives */
} luxel_photometry_opening;

/* The lamps of a EULUMDAT file, or those of an LM-63 file as one set. */
typedef struct luxel_photometry_lamp_set {
    double count;            /* of lamps; below 0 in EULUMDAT: absolute photometry */
    const char *type;        /* as the file calls it; "" */
    double lumens;           /* of all lamps of the set; NaN: the file declares none */
    const char *temperature; /* colour temperature, as it stands there; "" */
    const char *rendering;   /* colour rendering, as it stands there; "" */
    double watts;            /* with ballast */
    void *reserved[4];       /* for later versions: NULL */
} luxel_photometry_lamp_set;

/* A text of the file: an LM-63 keyword, or a line of EULUMDAT under the keyword that means the same. */
typedef struct luxel_photometry_text {
    const char *keyword; /* "MANUFAC"; "" where the file has none, as in 1986 */
    const char *text;    /* UTF-8; lines that go on by [MORE] are divided by \n */
} luxel_photometry_text;

/* A luminaire; all of it belongs to the library and is freed by luxel_photometry_free(). */
typedef struct luxel_photometry {
    luxel_photometry_format format; /* what the file is, whatever its name */
    const char *version; /* the first line of an LM-63 file, such as "IESNA:LM-63-2002"; "" where there is none */
    unsigned year;       /* of the LM-63 whose rules were followed: 1986, 1991, 1995, 2002, 2019; 0: EULUMDAT */
    luxel_photometry_type type;         /* what its angles are measured about */
    luxel_photometry_symmetry symmetry; /* as the header or the angles tell */

    size_t plane_count; /* of the table below */
    size_t angle_count; /* of the table below */
    /* Degrees, rising: C of type C, all around, so that the last is the first + 360; else the horizontal angles. */
    const double *planes;
    const double *angles;      /* degrees, rising: gamma, or the vertical angles */
    const double *intensities; /* cd, all angles of the first plane, then those of the next one */

    size_t declared_planes; /* how many planes the header announces */
    size_t stored_planes;   /* how many planes the file holds */

    bool is_absolute;       /* measured without reference to lamps: lumens are no scale */
    double declared_lumens; /* of the lamps, of the first set where there are several; NaN: none declared */
    double declared_lorl;   /* percent, EULUMDAT; NaN: none declared */
    double declared_dff;    /* percent, EULUMDAT; NaN: none declared */
    double multiplier;      /* cd for one unit of the file's numbers: all factors together */
    double watts;           /* input power */

    luxel_photometry_opening opening; /* where the light comes out */
    double housing_mm[3];             /* width, length and height of the luminaire, EULUMDAT; 0 where not known */

    const luxel_photometry_lamp_set *lamp_sets; /* the first one counts */
    size_t lamp_set_count;                      /* of them */
    const luxel_photometry_text *texts;         /* in the order of the file */
    size_t text_count;                          /* of them */

    unsigned tilt_geometry;     /* of the lamp in the luminaire, 1 to 3; 0: TILT=NONE */
    const double *tilt_angles;  /* degrees of the luminaire's tilt */
    const double *tilt_factors; /* of the intensities at these; not applied to the table */
    size_t tilt_count;          /* of them */
} luxel_photometry;

/*
 * Reads a file of either kind, told apart by what is in it.  All that is wrong is reported at once with line and
 * column; what is odd is reported as advice and changes no number in silence.
 * LUXEL_ERROR_FILE: it cannot be read or has errors.  LUXEL_ERROR_ARGUMENT: NULL where nothing may be.
 * LUXEL_ERROR_MEMORY: there is not enough.
 */
LUXEL_API luxel_status luxel_photometry_read(const char *path, luxel_diagnostics *diagnostics,
                                             luxel_photometry **photometry);

/* Reads bytes in memory; reports call them `name`, and what TILT=FILE names is looked for beside it. */
LUXEL_API luxel_status luxel_photometry_read_bytes(const void *bytes, size_t length, const char *name,
                                                   luxel_diagnostics *diagnostics, luxel_photometry **photometry);

/* Frees a luminaire; NULL is harmless. */
LUXEL_API void luxel_photometry_free(luxel_photometry *photometry);

/* The text under a keyword, NULL where there is none. */
LUXEL_API const char *luxel_photometry_find_text(const luxel_photometry *photometry, const char *keyword);

/* "LM-63-2002", "EULUMDAT". */
LUXEL_API const char *luxel_photometry_format_name(const luxel_photometry *photometry);
/* "axial", "quadrant", "bilateral 0-180", "bilateral 90-270", "lateral", "none". */
LUXEL_API const char *luxel_photometry_symmetry_name(luxel_photometry_symmetry symmetry);
/* "disk", "rectangle", "box", ...: the shape in one word or two, as JSON has it. */
LUXEL_API const char *luxel_photometry_opening_name(const luxel_photometry_opening *opening);

/* How the table goes on between its places: linear in both angles, or in the one and the cosine of the other, in which
 * zones of equal solid angle are equal. */
typedef enum luxel_photometry_interpolation {
    LUXEL_INTERPOLATE_ANGLE,
    LUXEL_INTERPOLATE_COSINE
} luxel_photometry_interpolation;

/* The intensity in cd at any C or horizontal angle and any gamma or vertical angle; 0 where the table has none. */
LUXEL_API double luxel_photometry_intensity(const luxel_photometry *photometry,
                                            luxel_photometry_interpolation interpolation, double plane_deg,
                                            double angle_deg);

/* The unit vector in a direction of the table. */
LUXEL_API void luxel_photometry_direction(const luxel_photometry *photometry, double plane_deg, double angle_deg,
                                          double direction[3]);
/* The table's angles of a direction of any length. */
LUXEL_API void luxel_photometry_angles(const luxel_photometry *photometry, const double direction[3], double *plane_deg,
                                       double *angle_deg);

enum { LUXEL_ROOM_INDICES = 10 };

/* What is read off a table.  Numbers that make no sense for it are NaN. */
typedef struct luxel_photometry_figures {
    double zone_lumens;        /* the flux by the zone rule: mean of two angles times the difference of their cosines */
    double linear_lumens;      /* the flux if the intensity is linear between the angles */
    double lorl;               /* light output ratio, percent of the declared lumens, by the zone rule */
    double dff;                /* downward flux fraction, percent, by the zone rule; type C */
    double greatest_cd;        /* the greatest intensity of the table */
    double greatest_plane_deg; /* its first place: the horizontal angle or C of the table */
    double greatest_angle_deg; /* its first place: the vertical angle or gamma of the table */
    double greatest_c_deg;     /* its first place: C about the axis, whatever the type */
    double greatest_gamma_deg; /* its first place: gamma from the axis, whatever the type */
    double beam_deg;           /* full angle between the directions of half the intensity, in the section there */
    double field_deg;          /* of a tenth of it */
    double beam_sections_deg[2];              /* in the sections C0-C180 and C90-C270, or horizontal and vertical */
    double field_sections_deg[2];             /* in these, too */
    double flux_code[5];                      /* CIE flux code N1 to N5, percent, not rounded; type C */
    double direct_ratios[LUXEL_ROOM_INDICES]; /* for the room indices of luxel_photometry_room_index(); type C */
    double spacing[3]; /* spacing criteria along C0-C180, along C90-C270 and across the diagonals; type C */
    void *reserved[4]; /* for later versions: NULL */
} luxel_photometry_figures;

/* Computes them.  LUXEL_ERROR_MEMORY. */
LUXEL_API luxel_status luxel_photometry_find_figures(const luxel_photometry *photometry,
                                                     luxel_photometry_figures *figures);

enum { LUXEL_FLUX_ZONES = 18 };

/* The flux by the zone rule in zones of ten degrees, from the axis on; types A and B: NaN.  LUXEL_ERROR_MEMORY. */
LUXEL_API luxel_status luxel_photometry_find_zones(const luxel_photometry *photometry, double lumens[LUXEL_FLUX_ZONES]);

/* The mean luminance of the opening in a direction, in cd/m²; NaN where it shows no area, and of types A and B. */
LUXEL_API double luxel_photometry_luminance(const luxel_photometry *photometry, double plane_deg, double angle_deg);

/* The zones of IES TM-15-11: before and behind the luminaire, and above it. */
typedef enum luxel_bug_zone {
    LUXEL_BUG_FORWARD_LOW,       /* FL: gamma up to 30 degrees, within 90 degrees of the front */
    LUXEL_BUG_FORWARD_MID,       /* FM: up to 60 degrees */
    LUXEL_BUG_FORWARD_HIGH,      /* FH: up to 80 degrees */
    LUXEL_BUG_FORWARD_VERY_HIGH, /* FVH: up to 90 degrees */
    LUXEL_BUG_BACK_LOW,          /* BL: gamma up to 30 degrees, on the other side */
    LUXEL_BUG_BACK_MID,          /* BM: up to 60 degrees */
    LUXEL_BUG_BACK_HIGH,         /* BH: up to 80 degrees */
    LUXEL_BUG_BACK_VERY_HIGH,    /* BVH: up to 90 degrees */
    LUXEL_BUG_UP_LOW,            /* UL: 90 to 100 degrees, all around */
    LUXEL_BUG_UP_HIGH,           /* UH: 100 to 180 degrees */
    LUXEL_BUG_ZONES              /* how many there are */
} luxel_bug_zone;

/* Backlight, uplight and glare of a luminaire outdoors, each rated 0 to 5. */
typedef struct luxel_bug_rating {
    bool exists;                    /* false: types A and B */
    double front_c_deg;             /* which way the front is: C = 0 of LM-63, C = 90 of EULUMDAT */
    bool is_around;                 /* it lights all sides alike (type V), and the back counts as the front does */
    double lumens[LUXEL_BUG_ZONES]; /* by the zone rule */
    unsigned backlight;             /* B */
    unsigned uplight;               /* U */
    unsigned glare;                 /* G */
    void *reserved[4];              /* for later versions: NULL */
} luxel_bug_rating;

/* Rates it by IES TM-15-11, addendum A.  LUXEL_ERROR_ARGUMENT: NULL.  LUXEL_ERROR_MEMORY. */
LUXEL_API luxel_status luxel_photometry_find_bug_rating(const luxel_photometry *photometry, luxel_bug_rating *rating);

/*
 * Writes a luminaire by the extension of the name: .ies as IESNA:LM-63-2002, .ldt as EULUMDAT, whole or not at all.
 * What is written reads back as the same table, but for planes that repeat others, and roundings of EULUMDAT in the
 * last digit; EULUMDAT knows type C alone, so that types A and B are interpolated for it, and advice tells how far that
 * may be off.  LUXEL_ERROR_ARGUMENT: another extension.  LUXEL_ERROR_FILE: it cannot be written.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_photometry_write(const luxel_photometry *photometry, const char *path,
                                              luxel_diagnostics *diagnostics);

/* The i-th room index for direct ratios: .6 .8 1 1.25 1.5 2 2.5 3 4 5. */
LUXEL_API double luxel_photometry_room_index(size_t i);

#ifdef __cplusplus
}
#endif
#endif
