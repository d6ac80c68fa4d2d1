// SPDX-License-Identifier: MIT
// Nothing stale, nothing mixed: a slow scene is opened beside a quick one and changed in all ways, and at each moment every
// label, list, table and file that is neither dimmed nor empty is held against the tool's numbers for the text of that
// moment.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { inside, opened, openText, shot, tab, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

const DIRECT = ' (direct light alone)';

/** The tool's answers for texts, each asked for once. */
class Tool {
    folder = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-versions-'));
    answers = new Map();

    constructor(program) {
        this.program = program;
    }

    ask(text, isDirect, ...values) {
        const key = JSON.stringify([text, isDirect, values]);
        if (!this.answers.has(key)) {
            const scene = path.join(this.folder, 'scene.yaml');
            fs.writeFileSync(scene, text);
            const [command, ...rest] = values;
            const set = isDirect && text.includes('reflections') ? ['-s', 'reflections=none'] : [];
            const env = { ...process.env, LUXEL_ISA: process.arch === 'x64' ? 'x86-64' : 'generic', LC_ALL: 'C' };
            const options = { env, stdio: ['ignore', 'pipe', 'pipe'] };
            this.answers.set(key, JSON.parse(execFileSync(this.program, [command, scene, ...set, ...rest, '--json'], options)));
        }
        return this.answers.get(key);
    }

    values(text, isDirect, places) {
        const asked = places.flatMap(([x, y]) => ['-p', `${x},${y}`]);
        return this.ask(text, isDirect, 'probe', ...asked).points;
    }

    close() {
        fs.rmSync(this.folder, { recursive: true });
    }
}

/** All that the page shows at this moment, and does not dim. */
const look = (page) =>
    page.evaluate(() => {
        const { model, section, picture } = window.luxel.inside;
        const isShown = (element) => element && !element.closest('.old, [hidden]');
        const textOf = (selector) => {
            const element = document.querySelector(selector);
            return isShown(element) && element.textContent ? element.textContent : null;
        };
        const all = (selector) => [...document.querySelectorAll(selector)].filter(isShown);
        const canSave = !document.querySelector('[aria-label="Section (CSV)"]').disabled;
        const hasSection = section.last && isShown(section.canvas);
        const hasPicture = model.picture && isShown(picture.canvas) && picture.shownImage?.width > 1;
        return {
            text: model.text,
            isBroken: model.stale,
            value: textOf('.value'),
            place: textOf('.probe .dim'),
            shares: all('.shares li').map(({ textContent }) => textContent),
            statistics: textOf('.statistics'),
            heads: all('.points th[scope=col]').map(({ textContent }) => textContent),
            points: all('.points tbody tr').map(({ cells }) => [...cells].map(({ textContent }) => textContent)),
            kinds: all('.form .thing summary').map(({ textContent }) => textContent),
            size: hasPicture ? [picture.image.width * model.picture.stride, picture.image.height * model.picture.stride] : null,
            lamps: isShown(picture.canvas) ? picture.marks.filter(({ thing }) => thing.kind === 'light').length : null,
            things: isShown(document.querySelector('canvas.space')) ? model.things.length : null,
            section: hasSection ? section.last : null,
            saved: canSave ? section.last : null,
            balance: all('.balance td').map(({ textContent }) => textContent),
            notice: textOf('.working'),
            isBusy: document.querySelector('main').getAttribute('aria-busy'),
        };
    });

const numberOf = (text) => Number(/[−-]?\d[\d.]*(e[−+-]?\d+)?/.exec(text)[0].replaceAll('−', '-'));

/** Whether digits that are shown are those of the tool; reflected light has bounds, of the page's and of the tool's number. */
function agrees(text, truth, what) {
    if (typeof truth.value !== 'number') return check(text.startsWith('—') || text === '', `${what}: "${text}", and there is no value`);
    const [shown, bound] = text.split(' ± ').map(numberOf);
    const room = 1e-5 * Math.abs(truth.value) + 1e-9 + (truth.error ?? 0) + (bound ?? 0);
    check(Math.abs(shown - truth.value) <= room, `${what}: "${text}" instead of ${truth.value}`);
}

