/* SPDX-License-Identifier: MIT */
/*
 * Skies by their visible boundaries: along the borders of what is seen of a polygon in the sky a potential
 * (integral/sky_potential.h) is integrated, adaptively.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/larger.h"
#include "../../base/vector.h"
#include "../integral/adaptive.h"
#include "../integral/sky_potential.h"
#include "boundary_ends.h"

enum { MOST_PANELS = 768, MOST_WIDTHS = 12, MOST_CUTS = 2 * MOST_WIDTHS + 2 };

/* What is less than this share of the whole sky need not be told from nothing. */
static const double FAINT = 1e-4;

/* A piece of a border: u = middle + a cos(t) + b sin(t). */
struct piece {
    double middle[3], a[3], b[3], from, to, sign;
};

struct borders {
    const struct lx_sky_potential *potential;
    const double *normal;
    double tolerance, known; /* of the sum with what is known */
    struct piece pieces[LX_BOUNDARY_PIECES];
    size_t count, steps;
    bool is_full;
};

/* An arc of a great circle. */
static void set_arc(const struct lx_boundary_side *side, double from, double to, struct piece *piece)
{
    double ends[2][3], across[3];
    lx_boundary_place(side, from, ends[0]);
    lx_boundary_place(side, to, ends[1]);
    lx_cross(ends[0], ends[1], across);
    const int first = lx_dot(across, side->g) < 0; /* counter-clockwise about what is inside */
    memcpy(piece->a, ends[first], sizeof piece->a);
    lx_normalize(piece->a);
    lx_cross(side->g, piece->a, piece->b);
    piece->from = 0;
    piece->to = atan2(sqrt(lx_dot(across, across)), lx_dot(ends[0], ends[1]));
}

static void add_piece(void *data, const struct lx_boundary_side *side, double from, double to, int sign)
{
    struct borders *borders = data;
    borders->is_full = borders->count == LX_BOUNDARY_PIECES;
    if (borders->is_full)
        return;
    struct piece *piece = &borders->pieces[borders->count++];
    *piece = (struct piece){.from = from, .to = to, .sign = sign};
    if (!side->is_circle) {
        set_arc(side, from, to, piece);
        return;
    }
    for (int k = 0; k < 3; k++) {
        piece->middle[k] = side->limit * side->g[k];
        piece->a[k] = side->sine * side->p[k];
        piece->b[k] = side->sine * side->q[k];
    }
}

static void place_on(const struct piece *piece, double t, double u[3], double step[3])
{
    const double c = cos(t), s = sin(t);
    for (int k = 0; k < 3; k++) {
        u[k] = piece->middle[k] + c * piece->a[k] + s * piece->b[k];
        step[k] = c * piece->b[k] - s * piece->a[k];
    }
}

/* Appends places to cut a piece at: about where it comes nearest to a pole, as far apart as they are from it. */
static size_t cut_about(const struct piece *piece, const double pole[3], double *cuts, size_t count)
{
    static const double FIRST = 2, NEXT = 4, FAR = 0.5, NEAR = 1e-6; /* of the angle to the pole, and that in rad */
    const double middle = (piece->from + piece->to) / 2;
    double foot = atan2(lx_dot(pole, piece->b), lx_dot(pole, piece->a)), u[3], step[3];
    foot += 2 * M_PI * round((middle - foot) / (2 * M_PI));
    place_on(piece, foot, u, step);
    const double away = lx_angle_between(u, pole), speed = sqrt(lx_dot(step, step) / lx_dot(u, u));
    double width = FIRST * fmax(away, NEAR) / speed;
    if (!(away < FAR))
        return count;
    cuts[count++] = foot;
    for (int i = 0; i < MOST_WIDTHS && width < 2 * M_PI; i++, width *= NEXT) {
        cuts[count++] = foot - width;
        cuts[count++] = foot + width;
    }
    return count;
}

/* The panels of a piece: at the pole the integrand may have a bend, and opposite to it a peak.  False: there are too
 * many. */
static bool start_panels(const struct borders *borders, size_t number, struct lx_panels *panels)
{
    const struct piece *piece = &borders->pieces[number];
    const double *pole = lx_sky_potential_pole(borders->potential), opposite[3] = {-pole[0], -pole[1], -pole[2]};
    double cuts[2 * MOST_CUTS], from = piece->from;
    size_t count = cut_about(piece, pole, cuts, 0);
    count = cut_about(piece, opposite, cuts, count);
    cuts[count++] = piece->to;
    qsort(cuts, count, sizeof *cuts, lx_by_value);
    for (size_t i = 0; i < count; i++)
        if (cuts[i] > from && cuts[i] <= piece->to) {
            if (panels->count == panels->capacity)
                return false;
            panels->items[panels->count++] = (struct lx_panel){.interval = number, .from = from, .to = cuts[i]};
            from = cuts[i];
        }
    return true;
}

static struct lx_point_value step_at(void *data, size_t piece, double t)
{
    struct borders *borders = data;
    const struct piece *on = &borders->pieces[piece];
    double u[3], step[3];
    place_on(on, t, u, step);
    borders->steps++;
    const lx_bounded found = lx_sky_potential_step(borders->potential, u, step, borders->normal);
    return (struct lx_point_value){.value = on->sign * found.value, .error = found.error};
}

static double target(void *data, const struct lx_integral *integral)
{
    const struct borders *borders = data;
    const double faint = FAINT * lx_sky_potential_whole(borders->potential);
    return borders->tolerance * (borders->known + fmax(fabs(integral->value), faint));
}

bool lx_boundary_sky(const struct lx_emitter *emitter, const double normal[3], const struct lx_occlusion *occlusion,
                     double tolerance, double known, lx_bounded *irradiance, size_t *parts)
{
    struct borders borders = {
        .potential = emitter->potential, .normal = normal, .tolerance = tolerance / 2, .known = known};
    struct lx_panel items[MOST_PANELS];
    struct lx_panels panels = {.items = items, .capacity = MOST_PANELS};
    *irradiance = lx_exact(0);
    double unsure;
    if (!lx_boundary_walk_source(emitter, normal, occlusion, add_piece, &borders, &unsure) || borders.is_full)
        return false;
    for (size_t i = 0; i < borders.count; i++)
        if (!start_panels(&borders, i, &panels))
            return false;
    const struct lx_integrand integrand = {.at = step_at, .target = target, .data = &borders, .is_smooth = true};
    const struct lx_integral all = lx_integrate_panels(&integrand, &panels);
    *parts += borders.steps;
    const double greatest = emitter->sky ? lx_sky_greatest(emitter->sky) : 1;
    *irradiance = (lx_bounded){fmax(all.value, 0), all.error + all.inherited + fmax(-all.value, 0) + unsure * greatest};
    return irradiance->error <=
           tolerance * (known + fmax(irradiance->value, FAINT * lx_sky_potential_whole(emitter->potential)));
}
