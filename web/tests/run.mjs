// SPDX-License-Identifier: MIT
// The tests of the web page: node run.mjs BUILD-WEB LUXEL.  With LUXEL_CORE_ONLY in the environment only the core is
// tried, in Node.
import path from 'node:path';
import { startCore } from './core.mjs';
import { numbers } from './numbers.mjs';
import { parts } from './parts.mjs';
import { summary } from './tap.mjs';

const [folder, tool] = process.argv.slice(2);

await parts(folder);
await numbers(await startCore(folder), tool);
if (!process.env.LUXEL_CORE_ONLY) await (await import('./page.mjs')).page(path.join(folder, 'page'), tool);
process.exitCode = summary();
