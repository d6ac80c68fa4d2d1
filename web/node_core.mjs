// SPDX-License-Identifier: MIT
// The class Core for Node, which splits the core and tries it: core.ts and what it includes as JavaScript.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const web = path.dirname(fileURLToPath(import.meta.url));

/** What core.ts exports. */
export async function coreModule() {
    const { outputFiles } = await build({
        entryPoints: [path.join(web, 'page/core.ts')],
        bundle: true,
        format: 'esm',
        write: false,
    });
    return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
}

export const compiled = (file) => WebAssembly.compile(fs.readFileSync(file));
