/* SPDX-License-Identifier: MIT */
/* The table of a potential: a tree of patches, and polynomials of Chebyshev on them. */
#include "sky_potential.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/vector.h"

enum {
    TERMS = 10,  /* of a polynomial, by either angle */
    AXES = 4,    /* three, and one for alignment */
    BANDS = 4,   /* into which chi is divided first, */
    SECTORS = 4, /* and phi */
    DEEPEST = 6,
    MOST_LEAVES = 6000,
    NO_LEAF = -1
};

/* How exact it shall be, of the light of the whole sky. */
static const double EXACT = 2e-8;

/* From where to where, in bands and sectors: exactly, by halves. */
struct patch {
    double chi[2], phi[2];
};

struct leaf {
    struct patch patch;
    double error;
    double terms[TERMS][TERMS][AXES]; /* by chi, then by phi */
};

/* A branch of the tree leads to the first of four, those of low chi before, or to a leaf. */
struct branch {
    int first, leaf;
};

struct lx_sky_potential {
    const struct lx_sky *sky;
    struct lx_glass_pane pane;
    bool has_pane, is_good;
    double frame[3][3];     /* across the pole, counter-clockwise, and the pole */
    double band_rad, whole; /* of a band of chi; about what the whole sky gives to a plane that faces it */
    struct branch *branches;
    size_t branch_count, branch_capacity;
    struct leaf *leaves;
    size_t leaf_count, leaf_capacity;
    double cosines[TERMS][TERMS]; /* of the terms at the nodes */
};

/* ---- what is integrated ---- */

static double kernel(const struct lx_sky_potential *potential, const double towards[3])
{
    const struct lx_sky *sky = potential->sky;
    double value = 1;
    if (sky && sky->kind == LX_SKY_OVERCAST) /* smooth beyond the horizon, too */
        value = (1 + 2 * lx_dot(sky->up, towards)) / 3;
    else if (sky)
        value = lx_sky_luminance(sky, towards);
    if (potential->has_pane)
        value *= lx_pane_transmittance(&potential->pane, -lx_dot(potential->pane.axis, towards));
    return value;
}

static void direction_of(const struct lx_sky_potential *potential, double band, double sector, double towards[3])
{
    const double chi = band * potential->band_rad, phi = (sector * (2.0 / SECTORS) - 1) * M_PI;
    const double x = sin(chi) * cos(phi), y = sin(chi) * sin(phi), z = cos(chi);
    for (int k = 0; k < 3; k++)
        towards[k] = x * potential->frame[0][k] + y * potential->frame[1][k] + z * potential->frame[2][k];
}

/* ---- the tree ---- */

static const struct leaf *find_leaf(const struct lx_sky_potential *potential, double band, double sector)
{
    const int row = (int)fmin(fmax(ceil(band) - 1, 0), BANDS - 1), column = (int)fmin(fmax(sector, 0), SECTORS - 1);
    const struct branch *branch = &potential->branches[row * SECTORS + column];
    double low_chi = row, low_phi = column, size = 1;
    while (branch->first >= 0) {
        size /= 2;
        const bool is_far = band > low_chi + size, is_beyond = sector > low_phi + size;
        low_chi += is_far ? size : 0;
        low_phi += is_beyond ? size : 0;
        branch = &potential->branches[branch->first + 2 * is_far + is_beyond];
    }
    return &potential->leaves[branch->leaf];
}

/* The values of the terms at a place between -1 and 1. */
static void find_terms(double x, double terms[TERMS])
{
    terms[0] = 1;
    terms[1] = x;
    for (int k = 2; k < TERMS; k++)
        terms[k] = 2 * x * terms[k - 1] - terms[k - 2];
}

static double share_of(const double range[2], double value)
{
    return fmin(fmax((2 * value - range[0] - range[1]) / (range[1] - range[0]), -1), 1);
}

static void value_on(const struct leaf *leaf, double band, double sector, double sum[AXES])
{
    double by_chi[TERMS], by_phi[TERMS];
    find_terms(share_of(leaf->patch.chi, band), by_chi);
    find_terms(share_of(leaf->patch.phi, sector), by_phi);
    memset(sum, 0, AXES * sizeof *sum);
    for (int i = 0; i < TERMS; i++) {
        double row[AXES] = {0};
        for (int j = 0; j < TERMS; j++)
            for (int k = 0; k < AXES; k++)
                row[k] += by_phi[j] * leaf->terms[i][j][k];
        for (int k = 0; k < AXES; k++)
            sum[k] += by_chi[i] * row[k];
    }
}

/* ---- making it ---- */

