/* SPDX-License-Identifier: MIT */
/*
 * The luminaire: a real lamp, whose intensity in every direction a photometry file tells (IES LM-63 or EULUMDAT).  It
 * stands at a place as a point source does; its axis is the direction gamma = 0, or the beam of types A and B, and c0
 * turns it about that.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/pose.h"
#include "../parameter/check.h"
#include "array.h"
#include "distribution.h"
#include "law.h"
#include "opening.h"
#include "placed.h"

struct luminaire_parameters {
    uint64_t given;
    const char *file;
    double position_mm[3];
    struct lx_shining shining;
    double c0[3];
    double flux;
    double factor;
    double maintenance;
    int interpolation; /* luxel_photometry_interpolation */
    struct lx_opening opening;
    struct lx_distribution *distribution; /* what was read of the file */
    struct lx_pointed *pointed;           /* and as it hangs */
    struct lx_array array;
};

static const char *const interpolation_names[] = {"angle", "cosine", NULL};

static const struct lx_parameter luminaire_parameters[] = {
    {
        .name = "file",
        .label = "File",
        .type = LX_TEXT,
        .offset = offsetof(struct luminaire_parameters, file),
        .required = true,
        .meaning = "a photometry file, IES LM-63 (.ies) or EULUMDAT (.ldt), with the intensity in every direction; "
                   "relative to the folder of the scene, or to the current one where the scene comes from standard "
                   "input",
    },
    {
        .name = "position",
        .label = "Position",
        .type = LX_REALS,
        .offset = offsetof(struct luminaire_parameters, position_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .advised = {LX_BETWEEN(-10000, 10000), LX_BETWEEN(-10000, 10000), LX_BETWEEN(100, 10000)},
        .meaning = "where the photometric centre is, from which the intensities were measured",
    },
    LX_SHINING_PARAMETERS(struct luminaire_parameters, shining),
    {
        .name = "c0",
        .label = "Direction C0",
        .type = LX_REALS,
        .offset = offsetof(struct luminaire_parameters, c0),
        .count = 3,
        .nonzero = true,
        .meaning = "the direction towards which the plane C = 0 lies, or the horizontal angles of types A and B grow, "
                   "made perpendicular to the axis; (1, 0, 0) where it is not given, or (0, 1, 0) where that is "
                   "parallel to the axis",
    },
    {
        .name = "flux",
        .label = "Flux",
        .type = LX_REAL,
        .offset = offsetof(struct luminaire_parameters, flux),
        .unit = LX_UNIT_POWER,
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0.1, 1e6)},
        .meaning = "the flux that the luminaire emits in all, to which its intensities are scaled; without it they are "
                   "those of the file",
    },
    {
        .name = "factor",
        .label = "Factor",
        .type = LX_REAL,
        .offset = offsetof(struct luminaire_parameters, factor),
        .initial = "1",
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0.01, 100)},
        .meaning = "a factor of all intensities, such as a dimmer's",
    },
    {
        .name = "maintenance_factor",
        .label = "Maintenance factor",
        .type = LX_REAL,
        .offset = offsetof(struct luminaire_parameters, maintenance),
        .initial = "1",
        .legal = {.given = true, .low = 0, .high = 1, .low_open = true},
        .advised = {LX_BETWEEN(0.5, 1)},
        .meaning = "the share of its light that the luminaire still gives when it is due to be cleaned and its lamps "
                   "changed; it multiplies all intensities, so that results are maintained values",
    },
    {
        .name = "interpolation",
        .label = "Interpolation",
        .type = LX_CHOICE,
        .offset = offsetof(struct luminaire_parameters, interpolation),
        .choices = interpolation_names,
        .initial = "angle",
        .meaning = "how the intensity goes on between the angles of the file: linear in both of them, or in the "
                   "horizontal angle and the cosine of the other, with which the flux is that of the zone rule",
    },
    {
        .name = "opening",
        .label = "Luminous opening",
        .type = LX_GROUP,
        .offset = offsetof(struct luminaire_parameters, opening),
        .group = &lx_opening_table,
        .choices = lx_opening_words,
        .initial = "point",
        .meaning = "where the light comes from: from one point, from the luminous opening that the file declares, or "
                   "from a shape; each part of it shines as the whole luminaire does, with its share of the intensity",
    },
    LX_ARRAY_PARAMETER(struct luminaire_parameters),
};

static const struct lx_rule luminaire_rules[] = {
    LX_SHINING_RULES,
    {LX_RULE_DISTINCT, "aim", "position", NULL},
};

static void check_luminaire(const struct lx_check *check, void *parameters);

static void release_luminaire(void *parameters)
{
    struct luminaire_parameters *luminaire = parameters;
    lx_kept_release((struct lx_kept *)luminaire->distribution);
    free(luminaire->pointed);
    luminaire->distribution = NULL;
    luminaire->pointed = NULL;
}

