/* SPDX-License-Identifier: MIT */
/*
 * Tiles at first.  The light that is reflected has kinks and jumps on a face where other surfaces stand on it, and
 * changes fast where they come near: the face is cut along the outlines of these, and graded towards all edges.
 */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../surface/mesh_faces.h"
#include "between.h"
#include "box.h"
#include "doubt.h"
#include "group.h"
#include "overlap.h"
#include "solution.h"

enum { MOST_MARKS = 128 };
/* The number of triangles of a mesh from which on they are small. */
enum { MANY = 150 };

/* Light has kinks where surfaces stand on a face, or almost: no farther from it than these shares of their size.  Up to
 * a greater share they darken a place as small as they are, and between things all is darker still; places of windows
 * that are larger than it by a factor would miss that. */
static const double STANDS = 0.15, MESH_STANDS = 0.05, OVER = 0.8, LARGER = 2;

/* ---- marks ---- */

/* Where another surface comes near to a face: a rectangle of its coordinates, or a line or a point. */
struct marks {
    int count;
    double low[MOST_MARKS][2], high[MOST_MARKS][2];
    bool is_over[MOST_MARKS]; /* it does not stand there: large windows alone are cut */
};

/* Adds a mark, of which the face has but what lies on it. */
static void add_mark(struct marks *marks, const double low[2], const double high[2], bool is_over)
{
    if (marks->count == MOST_MARKS)
        return;
    for (int k = 0; k < 2; k++) {
        if (!(low[k] < 1 && high[k] > -1))
            return;
        marks->low[marks->count][k] = fmax(low[k], -1);
        marks->high[marks->count][k] = fmin(high[k], 1);
    }
    marks->is_over[marks->count++] = is_over;
}

/* How high a place lies over a plate, and where on it. */
static double stand(const struct lx_matte_face *plate, const double place_mm[3], double at[2])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - plate->sheet.center_mm[i];
    lx_sheet_locate(&plate->sheet, place_mm, at);
    return plate->sheet.turn * lx_dot(from, plate->sheet.axis);
}

/* The corners of a surface, of which a face is the first, that are no higher over another one than this. */
static void mark_corners(const struct lx_radiosity *reflected, const struct lx_matte_face *face, size_t first,
                         const double heights_mm[2], bool is_over, struct marks *marks)
{
    const size_t surface = reflected->faces[first].surface;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t f = first; f < reflected->face_count && reflected->faces[f].surface == surface; f++) {
        double corners[4][3], at[2];
        const int count = lx_sheet_corners(&reflected->faces[f].sheet, corners);
        for (int c = 0; c < count; c++) {
            const double height = stand(face, corners[c], at);
            for (int i = 0; i < 2 && height >= heights_mm[0] && height <= heights_mm[1]; i++) {
                low[i] = fmin(low[i], at[i]);
                high[i] = fmax(high[i], at[i]);
            }
        }
    }
    add_mark(marks, low, high, is_over);
}

/* A plate or a mesh. */
static void mark_straight(const struct lx_radiosity *reflected, const struct lx_matte_face *face, size_t first,
                          double least_mm, struct marks *marks)
{
    const struct lx_matte_face *other = &reflected->faces[first];
    const double size = other->is_facet ? reflected->prepared->surfaces[other->surface].shape.radius_mm
                                        : fmax(other->size_mm[0], other->size_mm[1]);
    const double stands[2] = {-least_mm, (other->is_facet ? MESH_STANDS : STANDS) * size};
    const double over[2] = {-least_mm, OVER * size};
    mark_corners(reflected, face, first, stands, false, marks);
    mark_corners(reflected, face, first, over, true, marks);
}

/* A ball touches a plate at a point, what else is round along its outline. */
static void mark_round(const struct lx_matte_face *face, const struct lx_matte_face *other, double least_mm,
                       struct marks *marks)
{
    const struct lx_smooth_sheet *sheet = &other->sheet;
    const double radius = sheet->half_mm[0], turn = -face->sheet.turn;
    const double down[3] = {turn * face->sheet.axis[0], turn * face->sheet.axis[1], turn * face->sheet.axis[2]};
    double at[2], low[2], high[2];
    const double gap = stand(face, sheet->center_mm, at) - sheet->type->reach(sheet, down);
    if (gap < -least_mm || gap > OVER * 2 * radius)
        return;
    const bool is_over = gap > STANDS * 2 * radius;
    for (int i = 0; i < 2; i++) {
        const double beside = sheet->type->bends == 2 && !is_over ? 0 : radius / face->sheet.half_mm[i];
        low[i] = at[i] - beside;
        high[i] = at[i] + beside;
    }
    add_mark(marks, low, high, is_over);
}

