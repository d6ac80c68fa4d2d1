/* SPDX-License-Identifier: MIT */
/*
 * From YAML events to a document.  Events and not libfyaml's own documents, because those take 60 times the
 * memory and compare every key with every other.  What scenes do not need and attackers like (anchors,
 * aliases, tags, keys that are lists, deep nesting) is refused as it comes.
 */
#include <libfyaml.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/text.h"
#include "guard.h"
#include "yaml.h"

/* An open mapping or sequence. */
struct level {
    lx_node_id id, last;
    bool mapping, flow;
    bool has_key; /* and its value comes next */
    uint32_t key, key_start, key_end;
};

struct reader {
    struct lx_document *document;
    luxel_diagnostics *diagnostics;
    struct lx_place place; /* the source */
    size_t shift;          /* from positions of the parser to those of the source */
    unsigned outer_depth, depth;
    struct level levels[LX_DEEPEST];
    size_t last_end; /* of the last event that has a place */
    unsigned documents;
    lx_node_id root;
};

static luxel_status refuse(struct reader *reader, size_t start, size_t end, enum lx_message message,
                           const char *const *arguments)
{
    reader->place.start = start;
    reader->place.end = end;
    lx_report(reader->diagnostics, LUXEL_SEVERITY_ERROR, &reader->place, message, arguments);
    return LUXEL_ERROR_SCENE;
}

/* ---- places ---- */

static size_t position(const struct reader *reader, const struct fy_mark *mark, size_t otherwise)
{
    if (!mark)
        return otherwise;
    size_t at = mark->input_pos + reader->shift;
    return at > reader->place.length ? reader->place.length : at;
}

/* The stretch of an event; one without a place stands where the last one ended. */
static void stretch(struct reader *reader, struct fy_event *event, size_t *start, size_t *end)
{
    *start = position(reader, fy_event_start_mark(event), reader->last_end);
    *end = position(reader, fy_event_end_mark(event), *start);
    if (event->type == FYET_SCALAR && *end >= *start) {
        /* the parser's marks leave the quotes out */
        enum fy_scalar_style style = fy_token_scalar_style(event->scalar.value);
        bool quoted = style == FYSS_SINGLE_QUOTED || style == FYSS_DOUBLE_QUOTED;
        if (quoted && *start > 0 && *end < reader->place.length) {
            *start -= 1;
            *end += 1;
        }
    }
    reader->last_end = *end;
}

/* A dash without a value has no place of its own: find the dash. */
static void find_dash(const struct reader *reader, size_t *start, size_t *end)
{
    for (size_t i = *start; i < reader->place.length; i++)
        if (reader->place.text[i] == '-') {
            *start = i;
            *end = i + 1;
            return;
        }
}

/* ---- building the tree ---- */

static luxel_status out_of_memory(struct reader *reader)
{
    return lx_out_of_memory(reader->diagnostics);
}

/* Hangs a node under the innermost open level. */
static luxel_status place_node(struct reader *reader, struct lx_node node, lx_node_id *id)
{
    struct level *level = reader->depth ? &reader->levels[reader->depth - 1] : NULL;
    node.source = (uint32_t)(reader->document->source_count - 1) & (LX_MOST_SOURCES - 1);
    if (level && level->mapping) {
        node.key = level->key;
        node.key_start = level->key_start;
        node.key_end = level->key_end;
        level->has_key = false;
    }
    if (reader->document->node_count >= LX_MOST_OF_DOCUMENT)
        return refuse(reader, node.start, node.end, LX_MSG_TOO_MANY_VALUES, LX_ARGS(LX_TERM(LX_N("16 million"))));
    if (lx_document_add_node(reader->document, node, id) < 0)
        return out_of_memory(reader);
    if (!level)
        reader->root = *id;
    else if (level->last)
        reader->document->nodes[level->last].next = *id;
    else
        reader->document->nodes[level->id].first = *id;
    if (level)
        level->last = *id;
    return LUXEL_OK;
}

