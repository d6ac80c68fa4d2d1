/* SPDX-License-Identifier: MIT */
/* Reading polyhedra: what OFF and OBJ files may look like, what is refused and where, and keeping what was read. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "format/mesh/mesh.h"
#include "scenes.h"

static struct lx_mesh_report read_text(const char *name, const char *text, struct lx_mesh **mesh)
{
    char *copy = lx_copy_text(text, strlen(text));
    assert_non_null(copy);
    *mesh = NULL;
    struct lx_mesh_report report = lx_mesh_read(name, copy, strlen(text), NULL, mesh);
    free(copy);
    assert_true((report.message == LX_MSG_COUNT) == (*mesh != NULL));
    return report;
}

/* A tetrahedron in either format, however it is written. */
static void expect_tetrahedron(const char *name, const char *text)
{
    struct lx_mesh *mesh;
    struct lx_mesh_report report = read_text(name, text, &mesh);
    if (report.message != LX_MSG_COUNT)
        fail_msg("message %d in line %zu of\n%s", (int)report.message, report.line, text);
    assert_int_equal(mesh->corner_count, 4);
    assert_int_equal(mesh->face_count, 4);
    static const unsigned loop[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    assert_memory_equal(mesh->loop, loop, sizeof loop);
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(mesh->counts[i], 3);
        assert_int_equal(mesh->origins[i].number, i + 1);
    }
    assert_true(mesh->corners[1][0] == 1.5 && mesh->corners[2][1] == 1e2 && mesh->corners[3][2] == 3);
    lx_kept_release(&mesh->kept);
}

#define OFF_FACES "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
#define OBJ_CORNERS "v 0 0 0\nv 1.5 0 0\nv 0 1e2 0\nv 0 0 3\n"
#define OBJ_FACES "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"

static void reads_off(void **state)
{
    (void)state;
    expect_tetrahedron("a.off", "OFF\n4 4 6\n0 0 0\n1.5 0 0\n0 1e2 0\n0 0 3\n" OFF_FACES);
    expect_tetrahedron("a.OFF",
                       "# made by hand\nOFF 4 4\n\n 0 0 0 # the first\n+1.5 -0 0.\n\t0 100 0\n0 0 3\n" OFF_FACES);
    expect_tetrahedron("mesh", "OFF\r\n4 4 0\r\n0 0 0\r\n1.5 0 0\r\n0 1e+2 0\r\n0 0 3\r\n3 0 2 1\r\n3 0 1 3\r\n"
                               "3 1 2 3\r\n3 0 3 2");
    expect_tetrahedron("a.off", "4 4 6\n0 0 0\n1.5 0 0\n0 1e2 0\n0 0 3\n" OFF_FACES);
    expect_tetrahedron("a",
                       "COFF\n4 4 6\n0 0 0 255 0 0 255\n1.5 0 0 1 1 1 1\n0 1e2 0 1 1 1 1\n0 0 3 1 1 1 1\n" OFF_FACES);
    expect_tetrahedron("a", "OFF\n4 4 6\n0 0 0\n1.5 0 0\n0 1e2 0\n0 0 3\n3 0 2 1 255 0 0\n3 0 1 3 0.5 0.5 0.5\n"
                            "3 1 2 3 7\n3 0 3 2\nand more\n");
    expect_tetrahedron("a", "\xef\xbb\xbfoff4 4 6\n0 0 0\n1.5 0 0\n0 1e2 0\n0 0 3\n" OFF_FACES);
    expect_tetrahedron("a", "Off\r4 4 6\r0 0 0\r1.5 0 0\r0 100 0\r0 0 3\r3 0 2 1\r3 0 1 3\r3 1 2 3\r3 0 3 2\r");
    expect_tetrahedron("a", "OFF 4 4 6 0 0 0 1.5 0 0 0 1e2 0 0 0 3 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2 # all of it");
    expect_tetrahedron("a", "OFF\n4\n4\n6\n0 0\n0 1.5 0\n0\n0 1e2 0 0 0 3\n3 0\n2 1 3 0 1 3 3 1 2 3 3 0 3 2\n");
    expect_tetrahedron("a", "STNOFF 4 4 6 0 0 0 0 0 1 0 0 1.5 0 0 0 0 1 0 0 0 1e2 0 0 0 1 0 0 0 0 3 0 0 1 0 0\n"
                            "3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2");
}

