/* SPDX-License-Identifier: MIT */
/*
 * Bounds of lights as analytic functions of the place on the screen, in a region of complex numbers around a square of
 * a picture (docs/MATHS.md, "Squares of a picture"), for vectors of lights.  kernel.c includes it once, for float64.
 *
 * A vector w is w' + e + i f: w' is real and what w could be with real x and y, e real as well and of second order, f
 * real.  How far they reach is a struct deviation, as in struct lx_deviation.  Scalars are bounded by parts likewise.
 * Each step errs on the safe side by more than roundings; there is no need to be exact.
 */

struct deviation {
    lanes_double first, second, imaginary, tile;
};

LX_LANE struct deviation deviation_of(const struct lx_deviation *deviation, lanes_double share)
{
    return (struct deviation){deviation->first * share, deviation->second * share, deviation->imaginary * share,
                              deviation->tile * share};
}

LX_LANE lanes_double positive(lanes_double a)
{
    return greater_double(a, all_double(0));
}

/* How far two unit vectors are apart the sine of whose angle, below 90 degrees, is no more than that. */
LX_LANE lanes_double chord(lanes_double sine)
{
    return sine * root_double(2 * inverse_double(1 + root_double(positive(1 - sine * sine))));
}

/*
 * The range of the unit vector of a way of the length d, which moves by `moves`.  Its part f across it, over the length
 * of the real one, is at most k; what makes it unit again is 1/sqrt(1 - z) with |z| <= k^2.
 */
LX_LANE struct deviation deviation_of_unit(lanes_double d, struct deviation moves)
{
    const lanes_double nearest = d - moves.first - moves.second, inverse = inverse_double(d);
    const lanes_double k = moves.imaginary * inverse_double(nearest);
    const lanes_double more = inverse_root_double(1 - k * k) - 1;
    return (struct deviation){
        .first = chord(moves.first * inverse),
        .second = more * (1 + k) + k * k * (1 + more) + moves.second * inverse_double(nearest),
        .imaginary = k * (1 + more) + more,
        .tile = chord(moves.tile * inverse),
    };
}

/* The largest cosine of an angle of the given cosine and sine, from which it differs by one whose sine is no more than
 * `off`. */
LX_LANE lanes_double largest_cosine(lanes_double cosine, lanes_double sine, lanes_double off)
{
    const lanes_double one = all_double(1), zero = all_double(0);
    off = lesser_double(off, one);
    const lanes_double turned = cosine * root_double(positive(1 - off * off)) + sine * off;
    return where_above_double(cosine, zero, where_above_double(off, sine, one, turned), turned);
}

/* No less than a^(exponent/2) for a >= 0. */
LX_LANE lanes_double most_of_power(lanes_double a, lanes_double exponent)
{
    const lanes_double one = all_double(1), base = lesser_double(a, 1 / greater_double(a, one));
    const lanes_double power = exp2_of_double(0.5 * exponent * log2_of_double(base, all_double(0)));
    return where_above_double(a, one, 1 / power, power) * (1 + 1e-9);
}

/* What is known of a light: E_perp and the cosine at most, and on which side of the horizon the square is. */
struct bounded_light {
    lanes_double e, cosine;
    lanes_double is_up, is_down; /* above 0 where it is so throughout */
    lanes_double is_lit;         /* 0 where it is not, for certain */
    lanes_double doubt;          /* above 0 where there may be no such function */
    lanes_double x, y, z;        /* L in the middle */
    struct deviation deviation;  /* of L */
};

/* 1 where a > b, else 0. */
LX_LANE lanes_double is_above_lane(lanes_double a, lanes_double b)
{
    return where_above_double(a, b, all_double(1), all_double(0));
}

