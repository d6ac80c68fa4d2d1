/* SPDX-License-Identifier: MIT */
/* Programs that this one hands its whole command line to, because they need libraries that slow every start. */
#ifndef LUXEL_CLI_ELSEWHERE_H
#define LUXEL_CLI_ELSEWHERE_H

/* Becomes the program of this name: the one beside this program, or the one that was installed with it.  Returns an
 * errno value where that is not possible. */
int elsewhere_run(const char *name, char *const *arguments);

#endif
