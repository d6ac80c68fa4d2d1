/* SPDX-License-Identifier: MIT */
/* The document tree and its decoding through a table that has a parameter of every type. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "parameter/decode.h"
#include "scene/yaml.h"
#include "scenes.h"

/* ---- a table with everything ---- */

struct pebble {
    uint64_t given;
    double weight;
};

struct shelf {
    uint64_t given;
    bool open;
    int wood;
};

struct stock {
    uint64_t given;
    double real;
    unsigned whole;
    const char *text;
    double reals[3];
    unsigned wholes[2];
    struct lx_choice_or_pair mixed;
    struct lx_points points;
    struct shelf shelf;
    struct lx_list pebbles;
};

static const char *const woods[] = {"oak", "pine", NULL};

static const struct lx_parameter pebble_parameters[] = {
    {.name = "weight", .type = LX_REAL, .offset = offsetof(struct pebble, weight), .initial = "7", .meaning = "weight"},
};
static const struct lx_table pebble_table = {
    .parameters = pebble_parameters, .count = 1, .size = sizeof(struct pebble)};
static const struct lx_variant flint = {.name = "flint", .meaning = "a flint", .table = &pebble_table};
static const struct lx_variant *const pebbles[] = {&flint, NULL};

static const struct lx_parameter shelf_parameters[] = {
    {.name = "open", .type = LX_BOOLEAN, .offset = offsetof(struct shelf, open), .initial = "true", .meaning = "open"},
    {.name = "wood",
     .type = LX_CHOICE,
     .offset = offsetof(struct shelf, wood),
     .initial = "pine",
     .choices = woods,
     .meaning = "wood"},
};
static const struct lx_table shelf_table = {.parameters = shelf_parameters, .count = 2, .size = sizeof(struct shelf)};

#define AT(member) .offset = offsetof(struct stock, member), .meaning = #member
static const struct lx_parameter stock_parameters[] = {
    {.name = "real", .type = LX_REAL, AT(real), .initial = "-2.5e-3"},
    {.name = "whole", .type = LX_WHOLE, AT(whole), .initial = "12", .legal = LX_BETWEEN(1, 99)},
    {.name = "text", .type = LX_TEXT, AT(text)},
    {.name = "reals", .type = LX_REALS, AT(reals), .count = 3, .initial = "[0, -1.5, 1e3]"},
    {.name = "wholes", .type = LX_WHOLES, AT(wholes), .count = 2},
    {.name = "mixed", .type = LX_CHOICE_OR_PAIR, AT(mixed), .choices = woods, .initial = "pine"},
    {.name = "points", .type = LX_POINTS, AT(points)},
    {.name = "shelf", .type = LX_GROUP, AT(shelf), .group = &shelf_table},
    {.name = "pebbles", .type = LX_VARIANTS, AT(pebbles), .group = &shelf_table, .variants = pebbles},
};
static const struct lx_table stock_table = {
    .parameters = stock_parameters, .count = LX_COUNT(stock_parameters), .size = sizeof(struct stock)};

/* ---- helpers ---- */

static struct lx_document parse(const char *text)
{
    struct lx_document document = {0};
    uint32_t empty;
    assert_int_equal(lx_document_add_text(&document, "", 0, &empty), 0);
    assert_int_equal(lx_document_add_source(&document, "a", lx_copy_text(text, strlen(text)), strlen(text)), 0);
    assert_int_equal(lx_yaml_read(&document, 0, 0, 0, NULL, &document.root), LUXEL_OK);
    return document;
}

static luxel_status decode(const char *text, struct lx_document *document, struct stock *stock)
{
    *document = parse(text);
    struct lx_walk walk = {.document = document};
    return lx_decode(&walk, &stock_table, stock);
}

static void clear(struct lx_document *document, struct stock *stock)
{
    lx_parameters_clear(&stock_table, stock);
    lx_document_clear(document);
}

/* ---- tests ---- */

static void sets_defaults(void **state)
{
    (void)state;
    struct lx_document document;
    struct stock stock;
    assert_int_equal(decode("{}", &document, &stock), LUXEL_OK);
    assert_true(stock.given == 0 && stock.shelf.given == 0);
    assert_true(stock.real == -2.5e-3);
    assert_int_equal(stock.whole, 12);
    assert_null(stock.text);
    assert_true(stock.reals[0] == 0 && stock.reals[1] == -1.5 && stock.reals[2] == 1e3);
    assert_int_equal(stock.mixed.choice, 1);
    assert_int_equal(stock.points.count, 0);
    assert_true(stock.shelf.open);
    assert_int_equal(stock.shelf.wood, 1);
    assert_int_equal(stock.pebbles.count, 0);
    clear(&document, &stock);
}

static void decodes_every_type(void **state)
{
    (void)state;
    struct lx_document document;
    struct stock stock;
    assert_int_equal(decode("real: 1e3\nwhole: +7\ntext: two words\nreals: [1, 2, 3]\nwholes: [4, 5]\nmixed: [-1, 1]\n"
                            "points: [[1, 2], [3, 4]]\nshelf: {open: false}\n"
                            "pebbles: [{type: flint, weight: 3, wood: oak}, {type: flint}]\n",
                            &document, &stock),
                     LUXEL_OK);
    assert_true(stock.given == 0x1FF);
    assert_true(stock.real == 1e3);
    assert_int_equal(stock.whole, 7);
    assert_string_equal(stock.text, "two words");
    assert_true(stock.reals[2] == 3);
    assert_int_equal(stock.wholes[1], 5);
    assert_int_equal(stock.mixed.choice, -1);
    assert_true(stock.mixed.low == -1 && stock.mixed.high == 1);
    assert_int_equal(stock.points.count, 2);
    assert_true(stock.points.xy[1][0] == 3);
    assert_false(stock.shelf.open);
    assert_true(stock.shelf.given == 1);
    assert_int_equal(stock.pebbles.count, 2);
    const struct lx_item *item = &stock.pebbles.items[0];
    assert_true(item->variant == &flint);
    assert_true(((const struct pebble *)item->parameters)->weight == 3);
    assert_int_equal(((const struct shelf *)item->common)->wood, 0);
    assert_true(((const struct shelf *)item->common)->given == 2);
    assert_true(((const struct pebble *)stock.pebbles.items[1].parameters)->weight == 7);
    clear(&document, &stock);
}

