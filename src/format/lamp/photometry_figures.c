/* SPDX-License-Identifier: MIT */
/*
 * What is read off the table of a luminaire: flux, ratios, the CIE flux code, direct ratios, spacing criteria, the
 * greatest intensity.  docs/PHOTOMETRY.md has the definitions with their sources.
 */
#include <math.h>

#include "photometry.h"
#include "photometry_section.h"

static const double DEGREE = 0.017453292519943295;
static const double NONE = (double)NAN;

double luxel_photometry_room_index(size_t i)
{
    static const double indices[LUXEL_ROOM_INDICES] = {0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5};
    return i < LUXEL_ROOM_INDICES ? indices[i] : NONE;
}

/* ---- flux ---- */

/*
 * Direct ratios for a spacing to height ratio of 1: the sums over the four cones of the CIE flux code, of 41.4, 60,
 * 75.5 and 90 degrees, weighted per thousand for each room index (LiTG publication 3.5; DIN 5040, CIE 52).
 */
static const short cone_weights[LUXEL_ROOM_INDICES][4] = {
    {943, -317, 481, -107}, {752, -33, 372, -91}, {636, 121, 310, -67}, {510, 238, 282, -30}, {429, 275, 309, -13},
    {354, 248, 363, 35},    {286, 190, 416, 108}, {258, 118, 463, 161}, {236, -6, 512, 258},  {231, -99, 518, 350},
};

static void find_ratios(const luxel_photometry *photometry, const struct lx_polar_curve *curve,
                        luxel_photometry_figures *figures)
{
    double cones[4], whole = figures->zone_lumens;
    for (int i = 0; i < 4; i++) /* cosines of 3/4, 1/2, 1/4 and 0 */
        cones[i] = lx_polar_flux(curve, LUXEL_INTERPOLATE_COSINE, 0, i == 3 ? 90 : acos(0.75 - 0.25 * i) / DEGREE);
    figures->dff = whole > 0 ? 100 * fmin(1, cones[3] / whole) : NONE; /* sums of the same numbers may round apart */
    for (int i = 0; i < 3; i++)
        figures->flux_code[i] = cones[3] > 0 ? 100 * fmin(1, cones[i] / cones[3]) : NONE;
    figures->flux_code[3] = figures->dff;
    figures->flux_code[4] = photometry->is_absolute ? 100 : figures->lorl;
    for (size_t k = 0; k < LUXEL_ROOM_INDICES; k++) {
        double sum = 0;
        for (int i = 0; i < 4; i++)
            sum += cones[i] * cone_weights[k][i];
        figures->direct_ratios[k] = cones[3] > 0 ? sum / (1000 * cones[3]) : NONE;
    }
}

