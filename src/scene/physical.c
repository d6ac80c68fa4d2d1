/* SPDX-License-Identifier: MIT */
/*
 * What reflected light asks of a scene, beyond what each of its keys may be: surfaces whose sides are known and
 * that send back less than they get, as reflectances and not as weights, and lights whose law is physical; and mirrors,
 * which have to be flat, and do not go with it.
 */
#include <string.h>

#include "../base/number.h"
#include "../light/light.h"
#include "../material/lobe.h"
#include "../surface/mesh_faces.h"
#include "materials.h"
#include "object.h"

/* A way down from the root of the document; the deepest node on it that was written. */
struct descent {
    const struct lx_document *document;
    lx_node_id node, place;
};

static void descend(struct descent *descent, lx_node_id next)
{
    descent->node = next;
    if (next)
        descent->place = next;
}

static void go_to_key(struct descent *descent, const char *key)
{
    descend(descent, descent->node ? lx_document_find(descent->document, descent->node, key) : 0);
}

static void go_to_element(struct descent *descent, size_t index)
{
    lx_node_id id = descent->node ? lx_document_node(descent->document, descent->node)->first : 0;
    for (size_t k = 0; k < index && id; k++)
        id = lx_document_node(descent->document, id)->next;
    descend(descent, id);
}

static struct descent begin(const struct lx_document *document)
{
    return (struct descent){document, document->root, document->root};
}

/* Reports at a key of a material; `found`: what is there, or NULL; where the material stands follows it. */
static void report_material(struct lx_walk *walk, const struct lx_scene_material *at, const char *key,
                            enum lx_message message, const char *found)
{
    const struct lx_document *document = walk->document;
    struct descent descent = begin(document);
    go_to_key(&descent, "surfaces");
    go_to_element(&descent, at->surface);
    go_to_key(&descent, at->part ? "materials" : "material");
    struct lx_step list = {NULL, "surfaces", 0}, item = {&list, NULL, at->surface},
                   group = {&item, at->part ? "materials" : "material", 0}, part = {&group, at->part, 0};
    if (at->part)
        go_to_key(&descent, at->part);
    go_to_key(&descent, key);
    struct lx_step step = {at->part ? &part : &group, key, 0};
    char where[LX_MATERIAL_KEY_SIZE];
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, descent.place), &step, message, found,
                   lx_material_key(at, where));
}

static bool is_sound(const struct lx_scene_parameters *scene)
{
    for (size_t i = 0; i < scene->surfaces.count; i++)
        if (!scene->surfaces.items[i].variant)
            return false;
    return true;
}

static void check_materials(struct lx_walk *walk, const luxel_scene *scene)
{
    struct lx_scene_material at = {.material = NULL};
    while (lx_next_material(&scene->parameters, &at)) {
        char number[LX_NUMBER_SIZE];
        if (!lx_lobe_kinds[at.material->model]->is_lambertian) {
            const struct lx_parameter *model = lx_find_parameter(&lx_material_table, "model");
            report_material(walk, &at, "model", LX_MSG_REFLECTS_BY_MODEL, lx_chosen(model, at.material));
            lx_hint(walk->diagnostics, LX_MSG_HINT_LAMBERT, NULL);
        }
        const struct lx_lobe lobe = lx_lobe_prepare(at.material);
        if (lx_lobe_is_rough(&lobe)) {
            const struct lx_parameter *model = lx_find_parameter(&lx_material_table, "diffuse_model");
            report_material(walk, &at, "diffuse_model", LX_MSG_REFLECTS_BY_MODEL, lx_chosen(model, at.material));
            lx_hint(walk->diagnostics, LX_MSG_HINT_DIFFUSE_LAMBERT, NULL);
        }
        if (!at.material->over_pi) {
            report_material(walk, &at, "over_pi", LX_MSG_REFLECTS_BY_WEIGHT, NULL);
            lx_hint(walk->diagnostics, LX_MSG_HINT_OVER_PI, NULL);
        }
        if (at.material->diffuse >= 1) {
            report_material(walk, &at, "diffuse", LX_MSG_REFLECTS_ALL, lx_write_number(at.material->diffuse, number));
            lx_hint(walk->diagnostics, LX_MSG_HINT_LOWER_DIFFUSE, NULL);
        }
    }
}

const char *lx_foreign_law(const struct lx_item *light)
{
    const struct lx_parameter *law = lx_find_parameter(light->variant->table, "attenuation");
    const char *word = law ? lx_chosen(law, light->parameters) : NULL;
    return word && strcmp(word, "inverse-square") != 0 ? word : NULL;
}

