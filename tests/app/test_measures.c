/* SPDX-License-Identifier: MIT */
/* The numbers beside the picture are those that the library gives for the same places. */
#include <math.h>
#include <string.h>

#include "../../app/picture/color.h"
#include "../../app/picture/measures.h"
#include "scenes.h"

/* What a meter and a pointer told last; answers come in parts, and each part is kept. */
typedef struct Desk {
    AppMeter *meter;
    AppPointer *pointer;
    AppMeasures sources, points, section, statistics, isophotes, balance; /* of which the members are stolen */
    int answers, readings, empty_sections;
    AppReading reading;
    double shares[16];
} Desk;

static void tell_measures(AppMeasures *measures, gpointer owner)
{
    Desk *desk = owner;
    desk->answers++;
    assert_int_equal(measures->has_sources + measures->has_points + measures->has_section + measures->has_statistics +
                         measures->has_isophotes + measures->has_balance,
                     1);
    AppMeasures *place = measures->has_sources      ? &desk->sources
                         : measures->has_points     ? &desk->points
                         : measures->has_section    ? &desk->section
                         : measures->has_statistics ? &desk->statistics
                         : measures->has_balance    ? &desk->balance
                                                    : &desk->isophotes;
    desk->empty_sections += measures->has_section && !(measures->curves[0] && measures->curves[1]);
    AppMeasures taken = *measures;
    *measures = *place; /* freed in its stead */
    *place = taken;
}

static void tell_reading(const AppReading *reading, gpointer owner)
{
    Desk *desk = owner;
    desk->readings++;
    desk->reading = *reading;
    assert_true(reading->share_count <= G_N_ELEMENTS(desk->shares));
    memcpy(desk->shares, reading->shares, reading->share_count * sizeof *desk->shares);
}

static Desk *open_desk(void)
{
    Desk *desk = g_new0(Desk, 1);
    desk->meter = app_meter_new(tell_measures, desk);
    desk->pointer = app_pointer_new(tell_reading, desk);
    return desk;
}

static void clear_measures(AppMeasures *measures)
{
    app_shot_unref(measures->shot);
    g_free(measures->points);
    g_free(measures->sources);
    app_curve_free(measures->curves[0]);
    app_curve_free(measures->curves[1]);
    luxel_histogram_free(measures->histogram);
    luxel_isophotes_free(measures->isophotes);
}

static void close_desk(Desk *desk)
{
    app_meter_free(desk->meter);
    app_pointer_free(desk->pointer);
    clear_measures(&desk->points);
    clear_measures(&desk->section);
    clear_measures(&desk->statistics);
    clear_measures(&desk->isophotes);
    g_free(desk);
}

/* A whole picture of a built-in scene, small enough. */
static AppShot *small_shot(const char *scene, luxel_quantity quantity)
{
    AppDocument *document = document_of_builtin(scene);
    set(document, "screen.resolution", "[100, 80]");
    set(document, "screen.width", "900");
    set(document, "screen.height", "720");
    AppShot *shot = shot_of(document, quantity);
    g_object_unref(document);
    return shot;
}

static gboolean has_statistics(gpointer desk)
{
    return ((Desk *)desk)->statistics.has_statistics;
}

static gboolean has_balance(gpointer desk)
{
    return ((Desk *)desk)->balance.has_balance;
}

static gboolean has_isophotes(gpointer desk)
{
    return ((Desk *)desk)->isophotes.has_isophotes;
}

static gboolean has_section(gpointer desk)
{
    return ((Desk *)desk)->section.has_section;
}

static gboolean has_points(gpointer desk)
{
    return ((Desk *)desk)->points.has_points;
}

static gboolean has_reading(gpointer desk)
{
    return ((Desk *)desk)->readings > 0;
}

static luxel_settings settings_of(const AppShot *shot)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = luxel_field_quantity(shot->field);
    return settings;
}

/* ---- cases ---- */

