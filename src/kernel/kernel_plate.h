/* SPDX-License-Identifier: MIT */
/*
 * The geometry of plates for the kernels, in float64: the formulas of surface/rectangle.c, with unit axes.  Included
 * by kernel.c, once for an instruction set.
 */

/* Notes a place on the plane where it is on the plate, too. */
static inline __attribute__((always_inline)) double depth_on_plate(const struct lx_shape *plate, bool is_met,
                                                                   double depth, double x, double y, double z)
{
    double u = fabs(x * plate->across[0] + y * plate->across[1] + z * plate->across[2]);
    double v = fabs(x * plate->upward[0] + y * plate->upward[1] + z * plate->upward[2]);
    double inside = u <= plate->half_mm[0] ? depth : HUGE_VAL;
    inside = v <= plate->half_mm[1] ? inside : HUGE_VAL;
    return is_met ? inside : HUGE_VAL;
}

/* Seen along -z: the place is (dx, dy, -(nx dx + ny dy)/nz), if it is turned this way. */
struct plate_row {
    double x, dy;           /* of the centre, and from it */
    double slope_x, height; /* the height is slope_x dx + height */
    bool is_met;
};

static struct plate_row plate_row_of(const struct lx_shape *plate, const struct lx_row_view *view)
{
    const double dy = view->y_mm - plate->anchor_mm[1];
    const bool is_met = plate->axis[2] > 0;
    return (struct plate_row){.x = plate->anchor_mm[0],
                              .dy = dy,
                              .slope_x = is_met ? -plate->axis[0] / plate->axis[2] : 0,
                              .height = is_met ? -plate->axis[1] / plate->axis[2] * dy : 0,
                              .is_met = is_met};
}

static void meet_plate_parallel(const struct lx_shape *plate, const struct lx_row_view *view,
                                const double *restrict x_mm, size_t count, double *restrict depth, double *restrict px,
                                double *restrict py, double *restrict pz)
{
    const struct lx_shape shape = *plate;
    const struct plate_row row = plate_row_of(plate, view);
    const double top = view->observer_z_mm - shape.anchor_mm[2];
    for (size_t i = 0; i < count; i++) {
        double dx = x_mm[i] - row.x, height = row.slope_x * dx + row.height;
        depth[i] = depth_on_plate(&shape, row.is_met, top - height, dx, row.dy, height);
        px[i] = dx;
        py[i] = row.dy;
        pz[i] = height;
    }
}

static void fill_plate(const struct lx_shape *plate, const struct plate_row row, const struct lx_columns *columns,
                       size_t first, size_t count, struct lx_block_single *restrict block)
{
    const float nx = (float)plate->axis[0], ny = (float)plate->axis[1], nz = (float)plate->axis[2];
    const float dy = (float)row.dy;
    for (size_t i = 0; i < count; i++) {
        block->px[i] = columns->px[first + i];
        block->pz[i] = (float)(row.slope_x * (columns->x_mm[first + i] - row.x) + row.height);
    }
    for (size_t i = 0; i < count; i++) {
        block->py[i] = dy;
        block->nx[i] = nx, block->ny[i] = ny, block->nz[i] = nz;
    }
}

static struct lx_stretch view_plate(const struct lx_shape *plate, const struct lx_row_view *view,
                                    const struct lx_columns *columns, struct lx_block_single *block, uint8_t *mask)
{
    const struct lx_shape shape = *plate;
    const struct plate_row row = plate_row_of(plate, view);
    const size_t count = columns->count;
    double depth[LX_BLOCK], farthest = 0;
    for (size_t i = 0; i < lx_padded(count); i++) {
        double dx = columns->x_mm[i] - row.x, height = row.slope_x * dx + row.height;
        depth[i] = depth_on_plate(&shape, row.is_met, 0, dx, row.dy, height);
        farthest = depth[i] > farthest ? depth[i] : farthest;
    }
    struct lx_stretch stretch = {0};
    if (farthest < HUGE_VAL)
        stretch = whole_stretch(count, mask);
    for (size_t i = 0; i < count && stretch.met < count; i += LX_LANES)
        extend_by_depth(&stretch, depth + i, i, count - i < LX_LANES ? count - i : LX_LANES, mask);
    fill_plate(plate, row, columns, stretch.first, lx_padded(stretch.count), block);
    return stretch;
}

