/* SPDX-License-Identifier: MIT */
/*
 * Polygons into triangles, by ear clipping (Meisters 1975) in the plane that looks along the polygon's normal (Newell's
 * sum), dropping the axis along which that is longest.  Of a polygon that crosses itself, where there may be no ear,
 * the corner that turns most is cut off all the same: the number of triangles is always two less than that of corners.
 */
#include <math.h>

#include "solid.h"

/* A polygon in its plane, of which some corners are left. */
struct flat {
    const double (*corners)[3];
    const unsigned *loop;
    int axes[2];
    double sign;
    unsigned *left; /* places in the loop */
    unsigned count;
};

static double coordinate(const struct flat *flat, unsigned place, int axis)
{
    return flat->corners[flat->loop[place]][flat->axes[axis]];
}

/* Twice the area of a triangle of places, above 0 where it runs as the polygon does. */
static double turn_of(const struct flat *flat, unsigned a, unsigned b, unsigned c)
{
    const double x = coordinate(flat, a, 0), y = coordinate(flat, a, 1);
    return flat->sign * ((coordinate(flat, b, 0) - x) * (coordinate(flat, c, 1) - y) -
                         (coordinate(flat, b, 1) - y) * (coordinate(flat, c, 0) - x));
}

static void lay(const double (*corners)[3], const unsigned *loop, unsigned count, struct flat *flat)
{
    double normal[3] = {0, 0, 0};
    int main = 0;
    for (unsigned i = 0; i < count; i++) {
        const double *a = corners[loop[i]], *b = corners[loop[(i + 1) % count]], *origin = corners[loop[0]];
        for (int k = 0; k < 3; k++) {
            const int y = (k + 1) % 3, z = (k + 2) % 3;
            normal[k] += (a[y] - origin[y]) * (b[z] - origin[z]) - (a[z] - origin[z]) * (b[y] - origin[y]);
        }
    }
    for (int k = 1; k < 3; k++)
        main = fabs(normal[k]) > fabs(normal[main]) ? k : main;
    flat->axes[0] = (main + 1) % 3;
    flat->axes[1] = (main + 2) % 3;
    flat->sign = normal[main] < 0 ? -1 : 1;
}

/* Whether a corner that is left lies in the triangle that would be cut off at another one. */
static bool holds_another(const struct flat *flat, unsigned a, unsigned b, unsigned c)
{
    for (unsigned i = 0; i < flat->count; i++) {
        const unsigned p = flat->left[i];
        const unsigned name = flat->loop[p];
        if (name == flat->loop[a] || name == flat->loop[b] || name == flat->loop[c])
            continue;
        if (turn_of(flat, a, b, p) >= 0 && turn_of(flat, b, c, p) >= 0 && turn_of(flat, c, a, p) >= 0)
            return true;
    }
    return false;
}

/* The next ear from a corner on; where there is none, the corner that turns most. */
static unsigned find_ear(const struct flat *flat, unsigned from)
{
    unsigned best = 0;
    double most = -HUGE_VAL;
    for (unsigned k = 0; k < flat->count; k++) {
        const unsigned i = (from + k) % flat->count;
        const unsigned a = flat->left[(i + flat->count - 1) % flat->count], b = flat->left[i],
                       c = flat->left[(i + 1) % flat->count];
        const double turn = turn_of(flat, a, b, c);
        if (turn > 0 && !holds_another(flat, a, b, c))
            return i;
        if (turn > most) {
            most = turn;
            best = i;
        }
    }
    return best;
}

void lx_cut_polygon(const double (*corners)[3], const unsigned *loop, unsigned count, unsigned *room,
                    unsigned (*triangles)[3])
{
    struct flat flat = {.corners = corners, .loop = loop, .left = room, .count = count};
    unsigned ear = 1, made = 0;
    lay(corners, loop, count, &flat);
    for (unsigned i = 0; i < count; i++)
        flat.left[i] = i;
    while (flat.count > 3) {
        ear = find_ear(&flat, ear);
        triangles[made][0] = flat.left[(ear + flat.count - 1) % flat.count];
        triangles[made][1] = flat.left[ear];
        triangles[made++][2] = flat.left[(ear + 1) % flat.count];
        for (unsigned i = ear; i + 1 < flat.count; i++)
            flat.left[i] = flat.left[i + 1];
        flat.count--;
        ear = (ear + 1) % flat.count; /* not beside it, so that no fan of needles is made */
    }
    for (int k = 0; k < 3; k++)
        triangles[made][k] = flat.left[k];
}
