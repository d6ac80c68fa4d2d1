/* SPDX-License-Identifier: MIT */
/* Formulas: what of the notation is read, where it is not, and the formulas as Unicode and MathML. */
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "document/formula.h"
#include "documents.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static char *written(const char *notation, void (*add)(struct lx_text *, const struct lx_formula *))
{
    struct lx_text text = {0};
    size_t at = 0;
    struct lx_formula *formula = lx_formula_parse(notation, &at);
    if (!formula)
        fail_msg("%s: not read from %zu", notation, at);
    lx_text_puts(&text, "");
    add(&text, formula);
    lx_formula_free(formula);
    return lx_text_take(&text);
}

static void assert_written(const char *notation, void (*add)(struct lx_text *, const struct lx_formula *),
                           const char *expected)
{
    char *text = written(notation, add);
    assert_non_null(text);
    assert_string_equal(text, expected);
    free(text);
}

static void becomes_text(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"E = \\frac{I \\cos \\theta}{r^2}", "E = I cos θ / r²"},
        {"r = \\sqrt{(x - x_0)^2 + z_0^{2}}", "r = √((x − x₀)² + z₀²)"},
        {"\\sqrt{2} \\sqrt{x_1} \\sqrt{\\left( a \\right)}", "√2√x₁√(a)"},
        {"\\frac{k_d}{\\pi} E_\\perp", "(k_d / π) E_⊥"},
        {"E_⊥ = 90°", "E_⊥ = 90°"},
        {"2 \\cdot \\frac{a}{b}", "2 · a / b"},
        {"\\frac{a + b}{\\frac{c}{d}}", "(a + b) / (c / d)"},
        {"\\frac{(a + b)}{f(c - d)}", "(a + b) / f(c − d)"},
        {"\\frac{L + V}{|L + V|}", "(L + V) / |L + V|"},
        {"{a + b}^2 \\frac{1}{{c - d}}", "(a + b)² 1 / (c − d)"},
        {"\\sum_{i=1}^{n} I_i", "∑ᵢ₌₁ⁿ Iᵢ"},
        {"a^{-12} b^{x+1} c^{yz} d_{max} e^{1/2}", "a⁻¹²bˣ⁺¹c^(yz) dₘₐₓe^(1 / 2)"},
        {"\\left| \\vec{r} \\right| \\le \\hat{n}", "|r⃗| ≤ n̂"},
        {"\\max(0, \\mathbf{N} \\cdot \\mathbf{H})^{n}", "max(0, N · H)ⁿ"},
        {"2 \\sin x \\cos 30\\degree", "2 sin x cos 30°"},
        {"v_{\\max} \\max_i v_i", "vₘₐₓ maxᵢ vᵢ"},
        {"5.25\\,\\mathrm{mm}", "5.25 mm"},
        {"-a + (-2) \\times -3 = \\pm 1, -4", "−a + (−2) × −3 = ±1, −4"},
        {"a &= b \\\\ &= c", "a = b\n= c"},
        {"x \\qquad \\text{if } y > 0; \\% !", "x   if y > 0; %!"},
        {"\\lfloor 2 \\rfloor 3", "⌊2⌋ 3"},
        {"", ""},
        {"  ", ""},
    };
    for (size_t i = 0; i < COUNT(cases); i++)
        assert_written(cases[i][0], lx_formula_add_text, cases[i][1]);
}

static void becomes_mathml(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"r^2", "<mrow><msup><mi>r</mi><mn>2</mn></msup></mrow>"},
        {"a_{ij}^k", "<mrow><msubsup><mi>a</mi><mrow><mi>i</mi><mi>j</mi></mrow><mi>k</mi></msubsup></mrow>"},
        {"\\frac{1}{2.5}", "<mrow><mfrac><mrow><mn>1</mn></mrow><mrow><mn>2.5</mn></mrow></mfrac></mrow>"},
        {"\\sqrt{a < b}", "<mrow><msqrt><mrow><mi>a</mi><mo>&lt;</mo><mi>b</mi></mrow></msqrt></mrow>"},
        {"\\sum_{i}^{n}",
         "<mrow><munderover><mo>∑</mo><mrow><mi>i</mi></mrow><mrow><mi>n</mi></mrow></munderover></mrow>"},
        {"-\\mathbf{N}", "<mrow><mo form=\"prefix\">−</mo><mi mathvariant=\"normal\" "
                         "style=\"font-weight:bold\">N</mi></mrow>"},
        {"\\left( a \\right.", "<mrow><mrow><mo fence=\"true\">(</mo><mrow><mi>a</mi></mrow></mrow></mrow>"},
        {"a \\cos b", "<mrow><mi>a</mi><mspace width=\"0.17em\"></mspace><mi mathvariant=\"normal\">cos</mi>"
                      "<mo>&#x2061;</mo><mspace width=\"0.17em\"></mspace><mi>b</mi></mrow>"},
        {"\\text{ a < b }\\quad", "<mrow><mtext>&#xa0;a &lt; b&#xa0;</mtext><mspace width=\"1.00em\"></mspace></mrow>"},
    };
    for (size_t i = 0; i < COUNT(cases); i++)
        assert_written(cases[i][0], lx_formula_add_mathml, cases[i][1]);
}

