/* SPDX-License-Identifier: MIT */
/* Finding the choices that a scene has, and evaluating copies of it in which they are made. */
#include "alternatives.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../api/refuse.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../parameter/decode.h"
#include "../scene/lit.h"
#include "../scene/materials.h"
#include "../world/camera.h"

/* Where the key of a convention stands. */
enum holder { SCREEN, OBSERVER, MATERIAL, LIGHT };

/* The most choices that a convention has. */
enum { MOST_WORDS = 4 };

struct convention {
    const char *name;
    enum holder holder;
    const char *key;
    const char *choices[MOST_WORDS + 1];
    const char *meanings[MOST_WORDS];
};

static const struct convention conventions[] = {
    {LX_N("view vector"),
     OBSERVER,
     "view",
     {"parallel", "observer", NULL},
     {LX_N("along z, the same everywhere"), LX_N("from each point to the observer")}},
    {LX_N("projection"),
     OBSERVER,
     "projection",
     {"orthographic", "perspective", NULL},
     {LX_N("lines of sight along z"), LX_N("lines of sight from the observer")}},
    {LX_N("reflection model"),
     MATERIAL,
     "model",
     {"blinn-phong", "phong", "lambert", NULL},
     {LX_N("highlight by the half vector"), LX_N("highlight by the mirrored ray"), LX_N("no highlight")}},
    {LX_N("highlight"),
     MATERIAL,
     "highlight",
     {"plain", "gated", "cosine", NULL},
     {LX_N("everywhere, also where the light is behind the surface"), LX_N("only where the light is in front"),
      LX_N("times the cosine of incidence")}},
    {LX_N("division by π"),
     MATERIAL,
     "over_pi",
     {"false", "true", NULL},
     {LX_N("everything without the factor 1/π"), LX_N("everything times 1/π, as a radiance or luminance has it")}},
    {LX_N("normalized highlight"),
     MATERIAL,
     "normalized",
     {"false", "true", NULL},
     {LX_N("the coefficient ks as it is"), LX_N("ks times the factor that keeps the energy")}},
    {LX_N("attenuation"),
     LIGHT,
     "attenuation",
     {"none", "inverse-square", "practical", "polynomial", NULL},
     {LX_N("none: the distance does not matter"), LX_N("1/r², r in metres"), LX_N("1/(k + r), r in metres"),
      LX_N("1/(kc + kl·r + kq·r²), r in metres")}},
    {LX_N("pattern of the sources"),
     LIGHT,
     "pattern",
     {"isotropic", "lambertian", NULL},
     {LX_N("the same in all directions"), LX_N("times the cosine of the angle from the axis")}},
};

static const struct {
    enum lx_looked_at place;
    const char *choice, *meaning;
} places[] = {
    {LX_AT_POINT, LX_N("exact point"), LX_N("the point of the surface that is seen at x, y itself")},
    {LX_AT_PIXEL, LX_N("pixel"), LX_N("the sample of the pixel that the point falls in")},
    {LX_AT_OTHER_PIXEL, LX_N("pixel of the other sampling"),
     LX_N("the sample of the pixel that it falls in if samples lie by the other rule")},
    {LX_AT_FLIPPED, LX_N("pixel, flipped vertically"),
     LX_N("that of the row counted from the other end, where picture and table disagree on which row is the top")},
};

void lx_choices_clear(struct lx_choices *choices)
{
    for (size_t i = 0; i < choices->count; i++)
        free(choices->list[i].assignment);
    choices->count = 0;
    luxel_scene_free(choices->lit);
    choices->lit = NULL;
}

/* ---- what there is to choose ---- */

static void add_choice(struct lx_choices *choices, struct lx_choice choice)
{
    if (choices->count < LX_MOST_CHOICES)
        choices->list[choices->count++] = choice;
    else
        free(choice.assignment);
}

static void assign(struct lx_text *text, const char *path, const char *key, const char *value)
{
    lx_text_printf(text, "%s%s.%s=%s", text->length > 0 ? " -s " : "", path, key, value);
}

