/* SPDX-License-Identifier: MIT */
/* The public list of parameters: the scene's table flattened. */
#include <stdlib.h>

#include "../base/memory.h"
#include "../parameter/reflect.h"
#include "scene.h"

struct luxel_parameters {
    struct lx_reflection reflection;
};

luxel_parameters *luxel_parameters_new(void)
{
    luxel_parameters *parameters = lx_new_array(1, sizeof *parameters);
    if (!parameters || lx_reflect(&lx_scene_table, &parameters->reflection) == 0)
        return parameters;
    free(parameters);
    return NULL;
}

void luxel_parameters_free(luxel_parameters *parameters)
{
    if (parameters)
        lx_reflection_clear(&parameters->reflection);
    free(parameters);
}

size_t luxel_parameters_count(const luxel_parameters *parameters)
{
    return parameters->reflection.count;
}

const luxel_parameter *luxel_parameters_get(const luxel_parameters *parameters, size_t i)
{
    return i < parameters->reflection.count ? &parameters->reflection.items[i].shown : NULL;
}
