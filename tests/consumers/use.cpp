/* SPDX-License-Identifier: MIT */
/* A program of somebody else, in C++: the same as use.c, with the objects in smart pointers. */
#include <luxel/luxel.h>

#include <cstdio>
#include <memory>

namespace {

template <typename Object, void (*free_object)(Object *)> struct Free {
    void operator()(Object *object) const { free_object(object); }
};
using Scene = std::unique_ptr<luxel_scene, Free<luxel_scene, luxel_scene_free>>;
using Field = std::unique_ptr<luxel_field, Free<luxel_field, luxel_field_free>>;

Scene open_scene(const char *name)
{
    luxel_scene *scene = nullptr;
    const bool good =
        luxel_scene_open_builtin(name, nullptr, &scene) == LUXEL_OK && luxel_scene_commit(scene, nullptr) == LUXEL_OK;
    Scene owned(scene);
    return good ? std::move(owned) : nullptr;
}

Field render(const Scene &scene)
{
    luxel_field *field = nullptr;
    luxel_settings settings;
    luxel_settings_init(&settings);
    return Field(luxel_render(scene.get(), &settings, nullptr, &field) == LUXEL_OK ? field : nullptr);
}

} // namespace

int main()
{
    const Scene scene = open_scene("report");
    const Field field = scene ? render(scene) : nullptr;
    if (!field)
        return 1;
    std::printf("%d.%d.%d %s %.4f %s\n", LUXEL_VERSION_MAJOR, LUXEL_VERSION_MINOR, LUXEL_VERSION_PATCH, luxel_version(),
                luxel_field_statistics(field.get())->maximum.value, luxel_field_unit(field.get()));
    return 0;
}
