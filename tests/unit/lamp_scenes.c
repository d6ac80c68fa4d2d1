/* SPDX-License-Identifier: MIT */
/* Random scenes of one surface under one extended source. */
#include "lamp_scenes.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "extended_sources.h"
#include "light/solid/facets.h"
#include "squares.h"

/* One surface without a highlight under one extended source, of the first so many kinds, and, at times, a point. */
static void make_scene_of(int i, int kinds, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0x9E3779B97F4A7C15) * ((uint64_t)i + 1)};
    const struct lx_material material = {.model = LX_LAMBERT, .diffuse = 0.7};
    double direction[3], center[3];
    make_finer_scene(&random, i % 3 == 0, test, direction, center);
    test->surfaces[0].lobe = lx_lobe_prepare(&material);
    test->prepared.emitters.count = 1 + (size_t)(i % 4 == 0);
    const int kind = pick(&random, kinds);
    test->lights[0] = source_of(kind < SOURCES ? kind : PRISM, center, 1000, 0);
    if (kind >= SOURCES) {
        lx_facets_free(test->lights[0].facets);
        test->lights[0].facets = lx_facets_of_cylinder(center, 150, 300, direction, 3);
        assert_non_null(test->lights[0].facets);
    }
    test->lights[0].attenuation = (enum lx_attenuation)(i / 2 % LX_LAWS);
    test->lights[0].k_mm = 300 * (i % 5);
}

/* Beyond the last kind: a wedge, which is not symmetric. */
void make_lamp_scene(int i, struct test_scene *test)
{
    make_scene_of(i, SOURCES + 4, test);
}

/* A highlight of any kind: of whole exponents up to a limit, or of others. */
static struct lx_material random_gloss(struct randomness *random, double most_whole, double least, double most)
{
    struct lx_material material = {.specular = 0.5};
    material.model = pick(random, 2) ? LX_BLINN_PHONG : LX_PHONG;
    material.diffuse = pick(random, 3) ? 0.5 : 0;
    material.shininess = pick(random, 2) ? floor(logarithmic(random, 1, most_whole)) : logarithmic(random, least, most);
    material.highlight = pick(random, 2) ? (int)LX_HIGHLIGHT_PLAIN : pick(random, 3);
    return material;
}

/* Under any one, with a highlight. */
void make_glossy_lamp_scene(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0xBF58476D1CE4E5B9) * ((uint64_t)i + 1)};
    const struct lx_material material = random_gloss(&random, 300, 0.5, 100);
    make_scene_of(i, SOURCES, test);
    test->surfaces[0].lobe = lx_lobe_prepare(&material);
}

/* Under any one, with a highlight that may be as narrow as can be, by any law. */
luxel_precision make_narrow_lamp_scene(int i, struct test_scene *test)
{
    struct randomness random = {.state = UINT64_C(0xBF58476D1CE4E5B9) * ((uint64_t)i + 1)};
    const struct lx_material material = random_gloss(&random, 3000, 0.2, 10000);
    make_scene_of(i, SOURCES, test);
    test->surfaces[0].lobe = lx_lobe_prepare(&material);
    if (pick(&random, 4) == 0)
        test->lights[0].attenuation = (enum lx_attenuation)pick(&random, 3);
    return pick(&random, 3) ? LUXEL_SINGLE : LUXEL_DOUBLE;
}

void clear_lamp_scene(struct test_scene *test)
{
    lx_facets_free(test->lights[0].facets);
}
