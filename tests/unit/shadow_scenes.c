/* SPDX-License-Identifier: MIT */
/* Texts of random scenes with shadows. */
#include "shadow_scenes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

double dice_uniform(struct dice *dice, double low, double high)
{
    dice->state ^= dice->state >> 12;
    dice->state ^= dice->state << 25;
    dice->state ^= dice->state >> 27;
    return low + (high - low) * ((double)((dice->state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

int dice_pick(struct dice *dice, int count)
{
    return (int)dice_uniform(dice, 0, count);
}

#define ADD(text, ...)                                                                                                 \
    ((text)->length += (size_t)snprintf((text)->words + (text)->length, MOST_TEXT - (text)->length, __VA_ARGS__))

static void add_vector(struct text *text, const char *key, const double v[3])
{
    ADD(text, "%s: [%.17g, %.17g, %.17g], ", key, v[0], v[1], v[2]);
}

static void random_axis(struct dice *dice, double axis[3])
{
    for (int k = 0; k < 3; k++)
        axis[k] = dice_uniform(dice, -1, 1);
    if (dice_pick(dice, 4) == 0) /* along an axis */
        memcpy(axis, (const double[3][3]){{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}[dice_pick(dice, 3)], 3 * sizeof *axis);
}

static void add_surface(struct text *text, struct dice *dice, int kind, const double center[3])
{
    static const char *const names[] = {"sphere", "rectangle", "disk", "cylinder"};
    double axis[3], size = pow(10, dice_uniform(dice, 1, 2.8));
    random_axis(dice, axis);
    if (kind != CYLINDER) /* its front has to look to the observer */
        axis[2] = fabs(axis[2]) + 1e-3;
    ADD(text, "  - {type: %s, ", names[kind]);
    add_vector(text, "center", center);
    if (kind != SPHERE)
        add_vector(text, "axis", axis);
    if (kind == RECTANGLE)
        ADD(text, "size: [%.17g, %.17g]}\n", size, size * dice_uniform(dice, 0.1, 3));
    else
        ADD(text, "radius: %.17g", size / 2);
    if (kind == CYLINDER)
        ADD(text, ", height: %.17g", size * dice_uniform(dice, 0.2, 4));
    if (kind != RECTANGLE)
        ADD(text, "}\n");
}

static void add_source(struct text *text, struct dice *dice, int kind, const double center[3])
{
    static const char *const laws[] = {"inverse-square", "inverse-square", "none", "practical, k: 300",
                                       "polynomial, coefficients: [0.1, 0.5, 1]"};
    double axis[3], size = pow(10, dice_uniform(dice, 1.5, 3));
    random_axis(dice, axis);
    axis[2] = dice_pick(dice, 3) ? -1 - fabs(axis[2]) : axis[2];
    ADD(text, "  - {type: %s, attenuation: %s, radiance: 1, ", kind < BOX ? "planar" : "volume",
        laws[dice_pick(dice, 5)]);
    if (kind == WINDOW) {
        ADD(text, "rectangle: {size: [%.17g, %.17g], ", size, size * dice_uniform(dice, 0.1, 2));
        add_vector(text, "center", center);
        add_vector(text, "axis", axis);
        ADD(text, "}}\n");
    } else if (kind == POLYGON) {
        ADD(text, "vertices: [");
        for (int i = 0; i < 5; i++)
            ADD(text, "[%.17g, %.17g, %.17g], ", center[0] + size / 2 * cos(-1.2566370614359172 * i),
                center[1] + size / 3 * sin(-1.2566370614359172 * i), center[2]);
        ADD(text, "]}\n");
    } else if (kind == BOX) {
        ADD(text, "box: {size: [%.17g, %.17g, %.17g], ", size, size * dice_uniform(dice, 0.3, 1), size / 2);
        add_vector(text, "center", center);
        ADD(text, "}}\n");
    } else {
        ADD(text, "%s: {radius: %.17g, ", kind == LAMP ? "disk" : kind == GLOBE ? "sphere" : "cylinder", size / 2);
        add_vector(text, "center", center);
        if (kind != GLOBE)
            add_vector(text, "axis", axis);
        if (kind == TUBE)
            ADD(text, "height: %.17g", size * dice_uniform(dice, 0.2, 3));
        ADD(text, "}}\n");
    }
}

static const char *material(struct dice *dice, bool glossy)
{
    static const char *const glosses[] = {
        "{diffuse: 0.5}", "{model: phong, shininess: 60}", "{shininess: 400, highlight: gated}",
        "{highlight: cosine, over_pi: true, shininess: 8}", "{diffuse: 0, shininess: 5}"};
    return glossy ? glosses[dice_pick(dice, 5)] : "{model: lambert, diffuse: 1}";
}

struct text shadow_scene(struct dice *dice, int kind, int source, bool glossy, double size_mm)
{
    struct text text = {.length = 0};
    ADD(&text,
        "luxel: 1\nshadows: all\nscreen: {width: %.17g, height: %.17g, resolution: [30, 30]}\n"
        "observer: {z: 90000}\nsurfaces:\n"
        "  - {type: rectangle, center: [0, 0, 0], size: [%.17g, %.17g], material: %s}\n",
        size_mm, size_mm, 4 * size_mm, 4 * size_mm, material(dice, glossy));
    const double center[3] = {dice_uniform(dice, -600, 600), dice_uniform(dice, -600, 600),
                              dice_uniform(dice, 300, 1500)};
    for (int i = dice_pick(dice, 3); i >= 0; i--) {
        const double share = dice_uniform(dice, 0.05, 1.05), spread = 200 * share + 20;
        add_surface(&text, dice, i == 0 ? kind : dice_pick(dice, KINDS),
                    (const double[]){share * center[0] + dice_uniform(dice, -spread, spread),
                                     share * center[1] + dice_uniform(dice, -spread, spread), share * center[2]});
    }
    ADD(&text, "lights:\n");
    add_source(&text, dice, source, center);
    return text;
}
