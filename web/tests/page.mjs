// SPDX-License-Identifier: MIT
// The page in Debian's Chromium: what people do with mouse, keys and fingers, and what they then see.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import axe from 'axe-core';
import { colours } from './colour.mjs';
import { controls } from './controls.mjs';
import { daylight } from './daylight.mjs';
import { FIREFOX, inFirefox } from './firefox.mjs';
import { figures } from './figures.mjs';
import { frames } from './frames.mjs';
import { grabbing } from './grabbing.mjs';
import { joining } from './joining.mjs';
import { lessons } from './lessons.mjs';
import { loading } from './loading.mjs';
import { more, PAGES } from './more.mjs';
import { boxOf, dragBy, inside, lampIn, look, opened, openScene, shot, started, tab, until } from './hands.mjs';
import { serve } from './server.mjs';
import { stage } from './stage.mjs';
import { tasks } from './tasks.mjs';
import { typed } from './typed.mjs';
import { versions } from './versions.mjs';
import { check, equal, test } from './tap.mjs';

async function startsLit(page) {
    const facts = await inside(page, 'model.picture.facts');
    check(facts.maximum.value > 10 && facts.columns === 600, JSON.stringify(facts));
    check(await inside(page, 'model.messages.length === 0'), 'the first scene is not whole in view');
    const [x, y] = await lampIn(page, 'space');
    const box = await boxOf(page.locator('canvas.space'));
    check(x > box.x && x < box.x + box.width && y > box.y && y < box.y + box.height, 'the lamp is out of sight');
    const lit = await page.evaluate(() => {
        const canvas = document.querySelector('canvas.picture');
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        return data.some((byte, i) => i % 4 === 0 && byte > 240 && data[i + 3] === 255);
    });
    check(lit, 'no pixel of the picture is bright');
}

async function dragsInSpace(page) {
    await openScene(page, 'report');
    const before = await inside(page, 'model.scene.lights[0].place');
    await page.getByRole('button', { name: 'Plan' }).click();
    await dragBy(page, await lampIn(page, 'space'), -60, 30);
    await until(page, `model.scene.lights[0].place[0] < ${before[0]} - 10 && model.scene.lights[0].place[1] < -10`);
    const follows = "model.text.includes(`position: [${model.scene.lights[0].place.join(', ')}]`)";
    await until(page, `model.drags === 0 && model.text === model.wholeText && ${follows}`);
    const after = await inside(page, 'model.scene.lights[0].place');
    equal(after[2], before[2], 'height in the plan');
    check((await inside(page, 'model.text')).startsWith('# The lab report'), 'comments are gone');
    await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, `model.scene.lights[0].place[0] === ${before[0]}`);
    await page.getByRole('button', { name: 'Redo' }).click();
    await until(page, `model.scene.lights[0].place[0] === ${after[0]}`);
    await page.getByRole('button', { name: 'Orbit' }).click();
}

/** Presses, moves twice and lets go within one task: before the first movement is taken. */
async function dragAtOnce(page) {
    const [x, y] = await lampIn(page, 'space');
    await page.mouse.move(x, y); // which makes the pointer one that can be captured
    await page.evaluate(
        ([x, y]) => {
            const canvas = document.querySelector('canvas.space');
            for (const [type, dx, dy] of [
                ['pointerdown', 0, 0],
                ['pointermove', -20, 5],
                ['pointermove', -60, 20],
                ['pointerup', -60, 20],
            ])
                canvas.dispatchEvent(
                    new PointerEvent(type, { pointerId: 1, clientX: x + dx, clientY: y + dy, bubbles: true }),
                );
        },
        [x, y],
    );
}

/** The last movement of a drag is taken after the hand has let go, and belongs to the same step of the history. */
async function dragsQuickly(page) {
    await openScene(page, 'report');
    const before = await inside(page, 'model.text');
    const moved = `model.text !== ${JSON.stringify(before)}`;
    // the space view may not have fitted the scene yet: then the lamp is missed, and taken again
    for (let i = 0; i < 20 && !(await inside(page, moved)); i++) {
        await dragAtOnce(page);
        for (let k = 0; k < 40 && !(await inside(page, moved)); k++) await page.waitForTimeout(50);
    }
    await until(page, `${moved} && model.drags === 0 && model.text === model.wholeText`);
    await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, `model.text === ${JSON.stringify(before)}`);
}

