// SPDX-License-Identifier: MIT
// Sections as numbers: exact values at equal steps of a line on the screen, each with the lights' shares.
import type { Probe } from './core';
import type { Of } from './version';

/** Abscissa in mm, value, and each light's share of it; a value of null: there is none. */
export type Row = (number | null)[];

export interface Section {
    of: Of;
    from: number[];
    to: number[];
    rows: Row[];
}

/** The i-th of so many places from end to end, both of which are exact. */
export function placeOn(from: number[], to: number[], samples: number, i: number): [number, number] {
    const share = i / (samples - 1);
    return [from[0] * (1 - share) + to[0] * share, from[1] * (1 - share) + to[1] * share];
}

export function rowOn(from: number[], to: number[], samples: number, i: number, probe: Probe | null): Row {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return [(length * i) / (samples - 1), probe?.value ?? null, ...(probe?.shares ?? [])];
}

/** The samples in such an order that all of the line is known coarsely first. */
export function coarseFirst(samples: number): number[] {
    const order: number[] = [];
    for (let stride = 16; stride >= 1; stride /= 2)
        for (let i = 0; i < samples; i++)
            if (i % stride === 0 && (stride === 16 || i % (2 * stride) !== 0)) order.push(i);
    return order;
}
