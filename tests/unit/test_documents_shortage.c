/* SPDX-License-Identifier: MIT */
/* Documents when memory runs out: every allocation fails once, and the document says so or its writer gives up. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "document/formula.h"
#include "documents.h"
#include "shortage.h"
#ifdef HAS_FIGURES
#include "base/sink.h"
#include "figure/pages.h"
#include <luxel/figure.h>
#include <luxel/luxel.h>
#endif

static void building(void **state)
{
    (void)state;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        shortage_begin(i);
        struct luxel_document *document = documents_everything(NULL);
        shortage_end();
        assert_true(!document || lx_document_failed(document) == shortage_met());
        assert_true(document || shortage_met());
        if (shortage_met() && document)
            assert_null(luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT));
        luxel_document_free(document);
    }
}

static void writing(void **state)
{
    (void)state;
    struct luxel_document *document = documents_everything(NULL);
    for (int format = 0; format < 4; format++)
        for (long i = 0; i == 0 || shortage_met(); i++) {
            shortage_begin(i);
            char *text = luxel_document_write_text(document, (luxel_document_format)format);
            shortage_end();
            if (shortage_met() != !text)
                fail_msg("format %d, allocation %ld", format, i);
            luxel_text_free(text);
        }
    luxel_document_free(document);
}

static void reading_formulas(void **state)
{
    (void)state;
    for (size_t k = 0; documents_formulas[k]; k++)
        for (long i = 0; i == 0 || shortage_met(); i++) {
            size_t at = 0;
            shortage_begin(i);
            struct lx_formula *formula = lx_formula_parse(documents_formulas[k], &at);
            shortage_end();
            assert_true(shortage_met() ? !formula && at == SIZE_MAX : formula != NULL);
            lx_formula_free(formula);
        }
}

#ifdef HAS_FIGURES
/* What cairo and pango allocate does not fail here. */
static void setting_pages(void **state)
{
    (void)state;
    struct luxel_document *document = documents_everything(NULL);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        struct lx_sink *sink;
        assert_int_equal(lx_sink_open("/dev/null", NULL, NULL, &sink), LUXEL_OK);
        shortage_begin(i);
        luxel_status status = lx_pages_write(document, sink, NULL);
        shortage_end();
        if (status != (shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK))
            fail_msg("allocation %ld", i);
        lx_sink_abort(sink);
    }
    luxel_document_free(document);
}

/* A figure and a report in each format that they have: some of their allocations, for each takes a drawing. */
static void drawing_scenes(void **state)
{
    static const char *const names[] = {"a.svg", "a.md", "a.html", "a.tex"};
    char folder[] = "/tmp/luxel-shortage-XXXXXX", path[64];
    luxel_scene *scene = NULL;
    luxel_settings settings;
    (void)state;
    assert_non_null(mkdtemp(folder));
    luxel_settings_init(&settings);
    settings.threads = 1;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "screen.resolution=[9, 9]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, names[k]);
        for (long i = 0; i == 0 || shortage_met(); i += 1 + i / 2) {
            shortage_begin(i);
            luxel_status status = k == 0 ? luxel_figure_write(scene, &settings, NULL, path, NULL)
                                         : luxel_report_write(scene, &settings, NULL, path, NULL);
            shortage_end();
            if (status != LUXEL_OK && !(shortage_met() && status == LUXEL_ERROR_MEMORY))
                fail_msg("%s: status %d at allocation %ld", names[k], (int)status, i);
            assert_int_equal(unlink(path), status == LUXEL_OK ? 0 : -1);
        }
    }
    luxel_scene_free(scene);
    assert_int_equal(rmdir(folder), 0);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(building),      cmocka_unit_test(writing),        cmocka_unit_test(reading_formulas),
#ifdef HAS_FIGURES
        cmocka_unit_test(setting_pages), cmocka_unit_test(drawing_scenes),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