static void find_marks(const struct lx_radiosity *reflected, const struct lx_matte_face *face, struct marks *marks)
{
    const double least_mm = 1e-9 * reflected->size_mm;
    size_t last = SIZE_MAX;
    marks->count = 0;
    for (size_t f = 0; f < reflected->face_count && lx_is_rectangle(face); f++) {
        const struct lx_matte_face *other = &reflected->faces[f];
        if (other->surface == face->surface || other->surface == last)
            continue;
        last = other->surface; /* one of its sheets tells for all */
        if (lx_is_polygon(other))
            mark_straight(reflected, face, f, least_mm, marks);
        else
            mark_round(face, other, least_mm, marks);
    }
}

/* ---- cutting ---- */

/* A face that is cut. */
struct cutting {
    struct lx_radiosity *reflected;
    uint32_t face;
    double scale_mm; /* of the largest faces */
    struct marks marks;
};

/* Part i, low or high, of a window that is cut across direction `way`. */
static struct lx_window part_of(const struct lx_window *window, int way, double at, int i)
{
    struct lx_window part = *window;
    const double low = i ? at : window->middle[way] - window->half[way];
    const double high = i ? window->middle[way] + window->half[way] : at;
    part.middle[way] = (low + high) / 2;
    part.half[way] = (high - low) / 2;
    return part;
}

/* The line of a mark that cuts a window best: near to its middle.  False: no mark crosses it. */
static bool find_line(const struct cutting *cutting, const struct lx_window *window, int *way, double *at)
{
    const struct marks *marks = &cutting->marks;
    const double least = 1e-6;
    double best = 1 - least;
    for (int m = 0; m < marks->count; m++)
        for (int k = 0; k < 4; k++) {
            const int across = k & 1, along = 1 - across;
            const double line = k & 2 ? marks->high[m][across] : marks->low[m][across];
            const double off = fabs(line - window->middle[across]) / window->half[across];
            const double overlap = fmin(marks->high[m][along], window->middle[along] + window->half[along]) -
                                   fmax(marks->low[m][along], window->middle[along] - window->half[along]);
            const double extent = marks->high[m][across] - marks->low[m][across];
            const bool is_line = marks->high[m][along] - marks->low[m][along] < least;
            if (marks->is_over[m] && window->half[across] < LARGER * extent / 2)
                continue;
            if (overlap < (is_line ? -least : least) || off >= best || (1 - off) * window->half[across] < least)
                continue;
            best = off;
            *way = across;
            *at = line;
        }
    return best < 1 - least;
}

/* Cells along a window, counted from its middle, which lie between lines that are graded towards the edges: of four
 * each half is cut again, near to the edge, which is `edge`. */
struct grading {
    int cells[2], edge[2];
};

static int grade(const struct cutting *cutting, const struct lx_window *window, uint32_t parent, struct grading grading)
{
    const double beside = 0.75; /* where the outer part of a half begins, from -1 to 1 */
    const uint32_t group = lx_group_add(cutting->reflected, cutting->face, parent, window);
    const int way = grading.cells[1] > grading.cells[0], cells = grading.cells[way];
    if (group == LX_NO_GROUP)
        return -1;
    if (cells == 1)
        return 0;
    const double at = window->middle[way] + grading.edge[way] * beside * window->half[way];
    for (int i = 0; i < 2; i++) {
        const struct lx_window part = part_of(window, way, at, i);
        struct grading next = grading;
        next.cells[way] = cells / 2;
        next.edge[way] = i ? 1 : -1;
        if (grade(cutting, &part, group, next))
            return -1;
    }
    return 0;
}

