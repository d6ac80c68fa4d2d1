/* SPDX-License-Identifier: MIT */
/* Shafts between boxes along the axes. */
#include "shaft.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "region.h"
#include "solution.h"

/* The least and the greatest coordinates, of what is inside. */
struct box {
    double ends[2][3];
};

/* Whether a box is wholly on the outer side of a line that has both ends of a shaft on its other side, seen along an
 * axis: the line through a corner of one end and the same corner of the other. */
static bool is_beyond_line(const struct box *a, const struct box *b, const struct box *box, int x, int y,
                           double touch_mm)
{
    for (int corner = 0; corner < 4; corner++) {
        const int i = corner & 1, j = corner >> 1;
        const double px = a->ends[i][x], py = a->ends[j][y];
        double nx = b->ends[j][y] - py, ny = px - b->ends[i][x]; /* at right angles to the line */
        const double length = hypot(nx, ny);
        if (!(length > touch_mm))
            continue;
        const double outwards = (nx * (i ? 1 : -1) + ny * (j ? 1 : -1)) < 0 ? -1 : 1;
        nx *= outwards / length;
        ny *= outwards / length;
        /* the corners of both ends that are farthest outwards, and that of the box that is least so */
        const int sx = nx > 0, sy = ny > 0;
        const double a_most = nx * (a->ends[sx][x] - px) + ny * (a->ends[sy][y] - py);
        const double b_most = nx * (b->ends[sx][x] - px) + ny * (b->ends[sy][y] - py);
        const double least = nx * (box->ends[!sx][x] - px) + ny * (box->ends[!sy][y] - py);
        if (fmax(a_most, b_most) <= touch_mm && least > 2 * touch_mm)
            return true;
    }
    return false;
}

static bool is_beyond(const struct box *a, const struct box *b, const struct box *box, double touch_mm)
{
    for (int i = 0; i < 3; i++)
        if (box->ends[0][i] > fmax(a->ends[1][i], b->ends[1][i]) + touch_mm ||
            box->ends[1][i] < fmin(a->ends[0][i], b->ends[0][i]) - touch_mm ||
            is_beyond_line(a, b, box, i, (i + 1) % 3, touch_mm))
            return true;
    return false;
}

static struct box box_of(const struct lx_tile_cell *cell)
{
    const bool is_flat = cell->first_mm[0] != 0 || cell->first_mm[1] != 0 || cell->first_mm[2] != 0;
    struct box box;
    for (int i = 0; i < 3; i++) {
        const double reach = is_flat ? fabs(cell->first_mm[i]) + fabs(cell->second_mm[i]) : cell->radius_mm;
        box.ends[0][i] = cell->center_mm[i] - reach;
        box.ends[1][i] = cell->center_mm[i] + reach;
    }
    return box;
}

static struct box box_of_surface(const struct lx_prepared_surface *surface)
{
    struct box box;
    for (int i = 0; i < 3; i++) {
        box.ends[0][i] = surface->low_mm[i];
        box.ends[1][i] = surface->high_mm[i];
    }
    return box;
}

/* Surfaces that may stand between two boxes, of which one holds surface `own`. */
static void list_between(const struct lx_prepared *prepared, const struct box *from, const struct box *to, size_t own,
                         double touch_mm, struct lx_shafts *shafts, size_t *count)
{
    for (size_t s = 0; s < prepared->surface_count; s++) {
        const struct box box = box_of_surface(&prepared->surfaces[s]);
        if (s == own || !is_beyond(from, to, &box, touch_mm))
            shafts->surfaces[(*count)++] = (uint32_t)s;
    }
}

/* Leaves out the meshes that are not in the hull of a cell and a face. */
static void leave_meshes_out(const struct lx_prepared *prepared, const struct lx_tile_cell *cell,
                             const struct lx_matte_face *face, double touch_mm, struct lx_shafts *shafts, size_t first,
                             size_t *count)
{
    size_t kept = first;
    for (size_t i = first; i < *count; i++) {
        const struct lx_shape *shape = &prepared->surfaces[shafts->surfaces[i]].shape;
        if (lx_mesh_count(shape) == 0 || !lx_hull_is_free(shape, cell, face, touch_mm))
            shafts->surfaces[kept++] = shafts->surfaces[i];
    }
    *count = kept;
}

int lx_shafts_set(const struct lx_radiosity *reflected, const struct lx_tile_cell *cell, struct lx_shafts *shafts)
{
    const struct lx_prepared *prepared = reflected->prepared;
    const size_t surfaces = prepared->surface_count;
    const double touch_mm = 1e-9 * reflected->size_mm;
    const bool is_polygon = cell->first_mm[0] != 0 || cell->first_mm[1] != 0 || cell->first_mm[2] != 0;
    const struct box from = box_of(cell);
    size_t count = 0, mesh_first = 0, mesh_last = 0;
    if (lx_reserve(&shafts->of, &shafts->face_capacity, reflected->face_count, sizeof *shafts->of))
        return -1;
    for (size_t f = 0; f < reflected->face_count; f++) {
        const struct lx_matte_face *face = &reflected->faces[f];
        const bool has_hull = is_polygon && lx_is_polygon(face);
        struct lx_shaft_list *list = &shafts->of[f];
        if (lx_reserve(&shafts->surfaces, &shafts->capacity, count + 2 * surfaces, sizeof *shafts->surfaces))
            return -1;
        if (face->is_facet && (f == 0 || face->surface != reflected->faces[f - 1].surface)) {
            /* all of its triangles go together; from here each takes what is in its own way */
            const struct box to = box_of_surface(&prepared->surfaces[face->surface]);
            mesh_first = count;
            list_between(prepared, &from, &to, face->surface, touch_mm, shafts, &count);
            mesh_last = count;
        }
        *list = (struct lx_shaft_list){count, count, has_hull && !lx_cell_meets_face(cell, face, touch_mm)};
        if (list->is_none)
            continue;
        if (face->is_facet) {
            for (size_t i = mesh_first; i < mesh_last; i++)
                shafts->surfaces[count++] = shafts->surfaces[i];
        } else {
            const struct box to = box_of(&face->cell);
            list_between(prepared, &from, &to, face->surface, touch_mm, shafts, &count);
        }
        if (has_hull)
            leave_meshes_out(prepared, cell, face, touch_mm, shafts, list->first, &count);
        list->last = count;
    }
    return 0;
}

void lx_shafts_clear(struct lx_shafts *shafts)
{
    free(shafts->of);
    free(shafts->surfaces);
    *shafts = (struct lx_shafts){0};
}
