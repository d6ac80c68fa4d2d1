/* SPDX-License-Identifier: MIT */
/*
 * The way into luxel-pages: `luxel-pages man`, `luxel-pages scene`, and `luxel-pages bash|zsh|fish SCRIPT`, which
 * prints the script with its line @TABLES@ replaced.  Without a translation the pages are English, whatever the locale.
 */
#include "pages.h"

#include <string.h>

#include "../cli.h"
#include "../options.h"
#if defined LUXEL_FIGURES
#include <luxel/figure.h>
#endif

static const char placeholder[] = "@TABLES@\n";

bool pages_is_key(const luxel_parameters *parameters, size_t i)
{
    const char *path = luxel_parameters_get(parameters, i)->path;
    const size_t length = strlen(path);

    for (size_t k = 0; k < luxel_parameters_count(parameters); k++) {
        const char *other = luxel_parameters_get(parameters, k)->path;

        if ((k < i && strcmp(path, other) == 0) ||
            (strncmp(path, other, length) == 0 && (other[length] == '.' || other[length] == '[')))
            return false;
    }
    return true;
}

const char *pages_key_words(const luxel_parameter *parameter, char buffer[PAGES_WORDS])
{
    const char *initial = parameter->default_value;
    size_t used = 0;

    /* Truth values are the only ones with these defaults, and they all have one. */
    if (!parameter->choices)
        return initial && (strcmp(initial, "true") == 0 || strcmp(initial, "false") == 0) ? "true false" : "";
    for (const char *at = parameter->choices; *at && used < PAGES_WORDS - 1; at++)
        if (*at != ',')
            buffer[used++] = *at;
    buffer[used] = '\0';
    return buffer;
}

void pages_print_keys(FILE *out, const luxel_parameters *parameters, const char *before, const char *after)
{
    char words[PAGES_WORDS];

    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        if (pages_is_key(parameters, i)) {
            const luxel_parameter *parameter = luxel_parameters_get(parameters, i);
            const char *choices = pages_key_words(parameter, words);

            fprintf(out, "%s'%s%s%s'%s", before, parameter->path, *choices ? " " : "", choices, after);
        }
}

const char *pages_last_name(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot ? dot + 1 : path;
}

bool pages_is_first_name(const luxel_parameters *parameters, size_t i)
{
    const char *name = pages_last_name(luxel_parameters_get(parameters, i)->path);

    for (size_t k = 0; k < i; k++)
        if (strcmp(name, pages_last_name(luxel_parameters_get(parameters, k)->path)) == 0)
            return false;
    return true;
}

/* A word of an option's list, by its number; NULL beyond the last. */
static const char *option_word(const struct option_row *row, size_t i, char room[32])
{
    if (row->words)
        return row->words[i];
#if defined LUXEL_FIGURES
    if (row->value == VALUE_PALETTE)
        return luxel_palette_name(i);
#endif
    if (row->value != VALUE_ROOM || i >= LUXEL_UGR_ROOMS)
        return NULL;
    snprintf(room, 32, "%g,%g", luxel_ugr_room(i, 0), luxel_ugr_room(i, 1));
    return room;
}

const char *pages_option_words(const struct option_row *row, char buffer[512])
{
    char room[32];
    const char *word;
    size_t used = 0;

    for (size_t i = 0; (word = option_word(row, i, room)) != NULL && used < 512; i++)
        used += (size_t)snprintf(buffer + used, 512 - used, "%s%s", i > 0 ? " " : "", word);
    return used > 0 ? buffer : NULL;
}

void pages_print_endings(FILE *out, const char *before, const char *after)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        for (size_t k = 0; options_row(k); k++) {
            char endings[128];

            if (options_row(k)->value == VALUE_OUTPUT && (options_row(k)->commands & commands[i]->bit))
                fprintf(out, "%s'%s %s'%s", before, commands[i]->name,
                        command_endings(commands[i], endings, sizeof endings), after);
        }
}

void pages_quote(FILE *out, const char *text)
{
    fputc('\'', out);
    for (; *text; text++)
        fputs(*text == '\'' ? "'\\''" : (const char[]){*text, '\0'}, out);
    fputc('\'', out);
}

static int fill_script(const char *path, void (*tables)(FILE *, const luxel_parameters *),
                       const luxel_parameters *parameters)
{
    char line[512];
    FILE *script = fopen(path, "r");

    if (!script) {
        perror(path);
        return 1;
    }
    while (fgets(line, sizeof line, script))
        if (strcmp(line, placeholder) == 0)
            tables(stdout, parameters);
        else
            fputs(line, stdout);
    fclose(script);
    return 0;
}

static int write_page(int argc, char **argv, const luxel_parameters *parameters)
{
    static const struct {
        const char *name;
        void (*write)(FILE *, const luxel_parameters *);
        bool has_script;
    } pages[] = {
        {"man", pages_man, false}, {"scene", pages_scene, false}, {"bash", pages_bash, true},
        {"zsh", pages_zsh, true},  {"fish", pages_fish, true},
    };

    for (size_t i = 0; i < sizeof pages / sizeof pages[0]; i++) {
        if (argc != 2 + pages[i].has_script || strcmp(argv[1], pages[i].name) != 0)
            continue;
        if (pages[i].has_script)
            return fill_script(argv[2], pages[i].write, parameters);
        pages[i].write(stdout, parameters);
        return 0;
    }
    fputs("usage: luxel-pages man|scene, or luxel-pages bash|zsh|fish SCRIPT\n", stderr);
    return 2;
}

int main(int argc, char **argv)
{
    luxel_parameters *parameters = luxel_parameters_new();
    int code = parameters ? write_page(argc, argv, parameters) : 1;

    luxel_parameters_free(parameters);
    return fflush(stdout) == 0 && !ferror(stdout) ? code : 1;
}
