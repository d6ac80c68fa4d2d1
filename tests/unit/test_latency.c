/* SPDX-License-Identifier: MIT */
/*
 * How soon work ends that is to stop, counted in questions whether to go on, not in seconds: each phase asks often, and
 * once it was told to stop hardly asks again.  And what is made once for all pictures of a scene that differ in other
 * things: trees of clouds, and what was read of files.
 */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../../src/api/session.h"
#include "../../src/format/cloud.h"
#include "../../src/light/solid/facets.h"
#include "../../src/world/integral/cubature.h"
#include "scenes.h"
#include "wrapped.h"

/* What was asked; only one thread may ask while it is looked at. */
static struct {
    size_t asked;   /* how often since begin() */
    size_t stop_at; /* this question, and all after it, is answered by no; 0: none */
} counted;

WRAPPED(bool, lx_control_goes_on, struct lx_control *control, bool is_caller)
{
    static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&mutex);
    if (++counted.asked == counted.stop_at)
        atomic_store(&control->stop, true);
    pthread_mutex_unlock(&mutex);
    return REAL(lx_control_goes_on)(control, is_caller);
}

static void begin(size_t stop_at)
{
    counted.asked = 0;
    counted.stop_at = stop_at;
}

static const char form[] =
    "luxel: 1\n"
    "screen: {width: 800, height: 800, resolution: [24, 24]}\n"
    "observer: {z: 2500, view: observer}\n"
    "surfaces:\n"
    "  - {type: sphere, center: [0, 0, 1000], radius: 300, material: {diffuse: 0.6, specular: 0.4,\n"
    "     model: blinn-phong, shininess: 300}}\n"
    "lights:\n";

static luxel_scene *scene_with(const char *lights)
{
    char text[2048];
    luxel_scene *scene;
    snprintf(text, sizeof text, "%s%s", form, lights);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    return scene;
}

static void set(luxel_scene *scene, const char *assignment)
{
    assert_int_equal(luxel_scene_set(scene, assignment, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
}

/* A cloud of so many rows on a few lamps. */
static void write_cloud(const char *path, int rows)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 0; i < rows; i++)
        fprintf(file, "%.9g,%.9g,%.9g,%.9g\n", 1500 * cos(i % 7) + 40 * sin(i * 0.7),
                1500 * sin(i % 7) + 40 * cos(i * 0.3), 1800 + 40 * sin(i * 1.1), 1.0 + i % 3);
    fclose(file);
}

static void make_cloud(int rows, char path[40])
{
    strcpy(path, "/tmp/luxel-latency-XXXXXX");
    int descriptor = mkstemp(path);
    assert_true(descriptor >= 0);
    close(descriptor);
    write_cloud(path, rows);
}

static luxel_scene *scene_of_cloud(const char *path, const char *keys)
{
    char light[256];
    snprintf(light, sizeof light, "  - {type: points, file: %s%s}\n", path, keys);
    return scene_with(light);
}

static luxel_settings settings_with(double light_error, unsigned threads)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.light_error = light_error;
    settings.threads = threads;
    return settings;
}

static void asks_while_facets_are_made(void **state)
{
    (void)state;
    struct lx_control control = {.rows = 1};
    const struct lx_asking asking = {.control = &control, .is_caller = true};
    const double center[3] = {0, 0, 0}, axis[3] = {0, 0, 1};
    enum { MERIDIANS = 100, FACES = MERIDIANS * MERIDIANS / 2 };
    begin(0);
    struct lx_facets *ball = lx_facets_make_sphere(center, 10, MERIDIANS, &asking);
    assert_non_null(ball);
    assert_int_equal(ball->face_count, FACES);
    assert_true(counted.asked > 10 * FACES / 64);

    /* An area light of it, for the pictures of a surface. */
    const struct lx_emitter emitter = {.type = LX_FACETS, .facets = ball};
    const struct lx_shape lit = {.radius_mm = 100};
    struct lx_area_light lamp;
    begin(0);
    assert_int_equal(lx_area_light_make(&emitter, &lit, &asking, &lamp), LUXEL_OK);
    assert_true(counted.asked > (ball->face_count + ball->edge_count) / 128);
    size_t patches = 0;
    for (size_t i = 0; i < ball->face_count; i++)
        patches += (ball->faces[i].count - 1) / 2;
    assert_int_equal(lx_patch_limit(&lamp), patches);
    lx_area_light_clear(&lamp);
    begin(1);
    assert_int_equal(lx_area_light_make(&emitter, &lit, &asking, &lamp), LUXEL_CANCELLED);
    lx_area_light_clear(&lamp);
    lx_facets_free(ball);

    /* To stop at any question is the end of it. */
    control.stop = false;
    begin(0);
    lx_facets_free(lx_facets_make_sphere(center, 10, MERIDIANS, &asking));
    const size_t all = counted.asked;
    for (size_t at = 1; at <= all; at += 1 + at / 8) {
        control.stop = false;
        begin(at);
        assert_null(lx_facets_make_sphere(center, 10, MERIDIANS, &asking));
        assert_int_equal(counted.asked, at);
    }
    control.stop = false;
    begin(1);
    assert_null(lx_facets_make_cylinder(center, 10, 10, axis, 1000, &asking));
    assert_int_equal(counted.asked, 1);
}

