/* SPDX-License-Identifier: MIT */
/* The formulas of a scene in general: each once, in the order of the calculation, and only those that it uses. */
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../light/distribution.h"
#include "../light/placed.h"
#include "../parameter/decode.h"
#include "../scene/materials.h"
#include "../surface/part.h"
#include "explain.h"

/* What of the kinds of lights there is in a scene. */
struct used {
    bool ambient, distant, dome, point, spot, extended, opening, parts, laws[LX_LAWS], isotropic, lambertian, cosine,
        falloffs[5];
    bool by_angle, by_cosine; /* luminaires */
};

static void note_interpolation(struct used *used, const struct lx_profile *profile)
{
    if (!profile->luminaire)
        return;
    const bool by_angle = profile->luminaire->distribution->interpolation == LUXEL_INTERPOLATE_ANGLE;
    *(by_angle ? &used->by_angle : &used->by_cosine) = true;
}

static struct used find_used(const struct lx_prepared *prepared)
{
    struct used used = {0};
    for (size_t i = 0; i < prepared->emitters.count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *emitter = lx_emitter_at(&prepared->emitters, i, &room);
        const struct lx_profile *profile = &emitter->profile;
        used.ambient |= lx_is_uniform(emitter);
        used.dome |= lx_is_dome(emitter);
        used.distant |= lx_is_endless(emitter);
        used.extended |= lx_is_extended(emitter) && !lx_is_opening(emitter);
        used.opening |= lx_is_opening(emitter);
        used.parts |= emitter->is_part;
        if (lx_has_place(emitter))
            used.laws[emitter->attenuation] = true;
        note_interpolation(&used, profile);
        if (!lx_is_point(emitter) || emitter->is_part)
            continue;
        used.point = true;
        used.spot |= profile->falloff != LX_NO_CONE;
        used.falloffs[profile->falloff] = true;
        used.isotropic |= profile->exponent == 0 && !profile->luminaire;
        used.lambertian |= profile->exponent == 1;
        used.cosine |= profile->exponent > 0 && profile->exponent != 1;
    }
    return used;
}

static const struct lx_surface_kind *authored_kind(const struct lx_prepared *prepared, size_t i)
{
    return (const struct lx_surface_kind *)prepared->scene->surfaces.items[prepared->surfaces[i].authored].variant;
}

/* The words of surface i: of the whole where it is a part of one, else of the shape that it has. */
static const struct lx_surface_words *words_at(const struct lx_prepared *prepared, size_t i)
{
    const struct lx_surface_kind *kind = authored_kind(prepared, i);
    return lx_part_name(kind, 0) ? kind->words : prepared->surfaces[i].kind->words;
}

/*
 * The words of surface i, where it is of a kind with this name and none before it has the same.  By its name: luxel-
 * figure has tables of its own beside those of the library that prepared the scene.
 */
static const struct lx_surface_words *words_of(const struct lx_prepared *prepared, size_t i,
                                               const struct lx_variant *variant)
{
    const struct lx_surface_words *words = words_at(prepared, i);
    if (!words || strcmp(authored_kind(prepared, i)->variant.name, variant->name) != 0)
        return NULL;
    for (size_t k = 0; k < i; k++)
        if (words_at(prepared, k) == words)
            return NULL;
    return words;
}

static void explain_kind(struct luxel_document *document, const struct lx_surface_words *words, bool heights)
{
    if (heights && words->height) {
        lx_show_formula(document, "\\mathbf{P} = (x,\\, y,\\, z), \\qquad $", words->height);
    } else if (!heights && words->sentence) {
        struct lx_span spans[LX_COUNT(words->formulas) + 1] = {{LX_SPAN_END, NULL}};
        for (size_t i = 0; i < LX_COUNT(words->formulas) && words->formulas[i]; i++) {
            spans[i] = (struct lx_span)LX_MATH(words->formulas[i]);
            spans[i + 1] = (struct lx_span){LX_SPAN_END, NULL};
        }
        lx_document_paragraph(document, words->sentence, spans);
    }
}

