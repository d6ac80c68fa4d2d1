/* SPDX-License-Identifier: MIT */
/* Statistics of finished values, in one precision.  Included by kernel.c behind each lanes.h. */

/* What LX_LANES values after LX_LANES values have added up to. */
struct NAME(tally) {
    NAME(lanes) maximum, minimum;
    NAME(lane_bits) below; /* how many are below the limit */
    double sums[LX_LANES];
};

LX_LANE void NAME(count_in)(struct NAME(tally) * tally, const REAL *values, NAME(lanes) limit)
{
    const NAME(lanes) infinite = NAME(all)((REAL)HUGE_VAL);
    for (size_t k = 0; k < LX_LANES; k += NAME(LX_WIDTH)) {
        NAME(lanes) value;
        memcpy(&value, values + k, sizeof value);
        tally->maximum = NAME(greater)(tally->maximum, value);
        tally->minimum = NAME(lesser)(tally->minimum, NAME(where_above)(limit, value, infinite, value));
        tally->below -= (NAME(lane_bits))(limit > value);
    }
    for (int k = 0; k < LX_LANES; k++)
        tally->sums[k] += (double)values[k];
}

static struct lx_survey NAME(survey)(const REAL *values, size_t count, double least)
{
    const NAME(lanes) limit = NAME(all)((REAL)least), zero = NAME(all)(0);
    struct NAME(tally) tally = {zero, NAME(all)((REAL)HUGE_VAL), {0}, {0}};
    struct lx_survey survey = {.minimum = HUGE_VAL, .at_least = lx_padded(count)};
    REAL rest[LX_LANES] = {0};
    size_t i = 0;
    for (; i + LX_LANES <= count; i += LX_LANES)
        NAME(count_in)(&tally, values + i, limit);
    if (i < count) {
        memcpy(rest, values + i, (count - i) * sizeof *values);
        NAME(count_in)(&tally, rest, limit);
    }
    for (int k = 0; k < LX_LANES; k++)
        survey.sum += tally.sums[k];
    for (int lane = 0; lane < NAME(LX_WIDTH); lane++) {
        survey.maximum = lx_larger(survey.maximum, (double)tally.maximum[lane]);
        survey.minimum = lx_smaller(survey.minimum, (double)tally.minimum[lane]);
        survey.at_least -= (size_t)tally.below[lane];
    }
    return survey;
}
