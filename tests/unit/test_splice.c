/* SPDX-License-Identifier: MIT */
/* Changed scenes as text: byte for byte what was read, but for the values that were changed. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/object.h"
#include "scene/splice.h"
#include "scenes.h"

enum { MOST_SETS = 6 };

struct splice_case {
    const char *text, *sets[MOST_SETS], *expected;
};

/* What the splicer makes of the text, and not what is written anew where it gives up. */
static void expect_spliced(const luxel_scene *scene, const char *expected)
{
    const struct lx_document *document = &scene->document;
    struct lx_place place = lx_document_place(document, document->root);
    struct lx_text text = {0};
    bool json;
    char *written = NULL;
    assert_int_equal(lx_splice(document, document->root, place.text, place.length, &text, &json), LX_SPLICED);
    assert_string_equal(text.bytes, expected);
    lx_text_clear(&text);
    assert_int_equal(luxel_scene_write_text(scene, &written), LUXEL_OK);
    assert_string_equal(written, expected);
    luxel_text_free(written);
}

static void expect_case(const struct splice_case *each)
{
    luxel_scene *scene = NULL, *copy;
    if (luxel_scene_read_text(each->text, strlen(each->text), "a", NULL, &scene) != LUXEL_OK)
        fail_msg("not read: %s", each->text);
    expect_spliced(scene, each->text);
    for (size_t i = 0; i < MOST_SETS && each->sets[i]; i++)
        if (luxel_scene_set(scene, each->sets[i], NULL) != LUXEL_OK)
            fail_msg("not set: %s", each->sets[i]);
    expect_spliced(scene, each->expected);
    copy = luxel_scene_copy(scene);
    luxel_scene_free(scene);
    expect_spliced(copy, each->expected);
    luxel_scene_free(copy);
}

#define EXPECT_CASES(cases)                                                                                            \
    for (size_t each = 0; each < sizeof(cases) / sizeof(cases)[0]; each++)                                             \
    expect_case(&(cases)[each])

