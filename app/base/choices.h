/* SPDX-License-Identifier: MIT */
/*
 * Choices as people read them.  In scenes and on the command line a choice is a key in every language; lists, titles
 * and legends show a label for it, in the language of the rest.
 */
#ifndef LUXEL_APP_CHOICES_H
#define LUXEL_APP_CHOICES_H

/* The label of a choice, such as "cosine", or of a kind of light or surface; the choice itself where it has none. */
const char *app_choice_label(const char *choice);

#endif