static void reads_obj(void **state)
{
    (void)state;
    expect_tetrahedron("a.obj", OBJ_CORNERS OBJ_FACES);
    expect_tetrahedron("a.txt",
                       "mtllib a.mtl\no lamp\n" OBJ_CORNERS "vn 0 0 1\nvt 0 0\nusemtl glass\ns off\n" OBJ_FACES);
    expect_tetrahedron("a", "v 0 0 0 1\nv 1.5 0 0 0.1 0.2 0.3\nv 0 1e2 0\nv 0 0 3\nf 1/1 3/2 2/3\nf 1//7 2//7 4//7\n"
                            "f 2/1/1 3/1/1 4/1/1\nf 1/ 4 3");
    expect_tetrahedron("a", OBJ_CORNERS "f -4 -2 -3\nf 1 -3 -1\nf -3 3 4\nf 1 4 3\n");
    expect_tetrahedron("a", OBJ_CORNERS "f 1 3 \\\n2\nf \\\r\n 1 2 4\n f\t2 3 4 # comment\nf 1 4 3\n");
    expect_tetrahedron("a", OBJ_FACES OBJ_CORNERS);
    expect_tetrahedron("a.obj", "\xef\xbb\xbf" OBJ_CORNERS OBJ_FACES);
    expect_tetrahedron("a", "v 0 0 0\rv 1.5 0 0\rv 0 100 0\rv 0 0 3\rf 1 3 2\rf 1 2 4\rf 2 3 4\rf 1 4 3");
    expect_tetrahedron("a", OBJ_CORNERS "f 1 3 \\ \t\n2\nf 1 2 \\  \r\n4\nf 2 3 4\nf 1 4 3\n");
}

static void leaves_out_and_tells(void **state)
{
    (void)state;
    struct lx_mesh *mesh;
    static const char text[] = OBJ_CORNERS "f 1 3\nf 2\np 1\nl 1 2 3\n" OBJ_FACES "f 3 2 1\nf 2 4 1\n";
    assert_int_equal(read_text("a.obj", text, &mesh).message, LX_MSG_COUNT);
    assert_int_equal(mesh->face_count, 4);
    assert_true(mesh->thin.count == 2 && mesh->thin.line == 5);
    assert_true(mesh->others.count == 2 && mesh->others.line == 7);
    assert_true(mesh->doubled.count == 2 && mesh->doubled.line == 13);
    assert_int_equal(mesh->origins[0].number, 3);
    lx_kept_release(&mesh->kept);
}

/* What the digits of a file say about its places. */
static void knows_its_rounding(void **state)
{
    (void)state;
    static const struct {
        const char *corners;
        double rounding;
    } cases[] = {
        {"v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 1900\n", 0},
        {"v 0 0 0\nv 12.25 0 0\nv 0 100 0\nv 0 0 1900.55\n", 0.005},
        {"v 0 0 0\nv 0.00123457 0 0\nv 0 1234.57 0\nv 0 0 10\n", 0.005},
        {"v 0 0 0\nv 1.5e-2 0 0\nv 0 1e3 0\nv 0 0 1.25e+3\n", 5},
        {"v 0 0 0\nv 100.00000000000001 0 0\nv 0 6.1e-15 0\nv 0 100 3\n", 0.5e-14},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[200];
        struct lx_mesh *mesh;
        snprintf(text, sizeof text, "%s%s", cases[i].corners, OBJ_FACES);
        assert_int_equal(read_text("a", text, &mesh).message, LX_MSG_COUNT);
        assert_true(fabs(mesh->rounding - cases[i].rounding) <= 1e-9 * cases[i].rounding);
        lx_kept_release(&mesh->kept);
    }
}

