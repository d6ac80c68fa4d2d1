/* SPDX-License-Identifier: MIT */
/* Attenuation laws from the parameters to the emitters. */
#include "law.h"

#include <string.h>

const char *const lx_attenuation_names[] = {"inverse-square", "practical", "none", "polynomial", NULL};

void lx_law_set(const struct lx_law *law, struct lx_emitter *emitter)
{
    const double *coefficients = law->coefficients, k_mm = coefficients[0] * 1000;
    emitter->attenuation = (enum lx_attenuation)law->attenuation;
    emitter->k_mm = law->k_mm;
    memcpy(emitter->coefficients, coefficients, sizeof emitter->coefficients);
    if (emitter->attenuation != LX_POLYNOMIAL || coefficients[1] != 1 || coefficients[2] != 0)
        return;
    if (k_mm > 0 && k_mm / 1000 == coefficients[0]) {
        emitter->attenuation = LX_PRACTICAL;
        emitter->k_mm = k_mm;
    }
}

void lx_law_copy(const struct lx_emitter *from, struct lx_emitter *emitter)
{
    emitter->attenuation = from->attenuation;
    emitter->k_mm = from->k_mm;
    memcpy(emitter->coefficients, from->coefficients, sizeof emitter->coefficients);
}
