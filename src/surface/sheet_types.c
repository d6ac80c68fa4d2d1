/* SPDX-License-Identifier: MIT */
/* The types of sheets: coordinates, reach and what is turned to a place of plates, triangles, disks, tubes, balls. */
#include "sheet_types.h"

#include "../base/vector.h"

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

/* A place from the centre: along across, upward and the axis. */
static void find(const struct lx_smooth_sheet *sheet, const double place_mm[3], double at[3])
{
    const double from[3] = {place_mm[0] - sheet->center_mm[0], place_mm[1] - sheet->center_mm[1],
                            place_mm[2] - sheet->center_mm[2]};
    at[0] = lx_dot(from, sheet->across), at[1] = lx_dot(from, sheet->upward), at[2] = lx_dot(from, sheet->axis);
}

/* ---- plates ---- */

static double cross_plate(const struct lx_smooth_sheet *plate, const struct lx_sheet_line *s,
                          const struct lx_sheet_line *t, double place_mm[3], double normal[3])
{
    lay(plate, s->at * plate->half_mm[0], t->at * plate->half_mm[1], 0, place_mm);
    turn(plate, 0, 0, 1, normal);
    return plate->half_mm[0] * plate->half_mm[1];
}

static void locate_on_plate(const struct lx_smooth_sheet *plate, const double place_mm[3], double at[2])
{
    double place[3];
    find(plate, place_mm, place);
    for (int i = 0; i < 2; i++)
        at[i] = place[i] / plate->half_mm[i];
}

static double reach_of_plate(const struct lx_smooth_sheet *plate, const double direction[3])
{
    return fabs(lx_dot(direction, plate->across)) * plate->half_mm[0] +
           fabs(lx_dot(direction, plate->upward)) * plate->half_mm[1];
}

static void part_of_plate(const struct lx_smooth_sheet *plate, const double middle[2], const double half[2],
                          struct lx_sheet_part *part)
{
    (void)middle;
    for (int k = 0; k < 2; k++)
        part->lengths_mm[k] = plate->half_mm[k] * half[k];
    for (int i = 0; i < 3; i++) {
        part->first_mm[i] = part->lengths_mm[0] * plate->across[i];
        part->second_mm[i] = part->lengths_mm[1] * plate->upward[i];
    }
    part->radius_mm = hypot(part->lengths_mm[0], part->lengths_mm[1]);
    part->narrow = 1;
}

const struct lx_sheet_type lx_plate_sheet = {
    .corner_count = 4,
    .obstacle = LX_OBSTACLE_POLYGON,
    .cross = cross_plate,
    .locate = locate_on_plate,
    .reach = reach_of_plate,
    .part = part_of_plate,
    .rim = lx_rim_of_plate,
};

/* ---- triangles ---- */

static double cross_triangle(const struct lx_smooth_sheet *triangle, const struct lx_sheet_line *s,
                             const struct lx_sheet_line *t, double place_mm[3], double normal[3])
{
    const double away = (1 + t->at) / 2;
    lay(triangle, away * (triangle->middle + s->at * triangle->half_mm[0]), away * 2 * triangle->half_mm[1], 0,
        place_mm);
    turn(triangle, 0, 0, 1, normal);
    return away * triangle->half_mm[0] * triangle->half_mm[1];
}

static void locate_on_triangle(const struct lx_smooth_sheet *triangle, const double place_mm[3], double at[2])
{
    double place[3];
    find(triangle, place_mm, place);
    at[0] =
        place[1] > 0 ? (place[0] * 2 * triangle->half_mm[1] / place[1] - triangle->middle) / triangle->half_mm[0] : 0;
    at[1] = place[1] / triangle->half_mm[1] - 1;
}

static double reach_of_triangle(const struct lx_smooth_sheet *triangle, const double direction[3])
{
    const double a = lx_dot(direction, triangle->across), b = lx_dot(direction, triangle->upward);
    return fmax(0, a * triangle->middle + fabs(a) * triangle->half_mm[0] + 2 * b * triangle->half_mm[1]);
}

/* Between two ways from the tip, and two lines along the side across from it. */
static void part_of_triangle(const struct lx_smooth_sheet *triangle, const double middle[2], const double half[2],
                             struct lx_sheet_part *part)
{
    const double inner = fmax(1 + middle[1] - half[1], 0) / 2, outer = (1 + middle[1] + half[1]) / 2;
    const double aslant = triangle->middle + middle[0] * triangle->half_mm[0];
    const double across = outer * half[0] * triangle->half_mm[0];
    double squares[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        part->first_mm[i] = across * triangle->across[i];
        part->second_mm[i] =
            (outer - inner) / 2 * (aslant * triangle->across[i] + 2 * triangle->half_mm[1] * triangle->upward[i]);
        for (int k = 0; k < 2; k++) {
            const double corner = part->second_mm[i] + (k ? 1 : -1) * part->first_mm[i];
            squares[k] += corner * corner;
        }
    }
    part->lengths_mm[0] = across;
    part->lengths_mm[1] = sqrt(lx_dot(part->second_mm, part->second_mm));
    part->radius_mm = sqrt(fmax(squares[0], squares[1]));
    part->narrow = inner / outer;
}

