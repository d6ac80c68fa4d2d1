// SPDX-License-Identifier: MIT
// The lessons in Chromium: every chapter in both languages, with the tool's numbers; figures that hands and keys move; guesses
// and answers that are judged; what the formulas say; room and contrast.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import axe from 'axe-core';
import { shot } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

const CHAPTERS = ['ambient', 'point', 'practical', 'distant', 'cone', 'area', 'volume', 'reflection'];

/** A page with a chapter, all of whose figures are computed. */
async function chapter(page, url, name, language = 'en') {
    await page.goto('about:blank');
    await page.goto(`${url}#lesson=${name}&lang=${language}`);
    await page.waitForFunction((name) => window.luxel?.inside?.lesson?.name === name, name);
    await page.waitForFunction(() => document.querySelectorAll('.options button').length >= 4);
    for (const figure of await figures(page)) {
        await page.locator('figure').nth(figure.index).scrollIntoViewIfNeeded();
        await settled(page, figure.name);
    }
}

const figures = (page) =>
    page.evaluate(() =>
        [...window.luxel.inside.lesson.figures].map(([name, { value, unit, data }], index) => ({
            name, index, value, unit, quantity: data.quantity, hasMark: !!data.mark, controls: data.controls,
        })),
    );

const settled = (page, name) => page.evaluate((name) => window.luxel.inside.lesson.figures.get(name).settled(), name);

/** A figure's scene, its place on the screen, and the value that it tells, with some names changed. */
const asked = (page, name, set = {}) =>
    page.evaluate(
        ([name, set]) => {
            const figure = window.luxel.inside.lesson.figures.get(name);
            const at = figure.seen(figure.place(figure.data.at, figure.all(set)));
            return { text: figure.text(set), at, value: figure.value, quantity: figure.data.quantity };
        },
        [name, set],
    );

/** The tool's value for the same scene. */
function byTool(tool, { text, at, quantity }) {
    const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-lesson-')), 'scene.yaml');
    fs.writeFileSync(file, text);
    const point = at.map((c) => c.toPrecision(17)).join(',');
    const told = execFileSync(tool, ['probe', file, '-p', point, '--quantity', quantity, '--json'], { stdio: ['ignore', 'pipe', 'pipe'] });
    fs.rmSync(path.dirname(file), { recursive: true });
    return JSON.parse(told.toString()).points[0].value;
}

function near(got, expected, what) {
    check(Math.abs(got - expected) <= 1e-6 * Math.abs(expected) + 1e-12, `${what}: ${got} instead of ${expected}`);
}

async function opens(page, url, tool, language) {
    let count = 0;
    for (const name of CHAPTERS) {
        await chapter(page, url, name, language);
        equal(await page.evaluate(() => document.documentElement.lang), language, 'language');
        const isRussian = /[а-я]/.test(await page.locator('article').textContent());
        equal(isRussian, language === 'ru', `Russian letters in ${name}`);
        const shown = await figures(page);
        check(shown.length >= 2 && shown.length <= 3, `${name} has ${shown.length} figures`);
        for (const figure of shown) {
            const own = await asked(page, figure.name);
            near(own.value, byTool(tool, own), `${name}, ${figure.name}`);
            count++;
        }
        equal(await page.locator('.trouble').count(), 0, `troubles in ${name}`);
        equal(await page.locator('.options button[data-right=true]').count(), 1, `right guesses in ${name}`);
        await shot(page, `lesson-${name}-${language}`);
    }
    return `${count} figures`;
}

const painted = (page, index) =>
    page.evaluate((index) => document.querySelectorAll('.lit canvas')[index].toDataURL(), index);

/** Each control of each figure changes its picture, and the value is the tool's again; marks follow the hand. */
async function moves(page, url, tool) {
    let [slid, dragged] = [0, 0];
    for (const name of CHAPTERS) {
        await chapter(page, url, name);
        for (const figure of await figures(page)) {
            const canvas = page.locator('.lit canvas').nth(figure.index);
            const before = await painted(page, figure.index);
            const slider = page.locator('figure').nth(figure.index).locator('input').first();
            await slider.focus();
            for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowLeft');
            await settled(page, figure.name);
            check((await painted(page, figure.index)) !== before, `${name}, ${figure.name} does not follow its slider`);
            const own = await asked(page, figure.name);
            near(own.value, byTool(tool, own), `${name}, ${figure.name}, slid`);
            slid++;
            if (!figure.hasMark) continue;
            await canvas.scrollIntoViewIfNeeded();
            const names = () => page.evaluate((name) => ({ ...window.luxel.inside.lesson.figures.get(name).names }), figure.name);
            const [x, y] = await page.evaluate((name) => window.luxel.inside.lesson.figures.get(name).markAt, figure.name);
            const box = await canvas.boundingBox();
            const from = await names();
            const sign = x > box.width / 2 ? -1 : 1;
            await page.mouse.move(box.x + x, box.y + y);
            await page.mouse.down();
            await page.mouse.move(box.x + x + sign * 20, box.y + y - 15, { steps: 4 });
            await page.mouse.move(box.x + x + sign * 40, box.y + y - 30, { steps: 4 });
            await page.mouse.up();
            await settled(page, figure.name);
            check(JSON.stringify(await names()) !== JSON.stringify(from), `${name}, ${figure.name} is not dragged`);
            const after = await asked(page, figure.name);
            near(after.value, byTool(tool, after), `${name}, ${figure.name}, dragged`);
            dragged++;
        }
    }
    return `${slid} slid, ${dragged} dragged`;
}