/* The largest share of a profile, 0 for certain in `*is_dark`. */
LX_LANE lanes_double bound_profile(const struct lx_smooth_lights *lights, size_t i, const struct bounded_light *light,
                                   lanes_double *doubt, lanes_double *is_dark)
{
    const lanes_double margin = all_double(1e-9), zero = all_double(0), one = all_double(1);
    const lanes_double inner = load_double(lights->inner + i), outer = load_double(lights->outer + i);
    const lanes_double exponent = load_double(lights->exponent + i), is_broken = load_double(lights->is_broken + i);
    const lanes_double cosine =
        -(light->x * load_double(lights->axis_x + i) + light->y * load_double(lights->axis_y + i) +
          light->z * load_double(lights->axis_z + i));
    const lanes_double sine = root_double(positive(1 - cosine * cosine)), tile = light->deviation.tile;
    const lanes_double least = cosine * root_double(positive(1 - tile * tile)) - sine * tile - margin;
    const lanes_double most = largest_cosine(cosine, sine, tile) + margin;
    *is_dark = is_above_lane(outer, most);
    *doubt = where_above_double(least, inner, zero, one - *is_dark);
    const lanes_double lowest = cosine - light->deviation.first - light->deviation.second;
    *doubt = greater_double(*doubt, where_above_double(lowest, zero, zero, is_broken));
    const lanes_double real = largest_cosine(cosine, sine, light->deviation.first) + light->deviation.second;
    const lanes_double imaginary = light->deviation.imaginary;
    return most_of_power(real * real + imaginary * imaginary, exponent);
}

LX_LANE struct bounded_light bound_one(const struct lx_vicinity *at, const struct lx_smooth_lights *lights, size_t i)
{
    const lanes_double one = all_double(1), tiny = all_double(1e-200);
    const lanes_double moves = load_double(lights->moves + i);
    const lanes_double sx = load_double(lights->x + i), sy = load_double(lights->y + i),
                       sz = load_double(lights->z + i);
    const lanes_double x = sx - moves * at->place[0], y = sy - moves * at->place[1], z = sz - moves * at->place[2];
    const lanes_double square = greater_double(x * x + y * y + z * z, tiny), inverse = inverse_root_double(square);
    const lanes_double d = square * inverse;
    const lanes_double radius = load_double(lights->radius + i);
    const lanes_double strays = load_double(lights->strays + i), sways = load_double(lights->sways + i);
    struct deviation way = deviation_of(&at->place_deviation, moves);
    way.first += strays, way.imaginary += sways, way.tile += radius;
    struct bounded_light light = {.x = x * inverse, .y = y * inverse, .z = z * inverse};

    /* so far off that what follows means something */
    const lanes_double nearest = d - way.first - way.second, too_near = all_double(1e-3); /* mm */
    lanes_double is_good = is_above_lane(0.9 * nearest, greater_double(way.imaginary, 0.05 * d));
    is_good *= is_above_lane(nearest - way.imaginary, moves * too_near);
    light.doubt = one - is_good;
    way = (struct deviation){way.first * is_good, way.second * is_good, way.imaginary * is_good, way.tile * is_good};
    light.deviation = deviation_of_unit(d, way);

    /* r^2 has no less a real part than this, and r than its root */
    const lanes_double length = d - way.first - way.second, w = length * length - way.imaginary * way.imaginary;
    const lanes_double root = root_double(w);
    light.e = load_double(lights->gain + i) *
              inverse_double(load_double(lights->by_square + i) * w + load_double(lights->by_root + i) * root +
                             load_double(lights->by_none + i));

    /* N.D = N.S - level; N is n' + e + i f, f across it, and what it changes by along itself is of second order */
    const struct lx_deviation *n = &at->normal_deviation;
    const lanes_double s_square = sx * sx + sy * sy + sz * sz;
    const lanes_double along = at->normal[0] * sx + at->normal[1] * sy + at->normal[2] * sz;
    const lanes_double across = root_double(positive(s_square - along * along)) + 1e-7 * root_double(s_square);
    const lanes_double size = magnitude_double(along), height = along - moves * at->level;
    const lanes_double tile = n->tile * across + 0.5 * n->tile * n->tile * size + radius;
    const lanes_double real = n->first * across + 0.5 * n->first * n->first * size + n->second * (across + size) +
                              (1 + n->second) * strays + n->imaginary * sways;
    const lanes_double imaginary =
        n->imaginary * (across + (n->first + n->second) * size + strays) + (1 + n->second) * sways;
    const lanes_double margin = 1e-9 * d, most = magnitude_double(height) + real + margin;
    light.is_up = is_above_lane(height, tile + margin);
    light.is_down = is_above_lane(-height, tile + margin);
    light.cosine = root_double(most * most + imaginary * imaginary + tiny) * inverse_double(root);

    lanes_double doubt, is_dark;
    light.e *= bound_profile(lights, i, &light, &doubt, &is_dark);
    light.is_lit = 1 - is_dark * is_good;
    light.doubt = greater_double(light.doubt, doubt);
    return light;
}

/* Bounds of a highlight: as an analytic function, if it is one, and of its root S; in the square; and whether it is 0
 * there throughout, or may not be analytic. */
