/* SPDX-License-Identifier: MIT */
/* Values written into the pixels of a picture that is zoomed in so far that there is room for them. */
#include <math.h>

#include "../base/number.h"
#include "view_draw.h"

enum { LEAST_SIDE = 60 /* of a pixel in those of the widget */, DIGITS = 4 };

/* The shown pixels, from *first to before *end, of a row of `count` that begins at `origin` of the widget. */
static void find_shown(double origin, double side, double length, guint count, guint *first, guint *end)
{
    *first = (guint)CLAMP(floor(-origin / side), 0, count);
    *end = (guint)CLAMP(ceil((length - origin) / side), 0, count);
}

void app_draw_values(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const AppPicture *picture)
{
    const luxel_field *field = picture->side == APP_SIDE_PINNED ? picture->pinned->field : picture->shot->field;
    const AppArea area = app_area_of(field);
    const guint columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const double upper_left[2] = {area.low[0], area.high[1]};
    const double side[2] = {map->scale * (area.high[0] - area.low[0]) / columns,
                            map->scale * (area.high[1] - area.low[1]) / rows};
    double origin[2];
    guint first[2], end[2];
    if (!picture->shot->is_fine || side[0] < LEAST_SIDE || side[1] < LEAST_SIDE / 2.0)
        return;
    app_map_to_widget(map, upper_left, origin);
    find_shown(origin[0], side[0], gtk_widget_get_width(widget), columns, &first[0], &end[0]);
    find_shown(origin[1], side[1], gtk_widget_get_height(widget), rows, &first[1], &end[1]);
    for (guint row = first[1]; row < end[1]; row++)
        for (guint column = first[0]; column < end[0]; column++) {
            const double middle[2] = {origin[0] + (column + 0.5) * side[0], origin[1] + (row + 0.5) * side[1]};
            char text[APP_NUMBER_SIZE];
            double value;
            if (app_picture_value(picture, column, row, &value))
                app_draw_text(snapshot, widget, middle, app_number_show(value, DIGITS, text));
        }
}
