/* SPDX-License-Identifier: MIT */
/*
 * An independent witness of daylight: the irradiance of a place under a sky, a sun or a lamp behind bodies, walls with
 * holes and panes of glass, in plain C, that shares no code with the library.
 *
 *     sky_witness [PANELS] < LIST
 *
 * Each line of the list is a body, a source or a place, lengths in mm, vectors as three numbers:
 *
 *     quad C U V          the parallelogram C +- U +- V        |   tri A B C
 *     disk C N RADIUS     |   ball C RADIUS   |   tube C AXIS HALF RADIUS, open at both ends
 *     wall C U V          a quad, in which the next lines may cut holes:
 *     hole C U V N A      with glass of index N which leaves A of what enters it, or N = 0 for none
 *     sky A B C D E OFF UP SUN BY VALUE GROUND      (1 + A exp(B/cos Z)) (1 + C (exp(D chi) - OFF) + E cos^2 chi),
 *                         BY zenith, horizontal; GROUND is the reflectance below
 *     overcast UP BY VALUE GROUND
 *     sun SUN HALF_ANGLE E
 *     plate C U V L       shines to the side of U x V   |   globe C RADIUS L   |   point P I   |   distant SUN E
 *     place P N           where the irradiance is asked, on the side of N
 *
 * A list has one source.  Prints, for each place, the irradiance and an estimate of its error.
 *
 * The integral over directions runs along half circles from a pole: the sun of a sky, else the place's normal.  On one
 * of them all directions in which something may begin or end are found in closed form, a ray tells for the middle
 * between two of them what is seen there, and the rule of Gauss and Kronrod with 7 and 15 points, halved where its two
 * sums differ, runs between.  Across the half circles the same rule does, in PANELS to
 * begin with.
 */
#include "sky_witness_scene.h"

/* ---- half circles from the pole ---- */

static vector pole, first_side, second_side, side;
static double marks[MOST_MARKS];
static int mark_count;

static void mark(double angle)
{
    if (angle > 0 && angle < PI && mark_count < MOST_MARKS)
        marks[mark_count++] = angle;
}

/* Where the half circle crosses the plane of all ways across a vector. */
static void mark_plane(vector n)
{
    const double angle = atan2(-dot(n, pole), dot(n, side));
    mark(angle);
    mark(angle + PI);
}

static void mark_line(vector a, vector b)
{
    const vector turn = cross(pole, side), from = add(a, place, -1), to = add(b, place, -1);
    const double low = dot(turn, from), high = dot(turn, to);
    if ((low > 0) == (high > 0))
        return;
    const vector at = add(times(from, high / (high - low)), to, -low / (high - low));
    if (dot(at, side) > 0)
        mark(atan2(dot(at, side), dot(at, pole)));
}

static void mark_quad(vector c, vector u, vector v)
{
    const vector corners[4] = {add(add(c, u, 1), v, 1), add(add(c, u, -1), v, 1), add(add(c, u, -1), v, -1),
                               add(add(c, u, 1), v, -1)};
    for (int i = 0; i < 4; i++)
        mark_line(corners[i], corners[(i + 1) % 4]);
}

/* Ways on a cone around a vector, at a cosine. */
static void mark_cone(vector axis, double cosine)
{
    const double a = dot(axis, pole), b = dot(axis, side), size = hypot(a, b);
    if (!(fabs(cosine) < size))
        return;
    const double middle = atan2(b, a), off = acos(cosine / size);
    for (int turn = -1; turn <= 1; turn++) {
        mark(middle - off + turn * 2 * PI);
        mark(middle + off + turn * 2 * PI);
    }
}

static void mark_circle(vector c, vector n, double radius)
{
    vector x, y;
    across(n, &x, &y);
    const vector turn = cross(pole, side), from = add(c, place, -1);
    const double a = radius * dot(turn, x), b = radius * dot(turn, y), k = -dot(turn, from), size = hypot(a, b);
    if (!(fabs(k) < size))
        return;
    for (int i = -1; i <= 1; i += 2) {
        const double angle = atan2(b, a) + i * acos(k / size);
        const vector at = add(add(from, x, radius * cos(angle)), y, radius * sin(angle));
        if (dot(at, side) > 0)
            mark(atan2(dot(at, side), dot(at, pole)));
    }
}

static void mark_ball(vector c, double radius)
{
    const vector from = add(c, place, -1);
    const double away = sqrt(dot(from, from));
    if (away > radius)
        mark_cone(times(from, 1 / away), sqrt(1 - radius * radius / (away * away)));
    else
        mark_plane(from);
}