static int cut_window(const struct cutting *cutting, const struct lx_window *window, uint32_t parent)
{
    const struct lx_matte_face *face = &cutting->reflected->faces[cutting->face];
    struct grading grading = {{1, 1}, {0, 0}};
    int way = 0;
    double at = 0;
    if (!find_line(cutting, window, &way, &at)) {
        for (int k = 0; k < 2; k++) {
            const double length = window->half[k] * face->size_mm[k] / cutting->scale_mm;
            grading.cells[k] = length > 0.5 && lx_is_rectangle(face) ? 4 : length > 0.15 ? 2 : 1;
        }
        return grade(cutting, window, parent, grading);
    }
    const uint32_t group = lx_group_add(cutting->reflected, cutting->face, parent, window);
    if (group == LX_NO_GROUP)
        return -1;
    for (int i = 0; i < 2; i++) {
        const struct lx_window part = part_of(window, way, at, i);
        if (cut_window(cutting, &part, group))
            return -1;
    }
    return 0;
}

static int cut_face(struct lx_radiosity *reflected, uint32_t f, double scale_mm)
{
    const struct lx_window whole = {{0, 0}, {1, 1}};
    struct cutting cutting = {.reflected = reflected, .face = f, .scale_mm = scale_mm};
    find_marks(reflected, &reflected->faces[f], &cutting.marks);
    return cut_window(&cutting, &whole, LX_NO_GROUP);
}

/* ---- faces ---- */

/* First all fronts of a mesh, then all backs; what is there twice, as both sides of a sheet may be, reflects once. */
static int add_triangles(struct lx_radiosity *reflected, size_t s)
{
    const struct lx_prepared_surface *surface = &reflected->prepared->surfaces[s];
    const size_t count = lx_mesh_count(&surface->shape);
    bool *repeated = count > 0 ? lx_mesh_repeated(&surface->shape) : NULL;
    if (!repeated)
        return count > 0 ? -1 : 0;
    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < count; i++) {
            struct lx_smooth_sheet sheet;
            if (repeated[i] || !lx_mesh_sheet(&surface->shape, i, &sheet))
                continue;
            struct lx_matte_face *face = &reflected->faces[reflected->face_count++];
            sheet.turn = side == 0 ? 1 : -1;
            lx_face_make(&sheet, s, surface->material->diffuse, face);
            face->is_facet = true;
            face->triangle = (uint32_t)i;
            face->is_small = count > MANY;
        }
    free(repeated);
    return 0;
}

static int add_faces(struct lx_radiosity *reflected, size_t s)
{
    const struct lx_prepared_surface *surface = &reflected->prepared->surfaces[s];
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    const int count = lx_shape_sheets(&surface->shape, sheets);
    for (int i = 0; i < count; i++) {
        struct lx_matte_face *face = &reflected->faces[reflected->face_count++];
        lx_face_make(&sheets[i], s, surface->material->diffuse, face);
        reflected->has_round_faces = reflected->has_round_faces || !face->is_flat;
    }
    return add_triangles(reflected, s);
}

/* How far before the plane of a flat face anything of the other one is. */
static double highest_over(const struct lx_matte_face *flat, const struct lx_matte_face *other)
{
    const struct lx_smooth_sheet *plane = &flat->sheet;
    double normal[3];
    for (int i = 0; i < 3; i++)
        normal[i] = plane->turn * plane->axis[i];
    return lx_face_reach(other, normal, plane->center_mm);
}

bool lx_faces_meet(const struct lx_matte_face *a, const struct lx_matte_face *b)
{
    const double least = 1e-9;
    if (a->is_flat && highest_over(a, b) <= least * (a->radius_mm + b->radius_mm))
        return false;
    return !(b->is_flat && highest_over(b, a) <= least * (a->radius_mm + b->radius_mm));
}

/*
 * Leaves out what nothing sees: a flat face that meets no other one, as the outside of a room, and has no place before
 * it that is asked.  Nothing is reflected to it, and nobody receives its light.  Where no places are asked all stay:
 * means are of all sides, and whoever has a picture may ask at any place later.
 */
