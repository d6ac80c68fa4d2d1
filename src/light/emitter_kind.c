/* SPDX-License-Identifier: MIT */
/* The kinds of emitters by type, and those without size. */
#include "emitter_kind.h"

#define DECLARE(type, kind) extern const struct lx_emitter_kind kind;
LX_EMITTER_KINDS(DECLARE)
#undef DECLARE

#define ENTER(type, kind) [type] = &(kind),
const struct lx_emitter_kind *const lx_emitter_kinds[LX_EMITTER_TYPES] = {LX_EMITTER_KINDS(ENTER)};
#undef ENTER

static lx_bounded metres(lx_bounded length_mm)
{
    return lx_div(length_mm, lx_exact(1000));
}

/* kc + kl r + kq r^2 */
static lx_bounded polynomial(const double coefficients[3], lx_bounded r)
{
    const lx_bounded above = lx_add(lx_exact(coefficients[1]), lx_mul(r, lx_exact(coefficients[2])));
    return lx_add(lx_exact(coefficients[0]), lx_mul(r, above));
}

static lx_bounded attenuation(const struct lx_emitter *emitter, lx_bounded distance_m)
{
    lx_bounded one = lx_exact(1);
    switch (emitter->attenuation) {
    case LX_INVERSE_SQUARE: return lx_div(one, lx_mul(distance_m, distance_m));
    case LX_PRACTICAL: return lx_div(one, lx_add(metres(lx_exact(emitter->k_mm)), distance_m));
    case LX_POLYNOMIAL: return lx_div(one, polynomial(emitter->coefficients, distance_m));
    case LX_NO_ATTENUATION: break;
    }
    return one;
}

static struct lx_sample sample_point(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    lx_bounded3 offset = lx_sub3(lx_exact3(emitter->position_mm), place_mm);
    lx_bounded distance = lx_length3(offset);
    if (distance.value <= distance.error)
        return (struct lx_sample){.on_element = true};
    lx_bounded3 towards = lx_unit3(offset);
    lx_bounded e_perp = lx_mul(lx_strength(emitter), attenuation(emitter, metres(distance)));
    return (struct lx_sample){
        .towards = towards,
        .e_perp = lx_mul(e_perp, lx_profile_value(&emitter->profile, towards)),
    };
}

static struct lx_sample sample_direction(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    (void)place_mm;
    return (struct lx_sample){.towards = emitter->towards, .e_perp = lx_strength(emitter)};
}

static struct lx_sample sample_uniform(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    (void)place_mm;
    return (struct lx_sample){.e_perp = lx_strength(emitter)};
}

const struct lx_emitter_kind lx_uniform_emitter = {.name = "uniform", .sample = sample_uniform};
const struct lx_emitter_kind lx_direction_emitter = {.name = "direction", .sample = sample_direction};
const struct lx_emitter_kind lx_point_emitter = {.name = "point", .sample = sample_point};

struct lx_sample lx_emitter_sample(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    return lx_emitter_kind(emitter)->sample(emitter, place_mm);
}
