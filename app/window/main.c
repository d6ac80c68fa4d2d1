/* SPDX-License-Identifier: MIT */
/* luxel-app: the language, then the application. */
#include "../../front/language.h"
#include "../base/number.h"
#include "../files/document.h"
#include "application.h"
#include <locale.h>
#include <string.h>

#include <luxel/scene.h>

/* "report" becomes "builtin:report" where no file has that name, as for the tool; the caller's. */
static char *name_scene(const char *argument)
{
    for (gsize i = 0; luxel_builtin_scene_name(i); i++)
        if (strcmp(argument, luxel_builtin_scene_name(i)) == 0 && !g_file_test(argument, G_FILE_TEST_EXISTS))
            return g_strconcat(APP_BUILTIN, argument, NULL);
    return g_strdup(argument);
}

int main(int count, char **arguments)
{
    /* numbers that are written for programs keep their decimal point whatever the language is */
    gtk_disable_setlocale();
    language_begin();
    /* who has all drawn by cairo needs no OpenGL, and making it ready is a third of the work of the start */
    if (g_strcmp0(g_getenv("GSK_RENDERER"), "cairo") == 0)
        g_setenv("GDK_DEBUG", "gl-disable", FALSE);
    app_number_set_mark(language_decimal_mark());
    /* GLib prints in the encoding of this category: that of the messages, which it could not write otherwise */
    setlocale(LC_CTYPE, setlocale(LC_MESSAGES, NULL));
    g_set_prgname("luxel-app");
    char **named = g_new0(char *, (gsize)count + 1);
    for (int i = 0; i < count; i++)
        named[i] = i == 0 ? g_strdup(arguments[i]) : name_scene(arguments[i]);
    AppApplication *application = app_application_new();
    int status = g_application_run(G_APPLICATION(application), count, named);
    g_strfreev(named);
    g_object_unref(application);
    return status;
}
