/* SPDX-License-Identifier: MIT */
/* The luminaires of a lighting report: a schedule with totals, and where each hangs. */
#include <luxel/photometry.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../light/array.h"
#include "../parameter/decode.h"
#include "lighting.h"

enum { MOST_PLACES = 200, DIGITS = 5 };

/* What the schedule says of a light. */
struct entry {
    const luxel_photometry *photometry; /* NULL: it has no file */
    const char *file, *type, *name;
    size_t count;
    double flux;        /* of one, when it is new; NaN: it has none */
    double watts;       /* of one; 0: not known */
    double maintenance; /* of the scene and its own */
    double dimming;     /* of its group */
    double (*places_mm)[3];
};

struct totals {
    double count, flux, watts;
    bool has_flux, has_watts, is_dimmed;
};

static double own_maintenance(const struct lx_item *item)
{
    const struct lx_parameter *key = lx_find_parameter(item->variant->table, "maintenance_factor");
    return key ? *(const double *)lx_const_member(key, item->parameters) : 1;
}

/* False: the light is off, or comes from everywhere or far away; else its places are to be freed. */
static bool find_entry(const struct lx_design_report *lighting, size_t i, struct entry *entry)
{
    const struct lx_report *report = lighting->report;
    const struct lx_item *item = &report->parameters->lights.items[i];
    const struct lx_light_common *common = item->common;
    const struct lx_light_kind *kind = (const struct lx_light_kind *)item->variant;
    double flux = (double)NAN;
    *entry = (struct entry){.count = lx_light_places(item),
                            .type = item->variant->name,
                            .name = common->name,
                            .maintenance = report->parameters->maintenance * own_maintenance(item),
                            .dimming = lx_dimming_of(report->parameters, item)};
    if (!common->enabled || !(entry->places_mm = lx_light_find_places(item)))
        return false;
    if (kind->photometry)
        entry->photometry = kind->photometry(item->parameters, &entry->file);
    if (luxel_scene_light_flux(report->scene, i, &flux) != LUXEL_OK)
        flux = (double)NAN;
    entry->flux = flux / ((double)entry->count * entry->maintenance * entry->dimming);
    if (entry->photometry && entry->photometry->watts > 0)
        entry->watts = entry->photometry->watts;
    return true;
}

static const char *number_or_dash(bool exists, double number, int digits, char buffer[LX_NUMBER_SIZE])
{
    return exists && isfinite(number) ? lx_write_digits(number, digits, buffer) : "–";
}

/* "lamp.ies, Maker, number": what tells the luminaire. */
static void add_article(const struct entry *entry, struct lx_text *text)
{
    static const char *const keywords[] = {"MANUFAC", "LUMCAT", "LUMINAIRE"};
    lx_text_puts(text, entry->file ? entry->file : entry->type);
    for (size_t i = 0; entry->photometry && i < sizeof keywords / sizeof *keywords; i++) {
        const char *words = luxel_photometry_find_text(entry->photometry, keywords[i]);
        if (words && *words) {
            lx_text_puts(text, ", ");
            lx_text_add_escaped(text, words, strcspn(words, "\n"));
        }
    }
}

static void add_entry(const struct lx_design_report *lighting, size_t i, const struct entry *entry,
                      struct totals *totals)
{
    struct lx_report *report = lighting->report;
    const bool has_watts = entry->watts > 0, has_flux = isfinite(entry->flux);
    char name[40], numbers[4][LX_NUMBER_SIZE];
    struct lx_text article = {0};
    snprintf(name, sizeof name, "lights[%zu]", i);
    add_article(entry, &article);
    lx_document_row(
        report->document,
        LX_SPANS(LX_PLAIN(entry->name ? entry->name : name), LX_PLAIN(article.bytes ? article.bytes : ""),
                 LX_PLAIN(lx_write_number((double)entry->count, numbers[0])),
                 LX_PLAIN(number_or_dash(has_flux, entry->flux, DIGITS, numbers[1])),
                 LX_PLAIN(number_or_dash(has_watts, entry->watts, DIGITS, numbers[2])),
                 LX_PLAIN(number_or_dash(has_watts && has_flux, entry->flux / entry->watts, 4, numbers[3]))),
        false);
    lx_text_clear(&article);
    totals->count += (double)entry->count;
    totals->flux += (double)entry->count * entry->flux;
    totals->watts += (double)entry->count * entry->watts;
    totals->is_dimmed = totals->is_dimmed || entry->dimming < 1;
    totals->has_flux = totals->has_flux && has_flux;
    totals->has_watts = totals->has_watts && has_watts;
}

/* The totals, and what they are for the floor and for the light on the first grid. */
static void add_totals(const struct lx_design_report *lighting, const struct totals *totals)
{
    struct luxel_document *document = lighting->report->document;
    const luxel_grid *grid = lighting->grid_count > 0 ? lighting->grids[0] : NULL;
    char numbers[5][LX_NUMBER_SIZE];
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("together")), LX_PLAIN(""),
                             LX_PLAIN(lx_write_number(totals->count, numbers[0])),
                             LX_PLAIN(number_or_dash(totals->has_flux, totals->flux, DIGITS, numbers[1])),
                             LX_PLAIN(number_or_dash(totals->has_watts, totals->watts, DIGITS, numbers[2])),
                             LX_PLAIN(number_or_dash(totals->has_flux && totals->has_watts,
                                                     totals->flux / totals->watts, 4, numbers[3]))),
                    false);
    if (!totals->has_watts) {
        lx_document_paragraph(document, LX_N("The power is not known: not all luminaires have a file that tells it."),
                              NULL);
        return;
    }
    if (!(lighting->floor_m2 > 0))
        return;
    const double density = totals->watts / lighting->floor_m2;
    lx_document_paragraph(document, LX_N("On {0} m² of floor that is {1} W/m²."),
                          LX_SPANS(LX_PLAIN(lx_write_digits(lighting->floor_m2, DIGITS, numbers[0])),
                                   LX_PLAIN(lx_write_digits(density, 4, numbers[1]))));
    if (grid && grid->measured > 0 && !totals->is_dimmed && grid->average.value > 0)
        lx_document_paragraph(document, LX_N("By the average of the first grid, {0} {2}, it is {1} W/m² for 100 {2}."),
                              LX_SPANS(LX_PLAIN(lx_write_digits(grid->average.value, DIGITS, numbers[2])),
                                       LX_PLAIN(lx_write_digits(100 * density / grid->average.value, 4, numbers[3])),
                                       LX_PLAIN(lx_document_word(document, grid->unit))));
}

