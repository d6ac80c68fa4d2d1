/* SPDX-License-Identifier: MIT */
/*
 * The authored colour of a light: a colour temperature, a chromaticity, channels, or a spectrum in a file.  Whichever
 * it is, it becomes channels at luminance 1, so that the strength of the light stays what its key says.
 */
#include "colour.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/colour.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../format/text_table.h"
#include "../parameter/check.h"

static const struct lx_parameter color_parameters[] = {
    {
        .name = "temperature",
        .label = "Colour temperature",
        .type = LX_REAL,
        .offset = offsetof(struct lx_light_color, temperature),
        .legal = LX_BETWEEN(1000, 25000),
        .advised = {LX_BETWEEN(1500, 15000)},
        .meaning = "the temperature in kelvins of the black body whose colour the light has",
    },
    {
        .name = "xy",
        .label = "Chromaticity x, y",
        .type = LX_REALS,
        .offset = offsetof(struct lx_light_color, xy),
        .count = 2,
        .legal = LX_BETWEEN(0, 1),
        .meaning = "the chromaticity x, y of the CIE 1931 standard observer",
    },
    {
        .name = "rgb",
        .label = "Channels r, g, b",
        .type = LX_REALS,
        .offset = offsetof(struct lx_light_color, rgb),
        .count = 3,
        .meaning = "shares of red, green and blue in linear sRGB, which are scaled to luminance 1",
    },
    {
        .name = "spectrum",
        .label = "Spectrum",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_light_color, spectrum),
        .meaning = "a file with the spectral power distribution: a table of wavelengths in nm and powers in any unit, "
                   "in between them on straight lines",
    },
};

static const struct lx_rule color_rules[] = {
    {LX_RULE_ONE, "temperature", NULL, "temperature|xy|rgb|spectrum"},
};

/* ---- spectra ---- */

/* A spectrum that was read: all that counts is its chromaticity. */
struct lx_spectrum {
    struct lx_kept kept;
    double xy[2];
};

enum { LARGEST_SPECTRUM = 1 << 20, MOST_STEP_NM = 20, NEEDED_FROM_NM = 400, NEEDED_TO_NM = 700 };

static void free_spectrum(struct lx_kept *kept)
{
    free(kept);
}

static const char *const NM_NAMES[] = {"nm",        "wavelength", "lambda",      "λ", "wl", "wavelength_nm",
                                       "lambda_nm", "нм",         "длина волны", NULL};
static const char *const POWER_NAMES[] = {"power",    "value",    "intensity", "spd",        "spectral power",
                                          "relative", "radiance", "w/nm",      "irradiance", "spectral_power",
                                          "мощность", "отсчёты",  "counts",    "w/(m²·nm)",  NULL};
static const luxel_table_column COLUMNS[] = {
    {.type = LUXEL_TABLE_NUMBER, .is_required = true, .names = NM_NAMES},
    {.type = LUXEL_TABLE_NUMBER, .is_required = true, .names = POWER_NAMES}};
static const struct lx_text_table_form FORM = {.columns = COLUMNS, .count = LX_COUNT(COLUMNS)};

/* A spectrum on the way from its rows to the wavelengths of the observer. */
struct reading {
    double nm, power; /* of the row before; nm 0: there is none */
    double of[LX_WAVELENGTHS];
};

/* Fills in the wavelengths between the row before and the next one. */
static void draw_line(struct reading *reading, double nm, double power)
{
    const int first = (int)fmax(ceil(reading->nm), LX_FIRST_NM);
    for (int at = first; at <= nm && at < LX_FIRST_NM + LX_WAVELENGTHS; at++)
        reading->of[at - LX_FIRST_NM] =
            reading->power + (power - reading->power) * (at - reading->nm) / (nm - reading->nm);
}

