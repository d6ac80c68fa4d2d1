/* SPDX-License-Identifier: MIT */
/* Program of the unit tests: runs the one that its argument names, `units extrema`.  Each test_NAME.c is written as a
   program; its main() is compiled under the name main_of_NAME. */
#include <stdio.h>
#include <string.h>

#define UNIT(name) int main_of_##name(void);
#include "units.def"
#undef UNIT

static const struct {
    const char *name;
    int (*run)(void);
} units[] = {
#define UNIT(name) {#name, main_of_##name},
#include "units.def"
#undef UNIT
};

int main(int count, char **arguments)
{
    for (size_t i = 0; count == 2 && i < sizeof units / sizeof *units; i++)
        if (strcmp(arguments[1], units[i].name) == 0)
            return units[i].run();
    fputs("usage: units NAME, one of:\n", stderr);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        fprintf(stderr, "  %s\n", units[i].name);
    return 2;
}