static const struct lx_table luminaire_table = {
    .parameters = luminaire_parameters,
    .count = LX_COUNT(luminaire_parameters),
    .rules = luminaire_rules,
    .rule_count = LX_COUNT(luminaire_rules),
    .size = sizeof(struct luminaire_parameters),
    .check = check_luminaire,
    .release = release_luminaire,
};

/* ---- the file ---- */

/* Reads the file; what is wrong with it is reported at its own lines, and that it is so at the key. */
static struct lx_photometry *read_photometry(const struct lx_check *check, const char *path)
{
    struct lx_photometry *photometry = NULL;
    size_t length;
    char *text = lx_check_read(check, "file", path, LX_LARGEST_PHOTOMETRY, &length);
    if (!text)
        return NULL;
    luxel_diagnostics *errors = check->walk->diagnostics;
    luxel_status status = lx_photometry_read_text(text, length, path, errors, NULL, &photometry);
    free(text);
    if (status == LUXEL_ERROR_MEMORY)
        check->walk->out_of_memory = true;
    else if (status != LUXEL_OK)
        lx_check_report(check, "file", LX_ALL_OF_IT, LX_MSG_LUMINAIRE_FILE, LX_ARGS(path));
    return status == LUXEL_OK ? photometry : NULL;
}

/* Reads the file, unless the scene has done so already; false where that failed, which is reported. */
static bool load(const struct lx_check *check, struct luminaire_parameters *luminaire, const char *path)
{
    const luxel_photometry_interpolation interpolation = (luxel_photometry_interpolation)luminaire->interpolation;
    luminaire->distribution =
        (struct lx_distribution *)lx_check_kept(check, path, lx_distribution_free_of(interpolation));
    if (luminaire->distribution)
        return true;
    struct lx_photometry *photometry = read_photometry(check, path);
    if (!photometry)
        return false;
    luminaire->distribution = lx_distribution_make(photometry, interpolation);
    lx_kept_release(&photometry->kept);
    if (luminaire->distribution)
        lx_check_keep(check, path, &luminaire->distribution->kept);
    else
        check->walk->out_of_memory = true;
    return luminaire->distribution;
}

/* Warnings about the file, which is read once more for them. */
static void advise_file(const struct lx_check *check, const struct luminaire_parameters *luminaire)
{
    char *path = luminaire->distribution ? lx_check_path(check, luminaire->file) : NULL;
    size_t length;
    char *text = path ? lx_check_read(check, "file", path, LX_LARGEST_PHOTOMETRY, &length) : NULL;
    struct lx_photometry *photometry = NULL;
    if (text && lx_photometry_read_text(text, length, path, NULL, check->walk->diagnostics, &photometry) == LUXEL_OK)
        lx_kept_release(&photometry->kept);
    free(text);
    free(path);
}

/* Tells where `opening: file` changes nothing. */
static void advise_opening(const struct lx_check *check, const struct luminaire_parameters *luminaire)
{
    if (luminaire->opening.word == LX_OPENING_IS_OF_FILE && luminaire->distribution &&
        luminaire->distribution->photometry->shown.opening.shape == LUXEL_OPENING_POINT)
        lx_check_advise(check, "opening", LX_MSG_OPENING_IS_POINT, LX_ARGS(luminaire->file));
}

/* ---- how it hangs ---- */

static bool is_aimed(const struct luminaire_parameters *luminaire)
{
    return lx_is_given(&luminaire_table, luminaire, "aim");
}

static void axis_of(const struct luminaire_parameters *luminaire, double axis[3])
{
    for (int i = 0; i < 3; i++)
        axis[i] =
            is_aimed(luminaire) ? luminaire->shining.aim_mm[i] - luminaire->position_mm[i] : luminaire->shining.axis[i];
}

static bool find_c0(const struct lx_check *check, const struct luminaire_parameters *luminaire, double c0[3])
{
    static const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0};
    const bool is_given = lx_is_given(&luminaire_table, luminaire, "c0");
    double axis[3];
    axis_of(luminaire, axis);
    memcpy(c0, is_given ? luminaire->c0 : lx_are_parallel(axis, x) ? y : x, sizeof x);
    if (!lx_are_parallel(axis, c0))
        return true;
    lx_check_report(check, "c0", LX_ALL_OF_IT, LX_MSG_C0_PARALLEL, NULL);
    return false;
}

