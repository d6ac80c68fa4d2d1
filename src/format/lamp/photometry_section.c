/* SPDX-License-Identifier: MIT */
/* Sections through the axis of a luminaire's table, and the angles of beam and field in them. */
#include "photometry_section.h"

#include <math.h>
#include <stdlib.h>

#include "../../base/memory.h"

static void add(struct lx_section *section, double angle_deg, double value)
{
    section->angles_deg[section->count] = angle_deg;
    section->values[section->count++] = value;
}

/* Adds darkness from one angle to another, if there is any. */
static void add_dark(struct lx_section *section, double from_deg, double to_deg)
{
    if (to_deg > from_deg) {
        add(section, from_deg, 0);
        add(section, to_deg, 0);
    }
}

static double value_at(const luxel_photometry *photometry, double plane_deg, double angle_deg)
{
    return luxel_photometry_intensity(photometry, LUXEL_INTERPOLATE_ANGLE, plane_deg, angle_deg);
}

static void take_planes(const luxel_photometry *photometry, double plane_deg, struct lx_section *section)
{
    const double *angles = photometry->angles;
    size_t count = photometry->angle_count;
    add_dark(section, -180, -angles[count - 1]);
    for (size_t j = count; j-- > 0;)
        if (angles[j] > 0)
            add(section, -angles[j], value_at(photometry, plane_deg + 180, angles[j]));
    add_dark(section, -angles[0], angles[0]);
    for (size_t j = 0; j < count; j++)
        add(section, angles[j], value_at(photometry, plane_deg, angles[j]));
    add_dark(section, angles[count - 1], 180);
}

/* Types A and B: along the horizontal angles at the vertical angle 0, or the other way round. */
static void take_cross(const luxel_photometry *photometry, bool is_upright, struct lx_section *section)
{
    const double *places = is_upright ? photometry->angles : photometry->planes;
    size_t count = is_upright ? photometry->angle_count : photometry->plane_count;
    add_dark(section, -180, places[0]);
    for (size_t i = 0; i < count; i++)
        add(section, places[i], is_upright ? value_at(photometry, 0, places[i]) : value_at(photometry, places[i], 0));
    add_dark(section, places[count - 1], 180);
}

bool lx_section_of(const luxel_photometry *photometry, double plane_deg, struct lx_section *section)
{
    size_t most = 2 * photometry->angle_count + photometry->plane_count + 6;
    *section = (struct lx_section){lx_new_array(most, sizeof(double)), lx_new_array(most, sizeof(double)), 0};
    if (!section->angles_deg || !section->values) {
        lx_section_clear(section);
        return false;
    }
    if (photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        take_planes(photometry, plane_deg, section);
    else
        take_cross(photometry, plane_deg >= 90, section);
    return true;
}

void lx_section_clear(struct lx_section *section)
{
    free(section->angles_deg);
    free(section->values);
    *section = (struct lx_section){NULL, NULL, 0};
}

/* How far it is from a place at or above the level, one way, to where the curve falls below; at most 360. */
static double reach(const struct lx_section *section, size_t start, bool is_rightward, double level)
{
    size_t count = section->count, at = start;
    double way = 0;
    for (size_t steps = 0; steps < count; steps++) {
        size_t next = is_rightward ? (at + 1) % count : (at + count - 1) % count;
        double width = fabs(section->angles_deg[next] - section->angles_deg[at]);
        bool is_seam = is_rightward ? next == 0 : at == 0; /* -180 and 180 are one direction */
        width = is_seam ? 0 : width;
        double here = section->values[at], there = section->values[next];
        if (there < level)
            return way + (here > there ? width * (here - level) / (here - there) : 0);
        way += width;
        at = next;
    }
    return 360;
}

static size_t find_peak(const struct lx_section *section)
{
    size_t peak = 0;
    for (size_t i = 0; i < section->count; i++) {
        double more = section->values[i] - section->values[peak];
        bool is_nearer = fabs(section->angles_deg[i]) < fabs(section->angles_deg[peak]);
        if (more > 0 || (more == 0 && is_nearer))
            peak = i;
    }
    return peak;
}

/* Whether both halves are the same but for roundings. */
static bool is_symmetric(const struct lx_section *section, double greatest)
{
    static const double SAME = 1e-6;
    for (size_t i = 0, k = section->count - 1; i < k; i++, k--)
        if (fabs(section->angles_deg[i] + section->angles_deg[k]) > SAME ||
            fabs(section->values[i] - section->values[k]) > SAME * greatest)
            return false;
    return true;
}

/* Across the axis: twice the angle from it, or from the opposite direction, at which the half space is dark at last. */
static double width_across(const struct lx_section *section, bool is_down, double level)
{
    size_t start = section->count;
    for (size_t i = 0; i < section->count; i++) {
        double angle = section->angles_deg[i];
        bool is_inside = is_down ? angle >= 0 && angle <= 90 : angle >= 90;
        if (is_inside && section->values[i] >= level && (is_down || start == section->count))
            start = i;
    }
    double from = is_down ? section->angles_deg[start] : 180 - section->angles_deg[start];
    return fmin(360, 2 * (from + reach(section, start, is_down, level)));
}

double lx_section_width(const struct lx_section *section, double share)
{
    size_t peak = find_peak(section);
    double greatest = section->values[peak], level = share * greatest;
    if (!(greatest > 0))
        return (double)NAN;
    if (is_symmetric(section, greatest))
        return width_across(section, fabs(section->angles_deg[peak]) <= 90, level);
    return fmin(360, reach(section, peak, true, level) + reach(section, peak, false, level));
}
