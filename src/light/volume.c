/* SPDX-License-Identifier: MIT */
/*
 * The volume source: a convex body whose whole surface shines outwards with the same radiance everywhere, such as an
 * opal globe or a tube.  Sphere and cylinder are exact, or polyhedra where `facets` says so.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../parameter/mesh_file.h"
#include "array.h"
#include "spread.h"

/* Corners of a mesh are off by no more than this share of its size, however few digits the file has. */
static const double COARSEST = 5e-4;

/* Larger bodies take the time of a picture for each element. */
enum { MOST_SHINING = 1000000 };

struct box_parameters {
    uint64_t given;
    double center_mm[3], size_mm[3];
};

struct sphere_parameters {
    uint64_t given;
    double center_mm[3];
    double radius_mm;
    unsigned facets;
};

struct cylinder_parameters {
    uint64_t given;
    double center_mm[3];
    double radius_mm, height_mm;
    double axis[3];
    unsigned facets;
};

struct volume_parameters {
    uint64_t given;
    struct box_parameters box;
    struct sphere_parameters sphere;
    struct cylinder_parameters cylinder;
    const char *mesh_file;
    double scale; /* mm a unit of the file */
    struct lx_spread spread;
    struct lx_mesh *mesh; /* what was read of the file */
    struct lx_array array;
};

/* ---- tables ---- */

#define CENTER(type_)                                                                                                  \
    {                                                                                                                  \
        .name = "center", .label = "Centre", .type = LX_REALS, .offset = offsetof(type_, center_mm), .count = 3,       \
        .unit = LX_UNIT_MM, .required = true, .advised = LX_SPREAD_PLACES, .meaning = "where its centre lies",         \
    }

#define LENGTH(name_, label_, type_, member_, meaning_)                                                                \
    {                                                                                                                  \
        .name = name_, .label = label_, .type = LX_REAL, .offset = offsetof(type_, member_), .unit = LX_UNIT_MM,       \
        .required = true, .legal = LX_ABOVE(0), .advised = {LX_BETWEEN(1, 5000)}, .meaning = meaning_,                 \
    }

static const struct lx_parameter box_parameters[] = {
    CENTER(struct box_parameters),
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct box_parameters, size_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 10000)},
        .meaning = "its lengths along x, y and z",
    },
};

static const struct lx_table box_table = {
    .parameters = box_parameters,
    .count = LX_COUNT(box_parameters),
    .size = sizeof(struct box_parameters),
};

static const struct lx_parameter sphere_parameters[] = {
    CENTER(struct sphere_parameters),
    LENGTH("radius", LX_N("Radius"), struct sphere_parameters, radius_mm, LX_N("its radius")),
    {
        .name = "facets",
        .label = "Facets",
        .type = LX_WHOLE,
        .offset = offsetof(struct sphere_parameters, facets),
        .legal = LX_BETWEEN(4, 1000),
        .advised = {LX_BETWEEN(6, 100)},
        .meaning = "replaces it by the polyhedron with that many meridians, and half as many bands from pole to "
                   "pole along z, whose corners lie on the sphere; not given: the sphere itself",
    },
};

static const struct lx_table sphere_table = {
    .parameters = sphere_parameters,
    .count = LX_COUNT(sphere_parameters),
    .size = sizeof(struct sphere_parameters),
};

static const struct lx_parameter cylinder_parameters[] = {
    CENTER(struct cylinder_parameters),
    LENGTH("radius", LX_N("Radius"), struct cylinder_parameters, radius_mm, LX_N("its radius")),
    LENGTH("height", LX_N("Height"), struct cylinder_parameters, height_mm,
           LX_N("its length along the axis; both ends are closed")),
    {
        .name = "axis",
        .label = "Axis",
        .type = LX_REALS,
        .offset = offsetof(struct cylinder_parameters, axis),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 0, 1]",
        .meaning = "the direction of its axis, of any length",
    },
    {
        .name = "facets",
        .label = "Facets",
        .type = LX_WHOLE,
        .offset = offsetof(struct cylinder_parameters, facets),
        .legal = LX_BETWEEN(3, 1000),
        .advised = {LX_BETWEEN(6, 100)},
        .meaning = "replaces it by the prism with that many sides, whose edges lie on the cylinder; not given: the "
                   "cylinder itself",
    },
};

static const struct lx_table cylinder_table = {
    .parameters = cylinder_parameters,
    .count = LX_COUNT(cylinder_parameters),
    .size = sizeof(struct cylinder_parameters),
};