/** Where things stand comes with the judgement of the text, in one answer, so that no two versions are mixed. */
async function readsOffAtOnce(page) {
    await openScene(page, 'all-sources');
    const asked = await page.evaluate(async () => {
        const { model } = window.luxel.inside;
        const { ask } = model.client;
        const names = [];
        model.client.ask = function (name, ...values) {
            names.push(name);
            return ask.call(this, name, ...values);
        };
        await model.judge();
        model.client.ask = ask;
        return names;
    });
    equal(asked.filter((name) => name === 'judge').length, 1, `judgements among ${asked}`);
    check(asked.filter((name) => name === 'keys').length <= 2, `asked ${asked}`); // the form's
    const kinds = await inside(page, "model.shapes.filter(({ kind }) => kind === 'light').map(({ type }) => type)");
    check(['point', 'spot', 'rectangle', 'box'].every((kind) => kinds.includes(kind)), `lights are drawn as ${kinds}`);
    const [distant] = await inside(page, "model.things.filter(({ kind }) => kind === 'direction')");
    check(distant?.at.every(Number.isFinite), 'distant light cannot be taken');
}

async function dragsInPicture(page) {
    await openScene(page, 'report');
    await dragBy(page, await lampIn(page, 'picture'), -80, 0);
    await until(page, 'model.scene.lights[0].place[0] < 1990');
    equal(await inside(page, 'model.scene.lights[0].place[2]'), 2000, 'height above the screen');
}

async function movesByKeys(page) {
    await openScene(page, 'report');
    await look(page, 'space');
    await inside(page, "space.select(model.things.find(({ kind }) => kind === 'light'))");
    await page.locator('canvas.space').focus();
    await page.keyboard.press('ArrowLeft');
    await until(page, 'model.scene.lights[0].place[0] === 1990');
    await page.keyboard.press('Shift+PageUp');
    await until(page, 'model.scene.lights[0].place[2] === 2100');
    await page.keyboard.press('v');
    equal(await inside(page, 'space.side'), 'plan', 'view');
    await page.keyboard.press('v');
    await page.keyboard.press('v');
    equal(await inside(page, 'space.side'), 'orbit', 'view');
    for (const camera of ['space', 'picture']) {
        await openScene(page, 'three-lights');
        await look(page, camera);
        await page.locator(`canvas.${camera}`).focus();
        await page.keyboard.press('2');
        equal(await inside(page, 'space.selected?.index'), 1, 'the lamp of a number');
        await page.keyboard.press('9');
        equal(await inside(page, 'space.selected?.index'), 1, 'what stays where no lamp has the number');
        await inside(page, 'space.select(null)');
    }
}

async function probes(page, tool) {
    await openScene(page, 'three-lights');
    await page.locator('canvas.picture').focus();
    await inside(page, 'picture.moveProbe(50, 40)');
    const answer = JSON.parse(execFileSync(tool, ['probe', 'three-lights', '-p', '50,40', '--json']).toString())
        .points[0];
    await page.waitForFunction(
        (text) => document.querySelector('.value').textContent.startsWith(text),
        Number(answer.value.toPrecision(6)).toString(),
    );
    equal(await page.locator('.shares li').count(), 3, 'bars');
    await page.keyboard.press('ArrowRight');
    check((await inside(page, 'picture.probe[0]')) > 50, 'the arrow does not move the probe');
}

async function explains(page) {
    await openScene(page, 'report');
    await page.locator('canvas.picture').focus();
    await page.keyboard.press('Enter');
    await page.locator('dialog.why math').first().waitFor();
    const text = await page.locator('dialog.why').innerText();
    check(text.includes('W/sr'), text.slice(0, 300));
    await shot(page, 'why');
    await page.keyboard.press('Escape');
    check(!(await page.locator('dialog.why').isVisible()), 'Escape does not close it');
}

