/* SPDX-License-Identifier: MIT */
/*
 * Prints a hash of every frozen picture, of its values and its mask: for each scene, precision and instruction set that
 * runs here a line "NAME SET PRECISION HASH".
 *
 *     freeze SCENES        the built-in scenes and those of the file SCENES
 *
 * The first line names the compiler, since contracted products differ between compilers.  A picture that is refused,
 * such as one beyond the range of float32, has the status in the place of the hash.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

/* FNV-1a, 64 bits: what two different pictures share by chance once in 10^19. */
static uint64_t hash(uint64_t state, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++)
        state = (state ^ bytes[i]) * UINT64_C(0x100000001b3);
    return state;
}

static uint64_t hash_of(const luxel_field *field)
{
    const size_t count = (size_t)luxel_field_columns(field) * luxel_field_rows(field);
    const bool single = luxel_field_precision(field) == LUXEL_SINGLE;
    const void *values = single ? (const void *)luxel_field_single(field) : luxel_field_double(field);
    const uint64_t seen = hash(UINT64_C(0xcbf29ce484222325), luxel_field_mask(field), count);
    return hash(seen, values, count * (single ? sizeof(float) : sizeof(double)));
}

static void print_pictures(const char *name, const luxel_scene *scene)
{
    for (size_t i = 0; luxel_instruction_set_name(i); i++)
        for (luxel_precision precision = LUXEL_SINGLE; precision <= LUXEL_DOUBLE; precision++) {
            luxel_settings settings;
            luxel_field *field = NULL;
            luxel_settings_init(&settings);
            settings.precision = precision;
            settings.instruction_set = luxel_instruction_set_name(i);
            if (!luxel_instruction_set_runs(i))
                continue;
            const luxel_status status = luxel_render(scene, &settings, NULL, &field);
            printf("%s %s %s ", name, settings.instruction_set, precision == LUXEL_SINGLE ? "single" : "double");
            if (status == LUXEL_OK)
                printf("%016" PRIx64 "\n", hash_of(field));
            else
                printf("status-%d\n", (int)status);
            luxel_field_free(field);
        }
}

static bool print_scene(const char *name, const char *text, size_t length)
{
    luxel_scene *scene = NULL;
    const bool good = luxel_scene_read_text(text, length, name, NULL, &scene) == LUXEL_OK &&
                      luxel_scene_commit(scene, NULL) == LUXEL_OK;
    if (good)
        print_pictures(name, scene);
    else
        fprintf(stderr, "%s is no legal scene\n", name);
    luxel_scene_free(scene);
    return good;
}

static char *read_whole(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    long size;
    if (file && fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
        text = malloc((size_t)size + 1);
        if (text && fread(text, 1, (size_t)size, file) == (size_t)size)
            text[size] = '\0';
    }
    if (file)
        fclose(file);
    return text;
}

/* The next line that begins a scene, or the end. */
static char *next_scene(char *text)
{
    while (*text && strncmp(text, "= ", 2) != 0) {
        char *end = strchr(text, '\n');
        text = end ? end + 1 : text + strlen(text);
    }
    return text;
}

int main(int count, char **arguments)
{
    char *text = count == 2 ? read_whole(arguments[1]) : NULL;
    bool good = text != NULL;
    if (!good)
        fprintf(stderr, "usage: freeze SCENES\n");
    if (good)
        printf("# compiled by %s\n", __VERSION__);
    for (size_t i = 0; good && i < luxel_builtin_scene_count(); i++) {
        const char *scene = luxel_builtin_scene_text(i);
        good = print_scene(luxel_builtin_scene_name(i), scene, strlen(scene));
    }
    for (char *at = good ? next_scene(text) : NULL; at && *at;) {
        char *body = strchr(at, '\n');
        if (!body)
            break;
        *body++ = '\0';
        char *end = next_scene(body);
        good = print_scene(at + 2, body, (size_t)(end - body)) && good;
        at = end;
    }
    free(text);
    return good ? 0 : 1;
}