static const struct lx_parameter volume_parameters[] = {
    {
        .name = "box",
        .label = "Box",
        .type = LX_GROUP,
        .offset = offsetof(struct volume_parameters, box),
        .group = &box_table,
        .meaning = "a box with its edges along x, y and z as the body",
    },
    {
        .name = "sphere",
        .label = "Sphere",
        .type = LX_GROUP,
        .offset = offsetof(struct volume_parameters, sphere),
        .group = &sphere_table,
        .meaning = "a sphere as the body",
    },
    {
        .name = "cylinder",
        .label = "Cylinder",
        .type = LX_GROUP,
        .offset = offsetof(struct volume_parameters, cylinder),
        .group = &cylinder_table,
        .meaning = "a cylinder as the body",
    },
    {
        .name = "mesh",
        .label = "Mesh file",
        .type = LX_TEXT,
        .offset = offsetof(struct volume_parameters, mesh_file),
        .meaning = "a mesh file (OBJ, PLY, STL, OFF, glTF) with the body, closed and convex, in mm unless `scale` says "
                   "otherwise; relative to the "
                   "folder of the scene, or to the current one where the scene comes from standard input",
    },
    {
        .name = "scale",
        .label = "Scale",
        .type = LX_REAL,
        .offset = offsetof(struct volume_parameters, scale),
        .legal = LX_ABOVE(0),
        .initial = "1",
        .meaning = "mm for each unit of the mesh file, from the origin of coordinates: 1000 for a file in metres",
    },
    LX_SPREAD_PARAMETERS(struct volume_parameters),
    LX_ARRAY_PARAMETER(struct volume_parameters),
};

static const struct lx_rule volume_rules[] = {
    {LX_RULE_ONE, "box", NULL, "box|sphere|cylinder|mesh"},
    {LX_RULE_ONE, "radiance", NULL, "radiance|power"},
    {LX_RULE_USED, "scale", "mesh", NULL},
    LX_SPREAD_RULES,
};

static void check_volume(const struct lx_check *check, void *parameters);

static void release_volume(void *parameters)
{
    struct volume_parameters *volume = parameters;
    lx_kept_release((struct lx_kept *)volume->mesh);
    volume->mesh = NULL;
}

static const struct lx_table volume_table = {
    .parameters = volume_parameters,
    .count = LX_COUNT(volume_parameters),
    .rules = volume_rules,
    .rule_count = LX_COUNT(volume_rules),
    .size = sizeof(struct volume_parameters),
    .check = check_volume,
    .release = release_volume,
};

/* ---- shapes ---- */

static int add_sphere(const struct sphere_parameters *sphere, bool round, struct lx_shapes *shapes)
{
    if (!round && lx_is_given(&sphere_table, sphere, "facets"))
        return lx_shapes_add_facets(shapes, lx_facets_make_sphere(sphere->center_mm, sphere->radius_mm, sphere->facets,
                                                                  shapes->emitters.asking));
    struct lx_emitter shape = {.type = LX_BALL, .radius_mm = sphere->radius_mm};
    memcpy(shape.center_mm, sphere->center_mm, sizeof shape.center_mm);
    return lx_shapes_add(shapes, &shape);
}

static int add_cylinder(const struct cylinder_parameters *cylinder, bool round, struct lx_shapes *shapes)
{
    if (!round && lx_is_given(&cylinder_table, cylinder, "facets"))
        return lx_shapes_add_facets(shapes, lx_facets_make_cylinder(cylinder->center_mm, cylinder->radius_mm,
                                                                    cylinder->height_mm, cylinder->axis,
                                                                    cylinder->facets, shapes->emitters.asking));
    struct lx_emitter shape = {
        .type = LX_CYLINDER,
        .radius_mm = cylinder->radius_mm,
        .height_mm = cylinder->height_mm,
        .axis = lx_unit3(lx_exact3(cylinder->axis)),
    };
    memcpy(shape.center_mm, cylinder->center_mm, sizeof shape.center_mm);
    return lx_shapes_add(shapes, &shape);
}

static const char *body_of(const struct volume_parameters *volume)
{
    static const char *const bodies[] = {"box", "sphere", "cylinder"};
    for (size_t i = 0; i < LX_COUNT(bodies); i++)
        if (lx_is_given(&volume_table, volume, bodies[i]))
            return bodies[i];
    return "mesh";
}

/* mm for each unit of the mesh file: as given, or as its format says. */
static double scale_of(const struct volume_parameters *volume)
{
    const bool is_told = lx_is_given(&volume_table, volume, "scale") || !(volume->mesh->unit_mm > 0);
    return is_told ? volume->scale : volume->mesh->unit_mm;
}

