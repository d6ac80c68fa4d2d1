// SPDX-License-Identifier: MIT
// The sun in Chromium: its handle stands where the tool says, is dragged over its dome with all that stand there, by altitude and
// azimuth or by the hour of its date; the form's sliders of day and hour.
import { spawnSync } from 'node:child_process';
import { boxOf, dragBy, inside, opened, openText, shot, tab, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

// The sky is off: it takes seconds to light a picture, and where its sun stands is another matter.
const scene = (sun, rest = '') => `luxel: 1
units: photometric
screen: {width: 1600, height: 1200, resolution: [120, 90]}
observer: {position: [0, -3000, 2200], target: [0, 0, 200], projection: perspective}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [1500, 1500]}
  - {type: box, center: [0, 0, 200], size: [300, 300, 400]}
lights:
  - {type: sun, irradiance: 80000, ${sun}${rest}}
  - {type: sky, enabled: false, kind: 12, horizontal: 12000, ground: 0.2, sun: {${sun}}${rest}}
`;
const ANGLES = 'altitude: 40, azimuth: 200';
const DATED = 'date: "2026-06-21T15:00+02:00", latitude: 50, longitude: 10';
const STILL = 'model.drags === 0 && model.isSettled && space.stage.made && model.isCurrent(space.stage.made.of)';
const DEGREE = Math.PI / 180;

const suns = (page) => inside(page, 'model.things.flatMap(({ sun }) => (sun ? [sun] : []))');
const keys = (page, ...names) => inside(page, `model.client.ask('keys', model.asWhole(), ${JSON.stringify(names)})`);

/** The handles stand where the tool finds the sun. */
async function standsThere(page, tool) {
    const told = [];
    for (const [sun, rest] of [[ANGLES, ''], [DATED, ''], ['date: "2026-12-21T08:30Z", latitude: -34, longitude: 18', ''], [ANGLES, ', up: [0, 1, 0]'], [ANGLES, ', north: [1, 1, 0]']]) {
        const text = scene(sun, rest);
        await openText(page, text);
        const { stdout } = spawnSync(tool, ['daylight', '-', '--sun-patches', '--json'], { input: text });
        const { towards } = JSON.parse(stdout);
        const found = await suns(page);
        equal(found.map(({ base }) => base), ['lights[0]', 'lights[1].sun'], 'suns');
        for (const each of found) {
            const off = Math.hypot(...each.towards.map((c, axis) => c - towards[axis]));
            check(off < 1e-9, `${sun}${rest}: ${each.towards} instead of ${towards}`);
        }
        told.push(towards.map((c) => c.toFixed(3)).join(' '));
    }
    return told.join(', ');
}

async function dragSun(page, dx, dy) {
    await until(page, STILL);
    const box = await boxOf(page.locator('canvas.space'));
    const [x, y] = await inside(page, 'space.seen(model.things.find(({ sun }) => sun).at)');
    await dragBy(page, [box.x + x, box.y + y], dx, dy);
    await until(page, STILL);
}

/** Where the sun is taken is where it comes to, and the sky's goes with it. */
async function isDragged(page) {
    await openText(page, scene(ANGLES));
    await dragSun(page, 60, -25);
    const values = await keys(page, 'lights[0].altitude', 'lights[0].azimuth', 'lights[1].sun.altitude', 'lights[1].sun.azimuth');
    const [altitude, azimuth, skyAltitude, skyAzimuth] = values.map(Number);
    check(Math.abs(altitude - 40) + Math.abs(azimuth - 200) > 2, `the sun stays at ${altitude}, ${azimuth}`);
    equal([skyAltitude, skyAzimuth], [altitude, azimuth], 'the sun of the sky');
    const [{ towards }] = await suns(page);
    check(Math.abs(Math.asin(towards[2]) / DEGREE - altitude) < 1e-6, `${towards} is not ${altitude}° high`);
    await inside(page, "void space.select(model.things.find(({ sun }) => sun))");
    await page.waitForTimeout(100);
    await shot(page, 'sun');
    await inside(page, 'void model.undo()');
    await until(page, `${STILL} && model.text.includes('altitude: 40')`);
    // Below the horizon a hand does not bring it.
    await dragSun(page, 20, 400);
    check(Number((await keys(page, 'lights[0].altitude'))[0]) > 0, 'the sun has set');
    equal(await inside(page, 'model.messages.filter(({ error }) => error)'), [], 'errors');
}

/** By a date the hour changes, and the sun comes near to where the hand wants it. */
async function keepsDay(page) {
    await openText(page, scene(DATED));
    await dragSun(page, 40, 0);
    const [date, sky] = (await keys(page, 'lights[0].date', 'lights[1].sun.date')).map((text) => JSON.parse(text));
    check(/^2026-06-21T\d\d:\d\d\+02:00$/.test(date) && date !== '2026-06-21T15:00+02:00', `the date is ${date}`);
    equal(sky, date, 'the date of the sky');
    const before = await suns(page);
    // An hour is 15 degrees about the pole.
    await inside(page, `void model.change(['lights[0].date', 'lights[1].sun.date'].map((key) => ({ set: key + '="2026-06-21T12:00+02:00"' })))`);
    await until(page, `${STILL} && model.text.includes('T12:00')`);
    const hours = (Number(date.slice(11, 13)) * 60 + Number(date.slice(14, 16))) / 60 - 12;
    const [{ towards }] = await suns(page);
    const angle = Math.acos(towards.reduce((sum, c, axis) => sum + c * before[0].towards[axis], 0)) / DEGREE;
    check(angle < Math.abs(hours) * 15 + 0.1 && angle > Math.abs(hours) * 12, `${hours} h are ${angle}°`);
    await inside(page, "void space.select(model.things.find(({ sun }) => sun))");
    await page.waitForTimeout(100);
    await shot(page, 'sun-day');
}

/** Sliders of day and hour, and a sun that is told by date rather than by angles, and back. */
async function isTyped(page) {
    await openText(page, scene(DATED));
    await tab(page, 'Light');
    const row = page.locator('.thing').first();
    await row.getByLabel('Time of day').first().fill('600');
    await until(page, `${STILL} && model.text.split('T10:00+02:00').length === 3`);
    await row.getByLabel('Day of the year').first().fill('79');
    await until(page, `${STILL} && model.text.split('2026-03-21T10:00+02:00').length === 3`);
    const [{ towards }] = await suns(page);
    await row.getByRole('button', { name: 'By altitude and azimuth' }).click();
    await until(page, `${STILL} && model.scene && !model.things.find(({ sun }) => sun).sun.date`);
    const [after] = await suns(page);
    check(Math.hypot(...after.towards.map((c, axis) => c - towards[axis])) < 2e-4, `${after.towards} instead of ${towards}`);
    await row.getByRole('button', { name: 'By date and place' }).click();
    await until(page, `${STILL} && model.things.find(({ sun }) => sun).sun.date`);
    equal(await keys(page, 'lights[0].date', 'lights[0].latitude'), await keys(page, 'lights[1].sun.date', 'lights[1].sun.latitude'), 'the date of the other sun');
    await shot(page, 'sun-form');
    // A sun that has set is told at its field, and the hour can be taken back.
    await row.getByLabel('Time of day').first().fill('60');
    await page.locator('.thing .note', { hasText: 'below the horizon' }).first().waitFor();
    await row.getByLabel('Time of day').first().fill('660');
    await until(page, STILL);
    equal(await inside(page, 'model.messages.filter(({ error }) => error)'), [], 'errors');
}

export async function daylight(browser, url, tool) {
    const page = await opened(browser, url, { viewport: { width: 1280, height: 800 } });
    await test('handles of suns stand where the tool finds them', () => standsThere(page, tool));
    await test('a sun is dragged over its dome, that of the sky with it', () => isDragged(page));
    await test('a sun of a date keeps to its day', () => keepsDay(page));
    await test('day and hour of a sun are slid', () => isTyped(page));
    await test('no fault was reported of suns', () => equal(page.faults, [], 'faults'));
    await page.context().close();
}
