/* SPDX-License-Identifier: MIT */
/* luxel report, as luxel-draw runs it. */
#include <luxel/figure.h>

#include <errno.h>
#include <sys/stat.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../drawing.h"
#include "../load.h"
#include "../message.h"
#include "../outputs.h"
#include "../work.h"

static luxel_status write_reports(const struct loaded *loaded, const luxel_settings *settings, const void *look,
                                  const char *const *paths, size_t count, bool *written)
{
    luxel_settings shared = *settings;

    /* The picture, the points, each grid and each observer may take a solution of reflected light. */
    shared.within /= 2.0 + (double)(luxel_scene_grid_count(loaded->scene) + luxel_scene_observer_count(loaded->scene));
    return luxel_report_write_files(loaded->scene, &shared, look, paths, count, loaded->diagnostics, written);
}

static int report(const struct options *options, const struct loaded *loaded)
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    const luxel_report_settings settings = {
        .title = options->drawing.title,
        .author = options->drawing.author,
        .group = options->drawing.group,
        .date = options->drawing.date,
        .institution = options->drawing.institution,
        .faculty = options->drawing.faculty,
        .course = options->drawing.course,
        .teacher = options->drawing.teacher,
        .place = options->drawing.place,
        .aim = options->drawing.aim,
        .palette = options->drawing.palette,
        .digits = options->drawing.digits,
        .purpose = (luxel_report_purpose)options->drawing.purpose,
        .tables = options->drawing.tables,
        .language = &language,
    };

    if (settings.tables && mkdir(settings.tables, 0777) != 0 && errno != EEXIST) {
        message_error(_("cannot create %s: %s"), settings.tables, language_reason(errno));
        return EXIT_FILE;
    }
    return work_write_files(options, loaded, write_reports, &settings);
}

int drawing_report(const struct options *options)
{
    int code;

    if (options->drawing.tables && options->drawing.purpose != LUXEL_REPORT_LIGHTING) {
        message_error(_("--tables has the tables of a lighting design: it goes with --for lighting"));
        return EXIT_USAGE;
    }
    if (options->output_count == 0 && !options->drawing.tables) {
        message_error(_("luxel report needs a file to write to"));
        message_hint(_("add -o FILE.pdf, -o FILE.html, -o FILE.md, -o FILE.tex or -o FILE.csv"));
        return EXIT_USAGE;
    }
    code = outputs_check(options, luxel_check_report_name);
    return code == EXIT_DONE ? load_and(options, report) : code;
}