static void expect_points(const AppMeasures *measures, const AppShot *shot)
{
    const luxel_scene *scene = shot->moment->scene;
    const luxel_settings settings = settings_of(shot);
    guint8 *grey = g_malloc(100 * 80);
    luxel_field_grey(shot->field, grey);
    assert_ptr_equal(measures->shot, shot);
    assert_int_equal(measures->point_count, luxel_scene_point_count(scene));
    assert_int_equal(measures->points_left, 0);
    for (gsize i = 0; i < measures->point_count; i++) {
        const AppPoint *point = &measures->points[i];
        double x, y;
        luxel_probe *probe;
        luxel_scene_point(scene, i, &x, &y);
        assert_int_equal(luxel_probe_screen(scene, &settings, x, y, NULL, &probe), LUXEL_OK);
        assert_true(point->x_mm == x && point->y_mm == y);
        assert_int_equal(point->on_surface, probe->on_surface);
        assert_int_equal(point->has_value, probe->has_value);
        assert_true(point->value == probe->value && point->error == probe->error);
        assert_int_equal(point->has_pixel, probe->has_pixel && probe->has_pixel_value);
        if (point->has_pixel) {
            assert_true(point->pixel_value == probe->pixel_value);
            assert_int_equal(point->column, probe->column);
            assert_int_equal(point->row, probe->row);
            assert_int_equal(point->has_grey, luxel_field_channels(shot->field) == 1);
            assert_int_equal(point->grey, point->has_grey ? grey[point->row * 100 + point->column] : 0);
        }
        assert_memory_equal(&point->color, &probe->color, sizeof point->color);
        luxel_probe_free(probe);
    }
    g_free(grey);
}

static void reads_points(void **state)
{
    (void)state;
    for (gsize i = 0; i < luxel_builtin_scene_count(); i++) {
        AppShot *shot = small_shot(luxel_builtin_scene_name(i), i % 2 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS);
        Desk *desk = open_desk();
        app_meter_ask(desk->meter, &(AppQuestion){.shot = shot});
        wait_until(has_points, desk);
        expect_points(&desk->points, shot);
        close_desk(desk);
        app_shot_unref(shot);
    }
}

/* Each source by itself at the first surface's centre. */
static void reads_sources(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("all-sources");
    set(document, "screen.resolution", "[40, 40]");
    set(document, "lights[2].enabled", "false");
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    Desk *desk = open_desk();
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot});
    wait_until(has_points, desk);
    assert_int_equal(desk->sources.source_count, 9);
    luxel_settings settings = settings_of(shot);
    luxel_probe *probe;
    settings.quantity = LUXEL_IRRADIANCE;
    assert_int_equal(luxel_probe_screen(shot->moment->scene, &settings, 0, 0, NULL, &probe), LUXEL_OK);
    gsize share = 0;
    for (gsize i = 0; i < 9; i++) {
        const AppSource *source = &desk->sources.sources[i];
        double flux;
        assert_int_equal(luxel_scene_light_flux(shot->moment->scene, i, &flux), LUXEL_OK);
        assert_true(isnan(flux) ? isnan(source->flux) : source->flux == flux);
        if (i == 2) {
            assert_true(isnan(source->irradiance)); /* it is off */
            continue;
        }
        assert_int_equal(probe->shares[share].light, i);
        const double irradiance = probe->shares[share++].irradiance;
        assert_true(fabs(source->irradiance - irradiance) <= 1e-5 * irradiance);
    }
    luxel_probe_free(probe);
    close_desk(desk);
    app_shot_unref(shot);
    g_object_unref(document);
}

static void lists_the_first_points_only(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    GString *points = g_string_new("[");
    for (int i = 0; i < APP_MOST_POINTS + 30; i++)
        g_string_append_printf(points, "%s[%d, 0]", i ? ", " : "", i);
    g_string_append_c(points, ']');
    set(document, "points", points->str);
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    Desk *desk = open_desk();
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot});
    wait_until(has_points, desk);
    assert_int_equal(desk->points.point_count, APP_MOST_POINTS);
    assert_int_equal(desk->points.points_left, 30);
    assert_true(desk->points.points[APP_MOST_POINTS - 1].x_mm == APP_MOST_POINTS - 1);
    close_desk(desk);
    app_shot_unref(shot);
    g_string_free(points, TRUE);
    g_object_unref(document);
}

