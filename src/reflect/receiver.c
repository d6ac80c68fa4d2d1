/* SPDX-License-Identifier: MIT */
/* Receivers: where reflected light is asked for, and which way they face. */
#include "receiver.h"

#include <math.h>

#include "../base/vector.h"
#include "../surface/beside.h"
#include "../surface/mesh.h"
#include "../surface/mesh_faces.h"

/* Reflected light falls on the triangles of a mesh as they are, whatever its smooth normals are. */
static void turn_to_face(const struct lx_shape *mesh, struct lx_receiver *receiver)
{
    double offset[3], shading[3], normal[3];
    for (int i = 0; i < 3; i++)
        offset[i] = receiver->place_mm[i] - mesh->anchor_mm[i];
    mesh->kind->normal(mesh, offset, shading);
    const double facing = lx_dot(shading, receiver->normal);
    receiver->is_turned = fabs(facing) < 1 - LX_SAME_NORMAL || !lx_mesh_face_normal(mesh, receiver->place_mm, normal);
    for (int i = 0; i < 3 && !receiver->is_turned; i++)
        receiver->normal[i] = facing < 0 ? -normal[i] : normal[i];
}

struct lx_receiver lx_receiver_of(const struct lx_prepared *prepared, const struct lx_element *element)
{
    struct lx_receiver receiver = {
        .place_mm = {element->place_mm.x.value, element->place_mm.y.value, element->place_mm.z.value},
        .normal = {element->normal.x.value, element->normal.y.value, element->normal.z.value},
        .own = element->own ? (size_t)(element->own - prepared->surfaces) : SIZE_MAX,
    };
    if (element->own && lx_mesh_count(&element->own->shape) > 0)
        turn_to_face(&element->own->shape, &receiver);
    else
        receiver.is_turned =
            element->own && lx_shape_is_turned(&element->own->shape, element->place_mm, element->normal);
    return receiver;
}

size_t lx_receivers_of(const struct lx_prepared *prepared, const struct lx_element *element,
                       const struct lx_response *response, struct lx_receiver receivers[LX_MOST_RECEIVERS])
{
    receivers[0] = lx_receiver_of(prepared, element);
    if (!response)
        return 1;
    receivers[0].response = response;
    if (element->own && !receivers[0].is_turned)
        return 1;
    receivers[1] = receivers[0];
    for (int i = 0; i < 3; i++)
        receivers[1].normal[i] = -receivers[0].normal[i];
    return 2;
}
