// SPDX-License-Identifier: MIT
// The core for tests in Node: core.ts and what it includes as JavaScript, and the WebAssembly of the build folder.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const web = path.dirname(path.dirname(fileURLToPath(import.meta.url)));

export async function startCore(wasm) {
    const { outputFiles } = await build({
        entryPoints: [path.join(web, 'page/core.ts')],
        bundle: true,
        format: 'esm',
        write: false,
    });
    const text = Buffer.from(outputFiles[0].contents).toString('base64');
    const { Core } = await import(`data:text/javascript;base64,${text}`);
    return Core.start(await WebAssembly.compile(fs.readFileSync(wasm)));
}
