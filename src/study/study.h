/* SPDX-License-Identifier: MIT */
/* The study object, for the files of this room: the file as it was read, and the axes along which scenes differ. */
#ifndef LX_STUDY_STUDY_H
#define LX_STUDY_STUDY_H

#include <luxel/study.h>

#include "../scene/object.h"

enum lx_random { LX_EVEN, LX_LOGARITHMIC, LX_BOX, LX_ON_SPHERE, LX_RANDOM_CHOICE };

/* One element of `vary`, by lx_vary_table. */
struct lx_vary {
    uint64_t given;
    const char *key;
    lx_node_id values, from, to;
    unsigned steps;
    int random; /* enum lx_random */
    double center[3], radius;
};

/* `outputs`: for each output the index of the word that it was given. */
struct lx_study_wanted {
    uint64_t given;
    int words[LUXEL_STUDY_OUTPUTS];
};

/* A study file, by lx_study_table. */
struct lx_study_parameters {
    uint64_t given;
    unsigned study;
    const char *scene;
    lx_node_id set;
    unsigned count, seed, shard;
    struct lx_groups vary; /* of struct lx_vary */
    struct lx_study_wanted outputs;
};

extern const struct lx_table lx_study_table;

/* How an output is wanted. */
luxel_study_type lx_study_wanted(const struct lx_study_wanted *wanted, luxel_study_output output);

enum { LX_MOST_WIDTH = 8 };

/* One thing that varies. */
struct lx_axis {
    char *key;
    bool is_random;
    enum lx_random random;
    struct lx_parameter parameter; /* of the value, or of the component that the key leads to */
    bool has_parameter;            /* else it is whatever YAML says: a list, an element */
    unsigned width;                /* numbers of a value; 0: it is told by its index */
    double from[LX_MOST_WIDTH], to[LX_MOST_WIDTH];
    double center[3], radius;
    size_t count;    /* values that are listed, or steps */
    double *numbers; /* count x width, of values that are numbers */
    char **words;    /* of listed values that are none, as YAML */
    void *bytes;     /* count values as the parameter's type holds them; NULL where it is of no such type */
    size_t size;     /* of one of them */
    size_t column;   /* of its first number */
    uint64_t stride; /* of a grid: so many scenes have the same value */
};

struct luxel_study {
    struct lx_document document;
    struct lx_study_parameters parameters;
    char *folder;
    luxel_scene *plain; /* the base scene before it is committed, to be copied */
    luxel_scene *base;
    struct lx_axis *axes;
    size_t axis_count, width; /* numbers that tell what varies */
    uint64_t count;
};

/* What an axis has in a scene. */
struct lx_study_choice {
    size_t index; /* of a listed value */
    double numbers[LX_MOST_WIDTH];
};

struct lx_study_choice lx_axis_at(const struct luxel_study *study, size_t axis, uint64_t i);

/* Adds "KEY=VALUE" of a scene. */
void lx_axis_assignment(const struct luxel_study *study, size_t axis, uint64_t i, struct lx_text *text);

/* Makes the axes of what was decoded; everything wrong is reported.  Sets walk->failed. */
void lx_axes_make(struct lx_walk *walk, struct luxel_study *study);
void lx_axis_clear(struct lx_axis *axis);

#endif