async function keepsLastGood(page) {
    await openScene(page, 'report');
    await tab(page, 'Text');
    const area = page.getByLabel('Scene text (YAML)');
    const good = await area.inputValue();
    await area.fill(good.replace('intensity: 10', 'intensity: ten').replace('radius: 300', 'radius: -3'));
    await page.locator('.stale').waitFor();
    equal(await page.locator('.messages li.error').count(), 2, 'errors');
    equal(await page.locator('.text pre .error').count(), 2, 'marked lines');
    equal(await inside(page, 'model.picture.facts.columns'), 360, 'picture');
    await shot(page, 'errors');
    await page.locator('.messages button').first().click();
    const mark = await area.evaluate((element) => element.value.slice(element.selectionStart, element.selectionEnd));
    check(mark.includes('-3') || mark.includes('ten'), `"${mark}" is marked`);
    await area.fill(good);
    await page.locator('.stale').waitFor({ state: 'hidden' });
    await tab(page, 'Light');
}

async function editsByForm(page) {
    await openScene(page, 'report');
    await tab(page, 'Light');
    const field = page.getByLabel(/^Intensity/).first();
    await field.fill('20');
    await field.press('Enter');
    await until(page, "model.text.includes('intensity: 20') && model.picture.facts.maximum.value > 23");
    await field.press('ArrowUp');
    await until(page, '/intensity: 2[1-9]/.test(model.text)');
    await page.getByLabel('Add').first().selectOption('ambient');
    await until(page, 'model.scene.lights.length === 2');
    await page.locator('.form summary', { hasText: '2ambient' }).click();
    await page.getByRole('button', { name: 'Remove' }).nth(1).click();
    await until(page, 'model.scene.lights.length === 1');
    await page.getByLabel('Type').first().selectOption('spot');
    await until(page, "model.scene.lights[0].type === 'spot' && !model.stale");
}

/** The table of points, by keys alone: it is reached, walked, changed, and points are put in and taken out. */
async function editsPoints(page, tool) {
    await openScene(page, 'sphere');
    const focused = () => page.evaluate(() => document.activeElement.textContent);
    const cell = (text) => page.waitForFunction((text) => document.activeElement.textContent === text, text);
    const count = (number) => until(page, `model.scene.points.length === ${number} && model.text === model.wholeText`);
    await page.waitForFunction(() => document.querySelectorAll('.points tbody tr').length === 3);
    await tab(page, 'Points');
    const isCell = () => page.evaluate(() => document.activeElement.closest('[role=grid]') !== null);
    for (let i = 0; i < 12 && !(await isCell()); i++) await page.keyboard.press('Tab');
    equal(await focused(), '1', 'the cell that Tab comes to');
    await page.keyboard.press('ArrowDown');
    await until(page, "picture.probe.join() === '120,80'");
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter');
    await page.getByRole('textbox', { name: 'Point 2, x, mm' }).waitFor();
    await page.keyboard.type('nothing');
    await page.keyboard.press('Enter');
    await page.locator('.points [aria-invalid]').waitFor();
    await page.keyboard.press('ControlOrMeta+a');
    await page.keyboard.type('50,5');
    await page.keyboard.press('Enter');
    await until(page, "model.wholeText.includes('[50.5, 80]') && model.scene.points[1][0] === 50.5");
    await cell('50.5');
    const [{ value }] = JSON.parse(execFileSync(tool, ['probe', 'sphere', '-p', '50.5,80', '--json'])).points;
    await page.waitForFunction(
        (text) => document.querySelectorAll('.points tbody tr')[1].lastChild.textContent === text,
        String(Number(value.toPrecision(6))),
    );
    await shot(page, 'points');
    await page.keyboard.press('F2');
    await page.keyboard.type('7');
    await page.keyboard.press('Escape');
    await cell('50.5');
    await inside(page, 'picture.moveProbe(-20, 30)');
    await page.keyboard.press('Insert');
    await count(4);
    equal(await inside(page, 'model.scene.points[2].join()'), '-20,30', 'the point that was added');
    await cell('−20');
    for (const left of [3, 2, 1, 0]) {
        await page.keyboard.press('Delete');
        await count(left);
        await page.waitForFunction((left) => document.querySelectorAll('.points tbody tr').length === left, left);
    }
    await cell('Add the probe’s place');
    await page.keyboard.press('Enter');
    await count(1);
    for (const left of [0, 1, 2, 3, 4, 3, 3]) {
        await page.getByRole('button', { name: 'Undo' }).click();
        await count(left);
    }
    await until(page, "model.scene.points[1].join() === '120,80'");
}

