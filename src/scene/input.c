/* SPDX-License-Identifier: MIT */
/*
 * Getting at the text of a scene.  Pipes and devices are read like files, up to the limit, so a text without end is
 * refused like one that is too large; a picture may be as large as it likes, for only its texts are read.
 */
#include <stdlib.h>

#include "../base/encoding.h"
#include "../base/memory.h"
#include "../format/format.h"
#include "guard.h"
#include "input.h"

static luxel_status refuse_size(struct lx_source *source)
{
    return lx_source_fail(source, LUXEL_ERROR_SCENE, LX_MSG_TEXT_TOO_LARGE, LX_ARGS(LX_TERM(LX_N("64 MB"))));
}

/* A text in UTF-16, as PowerShell writes it, becomes UTF-8. */
static luxel_status decode_text(struct lx_source *source, struct lx_input *input)
{
    size_t mark;
    enum lx_encoding encoding = lx_find_encoding(input->text, input->length, &mark);
    if (encoding == LX_UTF8)
        return LUXEL_OK;
    char *text = lx_text_of_utf16(input->text, &input->length, mark, encoding);
    if (!text)
        return lx_source_out_of_memory(source);
    free(input->text);
    input->text = text;
    return input->length > LX_LARGEST_TEXT ? refuse_size(source) : LUXEL_OK;
}

static luxel_status read_text(struct lx_source *source, struct lx_input *input)
{
    if (lx_source_size(source) > LX_LARGEST_TEXT)
        return refuse_size(source);
    input->length = (size_t)lx_source_size(source);
    input->text = lx_new_array(input->length + 1, 1);
    if (!input->text)
        return lx_source_out_of_memory(source);
    luxel_status status = lx_source_read(source, 0, input->text, input->length);
    return status == LUXEL_OK ? decode_text(source, input) : status;
}

static luxel_status refuse_picture(struct lx_source *source, const struct lx_format *format)
{
    luxel_status status = lx_source_refuse(source, LX_MSG_NO_SCENE_INSIDE, LX_ARGS(format->name));
    lx_hint(lx_source_diagnostics(source), LX_MSG_HINT_CARRIES, NULL);
    return status;
}

static luxel_status read_picture(struct lx_source *source, const struct lx_format *format, struct lx_input *input)
{
    struct lx_tags tags = {0};
    lx_source_judge(source, LUXEL_ERROR_SCENE, format->magic, format->magic_length);
    luxel_status status = format->read_tags ? format->read_tags(source, &tags) : LUXEL_OK;
    const struct lx_read_tag *tag = lx_tags_find(&tags, LX_TAG_SCENE);
    if (status == LUXEL_OK && !tag)
        status = refuse_picture(source, format);
    if (status == LUXEL_OK)
        status = lx_carried_read(source, &tags, &input->carried);
    if (status == LUXEL_OK) {
        input->length = tag->length;
        input->text = lx_copy_text(tag->value, tag->length);
        status = input->text ? LUXEL_OK : lx_source_out_of_memory(source);
    }
    lx_tags_clear(&tags);
    return status;
}

luxel_status lx_read_input(struct lx_source *source, struct lx_input *input)
{
    struct lx_input read = {.text = NULL};
    const struct lx_format *format = lx_format_of_content(source);
    luxel_status status = lx_source_status(source);
    if (status == LUXEL_OK)
        status = format ? read_picture(source, format, &read) : read_text(source, &read);
    if (status == LUXEL_OK)
        *input = read;
    else
        free(read.text);
    return status;
}
