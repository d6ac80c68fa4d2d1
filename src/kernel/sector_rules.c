/* SPDX-License-Identifier: MIT */
/* Rules of Gauss for lobes, and how wide and how high these are in a part of a source. */
#include "sector_rules.h"

#include <math.h>

#include "../base/vector.h"
#include "../material/lobe.h"

/* Rules of Gauss on (0, 1). */
const double lx_sector_places[LX_PARTIAL_HIGHLIGHT_NODES][LX_PARTIAL_HIGHLIGHT_NODES] = {
    {0.5},
    {0.21132486540518713, 0.78867513459481287},
    {0.1127016653792583, 0.5, 0.8872983346207417},
    {0.069431844202973714, 0.33000947820757187, 0.66999052179242813, 0.93056815579702623},
    {0.046910077030668018, 0.23076534494715845, 0.5, 0.7692346550528415, 0.95308992296933193},
    {0.033765242898423975, 0.1693953067668677, 0.38069040695840151, 0.61930959304159849, 0.83060469323313235,
     0.96623475710157603},
    {0.025446043828620757, 0.12923440720030277, 0.29707742431130141, 0.5, 0.70292257568869854, 0.87076559279969723,
     0.97455395617137919},
    {0.019855071751231856, 0.10166676129318658, 0.2372337950418355, 0.40828267875217511, 0.59171732124782495,
     0.7627662049581645, 0.89833323870681348, 0.9801449282487682},
};
const double lx_sector_weights[LX_PARTIAL_HIGHLIGHT_NODES][LX_PARTIAL_HIGHLIGHT_NODES] = {
    {1},
    {0.50000000000000011, 0.50000000000000011},
    {0.27777777777777762, 0.44444444444444442, 0.27777777777777762},
    {0.17392742256872687, 0.32607257743127305, 0.32607257743127305, 0.17392742256872687},
    {0.1184634425280945, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324, 0.1184634425280945},
    {0.085662246189585248, 0.1803807865240693, 0.23395696728634563, 0.23395696728634563, 0.1803807865240693,
     0.085662246189585248},
    {0.064742483084434838, 0.13985269574463835, 0.19091502525255952, 0.2089795918367347, 0.19091502525255952,
     0.13985269574463835, 0.064742483084434838},
    {0.050614268145188088, 0.11119051722668723, 0.15685332293894369, 0.181341891689181, 0.181341891689181,
     0.15685332293894369, 0.11119051722668723, 0.050614268145188088},
};

/* A rule of so many nodes leaves no more than 3e-5 of the greatest value of exp(-x^2/2) over an interval of twice this
 * length, wherever it lies. */
static const double REACHES[LX_PARTIAL_HIGHLIGHT_NODES] = {0.013, 0.229, 0.64, 1.128, 1.642, 2.164, 2.687, 3.209};

unsigned lx_sector_order(unsigned least, double half)
{
    while (least < LX_PARTIAL_HIGHLIGHT_NODES && REACHES[least - 1] < half)
        least++;
    return least;
}

double lx_sector_power(const struct lx_lobe_double *lobe, const double mirrored[3], const double middle[3],
                       double cosine, double sine)
{
    const double towards = fmin(lx_dot(middle, mirrored), 1);
    const double aside = sqrt(fmax(1 - towards * towards, 0));
    const double nearest = towards >= cosine ? 1 : fmin(towards * cosine + aside * sine, 1);
    return pow(lx_power_lobe_of(lobe->model)->greatest_square(nearest), lobe->exponent.value / 2);
}

double lx_sector_width(const struct lx_lobe_double *lobe, const double view[3], const double middle[3], double sine)
{
    const double NARROWEST = 0.05; /* of the widest */
    double half[3];
    for (int k = 0; k < 3; k++)
        half[k] = middle[k] + view[k];
    const double share = fmin(fmax((sqrt(lx_dot(half, half)) - sine) / 2, NARROWEST), 1);
    return lx_power_lobe_of(lobe->model)->width(lobe->exponent.value, 2 * share);
}
