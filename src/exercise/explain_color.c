/* SPDX-License-Identifier: MIT */
/* The channels of a value in colour, light by light, their sum, and the colour that they are. */
#include <math.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../scene/colours.h"
#include "explain.h"

static const char *const names[LX_CHANNELS] = {"R", "G", "B"};

void lx_explain_color_rule(const struct lx_steps *steps)
{
    if (steps->quantity == LUXEL_IRRADIANCE)
        lx_document_paragraph(steps->document,
                              LX_N("All of it is of white light first; the channels of a light are that, times its own "
                                   "channels {0} at luminance 1."),
                              LX_SPANS(LX_MATH("l_R,\\; l_G,\\; l_B")));
    else
        lx_document_paragraph(
            steps->document,
            LX_N("All of it is of white light on a material without colours first; the channels of a light are that, "
                 "times its own channels {0} at luminance 1 and, for each part, the factors {1} and {2} that the "
                 "material calls color and specular_color."),
            LX_SPANS(LX_MATH("l_R,\\; l_G,\\; l_B"), LX_MATH("m"), LX_MATH("s")));
}

/* Whether the diffuse part in a channel is another formula's value, not that of white times a factor. */
static bool is_bent(const struct lx_material *material, int c)
{
    return LX_LAMBERT + material->diffuse_model == LX_EON && material->color[c] != 1;
}

/* A channel of what a light gives, from its parts in white. */
static void explain_channel(const struct lx_steps *steps, int c, double lamp, const luxel_light_share *white,
                            double value)
{
    const struct lx_material *material = steps->element->own->material;
    const double diffuse = material->color[c], specular = material->specular_color[c];
    const bool shines = lx_lobe_kind_of(steps->element->lobe)->value && white->specular != 0;
    struct lx_text text = {0};
    lx_add_notation(&text, "$ = ", names[c]);
    if (steps->quantity == LUXEL_IRRADIANCE)
        lx_add_notation(&text, "l_$\\, E = ! \\cdot # = #", names[c], lamp, white->irradiance, value);
    else if (is_bent(material, c) && shines)
        lx_add_notation(&text, "l_$\\, (B_d(\\rho = m_$\\, k_d) + s_$\\, B_s) = ! \\cdot (B_d + # \\cdot #) = #",
                        names[c], names[c], names[c], lamp, specular, white->specular, value);
    else if (is_bent(material, c))
        lx_add_notation(&text, "l_$\\, B_d(\\rho = m_$\\, k_d) = #", names[c], names[c], value);
    else if (shines)
        lx_add_notation(&text, "l_$\\, (m_$\\, B_d + s_$\\, B_s) = ! \\cdot (# \\cdot # + # \\cdot #) = #", names[c],
                        names[c], names[c], lamp, diffuse, white->diffuse, specular, white->specular, value);
    else
        lx_add_notation(&text, "l_$\\, m_$\\, B_d = ! \\cdot # \\cdot # = #", names[c], names[c], lamp, diffuse,
                        white->diffuse, value);
    lx_end_formula(steps->document, &text);
}

void lx_explain_light_color(const struct lx_steps *steps, const luxel_light_share *white,
                            const luxel_light_share *share)
{
    double lamp[LX_CHANNELS];
    lx_light_channels(steps->prepared->scene->lights.items[share->light].common, lamp);
    lx_document_paragraph(steps->document, LX_N("Its channels:"), NULL);
    for (int c = 0; c < LX_CHANNELS; c++)
        explain_channel(steps, c, lamp[c], white, share->color->rgb[c]);
}

