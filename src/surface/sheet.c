/* SPDX-License-Identifier: MIT */
/* Cutting surfaces into sheets, and what holds for those of all types. */
#include "sheet.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "sheet_types.h"

enum { CUBE = 6 };

static struct lx_smooth_sheet sheet_of(const struct lx_shape *shape, const struct lx_sheet_type *type)
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

/* The true size, without the room for rounding, which a wall shares with its neighbours. */
int lx_sheets_of_plate(const struct lx_shape *shape, struct lx_smooth_sheet *sheets)
{
    sheets[0] = sheet_of(shape, &lx_plate_sheet);
    for (int i = 0; i < 2; i++)
        sheets[0].half_mm[i] = shape->half_mm[i] - (shape->behind_mm > 0 ? shape->touch_mm / 2 : shape->touch_mm);
    return add_backs(sheets, 1);
}

int lx_sheets_of_sectors(const struct lx_shape *shape, const struct lx_sheet_type *type, double radius_mm,
                         double half_mm, struct lx_smooth_sheet *sheets)
{
    for (int i = 0; i < LX_SECTORS; i++) {
        sheets[i] = sheet_of(shape, type);
        sheets[i].half_mm[0] = radius_mm;
        sheets[i].half_mm[1] = half_mm;
        sheets[i].middle = (2 * i + 1) * LX_SECTOR;
    }
    return add_backs(sheets, LX_SECTORS);
}

int lx_sheets_of_ball(const struct lx_shape *shape, bool is_hollow, struct lx_smooth_sheet *sheets)
{
    for (int i = 0; i < CUBE; i++) {
        const double sign = i < CUBE / 2 ? 1 : -1;
        sheets[i] =
            (struct lx_smooth_sheet){.type = &lx_ball_sheet, .turn = is_hollow ? -1 : 1, .half_mm = {shape->radius_mm}};
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

double lx_sheet_place(const struct lx_smooth_sheet *sheet, double s, double t, double place_mm[3], double normal[3])
{
    const struct lx_sheet_line across = lx_sheet_line(sheet, 0, s), upward = lx_sheet_line(sheet, 1, t);
    return lx_sheet_cross(sheet, &across, &upward, place_mm, normal);
}

double lx_sheet_distance(const struct lx_smooth_sheet *sheet, const double place_mm[3])
{
    double from[3];
    if (sheet->type->bends > 0)
        return sheet->type->distance ? sheet->type->distance(sheet, place_mm) : 0;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - sheet->center_mm[i];
    return fabs(lx_dot(from, sheet->axis));
}

int lx_sheet_corners(const struct lx_smooth_sheet *sheet, double corners_mm[4][3])
{
    const int count = (int)sheet->type->corner_count;
    double normal[3];
    for (int k = 0; k < count; k++)
        lx_sheet_place(sheet, k == 0 || k == 3 ? -1 : 1, (count == 3 ? k < 2 : k >= 2) ? 1 : -1, corners_mm[k], normal);
    return count;
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
    *sheet = (struct lx_smooth_sheet){.type = &lx_triangle_sheet, .turn = 1};
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
