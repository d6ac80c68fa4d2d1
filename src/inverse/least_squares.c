/* SPDX-License-Identifier: MIT */
/* A small dense least squares solver: reflections, then rotations. */
#include "least_squares.h"

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"

enum { MOST_SWEEPS = 60 };

bool lx_least_squares_make(size_t columns, struct lx_least_squares *squares)
{
    double *const all = lx_new_array(3 * columns + 2 * columns * columns + 1, sizeof *all);
    *squares = (struct lx_least_squares){.columns = columns, .scale = all};
    if (!all)
        return false;
    squares->right = all + columns;
    squares->singular = all + 2 * columns;
    squares->rotated = all + 3 * columns;
    squares->v = squares->rotated + columns * columns;
    return true;
}

void lx_least_squares_clear(struct lx_least_squares *squares)
{
    free(squares->scale);
    *squares = (struct lx_least_squares){.columns = 0};
}

static double product(const double *a, const double *b, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Takes from a column what it has along a direction: twice that by its square, so that it is reflected. */
static void reflect(const double *direction, double square, double *column, size_t count)
{
    const double share = 2.0 * product(direction, column, count) / square;
    for (size_t i = 0; i < count; i++)
        column[i] -= share * direction[i];
}

/* Makes of a column the direction of the reflection that leaves only its first number, which is returned. */
static double make_direction(double *column, size_t count)
{
    const double first = -copysign(sqrt(product(column, column, count)), column[0]);
    column[0] -= first;
    return first;
}

static void triangulate(struct lx_least_squares *squares, double *a, double *b, size_t rows)
{
    const size_t n = squares->columns;
    for (size_t k = 0; k < n; k++) {
        double *direction = &a[k * rows + k];
        const double diagonal = make_direction(direction, rows - k);
        const double square = product(direction, direction, rows - k);
        for (size_t j = k + 1; square > 0.0 && j < n; j++)
            reflect(direction, square, &a[j * rows + k], rows - k);
        if (square > 0.0)
            reflect(direction, square, &b[k], rows - k);
        for (size_t i = 0; i < n; i++)
            squares->rotated[k * n + i] = i < k ? a[k * rows + i] : i == k ? diagonal : 0.0;
        squares->right[k] = b[k];
    }
}

static void rotate(double *p, double *q, size_t count, double c, double s)
{
    for (size_t i = 0; i < count; i++) {
        const double old = p[i];
        p[i] = c * old - s * q[i];
        q[i] = s * old + c * q[i];
    }
}

/* Makes two columns perpendicular; false: they were. */
static bool turn(struct lx_least_squares *squares, size_t i, size_t j)
{
    const size_t n = squares->columns;
    double *p = &squares->rotated[i * n], *q = &squares->rotated[j * n];
    const double a = product(p, p, n), b = product(q, q, n), c = product(p, q, n);
    if (fabs(c) <= 0x1p-52 * sqrt(a * b) || c == 0.0)
        return false;
    const double zeta = (b - a) / (2.0 * c);
    const double t = copysign(1.0, zeta) / (fabs(zeta) + hypot(1.0, zeta)), cosine = 1.0 / hypot(1.0, t);
    rotate(p, q, n, cosine, cosine * t);
    rotate(&squares->v[i * n], &squares->v[j * n], n, cosine, cosine * t);
    return true;
}

static void swap_columns(struct lx_least_squares *squares, size_t i, size_t j)
{
    rotate(&squares->rotated[i * squares->columns], &squares->rotated[j * squares->columns], squares->columns, 0, 1);
    rotate(&squares->v[i * squares->columns], &squares->v[j * squares->columns], squares->columns, 0, 1);
}

void lx_least_squares_solve(struct lx_least_squares *squares, double *a, double *b, size_t rows, const double *least,
                            bool is_scaled)
{
    const size_t n = squares->columns;
    for (size_t j = 0; j < n; j++) {
        double *column = &a[j * rows];
        const double length = sqrt(product(column, column, rows));
        const bool is_none = !(length > (least ? least[j] : 0.0));
        squares->scale[j] = is_none || !is_scaled ? 1.0 : length;
        for (size_t i = 0; i < rows; i++)
            column[i] = is_none ? 0.0 : column[i] / squares->scale[j];
    }
    triangulate(squares, a, b, rows);
    for (size_t i = 0; i < n * n; i++)
        squares->v[i] = i % (n + 1) == 0 ? 1.0 : 0.0;
    bool is_turning = true;
    for (unsigned sweep = 0; is_turning && sweep < MOST_SWEEPS; sweep++) {
        is_turning = false;
        for (size_t i = 0; i < n; i++)
            for (size_t j = i + 1; j < n; j++)
                is_turning = turn(squares, i, j) || is_turning;
    }
    for (size_t i = 0; i < n; i++) {
        squares->singular[i] = sqrt(product(&squares->rotated[i * n], &squares->rotated[i * n], n));
        for (size_t j = i; j > 0 && squares->singular[j] > squares->singular[j - 1]; j--) {
            const double value = squares->singular[j];
            squares->singular[j] = squares->singular[j - 1];
            squares->singular[j - 1] = value;
            swap_columns(squares, j - 1, j);
        }
    }
}

size_t lx_least_squares_rank(const struct lx_least_squares *squares, double tolerance)
{
    size_t rank = 0;
    while (rank < squares->columns && squares->singular[rank] > tolerance * squares->singular[0])
        rank++;
    return rank;
}

void lx_least_squares_step(const struct lx_least_squares *squares, double damping, double tolerance, double *step)
{
    const size_t n = squares->columns, rank = lx_least_squares_rank(squares, tolerance);
    for (size_t i = 0; i < n; i++)
        step[i] = 0.0;
    for (size_t j = 0; j < rank; j++) {
        const double along = product(&squares->rotated[j * n], squares->right, n) /
                             (squares->singular[j] * squares->singular[j] + damping);
        for (size_t i = 0; i < n; i++)
            step[i] += along * squares->v[j * n + i] / squares->scale[i];
    }
}

double lx_least_squares_covariance(const struct lx_least_squares *squares, size_t rank, size_t i, size_t j)
{
    const size_t n = squares->columns;
    double sum = 0.0;
    for (size_t k = 0; k < rank; k++)
        sum += squares->v[k * n + i] * squares->v[k * n + j] / (squares->singular[k] * squares->singular[k]);
    return sum / (squares->scale[i] * squares->scale[j]);
}
