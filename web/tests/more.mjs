// SPDX-License-Identifier: MIT
// More of the page in Chromium: built-in scenes with pictures, files that scenes name, comparison, the dial, sections,
// the report, and the element for other pages.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { boxOf, dragBy, inside, look, opened, openScene, PATIENCE, shot, tab, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

const file = (name, content) => ({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(content) });
const KNOT = fs.readFileSync(new URL('../../examples/meshes/knot.ply', import.meta.url));
const CUBE = `${[-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => `v ${x} ${y} ${z}`))).join('\n')}
f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n`;
const LAMP = 'IESNA91\nTILT=NONE\n1 800 1 3 1 1 2 .1 .1 0 1 1 20\n0 45 90 0 300 200 0\n';
const NAMING = `luxel: 1
screen: {width: 700, height: 700, resolution: [200, 200]}
observer: {z: 1700, projection: orthographic, view: parallel}
surfaces:
  - {type: mesh, file: models/knot.ply, scale: 2, position: [0, 0, 300]}
lights:
  - {type: luminaire, file: lamp.ies, position: [420, 300, 1250]}
`;

async function showsBuiltins(page) {
    await page.getByRole('button', { name: 'Built-in scenes…' }).click();
    const count = await page.locator('dialog.gallery .card').count();
    await page.waitForFunction(
        () => [...document.querySelectorAll('.card canvas')].filter(({ width }) => width > 4).length > 6,
    );
    await shot(page, 'gallery');
    await page.locator('dialog.gallery .card', { hasText: 'two-spheres' }).first().click();
    await until(page, "model.wholeText.includes('two-spheres') || model.scene.surfaces.length === 2");
    return `${count} scenes`;
}

async function namesFiles(page) {
    await page.locator('#file').setInputFiles([file('scene.yaml', NAMING), file('knot.ply', KNOT)]);
    await page.locator('.files .error').waitFor();
    equal(await page.locator('.files li').count(), 2, 'files');
    check((await page.locator('.files .error').innerText()).startsWith('lamp.ies'), 'the missing one');
    await page.getByLabel('Choose file… lamp.ies').last().setInputFiles(file('another name.txt', LAMP));
    await until(page, 'model.wholeText === model.text && model.files.every(([, found]) => found) && !model.stale');
    await until(page, 'model.picture.facts.columns === 200 && model.picture.facts.maximum.value > 0');
    await shot(page, 'files');
    // The core that is started after a failure has the files, too.
    await page.evaluate(() => window.luxel.inside.model.client.ask('crash').catch(() => undefined));
    await until(page, '!model.stale && model.files.every(([, found]) => found)');
}

async function joins(page) {
    await openScene(page, 'report');
    const before = await inside(page, 'model.text');
    await page.locator('#file').setInputFiles(file('cube.obj', CUBE));
    await until(page, 'model.scene.surfaces.length === 2 && !model.stale');
    const [ball, cube] = await inside(page, 'model.scene.surfaces');
    check(cube.reach > 50 && cube.center[2] > ball.center[2] + ball.reach, JSON.stringify([ball, cube]));
    await page.locator('#file').setInputFiles(file('lamp.ies', LAMP));
    await until(page, "model.scene.lights.length === 2 && model.scene.lights[1].type === 'luminaire' && !model.stale");
    await until(page, 'model.isSettled');
    await shot(page, 'joined');
    await page.getByRole('button', { name: 'Undo' }).click();
    await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, `model.text === ${JSON.stringify(before)}`);
}

async function compares(page) {
    await openScene(page, 'report');
    await tab(page, 'View');
    await page.getByRole('button', { name: 'Keep as A' }).click();
    const kept = await inside(page, 'model.picture.facts.maximum.value');
    await inside(page, "void model.change([{ set: 'lights[0].intensity=11' }])");
    await until(page, 'model.isSettled && model.picture.facts.maximum.value > 1.09 * 11.7');
    await page.getByLabel('Compare').selectOption('difference');
    await page.waitForFunction(() => /= 10 %/.test(document.querySelector('.compare + p').textContent));
    const scale = await inside(page, '[picture.shownScale.low, picture.shownScale.high]');
    check(Math.abs(scale[1] - 0.1 * kept) < 1e-5 * kept && scale[0] === -scale[1], JSON.stringify(scale));
    await shot(page, 'difference');
    await page.getByLabel('Compare').selectOption('A');
    await until(page, `picture.scale.high === ${kept}`);
    await page.getByRole('button', { name: 'Forget A' }).click();
    equal(await page.getByLabel('Compare').count(), 0, 'choices without A');
    await inside(page, 'void (model.picture = { ...model.picture, stride: 2 })'); // as if the whole one were on its way
    await page.getByRole('button', { name: 'Keep as A' }).click();
    equal(await page.getByLabel('Compare').count(), 0, 'choices before A is there');
    await inside(page, "void model.change([{ set: 'lights[0].intensity=12' }])");
    await page.getByLabel('Compare').waitFor();
    await page.getByRole('button', { name: 'Forget A' }).click();
}

