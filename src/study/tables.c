/* SPDX-License-Identifier: MIT */
/* The tables of study files, and what must hold between the keys of one thing that varies. */
#include <stdint.h>
#include <string.h>

#include "../parameter/any.h"
#include "../parameter/check.h"
#include "../parameter/schema.h"
#include "study.h"

static const char *const random_names[] = {"uniform", "log", "box", "sphere", "choice", NULL};
static const char *const float_names[] = {"float16", "float32", "float64", NULL};
static const char *const exact_names[] = {"float32", "float64", NULL};
static const char *const mask_names[] = {"uint8", NULL};
static const char *const index_names[] = {"int32", NULL};
static const char *const place_names[] = {"lp", "float32", "float64", NULL};

/* ---- what varies ---- */

static const struct lx_parameter vary_parameters[] = {
    {
        .name = "key",
        .label = "Key",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_vary, key),
        .required = true,
        .meaning = "the key of the scene that varies, a path such as lights[0].position or lights[0].position[2]",
    },
    {
        .name = "values",
        .label = "Values",
        .type = LX_ANY,
        .offset = offsetof(struct lx_vary, values),
        .meaning = "a list of values: one after the other, or with random: choice any of them",
    },
    {
        .name = "from",
        .label = "From",
        .type = LX_ANY,
        .offset = offsetof(struct lx_vary, from),
        .meaning = "where the steps or the range begin, as the key takes it: a number, or a list of them",
    },
    {
        .name = "to",
        .label = "To",
        .type = LX_ANY,
        .offset = offsetof(struct lx_vary, to),
        .meaning = "where the steps or the range end",
    },
    {
        .name = "steps",
        .label = "Steps",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_vary, steps),
        .legal = LX_BETWEEN(2, 1000000000),
        .meaning = "how many values there are from the first to the last, both included, evenly",
    },
    {
        .name = "random",
        .label = "Random",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_vary, random),
        .choices = random_names,
        .meaning =
            "how a value is drawn: evenly between from and to (uniform, or box of several numbers), evenly in its "
            "logarithm, evenly on a sphere around center, or one of the values",
    },
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct lx_vary, center),
        .count = 3,
        .meaning = "the centre of the sphere that places are drawn on",
    },
    {
        .name = "radius",
        .label = "Radius",
        .type = LX_REAL,
        .offset = offsetof(struct lx_vary, radius),
        .legal = LX_ABOVE(0),
        .meaning = "its radius",
    },
};

enum { KEY, VALUES, FROM, TO, STEPS, RANDOM, CENTER, RADIUS };

/* Which keys go with a way to vary: a bit for each. */
static unsigned keys_of(const struct lx_vary *vary, const char **way)
{
    const unsigned range = 1 << FROM | 1 << TO;
    static const unsigned of_random[] = {range, range, range, 1 << CENTER | 1 << RADIUS, 1 << VALUES};
    static const char *const ways[] = {"random: uniform", "random: log", "random: box", "random: sphere",
                                       "random: choice"};
    if (vary->given & 1 << RANDOM) {
        *way = ways[vary->random];
        return of_random[vary->random] | 1 << RANDOM;
    }
    if (vary->given & 1 << VALUES) {
        *way = "values";
        return 1 << VALUES;
    }
    *way = "steps";
    return range | 1 << STEPS;
}

