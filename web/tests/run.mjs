// SPDX-License-Identifier: MIT
// The tests of the web page: node run.mjs CORE.wasm LUXEL [PAGE-FOLDER].  Without a page only the core is tried.
import fs from 'node:fs';
import { gzipSync } from 'node:zlib';
import { startCore } from './core.mjs';
import { numbers } from './numbers.mjs';
import { check, summary, test } from './tap.mjs';

const [wasm, tool, page] = process.argv.slice(2);
const MOST_OF_CORE = 600e3; // bytes, gzip; docs/WEB.md tells what they are

await test('the core is small', () => {
    const size = gzipSync(fs.readFileSync(wasm), { level: 9 }).length;
    check(size <= MOST_OF_CORE, `${size} bytes`);
    return `${size} bytes, gzip`;
});
await numbers(await startCore(wasm), tool);
if (page) await (await import('./page.mjs')).page(page, tool);
process.exitCode = summary();
