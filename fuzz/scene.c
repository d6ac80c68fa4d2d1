/* SPDX-License-Identifier: MIT */
/* Any text, or picture, as a scene: read, committed, computed, written. */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene;
    luxel_status status = luxel_scene_read_text((const char *)data, size, "fuzz", diagnostics, &scene);
    fuzz_must(status == LUXEL_OK || luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR) > 0,
              "what cannot be read has a message");
    fuzz_read_messages(diagnostics);
    luxel_diagnostics_free(diagnostics);
    if (status == LUXEL_OK)
        fuzz_use_scene(scene);
    return 0;
}
