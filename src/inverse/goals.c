/* SPDX-License-Identifier: MIT */
/* Goals read and written into the scene as its limits, and how near values come to them. */
#include "goals.h"

#include <math.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../base/text.h"
#include "../scene/scene.h"

/* What may stand before >= or <=, and the key of limits that is meant. */
static const struct word {
    const char *word, *key;
    bool is_least, is_most;
} words[] = {
    {"average", "average", true, false}, {"E", "average", true, false},     {"minimum", "minimum", true, false},
    {"maximum", "maximum", false, true}, {"U0", "uniformity", true, false}, {"uniformity", "uniformity", true, false},
    {"ratio", "ratio", true, true},      {"ugr", "ugr", false, true},       {"UGR", "ugr", false, true},
};

/* A part of a goal's text. */
struct piece {
    const char *text;
    size_t length;
};

/* A goal as it is written. */
struct written {
    const char *text;
    struct piece name, key, number; /* the name is empty where none stands there */
    bool is_least;
};

static struct piece trimmed(const char *from, const char *to)
{
    while (from < to && *from == ' ')
        from++;
    while (to > from && to[-1] == ' ')
        to--;
    return (struct piece){from, (size_t)(to - from)};
}

static bool is_text(struct piece piece, const char *text)
{
    return strlen(text) == piece.length && strncmp(piece.text, text, piece.length) == 0;
}

/* Takes a goal apart; the word is NULL where it is none. */
static const struct word *take_apart(const char *text, struct written *goal)
{
    static const char *const signs[] = {">=", "<=", "≥", "≤"};
    const char *sign = NULL;
    *goal = (struct written){.text = text};
    for (size_t i = 0; !sign && i < LX_COUNT(signs); i++) {
        sign = strstr(text, signs[i]);
        if (sign) {
            const char *behind = sign + strlen(signs[i]);
            goal->is_least = i % 2 == 0;
            goal->number = trimmed(behind, behind + strlen(behind));
        }
    }
    if (!sign)
        return NULL;
    const char *colon = sign;
    while (colon > text && *colon != ':')
        colon--;
    goal->key = trimmed(*colon == ':' ? colon + 1 : text, sign);
    if (*colon == ':')
        goal->name = trimmed(text, colon);
    for (size_t i = 0; i < LX_COUNT(words); i++)
        if (is_text(goal->key, words[i].word))
            return &words[i];
    return NULL;
}

/* ---- whose limit it is ---- */

static const char *name_of(const luxel_scene *scene, bool is_observer, size_t i)
{
    const char *name = NULL;
    if (is_observer)
        luxel_scene_observer(scene, i, &name, NULL);
    else
        name = luxel_scene_grid_name(scene, i);
    return name;
}

static void report_whose(const luxel_scene *scene, const struct written *goal, bool is_observer, size_t count,
                         luxel_diagnostics *diagnostics)
{
    struct lx_text names = {0};
    for (size_t i = 0; i < count; i++)
        if (name_of(scene, is_observer, i))
            lx_text_printf(&names, "%s%s", names.length > 0 ? ", " : "", name_of(scene, is_observer, i));
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL,
              count > 0 && goal->name.length == 0 ? LX_MSG_ARRANGE_WHICH_GRID : LX_MSG_ARRANGE_NOBODY,
              LX_ARGS(goal->text));
    if (names.length > 0)
        lx_hint(diagnostics, LX_MSG_ARRANGE_NAMES, LX_ARGS(names.bytes));
    lx_text_clear(&names);
}

/* The grids or observers that are meant: from *first on to below *last. */
static bool find_whose(const luxel_scene *scene, const struct written *goal, bool is_observer, size_t *first,
                       size_t *last, luxel_diagnostics *diagnostics)
{
    const size_t count = is_observer ? luxel_scene_observer_count(scene) : luxel_scene_grid_count(scene);
    *first = 0;
    *last = count;
    if (goal->name.length == 0 && count > 0 && (is_observer || count == 1))
        return true;
    for (size_t i = 0; i < count && goal->name.length > 0; i++)
        if (name_of(scene, is_observer, i) && is_text(goal->name, name_of(scene, is_observer, i))) {
            *first = i;
            *last = i + 1;
            return true;
        }
    report_whose(scene, goal, is_observer, count, diagnostics);
    return false;
}

/* ---- setting them ---- */

static luxel_status refuse(luxel_diagnostics *diagnostics, enum lx_message message, const char *const *arguments)
{
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, message, arguments);
    return LUXEL_ERROR_ARGUMENT;
}

