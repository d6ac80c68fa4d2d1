/* SPDX-License-Identifier: MIT */
/*
 * Reading LM-63: the numbers behind TILT, which lines and columns do not order: the header, the angles and the candela
 * values.  All of them are looked at, so that one reading tells everything that is wrong.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/number.h"
#include "photometry_lm63.h"

static const double MM_PER_FOOT = 304.8;

static const char *const names[LX_LM63_NUMBERS] = {
    LX_N("the number of lamps"),
    LX_N("the lumens of a lamp"),
    LX_N("the multiplier of the candela values"),
    LX_N("the number of vertical angles"),
    LX_N("the number of horizontal angles"),
    LX_N("the photometric type"),
    LX_N("the unit of length"),
    LX_N("the width of the opening"),
    LX_N("the length of the opening"),
    LX_N("the height of the opening"),
    LX_N("the ballast factor"),
    LX_N("the number behind the ballast factor"),
    LX_N("the input power in watts"),
};

static const char vertical[] = LX_N("the vertical angle"), horizontal[] = LX_N("the horizontal angle"),
                  value_name[] = LX_N("a candela value");

/* ---- words and numbers ---- */

static bool is_between(const struct lx_lm63 *lm63, char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r') || (c == ',' && !lm63->decimal_commas);
}

bool lx_lm63_word(struct lx_lm63 *lm63, struct lx_token *token)
{
    const struct lx_luminaire_file *file = lm63->file;
    size_t at = file->at;
    while (at < file->length && is_between(lm63, file->text[at]))
        at++;
    token->start = at;
    while (at < file->length && !is_between(lm63, file->text[at]))
        at++;
    token->end = lm63->file->at = at;
    return token->end > token->start;
}

static void report_no_number(struct lx_lm63 *lm63, const char *name, struct lx_token token)
{
    struct lx_luminaire_file *file = lm63->file;
    const char *word = file->text + token.start;
    size_t length = token.end - token.start;
    char *text = lx_keeps(file->diagnostics, LUXEL_SEVERITY_ERROR) ? lx_copy_text(word, length) : NULL;
    enum lx_message message =
        lx_looks_like_number(word, length) ? LX_MSG_PHOTOMETRY_NOT_FINITE : LX_MSG_PHOTOMETRY_NUMBER;
    lx_luminaire_error(file, token.start, token.end, message, LX_ARGS(LX_TERM(name), text ? text : ""));
    free(text);
    if (*word == ';' || *word == '!' || *word == '#' || *word == '/')
        lx_hint(file->diagnostics, LX_MSG_HINT_LM63_COMMENT, NULL);
}

static bool read_word(struct lx_lm63 *lm63, struct lx_token token, double *number)
{
    return lx_luminaire_number(lm63->file->text + token.start, token.end - token.start, lm63->decimal_commas, number);
}

bool lx_lm63_next(struct lx_lm63 *lm63, const char *name, double *number, struct lx_token *token)
{
    *number = (double)NAN;
    if (!lx_lm63_word(lm63, token)) {
        lx_luminaire_error(lm63->file, lm63->file->length, lm63->file->length, LX_MSG_PHOTOMETRY_ENDS,
                           LX_ARGS(LX_TERM(name)));
        return false;
    }
    if (!read_word(lm63, *token, number))
        report_no_number(lm63, name, *token);
    return true;
}

void lx_lm63_unfit(struct lx_lm63 *lm63, const char *name, double number, struct lx_token token, const char *expected)
{
    char shown[LX_SHOWN_SIZE];
    lx_luminaire_error(lm63->file, token.start, token.end, LX_MSG_PHOTOMETRY_UNFIT,
                       LX_ARGS(LX_TERM(name), lx_shown(number, shown), LX_TERM(expected)));
}

/* ---- decimal commas ---- */

/* The next word as a number, in a trial that reports nothing; NaN: none. */
static double try_number(struct lx_lm63 *trial)
{
    struct lx_token token;
    double number;
    return lx_lm63_word(trial, &token) && read_word(trial, token, &number) ? number : (double)NAN;
}

