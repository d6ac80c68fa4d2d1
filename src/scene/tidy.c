/* SPDX-License-Identifier: MIT */
/*
 * Writing documents without regard to the text that they came from: keys of the scene, surfaces and long lists
 * in block style, small mappings and lists of numbers on one line.
 */
#include <string.h>

#include "../base/number.h"
#include "../parameter/plain.h"
#include "tidy.h"

enum { LINE_COLUMNS = 118, INDENT = 2 };

struct writer {
    const struct lx_document *document;
    struct lx_text *text;
    bool json;
};

/* ---- scalars ---- */

static void write_quoted(struct lx_text *text, const char *string)
{
    lx_text_puts(text, "\"");
    size_t length = strlen(string);
    for (size_t i = 0, size; i < length; i += size) {
        uint32_t code;
        size = lx_next_character(string + i, length - i, &code);
        size = size ? size : 1;
        if (string[i] == '"' || string[i] == '\\')
            lx_text_puts(text, "\\");
        lx_text_add_escaped(text, string + i, size);
    }
    lx_text_puts(text, "\"");
}

/* A text, without quotes where it stays a text without. */
static void write_word(struct lx_text *text, const char *string)
{
    if (lx_plain_is_safe(string))
        lx_text_puts(text, string);
    else
        write_quoted(text, string);
}

static void write_json_text(struct lx_text *text, const char *string)
{
    lx_text_puts(text, "\"");
    for (; *string; string++) {
        unsigned char byte = (unsigned char)*string;
        if (byte == '"' || byte == '\\')
            lx_text_printf(text, "\\%c", byte);
        else if (byte < 0x20 || byte == 0x7F)
            lx_text_printf(text, "\\u%04x", byte);
        else
            lx_text_add(text, string, 1);
    }
    lx_text_puts(text, "\"");
}

/* YAML allows "+5", ".5", "5." and "007"; JSON does not. */
static void write_json_number(struct lx_text *text, const char *number)
{
    if (*number == '-')
        lx_text_puts(text, "-");
    number += *number == '-' || *number == '+';
    while (number[0] == '0' && number[1] >= '0' && number[1] <= '9')
        number++;
    size_t digits = strspn(number, "0123456789");
    if (digits == 0)
        lx_text_puts(text, "0");
    lx_text_add(text, number, digits);
    number += digits;
    if (*number == '.') {
        digits = strspn(number + 1, "0123456789");
        lx_text_add(text, number, digits + 1);
        if (digits == 0)
            lx_text_puts(text, "0");
        number += digits + 1;
    }
    lx_text_puts(text, number);
}

/* What means nothing in JSON, such as .nan, stays as it is: no scene may hold it anyway. */
static void write_json_scalar(struct writer *writer, lx_node_id id)
{
    const char *string = lx_document_text(writer->document, id);
    bool plain = lx_document_node(writer->document, id)->plain;
    if (plain && lx_document_is_null(writer->document, id))
        lx_text_puts(writer->text, "null");
    else if (plain && lx_looks_like_number(string, strlen(string)))
        write_json_number(writer->text, string);
    else if (plain && (strcmp(string, "True") == 0 || strcmp(string, "TRUE") == 0))
        lx_text_puts(writer->text, "true");
    else if (plain && (strcmp(string, "False") == 0 || strcmp(string, "FALSE") == 0))
        lx_text_puts(writer->text, "false");
    else if (plain && !lx_plain_is_text(string))
        lx_text_puts(writer->text, string);
    else
        write_json_text(writer->text, string);
}

static void write_scalar(struct writer *writer, lx_node_id id)
{
    const char *string = lx_document_text(writer->document, id);
    if (writer->json)
        write_json_scalar(writer, id);
    else if (!lx_document_node(writer->document, id)->plain)
        write_word(writer->text, string);
    else if (!string[0])
        lx_text_puts(writer->text, "null");
    else if (lx_plain_is_writable(string))
        lx_text_puts(writer->text, string);
    else
        write_quoted(writer->text, string);
}

