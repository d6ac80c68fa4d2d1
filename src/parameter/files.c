/* SPDX-License-Identifier: MIT */
/* Files that a scene names: where they are, and what is in them. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/source.h"
#include "check.h"

char *lx_check_path(const struct lx_check *check, const char *file)
{
    const char *folder = check->walk->folder;
    struct lx_text path = {0};
    if (folder && folder[0] && file[0] != '/') {
        lx_text_puts(&path, folder);
        lx_text_puts(&path, folder[strlen(folder) - 1] == '/' ? "" : "/");
    }
    lx_text_puts(&path, file);
    char *joined = lx_text_take(&path);
    if (!joined)
        check->walk->out_of_memory = true;
    return joined;
}

/* The file is there but not for us: an error of another kind than those of what is written in a scene. */
static void report_unread(const struct lx_check *check, const char *key, const struct lx_source *source)
{
    const char *reason = lx_source_reason(source);
    if (lx_source_status(source) == LUXEL_ERROR_MEMORY) {
        check->walk->out_of_memory = true;
        return;
    }
    if (!reason)
        reason = LX_N("it became shorter while it was read");
    lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_NAMED_FILE_NOT_READ,
                    LX_ARGS(lx_source_name(source), LX_TERM(reason)));
    check->walk->unread++;
}

char *lx_check_read(const struct lx_check *check, const char *key, const char *path, size_t most, size_t *length)
{
    enum { MEGABYTE = 1 << 20 };
    struct lx_source *source = lx_source_try(path, most);
    char *text = NULL;
    if (source && lx_source_status(source) == LUXEL_OK && lx_source_size(source) > most) {
        struct lx_text limit = {0};
        lx_text_printf(&limit, "%zu MB", most / MEGABYTE);
        char *words = lx_text_take(&limit);
        lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_FILE_TOO_LARGE, LX_ARGS(path, words ? words : ""));
        free(words);
        lx_source_close(source);
        return NULL;
    }
    if (source && lx_source_status(source) == LUXEL_OK)
        text = lx_new_array((size_t)lx_source_size(source) + 1, 1);
    if (text && lx_source_read(source, 0, text, (size_t)lx_source_size(source)) == LUXEL_OK) {
        *length = (size_t)lx_source_size(source);
    } else if (source && lx_source_status(source) != LUXEL_OK) {
        report_unread(check, key, source);
        free(text);
        text = NULL;
    } else {
        check->walk->out_of_memory = true;
    }
    lx_source_close(source);
    return text;
}