static void asks_while_parts_are_cut(void **state)
{
    (void)state;
    enum { SIDE = 100, PARTS = SIDE * SIDE };
    static const char *const lights[] = {
        "  - {type: planar, rectangle: {center: [0, 0, 2000], size: [300, 200]}, radiance: 3, parts: 100}\n",
        "  - {type: planar, disk: {center: [0, 0, 2000], radius: 200}, radiance: 3, parts: 100}\n",
    };
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
        luxel_scene *scene = scene_with(lights[i]);
        struct lx_control control = {.rows = 1};
        const struct lx_asking asking = {.control = &control, .is_caller = true};
        struct lx_prepared prepared;
        begin(0);
        assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, &asking, &prepared), 0);
        assert_int_equal(prepared.emitters.count, PARTS);
        assert_null(prepared.emitters.asking); /* it would outlive the one who asks */
        lx_prepared_clear(&prepared);
        const size_t all = counted.asked;
        assert_true(all > PARTS / 128);
        for (size_t at = 1; at <= all; at += 1 + at / 4) {
            control.stop = false;
            begin(at);
            assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, &asking, &prepared), -1);
            assert_false(prepared.emitters.is_short);
            assert_int_equal(counted.asked, at);
            lx_prepared_clear(&prepared);
        }
        luxel_scene_free(scene);
    }
}

/* Told to stop at any question, a rendering is cancelled and asks hardly again: how often at most. */
static size_t count_after(const luxel_scene *scene, const luxel_settings *settings, size_t *all)
{
    size_t most = 0;
    luxel_field *field = NULL;
    begin(0);
    assert_int_equal(luxel_render(scene, settings, NULL, &field), LUXEL_OK);
    luxel_field_free(field);
    *all = counted.asked;
    /* The last question of all is whether there are rows left. */
    for (size_t at = 1; at < *all; at += 1 + at / 6) {
        begin(at);
        field = NULL;
        assert_int_equal(luxel_render(scene, settings, NULL, &field), LUXEL_CANCELLED);
        assert_null(field);
        assert_true(counted.asked >= at);
        most = counted.asked - at > most ? counted.asked - at : most;
    }
    return most;
}

#define PLATE "  - {type: planar, rectangle: {center: [0, 0, 2000], size: [300, 200]}, radiance: 3, parts: "

static void stops_at_any_question(void **state)
{
    (void)state;
    static const char fine[] = "screen={width: 10, height: 10, resolution: [128, 128]}"; /* shaded by panels */
    static const struct {
        const char *lights, *change;
        double light_error;
        size_t least; /* questions */
    } cases[] = {
        {PLATE "70}\n", NULL, 0, 500},
        {PLATE "70}\n", NULL, 0.01, 300},
        {PLATE "30}\n", NULL, 0.01, 200},
        {PLATE "60}\n", fine, 0, 650},
        {PLATE "90}\n", fine, 0, 2000},
        {"  - {type: volume, sphere: {center: [700, 600, 2000], radius: 150, facets: 40}, power: 250}\n", NULL, 0,
         1000},
        {"  - {type: volume, cylinder: {center: [0, 330, 1100], radius: 13, height: 900, axis: [1, 0, 0]},\n"
         "     power: 250, attenuation: none}\n",
         NULL, 0, 1000},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        luxel_scene *scene = scene_with(cases[i].lights);
        const luxel_settings settings = settings_with(cases[i].light_error, 1);
        if (cases[i].change)
            set(scene, cases[i].change);
        size_t all, after = count_after(scene, &settings, &all);
        if (all < cases[i].least || after > 8)
            print_message("# case %zu: %zu questions, %zu after the stop\n", i, all, after);
        assert_true(all >= cases[i].least);
        assert_true(after <= 8);
        luxel_scene_free(scene);
    }
}

