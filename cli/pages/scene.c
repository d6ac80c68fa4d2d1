/* SPDX-License-Identifier: MIT */
/* docs/SCENE.md: every key of a scene in tables, group by group, with an example of every kind.  English only. */
#include <ctype.h>
#include <string.h>

#include "pages.h"

static const char introduction[] =
    "# The scene file\n\n"
    "<!-- Made from the parameter tables by `build/cli/pages/luxel-pages scene > docs/SCENE.md`. -->\n\n"
    "A scene is one document in YAML 1.2, and so may be JSON; anchors, aliases and tags (& * !) are not used in it, "
    "nor numbers other than decimal ones. This is the scene `report`, which is built in and the "
    "default of every command:\n\n";

static const char conventions[] =
    "- Axes are right-handed. The screen lies in z = 0, centred on the origin, x to the right, y up. The observer is "
    "at "
    "(0, 0, z) and looks along -z; or it stands at a position, looks at a target, and the screen is carried there as a "
    "whole, its middle to the target, its z axis towards the observer.\n"
    "- Lengths are millimetres, angles degrees. A distance that enters an attenuation law is converted to metres "
    "first.\n"
    "- Units are given here by their radiometric names. `units: photometric` makes W/sr cd, W/m² lx, W/(sr·m²) cd/m² "
    "and W lm; numbers stay as they are.\n"
    "- Numbers are decimal, with a point, and finite. Words and truth values are written as they stand here: `true`, "
    "not `True`.\n"
    "- A value outside its legal range is an error, and so is an unknown, doubled or missing key. A value outside its "
    "advised range is fine; `luxel check` lists it, and `--strict` makes it an error.\n"
    "- A key that has no effect beside the others is accepted; `luxel check` mentions it.\n"
    "- Beyond the tables, for pictures and points of the screen: pixels must be square, that is screen.width / columns "
    "= screen.height / rows, and the observer must stand outside of all surfaces, orthographic above them. A plate "
    "that "
    "shows its back is not drawn. Free elements, grids, glare and reflected light ask neither for a screen nor for an "
    "observer, nor for surfaces.\n"
    "- On the command line a key is changed by its path: `-s screen.width=800`, `-s lights[0].intensity=20` or "
    "`-s lights.0.intensity=20`.\n\n"
    "`luxel schema > luxel.schema.json` writes all this for editors. One that uses yaml-language-server completes keys "
    "and marks errors in a scene that begins with\n\n"
    "```yaml\n# yaml-language-server: $schema=luxel.schema.json\n```\n";

static void print_sentence(FILE *out, const char *text)
{
    const bool is_symbol = text[strcspn(text, ", ")] == ',';

    fprintf(out, "%c%s.", is_symbol ? text[0] : toupper((unsigned char)text[0]), text + 1);
}

static const char *report_text(void)
{
    for (size_t i = 0; luxel_builtin_scene_name(i); i++)
        if (strcmp(luxel_builtin_scene_name(i), "report") == 0)
            return luxel_builtin_scene_text(i);
    return "";
}

/* ---- a row ---- */

/* Each of "a, b" in backquotes. */
static void print_words(FILE *out, const char *words, const char *separator)
{
    while (*words) {
        const size_t length = strcspn(words, ",");

        fprintf(out, "`%.*s`", (int)length, words);
        words += length;
        if (*words) {
            fputs(separator, out);
            words += strspn(words, ", ");
        }
    }
}

static void print_value(FILE *out, const luxel_parameter *parameter)
{
    if (parameter->choices) {
        print_words(out, parameter->choices, ", ");
        if (strstr(parameter->type, "[low, high]"))
            fputs(", or [low, high]", out);
        if (strstr(parameter->type, "whole number"))
            fprintf(out, ", or a whole number, %s", parameter->legal ? parameter->legal : "any");
    } else if (parameter->legal) {
        fprintf(out, "%s, %s", parameter->type, parameter->legal);
    } else {
        fprintf(out, "%s%s%s", parameter->type, *parameter->unit ? " in " : "", parameter->unit);
    }
}

static void print_rule(FILE *out, const luxel_parameter_rule *rule)
{
    static const char *const starts[] = {
        [LUXEL_RULE_EXCLUDES] = "Not together with",     [LUXEL_RULE_NEEDED] = "Required with",
        [LUXEL_RULE_USED] = "Has an effect only with",   [LUXEL_RULE_AT_MOST] = "At most",
        [LUXEL_RULE_DIFFERS] = "Must differ from",       [LUXEL_RULE_POSITIVE] = "Must be > 0 with",
        [LUXEL_RULE_ONE_OF] = "Exactly one is given of",
    };

    fprintf(out, " %s", starts[rule->kind]);
    if (rule->other)
        fprintf(out, " %s", rule->other);
    if (rule->choices) {
        fputc(' ', out);
        print_words(out, rule->choices, rule->other ? " or " : ", ");
    }
    fputc('.', out);
}

