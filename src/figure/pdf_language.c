/* SPDX-License-Identifier: MIT */
/*
 * Adding the language to a PDF file, which cairo has no function for: as an update at its end (ISO 32000-1, 7.5.6), a
 * catalogue in the place of the one before, and the part of the cross-reference table that is about it.
 */
#include "pdf_language.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The last place of some bytes; NULL: there is none. */
static const char *find_last(const struct lx_text *pdf, const char *wanted)
{
    const size_t length = strlen(wanted);
    for (size_t i = pdf->length; i-- > 0;)
        if (i + length <= pdf->length && memcmp(pdf->bytes + i, wanted, length) == 0)
            return pdf->bytes + i;
    return NULL;
}

/* Languages are letters, digits and hyphens. */
static bool is_language(const char *code)
{
    return *code && code[strspn(code, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-")] == '\0';
}

void lx_pdf_add_language(struct lx_text *pdf, const char *code)
{
    unsigned size, root, info;
    unsigned long before;
    char object[64];
    if (pdf->failed || !pdf->bytes || !is_language(code))
        return;
    const char *trailer = find_last(pdf, "trailer\n"), *start = find_last(pdf, "startxref\n");
    if (!trailer || !start ||
        sscanf(trailer, "trailer << /Size %u /Root %u 0 R /Info %u 0 R >>", &size, &root, &info) != 3 ||
        sscanf(start, "startxref %lu", &before) != 1)
        return;
    snprintf(object, sizeof object, "\n%u 0 obj\n<< /Type /Catalog\n", root);
    const char *catalogue = find_last(pdf, object), *end = catalogue ? strstr(catalogue, "\n>>\nendobj\n") : NULL;
    if (!end || end > trailer)
        return;
    /* a copy, as the text is moved when it grows */
    char *copy = strndup(catalogue + 1, (size_t)(end - catalogue - 1));
    const size_t place = pdf->length;
    pdf->failed = pdf->failed || !copy;
    if (copy)
        lx_text_printf(pdf, "%s\n   /Lang (%s)\n>>\nendobj\n", copy, code);
    const size_t table = pdf->length;
    lx_text_printf(pdf, "xref\n%u 1\n%010zu 00000 n \ntrailer\n<< /Size %u\n   /Root %u 0 R\n   /Info %u 0 R\n", root,
                   place, size, root, info);
    lx_text_printf(pdf, "   /Prev %lu\n>>\nstartxref\n%zu\n%%%%EOF\n", before, table);
    free(copy);
}
