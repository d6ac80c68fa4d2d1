/* SPDX-License-Identifier: MIT */
/* Fields of files and of values in memory: the values, and what else is told about them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "../base/text.h"
#include "../field/field.h"
#include "../format/format.h"
#include "../scene/carried.h"

static double value_of(const struct lx_loaded *loaded, size_t i)
{
    return loaded->sample == LX_SAMPLE_F64 ? ((const double *)loaded->values)[i]
                                           : (double)((const float *)loaded->values)[i];
}

/* Where a file tells no mask: off the surfaces a field is 0, and hardly anywhere else. */
static uint8_t *mask_of_values(const struct lx_loaded *loaded)
{
    size_t pixels = (size_t)loaded->columns * loaded->rows;
    uint8_t *mask = lx_new_aligned(pixels, 1);
    for (size_t i = 0; mask && i < pixels; i++)
        mask[i] = value_of(loaded, i) != 0;
    return mask;
}

/* The unit of a file may hold anything, and goes to terminals. */
static char *copy_unit(const char *unit)
{
    struct lx_text text = {0};
    lx_text_add_escaped(&text, unit, strlen(unit));
    return lx_text_take(&text);
}

static bool is_photometric(const char *unit)
{
    return strcmp(unit, "lx") == 0 || strcmp(unit, "cd") == 0 || strcmp(unit, "cd/m²") == 0;
}

/* Moves what was read into a field. */
static struct luxel_field *make_field(struct lx_loaded *loaded)
{
    const struct lx_read_tag *tag = lx_tags_find(&loaded->tags, LX_TAG_UNIT);
    const char *unit = loaded->unit ? loaded->unit : tag ? tag->value : "";
    struct luxel_field *field = lx_new_array(1, sizeof *field);
    if (!field)
        return NULL;
    *field = (struct luxel_field){
        .columns = loaded->columns,
        .rows = loaded->rows,
        .precision = loaded->sample == LX_SAMPLE_F64 ? LUXEL_DOUBLE : LUXEL_SINGLE,
        .unit = copy_unit(unit),
        .quantity_word = LX_N("values"),
        .instruction_set = "",
        .values = loaded->values,
        .mask = loaded->mask ? loaded->mask : mask_of_values(loaded),
        .mask_is_guess = !loaded->mask,
        .x_mm = loaded->x_mm,
        .y_mm = loaded->y_mm,
    };
    loaded->values = loaded->mask = NULL;
    loaded->x_mm = loaded->y_mm = NULL;
    if (field->unit && field->mask)
        return field;
    luxel_field_free(field);
    return NULL;
}

/*
 * What the scene that the file carries tells: the places of the pixels and their grey levels.  A scene that cannot be
 * read or is of another picture tells nothing; the values are good without it.
 */
static luxel_status take_scene(struct luxel_field *field, const struct lx_tags *tags)
{
    const struct lx_read_tag *tag = lx_tags_find(tags, LX_TAG_SCENE);
    luxel_scene *scene = NULL;
    luxel_status status = LUXEL_OK;
    if (!tag || luxel_scene_read_text(tag->value, tag->length, NULL, NULL, &scene) != LUXEL_OK)
        return LUXEL_OK;
    const struct lx_scene_parameters *parameters =
        luxel_scene_commit(scene, NULL) == LUXEL_OK ? lx_scene_parameters(scene) : NULL;
    if (parameters && parameters->screen.resolution[0] == field->columns &&
        parameters->screen.resolution[1] == field->rows) {
        field->picture = parameters->picture;
        if (parameters->units == LX_PHOTOMETRIC)
            field->quantity_word = lx_quantity_word(field->quantity, true);
        field->x_mm = lx_new_column_places(&parameters->screen, 1);
        field->y_mm = lx_new_row_places(&parameters->screen, 1);
        field->scene = lx_scene_text_copy(tag->value, tag->length);
        status = field->x_mm && field->y_mm && field->scene ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    }
    luxel_scene_free(scene);
    return status;
}

/* The settings that the file tells; its own values tell the precision. */
static void take_settings(struct luxel_field *field, const char *path, const struct lx_tags *tags)
{
    struct lx_carried carried = {0};
    struct lx_source *silent = NULL;
    if (lx_source_of_bytes(path, "", 0, NULL, &silent) == LUXEL_OK &&
        lx_carried_read(silent, tags, &carried) == LUXEL_OK) {
        field->quantity = carried.quantity;
        if (lx_tags_find(tags, LX_TAG_QUANTITY))
            field->quantity_word = lx_quantity_word(carried.quantity, is_photometric(field->unit));
        field->tolerance = carried.tolerance;
        field->light_error = carried.light_error;
        field->reflected_error = carried.reflected_error;
    }
    lx_source_close(silent);
}

/* What was read as a field, which `loaded` then no longer holds; `status` is that of reading it. */
static luxel_status finish(struct lx_loaded *loaded, const char *path, luxel_status status,
                           luxel_diagnostics *diagnostics, luxel_field **field)
{
    struct luxel_field *made = status == LUXEL_OK ? make_field(loaded) : NULL;
    if (made) {
        take_settings(made, path, &loaded->tags);
        status = take_scene(made, &loaded->tags);
        if (status == LUXEL_OK && lx_gather_statistics(made) < 0)
            status = LUXEL_ERROR_MEMORY;
    }
    if ((status == LUXEL_OK && !made) || (made && status == LUXEL_ERROR_MEMORY))
        status = lx_out_of_memory(diagnostics);
    lx_loaded_clear(loaded);
    if (status == LUXEL_OK)
        *field = made;
    else
        luxel_field_free(made);
    return status;
}

