/* SPDX-License-Identifier: MIT */
/* Texts as YAML scalars, and back. */
#ifndef LUXEL_APP_SCALAR_H
#define LUXEL_APP_SCALAR_H

/* A text as YAML in double quotes, and the text that a YAML scalar stands for; the caller's. */
char *app_yaml_quote(const char *text);
char *app_yaml_unquote(const char *yaml);

#endif
