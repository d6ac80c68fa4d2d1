/* SPDX-License-Identifier: MIT */
/*
 * Facets: their irradiance against values computed with 80 digits in easy and in hard places (facets_cases.h), against
 * printed ones, and what must be so anyway: parts add up to the whole, the other side of a polygon shines when it is
 * turned round, sizes do not matter, the mean over a sphere is that of the flux, the far field is that of a point.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "facets_cases.h"
#include "light/solid/facets.h"

typedef const double (*places)[3];

enum { MOST_PIECES = 32 };

/* Facets of one light. */
struct shape {
    struct lx_facets *pieces[MOST_PIECES];
    size_t count;
};

static struct shape one_piece(struct lx_facets *facets)
{
    assert_non_null(facets);
    return (struct shape){.pieces = {facets}, .count = 1};
}

static struct shape outline(const double (*corners)[3], size_t count)
{
    struct shape shape = {.count = 0};
    struct lx_facets **pieces = NULL;
    struct lx_shape_report report = lx_facets_of_outline(corners, count, &pieces, &shape.count);
    assert_int_equal(report.fault, LX_SHAPE_GOOD);
    assert_in_range(shape.count, 1, MOST_PIECES);
    memcpy(shape.pieces, pieces, shape.count * sizeof *pieces);
    free(pieces);
    return shape;
}

static void clear(struct shape *shape)
{
    for (size_t i = 0; i < shape->count; i++)
        lx_facets_free(shape->pieces[i]);
}

/* The irradiance of an element with an exact place and normal. */
static lx_bounded light(const struct shape *shape, const double place[3], const double normal[3])
{
    lx_bounded sum = lx_exact(0);
    for (size_t i = 0; i < shape->count; i++) {
        assert_false(lx_facets_touch(shape->pieces[i], lx_exact3(place)));
        lx_bounded part = lx_facets_irradiance(shape->pieces[i], lx_exact3(place), lx_exact3(normal));
        assert_true(part.value >= 0 && part.error >= 0);
        sum = lx_add(sum, part);
    }
    return sum;
}

static lx_bounded bounded_and_clear(struct shape shape, const double place[3], const double normal[3])
{
    const lx_bounded found = light(&shape, place, normal);
    clear(&shape);
    return found;
}

static double light_and_clear(struct shape shape, const double place[3], const double normal[3])
{
    return bounded_and_clear(shape, place, normal).value;
}

static void assert_near(double value, double expected, double relative, const char *what)
{
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%s: %.17g, expected %.17g", what, value, expected);
}

/* Both within their bounds, which are small. */
static void assert_agree(lx_bounded found, lx_bounded expected, const char *what)
{
    const double most = found.error + expected.error;
    if (!(fabs(found.value - expected.value) <= most && most <= 1e-12 * expected.value))
        fail_msg("%s: %.17g, expected %.17g to %g", what, found.value, expected.value, most);
}

/* xorshift64*: the same places on every machine */
static double uniform(uint64_t *state, double low, double high)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return low + (high - low) * ((double)((*state * UINT64_C(0x2545F4914F6CDD1D)) >> 11) * 0x1p-53);
}

static void random_unit(uint64_t *state, double v[3])
{
    double z = uniform(state, -1, 1), phi = uniform(state, 0, 2 * M_PI), rho = sqrt(1 - z * z);
    v[0] = rho * cos(phi);
    v[1] = rho * sin(phi);
    v[2] = z;
}

/* ---- values ---- */

static struct shape shape_of(const struct facets_case *entry)
{
    const double *n = entry->numbers;
    switch (entry->kind) {
    case RECTANGLE: return one_piece(lx_facets_of_rectangle(n, n + 3, n + 5, n + 8));
    case OUTLINE: return outline((places)n, entry->count / 3);
    case BOX: return one_piece(lx_facets_of_box(n, n + 3));
    case SPHERE: return one_piece(lx_facets_of_sphere(n, n[3], (unsigned)n[4]));
    case CYLINDER: break;
    }
    return one_piece(lx_facets_of_cylinder(n, n[3], n[4], n + 5, (unsigned)n[8]));
}

