/* SPDX-License-Identifier: MIT */
/*
 * Tables of luminous intensity completed by their symmetry: of type C all planes of a whole turn, the first of them
 * once more at its end; of types A and B both sides.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "photometry.h"

/* A plane of the complete table, and that of the file which it repeats. */
struct image {
    double angle;
    size_t stored;
};

static int compare_images(const void *first, const void *second)
{
    const struct image *a = first, *b = second;
    return a->angle != b->angle ? (a->angle < b->angle ? -1 : 1) : (a->stored > b->stored) - (a->stored < b->stored);
}

/* An angle from 0 to below 360; one that rounding has brought to 360 is 0. */
static double wrapped(double angle)
{
    double turned = fmod(angle, 360);
    turned += turned < 0 ? 360 : 0;
    return turned < 360 ? turned + 0.0 : 0;
}

/* Adds where a plane stands in the whole turn: at most four places. */
static size_t add_images(luxel_photometry_symmetry symmetry, double angle, size_t stored, struct image *images)
{
    size_t count = 0;
    images[count++] = (struct image){wrapped(angle), stored};
    if (symmetry == LUXEL_SYMMETRY_QUADRANT || symmetry == LUXEL_SYMMETRY_BILATERAL_0)
        images[count++] = (struct image){wrapped(360 - angle), stored};
    if (symmetry == LUXEL_SYMMETRY_QUADRANT || symmetry == LUXEL_SYMMETRY_BILATERAL_90)
        images[count++] = (struct image){wrapped(180 - angle), stored};
    if (symmetry == LUXEL_SYMMETRY_QUADRANT)
        images[count++] = (struct image){wrapped(180 + angle), stored};
    return count;
}

/* The planes of the whole turn, sorted, each once, the first one again at the end; returns how many. */
static size_t turn_images(const struct lx_stored_table *table, luxel_photometry_symmetry symmetry, struct image *images)
{
    static const double SAME = 1e-9; /* degrees */
    size_t count = 0, kept = 0;
    for (size_t i = 0; i < table->plane_count; i++)
        count += add_images(symmetry, symmetry == LUXEL_SYMMETRY_AXIAL ? 0 : table->planes[i], i, images + count);
    qsort(images, count, sizeof *images, compare_images);
    for (size_t i = 0; i < count; i++)
        if (kept == 0 || images[i].angle - images[kept - 1].angle > SAME)
            images[kept++] = images[i];
    if (kept > 1 && images[0].angle + 360 - images[kept - 1].angle <= SAME)
        kept--;
    images[kept] = (struct image){images[0].angle + 360, images[0].stored};
    return kept + 1;
}

/* Both sides of a lateral symmetry. */
static size_t side_images(const struct lx_stored_table *table, struct image *images)
{
    size_t count = 0;
    for (size_t i = table->plane_count; i-- > 0;)
        if (table->planes[i] > 0)
            images[count++] = (struct image){-table->planes[i], i};
    for (size_t i = 0; i < table->plane_count; i++)
        images[count++] = (struct image){table->planes[i] + 0.0, i};
    return count;
}

static size_t plain_images(const struct lx_stored_table *table, struct image *images)
{
    for (size_t i = 0; i < table->plane_count; i++)
        images[i] = (struct image){table->planes[i], i};
    return table->plane_count;
}

bool lx_complete_table(const struct lx_stored_table *table, struct lx_photometry *made)
{
    luxel_photometry *shown = &made->shown;
    size_t angles = table->angle_count;
    struct image *images = lx_new_array(4 * table->plane_count + 1, sizeof *images);
    if (!images)
        return false;
    bool is_whole = table->is_turn && table->planes[0] == 0; /* with its own last plane, should that differ */
    bool is_turn = shown->type == LUXEL_PHOTOMETRY_TYPE_C && !is_whole;
    size_t planes = is_turn                                     ? turn_images(table, shown->symmetry, images)
                    : shown->symmetry == LUXEL_SYMMETRY_LATERAL ? side_images(table, images)
                                                                : plain_images(table, images);
    made->planes = lx_new_array(planes, sizeof *made->planes);
    made->angles = lx_new_array(angles, sizeof *made->angles);
    made->intensities = lx_new_array(planes, angles * sizeof *made->intensities);
    bool is_made = made->planes && made->angles && made->intensities;
    for (size_t i = 0; i < planes && is_made; i++) {
        made->planes[i] = images[i].angle;
        memcpy(made->intensities + i * angles, table->intensities + images[i].stored * angles,
               angles * sizeof *made->intensities);
    }
    if (is_made)
        memcpy(made->angles, table->angles, angles * sizeof *made->angles);
    free(images);
    shown->plane_count = planes;
    shown->angle_count = angles;
    shown->planes = made->planes;
    shown->angles = made->angles;
    shown->intensities = made->intensities;
    return is_made;
}