static void expect_profile(const luxel_profile *found, const luxel_evaluator *evaluator, const AppShot *shot,
                           double degrees)
{
    static const double through[2] = {12, -34};
    luxel_profile_path path = {.type = LUXEL_PATH_LINE, .samples = found->count};
    luxel_profile *profile;
    assert_int_equal(luxel_profile_line(shot->moment->scene, through, degrees, NULL, path.from_mm, path.to_mm),
                     LUXEL_OK);
    assert_int_equal(luxel_find_profile(evaluator, &path, NULL, &profile), LUXEL_OK);
    assert_true(found->count > 100);
    assert_int_equal(found->lights, profile->lights);
    for (gsize i = 0; i < found->count; i++) {
        const luxel_profile_sample *one = &found->samples[i], *other = &profile->samples[i];
        assert_true(one->abscissa == other->abscissa && one->x_mm == other->x_mm && one->y_mm == other->y_mm);
        assert_true(one->has_value == other->has_value && one->value == other->value && one->error == other->error);
    }
    assert_memory_equal(found->shares, profile->shares, found->count * found->lights * sizeof *found->shares);
    luxel_profile_free(profile);
}

static void reads_sections(void **state)
{
    (void)state;
    AppShot *shot = small_shot("three-lights", LUXEL_BRIGHTNESS);
    const luxel_settings settings = settings_of(shot);
    luxel_evaluator *evaluator;
    Desk *desk = open_desk();
    assert_int_equal(luxel_evaluator_new(shot->moment->scene, &settings, NULL, &evaluator), LUXEL_OK);
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot, .section = TRUE, .section_mm = {12, -34}});
    wait_until(has_section, desk);
    assert_true(desk->section.section_mm[0] == 12 && desk->section.section_mm[1] == -34);
    expect_profile(&desk->section.curves[0]->profile, evaluator, shot, 0);
    expect_profile(&desk->section.curves[1]->profile, evaluator, shot, 90);
    clear_measures(&desk->section);
    desk->section = (AppMeasures){0};
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot, .section = TRUE, .section_mm = {12, 5000}});
    wait_until(has_section, desk);
    assert_null(desk->section.curves[0]); /* off the screen */
    assert_non_null(desk->section.curves[1]);
    close_desk(desk);
    luxel_evaluator_free(evaluator);
    app_shot_unref(shot);
}

static void reads_statistics(void **state)
{
    (void)state;
    AppShot *shot = small_shot("spot", LUXEL_BRIGHTNESS);
    const luxel_settings settings = settings_of(shot);
    luxel_evaluator *evaluator;
    luxel_summary summary;
    luxel_extrema extrema;
    Desk *desk = open_desk();
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot, .statistics = TRUE});
    wait_until(has_statistics, desk);
    assert_int_equal(luxel_field_summary(shot->field, NULL, NULL, &summary), LUXEL_OK);
    const luxel_summary *found = &desk->statistics.summary;
    assert_int_equal(found->pixels, summary.pixels);
    assert_true(found->mean == summary.mean && found->median == summary.median);
    assert_true(found->maximum.value == summary.maximum.value && found->minimum.value == summary.minimum.value);
    assert_true(found->standard_deviation == summary.standard_deviation && found->u0 == summary.u0);
    assert_true(desk->statistics.has_extrema);
    assert_int_equal(luxel_evaluator_new(shot->moment->scene, &settings, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_extrema(evaluator, shot->field, NULL, NULL, &extrema), LUXEL_OK);
    assert_true(desk->statistics.extrema.maximum.value == extrema.maximum.value);
    assert_true(desk->statistics.extrema.minimum.value == extrema.minimum.value);
    const luxel_histogram *histogram = desk->statistics.histogram;
    assert_non_null(histogram);
    assert_int_equal(histogram->scale, LUXEL_HISTOGRAM_LINEAR);
    assert_int_equal(histogram->pixels, summary.pixels);
    gsize sum = histogram->below + histogram->above;
    for (gsize i = 0; i < histogram->bins; i++)
        sum += histogram->counts[i];
    assert_int_equal(sum, summary.pixels);
    luxel_evaluator_free(evaluator);
    close_desk(desk);
    app_shot_unref(shot);
}

