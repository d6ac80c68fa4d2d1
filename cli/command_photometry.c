/* SPDX-License-Identifier: MIT */
/* luxel photometry: what a luminaire file says, and what follows from its table. */
#include <luxel/luxel.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "drawing.h"
#include "message.h"
#include "outputs.h"
#include "photometry.h"
#include "standard_output.h"
#include "text.h"

/* ---- what the file says ---- */

static void add(struct text_table *table, const char *name, const char *text)
{
    text_table_row(table, TEXT_CELLS(name, text));
}

/* A text of the file, without what could steer a terminal; lines that go on become one, cut where it is long. */
static void add_text(struct text_table *table, const char *name, const char *text)
{
    char line[TEXT_SIZE / 4], *escaped;
    size_t length = 0;

    if (!text || !*text)
        return;
    for (; text[length] && length + 4 < sizeof line; length++)
        line[length] = text[length] == '\n' ? ' ' : text[length];
    while (text[length] && length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80)
        length--; /* no character is cut in half */
    strcpy(line + length, text[length] ? "…" : "");
    escaped = luxel_escaped_text(line);
    if (escaped)
        add(table, name, escaped);
    luxel_text_free(escaped);
}

static const char *symmetry_words(luxel_photometry_symmetry symmetry)
{
    static const char *const words[] = {
        [LUXEL_SYMMETRY_NONE] = N_("none"),
        [LUXEL_SYMMETRY_AXIAL] = N_("about the axis"),
        [LUXEL_SYMMETRY_QUADRANT] = N_("about C0-C180 and C90-C270"),
        [LUXEL_SYMMETRY_BILATERAL_0] = N_("about C0-C180"),
        [LUXEL_SYMMETRY_BILATERAL_90] = N_("about C90-C270"),
        [LUXEL_SYMMETRY_LATERAL] = N_("left and right"),
    };

    return _(words[symmetry]);
}

static const char *opening_words(const luxel_photometry_opening *opening, char buffer[TEXT_SIZE])
{
    static const char *const words[] = {
        [LUXEL_OPENING_POINT] = N_("point"),
        [LUXEL_OPENING_RECTANGLE] = N_("rectangle"),
        [LUXEL_OPENING_BOX] = N_("box with luminous sides"),
        [LUXEL_OPENING_ELLIPSE] = N_("ellipse"),
        [LUXEL_OPENING_CYLINDER] = N_("upright cylinder"),
        [LUXEL_OPENING_ELLIPSOID] = N_("ellipsoid"),
        [LUXEL_OPENING_CYLINDER_LENGTH] = N_("cylinder along C0-C180"),
        [LUXEL_OPENING_CYLINDER_WIDTH] = N_("cylinder along C90-C270"),
        [LUXEL_OPENING_FACING_LENGTH] = N_("upright ellipse facing along C0-C180"),
        [LUXEL_OPENING_FACING_WIDTH] = N_("upright ellipse facing along C90-C270"),
    };
    const double length = opening->length_mm, width = opening->width_mm, height = opening->height_mm;

    if (opening->shape == LUXEL_OPENING_POINT)
        return _(words[LUXEL_OPENING_POINT]);
    if (opening->shape == LUXEL_OPENING_ELLIPSE && length == width)
        return text_format(buffer, _("disk, %.6g mm across"), width);
    if (opening->shape == LUXEL_OPENING_ELLIPSOID && length == width && width == height)
        return text_format(buffer, _("sphere, %.6g mm across"), width);
    if (height == 0)
        return text_format(buffer, _("%s, %.6g mm along C0-C180, %.6g mm along C90-C270"), _(words[opening->shape]),
                           length, width);
    return text_format(buffer, _("%s, %.6g mm along C0-C180, %.6g mm along C90-C270, %.6g mm high"),
                       _(words[opening->shape]), length, width, height);
}

/* The names of the angles in the file, and their range. */
static const char *table_words(const luxel_photometry *photometry, char buffer[TEXT_SIZE])
{
    const size_t planes = photometry->plane_count, angles = photometry->angle_count;

    if (photometry->type != LUXEL_PHOTOMETRY_TYPE_C)
        return text_format(
            buffer, _("horizontal angles: %zu, %.6g to %.6g degrees; vertical angles: %zu, %.6g to %.6g degrees"),
            planes, photometry->planes[0], photometry->planes[planes - 1], angles, photometry->angles[0],
            photometry->angles[angles - 1]);
    return text_format(buffer, _("C planes: %zu, stored: %zu; angles gamma: %zu, %.6g to %.6g degrees"),
                       photometry->declared_planes, photometry->stored_planes, angles, photometry->angles[0],
                       photometry->angles[angles - 1]);
}