const itemsOf = (text) => text.match(/(^  - \{?|\[\{)type: /gm).length; // of surfaces and lights

/** Holds what was seen at one moment against the tool. */
function judge(tool, seen, when) {
    const { text, isBroken } = seen;
    const name = `${when}, ${JSON.stringify(text.slice(0, 60))}`;
    if (isBroken) {
        const shown = ['value', 'statistics', 'section', 'saved', 'size', 'things', 'lamps'].filter((key) => seen[key] !== null);
        equal([shown, seen.points, seen.balance], [[], [], []], `${name}: not dimmed beside errors`);
        return;
    }
    if (seen.value !== null) {
        const [x, y] = seen.place.split(', ').map(numberOf);
        const isDirect = seen.value.endsWith(DIRECT);
        agrees(seen.value, tool.values(text, isDirect, [[x, y]])[0], `${name}: value at (${x}, ${y})`);
        check(seen.shares.length === 0 || seen.shares.length === tool.ask(text, true, 'probe').lights.length, `${name}: ${seen.shares.length} shares`);
    }
    if (seen.statistics !== null) {
        const { unit, max, mean } = tool.ask(text, seen.statistics.endsWith(DIRECT), 'stats');
        const [, own, most] = /, ([^:]*): maximum ([^,]*), mean/.exec(seen.statistics);
        equal(own, unit, `${name}: unit`);
        const [, roughly] = /within ([^ ]*) % .*reflected light roughly/.exec(seen.statistics) ?? [, 0];
        agrees(most, { value: max.value, error: (3e-5 + 0.01 * numberOf(String(roughly))) * max.value }, `${name}: maximum`);
        check(typeof mean === 'number', name);
    }
    if (seen.points.length) {
        const places = seen.points.map(([, x, y]) => [numberOf(x), numberOf(y)]);
        const isDirect = seen.heads[3].endsWith(DIRECT);
        const truths = tool.values(text, isDirect, places);
        equal(places, tool.ask(text, true, 'probe').points.map(({ screen }) => screen), `${name}: points`);
        seen.points.forEach(([, , , value], i) => agrees(value, truths[i], `${name}: point ${i + 1}`));
    }
    for (const section of [seen.section, seen.saved].filter(Boolean)) {
        equal(section.of.text, text, `${name}: the text of the section`);
        const last = section.rows.length - 1;
        const some = [0, 80, 160, last].filter((i) => section.isKnown[i]);
        const places = some.map((i) =>
            [0, 1].map((axis) => section.from[axis] * (1 - i / last) + section.to[axis] * (i / last)),
        );
        const truths = places.length ? tool.values(text, section.of.direct, places) : [];
        // reflected light on a surface is known within a thousandth of the maximum
        const room = section.of.direct ? 0 : 1e-3 * tool.ask(text, false, 'stats').max.value;
        some.forEach((i, k) =>
            agrees(String(section.rows[i][1] ?? '—'), { ...truths[k], error: room }, `${name}: section, sample ${i}`),
        );
    }
    check(!seen.saved || !seen.saved.of.direct || !text.includes('reflections'), `${name}: a table without reflected light`);
    const resolution = /resolution: \[(\d+), (\d+)\]/.exec(text).slice(1).map(Number);
    if (seen.size) check(seen.size.every((size, i) => size >= resolution[i] && size < resolution[i] + 16), `${name}: picture of ${seen.size}`);
    const lamps = text.match(/position: \[[^}]*intensity|power|planar/g).length; // those that stand somewhere
    if (seen.lamps) equal(seen.lamps, lamps, `${name}: lamps in the picture`);
    const kinds = seen.kinds.filter((each) => /^\d/.test(each));
    if (kinds.length) equal(kinds.length, itemsOf(text), `${name}: form of ${kinds}`);
}

/** Looks at the page again and again while something is done, and keeps what differs from what was seen before. */
async function watch(page, seen, when, act, milliseconds) {
    let isOver = false;
    const acting = act().finally(() => (isOver = true));
    const end = Date.now() + milliseconds;
    for (let isLast = false; !isLast; await pause(page, 20)) {
        isLast = isOver && Date.now() >= end;
        const now = { when, ...(await look(page)) };
        if (JSON.stringify(seen.at(-1)) !== JSON.stringify(now)) seen.push(now);
    }
    await acting;
}

const QUICK = `luxel: 1
screen: {width: 700, height: 700, resolution: [200, 200]}
observer: {z: 1700}
surfaces: [{type: sphere, center: [0, 0, 300], radius: 250, material: {model: lambert, diffuse: 0.8}}]
lights: [{type: point, position: [420, 300, 1250], intensity: 7}]
points: [[0, 0], [100, 50]]
`;

/** Four walls of light between surfaces: longer to solve than any test waits. */
const slowOf = (room) => room.replace('luxel: 1', 'luxel: 1\nreflections: 1');

/** A ball over a floor, each of which lights the other: a moment. */
export const BALL = `luxel: 1
reflections: 1
screen: {width: 1000, height: 800, resolution: [60, 48]}
observer: {z: 3000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [900, 700], material: {model: lambert, diffuse: 0.7, over_pi: true}}
  - {type: sphere, center: [0, 0, 400], radius: 150, material: {model: lambert, diffuse: 0.5, over_pi: true}}
lights: [{type: point, position: [-300, 0, 900], power: 20, attenuation: inverse-square}]
points: [[-350, 0], [100, 20]]
`;

const begin = (page, text) => page.evaluate((text) => window.luxel.inside.open(text), text);
const change = (page, set) =>
    page.evaluate((set) => window.luxel.inside.model.change([{ set }]).then(() => undefined), set);
const pause = (page, milliseconds) => page.waitForTimeout(milliseconds);

async function slowBesideQuick(page, tool, room) {
    const slow = slowOf(room);
    const seen = [];
    await openText(page, QUICK);
    await watch(page, seen, 'the slow scene is opened', () => begin(page, slow), 4000);
    await until(page, `model.picture?.of.text === ${JSON.stringify(slow)}`);
    await until(page, "model.work?.state === 'working' && section.last?.isKnown.every(Boolean)");
    await shot(page, 'slow');
    await watch(page, seen, 'the probe moves', () => inside(page, 'picture.moveProbe(-300, 200)'), 1500);
    await watch(page, seen, 'a lamp is switched off', () => change(page, 'lights[1].enabled=false'), 2500);
    await watch(page, seen, 'an error', () => inside(page, "model.setText(model.text.replace('size: [4400', 'size: [-4400'))"), 1500);
    check(await inside(page, 'model.stale'), 'the error is not found');
    await shot(page, 'slow-error');
    await page.getByLabel('Download').selectOption('.png');
    await page.getByText('There is no file of a scene with errors').waitFor();
    await page.getByRole('button', { name: 'Why?' }).click();
    await page.getByText('A scene with errors has no values to explain').waitFor();
    await page.keyboard.press('Escape');
    await watch(page, seen, 'the error is undone', () => inside(page, 'model.undo()'), 2000);
    await watch(page, seen, 'the quantity', () => inside(page, 'model.setIrradiance(true)'), 500);
    await inside(page, 'model.setIrradiance(false)');
    await watch(page, seen, 'the quick scene is opened', () => begin(page, QUICK), 1500);
    await watch(page, seen, 'undone, slow', () => inside(page, 'model.undo()'), 1500);
    await watch(page, seen, 'redone, quick', () => inside(page, 'model.redo()'), 1500);
    await watch(page, seen, 'a lamp is moved', () => change(page, 'lights[0].position=[-400, 100, 1250]'), 800);
    await until(page, 'model.isSettled');
    const told = seen.filter(({ when }) => when !== 'the quantity');
    for (const each of told) judge(tool, each, each.when);
    const direct = told.filter(({ value }) => value?.endsWith(DIRECT));
    check(direct.length > 0, 'no direct light was seen');
    check(told.some(({ notice }) => /Reflected light/.test(notice ?? '')), 'no progress is told');
    check(told.some(({ isBusy }) => isBusy === 'true'), 'it is never busy');
    return `${told.length} moments`;
}

/** Direct light comes at once, all light later, by one solution; its table can be had then, and not before. */
async function lightComes(page, tool) {
    const seen = [];
    await openText(page, QUICK);
    await page.evaluate(() => {
        const { model } = window.luxel.inside;
        window.workers = 0;
        const { twin } = model.client;
        model.client.twin = function () {
            window.workers++;
            return twin.call(this);
        };
    });
    await watch(
        page,
        seen,
        'the ball is opened',
        async () => {
            await begin(page, BALL);
            await until(page, 'model.isSettled');
            await tab(page, 'Balance');
            await page.locator('.balance:not(.old) table').last().waitFor();
            await until(page, 'section.last?.isKnown.every(Boolean) && !section.last.of.direct');
        },
        0,
    );
    seen.forEach((each) => judge(tool, each, each.when));
    equal(await page.evaluate(() => window.workers), 1, 'workers that computed reflected light');
    const last = seen.at(-1);
    check(!last.value.includes('direct') && last.saved && !last.saved.of.direct, 'reflected light does not come');
    await tab(page, 'View');
    const [download] = await Promise.all([
        page.waitForEvent('download'),
        page.locator('[aria-label="Section (CSV)"]').click(),
    ]);
    const rows = fs.readFileSync(await download.path(), 'utf8').trim().split('\n').slice(1);
    const some = [0, 100, 200, 240].map((i) => rows[i].split(','));
    const truths = tool.values(BALL, false, some.map(([, x, y]) => [Number(x), Number(y)]));
    const room = 1e-3 * tool.ask(BALL, false, 'stats').max.value;
    some.forEach(([, , , value], i) => agrees(value || '—', { ...truths[i], error: room }, `row ${i}`));
    return `${seen.length} moments`;
}

async function stops(page, room) {
    await begin(page, slowOf(room));
    await page.getByRole('button', { name: 'Stop' }).click();
    await page.getByText(/Reflected light was (not computed|computed roughly)/).waitFor();
    equal(await page.locator('main').getAttribute('aria-busy'), 'false', 'busy');
    check((await page.locator('.value').innerText()).endsWith(DIRECT), 'the value is not said to be of direct light');
    await page.getByRole('button', { name: 'Continue' }).click();
    await until(page, "model.work?.state === 'working'");
    await page.getByLabel('Download').selectOption('.png');
    await page.getByText('Reflected light is not known yet').waitFor();
    await page.getByRole('button', { name: 'Why?' }).click();
    await page.getByText('The value is explained when').waitFor();
    await page.keyboard.press('Escape');
    await openText(page, QUICK);
}

/** The last movements of a drag do not reach the scene that is opened then, whenever they come. */
async function dragsStay(page) {
    for (const wait of [0, 0, 0, 5, 10, 20, 40, 80]) {
        await openText(page, QUICK);
        const next = QUICK.replace('[420, 300, 1250]', `[${400 + wait}, 301, 1250]`).replace('radius: 250', 'radius: 249');
        const isKept = await page.evaluate(
            async ([text, wait]) => {
                const { model, space, open } = window.luxel.inside;
                const canvas = document.querySelector('canvas.space');
                const { left, top } = canvas.getBoundingClientRect();
                const [x, y] = space.seen(model.things.find(({ kind }) => kind === 'light').at);
                const send = (type, dx) =>
                    canvas.dispatchEvent(
                        new PointerEvent(type, { pointerId: 1, clientX: left + x + dx, clientY: top + y, bubbles: true }),
                    );
                canvas.setPointerCapture = () => undefined;
                send('pointerdown', 0);
                for (let i = 1; i < 6; i++) send('pointermove', -8 * i);
                send('pointerup', -40);
                if (wait) await new Promise((resolve) => setTimeout(resolve, wait));
                open(text);
                await new Promise((resolve) => setTimeout(resolve, 700));
                return model.text === text;
            },
            [next, wait],
        );
        check(isKept, `after ${wait} ms the drag changes the next scene`);
    }
}

/** The value under the pointer does not wait for the section of 241 values. */
async function probesFirst(page) {
    const text = await page.evaluate(() => window.luxel.inside.builtins.find(({ name }) => name === 'window').text);
    await openText(page, text);
    const order = await page.evaluate(async () => {
        const { model, picture, section } = window.luxel.inside;
        const order = [];
        const { ask } = model.client;
        model.client.ask = async function (name, ...values) {
            const answer = await ask.call(this, name, ...values);
            order.push(name);
            return answer;
        };
        picture.moveProbe(10, 20);
        for (let i = 0; i < 400 && !order.includes('values'); i++) await new Promise((resolve) => setTimeout(resolve, 10));
        const start = order.length;
        const { last } = section;
        picture.moveProbe(30, 10);
        for (let i = 0; i < 400 && !order.slice(start).includes('probe'); i++) await new Promise((resolve) => setTimeout(resolve, 10));
        model.client.ask = ask;
        return { order: order.slice(start), isKnown: last === section.last || section.last.isKnown.every(Boolean) };
    });
    // The value before it may still be on its way, and one part of the section.
    const before = order.order.slice(0, order.order.indexOf('probe'));
    check(order.order.includes('probe') && before.filter((name) => name === 'values').length <= 1, `answered before the probe: ${before}`);
    await until(page, 'section.last?.isKnown.every(Boolean)');
}

export async function versions(browser, url, program) {
    const page = await opened(browser, url);
    const tool = new Tool(program);
    const room = await page.evaluate(() => window.luxel.inside.builtins.find(({ name }) => name === 'room').text);
    await test('a slow scene beside a quick one: all that is shown is of the text', () => slowBesideQuick(page, tool, room));
    await test('direct light at once, all light by one solution', () => lightComes(page, tool));
    await test('reflected light is stopped and begun anew', () => stops(page, room));
    await test('a drag does not reach the next scene', () => dragsStay(page));
    await test('the pointer’s value comes before the section', () => probesFirst(page));
    equal(page.faults, [], 'faults');
    await page.context().close();
    tool.close();
}
