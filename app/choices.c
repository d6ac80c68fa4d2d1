/* SPDX-License-Identifier: MIT */
/* The labels of choices. */
#include "choices.h"

#include <glib.h>
#include <string.h>

#include "../front/words.h"

static const struct {
    const char *choice, *label;
} labels[] = {
    {"point", N_("point")},
    {"points", N_("points of a file")},
    {"spot", N_("spot")},
    {"luminaire", N_("luminaire of a file")},
    {"angle", N_("linear in the angle")},
    {"planar", N_("planar")},
    {"volume", N_("volume")},
    {"distant", N_("distant")},
    {"ambient", N_("ambient")},
    {"sphere", N_("sphere")},
    {"rectangle", N_("rectangle")},
    {"disk", N_("disk")},
    {"cylinder", N_("cylinder")},
    {"room", N_("room")},
    {"en12464", N_("as EN 12464-1 says")},
    {"mesh", N_("mesh of a file")},
    {"auto", N_("automatic")},
    {"file", N_("of the file")},
    {"smooth", N_("smooth")},
    {"flat", N_("of the triangles")},
    {"inverse-square", N_("inverse square")},
    {"practical", N_("practical, 1/(k + r)")},
    {"polynomial", N_("polynomial")},
    {"none", N_("none")},
    {"all", N_("all")},
    {"isotropic", N_("isotropic")},
    {"lambertian", N_("lambertian")},
    {"cosine", N_("cosine")},
    {"smoothstep", N_("smoothstep")},
    {"squared", N_("squared")},
    {"linear", N_("linear")},
    {"hard", N_("hard")},
    {"blinn-phong", N_("Blinn–Phong")},
    {"phong", N_("Phong")},
    {"lambert", N_("Lambert")},
    {"plain", N_("plain")},
    {"gated", N_("gated")},
    {"radiometric", N_("radiometric")},
    {"photometric", N_("photometric")},
    {"centers", N_("pixel centres")},
    {"nodes", N_("grid nodes")},
    {"orthographic", N_("orthographic")},
    {"perspective", N_("perspective")},
    {"parallel", N_("parallel")},
    {"observer", N_("from the observer")},
    {"max", N_("0 to maximum")},
    {"minmax", N_("minimum to maximum")},
    {"log", N_("logarithmic")},
    {"truncate", N_("rounded down")},
    {"nearest", N_("rounded")},
    {"converged", N_("as many as needed")},
    {"front", N_("front")},
    {"back", N_("back")},
    {"both", N_("both sides")},
    {"grey", N_("grey")},
};

const char *app_choice_label(const char *choice)
{
    for (gsize i = 0; choice && i < G_N_ELEMENTS(labels); i++)
        if (strcmp(labels[i].choice, choice) == 0)
            return _(labels[i].label);
    return choice;
}
