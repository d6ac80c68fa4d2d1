/* SPDX-License-Identifier: MIT */
/*
 * File formats for arrays of numbers, in one table by the ending of the file's name.  A format writes a plain image
 * to a sink and reads one from a source; it knows nothing of scenes and fields.  To add one: a file like pfm.c, and
 * a line in the table of format.c.
 */
#ifndef LX_FORMAT_FORMAT_H
#define LX_FORMAT_FORMAT_H

#include "../base/sink.h"
#include "../base/source.h"
#include "tags.h"

/* The most columns and rows that are read. */
enum { LX_MOST_PIXELS = 65536 };

/* What the samples of an image are; one bit each, so that a format can name several. */
enum lx_sample_type { LX_SAMPLE_U8 = 1, LX_SAMPLE_F32 = 2, LX_SAMPLE_F64 = 4, LX_SAMPLE_U16 = 8 };

/*
 * An image to write: rows x columns x channels samples, row 0 on top, without gaps.  All is the caller's.  What
 * comes behind the data may be left out; a format that has no place for it passes over it.  Of an image that is
 * written strip by strip data and mask stand in the strips.
 */
struct lx_image {
    unsigned columns, rows;
    unsigned channels; /* 1, or 3: linear sRGB or, of whole numbers, sRGB */
    enum lx_sample_type sample;
    const void *data;          /* uint8_t, uint16_t, float or double in the host's byte order */
    const uint8_t *mask;       /* rows x columns, 1 where there is a value; NULL: everywhere */
    const double *x_mm, *y_mm; /* the places of the columns and of the rows; NULL: not known */
    const char *unit;          /* of the samples; NULL: not known */
    const struct lx_tag *tags; /* texts that belong to the image */
    size_t tag_count;
};

/* Rows of an image, one below the other, from row `first` on; data and mask begin with that row. */
struct lx_image_strip {
    unsigned first, rows;
    const void *data;
    const uint8_t *mask;
};

/* A file that is being written, for its format. */
struct lx_writer {
    const struct lx_format *format;
    struct lx_image image;
    struct lx_sink *sink;
    void *own; /* the format's */
};

/* An image that was read; start with {0}.  It owns everything. */
struct lx_loaded {
    unsigned columns, rows;
    enum lx_sample_type sample; /* LX_SAMPLE_F32 or LX_SAMPLE_F64 */
    void *values;               /* float or double, aligned for vectors */
    uint8_t *mask;              /* NULL: the file tells none */
    double *x_mm, *y_mm;        /* NULL: the file tells no places */
    char *unit;                 /* NULL: the file tells none */
    struct lx_tags tags;
};

struct lx_format {
    const char *ending; /* lower case, with its dot: ".png" */
    const char *name;   /* as people call it: "PNG" */
    unsigned samples;   /* the kinds of samples that it takes: bits of enum lx_sample_type */
    bool needs_places;  /* whether an image without x_mm and y_mm cannot be written */
    const char *magic;  /* the bytes that its files begin with; NULL: any */
    size_t magic_length;
    bool bottom_up; /* whether the last row comes first, so that strips need a sink that can seek */
    /* Write what stands before the rows; the strips of an image, each once, from the top on; and what stands behind.
     * A failure is the sink's to keep; after one only `end` is called.  `begin` NULL: this build cannot write it. */
    void (*begin)(struct lx_writer *writer);
    void (*add)(struct lx_writer *writer, const struct lx_image_strip *strip);
    void (*end)(struct lx_writer *writer,
                bool whole); /* frees `own`; not whole: the file is given up.  NULL: nothing */
    /* Reads an image; NULL: its files hold no values.  A failure is the source's to keep, and is returned. */
    luxel_status (*read)(struct lx_source *source, struct lx_loaded *loaded);
    /* Reads only the tags, whatever the image is like; NULL: its files carry none. */
    luxel_status (*read_tags)(struct lx_source *source, struct lx_tags *tags);
};

/* Samples of a row. */
static inline size_t lx_row_samples(const struct lx_image *image)
{
    return (size_t)image->columns * image->channels;
}