static void add_lamps(struct text_table *table, const luxel_photometry *photometry)
{
    char text[TEXT_SIZE], number[TEXT_SIZE];

    for (size_t i = 0; i < photometry->lamp_set_count; i++) {
        const luxel_photometry_lamp_set *lamps = &photometry->lamp_sets[i];

        text_format(number, "%.6g", fabs(lamps->count));
        if (i == 0)
            text_format(text, "%s × %.150s", number, *lamps->type ? lamps->type : _("lamp"));
        else
            text_format(text, _("%s × %.60s, %.6g lm in all, %.6g W"), number, *lamps->type ? lamps->type : _("lamp"),
                        lamps->lumens, lamps->watts);
        add_text(table, i == 0 ? _("lamps") : _("other lamps"), text);
        if (*lamps->temperature)
            add_text(table, _("colour temperature"), lamps->temperature);
        if (*lamps->rendering)
            add_text(table, _("colour rendering"), lamps->rendering);
    }
    if (isfinite(photometry->declared_lumens))
        add(table, _("declared lumens"), text_format(text, _("%.7g lm"), photometry->declared_lumens));
    add(table, _("photometry"),
        photometry->is_absolute ? _("absolute: the intensities are those of the luminaire as it was measured")
                                : _("relative: the intensities belong to the declared lumens"));
    add(table, _("input power"), text_format(text, _("%.6g W"), photometry->watts));
}

static void add_file(struct text_table *table, const luxel_photometry *photometry)
{
    static const char *const type_words[] = {
        [LUXEL_PHOTOMETRY_TYPE_A] = "A", [LUXEL_PHOTOMETRY_TYPE_B] = "B", [LUXEL_PHOTOMETRY_TYPE_C] = "C"};
    char text[TEXT_SIZE];

    add(table, _("format"),
        text_format(text, _("%s, type %s"), luxel_photometry_format_name(photometry), type_words[photometry->type]));
    add_text(table, _("maker"), luxel_photometry_find_text(photometry, "MANUFAC"));
    add_text(table, _("luminaire"), luxel_photometry_find_text(photometry, "LUMINAIRE"));
    add_text(table, _("number"), luxel_photometry_find_text(photometry, "LUMCAT"));
    add(table, _("symmetry"), symmetry_words(photometry->symmetry));
    add(table, _("table"), table_words(photometry, text));
    add(table, _("luminous opening"), opening_words(&photometry->opening, text));
    add_lamps(table, photometry);
}

/* ---- what follows from the table ---- */

/* Adds a row unless the number is none. */
static void add_number(struct text_table *table, const char *name, const char *format, double number)
{
    char text[TEXT_SIZE];

    if (isfinite(number))
        add(table, name, text_format(text, format, number)); /* a format of ours */
}

static void add_angles(struct text_table *table, const luxel_photometry *photometry,
                       const luxel_photometry_figures *figures)
{
    const bool is_turn = photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    char text[TEXT_SIZE];

    if (is_turn)
        text_format(text, _("%.8g cd at C = %.6g, gamma = %.6g degrees"), figures->greatest_cd, figures->greatest_c_deg,
                    figures->greatest_gamma_deg);
    else
        text_format(text, _("%.8g cd at %.6g degrees across, %.6g degrees up"), figures->greatest_cd,
                    figures->greatest_plane_deg, figures->greatest_angle_deg);
    add(table, _("greatest intensity"), text);
    if (!isfinite(figures->beam_deg))
        return;
    add(table, _("beam angle (50 %)"),
        text_format(text,
                    is_turn ? _("%.4g degrees (C0-C180: %.4g, C90-C270: %.4g)")
                            : _("%.4g degrees (across: %.4g, upwards: %.4g)"),
                    figures->beam_deg, figures->beam_sections_deg[0], figures->beam_sections_deg[1]));
    add(table, _("field angle (10 %)"),
        text_format(text,
                    is_turn ? _("%.4g degrees (C0-C180: %.4g, C90-C270: %.4g)")
                            : _("%.4g degrees (across: %.4g, upwards: %.4g)"),
                    figures->field_deg, figures->field_sections_deg[0], figures->field_sections_deg[1]));
}

