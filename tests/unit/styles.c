/* SPDX-License-Identifier: MIT */
/* Documents written by chance: in lines or brackets, with quotes and comments, as YAML or JSON. */
#include "styles.h"

#include <string.h>

#include "base/text.h"
#include "scenes.h"

unsigned random_below(uint64_t *seed, unsigned count)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(*seed >> 33) % count;
}

struct writer {
    const struct lx_document *document;
    struct lx_text text;
    uint64_t seed;
    bool json, crlf, comments;
    unsigned comment;   /* how many there are */
    bool in_block_text; /* where a comment would be none */
};

static void write_break(struct writer *writer)
{
    lx_text_puts(&writer->text, writer->crlf ? "\r\n" : "\n");
}

static void write_comment(struct writer *writer)
{
    static const char *const words[] = {"", " plain", "\ttab\t", " свет - лампа", " key: [value", " \"'{"};
    lx_text_printf(&writer->text, "#~%u~%s", writer->comment++, words[random_below(&writer->seed, 6)]);
}

/* Ends a line, with a comment or lines of comments now and then. */
static void end_line(struct writer *writer, size_t indent)
{
    if (writer->in_block_text) {
        writer->in_block_text = false;
        write_break(writer);
        return;
    }
    if (writer->comments && random_below(&writer->seed, 4) == 0) {
        lx_text_puts(&writer->text, random_below(&writer->seed, 2) ? " " : " \t ");
        write_comment(writer);
    }
    write_break(writer);
    if (random_below(&writer->seed, 8) == 0)
        write_break(writer);
    if (writer->comments && random_below(&writer->seed, 6) == 0) {
        lx_text_fill(&writer->text, ' ', indent + random_below(&writer->seed, 3));
        write_comment(writer);
        write_break(writer);
    }
}

static void write_scalar(struct writer *writer, lx_node_id id, bool flow, size_t indent)
{
    const char *string = lx_document_text(writer->document, id);
    bool number = strspn(string, "+-.0123456789e") == strlen(string) || strcmp(string, "true") == 0 ||
                  strcmp(string, "false") == 0;
    unsigned style = number ? 5 : writer->json ? 0 : random_below(&writer->seed, flow ? 5 : 7);
    if (style <= 1)
        lx_text_printf(&writer->text, style ? "'%s'" : "\"%s\"", string);
    else if (style == 6) {
        lx_text_puts(&writer->text, random_below(&writer->seed, 2) ? "|-" : ">-");
        write_break(writer);
        lx_text_fill(&writer->text, ' ', indent + 3);
        lx_text_puts(&writer->text, string);
        writer->in_block_text = true;
    } else
        lx_text_puts(&writer->text, string);
}

static void write_key(struct writer *writer, lx_node_id id)
{
    const char *key = lx_document_key(writer->document, id);
    lx_text_printf(&writer->text, writer->json || random_below(&writer->seed, 12) == 0 ? "\"%s\"" : "%s", key);
}

static void write_flow(struct writer *writer, lx_node_id id, size_t indent)
{
    const struct lx_node *node = lx_document_node(writer->document, id);
    if (node->kind == LX_SCALAR) {
        write_scalar(writer, id, true, indent);
        return;
    }
    bool mapping = node->kind == LX_MAPPING, lines = random_below(&writer->seed, 4) == 0;
    const char *blank = random_below(&writer->seed, 3) ? "" : " ";
    lx_text_printf(&writer->text, "%c%s", mapping ? '{' : '[', blank);
    for (lx_node_id child = node->first; child; child = lx_document_node(writer->document, child)->next) {
        if (child != node->first)
            lx_text_puts(&writer->text, random_below(&writer->seed, 5) || !writer->json ? ", " : ",");
        if (lines) {
            end_line(writer, indent);
            lx_text_fill(&writer->text, ' ', indent + 2);
        }
        if (mapping) {
            write_key(writer, child);
            lx_text_puts(&writer->text, writer->json && random_below(&writer->seed, 2) ? ":" : ": ");
        }
        write_flow(writer, child, indent + 2);
    }
    if (node->first && !writer->json && random_below(&writer->seed, 6) == 0)
        lx_text_puts(&writer->text, ",");
    if (lines) {
        end_line(writer, indent);
        lx_text_fill(&writer->text, ' ', indent + 1);
    }
    lx_text_printf(&writer->text, "%s%c", blank, mapping ? '}' : ']');
}

static void write_block(struct writer *writer, lx_node_id id, size_t indent)
{
    const struct lx_node *node = lx_document_node(writer->document, id);
    for (lx_node_id child = node->first; child; child = lx_document_node(writer->document, child)->next) {
        const struct lx_node *below_it = lx_document_node(writer->document, child);
        bool mapping = node->kind == LX_MAPPING;
        size_t step = mapping && below_it->kind == LX_SEQUENCE ? 2 * random_below(&writer->seed, 2)
                                                               : 2 + random_below(&writer->seed, 3);
        if (child != node->first)
            lx_text_fill(&writer->text, ' ', indent);
        if (mapping)
            write_key(writer, child);
        lx_text_puts(&writer->text, mapping ? ":" : "-");
        if (below_it->kind == LX_SCALAR || !below_it->first || random_below(&writer->seed, 2)) {
            lx_text_fill(&writer->text, ' ', 1 + (random_below(&writer->seed, 6) == 0));
            if (below_it->kind == LX_SCALAR)
                write_scalar(writer, child, false, indent);
            else
                write_flow(writer, child, indent);
            end_line(writer, indent);
        } else if (!mapping && random_below(&writer->seed, 3)) {
            lx_text_puts(&writer->text, " ");
            write_block(writer, child, indent + 2);
        } else {
            end_line(writer, indent);
            lx_text_fill(&writer->text, ' ', indent + step);
            write_block(writer, child, indent + step);
        }
    }
}

char *random_style(const struct lx_document *document, uint64_t seed, bool *json)
{
    struct writer writer = {.document = document, .seed = seed};
    *json = writer.json = random_below(&writer.seed, 4) == 0;
    writer.crlf = random_below(&writer.seed, 4) == 0;
    writer.comments = !writer.json && random_below(&writer.seed, 4);
    if (!writer.json && random_below(&writer.seed, 8) == 0)
        lx_text_puts(&writer.text, "\xEF\xBB\xBF");
    if (writer.json || random_below(&writer.seed, 6) == 0)
        write_flow(&writer, document->root, 0);
    else
        write_block(&writer, document->root, 0);
    char *text = lx_text_take(&writer.text);
    assert_non_null(text);
    return text;
}
