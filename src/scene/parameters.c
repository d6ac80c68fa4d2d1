/* SPDX-License-Identifier: MIT */
/*
 * The public list of parameters: the scene's table flattened once, by whichever thread asks first, and kept for
 * the rest of the program.
 */
#include <pthread.h>

#include "../parameter/reflect.h"
#include "scene.h"

static pthread_once_t once = PTHREAD_ONCE_INIT;
static struct lx_reflection reflection; /* written once, before anybody reads it */

static void reflect(void)
{
    lx_reflect(&lx_scene_table, &reflection);
}

size_t luxel_parameter_count(void)
{
    pthread_once(&once, reflect);
    return reflection.count;
}

const luxel_parameter *luxel_parameter_get(size_t i)
{
    return i < luxel_parameter_count() ? &reflection.items[i].shown : NULL;
}
