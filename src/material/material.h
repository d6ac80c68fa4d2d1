/* SPDX-License-Identifier: MIT */
/* The authored material of a surface: its parameter table and the struct behind it. */
#ifndef LX_MATERIAL_MATERIAL_H
#define LX_MATERIAL_MATERIAL_H

#include "../parameter/table.h"
#include "model.h"

struct lx_material {
    uint64_t given;
    int model;         /* enum lx_model */
    int diffuse_model; /* that from LX_LAMBERT on */
    double sigma_degrees, roughness, alpha, f0;
    double diffuse, specular, shininess;
    double ambient; /* meaningful where given; else the diffuse weight counts */
    bool over_pi;
    int highlight; /* enum lx_highlight */
    bool normalized;
    bool mirror; /* of flat fronts: nothing else of it counts */
    double color[3], specular_color[3]; /* factors of diffuse and ambient, and of specular, in each channel */
};

extern const struct lx_table lx_material_table;

/* ka: the ambient weight, kd where it is not given. */
double lx_material_ambient(const struct lx_material *material);

#endif
