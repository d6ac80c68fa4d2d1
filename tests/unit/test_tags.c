/* SPDX-License-Identifier: MIT */
/*
 * Texts that PNG and EXR files carry: what was written comes back, what other programs write is understood, and
 * damaged or hostile files end in one message: wrong checksums, lengths beyond the file, texts that unpack without
 * end.
 */
#include "files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static const char SCENE[] = "# комментарий\nname: \"Лампа\"\n";

/* ---- what Luxel writes ---- */

static void assert_tags(const char *path, const struct lx_tag *expected, size_t count)
{
    struct lx_source *source;
    struct lx_tags tags = {0};

    assert_int_equal(lx_source_open(path, 0, NULL, &source), LUXEL_OK);
    const struct lx_format *format = lx_format_of_content(source);
    assert_int_equal(format->read_tags(source, &tags), LUXEL_OK);
    assert_int_equal(tags.count, count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_read_tag *tag = lx_tags_find(&tags, expected[i].key);
        assert_non_null(tag);
        assert_int_equal(tag->length, strlen(expected[i].value));
        assert_string_equal(tag->value, expected[i].value);
    }
    lx_tags_clear(&tags);
    lx_source_close(source);
}

static void test_written(void **state)
{
    struct files *files = *state;
    char *long_text = malloc(3000001);
    float value = 1;
    uint8_t grey = 1;
    memset(long_text, 'a', 3000000);
    long_text[3000000] = '\0';
    const struct lx_tag tags[] = {{"luxel:unit", "W/(sr·m²)"}, {"luxel:scene", SCENE}, {"luxel:long", long_text}};
    struct lx_image image = {.columns = 1, .rows = 1, .channels = 1, .tags = tags, .tag_count = 3};

    for (size_t i = 0; i < 2; i++) {
        image.sample = i ? LX_SAMPLE_F32 : LX_SAMPLE_U8;
        image.data = i ? (const void *)&value : &grey;
        snprintf(files->path, sizeof files->path, "%s/a%s", files->folder, i ? ".exr" : ".png");
        assert_int_equal(lx_write_image(files->path, &image, NULL), LUXEL_OK);
        assert_tags(files->path, tags, 3);
    }
    free(long_text);
}

/* ---- PNG files put together by hand ---- */

struct bytes {
    unsigned char *at;
    size_t length;
};

static void add(struct bytes *bytes, const void *more, size_t length)
{
    bytes->at = realloc(bytes->at, bytes->length + length + 1);
    memcpy(bytes->at + bytes->length, more, length);
    bytes->length += length;
}

static void add_number(struct bytes *bytes, uint32_t number)
{
    unsigned char four[] = {(unsigned char)(number >> 24), (unsigned char)(number >> 16), (unsigned char)(number >> 8),
                            (unsigned char)number};
    add(bytes, four, 4);
}

static void add_chunk(struct bytes *bytes, const char *type, const void *data, size_t length)
{
    add_number(bytes, (uint32_t)length);
    size_t start = bytes->length;
    add(bytes, type, 4);
    add(bytes, data, length);
    add_number(bytes, (uint32_t)crc32(0, bytes->at + start, (uInt)(length + 4)));
}

static struct bytes begin_png(void)
{
    struct bytes bytes = {0};
    add(&bytes, "\x89PNG\r\n\x1a\n", 8);
    add_chunk(&bytes, "IHDR", "\0\0\0\1\0\0\0\1\x08\0\0\0\0", 13);
    return bytes;
}

/* Reads the tags of the bytes; the one of the scene must be this text, or the reading must fail with this id. */
static void assert_scene(struct bytes *bytes, const char *text, const char *id)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_source *source;
    struct lx_tags tags = {0};

    assert_int_equal(lx_source_of_bytes("it.png", bytes->at, bytes->length, diagnostics, &source), LUXEL_OK);
    luxel_status status = lx_format_of_content(source)->read_tags(source, &tags);
    assert_int_equal(status, id ? LUXEL_ERROR_FILE : LUXEL_OK);
    assert_int_equal(luxel_diagnostics_count(diagnostics), id ? 1 : 0);
    if (id) {
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->source, "it.png");
    } else if (text) {
        assert_non_null(lx_tags_find(&tags, "luxel:scene"));
        assert_string_equal(lx_tags_find(&tags, "luxel:scene")->value, text);
    } else {
        assert_int_equal(tags.count, 0);
    }
    lx_tags_clear(&tags);
    lx_source_close(source);
    luxel_diagnostics_free(diagnostics);
    free(bytes->at);
}

