/* SPDX-License-Identifier: MIT */
/* luxel figure, as luxel-draw runs it: from the options to the figure's settings, and each FILE. */
#include <luxel/figure.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../cli.h"
#include "../drawing.h"
#include "../language.h"
#include "../load.h"
#include "../message.h"
#include "../outputs.h"

int drawing_figure(const struct options *options)
{
    (void)options;
    return EXIT_USAGE;
}
