/* SPDX-License-Identifier: MIT */
/* One point step by step: each formula with the numbers of the library's own reference put in. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/light.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../light/distribution.h"
#include "../light/placed.h"
#include "../parameter/words.h"
#include "../scene/colours.h"
#include "../world/albedo.h"
#include "../world/camera.h"
#include "explain.h"
#include "parameter_tables.h"

enum { DIGITS = 7 };

static void add_number(struct lx_text *text, double value)
{
    char number[LX_NUMBER_SIZE];
    char *power = strchr(lx_write_digits(value == 0 ? 0 : value, DIGITS, number), 'e');
    if (!power) {
        lx_text_puts(text, number);
        return;
    }
    *power = '\0';
    lx_text_puts(text, number);
    lx_text_printf(text, " \\cdot 10^{%ld}", strtol(power + 1, NULL, 10));
}

static void add_vector(struct lx_text *text, const lx_bounded3 *vector)
{
    const double values[3] = {vector->x.value, vector->y.value, vector->z.value};
    double largest = fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
    lx_text_puts(text, "(");
    for (int i = 0; i < 3; i++) {
        lx_text_puts(text, i > 0 ? ",\\, " : "");
        /* rounding beside the others is 0 */
        add_number(text, fabs(values[i]) < 1e-14 * largest ? 0 : values[i]);
    }
    lx_text_puts(text, ")");
}

static void add_marked(struct lx_text *text, const char *notation, va_list values)
{
    for (; *notation; notation++) {
        const size_t plain = strcspn(notation, "#!@$");
        lx_text_add(text, notation, plain);
        notation += plain;
        const char mark = *notation;
        if (mark == '\0')
            return;
        if (mark == '@') {
            add_vector(text, va_arg(values, const lx_bounded3 *));
        } else if (mark == '$') {
            lx_text_puts(text, va_arg(values, const char *));
        } else {
            const double number = va_arg(values, double);
            const bool in_brackets = mark == '!' && number < 0;
            lx_text_puts(text, in_brackets ? "(" : "");
            add_number(text, number);
            lx_text_puts(text, in_brackets ? ")" : "");
        }
    }
}

void lx_add_notation(struct lx_text *text, const char *notation, ...)
{
    va_list values;
    va_start(values, notation);
    add_marked(text, notation, values);
    va_end(values);
}

void lx_end_formula(struct luxel_document *document, struct lx_text *text)
{
    if (text->bytes)
        lx_document_formula(document, text->bytes);
    lx_text_clear(text);
}

void lx_show_formula(struct luxel_document *document, const char *notation, ...)
{
    struct lx_text text = {0};
    va_list values;
    va_start(values, notation);
    add_marked(&text, notation, values);
    va_end(values);
    lx_end_formula(document, &text);
}

/* ---- the place ---- */

/* The numbers that a formula of the kind names by @ and a letter. */
static void add_numbers(const struct lx_steps *steps, const char *formula, double x_mm, double y_mm,
                        struct lx_text *text)
{
    const struct lx_shape *shape = &steps->element->own->shape;
    for (; *formula; formula++) {
        if (*formula != '@') {
            lx_text_add(text, formula, 1);
            continue;
        }
        switch (*++formula) {
        case 'R': lx_add_notation(text, "#", shape->radius_mm); break;
        case 'x': lx_add_notation(text, "#", x_mm); break;
        case 'y': lx_add_notation(text, "#", y_mm); break;
        case 'z': lx_add_notation(text, "#", steps->element->place_mm.z.value); break;
        case 'X': lx_add_notation(text, "!", shape->anchor_mm[0]); break;
        case 'Y': lx_add_notation(text, "!", shape->anchor_mm[1]); break;
        default: lx_add_notation(text, "#", shape->anchor_mm[2]); break;
        }
    }
}

static void explain_height(const struct lx_steps *steps, const struct lx_surface_words *words, double x_mm, double y_mm)
{
    struct lx_text text = {0};
    lx_add_notation(&text, "$ = ", words->height);
    add_numbers(steps, words->height_in_numbers, x_mm, y_mm, &text);
    lx_add_notation(&text, "\\;\\mathrm{mm}");
    lx_end_formula(steps->document, &text);
}

static double albedo_of(const struct lx_steps *steps, const struct lx_material *material)
{
    return lx_material_albedo(material, lx_dot3(steps->element->normal, steps->element->view).value);
}