const struct lx_sheet_type lx_triangle_sheet = {
    .corner_count = 3,
    .obstacle = LX_OBSTACLE_POLYGON,
    .cross = cross_triangle,
    .locate = locate_on_triangle,
    .reach = reach_of_triangle,
    .part = part_of_triangle,
};

/* ---- sectors of disks and tubes ---- */

static struct lx_sheet_line line_of_sector(const struct lx_smooth_sheet *sheet, int way, double at)
{
    if (way == 1)
        return (struct lx_sheet_line){.at = at};
    return (struct lx_sheet_line){at, cos(sheet->middle + LX_SECTOR * at), sin(sheet->middle + LX_SECTOR * at)};
}

/* The coordinate of an angle. */
static double along_sector(const struct lx_smooth_sheet *sheet, double y, double x)
{
    return remainder(atan2(y, x) - sheet->middle, 2 * M_PI) / LX_SECTOR;
}

static double cross_disk(const struct lx_smooth_sheet *disk, const struct lx_sheet_line *s,
                         const struct lx_sheet_line *t, double place_mm[3], double normal[3])
{
    const double radius = disk->half_mm[0], hole = disk->half_mm[1], away = hole + (radius - hole) * (1 + t->at) / 2;
    lay(disk, away * s->first, away * s->second, 0, place_mm);
    turn(disk, 0, 0, 1, normal);
    return away * LX_SECTOR * (radius - hole) / 2;
}

static void locate_on_disk(const struct lx_smooth_sheet *disk, const double place_mm[3], double at[2])
{
    double place[3];
    find(disk, place_mm, place);
    at[0] = along_sector(disk, place[1], place[0]);
    at[1] = 2 * (hypot(place[0], place[1]) - disk->half_mm[1]) / (disk->half_mm[0] - disk->half_mm[1]) - 1;
}

static double reach_of_disk(const struct lx_smooth_sheet *disk, const double direction[3])
{
    return disk->half_mm[0] * hypot(lx_dot(direction, disk->across), lx_dot(direction, disk->upward));
}

const struct lx_sheet_type lx_disk_sheet = {
    .obstacle = LX_OBSTACLE_DISK,
    .line = line_of_sector,
    .cross = cross_disk,
    .locate = locate_on_disk,
    .reach = reach_of_disk,
    .rim = lx_rim_of_disk,
};

static double cross_tube(const struct lx_smooth_sheet *tube, const struct lx_sheet_line *s,
                         const struct lx_sheet_line *t, double place_mm[3], double normal[3])
{
    const double radius = tube->half_mm[0];
    lay(tube, radius * s->first, radius * s->second, t->at * tube->half_mm[1], place_mm);
    turn(tube, s->first, s->second, 0, normal);
    return radius * LX_SECTOR * tube->half_mm[1];
}

static void locate_on_tube(const struct lx_smooth_sheet *tube, const double place_mm[3], double at[2])
{
    double place[3];
    find(tube, place_mm, place);
    at[0] = along_sector(tube, place[1], place[0]);
    at[1] = place[2] / tube->half_mm[1];
}

static double reach_of_tube(const struct lx_smooth_sheet *tube, const double direction[3])
{
    return reach_of_disk(tube, direction) + fabs(lx_dot(direction, tube->axis)) * tube->half_mm[1];
}

static void out_of_tube(const struct lx_smooth_sheet *tube, const double place_mm[3], double way[3])
{
    for (int i = 0; i < 3; i++)
        way[i] = place_mm[i] - tube->center_mm[i];
    const double along = lx_dot(way, tube->axis);
    for (int i = 0; i < 3; i++)
        way[i] -= along * tube->axis[i];
}

/* The part that is turned away from a place outside is on one side of the plane, or line, in which ways from there
 * touch it; from inside, or on it, all that is turned inwards is seen, and nothing of the rest. */
static enum lx_sheet_facing face_round(const struct lx_smooth_sheet *sheet, const double way[3], double normal[3],
                                       double through_mm[3])
{
    const double away = sqrt(lx_dot(way, way)), radius = sheet->half_mm[0];
    if (away <= radius * (1 + 1e-9))
        return sheet->turn < 0 ? LX_FACES_WHOLLY : LX_FACES_NOT;
    for (int i = 0; i < 3; i++) {
        through_mm[i] = sheet->center_mm[i] + way[i] / away * (radius * radius / away);
        normal[i] = way[i] * -sheet->turn;
    }
    return LX_FACES_PARTLY;
}

