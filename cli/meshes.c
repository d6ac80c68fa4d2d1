/* SPDX-License-Identifier: MIT */
/* Prints what the meshes of a scene are as bodies: as a table for each, or as JSON. */
#include "meshes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "text.h"

static bool append(struct meshes *meshes, const struct mesh *mesh)
{
    if (meshes->count == meshes->capacity) {
        const size_t capacity = meshes->capacity ? 2 * meshes->capacity : 8;
        struct mesh *list = realloc(meshes->list, capacity * sizeof *list);

        if (!list)
            return false;
        meshes->list = list;
        meshes->capacity = capacity;
    }
    meshes->list[meshes->count++] = *mesh;
    return true;
}

/* Gathers those of surfaces, or of lights; false: memory ran out. */
static bool gather_from(const luxel_scene *scene, bool of_lights, struct meshes *meshes)
{
    const size_t count = of_lights ? luxel_scene_light_count(scene) : luxel_scene_surface_count(scene);

    for (size_t i = 0; i < count; i++) {
        struct mesh mesh = {.of_light = of_lights, .index = i};
        bool is_mesh = false;
        const luxel_status status = of_lights ? luxel_scene_light_mesh(scene, i, &is_mesh, &mesh.survey)
                                              : luxel_scene_surface_mesh(scene, i, &is_mesh, &mesh.survey);

        if (status != LUXEL_OK || (is_mesh && !append(meshes, &mesh)))
            return false;
    }
    return true;
}

static const char *key_of(const struct mesh *mesh, char buffer[TEXT_SIZE])
{
    return text_format(buffer, "%s[%zu].%s", mesh->of_light ? "lights" : "surfaces", mesh->index, mesh->survey.key);
}

static const char *closed_words(const luxel_mesh_survey *survey, char buffer[TEXT_SIZE])
{
    if (survey->is_closed)
        return _("yes");
    if (survey->crowded_edges == 0)
        return text_format(buffer, _("no; edges of one face alone: %zu"), survey->open_edges);
    return text_format(buffer, _("no; edges of one face alone: %zu, of more than two: %zu"), survey->open_edges,
                       survey->crowded_edges);
}

static const char *flipped_words(const luxel_mesh_survey *survey, char buffer[TEXT_SIZE])
{
    if (survey->is_one_sided)
        return _("faces go on with each other so that no two sides can be told");
    if (survey->flipped_faces == 0)
        return _("none");
    return text_format(buffer, _("%zu, the first is face %u"), survey->flipped_faces, survey->first_flipped);
}

static const char *volume_words(const luxel_mesh_survey *survey, char buffer[TEXT_SIZE])
{
    if (isnan(survey->volume_mm3))
        return _("none, since it bounds no body");
    if (survey->volume_mm3 < 0)
        return text_format(buffer, _("%.6g mm³, its faces look inwards"), -survey->volume_mm3);
    return text_format(buffer, _("%.6g mm³"), survey->volume_mm3);
}

static void print(const struct mesh *mesh)
{
    const luxel_mesh_survey *survey = &mesh->survey;
    struct text_table *table = text_table_new("ll");
    char text[TEXT_SIZE];

    printf("%s: ", key_of(mesh, text));
    text_print_escaped(stdout, survey->file);
    putchar('\n');
    text_table_row(table, TEXT_CELLS(_("triangles"), text_format(text, "%zu", survey->triangles)));
    text_table_row(table, TEXT_CELLS(_("closed"), closed_words(survey, text)));
    text_table_row(table, TEXT_CELLS(_("Euler number"),
                                     text_format(text, _("%ld, parts: %zu, corners: %zu, edges: %zu"),
                                                 survey->euler_number, survey->parts, survey->corners, survey->edges)));
    text_table_row(table, TEXT_CELLS(_("flipped faces"), flipped_words(survey, text)));
    text_table_row(table, TEXT_CELLS(_("enclosed volume"), volume_words(survey, text)));
    text_table_row(table,
                   TEXT_CELLS(_("size"), text_format(text, _("%.6g × %.6g × %.6g mm, a unit of the file: %.6g mm"),
                                                     survey->size_mm[0], survey->size_mm[1], survey->size_mm[2],
                                                     survey->scale_mm)));
    text_table_print(table, stdout, 2);
}

/* In the order of files, of their scales, and where they are named. */
static int compare(const void *first, const void *second)
{
    const struct mesh *a = *(const struct mesh *const *)first, *b = *(const struct mesh *const *)second;
    const int files = strcmp(a->survey.file, b->survey.file);

    if (files != 0)
        return files;
    if (a->survey.scale_mm != b->survey.scale_mm)
        return a->survey.scale_mm < b->survey.scale_mm ? -1 : 1;
    return a < b ? -1 : a > b;
}

/* Marks those that say the same as one before them; false: memory ran out. */
static bool mark_repeated(struct meshes *meshes)
{
    const struct mesh **sorted = malloc((meshes->count + 1) * sizeof *sorted);

    if (!sorted)
        return false;
    for (size_t i = 0; i < meshes->count; i++)
        sorted[i] = &meshes->list[i];
    if (meshes->count > 0)
        qsort(sorted, meshes->count, sizeof *sorted, compare);
    for (size_t i = meshes->count; i-- > 1;)
        if (strcmp(sorted[i]->survey.file, sorted[i - 1]->survey.file) == 0 &&
            sorted[i]->survey.scale_mm == sorted[i - 1]->survey.scale_mm)
            meshes->list[sorted[i] - meshes->list].is_repeated = true;
    free(sorted);
    return true;
}

bool meshes_gather(const luxel_scene *scene, struct meshes *meshes)
{
    return gather_from(scene, false, meshes) && gather_from(scene, true, meshes) && mark_repeated(meshes);
}

void meshes_clear(struct meshes *meshes)
{
    free(meshes->list);
    *meshes = (struct meshes){.list = NULL};
}

void meshes_print(const struct meshes *meshes)
{
    for (size_t i = 0; i < meshes->count; i++)
        if (!meshes->list[i].is_repeated)
            print(&meshes->list[i]);
}

static void write(struct json *json, const struct mesh *mesh)
{
    const luxel_mesh_survey *survey = &mesh->survey;
    char *file = luxel_escaped_text(survey->file); /* a file's name may be no UTF-8 */
    char text[TEXT_SIZE];

    json_open(json, NULL, '{');
    json_text(json, "key", key_of(mesh, text));
    json_text(json, "file", file);
    json_whole(json, "triangles", survey->triangles);
    json_whole(json, "corners", survey->corners);
    json_whole(json, "edges", survey->edges);
    json_whole(json, "open_edges", survey->open_edges);
    json_whole(json, "crowded_edges", survey->crowded_edges);
    json_bool(json, "closed", survey->is_closed);
    json_number(json, "euler_number", (double)survey->euler_number);
    json_whole(json, "parts", survey->parts);
    json_whole(json, "flipped_faces", survey->flipped_faces);
    json_bool(json, "one_sided", survey->is_one_sided);
    json_number(json, "volume_mm3", survey->volume_mm3);
    json_number(json, "scale_mm", survey->scale_mm);
    json_numbers(json, "size_mm", survey->size_mm, 3);
    json_close(json, '}');
    luxel_text_free(file);
}

void meshes_write(struct json *json, const struct meshes *meshes)
{
    json_open(json, "meshes", '[');
    for (size_t i = 0; i < meshes->count; i++)
        write(json, &meshes->list[i]);
    json_close(json, ']');
}