static void replaces_values(void **state)
{
    (void)state;
    static const struct splice_case cases[] = {
        {"shadows: none\n", {"shadows=points"}, "shadows: points\n"},
        {"shadows:   none   # why\n\n\n", {"shadows=points"}, "shadows:   points   # why\n\n\n"},
        {"shadows: none", {"shadows=points"}, "shadows: points"},
        {"shadows: none", {"shadows= points # because"}, "shadows: points"},
        {"shadows: 'none'\n", {"shadows=\"points\""}, "shadows: \"points\"\n"},
        {"shadows: \"none\" # q\n", {"shadows=none"}, "shadows: \"none\" # q\n"}, /* no change in value */
        {"shadows: none # q\n", {"shadows=points", "shadows=none"}, "shadows: none # q\n"},
        {"observer: {z: 1.50}\n", {"observer.z=1.5"}, "observer: {z: 1.5}\n"},
        {"observer: {z: 1.50}\n", {"observer.z=1.50"}, "observer: {z: 1.50}\n"},
        {"shadows: >-\n  none\n\n# c\nunits: |\n  x\n",
         {"shadows=points", "units=y"},
         "shadows: points\n\n# c\nunits: y\n"},
        {"shadows: several\n  words\n  here # c\n", {"shadows=none"}, "shadows: none # c\n"},
        {"shadows:\n  none\n", {"shadows=points"}, "shadows:\n  points\n"},
        {"shadows: # c\n  # d\n  none # e\n", {"shadows=points"}, "shadows: # c\n  # d\n  points # e\n"},
        {"shadows:\n", {"shadows=none"}, "shadows: none\n"},
        {"shadows:", {"shadows=none"}, "shadows: none"},
        /* values of several lines, and blocks, become one line wherever they go */
        {"units: x\n", {"units=one\n  two"}, "units: one two\n"},
        {"units: x\n", {"units=\"one\n  two\""}, "units: one two\n"},
        {"units: x\n", {"units='one\n\n  two'"}, "units: \"one\\ntwo\"\n"},
        {"units: x\n", {"units=|\n  one\n  two"}, "units: \"one\\ntwo\\n\"\n"},
        {"units: x\n", {"units=|-\n  one"}, "units: one\n"},
        {"{units: x, shadows: y}\n", {"units=>-\n  one\n  two"}, "{units: one two, shadows: y}\n"},
        {"shadows:  # c\nunits: x\n", {"shadows=none"}, "shadows: none  # c\nunits: x\n"},
        {"? shadows\n: none\n", {"shadows=points"}, "? shadows\n: points\n"},
        {"shadows : none\n", {"shadows=points"}, "shadows : points\n"},
        {"screen: {width: 5, height: 6}\n", {"screen.height=7"}, "screen: {width: 5, height: 7}\n"},
        {"screen: {width, height: , units:}\n",
         {"screen.width=1", "screen.height=2"},
         "screen: {width: 1, height: 2 , units:}\n"},
        {"screen: {resolution:[1,2]}\n", {"screen.resolution=3"}, "screen: {resolution: 3}\n"},
        {"points: [[0, 0], [1, 2]]\n", {"points[1][0]=-7.5"}, "points: [[0, 0], [-7.5, 2]]\n"},
        {"points:\n- - 1 # x\n  - 2\n-  [3,4]\n",
         {"points[0][0]=5", "points[1][1]=6"},
         "points:\n- - 5 # x\n  - 2\n-  [3,6]\n"},
        {"points:\n  -\n    - 1\n    - 2\n", {"points[0]=[3, 4]"}, "points:\n  - [3, 4]\n"},
        {"points:\n  - \n  - [1, 2] # - a\n  - # - b\n",
         {"points[0]=[3, 4]", "points[2]=[5, 6]"},
         "points:\n  - [3, 4] \n  - [1, 2] # - a\n  - [5, 6] # - b\n"},
        {"surfaces:\n  - name: ball\n    # tail\n",
         {"surfaces[0].name=a, b"},
         "surfaces:\n  - name: a, b\n    # tail\n"},
        {"surfaces: [{name: ball}]\n", {"surfaces[0].name=a, b"}, "surfaces: [{name: \"a, b\"}]\n"},
        {"surfaces: [{name: ball}]\n", {"surfaces[0].name=x*y"}, "surfaces: [{name: \"x*y\"}]\n"},
        {"surfaces: [{name: ball}]\n", {"surfaces[0].name='it''s'"}, "surfaces: [{name: 'it''s'}]\n"},
        {"surfaces: [{name: ball}]\n", {"surfaces[0].name=шар № 5"}, "surfaces: [{name: шар № 5}]\n"},
    };
    EXPECT_CASES(cases);
}

static void replaces_lists(void **state)
{
    (void)state;
    static const struct splice_case cases[] = {
        {"lights: []\n# c\n", {"lights=[{type: ambient}]"}, "lights: [{type: ambient}]\n# c\n"},
        {"lights:\n  # first\n  - {type: point}\n  - {type: spot}\n\n# next\npoints: []\n",
         {"lights=[]"},
         "lights: []\n  # first\n\n# next\npoints: []\n"},
        {"lights: # all\n- {type: point}\n- {type: spot} # last\npoints: []\n",
         {"lights=[]"},
         "lights: [] # all\n# last\npoints: []\n"},
        {"lights:\n  - type: point\n    name: a # a\n  # two\n  - type: spot # s\n    inner: 4\n# end\n",
         {"lights[0]={type: ambient}", "lights[1].inner=5"},
         "lights:\n  - {type: ambient} # a\n  # two\n  - type: spot # s\n    inner: 5\n# end\n"},
        {"lights:\n  - {type: point}\n",
         {"lights[0]={type: spot, inner: 1}", "lights[0].inner=2", "lights[0].outer=3"},
         "lights:\n  - {type: spot, inner: 2, outer: 3}\n"},
        {"lights: []\n",
         {"lights=- {type: spot}\n- type: point\n  position: [0,\n   1, 2]\n"},
         "lights: [{type: spot}, {type: point, position: [0, 1, 2]}]\n"},
        {"lights: []\n", {"lights=- {type: spot}", "lights[0].inner=5"}, "lights: [{type: spot, inner: 5}]\n"},
        {"lights: []\n",
         {"lights=[\n  {type: spot}, # one\n  {type: point}\n ]"},
         "lights: [\n  {type: spot}, # one\n  {type: point}\n ]\n"},
        {"lights: []\n", {"lights=[\n  {type: spot},\n]"}, "lights: [\n    {type: spot},\n  ]\n"},
        {"observer: {z: 5} # c\n",
         {"observer=z: 6\nview: observer", "observer.projection=perspective"},
         "observer: {z: 6, view: observer, projection: perspective} # c\n"},
        {"observer:\n  z: 5 # five\n  view: observer # c\nunits: x\n",
         {"observer={z: 6}"},
         "observer: {z: 6}\n  # c\nunits: x\n"},
        {"lights: [type: spot]\n", {"lights[0].inner=5"}, "lights: [{type: spot, inner: 5}]\n"},
        {"lights: [ type: spot , {type: point}]\n",
         {"lights[0]={type: point}"},
         "lights: [ {type: point} , {type: point}]\n"},
    };
    EXPECT_CASES(cases);
}

