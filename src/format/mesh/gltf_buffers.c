/* SPDX-License-Identifier: MIT */
/*
 * Buffers and accessors of glTF files.  Numbers of the file are whole and at most as large as the largest file, so that
 * no sum or product of two of them overflows, and every range is held against what is there before it is read.
 */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../base/memory.h"
#include "gltf.h"

bool lx_gltf_fail(struct lx_gltf *gltf, enum lx_message message, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    gltf->report.message = message;
    vsnprintf(gltf->report.detail, sizeof gltf->report.detail, format, arguments);
    va_end(arguments);
    return false;
}

bool lx_gltf_whole(const struct lx_gltf *gltf, uint32_t object, const char *key, size_t otherwise, size_t *number)
{
    const uint32_t value = lx_json_find(&gltf->json, object, key);
    *number = otherwise;
    if (!value)
        return otherwise != SIZE_MAX;
    const double given = gltf->json.values[value].number;
    if (gltf->json.values[value].type != LX_JSON_NUMBER || !(given >= 0 && given <= LX_LARGEST_MESH) ||
        given != floor(given))
        return false;
    *number = (size_t)given;
    return true;
}

/* ---- buffers ---- */

static int digit_of(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? strchr(digits, c == '-' ? '+' : c == '_' ? '/' : c) : NULL;
    return at ? (int)(at - digits) : -1;
}

/* Base64 in place; false: it is none. */
static bool decode(char *text, size_t *length)
{
    size_t made = 0;
    unsigned bits = 0, held = 0;
    size_t given = *length;
    while (given > 0 && text[given - 1] == '=')
        given--;
    for (size_t i = 0; i < given; i++) {
        const int digit = digit_of(text[i]);
        if (digit < 0)
            return false;
        bits = bits << 6 | (unsigned)digit;
        held += 6;
        if (held >= 8)
            text[made++] = (char)(bits >> (held -= 8) & 0xFF);
    }
    *length = made;
    return true;
}

/* The name of a file in a URI, in place: %20 and the like are bytes. */
static void decode_name(char *name)
{
    char *to = name;
    for (const char *at = name; *at; at++) {
        unsigned byte;
        if (at[0] == '%' && at[1] && at[2] && sscanf(at + 1, "%2x", &byte) == 1 && byte > 0) {
            *to++ = (char)byte;
            at += 2;
        } else {
            *to++ = *at;
        }
    }
    *to = 0;
}

/* Reads a file that belongs to the mesh, and notes that it does. */
static bool read_file(struct lx_gltf *gltf, char *name, struct lx_gltf_buffer *buffer)
{
    struct lx_mesh *mesh = gltf->raw->mesh;
    struct lx_mesh_file file = {.path = NULL};
    decode_name(name);
    if (!gltf->raw->opener || strstr(name, "://"))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_URI, "%.80s", name);
    buffer->own = gltf->raw->opener->open(gltf->raw->opener, name, &buffer->length, &file);
    buffer->bytes = buffer->own;
    struct lx_mesh_file *files = file.path ? realloc(mesh->files, (mesh->file_count + 1) * sizeof *files) : NULL;
    if (files) {
        mesh->files = files;
        files[mesh->file_count++] = file;
    } else {
        free(file.path);
    }
    if (!buffer->own || !files)
        return lx_gltf_fail(gltf, buffer->own ? LX_MSG_OUT_OF_MEMORY : LX_MSG_NAMED_FILE_NOT_READ, "%s", "");
    return true;
}

static bool read_buffer(struct lx_gltf *gltf, size_t number)
{
    static const char data[] = "data:", base64[] = ";base64,";
    struct lx_gltf_buffer *buffer = &gltf->buffers[number];
    const uint32_t object = gltf->lists[LX_GLTF_BUFFERS][number];
    const uint32_t uri = lx_json_find(&gltf->json, object, "uri");
    size_t length;
    if (!lx_gltf_whole(gltf, object, "byteLength", SIZE_MAX, &length))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "buffers[%zu].byteLength", number);
    if (!uri) {
        if (number > 0 || !gltf->chunk)
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "buffers[%zu].uri", number);
        buffer->bytes = gltf->chunk;
        buffer->length = gltf->chunk_length;
    } else {
        char *name = lx_json_string(&gltf->json, uri);
        if (!name)
            return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "buffers[%zu].uri", number);
        if (strncasecmp(name, data, sizeof data - 1) == 0) {
            char *start = strstr(name, base64);
            buffer->length = start ? strlen(start + sizeof base64 - 1) : 0;
            buffer->own = name;
            buffer->bytes = start ? start + sizeof base64 - 1 : name;
            if (!start || !decode(start + sizeof base64 - 1, &buffer->length))
                return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "buffers[%zu].uri", number);
        } else {
            const bool is_read = read_file(gltf, name, buffer);
            free(name);
            if (!is_read)
                return false;
        }
    }
    if (buffer->length < length)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_RANGE, "buffers[%zu].byteLength", number);
    buffer->length = length;
    gltf->total += length;
    return true;
}

