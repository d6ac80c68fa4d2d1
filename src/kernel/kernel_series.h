/* SPDX-License-Identifier: MIT */
/*
 * The polynomial through values at the nodes of a square of pixels, in float64: as a series of Chebyshev's polynomials,
 * of which no more are kept than float32 can tell from 0, and then as powers, which kernel_polynomial.h spreads.
 * kernel.c includes it once.
 */

/* Rows, and vectors of each, that products go by: one alone would wait for its own results. */
enum { ROWS_ABREAST = 4, COLUMNS_ABREAST = 2 * LX_WIDTH_double };

/* Some rows of a product, as below; `count` is a constant. */
LX_LANE void multiply_rows(const double *left, size_t down, size_t across, unsigned size, unsigned count,
                           const double (*right)[LX_LANES], unsigned columns, double (*product)[LX_LANES])
{
    for (unsigned k = 0; k < columns; k += COLUMNS_ABREAST) {
        lanes_double sums[ROWS_ABREAST][2];
        LX_UNROLLED
        for (unsigned r = 0; r < count; r++)
            sums[r][0] = sums[r][1] = all_double(0);
        for (unsigned i = 0; i < size; i++) {
            const lanes_double first = load_double(right[i] + k), second = load_double(right[i] + k + LX_WIDTH_double);
            LX_UNROLLED
            for (unsigned r = 0; r < count; r++) {
                const double entry = left[r * down + i * across];
                sums[r][0] += entry * first, sums[r][1] += entry * second;
            }
        }
        LX_UNROLLED
        for (unsigned r = 0; r < count; r++) {
            store_double(product[r] + k, sums[r][0]);
            store_double(product[r] + k + LX_WIDTH_double, sums[r][1]);
        }
    }
    const unsigned done = (columns + COLUMNS_ABREAST - 1) / COLUMNS_ABREAST * COLUMNS_ABREAST;
    for (unsigned r = 0; r < count; r++)
        for (unsigned k = done; k < LX_LANES; k += LX_WIDTH_double)
            store_double(product[r] + k, all_double(0));
}

/*
 * product = left right, of so many rows and columns on the left, an even number; of `left` the entry [j][i] stands at
 * left[j * down + i * across].  On the right all but the first `columns` are 0.
 */
