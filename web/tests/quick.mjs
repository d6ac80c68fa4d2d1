// SPDX-License-Identifier: MIT
// The web page in short, as a part of `make check`: node quick.mjs BUILD-WEB LUXEL.  It is left out where the page is not
// built, or older than what it is made of, or there is no Chromium.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const [folder, tool] = process.argv.slice(2);
const root = path.dirname(path.dirname(path.dirname(fileURLToPath(import.meta.url))));
const page = path.join(folder, 'page');
const SOURCES = ['src', 'include', 'data/scenes', 'po/ru.po', 'web/core', 'web/page', 'web/split.mjs'];
const SCENES = ['report', 'three-lights', 'spot', 'two-spheres'];

/** When the newest file of a folder was changed. */
function newest(place) {
    const state = fs.statSync(place);
    if (!state.isDirectory()) return state.mtimeMs;
    return Math.max(0, ...fs.readdirSync(place).map((name) => newest(path.join(place, name))));
}

function reasonToSkip() {
    const chromium = process.env.LUXEL_CHROMIUM ?? '/usr/bin/chromium';
    if (!fs.existsSync(chromium)) return `there is no ${chromium}`;
    const single = path.join(page, 'luxel.html'); // what is made last
    if (!fs.existsSync(single)) return 'the page is not built: make web';
    if (!fs.existsSync(path.join(root, 'web/node_modules/playwright-core'))) return 'no packages of npm: make web';
    const made = fs.statSync(single).mtimeMs;
    const changed = SOURCES.find((source) => newest(path.join(root, source)) > made);
    return changed && `the page is older than ${changed}: make web`;
}

const reason = reasonToSkip();
if (reason) console.log(`1..0 # SKIP ${reason}`);
else {
    const { startCore } = await import('./core.mjs');
    const { numbers } = await import('./numbers.mjs');
    const { inShort } = await import('./page.mjs');
    const { plan } = await import('./tap.mjs');
    await numbers(await startCore(folder), tool, SCENES);
    await inShort(page, tool);
    process.exitCode = plan();
}