/* How each light is kept and hangs. */
static void add_hanging(const struct lx_design_report *lighting)
{
    struct luxel_document *document = lighting->report->document;
    struct entry entry;
    lx_document_table(document, "lrrr");
    lx_document_name_table(document, "maintenance", 0);
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("light")), LX_TERM_SPAN(LX_N("maintenance")),
                             LX_TERM_SPAN(LX_N("dimmed to")), LX_TERM_SPAN(LX_N("height, mm"))),
                    false);
    for (size_t i = 0; i < lighting->report->parameters->lights.count; i++) {
        char name[40], numbers[3][LX_NUMBER_SIZE];
        if (!find_entry(lighting, i, &entry))
            continue;
        const double height = lx_dot(entry.places_mm[0], lx_lighting_up(lighting));
        snprintf(name, sizeof name, "lights[%zu]", i);
        lx_document_row(document,
                        LX_SPANS(LX_PLAIN(entry.name ? entry.name : name),
                                 LX_PLAIN(lx_write_digits(entry.maintenance, 4, numbers[0])),
                                 LX_PLAIN(lx_write_digits(entry.dimming, 4, numbers[2])),
                                 LX_PLAIN(lx_report_number(height + 0.0, numbers[1]))),
                        false);
        free(entry.places_mm);
    }
}

static void add_places(const struct lx_design_report *lighting)
{
    struct luxel_document *document = lighting->report->document;
    const size_t lights = lighting->report->parameters->lights.count;
    size_t number = 0;
    struct entry entry;
    lx_document_heading(document, 2, LX_N("Positions"), NULL);
    lx_document_table(document, "rlrrr");
    lx_document_name_table(document, "positions", 0);
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("no.")), LX_TERM_SPAN(LX_N("light")), LX_TERM_SPAN(LX_N("x, mm")),
                             LX_TERM_SPAN(LX_N("y, mm")), LX_TERM_SPAN(LX_N("z, mm"))),
                    false);
    for (size_t i = 0; i < lights && number < MOST_PLACES; i++) {
        if (!find_entry(lighting, i, &entry))
            continue;
        for (size_t k = 0; k < entry.count && number < MOST_PLACES; k++) {
            const double *place = entry.places_mm[k];
            char name[40], numbers[4][LX_NUMBER_SIZE];
            snprintf(name, sizeof name, "lights[%zu]", i);
            lx_document_row(document,
                            LX_SPANS(LX_PLAIN(lx_write_number((double)++number, numbers[3])),
                                     LX_PLAIN(entry.name ? entry.name : name),
                                     LX_PLAIN(lx_report_number(place[0] + 0.0, numbers[0])),
                                     LX_PLAIN(lx_report_number(place[1] + 0.0, numbers[1])),
                                     LX_PLAIN(lx_report_number(place[2] + 0.0, numbers[2]))),
                            false);
        }
        free(entry.places_mm);
    }
    if (number == MOST_PLACES)
        lx_document_paragraph(document, LX_N("These are the first {0} places."),
                              LX_SPANS(LX_PLAIN(lx_write_number(MOST_PLACES, (char[LX_NUMBER_SIZE]){0}))));
}

luxel_status lx_lighting_lamps(struct lx_design_report *lighting)
{
    struct luxel_document *document = lighting->report->document;
    const char *unit =
        lx_document_word(document, lx_unit_word(LX_UNIT_POWER, lighting->report->parameters->units == LX_PHOTOMETRIC));
    struct totals totals = {.has_flux = true, .has_watts = true};
    char flux[80], efficacy[40];
    struct entry entry;
    lx_document_heading(document, 1, LX_N("Luminaires"), NULL);
    lx_document_paragraph(document,
                          LX_N("Flux and power are those of one new luminaire that is not dimmed; the maintenance "
                               "factor is that of the scene times its own, and the height that of the first place."),
                          NULL);
    snprintf(flux, sizeof flux, "%s, %s", lx_document_word(document, LX_N("flux")), unit);
    snprintf(efficacy, sizeof efficacy, "%s/%s", unit, lx_document_word(document, "W"));
    lx_document_table(document, "llrrrr");
    lx_document_name_table(document, "luminaires", 0);
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("light")), LX_TERM_SPAN(LX_N("luminaire")), LX_TERM_SPAN(LX_N("number")),
                             LX_PLAIN(flux), LX_TERM_SPAN(LX_N("power, W")), LX_PLAIN(efficacy)),
                    false);
    for (size_t i = 0; i < lighting->report->parameters->lights.count; i++)
        if (find_entry(lighting, i, &entry)) {
            add_entry(lighting, i, &entry, &totals);
            free(entry.places_mm);
        }
    add_totals(lighting, &totals);
    add_hanging(lighting);
    add_places(lighting);
    return LUXEL_OK;
}
