/* SPDX-License-Identifier: MIT */
/* Batches of elements: one element after the other, and each of them on its own again. */
#include "elements.h"

#include <math.h>
#include <string.h>

static void set(struct lx_column *column, size_t i, lx_bounded number)
{
    column->value[i] = number.value;
    column->error[i] = number.error;
}

static void set3(struct lx_columns3 *columns, size_t i, lx_bounded3 vector)
{
    set(&columns->x, i, vector.x);
    set(&columns->y, i, vector.y);
    set(&columns->z, i, vector.z);
}

void lx_column_clear(struct lx_column *column, size_t count)
{
    const size_t whole = (count + LX_VECTOR - 1) / LX_VECTOR * LX_VECTOR;
    memset(column->value, 0, whole * sizeof *column->value);
    memset(column->error, 0, whole * sizeof *column->error);
}

lx_bounded lx_column_get(const struct lx_column *column, size_t i)
{
    return (lx_bounded){column->value[i], column->error[i]};
}

lx_bounded3 lx_columns_get(const struct lx_columns3 *columns, size_t i)
{
    return (lx_bounded3){lx_column_get(&columns->x, i), lx_column_get(&columns->y, i), lx_column_get(&columns->z, i)};
}

void lx_elements_begin(struct lx_elements *elements, const struct lx_lobe *lobe, bool are_free)
{
    elements->count = 0;
    elements->lobe = lobe;
    elements->are_free = are_free;
    elements->has_sides = false;
}

/* An element that nothing is known of but where it is. */
static void begin_element(struct lx_elements *elements, size_t i)
{
    elements->own[i] = 0;
    elements->side_x[i] = elements->side_y[i] = elements->side_z[i] = 0;
    elements->asks[i] = false;
    elements->shown[i] = LX_SHOWN;
}

void lx_elements_append(const struct lx_prepared *prepared, struct lx_elements *elements,
                        const struct lx_element *element)
{
    const size_t i = elements->count++;
    begin_element(elements, i);
    set3(&elements->place_mm, i, element->place_mm);
    set3(&elements->normal, i, element->normal);
    set3(&elements->view, i, element->view);
    elements->own[i] = element->own ? (uint32_t)(element->own - prepared->surfaces) + 1 : 0;
    elements->asks[i] = element->own && element->is_free;
    elements->has_sides = elements->has_sides || elements->asks[i];
    elements->shown[i] = element->shown;
}

void lx_elements_append_place(struct lx_elements *elements, lx_bounded3 place_mm, lx_bounded3 normal,
                              const double view[3])
{
    const size_t i = elements->count++;
    begin_element(elements, i);
    set3(&elements->place_mm, i, place_mm);
    set3(&elements->normal, i, normal);
    if (view)
        set3(&elements->view, i, lx_exact3(view));
}

static void copy_column(struct lx_column *to, size_t i, const struct lx_column *from, size_t k)
{
    to->value[i] = from->value[k];
    to->error[i] = from->error[k];
}

static void copy_columns(struct lx_columns3 *to, size_t i, const struct lx_columns3 *from, size_t k)
{
    copy_column(&to->x, i, &from->x, k);
    copy_column(&to->y, i, &from->y, k);
    copy_column(&to->z, i, &from->z, k);
}

/* Element i of one batch becomes element k of another. */
static void copy_element(struct lx_elements *to, size_t i, const struct lx_elements *from, size_t k)
{
    copy_columns(&to->place_mm, i, &from->place_mm, k);
    copy_columns(&to->normal, i, &from->normal, k);
    copy_columns(&to->view, i, &from->view, k);
    to->own[i] = from->own[k];
    to->side_x[i] = from->side_x[k];
    to->side_y[i] = from->side_y[k];
    to->side_z[i] = from->side_z[k];
    to->asks[i] = from->asks[k];
    to->shown[i] = from->shown[k];
}

void lx_elements_copy(struct lx_elements *to, const struct lx_elements *from, size_t k)
{
    copy_element(to, to->count++, from, k);
    to->has_sides = from->has_sides;
}

/* The ball around the box around all places. */
static struct lx_ball ball_around(const struct lx_elements *elements)
{
    const struct lx_column *columns[3] = {&elements->place_mm.x, &elements->place_mm.y, &elements->place_mm.z};
    struct lx_ball ball = {.radius = 0};
    double square = 0, size = 0, error = 0;
    for (int k = 0; k < 3; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < elements->count; i++) {
            const double at = columns[k]->value[i], off = columns[k]->error[i];
            low = at < low ? at : low;
            high = at > high ? at : high;
            error = off > error ? off : error;
        }
        ball.center[k] = low / 2 + high / 2;
        square += (high / 2 - low / 2) * (high / 2 - low / 2);
        size += fmax(fabs(low), fabs(high));
    }
    ball.radius = sqrt(square) + 4 * error + LX_BALL_ROOM * size;
    return ball;
}

void lx_elements_end(struct lx_elements *elements)
{
    const struct lx_columns3 *normal = &elements->normal;
    elements->around = ball_around(elements);
    elements->has_exact_normals = true;
    for (size_t i = 0; i < elements->count; i++)
        elements->has_exact_normals = elements->has_exact_normals && normal->x.error[i] == 0 &&
                                      normal->y.error[i] == 0 && normal->z.error[i] == 0;
    for (size_t i = elements->count; i > 0 && i % LX_VECTOR != 0; i++)
        copy_element(elements, i, elements, elements->count - 1);
}

void lx_elements_of_one(const struct lx_prepared *prepared, const struct lx_element *element,
                        struct lx_elements *elements)
{
    lx_elements_begin(elements, element->lobe, element->is_free);
    lx_elements_append(prepared, elements, element);
    lx_elements_end(elements);
}

struct lx_element lx_elements_get(const struct lx_prepared *prepared, const struct lx_elements *elements, size_t i)
{
    return (struct lx_element){
        .place_mm = lx_columns_get(&elements->place_mm, i),
        .normal = lx_columns_get(&elements->normal, i),
        .view = lx_columns_get(&elements->view, i),
        .lobe = elements->lobe,
        .own = elements->own[i] > 0 ? &prepared->surfaces[elements->own[i] - 1] : NULL,
        .is_free = elements->are_free,
        .shown = elements->shown[i],
    };
}