/* What holds for each kind of surface that the scene has: a formula of the place, or a sentence about the normal. */
static void explain_kinds(struct luxel_document *document, const struct lx_prepared *prepared, bool heights)
{
    for (size_t k = 0; lx_surface_variants[k]; k++)
        for (size_t i = 0; i < prepared->surface_count; i++) {
            const struct lx_surface_words *words = words_of(prepared, i, lx_surface_variants[k]);
            if (words)
                explain_kind(document, words, heights);
        }
}

/* A screen that was carried to where the observer looks: its frame in numbers, and the place on a line of sight. */
static void explain_carried(struct luxel_document *document, const struct lx_camera *camera)
{
    static const char *const names[] = {"\\mathbf{X}", "\\mathbf{Y}", "\\mathbf{Z}"};
    const lx_bounded3 target = lx_exact3(camera->frame.origin_mm), position = lx_exact3(camera->position_mm);
    lx_document_paragraph(document,
                          LX_N("The observer stands at {0} and looks at {1}, the middle of the screen. The screen is "
                               "carried there as a whole; its axes are {2} to the right, {3} upwards and {4} towards "
                               "the observer:"),
                          LX_SPANS(LX_MATH("\\mathbf{O}"), LX_MATH("\\mathbf{T}"), LX_MATH(names[0]), LX_MATH(names[1]),
                                   LX_MATH(names[2])));
    lx_show_formula(document, "\\mathbf{O} = @\\;\\mathrm{mm}, \\qquad \\mathbf{T} = @\\;\\mathrm{mm}", &position,
                    &target);
    for (int i = 0; i < 3; i++)
        lx_show_formula(document, "$ = @", names[i], &camera->frame.rounded[i]);
    lx_document_paragraph(document,
                          LX_N("The line of sight through the point (x, y) of the screen meets a surface in the point "
                               "{0}, the nearest to the observer:"),
                          LX_SPANS(LX_MATH("\\mathbf{P}")));
    lx_document_formula(document, camera->is_perspective
                                      ? "\\mathbf{P} = \\mathbf{O} + t\\,(\\mathbf{T} + x\\,\\mathbf{X} + "
                                        "y\\,\\mathbf{Y} - \\mathbf{O}), \\qquad t > 0"
                                      : "\\mathbf{P} = \\mathbf{O} + x\\,\\mathbf{X} + y\\,\\mathbf{Y} - "
                                        "t\\,\\mathbf{Z}, \\qquad t > 0");
}

static void explain_places(struct luxel_document *document, const struct lx_prepared *prepared)
{
    const struct lx_camera *camera = &prepared->camera;
    if (!camera->frame.is_own) {
        explain_carried(document, camera);
    } else if (!camera->is_perspective) {
        lx_document_paragraph(document,
                              LX_N("Lines of sight run along −z (orthographic projection). Through the point (x, y) of "
                                   "the screen they meet a surface in the point {0}, the nearest to the observer:"),
                              LX_SPANS(LX_MATH("\\mathbf{P}")));
        explain_kinds(document, prepared, true);
    } else {
        lx_document_paragraph(document,
                              LX_N("Lines of sight run from the observer {0} through the point (x, y) of the screen "
                                   "(perspective projection) and meet a surface in the point {1}, the nearest one:"),
                              LX_SPANS(LX_MATH("\\mathbf{O} = (0,\\, 0,\\, z_O)"), LX_MATH("\\mathbf{P}")));
        lx_document_formula(document, "\\mathbf{P} = \\mathbf{O} + t\\,(x,\\, y,\\, -z_O), \\qquad t > 0");
    }
    explain_kinds(document, prepared, false);
    if (camera->is_parallel)
        lx_document_paragraph(
            document, LX_N("The view vector is {0} everywhere."),
            LX_SPANS(LX_MATH(camera->frame.is_own ? "\\mathbf{V} = (0,\\, 0,\\, 1)" : "\\mathbf{V} = \\mathbf{Z}")));
    else
        lx_document_paragraph(
            document, LX_N("The view vector points to the observer: {0}."),
            LX_SPANS(LX_MATH("\\mathbf{V} = (\\mathbf{O} - \\mathbf{P}) / |\\mathbf{O} - \\mathbf{P}|")));
}

