/* SPDX-License-Identifier: MIT */
/*
 * Facets of a mesh: whether it is the closed shell of a convex body whose faces look outwards.  Corners at the same
 * place are one corner.  Convex is what has every corner behind the plane of every face; a tree of boxes around the
 * corners keeps that quick.
 */
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "facets_make.h"

static const struct lx_shape_report GOOD = {LX_SHAPE_GOOD, 0, 0}, NO_MEMORY = {LX_SHAPE_OUT_OF_MEMORY, 0, 0};

/* ---- the tree of corners ---- */

enum { LEAF = 8 };

struct place {
    double at[3];
    unsigned corner;
};

struct box {
    double low[3], high[3];
    size_t first, count; /* of the places in it */
    size_t beyond;       /* the box after this one and all within it; a box's first part follows it directly */
};

struct tree {
    struct place *places;
    struct box *boxes;
    size_t box_count;
};

static struct box box_around(const struct place *places, size_t first, size_t count)
{
    struct box box = {.low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, .high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    box.first = first;
    box.count = count;
    for (size_t i = first; i < first + count; i++)
        for (int k = 0; k < 3; k++) {
            box.low[k] = fmin(box.low[k], places[i].at[k]);
            box.high[k] = fmax(box.high[k], places[i].at[k]);
        }
    return box;
}

/* Sorts the places of a box by the half of its longest side that they lie in; the number of those in the lower half. */
static size_t divide(struct place *places, const struct box *box)
{
    int longest = 0;
    for (int k = 1; k < 3; k++)
        if (box->high[k] - box->low[k] > box->high[longest] - box->low[longest])
            longest = k;
    double middle = box->low[longest] / 2 + box->high[longest] / 2;
    size_t low = box->first, high = box->first + box->count;
    while (low < high)
        if (places[low].at[longest] < middle) {
            low++;
        } else {
            struct place moved = places[low];
            places[low] = places[--high];
            places[high] = moved;
        }
    size_t lower = low - box->first;
    return lower > 0 && lower < box->count ? lower : box->count / 2;
}

static void grow(struct tree *tree, size_t first, size_t count)
{
    size_t index = tree->box_count++;
    tree->boxes[index] = box_around(tree->places, first, count);
    if (count > LEAF) {
        size_t lower = divide(tree->places, &tree->boxes[index]);
        grow(tree, first, lower);
        grow(tree, first + lower, count - lower);
    }
    tree->boxes[index].beyond = tree->box_count;
}

/* The places of all corners are there. */
static void grow_tree(struct tree *tree, size_t count)
{
    tree->box_count = 0;
    grow(tree, 0, count);
}

/* How far corners may lie before a plane that was laid through a face. */
struct reach {
    double normal[3];
    double plane;     /* of the face, along the normal */
    double tolerance; /* at the face */
    double center[3]; /* of the face */
    double slope;     /* more for each mm of distance from it, since a plane through rounded corners is tilted */
};

static double allowed_at(const struct reach *reach, const double at[3])
{
    if (reach->slope == 0)
        return reach->tolerance;
    double x = at[0] - reach->center[0], y = at[1] - reach->center[1], z = at[2] - reach->center[2];
    return reach->tolerance + reach->slope * sqrt(x * x + y * y + z * z);
}

/* A corner that lies farther before the plane than it may, and how far it does, or -1. */
static long find_beyond(const struct tree *tree, const struct reach *reach, double *off)
{
    const double *normal = reach->normal, limit = reach->plane + reach->tolerance;
    for (size_t i = 0; i < tree->box_count;) {
        const struct box *box = &tree->boxes[i];
        double farthest = 0;
        for (int k = 0; k < 3; k++)
            farthest += normal[k] * (normal[k] > 0 ? box->high[k] : box->low[k]);
        if (farthest <= limit) {
            i = box->beyond;
            continue;
        }
        bool is_leaf = box->count <= LEAF;
        for (size_t n = box->first; is_leaf && n < box->first + box->count; n++) {
            const double *at = tree->places[n].at;
            *off = normal[0] * at[0] + normal[1] * at[1] + normal[2] * at[2] - reach->plane;
            if (*off > reach->tolerance && *off > allowed_at(reach, at))
                return (long)tree->places[n].corner;
        }
        i++;
    }
    return -1;
}

/* ---- corners ---- */

static int by_place(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    for (int k = 0; k < 3; k++)
        if (x->at[k] != y->at[k])
            return x->at[k] < y->at[k] ? -1 : 1;
    return (x->corner > y->corner) - (x->corner < y->corner);
}

/* A mesh as it was given, and what becomes of it. */
struct mesh {
    const double (*corners_mm)[3];
    const unsigned *loop, *counts;
    size_t corner_count, face_count, loop_count;
    unsigned *numbers; /* of a given corner: its number among those that are kept */
    struct lx_shape_rounding *rounding;
    struct lx_facets *facets;
    struct tree tree;
};

/* How far rounded corners may be off: the whole of an offset along three axes, of the corner and of the plane. */
static double offset_of(const struct mesh *mesh)
{
    return 2 * sqrt(3) * mesh->rounding->corner_mm;
}

/* Corners that faces use and that differ get numbers, all others none. */
static size_t number_corners(struct mesh *mesh)
{
    static const unsigned UNUSED = ~0u, USED = 0;
    struct place *places = mesh->tree.places;
    size_t used = 0, kept = 0;
    memset(mesh->numbers, (int)UNUSED, mesh->corner_count * sizeof *mesh->numbers);
    for (size_t i = 0; i < mesh->loop_count; i++)
        mesh->numbers[mesh->loop[i]] = USED;
    for (size_t i = 0; i < mesh->corner_count; i++)
        if (mesh->numbers[i] == USED) {
            places[used].corner = (unsigned)i;
            memcpy(places[used++].at, mesh->corners_mm[i], sizeof places->at);
        }
    qsort(places, used, sizeof *places, by_place);
    for (size_t i = 0; i < used; i++) {
        bool differs = i == 0;
        for (int k = 0; k < 3 && i > 0; k++)
            differs |= places[i].at[k] != places[i - 1].at[k];
        kept += differs;
        mesh->numbers[places[i].corner] = (unsigned)(kept - 1);
    }
    return kept;
}

/* ---- checking ---- */

/* The faces by their new corners. */
static struct lx_shape_report take_faces(struct mesh *mesh, size_t kept)
{
    struct lx_facets *facets = lx_facets_new(kept, mesh->face_count, mesh->loop_count);
    mesh->facets = facets;
    if (!facets)
        return NO_MEMORY;
    for (size_t i = 0; i < mesh->loop_count; i++) {
        facets->loop[i] = mesh->numbers[mesh->loop[i]];
        facets->corners_mm[facets->loop[i]] = lx_wide3_of(mesh->corners_mm[mesh->loop[i]]);
    }
    for (size_t i = 0; i < mesh->face_count; i++)
        lx_facets_add_face(facets, mesh->counts[i]);
    for (size_t i = 0; i < facets->face_count; i++) {
        const unsigned *loop = facets->loop + facets->faces[i].first;
        unsigned count = facets->faces[i].count;
        for (unsigned k = 0; k < count; k++)
            if (loop[k] == loop[(k + 1) % count])
                return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, i, k};
    }
    return GOOD;
}