luxel_status luxel_field_read(const char *path, luxel_diagnostics *diagnostics, luxel_field **field)
{
    struct lx_loaded loaded = {0};
    if (!path || !field)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(path ? "field" : "path"));
    luxel_status status = lx_read_image(path, diagnostics, &loaded);
    return finish(&loaded, path, status, diagnostics, field);
}

luxel_status luxel_field_read_memory(const void *bytes, size_t length, const char *name, luxel_diagnostics *diagnostics,
                                     luxel_field **field)
{
    struct lx_loaded loaded = {0};
    struct lx_source *source = NULL;
    if (!bytes || !name || !field)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(!bytes ? "bytes" : !name ? "name" : "field"));
    luxel_status status = lx_source_of_bytes(name, bytes, length, diagnostics, &source);
    if (status == LUXEL_OK)
        status = lx_read_image_of(source, &loaded);
    lx_source_close(source);
    return finish(&loaded, name, status, diagnostics, field);
}

/* Copies the places of columns, which go up, or of rows, which go down; `places` NULL: none. */
static luxel_status copy_places(const double *places, size_t count, bool go_up, luxel_diagnostics *diagnostics,
                                double **copied)
{
    if (!places)
        return LUXEL_OK;
    for (size_t i = 0; i < count; i++) {
        const double step = i == 0 ? 1 : go_up ? places[i] - places[i - 1] : places[i - 1] - places[i];
        if (!isfinite(places[i]) || !(step > 0))
            return lx_setting_out_of_range(diagnostics, go_up ? "x_mm" : "y_mm", places[i],
                                           go_up ? LX_N("finite and above the one before")
                                                 : LX_N("finite and below the one before"));
    }
    *copied = lx_new_array(count, sizeof **copied);
    if (!*copied)
        return lx_out_of_memory(diagnostics);
    memcpy(*copied, places, count * sizeof **copied);
    return LUXEL_OK;
}

/* Copies the values and the mask, off which a field is 0. */
static luxel_status copy_values(const luxel_field_content *content, struct lx_loaded *loaded,
                                luxel_diagnostics *diagnostics)
{
    struct lx_source *source = NULL;
    luxel_status status = lx_source_of_bytes("values", "", 0, diagnostics, &source);
    if (status == LUXEL_OK)
        status = lx_loaded_allocate(source, loaded);
    lx_source_close(source);
    if (status != LUXEL_OK)
        return status;
    const size_t pixels = (size_t)content->columns * content->rows;
    const size_t width = content->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float);
    memcpy(loaded->values, content->values, pixels * width);
    loaded->mask = content->mask ? lx_new_aligned(pixels, 1) : NULL;
    if (content->mask && !loaded->mask)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; content->mask && i < pixels; i++) {
        loaded->mask[i] = content->mask[i] != 0;
        if (!loaded->mask[i])
            memset((char *)loaded->values + i * width, 0, width);
    }
    return LUXEL_OK;
}

/* Whether size and enumerations are in their ranges, and the places of columns and rows come together. */
static luxel_status check_content(const luxel_field_content *content, luxel_diagnostics *diagnostics)
{
    static const char size[] = LX_N("1 to 65536");
    if (!content->values || !content->x_mm != !content->y_mm)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT,
                         LX_ARGS(!content->values ? "values"
                                 : content->x_mm  ? "y_mm"
                                                  : "x_mm"));
    if (content->columns - 1 >= LX_MOST_PIXELS)
        return lx_setting_out_of_range(diagnostics, "columns", content->columns, size);
    if (content->rows - 1 >= LX_MOST_PIXELS)
        return lx_setting_out_of_range(diagnostics, "rows", content->rows, size);
    if ((unsigned)content->precision > LUXEL_DOUBLE)
        return lx_setting_out_of_range(diagnostics, "precision", (double)content->precision, LX_N("single or double"));
    if ((unsigned)content->quantity > LUXEL_IRRADIANCE)
        return lx_setting_out_of_range(diagnostics, "quantity", (double)content->quantity,
                                       LX_N("brightness or irradiance"));
    return LX_CHECK_RESERVE(content, diagnostics);
}

luxel_status luxel_field_of_values(const luxel_field_content *content, luxel_diagnostics *diagnostics,
                                   luxel_field **field)
{
    if (!content || !field)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(content ? "field" : "content"));
    luxel_status status = check_content(content, diagnostics);
    if (status != LUXEL_OK)
        return status;
    struct lx_loaded loaded = {
        .columns = content->columns,
        .rows = content->rows,
        .sample = content->precision == LUXEL_DOUBLE ? LX_SAMPLE_F64 : LX_SAMPLE_F32,
    };
    status = copy_places(content->x_mm, content->columns, true, diagnostics, &loaded.x_mm);
    if (status == LUXEL_OK)
        status = copy_places(content->y_mm, content->rows, false, diagnostics, &loaded.y_mm);
    if (status == LUXEL_OK)
        status = copy_values(content, &loaded, diagnostics);
    if (status == LUXEL_OK && content->unit && !(loaded.unit = lx_copy_text(content->unit, strlen(content->unit))))
        status = lx_out_of_memory(diagnostics);
    luxel_field *made = NULL;
    status = finish(&loaded, "values", status, diagnostics, &made);
    if (status != LUXEL_OK)
        return status;
    made->quantity = content->quantity_known ? content->quantity : LUXEL_BRIGHTNESS;
    made->quantity_word =
        content->quantity_known ? lx_quantity_word(made->quantity, is_photometric(made->unit)) : LX_N("values");
    *field = made;
    return LUXEL_OK;
}
