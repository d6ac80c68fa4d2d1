/* SPDX-License-Identifier: MIT */
/*
 * Explanations and judgements as whole texts, of which a short sum is kept: whatever changes in one shows.  Numbers
 * count to six digits, and what lies beyond rounding's reach not at all.  LUXEL_TEXTS=print tells the sums that are
 * found, and the texts.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/exercise.h>

#include "scenes.h"

struct asked {
    const char *scene, *change;
    double x_mm, y_mm;
    bool is_irradiance;
    uint32_t explained, judged;
};

static const struct asked asked[] = {
    {"report", NULL, 0, 0, false, 0x418304c5, 0x6e7b4a47},
    {"report", NULL, 150, 0, false, 0xd6624837, 0x8e08b1fb},
    {"report", NULL, -150, 0, false, 0x709a739e, 0x4c8a0197},
    {"report", NULL, 40, 70, false, 0xaf281d79, 0xf7e658bf},
    {"spot", NULL, 0, 0, false, 0x35fe76df, 0x8889b5a1},
    {"spot", NULL, 100, 80, false, 0x7aaf0e5c, 0xbade14c5},
    {"spot", NULL, -200, -100, false, 0x1f45f805, 0xda4076ff},
    {"two-spheres", NULL, -100, 0, false, 0xf112111f, 0x2d359bbd},
    {"two-spheres", NULL, 210, 130, false, 0xe0c482af, 0x643d6b11},
    {"two-spheres", NULL, 60, 60, false, 0x9f6a7589, 0x2d359bbd},
    {"three-lights", NULL, 0, 0, false, 0xfc9d3fe8, 0xc3f082a7},
    {"three-lights", NULL, -120, 120, false, 0x400641e3, 0x65441adb},
    {"three-lights", NULL, 0, -300, false, 0xad7383b8, 0x1fc00105},
    {"distant", NULL, 0, 0, false, 0x4611d18b, 0x658e159b},
    {"distant", NULL, 80, -60, false, 0x99b78d97, 0x9d5a0ed7},
    {"desk", NULL, 0, 100, false, 0x07a28d16, 0xf5b2d1b5},
    {"desk", NULL, 150, -100, false, 0xda360f56, 0xce723d37},
    {"desk", NULL, -250, -150, false, 0x2cf940d9, 0xa2747eaf},
    {"ambient", NULL, 0, 0, false, 0x17d15da6, 0xb17411e1},
    {"report", "surfaces[0].material.model=phong", 70, -40, false, 0x55b867f3, 0xb82d6357},
    {"report", "surfaces[0].material.model=lambert", 70, -40, false, 0xb74be209, 0x2a7dc387},
    {"report", "surfaces[0].material.highlight=gated", 70, -40, false, 0xaa7c5d65, 0xfbbd7797},
    {"report", "surfaces[0].material.highlight=cosine", 70, -40, false, 0x52af047a, 0xc649181f},
    {"report", "surfaces[0].material.normalized=true", 70, -40, false, 0x90e863c8, 0x861dc74e},
    {"report", "surfaces[0].material.over_pi=true", 70, -40, false, 0x17a34305, 0xe5fc45c5},
    {"report", "surfaces[0].material.shininess=3.5", 70, -40, false, 0x7b7bc5ad, 0xf7d82d9a},
    {"report", "observer.projection=perspective", 70, -40, false, 0xcead47fa, 0xf5413b1f},
    {"report", "observer.view=observer", 70, -40, false, 0x31a72363, 0x4924570f},
    {"report", "screen.sampling=centers", 70, -40, false, 0xa40b75d7, 0xfbbd7797},
    {"report", "lights[0].attenuation=inverse-square", 70, -40, false, 0x516b964d, 0x0e62aa37},
    {"report", "lights[0]={type: point, position: [2000, 0, 2000], intensity: 10, attenuation: practical, k: 500}", 70,
     -40, false, 0x446253cb, 0xe4cedf77},
    {"report",
     "lights[0]={type: point, position: [2000, 0, 2000], intensity: 10, pattern: lambertian, aim: [0, 0, 1000]}", 70,
     -40, false, 0x71e81853, 0x1f54e277},
    {"report",
     "lights[0]={type: point, position: [2000, 0, 2000], intensity: 10, pattern: cosine, exponent: 2.5, aim: [0, 0, "
     "1000]}",
     70, -40, false, 0x0ae884fc, 0x82f7dc74},
    {"report", "picture.range=minmax", 70, -40, false, 0x31c389e1, 0xfbbd7797},
    {"report", "picture.range=log", 70, -40, false, 0x31c389e1, 0xfbbd7797},
    {"report", "picture.range=[1,9]", 70, -40, false, 0x31c389e1, 0xfbbd7797},
    {"report", "picture.rounding=nearest", 70, -40, false, 0x31c389e1, 0xfbbd7797},
    {"report", "shadows=none", 70, -40, false, 0x31c389e1, 0xfbbd7797},
    {"report", "units=photometric", 70, -40, false, 0x9252d4fa, 0xfbbd7797},
    {"spot", "lights[0].falloff=linear", 20, 170, false, 0xc35df547, 0x9b10062d},
    {"spot", "lights[0].falloff=squared", 20, 170, false, 0x498e7b81, 0x9b10062d},
    {"spot", "lights[0].falloff=hard", 20, 170, false, 0x99b59d30, 0x9b10062d},
    {"spot", "lights[0].falloff=smoothstep", 20, 170, false, 0xeed1f1a4, 0x9b10062d},
    {"report", NULL, 20, 30, true, 0x85e5a8d4, 0x3dbb09af},
    {"spot", NULL, 20, 30, true, 0x7074e74b, 0xed907966},
    {"two-spheres", NULL, 20, 30, true, 0xbd938d2f, 0x51cb566f},
    {"desk", NULL, 20, 30, true, 0xfc1eecea, 0x997c5a37},
    {"1", NULL, 30, 20, false, 0x302675b5, 0x16bf39ff},
    {"2", NULL, 30, 20, false, 0xd727649d, 0x651f2fb7},
    {"3", NULL, 30, 20, false, 0x60560cb2, 0x8ff321f9},
    {"4", NULL, 30, 20, false, 0x9d0fbefa, 0xc8fc24dd},
};

static bool prints(void)
{
    const char *wish = getenv("LUXEL_TEXTS");
    return wish && strcmp(wish, "print") == 0;
}

/* Adds a text to a sum (Fowler, Noll, Vo), of each number the first six digits. */
static uint32_t add_text(uint32_t sum, const char *text)
{
    int digits = 0;
    for (; *text; text++) {
        bool is_digit = isdigit((unsigned char)*text), is_point = *text == '.' && isdigit((unsigned char)text[1]);
        digits = is_digit ? digits + (digits > 0 || *text != '0') : is_point ? digits : 0;
        if (digits <= 6 || !is_digit)
            sum = (sum ^ (unsigned char)*text) * UINT32_C(16777619);
    }
    return sum;
}

