// SPDX-License-Identifier: MIT
// The core for tests in Node: both of its parts, as the build folder holds them for the page.
import path from 'node:path';
import { compiled, coreModule } from '../node_core.mjs';

export const PARTS = ['luxel-core.wasm', 'luxel-core-2.wasm'];

/** Both parts of a build folder, and what core.ts exports. */
export async function partsOf(folder) {
    const [first, second] = await Promise.all(PARTS.map((name) => compiled(path.join(folder, name))));
    return { first, second, ...(await coreModule()) };
}

export async function startCore(folder) {
    const { first, second, Core } = await partsOf(folder);
    return Core.start(first, second);
}