/* What is wrong with the next row, LX_MSG_COUNT: nothing.  Gaps count where the eye sees. */
static enum lx_message check_row(const struct reading *reading, double nm, double power)
{
    if (!(nm >= 100 && nm <= 20000))
        return LX_MSG_SPECTRUM_UNIT;
    if (power < 0)
        return LX_MSG_SPECTRUM_NEGATIVE;
    if (reading->nm == 0)
        return nm > NEEDED_FROM_NM ? LX_MSG_SPECTRUM_ENDS : LX_MSG_COUNT;
    if (!(nm > reading->nm))
        return LX_MSG_SPECTRUM_ORDER;
    const bool is_seen = nm > LX_FIRST_NM && reading->nm < NEEDED_TO_NM;
    return is_seen && nm - reading->nm > MOST_STEP_NM ? LX_MSG_SPECTRUM_GAP : LX_MSG_COUNT;
}

/* Reads all rows; what is wrong is in the fault, whose message else is LX_MSG_COUNT. */
static void read_rows(struct lx_text_table *table, struct reading *reading, struct lx_text_table_fault *fault)
{
    double row[2];
    const char *unit = lx_text_table_unit(table, 0);
    if (*unit && strcmp(unit, "nm") != 0 && strcmp(unit, "нм") != 0) {
        *fault = lx_text_table_fault_at(table, 0, LX_MSG_SPECTRUM_UNIT);
        return;
    }
    while (lx_text_table_next(table, row, fault)) {
        const enum lx_message wrong = check_row(reading, row[0], row[1]);
        if (wrong != LX_MSG_COUNT) {
            *fault = lx_text_table_fault_at(table, wrong == LX_MSG_SPECTRUM_NEGATIVE, wrong);
            lx_write_number(wrong == LX_MSG_SPECTRUM_ENDS ? NEEDED_FROM_NM : reading->nm, fault->words[0]);
            lx_write_number(wrong == LX_MSG_SPECTRUM_ENDS ? NEEDED_TO_NM : row[0], fault->words[1]);
            return;
        }
        if (reading->nm > 0)
            draw_line(reading, row[0], row[1]);
        reading->nm = row[0];
        reading->power = row[1];
    }
    if (fault->message == LX_MSG_COUNT && !(reading->nm >= NEEDED_TO_NM)) {
        *fault = (struct lx_text_table_fault){.message = LX_MSG_SPECTRUM_ENDS, .hint = LX_MSG_COUNT};
        lx_write_number(NEEDED_FROM_NM, fault->words[0]);
        lx_write_number(NEEDED_TO_NM, fault->words[1]);
    }
}

static void report_fault(const struct lx_check *check, const char *path, const struct lx_text_table_fault *fault)
{
    char line[LX_NUMBER_SIZE];
    struct lx_text words = {0};
    lx_add_fault(&words, fault);
    lx_write_number((double)fault->line, line);
    if (words.failed || fault->message == LX_MSG_OUT_OF_MEMORY)
        check->walk->out_of_memory = true;
    else
        lx_check_report(check, "spectrum", LX_ALL_OF_IT, fault->line > 0 ? LX_MSG_CLOUD_LINE : LX_MSG_CLOUD_TABLE,
                        LX_ARGS(path, line, LX_WORDS(words.bytes)));
    if (fault->message == LX_MSG_SPECTRUM_UNIT)
        lx_check_hint(check, LX_MSG_HINT_SPECTRUM_UNIT, NULL);
    else if (fault->hint != LX_MSG_COUNT)
        lx_check_hint(check, fault->hint, LX_ARGS(fault->words[0], fault->words[1], fault->words[2]));
    lx_text_clear(&words);
}