async function showsColours(page) {
    await openScene(page, 'report');
    await tab(page, 'View');
    await page.getByLabel('Colours').selectOption('turbo');
    await page.getByLabel('Logarithmic').check();
    await page.getByLabel('Isophotes').check();
    await until(page, 'picture.isophotes.length > 2');
    check((await inside(page, 'picture.scale.low')) > 0, 'a logarithmic range begins at 0');
    await shot(page, 'isophotes');
    await page.getByLabel('Logarithmic').uncheck();
    await page.getByLabel('To', { exact: true }).fill('6');
    await page.getByLabel('To', { exact: true }).press('Enter');
    check(await page.getByLabel('Lock range').isChecked(), 'a range that was typed is not locked');
    equal(await inside(page, 'picture.scale.high'), 6, 'range');
    await page.getByLabel('Lock range').uncheck();
    await page.getByLabel('Isophotes').uncheck();
    await page.getByLabel('Colours').selectOption('grey');
    await tab(page, 'Light');
}

async function downloads(page, tool) {
    await openScene(page, 'spot');
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-page-'));
    for (const ending of ['.png', '.csv', '.yaml']) {
        const [file] = await Promise.all([
            page.waitForEvent('download'),
            page.getByLabel('Download').selectOption(ending),
        ]);
        await file.saveAs(path.join(folder, `page${ending}`));
    }
    const yaml = fs.readFileSync(path.join(folder, 'page.yaml'));
    execFileSync(tool, ['render', 'page.yaml', '-o', 'tool.csv', '-o', 'tool.png'], { cwd: folder, stdio: 'ignore' });
    equal(yaml.toString(), await inside(page, 'model.text'), 'text');
    const count = (name) => fs.readFileSync(path.join(folder, name)).toString().split('\n').length;
    equal(count('page.csv'), count('tool.csv'), 'lines of the table');
    await openScene(page, 'report');
    await page.locator('#file').setInputFiles(path.join(folder, 'page.png'));
    await page.waitForFunction((text) => window.luxel.inside.model.text === text, yaml.toString());
    fs.rmSync(folder, { recursive: true });
}

async function links(page, browser, url) {
    await openScene(page, 'two-spheres');
    await page.evaluate(() => history.replaceState(null, '', location.pathname));
    await page.getByRole('button', { name: 'Share' }).click();
    await page.waitForFunction(() => location.hash.startsWith('#s='));
    await page.getByRole('button', { name: 'Close' }).click();
    // The browser tells its new address late to those outside of it.
    const other = await opened(browser, await page.evaluate(() => location.href));
    equal(await inside(other, 'model.text'), await inside(page, 'model.text'), 'scene of the link');
    await other.context().close();
    const named = await opened(browser, `${url}#scene=ambient`);
    check((await inside(named, 'model.text')).includes('ambient'), 'the name in a link');
    await named.context().close();
    const damaged = await opened(browser, `${url}#s=AAAA`);
    await damaged.waitForFunction(() => document.querySelector('.toast').textContent.startsWith('The link holds no scene'));
    await damaged.context().close();
}

async function survivesCrash(page) {
    await openScene(page, 'report');
    const text = await inside(page, 'model.text');
    await page.evaluate(() => window.luxel.inside.model.client.ask('crash').catch(() => undefined));
    await page.locator('.toast').waitFor();
    const isInTheWay = await page.locator('.toast').evaluate((toast) => {
        const { left, top, width, height } = toast.getBoundingClientRect();
        return toast.contains(document.elementFromPoint(left + width / 2, top + height / 2));
    });
    check(!isInTheWay, 'the notice takes the clicks on what is below it');
    equal(await inside(page, 'model.text'), text, 'text');
    await inside(page, 'picture.moveProbe(150, 0)');
    await page.waitForFunction(() => document.querySelector('.value').textContent.startsWith('11.038'));
}

async function endsLongWork(page) {
    await openScene(page, 'report');
    const room = await page.evaluate(() => window.luxel.inside.builtins.find(({ name }) => name === 'room').text);
    // so large that its whole picture is still on its way whenever this is looked at
    const text = room.replace(/resolution: \[(\d+), (\d+)\]/, (_, columns, rows) => `resolution: [${4 * columns}, ${4 * rows}]`);
    await inside(page, `void model.begin(${JSON.stringify(text)})`);
    await until(page, `model.work?.state === 'working' && model.picture?.of.text === ${JSON.stringify(text)} && model.picture.stride > 1`);
    const start = Date.now();
    await inside(page, 'void model.change([{ set: "lights[0].enabled=false" }])');
    await until(page, "!model.work?.of.text.includes('enabled: true') && model.wholeText.includes('enabled: false')");
    return `${Date.now() - start} ms until a long picture gives way`;
}