static void adds_keys(void **state)
{
    (void)state;
    static const struct splice_case cases[] = {
        {"luxel: 1\n", {"shadows=none", "units=photometric"}, "luxel: 1\nshadows: none\nunits: photometric\n"},
        {"luxel: 1", {"shadows=none"}, "luxel: 1\nshadows: none"},
        {"# a\n\nluxel: 1 # one\n\n# tail\n", {"shadows=none"}, "# a\n\nluxel: 1 # one\nshadows: none\n\n# tail\n"},
        {"--- # a\nluxel: 1\n...\n# b\n", {"shadows=none"}, "--- # a\nluxel: 1\nshadows: none\n...\n# b\n"},
        {"surfaces:\n- type: sphere\n  radius: 5 # r\n\n# lights\nlights: []\n",
         {"surfaces[0].name=ball", "surfaces[0].material.shininess=60", "surfaces[0].material.model=phong"},
         "surfaces:\n- type: sphere\n  radius: 5 # r\n  name: ball\n  material: {shininess: 60, model: phong}\n"
         "\n# lights\nlights: []\n"},
        {"observer:\n    z: 5\n    # tail\nlights:\n  - type: spot\n    # in\n",
         {"observer.view=parallel", "lights[0].k=1"},
         "observer:\n    z: 5\n    view: parallel\n    # tail\nlights:\n  - type: spot\n    k: 1\n    # in\n"},
        {"shadows: |\n  a\n\n\n# c\n", {"units=x"}, "shadows: |\n  a\nunits: x\n\n\n# c\n"},
        {"shadows: |+\n  a\n\n\n", {"units=x"}, "shadows: |+\n  a\n\n\nunits: x\n"},
        {"screen:\n  width:\n", {"screen.height=2", "screen.width=1"}, "screen:\n  width: 1\n  height: 2\n"},
        {"screen:   # c\nlights:\n",
         {"screen.width=1", "screen.height=2"},
         "screen: {width: 1, height: 2}   # c\nlights:\n"},
        {"screen: {}\n", {"screen.width=1", "screen.height=2"}, "screen: {width: 1, height: 2}\n"},
        {"screen: { }\n", {"screen.width=1"}, "screen: { width: 1 }\n"},
        {"screen: { # c\n  }\n", {"screen.width=1"}, "screen: {width: 1 # c\n  }\n"},
        {"screen: {width: 1}\n",
         {"screen.height=2", "screen.sampling=nodes"},
         "screen: {width: 1, height: 2, sampling: nodes}\n"},
        {"screen: { width: 1, }\n", {"screen.height=2"}, "screen: { width: 1, height: 2, }\n"},
        {"screen: {width}\n", {"screen.height=2"}, "screen: {width, height: 2}\n"},
        {"screen: {width: 1,\n         height: 2} # c\n",
         {"screen.sampling=nodes"},
         "screen: {width: 1,\n         height: 2, sampling: nodes} # c\n"},
        {"screen: {\n  width: 1, # w\n  height: 2 # h\n  }\n",
         {"screen.sampling=nodes", "screen.height=3"},
         "screen: {\n  width: 1, # w\n  height: 3, # h\n  sampling: nodes\n  }\n"},
        {"screen: {\n  width: 1,\n  height: 2, # h\n  }\n",
         {"screen.sampling=nodes"},
         "screen: {\n  width: 1,\n  height: 2, # h\n  sampling: nodes,\n  }\n"},
        {"screen: {'width': 1}\n", {"screen.height=2"}, "screen: {'width': 1, 'height': 2}\n"},
        {"{}", {"screen.width=1"}, "{\"screen\": {\"width\": 1}}"},
    };
    EXPECT_CASES(cases);
}