static void truth(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof facets_cases / sizeof *facets_cases; i++) {
        const struct facets_case *entry = &facets_cases[i];
        struct shape shape = shape_of(entry);
        lx_bounded found = light(&shape, entry->place_mm, entry->normal);
        double off = fabs((found.value - entry->value) - entry->rest);
        if (!(off <= found.error))
            fail_msg("%s: %.17g is off by %g, more than %g", entry->what, found.value, off, found.error);
        double none = entry->value == 0 ? 1e-24 : 0; /* a slanted plane is known but for roundings */
        if (!(off <= 1e-13 * entry->value) || !(found.error <= 1e-12 * entry->value + none))
            fail_msg("%s: %.17g, expected %.17g to 1e-12; error %g", entry->what, found.value, entry->value,
                     found.error);
        clear(&shape);
    }
}

/* CIE 171:2006 5.3, a square metre in the ceiling, and 5.6, a floor; Howell's element under a corner; a cube. */
static void printed(void **unused)
{
    static const struct {
        double center[3], size[2], up_or_down, place[3], normal[3], expected;
    } cases[] = {
        {{2000, 2000, 3000}, {1000, 1000}, -1, {2000, 0, 2750}, {0, 1, 0}, 0.03267689801439185},
        {{2000, 2000, 3000}, {1000, 1000}, -1, {2000, 0, 250}, {0, 1, 0}, 0.04000185201985107},
        {{2000, 2000, 3000}, {1000, 1000}, -1, {2000, 1750, 0}, {0, 0, 1}, 0.10577824217629437},
        {{2000, 2000, 0}, {4000, 4000}, 1, {2000, 0, 250}, {0, 1, 0}, 0.4512260356378261 * M_PI},
        {{2000, 2000, 0}, {4000, 4000}, 1, {2000, 1750, 3000}, {0, 0, -1}, 0.3556659245454594 * M_PI},
        {{2000, 2000, 0}, {500, 500}, 1, {2000, 250, 3000}, {0, 0, -1}, 0.004913964414903403 * M_PI},
        {{2000, 2000, 0}, {500000, 500000}, 1, {2000, 0, 250}, {0, 1, 0}, 0.4994349326414312 * M_PI},
        {{2000, 2000, 0}, {500000, 500000}, 1, {2000, 1750, 3000}, {0, 0, -1}, 0.9998821775514607 * M_PI},
        {{500, 500, 1000}, {1000, 1000}, -1, {0, 0, 0}, {0, 0, 1}, 0.138531605994893 * M_PI},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double axis[3] = {0, 0, cases[i].up_or_down}, up[3] = {0, 1, 0};
        struct shape shape = one_piece(lx_facets_of_rectangle(cases[i].center, cases[i].size, axis, up));
        assert_near(light_and_clear(shape, cases[i].place, cases[i].normal), cases[i].expected, 1e-13, "printed");
    }
    const double center[3] = {0, 0, 3000}, size[3] = {1000, 1000, 1000}, up[3] = {0, 0, 1};
    struct shape cube = one_piece(lx_facets_of_box(center, size));
    assert_near(light(&cube, (double[]){0, 0, 0}, up).value, 0.15191806968228244, 1e-13, "cube");
    assert_near(light_and_clear(cube, (double[]){4000, 0, 0}, up), 0.035827397045303494, 1e-13, "cube");
}

/* Where nothing can be seen the value is 0 and certainly so. */
static void darkness(void **unused)
{
    static const struct {
        double place[3], normal[3];
    } cases[] = {
        {{500, 0, 1000}, {-1, 0, 0}},   /* in the plane */
        {{500, 200, 1000}, {-1, 0, 0}}, /* on the line of an edge */
        {{0, 0, 1500}, {0, 0, -1}},     /* behind */
        {{0, 0, 0}, {0, 0, -1}},        /* turned away */
        {{300, 0, 0}, {1, 0, 0}},       /* its edge is on the horizon */
        {{1e9, 1e9, 0}, {1, 0, 0}},
    };
    const double center[3] = {0, 0, 1000}, size[2] = {600, 400}, axis[3] = {0, 0, -1}, up[3] = {0, 1, 0};
    struct shape panel = one_piece(lx_facets_of_rectangle(center, size, axis, up));
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        lx_bounded found = light(&panel, cases[i].place, cases[i].normal);
        assert_true(found.value == 0 && found.error == 0);
    }
    clear(&panel);
    struct shape cube = one_piece(lx_facets_of_box(center, (double[]){600, 400, 200}));
    lx_bounded inside = light(&cube, (double[]){10, 20, 1030}, up);
    assert_true(inside.value == 0 && inside.error == 0);
    clear(&cube);
}