async function turnsDial(page) {
    await openScene(page, 'report');
    const most = await inside(page, 'picture.scale.high');
    await tab(page, 'View');
    const exposure = page.getByLabel('Exposure', { exact: true });
    await exposure.focus();
    for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowRight');
    const halved = await inside(page, 'picture.scale.high');
    check(Math.abs(halved - most / 2) < 1e-9 * most, `one stop more: ${halved} of ${most}`);
    for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowLeft');
    const upper = page.getByRole('slider', { name: 'Upper end of the scale' });
    const box = await boxOf(upper);
    await dragBy(page, [box.x + 12, box.y + 11], 0, 100);
    const dragged = await inside(page, 'picture.scale.high');
    check(dragged < 0.9 * most && dragged > 0.4 * most, `${dragged} of ${most}`);
    check(await page.getByLabel('Lock range').isChecked(), 'the range is not locked');
    await upper.press('ArrowUp');
    check((await inside(page, 'picture.scale.high')) > dragged, 'a key does not move the end');
    await page.getByLabel('Lock range').uncheck();
    await until(page, `picture.scale.high === ${most}`);
}

async function cuts(page, tool) {
    await openScene(page, 'three-lights');
    await tab(page, 'View');
    await page.getByLabel('Angle').fill('90');
    await until(page, 'section.last && Math.abs(section.last.from[0] - section.last.to[0]) < 1e-9');
    const axis = (text) =>
        page.waitForFunction(
            (text) => document.querySelector('canvas.section').getAttribute('aria-label') === text,
            `Section, ${text} mm`,
        );
    await axis('y: −360 … 360');
    await page.getByLabel('Fix the line').check();
    for (const [name, value] of Object.entries({ 'x₁': '-100', 'y₁': '-50', 'x₂': '120', 'y₂': '80' })) {
        await page.getByLabel(`${name}, mm`).fill(value);
        await page.getByLabel(`${name}, mm`).press('Enter');
    }
    await until(page, 'section.last.to[0] === 120 && section.last.to[1] === 80 && section.last.from[1] === -50 && section.last.isKnown.every(Boolean)');
    await axis('s: 0 … 255.54');
    await page.getByLabel('Curves').selectOption('shares');
    const row = await inside(page, 'section.last.rows[240]');
    const answer = JSON.parse(execFileSync(tool, ['probe', 'three-lights', '-p', '120,80', '--json']).toString());
    equal(row[1], answer.points[0].value, 'the value at the end of the line');
    await shot(page, 'section');
    const [download] = await Promise.all([
        page.waitForEvent('download'),
        page.getByRole('button', { name: 'Section (CSV)' }).click(),
    ]);
    const lines = fs
        .readFileSync(await download.path(), 'utf8')
        .trim()
        .split('\n');
    equal([lines[0], lines.length], ['s_mm,x_mm,y_mm,value,light_1,light_2,light_3', 242], 'table');
    await look(page, 'picture');
    const canvas = await boxOf(page.locator('canvas.picture'));
    const [x, y] = await inside(
        page,
        'picture.toCanvas(120, 80, picture.canvas.clientWidth, picture.canvas.clientHeight)',
    );
    await dragBy(page, [canvas.x + x, canvas.y + y], -60, 0);
    await until(page, 'section.last.to[0] < 90 && section.last.to[1] === 80');
    await page.getByLabel('Fix the line').uncheck();
    await page.getByLabel('Curves').selectOption('values');
    await page.getByLabel('Angle').fill('0');
}

