/* SPDX-License-Identifier: MIT */
/* The site of a scene: where on the earth it is and how it lies, as its lights say, and where these have the sun. */
#ifndef LX_LIGHT_SKY_SITE_H
#define LX_LIGHT_SKY_SITE_H

#include <stdbool.h>

struct lx_emitter;
struct lx_item;

/* The ways of the scene that are up and north, of any length. */
struct lx_ground_ways {
    double up[3], north[3];
};

struct lx_sun_site {
    bool has_place; /* and with it a date */
    bool has_sun;   /* in the direction `towards` */
    double latitude_deg, longitude_deg, towards[3];
    struct lx_ground_ways ways;
    bool is_north_given;
};

/* What a light of the scene's list says of it; false: it is neither a sun nor a sky. */
bool lx_sun_site_of(const struct lx_item *light, struct lx_sun_site *site);

/* The site of a scene whose lights say nothing: z is up, y is north. */
struct lx_sun_site lx_sun_site_plain(void);

/* The way to the sun at a Julian date; returns its altitude in degrees. */
double lx_sun_site_look(const struct lx_sun_site *site, double julian, double towards[3]);

/* The sun's middle as parallel light; the disk of sky around a direction, under half the angle `half_rad`, put up so
 * far from a place. */
void lx_sun_as_direction(const double towards[3], struct lx_emitter *emitter);
void lx_sky_disk(const double towards[3], double half_rad, const double place_mm[3], double away_mm,
                 struct lx_emitter *emitter);

#endif
