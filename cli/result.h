/* SPDX-License-Identifier: MIT */
/* What render and probe share: the probes of their points, and the JSON object of their results. */
#ifndef LUXEL_CLI_RESULT_H
#define LUXEL_CLI_RESULT_H

#include <luxel/luxel.h>

#include "json.h"
#include "options.h"
#include "text.h"

struct result {
    const luxel_scene *scene;
    const struct options *options;
    const luxel_statistics *statistics; /* NULL: no picture was computed */
    luxel_probes *probes;               /* count of them */
    size_t count;
    const luxel_derivatives *derivatives; /* NULL: none were asked for */
    luxel_conventions_use use;            /* what they were made of */
    bool *surfaces;                       /* that it points to */
};

/*
 * Probes the places of -p, --at and --points or, where there are none, the scene's own points, all in one go.  Returns
 * an enum exit_code; errors are printed here.  EXIT_TOLERANCE goes with a complete result.  result_clear() is due in
 * every case.  Where surfaces reflect light the values of pixels take long, and are left out unless they are shown.
 */
int result_probe(const struct options *options, const luxel_scene *scene, bool shows_pixels,
                 luxel_diagnostics *diagnostics, struct result *result);
void result_clear(struct result *result);

/* Writes the conventions of what a result was made of as a member of an object. */
void result_write_conventions(struct json *json, const luxel_scene *scene, const luxel_conventions_use *use);
/* The lines of text that tell under which conventions the numbers were made. */
void result_print_conventions(const luxel_scene *scene, const luxel_conventions_use *use);
/* The use of a picture's values (`pixels`), or of exact ones at places of the screen. */
luxel_conventions_use result_use_of_screen(const struct options *options, bool pixels);

/* Writes an extremum as SPEC's `max` and `min` are written; null where there is none. */
void result_write_extremum(struct json *json, const char *key, const luxel_extremum *extremum);

/* The channels of a value, its x, y, u', v', colour temperature and Duv, null where there are none; also in a line. */
void result_write_color(struct json *json, const luxel_color *color);

/* Writes the members `ugr` and `error`, null where there is no rating, and `background`. */
void result_write_rating(struct json *json, const luxel_glare *glare);
/* The last of these alone, from x, y on; NULL: there is no colour. */
void result_write_seen(struct json *json, const double rgb[3]);
const char *result_color_text(const luxel_color *color, char buffer[TEXT_SIZE]);

/* Writes what is reflected to a probe as the member `reflected`; nothing where the scene reflects no light. */
void result_write_reflected(struct json *json, const luxel_probe *probe);

/* Writes the directional albedo of a probe's material at its view as the member `albedo`; null where it has none. */
void result_write_albedo(struct json *json, const luxel_scene *scene, const luxel_probe *probe);

/* Writes a derivative; those of the i-th place by the keys of --free as the member `derivatives`, one or, for a key of
 * several numbers, a list of them. */
void result_write_derivative(struct json *json, const char *key, const luxel_derivative *derivative);
void result_write_derivatives(struct json *json, const struct options *options, const luxel_derivatives *derivatives,
                              size_t place);

/* Writes the object of SPEC's `--json`, and prints it on standard output. */
void result_write_json(FILE *stream, const struct result *result);
void result_print_json(const struct result *result);

/* "P2 (150.0, 0.0)": how the text calls the i-th point. */
const char *result_point_name(const struct result *result, size_t i, char buffer[TEXT_SIZE]);
/* "P2 (400.0, 0.0): off the surface", of a point that has no value. */
const char *result_no_value(const struct result *result, size_t i, char buffer[TEXT_SIZE]);
/* "brightness" or "irradiance" */
const char *result_quantity_word(const struct result *result);
const char *result_unit(const struct result *result);

#endif