static void integrals_end_when_told_to(void **state)
{
    (void)state;
    struct lx_control control = {.rows = 1};
    const struct lx_asking asking = {.control = &control, .is_caller = true};
    struct lx_facets *facets = lx_facets_of_box((double[]){0, 0, 1000}, (double[]){600, 400, 200});
    assert_non_null(facets);
    const struct lx_emitter box = {.type = LX_FACETS, .radiance = lx_exact(3), .facets = facets};
    const struct lx_lobe lobe = {
        .model = LX_BLINN_PHONG, .diffuse = lx_exact(0.5), .specular = lx_exact(0.5), .exponent = 300};
    const struct lx_element element = {.place_mm = lx_exact3((double[]){10, 20, 0}),
                                       .normal = lx_exact3((double[]){0, 0, 1}),
                                       .view = lx_exact3((double[]){0.6, 0, 0.8}),
                                       .lobe = &lobe};
    begin(0);
    const struct lx_cubature whole = lx_integrate(&box, &element, NULL, false, 0, 1e-9, &asking);
    const struct lx_cubature alone = lx_integrate(&box, &element, NULL, false, 0, 1e-9, NULL);
    assert_true(whole.specular.value == alone.specular.value && whole.parts == alone.parts);
    assert_true(counted.asked > whole.parts / 100);
    begin(3);
    const struct lx_cubature stopped = lx_integrate(&box, &element, NULL, false, 0, 1e-9, &asking);
    assert_true(stopped.parts < whole.parts / 10);
    lx_facets_free(facets);
}

static void precision_is_not_chosen_to_the_end(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    static double bounds[COUNT];
    struct lx_rounding_sum rounding = {0};
    struct lx_control control = {.rows = 1};
    const struct lx_asking asking = {.control = &control, .is_caller = true};
    for (int i = 0; i < COUNT; i++)
        bounds[i] = 1e-15;
    begin(2);
    assert_int_equal(lx_choose_precision(bounds, COUNT, 1, &asking, &rounding), 2 * 4096 - 1);
    begin(0);
    control.stop = false;
    assert_int_equal(lx_choose_precision(bounds, COUNT, 1, &asking, &rounding), COUNT - (2 * 4096 - 1));
}

/* ---- what is kept ---- */

static const struct lx_built_tree *tree_of(const luxel_scene *scene)
{
    const luxel_settings settings = settings_with(0.01, 1);
    struct lx_session session;
    assert_int_equal(lx_session_open(scene, &settings, NULL, &session), LUXEL_OK);
    assert_int_equal(session.plan.trees.tree_count, 1);
    const struct lx_built_tree *built = session.plan.trees.trees[0].built;
    assert_int_equal(session.plan.trees.trees[0].leaf_count, built->leaf_count);
    lx_session_clear(&session);
    return built;
}

static void expect_same(const luxel_field *one, const luxel_field *other)
{
    const size_t count = (size_t)luxel_field_columns(one) * luxel_field_rows(one);
    assert_int_equal(count, (size_t)luxel_field_columns(other) * luxel_field_rows(other));
    assert_memory_equal(luxel_field_single(one), luxel_field_single(other), count * sizeof(float));
}

/* The picture of a scene is that of one that has nothing kept. */
static void expect_as_new(const luxel_scene *scene)
{
    const luxel_settings settings = settings_with(0.01, 1);
    luxel_scene *fresh;
    luxel_field *one = NULL, *other = NULL;
    char *text;
    assert_int_equal(luxel_scene_write_text(scene, &text), LUXEL_OK);
    assert_int_equal(load(text, NULL, &fresh), LUXEL_OK);
    assert_int_equal(luxel_render(scene, &settings, NULL, &one), LUXEL_OK);
    assert_int_equal(luxel_render(fresh, &settings, NULL, &other), LUXEL_OK);
    expect_same(one, other);
    luxel_text_free(text);
    luxel_scene_free(fresh);
    luxel_field_free(one);
    luxel_field_free(other);
}