static struct lx_shape_report check_faces(const struct mesh *mesh, bool *plain)
{
    const struct lx_facets *facets = mesh->facets;
    double allowed = fmax(LX_SHAPE_TOLERANCE * 2 * facets->radius_mm, offset_of(mesh));
    for (size_t i = 0; i < facets->face_count; i++) {
        const struct lx_face *face = &facets->faces[i];
        if (face->count == 3 && face->area_mm2 > 0) {
            lx_wide3 a = facets->corners_mm[facets->loop[face->first]];
            lx_wide3 b = facets->corners_mm[facets->loop[face->first + 1]];
            lx_wide3 c = facets->corners_mm[facets->loop[face->first + 2]];
            double x = lx_wide_value(lx_wide3_length(lx_wide3_sub(b, a)));
            double y = lx_wide_value(lx_wide3_length(lx_wide3_sub(c, a)));
            if (face->area_mm2 > 1e-14 * fmax(x, y) * fmax(x, y))
                continue;
        }
        struct lx_plane plane = lx_best_plane(facets->corners_mm, facets->loop + face->first, face->count);
        if (!plane.has_area)
            return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, i, 0};
        if (plane.deviation_mm > allowed) {
            mesh->rounding->off_mm = plane.deviation_mm;
            mesh->rounding->allowed_mm = allowed;
            return (struct lx_shape_report){LX_SHAPE_NOT_FLAT, i, plane.farthest};
        }
        *plain = false;
    }
    return GOOD;
}