static void gives_only_what_is_good(void **state)
{
    (void)state;
    struct lx_document document;
    struct stock stock;
    assert_int_equal(decode("real: x\nwhole: 100\npoints: [[1]]\nshelf: {open: 1, wood: oak}\n"
                            "pebbles: [{type: flint}, {type: flint, weight: x}, {type: clay}]\nreals: [1, 2, 3]\n",
                            &document, &stock),
                     LUXEL_ERROR_SCENE);
    assert_true(stock.given == 8); /* reals alone */
    assert_true(stock.shelf.given == 2);
    assert_int_equal(stock.points.count, 0);
    assert_int_equal(stock.pebbles.count, 3);
    assert_non_null(stock.pebbles.items[0].variant);
    assert_null(stock.pebbles.items[1].variant);
    assert_null(stock.pebbles.items[2].variant);
    clear(&document, &stock);
}

static void links_and_finds(void **state)
{
    (void)state;
    struct lx_document document = parse("a: 1\nb: [10, 20, 30]\nc: {d: ~, e: \"~\"}\n");
    lx_node_id root = document.root, b = lx_document_find(&document, root, "b");
    lx_node_id c = lx_document_find(&document, root, "c");
    assert_int_equal(lx_document_size(&document, root), 3);
    assert_int_equal(lx_document_size(&document, b), 3);
    assert_string_equal(lx_document_text(&document, lx_document_element(&document, b, 2)), "30");
    assert_int_equal(lx_document_element(&document, b, 3), 0);
    assert_int_equal(lx_document_find(&document, b, "a"), 0);
    assert_true(lx_document_is_null(&document, lx_document_find(&document, c, "d")));
    assert_false(lx_document_is_null(&document, lx_document_find(&document, c, "e")));

    struct lx_document_mark mark = lx_document_mark(&document);
    struct lx_node node = *lx_document_node(&document, lx_document_element(&document, b, 0));
    lx_node_id first, second;
    node.next = 0;
    assert_int_equal(lx_document_add_node(&document, node, &first), 0);
    lx_document_rewind(&document, mark);
    assert_int_equal(lx_document_add_node(&document, node, &second), 0);
    assert_int_equal(first, second);
    lx_document_append(&document, b, second);
    assert_int_equal(lx_document_size(&document, b), 4);
    assert_int_equal(lx_document_add_node(&document, node, &first), 0);
    lx_document_replace(&document, b, lx_document_element(&document, b, 1), first);
    assert_string_equal(lx_document_text(&document, lx_document_element(&document, b, 1)), "10");
    assert_int_equal(lx_document_size(&document, b), 4);
    lx_document_clear(&document);
}

static void copies_without_garbage(void **state)
{
    (void)state;
    struct lx_document document = parse("a: 1\nb: [10, 20, 30]\n"), copy;
    lx_node_id a = lx_document_find(&document, document.root, "a"), b = lx_document_find(&document, document.root, "b");
    document.nodes[document.root].first = a; /* b is garbage now */
    document.nodes[a].next = 0;
    assert_int_equal(lx_document_copy(&document, &copy), 0);
    assert_true(b != 0);
    assert_true(lx_document_bytes(&copy) < lx_document_bytes(&document));
    lx_document_clear(&document); /* the copy keeps the source alive */
    assert_int_equal(lx_document_find(&copy, copy.root, "b"), 0);
    a = lx_document_find(&copy, copy.root, "a");
    struct lx_place place = lx_document_place(&copy, a), key = lx_document_key_place(&copy, a);
    assert_int_equal(place.start, 3);
    assert_int_equal(key.end, 1);
    assert_memory_equal(place.text, "a: 1", 4);
    lx_document_clear(&copy);
}

static void knows_places(void **state)
{
    (void)state;
    static const char text[] = "a: \"x\"\nb: [1, {c: 'y'}]\nd:\n  - e: plain words\n  -\n";
    struct lx_document document = parse(text);
    static const struct {
        const char *key, *words;
    } cases[] = {{"a", "\"x\""}, {"b", "[1, {c: 'y'}]"}};
    for (size_t i = 0; i < LX_COUNT(cases); i++) {
        struct lx_place place = lx_document_place(&document, lx_document_find(&document, document.root, cases[i].key));
        assert_int_equal(place.end - place.start, strlen(cases[i].words));
        assert_memory_equal(text + place.start, cases[i].words, strlen(cases[i].words));
    }
    lx_node_id d = lx_document_find(&document, document.root, "d");
    assert_memory_equal(text + lx_document_place(&document, lx_document_element(&document, d, 0)).start, "e: pl", 5);
    assert_memory_equal(text + lx_document_place(&document, lx_document_element(&document, d, 1)).start, "-\n", 2);
    lx_document_clear(&document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sets_defaults),           cmocka_unit_test(decodes_every_type),
        cmocka_unit_test(gives_only_what_is_good), cmocka_unit_test(links_and_finds),
        cmocka_unit_test(copies_without_garbage),  cmocka_unit_test(knows_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