static void writes_json_as_json(void **state)
{
    (void)state;
    static const struct splice_case cases[] = {
        {"{\"shadows\":\"none\"}", {"shadows=points"}, "{\"shadows\":\"points\"}"},
        {"{\"shadows\": \"none\"}\n", {"shadows=none"}, "{\"shadows\": \"none\"}\n"},
        {"{\"observer\":{\"z\":5}}",
         {"observer.z=+.5", "observer.view=parallel", "shadows=none"},
         "{\"observer\":{\"z\":0.5,\"view\":\"parallel\"},\"shadows\":\"none\"}"},
        {"{\"points\": [[1, 2]]}\n",
         {"points=[[007, -1.], [1e3, -.5e-2], [+1, 0]]"},
         "{\"points\": [[7, -1.0], [1e3, -0.5e-2], [1, 0]]}\n"},
        {"{\"points\": [[1, 2]]}\n", {"points=[[1,2],\n [3,4]]"}, "{\"points\": [[1,2],\n [3,4]]}\n"},
        {"{\n  \"lights\": [\n    {\n      \"type\": \"spot\"\n    }\n  ]\n}\n",
         {"lights[0].inner=5", "lights[0].enabled=True", "lights[0].name=it's \"a\"\n  b\\c", "observer={z: 5}"},
         "{\n  \"lights\": [\n    {\n      \"type\": \"spot\",\n      \"inner\": 5,\n      \"enabled\": true,\n"
         "      \"name\": \"it's \\\"a\\\" b\\\\c\"\n    }\n  ],\n  \"observer\": {\"z\": 5}\n}\n"},
        {"{\"lights\": [{}, {}]}\n",
         {"lights[0].name=\"\\u0041\\n\\\"\"", "lights[1]={\"name\": \"\\/\\u00e9\", \"k\": null}"},
         "{\"lights\": [{\"name\": \"\\u0041\\n\\\"\"}, {\"name\": \"\\/\\u00e9\", \"k\": null}]}\n"},
        {"{\"lights\": [{}]}\n",
         {"lights[0]={\"name\": \"\\a\\x41\\u0042\", \"enabled\": false, \"k\": 01}"},
         "{\"lights\": [{\"name\": \"\\u0007AB\", \"enabled\": false, \"k\": 1}]}\n"},
        {"{\"lights\": [{}, {}]}\n",
         {"lights[0].type=spot", "lights[1]={type: \"point\"}", "lights[1].k=~"},
         "{\"lights\": [{\"type\": \"spot\"}, {\"type\": \"point\", \"k\": null}]}\n"},
        {"{\"a\": 1, # c\n \"shadows\": \"none\"}\n",
         {"units='x'"},
         "{\"a\": 1, # c\n \"shadows\": \"none\", \"units\": \"x\"}\n"},
    };
    EXPECT_CASES(cases);
}