static bool expects_key(const struct reader *reader)
{
    return reader->depth && reader->levels[reader->depth - 1].mapping && !reader->levels[reader->depth - 1].has_key;
}

/* The text of a scalar, which escapes may have filled with what no text should hold. */
static luxel_status add_text(struct reader *reader, struct fy_event *event, size_t start, size_t end, uint32_t *offset)
{
    size_t length = 0;
    const char *text = fy_token_get_text(event->scalar.value, &length);
    if (!text)
        return out_of_memory(reader);
    for (size_t i = 0, size; i < length; i += size) {
        uint32_t code = 0;
        size = lx_next_character(text + i, length - i, &code);
        if (size == 0 || code == 0) {
            refuse(reader, start, end, LX_MSG_BAD_ESCAPE, NULL);
            lx_hint(reader->diagnostics, LX_MSG_HINT_BACKSLASH, NULL);
            return LUXEL_ERROR_SCENE;
        }
    }
    return lx_document_add_text(reader->document, text, length, offset) < 0 ? out_of_memory(reader) : LUXEL_OK;
}

static luxel_status on_scalar(struct reader *reader, struct fy_event *event, size_t start, size_t end)
{
    uint32_t text;
    luxel_status status = add_text(reader, event, start, end, &text);
    if (status != LUXEL_OK)
        return status;
    struct level *level = reader->depth ? &reader->levels[reader->depth - 1] : NULL;
    if (expects_key(reader)) {
        level->has_key = true;
        level->key = text;
        level->key_start = (uint32_t)start;
        level->key_end = (uint32_t)end;
        return LUXEL_OK;
    }
    bool plain = fy_token_scalar_style(event->scalar.value) == FYSS_PLAIN;
    if (plain && start == end && level && !level->mapping)
        find_dash(reader, &start, &end);
    struct lx_node node = {
        .kind = LX_SCALAR, .plain = plain, .text = text, .start = (uint32_t)start, .end = (uint32_t)end};
    lx_node_id id;
    return place_node(reader, node, &id);
}

static luxel_status on_open(struct reader *reader, size_t start, size_t end, bool mapping)
{
    if (expects_key(reader))
        return refuse(reader, start, end, LX_MSG_COMPLEX_KEY, NULL);
    if (reader->outer_depth + reader->depth >= LX_DEEPEST)
        return refuse(reader, start, end, LX_MSG_TOO_DEEP, LX_ARGS("32"));
    struct lx_node node = {.kind = mapping ? LX_MAPPING : LX_SEQUENCE, .start = (uint32_t)start, .end = (uint32_t)end};
    struct level level = {.mapping = mapping, .flow = end > start};
    luxel_status status = place_node(reader, node, &level.id);
    if (status == LUXEL_OK)
        reader->levels[reader->depth++] = level;
    return status;
}

static luxel_status on_close(struct reader *reader, size_t end)
{
    reader->document->nodes[reader->levels[--reader->depth].id].end = (uint32_t)end;
    return LUXEL_OK;
}

/* Anchors, aliases and tags. */
static luxel_status check_decorations(struct reader *reader, struct fy_event *event)
{
    struct fy_token *token = NULL;
    if (event->type == FYET_SCALAR)
        token = event->scalar.anchor ? event->scalar.anchor : event->scalar.tag;
    else if (event->type == FYET_MAPPING_START)
        token = event->mapping_start.anchor ? event->mapping_start.anchor : event->mapping_start.tag;
    else if (event->type == FYET_SEQUENCE_START)
        token = event->sequence_start.anchor ? event->sequence_start.anchor : event->sequence_start.tag;
    else if (event->type == FYET_ALIAS)
        token = event->alias.anchor;
    if (!token)
        return LUXEL_OK;
    size_t start = position(reader, fy_token_start_mark(token), reader->last_end);
    size_t end = position(reader, fy_token_end_mark(token), start);
    if (start > 0 && strchr("&*!", reader->place.text[start - 1]))
        start--;
    return refuse(reader, start, end, LX_MSG_NO_ANCHORS, NULL);
}

