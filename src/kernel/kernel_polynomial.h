/* SPDX-License-Identifier: MIT */
/* Polynomials of two variables over the pixels of a square, in float32; kernel.c includes it once. */

/* Rows, and vectors of each, that go side by side: one vector alone would wait for its own results. */
enum { ROWS = 4, VECTORS = 4 };

/* -1 to 1 over the middles of some pixels. */
LX_LANE float place_in_square(int pixel, float scale)
{
    return (float)(2 * pixel + 1) * scale - 1;
}

/* Raises some vectors side by side to a power; what is below 0 counts as 0.  Not by complements as raise_single() does,
 * which would lose the digits of small numbers: those of a faint foot are all that it is for. */
LX_LANE void raise_all(lanes_single base[VECTORS], unsigned power)
{
    lanes_single product[VECTORS];
    LX_UNROLLED
    for (int v = 0; v < VECTORS; v++) {
        base[v] = greater_single(base[v], all_single(0));
        product[v] = all_single(1);
    }
    for (;; power >>= 1) {
        if (power & 1)
            LX_UNROLLED
        for (int v = 0; v < VECTORS; v++)
            product[v] *= base[v];
        if (power <= 1)
            break;
        LX_UNROLLED
        for (int v = 0; v < VECTORS; v++)
            base[v] *= base[v];
    }
    LX_UNROLLED
    for (int v = 0; v < VECTORS; v++)
        base[v] = product[v];
}

/* Sets values, which need not be aligned, to what is above 0 of vectors side by side, else to 0, or adds that. */
LX_LANE void put(const lanes_single numbers[VECTORS], bool adds, float *values)
{
    LX_UNROLLED
    for (int v = 0; v < VECTORS; v++) {
        lanes_single lanes = greater_single(numbers[v], all_single(0)), before;
        if (adds) {
            memcpy(&before, values + v * LX_WIDTH_single, sizeof before);
            lanes += before;
        }
        memcpy(values + v * LX_WIDTH_single, &lanes, sizeof lanes);
    }
}

/* Puts no more than `count` numbers. */
LX_LANE void put_some(const lanes_single numbers[VECTORS], int count, bool adds, float *values)
{
    if (count >= VECTORS * LX_WIDTH_single) {
        put(numbers, adds, values);
        return;
    }
    _Alignas(64) float room[VECTORS * LX_WIDTH_single] = {0};
    memcpy(room, values, (size_t)count * sizeof *room);
    put(numbers, adds, room);
    memcpy(values, room, (size_t)count * sizeof *room);
}

/* The polynomials of t that some rows are. */
LX_LANE void find_rows(const struct lx_polynomial *polynomial, int size, int first, float scale,
                       float terms[ROWS][LX_LANES])
{
    for (int i = 0; i < size; i += LX_WIDTH_single) {
        lanes_single sum[ROWS];
        LX_UNROLLED
        for (int r = 0; r < ROWS; r++)
            sum[r] = load_single(polynomial->terms[size - 1] + i);
        LX_UNROLLED
        for (int j = size - 2; j >= 0; j--)
            LX_UNROLLED
        for (int r = 0; r < ROWS; r++)
            sum[r] = sum[r] * place_in_square(first + r, scale) + load_single(polynomial->terms[j] + i);
        LX_UNROLLED
        for (int r = 0; r < ROWS; r++)
            store_single(terms[r] + i, sum[r]);
    }
}

LX_LANE void spread(const struct lx_polynomial *polynomial, int size, int rows, int columns, bool adds, float *values,
                    size_t stride)
{
    const float scale = 1 / (float)polynomial->side;
    _Alignas(64) float t[LX_PANEL_SIDE], terms[ROWS][LX_LANES];
    for (int i = 0; i < LX_PANEL_SIDE; i++)
        t[i] = place_in_square(i, scale);
    for (int row = 0; row < rows; row += ROWS) {
        find_rows(polynomial, size, row, scale, terms);
        for (int r = 0; r < ROWS; r += 2)
            for (int column = 0; column < columns; column += VECTORS * LX_WIDTH_single) {
                lanes_single above[VECTORS], below[VECTORS];
                LX_UNROLLED
                for (int v = 0; v < VECTORS; v++)
                    above[v] = all_single(terms[r][size - 1]), below[v] = all_single(terms[r + 1][size - 1]);
                LX_UNROLLED
                for (int i = size - 2; i >= 0; i--)
                    LX_UNROLLED
                for (int v = 0; v < VECTORS; v++) {
                    const lanes_single at = load_single(t + column + v * LX_WIDTH_single);
                    above[v] = above[v] * at + terms[r][i];
                    below[v] = below[v] * at + terms[r + 1][i];
                }
                if (polynomial->power > 1) {
                    raise_all(above, polynomial->power);
                    raise_all(below, polynomial->power);
                }
                float *at = values + (size_t)(row + r) * stride + column;
                if (row + r < rows)
                    put_some(above, columns - column, adds, at);
                if (row + r + 1 < rows)
                    put_some(below, columns - column, adds, at + stride);
            }
    }
}

static void spread_polynomial(const struct lx_polynomial *polynomial, unsigned rows, unsigned columns, bool adds,
                              float *values, size_t stride)
{
    if (polynomial->size <= 6)
        spread(polynomial, 6, (int)rows, (int)columns, adds, values, stride);
    else if (polynomial->size == 7)
        spread(polynomial, 7, (int)rows, (int)columns, adds, values, stride);
    else if (polynomial->size == 8)
        spread(polynomial, 8, (int)rows, (int)columns, adds, values, stride);
    else if (polynomial->size <= 12)
        spread(polynomial, 12, (int)rows, (int)columns, adds, values, stride);
    else
        spread(polynomial, LX_MOST_NODES, (int)rows, (int)columns, adds, values, stride);
}
