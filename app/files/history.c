/* SPDX-License-Identifier: MIT */
/* Steps as differences of texts; the ones that can be undone lie before `present`, the others behind. */
#include "history.h"

#include <string.h>

typedef struct Step {
    gsize offset; /* where the texts differ first */
    char *removed;
    char *inserted;
    char *topic;
} Step;

struct AppHistory {
    GPtrArray *steps;
    guint present;   /* how many of them can be undone */
    gboolean is_top; /* whether the last call added a step, with which the next one may be merged */
};

static void free_step(gpointer data)
{
    Step *step = data;
    g_free(step->removed);
    g_free(step->inserted);
    g_free(step->topic);
    g_free(step);
}

/* Bytes, not characters: what is put together again is the whole text. */
static Step *new_step(const char *before, const char *after, const char *topic)
{
    gsize before_length = strlen(before), after_length = strlen(after), head = 0, tail = 0;
    const gsize shorter = MIN(before_length, after_length);
    while (head < shorter && before[head] == after[head])
        head++;
    while (tail < shorter - head && before[before_length - 1 - tail] == after[after_length - 1 - tail])
        tail++;
    Step *step = g_new0(Step, 1);
    step->offset = head;
    step->removed = g_strndup(before + head, before_length - head - tail);
    step->inserted = g_strndup(after + head, after_length - head - tail);
    step->topic = g_strdup(topic);
    return step;
}

static char *splice(const char *text, gsize offset, const char *removed, const char *inserted)
{
    GString *result = g_string_new_len(text, (gssize)offset);
    g_string_append(result, inserted);
    g_string_append(result, text + offset + strlen(removed));
    return g_string_free(result, FALSE);
}

AppHistory *app_history_new(void)
{
    AppHistory *history = g_new0(AppHistory, 1);
    history->steps = g_ptr_array_new_with_free_func(free_step);
    return history;
}

void app_history_free(AppHistory *history)
{
    if (!history)
        return;
    g_ptr_array_unref(history->steps);
    g_free(history);
}

void app_history_clear(AppHistory *history)
{
    g_ptr_array_set_size(history->steps, 0);
    history->present = 0;
    history->is_top = FALSE;
}

static Step *last_step(const AppHistory *history)
{
    return history->present > 0 ? g_ptr_array_index(history->steps, history->present - 1) : NULL;
}

void app_history_add(AppHistory *history, const char *before, const char *after, const char *topic, gboolean merge)
{
    Step *last = last_step(history);
    char *earlier = NULL;
    if (merge && history->is_top && last && g_strcmp0(last->topic, topic) == 0) {
        earlier = splice(before, last->offset, last->inserted, last->removed);
        before = earlier;
        history->present--;
    }
    g_ptr_array_set_size(history->steps, (int)history->present);
    /* a drag that ends where it began is no step, and if it goes on it must not become one with the drag before */
    history->is_top = strcmp(before, after) != 0;
    if (history->is_top) {
        g_ptr_array_add(history->steps, new_step(before, after, topic));
        history->present++;
    }
    g_free(earlier);
}

char *app_history_undo(AppHistory *history, const char *text)
{
    const Step *step = last_step(history);
    if (!step)
        return NULL;
    history->present--;
    history->is_top = FALSE;
    return splice(text, step->offset, step->inserted, step->removed);
}

char *app_history_redo(AppHistory *history, const char *text)
{
    if (!app_history_can_redo(history))
        return NULL;
    const Step *step = g_ptr_array_index(history->steps, history->present++);
    history->is_top = FALSE;
    return splice(text, step->offset, step->removed, step->inserted);
}

gboolean app_history_can_undo(const AppHistory *history)
{
    return history->present > 0;
}

gboolean app_history_can_redo(const AppHistory *history)
{
    return history->present < history->steps->len;
}

const char *app_history_undo_topic(const AppHistory *history)
{
    const Step *step = last_step(history);
    return step ? step->topic : NULL;
}

const char *app_history_redo_topic(const AppHistory *history)
{
    return app_history_can_redo(history) ? ((Step *)g_ptr_array_index(history->steps, history->present))->topic : NULL;
}
