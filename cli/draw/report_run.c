/* SPDX-License-Identifier: MIT */
/* luxel report, as luxel-draw runs it. */
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

int drawing_report(const struct options *options)
{
    (void)options;
    return EXIT_USAGE;
}
