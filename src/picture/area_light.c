/* SPDX-License-Identifier: MIT */
/* Area lights for the kernels. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../light/solid/extended.h"
#include "patch.h"

/* Faces or edges between two questions whether to go on. */
enum { BETWEEN_CHECKS = 128 };

/* What rules leave, as places_for() has it, by what they go over. */
static const double MISSED_FLAT = 1.6, MISSED_ROUND = 60, MISSED_BALL = 60;

static void set_edge(const struct lx_facets *facets, const struct lx_edge *edge, struct lx_area_light_edge_double *made)
{
    lx_wide3 center = lx_wide3_of(facets->center_mm);
    lx_wide3 from = lx_wide3_sub(facets->corners_mm[edge->from], center);
    lx_wide3 to = lx_wide3_sub(facets->corners_mm[edge->to], center);
    lx_wide3_values(from, made->from);
    lx_wide3_values(to, made->to);
    lx_wide3_values(lx_wide3_sub(to, from), made->along);
    lx_wide3_values(lx_wide3_add(from, to), made->both);
    made->product = lx_wide_value(lx_wide3_dot(from, to));
    lx_wide3_values(lx_wide3_cross(from, to), made->moment);
    made->left = edge->left;
    made->right = edge->right;
}

static luxel_status set_facets(const struct lx_facets *facets, const struct lx_asking *asking,
                               struct lx_area_light *lamp)
{
    lamp->faces_double = lx_new_aligned(facets->face_count, sizeof *lamp->faces_double);
    lamp->edges_double = lx_new_aligned(facets->edge_count, sizeof *lamp->edges_double);
    lamp->facets = facets;
    if (!lamp->faces_double || !lamp->edges_double)
        return LUXEL_ERROR_MEMORY;
    lamp->face_count = facets->face_count;
    lamp->edge_count = facets->edge_count;
    lx_wide3 center = lx_wide3_of(facets->center_mm);
    for (size_t i = 0; i < facets->face_count; i++) {
        const struct lx_face *face = &facets->faces[i];
        lx_wide3 corner = lx_wide3_sub(facets->corners_mm[facets->loop[face->first]], center);
        lx_wide3_values(face->normal, lamp->faces_double[i].normal);
        lamp->faces_double[i].height = lx_wide_value(lx_wide3_dot(face->normal, corner));
        lamp->most_patches += (face->count - 1) / 2;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return LUXEL_CANCELLED;
    }
    for (size_t i = 0; i < facets->edge_count; i++) {
        set_edge(facets, &facets->edges[i], &lamp->edges_double[i]);
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            return LUXEL_CANCELLED;
    }
    return LUXEL_OK;
}

/* The pole of 1/(c + l r + q r^2): its two 1/r have the sum -l/c and the product q/c. */
static double pole_of(double none, double root, double square)
{
    const double under = root * root - 4 * none * square, none_beside = 1e30; /* beside r = 0 */
    if (square == 0)
        return none > 0 ? root / none : none_beside;
    if (under < 0)
        return root / (2 * none);
    return root > 0 ? 2 * square / (root + sqrt(under)) : none_beside;
}

/* Lengths in mm, and areas, where laws have m: 1/(c + l r/1000 + q r^2/10^6) for 10^-6 of the area. */
struct lx_area_light_law lx_law_of(const struct lx_emitter *emitter)
{
    struct lx_area_light_law law = {.square = 1};
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: break;
    case LX_PRACTICAL: law = (struct lx_area_light_law){.none = 1e3 * emitter->k_mm, .root = 1e3}; break;
    case LX_NO_ATTENUATION: law = (struct lx_area_light_law){.none = 1e6}; break;
    case LX_POLYNOMIAL:
        law = (struct lx_area_light_law){.none = 1e6 * emitter->coefficients[0],
                                         .root = 1e3 * emitter->coefficients[1],
                                         .square = emitter->coefficients[2]};
    }
    law.pole = pole_of(law.none, law.root, law.square);
    return law;
}