static void add_flux(struct text_table *table, const luxel_photometry *photometry,
                     const luxel_photometry_figures *figures)
{
    char text[TEXT_SIZE];

    add_number(table, _("flux, zone rule"), _("%.7g lm"), figures->zone_lumens);
    add_number(table, _("flux, linear rule"), _("%.7g lm"), figures->linear_lumens);
    if (photometry->watts > 0)
        add_number(table, _("efficacy"), _("%.4g lm/W"), figures->zone_lumens / photometry->watts);
    if (isfinite(figures->lorl) && isfinite(photometry->declared_lorl))
        add(table, _("light output ratio (LORL)"),
            text_format(text, _("%.4f %% (declared: %.4g %%)"), figures->lorl, photometry->declared_lorl));
    else
        add_number(table, _("light output ratio (LORL)"), "%.4f %%", figures->lorl);
    if (isfinite(figures->dff) && isfinite(photometry->declared_dff))
        add(table, _("downward flux fraction (DFF)"),
            text_format(text, _("%.4f %% (declared: %.4g %%)"), figures->dff, photometry->declared_dff));
    else
        add_number(table, _("downward flux fraction (DFF)"), "%.4f %%", figures->dff);
}

static const char *code_text(const luxel_photometry_figures *figures, char buffer[TEXT_SIZE])
{
    size_t used = 0;

    for (int i = 0; i < 5; i++)
        used += (size_t)snprintf(buffer + used, TEXT_SIZE - used, isfinite(figures->flux_code[i]) ? "%s%.0f" : "%s-",
                                 i > 0 ? " " : "", figures->flux_code[i]);
    return buffer;
}

static const char *spacing_text(const luxel_photometry_figures *figures, char buffer[TEXT_SIZE])
{
    return text_format(buffer, _("%.3g along C0-C180, %.3g along C90-C270, %.3g diagonally"), figures->spacing[0],
                       figures->spacing[1], figures->spacing[2]);
}

static void print_ratios(const luxel_photometry_figures *figures)
{
    struct text_table *table = text_table_new("lrrrrrrrrrr");
    char cells[2][LUXEL_ROOM_INDICES][TEXT_SIZE];
    const char *rows[2][LUXEL_ROOM_INDICES + 1] = {{_("room index k")}, {_("direct ratio")}};

    for (size_t i = 0; i < LUXEL_ROOM_INDICES; i++) {
        rows[0][i + 1] = text_format(cells[0][i], "%.3g", luxel_photometry_room_index(i));
        rows[1][i + 1] = text_format(cells[1][i], "%.3f", figures->direct_ratios[i]);
    }
    text_table_row(table, rows[0]);
    text_table_row(table, rows[1]);
    text_table_print(table, stdout, 2);
}

/* UGR of the standard rooms, as catalogues lay it out: reflectances above, crosswise on the left, endwise right. */
static void print_glare(const luxel_ugr_table *glare)
{
    enum { COLUMNS = 2 + 2 * LUXEL_UGR_REFLECTANCES };
    const char *const parts[] = {_("ceiling, %"), _("walls, %"), _("floor, %")};
    struct text_table *table = text_table_new("lrrrrrlrrrrr");
    char cells[COLUMNS][TEXT_SIZE], label[TEXT_SIZE];
    const char *row[COLUMNS];

    printf(_("\n  UGR (CIE 190), luminaires %.3g of their height above the eye apart: crosswise, endwise\n\n"),
           glare->spacing);
    for (size_t line = 0; line < 3 + LUXEL_UGR_ROOMS; line++) {
        const size_t room = line - 3;

        row[0] = line < 3 ? parts[line]
                          : text_format(label, "%.3gH × %.3gH", luxel_ugr_room(room, 0), luxel_ugr_room(room, 1));
        row[1 + LUXEL_UGR_REFLECTANCES] = "";
        for (size_t i = 0; i < 2 * LUXEL_UGR_REFLECTANCES; i++) {
            const size_t way = i / LUXEL_UGR_REFLECTANCES, k = i % LUXEL_UGR_REFLECTANCES;
            const double number = line < 3 ? 100 * luxel_ugr_reflectance(k, line) : glare->ratings[room][way][k];

            row[1 + i + way] = isfinite(number) ? text_format(cells[i], line < 3 ? "%.0f" : "%.1f", number) : "-";
        }
        text_table_row(table, row);
    }
    text_table_print(table, stdout, 2);
}

