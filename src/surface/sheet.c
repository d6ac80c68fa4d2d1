/* SPDX-License-Identifier: MIT */
/* Cutting surfaces into sheets, and the coordinates of these. */
#include "sheet.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

enum { SECTORS = 4, CUBE = 6 };
#define SECTOR (M_PI / SECTORS) /* half of one */

static struct lx_smooth_sheet sheet_of(const struct lx_shape *shape, enum lx_sheet_type type)
{
    struct lx_smooth_sheet sheet = {.type = type, .turn = 1};
    memcpy(sheet.center_mm, shape->anchor_mm, sizeof sheet.center_mm);
    memcpy(sheet.across, shape->across, sizeof sheet.across);
    memcpy(sheet.upward, shape->upward, sizeof sheet.upward);
    memcpy(sheet.axis, shape->axis, sizeof sheet.axis);
    return sheet;
}

/* The other side of `count` sheets, behind them. */
static int add_backs(struct lx_smooth_sheet *sheets, int count)
{
    for (int i = 0; i < count; i++) {
        sheets[count + i] = sheets[i];
        sheets[count + i].turn = -sheets[i].turn;
    }
    return 2 * count;
}

int lx_sheets_of_plate(const struct lx_shape *shape, struct lx_smooth_sheet *sheets)
{
    sheets[0] = sheet_of(shape, LX_SHEET_PLATE);
    for (int i = 0; i < 2; i++)
        sheets[0].half_mm[i] = shape->half_mm[i] - shape->touch_mm;
    return add_backs(sheets, 1);
}

int lx_sheets_of_sectors(const struct lx_shape *shape, enum lx_sheet_type type, double radius_mm, double half_mm,
                         struct lx_smooth_sheet *sheets)
{
    for (int i = 0; i < SECTORS; i++) {
        sheets[i] = sheet_of(shape, type);
        sheets[i].half_mm[0] = radius_mm;
        sheets[i].half_mm[1] = half_mm;
        sheets[i].middle = (2 * i + 1) * SECTOR;
    }
    return add_backs(sheets, SECTORS);
}

int lx_sheets_of_ball(const struct lx_shape *shape, bool is_hollow, struct lx_smooth_sheet *sheets)
{
    for (int i = 0; i < CUBE; i++) {
        const double sign = i < CUBE / 2 ? 1 : -1;
        sheets[i] =
            (struct lx_smooth_sheet){.type = LX_SHEET_BALL, .turn = is_hollow ? -1 : 1, .half_mm = {shape->radius_mm}};
        memcpy(sheets[i].center_mm, shape->anchor_mm, sizeof sheets[i].center_mm);
        sheets[i].axis[i % 3] = sign;
        sheets[i].across[(i + 1) % 3] = sign;
        sheets[i].upward[(i + 2) % 3] = 1;
    }
    return is_hollow ? add_backs(sheets, CUBE) : CUBE;
}

int lx_shape_sheets(const struct lx_shape *shape, struct lx_smooth_sheet sheets[LX_MOST_SHEETS])
{
    return shape->kind->sheets ? shape->kind->sheets(shape, sheets) : 0;
}

/* place = center + a across + b upward + c axis */
static void lay(const struct lx_smooth_sheet *sheet, double a, double b, double c, double place_mm[3])
{
    for (int i = 0; i < 3; i++)
        place_mm[i] = sheet->center_mm[i] + a * sheet->across[i] + b * sheet->upward[i] + c * sheet->axis[i];
}

static void turn(const struct lx_smooth_sheet *sheet, double a, double b, double c, double normal[3])
{
    for (int i = 0; i < 3; i++)
        normal[i] = sheet->turn * (a * sheet->across[i] + b * sheet->upward[i] + c * sheet->axis[i]);
}

struct lx_sheet_line lx_sheet_line(const struct lx_smooth_sheet *sheet, int way, double at)
{
    struct lx_sheet_line line = {.at = at};
    if (sheet->type == LX_SHEET_BALL) {
        line.first = tan(M_PI / 4 * at);
    } else if ((sheet->type == LX_SHEET_DISK || sheet->type == LX_SHEET_TUBE) && way == 0) {
        line.first = cos(sheet->middle + SECTOR * at);
        line.second = sin(sheet->middle + SECTOR * at);
    }
    return line;
}

double lx_sheet_cross(const struct lx_smooth_sheet *sheet, const struct lx_sheet_line *s, const struct lx_sheet_line *t,
                      double place_mm[3], double normal[3])
{
    const double radius = sheet->half_mm[0];
    if (sheet->type == LX_SHEET_PLATE) {
        lay(sheet, s->at * sheet->half_mm[0], t->at * sheet->half_mm[1], 0, place_mm);
        turn(sheet, 0, 0, 1, normal);
        return sheet->half_mm[0] * sheet->half_mm[1];
    }
    if (sheet->type == LX_SHEET_TRIANGLE) {
        const double away = (1 + t->at) / 2;
        lay(sheet, away * (sheet->middle + s->at * sheet->half_mm[0]), away * 2 * sheet->half_mm[1], 0, place_mm);
        turn(sheet, 0, 0, 1, normal);
        return away * sheet->half_mm[0] * sheet->half_mm[1];
    }
    if (sheet->type == LX_SHEET_DISK) {
        const double hole = sheet->half_mm[1], away = hole + (radius - hole) * (1 + t->at) / 2;
        lay(sheet, away * s->first, away * s->second, 0, place_mm);
        turn(sheet, 0, 0, 1, normal);
        return away * SECTOR * (radius - hole) / 2;
    }
    if (sheet->type == LX_SHEET_TUBE) {
        lay(sheet, radius * s->first, radius * s->second, t->at * sheet->half_mm[1], place_mm);
        turn(sheet, s->first, s->second, 0, normal);
        return radius * SECTOR * sheet->half_mm[1];
    }
    const double x = s->first, y = t->first, square = 1 + x * x + y * y, length = sqrt(square);
    lay(sheet, radius * x / length, radius * y / length, radius / length, place_mm);
    turn(sheet, x / length, y / length, 1 / length, normal);
    return radius * radius * (M_PI / 4) * (M_PI / 4) * (1 + x * x) * (1 + y * y) / (square * length);
}