static void explain_laws(struct luxel_document *document, const struct used *used)
{
    if (used->laws[LX_INVERSE_SQUARE])
        lx_document_item(document, LX_N("attenuation by the inverse square of the distance in metres: {0}"),
                         LX_SPANS(LX_MATH("a(r) = 1 / r^2")));
    if (used->laws[LX_PRACTICAL])
        lx_document_item(document, LX_N("attenuation by the practical law, distances in metres: {0}"),
                         LX_SPANS(LX_MATH("a(r) = 1 / (k + r)")));
    if (used->laws[LX_POLYNOMIAL])
        lx_document_item(document, LX_N("attenuation by a polynomial of the distance in metres: {0}"),
                         LX_SPANS(LX_MATH("a(r) = 1 / (k_c + k_l r + k_q r^2)")));
    if (used->laws[LX_NO_ATTENUATION])
        lx_document_item(document, LX_N("no attenuation: {0}"), LX_SPANS(LX_MATH("a(r) = 1")));
    if (used->lambertian)
        lx_document_item(document, LX_N("the Lambertian pattern, by the angle from the source's axis: {0}"),
                         LX_SPANS(LX_MATH("g = \\max(0, \\cos \\theta)")));
    if (used->cosine)
        lx_document_item(document, LX_N("the pattern of a power of the cosine, by the angle from the axis: {0}"),
                         LX_SPANS(LX_MATH("g = \\max(0, \\cos \\theta)^m")));
    if (used->by_angle)
        lx_document_item(document,
                         LX_N("the table of a luminaire's file, linear between its angles: {0}; beyond them 0"),
                         LX_SPANS(LX_MATH("g = I(C,\\, \\gamma) / I")));
    if (used->by_cosine)
        lx_document_item(document,
                         LX_N("the table of a luminaire's file, linear in C and {1} between its angles: {0}; beyond "
                              "them 0"),
                         LX_SPANS(LX_MATH("g = I(C,\\, \\gamma) / I"), LX_MATH("\\cos \\gamma")));
    if (used->falloffs[LX_SMOOTHSTEP])
        lx_document_item(
            document, LX_N("the cone of a spotlight, smooth between the inner angle a and the outer angle b: {0}"),
            LX_SPANS(LX_MATH("f = t^2 (3 - 2 t), \\quad t = \\frac{\\cos \\theta - \\cos b}{\\cos a - \\cos b}")));
    if (used->falloffs[LX_SQUARED])
        lx_document_item(document,
                         LX_N("the cone of a spotlight, squared between the inner angle a and the outer angle b: {0}"),
                         LX_SPANS(LX_MATH("f = t^2, \\quad t = \\frac{\\cos \\theta - \\cos b}{\\cos a - \\cos b}")));
    if (used->falloffs[LX_LINEAR])
        lx_document_item(document,
                         LX_N("the cone of a spotlight, linear between the inner angle a and the outer angle b: {0}"),
                         LX_SPANS(LX_MATH("f = \\frac{b - \\theta}{b - a}")));
    if (used->falloffs[LX_HARD])
        lx_document_item(document, LX_N("the hard cone of a spotlight: {0} up to its outer angle, 0 beyond"),
                         LX_SPANS(LX_MATH("f = 1")));
}

