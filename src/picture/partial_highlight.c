/* SPDX-License-Identifier: MIT */
/* Highlights over what is seen of a source, sector by sector. */
#include "partial_highlight.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "../kernel/sector_rules.h"
#include "../light/solid/extended.h"
#include "../world/visibility/boundary.h"

enum { MOST_PENDING = 48, MOST_PARTS = 160 };

/* Share of what is allowed for parts that are left out. */
static const double LEFT_OUT = 0.1;

/* Parts whose corners are farther from their middle, as a tangent, are cut; and those that are seen under more widths
 * of the lobe, from the middle. */
static const double WIDEST = 0.75, MOST_WIDTHS = 4.3;

/* Along an arc or an edge, half of what one rule takes in such widths, and an angle around a circle. */
static const double MOST_ALONG = 2.1;

/* Laws other than 1/r^2: how many times as obliquely the plane of a face may be seen at one corner as at another. */
static const double MOST_OBLIQUE = 1.6;

/* What is being summed. */
struct work {
    const struct lx_partial_highlight *asked;
    const struct lx_emitter *emitter;
    struct lx_boundary boundary;
    struct lx_boundary_polygon pending[MOST_PENDING];
    size_t pending_count;
    struct lx_lobe_at at;
    double face[3];                       /* of a law other than 1/r^2: the normal of the face, to the source, */
    double height_mm;                     /* and how far its plane is */
    const struct lx_boundary_side *curve; /* around the part; NULL: none */
    double center[3];                     /* of a ball */
    double middle[3];                     /* of the part, unit */
    double width;                         /* of the lobe there, as a tangent */
    double sum, left_out;
    size_t node_count;
    struct lx_beams_double beams;
};

/* The law towards a direction of any length. */
static double law_towards(const struct work *work, const double u[3])
{
    const double length = sqrt(lx_dot(u, u)), radius = work->emitter->radius_mm;
    if (work->emitter->attenuation == LX_INVERSE_SQUARE)
        return 1;
    if (lx_has_axis(work->emitter))
        return lx_relative_law(work->emitter, work->height_mm * length / lx_dot(work->face, u));
    const double ahead = lx_dot(work->center, u) / length;
    const double below = radius * radius - lx_dot(work->center, work->center) + ahead * ahead;
    return lx_relative_law(work->emitter, ahead - sqrt(fmax(below, 0)));
}

/* ---- nodes ---- */

/* The irradiance of all nodes so far. */
static void flush_matte(struct work *work)
{
    const struct lx_beams_double *beams = &work->beams;
    const double *n = work->asked->normal;
    double sum = 0;
    for (size_t i = 0; i < work->node_count; i++) {
        const double x = beams->x[i], y = beams->y[i], z = beams->z[i], square = x * x + y * y + z * z;
        sum += beams->weight[i] * (n[0] * x + n[1] * y + n[2] * z) / (square * square);
    }
    work->sum += sum;
}

double lx_partial_highlight_of_beams(const struct lx_partial_highlight *asked, struct lx_beams_double *beams,
                                     size_t used)
{
    const size_t count = lx_padded(used);
    struct lx_beams_single copy;
    for (size_t i = used; i < count; i++) {
        beams->x[i] = beams->x[0], beams->y[i] = beams->y[0], beams->z[i] = beams->z[0];
        beams->weight[i] = 0;
    }
    if (asked->source->in_double)
        return asked->kernels->beams_double(beams, count, asked->lobe, asked->normal, asked->view);
    for (size_t i = 0; i < count; i++) {
        copy.x[i] = (float)beams->x[i], copy.y[i] = (float)beams->y[i];
        copy.z[i] = (float)beams->z[i], copy.weight[i] = (float)beams->weight[i];
    }
    return asked->kernels->beams_single(&copy, count, asked->lobe_single, asked->normal, asked->view);
}

/* The highlight of all nodes so far, or what else is asked for. */
static void flush(struct work *work)
{
    if (work->asked->is_matte)
        flush_matte(work);
    else if (work->node_count > 0)
        work->sum += lx_partial_highlight_of_beams(work->asked, &work->beams, work->node_count);
    work->node_count = 0;
}

/* How many nodes do for what is so long, as a tangent; from the middle some more where they are eased. */
static unsigned order_for(const struct work *work, double length)
{
    unsigned order = length < 0.15 ? 2 : length < 0.4 ? 3 : 4; /* by the cosines alone */
    if (work->asked->is_matte)
        return LX_PARTIAL_HIGHLIGHT_NODES;
    if (!lx_has_axis(work->emitter) && work->emitter->attenuation != LX_INVERSE_SQUARE)
        order += 2;
    return lx_sector_order(order, length / 2 / work->width);
}

