/* SPDX-License-Identifier: MIT */
/* What kernel_law.c has for the table of kernel.c: functions of one instruction set, LX_ISA. */
#ifndef LX_KERNEL_KERNEL_LAW_H
#define LX_KERNEL_KERNEL_LAW_H

#include "kernel.h"

#define LX_OF_ISA(name) LX_OF_ISA_NAMED(name, LX_ISA)
#define LX_OF_ISA_NAMED(name, isa) LX_OF_ISA_JOINED(name, isa)
#define LX_OF_ISA_JOINED(name, isa) name##_##isa

lx_light_by_law LX_OF_ISA(lx_facets_by_rows_single), LX_OF_ISA(lx_facets_by_rows_double);
lx_light_by_law LX_OF_ISA(lx_round_by_rows_single), LX_OF_ISA(lx_round_by_rows_double);
lx_light_by_law LX_OF_ISA(lx_ball_by_rings_single), LX_OF_ISA(lx_ball_by_rings_double);

#endif