/* The word that a parameter has: a choice, or a truth value. */
static const char *word_of(const struct lx_parameter *parameter, const void *parameters)
{
    if (parameter->type == LX_BOOLEAN)
        return *(const bool *)lx_const_member(parameter, parameters) ? "true" : "false";
    return lx_chosen(parameter, parameters);
}

/* Whether a key has an effect, and whether what it would need to be another word is there. */
static bool is_usable(const struct lx_table *table, const struct lx_parameter *parameter, const void *parameters,
                      const char *word)
{
    for (size_t i = 0; i < table->rule_count; i++) {
        const struct lx_rule *rule = &table->rules[i];
        if (rule->kind == LX_RULE_USED && strcmp(rule->key, parameter->name) == 0 &&
            !lx_rule_applies(rule, table, parameters))
            return false;
        if (rule->kind == LX_RULE_NEEDED && strcmp(rule->other, parameter->name) == 0 && rule->choices &&
            strcmp(rule->choices, word) == 0 && !lx_is_given(table, parameters, rule->key))
            return false;
    }
    return true;
}

/* One place that has the key of a convention: adds what makes it a word; counts those that have it already. */
struct collected {
    struct lx_text text;
    size_t holders, present;
};

static void collect(struct collected *collected, const struct convention *convention, const char *word,
                    const struct lx_table *table, const void *parameters, const char *path)
{
    const struct lx_parameter *parameter = lx_find_parameter(table, convention->key);
    if (!parameter || !is_usable(table, parameter, parameters, word))
        return;
    collected->holders++;
    collected->present += strcmp(word_of(parameter, parameters), word) == 0;
    assign(&collected->text, path, convention->key, word);
}

static void collect_all(struct collected *collected, const struct convention *convention, const char *word,
                        const struct lx_scene_parameters *scene)
{
    const struct lx_parameter *group;
    char path[LX_MATERIAL_KEY_SIZE];
    switch (convention->holder) {
    case SCREEN:
    case OBSERVER:
        group = lx_find_parameter(&lx_scene_table, convention->holder == SCREEN ? "screen" : "observer");
        collect(collected, convention, word, group->group, lx_const_member(group, scene), group->name);
        break;
    case MATERIAL:
        for (struct lx_scene_material at = {0}; lx_next_material(scene, &at);)
            collect(collected, convention, word, &lx_material_table, at.material, lx_material_key(&at, path));
        break;
    case LIGHT:
        for (size_t i = 0; i < scene->lights.count; i++) {
            const struct lx_item *light = &scene->lights.items[i];
            const struct lx_light_common *common = light->common;
            snprintf(path, sizeof path, "lights[%zu]", i);
            if (common->enabled)
                collect(collected, convention, word, light->variant->table, light->parameters, path);
        }
        break;
    }
}

/* The choices of a convention, the present one first; none where there is only one. */
static int find_choices(const struct convention *convention, const struct lx_scene_parameters *scene,
                        struct lx_choices *choices)
{
    struct lx_choice found[MOST_WORDS];
    size_t count = 0;
    bool failed = false;
    for (size_t i = 0; convention->choices[i]; i++) {
        struct collected collected = {0};
        collect_all(&collected, convention, convention->choices[i], scene);
        if (collected.holders == 0)
            continue;
        char *assignment = lx_text_take(&collected.text);
        failed = failed || !assignment;
        found[count++] = (struct lx_choice){
            .convention = convention->name,
            .choice = convention->choices[i],
            .meaning = convention->meanings[i],
            .assignment = assignment,
            .is_present = collected.present == collected.holders,
        };
    }
    for (int present = 1; present >= 0; present--)
        for (size_t i = 0; i < count; i++)
            if (found[i].is_present == (present == 1) && count > 1)
                add_choice(choices, found[i]);
    if (count == 1)
        free(found[0].assignment);
    return failed ? -1 : 0;
}

