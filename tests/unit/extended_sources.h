/* SPDX-License-Identifier: MIT */
/* One extended source of each shape, some 300 mm large, for tests of their integrals. */
#ifndef TESTS_UNIT_EXTENDED_SOURCES_H
#define TESTS_UNIT_EXTENDED_SOURCES_H

#include "light/emitter.h"

enum { RECTANGLE, BOX, GLOBE, PRISM, DISK, BALL, CYLINDER, SOURCES };

/* The source of a kind with its middle there; free its facets with lx_facets_free(), which takes NULL as well. */
struct lx_emitter source_of(int kind, const double center[3], double radiance, double k_mm);

#endif