static void hang(const struct lx_check *check, struct luminaire_parameters *luminaire, const double c0[3])
{
    const struct lx_distribution *distribution = luminaire->distribution;
    luminaire->pointed = malloc(sizeof *luminaire->pointed);
    if (!luminaire->pointed)
        check->walk->out_of_memory = true;
    else if (is_aimed(luminaire))
        lx_aim_distribution(distribution, luminaire->position_mm, luminaire->shining.aim_mm, c0, luminaire->pointed);
    else
        lx_point_distribution(distribution, luminaire->shining.axis, c0, luminaire->pointed);
}

/* By what the intensities of the file are multiplied, the flux apart. */
static double factors_of(const struct luminaire_parameters *luminaire)
{
    return luminaire->factor * luminaire->maintenance;
}

static bool has_flux(const struct luminaire_parameters *luminaire)
{
    return lx_is_given(&luminaire_table, luminaire, "flux");
}

/* A luminaire that is dark cannot be scaled to a flux, and what is scaled must be numbers. */
static void check_flux(const struct lx_check *check, const struct luminaire_parameters *luminaire, const char *path)
{
    const struct lx_distribution *distribution = luminaire->distribution;
    const double scale = distribution->unit_cd * factors_of(luminaire);
    if (has_flux(luminaire) && luminaire->flux > 0 && !(distribution->zone_lumens > 0))
        lx_check_report(check, "flux", LX_ALL_OF_IT, LX_MSG_LUMINAIRE_DARK, LX_ARGS(path));
    else if (has_flux(luminaire) && !isfinite(luminaire->flux / distribution->zone_lumens * scale))
        lx_check_report(check, "flux", LX_ALL_OF_IT, LX_MSG_POWER_TOO_LARGE, NULL);
}

/* The opening that the luminaire has as a shape; false: it is a point. */
static bool find_opening(const struct luminaire_parameters *luminaire, struct lx_opening *opening)
{
    *opening = luminaire->opening;
    if (luminaire->opening.word == LX_OPENING_IS_OF_FILE)
        return lx_opening_of_file(&luminaire->distribution->photometry->shown.opening, luminaire->pointed, opening);
    return luminaire->opening.word != LX_OPENING_IS_POINT;
}

static void check_luminaire(const struct lx_check *check, void *parameters)
{
    struct luminaire_parameters *luminaire = parameters;
    double c0[3];
    if (check->advises) {
        advise_file(check, luminaire);
        advise_opening(check, luminaire);
        return;
    }
    const bool hangs = find_c0(check, luminaire, c0);
    char *path = lx_check_path(check, luminaire->file);
    if (path && load(check, luminaire, path)) {
        check_flux(check, luminaire, path);
        if (hangs)
            hang(check, luminaire, c0);
    }
    free(path);
}

/* ---- the kind ---- */

static int prepare_luminaire(const void *parameters, struct lx_emitters *emitters)
{
    const struct luminaire_parameters *luminaire = parameters;
    const struct lx_distribution *distribution = luminaire->distribution;
    struct lx_emitter emitter =
        lx_shining_emitter(&luminaire->shining, luminaire->position_mm, distribution->unit_cd * factors_of(luminaire),
                           lx_profile_luminaire(luminaire->pointed));
    const bool is_scaled = has_flux(luminaire) && distribution->zone_lumens > 0;
    if (is_scaled)
        emitter.strength *= luminaire->flux / distribution->zone_lumens;
    /* the zone rule's sums have as many roundings as the table has lines at most */
    const double lines = (double)(distribution->azimuth_count + distribution->polar_count);
    const double roundings = factors_of(luminaire) != 1 ? 2 : 0;
    emitter.strength_error = emitter.strength * DBL_EPSILON * (is_scaled ? lines + 8 : roundings);
    struct lx_opening opening;
    return find_opening(luminaire, &opening) ? lx_opening_emit(&opening, &emitter, emitters)
                                             : lx_emitters_append(emitters, &emitter);
}

static double opening_of(const void *parameters)
{
    const struct luminaire_parameters *luminaire = parameters;
    if (luminaire->opening.word != LX_OPENING_IS_POINT)
        return 0; /* it counts as what it is */
    const luxel_photometry_opening *opening = &luminaire->distribution->photometry->shown.opening;
    return opening->shape == LUXEL_OPENING_POINT
               ? 0
               : fmax(fmax(opening->width_mm, opening->length_mm), opening->height_mm);
}

static const luxel_photometry *photometry_of(const void *parameters, const char **file)
{
    const struct luminaire_parameters *luminaire = parameters;
    *file = luminaire->file;
    return &luminaire->distribution->photometry->shown;
}

const struct lx_light_kind lx_luminaire_kind = {
    .variant =
        {
            .name = "luminaire",
            .meaning = "a real lamp, by its photometry file (IES LM-63 or EULUMDAT)",
            .table = &luminaire_table, /* no example: it would need a file */
        },
    .prepare = prepare_luminaire,
    .opening_mm = opening_of,
    .photometry = photometry_of,
};