static luxel_status find_flux(const luxel_photometry *photometry, luxel_photometry_figures *figures)
{
    struct lx_polar_curve curve;
    if (!lx_polar_curve_of(photometry, &curve))
        return LUXEL_ERROR_MEMORY;
    figures->zone_lumens = lx_polar_flux(&curve, LUXEL_INTERPOLATE_COSINE, 0, 180);
    figures->linear_lumens = lx_polar_flux(&curve, LUXEL_INTERPOLATE_ANGLE, 0, 180);
    if (photometry->declared_lumens > 0)
        figures->lorl = 100 * figures->zone_lumens / photometry->declared_lumens;
    if (photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        find_ratios(photometry, &curve, figures);
    lx_polar_curve_clear(&curve);
    return LUXEL_OK;
}

/* ---- the greatest intensity ---- */

static void find_greatest(const luxel_photometry *photometry, luxel_photometry_figures *figures)
{
    size_t angles = photometry->angle_count, best = 0;
    double direction[3];
    for (size_t i = 0; i < photometry->plane_count * angles; i++)
        if (photometry->intensities[i] > photometry->intensities[best])
            best = i;
    figures->greatest_cd = photometry->intensities[best];
    figures->greatest_plane_deg = photometry->planes[best / angles];
    figures->greatest_angle_deg = photometry->angles[best % angles];
    figures->greatest_c_deg = figures->greatest_plane_deg;
    figures->greatest_gamma_deg = figures->greatest_angle_deg;
    if (photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        return;
    luxel_photometry_direction(photometry, figures->greatest_plane_deg, figures->greatest_angle_deg, direction);
    double across = hypot(direction[1], direction[2]);
    figures->greatest_gamma_deg = atan2(across, direction[0]) / DEGREE;
    figures->greatest_c_deg = across > 1e-12 ? atan2(direction[2], direction[1]) / DEGREE : 0;
    figures->greatest_c_deg += figures->greatest_c_deg < 0 ? 360 : 0;
}

static luxel_status find_widths(const luxel_photometry *photometry, luxel_photometry_figures *figures)
{
    struct lx_section section;
    bool is_turn = photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    for (int i = 0; i < (is_turn ? 3 : 2); i++) {
        if (!lx_section_of(photometry, i == 2 ? figures->greatest_c_deg : 90.0 * i, &section))
            return LUXEL_ERROR_MEMORY;
        double beam = lx_section_width(&section, 0.5), field = lx_section_width(&section, 0.1);
        if (i < 2) {
            figures->beam_sections_deg[i] = beam;
            figures->field_sections_deg[i] = field;
        }
        if (i == 2 || !is_turn) {
            bool is_wider = i == 2 || i == 0 || beam > figures->beam_deg;
            figures->beam_deg = is_wider ? beam : figures->beam_deg;
            figures->field_deg = is_wider ? field : figures->field_deg;
        }
        lx_section_clear(&section);
    }
    return LUXEL_OK;
}

/* ---- spacing criteria ---- */

/* The mean intensity of luminaires that see a point under one gamma from planes around it, times cos^3. */
static double mean_share(const luxel_photometry *photometry, const double *planes, size_t count, double gamma_deg)
{
    double sum = 0, cosine = cos(gamma_deg * DEGREE);
    for (size_t i = 0; i < count; i++)
        sum += luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, planes[i], gamma_deg);
    return sum / (double)count * cosine * cosine * cosine;
}

/*
 * The tangent of the largest gamma under which so many luminaires together light a point as much as one lights the
 * point right below it; NaN: there is none.
 */
static double farthest_tangent(const luxel_photometry *photometry, const double *planes, size_t count, double wanted)
{
    enum { PARTS = 4, HALVINGS = 60 };
    for (size_t j = photometry->angle_count - 1; j-- > 0;)
        for (int part = PARTS; part-- > 0;) {
            double from = photometry->angles[j], step = (photometry->angles[j + 1] - from) / PARTS;
            double low = from + part * step, high = part + 1 < PARTS ? low + step : photometry->angles[j + 1];
            if (low >= 90 || mean_share(photometry, planes, count, low) < wanted)
                continue;
            for (int i = 0; i < HALVINGS; i++) {
                double middle = 0.5 * (low + high);
                bool is_enough = middle < 90 && mean_share(photometry, planes, count, middle) >= wanted;
                low = is_enough ? middle : low;
                high = is_enough ? high : middle;
            }
            return tan(low * DEGREE);
        }
    return NONE;
}

static void find_spacing(const luxel_photometry *photometry, luxel_photometry_figures *figures)
{
    static const double along[2][2] = {{0, 180}, {90, 270}}, across[4] = {45, 135, 225, 315};
    double below = 0;
    for (size_t i = 0; i + 1 < photometry->plane_count; i++)
        below += photometry->angles[0] == 0 ? photometry->intensities[i * photometry->angle_count] *
                                                  (photometry->planes[i + 1] - photometry->planes[i]) / 360
                                            : 0;
    if (!(below > 0))
        return;
    for (int i = 0; i < 2; i++)
        figures->spacing[i] = 2 * farthest_tangent(photometry, along[i], 2, below / 2);
    figures->spacing[2] = sqrt(2) * farthest_tangent(photometry, across, 4, below / 4);
}

luxel_status luxel_photometry_find_figures(const luxel_photometry *photometry, luxel_photometry_figures *figures)
{
    if (!photometry || !figures)
        return LUXEL_ERROR_ARGUMENT;
    *figures = (luxel_photometry_figures){.lorl = NONE,
                                          .dff = NONE,
                                          .flux_code = {NONE, NONE, NONE, NONE, NONE},
                                          .spacing = {NONE, NONE, NONE},
                                          .beam_deg = NONE,
                                          .field_deg = NONE,
                                          .beam_sections_deg = {NONE, NONE},
                                          .field_sections_deg = {NONE, NONE}};
    for (size_t i = 0; i < LUXEL_ROOM_INDICES; i++)
        figures->direct_ratios[i] = NONE;
    find_greatest(photometry, figures);
    luxel_status status = find_flux(photometry, figures);
    if (status == LUXEL_OK && figures->greatest_cd > 0)
        status = find_widths(photometry, figures);
    if (status == LUXEL_OK && photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        find_spacing(photometry, figures);
    return status;
}