/* What a material of colours reflects in each channel. */
static void explain_albedos(const struct lx_steps *steps, const struct lx_material *material)
{
    char numbers[LX_CHANNELS][LX_NUMBER_SIZE];
    for (unsigned c = 0; c < LX_CHANNELS; c++) {
        const struct lx_material seen = lx_material_in_channel(material, c + 1);
        lx_write_digits(100 * albedo_of(steps, &seen), 4, numbers[c]);
    }
    lx_document_paragraph(steps->document,
                          LX_N("Of light that came from all sides alike the material would send {0} % of red, {1} % of "
                               "green and {2} % of blue this way."),
                          LX_SPANS(LX_PLAIN(numbers[0]), LX_PLAIN(numbers[1]), LX_PLAIN(numbers[2])));
}

/* What the material reflects in all. */
static void explain_albedo(const struct lx_steps *steps)
{
    const struct lx_material *material = steps->element->own->material;
    char number[LX_NUMBER_SIZE];
    const double albedo = albedo_of(steps, material);
    if (!(albedo >= 0))
        return;
    if (lx_is_in_color(lx_scene_parameters(steps->scene)) && lx_has_color(material)) {
        explain_albedos(steps, material);
        return;
    }
    lx_document_paragraph(steps->document,
                          albedo > 1 ? LX_N("Of light that came from all sides alike the material would send {0} % "
                                            "this way: more than falls in, as highlights do that nothing keeps in "
                                            "bounds.")
                                     : LX_N("Of light that came from all sides alike the material would send {0} % "
                                            "this way."),
                          LX_SPANS(LX_PLAIN(lx_write_digits(100 * albedo, 4, number))));
}

void lx_explain_place(const struct lx_steps *steps, double x_mm, double y_mm)
{
    const struct lx_camera *camera = &steps->prepared->camera;
    const struct lx_element *element = steps->element;
    const struct lx_surface_words *words = element->own->kind->words;
    const bool parallel = !camera->is_perspective, is_own = camera->frame.is_own;
    char count[LX_NUMBER_SIZE];
    lx_document_heading(steps->document, 1, LX_N("The point of the surface"), NULL);
    if (element->mirrors > 0)
        lx_document_paragraph(steps->document,
                              LX_N("The line of sight meets a mirror. Over {0} in a row it goes on to this point, "
                                   "whose light is what the mirror shows:"),
                              LX_SPANS(LX_PLAIN(lx_write_number(element->mirrors, count))));
    else
        lx_document_paragraph(
            steps->document,
            parallel && is_own ? LX_N("The line of sight runs along −z through the point of the screen (orthographic "
                                      "projection) and meets the surface first here:")
            : parallel ? LX_N("The line of sight runs at right angles through the point of the screen (orthographic "
                              "projection) and meets the surface first here:")
                       : LX_N("The line of sight runs from the observer through the point of the screen (perspective "
                              "projection) and meets the surface first here:"),
            NULL);
    if (element->mirrors == 0 && words && words->height && parallel && is_own)
        explain_height(steps, words, x_mm, y_mm);
    lx_show_formula(steps->document, "\\mathbf{P} = @\\;\\mathrm{mm}", &element->place_mm);
    lx_document_paragraph(steps->document, LX_N("The normal there and the view vector:"), NULL);
    const char *normal = words ? words->normal : NULL;
    lx_show_formula(steps->document, "\\mathbf{N} = $$@", normal ? normal : "", normal ? " = " : "", &element->normal);
    lx_show_formula(steps->document,
                    camera->is_parallel || element->mirrors > 0
                        ? "\\mathbf{V} = @"
                        : "\\mathbf{V} = \\frac{\\mathbf{O} - \\mathbf{P}}{|\\mathbf{O} - \\mathbf{P}|} = @",
                    &element->view);
    if (steps->quantity == LUXEL_BRIGHTNESS)
        explain_albedo(steps);
}

/* ---- a point-like light ---- */

static double length_of(const lx_bounded3 *vector)
{
    return sqrt(vector->x.value * vector->x.value + vector->y.value * vector->y.value +
                vector->z.value * vector->z.value);
}

static double dot(const lx_bounded3 *a, const lx_bounded3 *b)
{
    return a->x.value * b->x.value + a->y.value * b->y.value + a->z.value * b->z.value;
}