extern const struct lx_format lx_format_png, lx_format_npy, lx_format_pfm, lx_format_csv, lx_format_exr;

/*
 * The format for the ending of a file's name, in whatever case: "a/b.PNG".  Where there is none, says so with
 * the endings that are known.  LUXEL_ERROR_ARGUMENT.
 */
luxel_status lx_find_format(const char *path, luxel_diagnostics *diagnostics, const struct lx_format **format);

/* The format that a file's first bytes tell, whatever its name is; NULL where they tell none. */
const struct lx_format *lx_format_of_content(struct lx_source *source);

/* The ending of the i-th format, NULL beyond the last. */
const char *lx_format_ending(size_t i);

/*
 * Begins a file in the format of its ending; what `image` points to must live as long as the writer, as `diagnostics`
 * must.  LUXEL_ERROR_ARGUMENT: no such format, or one that takes no image of this kind.  LUXEL_ERROR_FILE.
 */
luxel_status lx_writer_open(const struct lx_destination *destination, const struct lx_image *image,
                            luxel_diagnostics *diagnostics, struct lx_writer **writer);

/* Whether it takes several strips; else the first must be the whole image. */
bool lx_writer_takes_strips(const struct lx_writer *writer);

/* Writes the next strip.  A failure is reported once and kept. */
void lx_writer_add(struct lx_writer *writer, const struct lx_image_strip *strip);

/* Puts the file in its place, or gives it up (NULL is harmless); both free the writer. */
luxel_status lx_writer_commit(struct lx_writer *writer);
void lx_writer_abort(struct lx_writer *writer);

/* Writes an image to a file, whole or not at all, as a single strip. */
luxel_status lx_write_image(const char *path, const struct lx_image *image, luxel_diagnostics *diagnostics);

/*
 * Reads an image in the format that its content tells or else its ending.  lx_loaded_clear() is due in any case.
 * LUXEL_ERROR_FILE: it cannot be read, or is none.  LUXEL_ERROR_MEMORY: it would not fit.
 */
luxel_status lx_read_image(const char *path, luxel_diagnostics *diagnostics, struct lx_loaded *loaded);

/* Reads the image of a source, as lx_read_image() does; a failure is the source's to keep, and is returned. */
luxel_status lx_read_image_of(struct lx_source *source, struct lx_loaded *loaded);
void lx_loaded_clear(struct lx_loaded *loaded);

/*
 * For the formats: writes floating-point samples of a strip, from the i-th on, as little-endian numbers of `width`
 * bytes (4 or 8), rounding where the image has more.
 */
luxel_status lx_write_numbers(struct lx_writer *writer, const struct lx_image_strip *strip, size_t i, size_t count,
                              size_t width);

/* For the formats: fails at once where there is no room for the samples as numbers of `width` bytes. */
void lx_reserve_numbers(struct lx_writer *writer, size_t width);

/*
 * For the formats: makes room for the values of an image whose size and kind of samples are set, zeroed, after
 * checking that both are within the limits.
 */
luxel_status lx_loaded_allocate(struct lx_source *source, struct lx_loaded *loaded);

/*
 * For the formats: checks that the source has as many bytes as the image, in numbers of `width` bytes, behind a header
 * of this length.
 */
luxel_status lx_check_size(struct lx_source *source, const char *name, const struct lx_loaded *loaded, size_t width,
                           size_t header);

/*
 * For the formats: reads `count` numbers of the image's kind from an offset on, and puts them to every `stride`-th
 * place of the values from place `first` on.
 */
luxel_status lx_read_numbers(struct lx_source *source, uint64_t offset, bool big_endian, struct lx_loaded *loaded,
                             size_t first, size_t stride, size_t count);

/* For the formats: a file that is not as it should be; `part` is the word of the format for what is wrong. */
luxel_status lx_bad_file(struct lx_source *source, const char *name, const char *part);

/* For the formats: a file in order from which yet no field can be read; `expected` NULL: no hint. */
luxel_status lx_unfit_file(struct lx_source *source, const char *name, const char *part, const char *value,
                           const char *expected);

#endif
