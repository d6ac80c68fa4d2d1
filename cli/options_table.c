/* SPDX-License-Identifier: MIT */
/*
 * The table of options, with the functions that take their arguments.  getopt_long's own tables, the check that a
 * command takes an option, the help, the man page and the completions are made from it; a new option is one row and, if
 * it is neither a plain flag nor a text that is kept as it is, one function that takes its argument.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "argument.h"
#include "cli.h"
#include "message.h"
#include "options.h"
#include "photometry_room.h"
#include "readings.h"
#include "room_options.h"
#include "sun.h"
#include "sweep_options.h"
#include "text.h"

static const char *const quantity_words[] = {"brightness", "irradiance", "luminance", "illuminance", NULL};
static const char *const purpose_words[] = {"exercise", "lighting", NULL};
static const char *const names_words[] = {"grids", "lights", NULL};
static const char *const precision_words[] = {"single", "double", NULL};
static const char *const csv_words[] = {"rfc4180", "excel-ru", NULL};
static const char *const accept_words[] = {"pixel", NULL};
static const char *const bits_words[] = {"8", "16", NULL};
static const char *const format_words[] = {"png", "npy",  "pfm",      "csv",   "exr",  "svg", "pdf", "md",
                                           "tex", "text", "markdown", "latex", "html", "ies", "ldt", NULL};
static const char *const section_words[] = {"center", "maximum", NULL};
static const char *const loss_words[] = {"gaussian", "huber", "tukey", NULL};
static const char *const view_words[] = {"luminance", "red", "green", "blue", "cct", NULL};
static const char *const spacing_words[] = {"0.25", "1", NULL};
static const char *const diagram_words[] = {"polar", "cartesian", "cone", NULL};
const char *const option_formats[] = {"text", "markdown", "latex", "html", NULL};

static bool take_output(struct options *options, const char *argument)
{
    options->outputs[options->output_count++] = argument;
    return true;
}

static bool take_point(struct options *options, const char *argument)
{
    struct option_place *place = &options->places[options->place_count++];

    return argument_numbers("-p", "X,Y", argument, place->numbers, 2);
}

static bool is_direction(const char *argument, const double direction[3], const char *zero)
{
    if (direction[0] != 0.0 || direction[1] != 0.0 || direction[2] != 0.0)
        return true;
    message_error(zero, argument); /* a format of ours */
    return false;
}

/* A place with a direction; `zero` tells that this must not be 0. */
static bool add_element(struct options *options, const char *option, const char *form, const char *argument,
                        const char *zero)
{
    struct option_place *place = &options->places[options->place_count++];

    place->is_element = true;
    return argument_numbers(option, form, argument, place->numbers, 6) &&
           is_direction(argument, place->numbers + 3, zero);
}

static bool take_element(struct options *options, const char *argument)
{
    return add_element(options, "--at", "X,Y,Z,NX,NY,NZ", argument, _("--at %s: the normal NX,NY,NZ must not be zero"));
}

static bool take_points(struct options *options, const char *argument)
{
    options->places[options->place_count++].file = argument;
    return true;
}

static bool take_view(struct options *options, const char *argument)
{
    return argument_numbers("--view", "X,Y,Z", argument, options->view, 3) &&
           is_direction(argument, options->view, _("--view %s: the direction must not be zero"));
}

static bool take_up(struct options *options, const char *argument)
{
    return argument_numbers("--up", "X,Y,Z", argument, options->up, 3) &&
           is_direction(argument, options->up, _("--up %s: the direction must not be zero"));
}

static bool take_material(struct options *options, const char *argument)
{
    return argument_whole("--material", argument, 0, 999999999, &options->material);
}

static bool take_assignment(struct options *options, const char *argument)
{
    options->assignments[options->assignment_count++] = argument;
    return true;
}

static bool take_free(struct options *options, const char *argument)
{
    options->free_keys[options->free_key_count++] = argument;
    return true;
}

static bool take_purpose(struct options *options, const char *argument)
{
    return argument_word("--for", argument, purpose_words, &options->drawing.purpose);
}

static bool take_quantity(struct options *options, const char *argument)
{
    size_t found;

    if (!argument_word("--quantity", argument, quantity_words, &found))
        return false;
    options->settings.quantity = found % 2 == 0 ? LUXEL_BRIGHTNESS : LUXEL_IRRADIANCE;
    return true;
}

