/* SPDX-License-Identifier: MIT */
/*
 * Several threads at once with one committed scene, one evaluator and one field, each doing everything that these
 * allow, in an order of its own: pictures, grids, probes, lines and copies have the bytes that they have alone.
 * `make check-threads` watches every access to memory meanwhile.
 */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "scenes.h"

enum { THREADS = 6, LEVELS = 1 };

static const double place[] = {40, -30};
static const luxel_profile_path path = {.to_mm = {120, 80}, .samples = 20};

/* What all threads use, and what each piece of work gave when it was done alone. */
struct shared {
    luxel_scene *scene;
    luxel_field *field;
    luxel_field *changed_field; /* of a copy with one light less */
    luxel_evaluator *evaluator;
    luxel_grid *grid; /* NULL: the scene has none */
    luxel_extrema extrema;
    luxel_isophotes *isophotes;
    luxel_profile *profile;
    luxel_probe *probe;
    luxel_value value;
    double levels[LEVELS];
    char *text;
};

struct worker {
    const struct shared *shared;
    unsigned index;
    const char *failure; /* what went wrong, NULL: nothing; asserts are for the main thread */
    pthread_t thread;
};

static luxel_settings settings_with(unsigned threads)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = threads;
    settings.tolerance = 1e-6;
    return settings;
}

static size_t size_of(const luxel_field *field)
{
    return (size_t)luxel_field_columns(field) * luxel_field_rows(field);
}

static bool same_field(const luxel_field *one, const luxel_field *other)
{
    return size_of(one) == size_of(other) &&
           memcmp(luxel_field_single(one), luxel_field_single(other), size_of(one) * sizeof(float)) == 0 &&
           memcmp(luxel_field_mask(one), luxel_field_mask(other), size_of(one)) == 0;
}

/* ---- pieces of work; each says whether it gave what it gives alone ---- */

static bool render(const struct shared *shared, unsigned threads)
{
    luxel_settings settings = settings_with(threads);
    luxel_field *field;
    if (luxel_render(shared->scene, &settings, NULL, &field) != LUXEL_OK)
        return false;
    bool same = same_field(field, shared->field);
    luxel_field_free(field);
    return same;
}

/* Progress that is asked for once, and ends the work. */
static bool stop(double done, void *asked)
{
    ++*(unsigned *)asked;
    return done < 0;
}

static bool cancel(const struct shared *shared, unsigned threads)
{
    luxel_settings settings = settings_with(threads);
    unsigned asked = 0;
    luxel_field *field = NULL;
    luxel_grid *grid = NULL;
    settings.progress = stop;
    settings.progress_data = &asked;
    bool cancelled = luxel_render(shared->scene, &settings, NULL, &field) == LUXEL_CANCELLED;
    if (shared->grid)
        cancelled = cancelled && luxel_find_grid(shared->scene, &settings, 0, NULL, &grid) == LUXEL_CANCELLED;
    return cancelled && !field && !grid && asked == (shared->grid ? 2 : 1);
}

static bool measure(const struct shared *shared, unsigned threads)
{
    luxel_settings settings = settings_with(threads);
    luxel_grid *grid;
    if (!shared->grid)
        return true;
    if (luxel_find_grid(shared->scene, &settings, 0, NULL, &grid) != LUXEL_OK)
        return false;
    size_t bytes = (size_t)grid->columns * grid->rows * sizeof *grid->values;
    bool same = memcmp(grid->values, shared->grid->values, bytes) == 0 &&
                memcmp(grid->errors, shared->grid->errors, bytes) == 0;
    luxel_grid_free(grid);
    return same;
}

static bool probe(const struct shared *shared, unsigned threads)
{
    luxel_settings settings = settings_with(threads);
    luxel_probe *found;
    if (luxel_probe_screen(shared->scene, &settings, place[0], place[1], NULL, &found) != LUXEL_OK)
        return false;
    bool same = found->value == shared->probe->value && found->error == shared->probe->error &&
                found->share_count == shared->probe->share_count;
    luxel_probe_free(found);
    return same;
}

static bool evaluate(const struct shared *shared, unsigned threads)
{
    (void)threads;
    luxel_value value;
    luxel_evaluate_screen(shared->evaluator, place[0], place[1], &value, NULL);
    return value.value == shared->value.value && value.error == shared->value.error;
}

