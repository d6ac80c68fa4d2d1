/* SPDX-License-Identifier: MIT */
/*
 * An independent witness of light in rooms: paths at random, in plain C, that share no code with the library.
 *
 *     witness < LIST
 *
 * Each line of the list is a surface, a lamp, a place or the work to be done, lengths in mm, vectors as three numbers:
 *
 *     quad C U V R        a parallelogram, C +- U +- V, of reflectance R on both sides
 *     disk C N RADIUS R   |   ball C RADIUS R   |   tube C AXIS HALF RADIUS R, open at both ends
 *     point P I           a source of intensity I in all directions
 *     spot P AXIS I COS_INNER COS_OUTER      with a smooth step between
 *     table P AXIS C0 NV NH, NV angles from the axis, NH angles around it from 0 to 90, NH rows of NV intensities
 *     plate C U V L       shines to the side of U x V with radiance L   |   globe C RADIUS L
 *     place P N           where the irradiance is asked, on the side of N
 *     work SIDE BATCHES SEED      SIDE^2 paths in each batch
 *
 * Prints, for each place, its irradiance and the standard error.
 *
 * Paths start at a place by Lambert's law and go on until little is left; where they meet surfaces the lamps are asked.
 * Close to a point the light that it sends would vary too much: a share of it comes from paths that start at the lamp,
 * meet one surface and are joined to the other path.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 400, MOST_BOUNCES = 400, EVEN = 16 };
static const double PI = 3.14159265358979323846, OFF_MM = 1e-5, CLOSE_MM = 600, LEAST_SHARE = 0.02;

typedef struct {
    double x, y, z;
} vector;

static vector add(vector a, vector b, double by)
{
    return (vector){a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

static double dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static vector times(vector a, double by)
{
    return (vector){by * a.x, by * a.y, by * a.z};
}

static vector unit(vector a)
{
    return times(a, 1 / sqrt(dot(a, a)));
}

/* Two directions across a unit vector. */
static void across(vector n, vector *a, vector *b)
{
    const vector other = fabs(n.x) < 0.6 ? (vector){1, 0, 0} : (vector){0, 1, 0};
    *a = unit(cross(n, other));
    *b = cross(n, *a);
}

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

enum kind { QUAD, DISK, BALL, TUBE };

struct surface {
    enum kind kind;
    vector center, normal, u, v; /* u and v by their squares: coordinates of a parallelogram */
    double radius, half, reflectance;
};

static struct surface surfaces[MOST];
static int surface_count;

/* The first distance beyond 0 at which a ray meets a surface; HUGE_VAL: none. */
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
    return fabs(dot(at, surface->u)) <= 1 && fabs(dot(at, surface->v)) <= 1 ? t : HUGE_VAL;
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

/* Whether nothing lies between two places. */
static bool is_open(vector from, vector to)
{
    const vector way = add(to, from, -1);
    const double end = 1 - OFF_MM / (sqrt(dot(way, way)) + OFF_MM);
    for (int s = 0; s < surface_count; s++)
        if (meet(&surfaces[s], from, way) < end)
            return false;
    return true;
}

/* ---- lamps ---- */

enum shine { POINT, SPOT, TABLE, PLATE, GLOBE };

struct lamp {
    enum shine shine;
    vector place, axis, u, v;
    double strength, inner, outer, radius; /* intensity or radiance; cosines */
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
    return facing > 0 && bright > 0 && is_open(place, to) ? facing * bright : 0;
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
    if (!(dot(normal, to) > 0) || !(dot(facing, to) < 0) || !is_open(place, there))
        return 0;
    return met->reflectance * flux * (1 - asked(lamp, distance)) * kernel / (PI * square * square) * 1e6;
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

/* All light at a place by one path; paths end by chance where they have little of it left. */
static double path(vector place, vector normal)
{
    double sum = 0, share = 1;
    vector way = lambert(normal, chance(), chance());
    for (int l = 0; l < lamp_count; l++)
        sum += ask(&lamps[l], place, normal, false, even_or_not(&lamps[l]), even_or_not(&lamps[l])) +
               join(&lamps[l], place, normal);
    for (int bounce = 0; bounce < MOST_BOUNCES; bounce++) {
        double distance;
        const struct surface *met = follow(place, way, &place, &normal, &distance);
        if (!met)
            break;
        share *= met->reflectance;
        if (share < LEAST_SHARE && chance() >= share / LEAST_SHARE)
            break;
        share = fmax(share, LEAST_SHARE);
        way = lambert(normal, chance(), chance());
        for (int l = 0; l < lamp_count; l++)
            sum += share * (ask(&lamps[l], place, normal, true, even_or_not(&lamps[l]), even_or_not(&lamps[l])) +
                            join(&lamps[l], place, normal));
    }
    return sum;
}

static void witness(vector place, vector normal, int side, int batches)
{
    double sum = 0, squares = 0;
    place = add(place, normal, OFF_MM);
    for (int b = 0; b < batches; b++) {
        double mean = 0;
        begin_batch();
        for (path_number = 0; path_number < side * side; path_number++) {
            drawn = 0;
            mean += path(place, normal);
        }
        mean /= (double)side * side;
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / batches, spread = fmax(0, squares / batches - mean * mean);
    printf("%.9g %.3g\n", mean, sqrt(spread / (batches - 1)));
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

static void read_surface(enum kind kind)
{
    struct surface *surface = &surfaces[surface_count++];
    surface->kind = kind;
    surface->center = three();
    if (kind == QUAD) {
        const vector u = three(), v = three();
        surface->normal = unit(cross(u, v));
        surface->u = times(cross(v, surface->normal), 1 / dot(u, cross(v, surface->normal)));
        surface->v = times(cross(u, surface->normal), 1 / dot(v, cross(u, surface->normal)));
    } else if (kind != BALL) {
        surface->normal = unit(three());
    }
    surface->half = kind == TUBE ? number() : 0;
    surface->radius = kind == QUAD ? 0 : number();
    surface->reflectance = number();
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
    lamp->axis = (vector){0, 1, 0};
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
    lamp->radius = shine == GLOBE ? number() : 0;
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
    static const char *const kinds[] = {"quad", "disk", "ball", "tube"};
    static const char *const shines[] = {"point", "spot", "table", "plate", "globe"};
    int place_count = 0, side = 64, batches = 16;
    char word[16];
    while (scanf("%15s", word) == 1) {
        bool is_known = false;
        if (surface_count == MOST || lamp_count == MOST || place_count == MOST)
            return 2;
        for (int k = 0; k < 4; k++)
            if (!strcmp(word, kinds[k])) {
                read_surface((enum kind)k);
                is_known = true;
            }
        for (int k = 0; k < 5; k++)
            if (!strcmp(word, shines[k])) {
                read_lamp((enum shine)k);
                is_known = true;
            }
        if (!strcmp(word, "place")) {
            places[place_count] = three();
            normals[place_count++] = unit(three());
        } else if (!strcmp(word, "work")) {
            side = (int)number();
            batches = (int)number();
            state = (uint64_t)number();
        } else if (!is_known) {
            fprintf(stderr, "witness: unknown word %s\n", word);
            return 2;
        }
    }
    for (int l = 0; l < lamp_count; l++)
        look_round(&lamps[l]);
    for (int p = 0; p < place_count; p++)
        witness(places[p], normals[p], side, batches);
    return 0;
}