async function changesDoNotWait(page) {
    await openScene(page, 'report');
    const text = await page.evaluate(() => window.luxel.inside.builtins.find(({ name }) => name === 'room').text);
    const reflecting = text.replace('luxel: 1', 'luxel: 1\nreflections: all');
    await inside(page, `void model.begin(${JSON.stringify(reflecting)})`);
    await until(page, `model.wholeText === ${JSON.stringify(reflecting)}`);
    const start = Date.now();
    await inside(page, 'void model.change([{ set: "lights[0].enabled=false" }])');
    await until(page, "model.wholeText.includes('enabled: false')");
    const time = Date.now() - start;
    await inside(page, "void model.change([{ set: 'reflections=none' }])");
    await until(page, "model.picture?.of.text.includes('reflections: none')");
    return `${time} ms until a change is taken`;
}

async function givesUpHopeless(page) {
    await openScene(page, 'report');
    await inside(page, 'void (model.failing = model.text)'); // as if it had been this text that failed before
    await page.evaluate(() => window.luxel.inside.model.client.ask('crash').catch(() => undefined));
    await page.locator('.messages .error').waitFor();
    await inside(page, "void model.change([{ set: 'lights[0].intensity=11' }])");
    await until(page, "!model.stale && model.failing === ''");
}

async function speaksRussian(page) {
    await openScene(page, 'report');
    await look(page, 'space');
    await tab(page, 'Light');
    await page.getByLabel('Language').selectOption('ru');
    await page.getByRole('heading', { name: 'Вид в пространстве' }).waitFor();
    await inside(page, 'picture.moveProbe(150, 0)');
    await page.waitForFunction(() => document.querySelector('.value').textContent.startsWith('11,038'));
    await page.getByLabel(/^Сила/).first().waitFor();
    // Choices are read in Russian; the text keeps their keys.
    const law = page.getByLabel('Затухание').first();
    await law.selectOption({ label: 'обратный квадрат' });
    await until(page, "model.text.includes('attenuation: inverse-square')");
    const latin = await page.locator('.form option, .form summary, .shares li').allTextContents();
    equal(latin.filter((text) => /[a-z]{3}/.test(text.replace(/IES|EN/g, ''))), [], 'words that are not Russian');
    const field = page.getByLabel(/^Сила/).first();
    await field.fill('12,5');
    await field.press('Enter');
    await until(page, "model.text.includes('intensity: 12.5')");
    await page.getByRole('button', { name: 'Почему?' }).click();
    await page.locator('dialog.why math').first().waitFor();
    const why = await page.locator('dialog.why').innerText();
    check(!/\d\.\d/.test(why.replace(/screen:[^]*/, '')), `decimal points: ${/.{20}\d\.\d.{9}/.exec(why)}`);
    const units = await page.locator('dialog.why mi[mathvariant=normal]').allTextContents();
    check(units.includes('мм') && !units.includes('mm') && !units.includes('m'), `units in formulas: ${units}`);
    await shot(page, 'why-russian');
    await page.getByRole('button', { name: 'Закрыть' }).click();
    await shot(page, 'russian');
    await page.getByLabel('Язык').selectOption('en');
    await page.getByRole('heading', { name: 'Space view' }).waitFor();
}

async function accessible(page, what) {
    await page.evaluate(axe.source);
    const { violations } = await page.evaluate(() => window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa'] }));
    equal(
        violations.map(
            ({ id, nodes }) =>
                `${id}: ${nodes
                    .slice(0, 3)
                    .map(({ html }) => html)
                    .join(' ')}`,
        ),
        [],
        `axe, ${what}`,
    );
}

/** A finger takes the lamp in the space view and moves it. */
async function dragByFinger(page) {
    const [x, y] = await lampIn(page, 'space');
    const before = await inside(page, 'model.scene.lights[0].place');
    const touch = await page.context().newCDPSession(page);
    const at = (type, points) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: points });
    await at('touchStart', [{ x, y }]);
    for (let i = 1; i <= 5; i++) await at('touchMove', [{ x: x - 8 * i, y }]);
    await at('touchEnd', []);
    await until(page, `model.scene.lights[0].place[0] < ${before[0]} - 10`);
}