static void touching(void **unused)
{
    const double center[3] = {0, 0, 1000}, size[2] = {600, 400}, axis[3] = {0, 0, -1}, up[3] = {0, 1, 0};
    struct lx_facets *panel = lx_facets_of_rectangle(center, size, axis, up);
    struct lx_facets *cube = lx_facets_of_box(center, (double[]){600, 400, 200});
    const double slanted_axis[3] = {1, 2, -3};
    struct lx_facets *slanted = lx_facets_of_rectangle(center, size, slanted_axis, up);
    static const double on[][3] = {{0, 0, 1000}, {300, 200, 1000}, {-300, 17, 1000}, {0, 200, 1000}};
    static const double off[][3] = {{0, 0, 999.9999999999999}, {300.00000000000006, 200, 1000}, {0, 201, 1000}};
    (void)unused;
    for (size_t i = 0; i < 4; i++)
        assert_true(lx_facets_touch(panel, lx_exact3(on[i])));
    for (size_t i = 0; i < 3; i++)
        assert_false(lx_facets_touch(panel, lx_exact3(off[i])));
    assert_true(lx_facets_touch(slanted, lx_exact3(center)));
    assert_true(lx_facets_touch(cube, lx_exact3((double[]){300, 0, 1000})));
    assert_true(lx_facets_touch(cube, lx_exact3((double[]){300, 200, 1100})));
    assert_false(lx_facets_touch(cube, lx_exact3(center)));
    assert_false(lx_facets_touch(cube, lx_exact3((double[]){300, 200, 1100.1})));
    lx_bounded3 vague = lx_exact3((double[]){0, 0, 999.9});
    vague.z.error = 0.2;
    assert_true(lx_facets_touch(panel, vague));
    vague.z.error = 0.05;
    assert_false(lx_facets_touch(panel, vague));
    lx_facets_free(panel);
    lx_facets_free(cube);
    lx_facets_free(slanted);
}

/* Next to its plane, nearby and far away, what is seen of a slanted panel does not depend on where the origin is; the
 * places are such that moving them rounds nothing. */
static void origin(void **unused)
{
    enum { PANELS = 400, EXPONENT = 29, ORIGINS = 5 };
    const double unit = ldexp(1, EXPONENT - 52), size[2] = {600, 400};
    uint64_t state = 29;
    size_t seen = 0, dark = 0;
    (void)unused;
    for (int i = 0; i < PANELS; i++) {
        const double away = i % 2 == 0 ? 500 : ldexp(1, EXPONENT - 2);
        double axis[3], along[3], place[3], inward[3];
        random_unit(&state, axis);
        random_unit(&state, along);
        const double height = axis[0] * along[0] + axis[1] * along[1] + axis[2] * along[2];
        for (int k = 0; k < 3; k++) {
            place[k] = unit * round(away * (along[k] - height * axis[k]) / unit);
            inward[k] = -along[k];
        }
        lx_bounded first = {0};
        for (int k = 0; k < ORIGINS; k++) { /* the panel's middle; far off on each axis; the place */
            double center[3] = {0}, there[3] = {place[0], place[1], place[2]};
            for (int n = 0; n < 3; n++) {
                const double by = k == 4 ? -place[n] : n == k - 1 ? ldexp(1, EXPONENT) : 0;
                center[n] += by, there[n] += by;
            }
            struct lx_facets *panel = lx_facets_of_rectangle(center, size, axis, (double[]){0.6, 0, 0.8});
            assert_non_null(panel);
            const lx_bounded found = lx_facets_irradiance(panel, lx_exact3(there), lx_exact3(inward));
            lx_facets_free(panel);
            if (k == 0)
                first = found;
            assert_true(fabs(found.value - first.value) <= first.error + found.error);
        }
        seen += first.value > 0;
        dark += first.value == 0 && first.error == 0;
    }
    assert_true(seen > PANELS / 4 && dark > PANELS / 4);
}

