/* SPDX-License-Identifier: MIT */
/* What YAML makes of scalars without quotes: which are texts, which are safe anywhere, which may stay as they are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "parameter/plain.h"

struct word {
    const char *text;
    bool is_text, is_safe, is_writable;
};

static const struct word words[] = {
    {"", false, false, false},        {"a", true, true, true},         {"Z9", true, true, true},
    {"_", true, true, true},          {"\xc3\xa4", true, true, true},  {"window (left)", true, true, true},
    {"two  words", true, true, true}, {"a/b+c-d.e", true, true, true}, {"a ", true, false, false},
    {" a", true, false, false},       {"a:b", true, false, false},     {"a,b", true, false, false},
    {"a#b", true, false, false},      {"a\tb", true, false, false},    {"a\x01", true, false, false},
    {"9a", true, false, true},        {"(a)", true, false, true},      {"/a", true, false, true},
    {"-a", true, false, true},        {"-", true, false, false},       {"- a", true, false, false},
    {"--", true, false, false},       {"--a", true, false, false},     {"~", false, false, true},
    {"~a", true, false, false},       {"null", false, false, true},    {"Null", false, false, true},
    {"NULL", false, false, true},     {"nULL", true, false, true},     {"nul", true, true, true},
    {"nulls", true, true, true},      {"true", false, false, true},    {"tRue", true, false, true},
    {"FALSE", false, false, true},    {"yes", true, false, true},      {"No", true, false, true},
    {"on", true, false, true},        {"off", true, false, true},      {"y", true, false, true},
    {"N", true, false, true},         {"nan", true, false, true},      {"inf", true, false, true},
    {".nan", false, false, true},     {".NaN", false, false, true},    {".nAn", true, false, true},
    {".inf", false, false, true},     {"-.inf", false, false, true},   {"+.INF", false, false, true},
    {"+.iNF", true, false, true},     {"-inf", true, false, true},     {"-~", true, false, false},
    {"-true", true, false, true},     {"0", false, false, true},       {"-1.5e3", false, false, true},
    {"+7", false, false, true},       {"1.5.2", true, false, true},    {"0x", true, false, true},
    {"0x1F", false, false, true},     {"-0xa", false, false, true},    {"0xg", true, false, true},
    {"0o17", false, false, true},     {"0o", true, false, true},       {"0b1", true, false, true},
    {"e5", true, true, true},
};

static void plain_words(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        const struct word *word = &words[i];
        if (lx_plain_is_text(word->text) != word->is_text || lx_plain_is_safe(word->text) != word->is_safe ||
            lx_plain_is_writable(word->text) != word->is_writable)
            fail_msg("\"%s\": text %d, safe %d, writable %d", word->text, lx_plain_is_text(word->text),
                     lx_plain_is_safe(word->text), lx_plain_is_writable(word->text));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(plain_words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