static bool find_extrema(const struct shared *shared, unsigned threads)
{
    luxel_extrema extrema;
    (void)threads;
    return luxel_find_extrema(shared->evaluator, shared->field, NULL, NULL, &extrema) == LUXEL_OK &&
           extrema.maximum.value == shared->extrema.maximum.value &&
           extrema.maximum.x_mm == shared->extrema.maximum.x_mm &&
           extrema.minimum.value == shared->extrema.minimum.value;
}

static bool find_isophotes(const struct shared *shared, unsigned threads)
{
    luxel_isophotes *isophotes;
    (void)threads;
    if (luxel_find_isophotes(shared->field, shared->evaluator, shared->levels, LEVELS, NULL, &isophotes) != LUXEL_OK)
        return false;
    bool same = isophotes->count == shared->isophotes->count;
    for (size_t i = 0; same && i < isophotes->count; i++) {
        const luxel_isophote *line = &isophotes->lines[i], *expected = &shared->isophotes->lines[i];
        same = line->count == expected->count &&
               memcmp(line->x_mm, expected->x_mm, line->count * sizeof *line->x_mm) == 0 &&
               memcmp(line->y_mm, expected->y_mm, line->count * sizeof *line->y_mm) == 0;
    }
    luxel_isophotes_free(isophotes);
    return same;
}

static bool find_profile(const struct shared *shared, unsigned threads)
{
    luxel_profile *profile;
    (void)threads;
    if (luxel_find_profile(shared->evaluator, &path, NULL, &profile) != LUXEL_OK)
        return false;
    bool same =
        memcmp(profile->shares, shared->profile->shares, profile->count * profile->lights * sizeof(double)) == 0;
    for (size_t i = 0; same && i < profile->count; i++)
        same = profile->samples[i].value == shared->profile->samples[i].value;
    luxel_profile_free(profile);
    return same;
}

static bool write(const struct shared *shared, unsigned threads)
{
    luxel_diagnostics *advice = luxel_diagnostics_new();
    char *text;
    (void)threads;
    bool same = luxel_scene_write_text(shared->scene, &text) == LUXEL_OK && strcmp(text, shared->text) == 0 &&
                luxel_scene_advise(shared->scene, advice) == LUXEL_OK;
    luxel_text_free(text);
    luxel_diagnostics_free(advice);
    return same;
}

/* A copy is independent, but shares what was read: its text and its files. */
static luxel_field *render_changed_copy(const luxel_scene *scene, unsigned threads)
{
    luxel_settings settings = settings_with(threads);
    luxel_scene *copy = luxel_scene_copy(scene);
    luxel_field *field = NULL;
    if (luxel_scene_set(copy, "lights[0].enabled=false", NULL) == LUXEL_OK &&
        luxel_scene_commit(copy, NULL) == LUXEL_OK)
        luxel_render(copy, &settings, NULL, &field);
    luxel_scene_free(copy);
    return field;
}

static bool change_copy(const struct shared *shared, unsigned threads)
{
    luxel_field *field = render_changed_copy(shared->scene, threads);
    bool same = field && same_field(field, shared->changed_field);
    luxel_field_free(field);
    return same;
}

static const struct {
    const char *name;
    bool (*work)(const struct shared *shared, unsigned threads);
} works[] = {{"render", render},
             {"cancel", cancel},
             {"measure", measure},
             {"probe", probe},
             {"evaluate", evaluate},
             {"find extrema", find_extrema},
             {"find isophotes", find_isophotes},
             {"find profile", find_profile},
             {"write", write},
             {"change a copy", change_copy}};
enum { WORKS = sizeof works / sizeof works[0] };

/* ---- alone, then all at once ---- */

static void do_alone(struct shared *shared)
{
    luxel_settings settings = settings_with(1);
    const luxel_scene *scene = shared->scene;
    assert_int_equal(luxel_render(scene, &settings, NULL, &shared->field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &shared->evaluator), LUXEL_OK);
    assert_int_equal(luxel_probe_screen(scene, &settings, place[0], place[1], NULL, &shared->probe), LUXEL_OK);
    assert_true(shared->probe->has_value);
    luxel_evaluate_screen(shared->evaluator, place[0], place[1], &shared->value, NULL);
    if (luxel_scene_grid_count(scene) > 0)
        assert_int_equal(luxel_find_grid(scene, &settings, 0, NULL, &shared->grid), LUXEL_OK);
    assert_int_equal(luxel_find_extrema(shared->evaluator, shared->field, NULL, NULL, &shared->extrema), LUXEL_OK);
    for (int i = 0; i < LEVELS; i++)
        shared->levels[i] = shared->extrema.maximum.value * (i + 1) / (LEVELS + 1);
    assert_int_equal(
        luxel_find_isophotes(shared->field, shared->evaluator, shared->levels, LEVELS, NULL, &shared->isophotes),
        LUXEL_OK);
    assert_true(shared->isophotes->count > 0);
    assert_int_equal(luxel_find_profile(shared->evaluator, &path, NULL, &shared->profile), LUXEL_OK);
    assert_int_equal(luxel_scene_write_text(scene, &shared->text), LUXEL_OK);
    shared->changed_field = render_changed_copy(scene, 1);
    assert_non_null(shared->changed_field);
    assert_false(same_field(shared->changed_field, shared->field));
}

