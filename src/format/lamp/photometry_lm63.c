/* SPDX-License-Identifier: MIT */
/*
 * Reading LM-63 (IES): the version, the texts of its keywords, and TILT, up to where the numbers begin.  The first line
 * that begins with TILT= ends the texts; keywords that have those letters in their text do not.
 */
#include "photometry_lm63.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../base/memory.h"
#include "../../base/path.h"
#include "../../base/source.h"
#include "../../base/text.h"

enum { MOST_TILT_BYTES = 1 << 20 };

/* ---- the version ---- */

/* Whether a tag has or ends with some digits. */
static bool has_digits(const char *tag, size_t length, const char *digits, bool at_end)
{
    size_t wanted = strlen(digits);
    for (size_t i = at_end && length > wanted ? length - wanted : 0; i + wanted <= length; i++)
        if (memcmp(tag + i, digits, wanted) == 0)
            return true;
    return false;
}

/* The year of a tag, in two digits or four; 0: none that is known. */
static unsigned year_of(const char *tag, size_t length)
{
    static const struct {
        const char *whole, *ending;
        unsigned year;
    } years[] = {
        {"1986", "86", 1986}, {"1991", "91", 1991}, {"1995", "95", 1995}, {"2002", "-02", 2002}, {"2019", "-19", 2019}};
    for (size_t i = 0; i < sizeof years / sizeof years[0]; i++)
        if (has_digits(tag, length, years[i].whole, false) || has_digits(tag, length, years[i].ending, true))
            return years[i].year;
    return 0;
}

/* The newest rules that a tag with another year may follow; 1986 where it tells none. */
static unsigned rules_of(const char *tag, size_t length)
{
    unsigned year = 0, digits = 0;
    while (digits < 4 && digits < length && tag[length - digits - 1] >= '0' && tag[length - digits - 1] <= '9')
        digits++;
    for (unsigned i = 0; i < digits; i++)
        year = 10 * year + (unsigned)(tag[length - digits + i] - '0');
    return year >= 2019 ? 2019 : year >= 2002 ? 2002 : year >= 1995 ? 1995 : year >= 1991 ? 1991 : 1986;
}

static void read_version(struct lx_lm63 *lm63, size_t start, size_t end)
{
    struct lx_luminaire_file *file = lm63->file;
    const char *tag = file->text + start;
    char rules[8] = {0};
    lm63->year = year_of(tag, end - start);
    file->made->version = lx_luminaire_text(file, start, end);
    static const char *const known[] = {"IESNA86",          "IESNA91",          "IESNA:LM-63-1986", "IESNA:LM-63-1991",
                                        "IESNA:LM-63-1995", "IESNA:LM-63-2002", "IES:LM-63-2019",   "IESNA:LM-63-2019"};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strlen(known[i]) == end - start && strncasecmp(known[i], tag, end - start) == 0)
            return;
    lm63->is_odd_tag = lm63->year == 0;
    if (lm63->is_odd_tag)
        lm63->year = rules_of(tag, end - start);
    for (unsigned i = 0, rest = lm63->year; i < 4; i++, rest /= 10)
        rules[3 - i] = (char)('0' + rest % 10);
    lx_luminaire_advise(file, start, end, LX_MSG_LM63_TAG, LX_ARGS(rules));
}

/* ---- texts ---- */

/* Joins a text to the one before it, as [MORE] has it. */
static void join_text(struct lx_luminaire_file *file, char *more)
{
    struct lx_photometry *made = file->made;
    struct lx_text joined = {0};
    if (!more || made->shown.text_count == 0) {
        lx_luminaire_add_text(file, more ? lx_copy_text("MORE", 4) : NULL, more);
        return;
    }
    luxel_photometry_text *last = &made->texts[made->shown.text_count - 1];
    lx_text_puts(&joined, last->text);
    lx_text_puts(&joined, "\n");
    lx_text_puts(&joined, more);
    free(more);
    char *taken = lx_text_take(&joined);
    file->no_memory = file->no_memory || !taken;
    if (!taken)
        return;
    free((char *)last->text);
    last->text = taken;
}

/* A line of the texts: [KEYWORD] text, or a text alone. */
static void read_label(struct lx_luminaire_file *file, size_t start, size_t end)
{
    const char *line = file->text + start;
    const char *close = *line == '[' ? memchr(line, ']', end - start) : NULL;
    size_t text = close ? (size_t)(close + 1 - file->text) : start;
    while (text < end && (file->text[text] == ' ' || file->text[text] == '\t'))
        text++;
    if (!close) {
        lx_luminaire_add_text(file, lx_copy_text("", 0), lx_luminaire_text(file, start, end));
        return;
    }
    size_t key = start + 1, key_end = (size_t)(close - file->text);
    if (key_end - key == 4 && strncasecmp(file->text + key, "MORE", 4) == 0)
        join_text(file, lx_luminaire_text(file, text, end));
    else
        lx_luminaire_add_text(file, lx_luminaire_text(file, key, key_end), lx_luminaire_text(file, text, end));
}

