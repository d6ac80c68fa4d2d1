/* SPDX-License-Identifier: MIT */
/*
 * Emitters: the few simple sources that every light is made of, and their float64 reference.
 *
 * uniform    adds its irradiance to every element, whatever its normal
 * direction  parallel light: one direction L and one irradiance E_perp
 * point      a point with radiant intensity I, an attenuation law a(r) and an angular profile g (profile.h):
 *            E_perp = I g a(r), r in metres
 * dome       light from directions of the sphere, at no finite distance, with a radiance by direction (sky/dome.h)
 * facets, disk, ball, cylinder
 * area lights of uniform radiance; extended.h says more.  With the profile of a luminaire they are its luminous
 *            opening: each part of them is a point with all of the distribution, and `radiance` says how much
 *            intensity there is for an area
 *
 * The kernels of the shade room hold the same formulas for whole blocks of elements.
 */
#ifndef LX_LIGHT_EMITTER_H
#define LX_LIGHT_EMITTER_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/bounded.h"
#include "profile.h"

/* The kinds, a row each: the type and the descriptor (emitter_kind.h).  Those from facets on are extended. */
#define LX_EMITTER_KINDS(ROW)                                                                                          \
    ROW(LX_UNIFORM, lx_uniform_emitter)                                                                                \
    ROW(LX_DIRECTION, lx_direction_emitter)                                                                            \
    ROW(LX_POINT, lx_point_emitter)                                                                                    \
    ROW(LX_DOME, lx_dome_emitter)                                                                                      \
    ROW(LX_FACETS, lx_facets_emitter)                                                                                  \
    ROW(LX_DISK, lx_disk_emitter)                                                                                      \
    ROW(LX_BALL, lx_ball_emitter)                                                                                      \
    ROW(LX_CYLINDER, lx_cylinder_emitter)

#define LX_EMITTER_TYPE(type, kind) type,
enum lx_emitter_type { LX_EMITTER_KINDS(LX_EMITTER_TYPE) LX_EMITTER_TYPES };
#undef LX_EMITTER_TYPE

struct lx_facets;
struct lx_asking;
struct lx_dome;
struct lx_sky;
struct lx_glass_pane;
struct lx_sky_potential;

/* The attenuation laws a(r): 1/r^2, 1/(k + r), 1, 1/(kc + kl r + kq r^2). */
enum lx_attenuation { LX_INVERSE_SQUARE, LX_PRACTICAL, LX_NO_ATTENUATION, LX_POLYNOMIAL };
enum { LX_LAWS = LX_POLYNOMIAL + 1 };

struct lx_emitter {
    enum lx_emitter_type type;
    size_t light;          /* index of the light in the scene that it belongs to */
    bool is_part;          /* a point that stands for a part of an extended source */
    double strength;       /* irradiance, or a point's radiant intensity, */
    double strength_error; /* which may be off by that */
    lx_bounded3 towards;   /* direction: the unit vector to the light */
    double position_mm[3]; /* point */
    enum lx_attenuation attenuation;
    double k_mm;            /* of the practical law */
    double coefficients[3]; /* kc, kl, kq of the polynomial one, r in metres */
    struct lx_profile profile;
    /* the extended ones: */
    lx_bounded radiance;      /* W/(sr m^2) */
    bool is_back;             /* of an opening: the other side of one that is in the list, with the same area */
    struct lx_facets *facets; /* what it is made of, belongs to the list that the emitter is in; NULL: it is round */
    double center_mm[3];      /* of a round one */
    double radius_mm, height_mm;
    double radii_mm[3]; /* all 0 but of one that is not round (elliptic.h) */
    lx_bounded3 axis;   /* unit: the way a disk shines; along a cylinder */
    const struct lx_sky *sky; /* of a patch of it: its radiance is that times the sky's luminance by direction */
    const struct lx_sky_potential *potential; /* of that, and of the glass before it (world/potentials.h); NULL: none */
    struct lx_dome *dome;     /* a dome; the list is one of its users */
    const struct lx_glass_pane *panes; /* of glass, that its light may come through */
    size_t pane_count;
    const struct lx_glass_pane *through; /* the one of them that all of it comes through; NULL: who knows */
};