const char *options_quantity_name(luxel_quantity quantity)
{
    return quantity == LUXEL_IRRADIANCE ? "irradiance" : "brightness";
}

static bool take_channel(struct options *options, const char *argument)
{
    return argument_word("--channel", argument, view_words, &options->analysis.view);
}

static bool take_precision(struct options *options, const char *argument)
{
    size_t found;

    if (!argument_word("--precision", argument, precision_words, &found))
        return false;
    options->settings.precision = found == 0 ? LUXEL_SINGLE : LUXEL_DOUBLE;
    return true;
}

static bool take_names(struct options *options, const char *argument)
{
    return argument_word("--names", argument, names_words, &options->names);
}

static bool take_accept(struct options *options, const char *argument)
{
    size_t found;

    options->accepts_pixel = argument_word("--accept", argument, accept_words, &found);
    return options->accepts_pixel;
}

static bool take_bits(struct options *options, const char *argument)
{
    size_t found;

    if (!argument_word("--bits", argument, bits_words, &found))
        return false;
    options->bits = found == 0 ? 8 : 16;
    return true;
}

static bool take_loss(struct options *options, const char *argument)
{
    size_t found;

    if (!argument_word("--loss", argument, loss_words, &found))
        return false;
    options->fit.loss = (luxel_loss)found;
    return true;
}

static bool take_tolerance(struct options *options, const char *argument)
{
    return argument_share("--tolerance", argument, &options->settings.tolerance);
}

static bool take_light_error(struct options *options, const char *argument)
{
    double value;

    if (!argument_number("--light-error", argument, &value))
        return false;
    if (value >= 0.0 && value < 1.0) {
        options->settings.light_error = value;
        return true;
    }
    message_error(_("--light-error %s: expected a number from 0 to below 1"), argument);
    return false;
}

static bool take_reflected_error(struct options *options, const char *argument)
{
    return argument_share("--reflected-error", argument, &options->settings.reflected_error);
}

static bool take_within(struct options *options, const char *argument)
{
    return argument_seconds("--within", argument, &options->settings.within);
}

static bool take_threads(struct options *options, const char *argument)
{
    return argument_whole("--threads", argument, 1, 1024, &options->settings.threads);
}

static bool take_region(struct options *options, const char *argument)
{
    return argument_region("--region", argument, &options->analysis.region);
}

static bool take_bins(struct options *options, const char *argument)
{
    return argument_whole("--bins", argument, 1, 65536, &options->analysis.bins);
}

static bool take_digits(struct options *options, const char *argument)
{
    unsigned digits;

    if (!argument_whole("--digits", argument, 1, 17, &digits))
        return false;
    options->drawing.digits = digits;
    text_set_digits(digits);
    return true;
}

static bool take_samples(struct options *options, const char *argument)
{
    return argument_whole("--samples", argument, 2, 10000000, &options->analysis.samples);
}

static bool take_scale(struct options *options, const char *argument)
{
    double *scale = options->analysis.scale;

    if (!argument_numbers("--scale", "LOW,HIGH", argument, scale, 2))
        return false;
    if (scale[0] < scale[1])
        return true;
    message_error(_("--scale %s: LOW must be below HIGH"), argument);
    return false;
}

static bool take_from(struct options *options, const char *argument)
{
    return argument_numbers("--from", "X,Y", argument, options->analysis.from_mm, 2);
}

static bool take_to(struct options *options, const char *argument)
{
    return argument_numbers("--to", "X,Y", argument, options->analysis.to_mm, 2);
}

static bool take_through(struct options *options, const char *argument)
{
    return argument_numbers("--through", "X,Y", argument, options->analysis.through_mm, 2);
}

static bool take_angle(struct options *options, const char *argument)
{
    return argument_number("--angle", argument, &options->analysis.angle_deg);
}

/* One whole number is how many levels are wanted; anything with a comma or a point is the levels themselves. */
static bool take_levels(struct options *options, const char *argument)
{
    struct option_analysis *analysis = &options->analysis;

    if (!strpbrk(argument, ",.eE"))
        return argument_whole("--levels", argument, 1, 50, &analysis->wanted_levels);
    return argument_levels(argument, analysis->levels, OPTION_LEVELS, &analysis->level_count);
}

