/* SPDX-License-Identifier: MIT */
/* Choices of a material that kernels are compiled for. */
#ifndef LX_MATERIAL_MODEL_H
#define LX_MATERIAL_MODEL_H

enum lx_model { LX_BLINN_PHONG, LX_PHONG, LX_LAMBERT };
enum lx_highlight { LX_HIGHLIGHT_PLAIN, LX_HIGHLIGHT_GATED, LX_HIGHLIGHT_COSINE };

#endif
