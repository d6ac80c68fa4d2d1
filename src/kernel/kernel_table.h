/* SPDX-License-Identifier: MIT */
/*
 * Luminaires in one precision: g of the distribution of a photometry file (light/distribution.h), by the two angles of
 * each direction.  The elements of a vector see a luminaire under nearly the same angle, so most often one cell of the
 * table does for all of them and its corners are loaded once; else each element's cell is looked up by itself.  Both
 * ways end in the same formula, so an element's bytes do not depend on its neighbours.
 *
 * kernel.c includes it once for each precision, behind lanes.h and kernel_functions.h.
 */

/* A cell of the table for each element: where it begins, 1 over its steps, and the values at its corners. */
struct NAME(table_cells) {
    NAME(lanes) polar, per_polar, south, azimuth, per_azimuth; /* south: 1 where the versine is from the other pole */
    NAME(lanes) near[2], far[2];                               /* at the first and at the second azimuth */
};

/* The angle, 0 to pi, of the point (along, beside), beside >= 0, at the distance `whole` from the origin. */
LX_LANE NAME(lanes) NAME(angle_at)(NAME(lanes) beside, NAME(lanes) along, NAME(lanes) whole)
{
    const NAME(lanes) least = NAME(all)((REAL)1e-18), zero = NAME(all)(0);
    const NAME(lanes) size = NAME(greater)(along, -along);
    const NAME(lanes) angle = NAME(angle_of_half_tangent)(beside * NAME(inverse)(NAME(greater)(whole + size, least)));
    return NAME(where_above)(zero, along, (REAL)M_PI - angle, angle);
}

/* The cell of an angle. */
static inline uint32_t NAME(find_cell)(const struct NAME(lx_lines) * lines, REAL angle)
{
    const REAL bucket = (angle - lines->start) * lines->per_radian;
    uint32_t cell = lines->first[bucket > 0 ? (bucket < (REAL)lines->last ? (uint32_t)bucket : lines->last) : 0];
    while (cell > 0 && angle < lines->edge[cell])
        cell--;
    while (angle >= lines->edge[cell + 1])
        cell++;
    return cell;
}

LX_LANE bool NAME(are_in_cell)(const struct NAME(lx_lines) * lines, uint32_t cell, NAME(lanes) angles)
{
    return !NAME(any_above)(NAME(all)(lines->edge[cell]), angles) &&
           NAME(all_above)(NAME(all)(lines->edge[cell + 1]), angles);
}

/* One cell for all elements. */
LX_LANE struct NAME(table_cells) NAME(same_cell)(const struct NAME(lx_table) * table, uint32_t i, uint32_t j)
{
    const size_t row = (size_t)table->polar.cells + 1;
    const REAL *corner = table->values + i * row + j;
    struct NAME(table_cells) cells = {
        .polar = NAME(all)(table->polar.line[j]),
        .per_polar = NAME(all)(table->polar.per_step[j]),
        .south = NAME(all)(j >= table->south ? 1 : 0),
        .azimuth = NAME(all)(table->azimuth.line[i]),
        .per_azimuth = NAME(all)(table->azimuth.per_step[i]),
    };
    for (size_t k = 0; k < 2; k++) {
        cells.near[k] = NAME(all)(corner[k]);
        cells.far[k] = NAME(all)(corner[row + k]);
    }
    return cells;
}

/* A cell for each element. */
static inline struct NAME(table_cells)
    NAME(each_cell)(const struct NAME(lx_table) * table, NAME(lanes) azimuth, NAME(lanes) polar)
{
    enum { POLAR, PER_POLAR, SOUTH, AZIMUTH, PER_AZIMUTH, NEAR, FAR = NEAR + 2, ALL = FAR + 2 };
    _Alignas(LX_VECTOR_BYTES) REAL numbers[ALL][NAME(LX_WIDTH)];
    const size_t row = (size_t)table->polar.cells + 1;
    for (int lane = 0; lane < NAME(LX_WIDTH); lane++) {
        const uint32_t i = table->is_axial ? 0 : NAME(find_cell)(&table->azimuth, azimuth[lane]);
        const uint32_t j = NAME(find_cell)(&table->polar, polar[lane]);
        const REAL *corner = table->values + i * row + j;
        numbers[POLAR][lane] = table->polar.line[j];
        numbers[PER_POLAR][lane] = table->polar.per_step[j];
        numbers[SOUTH][lane] = j >= table->south ? 1 : 0;
        numbers[AZIMUTH][lane] = table->azimuth.line[i];
        numbers[PER_AZIMUTH][lane] = table->azimuth.per_step[i];
        for (size_t k = 0; k < 2; k++) {
            numbers[NEAR + k][lane] = corner[k];
            numbers[FAR + k][lane] = corner[row + k];
        }
    }
    return (struct NAME(table_cells)){
        .polar = NAME(load)(numbers[POLAR]),
        .per_polar = NAME(load)(numbers[PER_POLAR]),
        .south = NAME(load)(numbers[SOUTH]),
        .azimuth = NAME(load)(numbers[AZIMUTH]),
        .per_azimuth = NAME(load)(numbers[PER_AZIMUTH]),
        .near = {NAME(load)(numbers[NEAR]), NAME(load)(numbers[NEAR + 1])},
        .far = {NAME(load)(numbers[FAR]), NAME(load)(numbers[FAR + 1])},
    };
}

