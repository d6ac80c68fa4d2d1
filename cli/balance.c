/* SPDX-License-Identifier: MIT */
/* The light on surfaces: a table with the means of their sides, and what becomes of the flux. */
#include "balance.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "text.h"

/* ---- text ---- */

/* "surfaces[1] ball, outside", "surfaces[0] room, floor"; the back of a wall is told, too. */
static const char *name_side(const luxel_balance_side *side, char buffer[TEXT_SIZE])
{
    char *name = side->surface_name ? luxel_escaped_text(side->surface_name) : NULL;
    const bool is_inner_wall = side->part_name && side->side == LUXEL_SIDE_FRONT;

    text_format(buffer, "surfaces[%zu]%s%s%s%s%s%s", side->surface, name ? " " : "", name ? name : "",
                side->part_name ? ", " : "", side->part_name ? side->part_name : "", is_inner_wall ? "" : ", ",
                is_inner_wall ? "" : _(luxel_surface_side_name(side->side)));
    luxel_text_free(name);
    return buffer;
}

/* "208.334 ± 8.5e-02": no digits beyond those of the bound, so that what is 0 within it is 0. */
static const char *write_cell(const luxel_bounded *amount, char buffer[TEXT_SIZE])
{
    return text_value_bound(buffer, 7, amount->value, amount->error);
}

static void add_side(struct text_table *table, const luxel_balance_side *side)
{
    char name[TEXT_SIZE], area[TEXT_SIZE], reflectance[TEXT_SIZE], direct[TEXT_SIZE], all[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(name_side(side, name), text_format(area, "%.4g", side->area_m2),
                                     text_format(reflectance, "%.3g", side->reflectance),
                                     write_cell(&side->direct, direct), write_cell(&side->irradiance, all)));
}

static void print_sides(const luxel_balance *balance)
{
    struct text_table *table = text_table_new("lrrrr");
    char direct[TEXT_SIZE], all[TEXT_SIZE];

    text_table_row(table,
                   TEXT_CELLS("", _("area, m²"), _("reflects"), text_format(direct, _("direct, %s"), _(balance->unit)),
                              text_format(all, _("all light, %s"), _(balance->unit))));
    for (size_t i = 0; i < balance->side_count; i++)
        add_side(table, &balance->sides[i]);
    text_table_print(table, stdout, 2);
}

static void add_flux(struct text_table *table, const char *name, const luxel_bounded *flux)
{
    char cell[TEXT_SIZE];

    text_table_row(table, TEXT_CELLS(name, write_cell(flux, cell)));
}

static void print_fluxes(const luxel_balance *balance)
{
    struct text_table *table = text_table_new("lr");

    if (balance->has_emitted) {
        add_flux(table, _("given off by the sources"), &balance->emitted);
        add_flux(table, _("of that meets no surface"), &balance->missed);
    }
    add_flux(table, _("arrives at surfaces directly"), &balance->arrives);
    add_flux(table, _("absorbed by surfaces"), &balance->absorbed);
    add_flux(table, _("escapes after reflections"), &balance->escaped);
    if (balance->pending.error > 0)
        add_flux(table, _("reflected after the last bounce"), &balance->pending);
    add_flux(table, _("difference, in truth 0"), &balance->difference);
    text_table_print(table, stdout, 2);
}

void balance_print(const luxel_balance *balance)
{
    printf(strcmp(balance->flux_unit, "lm") == 0 ? _("\nMean illuminance of the surfaces:\n\n")
                                                 : _("\nMean irradiance of the surfaces:\n\n"));
    print_sides(balance);
    printf(_("\nBalance of the flux, in %s:\n\n"), _(balance->flux_unit));
    print_fluxes(balance);
    printf(balance->closes ? _("  It closes within its bounds.\n")
                           : _("  It does not close within its bounds: some number above is wrong.\n"));
}

/* ---- JSON ---- */

static void write_amount(struct json *json, const char *key, const luxel_bounded *amount)
{
    json_open(json, key, '{');
    json_number(json, "value", amount->value);
    json_number(json, "error", amount->error);
    json_close(json, '}');
}

static void write_side(struct json *json, const luxel_balance_side *side)
{
    json_open(json, NULL, '{');
    json_whole(json, "surface", side->surface);
    json_text(json, "name", side->surface_name);
    if (side->part_name)
        json_text(json, "wall", side->part_name);
    json_text(json, "side", luxel_surface_side_name(side->side));
    json_number(json, "area", side->area_m2);
    json_number(json, "reflectance", side->reflectance);
    write_amount(json, "direct", &side->direct);
    write_amount(json, "irradiance", &side->irradiance);
    json_close(json, '}');
}

void balance_write(struct json *json, const luxel_balance *balance)
{
    json_open(json, "surfaces", '[');
    for (size_t i = 0; i < balance->side_count; i++)
        write_side(json, &balance->sides[i]);
    json_close(json, ']');
    json_open(json, "balance", '{');
    json_text(json, "unit", balance->flux_unit);
    if (balance->has_emitted) {
        write_amount(json, "emitted", &balance->emitted);
        write_amount(json, "missed", &balance->missed);
    } else {
        json_null(json, "emitted");
        json_null(json, "missed");
    }
    write_amount(json, "arrives", &balance->arrives);
    write_amount(json, "absorbed", &balance->absorbed);
    write_amount(json, "escaped", &balance->escaped);
    write_amount(json, "pending", &balance->pending);
    write_amount(json, "difference", &balance->difference);
    json_bool(json, "closes", balance->closes);
    json_close(json, '}');
}
