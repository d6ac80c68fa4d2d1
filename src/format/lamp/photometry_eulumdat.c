/* SPDX-License-Identifier: MIT */
/*
 * Reading EULUMDAT (.ldt): one text or number a line, in a fixed order; a blank line where a number is expected is 0.
 * A file with symmetry holds only some of the planes that it announces.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/number.h"
#include "photometry.h"

enum { DIRECT_RATIOS = 10, USUAL_LAMP_SETS = 20 };

/* A file, and what its head says. */
struct eulumdat {
    struct lx_luminaire_file *file;
    size_t line;
    double kind, symmetry, planes, angles, lorl, dff, conversion, sets, lumens;
    double opening[6]; /* length, width, and the heights at C0, C90, C180, C270 */
    struct lx_token planes_token, angles_token, lumens_token, symmetry_token;
};

/* ---- lines ---- */

static const char plane_name[] = LX_N("a C plane"), gamma_name[] = LX_N("an angle gamma"),
                  value_name[] = LX_N("an intensity");

/* The next line; false: the file ends, which is reported under the name of what is expected. */
static bool next_line(struct eulumdat *read, const char *name, struct lx_token *token)
{
    struct lx_luminaire_file *file = read->file;
    if (lx_luminaire_line(file, &token->start, &token->end)) {
        read->line++;
        return true;
    }
    lx_luminaire_error(file, file->length, file->length, LX_MSG_PHOTOMETRY_ENDS, LX_ARGS(LX_TERM(name)));
    return false;
}

static void unfit(struct eulumdat *read, const char *name, double number, struct lx_token token, const char *expected)
{
    char shown[LX_SHOWN_SIZE];
    lx_luminaire_error(read->file, token.start, token.end, LX_MSG_PHOTOMETRY_UNFIT,
                       LX_ARGS(LX_TERM(name), lx_shown(number, shown), LX_TERM(expected)));
}

/* A number; one that is none is reported and becomes NaN, a blank line is 0.  False: the file ends. */
static bool next_number(struct eulumdat *read, const char *name, double *number, struct lx_token *token)
{
    struct lx_luminaire_file *file = read->file;
    *number = 0;
    if (!next_line(read, name, token))
        return false;
    const char *line = file->text + token->start;
    size_t length = token->end - token->start;
    if (length == 0 || lx_luminaire_number(line, length, true, number))
        return true;
    *number = (double)NAN;
    char *text = lx_keeps(file->diagnostics, LUXEL_SEVERITY_ERROR) ? lx_copy_text(line, length) : NULL;
    enum lx_message message =
        lx_looks_like_number(line, length) ? LX_MSG_PHOTOMETRY_NOT_FINITE : LX_MSG_PHOTOMETRY_NUMBER;
    lx_luminaire_error(file, token->start, token->end, message, LX_ARGS(LX_TERM(name), text ? text : ""));
    free(text);
    return true;
}

/* A text that is kept under a keyword of LM-63; "" is not kept. */
static bool next_text(struct eulumdat *read, const char *name, const char *keyword)
{
    struct lx_token token;
    if (!next_line(read, name, &token))
        return false;
    if (token.end > token.start)
        lx_luminaire_add_text(read->file, lx_copy_text(keyword, strlen(keyword)),
                              lx_luminaire_text(read->file, token.start, token.end));
    return true;
}

/* ---- the head ---- */

static bool is_count(double number, double least, double most)
{
    return number >= least && number <= most && number == floor(number);
}

static bool read_kind(struct eulumdat *read)
{
    struct lx_token kind, unused;
    double step;
    if (!next_text(read, LX_N("the maker"), "MANUFAC") ||
        !next_number(read, LX_N("the kind of luminaire"), &read->kind, &kind) ||
        !next_number(read, LX_N("the symmetry"), &read->symmetry, &read->symmetry_token) ||
        !next_number(read, LX_N("the number of C planes"), &read->planes, &read->planes_token) ||
        !next_number(read, LX_N("the step between C planes"), &step, &unused) ||
        !next_number(read, LX_N("the number of angles gamma"), &read->angles, &read->angles_token) ||
        !next_number(read, LX_N("the step between angles gamma"), &step, &unused))
        return false;
    if (!is_count(read->kind, 0, 3) && !isnan(read->kind)) {
        char shown[LX_SHOWN_SIZE];
        lx_luminaire_advise(read->file, kind.start, kind.end, LX_MSG_EULUMDAT_KIND,
                            LX_ARGS(lx_shown(read->kind, shown)));
    }
    if (!is_count(read->symmetry, 0, 4) && !isnan(read->symmetry))
        unfit(read, LX_N("the symmetry"), read->symmetry, read->symmetry_token, LX_N("0, 1, 2, 3 or 4"));
    if (!is_count(read->planes, 1, 1e9) && !isnan(read->planes))
        unfit(read, LX_N("the number of C planes"), read->planes, read->planes_token, LX_N("a whole number from 1 on"));
    if (!is_count(read->angles, 2, 1e9) && !isnan(read->angles))
        unfit(read, LX_N("the number of angles gamma"), read->angles, read->angles_token,
              LX_N("a whole number from 2 on"));
    return true;
}