/* The volume and the part of the full solid angle 4 pi that the faces fill as seen from the middle, with signs. */
static void measure(const struct lx_facets *facets, double *volume, double *turns)
{
    *volume = *turns = 0;
    for (size_t i = 0; i < facets->face_count; i++) {
        const struct lx_face *face = &facets->faces[i];
        double at[3][3];
        for (unsigned k = 0; k < face->count; k++) {
            const lx_wide3 *corner = &facets->corners_mm[facets->loop[face->first + k]];
            unsigned n = k < 2 ? k : 2;
            if (k > 2)
                memcpy(at[1], at[2], sizeof at[1]);
            at[n][0] = (corner->x.high - facets->center_mm[0]) / facets->radius_mm;
            at[n][1] = (corner->y.high - facets->center_mm[1]) / facets->radius_mm;
            at[n][2] = (corner->z.high - facets->center_mm[2]) / facets->radius_mm;
            if (k < 2)
                continue;
            lx_bounded3 a = lx_exact3(at[0]), b = lx_exact3(at[1]), c = lx_exact3(at[2]);
            double det = lx_dot3(a, lx_cross3(b, c)).value;
            double la = lx_length3(a).value, lb = lx_length3(b).value, lc = lx_length3(c).value;
            double sum = la * lb * lc + lx_dot3(a, b).value * lc + lx_dot3(a, c).value * lb + lx_dot3(b, c).value * la;
            *volume += det / 6;
            *turns += 2 * atan2(det, sum) / (4 * M_PI); /* Van Oosterom, Strackee 1983 */
        }
    }
}

/* The plane of a face, how far corners may lie before it, and how this grows with the distance. */
static struct reach reach_of(const struct mesh *mesh, const struct lx_face *face, bool inward)
{
    const struct lx_facets *facets = mesh->facets;
    struct reach reach = {.tolerance = LX_SHAPE_TOLERANCE * 2 * facets->radius_mm};
    const double normal[3] = {face->normal.x.high, face->normal.y.high, face->normal.z.high};
    double largest = 0, offset = offset_of(mesh);
    for (unsigned i = 0; i < face->count; i++) {
        const lx_wide3 *corner = &facets->corners_mm[facets->loop[face->first + i]];
        const double at[3] = {corner->x.high - facets->center_mm[0], corner->y.high - facets->center_mm[1],
                              corner->z.high - facets->center_mm[2]};
        for (int k = 0; k < 3; k++) {
            reach.normal[k] = inward ? -normal[k] : normal[k];
            reach.center[k] += at[k] / face->count;
            reach.plane += reach.normal[k] * at[k] * (offset > 0 ? 1.0 / face->count : i == 0);
        }
    }
    for (unsigned i = 0; i < face->count && offset > 0; i++) {
        const lx_wide3 *corner = &facets->corners_mm[facets->loop[face->first + i]];
        const double at[3] = {corner->x.high - facets->center_mm[0], corner->y.high - facets->center_mm[1],
                              corner->z.high - facets->center_mm[2]};
        largest =
            fmax(largest, hypot(hypot(at[0] - reach.center[0], at[1] - reach.center[1]), at[2] - reach.center[2]));
    }
    if (offset > 0) { /* the width of the face, across its length of twice the largest distance */
        reach.tolerance = fmax(reach.tolerance, offset);
        reach.slope = offset * 4 * largest / fmax(face->area_mm2, offset * largest);
    }
    return reach;
}

/* Whether all corners lie behind all faces, or, where `inward`, before them. */
static struct lx_shape_report check_convex(const struct mesh *mesh, bool inward)
{
    const struct lx_facets *facets = mesh->facets;
    for (size_t i = 0; i < facets->face_count; i++) {
        struct reach reach = reach_of(mesh, &facets->faces[i], inward);
        double off = 0;
        long corner_beyond = find_beyond(&mesh->tree, &reach, &off);
        if (corner_beyond < 0)
            continue;
        mesh->rounding->off_mm = off;
        mesh->rounding->allowed_mm = reach.tolerance;
        return (struct lx_shape_report){LX_SHAPE_NOT_CONVEX, i, (size_t)corner_beyond};
    }
    return GOOD;
}