static void tells_where_it_is_wrong(void **state)
{
    (void)state;
    static const struct {
        const char *notation;
        size_t at;
    } cases[] = {
        {"a + \\foo", 5},
        {"\\frac{a}", 8},
        {"a}", 1},
        {"{a", 2},
        {"a^", 2},
        {"a_1_2", 4},
        {"\\left( a", 8},
        {"a \\right)", 2},
        {"\\left a \\right)", 5},
        {"\\sqrt a", 5},
        {"a $ b", 2},
        {"a # b", 2},
        {"\\mathrm{a_b}", 7},
        {"\\text{a\\b}", 5},
        {"\\text{a", 5},
        {"\\frac{a & b}{c}", 8},
        {"a é", 2},
        {"a \x80", 2},
        {"\\", 1},
        {"a \n b", 2},
        {"{a \\\\ b}", 3},
        {"a % b", 2},
        {"\\input{x}", 1},
        {"^2", 0},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        size_t at = SIZE_MAX;
        struct lx_formula *formula = lx_formula_parse(cases[i].notation, &at);
        if (formula || at != cases[i].at)
            fail_msg("%s: %s %zu", cases[i].notation, formula ? "read" : "stopped at", at);
    }
    assert_null(lx_formula_parse("a^", NULL));
}

/* Nobody's text makes the parser call itself without end. */
static void limits_depth(void **state)
{
    (void)state;
    static const char *const parts[] = {"{", "\\sqrt{", "\\frac{", "a^{", "\\left(", "\\vec{", "\\frac{1}{", "a_{b^{"};
    for (size_t i = 0; i < COUNT(parts); i++) {
        struct lx_text text = {0};
        for (int k = 0; k < 100000; k++)
            lx_text_puts(&text, parts[i]);
        assert_false(text.failed);
        assert_null(lx_formula_parse(text.bytes, NULL));
        lx_text_clear(&text);
    }
    struct lx_text text = {0};
    for (int k = 0; k < 30; k++)
        lx_text_puts(&text, "\\sqrt{");
    lx_text_puts(&text, "a");
    for (int k = 0; k < 30; k++)
        lx_text_puts(&text, "}");
    char *plain = written(text.bytes, lx_formula_add_text);
    assert_non_null(strstr(plain, "√√√√a"));
    free(plain);
    lx_text_clear(&text);
}

/* Whatever bytes come, the parser ends, and what it reads can be written. */
static void survives_anything(void **state)
{
    (void)state;
    static const char *const pieces[] = {"a",       "\\frac", "{",   "}", "_",    "^",      "\\left", "(",
                                         "\\right", ")",      "\\",  "&", "\\\\", "+",      "-",      "\\text{b",
                                         "1.",      "\\cos",  ",",   "|", " ",    "\\sqrt", "\xd0",   "⊥",
                                         "\\vec",   "\\sum",  "\\;", ".", "{c}",  "{d}"};
    uint64_t random = 88172645463325252u;
    size_t read = 0;
    for (int i = 0; i < 20000; i++) {
        struct lx_text notation = {0}, text = {0};
        lx_text_puts(&notation, "");
        for (int k = 0; k < 12; k++) {
            random ^= random << 13;
            random ^= random >> 7;
            random ^= random << 17;
            if (k < 2 || random % 3 > 0)
                lx_text_puts(&notation, pieces[random / 8 % COUNT(pieces)]);
        }
        struct lx_formula *formula = lx_formula_parse(notation.bytes, NULL);
        if (formula) {
            lx_formula_add_text(&text, formula);
            lx_formula_add_mathml(&text, formula);
            assert_false(text.failed);
            read++;
        }
        lx_formula_free(formula);
        lx_text_clear(&text);
        lx_text_clear(&notation);
    }
    assert_true(read > 100);
}

static void reads_all_of_the_notation(void **state)
{
    (void)state;
    for (size_t i = 0; documents_formulas[i]; i++) {
        char *text = written(documents_formulas[i], lx_formula_add_text);
        assert_null(strchr(text, '\\'));
        free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(becomes_text),
        cmocka_unit_test(becomes_mathml),
        cmocka_unit_test(tells_where_it_is_wrong),
        cmocka_unit_test(limits_depth),
        cmocka_unit_test(survives_anything),
        cmocka_unit_test(reads_all_of_the_notation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
