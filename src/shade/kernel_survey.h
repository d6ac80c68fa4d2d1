/* SPDX-License-Identifier: MIT */
/* Statistics of finished values, in one precision.  Included by kernel.c behind each lanes.h. */

static struct lx_survey NAME(survey)(const REAL *values, size_t count, double least)
{
    const NAME(lanes) limit = NAME(all)((REAL)least), infinite = NAME(all)((REAL)HUGE_VAL), zero = NAME(all)(0);
    NAME(lanes) maximum = zero, minimum = infinite, at_least = zero;
    double sums[LX_LANES] = {0};
    struct lx_survey survey = {.minimum = HUGE_VAL};
    for (size_t i = 0; i < count; i += LX_LANES) {
        REAL part[LX_LANES] = {0};
        memcpy(part, values + i, (count - i < LX_LANES ? count - i : LX_LANES) * sizeof *values);
        for (size_t k = 0; k < LX_LANES; k += NAME(LX_WIDTH)) {
            NAME(lanes) value;
            memcpy(&value, part + k, sizeof value);
            maximum = NAME(greater)(maximum, value);
            minimum = NAME(lesser)(minimum, NAME(where_above)(limit, value, infinite, value));
            at_least += NAME(where_above)(limit, value, zero, NAME(all)(1));
        }
        for (int k = 0; k < LX_LANES; k++)
            sums[k] += (double)part[k];
    }
    for (int k = 0; k < LX_LANES; k++)
        survey.sum += sums[k];
    for (int lane = 0; lane < NAME(LX_WIDTH); lane++) {
        survey.maximum = fmax(survey.maximum, (double)maximum[lane]);
        survey.minimum = fmin(survey.minimum, (double)minimum[lane]);
        survey.at_least += (size_t)at_least[lane];
    }
    return survey;
}
