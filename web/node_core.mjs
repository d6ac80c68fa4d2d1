// SPDX-License-Identifier: MIT
// Modules of the page for Node, which splits the core, tries it and has it make a picture: with what they include, as JavaScript.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const web = path.dirname(fileURLToPath(import.meta.url));

/** What a module of the page exports. */
export async function moduleOf(name) {
    const { outputFiles } = await build({
        entryPoints: [path.join(web, name)],
        bundle: true,
        format: 'esm',
        write: false,
    });
    return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
}

/** What core.ts exports. */
export const coreModule = () => moduleOf('page/core.ts');

export const compiled = (file) => WebAssembly.compile(fs.readFileSync(file));