static enum lx_sheet_facing face_of_tube(const struct lx_smooth_sheet *tube, const double place_mm[3], double touch_mm,
                                         double normal[3], double through_mm[3])
{
    double from[3], way[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - tube->center_mm[i];
    out_of_tube(tube, place_mm, way);
    if (fabs(lx_dot(from, tube->axis)) <= tube->half_mm[1] + touch_mm && tube->turn < 0 &&
        sqrt(lx_dot(way, way)) > tube->half_mm[0] * (1 + 1e-9))
        return LX_FACES_NOT;
    return face_round(tube, way, normal, through_mm);
}

const struct lx_sheet_type lx_tube_sheet = {
    .bends = 1,
    .has_ends = true,
    .obstacle = LX_OBSTACLE_TUBE,
    .line = line_of_sector,
    .cross = cross_tube,
    .locate = locate_on_tube,
    .reach = reach_of_tube,
    .rim = lx_rim_of_tube,
    .outwards = out_of_tube,
    .facing = face_of_tube,
};

/* ---- balls ---- */

static struct lx_sheet_line line_of_ball(const struct lx_smooth_sheet *ball, int way, double at)
{
    (void)ball, (void)way;
    return (struct lx_sheet_line){.at = at, .first = tan(M_PI / 4 * at)};
}

static double cross_ball(const struct lx_smooth_sheet *ball, const struct lx_sheet_line *s,
                         const struct lx_sheet_line *t, double place_mm[3], double normal[3])
{
    const double x = s->first, y = t->first, square = 1 + x * x + y * y, length = sqrt(square);
    const double radius = ball->half_mm[0];
    lay(ball, radius * x / length, radius * y / length, radius / length, place_mm);
    turn(ball, x / length, y / length, 1 / length, normal);
    return radius * radius * (M_PI / 4) * (M_PI / 4) * (1 + x * x) * (1 + y * y) / (square * length);
}

static void locate_on_ball(const struct lx_smooth_sheet *ball, const double place_mm[3], double at[2])
{
    double place[3];
    find(ball, place_mm, place);
    for (int i = 0; i < 2; i++)
        at[i] = place[2] > 0 ? atan(place[i] / place[2]) * 4 / M_PI : 2;
}

static double reach_of_ball(const struct lx_smooth_sheet *ball, const double direction[3])
{
    (void)direction;
    return ball->half_mm[0];
}

/* The solid angle of the rectangle from (0, 0, 1) to (x, y, 1), seen from 0. */
static double angle_of_corner(double s, double t)
{
    const double x = tan(M_PI / 4 * s), y = tan(M_PI / 4 * t);
    return atan(x * y / sqrt(1 + x * x + y * y));
}

static double area_of_ball(const struct lx_smooth_sheet *ball, const double low[2], const double high[2])
{
    const double angle = angle_of_corner(high[0], high[1]) - angle_of_corner(low[0], high[1]) -
                         angle_of_corner(high[0], low[1]) + angle_of_corner(low[0], low[1]);
    return ball->half_mm[0] * ball->half_mm[0] * angle;
}

static void out_of_ball(const struct lx_smooth_sheet *ball, const double place_mm[3], double way[3])
{
    for (int i = 0; i < 3; i++)
        way[i] = place_mm[i] - ball->center_mm[i];
}

static double distance_of_ball(const struct lx_smooth_sheet *ball, const double place_mm[3])
{
    double way[3];
    out_of_ball(ball, place_mm, way);
    return fabs(sqrt(lx_dot(way, way)) - ball->half_mm[0]);
}

static enum lx_sheet_facing face_of_ball(const struct lx_smooth_sheet *ball, const double place_mm[3], double touch_mm,
                                         double normal[3], double through_mm[3])
{
    double way[3];
    (void)touch_mm;
    out_of_ball(ball, place_mm, way);
    const double away = sqrt(lx_dot(way, way)), radius = ball->half_mm[0];
    if (ball->turn < 0 ? away > radius * (1 + 1e-9) : away < radius * (1 - 1e-9))
        return LX_FACES_NOT;
    return face_round(ball, way, normal, through_mm);
}

/* Inside of a sphere cos cos' / (pi r^2) is the same between all places. */
static double exchange_in_ball(const struct lx_smooth_sheet *ball)
{
    const double radius = ball->half_mm[0];
    return ball->turn < 0 ? 1 / (4 * M_PI * radius * radius) : 0;
}

const struct lx_sheet_type lx_ball_sheet = {
    .bends = 2,
    .obstacle = LX_OBSTACLE_BALL,
    .line = line_of_ball,
    .cross = cross_ball,
    .locate = locate_on_ball,
    .reach = reach_of_ball,
    .rim = lx_rim_of_ball,
    .area = area_of_ball,
    .distance = distance_of_ball,
    .outwards = out_of_ball,
    .facing = face_of_ball,
    .exchange = exchange_in_ball,
};
