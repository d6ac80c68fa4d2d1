/* SPDX-License-Identifier: MIT */
/* The element that is seen is asked of the library, by the first light that has a date. */
#include "sunshine.h"

#include <string.h>

#include "../../front/words.h"
#include "../base/date.h"
#include "../base/number.h"
#include "../base/scalar.h"

enum { MOST_SPANS = 4, DIGITS = 4 };

/* The date of a sun, or of that of a sky; the caller's; NULL: none has one. */
static char *find_date(const luxel_scene *scene)
{
    static const char *const forms[] = {"lights[%zu].date", "lights[%zu].sun.date"};
    char *date = NULL;
    for (gsize i = 0; i < luxel_scene_light_count(scene) && !date; i++)
        for (gsize k = 0; k < G_N_ELEMENTS(forms) && !date; k++) {
            char key[64], *text = NULL;
            bool written = false;
            g_snprintf(key, sizeof key, forms[k], i);
            if (luxel_scene_get(scene, key, NULL, &written, &text) == LUXEL_OK && written)
                date = app_yaml_unquote(text);
            luxel_text_free(text);
        }
    return date;
}

static gboolean find_element(const luxel_scene *scene, const luxel_settings *settings, const double screen_mm[2],
                             luxel_place *place)
{
    static const size_t none = 0;
    luxel_settings dark = *settings;
    luxel_probe *probe = NULL;
    dark.lights = &none; /* where it is does not ask for light */
    dark.light_count = 0;
    if (luxel_probe_screen(scene, &dark, screen_mm[0], screen_mm[1], NULL, &probe) != LUXEL_OK)
        return FALSE;
    const gboolean is_seen = probe->on_surface;
    *place = (luxel_place){.is_element = true};
    memcpy(place->position_mm, probe->position_mm, sizeof place->position_mm);
    memcpy(place->normal, probe->normal, sizeof place->normal);
    luxel_probe_free(probe);
    return is_seen;
}

static void add_clock(GString *text, double seconds)
{
    const guint minutes = (guint)(seconds / 60 + 0.5);
    g_string_append_printf(text, "%02u:%02u", minutes / 60, minutes % 60);
}

static char *tell(const char *day, const luxel_sun_hours *hours)
{
    char number[APP_NUMBER_SIZE];
    GString *spans = g_string_new(NULL);
    for (gsize i = 0; i < MIN(hours->span_count, MOST_SPANS); i++) {
        g_string_append(spans, i ? ", " : "");
        add_clock(spans, hours->spans[i].from_s);
        g_string_append(spans, "–");
        add_clock(spans, hours->spans[i].to_s);
    }
    if (hours->span_count > MOST_SPANS)
        g_string_append(spans, ", …");
    char *text = hours->span_count > 0
                     ? g_strdup_printf(_("Sun on %.10s: %s; %s h"), day, spans->str,
                                       app_number_show(hours->total_s / 3600, DIGITS, number))
                     : g_strdup_printf(_("No sun on %.10s"), day);
    g_string_free(spans, TRUE);
    return text;
}

char *app_sunshine(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm)
{
    const double screen_mm[2] = {x_mm, y_mm};
    char *date = find_date(scene), *day = date ? app_date_day(date) : NULL, *text = NULL;
    luxel_place place;
    luxel_sunlight *sunlight = NULL;
    const luxel_sun_day asked = {.date = day};
    if (day && find_element(scene, settings, screen_mm, &place) &&
        luxel_find_sunlight(scene, settings, &asked, &place, 1, NULL, &sunlight) == LUXEL_OK)
        text = tell(day, &sunlight->elements[0]);
    luxel_sunlight_free(sunlight);
    g_free(day);
    g_free(date);
    return text;
}
