/* SPDX-License-Identifier: MIT */
/*
 * Why do two programs print different numbers?  Renders one scene twice at the same time, with the view vector along
 * the axis and towards the observer, and says how far the pictures differ:
 *
 *     compare_conventions [SECONDS]
 *
 * Two threads work on two scenes, which share nothing.  Both end early when the time is over: the progress callback
 * then answers false, and the rendering ends with LUXEL_CANCELLED.
 */
#include <luxel/luxel.h>

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* What one thread works on; the other does not touch it. */
struct work {
    const char *view;
    struct timespec deadline;
    double done;
    luxel_status status;
    luxel_field *field;
};

/* Called from the thread that called luxel_render(), with the share that is done. */
static bool keep_going(double done, void *data)
{
    struct work *work = data;
    struct timespec now;

    work->done = done;
    timespec_get(&now, TIME_UTC);
    return now.tv_sec < work->deadline.tv_sec ||
           (now.tv_sec == work->deadline.tv_sec && now.tv_nsec < work->deadline.tv_nsec);
}

/* Opens, changes and renders a scene of its own.  Without diagnostics the status alone tells what went wrong. */
static void *render(void *data)
{
    struct work *work = data;
    luxel_scene *scene = NULL;
    luxel_settings settings;

    luxel_settings_init(&settings);
    settings.threads = 1; /* two scenes at once keep two processors busy */
    settings.precision = LUXEL_DOUBLE;
    settings.progress = keep_going;
    settings.progress_data = work;

    work->status = luxel_scene_open_builtin("report", NULL, &scene);
    if (work->status == LUXEL_OK)
        work->status = luxel_scene_set(scene, work->view, NULL);
    if (work->status == LUXEL_OK)
        work->status = luxel_scene_commit(scene, NULL);
    if (work->status == LUXEL_OK)
        work->status = luxel_render(scene, &settings, NULL, &work->field);
    luxel_scene_free(scene);
    return NULL;
}

/* Prints the largest difference of two pictures of the same size. */
static void compare(const luxel_field *first, const luxel_field *second)
{
    const unsigned columns = luxel_field_columns(first), rows = luxel_field_rows(first);
    const double *a = luxel_field_double(first), *b = luxel_field_double(second);
    size_t worst = 0;

    for (size_t i = 0; i < (size_t)columns * rows; i++)
        if (fabs(a[i] - b[i]) > fabs(a[worst] - b[worst]))
            worst = i;
    printf("they differ most in column %zu, row %zu: %.6g and %.6g %s\n", worst % columns, worst / columns, a[worst],
           b[worst], luxel_field_unit(first));
}

int main(int argc, char **argv)
{
    struct work works[2] = {{.view = "observer.view=parallel"}, {.view = "observer.view=observer"}};
    const long seconds = argc > 1 ? strtol(argv[1], NULL, 10) : 60;
    pthread_t threads[2];
    int started = 0, code = 0;

    for (; started < 2; started++) {
        struct timespec *deadline = &works[started].deadline;

        timespec_get(deadline, TIME_UTC);
        deadline->tv_sec += seconds;
        if (pthread_create(&threads[started], NULL, render, &works[started]) != 0)
            break;
    }
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);

    for (int i = 0; i < 2; i++) {
        const struct work *work = &works[i];

        if (i < started && work->status == LUXEL_OK)
            printf("%s: maximum %.9g %s\n", work->view, luxel_field_statistics(work->field)->maximum.value,
                   luxel_field_unit(work->field));
        else if (i < started && work->status == LUXEL_CANCELLED)
            printf("%s: cancelled at %.0f %%\n", work->view, 100.0 * work->done);
        else
            printf("%s: failed\n", work->view);
        if (i >= started || work->status != LUXEL_OK)
            code = 1;
    }
    if (code == 0)
        compare(works[0].field, works[1].field);

    luxel_field_free(works[0].field);
    luxel_field_free(works[1].field);
    return code;
}
