/* SPDX-License-Identifier: MIT */
/* Drawings as text: pairs of lines, a code for what follows and that (AutoCAD Release 12 DXF reference). */
#include "dxf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../base/vector.h"

enum { DIGITS = 12 };

static void add(struct lx_text *text, int code, const char *value)
{
    lx_text_printf(text, "%d\r\n%s\r\n", code, value);
}

static void add_whole(struct lx_text *text, int code, size_t value)
{
    lx_text_printf(text, "%d\r\n%zu\r\n", code, value);
}

static void add_number(struct lx_text *text, int code, double value)
{
    char number[LX_NUMBER_SIZE];
    add(text, code, lx_write_digits(value + 0.0, DIGITS, number));
}

/* The coordinates have codes ten apart. */
static void add_place(struct lx_text *text, int code, const double place[3])
{
    for (int i = 0; i < 3; i++)
        add_number(text, code + 10 * i, place[i]);
}

/* Release 12 knows no UTF-8: other characters than those of ASCII are named. */
static void add_words(struct lx_text *text, int code, const char *words)
{
    size_t length = strlen(words), size;
    uint32_t character;
    lx_text_printf(text, "%d\r\n", code);
    for (; length > 0; words += size, length -= size) {
        size = lx_next_character(words, length, &character);
        if (size == 0 || (size == 1 && (character < ' ' || character == 127)))
            lx_text_puts(text, "?"), size = 1;
        else if (size == 1)
            lx_text_add(text, words, 1);
        else if (character <= 0xffff)
            lx_text_printf(text, "\\U+%04X", (unsigned)character);
        else
            lx_text_puts(text, "?");
    }
    lx_text_puts(text, "\r\n");
}

void lx_dxf_add_layer(struct lx_dxf *dxf, struct lx_dxf_layer *layer)
{
    for (char *at = layer->name; *at; at++) {
        const bool is_small = *at >= 'a' && *at <= 'z';
        const bool is_good = (*at >= 'A' && *at <= 'Z') || (*at >= '0' && *at <= '9') || strchr("$-_", *at);
        *at = is_small ? (char)(*at - 'a' + 'A') : is_good ? *at : '_';
    }
    for (size_t i = 0; i < dxf->layer_count; i++)
        if (strcmp(dxf->layers[i].name, layer->name) == 0)
            return;
    if (lx_reserve(&dxf->layers, &dxf->layer_capacity, dxf->layer_count + 1, sizeof *dxf->layers) < 0)
        dxf->entities.failed = true;
    else
        dxf->layers[dxf->layer_count++] = *layer;
}

static void reach(struct lx_dxf *dxf, const double place[3])
{
    for (int i = 0; i < 3; i++) {
        dxf->low[i] = dxf->has_extent ? fmin(dxf->low[i], place[i]) : place[i];
        dxf->high[i] = dxf->has_extent ? fmax(dxf->high[i], place[i]) : place[i];
    }
    dxf->has_extent = true;
}

void lx_dxf_add_line(struct lx_dxf *dxf, const struct lx_dxf_layer *layer, const double (*places)[3], size_t count,
                     bool is_closed)
{
    static const double none[3] = {0};
    struct lx_text *text = &dxf->entities;
    add(text, 0, "POLYLINE");
    add(text, 8, layer->name);
    add(text, 66, "1"); /* vertices follow */
    add_place(text, 10, none);
    add(text, 70, is_closed ? "9" : "8"); /* in space */
    for (size_t i = 0; i < count; i++) {
        add(text, 0, "VERTEX");
        add(text, 8, layer->name);
        add_place(text, 10, places[i]);
        add(text, 70, "32");
        reach(dxf, places[i]);
    }
    add(text, 0, "SEQEND");
    add(text, 8, layer->name);
}

/* The axes that a plane of this normal has in such drawings, whatever is on it. */
static void find_axes(const double normal[3], double x[3], double y[3])
{
    const bool is_level = fabs(normal[0]) < 1.0 / 64 && fabs(normal[1]) < 1.0 / 64;
    const double from[3] = {0, is_level ? 1 : 0, is_level ? 0 : 1};
    lx_cross(from, normal, x);
    lx_normalize(x);
    lx_cross(normal, x, y);
}

void lx_dxf_add_words(struct lx_dxf *dxf, const struct lx_dxf_layer *layer, const struct lx_dxf_words *words)
{
    struct lx_text *text = &dxf->entities;
    double x[3], y[3];
    find_axes(words->normal, x, y);
    add(text, 0, "TEXT");
    add(text, 8, layer->name);
    add_place(text, 10,
              (const double[]){lx_dot(words->place, x), lx_dot(words->place, y), lx_dot(words->place, words->normal)});
    add_number(text, 40, words->height);
    add_words(text, 1, words->text);
    add_number(text, 50, atan2(lx_dot(words->along, y), lx_dot(words->along, x)) * 180 / M_PI);
    add_place(text, 210, words->normal);
    reach(dxf, words->place);
}

static void begin_section(struct lx_text *text, const char *name)
{
    add(text, 0, "SECTION");
    add(text, 2, name);
}

static void begin_table(struct lx_text *text, const char *name, size_t count)
{
    add(text, 0, "TABLE");
    add(text, 2, name);
    add_whole(text, 70, count);
}

static void add_tables(const struct lx_dxf *dxf, struct lx_text *text)
{
    begin_section(text, "TABLES");
    begin_table(text, "LTYPE", 1);
    add(text, 0, "LTYPE");
    add(text, 2, "CONTINUOUS");
    add(text, 70, "0");
    add(text, 3, "Solid line");
    add(text, 72, "65");
    add(text, 73, "0");
    add(text, 40, "0");
    add(text, 0, "ENDTAB");
    begin_table(text, "LAYER", dxf->layer_count);
    for (size_t i = 0; i < dxf->layer_count; i++) {
        add(text, 0, "LAYER");
        add(text, 2, dxf->layers[i].name);
        add(text, 70, "0");
        add_whole(text, 62, (size_t)dxf->layers[i].color);
        add(text, 6, "CONTINUOUS");
    }
    add(text, 0, "ENDTAB");
    add(text, 0, "ENDSEC");
}

void lx_dxf_finish(struct lx_dxf *dxf, const char *comment, struct lx_text *text)
{
    add_words(text, 999, comment);
    begin_section(text, "HEADER");
    add(text, 9, "$ACADVER");
    add(text, 1, "AC1009");
    add(text, 9, "$EXTMIN");
    add_place(text, 10, dxf->low);
    add(text, 9, "$EXTMAX");
    add_place(text, 10, dxf->high);
    add(text, 0, "ENDSEC");
    add_tables(dxf, text);
    begin_section(text, "ENTITIES");
    lx_text_add(text, dxf->entities.bytes ? dxf->entities.bytes : "", dxf->entities.length);
    add(text, 0, "ENDSEC");
    add(text, 0, "EOF");
    text->failed = text->failed || dxf->entities.failed;
    lx_text_clear(&dxf->entities);
    free(dxf->layers);
    *dxf = (struct lx_dxf){.layers = NULL};
}