static bool read_texts(struct eulumdat *read)
{
    return next_text(read, LX_N("the number of the report"), "TEST") &&
           next_text(read, LX_N("the name of the luminaire"), "LUMINAIRE") &&
           next_text(read, LX_N("the number of the luminaire"), "LUMCAT") &&
           next_text(read, LX_N("the name of the file"), "_FILE") && next_text(read, LX_N("the date"), "ISSUEDATE");
}

static bool read_sizes(struct eulumdat *read)
{
    static const char *const housing_names[] = {LX_N("the length of the luminaire"), LX_N("the width of the luminaire"),
                                                LX_N("the height of the luminaire")};
    static const char *const opening_names[] = {
        LX_N("the length of the luminous area"),         LX_N("the width of the luminous area"),
        LX_N("the height of the luminous area at C0"),   LX_N("the height of the luminous area at C90"),
        LX_N("the height of the luminous area at C180"), LX_N("the height of the luminous area at C270")};
    luxel_photometry *shown = &read->file->made->shown;
    struct lx_token token;
    for (int i = 0; i < 9; i++) {
        const char *name = i < 3 ? housing_names[i] : opening_names[i - 3];
        double *to = i < 3 ? &shown->housing_mm[i] : &read->opening[i - 3];
        if (!next_number(read, name, to, &token))
            return false;
        if (*to < 0)
            unfit(read, name, *to, token, LX_N("a number from 0 on"));
    }
    return true;
}

static bool read_ratios(struct eulumdat *read)
{
    static const char conversion[] = LX_N("the conversion factor for intensities"),
                      sets[] = LX_N("the number of lamp sets");
    struct lx_token token;
    double tilt;
    if (!next_number(read, LX_N("the downward flux fraction"), &read->dff, &token) ||
        !next_number(read, LX_N("the light output ratio"), &read->lorl, &token) ||
        !next_number(read, conversion, &read->conversion, &token))
        return false;
    if (!(read->conversion > 0) && !isnan(read->conversion))
        unfit(read, conversion, read->conversion, token, LX_N("a number above 0"));
    if (!next_number(read, LX_N("the tilt of the luminaire"), &tilt, &token) ||
        !next_number(read, sets, &read->sets, &token))
        return false;
    if (!is_count(read->sets, 1, 1e9) && !isnan(read->sets))
        unfit(read, sets, read->sets, token, LX_N("a whole number from 1 on"));
    else if (read->sets > 1)
        lx_luminaire_advise(read->file, token.start, token.end,
                            read->sets > USUAL_LAMP_SETS ? LX_MSG_EULUMDAT_MANY_SETS : LX_MSG_EULUMDAT_SETS, NULL);
    return true;
}

/* A text of a lamp set, as the caller's. */
static bool lamp_text(struct eulumdat *read, const char *name, const char **text)
{
    struct lx_token token;
    if (!next_line(read, name, &token))
        return false;
    *text = lx_luminaire_text(read->file, token.start, token.end);
    return true;
}

static bool read_lamp_set(struct eulumdat *read, bool is_first)
{
    static const char count_name[] = LX_N("the number of lamps"), flux_name[] = LX_N("the flux of the lamps");
    struct lx_token token;
    luxel_photometry_lamp_set *lamps = lx_luminaire_add_lamps(read->file);
    if (!lamps || !next_number(read, count_name, &lamps->count, &token) ||
        !lamp_text(read, LX_N("the type of lamp"), &lamps->type) ||
        !next_number(read, flux_name, &lamps->lumens, &read->lumens_token) ||
        !lamp_text(read, LX_N("the colour temperature"), &lamps->temperature) ||
        !lamp_text(read, LX_N("the colour rendering"), &lamps->rendering) ||
        !next_number(read, LX_N("the power of the lamps"), &lamps->watts, &token))
        return false;
    if (is_first && !(lamps->lumens > 0) && !isnan(lamps->lumens))
        unfit(read, flux_name, lamps->lumens, read->lumens_token,
              LX_N("a number above 0, as intensities are in cd/klm"));
    return true;
}