static void reads_isophotes(void **state)
{
    (void)state;
    AppShot *shot = small_shot("distant", LUXEL_BRIGHTNESS);
    const double high = luxel_field_statistics(shot->field)->maximum.value;
    Desk *desk = open_desk();
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot, .isophotes = TRUE, .low = 0, .high = high});
    wait_until(has_isophotes, desk);
    double levels[64];
    luxel_isophotes *lines;
    const gsize count = luxel_round_levels(0, high, false, 8, levels, 64);
    assert_int_equal(luxel_find_isophotes(shot->field, NULL, levels, count, NULL, &lines), LUXEL_OK);
    assert_int_equal(desk->isophotes.isophotes->count, lines->count);
    assert_true(lines->count > 2);
    luxel_isophotes_free(lines);
    close_desk(desk);
    app_shot_unref(shot);
}

/* A quick look: what is exact at once, and no grey levels, which the whole picture will have. */
static void answers_for_quick_looks(void **state)
{
    (void)state;
    AppShot *shot = small_shot("report", LUXEL_BRIGHTNESS);
    shot->is_fine = FALSE;
    Desk *desk = open_desk();
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot, .section = TRUE, .statistics = TRUE, .isophotes = TRUE});
    app_pointer_ask(desk->pointer, shot, NULL, 0, 0);
    wait_until(has_section, desk);
    wait_until(has_reading, desk);
    run_for(300);
    assert_int_equal(desk->answers, 3);
    assert_true(desk->sources.has_sources && desk->points.has_points);
    assert_int_equal(desk->points.points[0].grey, 0);
    assert_false(desk->reading.has_pixel);
    assert_true(desk->reading.value.has_value);
    close_desk(desk);
    app_shot_unref(shot);
}

/* The newest question is answered in full, whatever was asked before. */
static void answers_the_newest_question(void **state)
{
    (void)state;
    enum { QUESTIONS = 60 };
    AppShot *shots[2] = {small_shot("report", LUXEL_BRIGHTNESS), small_shot("all-sources", LUXEL_BRIGHTNESS)};
    Desk *desk = open_desk();
    for (int i = 0; i <= QUESTIONS; i++) {
        app_meter_ask(
            desk->meter,
            &(AppQuestion){.shot = shots[i % 2], .section = TRUE, .section_mm = {i, 0}, .statistics = i == QUESTIONS});
        app_pointer_ask(desk->pointer, shots[i % 2], NULL, i, 0);
        run_for((guint)(i % 4));
    }
    wait_until(has_statistics, desk);
    assert_ptr_equal(desk->points.shot, shots[0]);
    assert_true(desk->section.section_mm[0] == QUESTIONS);
    assert_non_null(desk->section.curves[0]);
    while (desk->reading.x_mm != QUESTIONS)
        run_for(1);
    assert_int_equal(desk->empty_sections, 0); /* what was given up is not told: it would make curves flicker */
    close_desk(desk);
    app_shot_unref(shots[0]);
    app_shot_unref(shots[1]);
}

