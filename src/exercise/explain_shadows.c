/* SPDX-License-Identifier: MIT */
/*
 * The surfaces between an element and a light, and how much of it each takes: the light is asked for again with
 * nothing in its way, and with one surface after the other alone.
 */
#include "../base/number.h"
#include "../base/phrase.h"
#include "explain.h"
#include "parameter_tables.h"

/* Lights of more parts, or more parts by surfaces, would be computed for too long. */
enum { MOST_EMITTERS = 64, MOST_LIGHTINGS = 1 << 20 };

/* The irradiance that a light gives the element directly. */
static double irradiance_of(const struct lx_prepared *prepared, const struct lx_element *element, size_t light)
{
    const struct lx_emitters *emitters = &prepared->emitters;
    double sum = 0;
    for (size_t i = 0; i < emitters->count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        if (emitter->light != light)
            continue;
        const struct lx_lighting lighting = lx_light_directly(prepared, element, emitter);
        sum += lighting.on_element ? 0 : lighting.irradiance.value;
    }
    return sum;
}

/* A copy that points to what the scene has; it is not to be cleared. */
static struct lx_prepared with_one(const struct lx_prepared *prepared, size_t surface)
{
    struct lx_prepared alone = *prepared;
    alone.surfaces = &prepared->surfaces[surface];
    alone.surface_count = 1;
    alone.boxes = (struct lx_boxes){.count = 0};
    return alone;
}

static struct lx_prepared without_shadows(const struct lx_prepared *prepared)
{
    struct lx_prepared open = *prepared;
    open.shadows = open.shadows_extended = open.shadows_on_free = false;
    return open;
}

static void name_surface(const struct lx_steps *steps, const struct lx_prepared_surface *surface, double share)
{
    const struct lx_item *item = &steps->prepared->scene->surfaces.items[surface->authored];
    const struct lx_surface_common *common = item->common;
    const char *part = lx_part_name((const struct lx_surface_kind *)item->variant, surface->part);
    struct lx_text name = {0};
    char percent[LX_NUMBER_SIZE];
    lx_write_digits(100 * share, 4, percent);
    lx_add_element_name(&name, "surfaces", surface->authored, common->name);
    if (!name.bytes)
        return;
    if (part)
        lx_document_item(steps->document, "{0}, {1}: {2} %",
                         LX_SPANS(LX_PLAIN(name.bytes), LX_TERM_SPAN(part), LX_PLAIN(percent)));
    else
        lx_document_item(steps->document, "{0}: {1} %", LX_SPANS(LX_PLAIN(name.bytes), LX_PLAIN(percent)));
    lx_text_clear(&name);
}

void lx_explain_shadows(const struct lx_steps *steps, const luxel_light_share *share, size_t emitters)
{
    const double least = 1e-6; /* of the light: less is not worth a line */
    const struct lx_prepared *prepared = steps->prepared, open = without_shadows(prepared);
    char numbers[2][LX_NUMBER_SIZE];
    if (emitters > MOST_EMITTERS || emitters * prepared->surface_count > MOST_LIGHTINGS)
        return;
    const double whole = irradiance_of(&open, steps->element, share->light);
    if (!(whole > 0 && whole - share->irradiance > least * whole))
        return;
    lx_document_paragraph(
        steps->document,
        LX_N("With nothing in the way E would be {0}; {1} % of that is hidden. Each surface alone would "
             "take away:"),
        LX_SPANS(LX_PLAIN(lx_write_digits(whole, 7, numbers[0])),
                 LX_PLAIN(lx_write_digits(100 * (1 - share->irradiance / whole), 4, numbers[1]))));
    for (size_t i = 0; i < prepared->surface_count; i++) {
        const struct lx_prepared alone = with_one(prepared, i);
        const double taken = 1 - irradiance_of(&alone, steps->element, share->light) / whole;
        if (taken > least)
            name_surface(steps, &prepared->surfaces[i], taken);
    }
}
