/* SPDX-License-Identifier: MIT */
/*
 * The picture's values at the pixels of probes.  A pixel's value may depend on those around it, which are shaded
 * together; so probes are taken tile by tile, each tile once.
 */
#ifndef LX_API_PROBE_PIXELS_H
#define LX_API_PROBE_PIXELS_H

#include <luxel/probe.h>

#include "session.h"

/*
 * Sets pixel_value of those of the probes that show a surface and have a pixel, by the threads of the session.  Each of
 * these counts as a row of the control.
 * LUXEL_ERROR_MEMORY, or LUXEL_CANCELLED by the control.
 */
luxel_status lx_probe_pixels(const struct lx_session *session, struct lx_control *control, luxel_probe *probes,
                             size_t count);

#endif
