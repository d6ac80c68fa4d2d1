/* SPDX-License-Identifier: MIT */
/* Writes documents with everything in them into a folder, in every format and two languages, for test_documents.py. */
#include <stdio.h>

#include "documents.h"

static int write_all(const char *folder, const char *name, struct luxel_document *document)
{
    static const char *const endings[] = {"txt", "md", "tex", "html"};
    int failures = document ? 0 : 1;
    for (size_t i = 0; document && i < sizeof endings / sizeof endings[0]; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s.%s", folder, name, endings[i]);
        failures += luxel_document_write(document, path, NULL) != LUXEL_OK;
    }
    luxel_document_free(document);
    return failures;
}

int main(int count, char **arguments)
{
    const luxel_language russian = {.translate = documents_translate, .code = "ru"};
    if (count != 2) {
        fputs("usage: write_documents FOLDER\n", stderr);
        return 2;
    }
    return write_all(arguments[1], "english", documents_everything(NULL)) +
                       write_all(arguments[1], "russian", documents_everything(&russian)) +
                       write_all(arguments[1], "hostile", documents_hostile_one(documents_hostile)) +
                       write_all(arguments[1], "long", documents_long(NULL, 80)) >
                   0
               ? 1
               : 0;
}
