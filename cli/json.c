/* SPDX-License-Identifier: MIT */
/* The JSON writer.  No numeric locale is ever set, so printf's numbers are JSON's. */
#include "json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

/* Below 65536 one, beyond a pair. */
static void write_number(FILE *stream, unsigned long code)
{
    if (code > 0xffff) {
        write_number(stream, 0xd800 + ((code - 0x10000) >> 10));
        code = 0xdc00 + ((code - 0x10000) & 0x3ff);
    }
    fprintf(stream, "\\u%04lx", code);
}

/*
 * A character of several bytes, by its number where it could disturb a terminal or what stands beside it; a byte that
 * begins none becomes the sign for that.  Returns how many bytes it takes.
 */
static size_t write_character(FILE *stream, const char *text)
{
    const unsigned char lead = (unsigned char)*text;
    const size_t size = strnlen(text, lead < 0xc0 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4);
    char *one = strndup(text, size), *escaped = one ? luxel_escaped_text(one) : NULL;
    const bool is_kept = !escaped || strcmp(one, escaped) == 0;
    const bool is_none = !is_kept && escaped[1] == 'x' && (size != 2 || strlen(escaped) > 4);

    if (is_none)
        write_number(stream, 0xfffd);
    else if (is_kept)
        fprintf(stream, "%.*s", (int)size, text);
    else
        write_number(stream, strtoul(escaped + 2, NULL, 16));
    luxel_text_free(escaped);
    free(one);
    return is_none ? 1 : size;
}

static void write_quoted(FILE *stream, const char *text)
{
    fputc('"', stream);
    while (*text) {
        const unsigned char byte = (unsigned char)*text;

        if (byte >= 0x80) {
            text += write_character(stream, text);
            continue;
        }
        text++;
        if (byte == '"' || byte == '\\')
            fprintf(stream, "\\%c", byte);
        else if (byte == '\n')
            fputs("\\n", stream);
        else if (byte < 0x20 || byte == 0x7f)
            fprintf(stream, "\\u%04x", byte);
        else
            fputc(byte, stream);
    }
    fputc('"', stream);
}

static void begin(struct json *json, const char *key)
{
    if (json->comma)
        fputs(", ", json->stream);
    if (key) {
        write_quoted(json->stream, key);
        fputs(": ", json->stream);
    }
    json->comma = true;
}

void json_open(struct json *json, const char *key, char bracket)
{
    begin(json, key);
    fputc(bracket, json->stream);
    json->comma = false;
    json->depth++;
}

void json_close(struct json *json, char bracket)
{
    fputc(bracket, json->stream);
    json->comma = true;
    if (--json->depth == 0)
        fputc('\n', json->stream);
}

void json_null(struct json *json, const char *key)
{
    begin(json, key);
    fputs("null", json->stream);
}

void json_bool(struct json *json, const char *key, bool value)
{
    begin(json, key);
    fputs(value ? "true" : "false", json->stream);
}

void json_whole(struct json *json, const char *key, size_t value)
{
    begin(json, key);
    fprintf(json->stream, "%zu", value);
}

void json_number(struct json *json, const char *key, double value)
{
    if (!isfinite(value)) {
        json_null(json, key);
        return;
    }
    begin(json, key);
    fprintf(json->stream, "%.17g", value + 0.0); /* -0 becomes 0 */
}

void json_number_if(struct json *json, const char *key, bool exists, double value)
{
    json_number(json, key, exists ? value : (double)NAN);
}

void json_text(struct json *json, const char *key, const char *value)
{
    if (!value) {
        json_null(json, key);
        return;
    }
    begin(json, key);
    write_quoted(json->stream, value);
}

void json_numbers(struct json *json, const char *key, const double *values, size_t count)
{
    json_open(json, key, '[');
    for (size_t i = 0; i < count; i++)
        json_number(json, NULL, values[i]);
    json_close(json, ']');
}

void json_wholes(struct json *json, const char *key, const unsigned *values, size_t count)
{
    json_open(json, key, '[');
    for (size_t i = 0; i < count; i++)
        json_whole(json, NULL, values[i]);
    json_close(json, ']');
}
