/* SPDX-License-Identifier: MIT */
/* The labels of choices in the language of the program. */
#include "choices.h"

#include <luxel/parameter.h>

#include "../../front/words.h"

const char *app_choice_label(const char *choice)
{
    const char *label = luxel_parameter_choice_label(choice);
    return label ? gettext(label) : choice;
}
