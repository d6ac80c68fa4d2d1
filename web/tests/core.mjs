// SPDX-License-Identifier: MIT
// The core for tests in Node: core.ts as JavaScript, and the WebAssembly of the build folder.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { transform } from 'esbuild';

const web = path.dirname(path.dirname(fileURLToPath(import.meta.url)));

export async function startCore(wasm) {
    const source = fs.readFileSync(path.join(web, 'page/core.ts'), 'utf8');
    const { code } = await transform(source, { loader: 'ts', format: 'esm' });
    const { Core } = await import(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
    return Core.start(await WebAssembly.compile(fs.readFileSync(wasm)));
}