/* A chunk of this type with a key, what stands between, and a text, which is packed if asked for. */
static void add_text(struct bytes *bytes, const char *type, const char *between, size_t between_length,
                     const char *text, bool packed)
{
    struct bytes data = {0};
    uLongf size = compressBound(strlen(text));
    unsigned char *small = malloc(size);

    compress(small, &size, (const Bytef *)text, strlen(text));
    add(&data, "luxel:scene", 12);
    add(&data, between, between_length);
    add(&data, packed ? small : (const void *)text, packed ? size : strlen(text));
    add_chunk(bytes, type, data.at, data.length);
    free(data.at);
    free(small);
}

static void test_png_kinds(void **state)
{
    struct bytes png = begin_png();
    (void)state;
    add_text(&png, "tEXt", "", 0, SCENE, false);
    add_chunk(&png, "IEND", "", 0);
    assert_scene(&png, SCENE, NULL);

    png = begin_png();
    add_text(&png, "zTXt", "\0", 1, SCENE, true);
    add_chunk(&png, "IEND", "", 0);
    assert_scene(&png, SCENE, NULL);

    png = begin_png(); /* with a language and a translated key, behind the picture */
    add_chunk(&png, "tEXt", "Title\0luxel", 11);
    add_chunk(&png, "IDAT", "not looked at", 13);
    add_text(&png, "iTXt", "\1\0ru\0\xd0\xa1\0", 8, SCENE, true);
    add_text(&png, "iTXt", "\0\0\0\0", 4, "a second one", false);
    add_chunk(&png, "IEND", "", 0);
    assert_scene(&png, SCENE, NULL);

    png = begin_png();
    add_chunk(&png, "IDAT", "", 0);
    add_chunk(&png, "IEND", "", 0);
    assert_scene(&png, NULL, NULL);
}

static void test_png_damaged(void **state)
{
    struct bytes png = begin_png();
    (void)state;
    add_text(&png, "iTXt", "\0\0\0\0", 4, SCENE, false);
    png.at[60] ^= 1;
    assert_scene(&png, NULL, "bad-checksum");

    png = begin_png();
    add_text(&png, "iTXt", "\0\0\0\0", 4, SCENE, false);
    assert_scene(&png, NULL, "file-ends"); /* without its end */

    png = begin_png();
    add_number(&png, 0x7fffffff);
    add(&png, "iTXtluxel:scene\0", 16);
    assert_scene(&png, NULL, "file-ends");

    png = begin_png();
    add_number(&png, 0xffffffff);
    add(&png, "iTXtluxel:scene\0", 16);
    assert_scene(&png, NULL, "bad-file");

    png = begin_png();
    add_chunk(&png, "i\0Xt", "", 0);
    assert_scene(&png, NULL, "bad-file");

    png = (struct bytes){0};
    add(&png, "\x89PNG\r\n\x1a\n", 8);
    add_chunk(&png, "IEND", "", 0);
    assert_scene(&png, NULL, "bad-file");
}

static void test_png_bad_texts(void **state)
{
    static const struct {
        const char *type, *between;
        size_t length;
        bool packed;
    } cases[] = {{"iTXt", "\2\0\0\0", 4, false}, {"iTXt", "\1\1\0\0", 4, true}, {"zTXt", "\1", 1, true},
                 {"iTXt", "\1\0\0\0", 4, false}, {"zTXt", "\0x", 2, true},      {"iTXt", "\0", 1, false}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct bytes png = begin_png();
        add_text(&png, cases[i].type, cases[i].between, cases[i].length, "a", cases[i].packed);
        assert_scene(&png, NULL, "bad-file");
    }
}

/* 100 MB of zeros make 100 kB. */
static void test_png_bomb(void **state)
{
    size_t large = 100 << 20;
    char *text = malloc(large + 1);
    struct bytes png = begin_png();

    (void)state;
    memset(text, ' ', large);
    text[large] = '\0';
    add_text(&png, "zTXt", "\0", 1, text, true);
    assert_true(png.length < 200000);
    assert_scene(&png, NULL, "tag-too-large");
    png = begin_png();
    add_text(&png, "tEXt", "", 0, text, false);
    assert_scene(&png, NULL, "tag-too-large");
    free(text);
}

