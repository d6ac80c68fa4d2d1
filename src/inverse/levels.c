/* SPDX-License-Identifier: MIT */
/* Pictures of grey levels as fields, for those who fit a scene to them. */
#include <luxel/fit.h>

#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../format/png_levels.h"

luxel_status luxel_read_levels(const char *path, luxel_diagnostics *diagnostics, luxel_field **field, double *greatest)
{
    struct lx_levels levels;
    if (!path || !field || !greatest)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = lx_png_read_levels(path, diagnostics, &levels);
    if (status != LUXEL_OK)
        return status;
    const size_t count = (size_t)levels.columns * levels.rows;
    uint8_t *mask = lx_new_array(count + 1, 1);
    if (mask) {
        memset(mask, 1, count);
        const luxel_field_content content = {.columns = levels.columns,
                                             .rows = levels.rows,
                                             .precision = LUXEL_DOUBLE,
                                             .values = levels.list,
                                             .mask = mask};
        status = luxel_field_of_values(&content, diagnostics, field);
        *greatest = levels.greatest;
    } else {
        status = lx_out_of_memory(diagnostics);
    }
    free(mask);
    free(levels.list);
    return status;
}
