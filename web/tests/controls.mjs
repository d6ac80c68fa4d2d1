// SPDX-License-Identifier: MIT
// What is done with lamps and bodies as a whole, the numbers that stand on the stage and below it, and what a tab keeps, in
// Chromium: against the tool's numbers where there are some.
import { execFileSync, spawnSync } from 'node:child_process';
import { inside, look, opened, openScene, openText, ready, shot, tab, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

const json = (tool, ...values) =>
    JSON.parse(execFileSync(tool, [...values, '--json'], { stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 26 }).toString());

const near = (got, expected, what, within = 1e-6) =>
    check(Math.abs(got - expected) <= within * Math.abs(expected) + 1e-9, `${what}: ${got} instead of ${expected}`);

/** The words that are written on a canvas while something is drawn. */
const written = (page, view) =>
    page.evaluate(async (view) => {
        const words = [];
        const { fillText } = CanvasRenderingContext2D.prototype;
        CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
            if (this.canvas.classList.contains(view)) words.push(text);
            return fillText.call(this, text, ...place);
        };
        window.luxel.inside[view].draw();
        await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 50)));
        CanvasRenderingContext2D.prototype.fillText = fillText;
        return words;
    }, view);

const enabled = (page) => inside(page, 'model.scene.lights.map(({ enabled }) => enabled)');

async function hasSolo(page) {
    await openScene(page, 'three-lights');
    await page.locator('.form [data-tab=light] .thing > details > summary').nth(1).click();
    const row = page.locator('.form [data-tab=light] .thing').nth(1);
    const solo = row.getByRole('button', { name: 'Solo' });
    await inside(page, "void model.change([{ set: 'lights[2].enabled=false' }])");
    await until(page, 'model.isSettled && !model.scene.lights[2].enabled');
    await solo.click();
    await until(page, 'model.isSettled && model.isSolo(1)');
    equal(await enabled(page), [false, true, false], 'lamps while one is alone');
    equal(await solo.getAttribute('aria-pressed'), 'true', 'the button');
    await solo.click();
    await until(page, 'model.isSettled && model.scene.lights[0].enabled');
    equal(await enabled(page), [true, true, false], 'lamps afterwards');
    await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, 'model.isSettled && model.isSolo(1)');
}

async function duplicates(page) {
    await openScene(page, 'three-lights');
    const before = await inside(page, 'model.scene.lights');
    await inside(page, "space.select(model.things.find(({ kind, index }) => kind === 'light' && index === 1))");
    await page.locator('canvas.space').focus();
    await page.keyboard.press('d');
    await until(page, 'model.isSettled && model.scene.lights.length === 4');
    const after = await inside(page, 'model.scene.lights');
    equal([after[2].type, after[2].flux, after[2].name], [before[1].type, before[1].flux, before[1].name], 'the copy');
    check(after[2].place[0] > before[1].place[0] && after[2].place[1] === before[1].place[1], `it stands at ${after[2].place}`);
    equal(after[3], before[2], 'the light behind it');
    await page.keyboard.press('Control+z');
    await until(page, 'model.isSettled && model.scene.lights.length === 3');
    await inside(page, "void model.duplicate('surfaces', [0])");
    await until(page, 'model.isSettled && model.scene.surfaces.length === 2');
    await inside(page, "space.select(model.things.find(({ kind, index }) => kind === 'surface' && index === 1))");
    await page.locator('canvas.space').focus();
    await page.keyboard.press('Delete');
    await until(page, 'model.isSettled && model.scene.surfaces.length === 1');
}

async function aims(page) {
    await openScene(page, 'spot');
    await tab(page, 'Light');
    await inside(page, 'void picture.moveProbe(60, -40)');
    await until(page, 'space.probe && Math.abs(space.probe.position[0] - 60) < 30');
    const to = await inside(page, 'space.probe.position.map(Math.round)');
    await page.getByRole('button', { name: 'Aim at the probe' }).click();
    await until(page, `model.isSettled && model.aimOf(0).at.join() === '${to.join()}'`);
}

