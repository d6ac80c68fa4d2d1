/* SPDX-License-Identifier: MIT */
/*
 * Unified glare rating of a luminaire in standard rooms, by the tabular method of CIE 190 (CIE 117):
 * UGR = 8 lg(0.25 / Lb · Σ L² ω / p²) over an even grid of luminaires at the height H above the eye.  The eye is in the
 * middle of a wall and looks at the one opposite.  The background Lb is the indirect illuminance of the walls between
 * eye and luminaires over π.  Two factors of the method stand in its tables and are computed here: what share of the
 * downward light falls on the plane of the eye, and how walls are lit by light that first meets floor, walls or
 * ceiling, each taken as evenly lit.  Lengths are in heights H, on which the rating does not depend: the glare sum and
 * Lb fall with its square alike.  docs/PHOTOMETRY.md says how far the results are from published tables.
 */
#include <luxel/glare.h>

#include <math.h>
#include <stdlib.h>

#include "../../base/glare.h"
#include "../../base/memory.h"
#include "photometry.h"
#include "photometry_area.h"
#include "photometry_cavity.h"

static const double PI = 3.141592653589793;
static const double DEGREE = 0.017453292519943295;

/* Luminaires count up to 85 degrees in whole degrees: CIE 190 has those 11.5 heights ahead, at 85.03. */
static const double GREATEST_GAMMA = 85.5;

static const unsigned char rooms[LUXEL_UGR_ROOMS][2] = {{2, 2}, {2, 3},  {2, 4},  {2, 6},  {2, 8},  {2, 12}, {4, 2},
                                                        {4, 3}, {4, 4},  {4, 6},  {4, 8},  {4, 12}, {8, 4},  {8, 6},
                                                        {8, 8}, {8, 12}, {12, 4}, {12, 6}, {12, 8}};

static const double reflectances[LUXEL_UGR_REFLECTANCES][LX_CAVITY_PARTS] = {
    /* floor, walls, ceiling */
    {0.2, 0.5, 0.7},
    {0.2, 0.3, 0.7},
    {0.2, 0.5, 0.5},
    {0.2, 0.3, 0.5},
    {0.2, 0.3, 0.3}};

/* ---- direct and reflected light on the walls ---- */

struct room {
    size_t across, along;           /* how many luminaires there are */
    double size[2], spacing;        /* in heights of the luminaires above the eye */
    double shares[LX_CAVITY_PARTS]; /* lumens of one luminaire that first fall on each part */
};

/* The share of a circle of directions, `radius` heights wide on the plane of the eye, that falls on it; the mean over
 * all luminaires, for each of which the room is four rectangles. */
static double share_inside(const struct room *room, double radius, double *starts, double *ends)
{
    double sum = 0;
    for (size_t i = 0; i < room->across; i++)
        starts[i] = acos(fmin(1, ((double)i + 0.5) * room->spacing / radius));
    for (size_t j = 0; j < room->along; j++)
        ends[j] = asin(fmin(1, ((double)j + 0.5) * room->spacing / radius));
    for (size_t i = 0; i < room->across; i++)
        for (size_t j = 0; j < room->along; j++)
            sum += fmax(0, ends[j] - starts[i]);
    return sum / ((double)(room->across * room->along) * (PI / 2));
}

/* The part of the downward flux on the plane of the eye: the curve's flux in rings, times their share. */
static bool find_shares(struct room *room, const struct lx_polar_curve *curve)
{
    enum { RINGS = 360 };
    double *starts = lx_new_array(room->across + room->along, sizeof *starts);
    double down = 0, on_floor = 0, whole = lx_polar_flux(curve, LUXEL_INTERPOLATE_ANGLE, 0, 180);
    if (!starts)
        return false;
    for (int i = 0; i < RINGS; i++) {
        double from = 90.0 * i / RINGS, to = 90.0 * (i + 1) / RINGS;
        double flux = lx_polar_flux(curve, LUXEL_INTERPOLATE_ANGLE, from, to);
        down += flux;
        on_floor += flux * share_inside(room, tan(0.5 * (from + to) * DEGREE), starts, starts + room->across);
    }
    free(starts);
    room->shares[LX_FLOOR] = on_floor;
    room->shares[LX_WALLS] = down - on_floor;
    room->shares[LX_CEILING] = fmax(0, whole - down);
    return true;
}