/* Whether the file holds just as many numbers as its header announces. */
static bool fits(const struct lx_lm63 *lm63, bool decimal_commas)
{
    struct lx_luminaire_file file = *lm63->file;
    struct lx_lm63 trial = {.file = &file, .decimal_commas = decimal_commas};
    struct lx_token token;
    double numbers[LX_LM63_NUMBERS], count = 0, wanted = 0;
    if (lm63->has_tilt) {
        try_number(&trial);
        wanted = 2 * try_number(&trial);
        for (double i = 0; i < wanted; i++)
            if (!lx_lm63_word(&trial, &token))
                return false;
    }
    for (int i = 0; i < LX_LM63_NUMBERS; i++)
        numbers[i] = try_number(&trial);
    wanted = numbers[LX_LM63_ANGLES] + numbers[LX_LM63_PLANES] + numbers[LX_LM63_ANGLES] * numbers[LX_LM63_PLANES];
    while (lx_lm63_word(&trial, &token))
        count++;
    return count == wanted;
}

void lx_lm63_judge_commas(struct lx_lm63 *lm63)
{
    const struct lx_luminaire_file *file = lm63->file;
    const char *from = file->text + file->at, *end = file->text + file->length, *comma = from;
    if (memchr(from, '.', (size_t)(end - from)))
        return;
    for (; (comma = memchr(comma, ',', (size_t)(end - comma))) != NULL; comma++) {
        bool is_within = comma > from && comma[-1] >= '0' && comma[-1] <= '9' && comma + 1 < end && comma[1] >= '0' &&
                         comma[1] <= '9';
        if (!is_within)
            continue;
        lm63->decimal_commas = !fits(lm63, false) && fits(lm63, true);
        size_t at = (size_t)(comma - file->text);
        if (lm63->decimal_commas)
            lx_luminaire_advise(lm63->file, at, at + 1, LX_MSG_LM63_COMMAS, NULL);
        return;
    }
}

/* ---- TILT ---- */

void lx_lm63_read_tilt(struct lx_lm63 *lm63)
{
    static const char geometry_name[] = LX_N("how the lamp lies in the luminaire (TILT)"),
                      count_name[] = LX_N("the number of angles of TILT"), angle_name[] = LX_N("the angle of TILT"),
                      factor_name[] = LX_N("a factor of TILT");
    struct lx_luminaire_file *file = lm63->file;
    struct lx_photometry *made = file->made;
    struct lx_token token;
    double geometry, count;
    if (!lx_lm63_next(lm63, geometry_name, &geometry, &token))
        return;
    if (geometry != 1 && geometry != 2 && geometry != 3 && !isnan(geometry))
        lx_lm63_unfit(lm63, geometry_name, geometry, token, LX_N("1, 2 or 3"));
    if (!lx_lm63_next(lm63, count_name, &count, &token) || isnan(count))
        return;
    if (count < 1 || count != floor(count) || count > (double)(file->length - file->at)) {
        lx_lm63_unfit(lm63, count_name, count, token, LX_N("a whole number above 0 of numbers that are there"));
        return;
    }
    size_t wanted = (size_t)count;
    struct lx_token *tokens = lx_new_array(wanted, sizeof *tokens);
    free(made->tilt_angles);
    free(made->tilt_factors);
    made->tilt_angles = lx_new_array(wanted, sizeof(double));
    made->tilt_factors = lx_new_array(wanted, sizeof(double));
    file->no_memory = file->no_memory || !tokens || !made->tilt_angles || !made->tilt_factors;
    size_t i = 0;
    for (; !file->no_memory && i < 2 * wanted; i++) {
        double *to = i < wanted ? &made->tilt_angles[i] : &made->tilt_factors[i - wanted];
        if (!lx_lm63_next(lm63, i < wanted ? angle_name : factor_name, to, i < wanted ? &tokens[i] : &token))
            break;
        if (i >= wanted && *to < 0)
            lx_lm63_unfit(lm63, factor_name, *to, token, LX_N("a number from 0 on"));
    }
    if (i == 2 * wanted) {
        lx_check_angles(file, angle_name, made->tilt_angles, tokens, wanted, -180, 180);
        made->shown.tilt_geometry = geometry >= 1 && geometry <= 3 ? (unsigned)geometry : 0;
        made->shown.tilt_count = wanted;
    }
    free(tokens);
}

