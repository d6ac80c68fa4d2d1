// SPDX-License-Identifier: MIT
// Figures in Chromium: picture, section and polar diagrams as SVG, PDF and PNG, and a lamp's intensities against the numbers of its own
// pattern or file.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { inside, opened, openScene, openText, shot, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

async function saved(page, button) {
    const coming = page.waitForEvent('download');
    await page.locator('dialog.figures').getByRole('button', { name: button, exact: true }).click();
    const download = await coming;
    return { name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path()) };
}

const choose = (page, kind) => page.locator('dialog.figures select').selectOption(kind);
const drawn = (page, title) => page.locator('.figures .drawn svg title', { hasText: title }).waitFor({ state: 'attached' });

async function draws(page) {
    await openScene(page, 'three-lights');
    await until(page, 'section.last?.isKnown.every((each) => each) && model.isCurrent(section.last.of)');
    await page.locator('header .rest select').nth(1).selectOption('figure');
    await drawn(page, 'W/(sr');
    await shot(page, 'figure-picture');
    const picture = await saved(page, 'SVG');
    equal(picture.name, 'scene-picture.svg', 'the name');
    const text = picture.bytes.toString();
    for (const part of ['<svg xmlns=', 'x, mm', 'y, mm', 'data:image/png;base64,']) check(text.includes(part), `there is no ${part}`);
    const png = await saved(page, 'PNG');
    equal([png.name, png.bytes.subarray(1, 4).toString(), png.bytes.readUInt32BE(16)], ['scene-picture.png', 'PNG', 2160], 'the PNG');
    await choose(page, 'section');
    await drawn(page, 'W/(sr');
    const curves = await page.locator('.figures .drawn path').count();
    equal(curves, 4, 'curves: the value and three lamps');
    await shot(page, 'figure-section');
    await choose(page, '1');
    await page.locator('.figures .drawn', { hasText: 'C90–C270' }).waitFor();
    await shot(page, 'figure-polar');
    equal((await saved(page, 'SVG')).name, 'scene-lamp-2.svg', 'the name of a diagram');
    await page.locator('dialog.figures').getByRole('button', { name: 'Close' }).click();
}

/** What poppler says of a PDF: its words, and its pixels, three for each. */
function readPdf(bytes) {
    const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-pdf-'));
    const file = path.join(scratch, 'figure.pdf');
    fs.writeFileSync(file, bytes);
    const run = (program, ...values) => execFileSync(program, values, { stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 26 });
    const words = run('pdftotext', '-layout', file, '-').toString();
    const about = run('pdfinfo', file).toString();
    const picture = run('pdftoppm', '-r', '96', '-singlefile', file);
    fs.rmSync(scratch, { recursive: true });
    const [, width, height] = /^P6\s+(\d+)\s+(\d+)\s+255\s/.exec(picture.subarray(0, 40).toString('latin1')).map(Number);
    return { words, about, width, height, pixels: picture.subarray(picture.length - 3 * width * height) };
}

/** Pixels of the drawing as the page paints its SVG, three levels for each. */
const painted = (page) =>
    page.evaluate(async () => {
        const text = new XMLSerializer().serializeToString(document.querySelector('.figures .drawn svg'));
        const image = new Image();
        image.src = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
        await image.decode();
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [720, 560];
        canvas.getContext('2d').drawImage(image, 0, 0);
        return [...canvas.getContext('2d').getImageData(0, 0, 720, 560).data.filter((_, i) => i % 4 !== 3)];
    });