/* How often light is reflected: not at all, once, as often as the scene says, and until nothing is left. */
static int find_bounces(const struct lx_choice_or_whole *present, struct lx_choices *choices)
{
    static const char *const meanings[] = {LX_N("direct light alone"), LX_N("direct light and the first bounce"),
                                           LX_N("so many bounces"), LX_N("all bounces")};
    const bool is_all = present->choice == LX_REFLECTIONS_ALL;
    char whole[LX_NUMBER_SIZE];
    snprintf(whole, sizeof whole, "%u", present->whole);
    const char *const words[] = {"none", "1", is_all || present->whole == 1 ? NULL : whole, "all"};
    const size_t own = is_all ? 3 : present->whole == 1 ? 1 : 2;
    for (size_t pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < LX_COUNT(words); i++) {
            struct lx_text text = {0};
            if (!words[i] || (i == own) != (pass == 0))
                continue;
            lx_text_printf(&text, "reflections=%s", words[i]);
            char *assignment = lx_text_take(&text);
            if (!assignment)
                return -1;
            add_choice(choices, (struct lx_choice){.convention = LX_N("reflected light"),
                                                   .choice = assignment + strlen("reflections="),
                                                   .meaning = meanings[i],
                                                   .assignment = assignment,
                                                   .is_bounces = true,
                                                   .is_present = i == own});
        }
    choices->has_bounces = true;
    return 0;
}

luxel_status lx_choices_find(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                             luxel_diagnostics *diagnostics, struct lx_choices *choices)
{
    *choices = (struct lx_choices){.scene = scene, .x_mm = x_mm, .y_mm = y_mm};
    if (!scene || !luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    const luxel_status status = lx_scene_lit(scene, settings, diagnostics, &choices->lit);
    if (status != LUXEL_OK)
        return status;
    if (choices->lit)
        choices->scene = choices->lit;
    if (settings)
        choices->settings = *settings;
    else
        luxel_settings_init(&choices->settings);
    choices->settings.skip_reflected_pixels = true;
    const struct lx_scene_parameters *parameters = lx_scene_parameters(choices->scene);
    if (lx_wants_reflections(parameters) && find_bounces(&parameters->reflections, choices) < 0)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < LX_COUNT(places); i++)
        add_choice(choices, (struct lx_choice){.convention = LX_N("place"),
                                               .choice = places[i].choice,
                                               .meaning = places[i].meaning,
                                               .place = places[i].place,
                                               .is_present = i == 0});
    for (size_t i = 0; i < LX_COUNT(conventions); i++)
        if (find_choices(&conventions[i], parameters, choices) < 0)
            return lx_out_of_memory(diagnostics);
    return LUXEL_OK;
}

/* ---- values ---- */

/* Applies assignments with " -s " between them. */
static luxel_status apply(luxel_scene *scene, const char *assignments, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    while (assignments && *assignments && status == LUXEL_OK) {
        const char *end = strstr(assignments, " -s ");
        size_t length = end ? (size_t)(end - assignments) : strlen(assignments);
        char *one = lx_copy_text(assignments, length);
        if (!one)
            return lx_out_of_memory(diagnostics);
        status = luxel_scene_set(scene, one, diagnostics);
        free(one);
        assignments = end ? end + 4 : NULL;
    }
    return status;
}

/* The place that is looked at; false off the screen, where there is no pixel. */
static bool find_place(const struct lx_scene_parameters *scene, enum lx_looked_at place, double *x_mm, double *y_mm)
{
    struct lx_screen screen = scene->screen;
    unsigned column, row;
    if (place == LX_AT_POINT)
        return true;
    if (place == LX_AT_OTHER_PIXEL)
        screen.sampling = screen.sampling == LX_NODES ? LX_CENTERS : LX_NODES;
    if (!lx_pixel_at(&screen, *x_mm, *y_mm, &column, &row))
        return false;
    if (place == LX_AT_FLIPPED)
        row = screen.resolution[1] - 1 - row;
    *x_mm = lx_column_x_mm(&screen, column);
    *y_mm = lx_row_y_mm(&screen, row);
    return true;
}

