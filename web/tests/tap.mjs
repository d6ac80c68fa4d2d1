// SPDX-License-Identifier: MIT
// Counting of tests: one line for each, and at the end "N passed, N failed".  With LUXEL_ONLY in the environment only
// those are run whose names it is a part of.
let passed = 0;
const failures = [];

export async function test(name, body) {
    if (!name.includes(process.env.LUXEL_ONLY ?? '')) return;
    try {
        const note = await body();
        passed++;
        console.log(`ok ${name}${note ? ` (${note})` : ''}`);
    } catch (error) {
        failures.push(name);
        console.log(
            `not ok ${name}\n# ${String(error?.message ?? error)
                .split('\n')
                .join('\n# ')}`,
        );
    }
}

export function check(truth, message) {
    if (!truth) throw new Error(message);
}

export function equal(got, expected, what) {
    const [a, b] = [JSON.stringify(got), JSON.stringify(expected)];
    if (a !== b) throw new Error(`${what}: ${a} instead of ${b}`);
}

/** Prints the sum; the exit code that goes with it. */
export function summary() {
    console.log(`${passed} passed, ${failures.length} failed`);
    return failures.length === 0 && passed > 0 ? 0 : 1;
}

/** Prints the count of the tests, as TAP has it; the exit code that goes with it. */
export function plan() {
    console.log(`1..${passed + failures.length}`);
    return failures.length === 0 && passed > 0 ? 0 : 1;
}