/* ---- the header ---- */

static void expect(struct lx_lm63 *lm63, enum lx_lm63_number which, bool holds, const char *expected)
{
    double number = lm63->numbers[which];
    if (!holds && !isnan(number))
        lx_lm63_unfit(lm63, names[which], number, lm63->tokens[which], expected);
}

static void advise(struct lx_lm63 *lm63, enum lx_lm63_number which, bool holds, enum lx_message message)
{
    char shown[LX_SHOWN_SIZE];
    struct lx_token token = lm63->tokens[which];
    if (!holds && !isnan(lm63->numbers[which]))
        lx_luminaire_advise(lm63->file, token.start, token.end, message,
                            LX_ARGS(lx_shown(lm63->numbers[which], shown)));
}

static bool is_count(double number, double least)
{
    return number >= least && number == floor(number);
}

/*
 * Whether the three numbers behind the ten are missing: only without them there are as many as are announced.  Words
 * that are no numbers do not count.
 */
static bool lacks_three(const struct lx_lm63 *lm63)
{
    struct lx_luminaire_file file = *lm63->file;
    struct lx_lm63 trial = {.file = &file, .decimal_commas = lm63->decimal_commas};
    struct lx_token token;
    double count = 0, number, angles = lm63->numbers[LX_LM63_ANGLES], planes = lm63->numbers[LX_LM63_PLANES];
    while (lx_lm63_word(&trial, &token))
        count += read_word(&trial, token, &number);
    return count == angles + planes + angles * planes;
}

/* The three numbers, or what is taken for them where they are missing. */
static bool read_three(struct lx_lm63 *lm63)
{
    static const double most_usual = 5; /* ballast factors are near 1 */
    struct lx_token token;
    size_t at = lm63->file->at;
    double ballast = lx_lm63_word(lm63, &token) && read_word(lm63, token, &ballast) ? ballast : 1;
    lm63->file->at = at;
    if (!(ballast > 0 && ballast <= most_usual) && lacks_three(lm63)) {
        lx_luminaire_error(lm63->file, token.start, token.end, LX_MSG_LM63_THREE, NULL);
        for (int i = LX_LM63_BALLAST; i < LX_LM63_NUMBERS; i++)
            lm63->numbers[i] = 1;
        return true;
    }
    for (int i = LX_LM63_BALLAST; i < LX_LM63_NUMBERS; i++)
        if (!lx_lm63_next(lm63, names[i], &lm63->numbers[i], &lm63->tokens[i]))
            return false;
    return true;
}

