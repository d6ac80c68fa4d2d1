/* SPDX-License-Identifier: MIT */
/*
 * The prepared scene: a committed scene lowered to surfaces with lobes and to emitters.  It points into the
 * scene's parameters, which must outlive it, and is not changed once made.
 */
#ifndef LX_WORLD_PREPARED_H
#define LX_WORLD_PREPARED_H

#include "../light/emitter.h"
#include "../light/sky/dome.h"
#include "../material/lobe.h"
#include "../scene/scene.h"
#include "../surface/part.h"
#include "boxes.h"
#include "camera.h"
#include <luxel/render.h>

/* The tolerance of probes where nothing else is asked for. */
#define LX_DEFAULT_TOLERANCE 1e-9

/* A surface of the scene, or a part of one. */
struct lx_prepared_surface {
    const struct lx_surface_kind *kind;
    const void *parameters; /* in the frame of the scene; NULL in one that was carried */
    struct lx_shape shape;
    double low_mm[3], high_mm[3]; /* its extent */
    const struct lx_material *material;
    struct lx_lobe lobe; /* of it */
    size_t authored;     /* which surface of the scene's list */
    unsigned part;       /* and which part of it; 0 where it is one by itself */
    struct lx_own_parameters own;
    bool is_mirror; /* its front */
};

/* A surface as the scene's list has it. */
struct lx_authored_surface {
    size_t first;        /* its first part among the prepared surfaces */
    struct lx_lobe lobe; /* of its material, whatever its parts have */
};

struct lx_mirror_way;
struct lx_open_domes;
struct lx_potentials;

/* The mirrors among the surfaces, and the ways of light over them (mirrors.h). */
struct lx_mirrors {
    uint32_t *surfaces; /* which are mirrors */
    size_t count;
    uint8_t *sides;             /* of each mirror, how each surface stands to it: enum lx_mirror_side */
    struct lx_mirror_way *ways; /* the shorter before the longer */
    size_t way_count, capacity;
    size_t computed;  /* the first of them are over no more mirrors than are counted; the others are for the bound */
    unsigned deepest; /* how many mirrors the longest are over */
    bool ends;        /* there are no longer ones */
    bool is_short;    /* they are too many */
    /* The pairs of facing planes between which ways go on for ever, at right angles to each other, and how many single
     * planes at right angles to them there are; 0 pairs where that is not all that there is. */
    unsigned pair_count, other_planes;
    double pair_gaps_mm[3], pair_axes[3][3], pair_size_mm;
    /* Two pairs: the axis at right angles to both, how far images are at least that are known by bounds alone, and
     * the sum of 1/d^3 over them, but for what single planes make of each. */
    double third_axis[3], nearest_mm, cubes_per_mm3;
};

/* Whether light or sights may go over more mirrors than are counted. */
static inline bool lx_goes_deeper(const struct lx_mirrors *mirrors)
{
    return mirrors->way_count > mirrors->computed;
}

struct lx_prepared {
    const struct lx_scene_parameters *scene;
    struct lx_camera camera;
    struct lx_prepared_surface *surfaces; /* the parts of all surfaces, in their order */
    size_t surface_count;
    double reach_mm;       /* no coordinate of what they are is larger */
    struct lx_boxes boxes; /* over many of them (among.h) */
    struct lx_authored_surface *authored;
    struct lx_material *colored; /* what materials with colours are in the scene's channel; NULL: all are as they are */
    struct lx_glass_pane *panes; /* the openings of rooms */
    size_t pane_count;
    bool is_glazed;              /* whether there is glass in one of them */
    size_t left_out;             /* 1 more than a surface of the scene's list that hides nothing now; 0: none is */
    bool *on;                    /* which lights of the scene's list give light */
    struct lx_emitters emitters; /* of those, in their order */
    struct lx_mirrors mirrors;
    struct lx_open_domes *open_domes; /* where there is a dome (open_domes.h) */
    struct lx_potentials *potentials; /* there, too (potentials.h) */
    double tolerance;      /* of integrals, relative to the value that they are a part of */
    bool shadows;          /* whether surfaces take light from each other */
    bool shadows_extended; /* whether extended sources are hidden, too, as far as they are */
    bool shadows_on_free;  /* whether they take it from free elements, for which one surface is enough */
};

/*
 * By the tolerance and the group of lights of the settings; NULL: the defaults.  0, or -1 when memory ran out, or where
 * it would not do for so many emitters (prepared->emitters.is_short), or where the work is to stop.  Release with
 * lx_prepared_clear() in any case.
 */
int lx_prepare(const struct lx_scene_parameters *scene, const luxel_settings *settings, const struct lx_asking *asking,
               struct lx_prepared *prepared);
/* The scene with its enabled lights, which has at most so many emitters; else -1, and prepared->emitters.is_short. */
int lx_prepare_few(const struct lx_scene_parameters *scene, double tolerance, size_t most,
                   struct lx_prepared *prepared);
/*
 * The scene in the frame of its screen, in which the observer stands at (0, 0, z) and looks along -z, as pictures are
 * made of it.  But for roundings all is as it was, with the same numbers of surfaces and emitters.  0, or -1 as above.
 */
int lx_prepared_carry(const struct lx_prepared *prepared, const struct lx_asking *asking, struct lx_prepared *carried);
/* The scene in that frame, where that is not its own: then it is put into *carried; else that is NULL, and it is the
 * scene itself.  NULL: memory ran out, or the work is to stop.  Release *carried by lx_prepared_free() anyway. */
const struct lx_prepared *lx_prepared_on_screen(const struct lx_prepared *prepared, const struct lx_asking *asking,
                                                struct lx_prepared **carried);
void lx_prepared_free(struct lx_prepared *carried);

void lx_prepared_clear(struct lx_prepared *prepared);

/* Whether there may be kernels for its light: not of domes, nor where it comes through glass or over mirrors. */
static inline bool lx_prepared_has_kernels(const struct lx_prepared *prepared)
{
    return !prepared->is_glazed && prepared->mirrors.count == 0 && !lx_has_dome(&prepared->emitters);
}

/* The index of a part of a surface of the scene's list, or of the first piece that openings leave of it. */
static inline size_t lx_prepared_index(const struct lx_prepared *prepared, size_t surface, unsigned part)
{
    const size_t first = prepared->authored[surface].first;
    size_t i = first;
    const struct lx_prepared_surface *all = prepared->surfaces;
    while (i < prepared->surface_count && all[i].authored == surface && all[i].part < part)
        i++;
    return i < prepared->surface_count && all[i].authored == surface ? i : first;
}

/* The unit of a quantity in this scene, UTF-8, as the attenuation laws, over_pi and `units` make it. */
const char *lx_unit_of(const struct lx_prepared *prepared, luxel_quantity quantity);
/* The unit of what the settings compute of a committed scene (NULL: the defaults); only its lights are prepared. */
const char *lx_unit_of_scene(const struct lx_scene_parameters *scene, const luxel_settings *settings);

#endif