/* The error of a value at an uncertain place, with an uncertain normal, covers what lies within both. */
static void uncertainty(void **unused)
{
    uint64_t state = 5;
    const double center[3] = {0, 0, 0}, size[3] = {1, 0.7, 0.4};
    struct shape box = one_piece(lx_facets_of_box(center, size));
    struct shape panel = one_piece(lx_facets_of_rectangle(center, size, (double[]){0, 0, -1}, (double[]){0, 1, 0}));
    (void)unused;
    for (int i = 0; i < 4000; i++) {
        struct shape *shape = i % 2 ? &box : &panel;
        double place[3], normal[3], moved[3], turned[3], away = pow(10, uniform(&state, -3, 3));
        double place_error = away * pow(10, uniform(&state, -12, -1));
        double normal_error = pow(10, uniform(&state, -12, -1));
        random_unit(&state, place);
        random_unit(&state, normal);
        random_unit(&state, moved);
        random_unit(&state, turned);
        lx_bounded3 vague_place, vague_normal;
        for (int k = 0; k < 3; k++) {
            place[k] *= 0.3 + away;
            moved[k] = place[k] + moved[k] * place_error;
            turned[k] = normal[k] + turned[k] * normal_error;
        }
        vague_place = lx_exact3(place);
        vague_normal = lx_exact3(normal);
        vague_place.x.error = vague_place.y.error = vague_place.z.error = place_error;
        vague_normal.x.error = vague_normal.y.error = vague_normal.z.error = normal_error;
        if (lx_facets_touch(shape->pieces[0], vague_place))
            continue;
        lx_bounded vague = lx_facets_irradiance(shape->pieces[0], vague_place, vague_normal);
        lx_bounded exact = light(shape, moved, turned);
        if (!(fabs(vague.value - exact.value) <= vague.error + exact.error))
            fail_msg("%.17g with error %g, but %.17g nearby", vague.value, vague.error, exact.value);
    }
    clear(&box);
    clear(&panel);
}

/*
 * From where an edge of a box goes on beyond its end, that edge is seen end on and two faces from their sides: what is
 * left is the face at that end, straight above its corner, whose light has a closed form (Howell's catalogue, B-3).
 */
static void edges_seen_end_on(void **unused)
{
    static const double center[3] = {30, -20, 10}, size[3] = {6, 4, 2}, away = 5;
    struct shape box = one_piece(lx_facets_of_box(center, size));
    (void)unused;
    for (int i = 0; i < 24; i++) { /* 3 directions, 4 edges, 2 ends */
        const int k = i % 3, u = (k + 1) % 3, v = (k + 2) % 3;
        const double side = i / 3 % 2 ? 1 : -1, a = size[u] / away, b = size[v] / away;
        double place[3], normal[3] = {0};
        place[k] = center[k] + side * (0.5 * size[k] + away);
        place[u] = center[u] + (i / 6 % 2 ? 0.5 : -0.5) * size[u];
        place[v] = center[v] + (i / 12 % 2 ? 0.5 : -0.5) * size[v];
        normal[k] = -side;
        const lx_bounded found = light(&box, place, normal);
        const double root = sqrt(1 + a * a), other = sqrt(1 + b * b);
        assert_near(found.value, 0.5 * (a / root * atan(b / root) + b / other * atan(a / other)), 1e-14, "end on");
        assert_true(found.error <= 1e-12 * found.value);
    }
    clear(&box);
}

/* ---- what must be so ---- */