static int leave_out(struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    const size_t count = reflected->face_count;
    if (request->place_count == 0)
        return 0;
    bool *stays = lx_new_array(count, sizeof *stays);
    reflected->left_out = lx_new_array(count, sizeof *reflected->left_out);
    int failed = stays && reflected->left_out ? 0 : -1;
    for (size_t f = 0; f < count && !failed; f++) {
        const struct lx_matte_face *face = &reflected->faces[f];
        stays[f] = !face->is_flat;
        for (size_t g = 0; g < count && !stays[f]; g++)
            stays[f] = g != f && lx_faces_meet(face, &reflected->faces[g]);
        for (size_t p = 0; p < request->place_count && !stays[f]; p++)
            stays[f] = lx_looks_at(&request->places[p].receiver, face);
        if (!stays[f])
            reflected->left_out[reflected->left_out_count++] = *face;
    }
    if (!failed && reflected->left_out_count > 0) {
        failed = lx_groups_drop(reflected, stays);
        lx_overlap_find(reflected);
    }
    free(stays);
    return failed;
}

int lx_tiling_make(struct lx_radiosity *reflected, const struct lx_reflected_request *request)
{
    const size_t surfaces = reflected->prepared->surface_count;
    size_t most = surfaces * LX_MOST_SHEETS;
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, square = 0, area = 0;
    for (size_t s = 0; s < surfaces; s++)
        most += 2 * lx_mesh_count(&reflected->prepared->surfaces[s].shape);
    reflected->faces = lx_new_array(most, sizeof *reflected->faces);
    if (!reflected->faces)
        return -1;
    for (size_t s = 0; s < surfaces; s++) {
        if (add_faces(reflected, s))
            return -1;
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], reflected->prepared->surfaces[s].low_mm[i]);
            high[i] = fmax(high[i], reflected->prepared->surfaces[s].high_mm[i]);
        }
    }
    for (int i = 0; i < 3; i++)
        square += (high[i] - low[i]) * (high[i] - low[i]);
    reflected->size_mm = sqrt(square);
    for (size_t f = 0; f < reflected->face_count; f++)
        area = fmax(area, reflected->faces[f].size_mm[0] * reflected->faces[f].size_mm[1]);
    lx_overlap_find(reflected);
    if (lx_closed_boxes_find(reflected))
        return -1;
    for (size_t f = 0; f < reflected->face_count; f++)
        if (cut_face(reflected, (uint32_t)f, sqrt(area)))
            return -1;
    return lx_groups_number(reflected) || leave_out(reflected, request) ? -1 : 0;
}

/* Whether a face is of the inner side of a closed mesh. */
static bool is_inner(const struct lx_radiosity *reflected, const struct lx_matte_face *face)
{
    const struct lx_shape *shape = &reflected->prepared->surfaces[face->surface].shape;
    const struct lx_mesh_body *body = shape->body;
    return face->is_facet && body->encloses && (face->sheet.turn > 0) == body->looks_inwards;
}

/* The inner side of a closed mesh has no light unless something in it has. */
static void darken_insides(const struct lx_radiosity *reflected, const bool *is_lit, bool *stays)
{
    for (size_t s = 0; s < reflected->prepared->surface_count; s++) {
        const struct lx_shape *shape = &reflected->prepared->surfaces[s].shape;
        bool has_light = lx_mesh_count(shape) == 0;
        for (size_t f = 0; f < reflected->face_count && !has_light; f++) {
            const struct lx_matte_face *face = &reflected->faces[f];
            has_light = is_lit[f] && (face->surface == s ? is_inner(reflected, face)
                                                         : lx_mesh_encloses(shape, face->cell.center_mm));
        }
        for (size_t f = 0; f < reflected->face_count && !has_light; f++)
            stays[f] = stays[f] && !(reflected->faces[f].surface == s && is_inner(reflected, &reflected->faces[f]));
    }
}

int lx_tiling_drop(struct lx_radiosity *reflected, const bool *is_lit)
{
    bool *stays = lx_new_array(reflected->face_count, sizeof *stays);
    if (!stays)
        return -1;
    for (size_t f = 0; f < reflected->face_count; f++) {
        stays[f] = is_lit[f];
        for (size_t g = 0; g < reflected->face_count && !stays[f]; g++)
            stays[f] = g != f && lx_faces_meet(&reflected->faces[f], &reflected->faces[g]);
    }
    darken_insides(reflected, is_lit, stays);
    lx_closed_boxes_darken(reflected, stays);
    const int failed = lx_groups_drop(reflected, stays);
    free(stays);
    lx_overlap_find(reflected); /* the inner bottom of a box, which lies on what the box stands on, may be gone */
    return failed;
}