struct bounded_shine {
    lanes_double most, root, seen, is_dark, doubt;
};

/*
 * A bound of S^n, where S = a.b of two vectors with the given cosine of their angle in the middle: S is at most
 * sqrt(real^2 + imaginary^2), and differs by at most `tile` within the square and by `all` in the region.
 */
LX_LANE struct bounded_shine bound_power(const struct lx_lobe_double *lobe, lanes_double cosine, lanes_double square,
                                         lanes_double tile, lanes_double all)
{
    const lanes_double margin = all_double(1e-9), zero = all_double(0), one = all_double(1);
    const double exponent = lobe->exponent.value;
    const lanes_double top = lesser_double(positive(cosine + tile + margin), one);
    struct bounded_shine shine = {
        .most = most_of_power(square, all_double(exponent)),
        .root = root_double(square),
        .seen = power_of_double(top, 1 - top, lobe->exponent) * (1 + margin) + (lobe->exponent.whole > 0 ? 0 : 1e-15),
    };
    shine.is_dark = is_above_lane(-cosine, tile + margin);
    shine.doubt = where_above_double(cosine, tile + margin, zero, one - shine.is_dark);
    if (exponent != floor(exponent)) /* there is none around S = 0 */
        shine.doubt = greater_double(shine.doubt, where_above_double(cosine, all + margin, zero, one - shine.is_dark));
    return shine;
}

/* S = N.W/sqrt(W.W) with W = L + V. */
LX_LANE struct bounded_shine bound_blinn_phong(const struct lx_vicinity *at, const struct lx_lobe_double *lobe,
                                               const struct bounded_light *light)
{
    const struct lx_deviation *n = &at->normal_deviation, *v = &at->view_deviation;
    const lanes_double one = all_double(1), zero = all_double(0), tiny = all_double(1e-200);
    const lanes_double x = light->x + at->view[0], y = light->y + at->view[1], z = light->z + at->view[2];
    const lanes_double inverse = inverse_root_double(x * x + y * y + z * z + tiny);
    const lanes_double m = (x * x + y * y + z * z) * inverse;
    const struct deviation w = {light->deviation.first + v->first, light->deviation.second + v->second,
                                light->deviation.imaginary + v->imaginary, light->deviation.tile + v->tile};
    const lanes_double is_good = is_above_lane(m - w.first - w.second - w.imaginary, 0.05 * m + 1e-3);
    const lanes_double cosine = (at->normal[0] * x + at->normal[1] * y + at->normal[2] * z) * inverse;
    const lanes_double sine = root_double(positive(1 - cosine * cosine));
    const lanes_double off = n->first + w.first * inverse,
                       q = inverse_double(where_above_double(is_good, zero, m - w.first, one));
    const lanes_double wi = w.imaginary * q, we = w.second * q;
    const lanes_double real = largest_cosine(cosine, sine, off) + n->second + (1 + n->second) * we + n->imaginary * wi;
    const lanes_double turned = lesser_double(sine + off + n->second, one);
    const lanes_double imaginary = n->imaginary * (turned + we) + (1 + n->second) * wi;
    const lanes_double least = (1 - we) * (1 - we) - wi * wi; /* of |W.W|, over that of W' */
    const lanes_double square =
        (real * real + imaginary * imaginary) * inverse_double(where_above_double(is_good, zero, least, one));
    const lanes_double tile = n->tile + w.tile * inverse * (1 + n->tile);
    const lanes_double all = n->first + n->second + (w.first + w.second) * inverse * (1 + n->first + n->second) +
                             n->imaginary * w.imaginary * inverse;
    struct bounded_shine shine = bound_power(lobe, cosine, square, tile, all);
    shine.doubt = greater_double(shine.doubt, 1 - is_good);
    shine.is_dark *= is_good;
    return shine;
}

