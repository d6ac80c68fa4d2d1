/* SPDX-License-Identifier: MIT */
/* What must hold of every scene, each with a name.  To add one: a function in a file of its subject and a line here. */
#ifndef LUXEL_PROPERTIES_PROPERTIES_H
#define LUXEL_PROPERTIES_PROPERTIES_H

#include "trial.h"

struct property {
    const char *name, *meaning;
    bool (*holds)(struct trial *trial); /* of a legal scene; false after trial_fails() */
    unsigned one_in; /* of so many scenes one is tried, so that dear ones take no longer than others */
};

/* values.c */
bool is_finite(struct trial *trial);
bool has_shares(struct trial *trial);
bool has_pixel_values(struct trial *trial);
bool reaches_tolerance(struct trial *trial);
/* accuracy.c */
bool is_true_in_single(struct trial *trial);
bool is_true_in_double(struct trial *trial);
bool is_true_in_panels(struct trial *trial);
/* symmetry.c */
bool is_mirrored_in_x(struct trial *trial);
bool is_mirrored_in_y(struct trial *trial);
bool is_turned(struct trial *trial);
bool ignores_order(struct trial *trial);
/* sums.c */
bool is_sum_of_lights(struct trial *trial);
bool scales_with_lights(struct trial *trial);
bool is_white_by_pi(struct trial *trial);
/* clusters.c */
bool keeps_light_error(struct trial *trial);
/* grids.c */
bool has_cells_of_elements(struct trial *trial);
bool has_cells_that_add_up(struct trial *trial);
bool has_cells_that_turn(struct trial *trial);
bool has_grid_within_bounds(struct trial *trial);
/* files.c */
bool reads_clouds(struct trial *trial);
bool reads_meshes(struct trial *trial);
/* bytes.c */
bool ignores_threads(struct trial *trial);
bool ignores_stride(struct trial *trial);
bool agrees_by_sets(struct trial *trial);
bool reads_back(struct trial *trial);

#endif
