/* SPDX-License-Identifier: MIT */
/* Asking for values and changing which elements and keys a scene has: in every layout, byte for byte. */
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static luxel_scene *scene_of(const char *text)
{
    luxel_scene *scene = NULL;
    if (luxel_scene_read_text(text, strlen(text), "a.yaml", NULL, &scene) != LUXEL_OK)
        fail_msg("not read: %s", text);
    return scene;
}

static void expect_text(const luxel_scene *scene, const char *expected)
{
    char *text = NULL;
    assert_int_equal(luxel_scene_write_text(scene, &text), LUXEL_OK);
    assert_string_equal(text, expected);
    luxel_text_free(text);
}

/* ---- asking ---- */

static void expect_got(const luxel_scene *scene, const char *key, bool expected_written, const char *expected)
{
    bool written = !expected_written;
    char *text = (char *)key;
    if (luxel_scene_get(scene, key, NULL, &written, &text) != LUXEL_OK)
        fail_msg("not got: %s", key);
    if (expected)
        assert_string_equal(text, expected);
    else
        assert_null(text);
    assert_int_equal(written, expected_written);
    luxel_text_free(text);
}

static void gets_values(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("luxel: 1\nscreen:\n  width: 5e2 # w\nobserver:\npicture:\n  range: [0, 1.50]\n"
                                  "surfaces:\n  - type: sphere\n    name: 'it''s: one'\n    radius: +300\n"
                                  "lights: [{type: planar, vertices: [[0, 0, 1], [1, 0, 1]]}, {type: spot}, {}]\n"
                                  "points: [[1,2]]\n");
    expect_got(scene, "luxel", true, "1");
    expect_got(scene, "screen.width", true, "5e2");
    expect_got(scene, "screen.height", false, NULL);
    expect_got(scene, "screen.sampling", false, "centers");
    expect_got(scene, "screen", true, "{width: 5e2}");
    expect_got(scene, "observer", true, "null");
    expect_got(scene, "observer.view", false, "parallel");
    expect_got(scene, "picture.range", true, "[0, 1.50]");
    expect_got(scene, "picture.range[1]", true, "1.50");
    expect_got(scene, "surfaces[0].name", true, "\"it's: one\"");
    expect_got(scene, "surfaces[0].radius", true, "+300");
    expect_got(scene, "surfaces[0].material", false, NULL);
    expect_got(scene, "surfaces[0].material.diffuse", false, "0.8");
    expect_got(scene, "surfaces[0].material.ambient", false, NULL);
    expect_got(scene, "surfaces", true, "[{type: sphere, name: \"it's: one\", radius: +300}]");
    expect_got(scene, "lights[0].vertices[1]", true, "[1, 0, 1]");
    expect_got(scene, "lights[1].falloff", false, "smoothstep");
    expect_got(scene, "lights[1].type", true, "spot");
    expect_got(scene, "lights[1]", true, "{type: spot}");
    expect_got(scene, "lights[2].type", false, NULL);
    expect_got(scene, "points[0][1]", true, "2");
    expect_got(scene, "grids", false, "[]");
    expect_got(scene, "shadows", false, "all");
    assert_int_equal(luxel_scene_set(scene, "lights[1].outer= 07.50 # degrees", NULL), LUXEL_OK);
    expect_got(scene, "lights[1].outer", true, "07.50");
    expect_got(scene, " lights.1.outer ", true, "07.50");
    char *text = NULL;
    assert_int_equal(luxel_scene_get(scene, "shadows", NULL, NULL, &text), LUXEL_OK);
    luxel_text_free(text);
    assert_int_equal(luxel_scene_get(scene, "shadows", NULL, NULL, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_get(NULL, "shadows", NULL, NULL, &text), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
}

static void tells_sizes(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("luxel: 1\nlights:\nsurfaces: []\npoints: [[0, 0], [1, 1]]\n"
                                  "grids:\n  - n: [1, 2]\n");
    static const struct {
        const char *list;
        size_t size;
    } cases[] = {{"lights", 0}, {"surfaces", 0},   {"points", 2},       {"points[0]", 2},
                 {"grids", 1},  {"grids[0].n", 2}, {"grids[0].size", 0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        size_t size = 99;
        assert_int_equal(luxel_scene_list_size(scene, cases[i].list, NULL, &size), LUXEL_OK);
        assert_int_equal(size, cases[i].size);
    }
    luxel_scene_free(scene);
}

/* ---- changing ---- */

enum step_kind { INSERT, REMOVE, MOVE };

struct element_case {
    const char *text;
    enum step_kind kind;
    const char *key;
    size_t index, to; /* `from` and `to` of a move */
    const char *value, *expected;
};

static luxel_status take_step(luxel_scene *scene, const struct element_case *each, luxel_diagnostics *diagnostics)
{
    switch (each->kind) {
    case INSERT: return luxel_scene_insert(scene, each->key, each->index, each->value, diagnostics);
    case REMOVE: return luxel_scene_remove(scene, each->key, diagnostics);
    default: return luxel_scene_move(scene, each->key, each->index, each->to, diagnostics);
    }
}

static void expect_case(const struct element_case *each)
{
    luxel_scene *scene = scene_of(each->text), *copy;
    if (take_step(scene, each, NULL) != LUXEL_OK)
        fail_msg("%s fails in:\n%s", each->key, each->text);
    expect_text(scene, each->expected);
    copy = luxel_scene_copy(scene);
    luxel_scene_free(scene);
    expect_text(copy, each->expected);
    luxel_scene_free(copy);
}

#define EXPECT_CASES(cases)                                                                                            \
    for (size_t each = 0; each < sizeof(cases) / sizeof(cases)[0]; each++)                                             \
    expect_case(&(cases)[each])

#define IN(text, list, index, value, expected)                                                                         \
    {                                                                                                                  \
        text, INSERT, list, index, 0, value, expected                                                                  \
    }
#define OUT(text, key, expected)                                                                                       \
    {                                                                                                                  \
        text, REMOVE, key, 0, 0, NULL, expected                                                                        \
    }
#define TO(text, list, from, to, expected)                                                                             \
    {                                                                                                                  \
        text, MOVE, list, from, to, NULL, expected                                                                     \
    }

/* Lights on lines, with comments of every kind. */
#define LINES                                                                                                          \
    "luxel: 1\n"                                                                                                       \
    "lights: # all\n"                                                                                                  \
    "  # one\n"                                                                                                        \
    "  - {type: point} # p\n"                                                                                          \
    "\n"                                                                                                               \
    "  # two\n"                                                                                                        \
    "  # and more\n"                                                                                                   \
    "  - type: spot\n"                                                                                                 \
    "    inner: 5 # i\n"                                                                                               \
    "  - {type: ambient}\n"                                                                                            \
    "    # below\n"                                                                                                    \
    "points: []\n"

static void changes_lines(void **state)
{
    (void)state;
    static const struct element_case cases[] = {
        IN(LINES, "lights", 0, "{type: distant}",
           "luxel: 1\nlights: # all\n  - {type: distant}\n  # one\n  - {type: point} # p\n\n  # two\n  # and more\n"
           "  - type: spot\n    inner: 5 # i\n  - {type: ambient}\n    # below\npoints: []\n"),
        IN(LINES, "lights", 1, "type: distant\nname: 'a'\n",
           "luxel: 1\nlights: # all\n  # one\n  - {type: point} # p\n\n  - {type: distant, name: a}\n  # two\n"
           "  # and more\n  - type: spot\n    inner: 5 # i\n  - {type: ambient}\n    # below\npoints: []\n"),
        IN(LINES, "lights", 3, "{type: distant}",
           "luxel: 1\nlights: # all\n  # one\n  - {type: point} # p\n\n  # two\n  # and more\n  - type: spot\n"
           "    inner: 5 # i\n  - {type: ambient}\n  - {type: distant}\n    # below\npoints: []\n"),
        OUT(LINES, "lights[0]",
            "luxel: 1\nlights: # all\n\n  # two\n  # and more\n  - type: spot\n    inner: 5 # i\n"
            "  - {type: ambient}\n    # below\npoints: []\n"),
        OUT(LINES, "lights[1]",
            "luxel: 1\nlights: # all\n  # one\n  - {type: point} # p\n\n  - {type: ambient}\n    # below\npoints: "
            "[]\n"),
        OUT(LINES, "lights[2]",
            "luxel: 1\nlights: # all\n  # one\n  - {type: point} # p\n\n  # two\n  # and more\n  - type: spot\n"
            "    inner: 5 # i\n    # below\npoints: []\n"),
        OUT(LINES, "lights[1].inner",
            "luxel: 1\nlights: # all\n  # one\n  - {type: point} # p\n\n  # two\n  # and more\n  - type: spot\n"
            "  - {type: ambient}\n    # below\npoints: []\n"),
        OUT(LINES, "lights[1].type",
            "luxel: 1\nlights: # all\n  # one\n  - {type: point} # p\n\n  # two\n  # and more\n  - inner: 5 # i\n"
            "  - {type: ambient}\n    # below\npoints: []\n"),
        OUT(LINES, "lights", "luxel: 1\n    # below\npoints: []\n"),
        TO(LINES, "lights", 0, 1,
           "luxel: 1\nlights: # all\n  # two\n  # and more\n  - type: spot\n    inner: 5 # i\n\n  # one\n"
           "  - {type: point} # p\n  - {type: ambient}\n    # below\npoints: []\n"),
        TO(LINES, "lights", 2, 0,
           "luxel: 1\nlights: # all\n  - {type: ambient}\n\n  # one\n  - {type: point} # p\n  # two\n  # and more\n"
           "  - type: spot\n    inner: 5 # i\n    # below\npoints: []\n"),
        TO(LINES, "lights", 0, 2,
           "luxel: 1\nlights: # all\n  # two\n  # and more\n  - type: spot\n    inner: 5 # i\n\n  - {type: ambient}\n"
           "  # one\n  - {type: point} # p\n    # below\npoints: []\n"),
        TO(LINES, "lights", 1, 1, LINES),
        /* other line breaks, indentations and ends */
        IN("lights:\r\n- {type: spot}", "lights", 1, "{}", "lights:\r\n- {type: spot}\r\n- {}"),
        IN("lights:\r\n- {type: spot}", "lights", 0, "{}", "lights:\r\n- {}\r\n- {type: spot}"),
        OUT("lights:\r\n- {type: spot}\r\n- {}", "lights[0]", "lights:\r\n- {}"),
        OUT("lights:\r\n- {type: spot}\r\n- {}", "lights[1]", "lights:\r\n- {type: spot}\r\n"),
        TO("lights:\r\n- {type: spot}\r\n- {}", "lights", 1, 0, "lights:\r\n- {}\r\n- {type: spot}"),
        TO("\xEF\xBB\xBFlights:\n   -\n      type: spot\n   -   type: a\n       name: b\n", "lights", 0, 1,
           "\xEF\xBB\xBFlights:\n   -   type: a\n       name: b\n   -\n      type: spot\n"),
        TO("surfaces:\n- name: |\n    a\n    b\n\n- name: c\n", "surfaces", 1, 0,
           "surfaces:\n- name: c\n\n- name: |\n    a\n    b\n"),
        /* elements without a value */
        OUT("lights:\n  - # a\n  - {} # b\n  -\n", "lights[0]", "lights:\n  - {} # b\n  -\n"),
        OUT("lights:\n  - # a\n  - {} # b\n  -\n", "lights[2]", "lights:\n  - # a\n  - {} # b\n"),
        TO("lights:\n  - # a\n  - {} # b\n  -\n", "lights", 2, 0, "lights:\n  -\n  - # a\n  - {} # b\n"),
        /* lists in lists */
        IN("points:\n- - 1 # x\n  - 2\n", "points[0]", 0, "5", "points:\n- - 5\n  - 1 # x\n  - 2\n"),
        IN("points:\n- - 1 # x\n  - 2\n", "points[0]", 2, "5", "points:\n- - 1 # x\n  - 2\n  - 5\n"),
        IN("points:\n- - 1 # x\n  - 2\n", "points", 1, "[5, 6]", "points:\n- - 1 # x\n  - 2\n- [5, 6]\n"),
        OUT("points:\n- - 1 # x\n  - 2\n", "points[0][0]", "points:\n- - 2\n"),
        OUT("points:\n- - 1 # x\n  - 2\n", "points[0][1]", "points:\n- - 1 # x\n"),
        TO("points:\n- - 1 # x\n  - 2\n", "points[0]", 0, 1, "points:\n- - 2\n  - 1 # x\n"),
        IN("lights:\n  - type: planar\n    vertices:\n      - [0, 0, 1] # a\n      - [1, 0, 1]\n    power: 1\n",
           "lights[0].vertices", 1, "[5,6,7]",
           "lights:\n  - type: planar\n    vertices:\n      - [0, 0, 1] # a\n      - [5, 6, 7]\n      - [1, 0, 1]\n"
           "    power: 1\n"),
        OUT("lights:\n  - type: planar\n    rectangle:\n      center: [0, 0, 1]\n      up: [1, 0, 0]\n",
            "lights[0].rectangle.up", "lights:\n  - type: planar\n    rectangle:\n      center: [0, 0, 1]\n"),
    };
    EXPECT_CASES(cases);
}

static void changes_brackets(void **state)
{
    (void)state;
    static const struct element_case cases[] = {
        IN("points: [[0, 0], [1, 2]] # c\n", "points", 0, "[5,6]", "points: [[5, 6], [0, 0], [1, 2]] # c\n"),
        IN("points: [[0, 0], [1, 2]] # c\n", "points", 1, "[5,6]", "points: [[0, 0], [5, 6], [1, 2]] # c\n"),
        IN("points: [[0, 0], [1, 2]] # c\n", "points", 2, "[5,6]", "points: [[0, 0], [1, 2], [5, 6]] # c\n"),
        IN("points: [[0, 0],]\n", "points", 1, "[5,6]", "points: [[0, 0], [5, 6],]\n"),
        IN("points: [[0,0],[1,2]]\n", "points", 2, "[5,6]", "points: [[0,0],[1,2],[5, 6]]\n"),
        IN("points: [[0, 0],\n         [1, 2]]\n", "points", 2, "[5, 6]",
           "points: [[0, 0],\n         [1, 2],\n         [5, 6]]\n"),
        IN("points: [[0, 0],\n         [1, 2]]\n", "points", 0, "[5, 6]",
           "points: [[5, 6],\n         [0, 0],\n         [1, 2]]\n"),
        OUT("points: [[0, 0], [1, 2], [3, 4]]\n", "points[0]", "points: [[1, 2], [3, 4]]\n"),
        OUT("points: [[0, 0], [1, 2], [3, 4]]\n", "points[1]", "points: [[0, 0], [3, 4]]\n"),
        OUT("points: [[0, 0], [1, 2], [3, 4]]\n", "points[2]", "points: [[0, 0], [1, 2]]\n"),
        OUT("points: [ [0, 0] , [1, 2] , ]\n", "points[1]", "points: [ [0, 0] , ]\n"),
        OUT("points: [[0, 0], # a\n  [1, 2]]\n", "points[0]", "points: [ # a\n  [1, 2]]\n"),
        OUT("points: [[0, 0], # a\n  [1, 2]]\n", "points[1]", "points: [[0, 0] # a\n  ]\n"),
        TO("points: [[0, 0],[1, 2], [3, 4]]\n", "points", 0, 2, "points: [[1, 2],[3, 4], [0, 0]]\n"),
        TO("points: [[0, 0],[1, 2], [3, 4]]\n", "points", 2, 1, "points: [[0, 0],[3, 4], [1, 2]]\n"),
        OUT("screen: {width: 5, height: 6, sampling: nodes}\n", "screen.width",
            "screen: {height: 6, sampling: nodes}\n"),
        OUT("screen: {width: 5, height: 6, sampling: nodes}\n", "screen.height",
            "screen: {width: 5, sampling: nodes}\n"),
        OUT("screen: {width: 5, height: 6, sampling: nodes}\n", "screen.sampling", "screen: {width: 5, height: 6}\n"),
        OUT("screen: {width, height: , sampling: }\n", "screen.height", "screen: {width, sampling: }\n"),
        OUT("lights: [{type: spot, 'name': a}]\n", "lights[0].name", "lights: [{type: spot}]\n"),
        OUT("lights: [type: spot, name: b]\n", "lights[0].type", "lights: [{}, name: b]\n"),
        TO("lights: [type: spot, name: b]\n", "lights", 0, 1, "lights: [name: b, type: spot]\n"),
    };
    EXPECT_CASES(cases);
}

/* Lights in brackets, each on lines of its own. */
#define ROWS                                                                                                           \
    "lights: [ # all\n"                                                                                                \
    "  # one\n"                                                                                                        \
    "  {type: point}, # p\n"                                                                                           \
    "  {type: spot,\n"                                                                                                 \
    "   inner: 5},\n"                                                                                                  \
    "  # three\n"                                                                                                      \
    "  {type: ambient} # a\n"                                                                                          \
    "  ]\n"

static void changes_rows_in_brackets(void **state)
{
    (void)state;
    static const struct element_case cases[] = {
        IN(ROWS, "lights", 0, "{}",
           "lights: [ # all\n  {},\n  # one\n  {type: point}, # p\n  {type: spot,\n   inner: 5},\n  # three\n"
           "  {type: ambient} # a\n  ]\n"),
        IN(ROWS, "lights", 2, "{}",
           "lights: [ # all\n  # one\n  {type: point}, # p\n  {type: spot,\n   inner: 5},\n  {},\n  # three\n"
           "  {type: ambient} # a\n  ]\n"),
        IN(ROWS, "lights", 3, "{}",
           "lights: [ # all\n  # one\n  {type: point}, # p\n  {type: spot,\n   inner: 5},\n  # three\n"
           "  {type: ambient}, # a\n  {}\n  ]\n"),
        OUT(ROWS, "lights[0]",
            "lights: [ # all\n  {type: spot,\n   inner: 5},\n  # three\n  {type: ambient} # a\n  ]\n"),
        OUT(ROWS, "lights[1]",
            "lights: [ # all\n  # one\n  {type: point}, # p\n  # three\n  {type: ambient} # a\n  ]\n"),
        OUT(ROWS, "lights[2]", "lights: [ # all\n  # one\n  {type: point}, # p\n  {type: spot,\n   inner: 5}\n  ]\n"),
        TO(ROWS, "lights", 2, 0,
           "lights: [ # all\n  # three\n  {type: ambient}, # a\n  # one\n  {type: point}, # p\n  {type: spot,\n"
           "   inner: 5}\n  ]\n"),
        TO(ROWS, "lights", 0, 1,
           "lights: [ # all\n  {type: spot,\n   inner: 5},\n  # one\n  {type: point}, # p\n  # three\n"
           "  {type: ambient} # a\n  ]\n"),
        IN("lights: [\n  {},\n  ]\n", "lights", 1, "{type: a}", "lights: [\n  {},\n  {type: a},\n  ]\n"),
    };
    EXPECT_CASES(cases);
}

static void changes_json(void **state)
{
    (void)state;
    static const struct element_case cases[] = {
        IN("{\"points\":[[1,2],[3,4]]}", "points", 1, "[+5, .5]", "{\"points\":[[1,2],[5, 0.5],[3,4]]}"),
        IN("{\"points\":[[1,2],[3,4]]}", "points", 2, "[5, 6]", "{\"points\":[[1,2],[3,4],[5, 6]]}"),
        IN("{\"lights\": []}", "lights", 0, "{type: a}", "{\"lights\": [{\"type\": \"a\"}]}"),
        IN("{\"lights\": [ ]}", "lights", 0, "{type: a}", "{\"lights\": [{\"type\": \"a\"}]}"),
        IN("{\"luxel\": 1}\n", "lights", 0, "type: a", "{\"luxel\": 1, \"lights\": [{\"type\": \"a\"}]}\n"),
        IN("{\n  \"lights\": [\n    {\"type\": \"a\"}\n  ]\n}\n", "lights", 1, "{}",
           "{\n  \"lights\": [\n    {\"type\": \"a\"},\n    {}\n  ]\n}\n"),
        OUT("{\n  \"lights\": [\n    {\"type\": \"a\"},\n    {}\n  ]\n}\n", "lights[1]",
            "{\n  \"lights\": [\n    {\"type\": \"a\"}\n  ]\n}\n"),
        OUT("{\n  \"lights\": [\n    {\"type\": \"a\"}\n  ]\n}\n", "lights[0]", "{\n  \"lights\": []\n}\n"),
        OUT("{\n  \"luxel\": 1,\n  \"units\": \"a\"\n}\n", "units", "{\n  \"luxel\": 1\n}\n"),
        OUT("{\"luxel\": 1}", "luxel", "{}\n"),
        TO("{\"points\":[[1,2],[3,4]]}", "points", 0, 1, "{\"points\":[[3,4],[1,2]]}"),
        IN("{\"lights\":[]}", "lights", 0, "{name: \"\\a\\u00e9\\x7f\\\\\\\"\", enabled: false}",
           "{\"lights\":[{\"name\": \"\\u0007\u00e9\\u007f\\\\\\\"\", \"enabled\": false}]}"),
    };
    EXPECT_CASES(cases);
}

static void fills_and_empties(void **state)
{
    (void)state;
    static const struct element_case cases[] = {
        IN("luxel: 1 # v\n", "lights", 0, "{type: a}", "luxel: 1 # v\nlights:\n  - {type: a}\n"),
        IN("luxel: 1\n", "points", 0, "[1, 2]", "luxel: 1\npoints: [[1, 2]]\n"),
        IN("lights: # none\nluxel: 1\n", "lights", 0, "{type: a}", "lights: # none\n  - {type: a}\nluxel: 1\n"),
        IN("lights: [] # none\nluxel: 1\n", "lights", 0, "{type: a}", "lights: # none\n  - {type: a}\nluxel: 1\n"),
        IN("lights: []\nsurfaces:\n- {}\n", "lights", 0, "{type: a}", "lights:\n- {type: a}\nsurfaces:\n- {}\n"),
        IN("lights: [ # none\n ]\n", "lights", 0, "{type: a}", "lights: [{type: a} # none\n ]\n"),
        IN("{lights: []}\n", "lights", 0, "{type: a}", "{lights: [{type: a}]}\n"),
        IN("lights: [{type: planar}]\n", "lights[0].vertices", 0, "[1, 2, 3]",
           "lights: [{type: planar, vertices: [[1, 2, 3]]}]\n"),
        OUT("lights: # all\n  # one\n  - {type: a} # a\n  # end\n", "lights[0]", "lights: [] # all\n  # end\n"),
        OUT("lights:\n- {type: a}\nluxel: 1\n", "lights[0]", "lights: []\nluxel: 1\n"),
        OUT("lights: [ {type: a} ] # c\n", "lights[0]", "lights: [] # c\n"),
        OUT("points:\n- - 1\n", "points[0][0]", "points:\n- []\n"),
        OUT("picture:\n  range: max\n", "picture.range", "picture: {}\n"),
        OUT("picture: {range: max}\n", "picture.range", "picture: {}\n"),
        OUT("lights:\n  - name: a\n", "lights[0].name", "lights:\n  - {}\n"),
        OUT("# top\nluxel: 1\n# u\nunits: x # y\n# end\n", "units", "# top\nluxel: 1\n# end\n"),
        OUT("# top\nluxel: 1\n# u\nunits: x # y\n", "luxel", "# top\n# u\nunits: x # y\n"),
        OUT("luxel: 1\n", "luxel", "{}\n"),
        OUT("luxel: 1\n", "units", "luxel: 1\n"),
    };
    EXPECT_CASES(cases);
}

/* Where patches would say something else the list is written in brackets, or at the top the whole anew. */
static void writes_odd_texts_anew(void **state)
{
    (void)state;
    static const struct element_case cases[] = {
        TO("surfaces:\n- name: |+\n    a\n\n- name: c\n\nluxel: 1\n", "surfaces", 0, 1,
           "surfaces: [{name: c}, {name: \"a\\n\\n\"}]\n\nluxel: 1\n"),
        OUT("lights:\n  - ? type\n    : a\n    ? name\n    : b\n", "lights[0].name", "lights:\n  - {type: a}\n"),
        OUT("? luxel\n: 1\n? units\n: x\n", "luxel", "? units\n: x\n"),
        OUT("? luxel\n: 1\n? units\n: x\n", "units", "luxel: 1\n"),
    };
    EXPECT_CASES(cases);
}

static void refuses(void **state)
{
    (void)state;
    static const struct {
        struct element_case step;
        luxel_status status;
        const char *id, *source, *message;
    } cases[] = {
        {IN("", "lights", 2, "{}", ""), LUXEL_ERROR_PATH, "no-such-element", "key", "1 element, lights[0]"},
        {IN("", "grids", 1, "{}", ""), LUXEL_ERROR_PATH, "no-such-element", "key", "grids has no elements"},
        {IN("", "light", 0, "{}", ""), LUXEL_ERROR_PATH, "unknown-key", "key", "light"},
        {IN("", "lights[0]", 0, "{}", ""), LUXEL_ERROR_PATH, "not-a-list", "key", "lights[0] is not"},
        {IN("", "screen", 0, "{}", ""), LUXEL_ERROR_PATH, "not-a-list", "key", "screen"},
        {IN("", "screen.width", 0, "{}", ""), LUXEL_ERROR_PATH, "not-a-list", "key", "screen.width"},
        {IN("", "picture.range", 0, "1", ""), LUXEL_ERROR_PATH, "no-list-here", "key", "picture.range"},
        {IN("", "lights", 0, "", ""), LUXEL_ERROR_SCENE, "no-value", "value", "lights"},
        {IN("", "lights", 0, " # none", ""), LUXEL_ERROR_SCENE, "no-value", "value", "lights"},
        {IN("", "lights", 0, "{type: ", ""), LUXEL_ERROR_SCENE, "not-closed", "value", ""},
        {IN("", "lights", 0, "&a {}", ""), LUXEL_ERROR_SCENE, "no-anchors", "value", ""},
        {OUT("", "lights[1]", ""), LUXEL_ERROR_PATH, "no-such-element", "key", "1 element"},
        {OUT("", "grids[0]", ""), LUXEL_ERROR_PATH, "list-not-written", "key", "grids"},
        {OUT("", "lights[0].nme", ""), LUXEL_ERROR_PATH, "unknown-key", "key", "nme"},
        {TO("", "points", 0, 2, ""), LUXEL_ERROR_PATH, "no-such-element", "key", "points[0] to points[1]"},
        {TO("", "points", 2, 0, ""), LUXEL_ERROR_PATH, "no-such-element", "key", "points[0] to points[1]"},
        {TO("", "points[", 2, 0, ""), LUXEL_ERROR_PATH, "path-syntax", "key", ""},
    };
    luxel_scene *scene;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(take_step(scene, &cases[i].step, diagnostics), cases[i].status);
        expect_entry(diagnostics, 0, WANTED(cases[i].id, .message = cases[i].message));
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->source, cases[i].source);
        luxel_diagnostics_free(diagnostics);
        assert_true(luxel_scene_is_committed(scene)); /* nothing happened */
    }
    expect_text(scene, good_scene);
    assert_int_equal(luxel_scene_insert(scene, NULL, 0, "{}", NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_remove(NULL, "lights[0]", NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_move(scene, NULL, 0, 1, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_list_size(scene, "lights", NULL, NULL), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
}

/* Values set before an edit are in it, values set behind it find their place, and reports tell its lines. */
static void goes_with_assignments(void **state)
{
    (void)state;
    luxel_scene *scene;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "lights[0].name=lamp", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_insert(scene, "lights", 0, "{type: ambient, irradiance: -1}", NULL), LUXEL_OK);
    assert_false(luxel_scene_is_committed(scene));
    assert_int_equal(luxel_scene_commit(scene, diagnostics), LUXEL_ERROR_SCENE);
    expect_entry(diagnostics, 0, WANTED("out-of-range", 11, 33, "lights[0].irradiance", "", ""));
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->source, "test.yaml");
    assert_int_equal(luxel_scene_set(scene, "lights[0].irradiance=2", NULL), LUXEL_OK);
    expect_got(scene, "lights[1].name", true, "lamp");
    assert_int_equal(luxel_scene_move(scene, "lights", 1, 0, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    char *expected =
        changed("attenuation: none}\n", "attenuation: none, name: lamp}\n  - {type: ambient, irradiance: 2}\n");
    expect_text(scene, expected);
    free(expected);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gets_values),
        cmocka_unit_test(tells_sizes),
        cmocka_unit_test(changes_lines),
        cmocka_unit_test(changes_brackets),
        cmocka_unit_test(changes_rows_in_brackets),
        cmocka_unit_test(changes_json),
        cmocka_unit_test(fills_and_empties),
        cmocka_unit_test(writes_odd_texts_anew),
        cmocka_unit_test(refuses),
        cmocka_unit_test(goes_with_assignments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