LX_LANE void multiply(const double *left, size_t down, size_t across, unsigned size, const double (*right)[LX_LANES],
                      unsigned columns, double (*product)[LX_LANES])
{
    unsigned j = 0;
    for (; j + ROWS_ABREAST <= size; j += ROWS_ABREAST)
        multiply_rows(left + j * down, down, across, size, ROWS_ABREAST, right, columns, product + j);
    if (j < size)
        multiply_rows(left + j * down, down, across, size, 2, right, columns, product + j);
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

/* Numbers of the columns, for vectors of them. */
_Alignas(64) static const double column_numbers[LX_LANES] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

LX_LANE double sum_of_lanes(lanes_double numbers)
{
    for (int half = LX_WIDTH_double / 2; half > 0; half /= 2) /* in pairs: each sum waits for the one before */
        for (int i = 0; i < half; i++)
            numbers[i] += numbers[i + half];
    return numbers[0];
}

/* Numbers of the columns from `first` on, and of those before, else 0. */
LX_LANE lanes_double from_column(int first, lanes_double column, lanes_double numbers)
{
    return where_above_double(column, all_double(first - 0.5), numbers, all_double(0));
}

LX_LANE lanes_double before_column(int first, lanes_double column, lanes_double numbers)
{
    return where_above_double(column, all_double(first - 0.5), all_double(0), numbers);
}

/* The sums of some rows' magnitudes. */
LX_LANE lanes_double add_rows(const double (*series)[LX_LANES], unsigned first, unsigned end, unsigned k)
{
    lanes_double sums = all_double(0);
    for (unsigned l = first; l < end; l++)
        sums += magnitude_double(load_double(series[l] + k));
    return sums;
}

/*
 * How many polynomials on each axis do for a series, no product of which is larger than 1: the others come to no more
 * than `*rest`, which is too little to count.
 */
LX_LANE unsigned size_of(const double (*series)[LX_LANES], unsigned nodes, double *rest)
{
    /* what there is beyond the first polynomials on each axis: of each size less the next larger */
    lanes_double by_twelve = all_double(0), by_eight = by_twelve, by_seven = by_twelve, by_six = by_twelve;
    lanes_double by_none = by_twelve;
    for (unsigned k = 0; k < LX_LANES; k += LX_WIDTH_double) {
        const lanes_double column = load_double(column_numbers + k);
        const lanes_double rows = add_rows(series, 0, 6, k), row_6 = add_rows(series, 6, 7, k);
        const lanes_double row_7 = add_rows(series, 7, 8, k), below = rows + row_6 + row_7;
        const lanes_double further = add_rows(series, 8, nodes < 12 ? nodes : 12, k);
        by_twelve += add_rows(series, 12, nodes, k) + from_column(12, column, below + further);
        by_eight += before_column(12, column, further + from_column(8, column, below));
        by_seven += before_column(8, column, row_7 + from_column(7, column, rows + row_6));
        by_six += before_column(7, column, row_6 + from_column(6, column, rows));
        by_none += before_column(6, column, rows);
    }
    const double twelve = sum_of_lanes(by_twelve), eight = twelve + sum_of_lanes(by_eight);
    const double seven = eight + sum_of_lanes(by_seven), six = seven + sum_of_lanes(by_six);
    const double most = (double)FLT_EPSILON / 4 * (six + sum_of_lanes(by_none));
    *rest = six <= most ? six : seven <= most ? seven : eight <= most ? eight : twelve <= most ? twelve : 0;
    return six <= most ? 6 : seven <= most ? 7 : eight <= most ? 8 : twelve <= most && nodes > 12 ? 12 : nodes;
}

/* Puts the sum of powers, of so many terms on each axis, in its place; returns what float32 may make it off by. */
LX_LANE double put_terms(const double (*all)[LX_LANES], unsigned size, struct lx_polynomial *polynomial)
{
    lanes_double roundings = all_double(0);
    polynomial->size = size <= 8 ? size : size <= 12 ? 12 : LX_MOST_NODES;
    memset(polynomial->terms[size], 0, (polynomial->size - size) * sizeof polynomial->terms[0]);
    for (unsigned l = 0; l < size; l++) {
        for (unsigned k = 0; k < LX_LANES; k++)
            polynomial->terms[l][k] = (float)all[l][k];
        /* a term is rounded itself, and twice in each of the steps of Horner's that it goes through */
        for (unsigned k = 0; k < LX_LANES; k += LX_WIDTH_double) {
            const lanes_double steps = load_double(column_numbers + k) + (double)l;
            roundings += (2 * steps + 3) * magnitude_double(load_double(all[l] + k));
        }
    }
    return sum_of_lanes(roundings) * ((double)FLT_EPSILON / 2);
}

static double find_polynomial(const double (*series)[LX_LANES], unsigned nodes, const double *values,
                              struct lx_polynomial *polynomial)
{
    _Alignas(64) double across[LX_MOST_NODES][LX_LANES], all[LX_MOST_NODES][LX_LANES], rest;
    const double(*const halfway)[LX_LANES] = (const double(*)[LX_LANES])across;
    multiply(values, nodes, 1, nodes, series, nodes, across);
    multiply(series[0], 1, LX_LANES, nodes, halfway, nodes, all);
    const unsigned size = size_of((const double(*)[LX_LANES])all, nodes, &rest);
    const unsigned even = size + size % 2; /* rows of a product */
    if (size < even) {
        memset(all[size], 0, sizeof all[size]);
        for (unsigned l = 0; l < size; l++)
            all[l][size] = 0;
    }
    multiply(all[0], LX_LANES, 1, even, chebyshev, even, across);
    multiply(chebyshev[0], 1, LX_LANES, even, halfway, even, all);
    return rest + put_terms((const double(*)[LX_LANES])all, size, polynomial);
}

static void find_roots(double *values, size_t count, double n)
{
    for (size_t i = 0; i < count; i += LX_WIDTH_double)
        store_double(values + i, exp2_of_double(log2_of_double(load_double(values + i), all_double(0)) / n));
}
