/* SPDX-License-Identifier: MIT */
/* How fine EN 12464-1 wants a plane to be measured. */
#ifndef LX_SCENE_GRIDS_H
#define LX_SCENE_GRIDS_H

/* EN 12464-1:2011, 4.4: the greatest distance between points of a plane, in mm. */
double lx_en12464_spacing_mm(const double size_mm[2]);

#endif
