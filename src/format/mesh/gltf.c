/* SPDX-License-Identifier: MIT */
/*
 * Reading glTF 2.0: the triangles of the meshes of a scene's nodes, each moved as its node and those above it say.  A
 * node that mirrors turns its triangles round, so that they look outwards as before.  Extensions that keep geometry in
 * another form are refused by name; skins and morphs stay as they are at rest.
 */
#include "gltf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/vector.h"

enum { DEEPEST = 256, JSON_CHUNK = 0x4E4F534A, BIN_CHUNK = 0x004E4942 };

/* The columns of a map, the last one its move. */
struct map {
    double columns[4][3];
};

static const struct map IDENTITY = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

/* ---- what a file consists of ---- */

static bool find_lists(struct lx_gltf *gltf)
{
    static const char *const names[LX_GLTF_LISTS] = {"buffers", "bufferViews", "accessors",
                                                     "meshes",  "nodes",       "scenes"};
    for (int list = 0; list < LX_GLTF_LISTS; list++) {
        const uint32_t value = lx_json_find(&gltf->json, 1, names[list]);
        const size_t count = gltf->json.values[value].count;
        if (value && gltf->json.values[value].type != LX_JSON_LIST)
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "%s", names[list]);
        gltf->lists[list] = lx_new_array(count + 1, sizeof **gltf->lists);
        if (!gltf->lists[list])
            return lx_gltf_fail(gltf, LX_MSG_OUT_OF_MEMORY, "%s", "");
        for (uint32_t i = gltf->json.values[value].child; i; i = gltf->json.values[i].next)
            gltf->lists[list][gltf->counts[list]++] = i;
    }
    return true;
}

static const char QUANTIZATION[] = "KHR_mesh_quantization";

/* Whether an extension that a file needs leaves the geometry as it is, or is read. */
static bool is_harmless(const char *name)
{
    static const char *const starts[] = {"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                         "MSFT_texture_",  "KHR_lights_",  "KHR_xmp",
                                         "KHR_animation_", QUANTIZATION,   NULL};
    for (size_t i = 0; starts[i]; i++)
        if (strncmp(name, starts[i], strlen(starts[i])) == 0)
            return true;
    return false;
}

/* Whether a list of the file, of extensions, has a name. */
static bool has_extension(const struct lx_gltf *gltf, const char *list, const char *name)
{
    const struct lx_json_value *values = gltf->json.values;
    for (uint32_t i = values[lx_json_find(&gltf->json, 1, list)].child; i; i = values[i].next)
        if (values[i].type == LX_JSON_STRING && lx_word_is(values[i].text, values[i].length, name))
            return true;
    return false;
}

static bool check_head(struct lx_gltf *gltf)
{
    const uint32_t asset = lx_json_find(&gltf->json, 1, "asset");
    const struct lx_json_value *version = &gltf->json.values[lx_json_find(&gltf->json, asset, "version")];
    if (version->type != LX_JSON_STRING || version->length < 2 || memcmp(version->text, "2.", 2) != 0)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VERSION, "%s", "");
    const uint32_t needed = lx_json_find(&gltf->json, 1, "extensionsRequired");
    for (uint32_t i = gltf->json.values[needed].child; i; i = gltf->json.values[i].next) {
        char *name = lx_json_string(&gltf->json, i);
        const bool is_good = name && is_harmless(name);
        if (!is_good)
            lx_gltf_fail(gltf, LX_MSG_GLTF_EXTENSION, "%.80s", name ? name : "");
        free(name);
        if (!is_good)
            return false;
    }
    gltf->is_quantized =
        has_extension(gltf, "extensionsUsed", QUANTIZATION) || has_extension(gltf, "extensionsRequired", QUANTIZATION);
    return true;
}

/* ---- nodes ---- */

/* Reads so many numbers of a list; false where they are not there, or no numbers. */
static bool read_numbers(struct lx_gltf *gltf, uint32_t object, const char *key, size_t count, double *numbers)
{
    const uint32_t list = lx_json_find(&gltf->json, object, key);
    if (!list)
        return true;
    if (gltf->json.values[list].type != LX_JSON_LIST || gltf->json.values[list].count != count)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "nodes: %s", key);
    for (uint32_t i = gltf->json.values[list].child; i; i = gltf->json.values[i].next) {
        if (gltf->json.values[i].type != LX_JSON_NUMBER)
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "nodes: %s", key);
        *numbers++ = gltf->json.values[i].number;
    }
    return true;
}