static bool take_csv(struct options *options, const char *argument)
{
    size_t found = 0;

    if (argument && !argument_word("--csv", argument, csv_words, &found))
        return false;
    options->csv = found == 0 ? CSV_RFC4180 : CSV_EXCEL_RU;
    return true;
}

/* As a table, whatever its variant. */
static bool take_students(struct options *options, const char *argument)
{
    (void)argument;
    options->by_student = true;
    if (options->csv == CSV_NONE)
        options->csv = CSV_RFC4180;
    return true;
}

bool options_take_document_format(struct options *options)
{
    return argument_word("--format", options->format_word, option_formats, &options->format);
}

static bool take_width(struct options *options, const char *argument)
{
    return argument_number("--width", argument, &options->drawing.width_mm);
}

static bool take_dpi(struct options *options, const char *argument)
{
    return argument_number("--dpi", argument, &options->drawing.dots_per_inch);
}

static bool take_diagram(struct options *options, const char *argument)
{
    return argument_word("--diagram", argument, diagram_words, &options->drawing.diagram);
}

static bool take_eye(struct options *options, const char *argument)
{
    return add_element(options, "--eye", "X,Y,Z,VX,VY,VZ", argument,
                       _("--eye %s: the direction of view VX,VY,VZ must not be zero"));
}

static bool take_section(struct options *options, const char *argument)
{
    options->drawing.section = argument ? argument : "center";
    return true;
}

#define TAKES(function) .take = (function)
#define SETS(name) .member = offsetof(struct options, name)
#define KEEPS(name) .member = offsetof(struct options, name)
#define SHARED .is_shared = true
#define WORDS(list) .value = VALUE_WORD, .words = (list)

/*
 * The commands that write files, those whose results are tables, those that look at a picture or at measuring planes,
 * those that print values, those that compute them, and those that read a scene.
 */
enum {
    PICTURES = COMMAND_RENDER | COMMAND_PROBE | COMMAND_EXPLAIN | COMMAND_STATS | COMMAND_PROFILE | COMMAND_ISOPHOTES |
               COMMAND_COMPARE | COMMAND_FIGURE | COMMAND_REPORT | COMMAND_GRID,
    MEASURING = COMMAND_RENDER | COMMAND_PROBE | COMMAND_GRID | COMMAND_STATS | COMMAND_PROFILE | COMMAND_ISOPHOTES |
                COMMAND_COMPARE,
    COMPUTING = PICTURES | COMMAND_GRADE | COMMAND_GLARE | COMMAND_DERIVE | COMMAND_FIT | COMMAND_EXCHANGE |
                COMMAND_DAYLIGHT | COMMAND_ARRANGE,
    REFINING = PICTURES | COMMAND_GLARE | COMMAND_DAYLIGHT,
    SCENES = PICTURES | COMMAND_CHECK | COMMAND_ADVISE | COMMAND_SCENE | COMMAND_SET | COMMAND_VARIANT | COMMAND_GLARE |
             COMMAND_DERIVE | COMMAND_FIT | COMMAND_EXCHANGE | COMMAND_DAYLIGHT | COMMAND_ARRANGE,
    WRITING = COMMAND_RENDER | COMMAND_DAYLIGHT | COMMAND_PROBE | COMMAND_GRID | COMMAND_SET | COMMAND_PROFILE |
              COMMAND_ISOPHOTES | COMMAND_COMPARE | COMMAND_FIGURE | COMMAND_EXPLAIN | COMMAND_REPORT |
              COMMAND_VARIANT | COMMAND_PHOTOMETRY | COMMAND_ROOM,
    ELEMENTS = COMMAND_PROBE | COMMAND_DERIVE | COMMAND_DAYLIGHT,
    TABLES = COMMAND_STATS | COMMAND_DAYLIGHT | COMMAND_PROFILE | COMMAND_ISOPHOTES | COMMAND_COMPARE | COMMAND_GRADE
};