/* Irradiance or intensity with its bound. */
static inline lx_bounded lx_strength(const struct lx_emitter *emitter)
{
    return (lx_bounded){emitter->strength, emitter->strength_error};
}

/* The polynomial law at a distance. */
static inline double lx_by_polynomial(const double coefficients[3], double distance_m)
{
    return 1 / (coefficients[0] + distance_m * (coefficients[1] + distance_m * coefficients[2]));
}

/* Whether it shines everywhere from all sides: there is no way to it. */
static inline bool lx_is_uniform(const struct lx_emitter *emitter)
{
    return emitter->type == LX_UNIFORM;
}

/* Whether its light is parallel: the way to it, `towards`, is the same everywhere and has no end. */
static inline bool lx_is_endless(const struct lx_emitter *emitter)
{
    return emitter->type == LX_DIRECTION;
}

/* Whether it shines from one place, `position_mm`, by a profile. */
static inline bool lx_is_point(const struct lx_emitter *emitter)
{
    return emitter->type == LX_POINT;
}

/* Whether its light comes from directions of the sphere, at no distance and by no one way. */
static inline bool lx_is_dome(const struct lx_emitter *emitter)
{
    return emitter->type == LX_DOME;
}

/* Whether it has an area. */
static inline bool lx_is_extended(const struct lx_emitter *emitter)
{
    return emitter->type >= LX_FACETS;
}

/* Whether a place gets all of its light by one way. */
static inline bool lx_has_one_way(const struct lx_emitter *emitter)
{
    return lx_is_point(emitter) || lx_is_endless(emitter);
}

/* Whether it stands somewhere, so that distances from it count. */
static inline bool lx_has_place(const struct lx_emitter *emitter)
{
    return lx_is_point(emitter) || lx_is_extended(emitter);
}

/* Whether it is a side of a luminous opening. */
static inline bool lx_is_opening(const struct lx_emitter *emitter)
{
    return lx_is_extended(emitter) && emitter->profile.luminaire;
}

/* Whether the irradiance of an extended emitter has a closed form. */
static inline bool lx_has_closed_form(const struct lx_emitter *emitter)
{
    return emitter->attenuation == LX_INVERSE_SQUARE && !emitter->profile.luminaire && !emitter->sky &&
           emitter->pane_count == 0;
}

struct lx_cloud;

/* A face cut into so many parts each way becomes a point set: a million emitters would be ten times as large. */
enum { LX_LEAST_IN_POINT_SET = 64 };

/* Many points that differ in place, intensity and, where they are aimed, axis: as the rows of a cloud say. */
struct lx_point_set {
    const struct lx_cloud *cloud; /* outlives the list, */
    bool is_owned;                /* or is the list's */
    struct lx_emitter model;      /* all else */
    bool is_aimed;
    double aim_mm[3];
    double strength_error; /* relative: by how much each row's strength may be off */
    size_t first, end;     /* which emitters of the list they are */
};

/*
 * A growing list; zero-initialise, free with lx_emitters_clear().  lx_emitter_at() gives each by its number; all but
 * the points of point sets are items.
 */