static void mark_all(void)
{
    mark_count = 0;
    mark_plane(normal);
    for (int i = 0; i < body_count; i++) {
        const struct body *body = &bodies[i];
        switch (body->kind) {
        case QUAD:
        case WALL:
        case HOLE: mark_quad(body->c, body->u, body->v); break;
        case TRI: {
            const vector b = add(body->c, body->u, 1), c = add(body->c, body->v, 1);
            mark_line(body->c, b);
            mark_line(b, c);
            mark_line(c, body->c);
            break;
        }
        case DISK: mark_circle(body->c, unit(cross(body->u, body->v)), body->radius); break;
        case BALL: mark_ball(body->c, body->radius); break;
        case TUBE: {
            const vector from = add(body->c, place, -1), off = add(from, body->u, -dot(from, body->u));
            const double away = sqrt(dot(off, off));
            for (int k = -1; k <= 1; k += 2)
                mark_circle(add(body->c, body->u, k * body->half), body->u, body->radius);
            if (away > body->radius * (1 + 1e-12)) {
                const vector ahead = times(off, 1 / away), aside = cross(body->u, ahead);
                const double sine = body->radius / away, cosine = sqrt(1 - sine * sine);
                for (int k = -1; k <= 1; k += 2) /* across the plane that touches it */
                    mark_plane(add(times(aside, cosine), ahead, k * sine));
            } else {
                mark_plane(off);
            }
            break;
        }
        }
    }
    if (source.kind == SKY || source.kind == OVERCAST)
        mark_plane(source.sky.up);
    if (source.kind == PLATE)
        mark_quad(source.at, source.u, source.v);
    if (source.kind == GLOBE)
        mark_ball(source.at, source.radius);
}

/* ---- the rule ---- */

static const double nodes[8] = {0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                0.586087235467691130294144691474,    0.405845151377397166906606412076961,
                                0.207784955007898467600689403773245, 0};
