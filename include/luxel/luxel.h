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
 */
#ifndef LUXEL_LUXEL_H
#define LUXEL_LUXEL_H

#include <luxel/alternatives.h>
#include <luxel/balance.h>
#include <luxel/colour.h>
#include <luxel/compare.h>
#include <luxel/conventions.h>
#include <luxel/diagnostics.h>
#include <luxel/document.h>
#include <luxel/evaluator.h>
#include <luxel/exercise.h>
#include <luxel/extrema.h>
#include <luxel/field.h>
#include <luxel/glare.h>
#include <luxel/grid.h>
#include <luxel/isophotes.h>
#include <luxel/light.h>
#include <luxel/mesh.h>
#include <luxel/parameter.h>
#include <luxel/photometry.h>
#include <luxel/probe.h>
#include <luxel/profile.h>
#include <luxel/render.h>
#include <luxel/scene.h>
#include <luxel/settings.h>
#include <luxel/statistics.h>
#include <luxel/status.h>
#include <luxel/study.h>
#include <luxel/table.h>
#include <luxel/text.h>
#include <luxel/version.h>
#include <luxel/view.h>

#endif