static luxel_status probe(const struct lx_choices *choices, const luxel_scene *scene, enum lx_looked_at place,
                          luxel_diagnostics *diagnostics, struct lx_choice_value *found)
{
    double x_mm = choices->x_mm, y_mm = choices->y_mm;
    luxel_probe *made = NULL;
    if (!find_place(lx_scene_parameters(scene), place, &x_mm, &y_mm))
        return LUXEL_OK;
    luxel_status status = luxel_probe_screen(scene, &choices->settings, x_mm, y_mm, diagnostics, &made);
    if (status == LUXEL_OK && made->has_value)
        *found = (struct lx_choice_value){true, made->value, made->error};
    luxel_probe_free(made);
    return status;
}

luxel_status lx_choices_value(const struct lx_choices *choices, const size_t *which, size_t count,
                              luxel_diagnostics *diagnostics, struct lx_choice_value *found)
{
    enum lx_looked_at place = LX_AT_POINT;
    luxel_diagnostics *unseen = luxel_diagnostics_new();
    luxel_scene *scene = luxel_scene_copy(choices->scene);
    luxel_status status = scene && unseen ? LUXEL_OK : lx_out_of_memory(diagnostics);
    *found = (struct lx_choice_value){0};
    for (size_t i = 0; status == LUXEL_OK && i < count; i++) {
        const struct lx_choice *choice = &choices->list[which[i]];
        if (choice->is_present)
            continue; /* the scene has it, and what was found of its light stands */
        status = apply(scene, choice->assignment, unseen);
        place = choice->place != LX_AT_POINT ? choice->place : place;
    }
    if (status == LUXEL_OK && !luxel_scene_is_committed(scene))
        status = luxel_scene_commit(scene, unseen);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, unseen);
    bool refused = status == LUXEL_ERROR_SCENE || status == LUXEL_ERROR_PATH;
    if (status == LUXEL_OK)
        status = probe(choices, scene, place, diagnostics, found);
    luxel_scene_free(scene);
    luxel_diagnostics_free(unseen);
    return refused ? LUXEL_OK : status; /* what the scene does not allow has no value */
}

/* ---- the public list ---- */

struct made {
    luxel_alternatives shown; /* first, so that its address is the whole's */
    struct lx_choices choices;
    luxel_alternative list[LX_MOST_CHOICES];
};

void luxel_alternatives_free(luxel_alternatives *alternatives)
{
    struct made *made = (struct made *)alternatives;
    if (!made)
        return;
    lx_choices_clear(&made->choices);
    free(made);
}

luxel_status luxel_find_alternatives(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                                     luxel_diagnostics *diagnostics, luxel_alternatives **alternatives)
{
    struct made *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    luxel_status status = lx_choices_find(scene, settings, x_mm, y_mm, diagnostics, &made->choices);
    size_t count = 0;
    for (size_t i = 0; status == LUXEL_OK && i < made->choices.count; i++) {
        const struct lx_choice *choice = &made->choices.list[i];
        struct lx_choice_value found;
        if (made->choices.has_bounces && !choice->is_bounces)
            continue; /* each would need all reflected light anew */
        luxel_alternative *shown = &made->list[count++];
        *shown = (luxel_alternative){
            .convention = choice->convention,
            .choice = choice->choice,
            .meaning = choice->meaning,
            .assignment = choice->assignment,
            .is_present = choice->is_present,
        };
        status = lx_choices_value(&made->choices, &i, 1, diagnostics, &found);
        shown->has_value = found.has_value;
        shown->value = found.value;
        shown->error = found.error;
    }
    made->shown = (luxel_alternatives){.count = count, .list = made->list};
    if (status == LUXEL_OK)
        *alternatives = &made->shown;
    else
        luxel_alternatives_free(&made->shown);
    return status;
}
