// SPDX-License-Identifier: MIT
// The stage in Chromium: what it shows of bodies are the tool's numbers for its camera, bodies hide what is behind them, all of
// the scene is in sight, and there is room for it on laptops, large screens and phones, upright and lying.
import { execFileSync, spawnSync } from 'node:child_process';
import { boxOf, inside, look, opened, openScene, openText, shot, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';
import { BALL } from './versions.mjs';

const CURRENT = 'space.stage.made && model.isCurrent(space.stage.made.of)';

/** The camera of the space view and some of its pixels that show bodies: their places on its screen, values and depths. */
const pixels = (page) =>
    page.evaluate(() => {
        const { made } = window.luxel.inside.space.stage;
        const { view, columns, rows, values, mask, stride } = made;
        const shown = [...mask].flatMap((is, i) => (is ? [i] : []));
        const pixel = view.width / view.factor / columns;
        const some = [0.15, 0.35, 0.5, 0.65, 0.85].map((share) => shown[Math.floor(share * shown.length)]);
        const at = (i) => [((i % columns) + 0.5 - columns / 2) * pixel, (rows / 2 - Math.floor(i / columns) - 0.5) * pixel];
        const { eye, target, up } = view;
        return { eye, target, up, size: [columns * pixel, rows * pixel], columns, rows, stride, some: some.map((i) => [at(i), values[i]]) };
    });

/** What the tool finds at those pixels. */
function truths(tool, text, { eye, target, up, size, columns, rows, some }, options = []) {
    const numbers = (list) => list.map((n) => n.toPrecision(17)).join(', ');
    const set = [
        `observer={position: [${numbers(eye)}], target: [${numbers(target)}], up: [${numbers(up)}], projection: perspective}`,
        `screen={width: ${size[0]}, height: ${size[1]}, resolution: [${columns}, ${rows}]}`,
    ].flatMap((each) => ['-s', each]);
    const places = some.flatMap(([[x, y]]) => ['-p', `${x},${y}`]);
    return JSON.parse(spawnSync(tool, ['probe', '-', ...set, ...options, ...places, '--json'], { input: text }).stdout).points;
}

async function showsNumbers(page, tool) {
    const told = [];
    for (const scene of ['three-lights', 'desk', 'room']) {
        await openScene(page, scene);
        await until(page, `${CURRENT} && space.stage.made.stride <= 4`);
        const seen = await pixels(page);
        const { stride, some } = seen;
        const points = truths(tool, await inside(page, 'model.text'), seen);
        some.forEach(([at, value], i) => {
            const off = Math.abs(points[i].value - value);
            check(off <= 2e-4 * Math.abs(value) + 1e-6, `${scene} at ${at}: ${value} instead of ${points[i].value}`);
        });
        told.push(`${scene} by every ${stride}`);
        await shot(page, `stage-${scene}`);
    }
    return told.join(', ');
}

async function hides(page) {
    await openScene(page, 'three-lights');
    await until(page, CURRENT);
    const hidden = await page.evaluate(() => {
        const { model, space } = window.luxel.inside;
        const { stage } = space;
        const { view } = stage.made;
        return model.scene.lights.map(({ place }) => {
            const off = place.map((c, axis) => c - view.target[axis]);
            const depth = view.distance - off.reduce((sum, c, axis) => sum + c * view.back[axis], 0);
            return stage.hides([...space.seen(place), depth]);
        });
    });
    equal(hidden, [false, false, true], 'lamps behind the ball');
}

/** Lamps and bodies are on the stage, clear of the colour bar, and stand on their feet. */
async function fits(page) {
    for (const scene of ['sphere', 'desk', 'room', 'spot', 'two-spheres']) {
        await openScene(page, scene);
        await until(page, CURRENT);
        const off = await page.evaluate(() => {
            const { model, space } = window.luxel.inside;
            const { clientWidth, clientHeight } = space.canvas;
            const isOff = ([x, y]) => x < 0 || y < 0 || x > clientWidth - 60 || y > clientHeight;
            const places = model.things.filter(({ kind }) => kind === 'light' || kind === 'surface').map(({ at }) => at);
            return places.map((at) => space.seen(at)).filter(isOff);
        });
        equal(off, [], `what of ${scene} is out of sight`);
    }
    await openScene(page, 'room');
    await until(page, CURRENT);
    const [floor, ceiling] = await inside(page, '[[0, 0, 2500], [0, 2500, 2500]].map((place) => space.seen(place))');
    check(floor[1] > ceiling[1] + 40, `the floor at ${floor}, the ceiling at ${ceiling}`);
}

/** A body that the hand points at in space tells the observer's value of that place, the tool's number. */
async function pointsInSpace(page, tool) {
    await openScene(page, 'sphere');
    await until(page, `${CURRENT} && space.stage.made.stride <= 4`);
    const { x: left, y: top } = await boxOf(page.locator('canvas.space'));
    const [x, y] = await inside(page, 'space.seen([model.shapes[0].center[0], model.shapes[0].center[1], model.shapes[0].center[2] + 0.9 * model.shapes[0].radius])');
    await page.mouse.move(left + x, top + y - 5);
    await page.mouse.move(left + x, top + y);
    await page.locator('.readout').waitFor();
    await until(page, "document.querySelector('.readout').textContent === document.querySelector('.value').textContent");
    const at = await inside(page, 'picture.probe');
    const [{ value }] = JSON.parse(execFileSync(tool, ['probe', 'sphere', '-p', at.join(), '--json']).toString()).points;
    const text = await page.locator('.readout').textContent();
    check(text.startsWith(String(Number(value.toPrecision(6)))), `${text} instead of ${value}`);
    // Below the ball's middle the observer sees nothing of it: the value is that towards the camera.
    const [lowX, lowY] = await inside(page, 'space.seen([model.shapes[0].center[0], model.shapes[0].center[1], model.shapes[0].center[2] - 1.07 * model.shapes[0].radius])');
    await page.mouse.move(left + lowX, top + lowY);
    await page.locator('.readout', { hasText: 'not seen by the observer' }).waitFor();
    equal(await inside(page, 'picture.probe'), at, 'the probe');
    await page.mouse.move(left + 5, top + 300);
    await page.locator('.readout').waitFor({ state: 'hidden' });
}

/** One camera flies to the other, and wheel and keys zoom both. */
async function flies(page) {
    await openScene(page, 'room');
    await until(page, CURRENT);
    await page.locator('canvas.space').focus();
    await page.keyboard.press('o');
    await page.locator('.stage[data-camera=picture]').waitFor();
    await page.locator('canvas.picture').focus();
    await page.mouse.move(500, 300);
    await page.mouse.wheel(0, -400);
    await until(page, 'picture.zoom > 1.2');
    await page.keyboard.press('f');
    await until(page, 'picture.zoom === 1');
    const high = await inside(page, 'picture.scale.high');
    await page.keyboard.press(']');
    check((await inside(page, 'picture.scale.high')) < high, '] does not raise the exposure');
    await page.keyboard.press('[');
    await look(page, 'space');
    await until(page, 'space.flight === null');
    await page.mouse.move(500, 300);
    await page.mouse.wheel(0, -400);
    await until(page, 'space.zoom > 1.2');
    await page.locator('canvas.space').focus();
    await page.keyboard.press('f');
    await until(page, 'space.zoom === 1');
}

/** Nothing of the scene before is on the stage, at any moment. */
async function belongs(page) {
    const wrong = await page.evaluate(async () => {
        const { model, space, dial, open, builtins } = window.luxel.inside;
        const size = document.querySelector('.caption-of-view .dim');
        const seen = [];
        for (const name of ['room', 'sphere', 'desk', 'room', 'spot']) {
            open(builtins.find((each) => each.name === name).text);
            for (let i = 0; i < 12; i++) {
                await new Promise((resolve) => setTimeout(resolve, 25));
                const { made } = space.stage;
                if (made && made.of.scene !== model.version.scene) seen.push(name);
                if (!model.picture && (!dial.element.hidden || size.textContent)) seen.push(`the range or the size before ${name}`);
            }
        }
        return seen;
    });
    equal(wrong, [], 'scenes under which another one was shown');
    await until(page, `model.isSettled && ${CURRENT}`);
}

/** Where surfaces reflect light the stage says that it has direct light alone. */
async function saysWhatIsMissing(page) {
    const note = page.locator('.of-space .partial');
    await openScene(page, 'sphere');
    check(await note.isHidden(), 'a note beside all the light there is');
    await page.evaluate(() => {
        const { builtins, open } = window.luxel.inside;
        open(builtins.find(({ name }) => name === 'room').text.replace('luxel: 1', 'luxel: 1\nreflections: 1'));
    });
    await note.waitFor(); // while all light is still being computed, too
    equal(await note.textContent(), 'direct light alone', 'the note');
    await shot(page, 'stage-reflections');
}

/** Once it is known reflected light is in space, too, from whichever side, and goes as a lamp is moved. */
async function showsReflections(page, tool) {
    const LIT = `${CURRENT} && !space.stage.made.of.direct && space.stage.made.stride <= 2`;
    const note = page.locator('.of-space .partial');
    await openText(page, BALL);
    const most = await inside(page, 'model.picture.facts.maximum.value');
    for (const side of [[-0.65, 0.9], [0.4, 1.2]]) {
        await page.evaluate(([turn, tilt]) => {
            const { space } = window.luxel.inside;
            space.turned = [turn, tilt];
            space.draw();
        }, side);
        await until(page, `${LIT} && space.stage.wanted === null && Math.abs(space.turned[0] - ${side[0]}) < 1e-9`);
        const seen = await pixels(page);
        const [whole, direct] = [[], ['-s', 'reflections=none']].map((options) => truths(tool, BALL, seen, options));
        const sum = (off) => seen.some.reduce((all, [, value], i) => all + Math.abs(off(value, i)), 0);
        const [reflected, wrong] = [sum((_, i) => whole[i].value - direct[i].value), sum((value, i) => whole[i].value - value)];
        check(wrong < 0.3 * reflected, `${wrong} beside what is reflected, ${reflected}`);
        seen.some.forEach(([at, value], i) => check(Math.abs(whole[i].value - value) <= 0.012 * most, `${at}: ${value} instead of ${whole[i].value}`));
    }
    check(await note.isHidden(), 'a note beside all the light there is');
    await shot(page, 'stage-reflected');
    await inside(page, "void model.change([{ set: 'lights[0].position=[-200, 0, 900]' }])");
    await until(page, `${CURRENT} && space.stage.made.of.direct`);
    await note.waitFor();
    await until(page, LIT);
}

async function hasRoom(browser, url) {
    const told = [];
    for (const [width, height] of [[1280, 720], [1920, 1080]])
        for (const colorScheme of ['light', 'dark'])
            for (const language of ['en', 'ru']) {
                const page = await opened(browser, `${url}#scene=three-lights&lang=${language}`, { viewport: { width, height }, colorScheme });
                await until(page, CURRENT);
                const share = await page.evaluate(() => {
                    const { width, height } = document.querySelector('.stage').getBoundingClientRect();
                    return (width * height) / window.innerWidth / window.innerHeight;
                });
                check(share >= 0.6 && share <= 0.72, `${share} of ${width} x ${height}`);
                const over = await page.evaluate(() => [document.documentElement.scrollWidth - innerWidth, document.documentElement.scrollHeight - innerHeight]);
                check(over.every((each) => each <= 0), `it is scrolled by ${over}`);
                await shot(page, `stage-${width}-${colorScheme}-${language}`);
                told.push(share.toFixed(2));
                await page.context().close();
            }
    return told.join(' ');
}

async function onPhones(browser, url) {
    for (const [width, height] of [[390, 844], [844, 390]]) {
        const page = await opened(browser, `${url}#scene=three-lights`, { viewport: { width, height }, hasTouch: true, isMobile: true });
        await until(page, CURRENT);
        const inWindow = ({ x, y, width: w, height: h }) => x >= 0 && y >= 0 && x + w <= width && y + h <= height;
        const [stage, value] = [await page.locator('.stage').boundingBox(), await page.locator('.value').boundingBox()];
        check(inWindow(stage) && stage.width * stage.height >= 0.36 * width * height, `the stage: ${JSON.stringify(stage)}`);
        check(inWindow(value), `the value: ${JSON.stringify(value)}`);
        await shot(page, `stage-phone-${width}`);
        if (width > height) {
            await page.context().close();
            continue;
        }
        const shares = page.locator('.shares .percent');
        equal(await shares.count(), 3, 'shares');
        for (let i = 0; i < 3; i++) check(inWindow(await shares.nth(i).boundingBox()), `share ${i + 1}`);
        const small = await page.evaluate(() =>
            [...document.querySelectorAll('button, select, summary, .drawer-body input:not([type=checkbox])')]
                .map((element) => [element.outerHTML.slice(0, 90), element.getBoundingClientRect()])
                .filter(([, { width, height }]) => width > 0 && (width < 43.5 || height < 43.5))
                .map(([html]) => html),
        );
        equal(small, [], 'what is too small for a finger');
        await page.locator('.edit > .tabs').getByRole('button', { name: 'Charts' }).click();
        await until(page, 'section.last !== null');
        check(inWindow(await page.locator('canvas.section').boundingBox()), 'the section in the sheet');
        await shot(page, 'stage-phone-chart');
        await page.locator('.edit > .tabs').getByRole('button', { name: 'Light' }).click();
        const handle = page.locator('.handle');
        const before = (await page.locator('.edit').boundingBox()).height;
        await handle.click();
        check((await page.locator('.edit').boundingBox()).height > 1.4 * before, 'the sheet does not open');
        await shot(page, 'stage-phone-sheet');
        await handle.click();
        check((await page.locator('.edit').boundingBox()).height < 100, 'the sheet does not close');
        check(inWindow(await page.locator('.value').boundingBox()), 'the value above the closed sheet');
        await shot(page, 'stage-phone-closed');
        await page.context().close();
    }
}

/** Where motion is not wanted the cameras are cut. */
async function cuts(browser, url) {
    const page = await opened(browser, url, { reducedMotion: 'reduce' });
    await until(page, CURRENT);
    const camera = await page.evaluate(() => {
        document.querySelectorAll('.cameras button')[1].click();
        return document.querySelector('.stage').dataset.camera;
    });
    equal(camera, 'picture', 'the camera at once');
    await page.context().close();
}

export async function stage(browser, url, tool) {
    const page = await opened(browser, url, { viewport: { width: 1280, height: 720 } });
    await test('the stage shows the numbers of the tool for its camera', () => showsNumbers(page, tool));
    await test('bodies hide what is behind them', () => hides(page));
    await test('the camera takes all of the scene, on its feet', () => fits(page));
    await test('a hand in space is told the value there', () => pointsInSpace(page, tool));
    await test('cameras fly, wheel and keys zoom', () => flies(page));
    await test('the stage says that it lacks reflected light', () => saysWhatIsMissing(page));
    await test('reflected light is in space once it is known', () => showsReflections(page, tool));
    await test('the stage shows no other scene', () => belongs(page));
    await test('no fault was reported on the stage', () => equal(page.faults, [], 'faults'));
    await page.context().close();
    await test('the stage has 60 to 70 % of the window', () => hasRoom(browser, url));
    await test('stage and value stay on phones', () => onPhones(browser, url));
    await test('reduced motion cuts', () => cuts(browser, url));
}