static luxel_status on_event(struct reader *reader, struct fy_event *event)
{
    if (event->type == FYET_STREAM_START || event->type == FYET_STREAM_END)
        return LUXEL_OK;
    size_t start, end;
    if (event->type == FYET_DOCUMENT_START)
        reader->documents++;
    if (reader->documents > 1 && (event->type != FYET_DOCUMENT_START || fy_event_start_mark(event))) {
        stretch(reader, event, &start, &end);
        return refuse(reader, start, end, LX_MSG_MORE_DOCUMENTS, NULL);
    }
    luxel_status status = check_decorations(reader, event);
    if (status != LUXEL_OK)
        return status;
    stretch(reader, event, &start, &end);
    switch (event->type) {
    case FYET_SCALAR: return on_scalar(reader, event, start, end);
    case FYET_MAPPING_START: return on_open(reader, start, end, true);
    case FYET_SEQUENCE_START: return on_open(reader, start, end, false);
    case FYET_MAPPING_END:
    case FYET_SEQUENCE_END: return on_close(reader, end);
    default: return LUXEL_OK;
    }
}

/* ---- the parser ---- */

/* Whether a text in double quotes has no end because a backslash stands before the quote, as in "C:\". */
static bool escapes_its_end(const struct reader *reader, const char *reason, size_t from)
{
    const char *text = reader->place.text;
    if (!strstr(reason, "without closing quote"))
        return false;
    for (size_t i = from; i + 1 < reader->place.length; i++)
        if (text[i] == '\\' && text[i + 1] == '"')
            return true;
    return false;
}

/* Puts the parser's own first error into ours. */
static luxel_status report_syntax(struct reader *reader, struct fy_diag *diag)
{
    void *iterator = NULL;
    struct fy_diag_error *error = fy_diag_errors_iterate(diag, &iterator);
    while (error && error->type != FYET_ERROR)
        error = fy_diag_errors_iterate(diag, &iterator);
    if (!error || !error->msg) /* for some texts the parser gives no reason */
        return refuse(reader, reader->last_end, reader->last_end, LX_MSG_SYNTAX,
                      LX_ARGS(LX_TERM(LX_N("unreadable behind this place"))));
    const struct fy_mark *mark = error->fyt ? fy_token_start_mark(error->fyt) : NULL;
    size_t from = position(reader, mark, reader->last_end);
    size_t to = position(reader, error->fyt ? fy_token_end_mark(error->fyt) : NULL, from);
    size_t rest = from;
    while (rest < reader->place.length && strchr(" \t\r\n", reader->place.text[rest]))
        rest++;
    if (rest == reader->place.length)
        for (unsigned i = reader->depth; i-- > 0;)
            if (reader->levels[i].flow) {
                /* the end of the text says little: show the bracket that is still open */
                from = reader->document->nodes[reader->levels[i].id].start;
                return refuse(reader, from, from + 1, LX_MSG_NOT_CLOSED, NULL);
            }
    if (strncmp(error->msg, "invalid escape", strlen("invalid escape")) == 0) /* it quotes the escape */
        refuse(reader, from, to, LX_MSG_BAD_ESCAPE, NULL);
    else
        refuse(reader, from, to, LX_MSG_SYNTAX, LX_ARGS(LX_TERM(error->msg)));
    if (strstr(error->msg, "escape") || escapes_its_end(reader, error->msg, from))
        lx_hint(reader->diagnostics, LX_MSG_HINT_BACKSLASH, NULL);
    if (strcmp(error->msg, "could not find expected ':'") == 0)
        lx_hint(reader->diagnostics, LX_MSG_HINT_COLON, NULL);
    return LUXEL_ERROR_SCENE;
}

