/* SPDX-License-Identifier: MIT */
/* Derivatives of probed values by numbers of the scene, from probes of changed copies of it. */
#include <luxel/derive.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/text.h"
#include "../parameter/words.h"
#include "../scene/path.h"
#include "differences.h"

enum {
    MOST_NUMBERS = 8,  /* that a key takes */
    MOST_ROWS = 40,    /* halved steps */
    MOST_HALVINGS = 50 /* of the first step, until both of its ends are legal */
};

/* A key and the numbers that it has in the scene. */
struct key {
    const char *path, *unit;
    bool is_list;
    size_t count, offset; /* its numbers, and the first of them among those of all keys */
    double numbers[MOST_NUMBERS];
    double step; /* the first step of each */
};

struct luxel_derivatives {
    size_t place_count, key_count, number_count;
    struct key *keys;
    luxel_derivative *list; /* number_count of each place */
};

struct derivation {
    const luxel_scene *scene;
    luxel_settings settings;
    const luxel_place *places;
    luxel_probes *middle;
    luxel_derivatives *made;
    luxel_progress progress;
    void *progress_data;
    size_t done; /* numbers of keys */
    unsigned row;
};

/* ---- keys ---- */

/* How many numbers stand at the end of a path, 0: no continuous ones do. */
static size_t numbers_at(const struct lx_path *path)
{
    const struct lx_parameter *parameter = path->parameter;
    if (!parameter)
        return 0;
    switch (parameter->type) {
    case LX_REAL: return path->depth == 0;
    case LX_REALS: return path->depth == 0 ? parameter->count : 1;
    case LX_POINTS: return path->depth == 1 ? 2 : path->depth == 2;
    case LX_VECTORS: return path->depth == 1 ? 3 : path->depth == 2;
    default: return 0;
    }
}

/* Reads the numbers of a value such as "10" or "[0, 0, 1000]". */
static bool read_numbers(const char *text, struct key *key)
{
    static const char between[] = "[], ";
    size_t read = 0;
    for (text += strspn(text, between); *text && read < key->count; read++) {
        const size_t length = strcspn(text, between);
        if (!lx_read_number(text, length, &key->numbers[read]))
            return false;
        text += length;
        text += strspn(text, between);
    }
    return read == key->count && !*text;
}

/* A twentieth of what the key says, which is halved as need be; of zeros so much as is little in most scenes. */
static double first_step(const struct key *key, enum lx_unit unit)
{
    double square = 0.0;
    for (size_t i = 0; i < key->count; i++)
        square += key->numbers[i] * key->numbers[i];
    return square > 0.0 ? sqrt(square) * 0.05 : unit == LX_UNIT_MM ? 10.0 : unit == LX_UNIT_DEGREES ? 1.0 : 0.05;
}

static luxel_status find_key(const luxel_scene *scene, const char *text, luxel_diagnostics *diagnostics,
                             struct key *key)
{
    const struct lx_place place = {.source = "key", .text = text, .length = strlen(text)};
    struct lx_path path;
    char *value = NULL;
    luxel_status status = lx_follow_path(scene, &place, place.length, diagnostics, &path);
    if (status != LUXEL_OK)
        return status;
    key->path = text;
    key->count = numbers_at(&path);
    if (key->count == 0 || key->count > MOST_NUMBERS) {
        struct lx_text type = {0};
        if (path.parameter)
            lx_add_type(&type, path.parameter);
        else
            lx_text_puts(&type, "{…}");
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_DERIVE_NO_NUMBERS,
                  LX_ARGS(text, LX_WORDS(type.bytes ? type.bytes : "")));
        lx_text_clear(&type);
        return LUXEL_ERROR_PATH;
    }
    key->is_list = key->count > 1 || (path.parameter->type == LX_REALS && path.depth == 0);
    key->unit = lx_unit_word(path.parameter->unit, lx_scene_parameters(scene)->units == LX_PHOTOMETRIC);
    status = luxel_scene_get(scene, text, diagnostics, NULL, &value);
    if (status == LUXEL_OK && (!value || !read_numbers(value, key))) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_DERIVE_NO_VALUE, LX_ARGS(text));
        status = LUXEL_ERROR_PATH;
    }
    luxel_text_free(value);
    key->step = first_step(key, path.parameter->unit);
    return status;
}

static luxel_status find_keys(const luxel_scene *scene, const char *const *keys, luxel_diagnostics *diagnostics,
                              luxel_derivatives *made)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < made->key_count; i++) {
        const luxel_status one = find_key(scene, keys[i], diagnostics, &made->keys[i]);
        if (one != LUXEL_OK && one != LUXEL_ERROR_PATH)
            return one;
        if (one != LUXEL_OK)
            status = one;
        made->keys[i].offset = made->number_count;
        made->number_count += made->keys[i].count;
    }
    return status;
}

/* ---- values ---- */

