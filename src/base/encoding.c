/* SPDX-License-Identifier: MIT */
/* UTF-16 and the code page 1251 made UTF-8. */
#include "encoding.h"

#include <stdint.h>
#include <string.h>

#include "memory.h"

enum { REPLACEMENT = 0xFFFD };

enum lx_encoding lx_find_encoding(const void *bytes, size_t length, size_t *mark)
{
    const unsigned char *at = bytes;
    *mark = 0;
    if (length >= 3 && memcmp(at, "\xEF\xBB\xBF", 3) == 0) {
        *mark = 3;
        return LX_UTF8;
    }
    if (length < 2)
        return LX_UTF8;
    bool is_little = at[0] == 0xFF && at[1] == 0xFE, is_big = at[0] == 0xFE && at[1] == 0xFF;
    *mark = is_little || is_big ? 2 : 0;
    if (is_little || (length >= 4 && at[0] && !at[1] && at[2] && !at[3]))
        return LX_UTF16_LITTLE;
    if (is_big || (length >= 4 && !at[0] && at[1] && !at[2] && at[3]))
        return LX_UTF16_BIG;
    return LX_UTF8;
}

static size_t put_character(uint32_t code, char *text)
{
    if (code < 0x80) {
        text[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        text[0] = (char)(0xC0 | code >> 6);
        text[1] = (char)(0x80 | (code & 0x3F));
        return 2;
    }
    if (code < 0x10000) {
        text[0] = (char)(0xE0 | code >> 12);
        text[1] = (char)(0x80 | (code >> 6 & 0x3F));
        text[2] = (char)(0x80 | (code & 0x3F));
        return 3;
    }
    text[0] = (char)(0xF0 | code >> 18);
    text[1] = (char)(0x80 | (code >> 12 & 0x3F));
    text[2] = (char)(0x80 | (code >> 6 & 0x3F));
    text[3] = (char)(0x80 | (code & 0x3F));
    return 4;
}

static uint32_t unit_at(const unsigned char *units, size_t i, enum lx_encoding encoding)
{
    uint32_t first = units[2 * i], second = units[2 * i + 1];
    return encoding == LX_UTF16_BIG ? first << 8 | second : second << 8 | first;
}

size_t lx_decode_utf16(const unsigned char *units, size_t count, enum lx_encoding encoding, bool is_last, char *text,
                       size_t *used)
{
    size_t length = 0, i = 0;
    while (i < count) {
        uint32_t code = unit_at(units, i, encoding);
        bool is_first_half = code >= 0xD800 && code < 0xDC00;
        if (is_first_half && i + 1 == count && !is_last)
            break;
        uint32_t next = is_first_half && i + 1 < count ? unit_at(units, i + 1, encoding) : 0;
        if (next >= 0xDC00 && next < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10) + (next - 0xDC00);
            i++;
        } else if (code >= 0xD800 && code < 0xE000) {
            code = REPLACEMENT;
        }
        length += put_character(code, text + length);
        i++;
    }
    *used = i;
    return length;
}

char *lx_text_of_utf16(const char *text, size_t *length, size_t mark, enum lx_encoding encoding)
{
    size_t units = (*length - mark) / 2, used;
    char *decoded = lx_new_array(units + 1, LX_UTF16_GROWTH);
    if (decoded)
        *length = lx_decode_utf16((const unsigned char *)text + mark, units, encoding, true, decoded, &used);
    return decoded;
}

char *lx_text_of_bytes(char *text, size_t *length)
{
    size_t mark;
    const enum lx_encoding encoding = lx_find_encoding(text, *length, &mark);
    if (encoding != LX_UTF8)
        return lx_text_of_utf16(text, length, mark, encoding);
    memset(text, ' ', mark);
    return text;
}

/* The characters from 0x80 to 0xBF; those from 0xC0 on are the Russian alphabet in order. */
static const uint16_t code_page_1251[64] = {
    0x0402, 0x0403, 0x201A, 0x0453, 0x201E, 0x2026, 0x2020, 0x2021, 0x20AC, 0x2030, 0x0409, 0x2039, 0x040A,
    0x040C, 0x040B, 0x040F, 0x0452, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0xFFFD, 0x2122,
    0x0459, 0x203A, 0x045A, 0x045C, 0x045B, 0x045F, 0x00A0, 0x040E, 0x045E, 0x0408, 0x00A4, 0x0490, 0x00A6,
    0x00A7, 0x0401, 0x00A9, 0x0404, 0x00AB, 0x00AC, 0x00AD, 0x00AE, 0x0407, 0x00B0, 0x00B1, 0x0406, 0x0456,
    0x0491, 0x00B5, 0x00B6, 0x00B7, 0x0451, 0x2116, 0x0454, 0x00BB, 0x0458, 0x0405, 0x0455, 0x0457,
};

static bool is_utf8(const char *bytes, size_t length)
{
    for (size_t i = 0, size; i < length; i += size) {
        uint32_t code;
        size = lx_next_character(bytes + i, length - i, &code);
        if (size == 0)
            return false;
    }
    return true;
}

void lx_add_decoded(struct lx_text *text, const char *bytes, size_t length)
{
    if (is_utf8(bytes, length)) {
        lx_text_add(text, bytes, length);
        return;
    }
    for (size_t i = 0; i < length; i++) {
        unsigned char byte = (unsigned char)bytes[i];
        uint32_t code = byte < 0x80 ? byte : byte < 0xC0 ? code_page_1251[byte - 0x80] : 0x0410u + (byte - 0xC0u);
        char character[4];
        lx_text_add(text, character, put_character(code, character));
    }
}

void lx_add_latin(struct lx_text *text, const char *bytes, size_t length)
{
    if (is_utf8(bytes, length)) {
        lx_text_add(text, bytes, length);
        return;
    }
    for (size_t i = 0; i < length; i++) {
        char character[4];
        lx_text_add(text, character, put_character((unsigned char)bytes[i], character));
    }
}
