/* SPDX-License-Identifier: MIT */
/*
 * The keys of limits, and the rows of standards that have names: EN 12464-1:2011, tables 5.1 to 5.36 (maintained
 * illuminance Em, uniformity U0, UGR); EN 12464-1:2021 (walls, ceilings and cylindrical illuminance of offices and
 * classrooms); EN 1838:2013 (least illuminance, greatest by least one); EN 12193:2018, indoor ball games and outdoor
 * football of the classes I to III (illuminance and uniformity of the principal area).
 */
#include "limits.h"

#include <math.h>

#include "../parameter/check.h"

struct row {
    double wanted[LX_LIMIT_SHARE]; /* 0: no limit */
    double ugr;
};

#define EN12464(average, uniformity, ugr_)                                                                             \
    {                                                                                                                  \
        .wanted = {[LX_LIMIT_AVERAGE] = (average), [LX_LIMIT_UNIFORMITY] = (uniformity)}, .ugr = (ugr_)                \
    }
#define EN12193(average, uniformity) EN12464(average, uniformity, 0)
#define EN1838(minimum, ratio)                                                                                         \
    {                                                                                                                  \
        .wanted = { [LX_LIMIT_MINIMUM] = (minimum), [LX_LIMIT_RATIO] = (ratio) }                                       \
    }

static const char *const row_names[] = {
    "en12464-corridor",      "en12464-stairs",
    "en12464-canteen",       "en12464-rest-room",
    "en12464-store",         "en12464-office",
    "en12464-filing",        "en12464-drawing",
    "en12464-meeting-room",  "en12464-reception",
    "en12464-archive",       "en12464-classroom",
    "en12464-evening-class", "en12464-lecture-hall",
    "en12464-walls",         "en12464-ceiling",
    "en12464-cylindrical",   "en1838-escape-route",
    "en1838-open-area",      "en12193-hall-1",
    "en12193-hall-2",        "en12193-hall-3",
    "en12193-football-1",    "en12193-football-2",
    "en12193-football-3",    NULL,
};

/* Those that limit the glare come first. */
static const struct row rows[] = {
    EN12464(100, 0.4, 28), EN12464(100, 0.4, 25), EN12464(200, 0.4, 22), EN12464(100, 0.4, 22), EN12464(100, 0.4, 25),
    EN12464(500, 0.6, 19), EN12464(300, 0.4, 19), EN12464(750, 0.7, 16), EN12464(500, 0.6, 19), EN12464(300, 0.6, 22),
    EN12464(200, 0.4, 25), EN12464(300, 0.6, 19), EN12464(500, 0.6, 19), EN12464(500, 0.6, 19), EN12464(75, 0.1, 0),
    EN12464(50, 0.1, 0),   EN12464(150, 0.1, 0),  EN1838(1, 40),         EN1838(0.5, 40),       EN12193(750, 0.7),
    EN12193(500, 0.7),     EN12193(200, 0.5),     EN12193(500, 0.7),     EN12193(200, 0.6),     EN12193(75, 0.5),
};

static const char *const glare_row_names[] = {
    "en12464-corridor", "en12464-stairs",    "en12464-canteen",       "en12464-rest-room",    "en12464-store",
    "en12464-office",   "en12464-filing",    "en12464-drawing",       "en12464-meeting-room", "en12464-reception",
    "en12464-archive",  "en12464-classroom", "en12464-evening-class", "en12464-lecture-hall", NULL,
};

static const struct lx_parameter share_parameters[] = {
    {
        .name = "above",
        .label = "At least",
        .type = LX_REAL,
        .offset = offsetof(struct lx_share_limit, above),
        .unit = LX_UNIT_IRRADIANCE,
        .required = true,
        .legal = LX_FROM(0),
        .meaning = "the value that cells of the share have at least",
    },
    {
        .name = "percent",
        .label = "Percent",
        .type = LX_REAL,
        .offset = offsetof(struct lx_share_limit, percent),
        .required = true,
        .legal = LX_BETWEEN(0, 100),
        .meaning = "the least share of the cells that have a value, in percent",
    },
};

static const struct lx_table share_table = {
    .parameters = share_parameters,
    .count = LX_COUNT(share_parameters),
    .size = sizeof(struct lx_share_limit),
};

static const struct lx_parameter grid_limits_parameters[] = {
    {
        .name = "average",
        .label = "Average at least",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid_limits, wanted[LX_LIMIT_AVERAGE]),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_FROM(0),
        .meaning = "the least average of the values",
    },
    {
        .name = "minimum",
        .label = "Minimum at least",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid_limits, wanted[LX_LIMIT_MINIMUM]),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_FROM(0),
        .meaning = "the least value that is allowed anywhere on the grid",
    },
    {
        .name = "maximum",
        .label = "Maximum at most",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid_limits, wanted[LX_LIMIT_MAXIMUM]),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_FROM(0),
        .meaning = "the greatest value that is allowed anywhere on the grid",
    },
    {
        .name = "uniformity",
        .label = "Uniformity at least",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid_limits, wanted[LX_LIMIT_UNIFORMITY]),
        .legal = LX_BETWEEN(0, 1),
        .meaning = "the least uniformity U0, the minimum by the average",
    },
    {
        .name = "ratio",
        .label = "Ratio",
        .type = LX_REAL,
        .offset = offsetof(struct lx_grid_limits, wanted[LX_LIMIT_RATIO]),
        .legal = LX_ABOVE(0),
        .meaning = "up to 1 the least ratio of the minimum to the maximum, such as 0.5; above 1 the greatest ratio of "
                   "the maximum to the minimum, such as 40",
    },
    {
        .name = "share",
        .label = "Share of the area",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_grid_limits, share),
        .group = &share_table,
        .meaning = "how much of the area, cell by cell, is to have at least some value, such as {above: 300, percent: "
                   "95}",
    },
    {
        .name = "preset",
        .label = "Row of a standard",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_grid_limits, preset),
        .choices = row_names,
        .meaning =
            "the limits of a row of a standard: of EN 12464-1:2011 Em and U0; walls, ceiling and cylindrical "
            "are those of EN 12464-1:2021; of EN 1838:2013 the minimum and the ratio; of EN 12193:2018, ball games "
            "in halls and outdoor football of class 1 to 3, the average and U0; other keys replace its numbers",
    },
};