bool lx_gltf_read_buffers(struct lx_gltf *gltf)
{
    gltf->buffers = lx_new_array(gltf->counts[LX_GLTF_BUFFERS] + 1, sizeof *gltf->buffers);
    if (!gltf->buffers)
        return lx_gltf_fail(gltf, LX_MSG_OUT_OF_MEMORY, "%s", "");
    for (size_t i = 0; i < gltf->counts[LX_GLTF_BUFFERS]; i++)
        if (!read_buffer(gltf, i))
            return false;
    return true;
}

/* ---- accessors ---- */

static bool type_of(size_t code, enum lx_binary_type *type)
{
    static const struct {
        size_t code;
        enum lx_binary_type type;
    } codes[] = {{5120, LX_INT8},   {5121, LX_UINT8},  {5122, LX_INT16},
                 {5123, LX_UINT16}, {5125, LX_UINT32}, {5126, LX_FLOAT32}};
    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++)
        if (codes[i].code == code) {
            *type = codes[i].type;
            return true;
        }
    return false;
}

/* Numbers that stand in a view: count items of so many components, which all are there. */
struct array {
    const char *bytes;
    size_t stride;
    enum lx_binary_type type;
    double most; /* the whole number that stands for 1; 0: numbers are what they are */
};

/* The array that an object with bufferView, byteOffset and componentType tells, its name in the file being `name`. */
static bool find_array(struct lx_gltf *gltf, uint32_t object, const char *name, size_t type_code, size_t components,
                       size_t count, bool is_packed, struct array *array)
{
    size_t number, offset, buffer, start, length, stride;
    if (!lx_gltf_whole(gltf, object, "bufferView", SIZE_MAX, &number) || number >= gltf->counts[LX_GLTF_VIEWS])
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "%s.bufferView", name);
    if (!lx_gltf_whole(gltf, object, "byteOffset", 0, &offset))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "%s.byteOffset", name);
    if (!type_of(type_code, &array->type))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "%s.componentType", name);
    const uint32_t view = gltf->lists[LX_GLTF_VIEWS][number];
    const uint32_t extensions = lx_json_find(&gltf->json, view, "extensions");
    if (lx_json_find(&gltf->json, extensions, "EXT_meshopt_compression"))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_EXTENSION, "EXT_meshopt_compression");
    const size_t item = components * lx_binary_size(array->type);
    if (!lx_gltf_whole(gltf, view, "buffer", SIZE_MAX, &buffer) || buffer >= gltf->counts[LX_GLTF_BUFFERS] ||
        !lx_gltf_whole(gltf, view, "byteOffset", 0, &start) ||
        !lx_gltf_whole(gltf, view, "byteLength", SIZE_MAX, &length) ||
        !lx_gltf_whole(gltf, view, "byteStride", item, &stride) || stride < item)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "bufferViews[%zu]", number);
    array->stride = is_packed ? item : stride;
    if (start > gltf->buffers[buffer].length || length > gltf->buffers[buffer].length - start)
        return lx_gltf_fail(gltf, LX_MSG_GLTF_RANGE, "bufferViews[%zu]", number);
    if (count > 0 &&
        (offset > length || item > length - offset || (count - 1) > (length - offset - item) / array->stride))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_RANGE, "%s", name);
    array->bytes = gltf->buffers[buffer].bytes + start + (count > 0 ? offset : 0);
    return true;
}

static double number_at(const struct array *array, size_t item, size_t component)
{
    const char *at = array->bytes + item * array->stride + component * lx_binary_size(array->type);
    const double number = lx_binary_number(at, array->type, false);
    return array->most > 0 ? fmax(number / array->most, -1) : number;
}