static bool read_header(struct lx_lm63 *lm63)
{
    const double *numbers = lm63->numbers;
    for (int i = 0; i < LX_LM63_BALLAST; i++)
        if (!lx_lm63_next(lm63, names[i], &lm63->numbers[i], &lm63->tokens[i]))
            return false;
    if (!read_three(lm63))
        return false;
    double type = numbers[LX_LM63_TYPE], units = numbers[LX_LM63_UNITS];
    expect(lm63, LX_LM63_TYPE, type == 1 || type == 2 || type == 3, LX_N("1 (type C), 2 (type B) or 3 (type A)"));
    expect(lm63, LX_LM63_UNITS, units == 1 || units == 2, LX_N("1 (feet) or 2 (metres)"));
    expect(lm63, LX_LM63_ANGLES, is_count(numbers[LX_LM63_ANGLES], 2), LX_N("a whole number from 2 on"));
    expect(lm63, LX_LM63_PLANES, is_count(numbers[LX_LM63_PLANES], 1), LX_N("a whole number from 1 on"));
    expect(lm63, LX_LM63_MULTIPLIER, numbers[LX_LM63_MULTIPLIER] > 0, LX_N("a number above 0"));
    expect(lm63, LX_LM63_BALLAST, numbers[LX_LM63_BALLAST] > 0, LX_N("a number above 0"));
    if (lm63->year < 1995)
        expect(lm63, LX_LM63_LAMP_BALLAST, numbers[LX_LM63_LAMP_BALLAST] > 0, LX_N("a number above 0"));
    advise(lm63, LX_LM63_LAMPS, numbers[LX_LM63_LAMPS] > 0, LX_MSG_LM63_LAMPS);
    advise(lm63, LX_LM63_LUMENS, numbers[LX_LM63_LUMENS] > 0 || numbers[LX_LM63_LUMENS] == -1, LX_MSG_LM63_LUMENS);
    advise(lm63, LX_LM63_WATTS, numbers[LX_LM63_WATTS] >= 0, LX_MSG_LM63_WATTS);
    return true;
}

static void take_opening(struct lx_lm63 *lm63)
{
    const double *numbers = lm63->numbers;
    double unit = numbers[LX_LM63_UNITS] == 1 ? MM_PER_FOOT : 1000;
    struct lx_token from = lm63->tokens[LX_LM63_WIDTH], to = lm63->tokens[LX_LM63_HEIGHT];
    if (!lx_lm63_opening(lm63->year, numbers[LX_LM63_WIDTH] * unit, numbers[LX_LM63_LENGTH] * unit,
                         numbers[LX_LM63_HEIGHT] * unit, &lm63->file->made->shown.opening))
        lx_luminaire_advise(lm63->file, from.start, to.end, LX_MSG_LM63_OPENING, NULL);
}

/* Keywords of a colour temperature and of colour rendering: LM-63 has none, its users have these. */
static const char *const temperatures[] = {"COLORTEMP",         "_COLORTEMP", "CCT",         "_CCT", "COLORTEMPERATURE",
                                           "_COLORTEMPERATURE", "COLOR_TEMP", "_COLOR_TEMP", NULL};
static const char *const renderings[] = {"CRI", "_CRI", "COLORRENDERING", "_COLORRENDERING", "RA", "_RA", NULL};

/* A copy of the text of the first of some keywords that there is, else of "". */
static char *copy_first(const luxel_photometry *shown, const char *const *keywords)
{
    const char *text = NULL;
    for (size_t i = 0; keywords[i] && !text; i++)
        text = luxel_photometry_find_text(shown, keywords[i]);
    return lx_copy_text(text ? text : "", text ? strlen(text) : 0);
}

static void take_header(struct lx_lm63 *lm63)
{
    struct lx_luminaire_file *file = lm63->file;
    luxel_photometry *shown = &file->made->shown;
    const double *numbers = lm63->numbers;
    bool has_lumens = numbers[LX_LM63_LAMPS] > 0 && numbers[LX_LM63_LUMENS] > 0;
    static const luxel_photometry_type types[] = {LUXEL_PHOTOMETRY_TYPE_C, LUXEL_PHOTOMETRY_TYPE_B,
                                                  LUXEL_PHOTOMETRY_TYPE_A};
    shown->format = LUXEL_PHOTOMETRY_LM_63;
    shown->year = lm63->year;
    shown->type = types[(int)numbers[LX_LM63_TYPE] - 1];
    shown->is_absolute = numbers[LX_LM63_LUMENS] < 0;
    shown->declared_lumens = has_lumens ? numbers[LX_LM63_LAMPS] * numbers[LX_LM63_LUMENS] : (double)NAN;
    shown->declared_lorl = shown->declared_dff = (double)NAN;
    shown->multiplier = numbers[LX_LM63_MULTIPLIER] * numbers[LX_LM63_BALLAST] *
                        (lm63->year < 1995 ? numbers[LX_LM63_LAMP_BALLAST] : 1);
    shown->watts = numbers[LX_LM63_WATTS];
    take_opening(lm63);
    luxel_photometry_lamp_set *lamps = lx_luminaire_add_lamps(file);
    if (!lamps)
        return;
    shown->texts = file->made->texts;
    lamps->count = numbers[LX_LM63_LAMPS];
    lamps->type = copy_first(shown, (const char *const[]){"LAMP", NULL});
    lamps->temperature = copy_first(shown, temperatures);
    lamps->rendering = copy_first(shown, renderings);
    lamps->lumens = shown->declared_lumens;
    lamps->watts = shown->watts;
    file->no_memory = file->no_memory || !lamps->type || !lamps->temperature || !lamps->rendering;
}

