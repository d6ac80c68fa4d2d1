/* SPDX-License-Identifier: MIT */
/*
 * An independent witness of light in rooms and outdoors: paths at random, in plain C, that share no code with the
 * library.
 *
 *     witness < LIST
 *
 * Each line of the list is a surface, a lamp, a place or the work to be done, lengths in mm, vectors as three numbers:
 *
 *     quad C U V R        a parallelogram, C +- U +- V, of reflectance R on both sides   |   tri A B C R
 *     hole C U V N A      cut into the last quad, with glass of index N which leaves A of what enters it, or N = 0
 *     disk C N RADIUS R   |   ball C RADIUS R   |   tube C AXIS HALF RADIUS R, open at both ends
 *     point P I           a source of intensity I in all directions
 *     spot P AXIS I COS_INNER COS_OUTER      with a smooth step between
 *     table P AXIS C0 NV NH, NV angles from the axis, NH angles around it from 0 to 90, NH rows of NV intensities
 *     plate C U V L       shines to the side of U x V with radiance L   |   globe C RADIUS L
 *     sun WAY HALF_ANGLE E        |   sky ..., overcast ... as sky_witness.c takes them, one of them
 *     place P N           where the irradiance is asked, on the side of N
 *     work SIDE BATCHES SEED BOUNCES      SIDE^2 paths in each batch, light reflected BOUNCES times, or -1 for all
 *
 * Prints, for each place, its irradiance and the standard error.
 *
 * Paths start at a place by Lambert's law and go on until little is left; where they meet surfaces the lamps are asked.
 * Close to a point the light that it sends would vary too much: a share of it comes from paths that start at the lamp,
 * meet one surface and are joined to the other path.  The sky is seen where paths leave all surfaces, and through a
 * place at random of each opening: what a way gives counts by the densities of all of these.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "witness_sky.h"

enum { MOST = 400, MOST_BOUNCES = 400, EVEN = 16, SKY_STEPS = 800 };
static const double OFF_MM = 1e-7, CLOSE_MM = 600, LEAST_SHARE = 0.02;

static uint64_t state;
/* The first numbers of a path spread evenly over all paths of a batch: multiples of powers of the root of
 * x^(EVEN + 1) = x + 1 from a start at random. */
static double starts[EVEN], steps[EVEN];
static int drawn, path_number;

