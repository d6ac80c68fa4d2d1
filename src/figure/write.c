/* SPDX-License-Identifier: MIT */
/* Figures to files: PNG with fast compression, SVG and PDF, all whole or not at all and the same for the same input. */
#include <math.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "../base/diagnostics.h"
#include "../base/ending.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/sink.h"
#include "../base/text.h"
#include "figure.h"
#include "sheet.h"

static const char *const endings[] = {".png", ".svg", ".pdf"};
enum { PNG, SVG, PDF };

static const double POINTS = 72 / 25.4; /* of a millimetre */

luxel_status luxel_check_figure_name(const char *path, luxel_diagnostics *diagnostics)
{
    size_t found;
    return lx_find_ending(path, endings, sizeof endings / sizeof endings[0], diagnostics, &found);
}

static double height_of(const struct lx_page_sheet *sheet)
{
    return sheet->draw(sheet->what, NULL, sheet->width_mm * POINTS);
}

static void paint(const struct lx_page_sheet *sheet, cairo_t *cairo, double width)
{
    struct lx_canvas canvas = lx_canvas_of(cairo, sheet->dark);
    lx_color(&canvas, canvas.ground, 1);
    cairo_paint(cairo);
    lx_canvas_clear(&canvas);
    sheet->draw(sheet->what, cairo, width);
}

/* ---- PNG ---- */

static void append(png_structp png, png_bytep bytes, size_t count)
{
    lx_text_add(png_get_io_ptr(png), (const char *)bytes, count);
}

static void flush(png_structp png)
{
    (void)png;
}

/* Level 3 without filters is many times faster than libpng's default and larger by little. */
static bool encode(cairo_surface_t *image, double dots_per_inch, struct lx_text *bytes)
{
    const int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    unsigned char *row = malloc((size_t)width * 3);
    bool done = png && info && row && !setjmp(png_jmpbuf(png));
    if (done) {
        png_set_write_fn(png, bytes, append, flush);
        png_set_compression_level(png, 3);
        png_set_filter(png, 0, PNG_FILTER_NONE);
        png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_uint_32 density = (png_uint_32)lround(dots_per_inch / 0.0254);
        png_set_pHYs(png, info, density, density, PNG_RESOLUTION_METER);
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_write_info(png, info);
        for (int y = 0; y < height; y++) {
            const unsigned char *from =
                cairo_image_surface_get_data(image) + (size_t)y * (size_t)cairo_image_surface_get_stride(image);
            for (int x = 0; x < width; x++) {
                uint32_t pixel;
                memcpy(&pixel, from + 4 * (size_t)x, sizeof pixel);
                row[3 * x] = pixel >> 16 & 255;
                row[3 * x + 1] = pixel >> 8 & 255;
                row[3 * x + 2] = pixel & 255;
            }
            png_write_row(png, row);
        }
        png_write_end(png, NULL);
    }
    png_destroy_write_struct(&png, &info);
    free(row);
    return done && !bytes->failed;
}

static bool draw_png(const struct lx_page_sheet *sheet, struct lx_text *bytes)
{
    double width = sheet->width_mm * POINTS, height = height_of(sheet);
    double scale = sheet->dots_per_inch / 72;
    cairo_surface_t *image =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)lround(width * scale), (int)lround(height * scale));
    cairo_t *cairo = cairo_create(image);
    cairo_scale(cairo, scale, scale);
    paint(sheet, cairo, width);
    cairo_surface_flush(image);
    bool done = cairo_status(cairo) == CAIRO_STATUS_SUCCESS && encode(image, sheet->dots_per_inch, bytes);
    cairo_destroy(cairo);
    cairo_surface_destroy(image);
    return done;
}

/* Pictures of more dots than that cannot be drawn on. */
static luxel_status check_dots(const struct lx_page_sheet *sheet, luxel_diagnostics *diagnostics)
{
    enum { MOST_DOTS = 32767 };
    double longest = fmax(sheet->width_mm * POINTS, height_of(sheet));
    double most = floor(MOST_DOTS / longest * 72);
    char given[LX_NUMBER_SIZE], number[LX_NUMBER_SIZE], bound[LX_NUMBER_SIZE + 8] = "≤ ";
    if (sheet->dots_per_inch <= most)
        return LUXEL_OK;
    strcat(bound, lx_write_number(most, number));
    return lx_refuse(diagnostics, LX_MSG_SETTING_OUT_OF_RANGE,
                     LX_ARGS("dots_per_inch", lx_write_number(sheet->dots_per_inch, given), bound));
}

luxel_status lx_sheet_png(const struct lx_page_sheet *sheet, luxel_diagnostics *diagnostics, unsigned char **bytes,
                          size_t *length)
{
    struct lx_text text = {0};
    if (!draw_png(sheet, &text)) {
        lx_text_clear(&text);
        return lx_out_of_memory(diagnostics);
    }
    *length = text.length;
    *bytes = (unsigned char *)text.bytes;
    return LUXEL_OK;
}

/* ---- SVG and PDF ---- */

