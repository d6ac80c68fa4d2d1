/* SPDX-License-Identifier: MIT */
/* luxel figure, as luxel-draw runs it: from the options to the figure's settings, and each FILE. */
#include <luxel/figure.h>

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "../../front/language.h"
#include "../argument.h"
#include "../cli.h"
#include "../drawing.h"
#include "../grid_named.h"
#include "../json.h"
#include "../load.h"
#include "../message.h"
#include "../outputs.h"
#include "../text.h"
#include "../work.h"

static int list_palettes(bool as_json)
{
    struct json json = {.stream = stdout};

    if (as_json) {
        json_open(&json, NULL, '{');
        json_open(&json, "palettes", '[');
        for (size_t i = 0; luxel_palette_name(i); i++) {
            json_open(&json, NULL, '{');
            json_text(&json, "name", luxel_palette_name(i));
            json_text(&json, "meaning", luxel_palette_meaning(i));
            json_close(&json, '}');
        }
        json_close(&json, ']');
        json_close(&json, '}');
        return EXIT_DONE;
    }
    for (size_t i = 0; luxel_palette_name(i); i++) {
        char term[TEXT_SIZE];

        text_definition(stdout, text_format(term, "  %s", luxel_palette_name(i)), 14, _(luxel_palette_meaning(i)));
    }
    return EXIT_DONE;
}

/* center, maximum, or a point. */
static bool take_section(const char *argument, luxel_figure_settings *figure)
{
    static const char *const words[] = {"center", "maximum"};
    const char *nearest;

    if (strcmp(argument, words[0]) == 0) {
        figure->section = LUXEL_SECTION_CENTER;
        return true;
    }
    if (strcmp(argument, words[1]) == 0) {
        figure->section = LUXEL_SECTION_MAXIMUM;
        return true;
    }
    figure->section = LUXEL_SECTION_POINT;
    if (strchr(argument, ','))
        return argument_numbers("--section", "X,Y", argument, figure->section_mm, 2);
    message_error(_("--section %s: expected center, maximum or X,Y"), argument);
    nearest = luxel_nearest_word(argument, words, COUNT_OF(words));
    message_did_you_mean(nearest);
    return false;
}

static bool take_bands(const struct option_drawing *drawing, luxel_figure_settings *figure)
{
    if (drawing->contours + drawing->bands + drawing->lines + drawing->plain > 1) {
        message_error(_("only one of --contour, --bands, --lines and --plain can be drawn"));
        return false;
    }
    figure->bands = drawing->bands   ? LUXEL_BANDS_STEPS
                    : drawing->lines ? LUXEL_BANDS_LINES
                    : drawing->plain ? LUXEL_BANDS_SMOOTH
                                     : LUXEL_BANDS_CONTOURS;
    return true;
}

static bool take_settings(const struct options *options, const luxel_language *language, luxel_figure_settings *figure)
{
    const struct option_drawing *drawing = &options->drawing;
    const struct option_analysis *analysis = &options->analysis;

    luxel_figure_settings_init(figure);
    figure->language = language;
    figure->palette = drawing->palette;
    figure->title = drawing->title;
    figure->label = drawing->label;
    figure->low = analysis->scale[0];
    figure->high = analysis->scale[1];
    figure->logarithmic = analysis->logarithmic;
    figure->extrema = !drawing->no_extrema;
    figure->points = !drawing->no_points;
    figure->stacked = drawing->stacked;
    figure->dark = drawing->dark;
    figure->daylight = drawing->daylight;
    figure->view = (luxel_color_view)analysis->view;
    if (analysis->wanted_levels > 0)
        figure->levels = analysis->wanted_levels;
    figure->level_list = analysis->levels;
    figure->level_list_count = analysis->level_count;
    if (options_given(options, "width"))
        figure->width_mm = drawing->width_mm;
    if (options_given(options, "dpi"))
        figure->dots_per_inch = drawing->dots_per_inch;
    return take_bands(drawing, figure) && (!drawing->section || take_section(drawing->section, figure));
}

/* The comment that a scene begins with, up to its line's end; "" where it begins otherwise.  What editors are told
 * there is no title. */
static void take_comment(const luxel_scene *scene, char *buffer, size_t size)
{
    char *text = NULL;

    *buffer = '\0';
    if (luxel_scene_write_text(scene, &text) != LUXEL_OK)
        return;
    for (const char *at = text; *at == '#' && *buffer == '\0'; at += strcspn(at, "\n"), at += *at == '\n') {
        const size_t marks = strspn(at, "# \t"), length = strcspn(at, "\r\n");

        if (length <= marks)
            continue;
        snprintf(buffer, size, "%.*s", (int)(length - marks < size ? length - marks : size - 1), at + marks);
        if (strncmp(buffer, "yaml-language-server:", 21) == 0)
            *buffer = '\0';
    }
    luxel_text_free(text);
}

/* That of a built-in scene as it is, and its name where it was changed; else the comment that the scene begins with,
 * which may be that of a built-in one. */
static const char *default_title(const struct options *options, const struct loaded *loaded, char *buffer, size_t size)
{
    const size_t builtin = load_find_builtin(options->operand);

    if (builtin < luxel_builtin_scene_count() && (!options->operand || access(options->operand, F_OK) != 0))
        return options->assignment_count == 0 ? _(luxel_builtin_scene_title(builtin)) : loaded->name;
    take_comment(loaded->scene, buffer, size);
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++)
        if (strcmp(buffer, luxel_builtin_scene_title(i)) == 0)
            return _(luxel_builtin_scene_title(i));
    return buffer;
}

static luxel_status write_figures(const struct loaded *loaded, const luxel_settings *settings, const void *look,
                                  const char *const *paths, size_t count, bool *written)
{
    return luxel_figure_write_files(loaded->scene, settings, look, paths, count, loaded->diagnostics, written);
}

static int figure(const struct options *options, const struct loaded *loaded)
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_figure_settings settings;
    char name[256];

    if (!take_settings(options, &language, &settings))
        return EXIT_USAGE;
    if (options->drawing.grid && (settings.grid = grid_named(options->drawing.grid, loaded)) == 0)
        return EXIT_USAGE;
    if (!settings.title && settings.grid > 0)
        settings.title = luxel_scene_grid_name(loaded->scene, settings.grid - 1);
    if (!settings.title)
        settings.title = default_title(options, loaded, name, sizeof name);
    return work_write_files(options, loaded, write_figures, &settings);
}

/* Whether all that is asked for can be drawn of a grid; if not, says what cannot. */
static bool suits_grid(const struct options *options)
{
    if (options->drawing.section)
        message_error(_("--section is of the picture: the figure of a grid has no sections"));
    else if (options_given(options, "quantity") && options->settings.quantity != LUXEL_IRRADIANCE)
        message_error(_("luxel grid measures the irradiance: a measuring plane has no material to be bright by"));
    else
        return true;
    return false;
}

int drawing_figure(const struct options *options)
{
    int code;

    if (options->drawing.palettes)
        return list_palettes(options->json);
    if (options->output_count == 0) {
        message_error(_("luxel figure needs a file to write to"));
        message_hint(_("add -o FILE.png, -o FILE.svg or -o FILE.pdf"));
        return EXIT_USAGE;
    }
    if (options->drawing.daylight && !options->drawing.grid) {
        message_error(_("--daylight is of a measuring grid"));
        message_hint(_("name one by --grid NAME"));
        return EXIT_USAGE;
    }
    if (options->drawing.grid && !suits_grid(options))
        return EXIT_USAGE;
    code = outputs_check(options, luxel_check_figure_name);
    return code == EXIT_DONE ? load_and(options, figure) : code;
}