#if LX_IS_SINGLE
typedef int32_t NAME(lane_numbers) __attribute__((vector_size(LX_VECTOR_BYTES)));
#else
typedef int64_t NAME(lane_numbers) __attribute__((vector_size(LX_VECTOR_BYTES)));
#endif

/* Where directions are: the shares of their cells that are behind them, and the values at the corners. */
struct NAME(table_place) {
    NAME(lanes) along, across; /* of the polar angle, of the azimuth */
    NAME(lanes) near[2], far[2];
};

/* The cells of angles, as numbers of both kinds, where all are alike; and the share that is behind them. */
LX_LANE NAME(lanes) NAME(even_share)(const struct NAME(lx_lines) * lines, NAME(lanes) angle, NAME(lane_numbers) * cell,
                                     NAME(lanes) * whole)
{
    const NAME(lanes) place = NAME(greater)((angle - lines->start) * lines->even, NAME(all)(0));
    const NAME(lanes) last = NAME(all)((REAL)lines->cells - 1);
    *cell = __builtin_convertvector(NAME(lesser)(place, last), NAME(lane_numbers));
    *whole = __builtin_convertvector(*cell, NAME(lanes));
    return NAME(lesser)(place, last + 1) - *whole;
}

LX_LANE bool NAME(are_alike)(NAME(lanes) whole)
{
    const NAME(lanes) first = NAME(all)(whole[0]);
    return !NAME(any_above)(whole, first) && !NAME(any_above)(first, whole);
}

/* The place in a table whose cells are all alike: they are counted, and only their corners are looked up. */
LX_LANE struct NAME(table_place)
    NAME(even_place)(const struct NAME(lx_table) * table, NAME(lanes) azimuth, NAME(lanes) polar)
{
    const size_t row = (size_t)table->polar.cells + 1;
    struct NAME(table_place) at = {.across = NAME(all)(0)};
    NAME(lane_numbers) i = {0}, j;
    NAME(lanes) whole_i = NAME(all)(0), whole_j;
    at.along = NAME(even_share)(&table->polar, polar, &j, &whole_j);
    if (!table->is_axial)
        at.across = NAME(even_share)(&table->azimuth, azimuth, &i, &whole_i);
    if (NAME(are_alike)(whole_j) && NAME(are_alike)(whole_i)) {
        const REAL *corner = table->values + (size_t)i[0] * row + (size_t)j[0];
        for (size_t k = 0; k < 2; k++) {
            at.near[k] = NAME(all)(corner[k]);
            at.far[k] = NAME(all)(corner[row + k]);
        }
        return at;
    }
    for (int lane = 0; lane < NAME(LX_WIDTH); lane++) {
        const REAL *corner = table->values + (size_t)i[lane] * row + (size_t)j[lane];
        at.near[0][lane] = corner[0];
        at.near[1][lane] = corner[1];
        if (!table->is_axial) {
            at.far[0][lane] = corner[row];
            at.far[1][lane] = corner[row + 1];
        }
    }
    return at;
}

/* 0 for angles beyond the table. */
LX_LANE NAME(lanes) NAME(darken)(const struct NAME(lx_lines) * lines, NAME(lanes) angle, NAME(lanes) g)
{
    const NAME(lanes) zero = NAME(all)(0);
    g = NAME(where_above)(NAME(all)(lines->dark_below), angle, zero, g);
    return NAME(where_above)(angle, NAME(all)(lines->dark_above), zero, g);
}

/*
 * How far through their cells directions are, in the versine: that of the acute angle from the axis is `across`/(r (r +
 * |along|)), `across` a square; seen from the other pole it has the opposite sign.
 */
LX_LANE NAME(lanes) NAME(versine_of)(NAME(lanes) across, NAME(lanes) along, NAME(lanes) r, NAME(lanes) south)
{
    const NAME(lanes) zero = NAME(all)(0), size = NAME(greater)(along, -along);
    const NAME(lanes) acute = across * NAME(inverse)(r * (r + size));
    const NAME(lanes) from_north = NAME(where_above)(zero, along, 2 - acute, acute);
    const NAME(lanes) from_south = NAME(where_above)(zero, along, -acute, acute - 2);
    return NAME(where_above)(south, zero, from_south, from_north);
}

