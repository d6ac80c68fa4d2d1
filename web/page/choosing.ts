// SPDX-License-Identifier: MIT
// Choosing what is to be moved by keys.
import type { Thing } from './geometry';

/** The thing behind or before another one in a list, around its end. */
export function nextOf(things: Thing[], from: Thing | null, step: number): Thing {
    const at = things.findIndex(({ key, kind }) => key === from?.key && kind === from.kind);
    const next = at < 0 ? (step > 0 ? 0 : things.length - 1) : at + step;
    return things[(next + things.length) % things.length];
}