static struct map map_of(const double move[3], const double q[4], const double scale[3])
{
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                               {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                               {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    struct map map;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            map.columns[c][k] = turn[c][k] * scale[c];
    memcpy(map.columns[3], move, sizeof map.columns[3]);
    return map;
}

static bool read_map(struct lx_gltf *gltf, uint32_t node, struct map *map)
{
    double move[3] = {0, 0, 0}, turn[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1};
    double matrix[16] = {0};
    if (!read_numbers(gltf, node, "translation", 3, move) || !read_numbers(gltf, node, "rotation", 4, turn) ||
        !read_numbers(gltf, node, "scale", 3, scale) || !read_numbers(gltf, node, "matrix", 16, matrix))
        return false;
    *map = map_of(move, turn, scale);
    for (int c = 0; lx_json_find(&gltf->json, node, "matrix") && c < 4; c++)
        memcpy(map->columns[c], matrix + 4 * c, sizeof map->columns[c]);
    return true;
}

static void apply(const struct map *map, const double place[3], bool is_direction, double moved[3])
{
    for (int k = 0; k < 3; k++) {
        moved[k] = is_direction ? 0 : map->columns[3][k];
        for (int c = 0; c < 3; c++)
            moved[k] += map->columns[c][k] * place[c];
    }
}

static struct map joined(const struct map *outer, const struct map *inner)
{
    struct map made;
    for (int c = 0; c < 4; c++)
        apply(outer, inner->columns[c], c < 3, made.columns[c]);
    return made;
}

/* The map of normals: cofactors of that of places, which turn as its determinant does. */
static struct map map_of_normals(const struct map *map, double *determinant)
{
    struct map made = IDENTITY;
    for (int c = 0; c < 3; c++) {
        const double *a = map->columns[(c + 1) % 3], *b = map->columns[(c + 2) % 3];
        for (int k = 0; k < 3; k++)
            made.columns[c][k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
    *determinant = lx_dot(made.columns[0], map->columns[0]);
    return made;
}

/* ---- primitives ---- */

/* What a primitive adds to: its first corner and normal. */
struct part {
    size_t first, count, first_normal;
    bool has_normals, is_mirrored;
};

static bool keep(struct lx_gltf *gltf, struct lx_mesh_report report)
{
    if (report.message == LX_MSG_COUNT)
        return true;
    gltf->report = report;
    return false;
}

static bool add_triangle(struct lx_gltf *gltf, const struct part *part, size_t a, size_t b, size_t c)
{
    const size_t corners[3] = {a, part->is_mirrored ? c : b, part->is_mirrored ? b : c};
    for (int k = 0; k < 3; k++) {
        const unsigned normal = part->has_normals ? (unsigned)(part->first_normal + corners[k]) : LX_NO_NORMAL;
        if (!keep(gltf, lx_add_to_loop(gltf->raw, (unsigned)(part->first + corners[k]), normal, 0)))
            return false;
    }
    return keep(gltf, lx_add_face(gltf->raw, 3, 0));
}

enum { TRIANGLES = 4, STRIP = 5, FAN = 6 };

/* Cuts a run of indices between restarts into triangles. */
static bool add_run(struct lx_gltf *gltf, const struct part *part, size_t mode, const size_t *run, size_t count)
{
    for (size_t i = 2; i < count; i += mode == TRIANGLES ? 3 : 1) {
        const size_t first = mode == FAN ? run[0] : run[i - 2];
        const bool is_odd = mode == STRIP && i % 2 == 1;
        if (!add_triangle(gltf, part, is_odd ? run[i - 1] : first, is_odd ? first : run[i - 1], run[i]))
            return false;
    }
    return true;
}

static bool add_faces(struct lx_gltf *gltf, uint32_t primitive, const struct part *part, size_t mode)
{
    size_t accessor, count = part->count, restart = SIZE_MAX, made = 0;
    const bool is_indexed = lx_json_find(&gltf->json, primitive, "indices") != 0;
    double *indices = NULL;
    if (is_indexed) {
        if (!lx_gltf_whole(gltf, primitive, "indices", SIZE_MAX, &accessor))
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "primitives: indices");
        indices = lx_gltf_numbers(gltf, accessor, 1, true, &count, &restart);
        if (!indices)
            return false;
    }
    size_t *run = lx_new_array(count + 1, sizeof *run);
    bool is_good = run || lx_gltf_fail(gltf, LX_MSG_OUT_OF_MEMORY, "%s", "");
    for (size_t i = 0; is_good && i <= count; i++) {
        const size_t index = i == count ? restart : indices ? (size_t)indices[i] : i;
        if (i == count || (is_indexed && index == restart)) {
            is_good = add_run(gltf, part, mode, run, made);
            made = 0;
        } else if (index < part->count) {
            run[made++] = index;
        } else {
            is_good = lx_gltf_fail(gltf, LX_MSG_GLTF_INDEX, "accessors[%zu]", accessor);
        }
    }
    free(run);
    free(indices);
    return is_good;
}

/* Adds the places or normals of an accessor, moved. */
static bool add_places(struct lx_gltf *gltf, size_t accessor, const struct map *map, bool are_normals, size_t *count)
{
    size_t restart;
    double *numbers = lx_gltf_numbers(gltf, accessor, 3, false, count, &restart);
    bool is_good = numbers != NULL;
    for (size_t i = 0; is_good && i < *count; i++) {
        double moved[3];
        apply(map, numbers + 3 * i, are_normals, moved);
        for (int k = 0; k < 3; k++)
            moved[k] += 0.0;
        if (are_normals)
            is_good = keep(gltf, lx_add_normal(gltf->raw, moved, 0));
        else if (!isfinite(moved[0] + moved[1] + moved[2]))
            is_good = keep(gltf, lx_mesh_fault(LX_MSG_MESH_NOT_FINITE, gltf->raw->mesh->corner_count + 1));
        else
            is_good = keep(gltf, lx_add_corner(gltf->raw, moved, 0));
    }
    free(numbers);
    return is_good;
}

static bool add_primitive(struct lx_gltf *gltf, uint32_t primitive, const struct map *map)
{
    static const char draco[] = "KHR_draco_mesh_compression";
    const uint32_t attributes = lx_json_find(&gltf->json, primitive, "attributes");
    struct part part = {.first = gltf->raw->mesh->corner_count, .first_normal = gltf->raw->mesh->normal_count};
    size_t mode, accessor, normals;
    double determinant;
    if (!lx_gltf_whole(gltf, primitive, "mode", TRIANGLES, &mode) || mode > FAN)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "primitives: mode");
    if (lx_json_find(&gltf->json, lx_json_find(&gltf->json, primitive, "extensions"), draco))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_EXTENSION, "%s", draco);
    if (mode < TRIANGLES) { /* points and lines */
        lx_mesh_take_note(&gltf->raw->mesh->others, 0);
        return true;
    }
    if (!lx_gltf_whole(gltf, attributes, "POSITION", SIZE_MAX, &accessor))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "primitives: POSITION");
    const struct map of_normals = map_of_normals(map, &determinant);
    part.is_mirrored = determinant < 0;
    if (!add_places(gltf, accessor, map, false, &part.count))
        return false;
    part.has_normals = lx_json_find(&gltf->json, attributes, "NORMAL") != 0;
    if (part.has_normals) {
        if (!lx_gltf_whole(gltf, attributes, "NORMAL", SIZE_MAX, &accessor) ||
            !add_places(gltf, accessor, &of_normals, true, &normals))
            return gltf->report.message != LX_MSG_COUNT ? false
                                                        : lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "primitives: NORMAL");
        if (normals != part.count)
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "accessors[%zu].count", accessor);
    }
    return add_faces(gltf, primitive, &part, mode);
}

