// SPDX-License-Identifier: MIT
// Sharing and tasks in Chromium: a link that the dialog makes asks its question, hides what it should, keeps still what must
// not be moved, and judges answers by the tool's value of the scene as it was given.
import { execFileSync } from 'node:child_process';
import axe from 'axe-core';
import { inside, look, opened, openScene, shot, until } from './hands.mjs';
import { check, equal, test } from './tap.mjs';

const AT = [40, -30];

function byTool(tool, scene, quantity = 'brightness') {
    const told = execFileSync(tool, ['probe', scene, '-p', AT.join(), '--quantity', quantity, '--json'], { stdio: ['ignore', 'pipe', 'pipe'] });
    return JSON.parse(told.toString()).points[0].value;
}

const linkIn = (page) => page.getByLabel('Link', { exact: true }).inputValue();

async function shares(page) {
    await openScene(page, 'three-lights');
    await page.evaluate(() => history.replaceState(null, '', location.pathname));
    await page.getByRole('button', { name: 'Share' }).click();
    const picture = page.locator('dialog.sharing canvas');
    await picture.waitFor();
    const colours = await picture.evaluate((canvas) => {
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        const seen = new Set();
        for (let i = 0; i < data.length; i += 4) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
        return seen.size;
    });
    check(colours > 100, `the picture has ${colours} colours`);
    check((await linkIn(page)).includes('#s='), 'a link to the scene');
    equal(await linkIn(page), await page.evaluate(() => location.href), 'the address is the link');
    const saved = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save picture' }).click();
    equal((await saved).suggestedFilename(), 'scene-stage.png', 'name of the picture');
    await shot(page, 'sharing');
    await page.getByRole('button', { name: 'Close' }).click();
}

/** Makes a task by the dialog, and returns its link. */
async function made(page, scene, { ask = '', hidden = [] } = {}) {
    await openScene(page, scene);
    await inside(page, `void picture.moveProbe(${AT})`);
    await page.getByRole('button', { name: 'Share' }).click();
    await page.getByText('Make a task').click();
    await page.getByLabel('Question').fill(ask);
    const boxes = page.locator('dialog.sharing fieldset');
    for (const name of ['Values and shares', 'Light', 'Matter', 'Place', 'View', 'Text'])
        await boxes.getByLabel(name, { exact: true }).setChecked(hidden.includes(name));
    const link = await linkIn(page);
    await page.getByRole('button', { name: 'Close' }).click();
    return link;
}

async function answer(page, typed) {
    await page.locator('.answer input').fill(typed);
    await page.locator('.answer button').click();
    await page.waitForFunction(() => !document.querySelector('.answer button').disabled);
    const verdict = page.locator('.task .verdict');
    return { isRight: await verdict.evaluate((each) => each.classList.contains('right')), text: await verdict.textContent() };
}