/* The quadrilaterals that faces are cut into for patches, from the source's centre. */
static luxel_status set_quads(const struct lx_asking *asking, struct lx_area_light *lamp)
{
    struct lx_patch *patches = lx_new_array(lamp->most_patches, sizeof *patches);
    luxel_status status = LUXEL_OK;
    lamp->quads = lx_new_array(lamp->most_patches, sizeof *lamp->quads);
    if (!lamp->quads || !patches)
        status = LUXEL_ERROR_MEMORY;
    const struct lx_around everywhere = {.radius = HUGE_VAL};
    const size_t count = status == LUXEL_OK ? lx_patches_make(lamp, &everywhere, asking, patches) : 0;
    for (size_t i = 0; i < count; i++) {
        struct lx_area_light_quad *quad = &lamp->quads[lamp->quad_count++];
        memcpy(quad->normal, patches[i].n, sizeof quad->normal);
        for (int k = 0; k < 3; k++) {
            const double first = patches[i].o[k] - lamp->center[k], a = patches[i].a[k], b = patches[i].b[k];
            quad->corners[0][k] = first;
            quad->corners[1][k] = first + a;
            quad->corners[2][k] = first + a + b + patches[i].g[k];
            quad->corners[3][k] = first + b;
        }
    }
    if (status == LUXEL_OK && !lx_asking_goes_on(asking))
        status = LUXEL_CANCELLED;
    free(patches);
    return status;
}

luxel_status lx_area_light_make(const struct lx_emitter *emitter, const struct lx_shape *lit,
                                const struct lx_asking *asking, struct lx_area_light *lamp)
{
    const struct lx_facets *facets = emitter->facets;
    const struct lx_emitter_kind *kind = lx_emitter_kind(emitter);
    const double *center = lx_emitter_center(emitter);
    *lamp = (struct lx_area_light){
        .type = emitter->type,
        .is_disk = lx_is_disk(emitter),
        .is_ball = !lx_has_axis(emitter),
        .has_side = kind->has_side,
        .radiance = emitter->radiance.value,
        .law = lx_law_of(emitter),
        .radius_mm = lx_emitter_radius(emitter),
        .axis = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value},
        .round_mm = facets ? 0 : emitter->radius_mm,
        .half_mm = lx_half_height(emitter),
        .turned_mm2 = kind->share_seen * kind->area_mm2(emitter).value,
        .section_mm2 = kind->section_mm2(emitter),
    };
    lamp->is_general = !lx_kernels_get(0)->light_by_area_light[lamp->type];
    double away = 0;
    for (int i = 0; i < 3; i++) {
        lamp->center[i] = center[i] - lit->anchor_mm[i];
        away += fabs(lamp->center[i]);
    }
    lamp->touch_mm = 16 * LX_ROUNDING * (away + lamp->radius_mm + lit->radius_mm);
    luxel_status status = facets ? set_facets(facets, asking, lamp) : LUXEL_OK;
    if (status == LUXEL_OK && facets && emitter->attenuation != LX_INVERSE_SQUARE)
        status = set_quads(asking, lamp);
    return status;
}

/* How many places rules need (rules.h), for parts that leave `missed` times (n + 1) rho^-2n.  0: more than are worth
 * it. */
static unsigned places_for(double digits, double missed, double length, double nearest)
{
    const double rate = asinh(2 * nearest / length);
    for (unsigned n = 1; n <= LX_MOST_NODES_ACROSS; n++)
        if (2 * n * rate >= digits + log(missed * (n + 1)))
            return n;
    return 0;
}

static double length_between(const double a[3], const double b[3])
{
    return hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
}

static struct lx_area_light_node node_at(const double place[3], double weight)
{
    return (struct lx_area_light_node){place[0],        place[1],        place[2],        weight,
                                       (float)place[0], (float)place[1], (float)place[2], (float)weight};
}