static luxel_status read_events(struct reader *reader, const char *text, size_t length)
{
    struct fy_diag_cfg diag_settings;
    fy_diag_cfg_default(&diag_settings);
    diag_settings.fp = NULL;
    diag_settings.level = FYET_ERROR;
    struct fy_diag *diag = fy_diag_create(&diag_settings);
    if (!diag)
        return out_of_memory(reader);
    fy_diag_set_collect_errors(diag, true);
    struct fy_parse_cfg settings = {
        .flags = FYPCF_QUIET | FYPCF_COLLECT_DIAG | FYPCF_DEFAULT_VERSION_1_2 | FYPCF_JSON_NONE |
                 FYPCF_ALLOW_DUPLICATE_KEYS | FYPCF_DISABLE_MMAP_OPT | FYPCF_DISABLE_ACCELERATORS,
        .diag = diag,
    };
    struct fy_parser *parser = fy_parser_create(&settings);
    luxel_status status = parser && fy_parser_set_string(parser, text, length) == 0 ? LUXEL_OK : out_of_memory(reader);
    struct fy_event *event = NULL;
    while (status == LUXEL_OK && (event = fy_parser_parse(parser))) {
        status = on_event(reader, event);
        fy_parser_event_free(parser, event);
    }
    if (status == LUXEL_OK && fy_parser_get_stream_error(parser))
        status = report_syntax(reader, diag);
    if (parser)
        fy_parser_destroy(parser);
    fy_diag_destroy(diag);
    return status;
}

/* Where the first token starts, if it opens a flow list or mapping; else the length. */
static size_t find_flow_root(const char *text, size_t length, size_t start)
{
    while (start < length) {
        if (text[start] == '#')
            while (start < length && text[start] != '\n' && text[start] != '\r')
                start++;
        else if (strchr(" \t\r\n", text[start]))
            start++;
        else
            break;
    }
    return start < length && (text[start] == '{' || text[start] == '[') ? start : length;
}

/*
 * A topmost flow mapping (JSON) could still become a key, so the parser would keep all of it: behind an explicit
 * document start it cannot.
 */
static luxel_status read_flow(struct reader *reader, size_t start)
{
    static const char marker[] = {'-', '-', '-', ' '};
    size_t length = reader->place.length - start + sizeof marker;
    char *text = lx_new_array(length, 1);
    if (!text)
        return out_of_memory(reader);
    memcpy(text, marker, sizeof marker);
    memcpy(text + sizeof marker, reader->place.text + start, length - sizeof marker);
    reader->shift = start - sizeof marker;
    luxel_status status = read_events(reader, text, length);
    free(text);
    return status;
}

luxel_status lx_yaml_read(struct lx_document *document, size_t source, size_t start, unsigned depth,
                          luxel_diagnostics *diagnostics, lx_node_id *root)
{
    struct reader reader = {.document = document, .diagnostics = diagnostics, .outer_depth = depth, .shift = start};
    reader.place = lx_document_stretch(document, source, start, start);
    const char *text = reader.place.text;
    size_t length = reader.place.length;
    if (start == 0 && length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        reader.place.start = reader.shift = start = 3;
    luxel_status status = lx_guard_text(&reader.place, diagnostics);
    if (status != LUXEL_OK)
        return status;
    size_t flow = find_flow_root(text, length, start);
    if (flow < length)
        status = read_flow(&reader, flow);
    else
        status = read_events(&reader, text + start, length - start);
    if (status == LUXEL_OK)
        *root = reader.root;
    return status;
}

luxel_status lx_yaml_read_text(const char *text, size_t length, struct lx_document *document)
{
    uint32_t empty;
    char *copy = lx_copy_text(text, length);
    if (!copy || lx_document_add_source(document, "", copy, length) < 0 ||
        lx_document_add_text(document, "", 0, &empty) < 0)
        return LUXEL_ERROR_MEMORY;
    return lx_yaml_read(document, 0, 0, 0, NULL, &document->root);
}