/* One room with the light that its surfaces really reflect, below what the tabular method makes of it. */
static void print_room(const struct luminaire *luminaire)
{
    const struct room_ratings *room = &luminaire->room;
    const luxel_ugr_table *glare = &luminaire->glare;
    const double *const tabular = glare->backgrounds[room->room];
    const char *const names[] = {_("ceiling, %"),
                                 _("walls, %"),
                                 _("floor, %"),
                                 _("background by the table, cd/m²"),
                                 _("background, cd/m²"),
                                 _("its error at most"),
                                 _("crosswise, by the table"),
                                 _("crosswise"),
                                 _("endwise, by the table"),
                                 _("endwise"),
                                 _("error at most")};
    struct text_table *table = text_table_new("lrrrrr");
    char cells[LUXEL_UGR_REFLECTANCES][TEXT_SIZE];
    const char *row[1 + LUXEL_UGR_REFLECTANCES];

    printf(_("\n  UGR in the room of %.3gH × %.3gH by the light that its walls really reflect, luminaires %.3g H "
             "apart; backgrounds for H = 1 m\n\n"),
           luxel_ugr_room(room->room, 0), luxel_ugr_room(room->room, 1), glare->spacing);
    for (size_t line = 0; line < COUNT_OF(names); line++) {
        row[0] = names[line];
        for (size_t i = 0; i < LUXEL_UGR_REFLECTANCES; i++) {
            const double numbers[] = {line < 3 ? 100 * luxel_ugr_reflectance(i, line) : 0,
                                      0,
                                      0,
                                      tabular[i],
                                      room->background[i].value,
                                      room->background[i].error,
                                      glare->ratings[room->room][0][i],
                                      room->ratings[0][i],
                                      glare->ratings[room->room][1][i],
                                      room->ratings[1][i],
                                      room->errors[i]};

            if (line < 3)
                text_format(cells[i], "%.0f", numbers[0]);
            else
                text_format(cells[i], line < 5 ? "%.4g" : line == 5 || line == 10 ? "%.2g" : "%.2f", numbers[line]);
            row[1 + i] = cells[i];
        }
        text_table_row(table, row);
    }
    text_table_print(table, stdout, 2);
}

static void print_warnings(const struct luminaire *luminaire)
{
    char *warning;

    for (size_t i = 0; (warning = luminaire_warning(luminaire, i, false)) != NULL; i++) {
        if (i == 0)
            fputs(_("\nWarnings:\n"), stdout);
        fputs("  ", stdout);
        text_print_escaped(stdout, warning);
        fputc('\n', stdout);
        free(warning);
    }
}

static void print_text(const struct luminaire *luminaire)
{
    const luxel_photometry_figures *figures = &luminaire->figures;
    struct text_table *table = text_table_new("ll");
    char text[TEXT_SIZE];

    text_print_escaped(stdout, luminaire->name);
    fputs("\n\n", stdout);
    add_file(table, luminaire->photometry);
    text_table_print(table, stdout, 2);
    fputc('\n', stdout);
    table = text_table_new("ll");
    add_flux(table, luminaire->photometry, figures);
    add_angles(table, luminaire->photometry, figures);
    if (luminaire->photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        add(table, _("CIE flux code"), code_text(figures, text));
    if (isfinite(figures->spacing[0]) && isfinite(figures->spacing[1]) && isfinite(figures->spacing[2]))
        add(table, _("spacing criterion"), spacing_text(figures, text));
    if (luminaire->bug.exists)
        add(table, _("backlight, uplight, glare (TM-15-11)"),
            text_format(text, _("B%u U%u G%u, the front at C = %.0f degrees"), luminaire->bug.backlight,
                        luminaire->bug.uplight, luminaire->bug.glare, luminaire->bug.front_c_deg));
    text_table_print(table, stdout, 2);
    if (isfinite(figures->direct_ratios[0])) {
        fputc('\n', stdout);
        print_ratios(figures);
    }
    if (luminaire->glare.exists)
        print_glare(&luminaire->glare);
    if (luminaire->room.exists)
        print_room(luminaire);
    print_warnings(luminaire);
}

/* ---- files ---- */

static const char *const endings[] = {".png", ".svg", ".pdf", ".html", ".md", ".tex", ".csv", ".ies", ".ldt"};
enum { PDF = 2, DRAWN_ENDINGS = 7 };

static luxel_status check_name(const char *path, luxel_diagnostics *diagnostics)
{
    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}

static bool is_among(const char *path, const char *const *some, size_t count)
{
    return luxel_check_ending(path, some, count, NULL) == LUXEL_OK;
}

bool luminaire_is_sheet(const struct options *options, const char *path)
{
    return is_among(path, endings + PDF, DRAWN_ENDINGS - PDF) &&
           !(options_given(options, "diagram") && is_among(path, endings + PDF, 1));
}

/* A diagram or a sheet. */
static bool is_drawn(const char *path)
{
    return is_among(path, endings, DRAWN_ENDINGS);
}

static int write_outputs(const struct options *options, const struct luminaire *luminaire, luminaire_draw *draw)
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const char *path = options->outputs[i];
        const luxel_status status = draw && is_drawn(path)
                                        ? draw(options, luminaire, path, diagnostics)
                                        : luxel_photometry_write(luminaire->photometry, path, diagnostics);

        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        else if (!options->quiet)
            message_diagnostics(stderr, diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ADVICE);
        luxel_diagnostics_clear(diagnostics);
    }
    luxel_diagnostics_free(diagnostics);
    return code;
}

