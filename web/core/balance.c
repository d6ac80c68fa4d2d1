/* SPDX-License-Identifier: MIT */
/* The balance of the flux of the present scene, and the mean irradiance of the sides of its surfaces. */
#include "answer.h"
#include "core.h"

static void answer_side(const luxel_balance_side *side)
{
    answer_open('{');
    answer_key("surface");
    answer_number((double)side->surface);
    answer_key("name");
    answer_string(side->surface_name);
    answer_key("part");
    answer_string(side->part_name ? page_translate(side->part_name, NULL) : NULL);
    answer_key("side"); /* walls face the room with their front, which goes without saying */
    answer_string(side->part_name && side->side == LUXEL_SIDE_FRONT
                      ? NULL
                      : page_translate(luxel_surface_side_name(side->side), NULL));
    answer_amount("irradiance", side->irradiance.value, side->irradiance.error);
    answer_close('}');
}

static void answer_balance(const luxel_balance *balance)
{
    answer_open('{');
    answer_key("unit");
    answer_string(page_translate(balance->unit, NULL));
    answer_key("flux_unit");
    answer_string(page_translate(balance->flux_unit, NULL));
    answer_key("sides");
    answer_open('[');
    for (size_t i = 0; i < balance->side_count; i++)
        answer_side(&balance->sides[i]);
    answer_close(']');
    if (balance->has_emitted) {
        answer_amount("emitted", balance->emitted.value, balance->emitted.error);
        answer_amount("missed", balance->missed.value, balance->missed.error);
    }
    answer_amount("arrives", balance->arrives.value, balance->arrives.error);
    answer_amount("absorbed", balance->absorbed.value, balance->absorbed.error);
    answer_amount("escaped", balance->escaped.value, balance->escaped.error);
    if (balance->pending.error > 0)
        answer_amount("pending", balance->pending.value, balance->pending.error);
    answer_amount("difference", balance->difference.value, balance->difference.error);
    answer_key("closes");
    answer_bool(balance->closes);
    answer_close('}');
}

/* The balance, or NULL where the scene has no reflected light, or there is none. */
PAGE_CALLS(page_balance) const char *page_balance(void)
{
    const luxel_settings settings = present_settings();
    luxel_balance *balance = NULL;
    if (!core.scene || luxel_find_balance(core.scene, &settings, fresh_diagnostics(), &balance) != LUXEL_OK || !balance)
        return NULL;
    answer_begin();
    answer_balance(balance);
    luxel_balance_free(balance);
    return answer_text();
}