static struct lx_shape_report make_body(const struct lx_mesh *mesh, double scale, struct lx_shape_rounding *rounding,
                                        struct lx_facets **facets)
{
    double(*corners)[3] = mesh->corners;
    rounding->corner_mm = scale * fmin(mesh->rounding, COARSEST * lx_mesh_size(mesh));
    if (scale != 1) {
        corners = lx_new_array(mesh->corner_count, sizeof *corners);
        if (!corners)
            return (struct lx_shape_report){LX_SHAPE_OUT_OF_MEMORY, 0, 0};
        for (size_t i = 0; i < mesh->corner_count; i++)
            for (int k = 0; k < 3; k++)
                corners[i][k] = scale * mesh->corners[i][k];
    }
    struct lx_shape_report report = lx_facets_of_mesh((const double(*)[3])corners, mesh->corner_count, mesh->loop,
                                                      mesh->counts, mesh->face_count, rounding, facets);
    if (scale != 1)
        free(corners);
    return report;
}

/* The body, or what is wrong with its mesh; `round`: without the facets of spheres and cylinders. */
static struct lx_shape_report make_shapes(const struct volume_parameters *volume, bool round,
                                          struct lx_shape_rounding *rounding, struct lx_shapes *shapes)
{
    struct lx_shape_report report = {LX_SHAPE_GOOD, 0, 0};
    const char *body = body_of(volume);
    int result;
    if (strcmp(body, "box") == 0) {
        result = lx_shapes_add_facets(shapes, lx_facets_of_box(volume->box.center_mm, volume->box.size_mm));
    } else if (strcmp(body, "sphere") == 0) {
        result = add_sphere(&volume->sphere, round, shapes);
    } else if (strcmp(body, "cylinder") == 0) {
        result = add_cylinder(&volume->cylinder, round, shapes);
    } else {
        struct lx_facets *facets = NULL;
        if (volume->mesh->body && volume->mesh->scale == scale_of(volume))
            facets = (struct lx_facets *)lx_kept_hold(volume->mesh->body);
        else
            report = make_body(volume->mesh, scale_of(volume), rounding, &facets);
        if (report.fault != LX_SHAPE_GOOD)
            return report;
        result = lx_shapes_add_facets(shapes, facets);
    }
    if (result < 0)
        report.fault = LX_SHAPE_OUT_OF_MEMORY;
    return report;
}

/* ---- checking ---- */

/* What is wrong with the body of a mesh, at the face of its file. */
static void report_mesh(const struct lx_check *check, const struct volume_parameters *volume, const char *path,
                        struct lx_shape_report report, const struct lx_shape_rounding *rounding)
{
    const struct lx_mesh *mesh = volume->mesh;
    char number[LX_NUMBER_SIZE], line[LX_NUMBER_SIZE], off[LX_NUMBER_SIZE], allowed[LX_NUMBER_SIZE];
    struct lx_mesh_origin origin = mesh->origins[report.first < mesh->face_count ? report.first : 0];
    enum lx_message message = LX_MSG_MESH_NO_AREA;
    lx_write_number(origin.number, number);
    lx_write_number(origin.line, line);
    switch (report.fault) {
    case LX_SHAPE_OUT_OF_MEMORY: check->walk->out_of_memory = true; return;
    case LX_SHAPE_NOT_FLAT: message = LX_MSG_MESH_NOT_FLAT; break;
    case LX_SHAPE_NOT_CLOSED: message = LX_MSG_MESH_NOT_CLOSED; break;
    case LX_SHAPE_NOT_CONVEX: message = rounding->off_mm > 0 ? LX_MSG_MESH_NOT_CONVEX : LX_MSG_MESH_NOT_ONE; break;
    case LX_SHAPE_INWARD: message = LX_MSG_MESH_INWARD; break;
    default: break;
    }
    lx_check_report(check, "mesh", LX_ALL_OF_IT, message,
                    LX_ARGS(path, number, line, lx_write_digits(rounding->off_mm, 3, off),
                            lx_write_digits(rounding->allowed_mm, 2, allowed)));
    if (report.fault == LX_SHAPE_INWARD)
        lx_check_hint(check, LX_MSG_HINT_TURN_FACES, NULL);
    else if (report.fault == LX_SHAPE_NOT_FLAT)
        lx_check_hint(check, LX_MSG_HINT_FLAT_FACES, NULL);
    else if (report.fault == LX_SHAPE_NOT_CONVEX && rounding->off_mm > 0)
        lx_check_hint(check, LX_MSG_HINT_CONVEX, NULL);
}