static bool read_lamps(struct eulumdat *read)
{
    double ratio;
    struct lx_token token;
    if (!is_count(read->sets, 1, 1e9))
        return false; /* where the angles begin is not known */
    for (double i = 0; i < read->sets; i++)
        if (!read_lamp_set(read, i == 0))
            return false;
    for (int i = 0; i < DIRECT_RATIOS; i++)
        if (!next_number(read, LX_N("a direct ratio"), &ratio, &token))
            return false;
    return true;
}

static void take_opening(struct eulumdat *read)
{
    const double *numbers = read->opening;
    double height = fmax(fmax(numbers[2], numbers[3]), fmax(numbers[4], numbers[5]));
    bool is_round = numbers[1] == 0;
    luxel_photometry_opening opening = {
        .width_mm = numbers[0], .length_mm = is_round ? numbers[0] : numbers[1], .height_mm = height};
    if (!(numbers[0] > 0) && is_round)
        opening.shape = LUXEL_OPENING_POINT;
    else if (is_round)
        opening.shape = height > 0 ? LUXEL_OPENING_CYLINDER : LUXEL_OPENING_ELLIPSE;
    else
        opening.shape = height > 0 ? LUXEL_OPENING_BOX : LUXEL_OPENING_RECTANGLE;
    read->file->made->shown.opening = opening;
}

static void take_head(struct eulumdat *read)
{
    luxel_photometry *shown = &read->file->made->shown;
    const luxel_photometry_lamp_set *lamps = &read->file->made->lamp_sets[0];
    static const luxel_photometry_symmetry symmetries[] = {LUXEL_SYMMETRY_NONE, LUXEL_SYMMETRY_AXIAL,
                                                           LUXEL_SYMMETRY_BILATERAL_0, LUXEL_SYMMETRY_BILATERAL_90,
                                                           LUXEL_SYMMETRY_QUADRANT};
    shown->format = LUXEL_PHOTOMETRY_EULUMDAT;
    shown->type = LUXEL_PHOTOMETRY_TYPE_C;
    shown->symmetry = symmetries[is_count(read->symmetry, 0, 4) ? (int)read->symmetry : 0];
    shown->declared_planes = is_count(read->planes, 1, 1e9) ? (size_t)read->planes : 0;
    shown->is_absolute = lamps->count < 0;
    shown->declared_lumens = lamps->lumens;
    shown->declared_lorl = read->lorl > 0 ? read->lorl : (double)NAN;
    shown->declared_dff = read->dff > 0 ? read->dff : (double)NAN;
    shown->watts = lamps->watts;
    shown->multiplier = read->conversion * lamps->lumens / 1000;
    take_opening(read);
    if (shown->housing_mm[1] == 0) /* a diameter */
        shown->housing_mm[1] = shown->housing_mm[0];
}

/* ---- the angles ---- */

/* Whether the planes that symmetry divides at are where the format has them; `at` counts planes from the first. */
static bool stands(struct eulumdat *read, const double *planes, const struct lx_token *tokens, size_t at, double angle)
{
    char first[LX_SHOWN_SIZE], second[LX_SHOWN_SIZE];
    if (fabs(planes[at] - angle) <= 1e-3)
        return true;
    lx_luminaire_error(read->file, tokens[at].start, tokens[at].end, LX_MSG_EULUMDAT_PLANE,
                       LX_ARGS(lx_shown(angle, first), lx_shown(planes[at], second)));
    return false;
}

/* Whether planes stand in pairs about one of them, the `middle`-th at an angle. */
static bool is_mirrored(const double *planes, size_t count, size_t middle, double angle)
{
    for (size_t i = 1; i < count; i++) {
        double apart = planes[(middle + i) % count] + planes[(middle + count - i) % count] - 2 * angle;
        if (fabs(remainder(apart, 360)) > 1e-3)
            return false;
    }
    return true;
}

