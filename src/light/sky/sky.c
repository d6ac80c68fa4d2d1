/* SPDX-License-Identifier: MIT */
/* The sky, of one of the types of the CIE, and the uniform ground below the horizon. */
#include "../../base/number.h"
#include "dome.h"
#include "stand.h"

struct sun_parameters {
    uint64_t given;
    struct lx_sun_stand stand;
};

struct sky_parameters {
    uint64_t given;
    unsigned kind;
    struct sun_parameters sun;
    double zenith, horizontal;
    double ground;
    struct lx_ground_ways ways;
};

static const struct lx_parameter sun_parameters[] = {LX_SUN_STAND_PARAMETERS(struct sun_parameters, stand)};

static const struct lx_rule sun_rules[] = {LX_SUN_STAND_RULES};

static void check_sun(const struct lx_check *check, void *parameters)
{
    const struct sun_parameters *sun = parameters;
    lx_check_sun_stand(check, &sun->stand);
}

static const struct lx_table sun_table = {
    .parameters = sun_parameters,
    .count = LX_COUNT(sun_parameters),
    .rules = sun_rules,
    .rule_count = LX_COUNT(sun_rules),
    .size = sizeof(struct sun_parameters),
    .check = check_sun,
};

static const struct lx_parameter sky_parameters[] = {
    {
        .name = "kind",
        .label = "Kind",
        .type = LX_WHOLE,
        .offset = offsetof(struct sky_parameters, kind),
        .required = true,
        .legal = LX_BETWEEN(1, LX_SKY_KINDS),
        .meaning = "the type of the sky by CIE S 011: 1 overcast, 5 uniform, 12 clear, 1 to 15; 16 is the traditional "
                   "overcast sky, three times as bright in the zenith as at the horizon",
    },
    {
        .name = "sun",
        .label = "Sun",
        .type = LX_GROUP,
        .offset = offsetof(struct sky_parameters, sun),
        .group = &sun_table,
        .meaning = "where the sun stands, which is no part of the sky's light but makes it brighter around; needed "
                   "but for the kinds 1, 3, 5 and 16",
    },
    {
        .name = "zenith",
        .label = "Zenith",
        .type = LX_REAL,
        .offset = offsetof(struct sky_parameters, zenith),
        .unit = LX_UNIT_RADIANCE,
        .legal = LX_FROM(0),
        .meaning = "the radiance, in photometric units the luminance, of the zenith",
    },
    {
        .name = "horizontal",
        .label = "Horizontal irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct sky_parameters, horizontal),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_FROM(0),
        .meaning = "the irradiance, in photometric units the illuminance, of a horizontal plane under the open sky, "
                   "instead of zenith",
    },
    {
        .name = "ground",
        .label = "Ground",
        .type = LX_REAL,
        .offset = offsetof(struct sky_parameters, ground),
        .legal = LX_BETWEEN(0, 1),
        .initial = "0",
        .meaning = "the reflectance of the ground, which shines evenly from below the horizon: with it times the "
                   "horizontal irradiance over pi",
    },
    LX_GROUND_WAYS_PARAMETERS(struct sky_parameters, ways),
};

static const struct lx_rule sky_rules[] = {{LX_RULE_ONE, "zenith", NULL, "zenith|horizontal"}};

static void check_sky(const struct lx_check *check, void *parameters);

static const struct lx_table sky_table = {
    .parameters = sky_parameters,
    .count = LX_COUNT(sky_parameters),
    .rules = sky_rules,
    .rule_count = LX_COUNT(sky_rules),
    .size = sizeof(struct sky_parameters),
    .check = check_sky,
};

static void check_sky(const struct lx_check *check, void *parameters)
{
    const struct sky_parameters *sky = parameters;
    char kind[LX_NUMBER_SIZE];
    lx_check_ground_ways(check, &sky->ways);
    if (lx_sky_has_sun(sky->kind) && !lx_is_given(&sky_table, sky, "sun")) {
        lx_check_report(check, "sun", LX_ALL_OF_IT, LX_MSG_SKY_NEEDS_SUN, LX_ARGS(lx_write_number(sky->kind, kind)));
        lx_check_hint(check, LX_MSG_HINT_SKY_NEEDS_SUN, NULL);
    }
}

static int prepare_sky(const void *parameters, struct lx_emitters *emitters)
{
    const struct sky_parameters *given = parameters;
    double altitude = 90, azimuth = 0, up[3], sun[3];
    if (lx_is_given(&sky_table, given, "sun") &&
        !lx_sun_stands(&sun_table, &given->sun, &given->sun.stand, &altitude, &azimuth))
        return 0;
    lx_way_up(&given->ways, up);
    lx_way_to_sun(&given->ways, lx_is_given(&sky_table, given, "north"), altitude, azimuth, sun);
    const struct lx_sky sky = lx_sky_of_kind(given->kind, up, sun);
    const lx_bounded whole = lx_sky_horizontal(&sky);
    const bool by_zenith = lx_is_given(&sky_table, given, "zenith");
    const lx_bounded zenith =
        by_zenith ? lx_exact(given->zenith) : lx_div(lx_exact(given->horizontal), whole);
    const lx_bounded horizontal = by_zenith ? lx_mul(zenith, whole) : lx_exact(given->horizontal);
    const lx_bounded ground = lx_mul(horizontal, lx_rounded(given->ground / M_PI, 0, 3));
    struct lx_emitter emitter = {.type = LX_DOME, .dome = lx_dome_of_sky(&sky, zenith, ground)};
    return emitter.dome ? lx_emitters_append(emitters, &emitter) : -1;
}

const struct lx_light_kind lx_sky_kind = {
    .variant =
        {
            .name = "sky",
            .meaning = "the sky of a type of the CIE, and the ground below the horizon",
            .example = "{type: sky, kind: 12, sun: {altitude: 40, azimuth: 200}, horizontal: 100, ground: 0.2}",
            .table = &sky_table,
        },
    .prepare = prepare_sky,
    .is_daylight = true,
};