static bool add_mesh(struct lx_gltf *gltf, size_t number, const struct map *map)
{
    if (number >= gltf->counts[LX_GLTF_MESHES])
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "nodes: mesh");
    const uint32_t list = lx_json_find(&gltf->json, gltf->lists[LX_GLTF_MESHES][number], "primitives");
    for (uint32_t i = gltf->json.values[list].child; i; i = gltf->json.values[i].next)
        if (!add_primitive(gltf, i, map))
            return false;
    return true;
}

/* A node with all below it.  No node may be met twice: it would be its own descendant, or have two parents. */
static bool add_node(struct lx_gltf *gltf, uint32_t value, const struct map *outer, bool *is_met, unsigned depth)
{
    static const char instances[] = "EXT_mesh_gpu_instancing";
    const struct lx_json_value *name = &gltf->json.values[value];
    const double number = name->number;
    size_t mesh;
    struct map own;
    if (name->type != LX_JSON_NUMBER || !(number >= 0 && number < (double)gltf->counts[LX_GLTF_NODES]) ||
        number != floor(number))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "nodes: children");
    if (is_met[(size_t)number] || depth == DEEPEST)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_NODES, "nodes[%zu]", (size_t)number);
    is_met[(size_t)number] = true;
    const uint32_t node = gltf->lists[LX_GLTF_NODES][(size_t)number];
    if (lx_json_find(&gltf->json, lx_json_find(&gltf->json, node, "extensions"), instances))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_EXTENSION, "%s", instances);
    if (!read_map(gltf, node, &own))
        return false;
    const struct map map = joined(outer, &own);
    if (lx_json_find(&gltf->json, node, "mesh")) {
        if (!lx_gltf_whole(gltf, node, "mesh", SIZE_MAX, &mesh))
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "nodes: mesh");
        if (!add_mesh(gltf, mesh, &map))
            return false;
    }
    const uint32_t children = lx_json_find(&gltf->json, node, "children");
    for (uint32_t i = gltf->json.values[children].child; i; i = gltf->json.values[i].next)
        if (!add_node(gltf, i, &map, is_met, depth + 1))
            return false;
    return true;
}