/* Reports at a key of an element of a list of the scene. */
static void report_at(struct lx_walk *walk, const char *list, size_t i, const char *key, enum lx_message message,
                      const char *first, const char *second)
{
    struct descent descent = begin(walk->document);
    struct lx_step whole = {NULL, list, 0}, item = {&whole, NULL, i}, step = {&item, key, 0};
    go_to_key(&descent, list);
    go_to_element(&descent, i);
    go_to_key(&descent, key);
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(walk->document, descent.place), &step, message, first,
                   second);
}

/* What is compared with the sun outside of the atmosphere, whose default is in radiometric units. */
static void check_weather(struct lx_walk *walk, const luxel_scene *scene)
{
    static const char KEY[] = "extraterrestrial";
    for (size_t i = 0; i < scene->parameters.lights.count && scene->parameters.units == LX_PHOTOMETRIC; i++) {
        const struct lx_item *light = &scene->parameters.lights.items[i];
        const struct lx_table *table = light->variant ? light->variant->table : NULL;
        if (!table || !lx_find_parameter(table, KEY) || !lx_is_given(table, light->parameters, "diffuse") ||
            lx_is_given(table, light->parameters, KEY))
            continue;
        report_at(walk, "lights", i, KEY, LX_MSG_PEREZ_UNITS, NULL, NULL);
        lx_hint(walk->diagnostics, LX_MSG_HINT_PEREZ_UNITS, NULL);
    }
}

static void check_laws(struct lx_walk *walk, const luxel_scene *scene)
{
    for (size_t i = 0; i < scene->parameters.lights.count; i++) {
        const struct lx_item *light = &scene->parameters.lights.items[i];
        const bool is_on = light->variant && ((const struct lx_light_common *)light->common)->enabled;
        const char *law = is_on ? lx_foreign_law(light) : NULL;
        if (!law)
            continue;
        report_at(walk, "lights", i, "attenuation", LX_MSG_REFLECTS_BY_LAW, law, NULL);
        lx_hint(walk->diagnostics, LX_MSG_HINT_INVERSE_SQUARE, NULL);
    }
}

/* Reports at a key of a surface. */
static void report_surface(struct lx_walk *walk, size_t surface, const char *key, enum lx_message message,
                           const char *first, const char *second)
{
    report_at(walk, "surfaces", surface, key, message, first, second);
}

static const struct lx_surface_kind *kind_of(const luxel_scene *scene, size_t surface)
{
    return (const struct lx_surface_kind *)scene->parameters.surfaces.items[surface].variant;
}

/* Kinds that nobody can integrate over. */
static void check_sides(struct lx_walk *walk, const luxel_scene *scene)
{
    for (size_t i = 0; i < scene->parameters.surfaces.count; i++) {
        if (lx_surface_has_sides(kind_of(scene, i)))
            continue;
        report_surface(walk, i, "type", LX_MSG_REFLECTS_WITHOUT_SIDES, kind_of(scene, i)->variant.name, NULL);
        lx_hint(walk->diagnostics, LX_MSG_HINT_REFLECTIONS_NONE, NULL);
    }
}

/* The first surface that is not all within another one; the number of surfaces where there is none. */
static size_t find_outside(const luxel_scene *scene, size_t around)
{
    const struct lx_list *surfaces = &scene->parameters.surfaces;
    double low[3], high[3], least[3], most[3];
    kind_of(scene, around)->extent(surfaces->items[around].parameters, least, most);
    for (size_t i = 0; i < surfaces->count; i++) {
        kind_of(scene, i)->extent(surfaces->items[i].parameters, low, high);
        for (int k = 0; k < 3; k++) {
            const double room = 1e-9 * (most[k] - least[k]);
            if (low[k] < least[k] - room || high[k] > most[k] + room)
                return i;
        }
    }
    return surfaces->count;
}

/* Light that surfaces send to each other through glass, of which nobody knows how much comes through. */
static void check_glass(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_list *surfaces = &scene->parameters.surfaces;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct lx_surface_kind *kind = kind_of(scene, i);
        struct lx_glass_pane pane = {.index = 0};
        char number[LX_NUMBER_SIZE];
        bool is_glazed = false;
        for (size_t k = 0; kind->panes && k < kind->panes(surfaces->items[i].parameters, k, &pane); k++)
            is_glazed = is_glazed || pane.index > 0;
        if (!is_glazed)
            continue;
        const size_t outside = find_outside(scene, i);
        if (outside == surfaces->count)
            continue;
        report_surface(walk, i, "openings", LX_MSG_GLASS_REFLECTIONS, lx_write_number((double)outside, number), NULL);
        lx_hint(walk->diagnostics, LX_MSG_HINT_REFLECTIONS_NONE, NULL);
    }
}

