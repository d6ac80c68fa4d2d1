/* SPDX-License-Identifier: MIT */
/* Luminaire files: opened, told apart, read by one of the readers, and completed; what the readers share. */
#include <luxel/photometry.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../base/encoding.h"
#include "../../base/ending.h"
#include "../../base/memory.h"
#include "../../base/number.h"
#include "../../base/source.h"
#include "../lines.h"
#include "photometry.h"

/* ---- memory ---- */

void lx_photometry_free(struct lx_kept *kept)
{
    struct lx_photometry *made = (struct lx_photometry *)kept;
    for (size_t i = 0; i < made->shown.lamp_set_count; i++) {
        free((char *)made->lamp_sets[i].type);
        free((char *)made->lamp_sets[i].temperature);
        free((char *)made->lamp_sets[i].rendering);
    }
    for (size_t i = 0; i < made->shown.text_count; i++) {
        free((char *)made->texts[i].keyword);
        free((char *)made->texts[i].text);
    }
    free(made->planes);
    free(made->angles);
    free(made->intensities);
    free(made->tilt_angles);
    free(made->tilt_factors);
    free(made->version);
    free(made->lamp_sets);
    free(made->texts);
    free(made);
}

void luxel_photometry_free(luxel_photometry *photometry)
{
    if (photometry)
        lx_kept_release((struct lx_kept *)((char *)photometry - offsetof(struct lx_photometry, shown)));
}

char *lx_luminaire_text(struct lx_luminaire_file *file, size_t start, size_t end)
{
    struct lx_text text = {0};
    lx_add_latin(&text, file->text + start, end - start);
    lx_text_add(&text, "", 0);
    char *copy = lx_text_take(&text);
    file->no_memory = file->no_memory || !copy;
    return copy;
}

void lx_luminaire_add_text(struct lx_luminaire_file *file, char *keyword, char *text)
{
    struct lx_photometry *made = file->made;
    size_t count = made->shown.text_count;
    if (!keyword || !text || lx_reserve(&made->texts, &made->text_capacity, count + 1, sizeof *made->texts) < 0) {
        free(keyword);
        free(text);
        file->no_memory = true;
        return;
    }
    made->texts[count] = (luxel_photometry_text){keyword, text};
    made->shown.text_count++;
}

struct luxel_photometry_lamp_set *lx_luminaire_add_lamps(struct lx_luminaire_file *file)
{
    struct lx_photometry *made = file->made;
    size_t count = made->shown.lamp_set_count;
    if (lx_reserve(&made->lamp_sets, &made->lamp_set_capacity, count + 1, sizeof *made->lamp_sets) < 0) {
        file->no_memory = true;
        return NULL;
    }
    made->lamp_sets[count] = (luxel_photometry_lamp_set){.type = NULL};
    made->shown.lamp_set_count++;
    return &made->lamp_sets[count];
}

/* ---- reports ---- */

static struct lx_place place_of(const struct lx_luminaire_file *file, size_t start, size_t end)
{
    return (struct lx_place){
        .source = file->name, .text = file->text, .length = file->length, .start = start, .end = end};
}

void lx_luminaire_error(struct lx_luminaire_file *file, size_t start, size_t end, enum lx_message message,
                        const char *const *arguments)
{
    struct lx_place place = place_of(file, start, end);
    file->errors++;
    lx_report(file->diagnostics, LUXEL_SEVERITY_ERROR, &place, message, arguments);
}

void lx_luminaire_advise(struct lx_luminaire_file *file, size_t start, size_t end, enum lx_message message,
                         const char *const *arguments)
{
    struct lx_place place = place_of(file, start, end);
    lx_report(file->advice, LUXEL_SEVERITY_ADVICE, &place, message, arguments);
}

const char *lx_shown(double number, char buffer[LX_SHOWN_SIZE])
{
    return lx_write_digits(number, 8, buffer);
}

/* ---- lines, numbers, angles ---- */

bool lx_luminaire_line(struct lx_luminaire_file *file, size_t *start, size_t *end)
{
    if (file->at >= file->length)
        return false;
    const char *text = file->text, *stop = memchr(text + file->at, '\n', file->length - file->at);
    *start = file->at;
    *end = stop ? (size_t)(stop - text) : file->length;
    file->at = *end + (stop != NULL);
    while (*start < *end && lx_is_blank(text[*start]))
        ++*start;
    while (*end > *start && lx_is_blank(text[*end - 1]))
        --*end;
    return true;
}

