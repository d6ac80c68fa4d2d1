/* SPDX-License-Identifier: MIT */
/* The simplex method on a condensed table: columns are what is 0, rows what is not. */
#include "linear_program.h"

#include <math.h>

enum { MOST_PIVOTS = 5000, BLAND_AFTER = 1000 };
/* What is no larger counts as 0; conditions are made of numbers about 1. */
static const double LEAST = 1e-11;

/* The column that gains most, or after many steps the first one that gains; `columns`: none does. */
static size_t find_column(const double *gains, const size_t *names, size_t columns, int pivots)
{
    size_t best = columns;
    for (size_t k = 0; k < columns; k++) {
        if (!(gains[k] > LEAST))
            continue;
        if (best == columns || (pivots < BLAND_AFTER ? gains[k] > gains[best] : names[k] < names[best]))
            best = k;
    }
    return best;
}

/* The row that stops the column first; `rows`: none does. */
static size_t find_row(const double *table, const size_t *names, size_t rows, size_t columns, size_t column)
{
    size_t best = rows;
    double least = HUGE_VAL;
    for (size_t i = 0; i < rows; i++) {
        const double *row = &table[i * (columns + 1)];
        if (!(row[column] > LEAST))
            continue;
        const double ratio = row[columns] / row[column];
        if (ratio < least || (!(ratio > least) && names[i] < names[best])) {
            least = ratio;
            best = i;
        }
    }
    return best;
}

/* Exchanges what a row and a column stand for. */
static void pivot(double *table, size_t rows, size_t columns, size_t at, size_t column)
{
    const size_t width = columns + 1;
    double *own = &table[at * width];
    const double by = own[column];
    for (size_t k = 0; k < width; k++)
        own[k] /= k == column ? by * by : by;
    for (size_t i = 0; i <= rows; i++) {
        double *row = &table[i * width];
        const double factor = row[column];
        if (i == at || factor == 0)
            continue;
        for (size_t k = 0; k < width; k++)
            row[k] = k == column ? -factor / by : row[k] - factor * own[k];
    }
}

void lx_linear_program(double *table, size_t rows, size_t columns, const double *gain, size_t *basis, double *x)
{
    size_t *of_rows = basis, *of_columns = basis + rows;
    double *gains = &table[rows * (columns + 1)];
    for (size_t i = 0; i < rows; i++)
        of_rows[i] = columns + i;
    for (size_t k = 0; k < columns; k++) {
        of_columns[k] = k;
        gains[k] = gain[k];
        x[k] = 0;
    }
    for (int pivots = 0; pivots < MOST_PIVOTS; pivots++) {
        const size_t column = find_column(gains, of_columns, columns, pivots);
        const size_t row = column < columns ? find_row(table, of_rows, rows, columns, column) : rows;
        if (row == rows)
            break;
        pivot(table, rows, columns, row, column);
        const size_t name = of_rows[row];
        of_rows[row] = of_columns[column];
        of_columns[column] = name;
    }
    for (size_t i = 0; i < rows; i++)
        if (of_rows[i] < columns)
            x[of_rows[i]] = fmax(table[i * (columns + 1) + columns], 0);
}
