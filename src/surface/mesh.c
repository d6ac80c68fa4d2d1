/* SPDX-License-Identifier: MIT */
/*
 * The mesh: a surface of triangles from a file, that hides parts of itself. Its parameters, and how it lies in space.
 */
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../parameter/mesh_file.h"
#include "turning.h"

enum { BOTH_SIDES, FRONT_ONLY };

struct mesh_parameters {
    uint64_t given;
    const char *file;
    double scale; /* mm a unit of the file */
    double rotate[3], position_mm[3];
    int normals; /* enum lx_solid_normals */
    double crease;
    int sides;
    struct lx_mesh *mesh; /* what was read of the file, and made of it */
    struct lx_solid *solid;
    struct lx_mesh_normals *shading;
    struct lx_mesh_body body;
};

static const char *const normal_choices[] = {"auto", "file", "smooth", "flat", NULL};
static const char *const side_choices[] = {"both", "front", NULL};

static const struct lx_parameter mesh_parameters[] = {
    {
        .name = "file",
        .label = "Mesh file",
        .type = LX_TEXT,
        .offset = offsetof(struct mesh_parameters, file),
        .required = true,
        .meaning =
            "a file with the mesh: OBJ, PLY, STL, OFF or glTF 2.0; relative to the folder of the scene, or to the "
            "current one where the scene comes from standard input",
    },
    {
        .name = "scale",
        .label = "Scale",
        .type = LX_REAL,
        .offset = offsetof(struct mesh_parameters, scale),
        .legal = LX_ABOVE(0),
        .initial = "1",
        .meaning =
            "mm for each unit of the file, from its origin: 1000 for a file in metres; glTF files are in metres, "
            "and have 1000 where it is not given",
    },
    {
        .name = "rotate",
        .label = "Rotation",
        .type = LX_REALS,
        .offset = offsetof(struct mesh_parameters, rotate),
        .count = 3,
        .unit = LX_UNIT_DEGREES,
        .initial = "[0, 0, 0]",
        .advised = {LX_BETWEEN(-360, 360)},
        .meaning = "how far it is turned about x, then about y, then about z, counter-clockwise as seen from where the "
                   "axis points to, about the file's origin",
    },
    {
        .name = "position",
        .label = "Position",
        .type = LX_REALS,
        .offset = offsetof(struct mesh_parameters, position_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .initial = "[0, 0, 0]",
        .meaning = "where the origin of the file goes",
    },
    {
        .name = "normals",
        .label = "Normals",
        .type = LX_CHOICE,
        .offset = offsetof(struct mesh_parameters, normals),
        .initial = "auto",
        .choices = normal_choices,
        .meaning =
            "by which normals it is shaded: those of the file (file), the means of faces that meet (smooth), those "
            "of the triangles (flat); auto: those of the file, or flat where it has none",
    },
    {
        .name = "crease",
        .label = "Crease",
        .type = LX_REAL,
        .offset = offsetof(struct mesh_parameters, crease),
        .unit = LX_UNIT_DEGREES,
        .legal = LX_BETWEEN(0, 180),
        .initial = "30",
        .meaning = "faces whose normals differ by no more are one smooth surface, with smooth normals",
    },
    {
        .name = "sides",
        .label = "Sides",
        .type = LX_CHOICE,
        .offset = offsetof(struct mesh_parameters, sides),
        .initial = "both",
        .choices = side_choices,
        .meaning =
            "whether its faces are seen from both sides, the normal turned to the observer, or from the front only, "
            "from where their corners run counter-clockwise; light they take from both sides",
    },
};

static const struct lx_rule mesh_rules[] = {
    {LX_RULE_USED, "crease", "normals", "smooth"},
};

static void check_mesh(const struct lx_check *check, void *parameters);
static void release_mesh(void *parameters);

static const struct lx_table mesh_table = {
    .parameters = mesh_parameters,
    .count = LX_COUNT(mesh_parameters),
    .rules = mesh_rules,
    .rule_count = LX_COUNT(mesh_rules),
    .size = sizeof(struct mesh_parameters),
    .check = check_mesh,
    .release = release_mesh,
};

/* ---- reading ---- */

static void release_mesh(void *parameters)
{
    struct mesh_parameters *mesh = parameters;
    lx_kept_release((struct lx_kept *)mesh->shading);
    lx_kept_release((struct lx_kept *)mesh->solid);
    lx_kept_release((struct lx_kept *)mesh->mesh);
    mesh->shading = NULL;
    mesh->solid = NULL;
    mesh->mesh = NULL;
}

static double scale_of(const struct mesh_parameters *mesh)
{
    const bool is_told = lx_is_given(&mesh_table, mesh, "scale") || !(mesh->mesh && mesh->mesh->unit_mm > 0);
    return is_told ? mesh->scale : mesh->mesh->unit_mm;
}

/* Whether no face has too many corners to be cut into triangles, which is reported. */
static bool check_faces(const struct lx_check *check, const struct lx_mesh *mesh, const char *path)
{
    char line[LX_NUMBER_SIZE];
    for (size_t i = 0; i < mesh->face_count; i++)
        if (mesh->counts[i] > LX_LARGEST_POLYGON) {
            lx_check_report(check, "file", LX_ALL_OF_IT, LX_MSG_MESH_POLYGON,
                            LX_ARGS(path, lx_write_number(mesh->origins[i].line, line)));
            return false;
        }
    return true;
}

/* Makes what the mesh is seen by; what is wrong is reported. */
static void make_body(const struct lx_check *check, struct mesh_parameters *mesh, const char *path)
{
    bool is_empty;
    if (!check_faces(check, mesh->mesh, path))
        return;
    if (mesh->normals == LX_NORMALS_FILE && !mesh->mesh->turns) {
        lx_check_report(check, "normals", LX_ALL_OF_IT, LX_MSG_MESH_NO_NORMALS, LX_ARGS(path));
        lx_check_hint(check, LX_MSG_HINT_NORMALS, NULL);
        return;
    }
    mesh->solid = lx_solid_of(mesh->mesh, &is_empty);
    if (mesh->solid)
        mesh->shading = lx_normals_of(mesh->mesh, mesh->solid, (enum lx_solid_normals)mesh->normals, mesh->crease);
    if (is_empty)
        lx_check_report(check, "file", LX_ALL_OF_IT, LX_MSG_MESH_NO_TRIANGLES, LX_ARGS(path));
    else if (!mesh->shading)
        check->walk->out_of_memory = true;
    else
        mesh->body = (struct lx_mesh_body){
            .tree = mesh->solid->tree,
            .normals = mesh->shading,
            .fronts_only = mesh->sides == FRONT_ONLY,
            .encloses = lx_is_closed(&mesh->solid->survey) && mesh->solid->survey.flipped == 0,
            .looks_inwards = mesh->solid->survey.volume < 0,
        };
}

/* Sizes in mm that what a scene shows may have. */
static const double LEAST = 10, MOST = 20000;

static void advise_mesh(const struct lx_check *check, const struct mesh_parameters *mesh)
{
    const struct lx_solid *solid = mesh->solid;
    char count[LX_NUMBER_SIZE], face[LX_NUMBER_SIZE];
    if (!mesh->mesh || !solid)
        return;
    const struct lx_mesh_survey *survey = &solid->survey;
    lx_check_advise_mesh(check, "file", mesh->file, mesh->mesh);
    if (solid->flat.count > 0)
        lx_check_advise(
            check, "file", LX_MSG_MESH_FLAT_TRIANGLES,
            LX_ARGS(mesh->file, lx_write_number(solid->flat.count, count), lx_write_number(solid->flat_face, face)));
    if (survey->flipped > 0)
        lx_check_advise(check, "file", LX_MSG_MESH_FLIPPED,
                        LX_ARGS(mesh->file, lx_write_number((double)survey->flipped, count),
                                lx_write_number(survey->flipped_at.number, face)));
    if (mesh->sides == FRONT_ONLY && lx_is_closed(survey) && survey->flipped == 0 && survey->volume < 0) {
        lx_check_advise(check, "sides", LX_MSG_MESH_LOOKS_INWARDS, LX_ARGS(mesh->file));
        lx_check_hint(check, LX_MSG_HINT_BOTH_SIDES, NULL);
    }
    lx_check_advise_mesh_size(check, "file", mesh->mesh, scale_of(mesh), LEAST, MOST);
}

static void check_mesh(const struct lx_check *check, void *parameters)
{
    struct mesh_parameters *mesh = parameters;
    bool is_new = false;
    if (check->advises) {
        advise_mesh(check, mesh);
        return;
    }
    char *path = lx_check_path(check, mesh->file);
    if (!path)
        return;
    mesh->mesh = lx_check_mesh(check, "file", path, &is_new);
    if (mesh->mesh) {
        if (is_new)
            lx_check_keep_mesh(check, path, mesh->mesh);
        make_body(check, mesh, path);
    }
    free(path);
}

/* ---- how it lies ---- */

static void keep(lx_bounded3 direction, double value[3], double error[3])
{
    value[0] = direction.x.value, value[1] = direction.y.value, value[2] = direction.z.value;
    error[0] = direction.x.error, error[1] = direction.y.error, error[2] = direction.z.error;
}

static struct lx_shape mesh_shape(const void *parameters)
{
    static const double TOUCH = 1e-11; /* what lies nearer to a face lies on it, of the size and place */
    const struct mesh_parameters *mesh = parameters;
    const struct lx_mesh_tree *tree = mesh->body.tree;
    const lx_bounded3 axes[3] = {lx_turned_axis(mesh->rotate, 0), lx_turned_axis(mesh->rotate, 1),
                                 lx_turned_axis(mesh->rotate, 2)};
    struct lx_shape shape = {.type = LX_GENERAL, .body = &mesh->body};
    keep(axes[0], shape.across, shape.across_error);
    keep(axes[1], shape.upward, shape.upward_error);
    keep(axes[2], shape.axis, shape.axis_error);
    memcpy(shape.normal, shape.axis, sizeof shape.normal);
    lx_bounded3 anchor = lx_exact3(mesh->position_mm);
    const lx_bounded scale = lx_exact(scale_of(mesh));
    for (int k = 0; k < 3 && tree; k++)
        anchor = lx_add3(anchor, lx_mul3(axes[k], lx_mul(scale, lx_exact(tree->middle[k]))));
    shape.anchor_mm[0] = anchor.x.value, shape.anchor_mm[1] = anchor.y.value, shape.anchor_mm[2] = anchor.z.value;
    shape.own[0] = tree ? tree->unit * scale.value : 1;
    shape.own[1] = fmax(anchor.x.error, fmax(anchor.y.error, anchor.z.error));
    shape.radius_mm = tree ? tree->farthest * shape.own[0] * (1 + 1e-12) : 0;
    const double away = fabs(anchor.x.value) + fabs(anchor.y.value) + fabs(anchor.z.value);
    shape.touch_mm = TOUCH * (shape.radius_mm + away);
    return shape;
}

/* The extent along directions: of all corners. */
static double reach_along(const struct lx_shape *shape, const double direction[3])
{
    const struct lx_mesh_body *body = shape->body;
    double turned_direction[3], most = -HUGE_VAL;
    turned_direction[0] = lx_dot(direction, shape->across);
    turned_direction[1] = lx_dot(direction, shape->upward);
    turned_direction[2] = lx_dot(direction, shape->axis);
    for (size_t i = 0; body->tree && i < body->tree->triangle_count; i++)
        for (int c = 0; c < 3; c++)
            most = fmax(most, lx_dot(body->tree->triangles[i].corners[c], turned_direction));
    return body->tree ? lx_dot(shape->anchor_mm, direction) + lx_mesh_size_of(shape) * most : 0;
}

static void mesh_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct lx_shape shape = mesh_shape(parameters);
    const struct lx_mesh_body *body = shape.body;
    for (int k = 0; k < 3; k++) {
        const double along[3] = {k == 0, k == 1, k == 2}, against[3] = {-along[0], -along[1], -along[2]};
        const bool is_straight = fabs(shape.across[k]) + fabs(shape.upward[k]) + fabs(shape.axis[k]) == 1 && body->tree;
        if (!is_straight) {
            low_mm[k] = -reach_along(&shape, against);
            high_mm[k] = reach_along(&shape, along);
            continue;
        }
        /* along an axis of the tree, whose box is known */
        const int axis = shape.across[k] != 0 ? 0 : shape.upward[k] != 0 ? 1 : 2;
        const double sign = shape.across[k] + shape.upward[k] + shape.axis[k], size = lx_mesh_size_of(&shape);
        low_mm[k] = shape.anchor_mm[k] + size * (sign > 0 ? body->tree->low[axis] : -body->tree->high[axis]);
        high_mm[k] = shape.anchor_mm[k] + size * (sign > 0 ? body->tree->high[axis] : -body->tree->low[axis]);
    }
}

