/* SPDX-License-Identifier: MIT */
/* Files that a scene names: where they are, and what is in them. */
#include <stdlib.h>
#include <string.h>

#include "../base/builtin_file.h"
#include "../base/memory.h"
#include "../base/path.h"
#include "check.h"

char *lx_check_path(const struct lx_check *check, const char *file)
{
    const char *folder = check->walk->folder;
    struct lx_text path = {0};
    if (folder && folder[0] && !lx_path_is_absolute(file) && !lx_is_builtin_path(file)) {
        lx_text_puts(&path, folder);
        lx_text_puts(&path, *lx_path_name(folder) == '\0' ? "" : "/");
    }
    lx_text_puts(&path, file);
    char *joined = lx_text_take(&path);
    if (!joined)
        check->walk->out_of_memory = true;
    return joined;
}

/* Paths of Windows have backslashes, which double quotes take for escapes and other systems for letters. */
static void hint_backslash(const struct lx_check *check, const char *key, const char *name)
{
    const struct lx_document *document = check->walk->document;
    lx_node_id id = lx_document_find(document, check->mapping, key);
    const struct lx_place place = lx_document_place(document, id);
    const bool is_quoted = id && place.start < place.end && place.text[place.start] == '"';
    if (strchr(name, '\\'))
        lx_check_hint(check, LX_MSG_HINT_SLASH, NULL);
    else if (is_quoted && memchr(place.text + place.start, '\\', place.end - place.start))
        lx_check_hint(check, LX_MSG_HINT_BACKSLASH, NULL);
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
    const char *name = lx_source_name(source);
    lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_NAMED_FILE_NOT_READ,
                    LX_ARGS(name[0] ? name : "\"\"", LX_TERM(reason)));
    hint_backslash(check, key, name);
    check->walk->unread++;
}

struct lx_kept *lx_check_kept(const struct lx_check *check, const char *path, void (*free)(struct lx_kept *kept))
{
    struct lx_kept_files *files = check->walk->kept;
    struct lx_kept *kept = files ? lx_kept_find(files, path, free) : NULL;
    return kept ? lx_kept_hold(kept) : NULL;
}

void lx_check_keep(const struct lx_check *check, const char *path, struct lx_kept *kept)
{
    struct lx_kept_files *files = check->walk->kept;
    if (!files)
        return;
    if (lx_kept_add(files, path, kept) < 0)
        check->walk->out_of_memory = true;
    else
        files->items[files->count - 1].state = check->walk->opened;
}

struct lx_source *lx_check_open(const struct lx_check *check, const char *key, const char *path, size_t most)
{
    enum { MEGABYTE = 1 << 20 };
    check->walk->opened = lx_file_state_of(path);
    struct lx_source *source = lx_source_try(path, most);
    if (!source) {
        check->walk->out_of_memory = true;
        return NULL;
    }
    if (lx_source_status(source) == LUXEL_OK && lx_source_size(source) > most) {
        struct lx_text limit = {0};
        lx_text_printf(&limit, "%zu MB", most / MEGABYTE);
        char *words = lx_text_take(&limit);
        lx_check_report(check, key, LX_ALL_OF_IT, LX_MSG_FILE_TOO_LARGE, LX_ARGS(path, words ? words : ""));
        free(words);
    } else if (lx_source_status(source) == LUXEL_OK) {
        return source;
    }
    lx_check_close(check, key, source);
    return NULL;
}

bool lx_check_close(const struct lx_check *check, const char *key, struct lx_source *source)
{
    bool is_read = source && lx_source_status(source) == LUXEL_OK;
    if (source && !is_read)
        report_unread(check, key, source);
    lx_source_close(source);
    return is_read;
}

char *lx_check_read(const struct lx_check *check, const char *key, const char *path, size_t most, size_t *length)
{
    struct lx_source *source = lx_check_open(check, key, path, most);
    if (!source)
        return NULL;
    *length = (size_t)lx_source_size(source);
    char *text = lx_new_array(*length + 1, 1);
    if (text)
        lx_source_read(source, 0, text, *length);
    else
        check->walk->out_of_memory = true;
    if (lx_check_close(check, key, source))
        return text;
    free(text);
    return NULL;
}