static void trees_are_planted_once(void **state)
{
    (void)state;
    char path[40];
    make_cloud(LX_LEAST_KEPT, path);
    luxel_scene *scene = scene_of_cloud(path, ", pattern: cosine, exponent: 2, axis: [0, 0, -1]");
    begin(0);
    const struct lx_built_tree *first = tree_of(scene);
    const size_t planted = counted.asked;
    begin(0);
    assert_ptr_equal(tree_of(scene), first);
    assert_true(counted.asked + 5 * LX_LEAST_KEPT / 256 < planted);
    luxel_scene *copy = luxel_scene_copy(scene);
    assert_ptr_equal(tree_of(copy), first);
    expect_as_new(copy);
    luxel_scene_free(copy);

    /* Another law or exponent needs no other tree, but other axes do. */
    lx_kept_hold((struct lx_kept *)&((struct lx_built_tree *)first)->kept); /* so that no other gets its place */
    copy = luxel_scene_copy(scene);
    struct lx_session session;
    const luxel_settings settings = settings_with(0.01, 1);
    assert_int_equal(lx_session_open(copy, &settings, NULL, &session), LUXEL_OK);
    struct lx_point_set *set = &session.prepared.emitters.point_sets[0];
    struct lx_control control = {.rows = 1};
    struct lx_light_trees trees = {0};
    set->model.attenuation = LX_NO_ATTENUATION;
    set->model.profile.exponent = 3;
    assert_int_equal(lx_light_trees_build(&session.prepared.emitters, &control, &trees), LUXEL_OK);
    assert_ptr_equal(trees.trees[0].built, first);
    assert_true(trees.trees[0].model.profile.exponent == 3);
    lx_light_trees_clear(&trees);
    set->is_aimed = true;
    assert_int_equal(lx_light_trees_build(&session.prepared.emitters, &control, &trees), LUXEL_OK);
    assert_ptr_not_equal(trees.trees[0].built, first);
    const struct lx_built_tree *by_aim = trees.trees[0].built;
    lx_light_trees_clear(&trees);
    assert_int_equal(lx_light_trees_build(&session.prepared.emitters, &control, &trees), LUXEL_OK);
    assert_ptr_equal(trees.trees[0].built, by_aim);
    lx_light_trees_clear(&trees);
    set->aim_mm[1] = 7;
    lx_kept_hold((struct lx_kept *)&((struct lx_built_tree *)by_aim)->kept);
    assert_int_equal(lx_light_trees_build(&session.prepared.emitters, &control, &trees), LUXEL_OK);
    assert_ptr_not_equal(trees.trees[0].built, by_aim);
    lx_light_trees_clear(&trees);
    set->is_aimed = false;
    set->model.profile.axis = lx_exact3((double[]){1, 0, 0});
    assert_int_equal(lx_light_trees_build(&session.prepared.emitters, &control, &trees), LUXEL_OK);
    assert_ptr_not_equal(trees.trees[0].built, first);
    lx_light_trees_clear(&trees);
    lx_session_clear(&session);
    lx_kept_release((struct lx_kept *)&((struct lx_built_tree *)first)->kept);
    lx_kept_release((struct lx_kept *)&((struct lx_built_tree *)by_aim)->kept);
    luxel_scene_free(copy);
    luxel_scene_free(scene);
    unlink(path);
}

/* A file that has only just been written is read again whatever it looks like. */
static void changed_files_are_read_again(void **state)
{
    (void)state;
    char path[40];
    make_cloud(5000, path);
    luxel_scene *scene = scene_of_cloud(path, "");
    expect_as_new(scene);
    write_cloud(path, 4500);
    set(scene, "surfaces[0].material.diffuse=0.5");
    expect_as_new(scene);
    luxel_scene_free(scene);
    unlink(path);
}

