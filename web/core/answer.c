/* SPDX-License-Identifier: MIT */
/* The buffer of answers, and the words that the page translates. */
#include "answer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct {
    char *text;
    size_t length, capacity;
    bool needs_comma, failed;
} answer;

static void add(const char *bytes, size_t count)
{
    if (answer.length + count + 1 > answer.capacity) {
        const size_t capacity = 2 * (answer.length + count + 1);
        char *text = answer.failed ? NULL : realloc(answer.text, capacity);
        if (!text) {
            answer.failed = true;
            return;
        }
        answer.text = text;
        answer.capacity = capacity;
    }
    memcpy(answer.text + answer.length, bytes, count);
    answer.length += count;
    answer.text[answer.length] = '\0';
}

static void separate(void)
{
    if (answer.needs_comma)
        add(",", 1);
    answer.needs_comma = true;
}

void answer_begin(void)
{
    answer.length = 0;
    answer.needs_comma = answer.failed = false;
}

const char *answer_text(void)
{
    return answer.failed ? NULL : answer.text;
}

void answer_open(char bracket)
{
    separate();
    add(&bracket, 1);
    answer.needs_comma = false;
}

void answer_close(char bracket)
{
    add(&bracket, 1);
    answer.needs_comma = true;
}

static void quote(const char *text)
{
    char code[8];
    add("\"", 1);
    for (const char *next = text; *next; next++) {
        const unsigned char byte = (unsigned char)*next;
        if (byte == '"' || byte == '\\' || byte < ' ') {
            snprintf(code, sizeof code, "\\u%04x", byte);
            add(code, strlen(code));
        } else {
            add(next, 1);
        }
    }
    add("\"", 1);
}

void answer_key(const char *key)
{
    separate();
    quote(key);
    add(":", 1);
    answer.needs_comma = false;
}

void answer_string(const char *text)
{
    separate();
    if (text)
        quote(text);
    else
        add("null", 4);
}

void answer_number(double number)
{
    char digits[32];
    separate();
    snprintf(digits, sizeof digits, "%.17g", number);
    if (isfinite(number))
        add(digits, strlen(digits));
    else
        add("null", 4);
}

void answer_bool(bool truth)
{
    separate();
    add(truth ? "true" : "false", truth ? 4 : 5);
}

void answer_numbers(const double *numbers, size_t count)
{
    if (!numbers) {
        answer_string(NULL);
        return;
    }
    answer_open('[');
    for (size_t i = 0; i < count; i++)
        answer_number(numbers[i]);
    answer_close(']');
}

void answer_amount(const char *key, double value, double error)
{
    answer_key(key);
    answer_numbers((const double[]){value, error}, 2);
}

/* The page keeps each translation at its place in memory, so that it lives as long as the core. */
const char *page_translation(const char *english);

const char *page_translate(const char *english, void *data)
{
    (void)data;
    const char *translation = page_translation(english);
    return translation ? translation : english;
}
