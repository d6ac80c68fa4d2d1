/* SPDX-License-Identifier: MIT */
/* Polynomials in place of the highlights of extended sources, against integrals at pixels of random squares. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "campaign.h"
#include "lamp_scenes.h"
#include "squares.h"
#include "world/reference.h"

/* Plans of such scenes take long to make. */
enum { SQUARES = 24 };

static void make_sharp_scene(int i, struct test_scene *test)
{
    make_narrow_lamp_scene(i, test);
}

/* How many squares of each kind; of those with a polynomial how many of each size. */
struct glossy_tally {
    size_t count[3], sides[3];
    double worst;
};

/* The highlights of the extended source at a place on the screen. */
static double exact_gloss(const struct test_scene *test, double x, double y)
{
    struct lx_element element;
    assert_true(lx_element_seen(&test->prepared, x, y, &element));
    return lx_light_element(&test->prepared, &element, &test->lights[0]).specular.value;
}

static void visit_glossy(const struct test_scene *test, struct workplace *work, const struct lx_square *given, int q,
                         struct randomness *random, void *data)
{
    enum { PIXELS = 2, SIZES = 3 };
    const struct lx_plan *plan = &work->plan;
    struct glossy_tally *tally = data;
    struct lx_square square = *given;
    struct lx_polynomial *polynomial = work->fitting.polynomials;
    float values[LX_PANEL_SIDE * LX_PANEL_SIDE] = {0};
    square.side = LX_PANEL_SIDE >> q % SIZES;
    for (int k = 0; k < 2; k++)
        square.half_mm[k] *= square.side / (double)given->side;
    if (!plan->has_gloss)
        return;
    const enum lx_gloss gloss = lx_gloss_fit(plan, &work->fitting, work->shader, &square, NULL, polynomial);
    tally->count[gloss]++;
    if (gloss == LX_GLOSS_ROUGH)
        return;
    if (gloss == LX_GLOSS_SMOOTH) {
        tally->sides[q % SIZES]++;
        plan->kernels->spread_polynomial(polynomial, square.side, square.side, false, values, LX_PANEL_SIDE);
    }
    for (int k = 0; k < PIXELS; k++) {
        const int column = pick(random, (int)square.side), row = pick(random, (int)square.side);
        const double t = (2 * column + 1) / (double)square.side - 1, u = (2 * row + 1) / (double)square.side - 1;
        const double exact =
            exact_gloss(test, square.x_mm + square.half_mm[0] * t, square.y_mm - square.half_mm[1] * u);
        const double off = fabs((double)values[row * LX_PANEL_SIDE + column] - exact);
        tally->worst = fmax(tally->worst, off / fmax(plan->least_maximum, exact));
    }
}

/* Highlights are as good as the tolerance asks, of the maximum: where exponents are moderate, and where a highlight may
 * be far narrower than a square. */
static void glossy_squares(void **state)
{
    (void)state;
    const struct campaign campaigns[] = {
        {.scenes = 60,
         .squares = SQUARES,
         .seed = UINT64_C(0xD1B54A32D192ED03),
         .make = make_glossy_lamp_scene,
         .clear = clear_lamp_scene,
         .visit = visit_glossy},
        {.scenes = 24,
         .squares = SQUARES,
         .seed = UINT64_C(0xA0761D6478BD642F),
         .make = make_sharp_scene,
         .clear = clear_lamp_scene,
         .visit = visit_glossy},
    };
    for (size_t c = 0; c < sizeof campaigns / sizeof *campaigns; c++) {
        struct glossy_tally tally = {.worst = 0};
        visit_by_all_sets(&campaigns[c], &tally);
        print_message("# %zu dark, %zu smooth (%zu large, %zu, %zu small), %zu rough; off by %.2g of the maximum\n",
                      tally.count[LX_GLOSS_DARK], tally.count[LX_GLOSS_SMOOTH], tally.sides[0], tally.sides[1],
                      tally.sides[2], tally.count[LX_GLOSS_ROUGH], tally.worst);
        assert_true(tally.count[LX_GLOSS_DARK] > in_campaign(20) && tally.count[LX_GLOSS_SMOOTH] > in_campaign(50));
        assert_true(tally.worst <= 1e-3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(glossy_squares),
    };
    return cmocka_run_group_tests_name("panel gloss", tests, NULL, NULL);
}