static void explain_lights(struct luxel_document *document, const struct used *used, bool photometric)
{
    if (used->point) {
        lx_document_paragraph(document,
                              photometric
                                  ? LX_N("A source at {0} with the intensity {1} lies in the direction {2} at the "
                                         "distance {3} and gives a surface that faces it the illuminance {4}:")
                                  : LX_N("A source at {0} with the intensity {1} lies in the direction {2} at the "
                                         "distance {3} and gives a surface that faces it the irradiance {4}:"),
                              LX_SPANS(LX_MATH("\\mathbf{S}"), LX_MATH("I"), LX_MATH("\\mathbf{L}"), LX_MATH("r"),
                                       LX_MATH("E_{\\perp}")));
        lx_document_formula(
            document, used->spot ? "\\mathbf{L} = \\frac{\\mathbf{S} - \\mathbf{P}}{r}, \\qquad r = |\\mathbf{S} - "
                                   "\\mathbf{P}|, \\qquad E_{\\perp} = I\\, f\\, g\\, a(r)"
                                 : "\\mathbf{L} = \\frac{\\mathbf{S} - \\mathbf{P}}{r}, \\qquad r = |\\mathbf{S} - "
                                   "\\mathbf{P}|, \\qquad E_{\\perp} = I\\, g\\, a(r)");
    }
    if (used->point || used->extended || used->opening || used->parts)
        explain_laws(document, used);
    if (used->point && used->isotropic)
        lx_document_item(document, LX_N("the same in all directions: {0}"), LX_SPANS(LX_MATH("g = 1")));
    if (used->distant)
        lx_document_paragraph(document,
                              photometric
                                  ? LX_N("A distant source has the same direction {0} and illuminance {1} everywhere.")
                                  : LX_N("A distant source has the same direction {0} and irradiance {1} everywhere."),
                              LX_SPANS(LX_MATH("\\mathbf{L}"), LX_MATH("E_{\\perp}")));
    if (used->extended) {
        lx_document_paragraph(document,
                              photometric
                                  ? LX_N("An extended source with the luminance {0} is the integral over what of it "
                                         "faces the point, each part of it with its own direction and distance:")
                                  : LX_N("An extended source with the radiance {0} is the integral over what of it "
                                         "faces the point, each part of it with its own direction and distance:"),
                              LX_SPANS(LX_MATH("L_e")));
        lx_document_formula(document, "dE_{\\perp} = L_e\\, \\max(0, \\cos \\theta')\\, a(r)\\, dA'");
    }
    if (used->dome) {
        lx_document_paragraph(document,
                              photometric ? LX_N("The sky and the sun have a luminance {0} by the direction {1}; they "
                                                 "are so far away that it is the same everywhere:")
                                          : LX_N("The sky and the sun have a radiance {0} by the direction {1}; they "
                                                 "are so far away that it is the same everywhere:"),
                              LX_SPANS(LX_MATH("L_s"), LX_MATH("\\mathbf{L}")));
        lx_document_formula(document, "dE_{\\perp} = L_s(\\mathbf{L})\\, d\\omega");
    }
    if (used->opening) {
        lx_document_paragraph(document,
                              LX_N("A luminaire with a luminous opening of the area {0} is the integral over it: each "
                                   "part of it is a point with all of the intensities and its share of the area, "
                                   "whatever the angle under which it is seen:"),
                              LX_SPANS(LX_MATH("A")));
        lx_document_formula(document, "dE_{\\perp} = I(C, \\gamma)\\, a(r)\\, \\frac{dA}{A}");
    }
    if (used->parts)
        lx_document_paragraph(document,
                              LX_N("A source in parts is as many points, each at the centre of its part with its share "
                                   "{0} of the intensity along the normal: {1}."),
                              LX_SPANS(LX_MATH("I_i"), LX_MATH("E_{\\perp} = I_i \\max(0, \\cos \\theta')\\, a(r)")));
}

/* The highlight's factor beside ks S^n. */
static void explain_weight(struct luxel_document *document, const struct lx_material *material)
{
    const enum lx_highlight highlight = (enum lx_highlight)material->highlight;
    if (!LX_ENDS_AT_HORIZON(highlight))
        lx_document_paragraph(document,
                              LX_N("The weight {0} says that the highlight counts everywhere, even where the surface "
                                   "is turned away from the source, {1}."),
                              LX_SPANS(LX_MATH("w = 1"), LX_MATH("\\mathbf{N} \\cdot \\mathbf{L} \\le 0")));
    else if (LX_JUMPS_AT_HORIZON(highlight))
        lx_document_paragraph(
            document,
            LX_N("The highlight counts only where the surface is turned to the source: {0} where "
                 "{1}, else {2}."),
            LX_SPANS(LX_MATH("w = 1"), LX_MATH("\\mathbf{N} \\cdot \\mathbf{L} > 0"), LX_MATH("w = 0")));
    else
        lx_document_paragraph(document, LX_N("The highlight is weighted by the cosine of the light's angle: {0}."),
                              LX_SPANS(LX_MATH("w = \\max(0, \\mathbf{N} \\cdot \\mathbf{L})")));
}

