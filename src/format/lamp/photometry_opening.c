/* SPDX-License-Identifier: MIT */
/*
 * Luminous openings of LM-63: which shape the signs of width, length and height mean.  Until 1995 one negative number
 * is a diameter and the next one may be 0; since 2002 round shapes repeat it.  Where both ways can be told apart they
 * are understood in files of any year.
 */
#include <math.h>

#include "photometry.h"

static int sign_of(double number)
{
    return (number > 0) - (number < 0);
}

/* The shape of the signs (-1, 0, 1) of width, length and height; -1: none that LM-63 knows. */
static int shape_of(unsigned year, int width, int length, int height)
{
    bool is_flat = height == 0, is_new = year >= 2002;
    if (width >= 0 && length >= 0 && height >= 0)
        return width + length + height == 0 ? LUXEL_OPENING_POINT
               : is_flat                    ? LUXEL_OPENING_RECTANGLE
                                            : LUXEL_OPENING_BOX;
    if (height >= 0)
        return is_flat ? LUXEL_OPENING_ELLIPSE : LUXEL_OPENING_CYLINDER;
    if (width < 0 && length < 0)
        return LUXEL_OPENING_ELLIPSOID;
    if (width == 0 && length > 0)
        return LUXEL_OPENING_CYLINDER_LENGTH;
    if (width > 0 && length == 0)
        return LUXEL_OPENING_CYLINDER_WIDTH;
    if (width < 0)
        return !is_new      ? LUXEL_OPENING_ELLIPSOID
               : length > 0 ? LUXEL_OPENING_CYLINDER_LENGTH
                            : LUXEL_OPENING_FACING_LENGTH;
    if (length < 0)
        return !is_new     ? LUXEL_OPENING_ELLIPSOID
               : width > 0 ? LUXEL_OPENING_CYLINDER_WIDTH
                           : LUXEL_OPENING_FACING_WIDTH;
    return -1;
}

bool lx_lm63_opening(unsigned year, double width_mm, double length_mm, double height_mm,
                     luxel_photometry_opening *opening)
{
    int shape = shape_of(year, sign_of(width_mm), sign_of(length_mm), sign_of(height_mm));
    double width = fabs(width_mm), length = fabs(length_mm), height = fabs(height_mm);
    bool is_known = shape >= 0;
    switch (shape) {
    case LUXEL_OPENING_ELLIPSE:
    case LUXEL_OPENING_CYLINDER:
    case LUXEL_OPENING_ELLIPSOID:
        width = width > 0 ? width : length;
        length = length > 0 ? length : width;
        break;
    case LUXEL_OPENING_CYLINDER_LENGTH: width = width > 0 ? width : height; break;
    case LUXEL_OPENING_CYLINDER_WIDTH: length = length > 0 ? length : height; break;
    default: break;
    }
    *opening = (luxel_photometry_opening){is_known ? (luxel_photometry_opening_shape)shape : LUXEL_OPENING_BOX, width,
                                          length, height};
    return is_known;
}

const char *luxel_photometry_opening_name(const luxel_photometry_opening *opening)
{
    bool is_round = opening->width_mm == opening->length_mm;
    switch (opening->shape) {
    case LUXEL_OPENING_POINT: return "point";
    case LUXEL_OPENING_RECTANGLE: return "rectangle";
    case LUXEL_OPENING_BOX: return "box";
    case LUXEL_OPENING_ELLIPSE: return is_round ? "disk" : "ellipse";
    case LUXEL_OPENING_CYLINDER: return is_round ? "cylinder" : "elliptic cylinder";
    case LUXEL_OPENING_ELLIPSOID: return is_round && opening->height_mm == opening->width_mm ? "sphere" : "ellipsoid";
    case LUXEL_OPENING_CYLINDER_LENGTH:
        return opening->width_mm == opening->height_mm ? "cylinder along the length"
                                                       : "elliptic cylinder along the length";
    case LUXEL_OPENING_CYLINDER_WIDTH:
        return opening->length_mm == opening->height_mm ? "cylinder along the width"
                                                        : "elliptic cylinder along the width";
    case LUXEL_OPENING_FACING_LENGTH:
        return opening->width_mm == opening->height_mm ? "disk facing the length" : "ellipse facing the length";
    case LUXEL_OPENING_FACING_WIDTH:
        return opening->length_mm == opening->height_mm ? "disk facing the width" : "ellipse facing the width";
    }
    return "point";
}