/* The planes that the file does not hold are said to mirror those that it does. */
static void check_mirror(struct eulumdat *read, const double *planes, const struct lx_token *tokens, size_t count)
{
    bool is_right = (read->symmetry == 3 || is_mirrored(planes, count, 0, 0)) &&
                    (read->symmetry == 2 || is_mirrored(planes, count, count / 4, 90));
    if (!is_right)
        lx_luminaire_advise(read->file, tokens[0].start, tokens[count - 1].end, LX_MSG_EULUMDAT_MIRROR, NULL);
}

/*
 * Which of the planes the file holds: the first one, and how many; 0: the file is wrong.  With Isym 3 they begin at
 * C270 and go on through C0 to C90.
 */
static size_t stored_planes(struct eulumdat *read, double *planes, const struct lx_token *tokens, size_t count,
                            size_t *first)
{
    static const int parts[] = {1, 1, 2, 2, 4};
    int symmetry = (int)read->symmetry, part = parts[symmetry];
    *first = 0;
    if (symmetry == 1)
        return 1;
    if (symmetry == 0)
        return count;
    if (count % (symmetry == 3 ? 4 : (size_t)part) != 0) {
        unfit(read, LX_N("the number of C planes"), (double)count, read->planes_token,
              symmetry == 2 ? LX_N("an even number for this symmetry") : LX_N("a multiple of 4 for this symmetry"));
        return 0;
    }
    check_mirror(read, planes, tokens, count);
    if (symmetry == 3) {
        *first = 3 * (count / 4);
        return stands(read, planes, tokens, *first, 270) && stands(read, planes, tokens, count / 4, 90) ? count / 2 + 1
                                                                                                        : 0;
    }
    size_t stored = count / (size_t)part;
    return stands(read, planes, tokens, 0, 0) && stands(read, planes, tokens, stored, 360.0 / part) ? stored + 1 : 0;
}

static bool read_list(struct eulumdat *read, const char *name, double *numbers, struct lx_token *tokens, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!next_number(read, name, &numbers[i], &tokens[i]))
            return false;
    return true;
}

/* A last plane C360 is the first one again. */
static void judge_turn(struct eulumdat *read, const struct lx_token *tokens, const double *planes, size_t count)
{
    struct lx_stored_table *table = &read->file->table;
    table->is_turn = read->symmetry == 0 && count > 1 && fabs(planes[count - 1] - planes[0] - 360) <= 1e-6;
    if (table->is_turn)
        lx_luminaire_advise(read->file, tokens[count - 1].start, tokens[count - 1].end, LX_MSG_EULUMDAT_TURN, NULL);
}

static void judge_gammas(struct eulumdat *read, const struct lx_token *tokens, const double *angles, size_t count)
{
    char from[LX_SHOWN_SIZE], to[LX_SHOWN_SIZE];
    double first = angles[0], last = angles[count - 1];
    if ((first != 0 && first != 90) || (last != 90 && last != 180))
        lx_luminaire_advise(read->file, tokens[0].start, tokens[count - 1].end, LX_MSG_PHOTOMETRY_DARK,
                            LX_ARGS(LX_TERM(gamma_name), lx_shown(first, from), lx_shown(last, to)));
}

/* ---- the intensities ---- */

static void read_values(struct eulumdat *read, size_t count)
{
    struct lx_luminaire_file *file = read->file;
    struct lx_stored_table *table = &file->table;
    double conversion = read->conversion > 0 ? read->conversion : 1;
    double lumens = file->made->shown.declared_lumens;
    lumens = lumens > 0 ? lumens : 1000; /* a wrong one is reported already */
    struct lx_token token;
    for (size_t i = 0; i < count; i++) {
        double *value = &table->intensities[i];
        if (file->at >= file->length) {
            char planes[LX_SHOWN_SIZE], angles[LX_SHOWN_SIZE], missing[LX_SHOWN_SIZE];
            lx_luminaire_error(file, file->length, file->length, LX_MSG_PHOTOMETRY_SHORT,
                               LX_ARGS(lx_shown((double)table->plane_count, planes),
                                       lx_shown((double)table->angle_count, angles),
                                       lx_shown((double)(count - i), missing)));
            return;
        }
        next_number(read, value_name, value, &token);
        if (*value < 0)
            unfit(read, value_name, *value, token, LX_N("a number from 0 on"));
        *value = *value * conversion * lumens / 1000;
        if (isinf(*value))
            lx_luminaire_error(file, token.start, token.end, LX_MSG_PHOTOMETRY_NOT_FINITE,
                               LX_ARGS(LX_TERM(value_name)));
    }
    while (lx_luminaire_line(file, &token.start, &token.end))
        if (token.end > token.start) {
            lx_luminaire_advise(file, token.start, token.end, LX_MSG_PHOTOMETRY_SURPLUS, NULL);
            return;
        }
}