/* The balance of surfaces that reflect light follows the statistics, with the library's numbers. */
static void finds_the_balance(void **state)
{
    (void)state;
    luxel_balance *balance;
    AppDocument *document = document_of_builtin("report");
    set(document, "surfaces",
        "[{type: rectangle, center: [0, 0, 0], size: [900, 900],"
        "  material: {model: lambert, diffuse: 0.7, over_pi: true}},"
        " {type: sphere, center: [0, 0, 400], radius: 150, material: {model: lambert, diffuse: 0.5, over_pi: true}}]");
    set(document, "lights", "[{type: point, position: [-300, 0, 900], power: 20, attenuation: inverse-square}]");
    set(document, "screen.resolution", "[40, 40]");
    set(document, "reflections", "1");
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    Desk *desk = open_desk();
    app_meter_ask(desk->meter, &(AppQuestion){.shot = shot, .statistics = TRUE});
    wait_until(has_balance, desk);
    assert_true(desk->statistics.has_statistics);
    assert_int_equal(luxel_find_balance(shot->moment->scene, NULL, NULL, &balance), LUXEL_OK);
    const luxel_balance *found = desk->balance.balance;
    assert_non_null(found);
    assert_true(found->closes && found->side_count == balance->side_count);
    assert_true(found->absorbed.value == balance->absorbed.value && found->absorbed.error == balance->absorbed.error);
    assert_true(found->sides[0].irradiance.value == balance->sides[0].irradiance.value);
    luxel_balance_free(balance);
    close_desk(desk);
    app_shot_unref(shot);
    g_object_unref(document);
}

static void reads_what_is_under_the_pointer(void **state)
{
    (void)state;
    static const double places[][2] = {{0, 0}, {150.3, -70.1}, {-449.9, 359.9}, {450.1, 0}, {-120, 120}, {1e6, 0}};
    AppShot *shot = small_shot("three-lights", LUXEL_BRIGHTNESS);
    const luxel_settings settings = settings_of(shot);
    luxel_evaluator *evaluator;
    double shares[3];
    guint8 *grey = g_malloc(100 * 80);
    luxel_field_grey(shot->field, grey);
    Desk *desk = open_desk();
    assert_int_equal(luxel_evaluator_new(shot->moment->scene, &settings, NULL, &evaluator), LUXEL_OK);
    for (gsize i = 0; i < G_N_ELEMENTS(places); i++) {
        const double x = places[i][0], y = places[i][1];
        const AppReading *reading = &desk->reading;
        guint column, row;
        desk->readings = 0;
        app_pointer_ask(desk->pointer, shot, NULL, x, y);
        wait_until(has_reading, desk);
        luxel_value value;
        luxel_evaluate_screen(evaluator, x, y, &value, shares);
        assert_true(reading->x_mm == x && reading->y_mm == y);
        assert_int_equal(reading->value.on_surface, value.on_surface);
        assert_int_equal(reading->value.has_value, value.has_value);
        assert_true(reading->value.value == value.value && reading->value.error == value.error);
        assert_int_equal(reading->share_count, 3);
        assert_memory_equal(desk->shares, shares, sizeof shares);
        assert_int_equal(reading->has_pixel, app_pixel_at(shot->field, x, y, &column, &row));
        assert_int_equal(reading->has_pixel, fabs(x) <= 450 && fabs(y) <= 360);
        if (reading->has_pixel) {
            assert_int_equal(reading->column, MIN((guint)floor((x + 450) / 9), 99));
            assert_int_equal(reading->row, MIN((guint)floor((360 - y) / 9), 79));
            assert_int_equal(reading->grey, grey[reading->row * 100 + reading->column]);
        }
    }
    g_free(grey);
    luxel_evaluator_free(evaluator);
    close_desk(desk);
    app_shot_unref(shot);
}