static luxel_status set_goal(const luxel_scene *scene, const char *text, luxel_diagnostics *diagnostics,
                             luxel_scene *goals)
{
    struct written goal;
    const struct word *word = take_apart(text, &goal);
    char digits[LX_NUMBER_SIZE];
    double wanted;
    if (!word || !lx_read_number(goal.number.text, goal.number.length, &wanted))
        return refuse(diagnostics, LX_MSG_ARRANGE_GOAL, LX_ARGS(text));
    lx_write_number(wanted, digits);
    const bool is_least = strcmp(word->key, "ratio") == 0 ? wanted <= 1 : word->is_least;
    if (is_least != goal.is_least) {
        struct lx_text meant = {0};
        lx_text_printf(&meant, "%s%s%s", word->word, is_least ? ">=" : "<=", digits);
        const luxel_status status =
            refuse(diagnostics, LX_MSG_ARRANGE_WAY, LX_ARGS(text, meant.bytes ? meant.bytes : ""));
        lx_text_clear(&meant);
        return status;
    }
    const bool is_observer = strcmp(word->key, "ugr") == 0;
    size_t first, last;
    if (!find_whose(scene, &goal, is_observer, &first, &last, diagnostics))
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = LUXEL_OK;
    for (size_t i = first; i < last && status == LUXEL_OK; i++) {
        struct lx_text assignment = {0};
        lx_text_printf(&assignment, "%s[%zu].limits.%s=%s", is_observer ? "observers" : "grids", i, word->key, digits);
        status =
            assignment.failed ? lx_out_of_memory(diagnostics) : luxel_scene_set(goals, assignment.bytes, diagnostics);
        lx_text_clear(&assignment);
    }
    return status;
}

luxel_status lx_goals_set(const luxel_scene *scene, const luxel_arranging *arranging, luxel_diagnostics *diagnostics,
                          luxel_scene **goals)
{
    luxel_status status = LUXEL_OK;
    *goals = luxel_scene_copy(scene);
    if (!*goals)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < arranging->goal_count; i++) {
        const luxel_status one = set_goal(scene, arranging->goals[i], diagnostics, *goals);
        if (one != LUXEL_OK && one != LUXEL_ERROR_ARGUMENT)
            return one;
        if (one != LUXEL_OK)
            status = one;
    }
    if (status == LUXEL_OK)
        status = luxel_scene_commit(*goals, diagnostics);
    if (status == LUXEL_OK && !luxel_scene_has_limits(*goals))
        status = lx_refuse(diagnostics, LX_MSG_ARRANGE_NO_GOAL, NULL);
    return status;
}

/* ---- judging ---- */

static double reserve_of(const struct lx_goal *goal, const double *values)
{
    double sum = 0, least = HUGE_VAL, greatest = 0;
    size_t count = 0, bright = 0;
    for (size_t i = 0; i < goal->count; i++) {
        const double value = values[goal->first + i];
        if (isnan(value)) /* a cell inside a body */
            continue;
        count++;
        bright += value >= goal->above;
        sum += value;
        least = fmin(least, value);
        greatest = fmax(greatest, value);
    }
    const double average = count > 0 ? sum / (double)count : 0;
    if (!(average > 0))
        return 0;
    switch (goal->which) {
    case LX_LIMIT_AVERAGE: return average / goal->wanted;
    case LX_LIMIT_MINIMUM: return least / goal->wanted;
    case LX_LIMIT_MAXIMUM: return goal->wanted / greatest;
    case LX_LIMIT_UNIFORMITY: return least / average / goal->wanted;
    case LX_LIMIT_SHARE: return 100 * (double)bright / (double)count / goal->wanted;
    case LX_LIMIT_RATIO: break;
    }
    return least / greatest * (goal->wanted > 1 ? goal->wanted : 1 / goal->wanted);
}

double lx_goals_reserve(const struct lx_goal *goals, size_t count, const double *values)
{
    double reserve = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        reserve = fmin(reserve, reserve_of(&goals[i], values));
    return reserve;
}

double lx_goal_reserve_of(const luxel_limit *limit)
{
    if (!limit->has_value)
        return limit->verdict == LUXEL_PASS ? HUGE_VAL : 0;
    if (strcmp(limit->name, "ugr") == 0)
        return pow(10, (limit->wanted - limit->value.value) / 8);
    return limit->is_most ? limit->wanted / limit->value.value : limit->value.value / limit->wanted;
}