/* The place in any table; `across`, `axial` and r tell the versine. */
LX_LANE struct NAME(table_place)
    NAME(uneven_place)(const struct NAME(lx_table) * table, NAME(lanes) azimuth, NAME(lanes) polar, NAME(lanes) across,
                       NAME(lanes) axial, NAME(lanes) r)
{
    const uint32_t j = NAME(find_cell)(&table->polar, polar[0]);
    const uint32_t i = table->is_axial ? 0 : NAME(find_cell)(&table->azimuth, azimuth[0]);
    const bool is_same = NAME(are_in_cell)(&table->polar, j, polar) &&
                         (table->is_axial || NAME(are_in_cell)(&table->azimuth, i, azimuth));
    const struct NAME(table_cells) cells =
        is_same ? NAME(same_cell)(table, i, j) : NAME(each_cell)(table, azimuth, polar);
    const NAME(lanes) at = table->by_cosine ? NAME(versine_of)(across, axial, r, cells.south) : polar;
    return (struct NAME(table_place)){
        .along = (at - cells.polar) * cells.per_polar,
        .across = (azimuth - cells.azimuth) * cells.per_azimuth,
        .near = {cells.near[0], cells.near[1]},
        .far = {cells.far[0], cells.far[1]},
    };
}

/* Sets g for the directions from a luminaire, against the ways (x, y, z) to it, r long. */
static __attribute__((noinline)) void NAME(look_up)(const struct lx_pointed *luminaire, const NAME(lanes) * x,
                                                    const NAME(lanes) * y, const NAME(lanes) * z, const NAME(lanes) * r,
                                                    NAME(lanes) * g)
{
    const struct NAME(lx_table) *table = &luminaire->distribution->NAME(table);
    const REAL(*frame)[3] = luminaire->NAME(frame);
    const NAME(lanes) zero = NAME(all)(0);
    NAME(lanes) d[3], azimuth = zero;
    for (int k = 0; k < 3; k++)
        d[k] = -(frame[k][0] * *x + frame[k][1] * *y + frame[k][2] * *z);
    const NAME(lanes) across = d[0] * d[0] + d[1] * d[1], beside = NAME(root)(across);
    const NAME(lanes) polar = NAME(angle_at)(beside, d[2], *r);
    if (!table->is_axial) {
        azimuth = NAME(angle_at)(NAME(greater)(d[1], -d[1]), d[0], beside);
        azimuth = NAME(where_above)(zero, d[1], -azimuth, azimuth);
        if (table->azimuth.dark_above > (REAL)8) /* a whole turn */
            azimuth = NAME(where_above)(NAME(all)(table->azimuth.start), azimuth, azimuth + (REAL)(2 * M_PI), azimuth);
    }
    const bool is_even = table->polar.even > 0 && (table->is_axial || table->azimuth.even > 0);
    const struct NAME(table_place) at =
        is_even ? NAME(even_place)(table, azimuth, polar) : NAME(uneven_place)(table, azimuth, polar, across, d[2], *r);
    NAME(lanes) value = at.near[0] + at.along * (at.near[1] - at.near[0]);
    if (!table->is_axial) {
        const NAME(lanes) far = at.far[0] + at.along * (at.far[1] - at.far[0]);
        value += at.across * (far - value);
        value = NAME(darken)(&table->azimuth, azimuth, value);
    }
    *g = NAME(greater)(NAME(darken)(&table->polar, polar, value), zero);
}

#if !LX_IS_SINGLE
static void find_angles(const struct lx_pointed *luminaire, const double place[3], const double ahead[2],
                        const struct lx_block_double *block, size_t count, double *polar, double *cosine,
                        double *azimuth)
{
    const double(*frame)[3] = luminaire->frame_double;
    const lanes_double zero = all_double(0);
    for (size_t i = 0; i < count; i += LX_WIDTH_double) {
        const lanes_double x = load_double(block->px + i) - place[0], y = load_double(block->py + i) - place[1],
                           z = load_double(block->pz + i) - place[2];
        lanes_double d[3];
        for (int k = 0; k < 3; k++)
            d[k] = frame[k][0] * x + frame[k][1] * y + frame[k][2] * z;
        const lanes_double across = d[0] * d[0] + d[1] * d[1], beside = root_double(across);
        const lanes_double r = root_double(across + d[2] * d[2]);
        store_double(polar + i, angle_at_double(beside, d[2], r));
        if (cosine)
            store_double(cosine + i, d[2] * inverse_double(greater_double(r, all_double(1e-18))));
        if (azimuth) {
            const lanes_double along = d[0] * ahead[0] + d[1] * ahead[1], aside = d[1] * ahead[0] - d[0] * ahead[1];
            const lanes_double turned = angle_at_double(magnitude_double(aside), along, beside);
            store_double(azimuth + i, where_above_double(zero, aside, -turned, turned));
        }
    }
}
#endif