async function reports(page, browser, tool) {
    await openScene(page, 'report');
    const [download] = await Promise.all([
        page.waitForEvent('download'),
        page.getByLabel('Download').selectOption('.html'),
    ]);
    const html = fs.readFileSync(await download.path(), 'utf8');
    const other = await (await browser.newContext({ viewport: { width: 900, height: 900 } })).newPage();
    await other.setContent(html);
    const text = await other.locator('body').innerText();
    const titles = ['Aim of the work', 'Task', 'Parameters', 'Pictures', 'Results', 'Conclusions', 'Method', 'Repetition'];
    equal(
        await other.locator('h2').allInnerTexts(),
        titles.map((title, i) => `${i + 1}. ${title}`),
        'chapters',
    );
    const answer = JSON.parse(execFileSync(tool, ['probe', 'report', '--json']).toString());
    for (const { value } of answer.points.filter(({ value }) => typeof value === 'number'))
        check(
            text.includes(String(Number(value.toPrecision(12)))) ||
                text.includes(value.toExponential(11).replace('-', '−')),
            `${value} is not in it`,
        );
    const cells = await other.locator('tr', { hasText: 'lights[0].intensity' }).locator('td').allInnerTexts();
    equal([cells[0], cells[2], cells[3]], ['lights[0].intensity', '10', 'W/sr'], 'a row of the parameters');
    check(/The brightness is greatest, 11\.\d+ W\/sr/.test(text), text.slice(0, 3000));
    equal(
        await other.locator('img').evaluateAll((all) => all.every(({ naturalWidth }) => naturalWidth > 99)),
        true,
        'pictures',
    );
    await shot(other, 'report');
    await other.context().close();
}

/** A ball over a floor, each of which lights the other. */
const REFLECTING = `luxel: 1
reflections: 1
screen: {width: 1000, height: 1000, resolution: [24, 24]}
observer: {z: 3000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [900, 900], material: {model: lambert, diffuse: 0.7, over_pi: true}}
  - {type: sphere, center: [0, 0, 400], radius: 150, material: {model: lambert, diffuse: 0.5, over_pi: true}}
lights: [{type: point, position: [-300, 0, 900], power: 20, attenuation: inverse-square}]
points: [[-350, 0]]
`;

async function reportsReflections(page, browser, tool) {
    await page.evaluate((text) => window.luxel.inside.open(text), REFLECTING);
    await until(page, `model.wholeText === ${JSON.stringify(REFLECTING)} && model.picture?.of.text === model.wholeText`);
    await until(page, 'model.isSettled');
    const [download] = await Promise.all([
        page.waitForEvent('download'),
        page.getByLabel('Download').selectOption('.html'),
    ]);
    const other = await (await browser.newContext({ viewport: { width: 900, height: 900 } })).newPage();
    await other.setContent(fs.readFileSync(await download.path(), 'utf8'));
    const text = await other.locator('body').innerText();
    const scene = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-')), 'ball.yaml');
    fs.writeFileSync(scene, REFLECTING);
    const [{ value }] = JSON.parse(execFileSync(tool, ['probe', scene, '--json']).toString()).points;
    check(text.includes(String(Number(value.toPrecision(6))).slice(0, 7)), `${value} is not in it`);
    const cells = await other.locator('tr', { hasText: 'reflections' }).first().locator('td').allInnerTexts();
    equal(cells[0], 'reflections', 'the row of the parameter');
    await shot(other, 'report-reflections');
    await other.context().close();
}

/** The balance of the flux is the tool's, comes by itself, in both languages, and goes where there is no reflected light. */
async function balances(page, tool) {
    await page.evaluate((text) => window.luxel.inside.open(text), REFLECTING);
    await until(page, `model.picture?.of.text === ${JSON.stringify(REFLECTING)} && model.isSettled`);
    await tab(page, 'Balance');
    const tables = page.locator('.balance:not(.old) table');
    await tables.last().waitFor();
    const scene = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-')), 'ball.yaml');
    fs.writeFileSync(scene, REFLECTING);
    const { surfaces, balance } = JSON.parse(execFileSync(tool, ['stats', scene, '--json']).toString());
    const amounts = await tables.locator('td').allInnerTexts();
    const fluxes = Object.values(balance).filter((each) => typeof each === 'object');
    const truths = [...surfaces.map(({ irradiance }) => irradiance), ...fluxes];
    equal(amounts.length, truths.length, 'numbers');
    amounts.forEach((text, i) => {
        const [value, error] = text.split(' ± ').map((number) => Number(number.replace('−', '-')));
        // both are within their bounds of the truth; the page's bound covers its rounding, too
        const near = Math.abs(value - truths[i].value) <= error + truths[i].error;
        check(near && error < 1.2 * truths[i].error + 1e-6 * Math.abs(value), `${text}: ${JSON.stringify(truths[i])}`);
    });
    await shot(page, 'balance');
    await page.getByLabel('Language').selectOption('ru');
    await page.locator('.balance:not(.old) caption', { hasText: 'Баланс потока, Вт' }).waitFor();
    await page.locator('.balance th', { hasText: 'излучают источники' }).waitFor();
    await page.getByLabel('Язык').selectOption('en');
    await openScene(page, 'report');
    await page.locator('.balance').waitFor({ state: 'hidden' });
}