async function answer(page, typed) {
    await page.locator('.answer input').fill(typed);
    await page.locator('.answer button').click();
    await page.waitForFunction(() => !document.querySelector('.answer button').disabled);
    const verdict = page.locator('.check .verdict');
    return { isRight: await verdict.evaluate((each) => each.classList.contains('right')), text: await verdict.textContent() };
}

async function judges(page, url, tool) {
    const told = [];
    for (const name of CHAPTERS) {
        await chapter(page, url, name);
        const { figure, set } = await page.evaluate(() => window.luxel.inside.lesson.chapter.check);
        const truth = byTool(tool, await asked(page, figure, set));
        check((await answer(page, truth.toPrecision(4))).isRight, `${name}: ${truth} is not right`);
        check((await answer(page, truth.toPrecision(4).replace('.', ','))).isRight, `${name}: ${truth} with a comma is not right`);
        check(!(await answer(page, (truth * 1.07).toPrecision(4))).isRight, `${name}: 1.07 times the value is right`);
        if (name === 'reflection') check(/three digits/.test((await answer(page, '7')).text), 'one digit of 7.170 is not told');
        check(/number/.test((await answer(page, 'many')).text), `${name}: words are judged`);
        const right = page.locator('.options button[data-right=true]');
        const wrong = page.locator('.options button[data-right=false]').first();
        await wrong.click();
        check(await page.locator('.guess .verdict.wrong').isVisible(), `${name}: a wrong guess is not told`);
        await right.click();
        check(await page.locator('.guess .verdict.right').isVisible(), `${name}: a right guess is not told`);
        told.push(truth.toPrecision(4));
    }
    return told.join(', ');
}

/** The symbols, this figure's numbers and the result, which follow the slider. */
async function tellsFormulas(page, url) {
    await chapter(page, url, 'point');
    const formula = page.locator('.formula').nth(1);
    check((await formula.textContent()).replace(/\s/g, '').endsWith('=60lx'), await formula.textContent());
    await page.evaluate(() => window.luxel.inside.lesson.figures.get('lift').change({ h: 500 }));
    await settled(page, 'lift');
    check((await formula.textContent()).replace(/\s/g, '').endsWith('=240lx'), await formula.textContent());
    equal(await page.locator('math mfrac').count() > 2, true, 'fractions are MathML');
}

/** The full page shows the same scene at the same place; variants are those of the tool. */
async function leads(page, url, tool) {
    await chapter(page, url, 'point');
    const own = await asked(page, 'bulb');
    await page.locator('figure').first().getByRole('button', { name: 'Open in the full page' }).click();
    await page.waitForFunction(() => window.luxel?.inside?.model?.isSettled);
    const inside = await page.evaluate(() => {
        const { model, picture } = window.luxel.inside;
        return { text: model.text, irradiance: model.irradiance, probe: picture.probe };
    });
    equal([inside.text, inside.irradiance], [own.text, true], 'the scene of the full page');
    own.at.forEach((c, axis) => check(Math.abs(c - inside.probe[axis]) < 1e-3, `probe at ${inside.probe}`));
    await page.locator('header .lessons').click();
    await page.waitForFunction(() => window.luxel?.inside?.lesson?.name === 'ambient');
    await page.locator('#variant').fill('42');
    await page.locator('.variant button').click();
    await page.waitForFunction(() => window.luxel?.inside?.model?.isSettled);
    equal(await page.evaluate(() => window.luxel.inside.model.text), execFileSync(tool, ['variant', '42']).toString(), 'variant 42');
}

async function isClean(browser, url) {
    for (const [width, colorScheme] of [[1280, 'light'], [390, 'dark'], [1920, 'dark']]) {
        const context = await browser.newContext({ viewport: { width, height: 844 }, colorScheme, reducedMotion: 'reduce' });
        const page = await context.newPage();
        for (const name of CHAPTERS) {
            await chapter(page, url, name, width === 390 ? 'ru' : 'en');
            const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
            check(over <= 0, `${name} is ${over} px too wide for ${width}`);
            await page.locator('.options button').first().click();
            await page.evaluate(axe.source);
            const { violations } = await page.evaluate(() => window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa'] }));
            equal(violations.map(({ id, nodes }) => [id, nodes[0].html]), [], `${name} at ${width}, ${colorScheme}`);
            await shot(page, `lesson-${name}-${width}-${colorScheme}`);
        }
        await context.close();
    }
}

export async function lessons(browser, url, tool) {
    const page = await (await browser.newContext({ viewport: { width: 1280, height: 900 }, locale: 'en-GB' })).newPage();
    const faults = [];
    page.on('pageerror', (error) => faults.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
    for (const language of ['en', 'ru'])
        await test(`lessons: each chapter in ${language}, with the tool's numbers`, () => opens(page, url, tool, language));
    await test('lessons: figures follow sliders and hands', () => moves(page, url, tool));
    await test('lessons: answers and guesses are judged', () => judges(page, url, tool));
    await test('lessons: formulas have the numbers of their figure', () => tellsFormulas(page, url));
    await test('lessons: they lead into the full page and to variants', () => leads(page, url, tool));
    await test('lessons: names, contrast and room', () => isClean(browser, url));
    await test('lessons: no fault was reported', () => equal(faults, [], 'faults'));
    await page.context().close();
}
