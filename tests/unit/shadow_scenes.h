/* SPDX-License-Identifier: MIT */
/* Random scenes in which surfaces of all kinds stand between a plate and an extended source. */
#ifndef TESTS_UNIT_SHADOW_SCENES_H
#define TESTS_UNIT_SHADOW_SCENES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* xorshift64*: the same scenes on every machine */
struct dice {
    uint64_t state;
};

double dice_uniform(struct dice *dice, double low, double high);
int dice_pick(struct dice *dice, int count);

enum { MOST_TEXT = 4096 };
struct text {
    char words[MOST_TEXT];
    size_t length;
};

enum { SPHERE, RECTANGLE, DISK, CYLINDER, KINDS };
enum { WINDOW, POLYGON, LAMP, BOX, GLOBE, TUBE, SOURCES };

/* A plate at the origin that looks up, four times as large as the screen, with a surface of some kind and maybe others
 * over it, and a source of some kind. */
struct text shadow_scene(struct dice *dice, int kind, int source, bool glossy, double size_mm);

#endif
