/* SPDX-License-Identifier: MIT */
/*
 * Luminaires over the pixels of a square: polynomials tell what a luminaire would give if it shone evenly, and in which
 * cell of its table each pixel stands, and where in that.  Neighbours mostly stand in one cell, which is loaded once;
 * else each has its own.  kernel.c includes it once, behind kernel_polynomial.h.
 */

/* Vectors that go side by side. */
enum { ABREAST = 2 };

typedef int32_t lane_cells __attribute__((vector_size(LX_VECTOR_BYTES)));

/* Terms of some rows of the polynomials. */
struct tabled_rows {
    _Alignas(64) float brightness[ROWS][LX_LANES];
    _Alignas(64) float polar[ROWS][LX_LANES], azimuth[ROWS][LX_LANES], cosine[ROWS][LX_LANES];
};

/* The polynomial of one row in some vectors. */
LX_LANE void follow_row(const float *terms, int size, const lanes_single at[ABREAST], lanes_single sums[ABREAST])
{
    LX_UNROLLED
    for (int v = 0; v < ABREAST; v++)
        sums[v] = all_single(terms[size - 1]);
    LX_UNROLLED
    for (int i = size - 2; i >= 0; i--)
        LX_UNROLLED
    for (int v = 0; v < ABREAST; v++)
        sums[v] = sums[v] * at[v] + terms[i];
}

/* The cells that all pixels of a square have in common: those that it sees, as numbers of vectors. */
struct tabled_cells {
    const lx_even_cell *cells;
    const float *start, *per_step;
    lanes_single polar_end, polar_last, azimuth_end, azimuth_last; /* from the first one on */
    lanes_single first, first_azimuth, turn, row;                  /* first: of the polar angle */
};

LX_LANE struct tabled_cells tabled_cells_of(const struct lx_tabled *tabled)
{
    return (struct tabled_cells){
        .cells = tabled->cells,
        .start = tabled->start,
        .per_step = tabled->per_step,
        .polar_end = all_single((float)tabled->polar_count),
        .polar_last = all_single((float)(tabled->polar_count - 1)),
        .azimuth_end = all_single((float)tabled->azimuth_count),
        .azimuth_last = all_single((float)(tabled->azimuth_count - 1)),
        .first = all_single((float)tabled->first_polar),
        .first_azimuth = all_single((float)tabled->first_azimuth),
        .turn = all_single((float)tabled->turn),
        .row = all_single((float)tabled->row),
    };
}

/* Cells in which places are, and the share of them that is behind. */
LX_LANE lanes_single share_of(lanes_single place, lanes_single end, lanes_single last, lanes_single *cell)
{
    const lanes_single inside = lesser_single(greater_single(place, all_single(0)), end);
    *cell = __builtin_convertvector(__builtin_convertvector(lesser_single(inside, last), lane_cells), lanes_single);
    return inside - *cell;
}

LX_LANE bool are_one(lanes_single cells)
{
    const lanes_single first = all_single(cells[0]);
    return !any_above_single(cells, first) && !any_above_single(first, cells);
}

/* Four numbers of four cells, number by number. */
typedef float quad __attribute__((vector_size(16)));