/* Cuts a quadrilateral in two, a corner of which is a rounded place of an edge. */
static void parts_add_up(void **unused)
{
    uint64_t state = 7;
    (void)unused;
    for (int i = 0; i < 300; i++) {
        double normal[3], place[3] = {uniform(&state, -2, 2), uniform(&state, -2, 2), -uniform(&state, 0.01, 3)};
        double x = uniform(&state, 0.1, 0.9), y = uniform(&state, 0.1, 0.9);
        random_unit(&state, normal);
        const double whole[4][3] = {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}};
        const double left[4][3] = {{0, 0, 0}, {0, 1, 0}, {x, 1, 0}, {y, 0, 0}};
        const double right[4][3] = {{y, 0, 0}, {x, 1, 0}, {1, 1, 0}, {1, 0, 0}};
        const lx_bounded sum = lx_add(bounded_and_clear(outline(left, 4), place, normal),
                                      bounded_and_clear(outline(right, 4), place, normal));
        const lx_bounded all = bounded_and_clear(outline(whole, 4), place, normal);
        assert_agree(sum, all, "parts");
        const double turned[4][3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
        const double mirrored[3] = {place[0], place[1], -place[2]}, upside[3] = {normal[0], normal[1], -normal[2]};
        assert_true(light_and_clear(outline(turned, 4), place, normal) == 0);
        assert_agree(bounded_and_clear(outline(turned, 4), mirrored, upside), all, "mirrored");
    }
}

static void scaling(void **unused)
{
    const double factors[] = {0x1p-30, 0x1p40, 1e-5, 3, 7e7};
    uint64_t state = 9;
    (void)unused;
    for (int i = 0; i < 200; i++) {
        double corners[3][3], larger[3][3], place[3], away[3], normal[3];
        random_unit(&state, normal);
        random_unit(&state, place);
        for (int k = 0; k < 3; k++)
            random_unit(&state, corners[k]);
        double before = light_and_clear(outline((places)corners, 3), place, normal);
        for (size_t n = 0; n < 5; n++) {
            for (int k = 0; k < 9; k++)
                larger[k / 3][k % 3] = corners[k / 3][k % 3] * factors[n];
            for (int k = 0; k < 3; k++)
                away[k] = place[k] * factors[n];
            double after = light_and_clear(outline((places)larger, 3), away, normal);
            if (n < 2)
                assert_true(before == after);
            else if (!(fabs(before - after) <= 1e-13 * before + 1e-13))
                fail_msg("scaled by %g: %.17g becomes %.17g", factors[n], before, after);
        }
    }
}

/* Each face of a polyhedron is a planar source; the silhouette is quicker. */
static void faces_make_the_silhouette(void **unused)
{
    uint64_t state = 11;
    const double center[3] = {0.25, -0.5, 0.125}, size[3] = {1, 2, 0.5}, axis[3] = {0, 0, 1};
    struct shape bodies[] = {
        one_piece(lx_facets_of_box(center, size)),
        one_piece(lx_facets_of_sphere(center, 1, 8)),
        one_piece(lx_facets_of_sphere(center, 0.7, 3)),
        one_piece(lx_facets_of_cylinder(center, 1, 0.5, axis, 6)),
    };
    (void)unused;
    for (int i = 0; i < 400; i++) {
        struct shape *body = &bodies[i % 4];
        const struct lx_facets *facets = body->pieces[0];
        double normal[3], place[3], sum = 0, corners[8][3];
        random_unit(&state, normal);
        random_unit(&state, place);
        for (int k = 0; k < 3; k++)
            place[k] *= uniform(&state, 1.2, 4);
        for (size_t f = 0; f < facets->face_count; f++) {
            const struct lx_face *face = &facets->faces[f];
            for (unsigned k = 0; k < face->count; k++) {
                const lx_wide3 *corner = &facets->corners_mm[facets->loop[face->first + k]];
                corners[k][0] = lx_wide_value(corner->x);
                corners[k][1] = lx_wide_value(corner->y);
                corners[k][2] = lx_wide_value(corner->z);
            }
            sum += light_and_clear(outline((places)corners, face->count), place, normal);
        }
        double whole = light(body, place, normal).value;
        if (!(fabs(sum - whole) <= 1e-13 * whole + (i % 4 ? 1e-15 : 1e-25)))
            fail_msg("silhouette %.17g, faces %.17g", whole, sum);
    }
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++)
        clear(&bodies[i]);
}