static double mesh_farthest(const void *parameters, const double direction[3])
{
    const struct lx_shape shape = mesh_shape(parameters);
    return reach_along(&shape, direction);
}

static bool mesh_used(const void *parameters, struct lx_mesh_use *use)
{
    const struct mesh_parameters *mesh = parameters;
    const struct lx_mesh_survey *survey = mesh->solid ? &mesh->solid->survey : NULL;
    *use = (struct lx_mesh_use){"file", mesh->file, mesh->mesh, scale_of(mesh), survey};
    return mesh->mesh != NULL;
}

static const struct lx_surface_words mesh_words = {
    .sentence =
        LX_N("The normal {0} of a mesh is that of the triangle that is met, or where the mesh is smooth the mean "
             "of the normals at its corners, weighted by the place in the triangle."),
    .formulas = {"\\mathbf{N}"},
};

const struct lx_surface_kind lx_mesh_kind = {
    .variant =
        {
            .name = "mesh",
            .meaning =
                "a surface of triangles from a file, such as a model of a real object, which hides parts of itself",
            .table = &mesh_table,
        },
    .extent = mesh_extent,
    .shape = mesh_shape,
    .hit = lx_mesh_hit,
    .normal = lx_mesh_normal,
    .blocks = lx_mesh_blocks,
    .holds = lx_mesh_holds,
    .hides_itself = true,
    .meets = lx_mesh_meets,
    .takes = lx_mesh_takes,
    .normal_seen = lx_mesh_normal_seen,
    .is_behind = lx_mesh_is_behind,
    .gather = lx_mesh_gather,
    .layers = lx_mesh_layers,
    .gather_beside = lx_mesh_gather_beside,
    .farthest = mesh_farthest,
    .hides = lx_mesh_hides,
    .encloses = lx_mesh_encloses,
    .distance = lx_mesh_distance,
    .mesh = mesh_used,
    .words = &mesh_words,
};
