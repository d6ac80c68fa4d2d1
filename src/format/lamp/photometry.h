/* SPDX-License-Identifier: MIT */
/*
 * Luminaire files (luxel/photometry.h): what the readers of LM-63 and EULUMDAT share.  A reader walks a text and fills
 * the stored table; the planes that symmetry leaves out are added afterwards, for both formats alike.
 */
#ifndef LX_FORMAT_PHOTOMETRY_H
#define LX_FORMAT_PHOTOMETRY_H

#include <luxel/photometry.h>

#include "../../base/diagnostics.h"
#include "../kept.h"

/* A luminaire with the memory of all that it shows. */
struct lx_photometry {
    struct lx_kept kept;
    luxel_photometry shown;
    double *planes, *angles, *intensities, *tilt_angles, *tilt_factors;
    char *version;
    luxel_photometry_lamp_set *lamp_sets;
    size_t lamp_set_capacity;
    luxel_photometry_text *texts;
    size_t text_capacity;
};

void lx_photometry_free(struct lx_kept *kept);

/* The table as the file holds it, in cd. */
struct lx_stored_table {
    double *planes, *angles, *intensities;
    size_t plane_count, angle_count;
    bool is_turn; /* without symmetry: the last plane is the first one again, as the file gives it */
};

/* A file while it is read; lines end in LF alone. */
struct lx_luminaire_file {
    const char *name, *text;
    size_t length, at;
    luxel_diagnostics *diagnostics, *advice; /* of errors, and of what is odd; often the same */
    size_t errors;
    bool no_memory;
    struct lx_photometry *made;
    struct lx_stored_table table;
};

enum { LX_LARGEST_PHOTOMETRY = 64 << 20 };

/* Reads a text, which may be changed and has room for a 0 byte behind it: as luxel_photometry_read_bytes(), with
 * advice going elsewhere; NULL: nowhere. */
luxel_status lx_photometry_read_text(char *text, size_t length, const char *name, luxel_diagnostics *errors,
                                     luxel_diagnostics *advice, struct lx_photometry **photometry);

/* Makes every line end in LF, and UTF-16 UTF-8; the text, another one or the same, or NULL: no memory. */
char *lx_photometry_plain_text(char *text, size_t *length);

/* Reports about a stretch of the file; an error counts. */
void lx_luminaire_error(struct lx_luminaire_file *file, size_t start, size_t end, enum lx_message message,
                        const char *const *arguments);
void lx_luminaire_advise(struct lx_luminaire_file *file, size_t start, size_t end, enum lx_message message,
                         const char *const *arguments);

/* The next line without blanks around it; false where there is none. */
bool lx_luminaire_line(struct lx_luminaire_file *file, size_t *start, size_t *end);
/* Reads a number, with a decimal comma where that is allowed. */
bool lx_luminaire_number(const char *text, size_t length, bool has_comma, double *number);
/* A copy of a text of the file as UTF-8; NULL: no memory, which the file notes. */
char *lx_luminaire_text(struct lx_luminaire_file *file, size_t start, size_t end);
/* Adds a text, which it takes over, under a constant keyword or one that it takes over. */
void lx_luminaire_add_text(struct lx_luminaire_file *file, char *keyword, char *text);
struct luxel_photometry_lamp_set *lx_luminaire_add_lamps(struct lx_luminaire_file *file);

/* Checks angles that must rise within a range; their places in the file are `starts` to `ends`. */
struct lx_token {
    size_t start, end;
};
bool lx_check_angles(struct lx_luminaire_file *file, const char *name, const double *angles,
                     const struct lx_token *tokens, size_t count, double low, double high);

/* A number as messages show it. */
enum { LX_SHOWN_SIZE = 40 };
const char *lx_shown(double number, char buffer[LX_SHOWN_SIZE]);

/* The readers: they fill `made` and `table`, and report. */
void lx_read_lm63(struct lx_luminaire_file *file);
void lx_read_eulumdat(struct lx_luminaire_file *file);

/* The opening that an LM-63 file of a year means by width, length and height; false: an odd one, taken as a box. */
bool lx_lm63_opening(unsigned year, double width_mm, double length_mm, double height_mm,
                     luxel_photometry_opening *opening);

/* Completes the stored table by its symmetry; false: no memory. */
bool lx_complete_table(const struct lx_stored_table *table, struct lx_photometry *made);

/* A curve over the polar angle, summed over the other: of type C over C, in cd·rad. */
struct lx_polar_curve {
    double *angles_deg; /* from one pole to the other, rising, from 0 to 180 */
    double *values;
    size_t count;
};
bool lx_polar_curve_of(const luxel_photometry *photometry, struct lx_polar_curve *curve);
/* That of type C over C from one angle, 0 to 360, so far on, in degrees. */
bool lx_polar_curve_within(const luxel_photometry *photometry, double from_deg, double width_deg,
                           struct lx_polar_curve *curve);
void lx_polar_curve_clear(struct lx_polar_curve *curve);
/* Its flux between two polar angles in degrees. */
double lx_polar_flux(const struct lx_polar_curve *curve, luxel_photometry_interpolation rule, double from_deg,
                     double to_deg);

#endif