/* The nodes between the middle and a place on the border, in its plane; eased, diffuse light takes two rules. */
static void add_spoke(struct work *work, const double x[3], unsigned order, double weight)
{
    const double *places = lx_sector_places[order - 1], *weights = lx_sector_weights[order - 1];
    struct lx_beams_double *beams = &work->beams;
    const bool by_square = work->emitter->attenuation == LX_INVERSE_SQUARE;
    const bool is_eased = !lx_has_axis(work->emitter) && !by_square; /* distances end like roots at the rim */
    const unsigned parts = is_eased && work->asked->is_matte ? 2 : 1;
    if (work->node_count + parts * order > LX_BLOCK)
        flush(work);
    for (unsigned i = 0; i < parts * order; i++) {
        const size_t at = work->node_count++;
        const double place = (i / order + places[i % order]) / parts;
        const double s = is_eased ? sin(M_PI_2 * place) : place;
        const double slope = (is_eased ? M_PI_2 * cos(M_PI_2 * place) : 1) / parts;
        const double y[3] = {work->middle[0] + s * (x[0] - work->middle[0]),
                             work->middle[1] + s * (x[1] - work->middle[1]),
                             work->middle[2] + s * (x[2] - work->middle[2])};
        beams->x[at] = y[0], beams->y[at] = y[1], beams->z[at] = y[2];
        beams->weight[at] = weight * weights[i % order] * slope * s * (by_square ? 1 : law_towards(work, y));
    }
}

/* To the plane that touches the sphere of directions in the middle of the part. */
static void project(const struct work *work, const double u[3], double x[3])
{
    const double scale = 1 / lx_dot(work->middle, u);
    for (int k = 0; k < 3; k++)
        x[k] = scale * u[k];
}

