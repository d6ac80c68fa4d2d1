/* SPDX-License-Identifier: MIT */
/* Documents: what each writer makes of every block, of words of users, and where it writes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/diagnostics.h"
#include "documents.h"
#include "place.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static const luxel_language russian = {.translate = documents_translate, .code = "ru"};

/* ---- each format ---- */

/* A document with a block of every type, as short as that may be. */
static struct luxel_document *make_short(void)
{
    struct luxel_document *document = lx_document_new(NULL);
    assert_non_null(document);
    lx_document_title(document, "A ball", NULL);
    lx_document_byline(document, "N. N.");
    lx_document_byline(document, "Group 1");
    lx_document_heading(document, 1, "Law {0}", LX_SPANS(LX_MATH("r^2")));
    lx_document_paragraph(document, "1. See {0} {1}{2}.",
                          LX_SPANS(LX_CODE("a|b"), LX_STRONG("now"), LX_PLAIN(" <here>")));
    lx_document_formula(document, "a &= b \\\\ &= 90\\degree");
    lx_document_item(document, "one", NULL);
    lx_document_item(document, "two", NULL);
    lx_document_heading(document, 2, "Table", NULL);
    lx_document_table(document, "lr");
    lx_document_row(document, LX_SPANS(LX_TERM_SPAN("name"), LX_TERM_SPAN("value")), false);
    lx_document_row(document, LX_SPANS(LX_MATH("|a|"), LX_PLAIN("1.5")), false);
    lx_document_row(document, LX_SPANS(LX_PLAIN("b_2"), LX_PLAIN("")), true);
    lx_document_code(document, "a:\n  - b\n\n  c");
    lx_document_picture(document, "PNG", 3, NULL, "A picture", NULL);
    return document;
}

static void assert_format(luxel_document_format format, const char *begins, const char *expected)
{
    struct luxel_document *document = make_short();
    char *text = luxel_document_write_text(document, format);
    assert_non_null(text);
    const char *at = strstr(text, begins);
    assert_non_null(at);
    assert_string_equal(at, expected);
    luxel_text_free(text);
    luxel_document_free(document);
}

static void writes_text(void **state)
{
    (void)state;
    assert_format(LUXEL_DOCUMENT_TEXT, "A ball",
                  "A ball\nN. N.\nGroup 1\n\nLaw r²\n══════\n\n1. See a|b now <here>.\n\n    a = b\n    = 90°\n\n"
                  "  • one\n  • two\n\nTable\n─────\n\n"
                  "name   value\n─────  ─────\n|a|      1.5\n→ b_2\n\n"
                  "    a:\n      - b\n\n      c\n\n[A picture]\n");
}

static void writes_markdown(void **state)
{
    (void)state;
    assert_format(LUXEL_DOCUMENT_MARKDOWN, "#",
                  "# A ball\n\nN. N.\\\nGroup 1\n\n## Law $r^2$\n\n1\\. See `a|b` **now** \\<here\\>.\n\n"
                  "$$\n\\begin{aligned}\na &= b \\\\ &= 90^\\circ \n\\end{aligned}\n$$\n\n- one\n- two\n\n### Table\n\n"
                  "| name | value |\n| --- | ---: |\n| $\\vert a\\vert $ | 1.5 |\n| **b\\_2** |  |\n\n"
                  "```yaml\na:\n  - b\n\n  c\n```\n\n"
                  "![A picture](data:image/png;base64,UE5H)\n\n*A picture*\n");
}

static void writes_latex(void **state)
{
    (void)state;
    assert_format(LUXEL_DOCUMENT_LATEX, "\\title",
                  "\\title{A ball}\n\\author{N. N.\\\\ Group 1}\n\\date{}\n\\begin{document}\n\\maketitle\n\n"
                  "\\section*{Law $r^2$}\n\n"
                  "1. See \\texttt{a\\textbar{}b} \\textbf{now} \\textless{}here\\textgreater{}.\n"
                  "\\begin{align*}\na &= b \\\\ &= 90^\\circ \n\\end{align*}\n\n"
                  "\\begin{itemize}\n\\item one\n\\item two\n\\end{itemize}\n\n\\subsection*{Table}\n\n"
                  "{\\small\n\\begin{longtable}{lr}\n\\toprule\nname & value \\\\\n\\midrule\n\\endhead\n"
                  "$|a|$ & 1.5 \\\\\n\\textbf{b\\_2} &  \\\\\n\\bottomrule\n\\end{longtable}}\n\n"
                  "\\begin{flushleft}\\footnotesize\\ttfamily\na:\\strut\\\\\n~~-{} b\\strut\\\\\n\\strut\\\\\n"
                  "~~c\\strut\\\\\n\\end{flushleft}\n\n"
                  "\\begin{center}\n\\textit{A picture}\n\\end{center}\n\n\\end{document}\n");
}

