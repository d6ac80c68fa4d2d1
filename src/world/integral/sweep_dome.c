/* SPDX-License-Identifier: MIT */
/*
 * The sweeps of a round end, half of a ball that goes on as a cylinder: of what is seen of the ball the part beyond the
 * circle where the two meet.
 *
 * With the way c to the ball's centre, p at right angles to it towards the end's axis a, s the sine of half the angle
 * under which the ball is seen and k its cosine, the circle meets the outline at the angles +-phi from p,
 *
 *     cos phi = (s/k) (a.c)/(a.p)
 *
 * which is the arc at tan t = tan phi/k of those that run along p.  Between them arcs begin on the circle; beyond them
 * they are whole where the end looks to the element, and empty where it does not.
 */
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "sweep_make.h"

static int append_part(struct lx_sweeps *sweeps, struct lx_sweep *model, enum lx_sweep_kind kind, double from,
                       double to)
{
    model->kind = kind;
    model->angle1 = from;
    model->angle = to - from;
    return to > from ? lx_sweeps_append(sweeps, model) : 0;
}

static int sweep_dome(const double center_mm[3], const double axis[3], double radius_mm, const double place_mm[3],
                      struct lx_sweeps *sweeps)
{
    double towards[3], beside[3];
    for (int i = 0; i < 3; i++)
        towards[i] = center_mm[i] - place_mm[i];
    const double distance = lx_sweep_normalize(towards), sine = radius_mm / distance;
    const double cosine = sqrt((1 - sine) * (1 + sine)), facing = lx_dot(axis, towards);
    lx_cross(axis, towards, beside);
    const double across = lx_sweep_normalize(beside), edge = sine * facing / (cosine * across);
    if (!(fabs(edge) < 1))
        return 0;
    struct lx_sweep model = {
        .frame = lx_sweep_frame_about(towards, beside), .height_mm = distance, .radius_mm = radius_mm};
    memcpy(model.pole, axis, sizeof model.pole);
    const double turn = atan2(sqrt((1 - edge) * (1 + edge)), fabs(edge) * cosine);
    if (append_part(sweeps, &model, LX_SWEEP_DOME, -turn, 0) || append_part(sweeps, &model, LX_SWEEP_DOME, 0, turn))
        return -1;
    if (facing > 0)
        return 0;
    return append_part(sweeps, &model, LX_SWEEP_BALL, -M_PI_2, -turn) ||
                   append_part(sweeps, &model, LX_SWEEP_BALL, turn, M_PI_2)
               ? -1
               : 0;
}

int lx_sweep_round_ends(const struct lx_emitter *capsule, const double caps[2][3], const double axis[3], double along,
                        double away, const double place_mm[3], const double across[3], struct lx_sweeps *sweeps)
{
    const double backwards[3] = {-axis[0], -axis[1], -axis[2]};
    if (away > capsule->radius_mm)
        return sweep_dome(caps[0], axis, capsule->radius_mm, place_mm, sweeps) ||
                       sweep_dome(caps[1], backwards, capsule->radius_mm, place_mm, sweeps)
                   ? -1
                   : 0;
    struct lx_emitter end = *capsule;
    memcpy(end.center_mm, caps[along > 0], sizeof end.center_mm);
    return lx_sweep_ball(&end, place_mm, across, sweeps);
}

/*
 * Where the arc of the ball crosses the circle on its near side.  In the half plane of the arc, with u and v from the
 * centre along e(beta) and the pole, and the centre w beside it, the circle's plane is u a.e + v a.z = w a.n.
 */
struct lx_arc lx_dome_arc(const struct lx_sweep *dome, struct lx_arc arc)
{
    double n[3];
    lx_cross(arc.direction, dome->frame.z, n);
    const double d = dome->height_mm, r = dome->radius_mm, w = d * lx_dot(n, dome->frame.x);
    const double middle = d * lx_dot(arc.direction, dome->frame.x);
    const double u = lx_dot(dome->pole, arc.direction), v = lx_dot(dome->pole, dome->frame.z);
    const double size = hypot(u, v), foot = w * lx_dot(dome->pole, n) / size;
    const double reach = sqrt(fmax((r - w) * (r + w) - foot * foot, 0));
    /* of the two places the nearer one, the line running along (v, -u) */
    const double at_u = (foot * u - reach * fabs(v)) / size, at_v = (foot * v + copysign(reach, v) * u) / size;
    const double begin = atan2(at_v, middle + at_u), end = arc.from + arc.width;
    arc.from = fmin(fmax(begin, arc.from), end);
    arc.width = end - arc.from;
    return arc;
}
