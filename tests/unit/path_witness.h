/* SPDX-License-Identifier: MIT */
/*
 * A witness for reflected light, which shares nothing with the library: paths through a room of walls, plates,
 * triangles and balls, with an interval that assumes nothing of what they bring but its greatest possible value.
 */
#ifndef TESTS_UNIT_PATH_WITNESS_H
#define TESTS_UNIT_PATH_WITNESS_H

#include <stddef.h>
#include <stdint.h>

enum { MOST_THINGS = 96, MOST_LAMPS = 3 };

/* A rectangle, both sides of which reflect, or a triangle in it, or a ball (radius above 0). */
struct path_thing {
    double center[3], axis[3], across[3], upward[3], half[2]; /* metres; unit vectors */
    double radius, reflectance;
    int is_triangle;
    double corners[3][2]; /* of a triangle, from the centre, across and upward; counter-clockwise */
};

/* A point (intensity in candelas), or a rectangle that shines to the side of its axis (luminance in cd/m^2). */
struct path_lamp {
    double center[3], axis[3], across[3], upward[3], half[2];
    double intensity, luminance;
};

/* All that stands in a closed room; walls are things. */
struct path_room {
    size_t thing_count, lamp_count;
    struct path_thing things[MOST_THINGS];
    struct path_lamp lamps[MOST_LAMPS];
};

struct path_interval {
    double value, error; /* the truth is farther away in one case of 10^9 */
};

/* Directions that make a right-handed frame with a unit axis, the second as near to `up` as may be. */
void path_frame(const double axis[3], const double up[3], double across[3], double upward[3]);

/* A triangle of corners in metres. */
struct path_thing path_triangle(const double corners[3][3], double reflectance);

/* The reflected irradiance, by all bounces, of an element at a place with a unit normal. */
struct path_interval path_reflected(const struct path_room *room, const double place[3], const double normal[3],
                                    size_t paths, uint64_t seed);

#endif
