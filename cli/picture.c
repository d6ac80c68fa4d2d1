/* SPDX-License-Identifier: MIT */
/* Pictures from scenes and from files. */
#include "picture.h"

#include <string.h>
#include <strings.h>

#include "cli.h"
#include "message.h"
#include "text.h"
#include "work.h"

/* A .png holds no values: it is a picture that may carry its scene. */
bool picture_holds_values(const char *operand)
{
    static const char *const endings[] = {".npy", ".pfm", ".exr", ".csv"};
    const char *dot = operand ? strrchr(operand, '.') : NULL;

    for (size_t i = 0; dot && i < COUNT_OF(endings); i++)
        if (strcasecmp(dot, endings[i]) == 0)
            return true;
    return false;
}

static int read_values(const char *path, struct picture *picture)
{
    luxel_status status;

    picture->loaded = (struct loaded){.name = path, .diagnostics = message_new_diagnostics()};
    if (picture->options.assignment_count > 0) {
        message_error(_("%s holds values and no scene that -s could change"), path);
        return EXIT_USAGE;
    }
    if (picture->options.lights) {
        message_error(_("%s holds values and no scene whose lights --lights could choose"), path);
        return EXIT_USAGE;
    }
    status = luxel_field_read(path, picture->loaded.diagnostics, &picture->field);
    if (status != LUXEL_OK)
        return message_failure(status, picture->loaded.diagnostics);
    message_passed_over(picture->loaded.diagnostics, picture->options.quiet);
    return EXIT_DONE;
}

int picture_open(const struct options *options, const char *operand, struct picture *picture)
{
    struct work work;
    luxel_status status;
    int code;

    *picture = (struct picture){.options = *options};
    picture->options.operand = operand;
    if (picture_holds_values(operand))
        return read_values(operand, picture);
    code = load_scene(&picture->options, false, &picture->loaded);
    if (code != EXIT_DONE)
        return code;
    picture->options = load_options(&picture->options, &picture->loaded);
    work_begin(&work, &picture->options);
    status = luxel_render(picture->loaded.scene, &work.settings, picture->loaded.diagnostics, &picture->field);
    code = work_end(&work, status, picture->loaded.diagnostics);
    if (code != EXIT_TOLERANCE)
        return code;
    picture->code = EXIT_TOLERANCE;
    return EXIT_DONE;
}

void picture_close(struct picture *picture)
{
    luxel_field_free(picture->field);
    load_clear(&picture->loaded);
}

const char *picture_unit(const struct picture *picture)
{
    return luxel_field_unit(picture->field);
}

const char *picture_quantity_name(const struct picture *picture)
{
    return options_quantity_name(luxel_field_quantity(picture->field));
}

const char *picture_quantity(const struct picture *picture)
{
    return luxel_field_quantity_word(picture->field);
}

void picture_print_heading(const struct picture *picture)
{
    const char *unit = picture_unit(picture);

    text_print_escaped(stdout, picture->loaded.name);
    if (*unit)
        printf(_(": %s in %s, %u × %u pixels\n\n"), _(picture_quantity(picture)), text_unit(unit),
               luxel_field_columns(picture->field), luxel_field_rows(picture->field));
    else
        printf(_(": %u × %u pixels\n\n"), luxel_field_columns(picture->field), luxel_field_rows(picture->field));
}
