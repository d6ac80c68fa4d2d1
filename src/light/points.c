/* SPDX-License-Identifier: MIT */
/*
 * The cloud of point sources: places and intensities from a file, and one pattern, axis or aim, and attenuation for all
 * of them, such as a lamp measured as many small sources.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../format/cloud.h"
#include "../parameter/check.h"
#include "pattern.h"
#include "placed.h"

struct points_parameters {
    uint64_t given;
    const char *file;
    double intensity; /* of each, where the file tells none */
    struct lx_shining shining;
    struct lx_pattern pattern;
    struct lx_cloud *cloud; /* what was read of the file */
};

static const struct lx_parameter points_parameters[] = {
    {
        .name = "file",
        .label = "File",
        .type = LX_TEXT,
        .offset = offsetof(struct points_parameters, file),
        .required = true,
        .meaning = "a CSV or NPY file with a row x, y, z, intensity for each source, or x, y, z with the key "
                   "intensity, up to ten million, in mm and the unit of intensities, or an .lp file; relative to the "
                   "folder of the scene, or to the current one where the scene comes from standard input",
    },
    {
        .name = "intensity",
        .label = "Intensity",
        .type = LX_REAL,
        .offset = offsetof(struct points_parameters, intensity),
        .unit = LX_UNIT_INTENSITY,
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0.01, 10000)},
        .meaning = "the intensity, radiant or luminous, of each source, along the axis where it depends on the "
                   "direction, for files that give none: without it, those of an .lp file have 1",
    },
    LX_SHINING_PARAMETERS(struct points_parameters, shining),
    LX_PATTERN_PARAMETERS(struct points_parameters),
};

static const struct lx_rule points_rules[] = {
    LX_SHINING_RULES,
    LX_PATTERN_RULES,
};

static void check_points(const struct lx_check *check, void *parameters);

static void release_points(void *parameters)
{
    struct points_parameters *points = parameters;
    lx_kept_release((struct lx_kept *)points->cloud);
    points->cloud = NULL;
}

static const struct lx_table points_table = {
    .parameters = points_parameters,
    .count = LX_COUNT(points_parameters),
    .rules = points_rules,
    .rule_count = LX_COUNT(points_rules),
    .size = sizeof(struct points_parameters),
    .check = check_points,
    .release = release_points,
};

/* ---- checking ---- */

static void report_cloud(const struct lx_check *check, const char *path, const struct lx_cloud_report *report)
{
    char number[LX_NUMBER_SIZE], column[LX_NUMBER_SIZE];
    struct lx_text words = {0};
    bool is_table = report->message == LX_MSG_CLOUD_TABLE || report->message == LX_MSG_CLOUD_LINE ||
                    report->message == LX_MSG_CLOUD_PLACE;
    if (is_table)
        lx_add_fault(&words, &report->fault);
    if (report->message == LX_MSG_OUT_OF_MEMORY || words.failed) {
        check->walk->out_of_memory = true;
        lx_text_clear(&words);
        return;
    }
    lx_write_number((double)report->number, number);
    lx_write_number(report->fault.column, column);
    if (is_table)
        lx_check_report(check, "file", LX_ALL_OF_IT, report->message,
                        LX_ARGS(path, number, LX_WORDS(words.bytes), column));
    else
        lx_check_report(check, "file", LX_ALL_OF_IT, report->message, LX_ARGS(path, number, report->text));
    const struct lx_text_table_fault *fault = &report->fault;
    if (is_table && fault->hint != LX_MSG_COUNT)
        lx_check_hint(check, fault->hint, LX_ARGS(fault->words[0], fault->words[1], fault->words[2]));
    else if (report->message == LX_MSG_CLOUD_UNIT)
        lx_check_hint(check, LX_MSG_HINT_CLOUD_UNITS, NULL);
    lx_text_clear(&words);
}

/* Reads the file, unless the scene has done so already; false where that failed, which is reported. */
static bool load_cloud(const struct lx_check *check, struct points_parameters *points, const char *path)
{
    points->cloud = (struct lx_cloud *)lx_check_kept(check, path, lx_cloud_free);
    if (points->cloud)
        return true;
    struct lx_source *source = lx_check_open(check, "file", path, LX_LARGEST_CLOUD);
    if (!source)
        return false;
    struct lx_cloud_report report = lx_cloud_read(source, &points->cloud);
    if (lx_check_close(check, "file", source) && report.message != LX_MSG_COUNT)
        report_cloud(check, path, &report);
    if (points->cloud)
        lx_check_keep(check, path, &points->cloud->kept);
    return points->cloud;
}