/* The nodes of the scene; of a file without scenes all meshes, as they are. */
static bool add_scene(struct lx_gltf *gltf)
{
    size_t scene;
    if (!lx_gltf_whole(gltf, 1, "scene", 0, &scene) ||
        (scene >= gltf->counts[LX_GLTF_SCENES] && lx_json_find(&gltf->json, 1, "scene")))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "scene");
    if (gltf->counts[LX_GLTF_SCENES] == 0) {
        for (size_t i = 0; i < gltf->counts[LX_GLTF_MESHES]; i++)
            if (!add_mesh(gltf, i, &IDENTITY))
                return false;
        return true;
    }
    bool *is_met = lx_new_array(gltf->counts[LX_GLTF_NODES] + 1, sizeof *is_met);
    bool is_good = is_met || lx_gltf_fail(gltf, LX_MSG_OUT_OF_MEMORY, "%s", "");
    const uint32_t nodes = lx_json_find(&gltf->json, gltf->lists[LX_GLTF_SCENES][scene], "nodes");
    for (uint32_t i = gltf->json.values[nodes].child; is_good && i; i = gltf->json.values[i].next)
        is_good = add_node(gltf, i, &IDENTITY, is_met, 0);
    free(is_met);
    return is_good;
}

/* ---- files ---- */

static struct lx_mesh_report read_json(struct lx_raw_mesh *raw, const char *text, size_t length, const char *chunk,
                                       size_t chunk_length)
{
    struct lx_gltf gltf = {.raw = raw, .chunk = chunk, .chunk_length = chunk_length, .total = length};
    gltf.report = lx_mesh_fault(LX_MSG_COUNT, 0);
    if (!lx_json_parse(text, length, &gltf.json))
        gltf.report = lx_mesh_fault(gltf.json.out_of_memory ? LX_MSG_OUT_OF_MEMORY : LX_MSG_GLTF_JSON, gltf.json.line);
    else if (check_head(&gltf) && find_lists(&gltf) && lx_gltf_read_buffers(&gltf))
        add_scene(&gltf);
    for (size_t i = 0; gltf.buffers && i < gltf.counts[LX_GLTF_BUFFERS]; i++)
        free(gltf.buffers[i].own);
    for (int list = 0; list < LX_GLTF_LISTS; list++)
        free(gltf.lists[list]);
    free(gltf.buffers);
    lx_json_clear(&gltf.json);
    raw->mesh->unit_mm = 1000;
    raw->rounding = 0x1p-24;
    return gltf.report;
}

bool lx_is_glb(const char *name, const char *text, size_t length)
{
    (void)name;
    return length >= 12 && memcmp(text, "glTF", 4) == 0;
}

struct lx_mesh_report lx_read_glb(struct lx_raw_mesh *raw)
{
    const char *json = NULL, *chunk = NULL;
    size_t json_length = 0, chunk_length = 0, at = 12;
    if (lx_binary_bits(raw->text + 4, 4, false) != 2) {
        struct lx_mesh_report report = lx_mesh_fault(LX_MSG_GLTF_VERSION, 0);
        return report;
    }
    while (at + 8 <= raw->length) {
        const size_t length = (size_t)lx_binary_bits(raw->text + at, 4, false);
        const uint64_t type = lx_binary_bits(raw->text + at + 4, 4, false);
        at += 8;
        if (length > raw->length - at)
            return lx_mesh_fault(LX_MSG_MESH_ENDS, 0);
        if (type == JSON_CHUNK && !json)
            json = raw->text + at, json_length = length;
        else if (type == BIN_CHUNK && json && !chunk)
            chunk = raw->text + at, chunk_length = length;
        at += length;
    }
    return json ? read_json(raw, json, json_length, chunk, chunk_length) : lx_mesh_fault(LX_MSG_MESH_ENDS, 0);
}

bool lx_is_gltf(const char *name, const char *text, size_t length)
{
    (void)name;
    while (length > 0 && lx_is_blank(*text))
        text++, length--;
    return length > 0 && *text == '{';
}

struct lx_mesh_report lx_read_gltf(struct lx_raw_mesh *raw)
{
    return read_json(raw, raw->text, raw->length, NULL, 0);
}