/** A page of a course with two scenes; what the element shows, tells and takes. */
export const COURSE = `<!doctype html><html lang="ru"><meta charset="utf-8"><title>Course</title>
<script src="luxel-scene.js" defer></script>
<h1>Светотехника</h1>
<luxel-scene id="named" scene="two-spheres" view="both"></luxel-scene>
<luxel-scene id="own" view="picture" lang="en" files="lamp.ies" label="A lamp">
  <script type="text/yaml">
    ${NAMING.replace('{type: mesh, file: models/knot.ply, scale: 2, position: [0, 0, 300]}', '{type: sphere, center: [0, 0, 300], radius: 250}').replaceAll('\n', '\n    ')}
  </script>
</luxel-scene></html>`;

async function embeds(browser, url) {
    const context = await browser.newContext({ viewport: { width: 1000, height: 1600 } });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE);
    await page.goto(url.replace('index.html', 'course.html'));
    const whole = (frame) =>
        frame.waitForFunction(
            () => window.luxel?.inside.model.isSettled,
        );
    const frameOf = async (id) => (await page.locator(`#${id} iframe`).elementHandle()).contentFrame();
    const named = await frameOf('named');
    await whole(named);
    check(await named.getByRole('button', { name: 'Почему?' }).isVisible(), 'not in the language of the page');
    check(!(await named.locator('header').isVisible()), 'the header is seen in a frame');
    const own = await frameOf('own');
    await whole(own);
    equal(await own.evaluate(() => window.luxel.inside.model.files), [['lamp.ies', true]], 'files');
    equal(await own.locator('canvas.space').isVisible(), false, 'the space view');
    equal(await own.locator('canvas.section').isVisible(), false, 'the section');
    equal(await page.locator('#own iframe').getAttribute('title'), 'A lamp', 'title');
    const told = page.evaluate(
        () =>
            new Promise((resolve) =>
                document.addEventListener('luxel-change', ({ detail }) => resolve(detail.text), { once: true }),
            ),
    );
    await own.evaluate(() => void window.luxel.inside.model.change([{ set: 'lights[0].factor=0.5' }]));
    check((await told).includes('factor: 0.5'), 'the page around is not told');
    await page.evaluate(
        () =>
            (document.querySelector('#named').text = document
                .querySelector('#named')
                .text.replace('radius: 330', 'radius: 329')),
    );
    await named.waitForFunction(
        () =>
            window.luxel.inside.model.text.includes('radius: 329') &&
            window.luxel.inside.model.picture?.of.text.includes('radius: 329'),
    );
    const heights = await page
        .locator('iframe')
        .evaluateAll((all) => all.map((frame) => frame.clientHeight - frame.contentDocument.body.scrollHeight));
    check(
        heights.every((off) => Math.abs(off) < 3),
        `heights are off by ${heights}`,
    );
    await shot(page, 'course');
    await context.close();
}

export async function more(page, browser, url, tool) {
    await test('built-in scenes with their pictures', () => showsBuiltins(page));
    await test('files that a scene names are told, given and kept', () => namesFiles(page));
    await test('a mesh and a lamp join the scene', () => joins(page));
    await test('two pictures are compared', () => compares(page));
    await test('the dial: exposure and ends', () => turnsDial(page));
    await test('sections along any line, and of shares', () => cuts(page, tool));
    await test('the report', () => reports(page, browser, tool));
    await test('the balance of the flux', () => balances(page, tool));
    await test('a report of surfaces that light each other', () => reportsReflections(page, browser, tool));
    await test('scenes in a page of a course', () => embeds(browser, url));
}

export const PAGES = { 'course.html': COURSE, 'lamp.ies': LAMP };