void lx_write_key(struct lx_text *text, const char *key, bool json)
{
    if (json)
        write_json_text(text, key);
    else
        write_word(text, key);
}

static void write_key(struct writer *writer, lx_node_id id)
{
    lx_write_key(writer->text, lx_document_key(writer->document, id), writer->json);
    lx_text_puts(writer->text, ":");
}

/* ---- lists and mappings ---- */

/* Writes on one line; false as soon as it is longer than `end`. */
static bool write_flow(struct writer *writer, lx_node_id id, size_t end)
{
    const struct lx_node *node = lx_document_node(writer->document, id);
    if (node->kind == LX_SCALAR) {
        write_scalar(writer, id);
        return writer->text->length <= end;
    }
    bool mapping = node->kind == LX_MAPPING;
    lx_text_puts(writer->text, mapping ? "{" : "[");
    for (lx_node_id child = node->first; child; child = lx_document_node(writer->document, child)->next) {
        if (child != node->first)
            lx_text_puts(writer->text, ", ");
        if (mapping) {
            write_key(writer, child);
            lx_text_puts(writer->text, " ");
        }
        if (!write_flow(writer, child, end))
            return false;
    }
    lx_text_puts(writer->text, mapping ? "}" : "]");
    return writer->text->length <= end;
}

/* Whether a mapping stands anywhere below. */
static bool holds_mapping(const struct lx_document *document, lx_node_id id)
{
    for (id = lx_document_node(document, id)->first; id; id = lx_document_node(document, id)->next)
        if (lx_document_node(document, id)->kind == LX_MAPPING || holds_mapping(document, id))
            return true;
    return false;
}

/* Writes on the rest of the line what is simple and fits there; else writes nothing and returns false. */
static bool write_on_line(struct writer *writer, lx_node_id id, size_t line_start)
{
    const struct lx_node *node = lx_document_node(writer->document, id);
    if (node->kind == LX_SCALAR || !node->first)
        return write_flow(writer, id, SIZE_MAX);
    size_t before = writer->text->length;
    if (!holds_mapping(writer->document, id) && write_flow(writer, id, line_start + LINE_COLUMNS))
        return true;
    writer->text->length = before;
    return false;
}

/* Writes the children on lines of their own; the first one starts where the text ends. */
static void write_block(struct writer *writer, lx_node_id id, size_t indent)
{
    const struct lx_node *node = lx_document_node(writer->document, id);
    for (lx_node_id child = node->first; child; child = lx_document_node(writer->document, child)->next) {
        if (child != node->first)
            lx_text_fill(writer->text, ' ', indent);
        size_t line_start = writer->text->length - indent;
        if (node->kind == LX_SEQUENCE)
            lx_text_puts(writer->text, "-");
        else
            write_key(writer, child);
        size_t before = writer->text->length;
        lx_text_puts(writer->text, " ");
        if (write_on_line(writer, child, line_start)) {
            lx_text_puts(writer->text, "\n");
        } else if (node->kind == LX_SEQUENCE) {
            write_block(writer, child, indent + INDENT);
        } else {
            writer->text->length = before;
            lx_text_puts(writer->text, "\n");
            lx_text_fill(writer->text, ' ', indent + INDENT);
            write_block(writer, child, indent + INDENT);
        }
        if (writer->text->failed)
            return;
    }
}

void lx_write_flow(struct lx_text *text, const struct lx_document *document, lx_node_id id, bool json)
{
    struct writer writer = {.document = document, .text = text, .json = json};
    write_flow(&writer, id, SIZE_MAX);
}

void lx_write_tidy(struct lx_text *text, const struct lx_document *document)
{
    struct writer writer = {.document = document, .text = text};
    if (lx_document_node(document, document->root)->first)
        write_block(&writer, document->root, 0);
    else
        lx_text_puts(text, "{}\n");
}

void lx_write_whole(struct lx_text *text, const struct lx_document *document, bool json)
{
    if (!json) {
        lx_write_tidy(text, document);
        return;
    }
    lx_write_flow(text, document, document->root, true);
    lx_text_puts(text, "\n");
}
