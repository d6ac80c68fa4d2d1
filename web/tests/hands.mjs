// SPDX-License-Identifier: MIT
// What the tests do with the page: a browser and its pages, waiting, scenes, drags, screenshots.
import fs from 'node:fs';
import path from 'node:path';
import { chromium } from 'playwright-core';

const CHROMIUM = process.env.LUXEL_CHROMIUM ?? '/usr/bin/chromium';
export const PATIENCE = Number(process.env.LUXEL_PATIENCE ?? 60000); // milliseconds that a busy machine may need
const SHOTS = process.env.LUXEL_SCREENSHOTS; // a folder for pictures of the page, to be looked at

export function started() {
    return chromium.launch({ executablePath: CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
}

/** A page with a whole picture, made by the first part of the core; without a link it shows the sphere. */
export async function begun(browser, url, options = {}) {
    const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, locale: 'en-GB', ...options });
    const page = await context.newPage();
    page.faults = [];
    page.on('pageerror', (error) => page.faults.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
    page.setDefaultTimeout(PATIENCE);
    await page.goto(url.includes('#') ? url : `${url}#scene=sphere`);
    await ready(page);
    return page;
}

/** A page with all that it fetches, or with so much of it. */
export async function opened(browser, url, options = {}, what = 'model.client.isWhole && model.client.hasWords') {
    const page = await begun(browser, url, options);
    await until(page, what);
    return page;
}

/** Waits until the picture is whole, of the present scene, and has all its light. */
export async function ready(page) {
    await page.waitForFunction(() => window.luxel?.inside.model.isSettled && document.querySelector('.value'));
}

export const inside = (page, what) =>
    page.evaluate(
        `(() => { const { model, picture, space, section, compare, dial } = window.luxel.inside; return ${what}; })()`,
    );

/** Waits until something inside is as it should be. */
export async function until(page, what) {
    let trouble = '';
    for (let i = 0; i < PATIENCE / 50; i++) {
        // there may be no picture or scene yet
        if (await inside(page, what).catch((error) => void (trouble = `: ${error.message}`))) return;
        await page.waitForTimeout(50);
    }
    throw new Error(`it never came that ${what}${trouble}`);
}

export async function shot(page, name) {
    if (!SHOTS) return;
    fs.mkdirSync(SHOTS, { recursive: true });
    await page.screenshot({ path: path.join(SHOTS, `${name}.png`), fullPage: true });
}

export async function openScene(page, name) {
    await openText(
        page,
        await page.evaluate((name) => window.luxel.inside.builtins.find((each) => each.name === name).text, name),
    );
}

export async function openText(page, text) {
    await page.evaluate((text) => window.luxel.inside.open(text), text);
    await page.waitForFunction((text) => {
        const { model } = window.luxel.inside;
        return model.text === text && model.isSettled;
    }, text);
}

/** Looks through a camera: 'space' or 'picture'. */
export async function look(page, camera) {
    await page.locator('.cameras button').nth(camera === 'space' ? 0 : 1).click();
    await page.locator(`.stage[data-camera=${camera}]`).waitFor();
}

/** Opens a tab of the drawer or of the strip. */
export async function tab(page, name) {
    await page.locator('.tabs').getByRole('button', { name, exact: true }).click();
}

/** Where an element is in the window, which is scrolled so that all of it is seen: the mouse reaches nothing else. */
export async function boxOf(locator) {
    await locator.scrollIntoViewIfNeeded();
    return locator.boundingBox();
}

export async function lampIn(page, view) {
    if (await page.locator('.cameras').isVisible()) await look(page, view);
    await until(page, 'space.flight === null');
    const box = await boxOf(page.locator(`canvas.${view}`));
    const [x, y] =
        view === 'space'
            ? await inside(page, "space.seen(model.things.find(({ kind }) => kind === 'light').at)")
            : await inside(
                  page,
                  'picture.markPlace(picture.marks[0], picture.canvas.clientWidth, picture.canvas.clientHeight)',
              );
    return [box.x + x, box.y + y];
}

export async function dragBy(page, [x, y], dx, dy) {
    const { width, height } = page.viewportSize();
    if (!(x >= 0 && x < width && y >= 0 && y < height)) throw new Error(`(${x}, ${y}) is outside of the window`);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 5; i++) await page.mouse.move(x + (dx * i) / 5, y + (dy * i) / 5);
    await page.mouse.up();
}
