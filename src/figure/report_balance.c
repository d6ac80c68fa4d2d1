/* SPDX-License-Identifier: MIT */
/* The section of a report about reflected light: the mean irradiance of the surfaces, and where the light stays. */
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "report.h"

enum { CELL = 2 * LX_NUMBER_SIZE + 8 };

/* "208.3341 ± 0.085" */
static const char *write_amount(const struct lx_report *report, const luxel_bounded *amount, char cell[CELL])
{
    char value[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE];
    lx_report_bounded(report, amount->value, amount->error, LX_REPORT_DIGITS, value);
    snprintf(cell, CELL, "%s ± %s", value,
             lx_write_bound(lx_error_of_shown(value, amount->value, amount->error), 2, error));
    return cell;
}

/* "table, front", "room, floor", "surfaces[1], outside" */
static void name_side(const struct lx_report *report, const luxel_balance_side *side, struct lx_text *name)
{
    if (side->surface_name)
        lx_text_puts(name, side->surface_name);
    else
        lx_text_printf(name, "surfaces[%zu]", side->surface);
    if (side->part_name)
        lx_text_printf(name, ", %s", side->part_name);
    if (!side->part_name || side->side != LUXEL_SIDE_FRONT)
        lx_text_printf(name, ", %s", lx_document_word(report->document, luxel_surface_side_name(side->side)));
}

static void add_side(const struct lx_report *report, const luxel_balance_side *side)
{
    struct lx_text name = {0};
    char direct[CELL], all[CELL];
    name_side(report, side, &name);
    lx_document_row(report->document,
                    LX_SPANS(LX_PLAIN(name.bytes), LX_PLAIN(write_amount(report, &side->direct, direct)),
                             LX_PLAIN(write_amount(report, &side->irradiance, all))),
                    false);
    lx_text_clear(&name);
}

static void add_flux(const struct lx_report *report, const char *english, const luxel_bounded *flux)
{
    char cell[CELL];
    lx_document_row(report->document, LX_SPANS(LX_TERM_SPAN(english), LX_PLAIN(write_amount(report, flux, cell))),
                    false);
}

static void add_fluxes(const struct lx_report *report)
{
    const luxel_balance *balance = report->balance;
    lx_document_paragraph(
        report->document,
        LX_N("The balance of the flux in {0}: what arrives at surfaces is absorbed by them or escapes, "
             "within the bounds of the calculation."),
        LX_SPANS(LX_PLAIN(lx_document_word(report->document, balance->flux_unit))));
    lx_document_table(report->document, "lr");
    lx_document_name_table(report->document, "balance", 0);
    lx_document_row(report->document, LX_SPANS(LX_TERM_SPAN(LX_N("flux")), LX_TERM_SPAN(balance->flux_unit)), false);
    if (balance->has_emitted) {
        add_flux(report, LX_N("given off by the sources"), &balance->emitted);
        add_flux(report, LX_N("of that meets no surface"), &balance->missed);
    }
    add_flux(report, LX_N("arrives at surfaces directly"), &balance->arrives);
    add_flux(report, LX_N("absorbed by surfaces"), &balance->absorbed);
    add_flux(report, LX_N("escapes after reflections"), &balance->escaped);
    if (balance->pending.error > 0)
        add_flux(report, LX_N("reflected after the last bounce"), &balance->pending);
    add_flux(report, LX_N("difference, in truth 0"), &balance->difference);
}

void lx_report_balance(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    const luxel_balance *balance = report->balance;
    if (!balance)
        return;
    lx_document_heading(document, 2, LX_N("Light on the surfaces"), NULL);
    lx_document_paragraph(
        document,
        strcmp(balance->flux_unit, "lm") == 0
            ? LX_N(
                  "The mean illuminance of each side that light reaches, in {0}: by light that comes from the sources, "
                  "and by all light, with what surfaces reflect to each other. Bounds of the errors follow after ±.")
            : LX_N("The mean irradiance of each side that light reaches, in {0}: by light that comes from the sources, "
                   "and by all light, with what surfaces reflect to each other. Bounds of the errors follow after ±."),
        LX_SPANS(LX_PLAIN(lx_document_word(document, balance->unit))));
    lx_document_table(document, "lrr");
    lx_document_name_table(document, "surfaces", 0);
    lx_document_row(document, LX_SPANS(LX_PLAIN(""), LX_TERM_SPAN(LX_N("direct")), LX_TERM_SPAN(LX_N("all light"))),
                    false);
    for (size_t i = 0; i < balance->side_count; i++)
        add_side(report, &balance->sides[i]);
    add_fluxes(report);
}