/* Reads the file of a source that is open; what is wrong is reported. */
static bool read_spectrum(const struct lx_check *check, const char *path, struct lx_source *source, double xy[2])
{
    struct reading reading = {.nm = 0};
    struct lx_text_table_fault fault;
    struct lx_text_table *table = lx_text_table_new(source, &FORM, &fault);
    if (!table) {
        check->walk->out_of_memory = true;
        lx_check_close(check, "spectrum", source);
        return false;
    }
    if (fault.message == LX_MSG_COUNT)
        read_rows(table, &reading, &fault);
    lx_text_table_free(table);
    const bool is_read = lx_check_close(check, "spectrum", source);
    if (is_read && fault.message == LX_MSG_COUNT && !lx_spectrum_xy(reading.of, xy))
        lx_check_report(check, "spectrum", LX_ALL_OF_IT, LX_MSG_SPECTRUM_DARK, LX_ARGS(path));
    else if (is_read && fault.message != LX_MSG_COUNT)
        report_fault(check, path, &fault);
    else
        return is_read;
    return false;
}

/* Reads the file, unless the scene has done so already; false where that failed, which is reported. */
static bool load_spectrum(const struct lx_check *check, struct lx_light_color *color)
{
    char *path = lx_check_path(check, color->spectrum);
    color->read = path ? (struct lx_spectrum *)lx_check_kept(check, path, free_spectrum) : NULL;
    struct lx_source *source = path && !color->read ? lx_check_open(check, "spectrum", path, LARGEST_SPECTRUM) : NULL;
    double xy[2];
    if (source && read_spectrum(check, path, source, xy)) {
        color->read = lx_new_array(1, sizeof *color->read);
        if (color->read) {
            lx_kept_init(&color->read->kept, free_spectrum);
            memcpy(color->read->xy, xy, sizeof xy);
            lx_check_keep(check, path, &color->read->kept);
        } else {
            check->walk->out_of_memory = true;
        }
    }
    free(path);
    return color->read;
}

static void release_color(void *parameters)
{
    struct lx_light_color *color = parameters;
    lx_kept_release((struct lx_kept *)color->read);
    color->read = NULL;
}

/* ---- channels ---- */

/* Channels of light that there is, scaled to luminance 1; else what they are not is reported at the key. */
static void take_rgb(const struct lx_check *check, struct lx_light_color *color, const char *key)
{
    const double luminance = luxel_rgb_luminance(color->channels);
    luxel_chromaticity seen;
    luxel_find_chromaticity(color->channels, &seen);
    if (!(luminance > 0) || !seen.has_xy)
        lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_COLOR_DARK, NULL);
    else if (!lx_is_light(seen.xy))
        lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_COLOR_NO_LIGHT, NULL);
    else
        for (int i = 0; i < 3; i++)
            color->channels[i] /= luminance;
}

static void check_color(const struct lx_check *check, void *parameters)
{
    struct lx_light_color *color = parameters;
    if (check->advises)
        return;
    if (lx_is_given(&lx_light_color_table, color, "rgb")) {
        memcpy(color->channels, color->rgb, sizeof color->rgb);
        take_rgb(check, color, "rgb");
    } else if (lx_is_given(&lx_light_color_table, color, "spectrum")) {
        if (load_spectrum(check, color))
            luxel_xy_to_rgb(color->read->xy, color->channels);
    } else if (lx_is_given(&lx_light_color_table, color, "temperature")) {
        double xy[2];
        luxel_planck_xy(color->temperature, xy);
        luxel_xy_to_rgb(xy, color->channels);
    } else if (!(color->xy[1] > 0)) {
        lx_check_report(check, "xy", 1, LX_MSG_COLOR_DARK, NULL);
    } else if (!lx_is_light(color->xy)) {
        lx_check_report(check, "xy", LX_ALL_OF_IT, LX_MSG_COLOR_NO_LIGHT, NULL);
    } else {
        luxel_xy_to_rgb(color->xy, color->channels);
    }
}

const struct lx_table lx_light_color_table = {
    .parameters = color_parameters,
    .count = LX_COUNT(color_parameters),
    .rules = color_rules,
    .rule_count = LX_COUNT(color_rules),
    .size = sizeof(struct lx_light_color),
    .check = check_color,
    .release = release_color,
};