/* ---- the horizontal angles ---- */

static bool is_near(double a, double b)
{
    return fabs(a - b) <= 1e-6;
}

static void report_planes(struct lx_lm63 *lm63, const struct lx_token *tokens, size_t count, bool is_error,
                          enum lx_message message)
{
    const double *planes = lm63->file->table.planes;
    char first[LX_SHOWN_SIZE], last[LX_SHOWN_SIZE];
    const char *const *arguments = LX_ARGS(lx_shown(planes[0], first), lx_shown(planes[count - 1], last));
    if (is_error)
        lx_luminaire_error(lm63->file, tokens[0].start, tokens[count - 1].end, message, arguments);
    else
        lx_luminaire_advise(lm63->file, tokens[0].start, tokens[count - 1].end, message, arguments);
}

/* The symmetry that the planes of type C tell. */
static void judge_turn(struct lx_lm63 *lm63, const struct lx_token *tokens, size_t count)
{
    luxel_photometry *shown = &lm63->file->made->shown;
    struct lx_stored_table *table = &lm63->file->table;
    double first = table->planes[0], last = table->planes[count - 1];
    shown->symmetry = LUXEL_SYMMETRY_NONE;
    if (count == 1) {
        shown->symmetry = LUXEL_SYMMETRY_AXIAL;
        if (first != 0)
            report_planes(lm63, tokens, count, false, LX_MSG_LM63_SINGLE_PLANE);
    } else if (is_near(last - first, 360)) {
        table->is_turn = true;
        if (first != 0)
            report_planes(lm63, tokens, count, false, LX_MSG_LM63_TURN);
    } else if (is_near(first, 0) && is_near(last, 90)) {
        shown->symmetry = LUXEL_SYMMETRY_QUADRANT;
    } else if (is_near(first, 0) && is_near(last, 180)) {
        shown->symmetry = LUXEL_SYMMETRY_BILATERAL_0;
    } else if (is_near(first, 90) && is_near(last, 270)) {
        shown->symmetry = LUXEL_SYMMETRY_BILATERAL_90;
        if (lm63->year != 1995 && !lm63->is_odd_tag)
            report_planes(lm63, tokens, count, false, LX_MSG_LM63_PLANES_90);
    } else if (is_near(first, 0) && last > 180 && is_near(last + (last - table->planes[count - 2]), 360)) {
        report_planes(lm63, tokens, count, false, LX_MSG_LM63_OPEN_TURN);
    } else {
        report_planes(lm63, tokens, count, true, LX_MSG_LM63_PLANES);
        lx_hint(lm63->file->diagnostics, LX_MSG_HINT_LM63_PLANES, NULL);
    }
}