/* Meshes of more triangles than reflected light can be calculated of. */
static void check_meshes(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_list *surfaces = &scene->parameters.surfaces;
    size_t sum = 0;
    for (size_t i = 0; i < surfaces->count && sum <= LX_MOST_REFLECTING; i++) {
        const struct lx_surface_kind *kind = kind_of(scene, i);
        const struct lx_shape shape =
            kind->mesh ? lx_surface_shape(kind, surfaces->items[i].parameters) : (struct lx_shape){0};
        char count[LX_NUMBER_SIZE], most[LX_NUMBER_SIZE];
        if (!shape.body)
            continue;
        sum += lx_mesh_count(&shape);
        if (sum <= LX_MOST_REFLECTING)
            continue;
        report_surface(walk, i, "file", LX_MSG_REFLECTS_TOO_MANY, lx_write_number((double)sum, count),
                       lx_write_number(LX_MOST_REFLECTING, most));
        lx_hint(walk->diagnostics, LX_MSG_HINT_REFLECTIONS_NONE, NULL);
    }
}

/* Whether light may come from the sky or through openings, which images in mirrors know nothing of. */
static bool has_daylight(const struct lx_scene_parameters *parameters)
{
    for (size_t i = 0; i < parameters->lights.count; i++) {
        const struct lx_light_kind *kind = (const struct lx_light_kind *)parameters->lights.items[i].variant;
        if (kind && kind->is_daylight)
            return true;
    }
    for (size_t i = 0; i < parameters->surfaces.count; i++) {
        const struct lx_item *surface = &parameters->surfaces.items[i];
        const struct lx_table *table = surface->variant->table;
        if (lx_find_parameter(table, "openings") && lx_is_given(table, surface->parameters, "openings"))
            return true;
    }
    return false;
}

/* Reports a mirror that light cannot be followed over: of a material, or of a surface where there is none. */
static void report_mirror(struct lx_walk *walk, const struct lx_scene_material *at, size_t surface, bool reflects)
{
    const enum lx_message message = reflects ? LX_MSG_MIRROR_REFLECTS : LX_MSG_MIRROR_DAYLIGHT;
    if (at)
        report_material(walk, at, "mirror", message, NULL);
    else
        report_surface(walk, surface, "mirror", message, NULL, NULL);
    lx_hint(walk->diagnostics, reflects ? LX_MSG_HINT_NO_MIRROR : LX_MSG_HINT_NO_DAYLIGHT, NULL);
}

/* Mirrors: on what is no mirror, with reflected light, and with daylight. */
static void check_mirrors(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_scene_parameters *parameters = &scene->parameters;
    const bool reflects = parameters->reflections.choice != LX_REFLECTIONS_NONE,
               is_refused = reflects || has_daylight(parameters);
    struct lx_scene_material at = {.material = NULL};
    while (lx_next_material(parameters, &at)) {
        const struct lx_surface_kind *kind = kind_of(scene, at.surface);
        if (at.material->mirror && !kind->is_mirror && !kind->part_names) {
            report_material(walk, &at, "mirror", LX_MSG_MIRROR_NOT_FLAT, kind->variant.name);
            lx_hint(walk->diagnostics, LX_MSG_HINT_FLAT_MIRROR, NULL);
        } else if (at.material->mirror && is_refused) {
            report_mirror(walk, &at, at.surface, reflects);
        }
    }
    for (size_t i = 0; i < parameters->surfaces.count && is_refused; i++) {
        const struct lx_surface_kind *kind = kind_of(scene, i);
        if (kind->is_mirror && kind->is_mirror(parameters->surfaces.items[i].parameters))
            report_mirror(walk, NULL, i, reflects);
    }
}

void lx_validate_reflections(struct lx_walk *walk, const luxel_scene *scene)
{
    if (is_sound(&scene->parameters))
        check_mirrors(walk, scene);
    check_weather(walk, scene);
    if (scene->parameters.reflections.choice == LX_REFLECTIONS_NONE)
        return;
    if (is_sound(&scene->parameters)) {
        check_materials(walk, scene);
        check_sides(walk, scene);
        check_glass(walk, scene);
        check_meshes(walk, scene);
    }
    check_laws(walk, scene);
}