static const double kronrod[8] = {0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                  0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                  0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                  0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
static const double gauss[4] = {0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

typedef double function(double x);

/* Adds to *error; `enough`: for one panel. */
static double integrate(function *f, double from, double to, double enough, int depth, double *error)
{
    const double middle = (from + to) / 2, half = (to - from) / 2;
    double fine = 0, coarse = 0;
    for (int i = 0; i < 15; i++) {
        const int k = i < 8 ? i : 14 - i;
        const double value = f(middle + (i < 8 ? -1 : 1) * half * nodes[k]);
        fine += kronrod[k] * value;
        coarse += k % 2 ? gauss[k / 2] * value : 0;
    }
    const double off = fabs(fine - coarse) * half;
    if (off <= enough || depth == 0) {
        *error += off;
        return fine * half;
    }
    return integrate(f, from, middle, enough, depth - 1, error) + integrate(f, middle, to, enough, depth - 1, error);
}

static double scale_of_all, inner_error;
static bool is_clear;

/* What the source sends where it is seen. */
static double emitted(vector way)
{
    return source.kind == SKY || source.kind == OVERCAST ? luminance(&source.sky, way) : source.value;
}

static double along(double angle)
{
    const vector way = add(times(pole, cos(angle)), side, sin(angle));
    return (is_clear ? emitted(way) : radiance(way)) * fmax(dot(way, normal), 0) * sin(angle);
}

static int by_value(const void *a, const void *b)
{
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

static double farthest; /* from the pole */

static double half_circle(double turn)
{
    double sum = 0;
    side = add(times(first_side, cos(turn)), second_side, sin(turn));
    mark_all();
    marks[mark_count++] = 0;
    marks[mark_count++] = farthest;
    qsort(marks, (size_t)mark_count, sizeof *marks, by_value);
    for (int i = 0; i + 1 < mark_count && marks[i + 1] <= farthest; i++) {
        const double from = marks[i], to = marks[i + 1], middle = (from + to) / 2;
        const vector way = add(times(pole, cos(middle)), side, sin(middle));
        if (to - from < 1e-15 || dot(way, normal) <= 0)
            continue;
        const double here = radiance(way);
        if (here <= 0)
            continue;
        is_clear = here > emitted(way) * (1 - 1e-12); /* else glass weakens it */
        double error = 0;
        sum += integrate(along, from, to, 1e-13 * scale_of_all, 30, &error);
        inner_error = fmax(inner_error, error);
    }
    return sum;
}

/* Turns about the pole where something may begin. */
static double turns[MOST_MARKS];
static int turn_count;

static void note_turn(vector way)
{
    if (turn_count < MOST_MARKS)
        turns[turn_count++] = atan2(dot(way, second_side), dot(way, first_side));
}

/* A corner, and where the edge to the next one crosses the horizons of the source and of the place: there the half
 * circles have a kink across which no rule of a smooth function is to be taken. */
static void note_edge(vector a, vector b)
{
    const vector from = add(a, place, -1), to = add(b, place, -1), planes[2] = {source.sky.up, normal};
    note_turn(from);
    for (int i = 0; i < 2; i++) {
        const double low = dot(planes[i], from), high = dot(planes[i], to);
        if ((low > 0) != (high > 0))
            note_turn(add(times(from, high / (high - low)), to, -low / (high - low)));
    }
}

static void note_corners(vector c, vector u, vector v)
{
    const vector corners[4] = {add(add(c, u, 1), v, 1), add(add(c, u, -1), v, 1), add(add(c, u, -1), v, -1),
                               add(add(c, u, 1), v, -1)};
    for (int i = 0; i < 4; i++)
        note_edge(corners[i], corners[(i + 1) % 4]);
}

/* Those of the rim of a disk, and where a ball begins and ends. */
static void note_rim(vector c, vector n, double radius)
{
    vector x, y;
    across(n, &x, &y);
    for (int i = 0; i < 8; i++)
        note_turn(add(add(add(c, x, radius * cos(i * PI / 4)), y, radius * sin(i * PI / 4)), place, -1));
}

static void note_ball(vector c, double radius)
{
    const vector from = add(c, place, -1), off = cross(pole, from);
    const double away = sqrt(dot(off, off));
    note_turn(from);
    for (int k = -1; k <= 1 && away > radius; k += 2) {
        const double middle = atan2(dot(from, second_side), dot(from, first_side)) + k * asin(radius / away);
        note_turn(add(times(first_side, cos(middle)), second_side, sin(middle)));
    }
}

static int panels = 16;

static double all_around(double *error)
{
    turn_count = 0;
    for (int i = 0; i <= panels; i++)
        turns[turn_count++] = -PI + i * 2 * PI / panels;
    for (int i = 0; i < body_count; i++) {
        const struct body *body = &bodies[i];
        if (body->kind == TRI) {
            note_edge(body->c, add(body->c, body->u, 1));
            note_edge(add(body->c, body->u, 1), add(body->c, body->v, 1));
            note_edge(add(body->c, body->v, 1), body->c);
        } else if (body->kind == BALL) {
            note_ball(body->c, body->radius);
        } else if (body->kind == DISK) {
            note_rim(body->c, cross(body->u, body->v), body->radius);
        } else if (body->kind == TUBE) {
            for (int k = -1; k <= 1; k += 2)
                note_rim(add(body->c, body->u, k * body->half), body->u, body->radius);
        } else {
            note_corners(body->c, body->u, body->v);
        }
    }
    if (source.kind == PLATE)
        note_corners(source.at, source.u, source.v);
    if (source.kind == GLOBE)
        note_ball(source.at, source.radius);
    note_turn(normal);
    note_turn(source.sky.up);
    qsort(turns, (size_t)turn_count, sizeof *turns, by_value);
    double sum = 0;
    inner_error = 0;
    *error = 0;
    for (int i = 0; i + 1 < turn_count; i++)
        if (turns[i + 1] - turns[i] > 1e-14)
            sum += integrate(half_circle, turns[i], turns[i + 1], 3e-12 * scale_of_all, 40, error);
    *error += inner_error * 2 * PI + 1e-13 * scale_of_all;
    return sum;
}

/* ---- what is asked ---- */

static double open_horizontal(void)
{
    const int bodies_before = body_count;
    double error;
    body_count = 0;
    normal = source.sky.up;
    place = (vector){0, 0, 0};
    pole = source.kind == SKY ? source.sky.sun : source.sky.up;
    across(pole, &first_side, &second_side);
    farthest = PI;
    scale_of_all = 1;
    const double found = all_around(&error);
    body_count = bodies_before;
    return found;
}

static double ask(double *error)
{
    *error = 0;
    if (source.kind == POINT) {
        const vector way = add(source.at, place, -1);
        const double away = sqrt(dot(way, way)), cosine = dot(way, normal) / away;
        return fmax(cosine, 0) * source.value / (away * away * 1e-6) * left_of(times(way, 1 / away), away);
    }
    if (source.kind == DISTANT)
        return fmax(dot(source.sky.sun, normal), 0) * source.value * left_of(source.sky.sun, HUGE_VAL);
    pole = source.kind == SKY || source.kind == SUN ? source.sky.sun : normal;
    across(pole, &first_side, &second_side);
    farthest = source.kind == SUN ? source.radius : PI;
    scale_of_all = source.kind == SKY || source.kind == OVERCAST ? source.sky.scale : source.value;
    const double first = all_around(error);
    if (first > scale_of_all / 10 || first == 0)
        return first;
    scale_of_all = first;
    return all_around(error);
}

static bool numbers(double *into, int count)
{
    for (int i = 0; i < count; i++)
        if (scanf("%lf", &into[i]) != 1)
            return false;
    return true;
}

static bool vectors(vector *into, int count)
{
    double n[3];
    for (int i = 0; i < count; i++) {
        if (!numbers(n, 3))
            return false;
        into[i] = (vector){n[0], n[1], n[2]};
    }
    return true;
}

static void fail(const char *word)
{
    fprintf(stderr, "sky_witness: cannot read %s\n", word);
    exit(1);
}

static void read_level(const char *word)
{
    char by[16];
    double number[2];
    if (scanf("%15s", by) != 1 || !numbers(number, 2))
        fail(word);
    source.sky.scale = 1;
    source.sky.ground = 0;
    source.sky.sun = source.kind == OVERCAST ? source.sky.up : unit(source.sky.sun);
    source.sky.up = unit(source.sky.up);
    if (by[0] == 'z')
        source.sky.scale = number[0] / luminance(&source.sky, source.sky.up);
    const double found = open_horizontal();
    if (by[0] == 'h')
        source.sky.scale = number[0] / found;
    source.sky.ground = number[1] / PI * (by[0] == 'h' ? number[0] : found);
}

static bool is_body(const char *word)
{
    static const char *const words[] = {"quad", "tri", "disk", "ball", "tube", "wall", "hole"};
    struct body *body = &bodies[body_count];
    vector v[3] = {{0, 0, 0}};
    for (int i = 0; i < 7; i++) {
        if (strcmp(word, words[i]) != 0)
            continue;
        if (body_count + 1 == MOST)
            fail("more bodies");
        bool good = true;
        *body = (struct body){.kind = (enum kind)i};
        if (i == DISK) {
            good = vectors(v, 2) && numbers(&body->radius, 1);
            across(unit(v[1]), &body->u, &body->v);
            body->u = times(body->u, body->radius);
            body->v = times(body->v, body->radius);
        } else if (i == BALL) {
            good = vectors(v, 1) && numbers(&body->radius, 1);
        } else if (i == TUBE) {
            good = vectors(v, 2) && numbers(&body->half, 1) && numbers(&body->radius, 1);
            body->u = unit(v[1]);
        } else {
            good = vectors(v, 3);
            body->u = i == TRI ? add(v[1], v[0], -1) : v[1];
            body->v = i == TRI ? add(v[2], v[0], -1) : v[2];
            good = good && (i != HOLE || (numbers(&body->index, 1) && numbers(&body->left, 1)));
        }
        body->c = v[0];
        if (!good)
            fail(word);
        body_count++;
        return true;
    }
    return false;
}

static bool is_source(const char *word)
{
    vector v[3] = {{0, 0, 0}};
    double n[6];
    bool good = true;
    if (!strcmp(word, "sky")) {
        good = numbers(n, 6) && vectors(v, 2);
        source = (struct source){.kind = SKY,
                                 .sky = {.a = n[0], .b = n[1], .c = n[2], .d = n[3], .e = n[4], .off = n[5]}};
        source.sky.up = v[0], source.sky.sun = v[1];
        read_level(word);
    } else if (!strcmp(word, "overcast")) {
        good = vectors(v, 1);
        source = (struct source){.kind = OVERCAST, .sky = {.is_overcast = true, .up = v[0]}};
        read_level(word);
    } else if (!strcmp(word, "sun")) {
        good = vectors(v, 1) && numbers(n, 2);
        source = (struct source){.kind = SUN, .sky = {.sun = unit(v[0]), .up = unit(v[0])}, .radius = n[0]};
        source.value = n[1] / (PI * sin(n[0]) * sin(n[0]));
    } else if (!strcmp(word, "plate")) {
        good = vectors(v, 3) && numbers(n, 1);
        source = (struct source){.kind = PLATE, .at = v[0], .u = v[1], .v = v[2], .value = n[0]};
    } else if (!strcmp(word, "globe")) {
        good = vectors(v, 1) && numbers(n, 2);
        source = (struct source){.kind = GLOBE, .at = v[0], .radius = n[0], .value = n[1]};
    } else if (!strcmp(word, "point")) {
        good = vectors(v, 1) && numbers(n, 1);
        source = (struct source){.kind = POINT, .at = v[0], .value = n[0]};
    } else if (!strcmp(word, "distant")) {
        good = vectors(v, 1) && numbers(n, 1);
        source = (struct source){.kind = DISTANT, .sky.sun = unit(v[0]), .value = n[0]};
    } else {
        return false;
    }
    if (!good)
        fail(word);
    if (source.kind > SUN && source.kind < DISTANT)
        source.sky.up = (vector){0, 0, 1};
    return true;
}

int main(int count, char **arguments)
{
    char word[16];
    vector v[2];
    if (count > 1)
        panels = atoi(arguments[1]);
    while (scanf("%15s", word) == 1) {
        if (is_body(word) || is_source(word))
            continue;
        if (strcmp(word, "place") != 0 || !vectors(v, 2))
            fail(word);
        double error;
        place = v[0];
        normal = unit(v[1]);
        const double found = ask(&error);
        printf("%.17g %.3g\n", found, error);
    }
    return 0;
}
