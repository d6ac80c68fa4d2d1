/* SPDX-License-Identifier: MIT */
/* What sweeps write: SHA-256 by plain code and by instructions, and the rounding to half precision. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../../cli/sweep/array.h"

static void sum_of(const void *bytes, size_t count, size_t step, bool by_instructions, char hex[SHA256_HEX])
{
    struct sha256 sum;
    sha256_begin(&sum, by_instructions);
    for (size_t at = 0; at < count; at += step)
        sha256_add(&sum, (const char *)bytes + at, count - at < step ? count - at : step);
    sha256_end(&sum, hex);
}

/* The examples of FIPS 180-4 and a million letters. */
static void known_sums(void **state)
{
    (void)state;
    static char letters[1000000];
    static const char longer[] = "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq";
    memset(letters, 'a', sizeof letters);
    for (int by_instructions = 0; by_instructions <= sha256_has_instructions(); by_instructions++) {
        char hex[SHA256_HEX];
        sum_of("", 0, 1, by_instructions, hex);
        assert_string_equal(hex, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        sum_of("abc", 3, 1, by_instructions, hex);
        assert_string_equal(hex, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        sum_of(longer, strlen(longer), 5, by_instructions, hex);
        assert_string_equal(hex, "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
        sum_of(letters, sizeof letters, 977, by_instructions, hex);
        assert_string_equal(hex, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    }
}

/* However the bytes are cut, and at every length around the blocks. */
static void cut_sums(void **state)
{
    (void)state;
    unsigned char bytes[300];
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (unsigned char)(i * 37 + i / 7);
    for (size_t count = 0; count < sizeof bytes; count++) {
        char whole[SHA256_HEX], cut[SHA256_HEX];
        sum_of(bytes, count, sizeof bytes, false, whole);
        for (size_t step = 1; step < 140; step += 23) {
            sum_of(bytes, count, step, sha256_has_instructions(), cut);
            assert_string_equal(whole, cut);
        }
    }
}

static double value_of_half(uint16_t half)
{
    const int exponent = half >> 10 & 31, digits = half & 1023;
    const double size = exponent ? ldexp(1024 + digits, exponent - 25) : ldexp(digits, -24);
    return half & 0x8000 ? -size : size;
}

/* Every half is itself; between two neighbours the middle goes to the even one, and what is beside it to the nearer. */
static void halves(void **state)
{
    (void)state;
    for (unsigned half = 0; half < 0x7c00; half++) {
        const double value = value_of_half((uint16_t)half);
        const double next = half == 0x7bff ? 65536 : value_of_half((uint16_t)(half + 1)), middle = (value + next) / 2;
        const uint16_t even = (uint16_t)(half + (half & 1));
        assert_int_equal(array_half(value), half);
        assert_int_equal(array_half(-value), half | 0x8000);
        assert_int_equal(array_half(middle), even);
        assert_int_equal(array_half(nextafter(middle, 0)), half);
        assert_int_equal(array_half(nextafter(middle, HUGE_VAL)), half + 1);
    }
    assert_int_equal(array_half(1e300), 0x7c00);
    assert_int_equal(array_half(-HUGE_VAL), 0xfc00);
    assert_int_equal(array_half(5e-324), 0);
    assert_true((array_half((double)NAN) & 0x7fff) > 0x7c00);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(known_sums), cmocka_unit_test(cut_sums),
                                       cmocka_unit_test(halves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
