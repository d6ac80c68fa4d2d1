/* SPDX-License-Identifier: MIT */
/*
 * The scene: the document that the user wrote (a tree with places) and, once committed, the structs decoded
 * from it through the parameter tables.
 */
#ifndef LX_SCENE_SCENE_H
#define LX_SCENE_SCENE_H

#include <luxel/field.h>
#include <luxel/scene.h>

#include "../light/colour.h"
#include "../material/material.h"
#include "../parameter/table.h"
#include "limits.h"

enum lx_units { LX_RADIOMETRIC, LX_PHOTOMETRIC };

enum lx_shadows { LX_SHADOWS_ALL, LX_SHADOWS_POINTS, LX_SHADOWS_NONE };
enum lx_channels { LX_GREY, LX_RGB };
enum lx_reflections { LX_REFLECTIONS_NONE, LX_REFLECTIONS_ALL };
enum lx_sampling { LX_CENTERS, LX_NODES };
enum lx_projection { LX_ORTHOGRAPHIC, LX_PERSPECTIVE };
enum lx_view { LX_VIEW_PARALLEL, LX_VIEW_OBSERVER };
enum lx_range { LX_RANGE_MAX, LX_RANGE_MINMAX, LX_RANGE_LOG };
enum lx_rounding { LX_TRUNCATE, LX_NEAREST };

/* What a quantity is called: brightness and irradiance, or luminance and illuminance; a phrase. */
const char *lx_quantity_word(luxel_quantity quantity, bool photometric);

/* The sentence about a quantity, of those that name brightness, luminance, irradiance and illuminance; a phrase. */
const char *lx_by_quantity(luxel_quantity quantity, bool photometric, const char *const sentences[4]);

struct lx_screen {
    uint64_t given;
    double width_mm, height_mm;
    unsigned resolution[2]; /* columns, rows */
    int sampling;           /* enum lx_sampling */
};

struct lx_observer {
    uint64_t given;
    double z_mm;                         /* without a position */
    double position_mm[3], target_mm[3]; /* instead of z */
    double up[3];
    int projection; /* enum lx_projection */
    int view;       /* enum lx_view */
};

struct lx_picture {
    uint64_t given;
    struct lx_choice_or_pair range; /* enum lx_range, or the pair */
    int rounding;                   /* enum lx_rounding */
};

/* A measuring plane: the irradiance at the centres of its cells is asked for. */
struct lx_grid {
    uint64_t given;
    const char *name; /* NULL where it has none */
    double center_mm[3];
    double size_mm[2];
    double axis[3], up[3]; /* as of a rectangle: the normal of the elements; along the rows' order */
    const char *surface;   /* NULL: it lies where it says; else the above are those of a side of it */
    const char *side;      /* NULL: none is named */
    double border_mm;
    double surround_mm, background_mm; /* the widths of the areas around it; 0: not asked for */
    unsigned n[2];                     /* columns, rows; as the spacing says where they are not given */
    int spacing;
    int measure; /* enum lx_measure */
    struct lx_grid_limits limits;
};

/* The keys that every surface and every light has beside those of its kind. */
struct lx_surface_common {
    uint64_t given;
    const char *name;
    struct lx_material material;
};

struct lx_light_common {
    uint64_t given;
    const char *name;  /* NULL where it has none */
    const char *group; /* that it is dimmed with; NULL: none */
    bool enabled;
    struct lx_light_color color; /* meaningful where given */
};

/* How the lights of a group are dimmed. */
struct lx_dimming {
    uint64_t given;
    const char *name;
    double factor;
};

/* The whole authored scene; lx_scene_table describes it. */
struct lx_scene_parameters {
    uint64_t given;
    unsigned luxel;
    int units;                             /* enum lx_units */
    int channels;                          /* enum lx_channels */
    int shadows;                           /* enum lx_shadows */
    struct lx_choice_or_whole reflections; /* enum lx_reflections, or the number of bounces */
    unsigned mirrors;                      /* how many in a row are counted */
    double maintenance;                    /* of all lights */
    struct lx_screen screen;
    struct lx_observer observer;
    struct lx_list surfaces; /* variants are lx_surface_kind, common lx_surface_common */
    struct lx_list lights;   /* variants are lx_light_kind, common lx_light_common */
    struct lx_points points;
    struct lx_picture picture;
    struct lx_groups grids;           /* of struct lx_grid */
    struct lx_groups dimming;         /* of struct lx_dimming */
    struct lx_groups glare_observers; /* of struct lx_glare_observer: the key `observers` */
    unsigned channel;                 /* of materials' colours, from 1; 0: their luminance (colours.h); no key */
};

extern const struct lx_table lx_scene_table, lx_grid_table, lx_dimming_table;

/* The share of its light that a light gives by its group; 1 without one. */
double lx_dimming_of(const struct lx_scene_parameters *scene, const struct lx_item *light);

/* How many materials free elements may name: those of the surfaces, else that which has all keys by default. */
static inline size_t lx_material_count(const struct lx_scene_parameters *scene)
{
    return scene->surfaces.count > 0 ? scene->surfaces.count : 1;
}

/* Whether a scene's numbers are ahead of its text (bind.h), so that its text does not repeat it. */
bool lx_scene_is_ahead(const luxel_scene *scene);

/* The name of the law that a light shines by, where that is no physical one; else NULL. */
const char *lx_foreign_law(const struct lx_item *light);

/* A place to keep what the surfaces of a committed scene reflect, for whoever asks next; NULL: there is none. */
struct lx_kept_slot *lx_scene_reflected(const luxel_scene *scene);
/* What the scene kept that this one is a copy of, but for observer, screen, points and picture, as one more user; NULL:
 * nothing. */
struct lx_kept *lx_scene_reflected_elsewhere(const luxel_scene *scene);
/* A place to keep what they reflect to the measuring plane, or the places, that were asked for last. */
struct lx_kept_slot *lx_scene_reflected_on_plane(const luxel_scene *scene);

/* The decoded parameters of a committed scene, NULL before; they live until the scene changes. */
const struct lx_scene_parameters *lx_scene_parameters(const luxel_scene *scene);

#endif