static void writes_html(void **state)
{
    (void)state;
    assert_format(LUXEL_DOCUMENT_HTML, "</head>",
                  "</head>\n<body>\n<h1>A ball</h1>\n<p class=\"byline\">N. N.</p>\n<p class=\"byline\">Group 1</p>\n"
                  "<h2 id=\"s0\">Law <math><mrow><msup><mi>r</mi><mn>2</mn></msup></mrow></math></h2>\n"
                  "<p>1. See <code>a|b</code> <strong>now</strong> &lt;here&gt;.</p>\n"
                  "<math display=\"block\"><mtable displaystyle=\"true\"><mtr>"
                  "<mtd style=\"text-align:right;padding-right:0\"><mi>a</mi></mtd>"
                  "<mtd style=\"text-align:left;padding-left:0\"><mrow><mi></mi><mo>=</mo><mi>b</mi></mrow></mtd></mtr>"
                  "<mtr><mtd style=\"text-align:right;padding-right:0\"></mtd>"
                  "<mtd style=\"text-align:left;padding-left:0\"><mrow><mi></mi><mo>=</mo><mn>90</mn>"
                  "<mi mathvariant=\"normal\">°</mi></mrow></mtd></mtr></mtable></math>\n"
                  "<ul>\n<li>one</li>\n<li>two</li>\n</ul>\n<h3 id=\"s5\">Table</h3>\n"
                  "<div class=\"table\"><table>\n<thead><tr><th scope=\"col\">name</th>"
                  "<th scope=\"col\" class=\"r\">value</th></tr></thead>\n<tbody>\n"
                  "<tr><td><math><mrow><mo fence=\"true\" stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo><mi>a</mi>"
                  "<mo fence=\"true\" stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo></mrow></math></td><td "
                  "class=\"r\">1.5</td></tr>\n"
                  "<tr class=\"marked\"><td>b_2</td><td class=\"r\"></td></tr>\n</tbody></table></div>\n"
                  "<pre><code>a:\n  - b\n\n  c\n</code></pre>\n"
                  "<figure><img src=\"data:image/png;base64,UE5H\" alt=\"A picture\" />"
                  "<figcaption>A picture</figcaption></figure>\n</body>\n</html>\n");
}

static void encodes_pictures(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"", ""},        {"f", "Zg=="},        {"fo", "Zm8="},
                                           {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"\xff\xfe\xfd", "//79"}};
    for (size_t i = 1; i < COUNT(cases); i++) {
        struct luxel_document *document = lx_document_new(NULL);
        char address[64];
        lx_document_picture(document, cases[i][0], strlen(cases[i][0]), NULL, "", NULL);
        char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_HTML);
        snprintf(address, sizeof address, "base64,%s\"", cases[i][1]);
        assert_non_null(strstr(text, address));
        luxel_text_free(text);
        luxel_document_free(document);
    }
}

/* ---- words ---- */

static void fills_and_translates(void **state)
{
    (void)state;
    struct luxel_document *document = documents_everything(&russian);
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT);
    assert_non_null(strstr(text, "Яркость шара\nA. Иванов\n"));
    assert_non_null(strstr(text, "Источник света lamp светит с расстояния 1500 мм, при котором выполняется E = I /"));
    assert_non_null(strstr(text, "→ P₂              11.747879  наибольшее\n"));
    assert_string_equal(lx_document_word(document, "Model"), "Модель расчёта");
    assert_string_equal(lx_document_word(document, ""), "");
    luxel_text_free(text);
    text = luxel_document_write_text(document, LUXEL_DOCUMENT_HTML);
    assert_non_null(strstr(text, "<html lang=\"ru\">"));
    luxel_text_free(text);
    luxel_document_free(document);
}

/* {3} without a span, a lone brace, and {0} in what a span says stay as they are. */
static void fills_only_its_own_places(void **state)
{
    (void)state;
    struct luxel_document *document = lx_document_new(NULL);
    lx_document_paragraph(document, "{1}{0} {3} { {x} {12} {", LX_SPANS(LX_PLAIN("{1}"), LX_CODE("{0}")));
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT);
    assert_string_equal(text, "\n\n{0}{1} {3} { {x} {12} {\n");
    luxel_text_free(text);
    luxel_document_free(document);
}

static size_t count_of(const char *text, const char *part)
{
    size_t count = 0;
    for (; (text = strstr(text, part)) != NULL; text++)
        count++;
    return count;
}

