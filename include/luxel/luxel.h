/* SPDX-License-Identifier: MIT */
/*
 * Luxel: how light sources brighten a surface.  This header brings in the whole library:
 *
 *     luxel_scene *scene;
 *     luxel_field *field;
 *     if (luxel_scene_open_builtin("report", NULL, &scene) == LUXEL_OK &&
 *         luxel_scene_commit(scene, NULL) == LUXEL_OK &&
 *         luxel_render(scene, NULL, NULL, &field) == LUXEL_OK)
 *             luxel_field_write(field, "report.png", NULL);
 *
 * Link with pkg-config's `luxel`.  The library keeps no global state, prints nothing and never exits.
 *
 * Rules that hold everywhere:
 *
 * Names.  luxel_find_X() finds a luxel_X or fills in one of the caller's; luxel_X_free() frees what the library made.
 * Functions of one object begin with its name.
 *
 * Growth.  A program need not be compiled anew for a later version.  What the library makes and hands out by a pointer,
 * one at a time (luxel_probe, luxel_grid, what a _get() returns), may get members behind its last one: it is neither
 * copied nor made by programs.  Every other structure, of the caller's, in a list or within another one, keeps its
 * size: its new members take the place of `reserved`.  What goes in begins as {0} or by its _init(), and a function
 * refuses one whose reserve is not NULL (LUXEL_ERROR_ARGUMENT, "reserved-not-null"); in what comes out the library sets
 * it to NULL.  A structure without it is complete; more about the elements of such a list stands in a list beside it.
 *
 * Errors.  `error` bounds |value - truth| with every rounding included, the truth being the real-number result of the
 * scene's numbers as they stand in float64.  It holds as well where an integral or reflected light is not found as
 * exactly as the settings ask for: that is no failure, but told by a member of the result, tolerance_reached,
 * reflected_reached or reached.
 *
 * Threads.  What a function takes by a pointer to const it only reads, and so may several of them in several threads at
 * once: render, probe and measure a committed scene, read a field, ask an evaluator.  What it may change, such as a
 * luxel_diagnostics or a scene that is committed or freed, belongs to one thread at a time.  Separate objects are
 * independent.  Any number of threads gives the same numbers.
 */
#ifndef LUXEL_LUXEL_H
#define LUXEL_LUXEL_H

#include <luxel/alternatives.h>
#include <luxel/arrange.h>
#include <luxel/balance.h>
#include <luxel/exchange.h>
#include <luxel/bounded.h>
#include <luxel/colour.h>
#include <luxel/compare.h>
#include <luxel/conventions.h>
#include <luxel/daylight.h>
#include <luxel/derive.h>
#include <luxel/diagnostics.h>
#include <luxel/document.h>
#include <luxel/evaluator.h>
#include <luxel/exercise.h>
#include <luxel/extrema.h>
#include <luxel/field.h>
#include <luxel/fit.h>
#include <luxel/glare.h>
#include <luxel/grid.h>
#include <luxel/isophotes.h>
#include <luxel/light.h>
#include <luxel/limits.h>
#include <luxel/mesh.h>
#include <luxel/parameter.h>
#include <luxel/photometry.h>
#include <luxel/probe.h>
#include <luxel/profile.h>
#include <luxel/render.h>
#include <luxel/room.h>
#include <luxel/scene.h>
#include <luxel/settings.h>
#include <luxel/statistics.h>
#include <luxel/status.h>
#include <luxel/study.h>
#include <luxel/sunlight.h>
#include <luxel/table.h>
#include <luxel/text.h>
#include <luxel/utilization.h>
#include <luxel/version.h>
#include <luxel/view.h>

#endif
