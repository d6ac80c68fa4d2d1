/* SPDX-License-Identifier: MIT */
/* Rows of formulas with the space that their signs want, and where rows may be broken. */
#include "formula_set.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

/* What a part of a row is to its neighbours. */
enum kind { ORDINARY, WORD, OPERATION, RELATION, OPENING, CLOSING, MARK, INNER };

static bool is_one_of(const char *text, const char *const *list)
{
    for (; *list; list++)
        if (strcmp(text, *list) == 0)
            return true;
    return false;
}

static enum kind kind_of(const struct lx_formula *row, size_t i)
{
    static const char *const operations[] = {"+", "−", "±", "·", "×", NULL}, *const large[] = {"∑", "∫", NULL};
    const struct lx_formula *sign = lx_formula_nucleus(row->children[i]);
    switch (sign->type) {
    case LX_FORMULA_OPERATOR:
        if (strcmp(sign->text, "/") == 0 || lx_formula_is_sign(row, i))
            return ORDINARY;
        return is_one_of(sign->text, operations) ? OPERATION : RELATION;
    case LX_FORMULA_UPRIGHT:
        if (lx_formula_is_comma(sign))
            return MARK;
        return lx_formula_is_word(sign) || is_one_of(sign->text, large) ? WORD : ORDINARY;
    case LX_FORMULA_FENCE:
        return lx_formula_is_fence(sign, false) ? OPENING : lx_formula_is_fence(sign, true) ? CLOSING : ORDINARY;
    case LX_FORMULA_FRACTION: return INNER;
    case LX_FORMULA_ROW:
        return sign->count > 0 && sign->children[0]->type == LX_FORMULA_FENCE && sign->children[0]->tall ? INNER
                                                                                                         : ORDINARY;
    default: return ORDINARY;
    }
}

/* The space between two kinds in eighteenths of the size: TeX's. */
static double space_between(enum kind left, enum kind right, bool script)
{
    static const unsigned char spaces[8][8] = {
        /* ordinary word operation relation opening closing mark inner */
        {0, 3, 4, 5, 0, 0, 0, 3}, /* ordinary */
        {3, 3, 0, 5, 0, 0, 0, 3}, /* word */
        {4, 4, 0, 0, 4, 0, 0, 4}, /* operation */
        {5, 5, 0, 0, 5, 0, 0, 5}, /* relation */
        {0, 0, 0, 0, 0, 0, 0, 0}, /* opening */
        {0, 3, 4, 5, 0, 0, 0, 3}, /* closing */
        {3, 3, 0, 3, 3, 3, 3, 3}, /* mark */
        {3, 3, 4, 5, 3, 0, 3, 3}, /* inner */
    };
    if (script && left != WORD && right != WORD)
        return 0;
    return spaces[left][right] / 18.0;
}

static bool is_space(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_SPACE;
}

void lx_formula_set_range(const struct lx_setting *setting, const struct lx_formula *row, size_t first, size_t last,
                          struct lx_style style, struct lx_formula_box *box)
{
    size_t before = row->count; /* the last part that is no space; none yet */
    for (size_t i = first; i < row->count; i++) {
        double space = 0;
        if (!is_space(row->children[i])) {
            if (before < row->count)
                space = space_between(kind_of(row, before), kind_of(row, i), style.script) * style.size;
            before = i;
        }
        if (i >= last) { /* what follows on the same line stands so far away */
            box->width += space;
            if (before == i)
                return;
            continue;
        }
        struct lx_formula_box part = {0};
        lx_formula_set(setting, row->children[i], style, &part);
        lx_formula_box_append(box, &part, space);
    }
}

/* ---- where rows may be broken ---- */

/* Whether a part is an operation or a relation that no bracket holds. */
static bool *find_breaks(const struct lx_formula *row)
{
    bool *breaks = lx_new_array(row->count + 1, sizeof *breaks);
    int open = 0;
    for (size_t i = 0; breaks && i < row->count; i++) {
        enum kind kind = kind_of(row, i);
        open += kind == OPENING ? 1 : kind == CLOSING ? -1 : 0;
        breaks[i] = open <= 0 && (kind == OPERATION || kind == RELATION);
    }
    return breaks;
}

static bool is_plain_row(const struct lx_formula *formula)
{
    return formula->type == LX_FORMULA_ROW &&
           !(formula->count == 3 && formula->children[0]->type == LX_FORMULA_FENCE && formula->children[0]->tall);
}

static bool any_failed(const struct lx_setting *setting, struct lx_formula_box *boxes, size_t count)
{
    bool failed = setting->failed;
    for (size_t i = 0; i < count; i++)
        failed = failed || boxes[i].failed;
    for (size_t i = 0; failed && i < count; i++)
        lx_formula_box_clear(&boxes[i]);
    return failed;
}

struct lx_formula_box *lx_formula_set_parts(const struct lx_formula_font *type, const struct lx_formula *formula,
                                            size_t *count)
{
    struct lx_setting setting = lx_formula_setting(type);
    const struct lx_style style = {.size = type->size};
    bool splits = is_plain_row(formula);
    bool *breaks = splits ? find_breaks(formula) : NULL;
    struct lx_formula_box *parts = lx_new_array(formula->count + 1, sizeof *parts);
    *count = 0;
    if (parts && breaks) {
        size_t first = 0;
        for (size_t i = 0; i < formula->count; i++)
            if (i + 1 == formula->count || (breaks[i] && i > first)) {
                lx_formula_set_range(&setting, formula, first, i + 1, style, &parts[(*count)++]);
                first = i + 1;
            }
    } else if (parts && !splits) {
        lx_formula_set(&setting, formula, style, &parts[(*count)++]);
    }
    bool failed = !parts || (splits && !breaks) || any_failed(&setting, parts, *count);
    free(breaks);
    *count = *count > 0 ? *count : 1;
    if (!failed)
        return parts;
    free(parts);
    return NULL;
}

