/* SPDX-License-Identifier: MIT */
/* luxel arrange: how many luminaires, and how far apart, reach the goals of a scene's grids and observers. */
#include <luxel/luxel.h>

#include <math.h>

#include "cli.h"
#include "grid_limits.h"
#include "json.h"
#include "message.h"
#include "outputs.h"
#include "standard_output.h"
#include "text.h"
#include "work.h"

/* What was found, and for what. */
struct arranged {
    const struct options *options;
    const struct loaded *loaded;
    const luxel_arrangement *found;
    const char *unit; /* of the grids */
};

/* The name of a limit's grid or observer; NULL: it has none. */
static const char *name_of(const struct arranged *arranged, const luxel_layout_limit *limit)
{
    const char *name = NULL;

    if (!limit->is_observer)
        return luxel_scene_grid_name(arranged->loaded->scene, limit->index);
    luxel_scene_observer(arranged->loaded->scene, limit->index, &name, NULL);
    return name;
}

/* ---- JSON ---- */

static void print_limits(struct json *json, const struct arranged *arranged, const luxel_layout *layout)
{
    json_open(json, "limits", '[');
    for (size_t i = 0; i < layout->limit_count; i++) {
        const luxel_layout_limit *of = &layout->limits[i];
        const luxel_limit *limit = &of->limit;

        json_open(json, NULL, '{');
        json_text(json, "of", of->is_observer ? "observer" : "grid");
        json_whole(json, "index", of->index);
        json_text(json, "of_name", name_of(arranged, of));
        json_text(json, "name", limit->name);
        json_number(json, "wanted", limit->wanted);
        json_number(json, "value", limit->has_value ? limit->value.value : (double)NAN);
        json_number(json, "error", limit->has_value ? limit->value.error : (double)NAN);
        json_text(json, "verdict", luxel_verdict_word(limit->verdict));
        json_close(json, '}');
    }
    json_close(json, ']');
}

static void print_layouts(struct json *json, const struct arranged *arranged, const char *key,
                          const luxel_layout *layouts, size_t count)
{
    json_open(json, key, '[');
    for (size_t i = 0; i < count; i++) {
        json_open(json, NULL, '{');
        if (layouts[i].numbers) {
            json_open(json, "numbers", '{');
            for (size_t k = 0; k < arranged->found->number_count; k++)
                json_number(json, arranged->found->names[k], layouts[i].numbers[k]);
            json_close(json, '}');
        } else {
            json_whole(json, "luminaires", (size_t)layouts[i].n[0] * layouts[i].n[1]);
            json_wholes(json, "n", layouts[i].n, 2);
            json_numbers(json, "spacing", layouts[i].spacing_mm, 2);
        }
        json_number(json, "dimming", layouts[i].dimming);
        json_number(json, "reserve", layouts[i].reserve);
        print_limits(json, arranged, &layouts[i]);
        json_close(json, '}');
    }
    json_close(json, ']');
}

static void print_json(const struct arranged *arranged)
{
    const luxel_arrangement *found = arranged->found;
    struct json json = {.stream = stdout};

    json_open(&json, NULL, '{');
    if (found->number_count == 0) {
        json_whole(&json, "light", found->light);
        json_text(&json, "light_name", luxel_scene_light_name(arranged->loaded->scene, found->light));
    }
    json_text(&json, "unit", arranged->unit);
    print_layouts(&json, arranged, "layouts", found->found, found->count);
    print_layouts(&json, arranged, "missed", found->missed, found->missed_count);
    json_whole(&json, "fewest", found->fewest);
    json_whole(&json, "tried", found->tried);
    json_whole(&json, "computed", found->computed);
    json_close(&json, '}');
}

/* ---- text ---- */

/* A limit as the head of a column: "average ≥ 500 lx", with its grid where there are several of these. */
static const char *text_head(const struct arranged *arranged, const luxel_layout_limit *limit, bool is_named,
                             char buffer[TEXT_SIZE])
{
    const char *name = is_named ? name_of(arranged, limit) : NULL;
    const bool has_unit = luxel_limit_has_unit(&limit->limit);

    return text_format(buffer, "%.80s%s%.80s %s %.6g%s%.40s", name ? name : "", name ? ": " : "",
                       _(luxel_limit_word(&limit->limit)), limit->limit.is_most ? "≤" : "≥", limit->limit.wanted,
                       has_unit ? " " : "", has_unit ? text_unit(arranged->unit) : "");
}

static const char *text_limit(const luxel_limit *limit, char buffer[TEXT_SIZE])
{
    char value[TEXT_SIZE];

    if (!limit->has_value)
        return limit->verdict == LUXEL_PASS ? "–" : _(luxel_verdict_word(limit->verdict));
    text_value_bound(value, 5, limit->value.value, limit->value.error);
    if (limit->verdict == LUXEL_PASS)
        return text_format(buffer, "%.200s", value);
    if (limit->verdict == LUXEL_UNDECIDED)
        return text_format(buffer, "%.200s (%s)", value, _(luxel_verdict_word(limit->verdict)));
    return text_format(buffer, "%.200s %s %.6g", value, limit->is_most ? ">" : "<", limit->wanted);
}

