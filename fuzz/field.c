/* SPDX-License-Identifier: MIT */
/*
 * Any file as a field: the first byte chooses the ending of its name (.npy, .pfm, .csv, .exr), the rest is the file.
 * What was read is summed up, written and compared with itself.
 */
#include "fuzz.h"

#include <math.h>

static luxel_status read_as(const char *ending, const uint8_t *data, size_t size, luxel_diagnostics *diagnostics,
                            luxel_field **field)
{
    struct fuzz_file file = fuzz_open(data, size, ending);
    luxel_status status = luxel_field_read(file.path, diagnostics, field);
    fuzz_close(&file);
    return status;
}

static void use(const luxel_field *field)
{
    luxel_summary summary;
    luxel_histogram *histogram;
    luxel_comparison comparison;
    luxel_field_summary(field, NULL, NULL, &summary);
    if (luxel_field_histogram(field, NULL, LUXEL_HISTOGRAM_LINEAR, (double)NAN, (double)NAN, 16, NULL, &histogram) ==
        LUXEL_OK) {
        size_t pixels = histogram->below + histogram->above;
        for (size_t i = 0; i < histogram->bins; i++)
            pixels += histogram->counts[i];
        fuzz_must(pixels <= histogram->pixels, "no pixel is counted twice");
        luxel_histogram_free(histogram);
    }
    if (luxel_compare(field, field, NULL, &comparison, NULL) == LUXEL_OK)
        fuzz_must(!(comparison.largest.value > 0), "a picture is equal to itself");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const endings[] = {".npy", ".pfm", ".csv", ".exr"};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_field *field;
    if (size > 0) {
        luxel_status status = read_as(endings[data[0] % 4], data + 1, size - 1, diagnostics, &field);
        fuzz_must(status == LUXEL_OK || luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR) > 0,
                  "what cannot be read has a message");
        fuzz_read_messages(diagnostics);
        if (status == LUXEL_OK) {
            use(field);
            luxel_field_free(field);
        }
    }
    luxel_diagnostics_free(diagnostics);
    return 0;
}
