/* SPDX-License-Identifier: MIT */
/*
 * Phrases: English words inside a text that a front end puts into its language.  A text with phrases marks each of
 * them, with its own arguments {0}, {1} ... (texts with phrases, too), so that it can be rendered in any language
 * when it is read.  What users wrote must be escaped before it is added to such a text (lx_text_add_escaped()).
 */
#ifndef LX_BASE_PHRASE_H
#define LX_BASE_PHRASE_H

#include <luxel/diagnostics.h>

#include "text.h"

/* A NULL-terminated array of strings, as lx_report(), lx_hint() and lx_add_phrase() take their arguments. */
#define LX_ARGS(...) ((const char *const[]){__VA_ARGS__, NULL})

/*
 * Among the arguments of lx_report() and lx_hint(), which are plain texts otherwise: LX_TERM(english) is words that
 * are translated as a whole, LX_WORDS(text) a text with phrases.
 */
#define LX_TERM(english) lx_term_mark, (english)
#define LX_WORDS(text) lx_words_mark, (text)

/* Marks an English constant that becomes a term or a phrase elsewhere, for the tools that list what to translate. */
#define LX_N(english) english

/* The addresses tell, not what is there. */
extern const char lx_term_mark[], lx_words_mark[];

/* Adds words to be translated; the arguments (NULL: none) are texts with phrases. */
void lx_add_phrase(struct lx_text *text, const char *english, const char *const *arguments);

/* Adds an argument of lx_report() as a text with phrases, everything else escaped; returns the one behind it. */
const char *const *lx_add_argument(struct lx_text *text, const char *const *argument);

/* A template in the language of `translate` (NULL: English), filled with texts with phrases. */
void lx_add_rendered(struct lx_text *text, const char *english, const char *const *arguments, luxel_translate translate,
                     void *data);

/* A text with phrases rendered, the caller's; NULL where memory ran out.  Leaves the buffer empty. */
char *lx_text_render(struct lx_text *text, luxel_translate translate, void *data);

#endif