bool lx_luminaire_number(const char *text, size_t length, bool has_comma, double *number)
{
    char copy[64];
    const char *comma = has_comma ? memchr(text, ',', length) : NULL;
    if (!comma || length > sizeof copy)
        return lx_read_number(text, length, number);
    memcpy(copy, text, length);
    copy[comma - text] = '.';
    return lx_read_number(copy, length, number);
}

bool lx_check_angles(struct lx_luminaire_file *file, const char *name, const double *angles,
                     const struct lx_token *tokens, size_t count, double low, double high)
{
    size_t errors = file->errors;
    char first[LX_SHOWN_SIZE], second[LX_SHOWN_SIZE], third[LX_SHOWN_SIZE];
    for (size_t i = 0; i < count; i++) {
        if (isnan(angles[i]))
            continue; /* reported already */
        if (angles[i] < low || angles[i] > high)
            lx_luminaire_error(
                file, tokens[i].start, tokens[i].end, LX_MSG_PHOTOMETRY_ANGLE_RANGE,
                LX_ARGS(LX_TERM(name), lx_shown(angles[i], first), lx_shown(low, second), lx_shown(high, third)));
        else if (i > 0 && angles[i] <= angles[i - 1])
            lx_luminaire_error(file, tokens[i].start, tokens[i].end, LX_MSG_PHOTOMETRY_ANGLE_ORDER,
                               LX_ARGS(LX_TERM(name), lx_shown(angles[i], first), lx_shown(angles[i - 1], second)));
    }
    return file->errors == errors;
}

/* ---- a text of either format ---- */

char *lx_photometry_plain_text(char *text, size_t *length)
{
    text = lx_text_of_bytes(text, length);
    if (!text)
        return NULL;
    char *end = text + *length;
    for (char *at = end; at > text && (at[-1] == 0x1a || at[-1] == 0); at--) /* the end as DOS marks it, and padding */
        at[-1] = ' ';
    for (char *at = text; (at = memchr(at, '\r', (size_t)(end - at))) != NULL;) {
        char *behind = at;
        while (behind < end && *behind == '\r')
            behind++;
        memset(at, behind < end && *behind == '\n' ? ' ' : '\n', (size_t)(behind - at));
        at = behind;
    }
    return text;
}

/* Whether a line is TILT=..., or begins the file as LM-63 does. */
static bool looks_like_lm63(struct lx_luminaire_file file)
{
    size_t start, end;
    bool is_first = true;
    for (file.at = 0; lx_luminaire_line(&file, &start, &end);) {
        const char *line = file.text + start;
        size_t length = end - start;
        if (length == 0)
            continue;
        if (is_first && length >= 3 && strncasecmp(line, "IES", 3) == 0)
            return true;
        is_first = false;
        if (length < 5 || strncasecmp(line, "TILT", 4) != 0)
            continue;
        size_t i = 4;
        while (i < length && lx_is_blank(line[i]))
            i++;
        if (i < length && line[i] == '=')
            return true;
    }
    return false;
}

/* Whether the second to the seventh line are numbers or blank, and the third is a symmetry. */
static bool looks_like_eulumdat(struct lx_luminaire_file file)
{
    size_t start, end;
    double number;
    file.at = 0;
    for (int line = 1; line <= 7; line++) {
        if (!lx_luminaire_line(&file, &start, &end))
            return false;
        bool is_number = lx_luminaire_number(file.text + start, end - start, true, &number);
        if (line > 1 && !is_number && start < end)
            return false;
        if (line == 3 && (!is_number || number < 0 || number > 4))
            return false;
    }
    return true;
}

static void (*find_reader(const struct lx_luminaire_file *file))(struct lx_luminaire_file *)
{
    if (looks_like_eulumdat(*file)) /* first: its texts may be anything, even TILT=, and LM-63 never looks so */
        return lx_read_eulumdat;
    if (looks_like_lm63(*file))
        return lx_read_lm63;
    return lx_has_ending(file->name, ".ies")   ? lx_read_lm63
           : lx_has_ending(file->name, ".ldt") ? lx_read_eulumdat
                                               : NULL;
}