/* Two large clouds have a tree each, small ones and other points of their kind one together. */
static void clouds_have_trees_of_their_own(void **state)
{
    (void)state;
    char large[40], small[40], light[512];
    make_cloud(LX_LEAST_KEPT, large);
    make_cloud(300, small);
    snprintf(light, sizeof light,
             "  - {type: points, file: %s}\n  - {type: points, file: %s}\n  - {type: points, file: %s}\n"
             "  - {type: point, position: [0, 700, 2000], intensity: 300}\n",
             small, large, large);
    luxel_scene *scene = scene_with(light);
    luxel_settings settings = settings_with(1e-6, 1);
    struct lx_session session;
    assert_int_equal(lx_session_open(scene, &settings, NULL, &session), LUXEL_OK);
    assert_int_equal(session.plan.trees.tree_count, 3);
    assert_int_equal(session.plan.trees.trees[0].built->point_count, 301);
    assert_ptr_equal(session.plan.trees.trees[1].built, session.plan.trees.trees[2].built);
    assert_int_equal(session.plan.trees.trees[1].first, 300);
    assert_int_equal(session.plan.trees.trees[2].first, 300 + LX_LEAST_KEPT);
    lx_session_clear(&session);
    luxel_field *clustered = NULL, *summed = NULL;
    assert_int_equal(luxel_render(scene, &settings, NULL, &clustered), LUXEL_OK);
    settings.light_error = 0;
    assert_int_equal(luxel_render(scene, &settings, NULL, &summed), LUXEL_OK);
    const double maximum = luxel_field_statistics(summed)->maximum.value;
    for (unsigned row = 0; row < 24; row++)
        for (unsigned column = 0; column < 24; column++)
            assert_true(fabs(luxel_field_value(clustered, column, row) - luxel_field_value(summed, column, row)) <=
                        5e-6 * maximum);
    assert_true(maximum > 0);
    luxel_field_free(clustered);
    luxel_field_free(summed);
    luxel_scene_free(scene);
    unlink(large);
    unlink(small);
}

struct sharing {
    const luxel_scene *scene;
    luxel_field *field;
    pthread_t thread;
};

static void *render_shared(void *data)
{
    struct sharing *sharing = data;
    const luxel_settings settings = settings_with(0.01, 2);
    if (luxel_render(sharing->scene, &settings, NULL, &sharing->field) != LUXEL_OK)
        sharing->field = NULL;
    return NULL;
}

static void threads_share_what_is_kept(void **state)
{
    (void)state;
    enum { THREADS = 6 };
    char path[40];
    make_cloud(6000, path);
    luxel_scene *scene = scene_of_cloud(path, ", pattern: cosine, exponent: 1, aim: [0, 0, 1000]");
    struct sharing sharing[THREADS];
    begin(0);
    for (int i = 0; i < THREADS; i++) {
        sharing[i] = (struct sharing){.scene = scene};
        assert_int_equal(pthread_create(&sharing[i].thread, NULL, render_shared, &sharing[i]), 0);
    }
    for (int i = 0; i < THREADS; i++)
        pthread_join(sharing[i].thread, NULL);
    for (int i = 0; i < THREADS; i++) {
        assert_non_null(sharing[i].field);
        expect_same(sharing[i].field, sharing[0].field);
    }
    for (int i = 0; i < THREADS; i++)
        luxel_field_free(sharing[i].field);
    expect_as_new(scene);
    luxel_scene_free(scene);
    unlink(path);
}

static void count_free(struct lx_kept *kept)
{
    free(kept);
}

static struct lx_kept *new_kept(void)
{
    struct lx_kept *kept = malloc(sizeof *kept);
    assert_non_null(kept);
    lx_kept_init(kept, count_free);
    return kept;
}

static void files_that_stay_are_kept(void **state)
{
    (void)state;
    const char *source = getenv("LUXEL_OLD_FILE");
    assert_non_null(source);
    char path[40];
    make_cloud(10, path);
    const struct lx_file_state old = lx_file_state_of(source);
    assert_true(old.is_known && old.size > 0);
    assert_false(lx_file_state_of(path).is_known);
    assert_false(lx_file_state_of("/tmp").is_known);
    assert_false(lx_file_state_of("/tmp/luxel-there-is-no-such-file").is_known);
    /* Nothing changed; then each thing that tells a change; then what is not known, or new. */
    enum { CHANGES = 8 };
    struct lx_kept_files files = {0};
    for (int i = 0; i < CHANGES + 2; i++) {
        struct lx_kept *kept = new_kept();
        assert_int_equal(lx_kept_add(&files, i <= CHANGES ? source : path, kept), 0);
        lx_kept_release(kept);
        files.items[i].state = old;
    }
    files.items[1].state.device++;
    files.items[2].state.inode++;
    files.items[3].state.size--;
    files.items[4].state.modified_s--;
    files.items[5].state.modified_ns++;
    files.items[6].state.changed_s--;
    files.items[7].state.changed_ns++;
    files.items[8].state.is_known = false;
    struct lx_kept *same = files.items[0].kept;
    lx_kept_refresh(&files);
    assert_int_equal(files.count, 1);
    assert_ptr_equal(files.items[0].kept, same);

    /* Copies know as much; what nobody asks for goes. */
    struct lx_kept_files copy = {0};
    assert_int_equal(lx_kept_copy(&files, &copy), 0);
    lx_kept_refresh(&copy);
    assert_int_equal(copy.count, 1);
    assert_ptr_equal(lx_kept_find(&copy, source, count_free), same);
    lx_kept_drop_unused(&copy);
    assert_int_equal(copy.count, 1);
    lx_kept_refresh(&copy);
    lx_kept_drop_unused(&copy);
    assert_int_equal(copy.count, 0);
    lx_kept_clear(&files);
    lx_kept_clear(&copy);
    unlink(path);
}

