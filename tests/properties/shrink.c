/* SPDX-License-Identifier: MIT */
/* One small step after the other, each kept where the draft still fails; again until no step is left. */
#include "shrink.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_TRIALS = 6000 };

struct shrinking {
    struct draft *draft;
    shrink_fails *fails;
    void *data;
    unsigned trials;
};

/* Takes a simpler draft over if it fails, too. */
static bool take(struct shrinking *shrinking, const struct draft *simpler)
{
    if (shrinking->trials++ >= MOST_TRIALS || !shrinking->fails(simpler, shrinking->data))
        return false;
    *shrinking->draft = *simpler;
    return true;
}

/* ---- parts ---- */

static bool drop_light(struct shrinking *shrinking, size_t i)
{
    struct draft simpler = *shrinking->draft;
    simpler.light_count--;
    memmove(&simpler.lights[i], &simpler.lights[i + 1], (simpler.light_count - i) * sizeof *simpler.lights);
    return take(shrinking, &simpler);
}

static bool drop_surface(struct shrinking *shrinking, size_t i)
{
    struct draft simpler = *shrinking->draft;
    simpler.surface_count--;
    memmove(&simpler.surfaces[i], &simpler.surfaces[i + 1], (simpler.surface_count - i) * sizeof *simpler.surfaces);
    return take(shrinking, &simpler);
}

static bool drop_parts(struct shrinking *shrinking)
{
    bool dropped = false;
    for (size_t i = shrinking->draft->light_count; i-- > 0;)
        dropped |= drop_light(shrinking, i);
    for (size_t i = shrinking->draft->surface_count; i-- > 0 && shrinking->draft->surface_count > 1;)
        dropped |= drop_surface(shrinking, i);
    return dropped;
}

/* ---- words and numbers, each given by its place in the draft ---- */

static bool put_word(struct shrinking *shrinking, size_t offset, unsigned word)
{
    struct draft simpler = *shrinking->draft;
    memcpy((char *)&simpler + offset, &word, sizeof word);
    return take(shrinking, &simpler);
}

static bool shrink_word(struct shrinking *shrinking, size_t offset, unsigned plain)
{
    unsigned word;
    memcpy(&word, (const char *)shrinking->draft + offset, sizeof word);
    if (word <= plain)
        return false;
    return put_word(shrinking, offset, plain) || (word / 2 > plain && put_word(shrinking, offset, word / 2)) ||
           (word - 1 > plain && put_word(shrinking, offset, word - 1));
}

/* The fewest decimal digits that tell a number, and how far its exponent is from 0. */
static unsigned complexity(double value, double plain)
{
    char text[40];
    if (value == plain)
        return 0;
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*e", digits - 1, value);
        if (strtod(text, NULL) == value)
            return 2 + 8 * (unsigned)digits + (unsigned)abs(atoi(strchr(text, 'e') + 1)) + (value < 0);
    }
    return 1000;
}

static bool put_number(struct shrinking *shrinking, size_t offset, double was, double number, double plain)
{
    if (!isfinite(number) || complexity(number, plain) >= complexity(was, plain))
        return false;
    struct draft simpler = *shrinking->draft;
    memcpy((char *)&simpler + offset, &number, sizeof number);
    return take(shrinking, &simpler);
}

static double with_digits(double value, int digits)
{
    char text[40];
    snprintf(text, sizeof text, "%.*e", digits - 1, value);
    return strtod(text, NULL);
}

static bool shrink_number(struct shrinking *shrinking, size_t offset, double plain)
{
    static const int digits[] = {1, 2, 3, 4, 6, 8, 12, 15};
    double was;
    memcpy(&was, (const char *)shrinking->draft + offset, sizeof was);
    if (put_number(shrinking, offset, was, plain, plain) || put_number(shrinking, offset, was, 0, plain) ||
        put_number(shrinking, offset, was, 1, plain) || put_number(shrinking, offset, was, -was, plain))
        return true;
    const double middle = was == 0 ? 0 : copysign(with_digits(pow(10, nearbyint(log10(fabs(was)) / 2)), 1), was);
    if (put_number(shrinking, offset, was, middle, plain))
        return true;
    for (size_t i = 0; i < sizeof digits / sizeof digits[0]; i++)
        if (put_number(shrinking, offset, was, with_digits(was, digits[i]), plain))
            return true;
    return false;
}

/* Goes through a struct of words, or of numbers, beside its plain values. */
static bool shrink_words(struct shrinking *shrinking, size_t offset, const void *plain, size_t size)
{
    bool shrank = false;
    for (size_t at = 0; at < size; at += sizeof(unsigned)) {
        unsigned value;
        memcpy(&value, (const char *)plain + at, sizeof value);
        shrank |= shrink_word(shrinking, offset + at, value);
    }
    return shrank;
}

static bool shrink_numbers(struct shrinking *shrinking, size_t offset, const void *plain, size_t size)
{
    bool shrank = false;
    for (size_t at = 0; at < size; at += sizeof(double)) {
        double value;
        memcpy(&value, (const char *)plain + at, sizeof value);
        shrank |= shrink_number(shrinking, offset + at, value);
    }
    return shrank;
}

static bool shrink_values(struct shrinking *shrinking)
{
    const struct draft *draft = shrinking->draft;
    bool shrank = shrink_words(shrinking, offsetof(struct draft, words), &draft_plain.words, sizeof draft->words);
    shrank |= shrink_numbers(shrinking, offsetof(struct draft, numbers), &draft_plain.numbers, sizeof draft->numbers);
    for (size_t i = 0; i < draft->surface_count; i++) {
        const size_t at = offsetof(struct draft, surfaces) + i * sizeof *draft->surfaces;
        shrank |= shrink_words(shrinking, at + offsetof(struct draft_surface, words), &draft_plain_surface.words,
                               sizeof draft_plain_surface.words);
        shrank |= shrink_numbers(shrinking, at + offsetof(struct draft_surface, numbers), &draft_plain_surface.numbers,
                                 sizeof draft_plain_surface.numbers);
    }
    for (size_t i = 0; i < draft->light_count; i++) {
        const size_t at = offsetof(struct draft, lights) + i * sizeof *draft->lights;
        shrank |= shrink_words(shrinking, at + offsetof(struct draft_light, words), &draft_plain_light.words,
                               sizeof draft_plain_light.words);
        shrank |= shrink_numbers(shrinking, at + offsetof(struct draft_light, numbers), &draft_plain_light.numbers,
                                 sizeof draft_plain_light.numbers);
    }
    const size_t grid = offsetof(struct draft, grid);
    shrank |= shrink_words(shrinking, grid + offsetof(struct draft_grid, words), &draft_plain.grid.words,
                           sizeof draft_plain.grid.words);
    shrank |= shrink_numbers(shrinking, grid + offsetof(struct draft_grid, numbers), &draft_plain.grid.numbers,
                             sizeof draft_plain.grid.numbers);
    return shrank;
}

void shrink(struct draft *draft, shrink_fails *fails, void *data)
{
    struct shrinking shrinking = {.draft = draft, .fails = fails, .data = data};
    bool shrank = true;
    while (shrank && shrinking.trials < MOST_TRIALS) {
        shrank = drop_parts(&shrinking);
        shrank |= shrink_values(&shrinking);
    }
}
