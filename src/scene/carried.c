/* SPDX-License-Identifier: MIT */
/* The settings that a picture carries, read from its texts and handed to who computes it again. */
#include "carried.h"

#include <string.h>

#include <luxel/render.h>

#include "../base/number.h"
#include "object.h"

const char *const lx_carried_quantities[] = {"brightness", "irradiance", NULL};
const char *const lx_carried_precisions[] = {"single", "double", NULL};

static luxel_status refuse(struct lx_source *source, const struct lx_read_tag *tag, const char *expected)
{
    return lx_source_refuse(source, LX_MSG_BAD_CARRIED, LX_ARGS(tag->key, tag->value, expected));
}

/* The number of the word that a tag says; 0 where there is no such tag. */
static luxel_status read_word(struct lx_source *source, const struct lx_tags *tags, const char *key,
                              const char *const *words, size_t *found)
{
    const struct lx_read_tag *tag = lx_tags_find(tags, key);
    *found = 0;
    if (!tag)
        return LUXEL_OK;
    while (words[*found] && strcmp(tag->value, words[*found]) != 0)
        ++*found;
    return words[*found] && strlen(tag->value) == tag->length
               ? LUXEL_OK
               : refuse(source, tag, words == lx_carried_quantities ? "brightness, irradiance" : "single, double");
}

/* A number from 0 to below 1; 0 where there is no such tag. */
static luxel_status read_share(struct lx_source *source, const struct lx_tags *tags, const char *key, double *number)
{
    const struct lx_read_tag *tag = lx_tags_find(tags, key);
    *number = 0;
    if (!tag || (lx_read_number(tag->value, tag->length, number) && *number >= 0 && *number < 1))
        return LUXEL_OK;
    return refuse(source, tag, "0 <= x < 1");
}

luxel_status lx_carried_read(struct lx_source *source, const struct lx_tags *tags, struct lx_carried *carried)
{
    size_t quantity, precision;
    luxel_status status = read_word(source, tags, LX_TAG_QUANTITY, lx_carried_quantities, &quantity);
    if (status == LUXEL_OK)
        status = read_word(source, tags, LX_TAG_PRECISION, lx_carried_precisions, &precision);
    if (status == LUXEL_OK)
        status = read_share(source, tags, LX_TAG_TOLERANCE, &carried->tolerance);
    if (status == LUXEL_OK)
        status = read_share(source, tags, LX_TAG_LIGHT_ERROR, &carried->light_error);
    if (status == LUXEL_OK)
        status = read_share(source, tags, LX_TAG_REFLECTED_ERROR, &carried->reflected_error);
    if (status != LUXEL_OK)
        return status;
    carried->exists = true;
    carried->quantity = quantity == 0 ? LUXEL_BRIGHTNESS : LUXEL_IRRADIANCE;
    carried->precision = precision == 0 ? LUXEL_SINGLE : LUXEL_DOUBLE;
    return LUXEL_OK;
}

bool luxel_scene_settings(const luxel_scene *scene, luxel_settings *settings)
{
    if (!scene || !settings || !scene->carried.exists)
        return false;
    settings->quantity = scene->carried.quantity;
    settings->precision = scene->carried.precision;
    settings->tolerance = scene->carried.tolerance;
    settings->light_error = scene->carried.light_error;
    settings->reflected_error = scene->carried.reflected_error;
    return true;
}
