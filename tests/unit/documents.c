/* SPDX-License-Identifier: MIT */
/* Documents for tests: one with everything, one of hostile words, one of many pages, and formulas of every kind. */
#include "documents.h"

#include <string.h>

#include "base/phrase.h"

const unsigned char documents_png[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x04, 0x00, 0x00, 0x00, 0x04, 0x08, 0x00, 0x00, 0x00, 0x00, 0x8c, 0x9a, 0xc1, 0xa2, 0x00, 0x00, 0x00,
    0x1d, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x60, 0x10, 0x50, 0x30, 0x60, 0x70, 0x08, 0x48, 0x28, 0x60,
    0x68, 0x98, 0xb0, 0x60, 0x03, 0xc3, 0x81, 0x0b, 0x0f, 0x3e, 0x00, 0x00, 0x30, 0xd4, 0x07, 0x81, 0xca, 0x38,
    0xd4, 0x9d, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
const size_t documents_png_length = sizeof documents_png;

const char documents_hostile[] = "<script>alert(1)</script> & \"quotes\" $x_1^2$ \\end{document} 100% #1 ~a~ | *b* _c_ "
                                 "`d` [e](f) {0} \n\x1b[31m -- é λ 😀";

const char *const documents_formulas[] = {
    "E = \\frac{I \\cos \\theta}{r^2}",
    "r = \\sqrt{(x - x_0)^2 + (y - y_0)^2 + z_0^{2}}",
    "L = \\frac{k_d}{\\pi} E_\\perp + k_s \\max(0, \\mathbf{N} \\cdot \\mathbf{H})^{n}",
    "\\sum_{i=1}^{n} I_i a(r_i) \\left( \\frac{1}{\\pi} + \\frac{a}{b + c} \\right)^{2}",
    "\\left| \\vec{r} \\right| \\le 1.5 \\cdot 10^{-7}\\,\\mathrm{mm} \\qquad \\hat{n} \\approx \\pm 90\\degree",
    "a &= b - 3 \\times (-2) \\\\ &\\ne \\text{eine Zahl: } c / d; \\quad \\alpha \\to \\infty",
    "g = \\lfloor 255 \\, \\min(1, v / v_{\\max}) + 0.5 \\rfloor, \\; f_{ij}",
    NULL,
};

/* A language of a few words. */
const char *documents_translate(const char *english, void *data)
{
    static const char *const words[][2] = {
        {"Brightness of a ball", "Яркость шара"},
        {"Model", "Модель расчёта"},
        {"Results", "Результаты"},
        {"The light {0} shines at a distance of {1} mm, where {2} holds.",
         "Источник света {0} светит с расстояния {1} мм, при котором выполняется {2}."},
        {"Values that follow are exact to {0} digits.", "Приведённые ниже значения точны до {0} знаков."},
        {"The key {0} says which law is meant.", "Ключ {0} указывает, какой закон имеется в виду."},
        {"point", "точка"},
        {"value, W/(sr·m²)", "значение, Вт/(ср·м²)"},
        {"remark", "примечание"},
        {"largest", "наибольшее"},
        {"off the surface", "вне поверхности"},
        {"The ball in false colour.", "Шар в условных цветах."},
        {"Long words and many lines make a paragraph that does not fit a single line of a page, nor two; the eye "
         "comes back to the beginning of the next line {0} times, and every line is as full as its words let it be.",
         "Длинные слова и многочисленные строки образуют абзац, который не помещается ни на одной строке страницы, "
         "ни на двух; взгляд возвращается к началу следующей строки {0} раза, и каждая строка заполнена настолько, "
         "насколько позволяют её слова."},
    };
    (void)data;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcmp(words[i][0], english) == 0)
            return words[i][1];
    return english;
}

static void add_table(struct luxel_document *document)
{
    lx_document_table(document, "lrl");
    lx_document_row(
        document,
        LX_SPANS(LX_TERM_SPAN(LX_N("point")), LX_TERM_SPAN(LX_N("value, W/(sr·m²)")), LX_TERM_SPAN(LX_N("remark"))),
        false);
    lx_document_row(document, LX_SPANS(LX_MATH("P_1"), LX_PLAIN("2.72759065255469"), LX_PLAIN("")), false);
    lx_document_row(document, LX_SPANS(LX_MATH("P_2"), LX_PLAIN("11.747879"), LX_STRONG(LX_N("largest"))), true);
    lx_document_row(document, LX_SPANS(LX_MATH("P_3"), LX_PLAIN("0"), LX_TERM_SPAN(LX_N("off the surface"))), false);
}

