/* SPDX-License-Identifier: MIT */
/* glTF 2.0 files: their JSON, the bytes of their buffers, and accessors, which are arrays of numbers in those. */
#ifndef LX_FORMAT_GLTF_H
#define LX_FORMAT_GLTF_H

#include "../../base/json_read.h"
#include "../binary.h"
#include "mesh_read.h"

enum lx_gltf_list {
    LX_GLTF_BUFFERS,
    LX_GLTF_VIEWS,
    LX_GLTF_ACCESSORS,
    LX_GLTF_MESHES,
    LX_GLTF_NODES,
    LX_GLTF_SCENES,
    LX_GLTF_LISTS
};

struct lx_gltf_buffer {
    const char *bytes;
    char *own; /* what of it is to be freed */
    size_t length;
};

struct lx_gltf {
    struct lx_raw_mesh *raw;
    struct lx_json_tree json;
    uint32_t *lists[LX_GLTF_LISTS]; /* the values of the lists of the file */
    size_t counts[LX_GLTF_LISTS];
    struct lx_gltf_buffer *buffers;
    const char *chunk; /* of a GLB file; NULL: none */
    size_t chunk_length, total;
    bool is_quantized;            /* by KHR_mesh_quantization: places and normals may be whole numbers */
    struct lx_mesh_report report; /* what went wrong */
};

/* Tells what is wrong: with a value whose name in the file is made as by printf; false. */
bool lx_gltf_fail(struct lx_gltf *gltf, enum lx_message message, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* A whole number from 0 on that a key of an object holds; `otherwise` where there is no such key.  False: it is none,
 * or larger than any file. */
bool lx_gltf_whole(const struct lx_gltf *gltf, uint32_t object, const char *key, size_t otherwise, size_t *number);

/* Reads the buffers; false: *report. */
bool lx_gltf_read_buffers(struct lx_gltf *gltf);

/* The numbers of an accessor, of so many components each; NULL: *report.  To be freed. */
double *lx_gltf_numbers(struct lx_gltf *gltf, size_t accessor, size_t components, bool is_index, size_t *count,
                        size_t *restart);

#endif