double lx_sheet_place(const struct lx_smooth_sheet *sheet, double s, double t, double place_mm[3], double normal[3])
{
    const struct lx_sheet_line across = lx_sheet_line(sheet, 0, s), upward = lx_sheet_line(sheet, 1, t);
    return lx_sheet_cross(sheet, &across, &upward, place_mm, normal);
}

/* The solid angle of the rectangle from (0, 0, 1) to (x, y, 1), seen from 0. */
static double angle_of_corner(double s, double t)
{
    const double x = tan(M_PI / 4 * s), y = tan(M_PI / 4 * t);
    return atan(x * y / sqrt(1 + x * x + y * y));
}

double lx_sheet_ball_area(const struct lx_smooth_sheet *ball, const double low[2], const double high[2])
{
    const double angle = angle_of_corner(high[0], high[1]) - angle_of_corner(low[0], high[1]) -
                         angle_of_corner(high[0], low[1]) + angle_of_corner(low[0], low[1]);
    return ball->half_mm[0] * ball->half_mm[0] * angle;
}

/* The coordinate of an angle in a sector. */
static double along_sector(const struct lx_smooth_sheet *sheet, double y, double x)
{
    return remainder(atan2(y, x) - sheet->middle, 2 * M_PI) / SECTOR;
}

void lx_sheet_locate(const struct lx_smooth_sheet *sheet, const double place_mm[3], double at[2])
{
    const double from[3] = {place_mm[0] - sheet->center_mm[0], place_mm[1] - sheet->center_mm[1],
                            place_mm[2] - sheet->center_mm[2]};
    const double a = lx_dot(from, sheet->across), b = lx_dot(from, sheet->upward), c = lx_dot(from, sheet->axis);
    switch (sheet->type) {
    case LX_SHEET_PLATE:
        at[0] = a / sheet->half_mm[0];
        at[1] = b / sheet->half_mm[1];
        break;
    case LX_SHEET_TRIANGLE:
        at[0] = b > 0 ? (a * 2 * sheet->half_mm[1] / b - sheet->middle) / sheet->half_mm[0] : 0;
        at[1] = b / sheet->half_mm[1] - 1;
        break;
    case LX_SHEET_DISK:
        at[0] = along_sector(sheet, b, a);
        at[1] = 2 * (hypot(a, b) - sheet->half_mm[1]) / (sheet->half_mm[0] - sheet->half_mm[1]) - 1;
        break;
    case LX_SHEET_TUBE:
        at[0] = along_sector(sheet, b, a);
        at[1] = c / sheet->half_mm[1];
        break;
    case LX_SHEET_BALL:
        at[0] = c > 0 ? atan(a / c) * 4 / M_PI : 2;
        at[1] = c > 0 ? atan(b / c) * 4 / M_PI : 2;
        break;
    }
}

bool lx_sheet_of_triangle(const double corners_mm[3][3], struct lx_smooth_sheet *sheet)
{
    double sides[3][3], squares[3], from[3];
    int longest = 0;
    for (int c = 0; c < 3; c++) { /* side c is across from corner c */
        for (int k = 0; k < 3; k++)
            sides[c][k] = corners_mm[(c + 1) % 3][k] - corners_mm[(c + 2) % 3][k];
        squares[c] = lx_dot(sides[c], sides[c]);
        longest = squares[c] > squares[longest] ? c : longest;
    }
    *sheet = (struct lx_smooth_sheet){.type = LX_SHEET_TRIANGLE, .turn = 1};
    memcpy(sheet->center_mm, corners_mm[longest], sizeof sheet->center_mm);
    memcpy(sheet->across, sides[longest], sizeof sheet->across);
    sheet->half_mm[0] = lx_normalize(sheet->across) / 2;
    for (int k = 0; k < 3; k++)
        from[k] = (corners_mm[(longest + 1) % 3][k] + corners_mm[(longest + 2) % 3][k]) / 2 - sheet->center_mm[k];
    sheet->middle = lx_dot(from, sheet->across);
    for (int k = 0; k < 3; k++)
        sheet->upward[k] = from[k] - sheet->middle * sheet->across[k];
    sheet->half_mm[1] = lx_normalize(sheet->upward) / 2;
    lx_cross(sheet->across, sheet->upward, sheet->axis);
    return sheet->half_mm[1] > 1e-9 * sheet->half_mm[0];
}