static struct lx_shape_report check_body(struct mesh *mesh)
{
    const struct lx_facets *facets = mesh->facets;
    double volume, turns, radius = facets->radius_mm;
    measure(facets, &volume, &turns);
    if (!(fabs(volume) > 1e-14 * facets->area_mm2 / radius / radius))
        return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, 0, 0};
    size_t count = facets->corner_count;
    for (size_t i = 0; i < mesh->corner_count; i++) /* of corners at one place the last is named */
        if (mesh->numbers[i] < count)
            mesh->tree.places[mesh->numbers[i]].corner = (unsigned)i;
    for (size_t i = 0; i < count; i++) {
        const lx_wide3 *corner = &facets->corners_mm[i];
        double *at = mesh->tree.places[i].at;
        at[0] = corner->x.high - facets->center_mm[0];
        at[1] = corner->y.high - facets->center_mm[1];
        at[2] = corner->z.high - facets->center_mm[2];
    }
    grow_tree(&mesh->tree, count);
    struct lx_shape_report report = check_convex(mesh, volume < 0);
    if (report.fault == LX_SHAPE_GOOD && fabs(turns) > 1.5) /* two shells in one */
        return (struct lx_shape_report){LX_SHAPE_NOT_CONVEX, 0, 0};
    if (report.fault == LX_SHAPE_GOOD && volume < 0)
        return (struct lx_shape_report){LX_SHAPE_INWARD, 0, 0};
    return report;
}

/* ---- faces that are not convex, or not quite flat ---- */

/* Faces in pieces, one behind another. */
struct pieces {
    unsigned *loop, *counts;
    size_t count, used;
};

/* A face as one piece, or as triangles where it is bent, or as convex pieces. */
static struct lx_shape_report cut_face(const struct lx_facets *facets, size_t index, lx_wide (*xy)[2],
                                       unsigned *positions, struct pieces *pieces)
{
    const struct lx_face *face = &facets->faces[index];
    const unsigned *loop = facets->loop + face->first;
    unsigned *made = pieces->loop + pieces->used, *counts = pieces->counts + pieces->count;
    if (face->count == 3) {
        memcpy(made, loop, 3 * sizeof *made);
        counts[0] = 3;
        pieces->used += 3;
        pieces->count++;
        return GOOD;
    }
    struct lx_plane plane = lx_best_plane(facets->corners_mm, loop, face->count);
    lx_flatten(facets->corners_mm, loop, face->count, plane.normal, xy);
    const lx_wide(*corners)[2] = (const lx_wide(*)[2])xy;
    struct lx_shape_report crossing = lx_find_crossing(corners, face->count);
    if (crossing.fault == LX_SHAPE_CROSSES)
        return (struct lx_shape_report){LX_SHAPE_NOT_CONVEX, index, crossing.first};
    if (crossing.fault != LX_SHAPE_GOOD)
        return crossing;
    size_t count = 1, corner_count = face->count;
    bool bent = plane.deviation_mm > 0x1p-45 * facets->radius_mm;
    bool convex = lx_turns_left(corners, positions, face->count);
    if (convex && !bent) {
        memcpy(made, positions, face->count * sizeof *made);
        counts[0] = face->count;
    } else {
        count = lx_cut_outline(corners, positions, face->count, made, counts, !bent);
        if (count == 0)
            return NO_MEMORY;
        corner_count = 0;
        for (size_t i = 0; i < count; i++)
            corner_count += counts[i];
    }
    for (size_t i = 0; i < corner_count; i++)
        made[i] = loop[made[i]];
    pieces->used += corner_count;
    pieces->count += count;
    return GOOD;
}

static struct lx_shape_report cut_faces(const struct lx_facets *facets, struct pieces *pieces)
{
    unsigned most = 0;
    for (size_t i = 0; i < facets->face_count; i++)
        most = facets->faces[i].count > most ? facets->faces[i].count : most;
    lx_wide(*xy)[2] = lx_new_array(most, sizeof *xy);
    unsigned *positions = lx_new_array(most, sizeof *positions);
    struct lx_shape_report report = xy && positions ? GOOD : NO_MEMORY;
    for (unsigned i = 0; i < most && positions; i++)
        positions[i] = i;
    for (size_t i = 0; i < facets->face_count && report.fault == LX_SHAPE_GOOD; i++)
        report = cut_face(facets, i, xy, positions, pieces);
    free(xy);
    free(positions);
    return report;
}