static double distance(const double a[3], const double b[3])
{
    const double way[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return sqrt(lx_dot(way, way));
}

/* The triangle of the middle and a piece of a great circle. */
static void add_triangle(struct work *work, const struct lx_boundary_side *side, double from, double to, int sign)
{
    double u[3], a[3], b[3], turned[3];
    lx_boundary_place(side, from, u);
    project(work, u, a);
    lx_boundary_place(side, to, u);
    project(work, u, b);
    lx_cross(a, b, turned);
    const double area = fabs(lx_dot(work->middle, turned)) * (lx_dot(side->g, work->middle) < 0 ? -sign : sign);
    const double length = distance(a, b), half = length / 2 / work->width;
    const unsigned parts = (unsigned)fmin(ceil(fmax(half / MOST_ALONG, 1)), 64);
    const unsigned along = order_for(work, length / parts);
    const unsigned across = order_for(work, fmax(distance(work->middle, a), distance(work->middle, b)));
    for (unsigned p = 0; p < parts; p++)
        for (unsigned i = 0; i < along; i++) {
            const double t = (p + lx_sector_places[along - 1][i]) / parts;
            const double x[3] = {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
            add_spoke(work, x, across, area * lx_sector_weights[along - 1][i] / parts);
        }
}

/* The sector of the middle and a piece of a circle, which is walked counter-clockwise about g. */
static void add_sector(struct work *work, const struct lx_boundary_side *side, double from, double to, int sign)
{
    double u[3], x[3], before[3] = {0}, length = 0, farthest = 0;
    for (int i = 0; i <= 4; i++) {
        lx_boundary_place(side, from + (to - from) * i / 4, u);
        project(work, u, x);
        length += i > 0 ? distance(before, x) : 0;
        farthest = fmax(farthest, distance(work->middle, x));
        memcpy(before, x, sizeof before);
    }
    const double half = length / 2 / work->width;
    const unsigned parts = (unsigned)fmin(ceil(fmax(half / MOST_ALONG, (to - from) / M_PI_2)), 64);
    const unsigned across = order_for(work, farthest);
    const double turn = (to - from) / parts;
    const unsigned by_turn = turn < 0.4 ? 3 : turn < 1 ? 4 : 5, by_length = order_for(work, length / parts);
    const unsigned along = by_turn > by_length ? by_turn : by_length;
    for (unsigned p = 0; p < parts; p++)
        for (unsigned i = 0; i < along; i++) {
            const double t = from + (p + lx_sector_places[along - 1][i]) * turn, c = cos(t), s = sin(t);
            double slope[3], turned[3];
            for (int k = 0; k < 3; k++) {
                u[k] = side->limit * side->g[k] + side->sine * (c * side->p[k] + s * side->q[k]);
                slope[k] = side->sine * (c * side->q[k] - s * side->p[k]);
            }
            lx_cross(u, slope, turned);
            const double ahead = lx_dot(work->middle, u);
            project(work, u, x);
            add_spoke(work, x, across,
                      sign * lx_dot(work->middle, turned) / (ahead * ahead) * lx_sector_weights[along - 1][i] * turn);
        }
}

static void add_piece(void *data, const struct lx_boundary_side *side, double from, double to, int sign)
{
    struct work *work = data;
    if (side->is_circle)
        add_sector(work, side, from, to, sign);
    else
        add_triangle(work, side, from, to, sign);
}

/* ---- parts of the source ---- */

/* What is known of a part. */
struct look {
    double cosine;  /* of the angle from its middle under which no corner is beyond */
    double bound;   /* of its highlight */
    double oblique; /* the ratio of cosines of incidence, of a law other than 1/r^2 */
};

/* A bound of the highlight of what is within an angle from the middle, and no farther than that. */
static double bound_of(const struct work *work, double cosine, double farthest_mm)
{
    const double sine = sqrt(fmax(1 - cosine * cosine, 0));
    return work->emitter->radiance.value * work->asked->lobe->specular * lx_relative_law(work->emitter, farthest_mm) *
           2 * M_PI * (1 - cosine) *
           (cosine > 0 ? lx_sector_power(work->asked->lobe, work->at.mirrored, work->middle, cosine, sine) : 1);
}

static bool look_at(struct work *work, const struct lx_boundary_polygon *part, struct look *look)
{
    double farthest = 0, least = HUGE_VAL, most = 0;
    memset(work->middle, 0, sizeof work->middle);
    for (unsigned i = 0; i < part->count; i++) {
        const double scale = 1 / sqrt(lx_dot(part->corners[i], part->corners[i]));
        for (int k = 0; k < 3; k++)
            work->middle[k] += scale * part->corners[i][k];
    }
    if (!(lx_normalize(work->middle) > 1e-3 * part->count))
        return false;
    look->cosine = 1;
    for (unsigned i = 0; i < part->count; i++) {
        const double length = sqrt(lx_dot(part->corners[i], part->corners[i]));
        const double slope = lx_dot(work->face, part->corners[i]) / length;
        look->cosine = fmin(look->cosine, lx_dot(work->middle, part->corners[i]) / length);
        farthest = fmax(farthest, length);
        least = fmin(least, slope);
        most = fmax(most, slope);
    }
    const bool is_even = work->emitter->attenuation == LX_INVERSE_SQUARE || !lx_has_axis(work->emitter);
    look->oblique = is_even ? 1 : most / least;
    if (!work->emitter->facets) /* the corners are directions alone */
        farthest = sqrt(lx_dot(work->center, work->center)) + work->emitter->radius_mm;
    look->bound = work->asked->is_matte ? 0 : bound_of(work, look->cosine, farthest);
    return is_even || least > 0;
}

/* Whether the lobe may end in the part so steeply that the rules are not for it. */
static bool ends_steeply(const struct work *work, double sine)
{
    const double SMOOTH = 4; /* an exponent */
    const struct lx_partial_highlight *asked = work->asked;
    double limit;
    if (asked->is_matte || !(asked->lobe->exponent.value < SMOOTH))
        return false;
    const double *end = lx_lobe_kinds[asked->lobe->model]->end(&work->at, &limit);
    return fabs(lx_dot(work->middle, end) - limit) <= sine;
}

/* Replaces a part by its two halves, cut across the way to its farthest corner; false: there is no room. */
static bool halve(struct work *work, const struct lx_boundary_polygon *part)
{
    double across[3] = {0}, farthest = -1;
    if (work->pending_count + 2 > MOST_PENDING || part->count + 1 > LX_BOUNDARY_SIDES)
        return false;
    for (unsigned i = 0; i < part->count; i++) {
        double corner[3] = {part->corners[i][0], part->corners[i][1], part->corners[i][2]};
        lx_normalize(corner);
        const double ahead = lx_dot(corner, work->middle), angle = 1 - ahead;
        for (int k = 0; k < 3 && angle > farthest; k++)
            across[k] = corner[k] - ahead * work->middle[k];
        farthest = fmax(farthest, angle);
    }
    for (int i = 0; i < 2; i++) {
        struct lx_boundary_polygon *half = &work->pending[work->pending_count];
        *half = *part;
        lx_boundary_cut(half, across);
        work->pending_count += half->count > 0;
        for (int k = 0; k < 3; k++)
            across[k] = -across[k];
    }
    return true;
}

/* Adds the highlight of what is pending; false: it is too much work, or not for the rules. */
static bool work_off(struct work *work)
{
    for (size_t parts = 0; work->pending_count > 0; parts++) {
        const struct lx_boundary_polygon part = work->pending[--work->pending_count];
        struct look look;
        if (parts == MOST_PARTS || !look_at(work, &part, &look))
            return false;
        if (!work->asked->is_matte && work->left_out + look.bound <= LEFT_OUT * work->asked->allowed) {
            work->left_out += look.bound;
            continue;
        }
        const double sine = sqrt(fmax(1 - look.cosine * look.cosine, 0));
        work->width = work->asked->is_matte ? HUGE_VAL
                                            : lx_sector_width(work->asked->lobe, work->asked->view, work->middle, sine);
        const bool is_near = look.cosine > 0 && sine <= WIDEST * look.cosine;
        if (!is_near || sine > MOST_WIDTHS * work->width * look.cosine || look.oblique > MOST_OBLIQUE) {
            if (!halve(work, &part))
                return false;
            continue;
        }
        if (ends_steeply(work, sine))
            return false;
        if (!lx_boundary_add_polygon(&part, &work->boundary.bodies[0]))
            continue; /* it has no width */
        struct lx_boundary_body *body = &work->boundary.bodies[0];
        if (work->curve) {
            if (body->count == LX_BOUNDARY_SIDES)
                return false;
            body->sides[body->count++] = *work->curve;
        }
        if (!lx_boundary_walk(&work->boundary, add_piece, work))
            return false;
        flush(work);
    }
    return true;
}

/* ---- the source ---- */

/* All of a shape, or what of it is above the horizon. */
static bool add_shape(struct work *work, const struct lx_boundary_shape *shape)
{
    struct lx_boundary_polygon *part = &work->pending[0];
    *part = shape->polygon;
    work->curve = shape->has_curve ? &shape->curve : NULL;
    if (part->count + 1 + work->boundary.cut_count > LX_BOUNDARY_SIDES)
        return false;
    lx_boundary_cut_all(&work->boundary, part);
    if (work->asked->is_matte || LX_ENDS_AT_HORIZON(work->asked->lobe->highlight))
        lx_boundary_cut(part, work->asked->normal);
    work->pending_count = part->count > 0;
    return work_off(work);
}

/* Each face by itself, by a law other than 1/r^2. */
static bool add_faces(struct work *work)
{
    const struct lx_facets *facets = work->emitter->facets;
    for (size_t f = 0; f < facets->face_count; f++) {
        struct lx_boundary_shape shape = {.has_curve = false};
        if (!lx_boundary_face(work->asked->occlusion, facets, f, &shape.polygon, work->face))
            return false;
        if (shape.polygon.count == 0)
            continue;
        work->height_mm = lx_dot(work->face, shape.polygon.corners[0]);
        if (!add_shape(work, &shape))
            return false;
    }
    return true;
}

static bool add_source(struct work *work)
{
    const struct lx_emitter *emitter = work->emitter;
    struct lx_boundary_shapes shapes;
    if (emitter->attenuation != LX_INVERSE_SQUARE) {
        if (emitter->facets)
            return add_faces(work);
        if (lx_emitter_kind(emitter)->has_side)
            return false;
        const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
        for (int k = 0; k < 3; k++)
            work->face[k] = -axis[k];
        work->height_mm = lx_dot(work->face, work->center);
    }
    if (!lx_boundary_shape(work->asked->occlusion, emitter, &shapes))
        return false;
    for (unsigned i = 0; i < shapes.count; i++)
        if (!add_shape(work, &shapes.items[i]) ||
            (i + 1 < shapes.count && !lx_boundary_put_aside(&shapes.items[i], &work->boundary)))
            return false;
    return true;
}

bool lx_partial_highlight_sum(const struct lx_partial_highlight *partial, double *sum)
{
    const struct lx_emitter *emitter = partial->source->emitter;
    struct work work; /* large: what is not needed stays as it is */
    if (!lx_boundary_begin(partial->occlusion, emitter, &work.boundary))
        return false;
    work.asked = partial;
    work.emitter = emitter;
    work.sum = work.left_out = 0;
    work.node_count = work.pending_count = 0;
    memset(work.face, 0, sizeof work.face);
    lx_lobe_at_set(partial->normal, partial->view, &work.at);
    for (int k = 0; k < 3; k++)
        work.center[k] = emitter->center_mm[k] - partial->occlusion->place_mm[k];
    if (!add_source(&work))
        return false;
    *sum = fmax(work.sum, 0);
    return true;
}