/* One intensity for all sources of a file that tells none, and not for one that tells them. */
static bool give_intensity(const struct lx_check *check, struct points_parameters *points, const char *path)
{
    bool is_given = lx_is_given(&points_table, points, "intensity");
    enum lx_cloud_intensities told = points->cloud->intensities;
    if (is_given && told == LX_CLOUD_TOLD) {
        lx_check_report(check, "intensity", LX_ALL_OF_IT, LX_MSG_CLOUD_HAS_INTENSITIES, LX_ARGS(path));
        return false;
    }
    if (!is_given && told == LX_CLOUD_NOT_TOLD) {
        lx_check_report(check, "file", LX_ALL_OF_IT, LX_MSG_CLOUD_INTENSITY, LX_ARGS(path));
        lx_check_hint(check, LX_MSG_HINT_CLOUD_INTENSITY, NULL);
        return false;
    }
    if (!is_given || told == LX_CLOUD_TOLD)
        return true;
    struct lx_cloud *same = lx_cloud_with_intensity(points->cloud, points->intensity);
    if (!same) {
        check->walk->out_of_memory = true;
        return false;
    }
    lx_kept_release(&points->cloud->kept);
    points->cloud = same;
    return true;
}

/* No source stands where all are aimed. */
static void check_aim(const struct lx_check *check, const struct points_parameters *points, const char *path)
{
    char number[LX_NUMBER_SIZE];
    const double *aim = points->shining.aim_mm;
    for (size_t i = 0; i < points->cloud->count; i++) {
        double row[LX_CLOUD_COLUMNS];
        lx_cloud_row(points->cloud, i, row);
        if (row[0] == aim[0] && row[1] == aim[1] && row[2] == aim[2]) {
            lx_check_report(check, "aim", LX_ALL_OF_IT, LX_MSG_CLOUD_AIM,
                            LX_ARGS(path, lx_write_number((double)i + 1, number)));
            return;
        }
    }
}

/* What the file has and is not used, and what it lacks. */
static void advise_points(const struct lx_check *check, const struct points_parameters *points)
{
    const struct lx_cloud *cloud = points->cloud;
    if (cloud && cloud->unused[0])
        lx_check_advise(check, "file", LX_MSG_CLOUD_UNUSED, LX_ARGS(points->file, cloud->unused));
    if (cloud && cloud->intensities == LX_CLOUD_LP && !lx_is_given(&points_table, points, "intensity"))
        lx_check_advise(check, "file", LX_MSG_CLOUD_LP, LX_ARGS(points->file));
}

static void check_points(const struct lx_check *check, void *parameters)
{
    struct points_parameters *points = parameters;
    if (check->advises) {
        advise_points(check, points);
        return;
    }
    char *path = lx_check_path(check, points->file);
    if (path && load_cloud(check, points, path) && give_intensity(check, points, path) &&
        lx_is_given(&points_table, points, "aim"))
        check_aim(check, points, path);
    free(path);
}

/* ---- the kind ---- */

static int prepare_points(const void *parameters, struct lx_emitters *emitters)
{
    static const double origin[3] = {0};
    const struct points_parameters *points = parameters;
    const struct lx_shining *shining = &points->shining;
    bool has_axis = lx_pattern_has_axis(&points->pattern);
    struct lx_profile profile = lx_pattern_profile(&points->pattern, lx_unit3(lx_exact3(shining->axis)));
    struct lx_point_set set = {
        .cloud = points->cloud,
        .model = lx_shining_emitter(shining, origin, 0, profile),
        .is_aimed = has_axis && lx_is_given(&points_table, points, "aim"),
    };
    memcpy(set.aim_mm, shining->aim_mm, sizeof set.aim_mm);
    return lx_emitters_append_point_set(emitters, &set);
}

const struct lx_light_kind lx_points_kind = {
    .variant =
        {
            .name = "points",
            .meaning = "a cloud of small sources, listed in a file",
            .table = &points_table, /* no example: it would need a file */
        },
    .prepare = prepare_points,
};
