/* SPDX-License-Identifier: MIT */
/* The sun: a disk of uniform radiance at no finite distance, or with the diameter 0 parallel light. */
#include "dome.h"
#include "stand.h"

struct sun_parameters {
    uint64_t given;
    double irradiance;
    struct lx_sun_stand stand;
    double diameter_deg;
    struct lx_ground_ways ways;
};

static const struct lx_parameter sun_parameters[] = {
    {
        .name = "irradiance",
        .label = "Irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct sun_parameters, irradiance),
        .unit = LX_UNIT_IRRADIANCE,
        .required = true,
        .legal = LX_FROM(0),
        .meaning = "the irradiance, in photometric units the illuminance, on a plane that faces the sun",
    },
    LX_SUN_STAND_PARAMETERS(struct sun_parameters, stand),
    {
        .name = "diameter",
        .label = "Diameter",
        .type = LX_REAL,
        .offset = offsetof(struct sun_parameters, diameter_deg),
        .unit = LX_UNIT_DEGREES,
        .initial = "0.533",
        .legal = LX_BETWEEN(0, 90),
        .advised = {LX_BETWEEN(0, 10)},
        .meaning = "the angle across its disk, which makes the edges of shadows soft; 0: they are sharp",
    },
    LX_GROUND_WAYS_PARAMETERS(struct sun_parameters, ways),
};

static const struct lx_rule sun_rules[] = {LX_SUN_STAND_RULES};

static void check_sun(const struct lx_check *check, void *parameters)
{
    const struct sun_parameters *sun = parameters;
    lx_check_sun_stand(check, &sun->stand);
    lx_check_ground_ways(check, &sun->ways);
}

static const struct lx_table sun_table = {
    .parameters = sun_parameters,
    .count = LX_COUNT(sun_parameters),
    .rules = sun_rules,
    .rule_count = LX_COUNT(sun_rules),
    .size = sizeof(struct sun_parameters),
    .check = check_sun,
};

static int prepare_sun(const void *parameters, struct lx_emitters *emitters)
{
    const struct sun_parameters *sun = parameters;
    double altitude, azimuth, towards[3];
    if (!lx_sun_stands(&sun_table, sun, &sun->stand, &altitude, &azimuth))
        return 0;
    lx_way_to_sun(&sun->ways, lx_is_given(&sun_table, sun, "north"), altitude, azimuth, towards);
    const double off = 8 * DBL_EPSILON;
    const lx_bounded3 way = {{towards[0], off}, {towards[1], off}, {towards[2], off}};
    struct lx_emitter emitter = {.type = LX_DIRECTION, .strength = sun->irradiance, .towards = way};
    if (sun->diameter_deg > 0) {
        const double half_rad = sun->diameter_deg / 2 * (M_PI / 180);
        emitter = (struct lx_emitter){
            .type = LX_DOME, .towards = way, .dome = lx_dome_of_disk(way, half_rad, sun->irradiance)};
        if (!emitter.dome)
            return -1;
    }
    return lx_emitters_append(emitters, &emitter);
}

const struct lx_light_kind lx_sun_kind = {
    .variant =
        {
            .name = "sun",
            .meaning = "the sun, a disk of uniform radiance beyond all surfaces",
            .example = "{type: sun, irradiance: 800, altitude: 40, azimuth: 200}",
            .table = &sun_table,
        },
    .prepare = prepare_sun,
    .is_daylight = true,
};
