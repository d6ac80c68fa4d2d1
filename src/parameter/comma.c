/* SPDX-License-Identifier: MIT */
/* Decimal commas: what may be the whole part of a number, a comma without a blank, and what may be its fraction. */
#include "comma.h"

#include <string.h>

static bool is_whole_part(const struct lx_document *document, lx_node_id id)
{
    const struct lx_node *node = lx_document_node(document, id);
    if (node->kind != LX_SCALAR || !node->plain)
        return false;
    const char *text = lx_document_text(document, id);
    text += *text == '-' || *text == '+';
    return text[0] && !text[strspn(text, "0123456789")];
}

/* Digits, and perhaps an exponent. */
static bool is_fraction(const char *text)
{
    size_t digits = strspn(text, "0123456789");
    const char *rest = text + digits;
    if (*rest == 'e' || *rest == 'E') {
        rest += 1 + (rest[1] == '-' || rest[1] == '+');
        if (!*rest)
            return false;
        rest += strspn(rest, "0123456789");
    }
    return digits > 0 && !*rest;
}

/* Whether a comma is all that stands between the end of a node and a place. */
static bool is_joined(const struct lx_document *document, lx_node_id before, uint32_t source, uint32_t start)
{
    const struct lx_node *node = lx_document_node(document, before);
    const struct lx_place place = lx_document_place(document, before);
    return node->source == source && start == node->end + 1 && node->end < place.length && place.text[node->end] == ',';
}

bool lx_has_decimal_commas(const struct lx_document *document, lx_node_id list, size_t wanted)
{
    size_t found = 0, joined = 0;
    lx_node_id before = 0;
    for (lx_node_id id = lx_document_node(document, list)->first; id; id = lx_document_node(document, id)->next) {
        const struct lx_node *node = lx_document_node(document, id);
        found++;
        bool goes_on = before && node->kind == LX_SCALAR && node->plain && is_whole_part(document, before) &&
                       is_fraction(lx_document_text(document, id)) &&
                       is_joined(document, before, node->source, node->start);
        joined += goes_on;
        before = goes_on ? 0 : id; /* a fraction has none of its own */
    }
    return found > wanted && joined >= found - wanted;
}

bool lx_number_goes_on_in_key(const struct lx_document *document, lx_node_id before, lx_node_id key)
{
    const struct lx_node *node = lx_document_node(document, key);
    return before && lx_document_is_null(document, key) && is_fraction(lx_document_key(document, key)) &&
           is_whole_part(document, before) && is_joined(document, before, node->source, node->key_start);
}
