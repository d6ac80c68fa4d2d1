/* SPDX-License-Identifier: MIT */
/* Finding what surface each pixel shows, and the colours of its material. */
#include "render_tints.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../picture/seen.h"
#include "../picture/shader.h"

/* The factors of a colour to its greatest channel, by which the grey pictures are made. */
static void divide(const double color[LX_CHANNELS], double factors[LX_CHANNELS])
{
    const double most = fmax(color[0], fmax(color[1], color[2]));
    for (int c = 0; c < LX_CHANNELS; c++)
        factors[c] = most > 0 ? color[c] / most : 0;
}

static void find_row(const struct lx_plan *plan, struct lx_seen *seen, const struct luxel_field *field, unsigned row,
                     uint32_t *of_pixels)
{
    for (size_t first = 0, count; first < field->columns; first += count) {
        const size_t left = field->columns - first;
        _Alignas(64) double x_mm[LX_BLOCK]; /* as kernels read it: whole lanes */
        count = left < LX_BLOCK ? left : LX_BLOCK;
        memcpy(x_mm, field->x_mm + first, count * sizeof *x_mm);
        lx_seen_pad(x_mm, count);
        const size_t found = lx_seen_find(plan, seen, field->y_mm[row], x_mm, count);
        for (size_t i = 0; i < count && found > 0; i++)
            of_pixels[first + i] = seen->shows_one ? 1 : seen->shown[i];
    }
}

int lx_tints_make(const struct lx_session *session, const struct luxel_field *field, struct lx_tints *tints)
{
    const struct lx_prepared *prepared = &session->prepared;
    struct lx_shader_memory *memory = lx_shader_memory_new(&session->plan);
    *tints = (struct lx_tints){.list = lx_new_array(prepared->surface_count + 1, sizeof *tints->list),
                               .of_pixels = lx_new_array((size_t)field->columns * field->rows, sizeof(uint32_t))};
    const bool is_made = memory && tints->list && tints->of_pixels;
    for (size_t s = 0; is_made && s < prepared->surface_count; s++) {
        const struct lx_material *material = prepared->surfaces[s].material;
        struct lx_tint *tint = &tints->list[s + 1];
        divide(material->color, tint->factors[0]);
        divide(material->specular_color, tint->factors[1]);
        for (int lobe = 0; lobe < 2; lobe++)
            for (int c = 0; c < LX_CHANNELS; c++)
                tints->greatest[lobe][c] = fmax(tints->greatest[lobe][c], tint->factors[lobe][c]);
    }
    for (unsigned row = 0; is_made && row < field->rows; row++)
        find_row(&session->plan, lx_shader_seen(memory), field, row, tints->of_pixels + (size_t)row * field->columns);
    lx_shader_memory_free(memory);
    return is_made ? 0 : -1;
}

void lx_tints_clear(struct lx_tints *tints)
{
    free(tints->list);
    free(tints->of_pixels);
}