/* From the origin, over triangles (Van Oosterom, Strackee 1983). */
static double solid_angle(const double (*corners)[3], size_t count)
{
    double omega = 0;
    for (size_t i = 1; i + 1 < count; i++) {
        lx_bounded3 a = lx_exact3(corners[0]), b = lx_exact3(corners[i]), c = lx_exact3(corners[i + 1]);
        double la = lx_length3(a).value, lb = lx_length3(b).value, lc = lx_length3(c).value;
        double sum = lx_dot3(a, b).value * lc + lx_dot3(a, c).value * lb + lx_dot3(b, c).value * la;
        omega += 2 * atan2(fabs(lx_dot3(a, lx_cross3(b, c)).value), la * lb * lc + sum);
    }
    return omega;
}

/* By midpoints, steps each way. */
static double mean_over_sphere(const struct shape *shape, double radius, int steps)
{
    double sum = 0;
    for (int i = 0; i < steps; i++)
        for (int k = 0; k < steps; k++) {
            double z = (2 * i + 1.0) / steps - 1, phi = 2 * M_PI * (k + 0.5) / steps, rho = sqrt(1 - z * z);
            const double normal[3] = {rho * cos(phi), rho * sin(phi), z};
            const double place[3] = {radius * normal[0], radius * normal[1], radius * normal[2]};
            sum += light(shape, place, normal).value;
        }
    return sum / (steps * steps);
}

/* Over a sphere that the polygon's plane does not cut, the mean is M Omega/(4 pi) for any radius, M being pi. */
static void mean_by_solid_angle(void **unused)
{
    const double corners[4][3] = {{-1, -1, 2}, {-0.5, 1.5, 2}, {1, 1, 2}, {1.5, -0.5, 2}};
    struct shape polygon = outline(corners, 4);
    double expected = solid_angle(corners, 4) / 4;
    (void)unused;
    for (double radius = 0.01; radius < 2; radius += 0.45) {
        double coarse = mean_over_sphere(&polygon, radius, 40), fine = mean_over_sphere(&polygon, radius, 80);
        assert_near((4 * fine - coarse) / 3, expected, 1e-5, "mean");
    }
    clear(&polygon);
}

/* ---- far away, and in parts ---- */

static double by_parts(struct lx_facets *facets, unsigned parts, const double place[3], const double normal[3])
{
    struct lx_emitter source = {.type = LX_FACETS, .radiance = lx_exact(1), .facets = facets};
    struct lx_emitters emitters = {0};
    assert_int_equal(lx_facets_cut(&source, parts, &emitters), 0);
    double sum = 0;
    for (size_t i = 0; i < emitters.count; i++) {
        assert_int_equal(emitters.items[i].type, LX_POINT);
        struct lx_sample sample = lx_emitter_sample(&emitters.items[i], lx_exact3(place));
        sum += sample.e_perp.value * fmax(0, lx_dot3(sample.towards, lx_exact3(normal)).value);
    }
    lx_emitters_clear(&emitters);
    return sum;
}

static void parts_converge(void **unused)
{
    const double center[3] = {0, 0, 1000}, size[2] = {600, 400}, axis[3] = {0.1, 0.2, -1}, up[3] = {0, 1, 0};
    const double hexagon[5][3] = {{0, 0, 900}, {-200, 300, 900}, {0, 500, 900}, {400, 500, 900}, {500, 100, 900}};
    const double place[3] = {100, -200, 50}, normal[3] = {0.48, 0.6, 0.64}, box_size[3] = {300, 200, 500};
    struct shape shapes[] = {
        one_piece(lx_facets_of_rectangle(center, size, axis, up)),
        outline(hexagon, 5),
        one_piece(lx_facets_of_box(center, box_size)),
        one_piece(lx_facets_of_sphere(center, 300, 8)),
    };
    (void)unused;
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        assert_int_equal(shapes[i].count, 1);
        double whole = light(&shapes[i], place, normal).value;
        double coarse = by_parts(shapes[i].pieces[0], 8, place, normal) - whole;
        double fine = by_parts(shapes[i].pieces[0], 16, place, normal) - whole;
        assert_near(coarse / fine, 4, 0.02, "order");
        assert_true(fabs(fine) < 1e-3 * whole);
        clear(&shapes[i]);
    }
}