async function asks(page, browser, tool) {
    const ask = 'How bright is it at P?\nGive three digits; "<b>no</b>" markup & no surprises: ярко?';
    const link = await made(page, 'three-lights', { ask, hidden: ['Values and shares', 'Light', 'Text'] });
    const other = await opened(browser, link);
    equal(await other.locator('.task .question').textContent(), ask, 'the question');
    for (const [what, isShown] of [['.values', false], ['.dial', false], ['.strip', false], ['header .share', false], ['header .scene', false], ['.tabs', true]])
        equal(await other.locator(what).first().isVisible(), isShown, `${what} is shown`);
    const tabs = await other.locator('.edit > .tabs button').evaluateAll((all) => all.filter(({ hidden }) => !hidden).map(({ textContent }) => textContent));
    equal(tabs, ['Matter', 'Place'], 'tabs');
    equal(await other.locator('.form > [data-tab=light]').isVisible(), false, 'lamps in the drawer');
    await other.locator('canvas.space').focus();
    // No lamp moves by hand or by keys; a body does.
    const text = await inside(other, 'model.text');
    const lamp = await inside(other, "space.seen(model.things.find(({ kind }) => kind === 'light').at)");
    equal(await inside(other, `space.thingAt(${lamp})?.kind ?? null`), null, 'what is grabbed at a lamp');
    for (const key of [' ', 'ArrowRight', 'ArrowRight']) await other.keyboard.press(key);
    await other.waitForTimeout(200);
    equal(await inside(other, 'model.text'), text, 'the scene after keys');
    await other.keyboard.press('o');
    await look(other, 'picture');
    await other.locator('canvas.picture').focus();
    await other.keyboard.press('Enter');
    equal(await other.locator('dialog.why').isVisible(), false, 'Why? is open');
    const truth = byTool(tool, 'three-lights');
    check((await answer(other, truth.toPrecision(4))).isRight, `${truth} is not right`);
    check((await answer(other, truth.toPrecision(4).replace('.', ','))).isRight, 'a comma');
    check(!(await answer(other, (1.07 * truth).toPrecision(4))).isRight, '1.07 times the value is right');
    check(/number/.test((await answer(other, 'many')).text), 'words are judged');
    const pi = await answer(other, (truth / Math.PI).toPrecision(4));
    check(!pi.isRight, 'a value by π');
    // Whatever is changed, the scene of the link is judged, and it comes back.
    await inside(other, "void model.change([{ set: 'lights[0].intensity=77' }])");
    await until(other, "model.isSettled && model.text.includes('77')");
    check((await answer(other, truth.toPrecision(5))).isRight, 'the scene as it was given is judged');
    await other.getByRole('button', { name: 'As it was given' }).click();
    await until(other, `model.isSettled && model.text === ${JSON.stringify(text)}`);
    check((await other.evaluate(() => location.href)).includes('task='), 'the address keeps the task');
    await shot(other, 'task');
    await other.evaluate(axe.source);
    const { violations } = await other.evaluate(() => window.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa'] }));
    equal(violations.map(({ id, nodes }) => [id, nodes[0].html]), [], 'axe');
    equal(other.faults, [], 'faults');
    await other.context().close();
}

/** Links that are written by hand, in Russian, on a phone; with nothing but the question left of the drawer. */
async function isWritten(browser, url, tool) {
    for (const width of [390, 1280]) {
        const hide = 'light,matter,place,text,values';
        const page = await opened(browser, `${url}#scene=sphere&task=${AT}&hide=${hide}&quantity=irradiance&lang=ru`, { viewport: { width, height: 844 } });
        const question = page.locator('.task .question');
        await question.getByText('Найдите в точке P: освещённость.').waitFor();
        equal(await page.locator('.edit > .tabs').isVisible(), false, 'tabs');
        const box = await question.boundingBox();
        check(box.y + box.height <= 844 && box.x + box.width <= width, `the question at ${JSON.stringify(box)}`);
        const truth = byTool(tool, 'sphere', 'irradiance');
        const { isRight, text } = await answer(page, truth.toPrecision(4));
        check(isRight && text.startsWith('Верно'), text);
        const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        check(over <= 0, `${over} px too wide for ${width}`);
        await shot(page, `task-ru-${width}`);
        await page.context().close();
    }
    // What is no task is none.
    const page = await opened(browser, `${url}#scene=sphere&task=1,many&hide=light`);
    equal(await page.locator('.task').count(), 0, 'a task at no place');
    check(await page.locator('.form > [data-tab=light]').isVisible(), 'something is hidden');
    await page.evaluate(() => (location.hash = '#scene=spot&task=0,0&hide=text'));
    await page.locator('.task').waitFor();
    await page.context().close();
}

/** Several steps in one link: each has its scene and its question, and answers are judged about it. */
async function hasSteps(page, browser, tool) {
    await openScene(page, 'three-lights');
    await inside(page, `void picture.moveProbe(${AT})`);
    await page.getByRole('button', { name: 'Share' }).click();
    await page.getByText('Make a task').click();
    await page.getByLabel('Question').fill('First?');
    await page.getByRole('button', { name: 'Add another step' }).click();
    await openScene(page, 'sphere');
    await inside(page, 'void picture.moveProbe(10, 20)');
    await page.getByRole('button', { name: 'Share' }).click();
    await page.getByText('Steps before this one: 1').waitFor();
    await page.getByLabel('Question').fill('Second?');
    const link = await linkIn(page);
    await page.getByRole('button', { name: 'Begin anew' }).click();
    await page.getByRole('button', { name: 'Close' }).click();
    const other = await opened(browser, link);
    const question = other.locator('.task .question');
    equal([await question.textContent(), await other.locator('.task .tag').textContent()], ['First?', 'Task 1 / 2'], 'the first step');
    check((await answer(other, byTool(tool, 'three-lights').toPrecision(4))).isRight, 'the value of the first step');
    await shot(other, 'task-steps');
    await other.getByRole('button', { name: 'Next' }).click();
    await question.getByText('Second?').waitFor();
    await until(other, "model.isSettled && model.scene.lights.length === 1 && picture.asked.join() === '10,20'");
    const told = execFileSync(tool, ['probe', 'sphere', '-p', '10,20', '--json'], { stdio: ['ignore', 'pipe', 'pipe'] });
    check((await answer(other, JSON.parse(told.toString()).points[0].value.toPrecision(4))).isRight, 'the value of the second step');
    check(await other.getByRole('button', { name: 'Next' }).isDisabled(), 'there is a step behind the last');
    await other.getByRole('button', { name: 'Back' }).click();
    await question.getByText('First?').waitFor();
    await until(other, 'model.isSettled && model.scene.lights.length === 3');
    equal(other.faults, [], 'faults');
    await other.context().close();
}

async function judgesReflected(browser, url, tool) {
    const page = await opened(browser, `${url}#scene=tin&task=${AT}`);
    const { isRight } = await answer(page, byTool(tool, 'tin').toPrecision(4));
    check(isRight, 'the value with all light');
    await page.context().close();
}

/** Those who show links find a picture of the size that is told. */
async function hasCard(page, url) {
    const told = await page.evaluate(() => Object.fromEntries([...document.querySelectorAll('meta[property]')].map((each) => [each.getAttribute('property'), each.content])));
    const response = await page.request.get(new URL(told['og:image'], url).href);
    check(response.ok(), `there is no ${told['og:image']}`);
    const bytes = await response.body();
    equal(bytes.subarray(1, 4).toString(), 'PNG', 'the format');
    equal([bytes.readUInt32BE(16), bytes.readUInt32BE(20)].map(String), [told['og:image:width'], told['og:image:height']], 'the size');
}

export async function tasks(browser, url, tool) {
    const page = await opened(browser, url);
    await test('sharing gives a picture and a link', () => shares(page));
    await test('the page has a card for links', () => hasCard(page, url));
    await test('a task asks, hides and judges', () => asks(page, browser, tool));
    await test('a task by a link that was written', () => isWritten(browser, url, tool));
    await test('a small lesson of several steps', () => hasSteps(page, browser, tool));
    await test('a task of a mesh or reflected light', () => judgesReflected(browser, url, tool));
    await test('no fault was reported of tasks', () => equal(page.faults, [], 'faults'));
    await page.context().close();
}