/* Seen from a point: c from the centre to the observer, d the line; the place is n x (c x d) / (n.d). */
static void meet_plate_central(const struct lx_shape *plate, const struct lx_row_view *view,
                               const double *restrict x_mm, size_t count, double *restrict depth, double *restrict px,
                               double *restrict py, double *restrict pz)
{
    const struct lx_shape shape = *plate;
    const double nx = shape.axis[0], ny = shape.axis[1], nz = shape.axis[2];
    const double cx = -shape.anchor_mm[0], cy = -shape.anchor_mm[1], cz = view->observer_z_mm - shape.anchor_mm[2];
    const double dy = view->y_mm, dz = -view->observer_z_mm;
    const double above = nx * cx + ny * cy + nz * cz;
    for (size_t i = 0; i < count; i++) {
        double dx = x_mm[i];
        double wx = cy * dz - cz * dy, wy = cz * dx - cx * dz, wz = cx * dy - cy * dx;
        double along = nx * dx + ny * dy + nz * dz;
        bool is_met = (above > 0) & (along < 0);
        double inverse = 1 / (is_met ? along : -1);
        double x = (ny * wz - nz * wy) * inverse;
        double y = (nz * wx - nx * wz) * inverse;
        double z = (nx * wy - ny * wx) * inverse;
        depth[i] = depth_on_plate(&shape, is_met, -above * inverse, x, y, z);
        px[i] = x;
        py[i] = y;
        pz[i] = z;
    }
}

static size_t meet_plate(const struct lx_shape *plate, const struct lx_row_view *view, const double *x_mm, size_t count,
                         double *depth, double *px, double *py, double *pz)
{
    if (view->perspective)
        meet_plate_central(plate, view, x_mm, lx_padded(count), depth, px, py, pz);
    else
        meet_plate_parallel(plate, view, x_mm, lx_padded(count), depth, px, py, pz);
    return count_met(depth, count);
}

static void complete_plate(const struct lx_shape *plate, const double *observer_mm, struct lx_block_double *block,
                           struct lx_block_single *copy, size_t count)
{
    count = lx_padded(count);
    for (size_t i = 0; i < count; i++) {
        block->nx[i] = plate->axis[0];
        block->ny[i] = plate->axis[1];
        block->nz[i] = plate->axis[2];
    }
    finish_block(observer_mm, block, copy, count);
}

/* As plate_blocks() of surface/rectangle.c: the heights of both ends, and the offsets where the way crosses. */
static void block_by_plate(const struct lx_blocker *blocker, const struct lx_block_double *block, size_t count,
                           float *restrict open)
{
    const struct lx_shape shape = blocker->shape;
    const double *n = shape.axis, *u = shape.across, *v = shape.upward, *c = shape.anchor_mm, *light = blocker->light;
    const double is_place = blocker->is_point ? 1 : 0, touch = shape.touch_mm;
    const double lx = light[0] - is_place * c[0], ly = light[1] - is_place * c[1], lz = light[2] - is_place * c[2];
    const double end = n[0] * lx + n[1] * ly + n[2] * lz, end_touch = is_place * touch;
    /* the side on which starts have the plate before the end; none where the end lies on the plate */
    const double side = end > end_touch ? -1 : end < -end_touch ? 1 : 0;
    count = lx_padded(count);
    for (size_t i = 0; i < count; i++) {
        double x = block->px[i] - c[0], y = block->py[i] - c[1], z = block->pz[i] - c[2];
        double tx = lx - is_place * x, ty = ly - is_place * y, tz = lz - is_place * z;
        double start = n[0] * x + n[1] * y + n[2] * z, change = n[0] * tx + n[1] * ty + n[2] * tz;
        double across = (u[0] * x + u[1] * y + u[2] * z) * change - start * (u[0] * tx + u[1] * ty + u[2] * tz);
        double upward = (v[0] * x + v[1] * y + v[2] * z) * change - start * (v[0] * tx + v[1] * ty + v[2] * tz);
        double scale = fabs(change);
        float blocked = side * start > touch ? 0 : open[i];
        blocked = fabs(across) <= shape.half_mm[0] * scale ? blocked : open[i];
        open[i] = fabs(upward) <= shape.half_mm[1] * scale ? blocked : open[i];
    }
}