static void judge_planes(struct lx_lm63 *lm63, const struct lx_token *tokens, size_t count)
{
    luxel_photometry *shown = &lm63->file->made->shown;
    const double *planes = lm63->file->table.planes;
    for (size_t i = 0; i < count; i++)
        if (isnan(planes[i]))
            return;
    if (shown->type == LUXEL_PHOTOMETRY_TYPE_C) {
        if (lx_check_angles(lm63->file, horizontal, planes, tokens, count, -360, 720))
            judge_turn(lm63, tokens, count);
        return;
    }
    double most = shown->type == LUXEL_PHOTOMETRY_TYPE_B ? 90 : 180;
    if (!lx_check_angles(lm63->file, horizontal, planes, tokens, count, -most, most))
        return;
    shown->symmetry = planes[0] == 0 ? LUXEL_SYMMETRY_LATERAL : LUXEL_SYMMETRY_NONE;
    if (count < 2)
        lx_lm63_unfit(lm63, names[LX_LM63_PLANES], 1, lm63->tokens[LX_LM63_PLANES], LX_N("2 or more in types A and B"));
    else if (!is_near(planes[count - 1], 90) || !(is_near(planes[0], -90) || is_near(planes[0], 0)))
        report_planes(lm63, tokens, count, false, LX_MSG_LM63_SIDES);
}

/* ---- the vertical angles ---- */

static void judge_angles(struct lx_lm63 *lm63, const struct lx_token *tokens, size_t count)
{
    luxel_photometry_type type = lm63->file->made->shown.type;
    const double *angles = lm63->file->table.angles;
    double low = type == LUXEL_PHOTOMETRY_TYPE_C ? 0 : type == LUXEL_PHOTOMETRY_TYPE_A ? -90 : -180;
    double high = type == LUXEL_PHOTOMETRY_TYPE_A ? 90 : 180;
    char first[LX_SHOWN_SIZE], last[LX_SHOWN_SIZE];
    if (!lx_check_angles(lm63->file, vertical, angles, tokens, count, low, high))
        return;
    double from = angles[0], to = angles[count - 1];
    bool is_usual = type == LUXEL_PHOTOMETRY_TYPE_C
                        ? (is_near(from, 0) || is_near(from, 90)) && (is_near(to, 90) || is_near(to, 180))
                        : is_near(from, -90) && is_near(to, 90);
    if (!is_usual && !isnan(from) && !isnan(to))
        lx_luminaire_advise(lm63->file, tokens[0].start, tokens[count - 1].end, LX_MSG_PHOTOMETRY_DARK,
                            LX_ARGS(LX_TERM(vertical), lx_shown(from, first), lx_shown(to, last)));
}

/* ---- the table ---- */

static bool read_angles(struct lx_lm63 *lm63, const char *name, double *angles, struct lx_token *tokens, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!lx_lm63_next(lm63, name, &angles[i], &tokens[i]))
            return false;
    return true;
}

static void read_values(struct lx_lm63 *lm63, size_t count)
{
    struct lx_luminaire_file *file = lm63->file;
    double *values = file->table.intensities, multiplier = file->made->shown.multiplier;
    struct lx_token token;
    multiplier = multiplier > 0 ? multiplier : 1; /* a wrong one is reported already */
    for (size_t i = 0; i < count; i++) {
        if (!lx_lm63_word(lm63, &token)) {
            char missing[LX_SHOWN_SIZE], planes[LX_SHOWN_SIZE], angles[LX_SHOWN_SIZE];
            lx_luminaire_error(file, file->length, file->length, LX_MSG_PHOTOMETRY_SHORT,
                               LX_ARGS(lx_shown((double)file->table.plane_count, planes),
                                       lx_shown((double)file->table.angle_count, angles),
                                       lx_shown((double)(count - i), missing)));
            return;
        }
        if (!read_word(lm63, token, &values[i]))
            report_no_number(lm63, value_name, token);
        else if (values[i] < 0)
            lx_lm63_unfit(lm63, value_name, values[i], token, LX_N("a number from 0 on"));
        else if (!isfinite(values[i] *= multiplier))
            report_no_number(lm63, value_name, token);
    }
    if (lx_lm63_word(lm63, &token))
        lx_luminaire_advise(file, token.start, token.end, LX_MSG_PHOTOMETRY_SURPLUS, NULL);
}