/* How ambient light adds to the brightness, which materials divide by pi or not. */
static void explain_ambient(struct luxel_document *document, const struct lx_prepared *prepared)
{
    const bool photometric = prepared->scene->units == LX_PHOTOMETRIC;
    size_t divided = 0;
    for (size_t i = 0; i < prepared->surface_count; i++)
        divided += prepared->surfaces[i].material->over_pi;
    if (divided > 0 && divided < prepared->surface_count)
        lx_document_paragraph(
            document,
            photometric ? LX_N("Ambient light of the illuminance {0} adds {1}, whatever the normal, or {2} where the "
                               "material divides by π.")
                        : LX_N("Ambient light of the irradiance {0} adds {1}, whatever the normal, or {2} where the "
                               "material divides by π."),
            LX_SPANS(LX_MATH("E_a"), LX_MATH("k_a E_a"), LX_MATH("\\frac{1}{\\pi} k_a E_a")));
    else
        lx_document_paragraph(document,
                              photometric ? LX_N("Ambient light of the illuminance {0} adds {1}, whatever the normal.")
                                          : LX_N("Ambient light of the irradiance {0} adds {1}, whatever the normal."),
                              LX_SPANS(LX_MATH("E_a"), LX_MATH(divided > 0 ? "\\frac{1}{\\pi} k_a E_a" : "k_a E_a")));
}

/* Whether two materials reflect by one formula, whatever numbers stand in it. */
static bool is_alike(const struct lx_material *one, const struct lx_material *other)
{
    return one->model == other->model && one->diffuse_model == other->diffuse_model && one->over_pi == other->over_pi &&
           (!lx_power_lobe_of((enum lx_model)one->model) ||
            (one->highlight == other->highlight && one->normalized == other->normalized));
}

/* "surfaces[0], surfaces[0].materials.floor": what has a material like this one. */
static void name_alike(struct luxel_document *document, const struct lx_scene_parameters *scene,
                       const struct lx_material *material)
{
    enum { MOST_NAMES = 12 };
    struct lx_text names = {0};
    char left[LX_NUMBER_SIZE];
    size_t count = 0;
    for (struct lx_scene_material at = {0}; lx_next_material(scene, &at);)
        if (is_alike(at.material, material) && count++ < MOST_NAMES)
            lx_text_printf(&names, "%ssurfaces[%zu]%s%s", names.length > 0 ? ", " : "", at.surface,
                           at.part ? ".materials." : "", at.part ? at.part : "");
    const struct lx_span listed = LX_PLAIN(names.bytes ? names.bytes : "");
    if (count > MOST_NAMES)
        lx_document_paragraph(document, LX_N("Of {0} and {1} more:"),
                              LX_SPANS(listed, LX_PLAIN(lx_write_number((double)(count - MOST_NAMES), left))));
    else
        lx_document_paragraph(document, LX_N("Of {0}:"), LX_SPANS(listed));
    lx_text_clear(&names);
}

/* The weight of the diffuse part in formulas. */
#define KD "k_d"

static void explain_material(struct luxel_document *document, const struct lx_material *material)
{
    const struct lx_lobe_kind *kind = lx_lobe_kinds[material->model];
    const struct lx_lobe_kind *diffuse = lx_diffuse_kind_of(material);
    const bool is_normalized = material->normalized && kind->words.normalized;
    const char *words = is_normalized ? kind->words.normalized : kind->words.brightness;
    const char *lambertian = material->diffuse_model != 0 ? strstr(words, KD) : NULL;
    struct lx_text formula = {0};
    if (kind->words.definition)
        lx_document_formula(document, kind->words.definition);
    lx_add_notation(&formula, "B = $E_{\\perp} ", material->over_pi ? "\\frac{1}{\\pi}\\, " : "");
    if (lambertian) /* D stands behind its weight */
        lx_text_printf(&formula, "%.*s" KD "\\, D %s", (int)(lambertian - words), words, lambertian + strlen(KD));
    else
        lx_add_notation(&formula, "$", words);
    lx_end_formula(document, &formula);
    if (lambertian) {
        lx_document_paragraph(document, LX_N("Its diffuse part is that of a rough surface:"), NULL);
        lx_document_formula(document, diffuse->words.definition);
        lx_document_formula(document, diffuse->words.constant);
    }
    if (kind->power)
        explain_weight(document, material);
    if (kind->words.constant && (is_normalized || !kind->words.normalized))
        lx_document_formula(document, kind->words.constant);
}