static void escapes_words_of_users(void **state)
{
    (void)state;
    struct luxel_document *document = documents_hostile_one(documents_hostile);
    assert_false(lx_document_failed(document));
    for (int format = 0; format < 4; format++) {
        char *text = luxel_document_write_text(document, (luxel_document_format)format);
        assert_non_null(text);
        assert_null(strchr(text, '\x1b'));
        luxel_text_free(text);
    }
    char *html = luxel_document_write_text(document, LUXEL_DOCUMENT_HTML);
    assert_null(strstr(html, "<script"));
    assert_int_equal(count_of(html, "&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;quotes&quot;"), 22);
    assert_int_equal(count_of(html, "<img "), 1);
    luxel_text_free(html);
    char *latex = luxel_document_write_text(document, LUXEL_DOCUMENT_LATEX);
    assert_int_equal(count_of(latex, "\\end{document}"), 1);
    assert_int_equal(count_of(latex, "\\$x\\_1\\textasciicircum{}2\\$ \\textbackslash{}end\\{document\\} 100\\% \\#1"),
                     19);
    assert_int_equal(count_of(latex, "\\DeclareUnicodeCharacter{1F600}"), 1);
    luxel_text_free(latex);
    char *markdown = luxel_document_write_text(document, LUXEL_DOCUMENT_MARKDOWN);
    assert_int_equal(count_of(markdown, "\n<script"), 2); /* within fences alone */
    assert_int_equal(count_of(markdown, "```yaml\n<script"), 2);
    luxel_text_free(markdown);
    luxel_document_free(document);
}

static void shows_what_is_no_formula(void **state)
{
    (void)state;
    struct luxel_document *document = lx_document_new(NULL);
    lx_document_formula(document, "\\input{secret}");
    lx_document_paragraph(document, "{0}", LX_SPANS(LX_MATH("$ \\input{secret} $")));
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_LATEX);
    assert_null(strstr(text, "\\input{"));
    assert_int_equal(count_of(text, "\\textbackslash{}input\\{secret\\}"), 2);
    luxel_text_free(text);
    luxel_document_free(document);
}

static void keeps_to_columns(void **state)
{
    (void)state;
    struct luxel_document *document = documents_long(&russian, 30);
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT);
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        size_t columns = 0;
        for (const char *at = line; *at; at++)
            columns += ((unsigned char)*at & 0xc0) != 0x80;
        if (columns > 100 && !strstr(line, "rather long name"))
            fail_msg("%zu columns: %s", columns, line);
    }
    luxel_text_free(text);
    luxel_document_free(document);
}

/* ---- files ---- */

static void assert_file(const char *path, const char *text)
{
    size_t length = strlen(text);
    char *bytes = malloc(length + 1);
    FILE *file = fopen(path, "rb");
    assert_true(file && bytes);
    assert_int_equal(fread(bytes, 1, length + 1, file), length);
    assert_memory_equal(bytes, text, length);
    fclose(file);
    free(bytes);
}

static void test_writes_files(void **state)
{
    const struct place *place = *state;
    static const char *const endings[] = {".txt", ".MD", ".tex", ".html"};
    struct luxel_document *document = make_short();
    char path[96];
    for (size_t i = 0; i < COUNT(endings); i++) {
        snprintf(path, sizeof path, "%s/report%s", place->folder, endings[i]);
        char *text = luxel_document_write_text(document, (luxel_document_format)i);
        assert_int_equal(luxel_check_document_name(path, NULL), LUXEL_OK);
        assert_int_equal(luxel_document_write(document, path, NULL), LUXEL_OK);
        assert_file(path, text);
        luxel_text_free(text);
    }
    assert_int_equal(entries(place), COUNT(endings));
    luxel_document_free(document);
}

static void test_refuses_files(void **state)
{
    const struct place *place = *state;
    struct luxel_document *document = make_short();
    static const char *const names[] = {"report", "report.doc", ".txt", "a.html/", "report.txt.gz"};
    char path[96];
    for (size_t i = 0; i < COUNT(names); i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        snprintf(path, sizeof path, "%s/%s", place->folder, names[i]);
        assert_int_equal(luxel_check_document_name(path, NULL), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_document_write(document, path, diagnostics), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        luxel_diagnostics_free(diagnostics);
    }
    snprintf(path, sizeof path, "%s/none/report.txt", place->folder);
    assert_int_equal(luxel_document_write(document, path, NULL), LUXEL_ERROR_FILE);
    assert_int_equal(entries(place), 0);
    luxel_document_free(document);
    luxel_document_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(writes_text),
        cmocka_unit_test(writes_markdown),
        cmocka_unit_test(writes_latex),
        cmocka_unit_test(writes_html),
        cmocka_unit_test(encodes_pictures),
        cmocka_unit_test(fills_and_translates),
        cmocka_unit_test(fills_only_its_own_places),
        cmocka_unit_test(escapes_words_of_users),
        cmocka_unit_test(shows_what_is_no_formula),
        cmocka_unit_test(keeps_to_columns),
        CASE(writes_files),
        CASE(refuses_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