struct lx_emitters {
    struct lx_emitter *items;
    size_t count, capacity; /* the count includes those of point sets */
    struct lx_point_set *point_sets;
    size_t point_set_count, point_set_capacity, in_point_sets;
    size_t faces;              /* of all facets among them */
    size_t most;               /* how many it may take, and as many faces; 0: as many as there are */
    size_t most_in_point_sets; /* how many of point sets instead, which take little room; 0: they count as others */
    bool is_short;             /* more of them were to be appended */
    double each,
        each_in_point_sets;         /* bytes; above 0: beyond `most` it may take as many as the memory holds of these */
    size_t light;                   /* which light those belong to that are appended from now on */
    size_t extended;                /* how many are, or are domes */
    size_t by_square, unattenuated; /* how many shine by the law 1/r^2 or are distant or uniform; by none */
    const struct lx_asking *asking; /* whether to go on making them; NULL: nobody asks */
    struct lx_pointed **turned;     /* luminaires that were carried into another frame (carry.h); theirs alone */
    size_t turned_count;
    bool is_whole; /* sources of some size are appended as they are, however many parts they are to be cut into */
};

/* How many are items: all that are no points of point sets. */
static inline size_t lx_item_count(const struct lx_emitters *emitters)
{
    return emitters->count - emitters->in_point_sets;
}

/*
 * Whether there is room for so many more items, which have so many faces, and for so many more of point sets; ->
 * is_short. Where the first two are many it is made at once: 0, or -1 where it is not there.
 */
int lx_emitters_make_room(struct lx_emitters *emitters, double items, size_t faces, size_t in_point_sets);

/* Appends a copy, which takes over the facets; 0, or -1 when memory or room ran out, or where the work is to stop (then
 * they are freed, too). */
int lx_emitters_append(struct lx_emitters *emitters, const struct lx_emitter *emitter);
/* Appends as many points as its cloud has rows, and takes over the cloud where it is to own it; `first` and `end`
 * are set here.  The same answers. */
int lx_emitters_append_point_set(struct lx_emitters *emitters, const struct lx_point_set *set);
/* Multiplies the strength of the emitters behind the first `items` items and `point_sets` point sets; 0, or -1 when
 * memory ran out. */
int lx_emitters_scale(struct lx_emitters *emitters, size_t items, size_t point_sets, double factor);
void lx_emitters_clear(struct lx_emitters *emitters);

/* For lx_emitter_at(). */
const struct lx_emitter *lx_emitter_in_point_sets(const struct lx_emitters *emitters, size_t i,
                                                  struct lx_emitter *room);

/* Emitter i of the list, made in `room` where it is of a point set. */
static inline const struct lx_emitter *lx_emitter_at(const struct lx_emitters *emitters, size_t i,
                                                     struct lx_emitter *room)
{
    return emitters->point_set_count > 0 ? lx_emitter_in_point_sets(emitters, i, room) : &emitters->items[i];
}

/* The axis of the point of an aimed point set that stands there. */
lx_bounded3 lx_point_set_axis(const struct lx_point_set *set, const double place_mm[3]);

/* Emitters of a list that follow each other: items, or the points of a point set. */
struct lx_emitter_span {
    size_t first, end;
    const struct lx_emitter *items; /* NULL: it is a point set */
    const struct lx_point_set *set;
};

/* The span behind a span of the same list, zero-initialised at first; false: there is none. */
bool lx_emitters_next(const struct lx_emitters *emitters, struct lx_emitter_span *span);

/* Emitter i of a span, as lx_emitter_at() gives it; to be asked with one `room` in their order from the first on. */
const struct lx_emitter *lx_span_at(const struct lx_emitter_span *span, size_t i, struct lx_emitter *room);

/* Place and strength, x, y, z, I, of a point, by its number in the list. */
void lx_emitter_row(const struct lx_emitters *emitters, size_t i, double row[4]);

/* What one emitter gives at a place. */
struct lx_sample {
    lx_bounded3 towards; /* L, unit; for a direction or point */
    lx_bounded e_perp;   /* irradiance on a plane facing the light; the irradiance itself for uniform */
    bool on_element;     /* the point cannot be told from the place itself: there is no L */
};

/* The reference: the light at a place (mm) of an emitter that is not extended. */
struct lx_sample lx_emitter_sample(const struct lx_emitter *emitter, lx_bounded3 place_mm);

#endif
