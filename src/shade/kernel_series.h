/* SPDX-License-Identifier: MIT */
/*
 * The polynomial through values at the nodes of a square of pixels, in float64: as a series of Chebyshev's polynomials,
 * of which no more are kept than float32 can tell from 0, and then as powers, which kernel_polynomial.h spreads.
 * kernel.c includes it once.
 */

/*
 * product = left right, of so many rows and columns on the left; of `left` the entry [j][i] stands at
 * left[j * down + i * across].  Rows and vectors go two by two, as one alone would wait for its own results.
 */
LX_LANE void multiply(const double *left, size_t down, size_t across, unsigned size, const double (*right)[LX_LANES],
                      double (*product)[LX_LANES])
{
    for (unsigned j = 0; j < size; j += 2)
        for (unsigned k = 0; k < LX_LANES; k += 2 * LX_WIDTH_double) {
            lanes_double above[2] = {all_double(0), all_double(0)}, below[2] = {above[0], above[0]};
            for (unsigned i = 0; i < size; i++) {
                const double *entry = left + j * down + i * across;
                const lanes_double first = load_double(right[i] + k),
                                   second = load_double(right[i] + k + LX_WIDTH_double);
                above[0] += entry[0] * first, above[1] += entry[0] * second;
                below[0] += entry[down] * first, below[1] += entry[down] * second;
            }
            for (int v = 0; v < 2; v++) {
                store_double(product[j] + k + v * LX_WIDTH_double, above[v]);
                store_double(product[j + 1] + k + v * LX_WIDTH_double, below[v]);
            }
        }
}

/* [degree][power] of Chebyshev's polynomials. */
_Alignas(64) static const double chebyshev[LX_MOST_NODES][LX_LANES] = {
    {1},
    {0, 1},
    {-1, 0, 2},
    {0, -3, 0, 4},
    {1, 0, -8, 0, 8},
    {0, 5, 0, -20, 0, 16},
    {-1, 0, 18, 0, -48, 0, 32},
    {0, -7, 0, 56, 0, -112, 0, 64},
    {1, 0, -32, 0, 160, 0, -256, 0, 128},
    {0, 9, 0, -120, 0, 432, 0, -576, 0, 256},
    {-1, 0, 50, 0, -400, 0, 1120, 0, -1280, 0, 512},
    {0, -11, 0, 220, 0, -1232, 0, 2816, 0, -2816, 0, 1024},
    {1, 0, -72, 0, 840, 0, -3584, 0, 6912, 0, -6144, 0, 2048},
    {0, 13, 0, -364, 0, 2912, 0, -9984, 0, 16640, 0, -13312, 0, 4096},
    {-1, 0, 98, 0, -1568, 0, 9408, 0, -26880, 0, 39424, 0, -28672, 0, 8192},
    {0, -15, 0, 560, 0, -6048, 0, 28800, 0, -70400, 0, 92160, 0, -61440, 0, 16384},
};

/* Adds up in pairs, as one after the other each sum would wait for the one before. */
LX_LANE double sum_of_lanes(const double n[LX_LANES])
{
    _Static_assert(LX_LANES == 16, "all of them are added");
    return (((n[0] + n[8]) + (n[4] + n[12])) + ((n[2] + n[10]) + (n[6] + n[14]))) +
           (((n[1] + n[9]) + (n[5] + n[13])) + ((n[3] + n[11]) + (n[7] + n[15])));
}

/* What there is beyond the first polynomials of a series on each axis, by columns: each size less the next larger. */
struct beyond {
    _Alignas(64) double twelve[LX_LANES], eight[LX_LANES], seven[LX_LANES], six[LX_LANES], none[LX_LANES];
};

LX_LANE void add_row(const double *row, double *sums)
{
    for (unsigned k = 0; k < LX_LANES; k++)
        sums[k] += fabs(row[k]);
}

/*
 * How many polynomials on each axis do for a series, no product of which is larger than 1: the others come to no more
 * than `*rest`, which is too little to count.
 */
LX_LANE unsigned size_of(const double (*series)[LX_LANES], unsigned nodes, double *rest)
{
    _Alignas(64) double rows[LX_LANES] = {0}, row_6[LX_LANES] = {0}, row_7[LX_LANES] = {0}, further[LX_LANES] = {0};
    struct beyond by = {.twelve = {0}};
    for (unsigned l = 0; l < 6; l++)
        add_row(series[l], rows);
    add_row(series[6], row_6);
    add_row(series[7], row_7);
    for (unsigned l = 8; l < nodes; l++)
        add_row(series[l], l < 12 ? further : by.twelve);
    for (unsigned k = 0; k < LX_LANES; k++) {
        const double below = rows[k] + row_6[k] + row_7[k];
        by.twelve[k] += k >= 12 ? below + further[k] : 0;
        by.eight[k] = k < 12 ? further[k] + (k >= 8 ? below : 0) : 0;
        by.seven[k] = k < 8 ? row_7[k] + (k == 7 ? rows[k] + row_6[k] : 0) : 0;
        by.six[k] = k < 7 ? row_6[k] + (k == 6 ? rows[k] : 0) : 0;
        by.none[k] = k < 6 ? rows[k] : 0;
    }
    const double twelve = sum_of_lanes(by.twelve), eight = twelve + sum_of_lanes(by.eight);
    const double seven = eight + sum_of_lanes(by.seven), six = seven + sum_of_lanes(by.six);
    const double most = (double)FLT_EPSILON / 4 * (six + sum_of_lanes(by.none));
    *rest = six <= most ? six : seven <= most ? seven : eight <= most ? eight : twelve <= most ? twelve : 0;
    return six <= most ? 6 : seven <= most ? 7 : eight <= most ? 8 : twelve <= most && nodes > 12 ? 12 : nodes;
}

static double find_polynomial(const double (*series)[LX_LANES], unsigned nodes, const double *values,
                              struct lx_polynomial *polynomial)
{
    _Alignas(64) double across[LX_MOST_NODES][LX_LANES], all[LX_MOST_NODES][LX_LANES], roundings[LX_LANES] = {0}, rest;
    const double(*const halfway)[LX_LANES] = (const double(*)[LX_LANES])across;
    multiply(values, nodes, 1, nodes, series, across);
    multiply(series[0], 1, LX_LANES, nodes, halfway, all);
    const unsigned size = size_of((const double(*)[LX_LANES])all, nodes, &rest);
    const unsigned even = size + size % 2; /* rows of a product */
    if (size < even) {
        memset(all[size], 0, sizeof all[size]);
        for (unsigned l = 0; l < size; l++)
            all[l][size] = 0;
    }
    multiply(all[0], LX_LANES, 1, even, chebyshev, across);
    multiply(chebyshev[0], 1, LX_LANES, even, halfway, all);
    polynomial->size = size <= 8 ? size : size <= 12 ? 12 : LX_MOST_NODES;
    for (unsigned l = 0; l < size; l++)
        for (unsigned k = 0; k < LX_LANES; k++) {
            polynomial->terms[l][k] = (float)all[l][k];
            /* a term is rounded itself, and twice in each of the steps of Horner's that it goes through */
            roundings[k] += (2 * (k + l) + 3) * fabs(all[l][k]);
        }
    return rest + sum_of_lanes(roundings) * ((double)FLT_EPSILON / 2);
}

static void find_roots(double *values, size_t count, double n)
{
    for (size_t i = 0; i < count; i += LX_WIDTH_double)
        store_double(values + i, exp2_of_double(log2_of_double(load_double(values + i), all_double(0)) / n));
}
