/* SPDX-License-Identifier: MIT */
/* luxel photometry with figures among its files, as luxel-draw runs it: from the options to the diagram's settings. */
#include <luxel/figure.h>

#include <stdio.h>
#include <string.h>

#include "../../front/language.h"
#include "../cli.h"
#include "../drawing.h"
#include "../photometry.h"
#include "../work.h"

/* The name of the luminaire in the file, else the name of the file: as much of its first line as a title may be. */
static char *default_title(const struct luminaire *luminaire)
{
    static const char *const keywords[] = {"LUMINAIRE", "LUMCAT"};
    enum { MOST = 80 };
    const char *title = luminaire->name;
    char line[MOST + 8];
    size_t length;

    for (size_t i = COUNT_OF(keywords); i-- > 0;) {
        const char *text = luxel_photometry_find_text(luminaire->photometry, keywords[i]);

        title = text && *text ? text : title;
    }
    length = strcspn(title, "\n");
    if (length > MOST)
        for (length = MOST; length > 0 && ((unsigned char)title[length] & 0xc0) == 0x80;)
            length--; /* no character is cut in half */
    snprintf(line, sizeof line, "%.*s%s", (int)length, title, title[length] ? "…" : "");
    return luxel_escaped_text(line);
}

static luxel_status draw_diagram(const struct options *options, const struct luminaire *luminaire, const char *path,
                                 const luxel_language *language, luxel_diagnostics *diagnostics)
{
    luxel_diagram_settings settings;
    char *title = options->drawing.title ? NULL : default_title(luminaire);
    luxel_status status;

    luxel_diagram_settings_init(&settings);
    settings.language = language;
    settings.diagram = (luxel_diagram)options->drawing.diagram;
    settings.title = options->drawing.title ? options->drawing.title : title;
    settings.dark = options->drawing.dark;
    if (options_given(options, "width"))
        settings.width_mm = options->drawing.width_mm;
    if (options_given(options, "dpi"))
        settings.dots_per_inch = options->drawing.dots_per_inch;
    status = luxel_diagram_write(luminaire->photometry, &settings, path, diagnostics);
    luxel_text_free(title);
    return status;
}

/* The file's name without its folders. */
static const char *own_name(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

static luxel_status draw(const struct options *options, const struct luminaire *luminaire, const char *path,
                         luxel_diagnostics *diagnostics)
{
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    const bool has_path = strcmp(options->operand, "-") != 0;
    struct work work;
    luxel_status status;

    if (!luminaire_is_sheet(options, path))
        return draw_diagram(options, luminaire, path, &language, diagnostics);
    work_begin(&work, options);
    work.settings.reflected_error = 0;
    status = luxel_sheet_write(luminaire->photometry,
                               &(luxel_sheet_settings){.title = options->drawing.title,
                                                       .file = own_name(luminaire->name),
                                                       .path = has_path ? options->operand : NULL,
                                                       .spacing = options->drawing.spacing,
                                                       .warnings = luminaire->diagnostics,
                                                       .settings = &work.settings,
                                                       .language = &language},
                               path, diagnostics);
    progress_end(&work.progress);
    return status;
}

int drawing_photometry(const struct options *options)
{
    return luminaire_show(options, draw);
}