struct luxel_document *documents_everything(const luxel_language *language)
{
    struct luxel_document *document = lx_document_new(language);
    if (!document)
        return NULL;
    lx_document_title(document, LX_N("Brightness of a ball"), NULL);
    lx_document_byline(document, "A. Иванов");
    lx_document_byline(document, "Group 5-11");
    lx_document_heading(document, 1, LX_N("Model"), NULL);
    lx_document_paragraph(document, LX_N("The light {0} shines at a distance of {1} mm, where {2} holds."),
                          LX_SPANS(LX_PLAIN("lamp"), LX_PLAIN("1500"), LX_MATH("E = I / r^2")));
    for (size_t i = 0; documents_formulas[i]; i++)
        lx_document_formula(document, documents_formulas[i]);
    lx_document_item(document, LX_N("Values that follow are exact to {0} digits."), LX_SPANS(LX_PLAIN("15")));
    lx_document_item(document, LX_N("The key {0} says which law is meant."), LX_SPANS(LX_CODE("lights[0].falloff")));
    lx_document_heading(document, 2, LX_N("Results"), NULL);
    add_table(document);
    lx_document_picture(document, documents_png, documents_png_length, NULL, LX_N("The ball in false colour."), NULL);
    lx_document_code(document, "surface:\n  type: sphere\n  radius: 500\n");
    lx_document_paragraph(document,
                          LX_N("Long words and many lines make a paragraph that does not fit a single line of a page, "
                               "nor two; the eye comes back to the beginning of the next line {0} times, and every "
                               "line is as full as its words let it be."),
                          LX_SPANS(LX_PLAIN("2")));
    return document;
}

struct luxel_document *documents_hostile_one(const char *words)
{
    const struct lx_span span = LX_PLAIN(words), code = LX_CODE(words), formula = LX_MATH(words);
    const struct lx_span spans[] = {span, code, formula, {LX_SPAN_END, NULL}};
    struct luxel_document *document = lx_document_new(NULL);
    if (!document)
        return NULL;
    lx_document_title(document, "{0}", spans);
    lx_document_byline(document, words);
    lx_document_heading(document, 1, "{0} {1}", spans);
    lx_document_paragraph(document, "{0} {1} {2}", spans);
    lx_document_item(document, "{0} {1}", spans);
    lx_document_formula(document, words);
    lx_document_table(document, "llr");
    lx_document_row(document, spans, false);
    lx_document_row(document, spans, true);
    lx_document_code(document, words);
    lx_document_picture(document, documents_png, documents_png_length, NULL, "{0} {1}", spans);
    return document;
}

struct luxel_document *documents_long(const luxel_language *language, size_t rows)
{
    struct luxel_document *document = documents_everything(language);
    if (!document)
        return NULL;
    for (int i = 0; i < 12; i++) {
        lx_document_heading(document, 1 + i % 2, LX_N("Results"), NULL);
        for (int k = 0; k < 3; k++)
            lx_document_paragraph(document,
                                  LX_N("Long words and many lines make a paragraph that does not fit a single line of "
                                       "a page, nor two; the eye comes back to the beginning of the next line {0} "
                                       "times, and every line is as full as its words let it be."),
                                  LX_SPANS(LX_MATH("\\frac{a + b}{2} \\approx \\sum_{i=1}^{4} a_i + b_i")));
        lx_document_formula(document,
                            "L = 1.234567 + 2.345678 + 3.456789 + 4.567891 + 5.678912 + 6.789123 + 7.891234 + "
                            "8.912345 + 9.123456 + 1.345678 + 2.456789 + 3.567891 = 57.37013");
    }
    lx_document_table(document, "lrlr");
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("point")), LX_TERM_SPAN(LX_N("value, W/(sr·m²)")),
                             LX_TERM_SPAN(LX_N("remark")), LX_MATH("\\mathbf{N} \\cdot \\mathbf{L}")),
                    false);
    for (size_t i = 0; i < rows; i++)
        lx_document_row(document,
                        LX_SPANS(LX_MATH("P_i"), LX_PLAIN("2.72759065255469"),
                                 LX_PLAIN(i % 7 == 3 ? "a remark that is so long that it needs more than a line of its "
                                                       "cell, which makes the row higher than the others"
                                                     : "short"),
                                 LX_PLAIN("0.5")),
                        i % 10 == 4);
    lx_document_code(document,
                     "lights:\n  - {type: point, position: [1000, -1000, 2000], intensity: 1000, name: a light "
                     "of a rather long name, attenuation: inverse-square}\n");
    return document;
}
