/* SPDX-License-Identifier: MIT */
/*
 * Fields in files, through the public interface: a field that is written and read is the same field as far as the file
 * can tell, a picture repeats itself byte for byte, and damaged files end in an error, never in a crash.
 */
#include "files.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <luxel/luxel.h>

static const char SMALL[] = "luxel: 1 # маленькая\n"
                            "screen: {width: 60, height: 40, resolution: [12, 8]}\n"
                            "observer: {z: 1500}\n"
                            "surfaces: [{type: sphere, name: \"Шар, № 1\", center: [3, -2, 1000], radius: 15}]\n"
                            "lights: [{type: point, position: [200, 100, 1500], intensity: 10}]\n";

static luxel_scene *open_scene(const char *text)
{
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text(text, strlen(text), NULL, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_field *render(const luxel_scene *scene, const luxel_settings *settings)
{
    luxel_field *field = NULL;
    assert_int_equal(luxel_render(scene, settings, NULL, &field), LUXEL_OK);
    return field;
}

static luxel_field *render_small(luxel_precision precision, luxel_quantity quantity)
{
    luxel_scene *scene = open_scene(SMALL);
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.precision = precision;
    settings.quantity = quantity;
    luxel_field *field = render(scene, &settings);
    luxel_scene_free(scene); /* the field must not need it */
    return field;
}

static const char *path_of(struct files *files, const char *name)
{
    snprintf(files->path, sizeof files->path, "%s/%s", files->folder, name);
    return files->path;
}

static luxel_field *write_and_read_field(struct files *files, const char *name, const luxel_field *field)
{
    luxel_field *read = NULL;
    assert_int_equal(luxel_field_write(field, path_of(files, name), NULL), LUXEL_OK);
    assert_int_equal(luxel_field_read(files->path, NULL, &read), LUXEL_OK);
    return read;
}

static void assert_same_values(const luxel_field *field, const luxel_field *read)
{
    assert_int_equal(luxel_field_columns(read), luxel_field_columns(field));
    assert_int_equal(luxel_field_rows(read), luxel_field_rows(field));
    for (unsigned row = 0; row < luxel_field_rows(field); row++)
        for (unsigned column = 0; column < luxel_field_columns(field); column++)
            assert_true(luxel_field_value(read, column, row) == luxel_field_value(field, column, row));
    assert_true(luxel_field_statistics(read)->maximum.value == luxel_field_statistics(field)->maximum.value);
    assert_int_equal(luxel_field_statistics(read)->maximum.column, luxel_field_statistics(field)->maximum.column);
}

/* Arrays of numbers tell nothing else. */
static void test_arrays(void **state)
{
    static const char *const names[] = {"a.npy", "a.pfm", "b.npy"};
    for (size_t i = 0; i < 3; i++) {
        luxel_field *field = render_small(i == 2 ? LUXEL_DOUBLE : LUXEL_SINGLE, LUXEL_BRIGHTNESS);
        luxel_field *read = write_and_read_field(*state, names[i], field);
        assert_same_values(field, read);
        assert_int_equal(luxel_field_precision(read), luxel_field_precision(field));
        assert_string_equal(luxel_field_unit(read), "");
        assert_string_equal(luxel_field_quantity_word(read), "values");
        assert_string_equal(luxel_field_instruction_set(read), "");
        assert_null(luxel_field_x_mm(read));
        assert_null(luxel_field_y_mm(read));
        assert_null(luxel_field_scene(read));
        assert_true(isnan(luxel_field_statistics(read)->maximum.x_mm));
        for (unsigned k = 0; k < 12 * 8; k++)
            assert_int_equal(luxel_field_mask(read)[k], luxel_field_value(field, k % 12, k / 12) != 0);
        assert_int_equal(luxel_field_write(read, path_of(*state, "c.csv"), NULL), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_field_write(read, path_of(*state, "c.png"), NULL), LUXEL_OK);
        luxel_field_free(read);
        luxel_field_free(field);
    }
}

/* A value that is no number is the maximum, wherever it stands. */
static void test_no_number(void **state)
{
    static const char header[] = "Pf\n2 2\n-1.0\n";
    for (unsigned i = 0; i < 4; i++) {
        struct files *files = *state;
        char bytes[sizeof header - 1 + 4 * sizeof(float)];
        float values[] = {3, 1, 2, 4}; /* from the bottom row on */
        luxel_field *read = NULL;
        values[i] = NAN;
        memcpy(bytes, header, sizeof header - 1);
        memcpy(bytes + sizeof header - 1, values, sizeof values);
        make_file(files, "a.pfm", bytes, sizeof bytes);
        assert_int_equal(luxel_field_read(files->path, NULL, &read), LUXEL_OK);
        const luxel_extremum *maximum = &luxel_field_statistics(read)->maximum;
        assert_true(maximum->exists && isnan(maximum->value));
        assert_true(maximum->column == i % 2 && maximum->row == 1 - i / 2);
        luxel_field_free(read);
    }
}

static void *ask_for_scene(void *field)
{
    return (void *)luxel_field_scene(field);
}

/* A field tells the scene that it was made of, whatever becomes of that, and the same to each of many threads. */
static void test_scene_as_it_was(void **state)
{
    enum { THREADS = 8 };
    luxel_scene *scene = open_scene(SMALL);
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=12", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);

    luxel_field *field = render(scene, NULL);
    char *expected = NULL;
    pthread_t threads[THREADS];
    void *found[THREADS];
    (void)state;
    assert_int_equal(luxel_scene_write_text(scene, &expected), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=7", NULL), LUXEL_OK);
    luxel_scene_free(scene);
    for (size_t i = 0; i < THREADS; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, ask_for_scene, field), 0);
    for (size_t i = 0; i < THREADS; i++) {
        pthread_join(threads[i], &found[i]);
        assert_ptr_equal(found[i], found[0]);
    }
    assert_string_equal(found[0], expected);
    luxel_text_free(expected);
    luxel_field_free(field);
}

/* An EXR file tells where it came from. */
static void test_exr(void **state)
{
    luxel_field *field = render_small(LUXEL_SINGLE, LUXEL_IRRADIANCE);
    luxel_field *read = write_and_read_field(*state, "a.exr", field);
    uint8_t grey[2][12 * 8];

    assert_same_values(field, read);
    assert_int_equal(luxel_field_quantity(read), LUXEL_IRRADIANCE);
    assert_string_equal(luxel_field_quantity_word(read), "irradiance");
    assert_string_equal(luxel_field_unit(read), luxel_field_unit(field));
    assert_string_equal(luxel_field_scene(read), luxel_field_scene(field));
    assert_memory_equal(luxel_field_x_mm(read), luxel_field_x_mm(field), 12 * sizeof(double));
    assert_memory_equal(luxel_field_y_mm(read), luxel_field_y_mm(field), 8 * sizeof(double));
    luxel_field_grey(field, grey[0]);
    luxel_field_grey(read, grey[1]);
    assert_memory_equal(grey[0], grey[1], sizeof grey[0]);
    luxel_field_free(read);
    luxel_field_free(field);
}

/* A table tells the mask and the places, but not how far the picture goes around the surface. */
static void test_csv(void **state)
{
    for (int precision = LUXEL_SINGLE; precision <= LUXEL_DOUBLE; precision++) {
        luxel_field *field = render_small((luxel_precision)precision, LUXEL_BRIGHTNESS);
        luxel_field *read = write_and_read_field(*state, "a.csv", field);
        const double *x = luxel_field_x_mm(read), *y = luxel_field_y_mm(read);
        unsigned left = 0, top = 0;
        while (luxel_field_x_mm(field)[left] != x[0])
            left++;
        while (luxel_field_y_mm(field)[top] != y[0])
            top++;
        assert_int_equal(luxel_field_precision(read), precision);
        assert_string_equal(luxel_field_unit(read), luxel_field_unit(field));
        for (unsigned row = 0; row < luxel_field_rows(read); row++)
            for (unsigned column = 0; column < luxel_field_columns(read); column++)
                assert_true(luxel_field_value(read, column, row) == luxel_field_value(field, column + left, row + top));
        const luxel_statistics *found = luxel_field_statistics(read), *expected = luxel_field_statistics(field);
        assert_true(found->mean == expected->mean && found->lit == expected->lit);
        assert_true(found->maximum.x_mm == expected->maximum.x_mm && found->minimum.y_mm == expected->minimum.y_mm);
        assert_int_equal(found->surface_pixels, expected->surface_pixels);
        luxel_field_free(read);
        luxel_field_free(field);
    }
}

/* ---- scenes in pictures ---- */

static void assert_same_files(const char *a, const char *b)
{
    size_t lengths[2];
    unsigned char *first = file_bytes(a, &lengths[0]), *second = file_bytes(b, &lengths[1]);
    assert_int_equal(lengths[0], lengths[1]);
    assert_memory_equal(first, second, lengths[0]);
    free(first);
    free(second);
}

static void test_repeats_itself(void **state)
{
    struct files *files = *state;
    char first[96], second[96];

    for (unsigned i = 0; i < 8; i++) {
        luxel_field *field =
            render_small(i & 1 ? LUXEL_DOUBLE : LUXEL_SINGLE, i & 2 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS);
        luxel_settings settings;
        luxel_scene *scene = NULL;
        snprintf(first, sizeof first, "%s/a%s", files->folder, i & 4 ? ".png" : ".exr");
        snprintf(second, sizeof second, "%s/b%s", files->folder, i & 4 ? ".png" : ".exr");
        assert_int_equal(luxel_field_write(field, first, NULL), LUXEL_OK);
        luxel_field_free(field);
        luxel_settings_init(&settings);
        assert_int_equal(luxel_scene_read_file(first, NULL, &scene), LUXEL_OK);
        luxel_scene *copy = luxel_scene_copy(scene);
        assert_true(luxel_scene_settings(copy, &settings));
        assert_int_equal(luxel_scene_commit(copy, NULL), LUXEL_OK);
        field = render(copy, &settings);
        assert_int_equal(luxel_field_write(field, second, NULL), LUXEL_OK);
        assert_same_files(first, second);
        luxel_field_free(field);
        luxel_scene_free(scene);
        luxel_scene_free(copy);
    }
}

/* The finer levels are those of luxel_field_grey16(), in which the coarser ones are the high parts. */
static void test_bits(void **state)
{
    struct files *files = *state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_field *field = render_small(LUXEL_SINGLE, LUXEL_BRIGHTNESS);
    luxel_scene *scene = NULL;
    uint16_t fine[12 * 8];
    uint8_t grey[12 * 8];
    char first[96], second[96];

    luxel_field_grey(field, grey);
    luxel_field_grey16(field, fine);
    for (size_t i = 0; i < 12 * 8; i++)
        assert_int_equal(fine[i] * 255 / 65535, grey[i]);
    assert_true(fine[4 * 12 + 6] % 257 != 0 || fine[4 * 12 + 7] % 257 != 0);
    snprintf(first, sizeof first, "%s/a.png", files->folder);
    snprintf(second, sizeof second, "%s/b.png", files->folder);
    assert_int_equal(luxel_field_write(field, first, NULL), LUXEL_OK);
    assert_int_equal(luxel_field_write_as(field, second, &(luxel_field_output){0}, NULL), LUXEL_OK);
    assert_same_files(first, second);
    assert_int_equal(luxel_field_write_as(field, second, &(luxel_field_output){.bits = 16}, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_read_file(second, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_field_write_as(field, second, &(luxel_field_output){.bits = 4}, diagnostics),
                     LUXEL_ERROR_ARGUMENT);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "setting-out-of-range");
    assert_int_equal(luxel_field_write_as(field, second, &(luxel_field_output){.reserved = {files}}, diagnostics),
                     LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
    luxel_field_free(field);
    luxel_diagnostics_free(diagnostics);
}

static void test_settings_of_texts(void **state)
{
    luxel_settings settings;
    luxel_scene *scene = open_scene(SMALL);
    (void)state;
    luxel_settings_init(&settings);
    settings.tolerance = 0.25;
    assert_false(luxel_scene_settings(scene, &settings));
    assert_false(luxel_scene_settings(NULL, &settings));
    assert_true(settings.tolerance == 0.25);
    luxel_scene_free(scene);
}

/* ---- damage ---- */

static void read_all_ways(struct files *files, const unsigned char *bytes, size_t length)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_field *field = NULL;

    if (luxel_scene_read_text((const char *)bytes, length, "it", diagnostics, &scene) != LUXEL_OK)
        assert_true(luxel_diagnostics_count(diagnostics) >= 1);
    else if (luxel_scene_commit(scene, diagnostics) != LUXEL_OK)
        assert_true(luxel_diagnostics_count(diagnostics) >= 1);
    luxel_diagnostics_clear(diagnostics);
    FILE *file = fopen(files->path, "r+b");
    fwrite(bytes, 1, length, file);
    assert_int_equal(ftruncate(fileno(file), (off_t)length), 0);
    fclose(file);
    if (luxel_field_read(files->path, diagnostics, &field) != LUXEL_OK)
        assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR), 1);
    luxel_field_free(field);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* Every byte with some of its bits turned, every length, and bytes by chance at chance places. */
static void damage(struct files *files, const char *name)
{
    static const unsigned char turns[] = {0x01, 0x80, 0xff};
    unsigned long random = 12345;
    luxel_field *field = render_small(LUXEL_SINGLE, LUXEL_BRIGHTNESS);
    size_t length;

    assert_int_equal(luxel_field_write(field, path_of(files, name), NULL), LUXEL_OK);
    luxel_field_free(field);
    unsigned char *bytes = file_bytes(files->path, &length);
    for (size_t i = 0; i < length && i < 2000; i++) {
        for (size_t k = 0; k < sizeof turns; k++) {
            bytes[i] ^= turns[k];
            read_all_ways(files, bytes, length);
            bytes[i] ^= turns[k];
        }
        read_all_ways(files, bytes, i);
    }
    for (size_t i = 0; i < 1000; i++) {
        unsigned char *copy = malloc(length);
        memcpy(copy, bytes, length);
        for (size_t k = 0; k <= i % 8; k++) {
            random = random * 6364136223846793005UL + 1442695040888963407UL;
            copy[(random >> 33) % length] = (unsigned char)(random >> 20);
        }
        read_all_ways(files, copy, length);
        free(copy);
    }
    free(bytes);
}

static void test_damage(void **state)
{
    static const char *const names[] = {"a.png", "a.exr", "a.npy", "a.pfm", "a.csv"};
    time_t start = time(NULL);

    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        damage(*state, names[i]);
    assert_true(time(NULL) - start < 60);
}

/* Files in memory are those on the disk, byte for byte, and are read as they are. */
static void test_in_memory(void **state)
{
    struct files *files = *state;
    for (size_t i = 0; luxel_field_output_ending(i); i++)
        for (int precision = 0; precision < 2; precision++) {
            char name[32];
            unsigned char *bytes = NULL;
            size_t length = 0;
            const luxel_field_output how = {.bits = precision ? 16 : 8};
            luxel_field *field = render_small(precision ? LUXEL_DOUBLE : LUXEL_SINGLE, LUXEL_BRIGHTNESS);
            luxel_field *read = NULL, *other = NULL;
            snprintf(name, sizeof name, "a%s", luxel_field_output_ending(i));
            if (luxel_field_write_as(field, path_of(files, name), &how, NULL) != LUXEL_OK) { /* .pfm, .exr: float32 */
                assert_int_equal(luxel_field_write_memory(field, name, &how, NULL, &bytes, &length),
                                 LUXEL_ERROR_ARGUMENT);
                assert_null(bytes);
                luxel_field_free(field);
                continue;
            }
            assert_int_equal(luxel_field_write_memory(field, name, &how, NULL, &bytes, &length), LUXEL_OK);
            FILE *file = fopen(files->path, "rb");
            assert_non_null(file);
            for (size_t k = 0; k < length; k++)
                assert_int_equal(getc(file), bytes[k]);
            assert_int_equal(getc(file), EOF);
            fclose(file);
            luxel_status status = luxel_field_read_memory(bytes, length, name, NULL, &read);
            luxel_bytes_free(bytes);
            assert_int_equal(status, luxel_field_read(files->path, NULL, &other));
            assert_int_equal(status, strcmp(luxel_field_output_ending(i), ".png") == 0 ? LUXEL_ERROR_FILE : LUXEL_OK);
            if (read) {
                unsigned columns = luxel_field_columns(read), rows = luxel_field_rows(read);
                assert_int_equal(columns, luxel_field_columns(other));
                assert_int_equal(rows, luxel_field_rows(other));
                for (unsigned pixel = 0; pixel < columns * rows; pixel++)
                    assert_true(luxel_field_value(read, pixel % columns, pixel / columns) ==
                                luxel_field_value(other, pixel % columns, pixel / columns));
            }
            luxel_field_free(other);
            luxel_field_free(read);
            luxel_field_free(field);
        }
}

static void test_wrong_memory(void **state)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_field *field = render_small(LUXEL_SINGLE, LUXEL_BRIGHTNESS), *read = NULL;
    unsigned char *bytes = NULL;
    size_t length = 0;
    (void)state;
    assert_int_equal(luxel_field_write_memory(field, "a.bmp", NULL, diagnostics, &bytes, &length),
                     LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_null(bytes);
    assert_int_equal(luxel_field_write_memory(field, "a.npy", NULL, diagnostics, &bytes, &length), LUXEL_OK);
    for (size_t less = 0; less < length; less += 37) { /* cut off anywhere, it is named and refused */
        assert_int_equal(luxel_field_read_memory(bytes, less, "cut.npy", diagnostics, &read), LUXEL_ERROR_FILE);
        const size_t last = luxel_diagnostics_count(diagnostics) - 1;
        if (last < 20)
            assert_string_equal(luxel_diagnostics_get(diagnostics, last)->source, "cut.npy");
    }
    assert_int_equal(luxel_field_read_memory(NULL, 1, "a", diagnostics, &read), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_field_read_memory(bytes, length, NULL, diagnostics, &read), LUXEL_ERROR_ARGUMENT);
    assert_null(read);
    luxel_bytes_free(bytes);
    luxel_field_free(field);
    luxel_diagnostics_free(diagnostics);
}

/* Values in memory become a field as those of a file do; what cannot be one is refused. */
static void of_values(void **state)
{
    (void)state;
    const float values[] = {1, -0.0F, 3, 4, NAN, 6};
    const uint8_t mask[] = {1, 1, 0, 7, 1, 0};
    const double x_mm[] = {-1, 0, 4}, y_mm[] = {2, -2}, same[] = {0, 0, 1}, wild[] = {0, (double)NAN, 1};
    const luxel_field_content good = {.columns = 3,
                                      .rows = 2,
                                      .values = values,
                                      .mask = mask,
                                      .x_mm = x_mm,
                                      .y_mm = y_mm,
                                      .unit = "lx",
                                      .quantity_known = true,
                                      .quantity = LUXEL_IRRADIANCE};
    const uint8_t shown[] = {1, 1, 0, 1, 1, 0};
    luxel_field *field = NULL;
    assert_int_equal(luxel_field_of_values(&good, NULL, &field), LUXEL_OK);
    const float expected[] = {1, -0.0F, 0, 4, NAN, 0};
    assert_memory_equal(luxel_field_single(field), expected, sizeof expected);
    assert_memory_equal(luxel_field_mask(field), shown, sizeof shown);
    assert_memory_equal(luxel_field_x_mm(field), x_mm, sizeof x_mm);
    assert_memory_equal(luxel_field_y_mm(field), y_mm, sizeof y_mm);
    assert_string_equal(luxel_field_unit(field), "lx");
    assert_string_equal(luxel_field_quantity_word(field), "illuminance");
    assert_int_equal(luxel_field_statistics(field)->surface_pixels, 4);
    luxel_field_free(field);
    const double doubles[] = {0, 5};
    const luxel_field_content bare = {.columns = 1, .rows = 2, .values = doubles, .precision = LUXEL_DOUBLE};
    assert_int_equal(luxel_field_of_values(&bare, NULL, &field), LUXEL_OK);
    assert_memory_equal(luxel_field_double(field), doubles, sizeof doubles);
    assert_int_equal(luxel_field_mask(field)[0] + 2 * luxel_field_mask(field)[1], 2);
    assert_string_equal(luxel_field_quantity_word(field), "values");
    assert_null(luxel_field_x_mm(field));
    luxel_field_free(field);

    luxel_field_content wrong[9];
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        wrong[i] = good;
    wrong[0].columns = 0;
    wrong[1].rows = 65537;
    wrong[2].values = NULL;
    wrong[3].y_mm = NULL;
    wrong[4].x_mm = same;
    wrong[5].x_mm = wild;
    wrong[6].y_mm = x_mm;
    wrong[7].precision = (luxel_precision)2;
    wrong[8].quantity = (luxel_quantity)2;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        field = NULL;
        assert_int_equal(luxel_field_of_values(&wrong[i], diagnostics, &field), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        assert_null(field);
        luxel_diagnostics_free(diagnostics);
    }
    assert_int_equal(luxel_field_of_values(NULL, NULL, &field), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_field_of_values(&good, NULL, NULL), LUXEL_ERROR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FILES_CASE(arrays),
        cmocka_unit_test(test_scene_as_it_was),
        FILES_CASE(exr),
        FILES_CASE(csv),
        FILES_CASE(repeats_itself),
        FILES_CASE(bits),
        FILES_CASE(settings_of_texts),
        FILES_CASE(damage),
        FILES_CASE(no_number),
        FILES_CASE(in_memory),
        FILES_CASE(wrong_memory),
        cmocka_unit_test(of_values),
    };

    return cmocka_run_group_tests_name("field files", tests, NULL, NULL);
}
