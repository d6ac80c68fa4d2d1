/* SPDX-License-Identifier: MIT */
/* From a document to the structs that tables describe, with every error on the way reported. */
#ifndef LX_PARAMETER_DECODE_H
#define LX_PARAMETER_DECODE_H

#include "../format/kept.h"
#include "document.h"
#include "table.h"
#include "words.h"

/* Lengths up to this are advised to scenes of any kind; how large they really are says the scene. */
#define LX_USUAL_MM 10000.0

/* What a walk over a document and its tables carries along. */
struct lx_walk {
    const struct lx_document *document;
    luxel_diagnostics *diagnostics;
    bool photometric;            /* which words the units have */
    const char *folder;          /* where files that the document names are looked for; NULL: the current folder */
    struct lx_kept_files *kept;  /* what the scene has read already, and where further files go; NULL: nowhere */
    struct lx_file_state opened; /* the file that was opened last, before that */
    bool failed, out_of_memory;
    size_t errors, unread; /* errors reported, and how many of them are files that cannot be read */
    /* Gives the advice just reported a hint at what brings a number to the nearest advised one; NULL: none. */
    void (*mend)(struct lx_walk *walk, const struct lx_step *step, double nearest);
    const struct luxel_scene *scene; /* for mend() */
    struct lx_interval lengths;      /* in mm, that are usual beyond those that are advised */
};

/*
 * Fills *parameters, of table->size bytes, from the document's root, which must be a mapping: values that were
 * written, defaults for the rest.  A `given` bit is set where a key was written and its value is good, also
 * when the whole fails; a list's item with errors has no variant then.  Free with lx_parameters_clear() in
 * any case.  LUXEL_ERROR_SCENE, LUXEL_ERROR_FILE, LUXEL_ERROR_MEMORY.
 */
luxel_status lx_decode(struct lx_walk *walk, const struct lx_table *table, void *parameters);

/* What a walk has come to: LUXEL_ERROR_FILE where nothing is wrong but that files cannot be read.  Memory that ran
 * out is reported here. */
luxel_status lx_walk_status(struct lx_walk *walk);

/* Frees what the struct holds, not itself. */
void lx_parameters_clear(const struct lx_table *table, void *parameters);

/* Appends advice on what was written: values outside advised ranges, keys without effect. */
void lx_advise_parameters(struct lx_walk *walk, const struct lx_table *table, const void *parameters);

/* ---- shared by the files of this room ---- */

/* Whether a parameter's value consists of mappings of their own. */
static inline bool lx_has_tables(const struct lx_parameter *parameter)
{
    return parameter->type == LX_GROUP || parameter->type == LX_GROUPS || parameter->type == LX_VARIANTS;
}

/* Hints at what a key that is missing means, and its type, range and unit. */
void lx_hint_expected(struct lx_walk *walk, const struct lx_parameter *parameter);

/* The parameter of a table with this name, or NULL. */
const struct lx_parameter *lx_find_parameter(const struct lx_table *table, const char *name);

static inline void *lx_member(const struct lx_parameter *parameter, void *parameters)
{
    return (char *)parameters + parameter->offset;
}

static inline const void *lx_const_member(const struct lx_parameter *parameter, const void *parameters)
{
    return (const char *)parameters + parameter->offset;
}

/* Whether a number lies in a range. */
bool lx_interval_holds(const struct lx_interval *range, double number);

/* A number that was written plainly. */
bool lx_read_real(const struct lx_document *document, lx_node_id id, double *value);

/*
 * Reports about a place; {0} is the end of the step's path; `arguments`, as lx_report() takes them, are {1}, {2} ...
 * `first` and `second` (or NULL), which are texts with phrases, are {1} and {2}.
 */
void lx_walk_tell(struct lx_walk *walk, luxel_severity severity, struct lx_place place, const struct lx_step *step,
                  enum lx_message message, const char *const *arguments);
void lx_walk_report(struct lx_walk *walk, luxel_severity severity, struct lx_place place, const struct lx_step *step,
                    enum lx_message message, const char *first, const char *second);

/* Decodes one value into its place in the struct; false where it is wrong, which is reported. */
bool lx_decode_value(struct lx_walk *walk, const struct lx_step *step, const struct lx_parameter *parameter,
                     lx_node_id id, void *value);

/* Sets a value to its default (zero where there is none). */
void lx_set_default(const struct lx_parameter *parameter, void *value);

/* Hints at the nearest of the words, if one is near. */
bool lx_hint_nearest(luxel_diagnostics *diagnostics, const struct lx_nearest *nearest);

/*
 * Hints at what was meant by a key that is in none of the tables: a key of other types of `list` (NULL where the
 * keys are not those of a list's element), the nearest one, or all known ones.  Returns the nearest one, or NULL.
 */
const char *lx_hint_unknown_key(luxel_diagnostics *diagnostics, const char *key, const struct lx_table *const *tables,
                                size_t count, const struct lx_parameter *list);

/* The variant of a list with this name, or NULL. */
const struct lx_variant *lx_find_variant(const struct lx_parameter *list, const char *name);

/* A mapping whose keys are judged together: the way to it, its table, its struct, its node. */
struct lx_check {
    struct lx_walk *walk;
    const struct lx_step *up;
    const struct lx_table *table;
    const void *parameters;
    lx_node_id mapping;
    bool advises; /* check() of a table that has release() gives advice on what it loaded, and changes nothing */
};

/* Checks the rules of a table; `seen` has the bits of the keys written, good or not, `there` of those that need not be
 * missed. */
void lx_check_rules(const struct lx_check *check, uint64_t seen, uint64_t there);

/* The word that a parameter of type LX_CHOICE has now. */
const char *lx_chosen(const struct lx_parameter *parameter, const void *parameters);
/* Whether a word is one of the rule's. */
bool lx_rule_lists(const struct lx_rule *rule, const char *word);
/* The parameter of the rule's i-th word, for rules whose words are keys; NULL beyond the last. */
const struct lx_parameter *lx_rule_key(const struct lx_rule *rule, const struct lx_table *table, size_t i);
/* Whether the rule's `other` has one of the rule's words now. */
bool lx_rule_applies(const struct lx_rule *rule, const struct lx_table *table, const void *parameters);

#endif
