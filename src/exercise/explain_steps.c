/* SPDX-License-Identifier: MIT */
/* One point step by step: each formula with the numbers of the library's own reference put in. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/light.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../light/distribution.h"
#include "../light/placed.h"
#include "../parameter/words.h"
#include "../world/albedo.h"
#include "../world/camera.h"
#include "explain.h"
#include "parameter_tables.h"

enum { DIGITS = 7 };

void lx_add_math_number(struct lx_text *text, double value)
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

void lx_add_math_vector(struct lx_text *text, const lx_bounded3 *vector)
{
    const double values[3] = {vector->x.value, vector->y.value, vector->z.value};
    double largest = fmax(fabs(values[0]), fmax(fabs(values[1]), fabs(values[2])));
    lx_text_puts(text, "(");
    for (int i = 0; i < 3; i++) {
        lx_text_puts(text, i > 0 ? ",\\, " : "");
        /* rounding beside the others is 0 */
        lx_add_math_number(text, fabs(values[i]) < 1e-14 * largest ? 0 : values[i]);
    }
    lx_text_puts(text, ")");
}

/* A formula in the making: text and numbers one after the other; the last part is NULL. */
struct line {
    struct lx_text text;
};

static void say(struct line *line, const char *notation)
{
    lx_text_puts(&line->text, notation);
}

static void number(struct line *line, double value)
{
    lx_add_math_number(&line->text, value);
}

/* In a product a negative factor stands in brackets. */
static void factor(struct line *line, double value)
{
    say(line, value < 0 ? "(" : "");
    number(line, value);
    say(line, value < 0 ? ")" : "");
}

static void vector(struct line *line, const lx_bounded3 *value)
{
    lx_add_math_vector(&line->text, value);
}

static void end(const struct lx_steps *steps, struct line *line)
{
    if (line->text.bytes)
        lx_document_formula(steps->document, line->text.bytes);
    lx_text_clear(&line->text);
}

/* ---- the place ---- */

/* The numbers that a formula of the kind names by @ and a letter. */
static void say_numbers(const struct lx_steps *steps, const char *formula, double x_mm, double y_mm, struct line *line)
{
    const struct lx_shape *shape = &steps->element->own->shape;
    for (; *formula; formula++) {
        if (*formula != '@') {
            say(line, (const char[]){*formula, '\0'});
            continue;
        }
        switch (*++formula) {
        case 'R': number(line, shape->radius_mm); break;
        case 'x': number(line, x_mm); break;
        case 'y': number(line, y_mm); break;
        case 'z': number(line, steps->element->place_mm.z.value); break;
        case 'X': factor(line, shape->anchor_mm[0]); break;
        case 'Y': factor(line, shape->anchor_mm[1]); break;
        default: number(line, shape->anchor_mm[2]); break;
        }
    }
}

static void explain_height(const struct lx_steps *steps, const struct lx_surface_words *words, double x_mm, double y_mm)
{
    struct line line = {{0}};
    say(&line, words->height);
    say(&line, " = ");
    say_numbers(steps, words->height_in_numbers, x_mm, y_mm, &line);
    say(&line, "\\;\\mathrm{mm}");
    end(steps, &line);
}

