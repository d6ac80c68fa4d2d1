/* SPDX-License-Identifier: MIT */
/* Short loops that do nothing but multiply and add, or copy. */
#include "machine.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { CHAINS = 12, STEPS = 200000, RUNS = 7, COPIED = 64 << 20 };

double machine_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The compiler must neither know the numbers nor leave their sum out. */
static volatile float factor = 0.999F, sink;

/* Twelve chains, each in a register of its own, so that none waits for its last result. */
#define EACH_CHAIN(of) of(0) of(1) of(2) of(3) of(4) of(5) of(6) of(7) of(8) of(9) of(10) of(11)
#define BEGIN(k) vector chain##k = by + k;
#define STEP(k) chain##k = chain##k * by + more;
#define END(k) sum += chain##k;

#define PRODUCTS(name, bytes, attributes)                                                                              \
    attributes static void name(void)                                                                                  \
    {                                                                                                                  \
        typedef float vector __attribute__((vector_size(bytes)));                                                      \
        const vector by = (vector){0} + factor, more = by * 0.5F;                                                      \
        vector sum = by;                                                                                               \
        EACH_CHAIN(BEGIN)                                                                                              \
        for (int i = 0; i < STEPS; i++) {                                                                              \
            EACH_CHAIN(STEP)                                                                                           \
        }                                                                                                              \
        EACH_CHAIN(END)                                                                                                \
        sink = sum[0];                                                                                                 \
    }

PRODUCTS(by_16_bytes, 16, )
#if defined __x86_64__
PRODUCTS(by_32_bytes, 32, __attribute__((target("avx2,fma"))))
PRODUCTS(by_64_bytes, 64, __attribute__((target("avx512f"))))
#endif

double machine_products_per_second(const char *instruction_set)
{
    void (*form)(void) = by_16_bytes;
    double width = 16, best = HUGE_VAL;

#if defined __x86_64__
    if (strcmp(instruction_set, "x86-64-v4") == 0)
        form = by_64_bytes, width = 64;
    else if (strcmp(instruction_set, "x86-64-v3") == 0)
        form = by_32_bytes, width = 32;
#else
    (void)instruction_set;
#endif
    for (int run = 0; run < RUNS; run++) {
        const double start = machine_seconds();

        form();
        best = fmin(best, machine_seconds() - start);
    }
    return (double)CHAINS * STEPS * width / sizeof(float) / best;
}

double machine_copied_bytes_per_second(void)
{
    char *from = malloc(COPIED), *to = malloc(COPIED);
    double best = HUGE_VAL;

    if (from && to) {
        memset(from, 1, COPIED);
        memset(to, 2, COPIED);
        for (int run = 0; run < RUNS; run++) {
            const double start = machine_seconds();

            memcpy(to, from, COPIED);
            best = fmin(best, machine_seconds() - start);
            sink = to[run];
        }
    }
    free(from);
    free(to);
    return 2.0 * COPIED / best;
}