/* The indirect illuminance of the walls, lm per square height, for one luminaire of the room. */
static double wall_light(const struct room *room, const double reflectance[LX_CAVITY_PARTS])
{
    double light[LX_CAVITY_PARTS];
    lx_cavity_light(room->size[0], room->size[1], room->shares, reflectance, light);
    return light[LX_WALLS] - room->shares[LX_WALLS] / (2 * (room->size[0] + room->size[1]));
}

/* ---- luminaires ---- */

/* The sum of L² ω / p² over the luminaires, whose C = 0 (crosswise) or C = 90 (endwise) goes towards the observer. */
static double glare_sum(const luxel_photometry *photometry, const struct room *room, bool is_endwise)
{
    double sum = 0, spacing = room->spacing;
    for (size_t j = 0; j < room->along; j++)
        for (size_t i = 0; i < room->across; i++) {
            double ahead = ((double)j + 0.5) * spacing, aside = ((double)i + 0.5) * spacing - room->size[0] / 2;
            double index = lx_position_index_of_table(ahead, aside, 1), way = hypot(ahead, aside);
            double gamma = atan(way) / DEGREE, turn = (is_endwise ? 90 : 0) - atan2(aside, ahead) / DEGREE;
            double direction[3];
            if (isnan(index) || gamma > GREATEST_GAMMA)
                continue;
            turn += turn < 0 ? 360 : 0;
            luxel_photometry_direction(photometry, turn, gamma, direction);
            double area = lx_opening_seen_area(&photometry->opening, direction);
            double cd = luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, turn, gamma);
            sum += cd > 0 ? cd * cd / (area * (1 + way * way) * index * index) : 0;
        }
    return sum;
}

static bool rate_room(const luxel_photometry *photometry, const struct lx_polar_curve *curve, struct room *room,
                      double ratings[2][LUXEL_UGR_REFLECTANCES], double backgrounds[LUXEL_UGR_REFLECTANCES])
{
    if (!find_shares(room, curve))
        return false;
    for (int k = 0; k < LUXEL_UGR_REFLECTANCES; k++)
        backgrounds[k] = wall_light(room, reflectances[k]) * (double)(room->across * room->along) / PI;
    for (int is_endwise = 0; is_endwise < 2; is_endwise++) {
        double sum = glare_sum(photometry, room, is_endwise);
        for (int k = 0; k < LUXEL_UGR_REFLECTANCES; k++) {
            double background = backgrounds[k];
            ratings[is_endwise][k] =
                isfinite(sum) && sum > 0 && background > 0 ? 8 * log10(0.25 / background * sum) : (double)NAN;
        }
    }
    return true;
}

luxel_status luxel_photometry_find_ugr_table(const luxel_photometry *photometry, double spacing, luxel_ugr_table *table)
{
    double parts = round(1 / spacing);
    struct lx_polar_curve curve;
    if (!photometry || !table || !(parts >= 1 && parts <= 8) || fabs(parts * spacing - 1) > 1e-9)
        return LUXEL_ERROR_ARGUMENT;
    *table = (luxel_ugr_table){.spacing = 1 / parts};
    if (photometry->type != LUXEL_PHOTOMETRY_TYPE_C || photometry->opening.shape == LUXEL_OPENING_POINT)
        return LUXEL_OK;
    if (!lx_polar_curve_of(photometry, &curve))
        return LUXEL_ERROR_MEMORY;
    bool is_done = true;
    for (size_t i = 0; i < LUXEL_UGR_ROOMS && is_done; i++) {
        struct room room = {
            (size_t)(rooms[i][0] * parts), (size_t)(rooms[i][1] * parts), {rooms[i][0], rooms[i][1]}, 1 / parts, {0}};
        is_done = rate_room(photometry, &curve, &room, table->ratings[i], table->backgrounds[i]);
    }
    lx_polar_curve_clear(&curve);
    table->exists = is_done;
    return is_done ? LUXEL_OK : LUXEL_ERROR_MEMORY;
}

double luxel_ugr_room(size_t i, size_t axis)
{
    return i < LUXEL_UGR_ROOMS && axis < 2 ? rooms[i][axis] : (double)NAN;
}

double luxel_ugr_reflectance(size_t i, size_t part)
{
    return i < LUXEL_UGR_REFLECTANCES && part < LX_CAVITY_PARTS ? reflectances[i][LX_CEILING - part] : (double)NAN;
}