/* The product rule with so many places along the edges between corners 0 and 1, and between 0 and 3. */
static void set_quad_nodes(const struct lx_gauss_rules *rules, const struct lx_area_light_quad *quad,
                           const unsigned places[2], struct lx_area_light_node *nodes)
{
    const struct lx_gauss_rule *by_s = &rules->rules[places[0] - 1], *by_t = &rules->rules[places[1] - 1];
    for (unsigned i = 0; i < places[0] * places[1]; i++) {
        const double s = (1 + by_s->places_double[i % places[0]]) / 2, t = (1 + by_t->places_double[i / places[0]]) / 2;
        double place[3], along[3], across[3], area = 0;
        for (int k = 0; k < 3; k++) {
            const double a = quad->corners[1][k] - quad->corners[0][k], b = quad->corners[3][k] - quad->corners[0][k];
            const double g = quad->corners[2][k] - quad->corners[1][k] - b;
            place[k] = quad->corners[0][k] + s * a + t * b + s * t * g;
            along[k] = a + t * g, across[k] = b + s * g;
        }
        for (int k = 0; k < 3; k++)
            area +=
                quad->normal[k] * (along[(k + 1) % 3] * across[(k + 2) % 3] - along[(k + 2) % 3] * across[(k + 1) % 3]);
        nodes[i] = node_at(place, area * by_s->weights_double[i % places[0]] * by_t->weights_double[i / places[0]] / 4);
    }
}

static luxel_status set_quads_nodes(const struct lx_gauss_rules *rules, double nearest, struct lx_area_light *lamp)
{
    double lengths[2] = {0, 0};
    unsigned places[2];
    for (size_t i = 0; i < lamp->quad_count; i++) {
        const double(*v)[3] = lamp->quads[i].corners;
        lengths[0] = fmax(lengths[0], fmax(length_between(v[0], v[1]), length_between(v[2], v[3])));
        lengths[1] = fmax(lengths[1], fmax(length_between(v[1], v[2]), length_between(v[3], v[0])));
    }
    for (int k = 0; k < 2; k++)
        places[k] = places_for(rules->digits, MISSED_FLAT, lengths[k], nearest);
    if (places[0] == 0 || places[1] == 0)
        return LUXEL_OK;
    lamp->nodes = lx_new_array(lamp->quad_count * places[0] * places[1], sizeof *lamp->nodes);
    if (!lamp->nodes)
        return LUXEL_ERROR_MEMORY;
    lamp->nodes_each = places[0] * places[1];
    for (size_t i = 0; i < lamp->quad_count; i++)
        set_quad_nodes(rules, &lamp->quads[i], places, lamp->nodes + i * lamp->nodes_each);
    return LUXEL_OK;
}

