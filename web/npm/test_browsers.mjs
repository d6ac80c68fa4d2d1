// SPDX-License-Identifier: MIT
// The packages in Debian's Chromium: in a plain page, bundled by esbuild and by Vite.  The second part of the core is fetched when
// it is needed, and not before.
import fs from 'node:fs';
import path from 'node:path';
import { build as esbuild } from 'esbuild';
import { chromium } from 'playwright-core';
import { build as vite } from 'vite';
import { serve } from '../tests/server.mjs';
import { check, equal, test } from '../tests/tap.mjs';

// Each step waits until the test has looked at what was fetched.
const PROGRAM = `
window.steps = {
    async first() {
        window.scene = await Scene.builtin('report');
        const { values } = await window.scene.render();
        return [values.length, (await window.scene.probe([150, 0])).value];
    },
    async second() {
        return (await window.scene.explain([150, 0], { format: 'html' })).length;
    },
    async remote() {
        const luxel = remote();
        const scene = await luxel.builtin('report');
        const { value } = await scene.probe([150, 0]);
        luxel.end();
        return value;
    },
};
`;
const imports = (core, others, element) =>
    `import { Scene } from '${core}';\nimport { remote } from '${others}';\nimport '${element}';\n${PROGRAM}`;
const PAGE = (script) => `<!doctype html><html lang="en"><title>Luxel</title><body>
<luxel-scene scene="sphere" view="picture"></luxel-scene><script type="module" src="${script}"></script></body></html>`;

const isSecond = (name) => /luxel-core-2.*\.wasm$/.test(name);

/** The page in a folder, served as it lies there. */
async function look(browser, folder, value) {
    const { server, asked, url } = await serve(folder);
    const page = await browser.newPage();
    const faults = [];
    page.on('pageerror', (error) => faults.push(String(error)));
    try {
        await page.goto(url);
        await page.waitForFunction(() => window.steps, null, { timeout: 60e3 });
        equal(await page.evaluate(() => window.steps.first()), [360 * 360, value], 'the first picture');
        check(!asked.some(isSecond), 'the second part was fetched for the first picture');
        check((await page.evaluate(() => window.steps.second())) > 1000, 'no explanation');
        check(asked.some(isSecond), 'the second part was not fetched');
        equal(await page.evaluate(() => window.steps.remote()), value, 'in a worker');
        const frame = page.frameLocator('luxel-scene iframe');
        await frame.locator('canvas.picture').waitFor({ timeout: 60e3 });
        await page.waitForFunction(() => document.querySelector('luxel-scene').text !== undefined);
        equal(faults, [], 'faults');
    } finally {
        await page.close();
        server.close();
    }
    return asked.filter((name) => name.endsWith('.wasm')).join(' ');
}

function copy(place, folder, names) {
    for (const name of names) fs.copyFileSync(path.join(place, 'node_modules', name), path.join(folder, path.basename(name)));
}

const WASM = ['luxel-core/luxel-core.wasm', 'luxel-core/luxel-core-2.wasm'];

function plain(place) {
    const folder = path.join(place, 'plain');
    fs.mkdirSync(folder);
    copy(place, folder, [...WASM, 'luxel-scene/luxel-scene.js', 'luxel-scene/luxel.html']);
    copy(place, folder, ['index', 'remote', 'worker'].map((name) => `luxel-core/${name}.js`));
    fs.writeFileSync(path.join(folder, 'program.js'), imports('./index.js', './remote.js', './luxel-scene.js'));
    fs.writeFileSync(path.join(folder, 'index.html'), PAGE('program.js'));
    return folder;
}

async function bundled(place) {
    const folder = path.join(place, 'bundled');
    fs.writeFileSync(path.join(place, 'program.js'), imports('luxel-core', 'luxel-core/remote', 'luxel-scene'));
    await esbuild({
        entryPoints: { program: path.join(place, 'program.js'), worker: 'luxel-core/worker' },
        absWorkingDir: place,
        bundle: true,
        format: 'esm',
        outdir: folder,
        logLevel: 'error',
    });
    copy(place, folder, [...WASM, 'luxel-scene/luxel.html']);
    fs.writeFileSync(path.join(folder, 'index.html'), PAGE('program.js'));
    return folder;
}

async function built(place) {
    const root = path.join(place, 'project');
    fs.mkdirSync(root);
    fs.writeFileSync(path.join(root, 'main.js'), imports('luxel-core', 'luxel-core/remote', 'luxel-scene'));
    fs.writeFileSync(path.join(root, 'index.html'), PAGE('./main.js'));
    await vite({ root, base: './', logLevel: 'error', configFile: false, build: { target: 'es2022', assetsDir: '.' } });
    return path.join(root, 'dist');
}

export async function inBrowsers(place, told) {
    const executablePath = process.env.LUXEL_CHROMIUM ?? '/usr/bin/chromium';
    if (!fs.existsSync(executablePath)) {
        console.log(`# there is no ${executablePath}: pages are left out`);
        return;
    }
    const { value } = JSON.parse(told).points[0];
    const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });
    try {
        for (const [name, make] of Object.entries({ 'a plain page': plain, 'a bundle by esbuild': bundled, 'a build by Vite': built }))
            await test(name, async () => look(browser, await make(place), value));
    } finally {
        await browser.close();
    }
}