static double attenuation_at(const struct lx_emitter *emitter, double r_m)
{
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return 1 / (r_m * r_m);
    case LX_PRACTICAL: return 1 / (emitter->k_mm / 1000 + r_m);
    case LX_POLYNOMIAL: return lx_by_polynomial(emitter->coefficients, r_m);
    case LX_NO_ATTENUATION: break;
    }
    return 1;
}

static double explain_distance(const struct lx_steps *steps, const struct lx_emitter *emitter)
{
    const lx_bounded3 source = lx_exact3(emitter->position_mm), way = lx_sub3(source, steps->element->place_mm);
    const double r_m = length_of(&way) / 1000;
    lx_show_formula(steps->document, "r = |\\mathbf{S} - \\mathbf{P}| = |@ - @| = #\\;\\mathrm{mm} = #\\;\\mathrm{m}",
                    &source, &steps->element->place_mm, 1000 * r_m, r_m);
    return r_m;
}

static void explain_attenuation(const struct lx_steps *steps, const struct lx_emitter *emitter, double r_m)
{
    const double *k = emitter->coefficients, value = attenuation_at(emitter, r_m);
    switch (emitter->attenuation) {
    case LX_NO_ATTENUATION: lx_show_formula(steps->document, "a(r) = 1"); break;
    case LX_INVERSE_SQUARE:
        lx_show_formula(steps->document, "a(r) = \\frac{1}{r^2} = \\frac{1}{#^2} = #", r_m, value);
        break;
    case LX_POLYNOMIAL:
        lx_show_formula(steps->document,
                        "a(r) = \\frac{1}{k_c + k_l r + k_q r^2} = \\frac{1}{# + # \\cdot # + # \\cdot #^2} = #", k[0],
                        k[1], r_m, k[2], r_m, value);
        break;
    case LX_PRACTICAL:
        lx_show_formula(steps->document, "a(r) = \\frac{1}{k + r} = \\frac{1}{# + #} = #", emitter->k_mm / 1000, r_m,
                        value);
        break;
    }
}

/* The direction as angles of the luminaire's table, and the intensity there. */
static void explain_luminaire(const struct lx_steps *steps, const struct lx_emitter *emitter, lx_bounded3 towards,
                              double left)
{
    const struct lx_pointed *luminaire = emitter->profile.luminaire;
    const luxel_photometry_type type = luminaire->distribution->photometry->shown.type;
    static const char *const notations[] = {
        "X = #\\degree, \\qquad Y = #\\degree, \\qquad I(X,\\, Y) = #",
        "H = #\\degree, \\qquad V = #\\degree, \\qquad I(H,\\, V) = #",
        "C = #\\degree, \\qquad \\gamma = #\\degree, \\qquad I(C,\\, \\gamma) = #",
    };
    double plane, angle;
    lx_pointed_angles(luminaire, (double[]){towards.x.value, towards.y.value, towards.z.value}, &plane, &angle);
    lx_show_formula(steps->document, notations[type], plane, angle, emitter->strength * left);
    lx_document_paragraph(steps->document,
                          luminaire->distribution->interpolation == LUXEL_INTERPOLATE_ANGLE
                              ? LX_N("This intensity is read off the table of the file, linear in both angles.")
                              : LX_N("This intensity is read off the table of the file, linear in the horizontal angle "
                                     "and the cosine of the other."),
                          NULL);
}

/* What pattern and cone leave of the intensity: g f as one number, with the angle from the axis. */
static void explain_profile(const struct lx_steps *steps, const struct lx_emitter *emitter, lx_bounded3 towards,
                            double left)
{
    const struct lx_profile *profile = &emitter->profile;
    if (profile->luminaire) {
        explain_luminaire(steps, emitter, towards, left);
        return;
    }
    if (lx_profile_is_isotropic(profile))
        return;
    const double cosine = -dot(&profile->axis, &towards);
    lx_show_formula(steps->document,
                    "\\cos \\theta = -\\mathbf{L} \\cdot \\mathbf{A} = #, \\qquad \\theta = #\\degree, \\qquad $#",
                    cosine, acos(fmax(-1, fmin(1, cosine))) * (180 / M_PI),
                    profile->falloff == LX_NO_CONE ? "g = "
                    : profile->exponent > 0        ? "f\\, g = "
                                                   : "f = ",
                    left);
}

