/* SPDX-License-Identifier: MIT */
/* The JSON writer.  No numeric locale is ever set, so printf's numbers are JSON's. */
#include "json.h"

#include <math.h>

static void write_quoted(FILE *stream, const char *text)
{
    fputc('"', stream);
    for (; *text; text++) {
        const unsigned char byte = (unsigned char)*text;

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