/* ---- what was read, judged as a whole ---- */

static char *percent(double part, double whole, char buffer[LX_SHOWN_SIZE])
{
    return lx_write_digits(100 * part / whole, 4, buffer);
}

/* Where the flux that the file declares and that of its table are more than one percent apart. */
static void compare_flux(struct lx_luminaire_file *file, const luxel_photometry_figures *figures)
{
    const luxel_photometry *shown = &file->made->shown;
    const struct lx_place whole = {.source = file->name};
    char lumens[LX_SHOWN_SIZE], declared[LX_SHOWN_SIZE], share[LX_SHOWN_SIZE];
    bool has_ratio = shown->declared_lorl > 0;
    double expected = shown->declared_lumens * (has_ratio ? shown->declared_lorl / 100 : 1);
    if (!(expected > 0) || fabs(figures->zone_lumens - expected) <= 0.01 * expected)
        return;
    lx_write_digits(figures->zone_lumens, 6, lumens);
    lx_write_digits(expected, 6, declared);
    percent(figures->zone_lumens, expected, share);
    enum lx_message message = has_ratio                         ? LX_MSG_PHOTOMETRY_FLUX_RATIO
                              : figures->zone_lumens < expected ? LX_MSG_PHOTOMETRY_FLUX_LESS
                                                                : LX_MSG_PHOTOMETRY_FLUX_MORE;
    lx_report(file->advice, LUXEL_SEVERITY_ADVICE, &whole, message, LX_ARGS(declared, lumens, share));
}

/* Where the share of the flux that goes down is more than one of a hundred parts off what the file declares. */
static void compare_dff(struct lx_luminaire_file *file, const luxel_photometry_figures *figures)
{
    const luxel_photometry *shown = &file->made->shown;
    const struct lx_place whole = {.source = file->name};
    char declared[LX_SHOWN_SIZE], found[LX_SHOWN_SIZE];
    if (!(shown->declared_dff > 0) || !(fabs(figures->dff - shown->declared_dff) > 1))
        return;
    lx_write_digits(shown->declared_dff, 4, declared);
    lx_write_digits(figures->dff, 4, found);
    lx_report(file->advice, LUXEL_SEVERITY_ADVICE, &whole, LX_MSG_PHOTOMETRY_DFF, LX_ARGS(declared, found));
}

static luxel_status finish(struct lx_luminaire_file *file)
{
    struct lx_photometry *made = file->made;
    luxel_photometry_figures figures;
    if (file->no_memory || !lx_complete_table(&file->table, made))
        return lx_out_of_memory(file->diagnostics);
    made->shown.version = made->version;
    made->shown.lamp_sets = made->lamp_sets;
    made->shown.texts = made->texts;
    made->shown.tilt_angles = made->tilt_angles;
    made->shown.tilt_factors = made->tilt_factors;
    made->shown.stored_planes = file->table.plane_count;
    if (luxel_photometry_find_figures(&made->shown, &figures) != LUXEL_OK)
        return lx_out_of_memory(file->diagnostics);
    compare_flux(file, &figures);
    compare_dff(file, &figures);
    return LUXEL_OK;
}

static luxel_status read_plain(struct lx_luminaire_file *file)
{
    file->made = lx_new_array(1, sizeof *file->made);
    if (!file->made)
        return lx_out_of_memory(file->diagnostics);
    lx_kept_init(&file->made->kept, lx_photometry_free);
    void (*reader)(struct lx_luminaire_file *) = find_reader(file);
    const char *zero = memchr(file->text, 0, file->length);
    if (zero)
        lx_luminaire_error(file, (size_t)(zero - file->text), (size_t)(zero - file->text) + 1, LX_MSG_TABLE_ZERO, NULL);
    else if (reader)
        reader(file);
    else
        lx_luminaire_error(file, 0, 0, LX_MSG_PHOTOMETRY_FORMAT, NULL);
    luxel_status status = file->no_memory    ? lx_out_of_memory(file->diagnostics)
                          : file->errors > 0 ? LUXEL_ERROR_FILE
                                             : finish(file);
    free(file->table.planes);
    free(file->table.angles);
    free(file->table.intensities);
    return status;
}