/* S = M.V with M = 2 (N.L) N - L, the mirrored L; the two parts of N are across each other. */
LX_LANE struct bounded_shine bound_phong(const struct lx_vicinity *at, const struct lx_lobe_double *lobe,
                                         const struct bounded_light *light)
{
    const struct lx_deviation *n = &at->normal_deviation, *v = &at->view_deviation;
    const struct deviation l = light->deviation;
    const double *normal = at->normal;
    const lanes_double twice = 2 * (normal[0] * light->x + normal[1] * light->y + normal[2] * light->z);
    const lanes_double x = twice * normal[0] - light->x, y = twice * normal[1] - light->y,
                       z = twice * normal[2] - light->z;
    /* the mirror: its real part is off by `second` besides, the imaginary one is no larger than that */
    const double second = 4 * n->second + 2 * n->second * n->second + 2 * n->imaginary * n->imaginary;
    const double mirrored = 2 * (1 + n->second) * n->imaginary;
    const struct deviation m = {
        .first = 2 * n->first + l.first,
        .second = second * (1 + l.second) + l.second + mirrored * l.imaginary,
        .imaginary = mirrored * (1 + l.second) + (1 + second) * l.imaginary,
        .tile = 2 * n->tile + l.tile,
    };
    const lanes_double cosine = x * at->view[0] + y * at->view[1] + z * at->view[2];
    const lanes_double sine = root_double(positive(1 - cosine * cosine));
    const lanes_double real = largest_cosine(cosine, sine, m.first + v->first) + m.second + v->second * (1 + m.second) +
                              m.imaginary * v->imaginary;
    const lanes_double imaginary = m.imaginary * (1 + v->second) + (1 + m.second) * v->imaginary;
    const lanes_double tile = m.tile + v->tile * (1 + m.tile), moved = m.first + m.second;
    const lanes_double all = moved + (v->first + v->second) * (1 + moved) + m.imaginary * v->imaginary;
    return bound_power(lobe, cosine, real * real + imaginary * imaginary, tile, all);
}

LX_LANE struct bounded_shine bound_shine(const struct lx_vicinity *vicinity, const struct lx_lobe_double *lobe,
                                         const struct bounded_light *light)
{
    return LX_IS_BY_MIRROR(lobe->model) ? bound_phong(vicinity, lobe, light) : bound_blinn_phong(vicinity, lobe, light);
}

static void bound_smooth(const struct lx_vicinity *vicinity, const struct lx_smooth_lights *lights, size_t first,
                         size_t end, const struct lx_lobe_double *lobe, double *sizes)
{
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL);
    for (size_t i = first; i < end; i += LX_WIDTH_double) {
        const struct bounded_light light = bound_one(vicinity, lights, i);
        const lanes_double unsure = 1 - light.is_up - light.is_down;
        lanes_double most = lobe->diffuse * light.cosine * (1 - light.is_down);
        if (LX_HAS_HIGHLIGHT(lobe->model)) {
            const struct bounded_shine shine = bound_shine(vicinity, lobe, &light);
            lanes_double is_there = 1 - shine.is_dark, doubt = shine.doubt;
            if (LX_ENDS_AT_HORIZON(lobe->highlight)) {
                is_there *= 1 - light.is_down;
                doubt = greater_double(doubt, unsure);
            }
            /* what may not be analytic is as well if it is small: nodes see none of it, or all */
            const lanes_double share = where_above_double(doubt, zero, shine.seen * vicinity->slip, shine.most);
            const lanes_double cosine = LX_FALLS_TO_HORIZON(lobe->highlight) ? light.cosine : all_double(1);
            most += where_above_double(is_there, zero, lobe->specular * share * cosine, zero);
        }
        const lanes_double bound = light.e * most;
        const lanes_double folded = where_above_double(unsure, zero, -bound, bound);
        const lanes_double size = where_above_double(light.doubt, zero, infinite, folded);
        store_double(sizes + i, where_above_double(light.is_lit, zero, size, zero));
    }
}

/* The root of E_perp is bounded as that of its bound: its real part is above 0, but for what has a pattern. */
static struct lx_foot bound_foot(const struct lx_vicinity *vicinity, const struct lx_smooth_lights *lights, size_t i,
                                 const struct lx_lobe_double *lobe)
{
    const size_t lane = i % LX_WIDTH_double;
    const struct bounded_light light = bound_one(vicinity, lights, i - lane);
    const struct bounded_shine shine = bound_shine(vicinity, lobe, &light);
    const lanes_double zero = all_double(0), infinite = all_double(HUGE_VAL), gain = light.e * lobe->specular;
    lanes_double doubt = light.doubt + shine.doubt + shine.is_dark + load_double(lights->exponent + i - lane);
    if (lobe->diffuse > 0)
        doubt += light.is_up;
    const lanes_double root = shine.root * most_of_power(gain, all_double(2 / lobe->exponent.value));
    const lanes_double bound = where_above_double(doubt, zero, infinite, root), most = gain * shine.seen;
    return (struct lx_foot){.root = bound[lane], .most = most[lane]};
}
