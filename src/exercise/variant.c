/* SPDX-License-Identifier: MIT */
/*
 * Numbered variants of the exercise: scenes of one sphere and one or two point sources, all numbers round and within
 * the exercise's ranges, with one peak that stands out and five points that show something.
 *
 * The number seeds a generator that draws whole numbers, and what was drawn is looked at until it is good.  Looking
 * takes only sums, products, quotients and square roots, which every machine rounds alike, so that a number means the
 * same variant everywhere and for ever: whoever changes anything here changes the exercises that students have in hand.
 */
#include <math.h>
#include <stdint.h>

#include <luxel/exercise.h>

#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../base/text.h"

/* Every number from 1 to LUXEL_LAST_VARIANT has been tried: none needs as many draws. */
enum { MOST_DRAWS = 4096, MOST_SOURCES = 2 };

struct source {
    int place_mm[3];
    int intensity_w_sr;
};

/* What a variant consists of, in whole numbers. */
struct variant {
    int pixel_half_mm; /* a pixel's side in halves of a millimetre */
    int columns, rows;
    int center_mm[3], radius_mm, step_mm; /* the four outer points lie so far from the centre, or less: */
    int steps_mm[4];                      /* to the right and left, up and down */
    int observer_mm;
    int diffuse_percent, specular_percent, shininess;
    int source_count;
    struct source sources[MOST_SOURCES];
};

/* SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014). */
static uint64_t next_bits(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* low, low + step ... up to high at most; low where there is nothing between. */
static int draw(uint64_t *state, int low, int high, int step)
{
    uint64_t bits = next_bits(state) >> 32;
    if (high < low)
        return low;
    return low + step * (int)(bits % (uint64_t)((high - low) / step + 1));
}

static int draw_of(uint64_t *state, const int *list, size_t count)
{
    return list[draw(state, 0, (int)count - 1, 1)];
}

#define DRAW_OF(state, ...) draw_of(state, (const int[]){__VA_ARGS__}, sizeof(int[]){__VA_ARGS__} / sizeof(int))

/* Up to a multiple of step. */
static int round_up(int value, int step)
{
    return (value + step - 1) / step * step;
}

static void draw_geometry(uint64_t *state, struct variant *v)
{
    v->pixel_half_mm = DRAW_OF(state, 2, 3, 4, 5, 6, 8);
    v->columns = draw(state, 300, 800, 100);
    int fewest = round_up(v->columns * 3 / 5, 100);
    v->rows = draw(state, fewest < 300 ? 300 : fewest, v->columns, 100);
    int half_width = v->columns * v->pixel_half_mm / 4, half_height = v->rows * v->pixel_half_mm / 4;
    v->radius_mm = draw(state, round_up(half_height / 2, 50), half_height * 9 / 10, 50);
    int room[2] = {half_width * 19 / 20 - v->radius_mm, half_height * 19 / 20 - v->radius_mm};
    bool centred = draw(state, 0, 1, 1) == 0;
    for (int i = 0; i < 2; i++) {
        int most = centred || room[i] < 50 ? 0 : room[i] / 50 * 50;
        v->center_mm[i] = draw(state, -most, most, 50);
    }
    v->center_mm[2] = draw(state, round_up(v->radius_mm + 300, 100), round_up(v->radius_mm + 1500, 100), 100);
    v->observer_mm =
        round_up(v->center_mm[2] + v->radius_mm + 200, 100) + DRAW_OF(state, 0, 100, 200, 300, 500, 800, 1000);
    int inner = round_up(v->radius_mm * 2 / 5, 50), outer = v->radius_mm * 3 / 4 / 50 * 50;
    v->step_mm = draw(state, inner, outer, 50);
}

static void draw_material(uint64_t *state, struct variant *v)
{
    v->diffuse_percent = draw(state, 30, 90, 5);
    v->specular_percent = draw(state, 25, 90, 5);
    v->shininess = DRAW_OF(state, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100);
}

static void draw_sources(uint64_t *state, struct variant *v, int count)
{
    v->source_count = count;
    for (int i = 0; i < count; i++) {
        struct source *source = &v->sources[i];
        for (int axis = 0; axis < 2; axis++)
            source->place_mm[axis] = draw(state, -5000, 5000, 100);
        source->place_mm[2] = draw(state, v->center_mm[2] + 200, v->center_mm[2] + 5000, 100);
        source->intensity_w_sr =
            DRAW_OF(state, 2, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100, 120, 150, 200);
    }
}

/* From the centre of the sphere: at least so many radii away, and neither almost overhead nor almost level with it. */
static bool stands_well(const struct variant *v, const struct source *source)
{
    double square = 0, height = source->place_mm[2] - v->center_mm[2], radius = v->radius_mm;
    for (int i = 0; i < 3; i++) {
        double along = source->place_mm[i] - v->center_mm[i];
        square += along * along;
    }
    return square >= 6.25 * radius * radius && height * height >= 0.09 * square && height * height <= 0.9 * square;
}

static double power(double base, int exponent)
{
    double result = 1;
    for (; exponent > 0; exponent /= 2, base *= base)
        if (exponent % 2 == 1)
            result *= base;
    return result;
}

struct light {
    double diffuse, specular;
};

/* The published formula at the element with the normal n, seen along z. */
static struct light shade(const struct variant *v, const double n[3])
{
    struct light sum = {0, 0};
    for (int s = 0; s < v->source_count; s++) {
        const struct source *source = &v->sources[s];
        double l[3], square = 0, cosine = 0;
        for (int i = 0; i < 3; i++) {
            l[i] = source->place_mm[i] - (v->center_mm[i] + v->radius_mm * n[i]);
            square += l[i] * l[i];
        }
        double r = sqrt(square);
        for (int i = 0; i < 3; i++) {
            l[i] /= r;
            cosine += l[i] * n[i];
        }
        double h = cosine + n[2], length = sqrt(2 + 2 * l[2]);
        if (cosine > 0)
            sum.diffuse += source->intensity_w_sr * (v->diffuse_percent / 100.0) * cosine;
        if (h > 0)
            sum.specular += source->intensity_w_sr * (v->specular_percent / 100.0) * power(h / length, v->shininess);
    }
    return sum;
}

/* The normal of what is seen at x, y, in radii from the centre of the disk; false off it. */
static bool normal_at(double x, double y, double n[3])
{
    double square = x * x + y * y;
    n[0] = x, n[1] = y, n[2] = square < 1 ? sqrt(1 - square) : 0;
    return square < 1;
}

/* The five points: at least three, the middle one among them, take part in what is seen. */
static bool points_show(const struct variant *v, double maximum)
{
    static const int ways[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int bright = 0;
    for (int i = 0; i < 5; i++) {
        double n[3], step = (double)v->step_mm / v->radius_mm;
        normal_at(step * ways[i][0], step * ways[i][1], n);
        struct light light = shade(v, n);
        bool shows = light.diffuse + light.specular >= 0.08 * maximum;
        if (i == 0 && !shows)
            return false;
        bright += shows;
    }
    return bright >= 3;
}

/*
 * Draws the outer points in until they show something: at least a two-hundredth of the maximum, and all but one, at
 * most, the light of a source that they face rather than the tail of a highlight.  False: they do not.
 */
static bool place_points(struct variant *v, double maximum)
{
    static const int ways[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int dark = 0;
    for (int i = 0; i < 4; i++) {
        bool found = false;
        for (int step = v->step_mm; step > 0 && !found; step -= 10) {
            double n[3], share = (double)step / v->radius_mm;
            normal_at(share * ways[i][0], share * ways[i][1], n);
            struct light light = shade(v, n);
            bool is_dark = !(light.diffuse > 0);
            found = light.diffuse + light.specular >= 0.005 * maximum && dark + is_dark <= 1;
            dark += found && is_dark;
            v->steps_mm[i] = step;
        }
        if (!found)
            return false;
    }
    return true;
}

/*
 * Whether there is one pronounced peak in view: the highest place lies well inside the disk, the highlight raises it
 * well over all diffuse light, it is much brighter than the mean, and nothing away from it comes near to it.
 */
static bool is_pronounced(struct variant *v)
{
    enum { STEPS = 24 }; /* of the radius */
    double maximum = 0, diffuse = 0, sum = 0, away = 0, values[2 * STEPS + 1][2 * STEPS + 1], n[3];
    int best[2] = {0, 0}, count = 0;
    for (int j = -STEPS; j <= STEPS; j++)
        for (int i = -STEPS; i <= STEPS; i++) {
            double *value = &values[j + STEPS][i + STEPS];
            *value = 0;
            if (!normal_at((double)i / STEPS, (double)j / STEPS, n))
                continue;
            struct light light = shade(v, n);
            *value = light.diffuse + light.specular;
            diffuse = light.diffuse > diffuse ? light.diffuse : diffuse;
            sum += *value;
            count++;
            if (*value > maximum) {
                maximum = *value;
                best[0] = i, best[1] = j;
            }
        }
    int from_centre = best[0] * best[0] + best[1] * best[1];
    if (from_centre * 16 < STEPS * STEPS || from_centre * 16 > 9 * STEPS * STEPS) /* a quarter to three quarters */
        return false;
    if (maximum < 1.3 * diffuse || maximum * count < 2.2 * sum)
        return false;
    for (int j = -STEPS; j <= STEPS; j++)
        for (int i = -STEPS; i <= STEPS; i++) {
            int x = i - best[0], y = j - best[1];
            if (25 * (x * x + y * y) >= 4 * STEPS * STEPS && values[j + STEPS][i + STEPS] > away) /* 0.4 radii */
                away = values[j + STEPS][i + STEPS];
        }
    return away <= 0.9 * maximum && points_show(v, maximum) && place_points(v, maximum);
}

/* Two sources must stand at least some 41 degrees apart as the sphere sees them, and neither may drown the other. */
static bool are_different(const struct variant *v)
{
    const struct source *one = &v->sources[0], *two = &v->sources[1];
    double dot = 0, square_one = 0, square_two = 0;
    if (v->source_count < 2)
        return true;
    for (int i = 0; i < 3; i++) {
        double a = one->place_mm[i] - v->center_mm[i], b = two->place_mm[i] - v->center_mm[i];
        dot += a * b;
        square_one += a * a;
        square_two += b * b;
    }
    return (dot <= 0 || 16 * dot * dot <= 9 * square_one * square_two) &&
           3 * one->intensity_w_sr >= two->intensity_w_sr && 3 * two->intensity_w_sr >= one->intensity_w_sr;
}

/* Every third variant has two sources. */
static struct variant find_variant(unsigned number)
{
    uint64_t state = UINT64_C(0x4c7578656c) + number * UINT64_C(0xd1342543de82ef95);
    struct variant v = {0};
    for (int i = 0; i < MOST_DRAWS; i++) {
        draw_geometry(&state, &v);
        draw_material(&state, &v);
        draw_sources(&state, &v, number % 3 == 0 ? 2 : 1);
        bool stand_well = true;
        for (int s = 0; s < v.source_count; s++)
            stand_well = stand_well && stands_well(&v, &v.sources[s]);
        if (stand_well && are_different(&v) && is_pronounced(&v))
            break;
    }
    return v;
}

static const char *write_percent(int percent, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_number(percent / 100.0, buffer);
}

static void write_scene(struct lx_text *text, const struct variant *v)
{
    char diffuse[LX_NUMBER_SIZE], specular[LX_NUMBER_SIZE];
    lx_text_printf(text, "luxel: 1\nunits: radiometric\n");
    lx_text_printf(text, "screen: {width: %d, height: %d, resolution: [%d, %d], sampling: nodes}\n",
                   v->columns * v->pixel_half_mm / 2, v->rows * v->pixel_half_mm / 2, v->columns, v->rows);
    lx_text_printf(text, "observer: {z: %d, projection: orthographic, view: parallel}\n", v->observer_mm);
    lx_text_printf(text, "surfaces:\n  - type: sphere\n    center: [%d, %d, %d]\n    radius: %d\n", v->center_mm[0],
                   v->center_mm[1], v->center_mm[2], v->radius_mm);
    lx_text_printf(text,
                   "    material: {model: blinn-phong, diffuse: %s, specular: %s, shininess: %d, highlight: plain, "
                   "over_pi: false}\n",
                   write_percent(v->diffuse_percent, diffuse), write_percent(v->specular_percent, specular),
                   v->shininess);
    lx_text_puts(text, "lights:\n");
    for (int i = 0; i < v->source_count; i++) {
        const struct source *source = &v->sources[i];
        lx_text_printf(text,
                       "  - {type: point, position: [%d, %d, %d], intensity: %d, pattern: isotropic, attenuation: "
                       "none}\n",
                       source->place_mm[0], source->place_mm[1], source->place_mm[2], source->intensity_w_sr);
    }
    const int x = v->center_mm[0], y = v->center_mm[1], *steps = v->steps_mm;
    lx_text_printf(text, "points: [[%d, %d], [%d, %d], [%d, %d], [%d, %d], [%d, %d]]\n", x, y, x + steps[0], y,
                   x - steps[1], y, x, y + steps[2], x, y - steps[3]);
    lx_text_puts(text, "picture: {range: max, rounding: truncate}\n");
}

luxel_status luxel_variant_text(unsigned number, luxel_diagnostics *diagnostics, char **text)
{
    if (number < 1 || number > LUXEL_LAST_VARIANT) {
        char given[LX_NUMBER_SIZE], last[LX_NUMBER_SIZE];
        return lx_refuse(diagnostics, LX_MSG_NO_VARIANT,
                         LX_ARGS(lx_write_number(number, given), lx_write_number(LUXEL_LAST_VARIANT, last)));
    }
    struct variant v = find_variant(number);
    struct lx_text written = {0};
    lx_text_printf(
        &written,
        "# Variant %u: the brightness of a sphere\n"
        "# By the rules of the published solution: the sources shine the same in all directions and are not\n"
        "# attenuated by the distance, the highlight is seen along z, values are those of the exact points.\n",
        number);
    write_scene(&written, &v);
    char *made = lx_text_take(&written);
    if (!made)
        return lx_out_of_memory(diagnostics);
    *text = made;
    return LUXEL_OK;
}
