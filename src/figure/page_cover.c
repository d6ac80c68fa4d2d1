/* SPDX-License-Identifier: MIT */
/* The title page of a document: its lines in four groups, the title among them, and the room left between these. */
#include <math.h>

#include "page_rows.h"

static const struct lx_page_type line = {.size = 11, .leading = 1.45};
static const struct lx_page_type title = {.size = 19, .leading = 1.25, .bold = true};

static void add_line(struct lx_pages *pages, const struct lx_pieces *words, const struct lx_page_type *type,
                     PangoAlignment alignment, double above)
{
    PangoLayout *layout = lx_page_layout(pages, words, type, pages->width);
    if (!layout)
        return;
    pango_layout_set_alignment(layout, alignment);
    lx_page_add_lines(pages, layout, type, 0, above);
}

static void add_lines(struct lx_pages *pages, enum lx_cover_place place, PangoAlignment alignment)
{
    const struct luxel_document *document = pages->document;
    for (size_t i = 0; i < document->cover_counts[place]; i++)
        add_line(pages, &document->covers[place][i], &line, alignment, 0);
}

/* The height of the rows from the first to before the last. */
static double height_of(const struct lx_pages *pages, size_t first, size_t end)
{
    double height = 0;
    for (size_t i = first; i < end; i++)
        height += pages->rows[i].above + pages->rows[i].height;
    return height;
}

void lx_page_add_cover(struct lx_pages *pages)
{
    /* of the room that is left, before the title, what stands on the right, and the foot */
    static const double parts[3] = {0.42, 0.2, 0.38};
    size_t begins[4] = {0};
    add_lines(pages, LX_COVER_HEAD, PANGO_ALIGN_CENTER);
    begins[0] = pages->count;
    add_lines(pages, LX_COVER_ABOVE, PANGO_ALIGN_CENTER);
    add_line(pages, &pages->document->title, &title, PANGO_ALIGN_CENTER, begins[0] < pages->count ? 10 : 0);
    begins[1] = pages->count;
    add_lines(pages, LX_COVER_SIDE, PANGO_ALIGN_RIGHT);
    begins[2] = pages->count;
    add_lines(pages, LX_COVER_FOOT, PANGO_ALIGN_CENTER);
    begins[3] = pages->count;
    const double left = fmax(0, pages->room - height_of(pages, 0, pages->count));
    double gap = 0;
    for (int i = 0; i < 3; i++) {
        gap += parts[i] * left;
        if (begins[i] == begins[i + 1] || begins[i] == 0)
            continue;
        pages->rows[begins[i]].above += gap;
        gap = 0;
    }
}