/** The bar is one row; what it has no room for is in its menu, whole, in both languages. */
async function headerOnPhone(page) {
    for (const language of ['ru', 'en']) {
        await page.locator('header .menu').click();
        await page.locator('header select').last().selectOption(language);
        await page.waitForFunction((code) => document.documentElement.lang === code, language);
        await page.waitForFunction(
            (word) => document.querySelector('header .share').textContent === word,
            language === 'ru' ? 'Поделиться' : 'Share',
        );
        await shot(page, `phone-${language}`);
        const height = await page.evaluate(() => document.querySelector('header').clientHeight);
        check(height <= 50, `the bar is ${height} px high in "${language}"`);
        await page.locator('header .menu').click();
        await shot(page, `phone-menu-${language}`);
        const { count, wrong } = await page.evaluate(() => {
            const controls = [...document.querySelectorAll('header :is(button, select)')].filter(({ offsetParent }) => offsetParent);
            const isWrong = (control) => {
                const { left, right, width, height } = control.getBoundingClientRect();
                return left < 0 || right > 390 || width < 44 || height < 44 || control.scrollWidth > control.clientWidth;
            };
            const cut = controls.filter((control) => !control.matches('.scene') && isWrong(control));
            return { count: controls.length, wrong: cut.map(({ outerHTML }) => outerHTML) };
        });
        equal(count, 9, `controls of the header in "${language}"`);
        equal(wrong, [], `controls that are cut off or too small in "${language}"`);
        await page.locator('header .menu').click();
        const width = await page.evaluate(() => document.documentElement.scrollWidth);
        check(width <= 390, `${width} px wide in "${language}"`);
    }
}

