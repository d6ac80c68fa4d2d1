// SPDX-License-Identifier: MIT
// Lights that join a scene fit it, links carry how it is shown, and very many lights keep the page answering.
import { inside, opened, openScene, openText, shot, tab, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

const maximum = (page) => inside(page, 'model.picture.facts.maximum.value');

async function addsLights(page) {
    await openScene(page, 'sphere');
    const alone = await maximum(page);
    for (const kind of ['point', 'spot', 'distant', 'planar', 'point']) {
        const count = await inside(page, 'model.scene.lights.length');
        await page.getByLabel('Add').first().selectOption(kind);
        await until(page, `model.scene.lights.length === ${count + 1} && model.isSettled`);
    }
    const lit = await maximum(page);
    check(lit > alone && lit < 7 * alone, `six lights of like strength: ${lit} after ${alone}`);
    const places = await inside(page, "model.things.filter(({ kind }) => kind === 'light').map(({ at }) => at.join())");
    equal(new Set(places).size, places.length, `each stands at a place of its own: ${places.join(' ')}`);
    const text = await inside(page, 'model.text');
    check(/type: point[^}]*attenuation: none/.test(text.slice(text.lastIndexOf('lights:') + 200)), 'the law of the first');
    const above = await inside(page, "model.scene.lights.every(({ place }) => !place || place[2] > 0)");
    check(above, 'none stands behind what it lights');
    await shot(page, 'added');
}

async function addsSurfaces(page) {
    const small = `luxel: 1\nscreen: {width: 60, height: 60, resolution: [100, 100]}\nobserver: {z: 150}\nsurfaces:\n
  - {type: sphere, center: [0, 0, 40], radius: 20}\nlights:\n  - {type: point, position: [40, 30, 120], intensity: 1}\n`;
    await openText(page, small);
    await tab(page, 'Matter');
    for (const kind of ['sphere', 'rectangle', 'disk', 'cylinder']) {
        const count = await inside(page, 'model.scene.surfaces.length');
        await page.getByLabel('Add').nth(1).selectOption(kind);
        await until(page, `model.scene.surfaces.length === ${count + 1} && model.isSettled`);
        const { reach, center } = await inside(page, `model.scene.surfaces[${count}]`);
        check(reach > 2 && reach < 20, `${kind}: of a size that suits the screen: ${reach}`);
        check(center[2] > 60 && center[2] + reach < 150, `${kind}: between what is there and the observer: ${center}`);
        await page.getByRole('button', { name: 'Undo' }).click();
        await until(page, `model.scene.surfaces.length === ${count} && model.text === model.wholeText`);
    }
}

async function linksLooks(page, browser) {
    await openScene(page, 'two-spheres');
    await tab(page, 'View');
    await page.getByLabel('Colours').selectOption('turbo');
    await page.getByLabel('Logarithmic').check();
    await page.getByLabel('Isophotes').check();
    await page.getByRole('button', { name: 'Plan' }).click();
    await page.getByLabel('Quantity').selectOption('irradiance');
    await inside(page, 'void picture.moveProbe(33.5, -20)');
    await page.getByLabel('From', { exact: true }).fill('0,5');
    await page.getByLabel('From', { exact: true }).press('Enter');
    await until(page, 'model.isSettled');
    await page.getByRole('button', { name: 'Share' }).click();
    await page.waitForFunction(() => location.hash.includes('&probe='));
    await page.getByRole('button', { name: 'Close' }).click();
    const state = () => `JSON.stringify([model.text, model.irradiance, picture.probe, picture.scale.map,
        picture.scale.logarithmic, picture.scale.locked, picture.scale.low, picture.showsIsophotes, space.side])`;
    const wanted = await inside(page, state());
    const address = await page.evaluate(() => location.href);
    const other = await opened(browser, address.replace('lang=en', 'lang=ru'));
    equal(await inside(other, state()), wanted, 'how it is shown');
    equal(await other.evaluate(() => document.documentElement.lang), 'ru', 'the language');
    check(await other.getByLabel('Изофоты').isChecked(), 'controls follow');
    await shot(other, 'linked-ru');
    equal(other.faults, [], 'faults');
    await other.context().close();
}

async function bearsManyLights(page) {
    const lights = Array.from(
        { length: 1500 },
        (_, i) => `  - {type: point, position: [${(i % 50) * 20 - 500}, ${Math.floor(i / 50) * 30 - 450}, 2000], intensity: 0.01}`,
    );
    const longest = page.evaluate(
        () =>
            new Promise((resolve) => {
                let most = 0;
                let last = performance.now();
                const timer = setInterval(() => {
                    const now = performance.now();
                    most = Math.max(most, now - last);
                    last = now;
                }, 20);
                setTimeout(() => {
                    clearInterval(timer);
                    resolve(most);
                }, 8000);
            }),
    );
    await openText(
        page,
        `luxel: 1\nscreen: {width: 600, height: 600, resolution: [100, 100]}\nobserver: {z: 1500}\nsurfaces:\n` +
            `  - {type: sphere, center: [0, 0, 900], radius: 250}\nlights:\n${lights.join('\n')}\n`,
    );
    const most = await longest;
    const nodes = await page.evaluate(() => document.querySelectorAll('*').length);
    check(nodes < 20000, `${nodes} elements`);
    await shot(page, 'many');
    return `the page was busy for at most ${Math.round(most)} ms, ${nodes} elements`;
}

export async function joining(browser, url) {
    const page = await opened(browser, url);
    await test('lights that are added fit the scene', () => addsLights(page));
    await test('surfaces that are added fit the scene', () => addsSurfaces(page));
    await test('a link carries how the scene is shown', () => linksLooks(page, browser));
    await test('1500 lights do not stop the page', () => bearsManyLights(page));
    await test('no fault was reported while they joined', () => equal(page.faults, [], 'faults'));
    await page.context().close();
}
