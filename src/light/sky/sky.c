/* SPDX-License-Identifier: MIT */
/* The sky, of one of the types of the CIE or of Perez's all-weather model, and the uniform ground below the horizon. */
#include "../../base/number.h"
#include "dome.h"
#include "perez.h"
#include "position.h"
#include "stand.h"

struct sun_parameters {
    uint64_t given;
    struct lx_sun_stand stand;
};

enum model { CIE, PEREZ };

static const char *const model_names[] = {"cie", "perez", NULL};

struct sky_parameters {
    uint64_t given;
    int model;
    unsigned kind;
    struct sun_parameters sun;
    double zenith, horizontal;
    double direct, diffuse, extraterrestrial;
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
        .name = "model",
        .label = "Model",
        .type = LX_CHOICE,
        .offset = offsetof(struct sky_parameters, model),
        .choices = model_names,
        .initial = "cie",
        .meaning =
            "where its distribution comes from: one of the types of the CIE by kind, or the all-weather model of "
            "Perez by direct and diffuse",
    },
    {
        .name = "kind",
        .label = "Kind",
        .type = LX_WHOLE,
        .offset = offsetof(struct sky_parameters, kind),
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
        .name = "direct",
        .label = "Direct irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct sky_parameters, direct),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_FROM(0),
        .meaning = "of model perez: what the sun gives to a plane that faces it; it shapes the sky, but the sun is a "
                   "light of its own",
    },
    {
        .name = "diffuse",
        .label = "Diffuse irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct sky_parameters, diffuse),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_ABOVE(0),
        .meaning = "of model perez: what the sky gives to a horizontal plane, instead of zenith and horizontal",
    },
    {
        .name = "extraterrestrial",
        .label = "Extraterrestrial irradiance",
        .type = LX_REAL,
        .offset = offsetof(struct sky_parameters, extraterrestrial),
        .unit = LX_UNIT_IRRADIANCE,
        .legal = LX_ABOVE(0),
        .initial = "1367",
        .meaning = "of model perez: what the sun gives outside of the atmosphere at its mean distance, in the unit of "
                   "direct and diffuse: 1367 W/m2, in photometric units 127500 lx",
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

static const struct lx_rule sky_rules[] = {
    {LX_RULE_NEEDED, "kind", "model", "cie"},
    {LX_RULE_USED, "kind", "model", "cie"},
    {LX_RULE_NEEDED, "sun", "model", "perez"},
    {LX_RULE_NEEDED, "direct", "model", "perez"},
    {LX_RULE_NEEDED, "diffuse", "model", "perez"},
    {LX_RULE_USED, "direct", "model", "perez"},
    {LX_RULE_USED, "extraterrestrial", "model", "perez"},
    {LX_RULE_ONE, "zenith", NULL, "zenith|horizontal|diffuse"},
};

static void check_sky(const struct lx_check *check, void *parameters);

static const struct lx_table sky_table = {
    .parameters = sky_parameters,
    .count = LX_COUNT(sky_parameters),
    .rules = sky_rules,
    .rule_count = LX_COUNT(sky_rules),
    .size = sizeof(struct sky_parameters),
    .check = check_sky,
};

/* Altitude and azimuth of the sun, in the zenith where it is not given; false: the date cannot be read. */
static bool find_sun(const struct sky_parameters *sky, double *altitude_deg, double *azimuth_deg)
{
    *altitude_deg = 90, *azimuth_deg = 0;
    return !lx_is_given(&sky_table, sky, "sun") ||
           lx_sun_stands(&sun_table, &sky->sun, &sky->sun.stand, altitude_deg, azimuth_deg);
}

static bool find_perez(const struct sky_parameters *sky, double altitude_deg, struct lx_perez *perez)
{
    struct lx_weather weather = {sky->direct, sky->diffuse, sky->extraterrestrial, altitude_deg};
    double julian;
    if (lx_is_given(&sun_table, &sky->sun, "date") && lx_read_date(sky->sun.stand.date, &julian))
        weather.extraterrestrial *= lx_sun_nearness(julian);
    return lx_perez_find(&weather, perez);
}

static void check_perez(const struct lx_check *check, const struct sky_parameters *sky)
{
    double altitude, azimuth;
    struct lx_perez perez;
    char first[LX_NUMBER_SIZE], second[LX_NUMBER_SIZE];
    if (!lx_is_given(&sky_table, sky, "sun") || !lx_is_given(&sky_table, sky, "direct") || !(sky->diffuse > 0) ||
        !find_sun(sky, &altitude, &azimuth) || !(altitude > 0))
        return;
    const bool is_found = find_perez(sky, altitude, &perez);
    if (sky->direct > sky->extraterrestrial) {
        lx_check_report(check, "direct", LX_ALL_OF_IT, LX_MSG_PEREZ_DIRECT,
                        LX_ARGS(lx_write_digits(sky->extraterrestrial, 6, first)));
        return;
    }
    if (is_found)
        return;
    lx_check_report(check, "diffuse", LX_ALL_OF_IT, LX_MSG_PEREZ_RANGE,
                    LX_ARGS(lx_write_digits(perez.clearness, 4, first), lx_write_digits(perez.brightness, 4, second)));
    if (perez.diffuse[0] < perez.diffuse[1] && !(sky->diffuse >= perez.diffuse[0] && sky->diffuse <= perez.diffuse[1]))
        lx_check_hint(
            check, LX_MSG_HINT_PEREZ_RANGE,
            LX_ARGS(lx_write_digits(perez.diffuse[0], 4, first), lx_write_digits(perez.diffuse[1], 4, second)));
    else
        lx_check_hint(check, LX_MSG_HINT_PEREZ_NONE, NULL);
}

static void check_sky(const struct lx_check *check, void *parameters)
{
    const struct sky_parameters *sky = parameters;
    char kind[LX_NUMBER_SIZE];
    lx_check_ground_ways(check, &sky->ways);
    if (sky->model == PEREZ) {
        check_perez(check, sky);
    } else if (lx_is_given(&sky_table, sky, "diffuse")) {
        lx_check_report(check, "diffuse", LX_ALL_OF_IT, LX_MSG_PEREZ_ONLY, NULL);
        lx_check_hint(check, LX_MSG_HINT_PEREZ_ONLY, NULL);
    } else if (lx_sky_has_sun(sky->kind) && !lx_is_given(&sky_table, sky, "sun")) {
        lx_check_report(check, "sun", LX_ALL_OF_IT, LX_MSG_SKY_NEEDS_SUN, LX_ARGS(lx_write_number(sky->kind, kind)));
        lx_check_hint(check, LX_MSG_HINT_SKY_NEEDS_SUN, NULL);
    }
}

static int prepare_sky(const void *parameters, struct lx_emitters *emitters)
{
    const struct sky_parameters *given = parameters;
    double altitude, azimuth, up[3], sun[3];
    struct lx_perez perez;
    if (!find_sun(given, &altitude, &azimuth) || (given->model == PEREZ && !find_perez(given, altitude, &perez)))
        return 0;
    lx_way_up(&given->ways, up);
    lx_way_to_sun(&given->ways, lx_is_given(&sky_table, given, "north"), altitude, azimuth, sun);
    const struct lx_sky sky =
        given->model == PEREZ ? lx_sky_of_perez(perez.coefficients, up, sun) : lx_sky_of_kind(given->kind, up, sun);
    const lx_bounded whole = lx_sky_horizontal(&sky);
    const bool by_zenith = lx_is_given(&sky_table, given, "zenith");
    const double level = given->model == PEREZ ? given->diffuse : given->horizontal;
    const lx_bounded zenith = by_zenith ? lx_exact(given->zenith) : lx_div(lx_exact(level), whole);
    const lx_bounded horizontal = by_zenith ? lx_mul(zenith, whole) : lx_exact(level);
    const lx_bounded ground = lx_mul(horizontal, lx_rounded(given->ground / M_PI, 0, 3));
    struct lx_emitter emitter = {.type = LX_DOME, .dome = lx_dome_of_sky(&sky, zenith, ground)};
    return emitter.dome ? lx_emitters_append(emitters, &emitter) : -1;
}

const struct lx_light_kind lx_sky_kind = {
    .variant =
        {
            .name = "sky",
            .meaning = "the sky, of a type of the CIE or by the weather, and the ground below the horizon",
            .example = "{type: sky, kind: 12, sun: {altitude: 40, azimuth: 200}, horizontal: 100, ground: 0.2}",
            .table = &sky_table,
        },
    .prepare = prepare_sky,
    .is_daylight = true,
};