/* The irradiance as intensity, f and g, as far as there are these, and the law of the distance. */
static void explain_product(const struct lx_steps *steps, const struct lx_emitter *emitter, double left, double law,
                            double e_perp)
{
    const bool has_cone = emitter->profile.falloff != LX_NO_CONE, has_pattern = emitter->profile.exponent > 0;
    if (emitter->profile.luminaire)
        lx_show_formula(steps->document, "E_{\\perp} = I\\, a(r) = # \\cdot # = #", emitter->strength * left, law,
                        e_perp);
    else if (!has_cone && !has_pattern)
        lx_show_formula(steps->document, "E_{\\perp} = I\\, a(r) = # \\cdot # = #", emitter->strength, law, e_perp);
    else
        lx_show_formula(steps->document, "E_{\\perp} = I\\, $a(r) = # \\cdot ! \\cdot # = #",
                        has_cone && has_pattern ? "f\\, g\\, "
                        : has_cone              ? "f\\, "
                                                : "g\\, ",
                        emitter->strength, left, law, e_perp);
}

static void explain_irradiance(const struct lx_steps *steps, const struct lx_emitter *emitter,
                               const struct lx_sample *sample)
{
    const double e_perp = sample->e_perp.value;
    if (lx_is_endless(emitter)) {
        lx_show_formula(steps->document, "\\mathbf{L} = @, \\qquad E_{\\perp} = #", &sample->towards, e_perp);
        return;
    }
    const double r_m = explain_distance(steps, emitter), law = attenuation_at(emitter, r_m);
    const double left = emitter->strength > 0 ? e_perp / (emitter->strength * law) : 1;
    lx_show_formula(steps->document, "\\mathbf{L} = \\frac{\\mathbf{S} - \\mathbf{P}}{r} = @", &sample->towards);
    explain_attenuation(steps, emitter, r_m);
    explain_profile(steps, emitter, sample->towards, left);
    explain_product(steps, emitter, left, law, e_perp);
}

/* What is reflected of a sample that nothing hides. */
static void explain_diffuse(const struct lx_steps *steps, const struct lx_sample *sample, double hidden,
                            const luxel_light_share *share)
{
    const struct lx_lobe *lobe = steps->element->lobe;
    const double cosine = dot(&steps->element->normal, &sample->towards);
    lx_show_formula(steps->document, "\\mathbf{N} \\cdot \\mathbf{L} = #", cosine);
    if (hidden < 1) {
        lx_document_paragraph(steps->document,
                              LX_N("Another surface stands between them and takes this light away: it gives nothing."),
                              NULL);
        return;
    }
    lx_show_formula(steps->document, "E = E_{\\perp} \\max(0, \\mathbf{N} \\cdot \\mathbf{L}) = # \\cdot # = #",
                    sample->e_perp.value, fmax(0, cosine), share->irradiance);
    if (steps->quantity == LUXEL_IRRADIANCE)
        return;
    if (!lx_lobe_is_rough(lobe)) {
        lx_show_formula(steps->document, "B_d = p\\, k_d E = # \\cdot # = #", lobe->diffuse.value, share->irradiance,
                        share->diffuse);
        return;
    }
    const struct lx_lobe rough = lx_lobe_of_diffuse(lobe);
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(&rough);
    const double factor = kind->value(&rough, steps->element->normal, steps->element->view, sample->towards).value;
    lx_show_formula(steps->document, "$#", kind->words.step, factor);
    lx_show_formula(steps->document, "B_d = p\\, k_d\\, D\\, E = # \\cdot # \\cdot # = #", lobe->diffuse.value, factor,
                    share->irradiance, share->diffuse);
}

/* S of a power, with the vector that it depends on; returns the lobe's f. */
static double explain_power(const struct lx_steps *steps, const struct lx_sample *sample)
{
    const struct lx_element *element = steps->element;
    const struct lx_lobe *lobe = element->lobe;
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    lx_bounded3 pair[2];
    kind->power->pair(element->normal, element->view, sample->towards, pair);
    const double base = fmax(0, dot(&pair[0], &pair[1]));
    lx_show_formula(steps->document, "$ = @", kind->words.vector, &pair[kind->power->moving]);
    lx_show_formula(steps->document, "$ = #, \\qquad S^n = S^{#} = #, \\qquad w = #", kind->words.cosine, base,
                    lobe->exponent, pow(base, lobe->exponent),
                    lx_lobe_weight(lobe, dot(&element->normal, &sample->towards)));
    return pow(base, lobe->exponent);
}