static bool names_differ(const luxel_layout *layout)
{
    for (size_t i = 1; i < layout->limit_count; i++)
        if (layout->limits[i].is_observer != layout->limits[0].is_observer ||
            layout->limits[i].index != layout->limits[0].index)
            return true;
    return false;
}

/* Spacings; of a single column or row there is none. */
static const char *text_spacings(const luxel_layout *layout, char buffer[TEXT_SIZE])
{
    char columns[TEXT_SIZE], rows[TEXT_SIZE];

    return text_format(buffer, "%.100s × %.100s",
                       layout->n[0] > 1 ? text_format(columns, "%.6g", layout->spacing_mm[0]) : "–",
                       layout->n[1] > 1 ? text_format(rows, "%.6g", layout->spacing_mm[1]) : "–");
}

/* The numbers of keys, layout by layout in columns. */
static void print_numbers(const struct arranged *arranged, const luxel_layout *layouts, size_t count)
{
    const luxel_arrangement *found = arranged->found;
    const size_t columns = count < TEXT_COLUMNS - 2 ? count : TEXT_COLUMNS - 2;
    char alignment[TEXT_COLUMNS + 1] = "l", texts[TEXT_COLUMNS][TEXT_SIZE];
    const char *cells[TEXT_COLUMNS] = {_("key")};
    struct text_table *table;

    for (size_t i = 0; i < columns; i++) {
        alignment[1 + i] = 'r';
        cells[1 + i] = text_format(texts[i], "%zu", i + 1);
    }
    alignment[1 + columns] = 'l';
    cells[1 + columns] = "";
    table = text_table_new(alignment);
    text_table_row(table, cells);
    for (size_t k = 0; k < found->number_count; k++) {
        cells[0] = found->names[k];
        for (size_t i = 0; i < columns; i++)
            cells[1 + i] = text_format(texts[i], "%.8g", layouts[i].numbers[k]);
        cells[1 + columns] = text_unit(found->units[k]);
        text_table_row(table, cells);
    }
    fputc('\n', stdout);
    text_table_print(table, stdout, 4);
}

static void print_table(const struct arranged *arranged, const luxel_layout *layouts, size_t count)
{
    enum { FIXED = 5 };
    const bool tunes = layouts[0].numbers;
    const size_t limits = layouts[0].limit_count < TEXT_COLUMNS - FIXED ? layouts[0].limit_count : TEXT_COLUMNS - FIXED;
    char alignment[TEXT_COLUMNS + 1] = "rrrrr", texts[TEXT_COLUMNS][TEXT_SIZE];
    const char *cells[TEXT_COLUMNS] = {tunes ? "" : _("luminaires"), tunes ? "" : _("columns × rows"),
                                       tunes ? "" : _("spacing, mm"),
                                       arranged->options->arrange.dims ? _("dimmed to") : "", _("reserve")};
    struct text_table *table;

    for (size_t k = 0; k < limits; k++) {
        alignment[FIXED + k] = 'l';
        cells[FIXED + k] = text_head(arranged, &layouts[0].limits[k], names_differ(&layouts[0]), texts[FIXED + k]);
    }
    table = text_table_new(alignment);
    text_table_row(table, cells);
    for (size_t i = 0; i < count; i++) {
        const luxel_layout *layout = &layouts[i];

        cells[0] = text_format(texts[0], "%zu", tunes ? i + 1 : (size_t)layout->n[0] * layout->n[1]);
        cells[1] = tunes ? "" : text_format(texts[1], "%u × %u", layout->n[0], layout->n[1]);
        cells[2] = tunes ? "" : text_spacings(layout, texts[2]);
        cells[3] = arranged->options->arrange.dims ? text_format(texts[3], "%.4g %%", 100 * layout->dimming) : "";
        cells[4] = text_format(texts[4], "%+.1f %%", 100 * (layout->reserve - 1));
        for (size_t k = 0; k < limits; k++)
            cells[FIXED + k] = text_limit(&layout->limits[k].limit, texts[FIXED + k]);
        text_table_row(table, cells);
    }
    text_table_print(table, stdout, 4);
    if (tunes)
        print_numbers(arranged, layouts, count);
}

static void print_text(const struct arranged *arranged)
{
    const luxel_arrangement *found = arranged->found;
    const bool tunes = found->number_count > 0;
    const char *name = tunes ? NULL : luxel_scene_light_name(arranged->loaded->scene, found->light);

    text_print_escaped(stdout, arranged->loaded->name);
    fputs(": ", stdout);
    if (name)
        text_print_escaped(stdout, name);
    else if (!tunes)
        printf("lights[%zu]", found->light);
    if (tunes)
        printf(_("numbers of keys to reach the goals by; %zu starts\n"), found->tried);
    else
        printf(_(", arranged; %zu numbers of columns and rows were tried\n"), found->tried);
    if (found->count > 0) {
        printf("\n%s\n", _("Layouts that reach the goals:"));
        print_table(arranged, found->found, found->count);
    }
    if (found->missed_count > 0) {
        printf("\n%s\n", found->count > 0 ? _("Of fewer luminaires none was found that does. The nearest:")
                         : tunes          ? _("No numbers that reach the goals were found. The nearest:")
                                          : _("No layout reaches the goals. The nearest:"));
        print_table(arranged, found->missed, found->missed_count);
    }
    if (found->fewest > 1)
        printf(_("\nFewer than %u give too little light wherever they stand.\n"), found->fewest);
}