LX_LANE void turn_quads(const lx_even_cell *cells, const int32_t *index, quad numbers[4])
{
    quad own[4];
    for (int i = 0; i < 4; i++)
        memcpy(&own[i], cells[index[i]], sizeof own[i]);
    const quad a = __builtin_shufflevector(own[0], own[1], 0, 4, 1, 5);
    const quad b = __builtin_shufflevector(own[2], own[3], 0, 4, 1, 5);
    const quad c = __builtin_shufflevector(own[0], own[1], 2, 6, 3, 7);
    const quad d = __builtin_shufflevector(own[2], own[3], 2, 6, 3, 7);
    numbers[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
    numbers[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
    numbers[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
    numbers[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

/* The four numbers of the cells of all lanes. */
LX_LANE void load_cells(const lx_even_cell *cells, lane_cells index, lanes_single numbers[4])
{
    enum { QUADS = LX_VECTOR_BYTES / 16 };
    _Alignas(LX_VECTOR_BYTES) int32_t indices[LX_WIDTH_single];
    quad quads[QUADS][4];
    memcpy(indices, &index, sizeof indices);
    LX_UNROLLED
    for (int q = 0; q < QUADS; q++)
        turn_quads(cells, indices + 4 * q, quads[q]);
    for (int k = 0; k < 4; k++) {
#if LX_VECTOR_BYTES == 64
        typedef float half __attribute__((vector_size(32)));
        const half low = __builtin_shufflevector(quads[0][k], quads[1][k], 0, 1, 2, 3, 4, 5, 6, 7);
        const half high = __builtin_shufflevector(quads[2][k], quads[3][k], 0, 1, 2, 3, 4, 5, 6, 7);
        numbers[k] =
            __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#elif LX_VECTOR_BYTES == 32
        numbers[k] = __builtin_shufflevector(quads[0][k], quads[1][k], 0, 1, 2, 3, 4, 5, 6, 7);
#else
        numbers[k] = quads[0][k];
#endif
    }
}

/* g of a vector.  There are fewer cells than whole numbers of float32. */
LX_LANE lanes_single tabled_value(const struct tabled_cells *table, bool is_axial, bool by_cosine, lanes_single polar,
                                  lanes_single azimuth, lanes_single cosine)
{
    lanes_single column, row, cell[4];
    lanes_single along = share_of(polar, table->polar_end, table->polar_last, &column), across = all_single(0);
    lanes_single index = column + table->first;
    if (!is_axial) {
        across = share_of(azimuth, table->azimuth_end, table->azimuth_last, &row);
        row += table->first_azimuth;
        row = where_above_single(table->turn, row, row, row - table->turn);
        index += row * table->row;
    }
    const bool is_one = are_one(index);
    if (by_cosine) {
        lanes_single start, per_step;
        if (is_one) {
            const size_t j = (size_t)column[0];
            start = all_single(table->start[j]), per_step = all_single(table->per_step[j]);
        } else {
            for (int lane = 0; lane < LX_WIDTH_single; lane++) {
                const size_t j = (size_t)column[lane];
                start[lane] = table->start[j], per_step[lane] = table->per_step[j];
            }
        }
        along = (cosine - start) * per_step;
    }
    if (is_one) {
        const float *own = table->cells[(size_t)index[0]];
        LX_UNROLLED
        for (int k = 0; k < 4; k++)
            cell[k] = all_single(own[k]);
    } else {
        load_cells(table->cells, __builtin_convertvector(index, lane_cells), cell);
    }
    const lanes_single near = cell[0] + along * cell[1];
    return is_axial ? near : near + across * (cell[2] + along * cell[3]);
}

LX_LANE void spread_rows(const struct lx_tabled *tabled, int size, bool is_axial, bool by_cosine, int rows, int columns,
                         float *values, size_t stride)
{
    const float scale = 1 / (float)tabled->brightness.side;
    const struct tabled_cells table = tabled_cells_of(tabled);
    _Alignas(64) float t[LX_PANEL_SIDE];
    struct tabled_rows terms;
    for (int i = 0; i < LX_PANEL_SIDE; i++)
        t[i] = place_in_square(i, scale);
    for (int row = 0; row < rows; row += ROWS) {
        find_rows(&tabled->brightness, size, row, scale, terms.brightness);
        find_rows(&tabled->polar, size, row, scale, terms.polar);
        if (!is_axial)
            find_rows(&tabled->azimuth, size, row, scale, terms.azimuth);
        if (by_cosine)
            find_rows(&tabled->cosine, size, row, scale, terms.cosine);
        for (int r = 0; r < ROWS && row + r < rows; r++)
            for (int column = 0; column < columns; column += ABREAST * LX_WIDTH_single) {
                lanes_single at[ABREAST], brightness[ABREAST], polar[ABREAST], azimuth[ABREAST], cosine[ABREAST];
                LX_UNROLLED
                for (int v = 0; v < ABREAST; v++)
                    at[v] = load_single(t + column + v * LX_WIDTH_single), azimuth[v] = cosine[v] = all_single(0);
                follow_row(terms.brightness[r], size, at, brightness);
                follow_row(terms.polar[r], size, at, polar);
                if (!is_axial)
                    follow_row(terms.azimuth[r], size, at, azimuth);
                if (by_cosine)
                    follow_row(terms.cosine[r], size, at, cosine);
                LX_UNROLLED
                for (int v = 0; v < ABREAST; v++)
                    brightness[v] *= tabled_value(&table, is_axial, by_cosine, polar[v], azimuth[v], cosine[v]);
                float *to = values + (size_t)(row + r) * stride + column;
                _Alignas(64) float room[ABREAST * LX_WIDTH_single] = {0};
                const bool is_whole = columns - column >= ABREAST * LX_WIDTH_single;
                float *at_once = is_whole ? to : room;
                if (!is_whole)
                    memcpy(room, to, (size_t)(columns - column) * sizeof *room);
                LX_UNROLLED
                for (int v = 0; v < ABREAST; v++) {
                    lanes_single sum;
                    memcpy(&sum, at_once + v * LX_WIDTH_single, sizeof sum);
                    sum += greater_single(brightness[v], all_single(0));
                    memcpy(at_once + v * LX_WIDTH_single, &sum, sizeof sum);
                }
                if (!is_whole)
                    memcpy(to, room, (size_t)(columns - column) * sizeof *room);
            }
    }
}

/* With LX_FEW_KERNELS one loop does for all, which takes less room for the same numbers. */
#ifdef LX_FEW_KERNELS
static void spread_tabled(const struct lx_tabled *tabled, unsigned rows, unsigned columns, float *values, size_t stride)
{
    const int size = (int)tabled->size;
    spread_rows(tabled, size, tabled->is_axial, tabled->by_cosine, (int)rows, (int)columns, values, stride);
}
#else
/* Functions of their own for each size: compilers take much longer for one that holds them all. */
#define LX_SPREAD(size)                                                                                                \
    static __attribute__((noinline)) void spread_rows_##size(const struct lx_tabled *tabled, int rows, int columns,    \
                                                             float *values, size_t stride)                             \
    {                                                                                                                  \
        if (tabled->is_axial && !tabled->by_cosine)                                                                    \
            spread_rows(tabled, size, true, false, rows, columns, values, stride);                                     \
        else if (tabled->is_axial)                                                                                     \
            spread_rows(tabled, size, true, true, rows, columns, values, stride);                                      \
        else if (!tabled->by_cosine)                                                                                   \
            spread_rows(tabled, size, false, false, rows, columns, values, stride);                                    \
        else                                                                                                           \
            spread_rows(tabled, size, false, true, rows, columns, values, stride);                                     \
    }
LX_SPREAD(6)
LX_SPREAD(8)
LX_SPREAD(12)
LX_SPREAD(16)
#undef LX_SPREAD

static void spread_tabled(const struct lx_tabled *tabled, unsigned rows, unsigned columns, float *values, size_t stride)
{
    if (tabled->size <= 6)
        spread_rows_6(tabled, (int)rows, (int)columns, values, stride);
    else if (tabled->size <= 8)
        spread_rows_8(tabled, (int)rows, (int)columns, values, stride);
    else if (tabled->size <= 12)
        spread_rows_12(tabled, (int)rows, (int)columns, values, stride);
    else
        spread_rows_16(tabled, (int)rows, (int)columns, values, stride);
}
#endif