/* Rings whose squared radii go by Gauss's rule, with places at equal distances, every other ring turned by half. */
static luxel_status set_disk_nodes(const struct lx_gauss_rules *rules, double nearest, struct lx_area_light *lamp)
{
    const unsigned needed = places_for(rules->digits, MISSED_ROUND, 2 * lamp->round_mm, nearest);
    const unsigned rings = (needed + 1) / 2, spokes = 4 * rings, ends = lamp->has_side ? 2 : 1;
    const double *axis = lamp->axis, other[3] = {fabs(axis[0]) <= 0.5, fabs(axis[0]) > 0.5, 0};
    double a[3], b[3], length = 0;
    if (needed == 0)
        return LUXEL_OK;
    lamp->nodes = lx_new_array(ends * rings * spokes, sizeof *lamp->nodes);
    if (!lamp->nodes)
        return LUXEL_ERROR_MEMORY;
    lamp->nodes_each = rings * spokes;
    for (int k = 0; k < 3; k++) {
        b[k] = axis[(k + 1) % 3] * other[(k + 2) % 3] - axis[(k + 2) % 3] * other[(k + 1) % 3];
        length = hypot(length, b[k]);
    }
    for (int k = 0; k < 3; k++)
        a[k] = (b[(k + 1) % 3] * axis[(k + 2) % 3] - b[(k + 2) % 3] * axis[(k + 1) % 3]) / length;
    const struct lx_gauss_rule *rule = &rules->rules[rings - 1];
    for (unsigned i = 0; i < ends * lamp->nodes_each; i++) {
        const unsigned ring = i / spokes % rings, end = i / lamp->nodes_each;
        const double turn = 2 * M_PI * (i % spokes + 0.5 * (ring % 2)) / spokes;
        const double radius = lamp->round_mm * sqrt((1 + rule->places_double[ring]) / 2);
        const double area = M_PI * lamp->round_mm * lamp->round_mm * rule->weights_double[ring] / 2 / spokes;
        double place[3];
        for (int k = 0; k < 3; k++)
            place[k] =
                radius * (cos(turn) * a[k] + sin(turn) * b[k] / length) + (end == 0 ? 1 : -1) * lamp->half_mm * axis[k];
        lamp->nodes[i] = node_at(place, area);
    }
    return LUXEL_OK;
}

luxel_status lx_area_light_set_nodes(const struct lx_gauss_rules *rules, double nearest, struct lx_area_light *lamp)
{
    if (!(nearest > 0))
        return LUXEL_OK;
    if (lamp->facets)
        return set_quads_nodes(rules, nearest, lamp);
    if (lamp->is_ball) { /* rings go from the edge of what is seen, behind which singularities are */
        const double away = nearest / lamp->round_mm;
        lamp->nodes_each = places_for(rules->digits, MISSED_BALL, 1, sqrt(away * (away + 2)));
        return LUXEL_OK;
    }
    return set_disk_nodes(rules, nearest, lamp);
}

void lx_area_light_forget_nodes(struct lx_area_light *lamp)
{
    free(lamp->nodes);
    lamp->nodes = NULL;
    lamp->nodes_each = 0;
}

static void copy3(const double from[3], float to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (float)from[i];
}

luxel_status lx_area_light_make_single(struct lx_area_light *lamp, const struct lx_asking *asking)
{
    struct lx_area_light_face_single *faces = lx_new_aligned(lamp->face_count, sizeof *faces);
    struct lx_area_light_edge_single *edges = lx_new_aligned(lamp->edge_count, sizeof *edges);
    luxel_status status = faces && edges ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < lamp->face_count && status == LUXEL_OK; i++) {
        copy3(lamp->faces_double[i].normal, faces[i].normal);
        faces[i].height = (float)lamp->faces_double[i].height;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            status = LUXEL_CANCELLED;
    }
    for (size_t i = 0; i < lamp->edge_count && status == LUXEL_OK; i++) {
        const struct lx_area_light_edge_double *edge = &lamp->edges_double[i];
        copy3(edge->from, edges[i].from);
        copy3(edge->to, edges[i].to);
        copy3(edge->along, edges[i].along);
        copy3(edge->both, edges[i].both);
        copy3(edge->moment, edges[i].moment);
        edges[i].product = (float)edge->product;
        edges[i].left = edge->left;
        edges[i].right = edge->right;
        if (!lx_asking_at_step(asking, i, BETWEEN_CHECKS))
            status = LUXEL_CANCELLED;
    }
    if (status == LUXEL_OK) {
        lamp->faces_single = faces;
        lamp->edges_single = edges;
        return LUXEL_OK;
    }
    free(faces);
    free(edges);
    return status;
}

void lx_area_light_clear(struct lx_area_light *lamp)
{
    free(lamp->faces_double);
    free(lamp->edges_double);
    free(lamp->faces_single);
    free(lamp->edges_single);
    free(lamp->quads);
    lx_area_light_forget_nodes(lamp);
    *lamp = (struct lx_area_light){0};
}
