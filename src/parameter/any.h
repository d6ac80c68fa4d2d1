/* SPDX-License-Identifier: MIT */
/*
 * The type of values that no other type describes: lx_node_id, the node of whatever stands there, for the table's
 * check() and whoever uses the struct; 0: not written.  No scene has such keys, so the enumeration of table.h, on which
 * every kernel depends, ends before it.
 */
#ifndef LX_PARAMETER_ANY_H
#define LX_PARAMETER_ANY_H

#include "table.h"

#define LX_ANY ((enum lx_parameter_type)(LX_VARIANTS + 1))

#endif