/* Makes the body one of convex, flat faces. */
static struct lx_shape_report refine(struct mesh *mesh)
{
    struct lx_facets *facets = mesh->facets, *made = NULL;
    struct pieces pieces = {0};
    pieces.loop = lx_new_array(mesh->loop_count, 3 * sizeof *pieces.loop);
    pieces.counts = lx_new_array(mesh->loop_count, sizeof *pieces.counts);
    struct lx_shape_report report = pieces.loop && pieces.counts ? cut_faces(facets, &pieces) : NO_MEMORY;
    if (report.fault == LX_SHAPE_GOOD && pieces.count > facets->face_count) {
        made = lx_facets_new(facets->corner_count, pieces.count, pieces.used);
        report = made ? GOOD : NO_MEMORY;
    }
    if (made) {
        memcpy(made->corners_mm, facets->corners_mm, facets->corner_count * sizeof *made->corners_mm);
        memcpy(made->loop, pieces.loop, pieces.used * sizeof *made->loop);
        for (size_t i = 0; i < pieces.count; i++)
            lx_facets_add_face(made, pieces.counts[i]);
        report = lx_facets_finish(made, true, NULL);
        report.first = report.second = 0; /* not the author's faces any more */
        lx_facets_free(facets);
        mesh->facets = made;
    }
    free(pieces.loop);
    free(pieces.counts);
    return report;
}

/* ---- all of it ---- */

static struct lx_shape_report count_loop(struct mesh *mesh)
{
    for (size_t i = 0; i < mesh->face_count; i++) {
        if (mesh->counts[i] < 3)
            return (struct lx_shape_report){LX_SHAPE_TOO_SMALL, i, 0};
        for (unsigned k = 0; k < mesh->counts[i]; k++)
            if (mesh->loop[mesh->loop_count + k] >= mesh->corner_count)
                return (struct lx_shape_report){LX_SHAPE_NOT_CLOSED, i, k};
        mesh->loop_count += mesh->counts[i];
    }
    bool fits = mesh->loop_count > 0 && mesh->loop_count < ~0u;
    return fits ? GOOD : (struct lx_shape_report){LX_SHAPE_TOO_SMALL, 0, 0};
}

static struct lx_shape_report make_mesh(struct mesh *mesh)
{
    bool plain = true;
    mesh->numbers = lx_new_array(mesh->corner_count, sizeof *mesh->numbers);
    mesh->tree.places = lx_new_array(mesh->corner_count, sizeof *mesh->tree.places);
    mesh->tree.boxes = lx_new_array(2 * mesh->corner_count, sizeof *mesh->tree.boxes);
    if (!mesh->numbers || !mesh->tree.places || !mesh->tree.boxes)
        return NO_MEMORY;
    struct lx_shape_report report = take_faces(mesh, number_corners(mesh));
    if (report.fault == LX_SHAPE_GOOD)
        report = lx_facets_finish(mesh->facets, true, NULL);
    if (report.fault == LX_SHAPE_GOOD)
        report = check_faces(mesh, &plain);
    if (report.fault == LX_SHAPE_GOOD)
        report = check_body(mesh);
    if (report.fault == LX_SHAPE_GOOD && !plain)
        report = refine(mesh);
    return report;
}

struct lx_shape_report lx_facets_of_mesh(const double (*corners_mm)[3], size_t corner_count, const unsigned *loop,
                                         const unsigned *counts, size_t face_count, struct lx_shape_rounding *rounding,
                                         struct lx_facets **facets)
{
    struct lx_shape_rounding none = {0};
    struct mesh mesh = {.rounding = rounding ? rounding : &none,
                        .corners_mm = corners_mm,
                        .loop = loop,
                        .counts = counts,
                        .corner_count = corner_count,
                        .face_count = face_count};
    struct lx_shape_report report = count_loop(&mesh);
    if (report.fault == LX_SHAPE_GOOD)
        report = make_mesh(&mesh);
    free(mesh.numbers);
    free(mesh.tree.places);
    free(mesh.tree.boxes);
    if (report.fault == LX_SHAPE_GOOD)
        *facets = mesh.facets;
    else
        lx_facets_free(mesh.facets);
    return report;
}