static void keeps_bytes(void **state)
{
    (void)state;
    static const struct splice_case cases[] = {
        {"\xEF\xBB\xBF# ж\r\nluxel: 1\t# \xE2\x80\xA8 tab\r\n\r\nscreen:\r\n  width: 5\r\n\r\n# end",
         {"screen.width=6", "screen.height=7", "shadows=none"},
         "\xEF\xBB\xBF# ж\r\nluxel: 1\t# \xE2\x80\xA8 tab\r\n\r\nscreen:\r\n  width: 6\r\n  height: 7\r\n"
         "shadows: none\r\n\r\n# end"},
        {"\xEF\xBB\xBFluxel: 1\n", {"shadows=none"}, "\xEF\xBB\xBFluxel: 1\nshadows: none\n"},
        {"lights:\r\n  - {type: spot}\r\n  - {type: spot}\r\npoints: []\r\n",
         {"lights=[]"},
         "lights: []\r\npoints: []\r\n"},
        {"points: [] # c\r\n", {"points=[[1,2],\n [3,4]]"}, "points: [[1,2],\r\n [3,4]] # c\r\n"},
        {"luxel: 1\rlights:\r- {type: spot}\rpoints: []\r",
         {"lights=[]", "shadows=none"},
         "luxel: 1\rlights: []\rpoints: []\rshadows: none\r"},
        {"shadows: |\r\n  a\r\n  b\r\nunits: x\r\n", {"shadows=none"}, "shadows: none\r\nunits: x\r\n"},
        {"  luxel: 1\n  shadows: none\n", {"units=x"}, "  luxel: 1\n  shadows: none\n  units: x\n"},
    };
    EXPECT_CASES(cases);
}

/* Texts that YAML allows and that cannot be changed in place are written anew, and rightly. */
static void writes_anew_where_it_must(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    char *text = NULL;
    const char *strange = "? shadows\n? units\n: x\n";
    assert_int_equal(luxel_scene_read_text(strange, strlen(strange), "a", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "shadows=none", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_write_text(scene, &text), LUXEL_OK);
    assert_string_equal(text, "shadows: none\nunits: x\n");
    luxel_text_free(text);
    luxel_scene_free(scene);
}

/* A slider that is dragged for hours. */
static void survives_many_sets(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    char assignment[100];
    const char *commented = "lights: # all\n  - {type: point} # one\n";
    assert_int_equal(luxel_scene_read_text(commented, strlen(commented), "a", NULL, &scene), LUXEL_OK);
    for (int i = 0; i < 30000; i++) {
        snprintf(assignment, sizeof assignment, "lights[0].%s=%d", i % 2 ? "intensity" : "k", i);
        assert_int_equal(luxel_scene_set(scene, assignment, NULL), LUXEL_OK);
        assert_true(lx_document_bytes(&scene->document) < 200000);
    }
    expect_spliced(scene, "lights: # all\n  - {type: point, k: 29998, intensity: 29999} # one\n");
    luxel_scene_free(scene);
}

static void writes_files(void **state)
{
    (void)state;
    char folder[] = "/tmp/luxel-splice-XXXXXX", path[64], read[64] = {0};
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a.yaml", folder);
    assert_int_equal(luxel_scene_read_text("shadows: none # c\n", 18, "a", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "shadows=points", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_write_file(scene, path, diagnostics), LUXEL_OK);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fread(read, 1, sizeof read - 1, file), 20);
    fclose(file);
    assert_string_equal(read, "shadows: points # c\n");
    remove(path);
    remove(folder);
    assert_int_equal(luxel_scene_write_file(scene, path, diagnostics), LUXEL_ERROR_FILE);
    expect_entry(diagnostics, 0, WANTED("file-not-created"));
    assert_int_equal(luxel_scene_write_file(scene, NULL, diagnostics), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_write_file(NULL, path, diagnostics), LUXEL_ERROR_ARGUMENT);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(replaces_values),    cmocka_unit_test(replaces_lists),
        cmocka_unit_test(adds_keys),          cmocka_unit_test(writes_json_as_json),
        cmocka_unit_test(keeps_bytes),        cmocka_unit_test(writes_anew_where_it_must),
        cmocka_unit_test(survives_many_sets), cmocka_unit_test(writes_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
