/* SPDX-License-Identifier: MIT */
/*
 * Rendering: from a committed scene to a field, or to files, in parallel rows.
 *
 * The result has the same bytes for any number of threads.  Every instruction set keeps the same bounds
 * (luxel_precision).  The call blocks; it may be cancelled through the progress callback.
 */
#ifndef LUXEL_RENDER_H
#define LUXEL_RENDER_H

#include <luxel/field.h>
#include <luxel/scene.h>
#include <luxel/settings.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * For a scene that was read from a picture: sets quantity, precision, tolerance, light_error and reflected_error to
 * those that the picture was made with, so that rendering repeats it byte for byte (on the same instruction set), and
 * returns true.  For any other scene it changes nothing and returns false.
 */
LUXEL_API bool luxel_scene_settings(const luxel_scene *scene, luxel_settings *settings);

/*
 * Computes the scene's picture.  `settings` NULL: the defaults.
 *
 * With a stride n above 1 the field is a quick look at the picture, such as to follow a slider: of the columns n / 2,
 * n / 2 + n and so on, or the last one instead of what lies beyond, and of the rows likewise; ceil(columns / n) by
 * ceil(rows / n) pixels with their places.  Their values are those of the whole picture, bit for bit, but for extended
 * sources, with a light_error, and in float32 where the whole picture is large and smooth (docs/MATHS.md, "Squares of a
 * picture"), where they keep the same bounds.  Such a field carries no scene, as it does not repeat it, and
 * luxel_find_extrema(), and luxel_find_isophotes() with an evaluator, refuse it.  All other functions that take
 * settings go by the whole picture.
 *
 * With a light_error E above 0, of 256 points or more of a kind (points, spots, the rows of clouds, the parts of
 * sources; of a kind are those that differ in place, intensity and axis alone) those that stand together are taken for
 * one where that is exact enough: no pixel is further than E times the larger of its value and a thousandth of the
 * picture's maximum from what the full sum gives, the rounding of `precision` aside.  Values of probes stay exact.
 *
 * With a group of lights the picture is that of the scene with these lights enabled and all others not, byte for byte,
 * whatever the scene says; the scene is neither changed nor copied for it, and the field carries the scene that it is
 * the picture of.  So what each light gives of a picture, of a grid or of a section, is asked group by group.
 *
 * LUXEL_ERROR_ARGUMENT: the scene is not committed, a setting is out of its range, there is no such light, the
 * instruction set is unknown or not of this machine.  LUXEL_ERROR_MEMORY: the picture would not fit (the message says
 * how much it needs; luxel_render_files() writes it all the same).  LUXEL_ERROR_RANGE: a value is beyond the precision.
 * LUXEL_CANCELLED.
 */
LUXEL_API luxel_status luxel_render(const luxel_scene *scene, const luxel_settings *settings,
                                    luxel_diagnostics *diagnostics, luxel_field **field);

/*
 * Computes the scene's picture and writes it to `count` files, each byte for byte as luxel_field_write_as() would write
 * the field of luxel_render().  `settings` NULL: the defaults; `how` NULL: as luxel_field_write() does; `statistics`,
 * which are those of that field, NULL: not wanted.  Without a file it computes the statistics alone.
 *
 * The picture need not fit in memory: it is computed and written some rows at a time.  Two kinds of files still need
 * all of it.  For a .png whose grey levels depend on the picture's maximum (those of all ranges but [low, high]) a
 * large picture is kept meanwhile in a file without a name in the folder of the .png, 5 or 9 bytes for each pixel.  And
 * what is no regular file, such as a pipe, takes such a .png and a .pfm, whose last row comes first, only of a picture
 * that fits in memory.
 *
 * Errors as of luxel_render(), and then no file is written.  Names and `how` are checked before anything is computed
 * (LUXEL_ERROR_ARGUMENT); a file that fails after that (LUXEL_ERROR_FILE) stops neither the others nor the statistics.
 * Cancelled between two files that are complete, the first is kept.
 */
LUXEL_API luxel_status luxel_render_files(const luxel_scene *scene, const luxel_settings *settings,
                                          const char *const *paths, size_t count, const luxel_field_output *how,
                                          luxel_diagnostics *diagnostics, luxel_statistics *statistics);

/* The name of the i-th instruction set that this library was built with, best first; NULL beyond the last. */
LUXEL_API const char *luxel_instruction_set_name(size_t i);
/* Whether this machine can run the i-th instruction set; false beyond the last. */
LUXEL_API bool luxel_instruction_set_runs(size_t i);
/*
 * The name of the instruction set that a computation takes whose settings ask for `wanted`: NULL is what LUXEL_ISA
 * says, else the best of this machine.  Short names count too: "v3", and "generic" for the set that runs everywhere.
 * NULL: this machine lacks what is asked for.
 */
LUXEL_API const char *luxel_instruction_set_chosen(const char *wanted);

#ifdef __cplusplus
}
#endif
#endif
