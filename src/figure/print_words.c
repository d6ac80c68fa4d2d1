/* SPDX-License-Identifier: MIT */
/* Words of the small print in the figure's language: kinds of lights and their shapes, and conventions. */
#include <string.h>

#include "../base/phrase.h"
#include "figure.h"

/* What a kind of light or a shape is called; keys of scenes are the same in every language. */
static const struct {
    const char *key, *english;
} kinds[] = {
    {"ambient", LX_N("ambient light")},
    {"point", LX_N("point source")},
    {"points", LX_N("cloud of point sources")},
    {"distant", LX_N("distant source")},
    {"spot", LX_N("spotlight")},
    {"luminaire", LX_N("luminaire")},
    {"planar", LX_N("planar source")},
    {"volume", LX_N("volume source")},
    {"rectangle", LX_N("rectangle")},
    {"disk", LX_N("disk")},
    {"box", LX_N("box")},
    {"sphere", LX_N("sphere")},
    {"cylinder", LX_N("cylinder")},
};

/* Each convention with each of its values. */
static const char *const conventions[] = {
    LX_N("units radiometric"),
    LX_N("units photometric"),
    LX_N("shadows all"),
    LX_N("shadows points"),
    LX_N("shadows none"),
    LX_N("sampling nodes"),
    LX_N("sampling centers"),
    LX_N("projection orthographic"),
    LX_N("projection perspective"),
    LX_N("view parallel"),
    LX_N("view observer"),
    LX_N("model blinn-phong"),
    LX_N("model phong"),
    LX_N("model ggx"),
    LX_N("model lambert"),
    LX_N("diffuse_model oren-nayar"),
    LX_N("diffuse_model eon"),
    LX_N("over_pi true"),
    LX_N("over_pi false"),
    LX_N("highlight plain"),
    LX_N("highlight gated"),
    LX_N("highlight cosine"),
    LX_N("normalized true"),
    LX_N("normalized false"),
    LX_N("attenuation none"),
    LX_N("attenuation inverse-square"),
    LX_N("attenuation practical"),
    LX_N("attenuation polynomial"),
    LX_N("pattern isotropic"),
    LX_N("pattern lambertian"),
    LX_N("pattern cosine"),
    LX_N("interpolation angle"),
    LX_N("interpolation cosine"),
    LX_N("falloff smoothstep"),
    LX_N("falloff squared"),
    LX_N("falloff linear"),
    LX_N("falloff hard"),
    LX_N("range max"),
    LX_N("range minmax"),
    LX_N("range log"),
    LX_N("rounding truncate"),
    LX_N("rounding nearest"),
    LX_N("parts converged"),
};

const char *lx_figure_kind(const struct lx_figure *figure, const char *key)
{
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        if (strcmp(kinds[i].key, key) == 0)
            return lx_figure_word(figure, kinds[i].english);
    return key;
}

/* One value of a convention; those that are numbers have no words. */
static void add_value(const struct lx_figure *figure, struct lx_text *text, const char *key, const char *value,
                      size_t length)
{
    struct lx_text both = {0};
    lx_text_printf(&both, "%s %.*s", key, (int)length, value);
    const char *shown = both.bytes;
    for (size_t i = 0; shown && i < sizeof conventions / sizeof conventions[0]; i++)
        if (strcmp(conventions[i], both.bytes) == 0)
            shown = lx_figure_word(figure, conventions[i]);
    lx_text_puts(text, shown ? shown : "");
    text->failed = text->failed || both.failed;
    lx_text_clear(&both);
}

void lx_figure_add_convention(const struct lx_figure *figure, struct lx_text *text, const char *key, const char *value)
{
    const luxel_language *language = figure->settings.language;
    if (!language || !language->translate || *value == '[') {
        lx_text_printf(text, "%s %s", key, value);
        return;
    }
    while (*value) { /* of several materials or lights, several values */
        const char *end = strstr(value, ", ");
        const size_t length = end ? (size_t)(end - value) : strlen(value);
        add_value(figure, text, key, value, length);
        lx_text_puts(text, end ? ", " : "");
        value += length + (end ? 2 : 0);
    }
}
