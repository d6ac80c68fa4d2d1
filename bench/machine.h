/* SPDX-License-Identifier: MIT */
/* What the machine could do at best, measured: what benchmarks are compared with. */
#ifndef LUXEL_BENCH_MACHINE_H
#define LUXEL_BENCH_MACHINE_H

/* Seconds of a clock that only goes forward. */
double machine_seconds(void);

/*
 * Products and sums of float32, a * b + c, that one thread forms in a second with the registers of an instruction set,
 * as luxel_instruction_set_name() calls it, which must run here; in one operation where the set has it.
 */
double machine_products_per_second(const char *instruction_set);

/* Bytes that one thread reads and writes in a second, both counted, when it copies more than the caches hold; 0 where
 * there is no memory to try it. */
double machine_copied_bytes_per_second(void);

#endif