/* Planes 0 and 360 are one; how far they are apart, of the greatest intensity. */
static void compare_seam(struct lx_lm63 *lm63, const struct lx_token *tokens)
{
    const struct lx_stored_table *table = &lm63->file->table;
    size_t angles = table->angle_count, last = table->plane_count - 1;
    double apart = 0, greatest = 0;
    char share[LX_SHOWN_SIZE];
    for (size_t i = 0; i < table->plane_count * angles; i++)
        greatest = fmax(greatest, table->intensities[i]);
    for (size_t j = 0; j < angles; j++)
        apart = fmax(apart, fabs(table->intensities[j] - table->intensities[last * angles + j]));
    if (apart > 0.001 * greatest)
        lx_luminaire_advise(lm63->file, tokens[last].start, tokens[last].end, LX_MSG_PHOTOMETRY_SEAM,
                            LX_ARGS(lx_write_digits(100 * apart / greatest, 3, share)));
}

/* What the header announces must have room in the file: a digit and a blank for each number. */
static bool has_room(struct lx_lm63 *lm63, double angles, double planes)
{
    struct lx_luminaire_file *file = lm63->file;
    double wanted = angles + planes + angles * planes, room = (double)(file->length - file->at + 1) / 2;
    if (wanted <= room)
        return true;
    char first[LX_SHOWN_SIZE], second[LX_SHOWN_SIZE];
    struct lx_token token;
    size_t at = file->at, found = 0;
    while (lx_lm63_word(lm63, &token))
        found++;
    file->at = at;
    struct lx_token from = lm63->tokens[LX_LM63_ANGLES], to = lm63->tokens[LX_LM63_PLANES];
    lx_luminaire_error(file, from.start, to.end, LX_MSG_PHOTOMETRY_ROOM,
                       LX_ARGS(lx_shown(wanted, first), lx_shown((double)found, second)));
    return false;
}

static void read_table(struct lx_lm63 *lm63, size_t angles, size_t planes)
{
    struct lx_luminaire_file *file = lm63->file;
    struct lx_stored_table *table = &file->table;
    struct lx_token *angle_tokens = lx_new_array(angles, sizeof *angle_tokens);
    struct lx_token *plane_tokens = lx_new_array(planes, sizeof *plane_tokens);
    *table = (struct lx_stored_table){lx_new_array(planes, sizeof(double)),
                                      lx_new_array(angles, sizeof(double)),
                                      lx_new_array(planes, angles * sizeof(double)),
                                      planes,
                                      angles,
                                      false};
    bool has_memory = angle_tokens && plane_tokens && table->planes && table->angles && table->intensities;
    file->no_memory = file->no_memory || !has_memory;
    if (has_memory && read_angles(lm63, vertical, table->angles, angle_tokens, angles) &&
        read_angles(lm63, horizontal, table->planes, plane_tokens, planes)) {
        judge_angles(lm63, angle_tokens, angles);
        judge_planes(lm63, plane_tokens, planes);
        read_values(lm63, planes * angles);
        if (table->is_turn && file->errors == 0)
            compare_seam(lm63, plane_tokens);
    }
    free(angle_tokens);
    free(plane_tokens);
}

void lx_lm63_read_numbers(struct lx_lm63 *lm63)
{
    struct lx_luminaire_file *file = lm63->file;
    if (!read_header(lm63))
        return;
    double angles = lm63->numbers[LX_LM63_ANGLES], planes = lm63->numbers[LX_LM63_PLANES];
    double type = lm63->numbers[LX_LM63_TYPE];
    if (type != 1 && type != 2 && type != 3)
        return; /* what the angles mean is not known */
    take_header(lm63);
    file->made->shown.declared_planes = is_count(planes, 1) && planes < 1e9 ? (size_t)planes : 0;
    if (!is_count(angles, 2) || !is_count(planes, 1) || !has_room(lm63, angles, planes))
        return;
    read_table(lm63, (size_t)angles, (size_t)planes);
}
