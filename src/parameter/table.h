/* SPDX-License-Identifier: MIT */
/*
 * The parameter table: a parameter is declared once, with its name, type, unit, default, ranges and meaning,
 * and everything else (reading, setting, checking, advising, help) walks the table.
 *
 * A table describes a struct whose first member is `uint64_t given`, one bit for each parameter of the table
 * in order, set where the user wrote the key.  Parameters that were not written have their defaults.
 */
#ifndef LX_PARAMETER_TABLE_H
#define LX_PARAMETER_TABLE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum lx_parameter_type {
    LX_REAL,            /* double */
    LX_WHOLE,           /* unsigned */
    LX_BOOLEAN,         /* bool */
    LX_CHOICE,          /* int: index into choices */
    LX_TEXT,            /* const char *: the document's */
    LX_REALS,           /* double[count] */
    LX_WHOLES,          /* unsigned[count] */
    LX_CHOICE_OR_PAIR,  /* struct lx_choice_or_pair: one of choices, or [low, high] */
    LX_GROUP,           /* a struct of its own, by `group`, in place; with choices it begins with struct lx_worded */
    LX_POINTS,          /* struct lx_points: a list of pairs of numbers */
    LX_VECTORS,         /* struct lx_vectors: a list of triples of numbers, at least `count` of them */
    LX_CHOICE_OR_WHOLE, /* struct lx_choice_or_whole: one of choices, or a whole number in the legal range */
    LX_GROUPS,          /* struct lx_groups: a list of structs, all by `group` */
    LX_VARIANTS         /* struct lx_list: a list of structs, each of one of `variants`, told by its key `type` */
};

/* Units by what they measure; their words depend on the scene's `units`. */
enum lx_unit {
    LX_UNIT_NONE,
    LX_UNIT_MM,
    LX_UNIT_DEGREES,
    LX_UNIT_INTENSITY,
    LX_UNIT_IRRADIANCE,
    LX_UNIT_RADIANCE,
    LX_UNIT_POWER
};

/* A range; a bound is included unless it is open.  All zero means: any value. */
struct lx_interval {
    bool given;
    double low, high; /* -HUGE_VAL and HUGE_VAL: no bound */
    bool low_open;
};

enum { LX_COMPONENTS = 3 };

struct lx_table;
struct lx_variant;
struct lx_check;

struct lx_parameter {
    const char *name;
    const char *label; /* a short name for forms, capitalised */
    enum lx_parameter_type type;
    size_t offset;
    unsigned count; /* numbers in LX_REALS and LX_WHOLES; least number of elements of a list */
    enum lx_unit unit;
    bool required;
    bool nonzero;             /* LX_REALS: must not be zero all at once */
    const char *initial;      /* default as YAML, NULL where there is none ("required", or "not given") */
    struct lx_interval legal; /* of each number */
    struct lx_interval advised[LX_COMPONENTS]; /* by component; where only the first is given it goes for all */
    const char *const *choices; /* NULL-terminated; of choices, LX_CHOICE_OR_..., and of groups that may be a word */
    const struct lx_table
        *group; /* LX_GROUP, LX_GROUPS; LX_VARIANTS: the keys that all variants have beside their own */
    const struct lx_variant *const *variants; /* LX_VARIANTS, NULL-terminated */
    const char *meaning;                      /* one sentence without a full stop */
};

/* What must hold between the keys of one table. */
enum lx_rule_kind {
    LX_RULE_EXCLUSIVE, /* key and other must not both be given */
    LX_RULE_NEEDED,    /* key must be given where other is one of choices, or is given if there are no choices */
    LX_RULE_USED,      /* key has an effect only where other is one of choices, or where it is given if there are no
                        * choices (else: advice when key is given) */
    LX_RULE_ORDERED,   /* key <= other (numbers) */
    LX_RULE_DISTINCT,  /* where both are given, the vectors key and other must differ */
    LX_RULE_POSITIVE,  /* the number key must be > 0 where other is one of choices */
    LX_RULE_ONE        /* exactly one of the keys named in choices must be given; key is the first of them */
};

struct lx_rule {
    enum lx_rule_kind kind;
    const char *key;
    const char *other;
    const char *choices; /* words separated by '|' */
};

struct lx_table {
    const struct lx_parameter *parameters;
    size_t count;
    const struct lx_rule *rules;
    size_t rule_count;
    size_t size; /* of the struct */
    /* Judges what no rule can say, of parameters that are good by themselves, and loads what they name (check.h). */
    void (*check)(const struct lx_check *check, void *parameters);
    /* Frees what check() has put into the struct; harmless where that is nothing. */
    void (*release)(void *parameters);
};

/* One kind of surface or light, as its `type` names it. */
struct lx_variant {
    const char *name;
    const char *meaning;
    const char *example; /* an element of the list as YAML on one line, for references and forms */
    const struct lx_table *table;
};

/* What a group begins with whose value may be one of choices instead of keys. */
struct lx_worded {
    uint64_t given;
    int word; /* -1: the keys */
};

/* The struct behind each composite type. */
struct lx_choice_or_pair {
    int choice; /* -1: the pair */
    double low, high;
};

struct lx_points {
    double (*xy)[2];
    size_t count;
};

struct lx_vectors {
    double (*xyz)[3];
    size_t count;
};

struct lx_choice_or_whole {
    int choice; /* -1: the number */
    unsigned whole;
};

/* `items` holds count structs of the group's table->size bytes, one after the other. */
struct lx_groups {
    void *items;
    size_t count;
};

struct lx_item {
    const struct lx_variant *variant;
    void *parameters; /* by variant->table */
    void *common;     /* by the list parameter's group */
};

struct lx_list {
    struct lx_item *items;
    size_t count;
};

/* Whether the user wrote the key `name` of this table. */
bool lx_is_given(const struct lx_table *table, const void *parameters, const char *name);

#define LX_COUNT(array) (sizeof(array) / sizeof(array)[0])
#define LX_ABOVE(bound)                                                                                                \
    {                                                                                                                  \
        .given = true, .low = (bound), .high = HUGE_VAL, .low_open = true                                              \
    }
#define LX_FROM(bound)                                                                                                 \
    {                                                                                                                  \
        .given = true, .low = (bound), .high = HUGE_VAL                                                                \
    }
#define LX_BETWEEN(lowest, highest)                                                                                    \
    {                                                                                                                  \
        .given = true, .low = (lowest), .high = (highest)                                                              \
    }

#endif
