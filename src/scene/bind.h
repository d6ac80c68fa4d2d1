/* SPDX-License-Identifier: MIT */
/*
 * Bindings: where the values of keys lie in a committed scene, so that a scene which differs in numbers only is ready
 * in some microseconds, without its text being read again.
 *
 * What is written through a binding is in the parameters alone: the scene is then ahead of its document.  It can be
 * rendered and probed, but neither written as text nor copied, until it is changed or committed in the usual way.
 */
#ifndef LX_SCENE_BIND_H
#define LX_SCENE_BIND_H

#include "path.h"

/* A mapping on the way to a value, whose rules may speak about it. */
struct lx_bound_mapping {
    const struct lx_table *table;
    void *parameters;
    lx_node_id node;
};

/* A value, or a component of one, in a scene's parameters. */
struct lx_binding {
    const struct lx_parameter *parameter;
    void *value;       /* all of it */
    bool is_component; /* only number `component` of it is meant */
    unsigned component;
    size_t mapping_count;
    struct lx_bound_mapping mappings[LX_MOST_SEGMENTS]; /* from the inside to the outside */
};

/*
 * Binds the value that a path leads to in a committed scene which writes it.  False where it is none of numbers, truth
 * values and words of a choice, or stands in a mapping that loads files.  Holds until the scene is changed.
 */
bool lx_bind(luxel_scene *scene, const struct lx_path *path, struct lx_binding *binding);

/* The size of a value that lx_bind() takes; 0: it takes none of this type. */
size_t lx_bound_size(const struct lx_parameter *parameter);

/* Puts a value as the parameter's type holds it: all of it, or the number of a component. */
void lx_bound_put(luxel_scene *scene, const struct lx_binding *binding, const void *value);

/* Whether the scene is still good as far as these bindings can have changed that, its view aside; says nothing about
 * what is wrong. */
bool lx_bound_check(luxel_scene *scene, const struct lx_binding *bindings, size_t count);

#endif
