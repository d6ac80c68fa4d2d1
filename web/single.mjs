// SPDX-License-Identifier: MIT
// Makes of the page's files a single one, luxel.html, which works from a disk without any server.  What the page would
// fetch stands in it as text; its policy names the script by its hash.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';

const folder = process.argv[2];
const read = (name) => fs.readFileSync(path.join(folder, name));
const script = read('luxel.js').toString().replaceAll('</script', '<\\/script');
const hash = createHash('sha256').update(script).digest('base64');
const style = read('index.css').toString();
const styleHash = createHash('sha256').update(style).digest('base64');
const data = (id, bytes) => `<script type="text/plain" id="${id}">${bytes.toString('base64')}</script>`;

const html = read('index.html')
    .toString()
    .replace("script-src 'self'", () => `script-src 'sha256-${hash}'`)
    .replace("style-src 'self'", () => `style-src 'sha256-${styleHash}'`)
    .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${style}</style>`)
    .replaceAll(/\s*<link rel="preload"[^>]*>/g, '')
    .replace(/<script type="module"[^>]*><\/script>/, '')
    .replace('</body>', () =>
        [
            data('embedded-core', read('luxel-core.wasm')),
            data('embedded-core-2', read('luxel-core-2.wasm')),
            data('embedded-words', read('ru.json')),
            data('embedded-worker', read('worker.js')),
            `<script type="module">${script}</script>`,
            '</body>',
        ].join('\n'),
    );
fs.writeFileSync(path.join(folder, 'luxel.html'), html);