static const struct option_row rows[] = {
    {"output", 'o', N_("FILE"), WRITING | COMMAND_SWEEP | COMMAND_FIT | COMMAND_ARRANGE, TAKES(take_output),
     .value = VALUE_OUTPUT,
     .help =
         N_("write the result to FILE, in the format given by its extension; may be repeated (luxel sweep: the folder "
            "to fill)")},
    {"bits", 0, N_("N"), COMMAND_RENDER, TAKES(take_bits), WORDS(bits_words),
     .help = N_("bits of the grey levels of a .png: 8 (default) or 16, which show differences that 256 levels hide")},
    {"dry-run", 'n', NULL, COMMAND_SET | COMMAND_SWEEP, SETS(dry_run),
     .help = N_("write no file: print the changed scene, or how many scenes, bytes and seconds a sweep is")},
    {"show", 0, N_("I"), COMMAND_SWEEP, TAKES(sweep_take_show), .help = N_("print scene I of the study, from 0 on")},
    {"shard", 0, N_("I/N"), COMMAND_SWEEP, TAKES(sweep_take_shard),
     .help = N_("compute part I of N, the shards whose number is I modulo N, as one of the N jobs of an array")},
    {"workers", 0, N_("N"), COMMAND_SWEEP, TAKES(sweep_take_workers),
     .help = N_("how many threads compute a shard each; the default is one per processor")},
    {"merge", 0, N_("FILE"), COMMAND_SWEEP, KEEPS(sweep.merge), .value = VALUE_FILE,
     .help =
         N_("compute nothing, and put all shards of the folder into one file: .h5, or .npy of the output that it is "
            "called as")},
    {"point", 'p', N_("X,Y"), COMMAND_PROBE | COMMAND_DERIVE | COMMAND_EXPLAIN, TAKES(take_point),
     .help = N_("take this point of the screen, in mm, instead of the scene's own points; may be repeated")},
    {"at", 0, N_("X,Y,Z,NX,NY,NZ"), ELEMENTS, TAKES(take_element),
     .help = N_("probe a free surface element: its position in mm and its normal; may be repeated")},
    {"outdoor", 0, N_("LX"), COMMAND_DAYLIGHT, TAKES(sun_take_outdoor),
     .help = N_("lx under the open sky for EN 17037, 13900 in Berlin; the default is what the scene's sky gives")},
    {"sun-hours", 0, N_("DATE"), COMMAND_DAYLIGHT, KEEPS(sun.day),
     .help = N_("find the hours of sun on a day instead, such as 2026-03-21 by UTC or 2026-03-21+01:00")},
    {"sun-patches", 0, NULL, COMMAND_DAYLIGHT, SETS(sun.patches),
     .help = N_("find the patches of sun on rectangles, boxes and rooms instead, by the scene's own sun")},
    {"location", 0, N_("LATITUDE,LONGITUDE"), COMMAND_DAYLIGHT, TAKES(sun_take_location),
     .help = N_("of the hours of sun, in degrees to north and east; else that of the scene's sun or sky")},
    {"least-altitude", 0, N_("DEGREES"), COMMAND_DAYLIGHT, TAKES(sun_take_least_altitude),
     .help = N_("of the hours of sun: lower the sun does not count; the default is 0, the horizon")},
    {"free", 0, N_("KEY"), COMMAND_DERIVE | COMMAND_FIT | COMMAND_ARRANGE, TAKES(take_free),
     .help = N_("a key of the scene to derive by, or to find, such as lights[0].position; may be repeated")},
    {"picture", 0, N_("FILE"), COMMAND_FIT, KEEPS(fit.picture), .value = VALUE_FILE,
     .help = N_("fit to a picture of as many pixels as the scene's: .exr, .npy, .pfm, .csv, or the grey levels of a "
                ".png, by the scene's picture.range and rounding")},
    {"values", 0, N_("FILE"), COMMAND_FIT, KEEPS(fit.values), .value = VALUE_FILE,
     .help = N_("fit to readings in a table with the columns x, y, value for points of the screen, or x, y, z, nx, ny, "
                "nz, value for free elements")},
    {"noise", 0, N_("SHARE%|SD"), COMMAND_FIT, TAKES(readings_take_noise),
     .help = N_("the standard deviation of a reading: a share of it, such as 3%, a number in its unit, or 3%+0.01; "
                "without it is told by how the readings scatter")},
    {"saturated", 0, N_("V"), COMMAND_FIT, TAKES(readings_take_saturated),
     .help = N_("readings from V on tell only that the truth is no less")},
    {"relative", 0, NULL, COMMAND_FIT, SETS(fit.is_relative),
     .help = N_("the readings are known only up to one factor, which is found, too; so are those of a .png whose "
                "picture.range is max")},
    {"loss", 0, N_("NAME"), COMMAND_FIT, TAKES(take_loss), WORDS(loss_words),
     .help = N_("what readings that are off count for: gaussian (default), their squares; huber, which bears outliers; "
                "tukey, for which they do not count at all")},
    {"residual", 0, N_("FILE"), COMMAND_FIT, KEEPS(fit.residual), .value = VALUE_OUTPUT,
     .help = N_("write the readings less what the fitted scene gives: a picture, or .csv of values at points")},
    {"eye", 0, N_("X,Y,Z,VX,VY,VZ"), COMMAND_GLARE, TAKES(take_eye),
     .help = N_("an observer: where the eye is, in mm, and the direction in which it looks; may be repeated")},
    {"up", 0, N_("X,Y,Z"), COMMAND_GLARE, TAKES(take_up),
     .help = N_(
         "what is up for the observers; the default is the axis that a room names (up), else the scene's observer.up, "
         "or (0, 0, 1) where it has none")},
    {"limits", 0, NULL, COMMAND_GRID, SETS(judges),
     .help = N_("rate the glare of the scene's observers, too, and end with 1 unless all limits are kept for certain")},
    {"goal", 0, N_("GOAL"), COMMAND_ARRANGE, TAKES(arrange_take_goal),
     .help =
         N_("beside the scene's limits: average>=500, U0>=0.6, minimum>=200, maximum<=2000, ratio>=0.1, ugr<=19; of "
            "several grids NAME:average>=500; may be repeated")},
    {"dimming", 0, NULL, COMMAND_ARRANGE, SETS(arrange.dims), .help = N_("dim all alike, for the least power")},
    {"most", 0, N_("N"), COMMAND_ARRANGE, TAKES(arrange_take_most), .help = N_("luminaires to try, usually to 100")},
    {"file", 0, N_("LAMP"), COMMAND_ROOM, KEEPS(room.file), .value = VALUE_FILE,
     .help = N_("the photometry file of the luminaires, .ies or .ldt")},
    {"array", 0, N_("N,M"), COMMAND_ROOM, TAKES(room_take_array), .help = N_("N columns along x and M rows along y")},
    {"target", 0, N_("E"), COMMAND_ROOM, TAKES(room_take_target), .help = N_("illuminance to reach, lx; usually 500")},
    {"reflectances", 0, N_("C,W,F"), COMMAND_ROOM, TAKES(room_take_reflectances),
     .help = N_("those of ceiling, walls and floor; usually 0.7,0.5,0.2")},
    {"plane", 0, N_("H"), COMMAND_ROOM, TAKES(room_take_plane), .help = N_("height of the plane in m; usually 0.75")},
    {"maintenance", 0, N_("F"), COMMAND_ROOM, TAKES(room_take_maintenance), .help = N_("its factor; usually 0.8")},
    {"points", 0, N_("FILE"), ELEMENTS, TAKES(take_points), .value = VALUE_FILE,
     .help =
         N_("probe the places of a table, CSV or .pts: points x, y of the screen, or free elements x, y, z, nx, ny, "
            "nz; may be repeated")},
    {"view", 0, N_("X,Y,Z"), COMMAND_PROBE | COMMAND_DERIVE, TAKES(take_view),
     .help = N_("the direction from which free elements are seen, of any length; the default is the scene's: (0, 0, 1) "
                "where observer.view is parallel, else towards the observer")},
    {"material", 0, N_("N"), COMMAND_PROBE | COMMAND_DERIVE | COMMAND_FIT, TAKES(take_material),
     .help =
         N_("give free elements that lie on no surface the material of surfaces[N], counted from 0 (the default) as "
            "in paths; an element that lies on a surface keeps the material of that surface")},
    {"from", 0, N_("X,Y"), COMMAND_PROFILE, TAKES(take_from),
     .help = N_("where the line begins on the screen, in mm; goes with --to")},
    {"to", 0, N_("X,Y"), COMMAND_PROFILE, TAKES(take_to), .help = N_("where the line ends on the screen, in mm")},
    {"through", 0, N_("X,Y"), COMMAND_PROFILE, TAKES(take_through),
     .help = N_("a point of the line across the whole screen, in mm; the default is the centre")},
    {"angle", 0, N_("DEGREES"), COMMAND_PROFILE, TAKES(take_angle),
     .help = N_("the angle of that line from the x axis: 0 (the default) is horizontal, 90 vertical")},
    {"arc", 0, NULL, COMMAND_PROFILE, SETS(analysis.arc),
     .help = N_("go along the great circle of the sphere through the two places seen at --from and --to, in degrees")},
    {"digits", 0, N_("N"), MEASURING | COMMAND_REPORT, TAKES(take_digits),
     .help = N_("print values in N significant digits, 1 to 17; JSON, CSV and other files keep all of them")},
    {"samples", 0, N_("N"), COMMAND_PROFILE, TAKES(take_samples),
     .help = N_("how many values, 2 to 10000000; the default is one for each pixel of the longer side, or 181 on an "
                "arc")},
    {"picture", 0, NULL, COMMAND_PROFILE | COMMAND_ISOPHOTES, SETS(analysis.from_picture),
     .help = N_("take the values of the picture's pixels instead of the exact ones between them")},
    {"exact", 0, NULL, COMMAND_ISOPHOTES, SETS(analysis.exact),
     .help = N_("find each vertex on the exact values under area lights, too, which takes ten seconds and more")},
    {"region", 0, N_("X,Y,W,H"), COMMAND_STATS, TAKES(take_region),
     .help = N_("look at a rectangle around X,Y alone, W wide and H high, in mm; X,Y,R is a circle")},
    {"histogram", 0, NULL, COMMAND_STATS, SETS(analysis.histogram), .help = N_("print the histogram too")},
    {"bins", 0, N_("N"), COMMAND_STATS, TAKES(take_bins),
     .help = N_("steps of the histogram, 1 to 65536; the default is 16")},
    {"levels", 0, N_("N"), COMMAND_ISOPHOTES | COMMAND_FIGURE, TAKES(take_levels),
     .help = N_("about N round levels, 1 to 50; or the levels themselves: L1,L2,... (\"5,\" is the one level 5)")},
    {"scale", 0, N_("LOW,HIGH"), COMMAND_STATS | COMMAND_ISOPHOTES | COMMAND_FIGURE, TAKES(take_scale),
     .help = N_("the range of values of the histogram, the levels or the colours")},
    {"log", 0, NULL, COMMAND_STATS | COMMAND_ISOPHOTES | COMMAND_FIGURE, SETS(analysis.logarithmic),
     .help = N_("in steps of the logarithm")},
    {"channel", 0, N_("NAME"), COMMAND_STATS | COMMAND_FIGURE, TAKES(take_channel), WORDS(view_words),
     .help =
         N_("of a picture in colour: its luminance (the default), a channel, red, green or blue, or cct, the colour "
            "temperature in K")},
    {"label", 0, N_("TEXT"), COMMAND_FIGURE, KEEPS(drawing.label),
     .help = N_("the label of the colour bar, instead of the quantity with its unit")},
    {"contour", 0, NULL, COMMAND_FIGURE, SETS(drawing.contours),
     .help = N_("draw labelled isophotes over smooth colours (the default)")},
    {"bands", 0, NULL, COMMAND_FIGURE, SETS(drawing.bands), .help = N_("draw one colour from each level to the next")},
    {"lines", 0, NULL, COMMAND_FIGURE, SETS(drawing.lines), .help = N_("draw the isophotes alone, coloured")},
    {"plain", 0, NULL, COMMAND_FIGURE, SETS(drawing.plain), .help = N_("draw smooth colours without isophotes")},
    {"no-extrema", 0, NULL, COMMAND_FIGURE, SETS(drawing.no_extrema), .help = N_("do not mark the maximum")},
    {"no-points", 0, NULL, COMMAND_FIGURE, SETS(drawing.no_points),
     .help = N_("do not mark the scene's points; of a grid, do not write its values")},
    {"palette", 0, N_("NAME"), COMMAND_FIGURE | COMMAND_REPORT, KEEPS(drawing.palette), .value = VALUE_PALETTE,
     .help = N_("the colours: viridis (default) or another of --palettes")},
    {"palettes", 0, NULL, COMMAND_FIGURE, SETS(drawing.palettes), .help = N_("list the palettes")},
    {"grid", 0, N_("NAME"), COMMAND_FIGURE | COMMAND_ISOPHOTES | COMMAND_DERIVE, KEEPS(drawing.grid),
     .value = VALUE_GRIDS,
     .help = N_("the plane of a measuring grid, by its name or number; figures have its values and lights")},
    {"daylight", 0, NULL, COMMAND_FIGURE, SETS(drawing.daylight),
     .help = N_("of a measuring grid: its daylight factors in percent instead of the irradiance")},
    {"section", 0, N_("PLACE"), COMMAND_FIGURE, TAKES(take_section), .value = VALUE_OPTIONAL, .words = section_words,
     .help = N_("plot the horizontal and the vertical section below, through the center (the default), the maximum or "
                "a point: --section=X,Y")},
    {"stacked", 0, NULL, COMMAND_FIGURE, SETS(drawing.stacked),
     .help = N_("in the sections, put the lights' shares on top of each other")},
    {"diagram", 0, N_("KIND"), COMMAND_PHOTOMETRY, TAKES(take_diagram), WORDS(diagram_words),
     .help =
         N_("what a figure shows: the polar diagram (default), cartesian, the intensity over gamma, or cone, the beam "
            "from 1 to 5 m away; a .pdf is then that diagram and not the luminaire's sheet")},
    {"spacing", 0, N_("RATIO"), COMMAND_PHOTOMETRY, TAKES(room_take_spacing), WORDS(spacing_words),
     .help = N_("of the UGR table: between luminaires, over their height above the eye; 0.25 (default), as in "
                "catalogues, or 1, as in CIE 190, or another part of it")},
    {"room", 0, "X,Y", COMMAND_PHOTOMETRY, TAKES(room_take), .value = VALUE_ROOM,
     .help = N_("rate this room of the UGR table, X by Y heights, with the light that its surfaces really reflect, "
                "too: seconds with --spacing 1, minutes with the default")},
    {"dark", 0, NULL, COMMAND_FIGURE | COMMAND_PHOTOMETRY, SETS(drawing.dark),
     .help = N_("light lines on a dark ground, for projectors")},
    {"width", 0, N_("MM"), COMMAND_FIGURE | COMMAND_PHOTOMETRY, TAKES(take_width),
     .help = N_("the width of the figure on paper, 40 to 1000 mm; the default is 160")},
    {"dpi", 0, N_("N"), COMMAND_FIGURE | COMMAND_PHOTOMETRY, TAKES(take_dpi),
     .help = N_("dots per inch of a .png, 30 to 2400; the default is 200")},
    {"title", 0, N_("TEXT"), COMMAND_FIGURE | COMMAND_REPORT | COMMAND_PHOTOMETRY, KEEPS(drawing.title),
     .help = N_("the title")},
    {"for", 0, N_("PURPOSE"), COMMAND_REPORT, TAKES(take_purpose), WORDS(purpose_words),
     .help = N_("whom the report is for: exercise (the default), or lighting, who are to see that a design is good")},
    {"tables", 0, N_("DIR"), COMMAND_REPORT, KEEPS(drawing.tables), .value = VALUE_FILE,
     .help = N_("with --for lighting: a folder for each table, all values of grids and isolux lines as files")},
    {"author", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.author), .help = N_("who hands the report in")},
    {"group", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.group), .help = N_("the author's group")},
    {"date", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.date),
     .help = N_("the date as it is to stand in the report; the default is none, so that it can be repeated byte for "
                "byte")},
    {"institution", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.institution),
     .help = N_("the university or school, which heads a title page; so do the next four")},
    {"faculty", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.faculty), .help = N_("its faculty or department")},
    {"course", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.course), .help = N_("the course that the report is for")},
    {"teacher", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.teacher), .help = N_("who checks the report")},
    {"place", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.place),
     .help = N_("the town, at the foot of the title page")},
    {"aim", 0, N_("TEXT"), COMMAND_REPORT, KEEPS(drawing.aim),
     .help = N_("the aim of the work, instead of one made from what is computed")},
    {"format", 0, N_("NAME"), WRITING & ~COMMAND_SET, KEEPS(format_word), WORDS(format_words),
     .help = N_("the format of -o -, standard output: an extension without its dot, such as png; luxel explain prints "
                "as text (default), markdown, latex or html")},
    {"csv", 0, N_("VARIANT"), TABLES, TAKES(take_csv), .value = VALUE_OPTIONAL, .words = csv_words,
     .help = N_("print as comma-separated values (RFC 4180), or with --csv=excel-ru as spreadsheets in Russia read "
                "them: semicolons, decimal commas")},
    {"accept", 0, N_("CONVENTION"), COMMAND_GRADE, TAKES(take_accept), WORDS(accept_words),
     .help = N_("take answers by another convention for right, too: pixel, the value of the pixel that the point falls "
                "in, as published answers have it")},
    {"students", 0, NULL, COMMAND_GRADE, TAKES(take_students),
     .help = N_("print one line for each student, as comma-separated values: variants, how many points were asked for "
                "and answered, and how many answers are right, of another convention, wrong and so on")},
    {"list", 0, NULL, COMMAND_SCENE, SETS(list), .help = N_("list the built-in scenes")},
    {"set", 's', N_("KEY=VALUE"), SCENES | COMMAND_GRADE, SHARED, TAKES(take_assignment), .value = VALUE_ASSIGNMENT,
     .help = N_("change one value of the scene, such as lights[0].intensity=20; the value is YAML; may be repeated")},
    {"quantity", 0, N_("NAME"), COMPUTING, SHARED, TAKES(take_quantity), WORDS(quantity_words),
     .help = N_(
         "what to compute: brightness (default) or irradiance; luminance and illuminance are their photometric names")},
    {"tolerance", 0, N_("T"), COMPUTING | COMMAND_ROOM, SHARED, TAKES(take_tolerance),
     .help =
         N_("relative error that the value of a probe or of a grid's cell may have, above 0 and below 1; exit code 5 "
            "where it is not reached")},
    {"precision", 0, N_("NAME"), COMPUTING, SHARED, TAKES(take_precision), WORDS(precision_words),
     .help = N_("numbers of the picture: single (default) or double")},
    {"threads", 0, N_("N"), COMPUTING | COMMAND_ROOM, SHARED, TAKES(take_threads),
     .help = N_("threads to compute with, 1 to 1024; the default is as many as pay, no more than one per processor; "
                "results do not depend on it")},
    {"light-error", 0, N_("E"), COMPUTING, SHARED, TAKES(take_light_error),
     .help = N_("error of a pixel allowed for taking many points together, relative to its value or to a thousandth of "
                "the maximum, from 0 (the default: each point is summed) to below 1")},
    {"reflected-error", 0, N_("R"), COMPUTING | COMMAND_ROOM, SHARED, TAKES(take_reflected_error),
     .help =
         N_("error that reflected light may have, above 0 and below 1: relative to the value of a probe or of a grid's "
            "cell, the default 0.001, or to the maximum of a picture, the default 0.01; exit code 5 where it is not "
            "reached")},
    {"within", 0, N_("SECONDS"), REFINING, SHARED, TAKES(take_within),
     .help = N_("refine reflected light for no longer than that, and take the best bound that is reached by then; exit "
                "code 5 where it is not the one that was asked for")},
    {"keep", 0, NULL, REFINING, SHARED, SETS(keeps),
     .help = N_("let Ctrl-C end the refining of reflected light: the best so far is printed with its bound, exit code "
                "130; pressed again, it ends the tool")},
    {"lights", 0, N_("LIST"), PICTURES | COMMAND_ARRANGE, SHARED, KEEPS(lights), .value = VALUE_LIGHTS,
     .help = N_("the lights that alone give light, whether they are enabled or not: names, or numbers as of lights[0], "
                "with commas between them")},
    {"names", 0, N_("LIST"), COMMAND_CHECK, TAKES(take_names), WORDS(names_words),
     .help = N_("print nothing but the names of the scene's grids or lights, one a line")},
    {"strict", 0, NULL, SCENES, SHARED, SETS(strict), .help = N_("treat advice about the scene as an error")},
    {"json", 0, NULL, COMMAND_ANY, SHARED, SETS(json), .help = N_("print the results as one JSON object")},
    {"quiet", 'q', NULL, COMMAND_ANY, SHARED, SETS(quiet),
     .help = N_(
         "print no progress, notes and confirmations, and with -o no results but those asked for by --json or --csv")},
    {"help", 'h', NULL, COMMAND_ANY | COMMAND_NONE, SHARED, SETS(help),
     .help = N_("print this help and do nothing else")},
    {"version", 'V', NULL, COMMAND_ANY | COMMAND_NONE, SHARED, SETS(version),
     .help = N_("print the version and the instruction set that would be used")},
};

_Static_assert(COUNT_OF(rows) <= OPTIONS_MOST, "each option has a bit of options.given");

const struct option_row *options_row(size_t i)
{
    return i < COUNT_OF(rows) ? &rows[i] : NULL;
}