/* Corners of each face of its own, which differ in the last digit. */
static void joins_what_digits_join(void **state)
{
    (void)state;
    struct lx_mesh *mesh;
    static const char text[] =
        "v 0 0 0\nv 0 10.00 0\nv 1.50 0 0\nf -3 -2 -1\nv 0.01 0 -0.01\nv 1.50 0.01 0\nv 0 0 3.00\n"
        "f -3 -2 -1\nv 1.49 0 0\nv 0 10.01 0\nv 0 0 3.01\nf -3 -2 -1\nv 0 0 0\nv 0 0 3\nv 0.01 "
        "10 0\nf -3 -2 -1\n";
    assert_int_equal(read_text("a", text, &mesh).message, LX_MSG_COUNT);
    assert_int_equal(mesh->corner_count, 10);
    assert_true(lx_mesh_join(mesh));
    assert_true(mesh->corner_count == 4 && mesh->face_count == 4 && mesh->joined == 6);
    assert_false(lx_mesh_join(mesh));
    lx_kept_release(&mesh->kept);
}

static void brings_corners_together(void **state)
{
    (void)state;
    struct lx_mesh *mesh;
    /* each face has corners of its own, one corner has no face, one face is an edge only, one has a corner twice */
    static const char text[] = "v 9 9 9\nv 0 0 0\nv 0 1 0\nv 1 0 0\nf -3 -2 -1\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf -3 -2 -1\n"
                               "v 1 0 0\nv 0 1 0\nv -0 0 1\nf -3 -2 -1 -1\nf 2 5 3\nf 2 10 3\n";
    assert_int_equal(read_text("a.obj", text, &mesh).message, LX_MSG_COUNT);
    assert_int_equal(mesh->corner_count, 4);
    assert_int_equal(mesh->face_count, 4);
    assert_int_equal(mesh->counts[2], 3);
    assert_int_equal(mesh->origins[3].number, 5);
    assert_int_equal(mesh->origins[3].line, 15);
    static const unsigned loop[] = {0, 1, 2, 0, 2, 3, 2, 1, 3, 0, 3, 1};
    assert_memory_equal(mesh->loop, loop, sizeof loop);
    lx_kept_release(&mesh->kept);
}

