/* SPDX-License-Identifier: MIT */
/* Lambert's model (1760): light is reflected to all sides alike, and there is no highlight. */
#include "lobe.h"

const struct lx_lobe_kind lx_lambert_lobe = {
    .words = {.brightness = "k_d \\max(0, \\mathbf{N} \\cdot \\mathbf{L})"},
    .is_lambertian = true,
};