/* ---- the command ---- */

static luxel_status check_name(const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".yaml", ".yml", ".json"};

    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}

static int write_files(const struct arranged *arranged)
{
    const struct options *options = arranged->options;
    int worst = EXIT_DONE;

    if (options->output_count > 0 && arranged->found->count == 0)
        message_note(_("the scene is not written, as no layout reaches the goals"));
    for (size_t i = 0; i < options->output_count && arranged->found->count > 0; i++) {
        const luxel_status status =
            luxel_scene_write_file(luxel_arrangement_scene(arranged->found, &arranged->found->found[0]),
                                   options->outputs[i], arranged->loaded->diagnostics);

        if (status != LUXEL_OK)
            worst = message_failure(status, arranged->loaded->diagnostics);
    }
    return worst;
}

/* What stands in the way of the nearest layout. */
static void tell_unreached(const struct arranged *arranged)
{
    const luxel_arrangement *found = arranged->found;

    if (found->number_count > 0 && found->missed_count > 0)
        message_error(_("no numbers that reach the goals were found: the nearest come to %.1f %% of what is wanted"),
                      100 * found->missed[0].reserve);
    else if (found->tried == 0)
        message_error(_("no layout reaches the goals: it takes %u luminaires at least"), found->fewest);
    else if (found->missed_count == 0)
        message_error(_("no layout reaches the goals"));
    else
        message_error(_("no layout reaches the goals: the nearest, %u × %u, comes to %.1f %% of what is wanted"),
                      found->missed[0].n[0], found->missed[0].n[1], 100 * found->missed[0].reserve);
}

static int arrange(const struct options *options, const struct loaded *loaded)
{
    const luxel_arranging wanted = {.goals = options->arrange.goals,
                                    .goal_count = options->arrange.goal_count,
                                    .dims = options->arrange.dims,
                                    .most = options->arrange.most,
                                    .keys = options->free_keys,
                                    .key_count = options->free_key_count};
    luxel_arrangement *found = NULL;
    struct work work;
    int code = outputs_check(options, check_name);

    if (code != EXIT_DONE)
        return code;
    work_begin(&work, options);
    const luxel_status status = luxel_arrange(loaded->scene, &work.settings, &wanted, loaded->diagnostics, &found);
    code = work_end(&work, status, loaded->diagnostics);
    if (found) {
        const struct arranged arranged = {options, loaded, found, luxel_scene_unit(loaded->scene, LUXEL_IRRADIANCE)};

        if (options->json)
            print_json(&arranged);
        else if (standard_output_is_free(options))
            print_text(&arranged);
        if (found->count == 0)
            tell_unreached(&arranged);
        code = write_files(&arranged);
        if (code == EXIT_DONE && found->count == 0)
            code = EXIT_DIFFERENCE;
    }
    luxel_arrangement_free(found);
    return code;
}

static int run(const struct options *options)
{
    return load_and(options, arrange);
}

const struct command command_arrange = {
    .name = "arrange",
    .bit = COMMAND_ARRANGE,
    .operand = N_("SCENE"),
    .endings = ".yaml .yml .json",
    .summary = N_("find how many luminaires, and how far apart, reach goals"),
    .description = N_(
        "Finds numbers of columns and rows, and spacings, of a light with the key array that reach the scene's limits "
        "and the goals of --goal with the fewest luminaires, and with --dimming the least power. Walls, furniture, "
        "other lights and reflected light count. Several layouts are offered, and of fewer luminaires the nearest "
        "are told with what they miss; -o writes the scene of the first. The exit code is 1 where no layout is found. "
        "The light is the only one with an array, or that of --lights. With --free the numbers of luminaires stay, and "
        "keys are found instead: aims, places, the spacings of several arrays, the strength of each light; with "
        "--dimming the least flux that reaches the goals."),
    .examples = "luxel arrange room.yaml --goal 'average>=500' --goal 'U0>=0.6'\n"
                "luxel arrange room.yaml --goal 'ugr<=19' --dimming -o arranged.yaml\n"
                "luxel arrange -s 'grids[0].limits.average=500' room.yaml --json\n"
                "luxel arrange hall.yaml --goal 'U0>=0.7' --free lights[0].aim --free lights[1].aim\n"
                "luxel arrange hall.yaml --goal 'average>=300' --dimming --free 'dimming[windows].factor'",
    .run = run,
};
