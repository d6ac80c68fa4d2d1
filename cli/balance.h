/* SPDX-License-Identifier: MIT */
/* The light on the surfaces of a scene that reflects light, and the balance of its flux, as text and in JSON. */
#ifndef LUXEL_CLI_BALANCE_H
#define LUXEL_CLI_BALANCE_H

#include <luxel/luxel.h>

#include "json.h"

void balance_print(const luxel_balance *balance);

/* Writes `surfaces` and `balance` as members of an object. */
void balance_write(struct json *json, const luxel_balance *balance);

#endif