static void check_vary(const struct lx_check *check, void *parameters)
{
    const struct lx_vary *vary = parameters;
    const char *way;
    const unsigned wanted = keys_of(vary, &way) | 1 << KEY;
    if (!(vary->given & ~(uint64_t)(1 << KEY))) {
        lx_check_report(check, "key", LX_ALL_OF_IT, LX_MSG_STUDY_HOW, NULL);
        return;
    }
    for (unsigned i = 0; i < LX_COUNT(vary_parameters); i++) {
        const bool given = (vary->given >> i & 1) != 0;
        const char *name = vary_parameters[i].name;
        if ((wanted >> i & 1) && !given) {
            struct lx_step step = {check->up, name, 0};
            lx_walk_tell(check->walk, LUXEL_SEVERITY_ERROR, lx_document_place(check->walk->document, check->mapping),
                         &step, LX_MSG_STUDY_NEEDS, LX_ARGS(way));
        } else if (!(wanted >> i & 1) && given) {
            lx_check_report(check, name, LX_ALL_OF_IT, LX_MSG_STUDY_EXCESS, LX_ARGS(way));
        }
    }
    if (vary->values) {
        const struct lx_node *node = lx_document_node(check->walk->document, vary->values);
        if (node->kind != LX_SEQUENCE || !node->first)
            lx_check_report(check, "values", LX_ALL_OF_IT, LX_MSG_STUDY_VALUES, NULL);
    }
}

static const struct lx_table vary_table = {
    .parameters = vary_parameters,
    .count = LX_COUNT(vary_parameters),
    .size = sizeof(struct lx_vary),
    .check = check_vary,
};

/* ---- outputs ---- */

static const struct lx_parameter output_parameters[] = {
    {
        .name = "brightness",
        .label = "Brightness",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_BRIGHTNESS]),
        .choices = float_names,
        .meaning = "the picture of each scene",
    },
    {
        .name = "irradiance",
        .label = "Irradiance",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_IRRADIANCE]),
        .choices = float_names,
        .meaning = "the irradiance of each pixel",
    },
    {
        .name = "mask",
        .label = "Mask",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_MASK]),
        .choices = mask_names,
        .meaning = "1 where a pixel shows a surface, else 0",
    },
    {
        .name = "normals",
        .label = "Normals",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_NORMALS]),
        .choices = float_names,
        .meaning = "the unit normal of what a pixel shows; 0, 0, 0 where that is nothing",
    },
    {
        .name = "depth",
        .label = "Depth",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_DEPTH]),
        .choices = float_names,
        .meaning = "how far what a pixel shows is from the observer along the axis of view, in mm; 0: nothing",
    },
    {
        .name = "probes",
        .label = "Probes",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_PROBES]),
        .choices = exact_names,
        .meaning = "the exact values of the scene's points",
    },
    {
        .name = "statistics",
        .label = "Statistics",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_STATISTICS]),
        .choices = exact_names,
        .meaning = "maximum, minimum, mean, lit share and the number of pixels on a surface",
    },
    {
        .name = "light_positions",
        .label = "Light positions",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_LIGHT_POSITIONS]),
        .choices = place_names,
        .meaning = "where the lights stand: numbers in mm, or a text of directions for programs that relight (lp)",
    },
    {
        .name = "positions",
        .label = "Positions",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_POSITIONS]),
        .choices = exact_names,
        .meaning = "the place that a pixel shows, in mm; 0, 0, 0 where that is nothing",
    },
    {
        .name = "surfaces",
        .label = "Surfaces",
        .type = LX_CHOICE,
        .offset = offsetof(struct lx_study_wanted, words[LUXEL_STUDY_SURFACES]),
        .choices = index_names,
        .meaning = "the index of the surface that a pixel shows, from 0 on; -1: nothing",
    },
};

luxel_study_type lx_study_wanted(const struct lx_study_wanted *wanted, luxel_study_output output)
{
    if (!(wanted->given >> output & 1))
        return LUXEL_STUDY_NONE;
    const char *word = output_parameters[output].choices[wanted->words[output]];
    for (luxel_study_type type = LUXEL_STUDY_FLOAT16; luxel_study_type_name(type); type++)
        if (strcmp(luxel_study_type_name(type), word) == 0)
            return type;
    return LUXEL_STUDY_NONE;
}

const char *luxel_study_output_name(luxel_study_output output)
{
    return (unsigned)output < LUXEL_STUDY_OUTPUTS ? output_parameters[output].name : NULL;
}

const char *luxel_study_type_name(luxel_study_type type)
{
    static const char *const names[] = {NULL, "float16", "float32", "float64", "uint8", "lp", "int32"};
    return (unsigned)type < LX_COUNT(names) ? names[type] : NULL;
}