int luminaire_show(const struct options *options, luminaire_draw *draw)
{
    struct luminaire luminaire;
    int code = luminaire_open(options, &luminaire);

    if (code == EXIT_DONE)
        code = room_rate(options, luminaire.photometry, &luminaire.glare, luminaire.figures.dff, &luminaire.room);
    if (code == EXIT_DONE || code == EXIT_TOLERANCE) {
        const int written = write_outputs(options, &luminaire, draw);

        code = written == EXIT_DONE ? code : written;
        if (options->json)
            luminaire_print_json(&luminaire);
        else if (standard_output_is_free(options))
            print_text(&luminaire);
    }
    luminaire_close(&luminaire);
    return code;
}

static int run(const struct options *options)
{
    const int code = outputs_check(options, check_name);
    bool draws = false, has_diagram = false;

    if (code != EXIT_DONE)
        return code;
    for (size_t i = 0; i < options->output_count; i++) {
        draws = draws || is_drawn(options->outputs[i]);
        has_diagram =
            has_diagram || (is_drawn(options->outputs[i]) && !luminaire_is_sheet(options, options->outputs[i]));
    }
    if (options_given(options, "diagram") && !has_diagram) {
        message_error(_("--diagram names what a figure shows, and no file of -o is a figure"));
        message_hint(_("add -o FILE.png, -o FILE.svg or -o FILE.pdf"));
        return EXIT_USAGE;
    }
    return draws ? drawing_photometry(options) : luminaire_show(options, NULL);
}

const struct command command_photometry = {
    .name = "photometry",
    .bit = COMMAND_PHOTOMETRY,
    .operand = N_("FILE"),
    .operand_kind = OPERAND_FILE,
    .endings = ".pdf .html .md .tex .csv .png .svg .ies .ldt",
    .summary = N_("what a luminaire file (IES, EULUMDAT) says"),
    .description = N_(
        "Reads a luminaire file, IES LM-63 of 1986 to 2019 or EULUMDAT, and prints what it says and what follows "
        "from its table of intensities: the flux by the zone rule and by the linear rule, light output ratio and "
        "downward flux fraction, the greatest intensity, beam and field angle, CIE flux code, spacing criterion, "
        "direct ratios and the table of unified glare ratings (UGR) of standard rooms. All errors of a wrong file are "
        "listed with line and column; what is odd is a warning, and no number is ever rescaled in silence. A FILE of "
        "-o is the luminaire's sheet (.pdf, .html, .md, .tex; its tables: .csv), with diagrams, intensities, flux of "
        "zones, luminances, "
        "utilization factors, glare ratings and the rating of backlight and uplight; or a diagram alone (.png, .svg), "
        "the polar one or what --diagram names, which makes a .pdf one, too; or the same luminaire as LM-63-2002 "
        "(.ies) or EULUMDAT (.ldt)."),
    .examples = "luxel photometry lamp.ies\n"
                "luxel photometry lamp.ldt --json\n"
                "luxel photometry lamp.ldt --spacing 1 --room 4,8\n"
                "luxel photometry lamp.ldt -o lamp.ies\n"
                "luxel photometry lamp.ldt -o sheet.pdf\n"
                "luxel photometry lamp.ies -o polar.svg\n"
                "luxel photometry lamp.ies -o cone.pdf --diagram cone",
    .run = run,
};