static double random_number(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static double chance(void)
{
    if (drawn >= EVEN)
        return random_number();
    const double at = starts[drawn] + path_number * steps[drawn];
    drawn++;
    return at - floor(at);
}

static void begin_batch(void)
{
    double root = 1.5;
    for (int i = 0; i < 200; i++)
        root = pow(1 + root, 1.0 / (EVEN + 1));
    for (int i = 0; i < EVEN; i++) {
        starts[i] = random_number();
        steps[i] = pow(root, -1 - i);
    }
}

/* ---- surfaces ---- */

enum kind { QUAD, DISK, BALL, TUBE, TRI };

struct surface {
    enum kind kind;
    vector center, normal, u, v; /* u and v give the coordinates of a parallelogram, or from the first corner */
    double radius, half, reflectance;
    int holes; /* the next ones after `first_hole` */
    int first_hole;
};

struct hole {
    struct surface rim;
    vector u, v;
    double area, index, left;
};

static struct surface surfaces[MOST];
static struct hole holes[MOST];
static int surface_count, hole_count;

/* The first distance beyond 0 at which a ray meets a round surface; HUGE_VAL: none. */
static double meet_round(const struct surface *surface, vector start, vector way)
{
    vector from = add(start, surface->center, -1);
    double along = 0, step = 0;
    if (surface->kind == TUBE) {
        along = dot(from, surface->normal);
        step = dot(way, surface->normal);
        from = add(from, surface->normal, -along);
        way = add(way, surface->normal, -step);
    }
    const double a = dot(way, way), b = dot(from, way), c = dot(from, from) - surface->radius * surface->radius;
    const double root = b * b - a * c;
    if (root <= 0 || a <= 0)
        return HUGE_VAL;
    const double q = sqrt(root), t[2] = {(-b - q) / a, (-b + q) / a};
    for (int i = 0; i < 2; i++)
        if (t[i] > 0 && (surface->kind == BALL || fabs(along + t[i] * step) <= surface->half))
            return t[i];
    return HUGE_VAL;
}

/* The first distance beyond 0 at which a ray meets a surface, a quad beside its holes; HUGE_VAL: none. */
static double meet(const struct surface *surface, vector start, vector way)
{
    if (surface->kind == BALL || surface->kind == TUBE)
        return meet_round(surface, start, way);
    const vector from = add(start, surface->center, -1);
    const double slope = dot(way, surface->normal), t = -dot(from, surface->normal) / slope;
    if (!(t > 0) || !(t < HUGE_VAL))
        return HUGE_VAL;
    const vector at = add(from, way, t);
    if (surface->kind == DISK)
        return dot(at, at) <= surface->radius * surface->radius ? t : HUGE_VAL;
    const double s = dot(at, surface->u), r = dot(at, surface->v);
    if (surface->kind == TRI)
        return s >= 0 && r >= 0 && s + r <= 1 ? t : HUGE_VAL;
    bool is_met = fabs(s) <= 1 && fabs(r) <= 1;
    for (int h = surface->first_hole; is_met && h < surface->first_hole + surface->holes; h++)
        is_met = meet(&holes[h].rim, start, way) == HUGE_VAL;
    return is_met ? t : HUGE_VAL;
}

/* What the glass before the end of a way leaves of light. */
static double through(vector start, vector way, double end)
{
    double left = 1;
    for (int h = 0; h < hole_count; h++)
        if (holes[h].index > 0 && meet(&holes[h].rim, start, way) < end)
            left *= pane(holes[h].index, holes[h].left, dot(holes[h].rim.normal, way) / sqrt(dot(way, way)));
    return left;
}

/* What a ray meets first, the place a little before it and the normal on that side; NULL: nothing. */
static const struct surface *follow(vector start, vector way, vector *place, vector *normal, double *distance)
{
    const struct surface *met = NULL;
    double first = HUGE_VAL;
    for (int s = 0; s < surface_count; s++) {
        const double t = meet(&surfaces[s], start, way);
        if (t < first) {
            first = t;
            met = &surfaces[s];
        }
    }
    if (!met)
        return NULL;
    *distance = first;
    *place = add(start, way, first);
    *normal = met->normal;
    if (met->kind == BALL || met->kind == TUBE) {
        vector out = add(*place, met->center, -1);
        if (met->kind == TUBE)
            out = add(out, met->normal, -dot(out, met->normal));
        *normal = unit(out);
    }
    if (dot(*normal, way) > 0)
        *normal = times(*normal, -1);
    *place = add(*place, *normal, OFF_MM);
    return met;
}

/* What is left of light by a way, from its end; 0: something lies before that. */
static double passed(vector from, vector way, double end)
{
    for (int s = 0; s < surface_count; s++)
        if (meet(&surfaces[s], from, way) < end)
            return 0;
    return through(from, way, end);
}

static double passed_between(vector from, vector to)
{
    const vector way = add(to, from, -1);
    return passed(from, way, 1 - OFF_MM / (sqrt(dot(way, way)) + OFF_MM));
}

/* ---- lamps ---- */

enum shine { POINT, SPOT, TABLE, PLATE, GLOBE, SUN };

struct lamp {
    enum shine shine;
    vector place, axis, u, v;
    double strength, inner, outer, radius; /* intensity, radiance or, of a sun, irradiance; cosines; or half an angle */
    double *up, *around, *table;
    int ups, arounds;
    bool is_close; /* to a surface */
};

static struct lamp lamps[MOST];
static int lamp_count;

static int interval(const double *angles, int count, double at)
{
    int i = 0;
    while (i < count - 2 && angles[i + 1] <= at)
        i++;
    return i;
}

static double table_at(const struct lamp *lamp, vector way)
{
    const double gamma = acos(fmax(-1, fmin(1, dot(way, lamp->axis)))) * 180 / PI;
    const double c = atan2(fabs(dot(way, lamp->v)), fabs(dot(way, lamp->u))) * 180 / PI;
    if (gamma > lamp->up[lamp->ups - 1] || gamma < lamp->up[0])
        return 0;
    const int i = interval(lamp->up, lamp->ups, gamma), j = interval(lamp->around, lamp->arounds, c);
    const double x = (gamma - lamp->up[i]) / (lamp->up[i + 1] - lamp->up[i]);
    const double y = (c - lamp->around[j]) / (lamp->around[j + 1] - lamp->around[j]);
    const double *low = lamp->table + j * lamp->ups + i, *high = low + lamp->ups;
    return (1 - y) * ((1 - x) * low[0] + x * low[1]) + y * ((1 - x) * high[0] + x * high[1]);
}

/* The intensity of a point in a direction. */
static double intensity(const struct lamp *lamp, vector way)
{
    if (lamp->shine == POINT)
        return lamp->strength;
    if (lamp->shine == TABLE)
        return lamp->strength * table_at(lamp, way);
    const double t = (dot(way, lamp->axis) - lamp->outer) / (lamp->inner - lamp->outer);
    return t <= 0 ? 0 : t >= 1 ? lamp->strength : lamp->strength * t * t * (3 - 2 * t);
}

/* The share of a point's light that is asked where paths meet surfaces. */
static double asked(const struct lamp *lamp, double distance)
{
    return lamp->is_close ? fmin(1, distance * distance / (CLOSE_MM * CLOSE_MM)) : 1;
}

/* The irradiance of a lamp: of a point exactly, or the share that is asked; else of one place of the source, x, y. */
static double ask(const struct lamp *lamp, vector place, vector normal, bool in_shares, double x, double y)
{
    vector to = lamp->place;
    double facing = 1, bright = 0;
    if (lamp->shine == SUN) {
        const double least = cos(lamp->radius), cosine = 1 - x * (1 - least), sine = sqrt(fmax(0, 1 - cosine * cosine));
        const vector across_it = add(times(lamp->u, sine * cos(2 * PI * y)), lamp->v, sine * sin(2 * PI * y));
        const vector aimed = add(across_it, lamp->axis, cosine);
        facing = dot(normal, aimed);
        return facing > 0 ? facing * lamp->strength * 2 / (1 + least) * passed(place, aimed, HUGE_VAL) : 0;
    }
    if (lamp->shine == PLATE)
        to = add(add(to, lamp->u, 2 * x - 1), lamp->v, 2 * y - 1);
    vector way = add(to, place, -1);
    double square = dot(way, way), distance = sqrt(square);
    way = times(way, 1 / distance);
    if (lamp->shine == GLOBE) {
        const double least = sqrt(fmax(0, 1 - lamp->radius * lamp->radius / square));
        const double cosine = 1 - x * (1 - least), sine = sqrt(fmax(0, 1 - cosine * cosine));
        vector a, b;
        across(way, &a, &b);
        const vector aimed = add(add(times(way, cosine), a, sine * cos(2 * PI * y)), b, sine * sin(2 * PI * y));
        const double middle = distance * cosine;
        to = add(place, aimed, middle - sqrt(fmax(0, lamp->radius * lamp->radius - square * sine * sine)));
        bright = lamp->strength * 2 * PI * (1 - least);
        facing = dot(normal, aimed);
    } else if (lamp->shine == PLATE) {
        facing = dot(normal, way);
        const vector wide = cross(lamp->u, lamp->v);
        bright = lamp->strength * 4 * fmax(0, -dot(wide, way)) / square;
    } else {
        facing = dot(normal, way);
        if (facing > 0)
            bright = intensity(lamp, times(way, -1)) / square * 1e6 * (in_shares ? asked(lamp, distance) : 1);
    }
    return facing > 0 && bright > 0 ? facing * bright * passed_between(place, to) : 0;
}

/* The reflected irradiance that the other share of a point's light is by one surface: one path from the lamp. */
static double join(const struct lamp *lamp, vector place, vector normal)
{
    if (!lamp->is_close)
        return 0;
    const double least = lamp->shine == SPOT ? lamp->outer : -1, cosine = least + (1 - least) * chance();
    const double sine = sqrt(fmax(0, 1 - cosine * cosine)), turn = 2 * PI * chance();
    const vector way = add(add(times(lamp->axis, cosine), lamp->u, sine * cos(turn)), lamp->v, sine * sin(turn));
    const double flux = intensity(lamp, way) * 2 * PI * (1 - least);
    vector there, facing;
    double distance;
    const struct surface *met = flux > 0 ? follow(lamp->place, way, &there, &facing, &distance) : NULL;
    if (!met || !(distance < CLOSE_MM))
        return 0;
    const vector to = add(there, place, -1);
    const double square = dot(to, to), kernel = dot(normal, to) * -dot(facing, to);
    if (!(dot(normal, to) > 0) || !(dot(facing, to) < 0))
        return 0;
    const double left = through(lamp->place, way, distance) * passed_between(place, there);
    return left * met->reflectance * flux * (1 - asked(lamp, distance)) * kernel / (PI * square * square) * 1e6;
}

/* ---- paths ---- */

static vector lambert(vector normal, double x, double y)
{
    vector a, b;
    across(normal, &a, &b);
    const double sine = sqrt(x), turn = 2 * PI * y;
    return add(add(times(normal, sqrt(fmax(0, 1 - x))), a, sine * cos(turn)), b, sine * sin(turn));
}

static double even_or_not(const struct lamp *lamp)
{
    return lamp->shine >= PLATE ? chance() : 0;
}

static struct sky sky;
static bool has_sky;

/* The irradiance by a way to the sky that paths of all kinds may find, by the densities of them together. */
static double sky_by(vector place, vector normal, vector way)
{
    const double facing = dot(normal, way);
    if (!(facing > 0))
        return 0;
    double density = facing / PI;
    for (int h = 0; h < hole_count; h++) {
        const double t = meet(&holes[h].rim, place, way);
        if (t < HUGE_VAL)
            density += t * t / (holes[h].area * fabs(dot(way, holes[h].rim.normal)));
    }
    return luminance(&sky, way) * facing / density;
}

static double sky_by_holes(vector place, vector normal)
{
    double sum = 0;
    for (int h = 0; h < hole_count && has_sky; h++) {
        const double x = 2 * chance() - 1, y = 2 * chance() - 1;
        const vector to = add(add(holes[h].rim.center, holes[h].u, x), holes[h].v, y);
        const vector way = unit(add(to, place, -1));
        const double found = sky_by(place, normal, way);
        sum += found > 0 ? found * passed(place, way, HUGE_VAL) : 0;
    }
    return sum;
}

/* All light at a place by one path; paths end by chance where they have little of it left. */
static double path(vector place, vector normal, int bounces)
{
    double sum = 0, share = 1, distance;
    for (int bounce = 0; bounce <= bounces; bounce++) {
        const vector way = lambert(normal, chance(), chance());
        double here = sky_by_holes(place, normal);
        for (int l = 0; l < lamp_count; l++) {
            here += ask(&lamps[l], place, normal, bounce > 0, even_or_not(&lamps[l]), even_or_not(&lamps[l]));
            here += bounce < bounces ? join(&lamps[l], place, normal) : 0;
        }
        sum += share * here;
        const vector start = place, facing = normal;
        const struct surface *met = follow(start, way, &place, &normal, &distance);
        if (!met)
            return sum + (has_sky ? share * sky_by(start, facing, way) * through(start, way, HUGE_VAL) : 0);
        share *= met->reflectance * through(start, way, distance);
        if (share < LEAST_SHARE && chance() >= share / LEAST_SHARE)
            return sum;
        share = fmax(share, LEAST_SHARE);
    }
    return sum;
}

static void witness(vector place, vector normal, int side, int batches, int bounces)
{
    double sum = 0, squares = 0;
    place = add(place, normal, OFF_MM);
    for (int b = 0; b < batches; b++) {
        double mean = 0;
        begin_batch();
        for (path_number = 0; path_number < side * side; path_number++) {
            drawn = 0;
            mean += path(place, normal, bounces);
        }
        mean /= (double)side * side;
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / batches, spread = fmax(0, squares / batches - mean * mean);
    printf("%.15g %.3g\n", mean, sqrt(spread / (batches - 1)));
    fflush(stdout);
}

/* ---- reading ---- */

static double number(void)
{
    double value;
    if (scanf("%lf", &value) != 1) {
        fprintf(stderr, "witness: a number is missing\n");
        exit(2);
    }
    return value;
}

static vector three(void)
{
    vector read;
    read.x = number();
    read.y = number();
    read.z = number();
    return read;
}

/* From the vectors to where the coordinates are 1. */
static void set_plane(struct surface *surface, vector u, vector v)
{
    surface->normal = unit(cross(u, v));
    surface->u = times(cross(v, surface->normal), 1 / dot(u, cross(v, surface->normal)));
    surface->v = times(cross(u, surface->normal), 1 / dot(v, cross(u, surface->normal)));
}

static void read_surface(enum kind kind)
{
    struct surface *surface = &surfaces[surface_count++];
    surface->kind = kind;
    surface->first_hole = hole_count;
    surface->center = three();
    if (kind == QUAD || kind == TRI) {
        const vector u = three(), v = three(), from = kind == TRI ? surface->center : (vector){0, 0, 0};
        set_plane(surface, add(u, from, -1), add(v, from, -1));
    } else if (kind != BALL) {
        surface->normal = unit(three());
    }
    surface->half = kind == TUBE ? number() : 0;
    surface->radius = kind == QUAD || kind == TRI ? 0 : number();
    surface->reflectance = number();
}

static void read_hole(void)
{
    struct hole *hole = &holes[hole_count++];
    surfaces[surface_count - 1].holes++;
    hole->rim = (struct surface){.kind = QUAD, .center = three()};
    hole->u = three();
    hole->v = three();
    set_plane(&hole->rim, hole->u, hole->v);
    hole->area = 4 * sqrt(dot(cross(hole->u, hole->v), cross(hole->u, hole->v)));
    hole->index = number();
    hole->left = number();
}

/* The irradiance of a horizontal plane under the open sky: by Simpson's rule on ways from the sun to the horizon. */
static double open_horizontal(void)
{
    double sum = 0;
    vector a, b;
    across(sky.sun, &a, &b);
    for (int i = 0; i < SKY_STEPS; i++) {
        const double turn = (i + 0.5) * 2 * PI / SKY_STEPS;
        const vector side = add(times(a, cos(turn)), b, sin(turn));
        const double end = atan2(dot(sky.sun, sky.up), -dot(side, sky.up));
        for (int j = 1; j < SKY_STEPS; j++) {
            const double chi = j * end / SKY_STEPS;
            const vector way = add(times(sky.sun, cos(chi)), side, sin(chi));
            const double weight = (j % 2 ? 4.0 : 2.0) / 3 * end / SKY_STEPS;
            sum += weight * luminance(&sky, way) * fmax(0, dot(way, sky.up)) * sin(chi);
        }
    }
    return sum * 2 * PI / SKY_STEPS;
}

static void read_sky(bool is_overcast)
{
    char by[16];
    sky = (struct sky){.is_overcast = is_overcast, .scale = 1};
    double *const all[] = {&sky.a, &sky.b, &sky.c, &sky.d, &sky.e, &sky.off};
    for (int i = 0; i < 6 && !is_overcast; i++)
        *all[i] = number();
    sky.up = unit(three());
    sky.sun = is_overcast ? sky.up : unit(three());
    if (scanf("%15s", by) != 1)
        exit(2);
    const double value = number(), reflectance = number(), found = open_horizontal();
    sky.scale = value / (by[0] == 'h' ? found : luminance(&sky, sky.up));
    sky.ground = reflectance / PI * found * sky.scale;
    has_sky = true;
}

static double *numbers(int count)
{
    double *read = calloc((size_t)count, sizeof *read);
    for (int i = 0; read && i < count; i++)
        read[i] = number();
    return read;
}

static void read_lamp(enum shine shine)
{
    struct lamp *lamp = &lamps[lamp_count++];
    lamp->shine = shine;
    lamp->place = three();
    lamp->axis = shine == SUN ? unit(lamp->place) : (vector){0, 1, 0};
    if (shine == SPOT || shine == TABLE)
        lamp->axis = unit(three());
    across(lamp->axis, &lamp->u, &lamp->v);
    lamp->strength = 1;
    if (shine == TABLE) {
        const vector c0 = three();
        lamp->u = unit(add(c0, lamp->axis, -dot(c0, lamp->axis)));
        lamp->v = cross(lamp->axis, lamp->u);
        lamp->ups = (int)number();
        lamp->arounds = (int)number();
        lamp->up = numbers(lamp->ups);
        lamp->around = numbers(lamp->arounds);
        lamp->table = numbers(lamp->ups * lamp->arounds);
        return;
    }
    if (shine == PLATE) {
        lamp->u = three();
        lamp->v = three();
    }
    lamp->radius = shine == GLOBE || shine == SUN ? number() : 0;
    lamp->strength = number();
    if (shine == SPOT) {
        lamp->inner = number();
        lamp->outer = number();
    }
}

/* Looks round a point for surfaces close by. */
static void look_round(struct lamp *lamp)
{
    vector place, normal;
    double distance;
    for (int i = 0; i < 20000 && lamp->shine <= TABLE; i++) {
        const double cosine = 2 * chance() - 1, turn = 2 * PI * chance(), sine = sqrt(1 - cosine * cosine);
        const vector way = {sine * cos(turn), cosine, sine * sin(turn)};
        lamp->is_close =
            lamp->is_close ||
            (intensity(lamp, way) > 0 && follow(lamp->place, way, &place, &normal, &distance) && distance < CLOSE_MM);
    }
}

int main(void)
{
    static vector places[MOST], normals[MOST];
    static const char *const kinds[] = {"quad", "disk", "ball", "tube", "tri"};
    static const char *const shines[] = {"point", "spot", "table", "plate", "globe", "sun"};
    int place_count = 0, side = 64, batches = 16, bounces = -1;
    char word[16];
    while (scanf("%15s", word) == 1) {
        bool is_known = false;
        if (surface_count == MOST || hole_count == MOST || lamp_count == MOST || place_count == MOST)
            return 2;
        for (int k = 0; k < 5; k++)
            if (!strcmp(word, kinds[k])) {
                read_surface((enum kind)k);
                is_known = true;
            }
        for (int k = 0; k < 6; k++)
            if (!strcmp(word, shines[k])) {
                read_lamp((enum shine)k);
                is_known = true;
            }
        const bool is_overcast = !strcmp(word, "overcast");
        if (is_overcast || !strcmp(word, "sky")) {
            read_sky(is_overcast);
        } else if (!strcmp(word, "hole") && surface_count > 0) {
            read_hole();
        } else if (!strcmp(word, "place")) {
            places[place_count] = three();
            normals[place_count++] = unit(three());
        } else if (!strcmp(word, "work")) {
            side = (int)number();
            batches = (int)number();
            state = (uint64_t)number();
            bounces = (int)number();
        } else if (!is_known) {
            fprintf(stderr, "witness: unknown word %s\n", word);
            return 2;
        }
    }
    for (int l = 0; l < lamp_count; l++)
        look_round(&lamps[l]);
    for (int p = 0; p < place_count; p++)
        witness(places[p], normals[p], side, batches, bounces < 0 ? MOST_BOUNCES : bounces);
    return 0;
}