static cairo_status_t collect(void *data, const unsigned char *bytes, unsigned count)
{
    struct lx_text *text = data;
    lx_text_add(text, (const char *)bytes, count);
    return text->failed ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

static bool draw_vector(const struct lx_page_sheet *sheet, size_t format, struct lx_text *bytes)
{
    double width = sheet->width_mm * POINTS, height = height_of(sheet);
    cairo_surface_t *surface = format == PDF ? cairo_pdf_surface_create_for_stream(collect, bytes, width, height)
                                             : cairo_svg_surface_create_for_stream(collect, bytes, width, height);
    if (format == PDF) {
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, sheet->title);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "Luxel");
        /* a date would make two files of the same figure differ */
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    } else {
        cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PT);
    }
    cairo_t *cairo = cairo_create(surface);
    paint(sheet, cairo, width);
    bool done = cairo_status(cairo) == CAIRO_STATUS_SUCCESS;
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    done = done && cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS && !bytes->failed;
    cairo_surface_destroy(surface);
    return done;
}

luxel_status lx_sheet_write(const struct lx_page_sheet *sheet, const struct lx_destination *destination,
                            luxel_diagnostics *diagnostics)
{
    struct lx_text bytes = {0};
    size_t format;
    luxel_status status =
        lx_find_ending(destination->path, endings, sizeof endings / sizeof endings[0], diagnostics, &format);
    if (status == LUXEL_OK && format == PNG)
        status = check_dots(sheet, diagnostics);
    if (status == LUXEL_OK && !(format == PNG ? draw_png(sheet, &bytes) : draw_vector(sheet, format, &bytes)))
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = lx_sink_put(destination, bytes.bytes, bytes.length, diagnostics);
    lx_text_clear(&bytes);
    return status;
}

/* ---- figures of scenes ---- */

static double draw_figure(const void *figure, cairo_t *cairo, double width)
{
    return lx_figure_draw(figure, cairo, width);
}

static struct lx_page_sheet sheet_of(const struct lx_figure *figure)
{
    return (struct lx_page_sheet){.title = figure->title,
                                  .width_mm = figure->settings.width_mm,
                                  .dots_per_inch = figure->settings.dots_per_inch,
                                  .dark = figure->settings.dark,
                                  .draw = draw_figure,
                                  .what = figure};
}

luxel_status lx_figure_png(const struct lx_figure *figure, luxel_diagnostics *diagnostics, unsigned char **bytes,
                           size_t *length)
{
    const struct lx_page_sheet sheet = sheet_of(figure);
    return lx_sheet_png(&sheet, diagnostics, bytes, length);
}

static luxel_status write_to(const struct lx_destination *destinations, size_t count, const luxel_scene *scene,
                             const luxel_settings *settings, const luxel_figure_settings *wanted,
                             luxel_diagnostics *diagnostics, bool *written)
{
    struct lx_figure *figure = NULL;
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        status = luxel_check_figure_name(destinations[i].path, diagnostics);
    if (status == LUXEL_OK)
        status = lx_figure_make(scene, settings, wanted, NULL, diagnostics, &figure);
    if (status == LUXEL_OK) {
        const struct lx_page_sheet sheet = sheet_of(figure);
        for (size_t i = 0; i < count; i++) {
            const luxel_status one = lx_sheet_write(&sheet, &destinations[i], diagnostics);
            written[i] = one == LUXEL_OK;
            status = one == LUXEL_OK ? status : one;
        }
    }
    lx_figure_free(figure);
    return status;
}

luxel_status luxel_figure_write(const luxel_scene *scene, const luxel_settings *settings,
                                const luxel_figure_settings *figure, const char *path, luxel_diagnostics *diagnostics)
{
    bool written;
    return write_to(&(struct lx_destination){.path = path}, 1, scene, settings, figure, diagnostics, &written);
}

luxel_status luxel_figure_write_files(const luxel_scene *scene, const luxel_settings *settings,
                                      const luxel_figure_settings *figure, const char *const *paths, size_t count,
                                      luxel_diagnostics *diagnostics, bool *written)
{
    struct lx_destination *destinations = lx_destinations_of(paths, count);
    memset(written, 0, count * sizeof *written);
    const luxel_status status = destinations
                                    ? write_to(destinations, count, scene, settings, figure, diagnostics, written)
                                    : lx_out_of_memory(diagnostics);
    free(destinations);
    return status;
}

luxel_status luxel_figure_write_memory(const luxel_scene *scene, const luxel_settings *settings,
                                       const luxel_figure_settings *figure, const char *name,
                                       luxel_diagnostics *diagnostics, unsigned char **bytes, size_t *length)
{
    bool written;
    return write_to(&(struct lx_destination){name, bytes, length}, 1, scene, settings, figure, diagnostics, &written);
}

/* ---- drawings of documents ---- */

static void draw_part(void *cairo, void *data)
{
    const struct lx_figure *figure = data;
    lx_figure_draw(figure, cairo, figure->settings.width_mm * POINTS);
}

static void release_part(void *data)
{
    lx_figure_free(data);
}

struct lx_drawing lx_figure_drawing(struct lx_figure *figure)
{
    double width = figure->settings.width_mm * POINTS;
    return (struct lx_drawing){.width_pt = width,
                               .height_pt = lx_figure_draw(figure, NULL, width),
                               .draw = draw_part,
                               .release = release_part,
                               .data = figure};
}