static const uint32_t NO_TEXT = UINT32_C(2166136261);

static luxel_settings settings_of(const struct asked *it)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = it->is_irradiance ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
    return settings;
}

static uint32_t explained(const struct asked *it)
{
    luxel_scene *scene = opened_with(it->scene, &it->change, 1);
    luxel_settings settings = settings_of(it);
    luxel_document *document = NULL;
    assert_int_equal(luxel_explain(scene, &settings, it->x_mm, it->y_mm, NULL, NULL, &document), LUXEL_OK);
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_MARKDOWN);
    assert_non_null(text);
    if (prints())
        puts(text); /* print_message() cuts long texts off */
    uint32_t sum = add_text(NO_TEXT, text);
    luxel_text_free(text);
    luxel_document_free(document);
    luxel_scene_free(scene);
    return sum;
}

/* Answers that slips and other conventions give, and others. */
static uint32_t judged(const struct asked *it)
{
    static const double factors[] = {1, 1.01, 2, M_PI, 1e-3, 0.8}, tolerances[] = {1e-3, 2e-2};
    luxel_scene *scene = opened_with(it->scene, &it->change, 1);
    luxel_settings settings = settings_of(it);
    luxel_probe *probe = NULL;
    uint32_t sum = NO_TEXT;
    assert_int_equal(luxel_probe_screen(scene, &settings, it->x_mm, it->y_mm, NULL, &probe), LUXEL_OK);
    for (size_t f = 0; f < sizeof factors / sizeof *factors; f++)
        for (int k = 0; k < 2; k++) {
            luxel_judgement *judgement = NULL;
            char text[300];
            assert_int_equal(luxel_judge_answer(scene, &settings, it->x_mm, it->y_mm, factors[f] * probe->value,
                                                tolerances[k], 0, NULL, &judgement),
                             LUXEL_OK);
            snprintf(text, sizeof text, "%d %d %zu %.6g;", (int)judgement->verdict, judgement->has_value,
                     judgement->explanation_count, judgement->value);
            sum = add_text(sum, text);
            if (prints())
                print_message("%s", text);
            for (size_t e = 0; e < judgement->explanation_count; e++) {
                const char *choice = judgement->explanations[e].choice;
                sum = add_text(sum, choice ? choice : "slip");
                if (prints())
                    print_message(" %s", choice ? choice : "slip");
            }
            luxel_judgement_free(judgement);
        }
    luxel_probe_free(probe);
    luxel_scene_free(scene);
    return sum;
}

static void compare(const char *what, uint32_t (*found)(const struct asked *it), bool is_judged)
{
    unsigned wrong = 0;
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        uint32_t sum = found(&asked[i]), before = is_judged ? asked[i].judged : asked[i].explained;
        wrong += sum != before;
        if (sum != before || prints())
            print_message("# %s %zu: 0x%08x\n", what, i, (unsigned)sum);
    }
    assert_int_equal(wrong, 0);
}

static void explanations(void **state)
{
    (void)state;
    compare("explanation", explained, false);
}

static void judgements(void **state)
{
    (void)state;
    compare("judgement", judged, true);
}

int main(void)
{
    /* pixels' last digits depend on the instruction set */
    setenv("LUXEL_ISA", "generic", 1);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(explanations),
        cmocka_unit_test(judgements),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
