/* SPDX-License-Identifier: MIT */
/* A draft on trial: its scene, what was computed of it so far, and what is wrong. */
#ifndef LUXEL_PROPERTIES_TRIAL_H
#define LUXEL_PROPERTIES_TRIAL_H

#include <luxel/luxel.h>

#include "draft.h"

struct trial {
    const struct draft *draft;
    luxel_scene *scene;       /* NULL: the draft is no legal scene */
    luxel_field *pictures[2]; /* of brightness, by precision */
    bool is_rendered[2];
    luxel_evaluator *evaluator;
    char complaint[400];   /* what does not hold, with its values */
    unsigned long pixels;  /* that were compared with the truth, */
    unsigned long vague;   /* those of them where its own error is larger than what the picture may be off by, */
    unsigned long excused; /* and those that miss it but show what is true nearby */
};

void trial_open(const struct draft *draft, struct trial *trial);
void trial_close(struct trial *trial);

/* Notes what does not hold; false. */
__attribute__((format(printf, 2, 3))) bool trial_fails(struct trial *trial, const char *format, ...);

/* The scene of a draft, committed; NULL where it is none. */
luxel_scene *trial_scene_of(const struct draft *draft);
/* The usual settings: one thread, brightness. */
luxel_settings trial_settings(luxel_precision precision);
/* A picture, to be freed; NULL where a value is beyond the precision. */
luxel_field *trial_render(const luxel_scene *scene, const luxel_settings *settings);
/* The picture of a draft, likewise to be freed. */
luxel_field *trial_render_draft(const struct draft *draft, const luxel_settings *settings);

/* The scene's picture by the usual settings, kept with the trial; NULL where a value is beyond the precision. */
const luxel_field *trial_picture(struct trial *trial, luxel_precision precision);
/* The scene's exact brightness, kept with the trial. */
const luxel_evaluator *trial_evaluator(struct trial *trial);

double trial_maximum(const luxel_field *picture);

/* What a picture may be off by: SPEC's share of its maximum, with room for what lies below the normal numbers. */
double trial_slack(const struct trial *trial, const luxel_field *picture);

#endif