static const struct lx_table outputs_table = {
    .parameters = output_parameters,
    .count = LX_COUNT(output_parameters),
    .size = sizeof(struct lx_study_wanted),
};

/* ---- the study ---- */

static const struct lx_parameter study_parameters[] = {
    {
        .name = "study",
        .label = "Format version",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_study_parameters, study),
        .required = true,
        .legal = LX_BETWEEN(1, 1),
        .meaning = "the version of the study format",
    },
    {
        .name = "scene",
        .label = "Scene",
        .type = LX_TEXT,
        .offset = offsetof(struct lx_study_parameters, scene),
        .meaning = "the base scene: a built-in name, or a file, relative to the study; without it \"report\"",
    },
    {
        .name = "set",
        .label = "Set",
        .type = LX_ANY,
        .offset = offsetof(struct lx_study_parameters, set),
        .meaning = "a list of changes of the base scene, texts such as 'screen.resolution=[128, 128]'",
    },
    {
        .name = "count",
        .label = "Count",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_study_parameters, count),
        .legal = LX_BETWEEN(1, UINT32_MAX),
        .meaning = "how many scenes are drawn where something is random, for each cell of a grid; of a grid alone "
                   "it is the product of its axes",
    },
    {
        .name = "seed",
        .label = "Seed",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_study_parameters, seed),
        .initial = "0",
        .legal = LX_BETWEEN(0, UINT32_MAX),
        .meaning = "another seed draws other scenes",
    },
    {
        .name = "shard",
        .label = "Shard",
        .type = LX_WHOLE,
        .offset = offsetof(struct lx_study_parameters, shard),
        .initial = "256",
        .legal = LX_BETWEEN(1, 1000000),
        .meaning = "how many scenes go into a shard, a folder that is computed and written whole",
    },
    {
        .name = "vary",
        .label = "Vary",
        .type = LX_GROUPS,
        .offset = offsetof(struct lx_study_parameters, vary),
        .initial = "[]",
        .group = &vary_table,
        .meaning = "what varies; of grids the last one changes from scene to scene, the first one least often",
    },
    {
        .name = "outputs",
        .label = "Outputs",
        .type = LX_GROUP,
        .offset = offsetof(struct lx_study_parameters, outputs),
        .group = &outputs_table,
        .meaning = "what is kept of each scene, and as which type of numbers; without it brightness: float32",
    },
};

/* Each element of `set` is a text. */
static void check_study(const struct lx_check *check, void *parameters)
{
    const struct lx_document *document = check->walk->document;
    const struct lx_study_parameters *study = parameters;
    if (!study->set)
        return;
    bool good = lx_document_node(document, study->set)->kind == LX_SEQUENCE;
    for (lx_node_id id = lx_document_node(document, study->set)->first; id; id = lx_document_node(document, id)->next)
        good = good && lx_document_node(document, id)->kind == LX_SCALAR;
    if (!good)
        lx_check_report(check, "set", LX_ALL_OF_IT, LX_MSG_STUDY_SET, NULL);
}

const struct lx_table lx_study_table = {
    .parameters = study_parameters,
    .count = LX_COUNT(study_parameters),
    .size = sizeof(struct lx_study_parameters),
    .check = check_study,
};

luxel_parameters *luxel_study_keys(luxel_translate translate, void *data)
{
    return lx_parameters_of(&lx_study_table, translate, data);
}

luxel_status luxel_study_schema(char **text)
{
    static const char beyond[] =
        "luxel sweep --dry-run refuses some studies that this schema accepts: keys that the base "
        "scene has not, values that a key does not take, keys of one way to vary beside those "
        "of another, a count of a grid alone, and none of random draws.";
    char *schema = text ? lx_schema(&lx_study_table, "Luxel study", beyond) : NULL;
    if (!schema)
        return text ? LUXEL_ERROR_MEMORY : LUXEL_ERROR_ARGUMENT;
    *text = schema;
    return LUXEL_OK;
}
