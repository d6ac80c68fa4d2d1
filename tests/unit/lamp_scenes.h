/* SPDX-License-Identifier: MIT */
/* Random scenes of one surface, seen so finely that squares fit, under one extended source of any kind; each is to be
 * cleared. */
#ifndef TESTS_UNIT_LAMP_SCENES_H
#define TESTS_UNIT_LAMP_SCENES_H

#include "random_scenes.h"

/* Without a highlight; at times with a point besides. */
void make_lamp_scene(int i, struct test_scene *test);

/* With a highlight of a moderate exponent; and with one that may be as narrow as can be, by any law, with the precision
 * that it is to be tried in. */
void make_glossy_lamp_scene(int i, struct test_scene *test);
luxel_precision make_narrow_lamp_scene(int i, struct test_scene *test);

void clear_lamp_scene(struct test_scene *test);

#endif