/* Since 2002 a file must tell its test, laboratory, date and maker. */
static void check_keywords(struct lx_lm63 *lm63)
{
    static const char *const required[] = {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"};
    struct lx_text missing = {0};
    if (lm63->year < 2002)
        return;
    for (size_t i = 0; i < sizeof required / sizeof required[0]; i++) {
        lm63->file->made->shown.texts = lm63->file->made->texts;
        if (!luxel_photometry_find_text(&lm63->file->made->shown, required[i]))
            lx_text_printf(&missing, "%s[%s]", missing.length > 0 ? ", " : "", required[i]);
    }
    if (missing.length > 0 && !missing.failed) {
        const struct lx_place whole = {.source = lm63->file->name};
        lx_report(lm63->file->advice, LUXEL_SEVERITY_ADVICE, &whole, LX_MSG_LM63_KEYWORDS, LX_ARGS(missing.bytes));
    }
    lx_text_clear(&missing);
}

/* ---- TILT ---- */

/* Where the word behind TILT= begins; 0: the line is another one. */
static size_t tilt_word(const struct lx_luminaire_file *file, size_t start, size_t end)
{
    size_t at = start + 4;
    if (end - start < 5 || strncasecmp(file->text + start, "TILT", 4) != 0)
        return 0;
    while (at < end && file->text[at] == ' ')
        at++;
    if (at == end || file->text[at++] != '=')
        return 0;
    while (at < end && file->text[at] == ' ')
        at++;
    return at;
}

/* The path of a file that stands beside the luminaire's. */
static char *path_beside(const struct lx_luminaire_file *file, size_t start, size_t end)
{
    struct lx_text path = {0};
    if (!lx_path_is_absolute(file->text + start))
        lx_text_add(&path, file->name, (size_t)(lx_path_name(file->name) - file->name));
    lx_text_add(&path, file->text + start, end - start);
    return lx_text_take(&path);
}

/* Reads the factors of another file. */
static void read_tilt_text(struct lx_lm63 *lm63, const char *path, char *text, size_t length)
{
    char *plain = lx_photometry_plain_text(text, &length);
    struct lx_luminaire_file file = {.name = path,
                                     .text = plain,
                                     .length = length,
                                     .diagnostics = lm63->file->diagnostics,
                                     .advice = lm63->file->advice,
                                     .made = lm63->file->made};
    struct lx_lm63 other = {.file = &file, .year = lm63->year};
    if (plain)
        lx_lm63_read_tilt(&other);
    lm63->file->errors += file.errors;
    lm63->file->no_memory = lm63->file->no_memory || file.no_memory || !plain;
    if (plain != text)
        free(plain);
}

static void read_tilt_file(struct lx_lm63 *lm63, size_t start, size_t end)
{
    struct lx_luminaire_file *file = lm63->file;
    char *path = path_beside(file, start, end);
    struct lx_source *source = path ? lx_source_try(path, MOST_TILT_BYTES) : NULL;
    size_t length = source ? (size_t)lx_source_size(source) : 0;
    char *text = source && length <= MOST_TILT_BYTES ? lx_new_array(length + 1, 1) : NULL;
    if (lm63->year >= 2019)
        lx_luminaire_advise(file, start, end, LX_MSG_LM63_TILT_FILE, NULL);
    if (text && !lx_source_reason(source))
        lx_source_read(source, 0, text, length);
    if (!path || !source || (!text && length <= MOST_TILT_BYTES)) {
        file->no_memory = true;
    } else if (lx_source_reason(source) || !text) {
        const char *reason = lx_source_reason(source);
        lx_luminaire_error(file, start, end, LX_MSG_LM63_TILT_READ,
                           LX_ARGS(path, LX_TERM(reason ? reason : LX_N("File too large"))));
        lx_hint(file->diagnostics, LX_MSG_HINT_LM63_TILT, NULL);
    } else {
        read_tilt_text(lm63, path, text, length);
    }
    free(text);
    lx_source_close(source);
    free(path);
}

static void read_tilt(struct lx_lm63 *lm63, size_t start, size_t end)
{
    struct lx_luminaire_file *file = lm63->file;
    const char *word = file->text + start;
    size_t length = end - start;
    if (length == 0) {
        lx_luminaire_error(file, start, end, LX_MSG_LM63_TILT_EMPTY, NULL);
        return;
    }
    if (length == 4 && strncasecmp(word, "NONE", 4) == 0) {
        lx_lm63_judge_commas(lm63);
        return;
    }
    lm63->has_tilt = length == 7 && strncasecmp(word, "INCLUDE", 7) == 0;
    lx_lm63_judge_commas(lm63);
    if (lm63->has_tilt)
        lx_lm63_read_tilt(lm63);
    else
        read_tilt_file(lm63, start, end);
    if (file->made->shown.tilt_count > 0)
        lx_luminaire_advise(file, start, end, LX_MSG_LM63_TILT, NULL);
}

void lx_read_lm63(struct lx_luminaire_file *file)
{
    struct lx_lm63 lm63 = {.file = file, .year = 1986};
    size_t start, end, word;
    bool is_first = true;
    file->at = 0;
    while (lx_luminaire_line(file, &start, &end)) {
        if (start == end)
            continue;
        word = tilt_word(file, start, end);
        if (word > 0) {
            check_keywords(&lm63);
            read_tilt(&lm63, word, end);
            lx_lm63_read_numbers(&lm63);
            if (!file->made->version)
                file->made->version = lx_luminaire_text(file, 0, 0);
            return;
        }
        bool is_tag = is_first && end - start >= 3 && strncasecmp(file->text + start, "IES", 3) == 0;
        if (is_tag)
            read_version(&lm63, start, end);
        else
            read_label(file, start, end);
        is_first = false;
    }
    lx_luminaire_error(file, file->length, file->length, LX_MSG_LM63_NO_TILT, NULL);
    lx_hint(file->diagnostics, LX_MSG_HINT_LM63_NO_TILT, NULL);
}