/* Puts the values of a sparse accessor where they belong. */
static bool add_sparse(struct lx_gltf *gltf, uint32_t sparse, const char *name, size_t type_code, size_t components,
                       size_t count, double most, double *numbers)
{
    char part[64];
    size_t few, index_code;
    struct array indices, values;
    const uint32_t where = lx_json_find(&gltf->json, sparse, "indices");
    if (!lx_gltf_whole(gltf, sparse, "count", SIZE_MAX, &few) || few > count ||
        !lx_gltf_whole(gltf, where, "componentType", SIZE_MAX, &index_code))
        return lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "%s.sparse", name);
    snprintf(part, sizeof part, "%s.sparse.indices", name);
    if (!find_array(gltf, where, part, index_code, 1, few, true, &indices))
        return false;
    snprintf(part, sizeof part, "%s.sparse.values", name);
    if (!find_array(gltf, lx_json_find(&gltf->json, sparse, "values"), part, type_code, components, few, true, &values))
        return false;
    values.most = most;
    for (size_t i = 0; i < few; i++) {
        const double index = number_at(&indices, i, 0);
        if (!(index >= 0 && index < (double)count && index == floor(index)))
            return lx_gltf_fail(gltf, LX_MSG_GLTF_RANGE, "%s.sparse.indices", name);
        for (size_t k = 0; k < components; k++)
            numbers[(size_t)index * components + k] = number_at(&values, i, k);
    }
    return true;
}

/* Whether the type of an accessor is what is read. */
static bool fits(const struct lx_gltf *gltf, uint32_t object, size_t components, bool is_index, size_t code)
{
    const uint32_t type = lx_json_find(&gltf->json, object, "type");
    const char *wanted = components == 3 ? "VEC3" : "SCALAR";
    const struct lx_json_value *value = &gltf->json.values[type];
    return value->type == LX_JSON_STRING && value->length == strlen(wanted) &&
           memcmp(value->text, wanted, value->length) == 0 &&
           (is_index ? code == 5121 || code == 5123 || code == 5125
                     : code == 5126 || (gltf->is_quantized && code >= 5120 && code <= 5123));
}

/* The whole number that stands for 1; 0: the numbers of an accessor are what they are. */
static double most_of(const struct lx_gltf *gltf, uint32_t object, size_t code)
{
    static const double most[] = {127, 255, 32767, 65535};
    const uint32_t normalized = lx_json_find(&gltf->json, object, "normalized");
    return gltf->json.values[normalized].type == LX_JSON_TRUE && code <= 5123 ? most[code - 5120] : 0;
}

double *lx_gltf_numbers(struct lx_gltf *gltf, size_t accessor, size_t components, bool is_index, size_t *count,
                        size_t *restart)
{
    char name[48];
    size_t code;
    if (accessor >= gltf->counts[LX_GLTF_ACCESSORS]) {
        lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "accessors[%zu]", accessor);
        return NULL;
    }
    const uint32_t object = gltf->lists[LX_GLTF_ACCESSORS][accessor];
    const uint32_t sparse = lx_json_find(&gltf->json, object, "sparse");
    const bool has_view = lx_json_find(&gltf->json, object, "bufferView") != 0;
    snprintf(name, sizeof name, "accessors[%zu]", accessor);
    if (!lx_gltf_whole(gltf, object, "count", SIZE_MAX, count) ||
        !lx_gltf_whole(gltf, object, "componentType", SIZE_MAX, &code) ||
        !fits(gltf, object, components, is_index, code)) {
        lx_gltf_fail(gltf, LX_MSG_GLTF_VALUE, "%s", name);
        return NULL;
    }
    const double most = most_of(gltf, object, code);
    struct array array = {.bytes = NULL};
    if (has_view ? !find_array(gltf, object, name, code, components, *count, false, &array) : *count > gltf->total) {
        if (!has_view) /* zeros, more of them than there are bytes */
            lx_gltf_fail(gltf, LX_MSG_GLTF_RANGE, "%s", name);
        return NULL;
    }
    double *numbers = lx_new_array(*count * components + 1, sizeof *numbers);
    if (!numbers) {
        lx_gltf_fail(gltf, LX_MSG_OUT_OF_MEMORY, "%s", "");
        return NULL;
    }
    array.most = most;
    for (size_t i = 0; has_view && i < *count; i++)
        for (size_t k = 0; k < components; k++)
            numbers[i * components + k] = number_at(&array, i, k);
    *restart = code == 5121 ? 255 : code == 5123 ? 65535 : UINT32_MAX;
    if (sparse && !add_sparse(gltf, sparse, name, code, components, *count, most, numbers)) {
        free(numbers);
        return NULL;
    }
    return numbers;
}