/* Each formula once, with the names of what it holds for where there are several. */
static void explain_materials(struct luxel_document *document, const struct lx_scene_parameters *scene)
{
    enum { MOST_FORMULAS = 32 }; /* there are fewer */
    const struct lx_material *told[MOST_FORMULAS];
    size_t count = 0;
    for (struct lx_scene_material at = {0}; lx_next_material(scene, &at);) {
        size_t i = 0;
        while (i < count && !is_alike(told[i], at.material))
            i++;
        if (i == count && count < MOST_FORMULAS)
            told[count++] = at.material;
    }
    for (size_t i = 0; i < count; i++) {
        if (count > 1)
            name_alike(document, scene, told[i]);
        explain_material(document, told[i]);
    }
}

/* What surfaces reflect to each other, bounce by bounce. */
static void explain_reflections(struct luxel_document *document, const struct lx_scene_parameters *scene,
                                luxel_quantity quantity)
{
    const struct lx_choice_or_whole *bounces = &scene->reflections;
    char last[LX_NUMBER_SIZE] = "\\infty";
    if (bounces->choice == LX_REFLECTIONS_NONE)
        return;
    if (bounces->choice < 0)
        lx_write_number(bounces->whole, last);
    lx_document_paragraph(
        document,
        scene->units == LX_PHOTOMETRIC
            ? LX_N("Surfaces reflect light to each other, too, as Lambert's law says. Where the sources alone give the "
                   "illuminance {0} and light that was reflected {1} times gives {2}, a part {3} of a surface that is "
                   "seen from a point gives it, reflected once more,")
            : LX_N("Surfaces reflect light to each other, too, as Lambert's law says. Where the sources alone give the "
                   "irradiance {0} and light that was reflected {1} times gives {2}, a part {3} of a surface that is "
                   "seen from a point gives it, reflected once more,"),
        LX_SPANS(LX_MATH("E_0"), LX_MATH("n"), LX_MATH("E_n"), LX_MATH("dA'")));
    lx_document_formula(document, "dE_{n+1} = \\frac{1}{\\pi}\\, k_d' E_n'\\, \\frac{\\max(0, \\cos \\theta) "
                                  "\\max(0, \\cos \\theta')}{r^2}\\, dA',");
    lx_document_paragraph(document, LX_N("and all of that together adds to the value:"), NULL);
    lx_show_formula(document, "E_r = \\sum_{n=1}^{$} E_n$", last,
                    quantity == LUXEL_BRIGHTNESS ? ", \\qquad B_r = \\frac{1}{\\pi}\\, k_d E_r" : "");
}

void lx_explain_model(struct luxel_document *document, const struct lx_prepared *prepared, luxel_quantity quantity)
{
    const struct lx_scene_parameters *scene = prepared->scene;
    static const char *const sums[] = {LX_N("The brightness is the sum over the sources of what the surface reflects:"),
                                       LX_N("The luminance is the sum over the sources of what the surface reflects:"),
                                       LX_N("The irradiance is the sum over the sources:"),
                                       LX_N("The illuminance is the sum over the sources:")};
    const bool photometric = scene->units == LX_PHOTOMETRIC;
    const char *sum = lx_by_quantity(quantity, photometric, sums);
    struct used used = find_used(prepared);
    explain_places(document, prepared);
    explain_lights(document, &used, photometric);
    if (prepared->shadows && prepared->shadows_extended && prepared->emitters.extended > 0)
        lx_document_paragraph(
            document, LX_N("What another surface hides of a source gives no light, be it all of it or a part."), NULL);
    else if (prepared->shadows && (used.point || used.distant))
        lx_document_paragraph(
            document,
            LX_N("Where another surface stands in the way of a source that is a point or distant, it gives no light."),
            NULL);
    if (quantity == LUXEL_IRRADIANCE) {
        lx_document_paragraph(document, sum, NULL);
        lx_document_formula(document, used.ambient
                                          ? "E = E_a + \\sum E_{\\perp} \\max(0, \\mathbf{N} \\cdot \\mathbf{L})"
                                          : "E = \\sum E_{\\perp} \\max(0, \\mathbf{N} \\cdot \\mathbf{L})");
        explain_reflections(document, scene, quantity);
        return;
    }
    lx_document_paragraph(document, sum, NULL);
    explain_materials(document, scene);
    if (used.ambient)
        explain_ambient(document, prepared);
    explain_reflections(document, scene, quantity);
}