static void print_row(FILE *out, const luxel_parameter *parameter)
{
    fprintf(out, "| %s | ", pages_last_name(parameter->path));
    print_value(out, parameter);
    if (parameter->required)
        fputs(" | required", out);
    else if (parameter->default_value)
        fprintf(out, " | `%s`", parameter->default_value);
    else
        fputs(" |", out);
    fprintf(out, " | %s%s| ", parameter->advised ? parameter->advised : "", parameter->advised ? " " : "");
    print_sentence(out, parameter->meaning);
    for (size_t i = 0; i < parameter->rule_count; i++)
        print_rule(out, &parameter->rules[i]);
    fputs(" |\n", out);
}

/* ---- a group ---- */

static size_t group_length(const char *path)
{
    return (size_t)(pages_last_name(path) - path);
}

static bool same_group(const luxel_parameter *a, const luxel_parameter *b)
{
    const size_t length = group_length(a->path);

    return length == group_length(b->path) && strncmp(a->path, b->path, length) == 0 &&
           (a->variant == b->variant || (a->variant && b->variant && strcmp(a->variant, b->variant) == 0));
}

static bool is_first_of_group(const luxel_parameters *parameters, size_t i)
{
    for (size_t k = 0; k < i; k++)
        if (same_group(luxel_parameters_get(parameters, k), luxel_parameters_get(parameters, i)))
            return false;
    return true;
}

static void print_kind(FILE *out, const luxel_parameters *parameters, const luxel_parameter *first)
{
    const luxel_parameter_kind *kind;

    for (size_t i = 0; (kind = luxel_parameters_kind(parameters, i)) != NULL; i++) {
        if (strcmp(kind->name, first->variant) != 0 || strncmp(kind->list, first->path, strlen(kind->list)) != 0)
            continue;
        fprintf(out, "### %s: type %s\n\n", kind->list, kind->name);
        print_sentence(out, kind->meaning);
        fputs("\n\n", out);
        if (kind->example)
            fprintf(out, "```yaml\n%s:\n  - %s\n```\n\n", kind->list, kind->example);
    }
}

static bool has_kinds(const luxel_parameters *parameters, const char *list)
{
    const luxel_parameter_kind *kind;

    for (size_t i = 0; (kind = luxel_parameters_kind(parameters, i)) != NULL; i++)
        if (strcmp(kind->list, list) == 0)
            return true;
    return false;
}

/* The group's own parameter gives its meaning; a list's is without the "[]" of its elements. */
static void print_group_heading(FILE *out, const luxel_parameters *parameters, const luxel_parameter *first)
{
    const size_t length = group_length(first->path);
    char path[128];

    if (length == 0) {
        fputs("## The whole\n\n", out);
        return;
    }
    snprintf(path, sizeof path, "%.*s", (int)length - 1, first->path);
    if (strcmp(path + length - 3, "[]") == 0)
        path[length - 3] = '\0';
    fprintf(out, "%s %s\n\n", strchr(path, '.') ? "###" : "##", path);
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, i);

        if (strcmp(parameter->path, path) != 0)
            continue;
        print_sentence(out, parameter->meaning);
        if (strchr(first->path + length - 2, ']'))
            fputs(has_kinds(parameters, path) ? " Each has these keys, and those of its type."
                                              : " Each has these keys.",
                  out);
        fputs("\n\n", out);
        return;
    }
}

/* Whether it stands in a group of its type: lights[].rectangle.size. */
static bool is_below_kind(const luxel_parameter *parameter)
{
    const char *end = strstr(parameter->path, "[].");

    return parameter->variant && end && strchr(end + 3, '.');
}

/* "lights: rectangle of type planar", and the meaning that the key of the group has. */
static void print_group_of_kind(FILE *out, const luxel_parameters *parameters, const luxel_parameter *first)
{
    const size_t length = group_length(first->path) - 1;
    const char *list_end = strstr(first->path, "[].");

    fprintf(out, "#### %.*s: %.*s of type %s\n\n", (int)(list_end - first->path), first->path,
            (int)(first->path + length - list_end - 3), list_end + 3, first->variant);
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, i);

        if (!parameter->variant || strcmp(parameter->variant, first->variant) != 0 ||
            strncmp(parameter->path, first->path, length) != 0 || parameter->path[length] != '\0')
            continue;
        print_sentence(out, parameter->meaning);
        fputs("\n\n", out);
    }
}

static void print_group(FILE *out, const luxel_parameters *parameters, size_t i)
{
    const luxel_parameter *first = luxel_parameters_get(parameters, i);

    fputc('\n', out);
    if (is_below_kind(first))
        print_group_of_kind(out, parameters, first);
    else if (first->variant)
        print_kind(out, parameters, first);
    else
        print_group_heading(out, parameters, first);
    fputs("| key | value | default | advised | meaning |\n|---|---|---|---|---|\n", out);
    for (size_t k = i; k < luxel_parameters_count(parameters); k++)
        if (same_group(luxel_parameters_get(parameters, k), first))
            print_row(out, luxel_parameters_get(parameters, k));
}

void pages_scene(FILE *out, const luxel_parameters *parameters)
{
    fputs(introduction, out);
    fprintf(out, "```yaml\n%s```\n\n", report_text());
    fputs(conventions, out);
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        if (is_first_of_group(parameters, i))
            print_group(out, parameters, i);
}