/* What the head announces must have room in the file: a line, of one byte at least, for each number. */
static bool has_room(struct eulumdat *read)
{
    struct lx_luminaire_file *file = read->file;
    double least = read->planes + 2 * read->angles, room = (double)(file->length - file->at + 1);
    if (least <= room)
        return true;
    char first[LX_SHOWN_SIZE], second[LX_SHOWN_SIZE];
    struct lx_token token;
    double found = 0;
    while (lx_luminaire_line(file, &token.start, &token.end))
        found++;
    bool is_planes = read->planes > read->angles;
    token = is_planes ? read->planes_token : read->angles_token;
    lx_luminaire_error(file, token.start, token.end, LX_MSG_PHOTOMETRY_ROOM,
                       LX_ARGS(lx_shown(least, first), lx_shown(found, second)));
    return false;
}

static void take_stored(struct eulumdat *read, const double *planes, size_t count, size_t first, size_t stored)
{
    for (size_t i = 0; i < stored; i++) {
        size_t at = first + i;
        read->file->table.planes[i] = planes[at % count] + (at >= count ? 360 : 0);
    }
}

static void read_table(struct eulumdat *read, size_t count, size_t angles)
{
    struct lx_luminaire_file *file = read->file;
    struct lx_stored_table *table = &file->table;
    double *planes = lx_new_array(count, sizeof *planes);
    struct lx_token *plane_tokens = lx_new_array(count, sizeof *plane_tokens);
    struct lx_token *angle_tokens = lx_new_array(angles, sizeof *angle_tokens);
    size_t first = 0, stored = 0;
    table->angles = lx_new_array(angles, sizeof *table->angles);
    file->no_memory = file->no_memory || !planes || !plane_tokens || !angle_tokens || !table->angles;
    if (!file->no_memory && read_list(read, plane_name, planes, plane_tokens, count) &&
        read_list(read, gamma_name, table->angles, angle_tokens, angles)) {
        bool rises = read->symmetry == 1 || lx_check_angles(file, plane_name, planes, plane_tokens, count, 0, 360);
        if (lx_check_angles(file, gamma_name, table->angles, angle_tokens, angles, 0, 180) && file->errors == 0)
            judge_gammas(read, angle_tokens, table->angles, angles);
        if (rises && file->errors == 0)
            stored = stored_planes(read, planes, plane_tokens, count, &first);
    }
    /* the file must hold them, a byte or more for each */
    if (stored > 0 && (double)stored * (double)angles > (double)(file->length - file->at + 1)) {
        char wanted[LX_SHOWN_SIZE], found[LX_SHOWN_SIZE];
        lx_luminaire_error(file, read->planes_token.start, read->angles_token.end, LX_MSG_PHOTOMETRY_ROOM,
                           LX_ARGS(lx_shown((double)stored * (double)angles, wanted),
                                   lx_shown((double)(file->length - file->at), found)));
        stored = 0;
    }
    if (stored > 0) {
        table->plane_count = stored;
        table->angle_count = angles;
        table->planes = lx_new_array(stored, sizeof *table->planes);
        table->intensities = lx_new_array(stored, angles * sizeof *table->intensities);
        file->no_memory = file->no_memory || !table->planes || !table->intensities;
    }
    if (stored > 0 && !file->no_memory) {
        take_stored(read, planes, count, first, stored);
        judge_turn(read, plane_tokens, planes, count);
        read_values(read, stored * angles);
    }
    free(planes);
    free(plane_tokens);
    free(angle_tokens);
}

void lx_read_eulumdat(struct lx_luminaire_file *file)
{
    struct eulumdat read = {.file = file};
    file->at = 0;
    file->made->version = lx_luminaire_text(file, 0, 0);
    if (!read_kind(&read) || !read_texts(&read) || !read_sizes(&read) || !read_ratios(&read) || !read_lamps(&read))
        return;
    take_head(&read);
    if (!is_count(read.planes, 1, 1e9) || !is_count(read.angles, 2, 1e9) || !is_count(read.symmetry, 0, 4) ||
        !has_room(&read))
        return;
    read_table(&read, (size_t)read.planes, (size_t)read.angles);
}
