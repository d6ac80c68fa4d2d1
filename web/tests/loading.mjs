// SPDX-License-Identifier: MIT
// The page in Chromium while the core's second part is on its way, fails to come, or is of another build: the server of
// these tests answers when and how they want.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { begun, dragBy, inside, lampIn, openText, shot, until } from './hands.mjs';
import { MESH } from './parts.mjs';
import { serve } from './server.mjs';
import { check, equal, test } from './tap.mjs';

const SECOND = 'luxel-core-2.wasm';
const COMING = 'The rest of Luxel is still being loaded';

/** A server whose second part waits for release(), and a page of it that shows its first picture. */
async function pageWithoutSecond(browser, folder, how = null) {
    let release;
    const released = new Promise((resolve) => (release = resolve));
    const later = (response, bytes) => void released.then(() => response.writeHead(200).end(bytes));
    const { server, asked, url } = await serve(folder, { [SECOND]: how ?? later });
    const page = await begun(browser, url);
    const end = async () => {
        await page.context().close();
        server.closeAllConnections();
        server.close();
    };
    return { page, release, asked, end };
}

async function begins(page) {
    check(!(await inside(page, 'model.client.isWhole')), 'the second part is there');
    const before = await inside(page, 'model.scene.lights[0].place');
    await dragBy(page, await lampIn(page, 'space'), -60, 30);
    await until(page, `model.scene.lights[0].place.join() !== '${before.join()}' && model.drags === 0`);
    await until(page, 'model.isSettled');
    equal(await page.locator('.loading').isVisible(), false, 'the notice');
}

const isMesh = `model.picture?.of.text === ${JSON.stringify(MESH)}`;

async function showsMesh(page, tool) {
    await until(page, `${isMesh} && model.isSettled`);
    await page.locator('.loading').waitFor({ state: 'hidden' });
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-loading-'));
    try {
        const scene = path.join(folder, 'scene.yaml');
        fs.writeFileSync(scene, MESH);
        const answer = JSON.parse(execFileSync(tool, ['probe', scene, '-p', '20,30', '--json'])).points[0];
        const probe = await page.evaluate(() => {
            const { model } = window.luxel.inside;
            return model.client.ask('probe', model.asWhole(), 20, 30);
        });
        equal(probe.value, answer.value, 'value');
    } finally {
        fs.rmSync(folder, { recursive: true });
    }
}

async function waits(browser, folder, tool) {
    const { page, release, end } = await pageWithoutSecond(browser, folder);
    await begins(page);
    await page.evaluate((text) => window.luxel.inside.open(text), MESH);
    await page.getByText(COMING).waitFor();
    await shot(page, 'loading');
    check(!(await inside(page, isMesh)), 'there is a picture of the mesh');
    release();
    await showsMesh(page, tool);
    equal(page.faults, [], 'faults');
    await end();
}

/** What waits for the second part makes way for another scene; a crash before it comes loses nothing. */
async function makesWay(browser, folder, tool) {
    const { page, release, end } = await pageWithoutSecond(browser, folder);
    const plain = await inside(page, 'model.text');
    await page.evaluate(() => {
        const { model } = window.luxel.inside;
        void model.client.ask('file', model.asWhole(), 'scene.png').catch(() => undefined);
    });
    await page.getByText(COMING).waitFor();
    const changed = plain.replace('luxel: 1', 'luxel: 1 # another');
    await openText(page, changed);
    await page.evaluate(() => window.luxel.inside.model.client.ask('crash').catch(() => undefined));
    await openText(page, plain);
    release();
    await openText(page, MESH);
    await showsMesh(page, tool);
    await end();
}

async function failsAndComes(browser, folder, tool) {
    let isUp = false;
    const how = (response, bytes) => (isUp ? response.writeHead(200).end(bytes) : response.writeHead(503).end());
    const { page, asked, end } = await pageWithoutSecond(browser, folder, how);
    await page.getByText('The rest of Luxel could not be loaded').waitFor();
    check((await page.locator('.loading').innerText()).includes('503'), 'the reason is not told');
    await page.evaluate((text) => window.luxel.inside.open(text), MESH);
    const times = () => asked.filter((name) => name === SECOND).length;
    equal(times(), 1, 'requests');
    await page.getByRole('button', { name: 'Try again' }).click();
    for (let i = 0; i < 600 && times() < 2; i++) await page.waitForTimeout(50);
    await page.getByText('The rest of Luxel could not be loaded').waitFor();
    await shot(page, 'not-loaded');
    isUp = true;
    await page.getByRole('button', { name: 'Try again' }).click();
    await showsMesh(page, tool);
    await end();
}

async function refusesOther(browser, folder) {
    let isOld = true;
    const how = (response, bytes) => {
        if (isOld) bytes[bytes.length - 1] ^= 1;
        response.writeHead(200).end(bytes);
    };
    const { page, end } = await pageWithoutSecond(browser, folder, how);
    await page.getByText('Luxel has been renewed on the server').waitFor();
    check(!(await inside(page, 'model.client.isWhole')), 'a part of another build is taken');
    isOld = false;
    await page.getByRole('button', { name: 'Load anew' }).click();
    await page.waitForFunction(() => window.luxel?.inside.model.client.isWhole);
    check(await page.locator('.loading').isHidden(), 'the notice stays');
    await end();
}

async function single(browser, folder, tool) {
    const page = await begun(browser, pathToFileURL(path.join(folder, 'luxel.html')).href);
    check((await inside(page, 'model.picture.facts.maximum.value')) > 10, 'no picture');
    await openText(page, MESH);
    await showsMesh(page, tool);
    equal(page.faults, [], 'faults');
    await page.context().close();
}

export async function loading(browser, folder, tool) {
    await test('the first picture needs no second part; what does waits for it', () => waits(browser, folder, tool));
    await test('what waits for the second part makes way', () => makesWay(browser, folder, tool));
    await test('a second part that does not come is told, and tried again', () => failsAndComes(browser, folder, tool));
    await test('a second part of another build is refused', () => refusesOther(browser, folder));
    await test('a single file, from the disk', () => single(browser, folder, tool));
}