static void far_field(void **unused)
{
    const double hexagon[5][3] = {{0, 0, 0}, {-2, 3, 0}, {0, 5, 0}, {4, 5, 0}, {5, 1, 0}};
    const double normal[3] = {0.48, -0.6, 0.64}, towards[3] = {-0.48, 0.36, 0.8};
    struct shape shape = outline(hexagon, 5);
    const struct lx_facets *facets = shape.pieces[0];
    double middle[3] = {0, 0, 0}, offs[2];
    (void)unused;
    /* the centroid: of the triangles from the first corner, which is at the origin */
    for (int i = 1; i < 4; i++) {
        double twice = fabs(hexagon[i][0] * hexagon[i + 1][1] - hexagon[i][1] * hexagon[i + 1][0]);
        for (int k = 0; k < 2; k++)
            middle[k] += (hexagon[i][k] + hexagon[i + 1][k]) / 3 * twice / 2 / facets->area_mm2;
    }
    for (int i = 0; i < 2; i++) {
        double distance = i == 0 ? 1000 : 2000, place[3];
        for (int k = 0; k < 3; k++)
            place[k] = middle[k] - towards[k] * distance;
        double cosines = (normal[0] * towards[0] + normal[1] * towards[1] + normal[2] * towards[2]) * towards[2];
        double point = facets->area_mm2 * cosines / (distance * distance);
        offs[i] = light(&shape, place, normal).value / point - 1;
    }
    assert_true(fabs(offs[0]) < 1e-3);
    assert_near(offs[0] / offs[1], 4, 0.02, "order");
    clear(&shape);
}

static void parts(void **unused)
{
    const double center[3] = {0, 0, 1000}, size[2] = {600, 400}, axis[3] = {0, 0, -2}, up[3] = {0, 1, 0};
    struct lx_facets *panel = lx_facets_of_rectangle(center, size, axis, up);
    struct lx_emitter source = {.type = LX_FACETS,
                                .light = 3,
                                .radiance = lx_exact(5),
                                .attenuation = LX_PRACTICAL,
                                .k_mm = 70,
                                .facets = panel};
    struct lx_emitters emitters = {.light = 3};
    double strength = 0;
    (void)unused;
    assert_int_equal(lx_facets_cut(&source, 1, &emitters), 0);
    assert_int_equal(emitters.count, 1);
    for (int k = 0; k < 3; k++)
        assert_true(emitters.items[0].position_mm[k] == center[k]);
    assert_true(emitters.items[0].profile.axis.z.value == -1 && emitters.items[0].profile.exponent == 1);
    assert_int_equal(lx_facets_cut(&source, 3, &emitters), 0);
    assert_int_equal(emitters.count, 1 + 9);
    for (size_t i = 1; i < emitters.count; i++) {
        const struct lx_emitter *part = &emitters.items[i];
        assert_true(part->light == 3 && part->attenuation == LX_PRACTICAL && part->k_mm == 70);
        strength += part->strength;
    }
    assert_near(strength, 5 * 0.24, 1e-15, "strength");
    lx_emitters_clear(&emitters);
    lx_facets_free(panel);
    source.facets = lx_facets_of_sphere(center, 100, 8); /* eight triangles, twice eight trapezia, eight triangles */
    assert_int_equal(lx_facets_cut(&source, 4, &emitters), 0);
    assert_int_equal(emitters.count, (8 + 2 * 16 + 8) * 16);
    lx_emitters_clear(&emitters);
    lx_facets_free(source.facets);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truth),
        cmocka_unit_test(printed),
        cmocka_unit_test(darkness),
        cmocka_unit_test(touching),
        cmocka_unit_test(origin),
        cmocka_unit_test(uncertainty),
        cmocka_unit_test(edges_seen_end_on),
        cmocka_unit_test(parts_add_up),
        cmocka_unit_test(scaling),
        cmocka_unit_test(faces_make_the_silhouette),
        cmocka_unit_test(mean_by_solid_angle),
        cmocka_unit_test(parts_converge),
        cmocka_unit_test(far_field),
        cmocka_unit_test(parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