async function onPhone(browser, url) {
    const page = await opened(browser, url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    check(width <= 390, `${width} px wide`);
    await shot(page, 'phone');
    await headerOnPhone(page);
    await look(page, 'picture');
    const box = await boxOf(page.locator('canvas.picture'));
    await page.touchscreen.tap(box.x + box.width * 0.6, box.y + box.height / 2);
    await until(page, 'picture.probe[0] > 10');
    await dragByFinger(page);
    await page.context().close();
}

/** On small screens the header is one row, and fields show their numbers whole. */
async function onSmallScreens(browser, url) {
    for (const [language, width] of [
        ['en', 1024],
        ['ru', 1280],
    ]) {
        const page = await opened(browser, `${url}#lang=${language}`, { viewport: { width, height: 700 } });
        await openScene(page, 'three-lights');
        await page.locator('.form summary', { hasText: 'key' }).waitFor();
        const height = await page.evaluate(() => document.querySelector('header').clientHeight);
        check(height < 60, `the header is ${height} px high at ${width}`);
        const clipped = await page.evaluate(() =>
            [...document.querySelectorAll('.field input[type=text]')]
                .filter((input) => input.clientWidth > 0 && input.scrollWidth > input.clientWidth)
                .map(({ value }) => value),
        );
        equal(clipped, [], `what does not fit at ${width}`);
        await page.context().close();
    }
}

async function inDark(browser, url) {
    const page = await opened(browser, url, { colorScheme: 'dark', reducedMotion: 'reduce' });
    await accessible(page, 'dark');
    await shot(page, 'dark');
    await page.context().close();
}

async function withoutWasm(browser, url) {
    const context = await browser.newContext({ locale: 'en-GB' });
    await context.addInitScript(() => delete globalThis.WebAssembly);
    const page = await context.newPage();
    await page.goto(url);
    await page.getByText('This browser cannot run Luxel').waitFor();
    await context.close();
}

async function offline(page, asked) {
    const before = asked.length;
    await page.context().setOffline(true);
    await openScene(page, 'tin');
    await page.getByRole('button', { name: 'Why?' }).click();
    await page.locator('dialog.why math').first().waitFor();
    await page.keyboard.press('Escape');
    await page.context().setOffline(false);
    equal(asked.slice(before), [], 'asked for after loading');
}

async function quick(page) {
    await openScene(page, 'report');
    await tab(page, 'Text');
    const text = (await inside(page, 'model.text')).replace('[360, 360]', '[800, 800]');
    await page.getByLabel('Scene text (YAML)').fill(text);
    await until(page, 'model.picture.facts.columns === 800');
    await tab(page, 'Light');
    const times = await page.evaluate(async () => {
        const { model } = window.luxel.inside;
        const all = [];
        for (let i = 0; i < 12; i++)
            all.push((await model.client.ask('render', model.asWhole(), 1)).milliseconds);
        return all;
    });
    const best = Math.min(...times);
    check(best < 100, `${best} ms`);
    return `800 x 800 in ${best.toFixed(1)} ms at best`;
}

/** What must go in any case, in seconds. */
export async function inShort(folder, tool) {
    const { server, url } = await serve(folder);
    const browser = await started();
    const page = await opened(browser, url);
    await test('starts with a whole lit sphere and its lamp in sight', () => startsLit(page));
    await test('a lamp is dragged in space; undo and redo', () => dragsInSpace(page));
    await test('the probe shows the number of the tool and the shares', () => probes(page, tool));
    await test('errors are told in place, and the last good picture stays, stale', () => keepsLastGood(page));
    await test('no fault was reported by the browser', () => equal(page.faults, [], 'faults'));
    await browser.close();
    server.close();
}

export async function page(folder, tool) {
    const { server, asked, url } = await serve(folder, PAGES);
    const browser = await started();
    const page = await opened(browser, url);
    await shot(page, 'desktop');
    let most = 0;
    await test('starts with a whole lit sphere and its lamp in sight', () => startsLit(page));
    await test('a lamp is dragged in space; undo and redo', () => dragsInSpace(page));
    await openScene(page, 'report');
    most = await inside(page, 'model.picture.facts.maximum.value');
    await test('a drag that is over before it is taken is one step', () => dragsQuickly(page));
    await test('where things stand is read off at once', () => readsOffAtOnce(page));
    await test('a lamp is dragged in the picture at its height', () => dragsInPicture(page));
    await test('keys move what is selected and change the view', () => movesByKeys(page));
    await test('the probe shows the number of the tool and the shares', () => probes(page, tool));
    await test('Why? explains the value', () => explains(page));
    await test('errors are told in place, and the last good picture stays, stale', () => keepsLastGood(page));
    await test('the form changes the text; lights are added and removed', () => editsByForm(page));
    await test('the table of points is walked and edited by keys', () => editsPoints(page, tool));
    await test('colours, range and isophotes', () => showsColours(page));
    await test('files are downloaded and opened again', () => downloads(page, tool));
    await more(page, browser, url, tool);
    await test('a scene travels in a link', () => links(page, browser, url));
    await joining(browser, url);
    await lessons(browser, url, tool);
    await test('a crash of the core loses nothing', () => survivesCrash(page));
    await test('a scene on which the core fails again and again is told', () => givesUpHopeless(page));
    await test('a picture that takes long gives way to a change', () => endsLongWork(page));
    await test('a change does not wait for reflected light', () => changesDoNotWait(page));
    await test('Russian, with decimal commas', () => speaksRussian(page));
    await test('nothing is fetched after loading', () => offline(page, asked));
    await test('quick', () => quick(page));
    await test('names and contrast (axe)', () => accessible(page, 'light'));
    await test('no fault was reported by the browser', () =>
        equal(
            page.faults.filter((fault) => !fault.includes('asked for')),
            [],
            'faults',
        ));
    await test('a phone, 390 px wide', () => onPhone(browser, url));
    await test('small screens', () => onSmallScreens(browser, url));
    await test('dark', () => inDark(browser, url));
    await stage(browser, url, tool);
    await frames(browser, url);
    await controls(browser, url, tool);
    await colours(browser, url, tool);
    await daylight(browser, url, tool);
    await grabbing(browser, url, tool);
    await figures(browser, url);
    await tasks(browser, url, tool);
    await typed(browser, folder, url);
    await versions(browser, url, tool);
    await loading(browser, folder, tool);
    await test('a browser without WebAssembly is told', () => withoutWasm(browser, url));
    await browser.close();
    if (fs.existsSync(FIREFOX)) await test('Firefox has the same numbers', () => inFirefox(url, most));
    else console.log(`${FIREFOX} is not there: the page is not tried in Firefox`);
    server.close();
}
