/* SPDX-License-Identifier: MIT */
/* For the reader of tables: the lines of a file, part by part, each cut into its fields. */
#ifndef LX_FORMAT_TEXT_TABLE_LINES_H
#define LX_FORMAT_TEXT_TABLE_LINES_H

#include "../base/encoding.h"
#include "../base/source.h"

/* A field without blanks and quotes around it; a quote inside one in quotes is doubled. */
struct lx_text_table_field {
    const char *at;
    size_t length;
    bool is_quoted;
};

/* The longest line is as long as a part. */
enum { LX_TABLE_PART = 1 << 20 };

struct lx_text_table_lines {
    struct lx_source *source;
    uint64_t offset; /* of what comes behind the part */
    enum lx_encoding encoding;
    unsigned char *raw; /* code units of UTF-16 */
    char *part;         /* with a line end behind it */
    size_t length;
    bool is_last;             /* nothing comes behind the part */
    bool comments_anywhere;   /* # begins a comment anywhere outside quotes, else only at the beginning of a line */
    const char *start, *next; /* the line, and what follows it; a new part moves both */
    size_t line, next_line;   /* their numbers, from 1 */
    size_t inside;            /* line ends in quotes */
    char separator;           /* ',', ';', a tab, or ' ': any blanks */
    bool stops[256];          /* the characters that a field without quotes goes up to */
    struct lx_text_table_field *fields;
    size_t count, capacity;
    const char *wrong; /* where a fault is */
};

enum lx_text_table_step {
    LX_TABLE_LINE,       /* its fields are there */
    LX_TABLE_COMMENT,    /* the whole line is one, and its only field what stands behind # */
    LX_TABLE_END,        /* nothing is left, or the source failed */
    LX_TABLE_LONG,       /* the line is longer than a part */
    LX_TABLE_OPEN_QUOTE, /* `wrong` is never closed */
    LX_TABLE_BEHIND,     /* at `wrong`, behind a field in quotes, stands something else */
    LX_TABLE_ZERO,       /* at `wrong` is a byte 0 */
    LX_TABLE_OUT_OF_MEMORY
};

/* False: memory ran out.  lx_text_table_lines_clear() is due in either case. */
bool lx_text_table_lines_begin(struct lx_text_table_lines *lines, struct lx_source *source, bool comments_anywhere);
void lx_text_table_lines_clear(struct lx_text_table_lines *lines);

void lx_text_table_set_separator(struct lx_text_table_lines *lines, char separator);

/* Goes to the next line and cuts it; after lx_text_table_again() to the same one. */
enum lx_text_table_step lx_text_table_cut(struct lx_text_table_lines *lines);
void lx_text_table_again(struct lx_text_table_lines *lines);

/* Adds a field in UTF-8, doubled quotes single. */
void lx_text_table_add(struct lx_text *text, const struct lx_text_table_field *field);

bool lx_is_line_end(char c);

#endif
