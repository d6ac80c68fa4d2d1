/* SPDX-License-Identifier: MIT */
/* What the present scene holds, as the space view and the lists show it; keys and kinds; built-in scenes. */
#include <stdio.h>
#include <string.h>

#include "answer.h"
#include "core.h"

/* A choice of a key, or the name of a kind, as people read it. */
static void answer_label(const char *choice)
{
    const char *label = luxel_parameter_choice_label(choice);
    answer_string(label ? page_translate(label, NULL) : choice);
}

static void answer_light(size_t i)
{
    double at[3], along[3], flux;
    answer_open('{');
    answer_key("type");
    answer_string(luxel_scene_light_type(core.scene, i));
    answer_key("label");
    answer_label(luxel_scene_light_type(core.scene, i));
    answer_key("name");
    answer_string(luxel_scene_light_name(core.scene, i));
    answer_key("enabled");
    answer_bool(luxel_scene_light_enabled(core.scene, i));
    answer_key("place");
    answer_numbers(luxel_scene_light_place(core.scene, i, at) ? at : NULL, 3);
    answer_key("direction");
    answer_numbers(luxel_scene_light_direction(core.scene, i, along) ? along : NULL, 3);
    answer_key("flux");
    answer_number(luxel_scene_light_flux(core.scene, i, &flux) == LUXEL_OK ? flux : -1);
    answer_close('}');
}

static void answer_surface(size_t i)
{
    double center[3], radius;
    if (luxel_scene_surface_place(core.scene, i, center) != LUXEL_OK ||
        luxel_scene_surface_radius(core.scene, i, &radius) != LUXEL_OK) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_key("center");
    answer_numbers(center, 3);
    answer_key("reach");
    answer_number(radius);
    answer_close('}');
}

static void answer_surfaces(void)
{
    answer_key("surfaces");
    answer_open('[');
    for (size_t i = 0; i < luxel_scene_surface_count(core.scene); i++)
        answer_surface(i);
    answer_close(']');
}

static void answer_points(void)
{
    double point[2];
    answer_key("points");
    answer_open('[');
    for (size_t i = 0; i < luxel_scene_point_count(core.scene); i++)
        if (luxel_scene_point(core.scene, i, &point[0], &point[1]) == LUXEL_OK)
            answer_numbers(point, 2);
    answer_close(']');
}

PAGE_CALLS(page_scene) const char *page_scene(void)
{
    unsigned columns = 0, rows = 0;
    if (!core.scene)
        return NULL;
    (void)luxel_scene_resolution(core.scene, &columns, &rows);
    answer_begin();
    answer_open('{');
    answer_key("columns");
    answer_number(columns);
    answer_key("rows");
    answer_number(rows);
    answer_key("unit");
    answer_string(page_translate(luxel_scene_unit(core.scene, core.quantity), NULL));
    answer_key("word");
    answer_string(luxel_scene_quantity_word(core.scene, core.quantity));
    answer_key("irradiance_unit");
    answer_string(page_translate(luxel_scene_unit(core.scene, LUXEL_IRRADIANCE), NULL));
    answer_key("grids");
    answer_number((double)luxel_scene_grid_count(core.scene));
    answer_key("observers");
    answer_number((double)luxel_scene_observer_count(core.scene));
    answer_key("lights");
    answer_open('[');
    for (size_t i = 0; i < luxel_scene_light_count(core.scene); i++)
        answer_light(i);
    answer_close(']');
    answer_surfaces();
    answer_points();
    answer_close('}');
    return answer_text();
}

/* Where a place of the scene is seen on the screen, and how high it stands above it: x, y, z in mm. */
PAGE_CALLS(page_project) const char *page_project(double x, double y, double z)
{
    const double place[3] = {x, y, z};
    double seen[3];
    if (!luxel_scene_project(core.scene, place, seen) || !luxel_scene_height(core.scene, place, &seen[2]))
        return NULL;
    answer_begin();
    answer_numbers(seen, 3);
    return answer_text();
}

/* The place at a height above the screen that is seen at a point of it. */
PAGE_CALLS(page_unproject) const char *page_unproject(double x, double y, double height)
{
    const double screen[2] = {x, y};
    double place[3];
    if (!luxel_scene_unproject(core.scene, screen, height, place))
        return NULL;
    answer_begin();
    answer_numbers(place, 3);
    return answer_text();
}

static void answer_interval(const char *key, const luxel_parameter_range *interval)
{
    answer_key(key);
    if (!interval->given) {
        answer_string(NULL);
        return;
    }
    answer_open('[');
    answer_number(interval->low); /* infinity becomes null, as the page has it */
    answer_number(interval->high);
    answer_close(']');
}

/* The labels of the choices "centers, nodes"; none of NULL. */
static void answer_labels(const char *choices)
{
    char word[64];
    answer_open('[');
    for (const char *at = choices; at && *at;) {
        const size_t length = strcspn(at, ",");
        (void)snprintf(word, sizeof word, "%.*s", (int)length, at);
        answer_label(word);
        at += length + strspn(at + length, ", ");
    }
    answer_close(']');
}

static void answer_parameter(const luxel_parameter *parameter)
{
    answer_open('{');
    answer_key("path");
    answer_string(parameter->path);
    answer_key("variant");
    answer_string(parameter->variant);
    answer_key("type");
    answer_number(parameter->value_type);
    answer_key("count");
    answer_number(parameter->count);
    answer_key("choices");
    answer_string(parameter->choices);
    answer_key("labels");
    answer_labels(parameter->choices);
    answer_key("unit");
    answer_string(parameter->unit);
    answer_key("photometric");
    answer_string(parameter->photometric_unit);
    answer_key("label");
    answer_string(parameter->label);
    answer_key("meaning");
    answer_string(parameter->meaning);
    answer_key("legal");
    answer_string(parameter->legal);
    answer_interval("advised", &parameter->advised_range[0]);
    answer_close('}');
}

static void answer_kind(const luxel_parameter_kind *kind)
{
    answer_open('{');
    answer_key("list");
    answer_string(kind->list);
    answer_key("name");
    answer_string(kind->name);
    answer_key("label");
    answer_label(kind->name);
    answer_key("meaning");
    answer_string(kind->meaning);
    answer_key("example");
    answer_string(kind->example);
    answer_close('}');
}

/* All keys and kinds in the page's language. */
PAGE_CALLS(page_parameters) const char *page_parameters(void)
{
    luxel_parameters *parameters = luxel_parameters_new_translated(page_translate, NULL);
    if (!parameters)
        return NULL;
    answer_begin();
    answer_open('{');
    answer_key("keys");
    answer_open('[');
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        answer_parameter(luxel_parameters_get(parameters, i));
    answer_close(']');
    answer_key("kinds");
    answer_open('[');
    for (size_t i = 0; i < luxel_parameters_kind_count(parameters); i++)
        answer_kind(luxel_parameters_kind(parameters, i));
    answer_close(']');
    answer_close('}');
    luxel_parameters_free(parameters);
    return answer_text();
}

PAGE_CALLS(page_version) const char *page_version(void)
{
    return luxel_version();
}

PAGE_CALLS(page_builtins) const char *page_builtins(void)
{
    answer_begin();
    answer_open('[');
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++) {
        answer_open('{');
        answer_key("name");
        answer_string(luxel_builtin_scene_name(i));
        answer_key("title");
        answer_string(page_translate(luxel_builtin_scene_title(i), NULL));
        answer_key("text");
        answer_string(luxel_builtin_scene_text(i));
        answer_close('}');
    }
    answer_close(']');
    return answer_text();
}
