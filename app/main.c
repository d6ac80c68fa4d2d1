/* SPDX-License-Identifier: MIT */
/* luxel-app: the language, then the application. */
#include "../front/language.h"
#include "application.h"
#include <locale.h>

int main(int count, char **arguments)
{
    /* numbers keep their decimal point whatever the language is */
    gtk_disable_setlocale();
    language_begin();
    /* GLib prints in the encoding of this category: that of the messages, which it could not write otherwise */
    setlocale(LC_CTYPE, setlocale(LC_MESSAGES, NULL));
    g_set_prgname("luxel-app");
    AppApplication *application = app_application_new();
    int status = g_application_run(G_APPLICATION(application), count, arguments);
    g_object_unref(application);
    return status;
}