/** A PDF has the page's words, in Russian, too, and looks as the drawing does. */
async function makesPdf(page) {
    const told = [];
    for (const [language, kinds] of [['en', ['picture', 'section']], ['ru', ['picture', 'section', '1']]]) {
        await page.locator('header select').last().selectOption(language);
        await openScene(page, 'three-lights');
        await until(page, 'section.last?.isKnown.every((each) => each) && model.isCurrent(section.last.of)');
        await page.locator('header .rest select').nth(1).selectOption('figure');
        for (const kind of kinds) {
            await choose(page, kind);
            await page.waitForFunction(() => document.querySelector('.figures .drawn svg title'));
            await page.waitForTimeout(100);
            const { name, bytes } = await saved(page, 'PDF');
            equal(name.slice(-4), '.pdf', 'the name');
            const { words, about, width, height, pixels } = readPdf(bytes);
            const title = await page.locator('.figures .drawn svg title').textContent();
            check(about.includes(title), `${about} has no ${title}`);
            equal([width, height], [720, 560], 'the size');
            const seen = await page.locator('.figures .drawn text').allTextContents();
            const missing = seen.filter((each) => !words.replace(/\s+/g, '').includes(each.replace(/\s+/g, '')) && !each.startsWith('y, '));
            equal(missing, [], 'words that the PDF has not');
            const other = await painted(page);
            const off = other.reduce((sum, level, i) => sum + Math.abs(level - pixels[i]), 0) / other.length;
            check(off < 4, `${kind}: ${off} levels off the drawing`);
            told.push(`${language} ${kind} ${bytes.length} bytes, ${off.toFixed(2)} levels off`);
        }
        await page.locator('dialog.figures').locator('.bar-of-buttons button').click();
    }
    await page.locator('header select').last().selectOption('en');
    return told.join(', ');
}

const LAMPS = `luxel: 1
units: photometric
screen: {width: 700, height: 700, resolution: [60, 60]}
observer: {z: 2700}
surfaces: [{type: sphere, center: [0, 0, 0], radius: 200}]
lights:
  - {type: planar, disk: {center: [300, 0, 900], radius: 50, axis: [0, 0.6, -0.8]}, radiance: 1000}
  - {type: spot, position: [0, 400, 900], aim: [0, 0, 100], intensity: 80, inner: 10, outer: 30, falloff: linear}
  - {type: luminaire, file: 'builtin:office-lamp.ies', position: [0, 0, 1500]}
`;

/** Intensities are those of Lambert's law, of a cone, and of the built-in file. */
async function areTrue(page) {
    await openText(page, LAMPS);
    const of = (index) =>
        page.evaluate(async (index) => {
            const { degrees, planes } = await window.luxel.inside.polar(index);
            return [0, 15, 20, 40, 60, 100].map((angle) => planes.map((plane) => plane[degrees.indexOf(angle)]));
        }, index);
    const near = (found, expected, what) => {
        const off = Math.abs(found - expected);
        check(off <= 2e-5 * Math.abs(expected) + 1e-6, `${what}: ${found} instead of ${expected}`);
    };
    const panel = await of(0);
    const most = 1000 * Math.PI * 0.05 ** 2;
    [0, 15, 20, 40, 60, 100].forEach((angle, i) => panel[i].forEach((value) => near(value, most * Math.max(0, Math.cos((angle * Math.PI) / 180)), `a panel at ${angle}°`)));
    const spot = await of(1);
    [80, 60, 40, 0, 0, 0].forEach((expected, i) => spot[i].forEach((value) => near(value, expected, `a spot, ${i}`)));
    const lamp = await of(2);
    check(lamp[0][0] > 100 && Math.abs(lamp[0][0] - lamp[0][1]) < 1e-3 * lamp[0][0] && lamp[5][0] >= 0, `a file: ${JSON.stringify(lamp)}`);
}

export async function figures(browser, url) {
    const page = await opened(browser, url, { viewport: { width: 1280, height: 800 } });
    await test('figures are drawn and saved', () => draws(page));
    await test('figures as PDF look like the drawing', () => makesPdf(page));
    await test('polar diagrams have the true intensities', () => areTrue(page));
    await test('no fault was reported of figures', () => equal(page.faults, [], 'faults'));
    await page.context().close();
}