/* What the material reflects in all. */
static void explain_albedo(const struct lx_steps *steps)
{
    const struct lx_element *element = steps->element;
    char number[LX_NUMBER_SIZE];
    const double albedo = lx_material_albedo(element->own->material, lx_dot3(element->normal, element->view).value);
    if (!(albedo >= 0))
        return;
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
    struct line line = {{0}};
    lx_document_heading(steps->document, 1, LX_N("The point of the surface"), NULL);
    lx_document_paragraph(steps->document,
                          parallel && is_own ? LX_N("The line of sight runs along −z through the point of the screen "
                                                    "(orthographic projection) and meets the surface first here:")
                          : parallel ? LX_N("The line of sight runs at right angles through the point of the screen "
                                            "(orthographic projection) and meets the surface first here:")
                                     : LX_N("The line of sight runs from the observer through the point of the screen "
                                            "(perspective projection) and meets the surface first here:"),
                          NULL);
    if (words && words->height && parallel && is_own)
        explain_height(steps, words, x_mm, y_mm);
    say(&line, "\\mathbf{P} = ");
    vector(&line, &element->place_mm);
    say(&line, "\\;\\mathrm{mm}");
    end(steps, &line);
    lx_document_paragraph(steps->document, LX_N("The normal there and the view vector:"), NULL);
    say(&line, "\\mathbf{N} = ");
    if (words && words->normal) {
        say(&line, words->normal);
        say(&line, " = ");
    }
    vector(&line, &element->normal);
    end(steps, &line);
    say(&line, camera->is_parallel ? "\\mathbf{V} = "
                                   : "\\mathbf{V} = \\frac{\\mathbf{O} - \\mathbf{P}}{|\\mathbf{O} - \\mathbf{P}|} = ");
    vector(&line, &element->view);
    end(steps, &line);
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

static void explain_distance(const struct lx_steps *steps, const struct lx_emitter *emitter, double *r_m)
{
    lx_bounded3 source = lx_exact3(emitter->position_mm), way = lx_sub3(source, steps->element->place_mm);
    struct line line = {{0}};
    *r_m = length_of(&way) / 1000;
    say(&line, "r = |\\mathbf{S} - \\mathbf{P}| = |");
    vector(&line, &source);
    say(&line, " - ");
    vector(&line, &steps->element->place_mm);
    say(&line, "| = ");
    number(&line, 1000 * *r_m);
    say(&line, "\\;\\mathrm{mm} = ");
    number(&line, *r_m);
    say(&line, "\\;\\mathrm{m}");
    end(steps, &line);
}

static void explain_attenuation(const struct lx_steps *steps, const struct lx_emitter *emitter, double r_m)
{
    struct line line = {{0}};
    if (emitter->attenuation == LX_NO_ATTENUATION) {
        say(&line, "a(r) = 1");
    } else if (emitter->attenuation == LX_INVERSE_SQUARE) {
        say(&line, "a(r) = \\frac{1}{r^2} = \\frac{1}{");
        number(&line, r_m);
        say(&line, "^2} = ");
        number(&line, attenuation_at(emitter, r_m));
    } else if (emitter->attenuation == LX_POLYNOMIAL) {
        say(&line, "a(r) = \\frac{1}{k_c + k_l r + k_q r^2} = \\frac{1}{");
        number(&line, emitter->coefficients[0]);
        say(&line, " + ");
        number(&line, emitter->coefficients[1]);
        say(&line, " \\cdot ");
        number(&line, r_m);
        say(&line, " + ");
        number(&line, emitter->coefficients[2]);
        say(&line, " \\cdot ");
        number(&line, r_m);
        say(&line, "^2} = ");
        number(&line, attenuation_at(emitter, r_m));
    } else {
        say(&line, "a(r) = \\frac{1}{k + r} = \\frac{1}{");
        number(&line, emitter->k_mm / 1000);
        say(&line, " + ");
        number(&line, r_m);
        say(&line, "} = ");
        number(&line, attenuation_at(emitter, r_m));
    }
    end(steps, &line);
}

/* The direction as angles of the luminaire's table, and the intensity there. */
static void explain_luminaire(const struct lx_steps *steps, const struct lx_emitter *emitter, lx_bounded3 towards,
                              double left)
{
    const struct lx_pointed *luminaire = emitter->profile.luminaire;
    const luxel_photometry_type type = luminaire->distribution->photometry->shown.type;
    static const char *const first[] = {"X = ", "H = ", "C = "};
    static const char *const second[] = {
        "\\degree, \\qquad Y = ", "\\degree, \\qquad V = ", "\\degree, \\qquad \\gamma = "};
    static const char *const third[] = {
        "\\degree, \\qquad I(X,\\, Y) = ", "\\degree, \\qquad I(H,\\, V) = ", "\\degree, \\qquad I(C,\\, \\gamma) = "};
    struct line line = {{0}};
    double plane, angle;
    lx_pointed_angles(luminaire, (double[]){towards.x.value, towards.y.value, towards.z.value}, &plane, &angle);
    say(&line, first[type]);
    number(&line, plane);
    say(&line, second[type]);
    number(&line, angle);
    say(&line, third[type]);
    number(&line, emitter->strength * left);
    end(steps, &line);
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
    struct line line = {{0}};
    if (profile->luminaire) {
        explain_luminaire(steps, emitter, towards, left);
        return;
    }
    if (lx_profile_is_isotropic(profile))
        return;
    double cosine = -dot(&profile->axis, &towards);
    say(&line, "\\cos \\theta = -\\mathbf{L} \\cdot \\mathbf{A} = ");
    number(&line, cosine);
    say(&line, ", \\qquad \\theta = ");
    number(&line, acos(fmax(-1, fmin(1, cosine))) * (180 / M_PI));
    say(&line, "\\degree, \\qquad ");
    say(&line, profile->falloff == LX_NO_CONE ? "g = " : profile->exponent > 0 ? "f\\, g = " : "f = ");
    number(&line, left);
    end(steps, &line);
}

/* The irradiance as intensity, f and g, as far as there are these. */
static void explain_factors(struct line *line, const struct lx_emitter *emitter, double left)
{
    const bool has_cone = emitter->profile.falloff != LX_NO_CONE, has_pattern = emitter->profile.exponent > 0;
    say(line, has_cone && has_pattern ? "E_{\\perp} = I\\, f\\, g\\, a(r) = "
              : has_cone              ? "E_{\\perp} = I\\, f\\, a(r) = "
              : has_pattern           ? "E_{\\perp} = I\\, g\\, a(r) = "
                                      : "E_{\\perp} = I\\, a(r) = ");
    number(line, emitter->strength);
    if (!has_cone && !has_pattern)
        return;
    say(line, " \\cdot ");
    factor(line, left);
}

static void explain_irradiance(const struct lx_steps *steps, const struct lx_emitter *emitter,
                               const struct lx_sample *sample)
{
    struct line line = {{0}};
    double r_m = 0, left = 1;
    if (lx_is_endless(emitter)) {
        say(&line, "\\mathbf{L} = ");
        vector(&line, &sample->towards);
        say(&line, ", \\qquad E_{\\perp} = ");
        number(&line, sample->e_perp.value);
        end(steps, &line);
        return;
    }
    explain_distance(steps, emitter, &r_m);
    say(&line, "\\mathbf{L} = \\frac{\\mathbf{S} - \\mathbf{P}}{r} = ");
    vector(&line, &sample->towards);
    end(steps, &line);
    explain_attenuation(steps, emitter, r_m);
    if (emitter->strength > 0)
        left = sample->e_perp.value / (emitter->strength * attenuation_at(emitter, r_m));
    explain_profile(steps, emitter, sample->towards, left);
    if (emitter->profile.luminaire) {
        say(&line, "E_{\\perp} = I\\, a(r) = ");
        number(&line, emitter->strength * left);
    } else {
        explain_factors(&line, emitter, left);
    }
    say(&line, " \\cdot ");
    number(&line, attenuation_at(emitter, r_m));
    say(&line, " = ");
    number(&line, sample->e_perp.value);
    end(steps, &line);
}

/* What is reflected of a sample that nothing hides. */
static void explain_diffuse(const struct lx_steps *steps, const struct lx_sample *sample, double hidden,
                            const luxel_light_share *share)
{
    const struct lx_lobe *lobe = steps->element->lobe;
    double cosine = dot(&steps->element->normal, &sample->towards), factor = 1;
    struct line line = {{0}};
    say(&line, "\\mathbf{N} \\cdot \\mathbf{L} = ");
    number(&line, cosine);
    end(steps, &line);
    if (hidden < 1) {
        lx_document_paragraph(steps->document,
                              LX_N("Another surface stands between them and takes this light away: it gives nothing."),
                              NULL);
        return;
    }
    say(&line, "E = E_{\\perp} \\max(0, \\mathbf{N} \\cdot \\mathbf{L}) = ");
    number(&line, sample->e_perp.value);
    say(&line, " \\cdot ");
    number(&line, fmax(0, cosine));
    say(&line, " = ");
    number(&line, share->irradiance);
    end(steps, &line);
    if (steps->quantity == LUXEL_IRRADIANCE)
        return;
    if (lx_lobe_is_rough(lobe)) {
        const struct lx_lobe rough = lx_lobe_of_diffuse(lobe);
        const struct lx_lobe_kind *kind = lx_lobe_kind_of(&rough);
        factor = kind->value(&rough, steps->element->normal, steps->element->view, sample->towards).value;
        say(&line, kind->words.step);
        number(&line, factor);
        end(steps, &line);
    }
    say(&line, lx_lobe_is_rough(lobe) ? "B_d = p\\, k_d\\, D\\, E = " : "B_d = p\\, k_d E = ");
    number(&line, lobe->diffuse.value);
    say(&line, " \\cdot ");
    if (lx_lobe_is_rough(lobe)) {
        number(&line, factor);
        say(&line, " \\cdot ");
    }
    number(&line, share->irradiance);
    say(&line, " = ");
    number(&line, share->diffuse);
    end(steps, &line);
}

/* S of a power, with the vector that it depends on; returns the lobe's f. */
static double explain_power(const struct lx_steps *steps, const struct lx_sample *sample)
{
    const struct lx_element *element = steps->element;
    const struct lx_lobe *lobe = element->lobe;
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    struct line line = {{0}};
    lx_bounded3 pair[2];
    kind->power->pair(element->normal, element->view, sample->towards, pair);
    const double base = fmax(0, dot(&pair[0], &pair[1]));
    say(&line, kind->words.vector);
    say(&line, " = ");
    vector(&line, &pair[kind->power->moving]);
    end(steps, &line);
    say(&line, kind->words.cosine);
    say(&line, " = ");
    number(&line, base);
    say(&line, ", \\qquad S^n = S^{");
    number(&line, lobe->exponent);
    say(&line, "} = ");
    number(&line, pow(base, lobe->exponent));
    say(&line, ", \\qquad w = ");
    number(&line, lx_lobe_weight(lobe, dot(&element->normal, &sample->towards)));
    end(steps, &line);
    return pow(base, lobe->exponent);
}

static void explain_highlight(const struct lx_steps *steps, const struct lx_sample *sample,
                              const luxel_light_share *share)
{
    const struct lx_element *element = steps->element;
    const struct lx_lobe *lobe = element->lobe;
    const struct lx_lobe_kind *kind = lx_lobe_kind_of(lobe);
    const double weight = lx_lobe_weight(lobe, dot(&element->normal, &sample->towards));
    struct line line = {{0}};
    const double shape = kind->power ? explain_power(steps, sample)
                                     : kind->value(lobe, element->normal, element->view, sample->towards).value;
    say(&line, kind->power ? "B_s = E_{\\perp}\\, p\\, k_s\\, c\\, w\\, S^n = " : kind->words.step);
    number(&line, sample->e_perp.value);
    say(&line, " \\cdot ");
    number(&line, lobe->specular.value);
    say(&line, " \\cdot ");
    number(&line, weight);
    say(&line, " \\cdot ");
    number(&line, shape);
    say(&line, " = ");
    number(&line, share->specular);
    end(steps, &line);
}

/* ---- the other lights ---- */

static void explain_ambient(const struct lx_steps *steps, const luxel_light_share *share)
{
    struct line line = {{0}};
    say(&line, "E_a = ");
    number(&line, share->irradiance);
    if (steps->quantity == LUXEL_BRIGHTNESS) {
        say(&line, ", \\qquad B = p\\, k_a E_a = ");
        number(&line, steps->element->lobe->ambient.value);
        say(&line, " \\cdot ");
        number(&line, share->irradiance);
        say(&line, " = ");
        number(&line, share->diffuse);
    }
    end(steps, &line);
}

static void explain_sum(const struct lx_steps *steps, const luxel_light_share *share, size_t emitters,
                        const struct lx_emitter *first)
{
    const bool are_parts = lx_is_extended(first) || first->is_part;
    struct line line = {{0}};
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
    say(&line, "E = ");
    number(&line, share->irradiance);
    if (steps->quantity == LUXEL_BRIGHTNESS) {
        say(&line, lx_lobe_is_rough(steps->element->lobe) ? ", \\qquad B_d = p\\, k_d \\int D\\, dE = "
                                                          : ", \\qquad B_d = p\\, k_d E = ");
        number(&line, share->diffuse);
        if (lx_lobe_kind_of(steps->element->lobe)->value) {
            say(&line, ", \\qquad B_s = ");
            number(&line, share->specular);
        }
    }
    end(steps, &line);
}

static void sum_parts(const struct lx_steps *steps, const luxel_light_share *share)
{
    struct line line = {{0}};
    if (steps->quantity == LUXEL_IRRADIANCE || !lx_lobe_kind_of(steps->element->lobe)->value)
        return;
    say(&line, "B = B_d + B_s = ");
    number(&line, share->diffuse);
    say(&line, " + ");
    number(&line, share->specular);
    say(&line, " = ");
    number(&line, share->diffuse + share->specular);
    end(steps, &line);
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

void lx_explain_light(const struct lx_steps *steps, const luxel_light_share *share)
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
    struct lx_lighting lighting = lx_light_element(steps->prepared, steps->element, first);
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