static void explain_highlight(const struct lx_steps *steps, const struct lx_sample *sample,
                              const luxel_light_share *share)
{
    const struct lx_element *element = steps->element;
    const struct lx_lobe *lobe = element->lobe;
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    const double weight = lx_lobe_weight(lobe, dot(&element->normal, &sample->towards));
    const double shape = kind->power ? explain_power(steps, sample)
                                     : kind->value(lobe, element->normal, element->view, sample->towards).value;
    lx_show_formula(steps->document, "$# \\cdot # \\cdot # \\cdot # = #",
                    kind->power ? "B_s = E_{\\perp}\\, p\\, k_s\\, c\\, w\\, S^n = " : kind->words.step,
                    sample->e_perp.value, lobe->specular.value, weight, shape, share->specular);
}

/* ---- the other lights ---- */

static void explain_ambient(const struct lx_steps *steps, const luxel_light_share *share)
{
    if (steps->quantity == LUXEL_BRIGHTNESS)
        lx_show_formula(steps->document, "E_a = #, \\qquad B = p\\, k_a E_a = # \\cdot # = #", share->irradiance,
                        steps->element->lobe->ambient.value, share->irradiance, share->diffuse);
    else
        lx_show_formula(steps->document, "E_a = #", share->irradiance);
}

static void explain_sum(const struct lx_steps *steps, const luxel_light_share *share, size_t emitters,
                        const struct lx_emitter *first)
{
    const bool are_parts = lx_is_extended(first) || first->is_part;
    struct lx_text text = {0};
    char parts[LX_NUMBER_SIZE];
    if (emitters > 1)
        lx_document_paragraph(steps->document,
                              are_parts ? LX_N("It is the sum of {0} parts.") : LX_N("It is the sum of {0} sources."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)emitters, parts))));
    if (share->parts > 0 && lx_is_opening(first))
        lx_document_paragraph(steps->document,
                              LX_N("The integral over the luminous opening was computed from {0} of its points, until "
                                   "its error was small enough."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)share->parts, parts))));
    else if (share->parts > 0)
        lx_document_paragraph(steps->document,
                              LX_N("The integral over the source was computed from {0} of its points, until its error "
                                   "was small enough; what is diffuse by the inverse square is a closed form."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)share->parts, parts))));
    else if (are_parts && emitters == 1 && !lx_is_opening(first))
        lx_document_paragraph(steps->document, LX_N("The integral over the source has a closed form."), NULL);
    lx_add_notation(&text, "E = #", share->irradiance);
    if (steps->quantity == LUXEL_BRIGHTNESS)
        lx_add_notation(&text,
                        lx_lobe_is_rough(steps->element->lobe) ? ", \\qquad B_d = p\\, k_d \\int D\\, dE = #"
                                                               : ", \\qquad B_d = p\\, k_d E = #",
                        share->diffuse);
    if (steps->quantity == LUXEL_BRIGHTNESS && lx_lobe_kind_of(steps->element->lobe)->value)
        lx_add_notation(&text, ", \\qquad B_s = #", share->specular);
    lx_end_formula(steps->document, &text);
}

static void sum_parts(const struct lx_steps *steps, const luxel_light_share *share)
{
    if (steps->quantity == LUXEL_BRIGHTNESS && lx_lobe_kind_of(steps->element->lobe)->value)
        lx_show_formula(steps->document, "B = B_d + B_s = # + # = #", share->diffuse, share->specular,
                        share->diffuse + share->specular);
}

/* Intensity and flux, as far as there are such: the pattern integrated over all directions, whatever the law. */
static void explain_strength(const struct lx_steps *steps, size_t light)
{
    const bool photometric = steps->prepared->scene->units == LX_PHOTOMETRIC;
    double flux = (double)NAN, intensity = (double)NAN;
    char numbers[2][LX_NUMBER_SIZE];
    if (luxel_scene_light_flux(steps->scene, light, &flux) != LUXEL_OK || !isfinite(flux))
        return;
    luxel_scene_light_intensity(steps->scene, light, &intensity);
    const struct lx_span sent = LX_PLAIN(lx_write_digits(flux, 7, numbers[0]));
    const struct lx_span in_flux = LX_TERM_SPAN(lx_unit_word(LX_UNIT_POWER, photometric));
    if (!isfinite(intensity))
        lx_document_paragraph(steps->document,
                              LX_N("The flux that it sends out in all directions together is {0} {1}."),
                              LX_SPANS(sent, in_flux));
    else
        lx_document_paragraph(
            steps->document,
            LX_N("Its intensity is {0} {1}, and the flux that it sends out in all directions together "
                 "is {2} {3}."),
            LX_SPANS(LX_PLAIN(lx_write_digits(intensity, 7, numbers[1])),
                     LX_TERM_SPAN(lx_unit_word(LX_UNIT_INTENSITY, photometric)), sent, in_flux));
}