/* Texts that are small one by one: two of 40 MB, and five thousand empty ones. */
static void test_png_many_texts(void **state)
{
    size_t large = 40 << 20, size = compressBound(large);
    char *text = calloc(large, 1);
    struct bytes packed = {malloc(size + 20), 0}, png = begin_png();

    (void)state;
    memcpy(packed.at, "luxel:a\0", 9); /* the key, and how it is compressed */
    compress(packed.at + 9, &size, (const Bytef *)text, large);
    packed.length = 9 + size;
    for (int i = 0; i < 2; i++) {
        add_chunk(&png, "zTXt", packed.at, packed.length);
        packed.at[6] = 'b';
    }
    assert_scene(&png, NULL, "tag-too-large");

    png = begin_png();
    for (int i = 0; i < 5000; i++) {
        char key[24];
        snprintf(key, sizeof key, "luxel:%d", i);
        add_chunk(&png, "tEXt", key, strlen(key) + 1);
    }
    assert_scene(&png, NULL, "tag-too-large");

    png = begin_png();
    add_text(&png, "tEXt", "", 0, SCENE, false);
    for (int i = 0; i < 4; i++)
        add_chunk(&png, "none", text, large); /* of other programs */
    assert_scene(&png, NULL, "bad-file");
    free(packed.at);
    free(text);
}

/* ---- EXR headers put together by hand ---- */

static void add_attribute(struct bytes *bytes, const char *name, const char *type, uint32_t claimed, const char *value,
                          size_t length)
{
    unsigned char size[] = {(unsigned char)claimed, (unsigned char)(claimed >> 8), (unsigned char)(claimed >> 16),
                            (unsigned char)(claimed >> 24)};
    add(bytes, name, strlen(name) + 1);
    add(bytes, type, strlen(type) + 1);
    add(bytes, size, 4);
    add(bytes, value, length);
}

static struct bytes begin_exr(unsigned char flags)
{
    unsigned char start[] = {0x76, 0x2f, 0x31, 0x01, 2, flags, 0, 0};
    struct bytes bytes = {0};
    add(&bytes, start, sizeof start);
    return bytes;
}

static void test_exr_kinds(void **state)
{
    struct bytes exr = begin_exr(0x10 | 2); /* several parts of tiles: the texts do not care */
    (void)state;
    add_attribute(&exr, "luxel:scene", "int", 4, "1234", 4);
    add_attribute(&exr, "owner", "string", 2, "me", 2);
    add_attribute(&exr, "luxel:scene", "string", sizeof SCENE - 1, SCENE, sizeof SCENE - 1);
    add(&exr, "", 1);
    assert_scene(&exr, SCENE, NULL);
}

static void test_exr_damaged(void **state)
{
    struct bytes exr = begin_exr(0);
    (void)state;
    add_attribute(&exr, "luxel:scene", "string", 0x7fffffff, SCENE, sizeof SCENE);
    assert_scene(&exr, NULL, "file-ends");

    exr = begin_exr(0);
    add_attribute(&exr, "luxel:scene", "string", 0xfffffff0, SCENE, sizeof SCENE);
    assert_scene(&exr, NULL, "bad-file");

    exr = begin_exr(0);
    add_attribute(&exr, "luxel:scene", "string", 4, "abcd", 4);
    assert_scene(&exr, NULL, "file-ends"); /* no end of the header */

    exr = begin_exr(0x20);
    add(&exr, "", 1);
    assert_scene(&exr, NULL, "bad-file"); /* a flag that does not exist */

    char name[300];
    memset(name, 'n', sizeof name);
    exr = begin_exr(0);
    add(&exr, name, sizeof name);
    assert_scene(&exr, NULL, "bad-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FILES_CASE(written),  FILES_CASE(png_kinds),      FILES_CASE(png_damaged), FILES_CASE(png_bad_texts),
        FILES_CASE(png_bomb), FILES_CASE(png_many_texts), FILES_CASE(exr_kinds),   FILES_CASE(exr_damaged),
    };

    return cmocka_run_group_tests_name("tags", tests, NULL, NULL);
}