static bool tell_progress(double share, void *data)
{
    const struct derivation *derivation = data;
    const double of_number = (derivation->row + share) / (derivation->row + 8.0);
    return derivation->progress(((double)derivation->done + of_number) / (double)(derivation->made->number_count + 1),
                                derivation->progress_data);
}

/* Commits a copy of the scene in which one number of a key is larger by `change`. */
static luxel_status change_scene(const struct derivation *derivation, const struct key *key, size_t number,
                                 double change, luxel_diagnostics *diagnostics, luxel_scene **changed)
{
    luxel_scene *scene = luxel_scene_copy(derivation->scene);
    struct lx_text text = {0};
    lx_text_printf(&text, "%s=%s", key->path, key->is_list ? "[" : "");
    for (size_t i = 0; i < key->count; i++) {
        char digits[LX_NUMBER_SIZE];
        lx_write_number(key->numbers[i] + (i == number ? change : 0.0), digits);
        lx_text_printf(&text, "%s%s", i > 0 ? ", " : "", digits);
    }
    lx_text_puts(&text, key->is_list ? "]" : "");
    luxel_status status = scene && !text.failed ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        status = luxel_scene_set(scene, text.bytes, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    lx_text_clear(&text);
    if (status != LUXEL_OK) {
        luxel_scene_free(scene);
        scene = NULL;
    }
    *changed = scene;
    return status;
}

/* Probes all places of the changed scene.  LUXEL_ERROR_SCENE: there is no such scene. */
static luxel_status probe_changed(struct derivation *derivation, const struct key *key, size_t number, double change,
                                  luxel_diagnostics *diagnostics, luxel_probes **probes)
{
    luxel_scene *scene;
    luxel_status status = change_scene(derivation, key, number, change, NULL, &scene);
    *probes = NULL;
    if (status == LUXEL_OK)
        status = luxel_probe_places(scene, &derivation->settings, derivation->places, derivation->made->place_count,
                                    diagnostics, probes);
    luxel_scene_free(scene);
    return status;
}

/* ---- steps ---- */

/* Which steps are legal: the first one, halved until it is, and whether it goes both ways. */
struct steps {
    double first;
    bool is_one_sided;
};

static bool is_legal(const struct derivation *derivation, const struct key *key, size_t number, double change)
{
    luxel_scene *scene;
    const bool good = change_scene(derivation, key, number, change, NULL, &scene) == LUXEL_OK;
    luxel_scene_free(scene);
    return good;
}

/* LUXEL_ERROR_SCENE, reported: no step is. */
static luxel_status find_steps(const struct derivation *derivation, const struct key *key, size_t number,
                               luxel_diagnostics *diagnostics, struct steps *steps)
{
    bool up = false, down = false;
    *steps = (struct steps){.first = key->step};
    for (int i = 0; i < MOST_HALVINGS; i++, steps->first /= 2.0) {
        up = is_legal(derivation, key, number, steps->first);
        down = is_legal(derivation, key, number, -steps->first);
        if (up && down)
            return LUXEL_OK;
        /* a value at the end of what is legal stays there, however small the step */
        if ((up || down) && steps->first < key->step * 0x1p-30)
            break;
    }
    steps->is_one_sided = true;
    for (steps->first = up ? key->step : -key->step; fabs(steps->first) > key->step * 0x1p-30; steps->first /= 2.0)
        if (is_legal(derivation, key, number, steps->first))
            return LUXEL_OK;
    luxel_scene *scene;
    return change_scene(derivation, key, number, key->step, diagnostics, &scene);
}

static void add_step(const luxel_probes *const sides[2], size_t place, double step, struct lx_differences *differences)
{
    double values[2] = {0.0, 0.0}, errors[2] = {0.0, 0.0};
    for (size_t side = 0; side < 2 && sides[side]; side++) {
        const luxel_probe *probe = luxel_probes_get(sides[side], place);
        differences->is_missing = differences->is_missing || !probe->has_value;
        values[side] = probe->value;
        errors[side] = probe->error;
    }
    if (!differences->is_missing)
        lx_differences_add(differences, step, values, errors);
}

/* A step, at all places that are not done; *done: all of them are. */
static luxel_status take_step(struct derivation *derivation, const struct key *key, size_t number, double step,
                              luxel_diagnostics *diagnostics, struct lx_differences *differences, bool *done)
{
    luxel_probes *sides[2] = {NULL, NULL};
    luxel_status status = probe_changed(derivation, key, number, step, diagnostics, &sides[0]);
    if (status == LUXEL_OK && !differences[0].is_one_sided)
        status = probe_changed(derivation, key, number, -step, diagnostics, &sides[1]);
    *done = true;
    for (size_t i = 0; status == LUXEL_OK && i < derivation->made->place_count; i++) {
        if (lx_differences_are_done(&differences[i]))
            continue;
        add_step((const luxel_probes *const *)sides, i, step, &differences[i]);
        *done = *done && lx_differences_are_done(&differences[i]);
    }
    luxel_probes_free(sides[0]);
    luxel_probes_free(sides[1]);
    return status;
}

static luxel_status derive_number(struct derivation *derivation, const struct key *key, size_t number,
                                  luxel_diagnostics *diagnostics, struct lx_differences *differences)
{
    struct steps steps;
    const luxel_derivatives *made = derivation->made;
    bool done = false;
    luxel_status status = find_steps(derivation, key, number, diagnostics, &steps);
    for (size_t i = 0; i < made->place_count; i++) {
        const luxel_probe *probe = luxel_probes_get(derivation->middle, i);
        lx_differences_begin(&differences[i], probe->value, probe->error, steps.is_one_sided);
        differences[i].is_missing = !probe->has_value;
    }
    double step = steps.first;
    for (derivation->row = 0; status == LUXEL_OK && !done && derivation->row < MOST_ROWS; derivation->row++) {
        /* what was stepped to has no rounding of its own */
        const double at = key->numbers[number];
        volatile double end = at + step;
        if (end == at || end - at != step)
            step = end - at;
        if (step == 0.0)
            break;
        status = take_step(derivation, key, number, step, diagnostics, differences, &done);
        step /= 2.0;
    }
    for (size_t i = 0; i < made->place_count; i++)
        made->list[i * made->number_count + key->offset + number] = lx_differences_conclude(&differences[i]);
    return status;
}

static luxel_status derive_all(struct derivation *derivation, luxel_diagnostics *diagnostics)
{
    luxel_derivatives *made = derivation->made;
    struct lx_differences *differences = lx_new_array(made->place_count + 1, sizeof *differences);
    made->list = lx_new_array(made->place_count * made->number_count + 1, sizeof *made->list);
    luxel_status status = differences && made->list ? LUXEL_OK : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = luxel_probe_places(derivation->scene, &derivation->settings, derivation->places, made->place_count,
                                    diagnostics, &derivation->middle);
    for (size_t k = 0; status == LUXEL_OK && k < made->key_count; k++)
        for (size_t i = 0; status == LUXEL_OK && i < made->keys[k].count; i++) {
            status = derive_number(derivation, &made->keys[k], i, diagnostics, differences);
            derivation->done++;
        }
    luxel_probes_free(derivation->middle);
    free(differences);
    return status;
}

luxel_status luxel_derive_places(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                                 size_t count, const char *const *keys, size_t key_count,
                                 luxel_diagnostics *diagnostics, luxel_derivatives **derivatives)
{
    if (!scene || (!places && count > 0) || (!keys && key_count > 0) || !derivatives)
        return LUXEL_ERROR_ARGUMENT;
    *derivatives = NULL;
    if (!luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    struct derivation derivation = {.scene = scene, .places = places};
    if (settings)
        derivation.settings = *settings;
    else
        luxel_settings_init(&derivation.settings);
    derivation.progress = derivation.settings.progress;
    derivation.progress_data = derivation.settings.progress_data;
    if (derivation.progress)
        derivation.settings.progress = tell_progress;
    derivation.settings.progress_data = &derivation;
    derivation.settings.skip_reflected_pixels = true;
    if (derivation.settings.tolerance == 0.0)
        derivation.settings.tolerance = 1e-11;
    luxel_derivatives *made = derivation.made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    made->place_count = count;
    made->key_count = key_count;
    made->keys = lx_new_array(key_count + 1, sizeof *made->keys);
    luxel_status status = made->keys ? find_keys(scene, keys, diagnostics, made) : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = derive_all(&derivation, diagnostics);
    if (status != LUXEL_OK) {
        luxel_derivatives_free(made);
        return status;
    }
    *derivatives = made;
    return LUXEL_OK;
}

size_t luxel_derivatives_numbers(const luxel_derivatives *derivatives, size_t key)
{
    return derivatives && key < derivatives->key_count ? derivatives->keys[key].count : 0;
}

const char *luxel_derivatives_unit(const luxel_derivatives *derivatives, size_t key)
{
    return derivatives && key < derivatives->key_count ? derivatives->keys[key].unit : NULL;
}

const luxel_derivative *luxel_derivatives_get(const luxel_derivatives *derivatives, size_t place, size_t key,
                                              size_t number)
{
    if (place >= (derivatives ? derivatives->place_count : 0) || number >= luxel_derivatives_numbers(derivatives, key))
        return NULL;
    return &derivatives->list[place * derivatives->number_count + derivatives->keys[key].offset + number];
}

const char *luxel_derivative_words(luxel_derivative_state state)
{
    static const char *const words[] = {
        [LUXEL_DERIVATIVE_NO_VALUE] = LX_N("there is no value here, or not beside it"),
        [LUXEL_DERIVATIVE_KINK] = LX_N("the value has a kink here"),
        [LUXEL_DERIVATIVE_ROUGH] = LX_N("the value jumps here, or is not known well enough"),
    };
    return (size_t)state < LX_COUNT(words) ? words[state] : NULL;
}

void luxel_derivatives_free(luxel_derivatives *derivatives)
{
    if (!derivatives)
        return;
    free(derivatives->keys);
    free(derivatives->list);
    free(derivatives);
}