/* What a light gives directly, of all that it gives. */
static luxel_light_share direct_share(const struct lx_steps *steps, const luxel_light_share *share)
{
    const struct lx_emitters *emitters = &steps->prepared->emitters;
    luxel_light_share direct = *share;
    direct.irradiance = direct.diffuse = direct.specular = 0;
    for (size_t i = 0; i < emitters->count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(emitters, i, &room);
        if (emitter->light != share->light)
            continue;
        const struct lx_lighting lighting = lx_light_directly(steps->prepared, steps->element, emitter);
        direct.irradiance += lighting.irradiance.value;
        direct.diffuse += lighting.diffuse.value;
        direct.specular += lighting.specular.value;
    }
    return direct;
}

/* What comes over mirrors beside that. */
static void explain_images(const struct lx_steps *steps, const luxel_light_share *direct,
                           const luxel_light_share *share)
{
    const bool is_irradiance = steps->quantity == LUXEL_IRRADIANCE;
    const double all = is_irradiance ? share->irradiance : share->diffuse + share->specular;
    const double known = is_irradiance ? direct->irradiance : direct->diffuse + direct->specular;
    lx_document_paragraph(steps->document,
                          LX_N("So much comes directly. Over mirrors the light comes as from its images, of which the "
                               "mirrors' outlines leave a part; with what these give it is:"),
                          NULL);
    lx_show_formula(steps->document, is_irradiance ? "E = # + # = #" : "B = # + # = #", known, all - known, all);
}

static void explain_direct_light(const struct lx_steps *steps, const luxel_light_share *share);

void lx_explain_light(const struct lx_steps *steps, const luxel_light_share *share)
{
    const luxel_light_share direct = direct_share(steps, share);
    const bool is_mirrored = steps->prepared->mirrors.count > 0 && direct.irradiance != share->irradiance;
    explain_direct_light(steps, is_mirrored ? &direct : share);
    if (is_mirrored)
        explain_images(steps, &direct, share);
}

static void explain_direct_light(const struct lx_steps *steps, const luxel_light_share *share)
{
    const struct lx_emitters *emitters = &steps->prepared->emitters;
    struct lx_emitter room, made;
    const struct lx_emitter *first = NULL;
    struct lx_text name = {0};
    size_t count = 0;
    for (size_t i = 0; i < emitters->count; i++) {
        if (lx_emitter_at(emitters, i, &room)->light != share->light)
            continue;
        first = first ? first : lx_emitter_at(emitters, i, &made);
        count += !lx_emitter_at(emitters, i, &room)->is_back;
    }
    lx_add_element_name(&name, "lights", share->light, share->name);
    if (name.bytes)
        lx_document_heading(
            steps->document, 2, "{0}: {1}",
            LX_SPANS(LX_PLAIN(name.bytes),
                     LX_TERM_SPAN(steps->prepared->scene->lights.items[share->light].variant->meaning)));
    lx_text_clear(&name);
    if (!first)
        return;
    explain_strength(steps, share->light);
    if (lx_is_uniform(first)) {
        explain_ambient(steps, share);
        return;
    }
    if (lx_is_extended(first) || first->is_part || count > 1) {
        explain_sum(steps, share, count, first);
        sum_parts(steps, share);
        lx_explain_shadows(steps, share, count);
        return;
    }
    struct lx_sample sample = lx_emitter_sample(first, steps->element->place_mm);
    struct lx_lighting lighting = lx_light_directly(steps->prepared, steps->element, first);
    struct lx_reflection free =
        lx_lobe_reflect(steps->element->lobe, steps->element->normal, steps->element->view, sample.towards);
    double seen = sample.e_perp.value * (free.diffuse.value + free.specular.value);
    bool hidden = seen > 0 && lighting.diffuse.value + lighting.specular.value == 0;
    explain_irradiance(steps, first, &sample);
    explain_diffuse(steps, &sample, hidden ? 0 : 1, share);
    if (hidden)
        lx_explain_shadows(steps, share, count);
    if (hidden || steps->quantity == LUXEL_IRRADIANCE || !lx_lobe_kind_of(steps->element->lobe)->value)
        return;
    explain_highlight(steps, &sample, share);
    sum_parts(steps, share);
}
