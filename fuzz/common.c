/* SPDX-License-Identifier: MIT */
/* What the targets share. */
#include "fuzz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum {
    MOST_PIXELS = 20 * 20, /* that are computed */
    MOST_LIGHTS = 64,
    MOST_POINTS = 4,
    MOST_ASKED = 2000 /* how often a computation may report progress before it is given up */
};

void fuzz_must(bool holds, const char *what)
{
    if (holds)
        return;
    dprintf(STDERR_FILENO, "must hold: %s\n", what); /* `stderr` may be listened to */
    abort();
}

struct fuzz_file fuzz_open(const void *data, size_t size, const char *ending)
{
    char target[64];
    struct fuzz_file file = {.descriptor = memfd_create("fuzz", MFD_CLOEXEC)};
    fuzz_must(file.descriptor >= 0, "a file in memory");
    const char *bytes = data;
    for (size_t done = 0; done < size;) {
        ssize_t written = write(file.descriptor, bytes + done, size - done);
        fuzz_must(written > 0, "a file in memory can be written");
        done += (size_t)written;
    }
    snprintf(target, sizeof target, "/proc/%d/fd/%d", (int)getpid(), file.descriptor);
    snprintf(file.path, sizeof file.path, "/tmp/luxel-fuzz-%d%s", (int)getpid(), ending);
    unlink(file.path);
    fuzz_must(symlink(target, file.path) == 0, "a link can be made");
    return file;
}

void fuzz_close(struct fuzz_file *file)
{
    unlink(file->path);
    close(file->descriptor);
}

void fuzz_read_messages(const luxel_diagnostics *diagnostics)
{
    for (size_t i = 0; i < luxel_diagnostics_count(diagnostics); i++) {
        char *message = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
        char *hint = luxel_diagnostics_hint(diagnostics, i, NULL, NULL);
        fuzz_must(message && *message && hint, "a message has words");
        luxel_text_free(message);
        luxel_text_free(hint);
    }
}

void fuzz_listen(struct fuzz_words *words)
{
    *words = (struct fuzz_words){.before = stderr};
    FILE *listening = open_memstream(&words->text, &words->length);
    fuzz_must(listening != NULL, "memory");
    stderr = listening;
}

size_t fuzz_heard(struct fuzz_words *words)
{
    size_t lines = 0;
    unsigned char before = 0;
    fclose(stderr);
    stderr = words->before;
    for (size_t i = 0; i < words->length; i++) {
        unsigned char byte = (unsigned char)words->text[i];
        bool is_control = byte < ' ' || byte == 0x7f || (before == 0xc2 && byte < 0xa0); /* C1 in UTF-8 */
        lines += byte == '\n';
        fuzz_must(byte == '\n' || !is_control, "nothing steers the terminal");
        before = byte;
    }
    fuzz_must(words->length == 0 || words->text[words->length - 1] == '\n', "lines are whole");
    free(words->text);
    return lines;
}

/* What was written reads back as the same. */
static void write_and_read(const luxel_scene *scene)
{
    char *text, *again;
    luxel_scene *copy;
    if (luxel_scene_write_text(scene, &text) != LUXEL_OK)
        return;
    fuzz_must(luxel_scene_read_text(text, strlen(text), "written", NULL, &copy) == LUXEL_OK, "a written scene reads");
    fuzz_must(luxel_scene_write_text(copy, &again) == LUXEL_OK && strcmp(text, again) == 0,
              "a scene that is read is written as it was");
    luxel_text_free(text);
    luxel_text_free(again);
    luxel_scene_free(copy);
}

static bool go_on(double done, void *asked)
{
    fuzz_must(done >= 0 && done <= 1, "progress is a share");
    return ++*(unsigned *)asked < MOST_ASKED;
}

static void check_field(const luxel_field *field)
{
    const size_t count = (size_t)luxel_field_columns(field) * luxel_field_rows(field);
    const uint8_t *mask = luxel_field_mask(field);
    uint8_t *grey = malloc(count);
    fuzz_must(grey != NULL, "memory");
    luxel_field_grey(field, grey);
    free(grey);
    for (size_t i = 0; i < count; i++) {
        double value = luxel_field_double(field) ? luxel_field_double(field)[i] : (double)luxel_field_single(field)[i];
        fuzz_must(isfinite(value) && value >= 0, "a brightness is finite and not negative");
        fuzz_must(mask[i] <= 1 && (mask[i] || value == 0), "off the surfaces there is none");
    }
}

static void probe(const luxel_scene *scene, const luxel_settings *settings, double x, double y)
{
    luxel_probe *found;
    if (luxel_probe_screen(scene, settings, x, y, NULL, &found) != LUXEL_OK)
        return;
    if (found->has_value) {
        double sum = 0;
        fuzz_must(isfinite(found->value) && found->value >= 0, "a value is finite and not negative");
        fuzz_must(found->error >= 0, "a bound is not negative");
        for (size_t i = 0; i < found->share_count; i++)
            sum += settings->quantity == LUXEL_IRRADIANCE ? found->shares[i].irradiance
                                                          : found->shares[i].diffuse + found->shares[i].specular;
        fuzz_must(!isfinite(sum) || fabs(sum - found->value) <= found->error + 1e-9 * found->value,
                  "the lights' shares make up the value");
    }
    luxel_probe_free(found);
}

static void compute(const luxel_scene *scene)
{
    unsigned columns, rows, asked = 0;
    luxel_settings settings;
    luxel_field *field;
    luxel_scene_resolution(scene, &columns, &rows);
    if (luxel_scene_light_count(scene) > MOST_LIGHTS)
        return;
    luxel_settings_init(&settings);
    settings.threads = 1;
    settings.tolerance = 1e-4;
    settings.progress = go_on;
    settings.progress_data = &asked;
    while ((uint64_t)(columns / (settings.stride + 1)) * (rows / (settings.stride + 1)) > MOST_PIXELS)
        settings.stride = settings.stride * 2 + 1;
    settings.stride++;
    if (settings.stride <= 65536 && luxel_render(scene, &settings, NULL, &field) == LUXEL_OK) {
        check_field(field);
        luxel_field_free(field);
    }
    for (size_t i = 0; i < luxel_scene_point_count(scene) && i < MOST_POINTS; i++) {
        double x, y;
        luxel_scene_point(scene, i, &x, &y);
        probe(scene, &settings, x, y);
        settings.quantity = settings.quantity == LUXEL_BRIGHTNESS ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
    }
}

void fuzz_use_scene(luxel_scene *scene)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    write_and_read(scene);
    luxel_status status = luxel_scene_commit(scene, diagnostics);
    fuzz_must((status == LUXEL_OK) == luxel_scene_is_committed(scene), "a scene knows whether it is committed");
    fuzz_must(status == LUXEL_OK || status == LUXEL_ERROR_MEMORY ||
                  luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR) > 0,
              "an error has a message");
    fuzz_read_messages(diagnostics);
    luxel_diagnostics_clear(diagnostics);
    if (status == LUXEL_OK) {
        luxel_scene_advise(scene, diagnostics);
        fuzz_read_messages(diagnostics);
        compute(scene);
    }
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

void fuzz_use_file(const char *scene_text, const void *data, size_t size, const char *ending)
{
    struct fuzz_file file = fuzz_open(data, size, ending);
    luxel_scene *scene;
    char *text;
    fuzz_must(asprintf(&text, scene_text, file.path) > 0, "memory");
    fuzz_must(luxel_scene_read_text(text, strlen(text), "fuzz", NULL, &scene) == LUXEL_OK, "the scene around it");
    fuzz_use_scene(scene);
    free(text);
    fuzz_close(&file);
}