/* R = 1.2 + 0.3 + 0.1 = 1.6: what the lights give, and then what is reflected. */
static void add_up(const struct lx_steps *steps, const luxel_probe *probe, int c, bool shows_terms)
{
    struct lx_text text = {0};
    double direct = 0;
    lx_add_notation(&text, "$ = ", names[c]);
    for (size_t i = 0; i < probe->share_count; i++) {
        const double value = probe->shares[i].color->rgb[c];
        direct += value;
        if (shows_terms)
            lx_add_notation(&text, i > 0 ? " + !" : "!", value);
    }
    if (probe->has_reflected)
        lx_add_notation(&text, shows_terms && probe->share_count > 0 ? " + !" : "!", probe->color.rgb[c] - direct);
    lx_add_notation(&text, shows_terms || probe->has_reflected ? " = #" : "#", probe->color.rgb[c]);
    lx_end_formula(steps->document, &text);
}

/* What a channel counts for in the luminance. */
static double weight_of(int c)
{
    return luxel_rgb_luminance((const double[LX_CHANNELS]){c == 0, c == 1, c == 2});
}

/* A channel to all its digits. */
static void tell_channel(const struct lx_steps *steps, const luxel_color *color, int c)
{
    char value[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE];
    lx_write_digits(color->rgb[c] == 0 ? 0 : color->rgb[c], 15, value);
    lx_write_bound(lx_error_of_shown(value, color->rgb[c], color->error[c]), 2, error);
    lx_document_item(steps->document, LX_N("{0} = {1}, with an error of at most {2}"),
                     LX_SPANS(LX_MATH(names[c]), LX_PLAIN(value), LX_PLAIN(error)));
}

/* The chromaticity, and the black body that is nearest to it. */
static void explain_chromaticity(const struct lx_steps *steps, const luxel_chromaticity *seen)
{
    char kelvin[LX_NUMBER_SIZE], away[LX_NUMBER_SIZE];
    lx_show_formula(steps->document, "X = #, \\qquad Y = #, \\qquad Z = #", seen->xyz[0], seen->xyz[1], seen->xyz[2]);
    if (!seen->has_xy) {
        lx_document_paragraph(steps->document, LX_N("Without luminance it has no colour."), NULL);
        return;
    }
    lx_show_formula(
        steps->document,
        "x = \\frac{X}{X + Y + Z} = #, \\qquad y = \\frac{Y}{X + Y + Z} = #, \\qquad u' = #, \\qquad v' = #",
        seen->xy[0], seen->xy[1], seen->uv[0], seen->uv[1]);
    if (seen->has_cct)
        lx_document_paragraph(steps->document,
                              LX_N("The black body that is nearest in u, v of 1960 has {0} K, at a distance Duv of "
                                   "{1}."),
                              LX_SPANS(LX_PLAIN(lx_write_digits(seen->cct_k, 7, kelvin)),
                                       LX_PLAIN(lx_write_digits(fabs(seen->duv) < 1e-9 ? 0 : seen->duv, 4, away))));
    else
        lx_document_paragraph(steps->document,
                              LX_N("No black body from 1000 to 25000 K is near it in u, v of 1960: it has no colour "
                                   "temperature."),
                              NULL);
}

void lx_explain_color(const struct lx_steps *steps, const luxel_probe *probe, bool shows_terms)
{
    const double *rgb = probe->color.rgb;
    luxel_chromaticity seen;
    luxel_find_chromaticity(rgb, &seen);
    lx_document_heading(steps->document, 1, LX_N("The colour"), NULL);
    lx_document_paragraph(steps->document,
                          probe->has_reflected ? LX_N("The lights together, and last what other surfaces reflect:")
                                               : LX_N("The lights together:"),
                          NULL);
    for (int c = 0; c < LX_CHANNELS; c++)
        add_up(steps, probe, c, shows_terms);
    for (int c = 0; c < LX_CHANNELS; c++)
        tell_channel(steps, &probe->color, c);
    lx_document_paragraph(steps->document, LX_N("The luminance of these channels of linear sRGB is the value:"), NULL);
    lx_show_formula(steps->document, "Y = # \\cdot ! + # \\cdot ! + # \\cdot ! = #", weight_of(0), rgb[0], weight_of(1),
                    rgb[1], weight_of(2), rgb[2], luxel_rgb_luminance(rgb));
    explain_chromaticity(steps, &seen);
}
