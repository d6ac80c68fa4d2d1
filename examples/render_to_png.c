/* SPDX-License-Identifier: MIT */
/*
 * Takes a built-in scene, changes some of its values and writes its picture:
 *
 *     render_to_png sphere.png [KEY=VALUE...]
 *     render_to_png sphere.png 'lights[0].intensity=20' 'surfaces[0].material.shininess=60'
 *
 * Every other ending that the library knows works as well, .npy for the numbers themselves for instance.
 */
#include <luxel/luxel.h>

#include <stdio.h>

/* Says what the library found: the place, the message, and how to mend it. */
static void print_diagnostics(const luxel_diagnostics *diagnostics)
{
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
        char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
        char *hint = luxel_diagnostics_hint(diagnostics, i, NULL, NULL);

        if (entry->source)
            fprintf(stderr, "%s:%u:%u: ", entry->source, entry->line, entry->column);
        fprintf(stderr, "%s\n", message ? message : entry->id);
        if (hint && *hint)
            fprintf(stderr, "    %s\n", hint);
        luxel_text_free(message);
        luxel_text_free(hint);
    }
}

/* All changes first, then one check of the whole scene: so the user sees everything that is wrong at once. */
static luxel_status change(luxel_scene *scene, char **assignments, int count, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;

    for (int i = 0; i < count && status == LUXEL_OK; i++)
        status = luxel_scene_set(scene, assignments[i], diagnostics);
    return status == LUXEL_OK ? luxel_scene_commit(scene, diagnostics) : status;
}

static void print_result(const luxel_field *field)
{
    const luxel_extremum *maximum = &luxel_field_statistics(field)->maximum;

    printf("%u x %u pixels\n", luxel_field_columns(field), luxel_field_rows(field));
    if (maximum->exists)
        printf("maximum %.6g %s in column %u, row %u\n", maximum->value, luxel_field_unit(field), maximum->column,
               maximum->row);
}

int main(int argc, char **argv)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_field *field = NULL;
    luxel_status status;

    if (argc < 2) {
        fprintf(stderr, "usage: render_to_png FILE [KEY=VALUE...]\n");
        luxel_diagnostics_free(diagnostics);
        return 2;
    }
    /* Each step stands only on the success of those before it; a NULL is harmless to every _free function. */
    status = luxel_scene_open_builtin("report", diagnostics, &scene);
    if (status == LUXEL_OK)
        status = change(scene, argv + 2, argc - 2, diagnostics);
    if (status == LUXEL_OK)
        status = luxel_render(scene, NULL, diagnostics, &field);
    if (status == LUXEL_OK)
        status = luxel_field_write(field, argv[1], diagnostics);
    if (status == LUXEL_OK)
        print_result(field);
    print_diagnostics(diagnostics);

    luxel_field_free(field);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    return status == LUXEL_OK ? 0 : 1;
}
