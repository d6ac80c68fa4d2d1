/* SPDX-License-Identifier: MIT */
/* The JSON writer: strings, and where commas, lines and blanks stand. */
#include "json.h"

#include "number.h"

enum { INDENT = 2 };

static void add_quoted(struct lx_text *text, const char *value)
{
    lx_text_puts(text, "\"");
    for (; *value; value++) {
        unsigned char byte = (unsigned char)*value;
        if (byte == '"' || byte == '\\')
            lx_text_printf(text, "\\%c", byte);
        else if (byte < 0x20 || byte == 0x7f)
            lx_text_printf(text, "\\u%04x", byte);
        else
            lx_text_add(text, value, 1);
    }
    lx_text_puts(text, "\"");
}

static bool on_one_line(const struct lx_json *json)
{
    return json->line && json->depth >= json->line;
}

static void new_line(struct lx_json *json)
{
    lx_text_puts(json->text, "\n");
    lx_text_fill(json->text, ' ', (size_t)INDENT * json->depth);
}

static void begin(struct lx_json *json, const char *key)
{
    if (json->comma)
        lx_text_puts(json->text, on_one_line(json) ? ", " : ",");
    if (json->depth && !on_one_line(json))
        new_line(json);
    if (key) {
        add_quoted(json->text, key);
        lx_text_puts(json->text, ": ");
    }
    json->comma = true;
}

void lx_json_open(struct lx_json *json, const char *key, char bracket)
{
    begin(json, key);
    lx_text_add(json->text, &bracket, 1);
    json->comma = false;
    json->depth++;
}

void lx_json_open_line(struct lx_json *json, const char *key, char bracket)
{
    lx_json_open(json, key, bracket);
    if (!json->line)
        json->line = json->depth;
}

static void close_one(struct lx_json *json, char bracket)
{
    bool line = on_one_line(json);
    if (json->line == json->depth)
        json->line = 0;
    json->depth--;
    if (!line && json->comma)
        new_line(json);
    lx_text_add(json->text, &bracket, 1);
    json->comma = true;
    if (!json->depth)
        lx_text_puts(json->text, "\n");
}

void lx_json_close(struct lx_json *json, const char *brackets)
{
    for (; *brackets; brackets++)
        close_one(json, *brackets);
}

void lx_json_text(struct lx_json *json, const char *key, const char *value)
{
    begin(json, key);
    add_quoted(json->text, value);
}

void lx_json_number(struct lx_json *json, const char *key, double value)
{
    char buffer[LX_NUMBER_SIZE];
    lx_json_raw(json, key, lx_write_number(value, buffer));
}

void lx_json_boolean(struct lx_json *json, const char *key, bool value)
{
    lx_json_raw(json, key, value ? "true" : "false");
}

void lx_json_raw(struct lx_json *json, const char *key, const char *value)
{
    begin(json, key);
    lx_text_puts(json->text, value);
}
