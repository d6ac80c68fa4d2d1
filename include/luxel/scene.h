/* SPDX-License-Identifier: MIT */
/*
 * Scenes: what the user wrote, as a tree of keys and values with their places in the text.
 *
 * A scene is made from a built-in text, a file or a string, changed by key paths, and then committed:
 * luxel_scene_commit() checks everything at once and makes the scene ready for luxel_render() and the
 * probes.  A change takes the readiness away until the next commit.  Lengths are millimetres.
 *
 * Threads as luxel.h says: a scene that is being changed, committed or freed belongs to one of them.
 */
#ifndef LUXEL_SCENE_H
#define LUXEL_SCENE_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/diagnostics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scene, owned by the caller; freed with luxel_scene_free(). */
typedef struct luxel_scene luxel_scene;

/* The number of built-in scenes. */
LUXEL_API size_t luxel_builtin_scene_count(void);
/* The name of the i-th built-in scene, such as "report"; NULL beyond the last. */
LUXEL_API const char *luxel_builtin_scene_name(size_t i);
/* Its title in one line, English; NULL beyond the last. */
LUXEL_API const char *luxel_builtin_scene_title(size_t i);
/* Its YAML text; NULL beyond the last. */
LUXEL_API const char *luxel_builtin_scene_text(size_t i);

/*
 * Makes a scene from the built-in one of this name.  The scene is not ready for use yet: call luxel_scene_commit()
 * before it is rendered or probed, as after luxel_scene_read_file() and luxel_scene_read_text().
 * LUXEL_ERROR_ARGUMENT: no such name.
 */
LUXEL_API luxel_status luxel_scene_open_builtin(const char *name, luxel_diagnostics *diagnostics, luxel_scene **scene);
/*
 * Makes a scene from a file of YAML or JSON, or from a picture that carries its scene: a .png or .exr file of
 * luxel_field_write(), which is known by its content, whatever its name is; luxel_scene_settings() tells what else
 * it carries.  Only the text itself is checked here: that it is one well-formed document within the limits (64 MB,
 * 32 levels, no anchors or aliases).  luxel_scene_commit() checks the rest and must follow before the scene is used.
 * LUXEL_ERROR_SCENE: malformed text, or a picture that is damaged or carries no scene.  LUXEL_ERROR_FILE: cannot be
 * read.
 */
LUXEL_API luxel_status luxel_scene_read_file(const char *path, luxel_diagnostics *diagnostics, luxel_scene **scene);
/*
 * Makes a scene from `length` bytes of YAML or JSON, or of a picture that carries its scene; `source` is the name
 * shown in messages.  Checks as much as luxel_scene_read_file(), with the same errors: luxel_scene_commit() must follow
 * before the scene is used.
 */
LUXEL_API luxel_status luxel_scene_read_text(const char *text, size_t length, const char *source,
                                             luxel_diagnostics *diagnostics, luxel_scene **scene);

/*
 * Makes the folder of a file the one that the files which the scene names are relative to; `path` NULL or without a
 * folder: the current one.  For a scene that was made from a text, or is about to be saved somewhere else.  It is to
 * be committed anew.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_set_folder_of(luxel_scene *scene, const char *path);

/*
 * Takes over what another scene, such as that of the text a moment ago, has read from files: luxel_scene_commit() then
 * reads only those that the other one did not name or that have changed since.  LUXEL_ERROR_MEMORY.
 */
LUXEL_API luxel_status luxel_scene_keep_files(luxel_scene *scene, const luxel_scene *other);

/*
 * Changes one value: `assignment` is KEY=VALUE, where KEY is a path such as lights[0].intensity or
 * lights.0.intensity and VALUE is YAML.  Keys with defaults that the scene does not write yet are added.
 * lights[*].intensity are those of all elements that have the key, of which there must be one.
 * LUXEL_ERROR_PATH: no '=', or no such key or element (the scene stays as it was).
 * LUXEL_ERROR_SCENE: VALUE is no YAML.  Whether the value is legal is for luxel_scene_commit() to say.
 */
LUXEL_API luxel_status luxel_scene_set(luxel_scene *scene, const char *assignment, luxel_diagnostics *diagnostics);

/*
 * The value of a key as YAML on one line, such as "10", "[0, 0, 1000]", "point" or "{type: ambient, irradiance: 1}":
 * what the scene writes, or else the key's default; *text is NULL where there is neither.  `key` is a path as
 * luxel_scene_set() takes it.  `written` is NULL, or takes whether the scene itself writes the key.  The text is the
 * caller's: free it with luxel_text_free().  It follows the path alone, whatever the size of the scene's text, and
 * needs no commit.
 * LUXEL_ERROR_PATH: no such key or element.
 */
LUXEL_API luxel_status luxel_scene_get(const luxel_scene *scene, const char *key, luxel_diagnostics *diagnostics,
                                       bool *written, char **text);
/*
 * How many elements a list has: surfaces, lights, points, grids, or the list of places of an outline such as
 * lights[0].vertices; 0 where it is not written.  LUXEL_ERROR_PATH: no such key or element, or no list.
 */
LUXEL_API luxel_status luxel_scene_list_size(const luxel_scene *scene, const char *list, luxel_diagnostics *diagnostics,
                                             size_t *count);

/*
 * The next three functions change which elements and keys there are.  All else in the text of luxel_scene_write_text()
 * stays byte for byte: lists on lines ("- ...") go on as such at the same indentation, lists in brackets in brackets,
 * JSON as JSON.  A comment behind an element, and comments right above it that begin at its column, go with it where
 * it has its lines for itself.  Where a text is too odd for that, the list is written anew in brackets.  From then on
 * reports about the scene tell lines of the changed text.  Whether the result is legal is for luxel_scene_commit() to
 * say.  Any error leaves the scene as it was, LUXEL_ERROR_MEMORY included.
 */