/** Each row tells the flux of its lamp, and the irradiance that it brings to the probe, whatever the picture shows. */
async function tellsLamps(page, tool) {
    for (const scene of ['three-lights', 'desk']) {
        await openScene(page, scene);
        const [x, y] = [35, 20];
        await inside(page, `void picture.moveProbe(${x}, ${y})`);
        const told = json(tool, 'probe', scene, '-p', `${x},${y}`, '--quantity', 'irradiance').points[0];
        const shares = told.lights.map(({ irradiance }) => irradiance);
        await page.waitForFunction(
            (first) => document.querySelector('.form [data-tab=light] .of-probe')?.textContent.startsWith(first),
            String(Number(shares[0].toPrecision(4))),
        );
        const rows = await page.locator('.form [data-tab=light] .thing > details > summary').evaluateAll((all) =>
            all.map((row) => [row.querySelector('.of-probe').textContent, row.querySelector('.flux').textContent]),
        );
        equal(rows.length, shares.length, 'rows');
        const unit = await inside(page, 'model.scene.irradiance_unit');
        rows.forEach(([amount], i) => {
            check(amount.startsWith(String(Number(shares[i].toPrecision(4)))), `${scene}, lamp ${i + 1}: ${amount} instead of ${shares[i]}`);
            check(unit === 'relative' || amount.endsWith(unit), amount);
        });
        const fluxes = await inside(page, 'model.scene.lights.map(({ flux }) => flux)');
        rows.forEach(([, flux], i) => check(fluxes[i] === null || fluxes[i] < 0 ? flux === '' : flux.startsWith('Φ'), flux));
    }
    await shot(page, 'lamps');
}

async function numbersPixels(page, tool) {
    await openScene(page, 'report');
    await look(page, 'picture');
    equal((await written(page, 'picture')).filter((text) => text.includes('.')), [], 'numbers of small pixels');
    await inside(page, 'void (picture.view = [60, 100, 20])');
    const words = (await written(page, 'picture')).filter((text) => text.includes('.'));
    check(words.length > 20, `${words.length} numbers`);
    const known = await inside(page, '[...model.picture.values].map((value) => String(Number(value.toPrecision(4))))');
    equal(words.filter((word) => !known.includes(word)), [], 'numbers that no pixel has');
    await shot(page, 'pixels');
    await inside(page, 'void (picture.view = [1, 0, 0])');
}

async function labelsIsophotes(page) {
    await openScene(page, 'two-spheres');
    await look(page, 'picture');
    await tab(page, 'View');
    await page.getByLabel('Isophotes').check();
    await until(page, 'picture.isophotes.length > 3');
    const levels = await inside(page, '[...new Set(picture.isophotes.map(({ level }) => String(Number(level.toPrecision(3)))))]');
    const words = await written(page, 'picture');
    const told = levels.filter((level) => words.includes(level));
    check(told.length >= Math.min(4, levels.length), `${words} of ${levels}`);
    await shot(page, 'isophotes');
    await page.getByLabel('Isophotes').uncheck();
    await tab(page, 'Light');
}

async function showsHistogram(page, tool) {
    await openScene(page, 'report');
    await tab(page, 'Histogram');
    const row = page.getByRole('button', { name: /^true maximum/ });
    await row.waitFor();
    const { maximum, minimum } = json(tool, 'stats', 'report');
    const text = await row.textContent();
    near(Number(text.split(' ')[2]), maximum.value, text, 1e-5);
    near(Number((await page.getByRole('button', { name: /^true minimum/ }).textContent()).split(' ')[2]), minimum.value, 'the minimum', 1e-5);
    await row.click();
    await until(page, `Math.abs(model.picture.facts.maximum.x - picture.probe[0]) < 3`);
    await until(page, `Math.abs(space.probe?.value - ${maximum.value}) < 1e-4 * ${maximum.value}`);
    await shot(page, 'histogram');
    await tab(page, 'Section');
}

