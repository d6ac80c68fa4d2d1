/* SPDX-License-Identifier: MIT */
/*
 * What must hold of every scene, tried on random ones of the whole legal range:
 *
 *     properties [--scenes N] [--seed S] [--only NAME] [--extended N]
 *
 * Each scene has a seed of its own, from S on; a failure names it.  One light in N is an extended source, usually one
 * in 64, as they take a hundred times as long.  Interrupted, it tells what it has found so far.
 */
#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "tester.h"

static const struct property properties[] = {
    {"finite", "pictures are finite and not negative, 0 off the surfaces", is_finite, 1},
    {"single", "float32 pictures are within 2e-6 of their maximum", is_true_in_single, 2},
    {"double", "float64 pictures are within 1e-11 of their maximum", is_true_in_double, 1},
    {"panels", "float32 pictures from near, in squares that polynomials do for, are as good", is_true_in_panels, 8},
    {"shares", "the shares of a probe make up its value", has_shares, 2},
    {"pixel-value", "a probe knows what its pixel shows", has_pixel_values, 3},
    {"tolerance", "probes are within their error of those with a finer tolerance", reaches_tolerance, 1},
    {"sum", "pictures of single lights add up", is_sum_of_lights, 3},
    {"scale", "2^20 times the light is 2^20 times as bright, exactly", scales_with_lights, 3},
    {"white", "what a white surface reflects over pi is its irradiance", is_white_by_pi, 3},
    {"mirror-x", "left and right are alike", is_mirrored_in_x, 4},
    {"mirror-y", "up and down are alike", is_mirrored_in_y, 4},
    {"quarter-turn", "a quarter turn changes nothing", is_turned, 4},
    {"order", "the order of the lights does not matter", ignores_order, 3},
    {"light-error", "points taken together are within the error that is allowed for it", keeps_light_error, 1},
    {"grid-element", "a grid's cells are free elements", has_cells_of_elements, 4},
    {"grid-sum", "grids of single lights add up", has_cells_that_add_up, 3},
    {"grid-turn", "a quarter turn changes no grid", has_cells_that_turn, 3},
    {"grid-bound", "grids are within their errors of those with a finer tolerance", has_grid_within_bounds, 2},
    {"cloud", "points from a file light as they do one by one", reads_clouds, 4},
    {"mesh", "a box from a file lights as a box", reads_meshes, 32},
    {"sets", "all instruction sets agree", agrees_by_sets, 3},
    {"stride", "a quick look shows the pixels of the picture", ignores_stride, 4},
    {"threads", "any number of threads gives the same bytes", ignores_threads, 256},
    {"read-back", "a written scene reads back and gives the same bytes", reads_back, 4},
};
enum { PROPERTIES = sizeof properties / sizeof properties[0] };

static volatile sig_atomic_t is_interrupted;

static void interrupt(int signal)
{
    (void)signal;
    is_interrupted = 1;
}

static int explain(void)
{
    fprintf(stderr, "usage: properties [--scenes N] [--seed S] [--only NAME] [--extended N]\n");
    for (size_t i = 0; i < PROPERTIES; i++)
        fprintf(stderr, "  %-14s %s\n", properties[i].name, properties[i].meaning);
    return 2;
}

static bool read_count(const char *text, unsigned long long *count)
{
    char *end;
    errno = 0;
    *count = strtoull(text, &end, 10);
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0;
}

int main(int count, char **arguments)
{
    unsigned long long scenes = 1500, seed = 1, extended = DRAFT_EXTENDED_ONE_IN;
    struct tester_options options = {.stop = &is_interrupted, .progress = isatty(STDERR_FILENO) ? stderr : NULL};
    for (int i = 1; i < count; i += 2) {
        const char *name = arguments[i], *value = i + 1 < count ? arguments[i + 1] : "";
        const bool known = strcmp(name, "--only") == 0       ? (options.only = value) != NULL
                           : strcmp(name, "--scenes") == 0   ? read_count(value, &scenes)
                           : strcmp(name, "--seed") == 0     ? read_count(value, &seed)
                           : strcmp(name, "--extended") == 0 ? read_count(value, &extended) && extended <= UINT_MAX
                                                             : false;
        if (!known)
            return explain();
    }
    options.scenes = scenes;
    options.seed = seed;
    options.extended_one_in = (unsigned)extended;
    signal(SIGINT, interrupt);
    signal(SIGTERM, interrupt);
    return tester_run(properties, PROPERTIES, &options, stdout) > 0;
}
