/* SPDX-License-Identifier: MIT */
/* The projected areas of luminous openings: of flat ones by the cosine, of bodies their shadows. */
#include "photometry_area.h"

#include <math.h>

static const double PI = 3.141592653589793;

/* How wide an ellipse of the half axes a and b is seen from the direction (x, y). */
static double silhouette(double a, double b, double x, double y)
{
    return 2 * hypot(a * y, b * x);
}

double lx_opening_seen_area(const luxel_photometry_opening *opening, const double direction[3])
{
    double along = fabs(direction[0]), x = fabs(direction[1]), y = fabs(direction[2]);
    double length = opening->length_mm / 1000, width = opening->width_mm / 1000, height = opening->height_mm / 1000;
    double a = length / 2, b = width / 2, c = height / 2;
    switch (opening->shape) {
    case LUXEL_OPENING_POINT: return 0;
    case LUXEL_OPENING_RECTANGLE: return length * width * along;
    case LUXEL_OPENING_BOX: return length * width * along + height * (width * x + length * y);
    case LUXEL_OPENING_ELLIPSE: return PI * a * b * along;
    case LUXEL_OPENING_CYLINDER: return PI * a * b * along + height * silhouette(a, b, x, y);
    case LUXEL_OPENING_ELLIPSOID: return PI * hypot(hypot(b * c * x, a * c * y), a * b * along);
    case LUXEL_OPENING_CYLINDER_LENGTH: return PI * b * c * x + length * silhouette(b, c, y, along);
    case LUXEL_OPENING_CYLINDER_WIDTH: return PI * a * c * y + width * silhouette(a, c, x, along);
    case LUXEL_OPENING_FACING_LENGTH: return PI * b * c * x;
    case LUXEL_OPENING_FACING_WIDTH: return PI * a * c * y;
    }
    return 0;
}