/* ---- lines ---- */

struct lines {
    struct lx_formula_line *items;
    size_t count, capacity;
    bool failed;
};

static struct lx_formula_line *add_line(struct lines *lines)
{
    if (lx_reserve(&lines->items, &lines->capacity, lines->count + 1, sizeof *lines->items) < 0) {
        lines->failed = true;
        return NULL;
    }
    struct lx_formula_line *line = &lines->items[lines->count++];
    *line = (struct lx_formula_line){.scale = 1};
    return line;
}

static void shrink(struct lx_formula_line *line, double room)
{
    if (line->box.width > room)
        line->scale = room / line->box.width;
}

/* Those of a row from `first` on as long as they fit, then more lines, which begin with an operation or a relation. */
static void break_row(struct lines *lines, const struct lx_setting *setting, const struct lx_formula *row, size_t first,
                      double x, double width)
{
    const struct lx_style style = {.size = setting->type->size, .display = true};
    const double further = x + 2 * style.size < width / 3 ? x + 2 * style.size : width / 3;
    bool *breaks = find_breaks(row);
    lines->failed = lines->failed || !breaks;
    for (size_t last; breaks && !lines->failed && first < row->count; first = last) {
        struct lx_formula_line *line = add_line(lines);
        last = row->count;
        if (!line)
            break;
        for (size_t end = first + 1; end <= row->count; end++) { /* the longest that fits, or the shortest */
            if (end < row->count && !breaks[end])
                continue;
            struct lx_formula_box box = {0};
            lx_formula_set_range(setting, row, first, end, style, &box);
            bool fits = x + box.width <= width;
            if (fits || !line->box.count) {
                lines->failed = lines->failed || line->box.failed;
                lx_formula_box_clear(&line->box);
                line->box = box;
                last = end;
            } else {
                lines->failed = lines->failed || box.failed;
                lx_formula_box_clear(&box);
            }
            if (!fits)
                break;
        }
        line->x = x;
        shrink(line, width - x);
        x = further;
    }
    free(breaks);
}

static size_t find_mark(const struct lx_formula *row)
{
    size_t mark = 0;
    while (mark < row->count && !(is_space(row->children[mark]) && row->children[mark]->width == 0))
        mark++;
    return mark;
}

/* Lines that are aligned at their marks; the part before a mark ends where the widest of them does. */
static void set_aligned(struct lines *lines, const struct lx_setting *setting, const struct lx_formula *whole,
                        double width)
{
    const struct lx_style style = {.size = setting->type->size, .display = true};
    double left = 0, right = 0;
    for (size_t i = 0; i < whole->count; i++) {
        const struct lx_formula *row = whole->children[i];
        struct lx_formula_box before = {0}, all = {0};
        lx_formula_set_range(setting, row, 0, find_mark(row), style, &before);
        lx_formula_set_range(setting, row, 0, row->count, style, &all);
        left = before.width > left ? before.width : left;
        right = all.width - before.width > right ? all.width - before.width : right;
        lines->failed = lines->failed || before.failed || all.failed;
        lx_formula_box_clear(&before);
        lx_formula_box_clear(&all);
    }
    double x = left + right < width ? (width - left - right) / 2 : 0;
    for (size_t i = 0; i < whole->count && !lines->failed; i++) {
        const struct lx_formula *row = whole->children[i];
        struct lx_formula_box before = {0}, all = {0};
        lx_formula_set_range(setting, row, 0, find_mark(row), style, &before);
        lx_formula_set_range(setting, row, 0, row->count, style, &all);
        double begin = x + left - before.width;
        lines->failed = lines->failed || before.failed || all.failed;
        lx_formula_box_clear(&before);
        if (begin + all.width > width) {
            lx_formula_box_clear(&all);
            break_row(lines, setting, row, 0, begin, width);
            continue;
        }
        struct lx_formula_line *line = add_line(lines);
        if (line) {
            line->box = all;
            line->x = begin;
        } else {
            lx_formula_box_clear(&all);
        }
    }
}

struct lx_formula_line *lx_formula_set_lines(const struct lx_formula_font *type, const struct lx_formula *formula,
                                             double width, size_t *count)
{
    struct lx_setting setting = lx_formula_setting(type);
    const struct lx_style style = {.size = type->size, .display = true};
    struct lines lines = {.failed = setting.failed};
    struct lx_formula_box box = {0};
    if (formula->type == LX_FORMULA_LINES) {
        set_aligned(&lines, &setting, formula, width);
    } else {
        lx_formula_set(&setting, formula, style, &box);
        bool fits = box.width <= width;
        struct lx_formula_line *line = fits || !is_plain_row(formula) ? add_line(&lines) : NULL;
        if (line) {
            line->box = box;
            shrink(line, width);
            line->x = (width - box.width * line->scale) / 2;
        } else {
            lines.failed = lines.failed || box.failed;
            lx_formula_box_clear(&box);
            if (!fits)
                break_row(&lines, &setting, formula, 0, 0, width);
        }
    }
    for (size_t i = 0; i < lines.count; i++)
        lines.failed = lines.failed || lines.items[i].box.failed;
    *count = lines.count;
    if (!lines.failed)
        return lines.items;
    for (size_t i = 0; i < lines.count; i++)
        lx_formula_box_clear(&lines.items[i].box);
    free(lines.items);
    return NULL;
}
