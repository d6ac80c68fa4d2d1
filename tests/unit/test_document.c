/* SPDX-License-Identifier: MIT */
/* The document tree and its decoding through a table that has a parameter of every type. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "parameter/check.h"
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

struct box {
    uint64_t given;
    double width, height;
    const char *label;
};

/* Exactly one of three keys, and what its table's own functions do. */
struct lid {
    uint64_t given;
    double round, square, oval, hole;
    char *checked;
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
    struct lx_vectors corners;
    struct lx_choice_or_whole parts;
    struct lx_groups boxes;
    struct lid lid;
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

static const struct lx_parameter box_parameters[] = {
    {.name = "width",
     .type = LX_REAL,
     .offset = offsetof(struct box, width),
     .required = true,
     .legal = LX_ABOVE(0),
     .meaning = "width"},
    {.name = "height", .type = LX_REAL, .offset = offsetof(struct box, height), .initial = "3", .meaning = "height"},
    {.name = "label", .type = LX_TEXT, .offset = offsetof(struct box, label), .meaning = "label"},
};
static const struct lx_table box_table = {.parameters = box_parameters, .count = 3, .size = sizeof(struct box)};

/* A lid with a hole as large as a million is wrong, and marked before that. */
static void check_lid(const struct lx_check *check, void *parameters)
{
    struct lid *lid = parameters;
    free(lid->checked);
    lid->checked = lx_copy_text("yes", 3);
    if (lid->hole > 1e6)
        lx_check_report(check, "hole", LX_ALL_OF_IT, LX_MSG_NOT_FLAT, NULL);
}

static void release_lid(void *parameters)
{
    free(((struct lid *)parameters)->checked);
    ((struct lid *)parameters)->checked = NULL;
}

#define LID(member)                                                                                                    \
    {                                                                                                                  \
        .name = #member, .type = LX_REAL, .offset = offsetof(struct lid, member), .meaning = #member                   \
    }
static const struct lx_parameter lid_parameters[] = {LID(round), LID(square), LID(oval), LID(hole)};
static const struct lx_rule lid_rules[] = {{LX_RULE_ONE, "round", NULL, "round|square|oval"}};
static const struct lx_table lid_table = {.parameters = lid_parameters,
                                          .count = 4,
                                          .rules = lid_rules,
                                          .rule_count = 1,
                                          .size = sizeof(struct lid),
                                          .check = check_lid,
                                          .release = release_lid};

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
    {.name = "corners", .type = LX_VECTORS, AT(corners), .count = 2},
    {.name = "parts",
     .type = LX_CHOICE_OR_WHOLE,
     AT(parts),
     .choices = woods,
     .initial = "pine",
     .legal = LX_BETWEEN(2, 9)},
    {.name = "boxes", .type = LX_GROUPS, AT(boxes), .group = &box_table},
    {.name = "lid", .type = LX_GROUP, AT(lid), .group = &lid_table},
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
    assert_int_equal(stock.corners.count, 0);
    assert_int_equal(stock.parts.choice, 1);
    assert_int_equal(stock.boxes.count, 0);
    assert_true(stock.lid.given == 0 && !stock.lid.checked); /* a group that is not there needs nothing */
    clear(&document, &stock);
}

static void decodes_groups_and_vectors(void **state)
{
    (void)state;
    struct lx_document document;
    struct stock stock;
    assert_int_equal(decode("corners: [[1, 2, 3], [4, 5, 6]]\nparts: 7\nlid: {square: 5}\n"
                            "boxes: [{width: 2, label: a}, {width: 4, height: 5}]\n",
                            &document, &stock),
                     LUXEL_OK);
    assert_true(stock.given == 0x1E00);
    assert_int_equal(stock.corners.count, 2);
    assert_true(stock.corners.xyz[0][2] == 3 && stock.corners.xyz[1][0] == 4);
    assert_int_equal(stock.parts.choice, -1);
    assert_int_equal(stock.parts.whole, 7);
    assert_int_equal(stock.boxes.count, 2);
    const struct box *boxes = stock.boxes.items;
    assert_true(boxes[0].width == 2 && boxes[0].height == 3 && boxes[0].given == 5);
    assert_string_equal(boxes[0].label, "a");
    assert_true(boxes[1].width == 4 && boxes[1].height == 5 && boxes[1].given == 3);
    assert_true(stock.lid.given == 2 && stock.lid.square == 5);
    assert_string_equal(stock.lid.checked, "yes");
    clear(&document, &stock);
    assert_int_equal(decode("parts: oak\nboxes: []\n", &document, &stock), LUXEL_OK);
    assert_true(stock.parts.choice == 0 && stock.boxes.count == 0);
    clear(&document, &stock);
}

static void refuses_groups_and_vectors(void **state)
{
    (void)state;
    static const char *const cases[] = {
        "corners: [[1, 2, 3]]",
        "corners: [[1, 2, 3], [4, 5]]",
        "corners: {}",
        "corners: [[1, 2, 3], [4, 5, x]]",
        "corners: [1, 2, 3]",
        "parts: 1",
        "parts: 10",
        "parts: 2.5",
        "parts: ash",
        "parts: [2]",
        "parts: \"7\"",
        "boxes: {width: 1}",
        "boxes: [{}]",
        "boxes: [{width: 0}]",
        "boxes: [{width: 1, depth: 2}]",
        "boxes: [5]",
        "lid: {}",
        "lid: {hole: 1}",
        "lid: {round: 1, oval: 2}",
        "lid: {round: 1, hole: 2e6}",
        "lid: {round: x}",
        "lid: {round: 1, square: 1, oval: 2}",
    };
    for (size_t i = 0; i < LX_COUNT(cases); i++) {
        struct lx_document document;
        struct stock stock;
        if (decode(cases[i], &document, &stock) != LUXEL_ERROR_SCENE || stock.given)
            fail_msg("%s", cases[i]);
        /* what is wrong by itself or by a rule is not checked any further */
        bool checked = stock.lid.checked != NULL;
        assert_true(checked == (strstr(cases[i], "2e6") != NULL));
        clear(&document, &stock);
    }
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
        cmocka_unit_test(sets_defaults),
        cmocka_unit_test(decodes_every_type),
        cmocka_unit_test(decodes_groups_and_vectors),
        cmocka_unit_test(refuses_groups_and_vectors),
        cmocka_unit_test(gives_only_what_is_good),
        cmocka_unit_test(links_and_finds),
        cmocka_unit_test(copies_without_garbage),
        cmocka_unit_test(knows_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
