/* SPDX-License-Identifier: MIT */
/* The public list of parameters, which is the scene's table flattened, and the schema made from it. */
#include <stdlib.h>

#include "../base/memory.h"
#include "../parameter/reflect.h"
#include "../parameter/schema.h"
#include "object.h"

struct luxel_parameters {
    struct lx_parameter_reflection reflection;
};

luxel_parameters *lx_parameters_of(const struct lx_table *table, luxel_translate translate, void *data)
{
    luxel_parameters *parameters = lx_new_array(1, sizeof *parameters);
    if (!parameters || lx_reflect(table, translate, data, &parameters->reflection) == 0)
        return parameters;
    free(parameters);
    return NULL;
}

luxel_parameters *luxel_parameters_new_translated(luxel_translate translate, void *data)
{
    return lx_parameters_of(&lx_scene_table, translate, data);
}

luxel_parameters *luxel_parameters_new(void)
{
    return luxel_parameters_new_translated(NULL, NULL);
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

size_t luxel_parameters_kind_count(const luxel_parameters *parameters)
{
    return parameters->reflection.kind_count;
}

const luxel_parameter_kind *luxel_parameters_kind(const luxel_parameters *parameters, size_t i)
{
    return i < parameters->reflection.kind_count ? &parameters->reflection.kinds[i] : NULL;
}

const luxel_parameter *luxel_parameters_get(const luxel_parameters *parameters, size_t i)
{
    return i < parameters->reflection.count ? &parameters->reflection.items[i].shown : NULL;
}

luxel_status luxel_scene_schema(char **text)
{
    static const char beyond[] =
        "luxel check refuses some scenes that this schema accepts, because a schema cannot compare values: pixels that "
        "are not square; an observer that is not above the front of every surface; an aim that is the light's "
        "position or center; an up that is parallel to the axis; vertices in no plane, on one line, or of edges that "
        "cross; a mesh that cannot be read or is not closed and convex; a cloud of points that cannot be read, or with "
        "one where they are aimed; measuring grids of more than ten million cells; an inner angle greater than the "
        "outer one within one degree; a range [low, high] that does not "
        "rise between two of the steps listed there. It reads numbers and words as they are written: 360.0 is no "
        "whole number, and only true and false are truth values. Doubled keys, anchors, aliases, tags and further "
        "documents are errors of the text and unknown to a schema.";
    char *schema = lx_schema(&lx_scene_table, "Luxel scene", beyond);
    if (!schema)
        return LUXEL_ERROR_MEMORY;
    *text = schema;
    return LUXEL_OK;
}
