// SPDX-License-Identifier: MIT
// The page as static files with relative paths; core and words come from the build folder, LUXEL_WEB_FOLDER.
import fs from 'node:fs';
import path from 'node:path';
import { build } from 'esbuild';
import { defineConfig } from 'vite';

const folder = path.resolve(process.env.LUXEL_WEB_FOLDER ?? '../build-web');

// Where the page will be found, "https://example.org/luxel/": those who show links want the whole address of its picture.
const address = process.env.LUXEL_WEB_ADDRESS ?? '';

// The licences of what the page and its core are made of, in this order.
function licences() {
    const sources = path.join(folder, 'libraries/sources');
    const files = fs
        .readdirSync(sources)
        .sort()
        .map((name) => path.join(sources, name, 'LICENSE'))
        .filter((file) => fs.existsSync(file));
    const musl = '/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT';
    const titled = (title, file) => `${title}\n\n${fs.readFileSync(file, 'utf8').trim()}\n`;
    const texts = [
        titled('Luxel', '../LICENSE'),
        ...files.map((file) => titled(path.basename(path.dirname(file)), file)),
        titled('musl', musl),
        titled('The colours "turbo"', '../LICENSES/Apache-2.0.txt'),
    ];
    return texts.join('\n\n').replaceAll('&', '&amp;').replaceAll('<', '&lt;');
}

// <luxel-scene> is a script of its own, as it runs in other pages.
const element = {
    name: 'luxel-scene',
    async generateBundle() {
        const { outputFiles } = await build({
            entryPoints: ['page/luxel-scene.ts'],
            bundle: true,
            minify: true,
            format: 'iife',
            target: 'es2022',
            legalComments: 'inline',
            write: false,
        });
        this.emitFile({ type: 'asset', fileName: 'luxel-scene.js', source: outputFiles[0].contents });
    },
};

// What the script asks for first comes with it rather than after it.
const early = (name) => `<link rel="preload" as="fetch" crossorigin href="./${name}" />`;

const core = {
    name: 'luxel-core',
    transformIndexHtml: (html) =>
        html
            .replace('<!-- licences -->', licences)
            .replace('content="card.png"', `content="${address}card.png"`)
            .replace('</title>', () => ['</title>', ...['luxel-core.wasm', 'worker.js'].map(early)].join('\n    ')),
    generateBundle() {
        const take = (fileName) =>
            this.emitFile({ type: 'asset', fileName, source: fs.readFileSync(path.join(folder, fileName)) });
        for (const name of ['luxel-core.wasm', 'luxel-core-2.wasm', 'ru.json', 'card.png']) take(name);
    },
};

export default defineConfig({
    root: 'page',
    base: './',
    plugins: [core, element],
    worker: { format: 'iife', rollupOptions: { output: { entryFileNames: 'worker.js' } } },
    build: {
        outDir: path.join(folder, 'page'),
        emptyOutDir: true,
        assetsInlineLimit: 0,
        modulePreload: false,
        target: 'es2022',
        rollupOptions: { output: { entryFileNames: 'luxel.js', assetFileNames: '[name][extname]' } },
    },
});
