/* SPDX-License-Identifier: MIT */
/*
 * Cutting facets into parts, each a small Lambertian source at its centre: parallelograms into N x N of their kind,
 * what other faces consist of, triangles, into N^2 congruent ones.
 */
#include <string.h>

#include "../../base/pose.h"
#include "../../base/rows.h"
#include "../../format/cloud.h"
#include "../law.h"
#include "facets.h"

/* Four corners this near to a parallelogram, relative to its size, are one. */
static const double ROUNDED = 1e-12;

/* A point emitter for each part has all but its place in common. */
struct cut {
    lx_wide3 origin_mm, u_mm, v_mm; /* a parallelogram, or the triangle that is half of it */
    unsigned parts;
    struct lx_emitter part;
    struct lx_emitters *emitters;
    double *row; /* of the next part; NULL: they are appended one by one */
};

/* Parts between two questions whether to go on. */
enum { BETWEEN_CHECKS = 128 };

/* A part at origin + (i + offset)/parts u + (j + offset)/parts v, the offset being so many thirds or halves. */
static int add_part(struct cut *cut, unsigned i, unsigned j, unsigned numerator, unsigned denominator)
{
    lx_wide whole = lx_wide_of((double)denominator * cut->parts);
    lx_wide s = lx_wide_div(lx_wide_of((double)i * denominator + numerator), whole);
    lx_wide t = lx_wide_div(lx_wide_of((double)j * denominator + numerator), whole);
    lx_wide3 way = lx_wide3_add(lx_wide3_mul(cut->u_mm, s), lx_wide3_mul(cut->v_mm, t));
    lx_wide3 place = lx_wide3_add(cut->origin_mm, way);
    if (cut->row) {
        const double row[LX_CLOUD_COLUMNS] = {lx_wide_value(place.x), lx_wide_value(place.y), lx_wide_value(place.z),
                                              cut->part.strength};
        memcpy(cut->row, row, sizeof row);
        cut->row += LX_CLOUD_COLUMNS;
        return lx_asking_at_step(cut->emitters->asking, i, BETWEEN_CHECKS) ? 0 : -1;
    }
    cut->part.position_mm[0] = lx_wide_value(place.x);
    cut->part.position_mm[1] = lx_wide_value(place.y);
    cut->part.position_mm[2] = lx_wide_value(place.z);
    return lx_emitters_append(cut->emitters, &cut->part);
}

static int cut_parallelogram(struct cut *cut)
{
    for (unsigned j = 0; j < cut->parts; j++)
        for (unsigned i = 0; i < cut->parts; i++)
            if (add_part(cut, i, j, 1, 2))
                return -1;
    return 0;
}

/* The lines i/N, j/N and (i + j)/N cut it; half of the small triangles lie the other way round. */
static int cut_triangle(struct cut *cut)
{
    for (unsigned j = 0; j < cut->parts; j++)
        for (unsigned i = 0; i + j < cut->parts; i++)
            if (add_part(cut, i, j, 1, 3) || (i + j + 1 < cut->parts && add_part(cut, i, j, 2, 3)))
                return -1;
    return 0;
}

/* Cuts what `cutter` cuts, into a point set where there are many parts. */
static int cut_piece(struct cut *cut, int (*cutter)(struct cut *cut))
{
    if (cut->parts < LX_LEAST_IN_POINT_SET)
        return cutter(cut);
    struct lx_cloud *cloud = lx_cloud_new((size_t)cut->parts * cut->parts);
    if (!cloud)
        return -1;
    const struct lx_point_set set = {.cloud = cloud, .is_owned = true, .model = cut->part};
    cut->row = cloud->values;
    int failed = cutter(cut);
    cut->row = NULL;
    if (!failed)
        return lx_emitters_append_point_set(cut->emitters, &set);
    lx_kept_release(&cloud->kept);
    return failed;
}

static double size(lx_wide3 a)
{
    return lx_wide_value(lx_wide3_length(a));
}

/* Each part's intensity along the normal, W/sr: radiance times its area. */
static void set_strength(struct cut *cut, double radiance, double share)
{
    double area_m2 = size(lx_wide3_cross(cut->u_mm, cut->v_mm)) * share / 1e6;
    cut->part.strength = radiance * area_m2 / ((double)cut->parts * cut->parts);
}

static int cut_face(const struct lx_emitter *emitter, const struct lx_face *face, struct cut *cut)
{
    const struct lx_facets *facets = emitter->facets;
    const unsigned *loop = facets->loop + face->first;
    const lx_wide3 *corners = facets->corners_mm;
    cut->part.profile = lx_profile_cosine(lx_wide3_direction(face->normal), 1);
    cut->origin_mm = corners[loop[0]];
    if (face->count == 4) {
        lx_wide3 back = lx_wide3_sub(corners[loop[2]], corners[loop[3]]);
        cut->u_mm = lx_wide3_sub(corners[loop[1]], corners[loop[0]]);
        cut->v_mm = lx_wide3_sub(corners[loop[3]], corners[loop[0]]);
        if (size(lx_wide3_sub(cut->u_mm, back)) <= ROUNDED * fmax(size(cut->u_mm), size(cut->v_mm))) {
            set_strength(cut, emitter->radiance.value, 1);
            return cut_piece(cut, cut_parallelogram);
        }
    }
    for (unsigned k = 1; k + 1 < face->count; k++) {
        cut->u_mm = lx_wide3_sub(corners[loop[k]], corners[loop[0]]);
        cut->v_mm = lx_wide3_sub(corners[loop[k + 1]], corners[loop[0]]);
        set_strength(cut, emitter->radiance.value, 0.5);
        if (cut_piece(cut, cut_triangle))
            return -1;
    }
    return 0;
}

int lx_facets_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters)
{
    struct cut cut = {.parts = parts, .emitters = emitters};
    cut.part.type = LX_POINT;
    cut.part.light = emitter->light;
    lx_law_copy(emitter, &cut.part);
    for (size_t i = 0; i < emitter->facets->face_count; i++)
        if (cut_face(emitter, &emitter->facets->faces[i], &cut))
            return -1;
    return 0;
}
