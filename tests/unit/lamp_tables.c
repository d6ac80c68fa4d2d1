/* SPDX-License-Identifier: MIT */
/* Random tables of luminaires, as files. */
#include "lamp_tables.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

void append(char *text, const char *format, ...)
{
    const size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + length, MOST_TEXT - length, format, arguments);
    va_end(arguments);
}

/* Angles from one to another by equal steps, or by steps that are multiples of one, or by any. */
static size_t random_angles(struct randomness *random, double from, double to, double *angles)
{
    static const double STEPS[] = {1, 2.5, 5, 7.5, 15, 22.5, 45};
    const double step = STEPS[pick(random, sizeof STEPS / sizeof *STEPS)];
    const int way = pick(random, 4);
    size_t count = 0;
    for (double angle = from; angle < to - 1e-9; count++) {
        angles[count] = angle;
        angle += way == 0 ? uniform(random, 0.5, 1.5) * step : way == 1 ? step * (1 + pick(random, 3)) : step;
    }
    angles[count] = to;
    return count + 1;
}

void write_table(struct randomness *random, const char *path, char *text)
{
    enum { MOST = 800 };
    static const double LAST_PLANES[] = {0, 90, 180, 360};
    const bool is_sideways = pick(random, 6) == 0, ends_in_light = pick(random, 5) == 0;
    double gammas[MOST], planes[MOST], last_plane = is_sideways ? 90 : LAST_PLANES[pick(random, 4)];
    const double end = is_sideways ? 90 : pick(random, 2) ? 90 : 180;
    const size_t gamma_count = random_angles(random, is_sideways ? -90 : 0, end, gammas);
    const size_t plane_count = last_plane == 0 ? 1 : random_angles(random, is_sideways ? -90 : 0, last_plane, planes);
    const double width = logarithmic(random, 0.05, 1.5), wave = uniform(random, 0, 0.5), turn = pick(random, 4);
    planes[0] = is_sideways ? planes[0] : 0;
    *text = 0;
    append(text, "IESNA:LM-63-2002\n[TEST] 1\n[MANUFAC] 1\nTILT=NONE\n1 -1 1 %zu %zu %d 2 0 0 0\n1 1 50\n", gamma_count,
           plane_count, is_sideways ? 2 : 1);
    for (size_t j = 0; j < gamma_count; j++)
        append(text, "%.9g\n", gammas[j]);
    for (size_t i = 0; i < plane_count; i++)
        append(text, "%.9g\n", planes[i]);
    for (size_t i = 0; i < plane_count; i++)
        for (size_t j = 0; j < gamma_count; j++) {
            const double c = planes[i] * M_PI / 180, gamma = gammas[j] * M_PI / 180;
            const double off = is_sideways ? sqrt(c * c + gamma * gamma) : gamma;
            const double lobe = exp(-off * off / (2 * width * width)) + 0.3 * pow(sin(off), 2);
            const bool is_last = j + 1 == gamma_count && (gammas[j] < 180 || is_sideways);
            const bool is_edge = is_sideways && (i == 0 || i + 1 == plane_count || j == 0);
            const double around = is_sideways ? 1 : 1 + wave * sin(off) * cos(turn * c);
            append(text, "%.5f\n", (is_last || is_edge) && !ends_in_light ? 0 : 1000 * lobe * around);
        }
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_int_equal(fputs(text, file) >= 0, 1);
    assert_int_equal(fclose(file), 0);
}
