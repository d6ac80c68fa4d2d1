/* SPDX-License-Identifier: MIT */
/*
 * What a picture carries beside itself, so that it can be computed again: the scene and the settings that decide its
 * bytes, each a text under its own key.
 */
#ifndef LX_SCENE_CARRIED_H
#define LX_SCENE_CARRIED_H

#include <stdbool.h>

#include <luxel/field.h>

#include "../format/tags.h"

#define LX_TAG_QUANTITY "luxel:quantity"
#define LX_TAG_PRECISION "luxel:precision"
#define LX_TAG_TOLERANCE "luxel:tolerance"
#define LX_TAG_LIGHT_ERROR "luxel:light-error"
#define LX_TAG_REFLECTED_ERROR "luxel:reflected-error"
#define LX_TAG_UNIT "luxel:unit"
#define LX_TAG_SCENE "luxel:scene"
enum { LX_CARRIED_TAGS = 7 };

/* The words for luxel_quantity and luxel_precision, in their order; NULL behind the last. */
extern const char *const lx_carried_quantities[], *const lx_carried_precisions[];

struct lx_carried {
    bool exists; /* false: all that follows is the default */
    luxel_quantity quantity;
    luxel_precision precision;
    double tolerance, light_error, reflected_error; /* 0: the default */
};

/*
 * The settings that the tags of a picture tell; what they do not tell is the default.
 * A value that means nothing here is refused at the source.
 */
luxel_status lx_carried_read(struct lx_source *source, const struct lx_tags *tags, struct lx_carried *carried);

#endif