static void clear(struct shared *shared)
{
    luxel_text_free(shared->text);
    luxel_profile_free(shared->profile);
    luxel_isophotes_free(shared->isophotes);
    luxel_grid_free(shared->grid);
    luxel_probe_free(shared->probe);
    luxel_evaluator_free(shared->evaluator);
    luxel_field_free(shared->changed_field);
    luxel_field_free(shared->field);
    luxel_scene_free(shared->scene);
}

static void *run(void *argument)
{
    struct worker *worker = argument;
    for (unsigned i = 0; !worker->failure && i < WORKS; i++) {
        unsigned which = (i * 3 + worker->index * 7) % WORKS; /* 3 and WORKS have no common divisor */
        if (!works[which].work(worker->shared, 1 + (i + worker->index) % 3))
            worker->failure = works[which].name;
    }
    return NULL;
}

static void all_at_once(const char *name, const char *const *assignments)
{
    struct shared shared = {.scene = builtin(name)};
    struct worker workers[THREADS];
    for (; *assignments; assignments++)
        assert_int_equal(luxel_scene_set(shared.scene, *assignments, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(shared.scene, NULL), LUXEL_OK);
    do_alone(&shared);
    for (unsigned i = 0; i < THREADS; i++) {
        workers[i] = (struct worker){.shared = &shared, .index = i};
        assert_int_equal(pthread_create(&workers[i].thread, NULL, run, &workers[i]), 0);
    }
    for (unsigned i = 0; i < THREADS; i++)
        pthread_join(workers[i].thread, NULL);
    for (unsigned i = 0; i < THREADS; i++)
        if (workers[i].failure)
            fail_msg("%s, thread %u: %s", name, i, workers[i].failure);
    clear(&shared);
}

static void test_every_source(void **state)
{
    (void)state;
    all_at_once("all-sources", (const char *const[]){"screen.resolution=[10, 10]", NULL});
}

static void test_grid_and_shadow(void **state)
{
    (void)state;
    all_at_once("desk", (const char *const[]){"screen.resolution=[40, 32]", NULL});
}

/* ---- separate scenes ---- */

static void *run_builtin(void *argument)
{
    struct worker *worker = argument;
    const char *name = luxel_builtin_scene_name(worker->index % luxel_builtin_scene_count());
    luxel_settings settings = settings_with(2);
    luxel_scene *scene;
    luxel_field *fields[2] = {NULL, NULL};
    worker->failure = name;
    if (luxel_scene_open_builtin(name, NULL, &scene) != LUXEL_OK)
        return NULL;
    if (luxel_scene_set(scene, "screen={width: 800, height: 800, resolution: [12, 12]}", NULL) == LUXEL_OK &&
        luxel_scene_commit(scene, NULL) == LUXEL_OK && luxel_render(scene, &settings, NULL, &fields[0]) == LUXEL_OK &&
        luxel_render(scene, &settings, NULL, &fields[1]) == LUXEL_OK && same_field(fields[0], fields[1]))
        worker->failure = NULL;
    for (int i = 0; i < 2; i++)
        luxel_field_free(fields[i]);
    luxel_scene_free(scene);
    return NULL;
}

static void test_separate_scenes(void **state)
{
    (void)state;
    struct worker workers[14];
    for (unsigned i = 0; i < 14; i++) {
        workers[i] = (struct worker){.index = i};
        assert_int_equal(pthread_create(&workers[i].thread, NULL, run_builtin, &workers[i]), 0);
    }
    for (unsigned i = 0; i < 14; i++)
        pthread_join(workers[i].thread, NULL);
    for (unsigned i = 0; i < 14; i++)
        if (workers[i].failure)
            fail_msg("%s", workers[i].failure);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_source),
        cmocka_unit_test(test_grid_and_shadow),
        cmocka_unit_test(test_separate_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