/* The nodes are where the term after the last one is 0. */
static double node_at(const double range[2], int i)
{
    return (range[0] + range[1]) / 2 - (range[1] - range[0]) / 2 * cos(M_PI * (i + 0.5) / TERMS);
}

/* From values at the nodes to terms. */
static void transform(const struct lx_sky_potential *potential, const double values[TERMS], double terms[TERMS])
{
    for (int k = 0; k < TERMS; k++) {
        terms[k] = 0;
        for (int i = 0; i < TERMS; i++)
            terms[k] += (k == 0 ? 1.0 : 2.0) / TERMS * potential->cosines[k][i] * values[i];
    }
}

/* From the terms of a function to those of its integral from the beginning of the range; the term that is one too many
 * is left out. */
static void integrate(double terms[TERMS], double width, double start)
{
    double sum[TERMS] = {0}, at_begin = 0;
    for (int k = 1; k < TERMS; k++)
        sum[k] = width / 2 * ((k == 1 ? 2 : 1) * terms[k - 1] - (k + 1 < TERMS ? terms[k + 1] : 0)) / (2 * k);
    for (int k = 1; k < TERMS; k++)
        at_begin += k % 2 ? -sum[k] : sum[k];
    sum[0] = start - at_begin;
    memcpy(terms, sum, sizeof sum);
}

/* The polynomials of a patch, and how far they may be off: by how small the last terms are. */
static void fit(const struct lx_sky_potential *potential, struct leaf *leaf)
{
    static const double CAUTION = 4;
    const double width = (leaf->patch.chi[1] - leaf->patch.chi[0]) * potential->band_rad;
    double columns[AXES - 1][TERMS][TERMS], last = 0; /* by chi at the nodes of phi */
    for (int j = 0; j < TERMS; j++) {
        const double phi = node_at(leaf->patch.phi, j);
        double values[AXES - 1][TERMS], start[AXES] = {0}, towards[3];
        if (leaf->patch.chi[0] > 0)
            value_on(find_leaf(potential, leaf->patch.chi[0], phi), leaf->patch.chi[0], phi, start);
        for (int i = 0; i < TERMS; i++) {
            const double chi = node_at(leaf->patch.chi, i);
            direction_of(potential, chi, phi, towards);
            const double light = kernel(potential, towards) * sin(chi * potential->band_rad);
            for (int k = 0; k < 3; k++)
                values[k][i] = light * towards[k];
        }
        for (int k = 0; k < 3; k++) {
            transform(potential, values[k], columns[k][j]);
            last = fmax(last, width / 2 * (fabs(columns[k][j][TERMS - 1]) + fabs(columns[k][j][TERMS - 2])) / TERMS);
            integrate(columns[k][j], width, start[k]);
        }
    }
    double beyond = 0;
    for (int k = 0; k < 3; k++) {
        double off = 0;
        for (int i = 0; i < TERMS; i++) {
            double row[TERMS], terms[TERMS];
            for (int j = 0; j < TERMS; j++)
                row[j] = columns[k][j][i];
            transform(potential, row, terms);
            for (int j = 0; j < TERMS; j++)
                leaf->terms[i][j][k] = terms[j];
            off += fabs(terms[TERMS - 1]) + fabs(terms[TERMS - 2]);
        }
        beyond = fmax(beyond, off);
    }
    leaf->error = CAUTION * (last + beyond);
}

/* Whether a way in a patch may count. */
static bool may_count(const struct lx_sky_potential *potential, const struct patch *patch)
{
    double middle[3];
    direction_of(potential, (patch->chi[0] + patch->chi[1]) / 2, (patch->phi[0] + patch->phi[1]) / 2, middle);
    const double reach =
        (patch->chi[1] - patch->chi[0]) * potential->band_rad / 2 + (patch->phi[1] - patch->phi[0]) * (M_PI / SECTORS);
    const double below = -sin(fmin(reach, M_PI_2));
    return !(potential->sky && lx_dot(potential->sky->up, middle) < below) &&
           !(potential->has_pane && -lx_dot(potential->pane.axis, middle) < below);
}

/* Sets a branch that is there; 0, or -1. */
static int grow(struct lx_sky_potential *potential, size_t branch, const struct patch *patch, int depth)
{
    struct leaf leaf = {.patch = *patch};
    fit(potential, &leaf);
    if (leaf.error <= EXACT * potential->whole || depth == DEEPEST || !may_count(potential, patch)) {
        if (potential->leaf_count == MOST_LEAVES ||
            lx_reserve(&potential->leaves, &potential->leaf_capacity, potential->leaf_count + 1, sizeof leaf))
            return -1;
        potential->branches[branch] = (struct branch){-1, (int)potential->leaf_count};
        potential->leaves[potential->leaf_count++] = leaf;
        return 0;
    }
    const size_t first = potential->branch_count;
    if (lx_reserve(&potential->branches, &potential->branch_capacity, first + 4, sizeof *potential->branches))
        return -1;
    potential->branch_count += 4;
    potential->branches[branch] = (struct branch){(int)first, NO_LEAF};
    for (size_t i = 0; i < 4; i++) {
        struct patch part = *patch;
        part.chi[i < 2] = (patch->chi[0] + patch->chi[1]) / 2;
        part.phi[i % 2 == 0] = (patch->phi[0] + patch->phi[1]) / 2;
        if (grow(potential, first + i, &part, depth + 1))
            return -1;
    }
    return 0;
}