/*
 * Puts an element, given as YAML, before the element `index` of a list; the list's size as index: at its end.  It is
 * written on one line.  A list that the scene does not write is added.
 * LUXEL_ERROR_PATH: no such list, or index beyond its size.  LUXEL_ERROR_SCENE: `value` is no YAML.
 */
LUXEL_API luxel_status luxel_scene_insert(luxel_scene *scene, const char *list, size_t index, const char *value,
                                          luxel_diagnostics *diagnostics);
/*
 * Takes out an element of a list ("lights[2]") or a key with its value ("lights[0].name"), with its line or comma.
 * The last element leaves an empty list, lights: [], the last key an empty mapping.  A key that there may be, but that
 * the scene does not write, is none to take out: LUXEL_OK, and nothing changes.
 * LUXEL_ERROR_PATH: no such key or element.
 */
LUXEL_API luxel_status luxel_scene_remove(luxel_scene *scene, const char *key, luxel_diagnostics *diagnostics);
/*
 * Moves the element `from` of a list to another place: `to` is its index afterwards, and the elements between close up.
 * An index that is equal to it changes nothing.
 * LUXEL_ERROR_PATH: no such list or elements.
 */
LUXEL_API luxel_status luxel_scene_move(luxel_scene *scene, const char *list, size_t from, size_t to,
                                        luxel_diagnostics *diagnostics);

/*
 * Checks the whole scene, all errors at once, and makes it ready.  Files that the scene names, such as meshes, are read
 * now: relative to the folder of the file that the scene was read from, or else to the current one.  What an earlier
 * commit of the scene, or of the one that it is a copy of, has read of a file is taken again as long as the file has
 * not changed since: its size and times tell. LUXEL_ERROR_SCENE: it has errors.  LUXEL_ERROR_FILE: it has none but that
 * files it names cannot be read.
 */
LUXEL_API luxel_status luxel_scene_commit(luxel_scene *scene, luxel_diagnostics *diagnostics);

/* Whether the last commit succeeded and nothing has been changed since. */
LUXEL_API bool luxel_scene_is_committed(const luxel_scene *scene);

/*
 * Whether pictures can be made of a committed scene and points of its screen be probed, which luxel_render() and all
 * that looks through the screen ask first; free elements, grids, glare and reflected light do not need it.
 * LUXEL_ERROR_SCENE: pixels that are not square, an observer inside a surface or not above it, no surface at all.
 */
LUXEL_API luxel_status luxel_scene_check_view(const luxel_scene *scene, luxel_diagnostics *diagnostics);

/* Appends advice about a committed scene: values outside advised ranges, unused keys, surfaces out of view. */
LUXEL_API luxel_status luxel_scene_advise(const luxel_scene *scene, luxel_diagnostics *diagnostics);

/*
 * The scene as text that reads back as the same scene: the very text that it was made from, byte for byte, in which
 * only the values changed since then are replaced, as they were given to luxel_scene_set(), and only the keys added
 * since then are new.  So comments, order and layout stay; JSON stays JSON, and values are written as such there.  The
 * text is the caller's: free it with luxel_text_free().
 */
LUXEL_API luxel_status luxel_scene_write_text(const luxel_scene *scene, char **text);
/*
 * Writes that text to a file, whatever its extension, and whether the scene is committed or not.  The file appears
 * whole or not at all; one that was there keeps its permissions, and a symbolic link stays one.
 * LUXEL_ERROR_FILE: it could not be written.
 */
LUXEL_API luxel_status luxel_scene_write_file(const luxel_scene *scene, const char *path,
                                              luxel_diagnostics *diagnostics);

/* An independent copy (committed if `scene` is, with what was read from files then), or NULL when memory is short. */
LUXEL_API luxel_scene *luxel_scene_copy(const luxel_scene *scene);
/* Frees a scene; NULL is harmless. */
LUXEL_API void luxel_scene_free(luxel_scene *scene);

/* The number of measuring points of a committed scene. */
LUXEL_API size_t luxel_scene_point_count(const luxel_scene *scene);
/* The i-th measuring point of a committed scene on the screen.  LUXEL_ERROR_ARGUMENT: not committed, or no such. */
LUXEL_API luxel_status luxel_scene_point(const luxel_scene *scene, size_t i, double *x_mm, double *y_mm);

/* The number of surfaces of a committed scene. */
LUXEL_API size_t luxel_scene_surface_count(const luxel_scene *scene);
/* The centre of the i-th surface of a committed scene.  LUXEL_ERROR_ARGUMENT: not committed, or no such. */
LUXEL_API luxel_status luxel_scene_surface_place(const luxel_scene *scene, size_t i, double center_mm[3]);
/* How far from its centre the i-th surface of a committed scene reaches at most.  LUXEL_ERROR_ARGUMENT as above. */
LUXEL_API luxel_status luxel_scene_surface_radius(const luxel_scene *scene, size_t i, double *radius_mm);

/* The name of a part of the i-th surface of a committed scene, such as "floor" of a room; NULL: it has no such part. */
LUXEL_API const char *luxel_scene_part_name(const luxel_scene *scene, size_t i, unsigned part);

/* The pixels of a committed scene. */
LUXEL_API luxel_status luxel_scene_resolution(const luxel_scene *scene, unsigned *columns, unsigned *rows);

#ifdef __cplusplus
}
#endif
#endif