async function showsGrids(page, tool) {
    await openScene(page, 'sphere');
    check(await page.locator('.strip .tabs').getByRole('button', { name: 'Grids' }).isHidden(), 'grids of a scene without');
    for (const scene of ['tin', 'desk']) {
        await openScene(page, scene);
        await tab(page, 'Grids');
        await page.locator('.grids .cells td').first().waitFor();
        const [grid] = json(tool, 'grid', scene).grids;
        const cells = await page.locator('.grids .grid').first().locator('.cells td').allTextContents();
        const values = grid.values.flat();
        equal(cells.length, values.length, 'cells');
        values.forEach((value, i) => equal(cells[i], value === null ? '—' : String(Number(value.toPrecision(4))), `cell ${i}`));
        await look(page, 'space');
        await until(page, 'space.measured.cells.length > 0');
        const words = await written(page, 'space');
        const known = values.filter((value) => value !== null).map((value) => String(Number(value.toPrecision(3))));
        equal(await inside(page, 'space.measured.cells.map(({ text }) => text)'), known, 'numbers in space');
        check(words.filter((word) => known.includes(word)).length >= 5, `few numbers: ${words}`);
        await shot(page, `grids-${scene}`);
        await tab(page, 'Section');
        check(!(await written(page, 'space')).some((word) => word === String(Number(values[0]?.toPrecision(3)))), 'numbers that stay');
    }
}

const DESIGN = `luxel: 1
units: photometric
reflections: REFLECTIONS
screen: {width: 6000, height: 4500, resolution: [80, 60]}
observer: {position: [-1800, -1400, 1500], target: [600, 400, 800], up: [0, 0, 1], projection: perspective}
surfaces:
  - {type: room, center: [0, 0, 1350], size: [4000, 3000, 2700], up: z, material: {model: lambert, over_pi: true, diffuse: 0.5}}
lights:
  - {type: luminaire, file: 'builtin:office-lamp.ies', position: [0, 0, 2650], array: {n: [2, 1], spacing: [2000, 2000]}}
grids:
  - {name: task, center: [0, 0, 750], size: [1600, 1000], n: [4, 3], surround: 500, background: 500, limits: {average: 300, uniformity: 0.7, maximum: 10}}
observers:
  - {name: seated, eye: [-1900, 0, 1200], view: [1, 0, 0], limits: {ugr: 28}}
`;

/** Limits have the tool's numbers and verdicts, in the strip and in space; before all light is known nothing is said. */
async function judgesLimits(page, tool) {
    for (const reflections of ['none', '2']) {
        const text = DESIGN.replace('REFLECTIONS', reflections);
        const told = JSON.parse(spawnSync(tool, ['grid', '-', '--limits', '--json', '--reflected-error', '0.05'], { input: text }).stdout);
        await openText(page, text);
        await tab(page, 'Grids');
        await until(page, 'model.isSettled && space.measured.lines.length > 0 && space.measured.lines.every(({ verdict }) => verdict)');
        const rows = await page.locator('.grids .limit').evaluateAll((all) => all.map((row) => [row.className, ...[...row.children].map((cell) => cell.textContent)]));
        const expected = [...told.grids[0].limits, ...told.observers[0].limits];
        equal(rows.length, expected.length, 'limits');
        const words = { pass: 'kept', fail: 'not kept', undecided: 'undecided' };
        expected.forEach(({ name, wanted, value, verdict }, i) => {
            const [kind, , said, number, limit] = rows[i];
            equal([kind, said], [`limit ${verdict}`, words[verdict]], `what is said of ${name}, ${number} to ${value}`);
            check(limit.includes(String(Number(wanted.toPrecision(5)))), `${name}: ${limit} has no ${wanted}`);
            if (value === null) equal(number, '—', name);
            else check(Math.abs(parseFloat(number) - value) <= 0.03 * Math.abs(value), `${name}: ${number} instead of ${value}`);
        });
        const lines = [['fail', false], ['pass', true], ['pass', true], [told.observers[0].limits[0].verdict, false]];
        equal(await inside(page, 'space.measured.lines.map(({ verdict, isStrip }) => [verdict, !!isStrip])'), lines, 'lines in space');
        await shot(page, `limits-${reflections}`);
    }
    await tab(page, 'Section');
}

const UNDER_SKY = `luxel: 1
units: photometric
screen: {width: 3000, height: 3000, resolution: [60, 60]}
observer: {z: 9000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [4000, 4000], axis: [0, 0, 1], material: {model: lambert}}
  - {type: box, center: [700, 0, 900], size: [300, 3000, 1800], material: {model: lambert}}
lights:
  - {type: sky, kind: 1, horizontal: 700, ground: 0.2}
grids:
  - {name: desk, center: [0, 0, 800], size: [1000, 1000], n: [3, 2]}
`;