static int grow_all(struct lx_sky_potential *potential)
{
    potential->branch_count = BANDS * SECTORS;
    if (lx_reserve(&potential->branches, &potential->branch_capacity, potential->branch_count,
                   sizeof *potential->branches))
        return -1;
    for (int i = 0; i < BANDS; i++)
        for (int j = 0; j < SECTORS; j++) {
            const struct patch patch = {{i, i + 1}, {j, j + 1}};
            if (grow(potential, (size_t)(i * SECTORS + j), &patch, 0))
                return -1;
        }
    return 0;
}

struct lx_sky_potential *lx_sky_potential_new(const struct lx_sky *sky, const struct lx_glass_pane *opening)
{
    struct lx_sky_potential *potential = lx_new_array(1, sizeof *potential);
    double outwards[3];
    if (!potential)
        return NULL;
    potential->sky = sky;
    potential->has_pane = opening && opening->index > 0;
    if (potential->has_pane)
        potential->pane = *opening;
    for (int k = 0; k < 3; k++)
        outwards[k] = -potential->pane.axis[k];
    const bool is_before_sun = !potential->has_pane || (sky && sky->c != 0 && lx_dot(outwards, sky->sun) > 0);
    const double *pole = is_before_sun ? sky->sun : outwards;
    potential->band_rad = (is_before_sun ? M_PI : M_PI_2) / BANDS;
    memcpy(potential->frame[2], pole, sizeof potential->frame[2]);
    lx_around_axis(pole, potential->frame[0], potential->frame[1]);
    potential->whole = sky ? lx_sky_horizontal(sky).value : 1;
    for (int k = 0; k < TERMS; k++)
        for (int i = 0; i < TERMS; i++)
            potential->cosines[k][i] = (k % 2 ? -1 : 1) * cos(M_PI * k * (i + 0.5) / TERMS);
    static const double LOWEST = 1e-6; /* the sun opposite to which borders may not lie */
    potential->is_good =
        (potential->has_pane || sky->c == 0 || lx_dot(sky->up, sky->sun) > LOWEST) && !grow_all(potential);
    return potential;
}

void lx_sky_potential_free(struct lx_sky_potential *potential)
{
    if (!potential)
        return;
    free(potential->branches);
    free(potential->leaves);
    free(potential);
}

bool lx_sky_potential_is_of(const struct lx_sky_potential *potential, const struct lx_sky *sky,
                            const struct lx_glass_pane *opening)
{
    const struct lx_glass_pane *own = &potential->pane;
    const bool has_pane = opening && opening->index > 0;
    return potential->sky == sky && potential->has_pane == has_pane &&
           (!has_pane || (own->index == opening->index && own->transmittance == opening->transmittance &&
                          memcmp(own->axis, opening->axis, sizeof own->axis) == 0));
}

bool lx_sky_potential_is_good(const struct lx_sky_potential *potential)
{
    return potential->is_good;
}

double lx_sky_potential_whole(const struct lx_sky_potential *potential)
{
    return potential->whole;
}

const double *lx_sky_potential_pole(const struct lx_sky_potential *potential)
{
    return potential->frame[2];
}

lx_bounded lx_sky_potential_step(const struct lx_sky_potential *potential, const double towards[3],
                                 const double step[3], const double normal[3])
{
    double x = lx_dot(towards, potential->frame[0]), y = lx_dot(towards, potential->frame[1]);
    double across2 = x * x + y * y, turned[3], sum[AXES];
    if (!(across2 > 0))
        return (lx_bounded){0, 0};
    lx_cross(towards, step, turned);
    const double turn = lx_dot(potential->frame[2], turned) / across2;
    const double band = atan2(sqrt(across2), lx_dot(towards, potential->frame[2])) / potential->band_rad;
    const double sector = (atan2(y, x) / M_PI + 1) * (SECTORS / 2.0);
    const struct leaf *leaf = find_leaf(potential, band, sector);
    value_on(leaf, band, sector, sum);
    return (lx_bounded){lx_dot(normal, sum) * turn, leaf->error * fabs(turn)};
}