/* Reads the file of a mesh, unless the scene has done so already; false where that failed, which is reported. */
static bool load_mesh(const struct lx_check *check, struct volume_parameters *volume, const char *path)
{
    bool is_new;
    volume->mesh = lx_check_mesh(check, "mesh", path, &is_new);
    if (volume->mesh && volume->mesh->face_count > MOST_SHINING) {
        lx_check_report(check, "mesh", LX_ALL_OF_IT, LX_MSG_MESH_TOO_LARGE_SOURCE, LX_ARGS(path));
        return false;
    }
    if (!volume->mesh || !is_new)
        return volume->mesh != NULL;
    /* The body is made once for all scenes that share the mesh; what is wrong with it is told by the check. */
    struct lx_facets *body = NULL;
    struct lx_shape_rounding rounding;
    const double scale = scale_of(volume);
    struct lx_shape_report shape = make_body(volume->mesh, scale, &rounding, &body);
    if (shape.fault == LX_SHAPE_NOT_CLOSED && lx_mesh_join(volume->mesh)) /* corners that differ in their last digits */
        shape = make_body(volume->mesh, scale, &rounding, &body);
    if (shape.fault == LX_SHAPE_GOOD) {
        volume->mesh->body = &body->kept;
        volume->mesh->scale = scale;
    }
    lx_check_keep_mesh(check, path, volume->mesh);
    return true;
}

/* Sizes in mm that lamps may have. */
static const double LEAST = 1, MOST = 10000;

/* What was left out of the file, and whether its unit can be mm. */
static void advise_volume(const struct lx_check *check, const struct volume_parameters *volume)
{
    const struct lx_mesh *mesh = volume->mesh;
    if (!mesh || !lx_is_given(&volume_table, volume, "mesh"))
        return;
    lx_check_advise_mesh(check, "mesh", volume->mesh_file, mesh);
    lx_check_advise_mesh_size(check, "mesh", mesh, scale_of(volume), LEAST, MOST);
}

static void check_volume(const struct lx_check *check, void *parameters)
{
    struct volume_parameters *volume = parameters;
    if (check->advises) {
        advise_volume(check, volume);
        return;
    }
    const char *body = body_of(volume);
    bool is_mesh = strcmp(body, "mesh") == 0;
    char *path = is_mesh ? lx_check_path(check, volume->mesh_file) : NULL;
    struct lx_shapes shapes = {0};
    if (is_mesh && (!path || !load_mesh(check, volume, path))) {
        free(path);
        return;
    }
    struct lx_shape_rounding rounding = {0};
    struct lx_shape_report report = make_shapes(volume, true, &rounding, &shapes); /* an area as good as any */
    if (report.fault == LX_SHAPE_GOOD)
        lx_check_area(check, body, &shapes);
    else if (is_mesh)
        report_mesh(check, volume, path, report, &rounding);
    else
        check->walk->out_of_memory = true; /* nothing else can be wrong with the others */
    lx_shapes_clear(&shapes);
    free(path);
}

/* ---- the kind ---- */

static int prepare_volume(const void *parameters, struct lx_emitters *emitters)
{
    const struct volume_parameters *volume = parameters;
    struct lx_shapes shapes = {.emitters = {.asking = emitters->asking}};
    struct lx_shape_rounding rounding;
    if (make_shapes(volume, false, &rounding, &shapes).fault != LX_SHAPE_GOOD) {
        lx_shapes_clear(&shapes);
        return -1;
    }
    lx_bounded radiance = lx_is_given(&volume_table, volume, "radiance")
                              ? lx_exact(volume->spread.radiance)
                              : lx_radiance_of_power(volume->spread.power, &shapes);
    return lx_spread_emit(&volume->spread, radiance, &shapes, emitters);
}

static bool mesh_used(const void *parameters, struct lx_mesh_use *use)
{
    const struct volume_parameters *volume = parameters;
    if (!volume->mesh || !lx_is_given(&volume_table, volume, "mesh"))
        return false;
    *use = (struct lx_mesh_use){"mesh", volume->mesh_file, volume->mesh, scale_of(volume), NULL};
    return true;
}

const struct lx_light_kind lx_volume_kind = {
    .variant =
        {
            .name = "volume",
            .meaning = "a convex body that shines outwards all over, such as an opal globe",
            .example = "{type: volume, sphere: {center: [700, 600, 2000], radius: 150}, power: 250}",
            .table = &volume_table,
        },
    .prepare = prepare_volume,
    .mesh = mesh_used,
};
