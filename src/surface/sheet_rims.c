/* SPDX-License-Identifier: MIT */
/* Rims of sheets: straight pieces of the outlines that plates, disks, tubes and balls have as a light sees them. */
#include "../base/vector.h"
#include "sheet_types.h"

/* Whoever takes the pieces of a rim, until it has enough. */
struct rim {
    lx_rim_taker *take;
    void *data;
    int pieces; /* of a round outline */
    bool is_over;
};

static void add(struct rim *rim, const double from_mm[3], const double to_mm[3], const double inside_mm[3])
{
    rim->is_over = rim->is_over || !rim->take(rim->data, from_mm, to_mm, inside_mm);
}

void lx_rim_of_plate(const struct lx_smooth_sheet *plate, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                     void *data)
{
    struct rim rim = {take, data, pieces, false};
    double corners[4][3];
    (void)light;
    const int count = lx_sheet_corners(plate, corners);
    for (int c = 0; c < count; c++)
        add(&rim, corners[c], corners[(c + 1) % count], plate->center_mm);
}

/* Place i of a circle. */
static void on_circle(const double center_mm[3], double radius_mm, const double across[3], const double upward[3],
                      int i, int pieces, double place_mm[3])
{
    const double angle = 2 * M_PI * i / pieces;
    for (int k = 0; k < 3; k++)
        place_mm[k] = center_mm[k] + radius_mm * (cos(angle) * across[k] + sin(angle) * upward[k]);
}

/* Adds a circle, from each place of which the surface goes on by `inwards`; NULL: to the middle, or away from it where
 * the circle is a hole. */
static void add_circle(struct rim *rim, const double center_mm[3], double radius_mm, const double across[3],
                       const double upward[3], const double *inwards, bool is_hole)
{
    for (int i = 0; i < rim->pieces; i++) {
        double from[3], to[3], inside[3];
        on_circle(center_mm, radius_mm, across, upward, i, rim->pieces, from);
        on_circle(center_mm, radius_mm, across, upward, i + 1, rim->pieces, to);
        for (int k = 0; k < 3; k++)
            inside[k] = inwards   ? (from[k] + to[k]) / 2 + inwards[k]
                        : is_hole ? from[k] + to[k] - center_mm[k]
                                  : center_mm[k];
        add(rim, from, to, inside);
    }
}

/* A disk goes on away from the middle beside its hole. */
void lx_rim_of_disk(const struct lx_smooth_sheet *disk, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                    void *data)
{
    struct rim rim = {take, data, pieces, false};
    (void)light;
    add_circle(&rim, disk->center_mm, disk->half_mm[0], disk->across, disk->upward, NULL, false);
    if (disk->half_mm[1] > 0)
        add_circle(&rim, disk->center_mm, disk->half_mm[1], disk->across, disk->upward, NULL, true);
}

/* The circle in which ways from the light touch a ball; inside of it there is none. */
void lx_rim_of_ball(const struct lx_smooth_sheet *ball, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                    void *data)
{
    struct rim rim = {take, data, pieces, false};
    const double radius = ball->half_mm[0];
    double way[3], across[3], upward[3], middle[3];
    lx_way_to(light, ball->center_mm, way);
    const double away = lx_normalize(way), sine = light->endless ? 0 : radius / away;
    if (!(sine < 1))
        return;
    lx_around_axis(way, across, upward);
    for (int k = 0; k < 3; k++)
        middle[k] = ball->center_mm[k] + radius * sine * way[k];
    add_circle(&rim, middle, radius * sqrt(1 - sine * sine), across, upward, NULL, false);
}

/* Both rims of a tube, and where ways from the light touch its side. */
void lx_rim_of_tube(const struct lx_smooth_sheet *tube, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                    void *data)
{
    struct rim rim = {take, data, pieces, false};
    const double radius = tube->half_mm[0], half = tube->half_mm[1];
    double way[3];
    for (int side = -1; side <= 1; side += 2) {
        double middle[3], inwards[3];
        for (int k = 0; k < 3; k++) {
            middle[k] = tube->center_mm[k] + side * half * tube->axis[k];
            inwards[k] = -side * half * tube->axis[k];
        }
        add_circle(&rim, middle, radius, tube->across, tube->upward, inwards, false);
    }
    lx_way_to(light, tube->center_mm, way);
    const double x = lx_dot(way, tube->across), y = lx_dot(way, tube->upward), away = hypot(x, y);
    const double cosine = light->endless ? 0 : radius / away;
    for (int side = -1; side <= 1 && away > 0 && cosine < 1; side += 2) {
        const double angle = atan2(y, x) + side * acos(cosine);
        double ends[2][3];
        for (int k = 0; k < 3; k++) {
            const double touch =
                tube->center_mm[k] + radius * (cos(angle) * tube->across[k] + sin(angle) * tube->upward[k]);
            ends[0][k] = touch - half * tube->axis[k];
            ends[1][k] = touch + half * tube->axis[k];
        }
        add(&rim, ends[0], ends[1], tube->center_mm);
    }
}
