/* SPDX-License-Identifier: MIT */
/*
 * Drafts: scenes as plain structs, which can be made by chance, turned, made simpler step by step, and written.
 *
 * The words and the numbers of each part stand in structs of nothing else, so that whoever makes a draft simpler goes
 * through them as arrays.  A word is an index, of which 0 is the simplest.
 */
#ifndef LUXEL_PROPERTIES_DRAFT_H
#define LUXEL_PROPERTIES_DRAFT_H

#include "choices.h"

enum { DRAFT_LIGHTS = 4, DRAFT_SURFACES = 3, DRAFT_CORNERS = 6 };

enum draft_surface_type { DRAFT_SPHERE, DRAFT_RECTANGLE };

struct draft_surface {
    struct draft_surface_words {
        unsigned type, model, highlight, over_pi, normalized, has_ambient;
    } words;
    struct draft_surface_numbers {
        double center[3];
        double size[2]; /* the radius, or width and height */
        double axis[3], up[3];
        double diffuse, specular, shininess, ambient;
    } numbers;
};

enum draft_light_type { DRAFT_POINT, DRAFT_DISTANT, DRAFT_AMBIENT, DRAFT_SPOT, DRAFT_PLANAR, DRAFT_VOLUME };
enum draft_pattern { DRAFT_ISOTROPIC, DRAFT_LAMBERTIAN, DRAFT_COSINE };
enum draft_law { DRAFT_INVERSE_SQUARE, DRAFT_NONE, DRAFT_PRACTICAL, DRAFT_POLYNOMIAL, DRAFT_LAWS };
enum draft_outline { DRAFT_PLATE, DRAFT_DISK, DRAFT_POLYGON, DRAFT_OUTLINES };
enum draft_body { DRAFT_BOX, DRAFT_BALL, DRAFT_CYLINDER, DRAFT_BODIES };
enum draft_measure { DRAFT_RADIANCE, DRAFT_POWER, DRAFT_INTENSITY };

struct draft_light {
    struct draft_light_words {
        unsigned type, law, pattern, falloff;
        unsigned shape;   /* an outline or a body */
        unsigned measure; /* of extended sources */
        unsigned is_aimed;
        unsigned parts;   /* 0: converged */
        unsigned facets;  /* 0: none */
        unsigned corners; /* of a polygon */
    } words;
    struct draft_light_numbers {
        double place[3];
        double towards[3]; /* axis, direction, or what it is aimed at */
        double up[3];
        double strength; /* in what the measure says */
        double k, exponent, inner, outer;
        double coefficients[3];
        double size[3];
        double corners[DRAFT_CORNERS][3];
    } numbers;
};

/* A measuring grid, of which there is one or none. */
struct draft_grid {
    struct draft_grid_words {
        unsigned columns, rows; /* 0: there is none */
    } words;
    struct draft_grid_numbers {
        double center[3], size[2], axis[3], up[3];
    } numbers;
};

struct draft {
    struct draft_words {
        unsigned nodes, perspective, from_observer, no_shadows, columns, rows;
    } words;
    struct draft_numbers {
        double pitch; /* the size of a pixel */
        double observer_z;
    } numbers;
    struct draft_surface surfaces[DRAFT_SURFACES];
    struct draft_light lights[DRAFT_LIGHTS];
    struct draft_grid grid;
    size_t surface_count, light_count;
    const char *cloud; /* NULL, or the file that all points are read from, with what else the first of them says */
    const char *mesh;  /* NULL, or the file that boxes are read from */
};

/* Extended sources cost a hundred times what others do: usually one light in so many is one. */
enum { DRAFT_EXTENDED_ONE_IN = 64 };

/* A scene, nearly always a legal one, whatever is chosen; one light in so many is extended, at most one of a scene. */
void draft_make(struct choices *choices, unsigned extended_one_in, struct draft *draft);

/* Its lights, at random, around surfaces that are there already. */
void draft_make_lights(struct choices *choices, unsigned extended_one_in, struct draft *draft);

/* A place around a surface, or where programs err. */
void draft_choose_place(struct choices *choices, const struct draft *draft, double place[3]);

/* A direction of the length 1, or along an axis. */
void draft_choose_direction(struct choices *choices, double direction[3]);

/* The simplest values of each part. */
extern const struct draft_surface draft_plain_surface;
extern const struct draft_light draft_plain_light;
extern const struct draft draft_plain;

/* Its YAML text, to be freed. */
char *draft_write(const struct draft *draft);

/* A map of x and y that takes the axes to the axes; z stays. */
struct draft_map {
    int xx, xy, yx, yy; /* x' = xx x + xy y, y' = yx x + yy y */
};

/* The draft as it is after the map, the screen included. */
void draft_turn(struct draft *draft, struct draft_map map);

/* Whether a light is one surface of sources, and not a few points. */
bool draft_is_extended(const struct draft_light *light);
/* Whether any light is. */
bool draft_has_extended(const struct draft *draft);
/*
 * Whether draft_turn() gives what the scene would give, turned: polyhedra begin at +x, and parts of round sources at a
 * direction of their own.
 */
bool draft_is_symmetric(const struct draft *draft);

#endif
