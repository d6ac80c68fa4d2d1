/* SPDX-License-Identifier: MIT */
/*
 * Pictures are made of blocks and tiles, which leave out surfaces that do not reach them: a narrow plate, wherever it
 * stands, shows in its own pixels, and only in them.
 */
#include <stdio.h>
#include <string.h>

#include "scenes.h"

enum { COLUMNS = 300, ROWS = 20 };

/* A plate over the samples of some columns and rows of a screen with 1 mm a pixel, beside one that is always there. */
static void expect_pixels(const char *projection, unsigned column, unsigned columns, unsigned row, unsigned rows)
{
    char text[800];
    luxel_scene *scene;
    luxel_field *field;
    /* in perspective the plate lies in the screen, where a pixel is as large as well */
    snprintf(text, sizeof text,
             "luxel: 1\nscreen: {width: %d, height: %d, resolution: [%d, %d], sampling: centers}\n"
             "observer: {z: 1000, projection: %s}\n"
             "surfaces:\n"
             "  - {type: rectangle, center: [%.17g, %.17g, 0], size: [%.17g, %.17g], material: {model: lambert}}\n"
             "  - {type: sphere, center: [0, 0, -5000], radius: 0.001, material: {model: lambert}}\n"
             "lights: [{type: distant, direction: [0, 0, -1], irradiance: 3}]\n",
             COLUMNS, ROWS, COLUMNS, ROWS, projection, column + columns / 2.0 - COLUMNS / 2.0,
             ROWS / 2.0 - row - rows / 2.0, columns - 0.8, rows - 0.8);
    if (load(text, NULL, &scene) != LUXEL_OK)
        fail_msg("not a good scene: %s", text);
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    for (unsigned y = 0; y < ROWS; y++)
        for (unsigned x = 0; x < COLUMNS; x++) {
            bool inside = x >= column && x < column + columns && y >= row && y < row + rows;
            if (luxel_field_mask(field)[(size_t)y * COLUMNS + x] != inside)
                fail_msg("%s: columns %u to %u, rows %u to %u: pixel (%u, %u)", projection, column, column + columns,
                         row, row + rows, x, y);
            assert_true((luxel_field_value(field, x, y) > 0) == inside);
        }
    luxel_field_free(field);
    luxel_scene_free(scene);
}

static void narrow_plates(void **state)
{
    static const char *const projections[] = {"orthographic", "perspective"};
    (void)state;
    for (int p = 0; p < 2; p++) {
        for (unsigned column = 0; column < COLUMNS; column++)
            expect_pixels(projections[p], column, 1, column % ROWS, 1);
        for (unsigned row = 0; row < ROWS; row++)
            expect_pixels(projections[p], 100, 60, row, 1);
        for (unsigned column = 1; column < COLUMNS; column += 17) {
            expect_pixels(projections[p], 0, column, 3, 9); /* from the edge to anywhere, and from anywhere to it */
            expect_pixels(projections[p], column, COLUMNS - column, 5, ROWS - 5);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(narrow_plates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