luxel_status lx_photometry_read_text(char *text, size_t length, const char *name, luxel_diagnostics *errors,
                                     luxel_diagnostics *advice, struct lx_photometry **photometry)
{
    char *plain = lx_photometry_plain_text(text, &length);
    if (!plain)
        return lx_out_of_memory(errors);
    struct lx_luminaire_file file = {
        .name = name, .text = plain, .length = length, .diagnostics = errors, .advice = advice};
    luxel_status status = read_plain(&file);
    if (status == LUXEL_OK)
        *photometry = file.made;
    else if (file.made)
        lx_kept_release(&file.made->kept);
    if (plain != text)
        free(plain);
    return status;
}

/* Reads a text, which may be changed. */
static luxel_status read_text(char *text, size_t length, const char *name, luxel_diagnostics *diagnostics,
                              luxel_photometry **photometry)
{
    struct lx_photometry *made;
    luxel_status status = lx_photometry_read_text(text, length, name, diagnostics, diagnostics, &made);
    if (status == LUXEL_OK)
        *photometry = &made->shown;
    return status;
}

luxel_status luxel_photometry_read_bytes(const void *bytes, size_t length, const char *name,
                                         luxel_diagnostics *diagnostics, luxel_photometry **photometry)
{
    if ((!bytes && length > 0) || !photometry)
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_place whole = {.source = name ? name : "<text>"};
    if (length > LX_LARGEST_PHOTOMETRY) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &whole, LX_MSG_PHOTOMETRY_TOO_LARGE, NULL);
        return LUXEL_ERROR_FILE;
    }
    char *copy = lx_copy_text(length > 0 ? bytes : "", length);
    if (!copy)
        return lx_out_of_memory(diagnostics);
    luxel_status status = read_text(copy, length, whole.source, diagnostics, photometry);
    free(copy);
    return status;
}

luxel_status luxel_photometry_read(const char *path, luxel_diagnostics *diagnostics, luxel_photometry **photometry)
{
    struct lx_source *source;
    if (!path || !photometry)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = lx_source_open(path, LX_LARGEST_PHOTOMETRY, diagnostics, &source);
    if (status != LUXEL_OK)
        return status;
    uint64_t size = lx_source_size(source);
    if (size > LX_LARGEST_PHOTOMETRY) {
        status = lx_source_refuse(source, LX_MSG_PHOTOMETRY_TOO_LARGE, NULL);
    } else {
        char *text = lx_new_array((size_t)size + 1, 1);
        status = text ? lx_source_read(source, 0, text, (size_t)size) : lx_source_out_of_memory(source);
        if (status == LUXEL_OK)
            status = read_text(text, (size_t)size, path, diagnostics, photometry);
        free(text);
    }
    lx_source_close(source);
    return status;
}

/* ---- names ---- */

const char *luxel_photometry_find_text(const luxel_photometry *photometry, const char *keyword)
{
    for (size_t i = 0; photometry && keyword && i < photometry->text_count; i++)
        if (strcasecmp(photometry->texts[i].keyword, keyword) == 0)
            return photometry->texts[i].text;
    return NULL;
}

const char *luxel_photometry_format_name(const luxel_photometry *photometry)
{
    switch (photometry->year) {
    case 1986: return "LM-63-1986";
    case 1991: return "LM-63-1991";
    case 1995: return "LM-63-1995";
    case 2002: return "LM-63-2002";
    case 2019: return "LM-63-2019";
    default: return "EULUMDAT";
    }
}

const char *luxel_photometry_symmetry_name(luxel_photometry_symmetry symmetry)
{
    static const char *const names[] = {
        [LUXEL_SYMMETRY_NONE] = "none",
        [LUXEL_SYMMETRY_AXIAL] = "axial",
        [LUXEL_SYMMETRY_QUADRANT] = "quadrant",
        [LUXEL_SYMMETRY_BILATERAL_0] = "bilateral 0-180",
        [LUXEL_SYMMETRY_BILATERAL_90] = "bilateral 90-270",
        [LUXEL_SYMMETRY_LATERAL] = "lateral",
    };
    return names[symmetry];
}