static void names_the_line(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        enum lx_message message;
        size_t line;
    } cases[] = {
        {"", LX_MSG_MESH_FORMAT, 0},
        {"# nothing\n", LX_MSG_MESH_FORMAT, 0},
        {"luxel: 1\n", LX_MSG_MESH_FORMAT, 0},
        {"4OFF\n1 1 1\n", LX_MSG_OFF_DIMENSIONS, 1},
        {"nOFF 3\n1 1 1\n", LX_MSG_OFF_DIMENSIONS, 1},
        {"OFFER\n1 1 1\n", LX_MSG_MESH_FORMAT, 0},
        {"OFF BINARY\n\1\2", LX_MSG_OFF_BINARY, 1},
        {"some words\n", LX_MSG_MESH_FORMAT, 0},
        {"OFF\n", LX_MSG_MESH_ENDS, 1},
        {"OFF\n\n4\n", LX_MSG_MESH_COUNTS, 3},
        {"OFF\n-1 4 0\n", LX_MSG_MESH_COUNTS, 2},
        {"OFF\n4.0 4 0\n", LX_MSG_MESH_COUNTS, 2},
        {"OFF\n99999999999999999999999 4 0\n", LX_MSG_MESH_COUNTS, 2},
        {"OFF\n4 10000001 0\n", LX_MSG_MESH_TOO_LARGE, 2},
        {"OFF\n30000001 4 0\n", LX_MSG_MESH_TOO_LARGE, 2},
        {"OFF\n2000000 1000000 0\n0 0 0\n", LX_MSG_MESH_ENDS, 3},
        {"OFF\n1 1 0\n0 0\n", LX_MSG_MESH_CORNER, 3},
        {"OFF\n1 1 0\n0 0 x\n", LX_MSG_MESH_CORNER, 3},
        {"OFF\n1 1 0\n0 0 nan\n", LX_MSG_MESH_CORNER, 3},
        {"OFF\n1 1 0\n0 0 1e999\n", LX_MSG_MESH_CORNER, 3},
        {"OFF\n1 1 0\n0 0 0,5\n", LX_MSG_MESH_CORNER, 3},
        {"OFF\n1 1 0\n0 0 0x1\n", LX_MSG_MESH_CORNER, 3},
        {"OFF\n1 1 0\n0 0 0\n\n# a face\n2 0 0\n", LX_MSG_MESH_EMPTY, 0},
        {"OFF\n1 1 0\n0 0 0\n3 0 0\n", LX_MSG_OFF_FACE, 4},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", LX_MSG_OFF_FACE, 4},
        {"OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", LX_MSG_OFF_FACE, 4},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n", LX_MSG_MESH_INDEX, 4},
        {"OFF\n3 0 0\n0 0 0\n1 1 1\n2 2 2\n", LX_MSG_MESH_EMPTY, 0},
        {"OFF\n1 1 0\n0 0 0\n3 0 0 0\n", LX_MSG_MESH_EMPTY, 0},
        {"v 1 2\n", LX_MSG_MESH_CORNER, 1},
        {"v 1 2 3\nf 1 2\n", LX_MSG_MESH_EMPTY, 0},
        {"v 1 2 3\ncstype bezier\n", LX_MSG_OBJ_FREE_FORM, 2},
        {"OFF 1 1 0 0 0 0 3 0 0 0 7\n", LX_MSG_MESH_ENDS, 1},
        {"v 1 2 3\nf 1 1 0\n", LX_MSG_OBJ_FACE, 2},
        {"v 1 2 3\nf 1 1 -2\n", LX_MSG_OBJ_FACE, 2},
        {"v 1 2 3\nf 1 1 one\n", LX_MSG_OBJ_FACE, 2},
        {"v 1 2 3\nf 1 1 1.5\n", LX_MSG_OBJ_FACE, 2},
        {"v 1 2 3\nf 1 1 99999999999999999999\n", LX_MSG_OBJ_FACE, 2},
        {"v 1 2 3\n\\\n\\\nf 1 \\\n1 \\\n2\n", LX_MSG_MESH_INDEX, 2},
        {"v 1 2 3 \\\n\nf 1 1 1\nf 1 2 2\n", LX_MSG_MESH_INDEX, 4},
        {"v 1 2 3\n", LX_MSG_MESH_EMPTY, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct lx_mesh *mesh;
        struct lx_mesh_report report = read_text("a", cases[i].text, &mesh);
        if (report.message != cases[i].message || (cases[i].line && report.line != cases[i].line))
            fail_msg("message %d in line %zu of\n%s", (int)report.message, report.line, cases[i].text);
    }
}

static void keeps_by_path(void **state)
{
    (void)state;
    struct lx_kept_files meshes = {0}, copy = {0};
    struct lx_mesh *mesh;
    assert_int_equal(read_text("a", OBJ_CORNERS OBJ_FACES, &mesh).message, LX_MSG_COUNT);
    assert_null(lx_kept_find(&meshes, "a", lx_mesh_free));
    assert_int_equal(lx_kept_add(&meshes, "a", &mesh->kept), 0);
    lx_kept_release(&mesh->kept);
    assert_ptr_equal(lx_kept_find(&meshes, "a", lx_mesh_free), mesh);
    assert_int_equal(lx_kept_copy(&meshes, &copy), 0);
    lx_kept_clear(&meshes);
    assert_null(lx_kept_find(&meshes, "a", lx_mesh_free));
    assert_ptr_equal(lx_kept_find(&copy, "a", lx_mesh_free), mesh);
    assert_int_equal(mesh->face_count, 4);
    lx_kept_clear(&copy);
    lx_kept_release(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_off),
        cmocka_unit_test(reads_obj),
        cmocka_unit_test(brings_corners_together),
        cmocka_unit_test(leaves_out_and_tells),
        cmocka_unit_test(knows_its_rounding),
        cmocka_unit_test(joins_what_digits_join),
        cmocka_unit_test(names_the_line),
        cmocka_unit_test(keeps_by_path),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
