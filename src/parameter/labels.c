/* SPDX-License-Identifier: MIT */
/* The labels of choices. */
#include <luxel/parameter.h>

#include <string.h>

#include "../base/phrase.h"

static const struct {
    const char *choice, *label;
} labels[] = {
    {"point", LX_N("point")},
    {"points", LX_N("points of a file")},
    {"spot", LX_N("spot")},
    {"luminaire", LX_N("luminaire of a file")},
    {"angle", LX_N("linear in the angle")},
    {"planar", LX_N("planar")},
    {"volume", LX_N("volume")},
    {"distant", LX_N("distant")},
    {"ambient", LX_N("ambient")},
    {"sphere", LX_N("sphere")},
    {"rectangle", LX_N("rectangle")},
    {"disk", LX_N("disk")},
    {"cylinder", LX_N("cylinder")},
    {"room", LX_N("room")},
    {"box", LX_N("box")},
    {"y", LX_N("y")},
    {"z", LX_N("z")},
    {"en12464", LX_N("as EN 12464-1 says")},
    {"plane", LX_N("on the plane")},
    {"cylindrical", LX_N("cylindrical")},
    {"semicylindrical", LX_N("semicylindrical")},
    {"spherical", LX_N("spherical")},
    {"hemispherical", LX_N("hemispherical")},
    {"mesh", LX_N("mesh of a file")},
    {"auto", LX_N("automatic")},
    {"file", LX_N("of the file")},
    {"smooth", LX_N("smooth")},
    {"flat", LX_N("of the triangles")},
    {"inverse-square", LX_N("inverse square")},
    {"practical", LX_N("practical, 1/(k + r)")},
    {"polynomial", LX_N("polynomial")},
    {"none", LX_N("none")},
    {"all", LX_N("all")},
    {"isotropic", LX_N("isotropic")},
    {"lambertian", LX_N("lambertian")},
    {"cosine", LX_N("cosine")},
    {"smoothstep", LX_N("smoothstep")},
    {"squared", LX_N("squared")},
    {"linear", LX_N("linear")},
    {"hard", LX_N("hard")},
    {"blinn-phong", LX_N("Blinn–Phong")},
    {"phong", LX_N("Phong")},
    {"ggx", LX_N("GGX")},
    {"lambert", LX_N("Lambert")},
    {"oren-nayar", LX_N("Oren–Nayar")},
    {"eon", LX_N("EON")},
    {"plain", LX_N("plain")},
    {"gated", LX_N("gated")},
    {"radiometric", LX_N("radiometric")},
    {"photometric", LX_N("photometric")},
    {"centers", LX_N("pixel centres")},
    {"nodes", LX_N("grid nodes")},
    {"orthographic", LX_N("orthographic")},
    {"perspective", LX_N("perspective")},
    {"parallel", LX_N("parallel")},
    {"observer", LX_N("from the observer")},
    {"max", LX_N("0 to maximum")},
    {"minmax", LX_N("minimum to maximum")},
    {"log", LX_N("logarithmic")},
    {"truncate", LX_N("rounded down")},
    {"nearest", LX_N("rounded")},
    {"converged", LX_N("as many as needed")},
    {"front", LX_N("front")},
    {"back", LX_N("back")},
    {"both", LX_N("both sides")},
    {"grey", LX_N("grey")},
    {"rgb", LX_N("red, green and blue")},
};

const char *luxel_parameter_choice_label(const char *choice)
{
    for (size_t i = 0; choice && i < sizeof labels / sizeof labels[0]; i++)
        if (strcmp(labels[i].choice, choice) == 0)
            return labels[i].label;
    return NULL;
}
