/* SPDX-License-Identifier: MIT */
/* Reading the meshes that a scene names, with the files that belong to them, and telling what is wrong with them. */
#include "mesh_file.h"

#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/path.h"
#include "../base/phrase.h"

/* What a file is read for. */
struct reading {
    const struct lx_check *check;
    const char *key, *path;
    struct lx_file_state state; /* of it, before it was read */
};

/* A file beside the mesh's, by a name as it stands there. */
static char *path_beside(const char *path, const char *name)
{
    struct lx_text text = {0};
    if (!lx_path_is_absolute(name))
        lx_text_add(&text, path, (size_t)(lx_path_name(path) - path));
    lx_text_puts(&text, name);
    return lx_text_take(&text);
}

static char *open_beside(const struct lx_mesh_opener *opener, const char *name, size_t *length,
                         struct lx_mesh_file *file)
{
    const struct reading *reading = opener->data;
    file->path = path_beside(reading->path, name);
    if (!file->path) {
        reading->check->walk->out_of_memory = true;
        return NULL;
    }
    char *bytes = lx_check_read(reading->check, reading->key, file->path, LX_LARGEST_MESH, length);
    file->state = reading->check->walk->opened;
    return bytes;
}

struct lx_mesh *lx_check_mesh(const struct lx_check *check, const char *key, const char *path, bool *is_new)
{
    struct reading reading = {check, key, path, {.is_known = false}};
    const struct lx_mesh_opener opener = {open_beside, &reading};
    char line[LX_NUMBER_SIZE];
    size_t length;
    struct lx_mesh *mesh = (struct lx_mesh *)lx_check_kept(check, path, lx_mesh_free);
    *is_new = !mesh;
    if (mesh)
        return mesh;
    char *text = lx_check_read(check, key, path, LX_LARGEST_MESH, &length);
    if (!text)
        return NULL;
    reading.state = check->walk->opened;
    const struct lx_mesh_report report = lx_mesh_read(path, text, length, &opener, &mesh);
    check->walk->opened = reading.state;
    free(text);
    if (report.message == LX_MSG_OUT_OF_MEMORY)
        check->walk->out_of_memory = true;
    else if (report.message != LX_MSG_COUNT && report.message != LX_MSG_NAMED_FILE_NOT_READ)
        lx_check_report(check, key, LX_ALL_OF_IT, report.message,
                        LX_ARGS(path, lx_write_number((double)report.line, line), report.detail));
    return mesh;
}

void lx_check_keep_mesh(const struct lx_check *check, const char *path, struct lx_mesh *mesh)
{
    lx_check_keep(check, path, &mesh->kept);
}

static void note(const struct lx_check *check, const char *key, const char *file, const struct lx_mesh_note *about,
                 enum lx_message message)
{
    char count[LX_NUMBER_SIZE], line[LX_NUMBER_SIZE];
    if (about->count > 0)
        lx_check_advise(check, key, message,
                        LX_ARGS(file, lx_write_number(about->count, count), lx_write_number(about->line, line)));
}

void lx_check_advise_mesh(const struct lx_check *check, const char *key, const char *file, const struct lx_mesh *mesh)
{
    note(check, key, file, &mesh->thin, LX_MSG_MESH_THIN);
    note(check, key, file, &mesh->doubled, LX_MSG_MESH_DOUBLED);
    note(check, key, file, &mesh->others, LX_MSG_MESH_OTHERS);
    note(check, key, file, &mesh->lost_normals, LX_MSG_MESH_LOST_NORMALS);
    note(check, key, file, &mesh->uncounted, LX_MSG_STL_COUNT);
    note(check, key, file, &mesh->bytes_behind, LX_MSG_STL_BEHIND);
    note(check, key, file, &mesh->unended, LX_MSG_STL_UNENDED);
}

void lx_check_advise_mesh_size(const struct lx_check *check, const char *key, const struct lx_mesh *mesh,
                               double scale_mm, double least_mm, double most_mm)
{
    static const double scales[] = {1000, 10, 25.4, 0.001};
    static const char *const units[] = {LX_N("metres"), LX_N("centimetres"), LX_N("inches"), LX_N("micrometres")};
    char size[LX_NUMBER_SIZE], scale[LX_NUMBER_SIZE];
    const double bare = lx_mesh_size(mesh), across = bare * scale_mm;
    if (across >= least_mm && across <= most_mm)
        return;
    for (size_t i = 0; i < LX_COUNT(scales); i++)
        if (bare * scales[i] >= least_mm && bare * scales[i] <= most_mm) {
            lx_check_advise(check, key, LX_MSG_MESH_SIZE, LX_ARGS(lx_write_digits(across, 4, size), LX_TERM(units[i])));
            lx_check_hint(check, LX_MSG_HINT_MESH_SCALE, LX_ARGS(lx_write_number(scales[i], scale)));
            return;
        }
}