static void bodies_of_meshes_are_made_once(void **state)
{
    (void)state;
    const char *mesh = getenv("LUXEL_OLD_FILE");
    char light[512];
    assert_non_null(mesh);
    snprintf(light, sizeof light, "  - {type: volume, mesh: '%s', radiance: 3}\n", mesh);
    luxel_scene *scene = scene_with(light);
    struct lx_prepared one, other;
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &one), 0);
    set(scene, "surfaces[0].material.diffuse=0.25");
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &other), 0);
    assert_int_equal(one.emitters.items[0].type, LX_FACETS);
    assert_ptr_equal(one.emitters.items[0].facets, other.emitters.items[0].facets);
    luxel_scene_free(scene);
    assert_true(other.emitters.items[0].facets->face_count > 3);
    lx_prepared_clear(&one);
    lx_prepared_clear(&other);
}

/* Parts in a point set shine like parts one by one: a rectangle of 64 x 64, or its quarters of 32 x 32. */
static void parts_in_a_swarm_shine_the_same(void **state)
{
    (void)state;
    luxel_scene *set =
        scene_with("  - {type: planar, rectangle: {center: [0, 0, 2000], size: [400, 320]}, radiance: 3, parts: 64}\n");
    luxel_scene *quarters = scene_with(
        "  - {type: planar, rectangle: {center: [-100, -80, 2000], size: [200, 160]}, radiance: 3, parts: 32}\n"
        "  - {type: planar, rectangle: {center: [100, -80, 2000], size: [200, 160]}, radiance: 3, parts: 32}\n"
        "  - {type: planar, rectangle: {center: [-100, 80, 2000], size: [200, 160]}, radiance: 3, parts: 32}\n"
        "  - {type: planar, rectangle: {center: [100, 80, 2000], size: [200, 160]}, radiance: 3, parts: 32}\n");
    struct lx_prepared prepared;
    assert_int_equal(lx_prepare(lx_scene_parameters(set), NULL, NULL, &prepared), 0);
    assert_int_equal(prepared.emitters.point_set_count, 1);
    assert_int_equal(prepared.emitters.count, 64 * 64);
    assert_true(prepared.emitters.point_sets[0].model.is_part);
    lx_prepared_clear(&prepared);
    luxel_probe *one, *other;
    assert_int_equal(luxel_probe_screen(set, NULL, 60, 40, NULL, &one), LUXEL_OK);
    assert_int_equal(luxel_probe_screen(quarters, NULL, 60, 40, NULL, &other), LUXEL_OK);
    assert_true(one->value > 0 && fabs(one->value - other->value) < 1e-12 * one->value);
    assert_true(one->has_pixel_value && fabs(one->pixel_value - other->pixel_value) < 1e-5 * one->pixel_value);
    luxel_probe_free(one);
    luxel_probe_free(other);
    luxel_scene_free(set);
    luxel_scene_free(quarters);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(asks_while_facets_are_made),
        cmocka_unit_test(asks_while_parts_are_cut),
        cmocka_unit_test(stops_at_any_question),
        cmocka_unit_test(integrals_end_when_told_to),
        cmocka_unit_test(precision_is_not_chosen_to_the_end),
        cmocka_unit_test(trees_are_planted_once),
        cmocka_unit_test(changed_files_are_read_again),
        cmocka_unit_test(clouds_have_trees_of_their_own),
        cmocka_unit_test(threads_share_what_is_kept),
        cmocka_unit_test(files_that_stay_are_kept),
        cmocka_unit_test(bodies_of_meshes_are_made_once),
        cmocka_unit_test(parts_in_a_swarm_shine_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