/* In colour the channels are those of luxel probe, and the mean that of the picture's pixels, whichever is shown. */
static void reads_colors(void **state)
{
    (void)state;
    AppShot *shot = small_shot("warm-and-cold", LUXEL_BRIGHTNESS), *red = app_shot_view(shot, APP_CHANNEL_RED);
    const luxel_settings settings = settings_of(shot);
    const float *rgb = luxel_field_rgb_single(shot->field);
    luxel_chromaticity seen;
    luxel_probe *probe;
    assert_ptr_equal(red->whole, shot);
    assert_ptr_equal(app_shot_light(red), shot->field);
    assert_true(luxel_field_single(red->field)[1234] == rgb[3 * 1234]);
    Desk *desk = open_desk();
    app_pointer_ask(desk->pointer, red, NULL, -120, 10);
    wait_until(has_reading, desk);
    assert_int_equal(luxel_probe_screen(shot->moment->scene, &settings, -120, 10, NULL, &probe), LUXEL_OK);
    assert_true(probe->color.exists && desk->reading.value.value == probe->value);
    assert_memory_equal(&desk->reading.color, &probe->color, sizeof probe->color);
    assert_false(desk->reading.has_grey);
    luxel_find_chromaticity(probe->color.rgb, &seen);
    assert_true(app_color_number(&probe->color, probe->value, APP_CHANNEL_COLORS) == probe->value);
    assert_true(app_color_number(&probe->color, probe->value, APP_CHANNEL_BLUE) == probe->color.rgb[2]);
    assert_true(app_color_number(&probe->color, probe->value, APP_CHANNEL_CCT) == seen.cct_k);
    luxel_probe_free(probe);
    const luxel_color mean = app_color_mean(shot->field);
    double sum = 0;
    for (gsize i = 0; i < 100 * 80; i++)
        sum += (double)rgb[3 * i + 2];
    assert_true(mean.exists && fabs(mean.rgb[2] - sum / (100 * 80)) <= 1e-9 * sum);
    assert_false(app_color_mean(red->field).exists);
    close_desk(desk);
    app_shot_unref(red);
    app_shot_unref(shot);
}

static void finds_pixels(void **state)
{
    (void)state;
    static const char *const samplings[] = {"centers", "nodes"};
    for (gsize s = 0; s < 2; s++) {
        AppDocument *document = document_of_builtin("report");
        guint column, row;
        set(document, "screen.resolution", "[40, 40]");
        set(document, "screen.sampling", samplings[s]);
        AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
        const double *x = luxel_field_x_mm(shot->field), *y = luxel_field_y_mm(shot->field);
        for (guint i = 0; i < 40; i++) {
            assert_true(app_pixel_at(shot->field, x[i] + 1, y[39 - i] - 1, &column, &row));
            assert_int_equal(column, i);
            assert_int_equal(row, 39 - i);
        }
        assert_false(app_pixel_at(shot->field, 300, 0, &column, &row));
        assert_false(app_pixel_at(shot->field, 0, -300, &column, &row));
        app_shot_unref(shot);
        g_object_unref(document);
    }
}

static void stops_while_measuring(void **state)
{
    (void)state;
    AppShot *shot = small_shot("all-sources", LUXEL_BRIGHTNESS);
    for (guint i = 0; i < 6; i++) {
        Desk *desk = open_desk();
        app_meter_ask(desk->meter,
                      &(AppQuestion){.shot = shot, .section = TRUE, .statistics = TRUE, .isophotes = TRUE, .high = 1});
        app_pointer_ask(desk->pointer, shot, NULL, 10, 10);
        run_for(10 * i * i);
        close_desk(desk);
        run_for(5);
    }
    app_shot_unref(shot);
    app_meter_free(NULL);
    app_pointer_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_points),
        cmocka_unit_test(reads_sources),
        cmocka_unit_test(lists_the_first_points_only),
        cmocka_unit_test(reads_sections),
        cmocka_unit_test(reads_statistics),
        cmocka_unit_test(reads_isophotes),
        cmocka_unit_test(answers_for_quick_looks),
        cmocka_unit_test(answers_the_newest_question),
        cmocka_unit_test(finds_the_balance),
        cmocka_unit_test(reads_what_is_under_the_pointer),
        cmocka_unit_test(reads_colors),
        cmocka_unit_test(finds_pixels),
        cmocka_unit_test(stops_while_measuring),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
