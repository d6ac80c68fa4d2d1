/* SPDX-License-Identifier: MIT */
/* Cutting disks, balls and cylinders into parts of equal area, each a Lambertian point. */
#include <math.h>

#include "../../base/pose.h"
#include "../law.h"
#include "round.h"

/* Directions at right angles. */
struct frame {
    double across[3], upward[3], axis[3];
};

static struct frame frame_of(const struct lx_emitter *emitter)
{
    double axis[3] = {0, 0, 1}, up[3];
    if (lx_has_axis(emitter))
        axis[0] = emitter->axis.x.value, axis[1] = emitter->axis.y.value, axis[2] = emitter->axis.z.value;
    lx_usual_up(axis, up);
    struct lx_pose pose = lx_pose_of(axis, up);
    struct frame frame;
    lx_wide3_values(pose.across, frame.across);
    lx_wide3_values(pose.upward, frame.upward);
    lx_wide3_values(pose.axis, frame.axis);
    return frame;
}

/* What all parts of one side have in common. */
struct cut {
    const struct lx_emitter *emitter;
    struct frame frame;
    double strength; /* of each part */
    struct lx_emitters *emitters;
};

/* A part at a place and with a normal, both by their components in the frame, the place from the centre. */
static int add_part(const struct cut *cut, const double offset[3], const double normal[3])
{
    struct lx_emitter part = {
        .type = LX_POINT,
        .strength = cut->strength,
    };
    double direction[3];
    lx_law_copy(cut->emitter, &part);
    for (int i = 0; i < 3; i++) {
        const double along[3] = {cut->frame.across[i], cut->frame.upward[i], cut->frame.axis[i]};
        part.position_mm[i] =
            cut->emitter->center_mm[i] + offset[0] * along[0] + offset[1] * along[1] + offset[2] * along[2];
        direction[i] = normal[0] * along[0] + normal[1] * along[1] + normal[2] * along[2];
    }
    part.profile = lx_profile_cosine(lx_unit3(lx_exact3(direction)), 1);
    return lx_emitters_append(cut->emitters, &part);
}

static double part_strength(const struct lx_emitter *emitter, double area_mm2, unsigned parts)
{
    return emitter->radiance.value * (area_mm2 / 1e6) / parts / parts;
}

/* A disk at a height along the axis, shining along it by its sign: the point is the middle of mass of its part. */
static int cut_disk(struct cut *cut, double height_mm, double sign, unsigned parts)
{
    double radius = cut->emitter->radius_mm, sector = 2 * M_PI / parts;
    double inwards = parts > 1 ? sin(sector / 2) / (sector / 2) : 0;
    cut->strength = part_strength(cut->emitter, M_PI * radius * radius, parts);
    for (unsigned ring = 0; ring < parts; ring++) {
        double inner = sqrt((double)ring / parts), outer = sqrt((ring + 1.0) / parts);
        double middle = 2.0 / 3 * (outer * outer + outer * inner + inner * inner) / (outer + inner);
        for (unsigned k = 0; k < parts; k++) {
            double angle = sector * (k + 0.5), distance = radius * middle * inwards;
            const double offset[3] = {distance * cos(angle), distance * sin(angle), height_mm};
            if (add_part(cut, offset, (const double[]){0, 0, sign}))
                return -1;
        }
    }
    return 0;
}

static int cut_ball(struct cut *cut, unsigned parts)
{
    double radius = cut->emitter->radius_mm;
    cut->strength = part_strength(cut->emitter, 4 * M_PI * radius * radius, parts);
    for (unsigned band = 0; band < parts; band++)
        for (unsigned k = 0; k < parts; k++) {
            double z = 1 - (2 * band + 1.0) / parts, across = sqrt((1 - z) * (1 + z)),
                   angle = 2 * M_PI * (k + 0.5) / parts;
            const double normal[3] = {across * cos(angle), across * sin(angle), z};
            const double offset[3] = {radius * normal[0], radius * normal[1], radius * normal[2]};
            if (add_part(cut, offset, normal))
                return -1;
        }
    return 0;
}

static int cut_side(struct cut *cut, unsigned parts)
{
    double radius = cut->emitter->radius_mm, height = cut->emitter->height_mm;
    cut->strength = part_strength(cut->emitter, 2 * M_PI * radius * height, parts);
    for (unsigned level = 0; level < parts; level++)
        for (unsigned k = 0; k < parts; k++) {
            double angle = 2 * M_PI * (k + 0.5) / parts;
            const double normal[3] = {cos(angle), sin(angle), 0};
            const double offset[3] = {radius * normal[0], radius * normal[1], height * ((level + 0.5) / parts - 0.5)};
            if (add_part(cut, offset, normal))
                return -1;
        }
    return 0;
}

static struct cut cut_of(const struct lx_emitter *emitter, struct lx_emitters *emitters)
{
    return (struct cut){.emitter = emitter, .frame = frame_of(emitter), .emitters = emitters};
}

int lx_disk_cut(const struct lx_emitter *disk, unsigned parts, struct lx_emitters *emitters)
{
    struct cut cut = cut_of(disk, emitters);
    return cut_disk(&cut, 0, 1, parts);
}

int lx_ball_cut(const struct lx_emitter *ball, unsigned parts, struct lx_emitters *emitters)
{
    struct cut cut = cut_of(ball, emitters);
    return cut_ball(&cut, parts);
}

int lx_cylinder_cut(const struct lx_emitter *cylinder, unsigned parts, struct lx_emitters *emitters)
{
    struct cut cut = cut_of(cylinder, emitters);
    const double half = cylinder->height_mm / 2;
    if (cut_side(&cut, parts) || cut_disk(&cut, half, 1, parts))
        return -1;
    return cut_disk(&cut, -half, -1, parts);
}
