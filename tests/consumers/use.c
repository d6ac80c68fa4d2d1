/* SPDX-License-Identifier: MIT */
/* A program of somebody else, in C: prints the versions and the report's maximum. */
#include <luxel/luxel.h>

#include <stdio.h>

/* A name that the library uses inside; a program may have it too. */
int lx_kernels_choose(void);
int lx_kernels_choose(void)
{
    return 0;
}

int main(void)
{
    luxel_scene *scene = NULL;
    luxel_field *field = NULL;

    if (luxel_scene_open_builtin("report", NULL, &scene) == LUXEL_OK && luxel_scene_commit(scene, NULL) == LUXEL_OK &&
        luxel_render(scene, NULL, NULL, &field) == LUXEL_OK)
        printf("%d.%d.%d %s %.4f %s\n", LUXEL_VERSION_MAJOR, LUXEL_VERSION_MINOR, LUXEL_VERSION_PATCH, luxel_version(),
               luxel_field_statistics(field)->maximum.value, luxel_field_unit(field));
    luxel_field_free(field);
    luxel_scene_free(scene);
    return lx_kernels_choose();
}