const struct lx_table lx_grid_limits_table = {
    .parameters = grid_limits_parameters,
    .count = LX_COUNT(grid_limits_parameters),
    .size = sizeof(struct lx_grid_limits),
};

static const struct lx_parameter glare_limits_parameters[] = {
    {
        .name = "ugr",
        .label = "UGR at most",
        .type = LX_REAL,
        .offset = offsetof(struct lx_glare_limits, ugr),
        .advised = {LX_BETWEEN(10, 28)},
        .meaning = "the greatest unified glare rating; standards have 13, 16, 19, 22, 25 and 28",
    },
    {
        .name = "preset",
        .label = "Row of a standard",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_glare_limits, preset),
        .choices = glare_row_names,
        .meaning = "the greatest unified glare rating of a row of EN 12464-1:2011, which ugr replaces",
    },
};

static const struct lx_table glare_limits_table = {
    .parameters = glare_limits_parameters,
    .count = LX_COUNT(glare_limits_parameters),
    .size = sizeof(struct lx_glare_limits),
};

static const struct lx_parameter sight_parameters[] = {
    {
        .name = "name",
        .label = "Name",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_glare_observer, name),
        .meaning = "a name for messages and tables",
    },
    {
        .name = "eye",
        .label = "Eye",
        .type = LX_REALS,
        .offset = offsetof(struct lx_glare_observer, eye_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "where the observer's eye is, or the middle of the rectangle in which places are",
    },
    {
        .name = "view",
        .label = "View",
        .type = LX_REALS,
        .offset = offsetof(struct lx_glare_observer, view),
        .count = 3,
        .nonzero = true,
        .meaning =
            "the direction, of any length, in which the observer looks; of several places (n) it may be left out, "
            "for the four level ones along the sides of the rectangle",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct lx_glare_observer, size_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .legal = LX_ABOVE(0),
        .meaning = "the width and the depth of a level rectangle around the eye, in whose cells places are",
    },
    {
        .name = "n",
        .label = "Places",
        .type = LX_WHOLES,
        .offset = offsetof(struct lx_glare_observer, n),
        .count = 2,
        .legal = LX_BETWEEN(1, 100),
        .meaning = "the number of places, [columns, rows], at the centres of the cells of that rectangle",
    },
    {
        .name = "limits",
        .label = "Limits",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_glare_observer, limits),
        .group = &glare_limits_table,
        .meaning = "what the glare is to keep: pass, fail, or undecided where its bound spans the limit",
    },
};

static const struct lx_rule sight_rules[] = {
    {LX_RULE_NEEDED, "size", "n", NULL},
    {LX_RULE_NEEDED, "n", "size", NULL},
};

/* One eye looks somewhere. */
static void check_sight(const struct lx_check *check, void *parameters)
{
    struct lx_glare_observer *observer = parameters;
    const bool has_places = lx_is_given(check->table, parameters, "n");
    if (!has_places)
        observer->n[0] = observer->n[1] = 1;
    if (!has_places && !lx_is_given(check->table, parameters, "view"))
        lx_check_report(check, "view", LX_ALL_OF_IT, LX_MSG_MISSING_KEY, NULL);
}

const struct lx_table lx_glare_observer_table = {
    .parameters = sight_parameters,
    .count = LX_COUNT(sight_parameters),
    .rules = sight_rules,
    .rule_count = LX_COUNT(sight_rules),
    .size = sizeof(struct lx_glare_observer),
    .check = check_sight,
};

static double limit_of(const struct lx_table *table, const void *limits, const char *key, double own, double of_row)
{
    return lx_is_given(table, limits, key) ? own : of_row > 0 ? of_row : (double)NAN;
}

double lx_grid_limit(const struct lx_grid_limits *limits, enum lx_grid_limit which, const char **name)
{
    const bool has_row = lx_is_given(&lx_grid_limits_table, limits, "preset");
    *name = grid_limits_parameters[which].name;
    if (which == LX_LIMIT_SHARE)
        return limit_of(&lx_grid_limits_table, limits, *name, limits->share.percent, 0);
    return limit_of(&lx_grid_limits_table, limits, *name, limits->wanted[which],
                    has_row ? rows[limits->preset].wanted[which] : 0);
}

double lx_glare_limit(const struct lx_glare_limits *limits)
{
    const bool has_row = lx_is_given(&glare_limits_table, limits, "preset");
    return limit_of(&glare_limits_table, limits, "ugr", limits->ugr, has_row ? rows[limits->preset].ugr : 0);
}

bool lx_observer_has_view(const struct lx_glare_observer *observer)
{
    return lx_is_given(&lx_glare_observer_table, observer, "view");
}