/** Under a sky grids tell daylight factors, the tool's numbers, in the strip and in space. */
async function tellsDaylight(page, tool) {
    const { grids } = JSON.parse(spawnSync(tool, ['daylight', '-', '--json'], { input: UNDER_SKY }).stdout);
    await openText(page, UNDER_SKY);
    await tab(page, 'Grids');
    await page.getByRole('button', { name: 'Daylight factor' }).click();
    await page.locator('.grids caption', { hasText: 'daylight factor' }).waitFor();
    const cells = await page.locator('.grids .cells td').allTextContents();
    const expected = grids[0].values.flat();
    equal(cells.length, expected.length, 'cells');
    cells.forEach((text, i) => check(Math.abs(Number(text) - expected[i]) <= 6e-4 * expected[i], `cell ${i}: ${text} instead of ${expected[i]}`));
    const facts = await page.locator('.grids table').first().innerText();
    for (const number of [grids[0].mean, grids[0].median]) check(facts.includes(String(Number(number.toPrecision(6))).slice(0, 5)), `${number} is not in ${facts}`);
    check(facts.includes(`${Number((100 * grids[0].en17037.shares[500]).toPrecision(3))} %`), `the share of 500 lx is not in ${facts}`);
    equal((await inside(page, 'space.measured.cells.map(({ text }) => text)')).map(Number), expected.map((value) => Number(value.toPrecision(3))), 'numbers in space');
    await shot(page, 'daylight-factors');
    await page.getByRole('button', { name: 'Illuminance' }).click();
    await page.locator('.grids caption', { hasText: 'lx' }).waitFor();
    await tab(page, 'Section');
}

/** A reload goes on where the page was, with all that can be undone. */
async function keepsOn(browser, url) {
    const page = await opened(browser, url);
    await openScene(page, 'three-lights');
    const first = await inside(page, 'model.text');
    await inside(page, "void model.change([{ set: 'lights[0].intensity=17' }])");
    await until(page, "model.isSettled && model.text.includes('intensity: 17')");
    await inside(page, "void model.change([{ set: 'lights[0].intensity=18' }])");
    await until(page, "model.isSettled && model.text.includes('intensity: 18')");
    const last = await inside(page, 'model.text');
    await page.reload();
    await ready(page);
    equal(await inside(page, 'model.text'), last, 'the scene');
    for (let i = 0; i < 2; i++) await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, `model.isSettled && model.text === ${JSON.stringify(first)}`);
    await page.getByRole('button', { name: 'Undo' }).click(); // the scene before
    await until(page, 'model.isSettled && model.scene.lights.length === 1');
    await page.getByRole('button', { name: 'Redo' }).click();
    await until(page, `model.isSettled && model.text === ${JSON.stringify(first)}`);
    // Another address is another scene.
    await page.goto('about:blank');
    await page.goto(`${url}#scene=spot`);
    await ready(page);
    check((await inside(page, 'model.text')).includes('spot'), 'the scene of the link');
    equal(page.faults, [], 'faults');
    await page.context().close();
}

export async function controls(browser, url, tool) {
    const page = await opened(browser, url);
    await test('a lamp alone, and as it was before', () => hasSolo(page));
    await test('lamps and bodies are duplicated and removed', () => duplicates(page));
    await test('a spot is aimed at the probe', () => aims(page));
    await test('rows of lamps tell flux and irradiance', () => tellsLamps(page, tool));
    await test('pixels tell their values from near', () => numbersPixels(page, tool));
    await test('isophotes tell their levels', () => labelsIsophotes(page));
    await test('the histogram tells the true extrema', () => showsHistogram(page, tool));
    await test('measuring grids with their numbers', () => showsGrids(page, tool));
    await test('limits of grids and observers, and whether they are kept', () => judgesLimits(page, tool));
    await test('daylight factors of grids under a sky', () => tellsDaylight(page, tool));
    await test('no fault was reported by controls', () => equal(page.faults, [], 'faults'));
    await page.context().close();
    await test('a reload goes on where it was', () => keepsOn(browser, url));
}
