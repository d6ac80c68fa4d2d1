/* SPDX-License-Identifier: MIT */
/* Reading the luminaire file of luxel photometry, and its warnings. */
#include "photometry.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../front/language.h"
#include "cli.h"
#include "load.h"
#include "message.h"

static luxel_status read_file(const struct options *options, struct luminaire *luminaire, int *code)
{
    luxel_status status = LUXEL_OK;
    char *text = NULL;
    size_t length;

    *code = EXIT_DONE;
    luminaire->name = options->operand;
    if (strcmp(options->operand, "-") != 0)
        return luxel_photometry_read(options->operand, luminaire->diagnostics, &luminaire->photometry);
    luminaire->name = "<stdin>";
    *code = load_standard_input(&text, &length);
    if (*code == EXIT_DONE)
        status =
            luxel_photometry_read_bytes(text, length, luminaire->name, luminaire->diagnostics, &luminaire->photometry);
    free(text);
    return status;
}

int luminaire_open(const struct options *options, struct luminaire *luminaire)
{
    luxel_status status;
    int code;

    *luminaire = (struct luminaire){.diagnostics = message_new_diagnostics()};
    if (!options->operand) {
        message_error(_("luxel photometry needs a luminaire file: .ies (LM-63) or .ldt (EULUMDAT)"));
        return EXIT_USAGE;
    }
    status = read_file(options, luminaire, &code);
    if (code != EXIT_DONE)
        return code;
    if (status == LUXEL_OK)
        status = luxel_photometry_find_figures(luminaire->photometry, &luminaire->figures);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_ugr_table(
            luminaire->photometry, options->drawing.spacing > 0 ? options->drawing.spacing : 0.25, &luminaire->glare);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_zones(luminaire->photometry, luminaire->zones);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_utilization(luminaire->photometry, &luminaire->utilization);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_bug_rating(luminaire->photometry, &luminaire->bug);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, luminaire->diagnostics);
}

void luminaire_close(struct luminaire *luminaire)
{
    luxel_photometry_free(luminaire->photometry);
    luxel_diagnostics_free(luminaire->diagnostics);
}

/* "line 12, column 5: ...", or without a place where it is about the whole. */
static char *place_warning(const luxel_diagnostic *entry, const char *message, bool in_english)
{
    char *text = NULL;
    int length;

    if (entry->line > 0 && in_english)
        length = asprintf(&text, "line %u, column %u: %s", entry->line, entry->column, message);
    else if (entry->line > 0)
        length = asprintf(&text, _("line %u, column %u: %s"), entry->line, entry->column, message);
    else
        length = asprintf(&text, "%s", message);
    return length < 0 ? NULL : text;
}

char *luminaire_warning(const struct luminaire *luminaire, size_t i, bool in_english)
{
    for (size_t k = 0, found = 0; k < luxel_diagnostics_count(luminaire->diagnostics); k++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(luminaire->diagnostics, k);
        char *message, *text;

        if (entry->severity != LUXEL_SEVERITY_ADVICE || found++ < i)
            continue;
        message = luxel_diagnostics_message(luminaire->diagnostics, k, in_english ? NULL : language_translate, NULL);
        text = place_warning(entry, message ? message : entry->id, in_english);
        luxel_text_free(message);
        return text;
    }
    return NULL;
}
