// SPDX-License-Identifier: MIT
// What is typed, pressed and touched in Chromium: fields with what is no number, undoing beside fields and sliders, lamps
// that keys select and move, fingers on a phone, and languages without a network.
import { boxOf, inside, look, opened, openScene, shot, until } from './hands.mjs';
import { serve } from './server.mjs';
import { check, equal, test } from './tap.mjs';

const noteOf = (field) => field.locator('xpath=ancestor::div[contains(@class, "field")]').locator('.note');

/** What is no number is told at its field, stays there to be mended, and does not keep the fields beside it from working. */
async function tellsWrongNumbers(page) {
    await openScene(page, 'sphere');
    const [x, y, z] = ['x', 'y', 'z'].map((axis) => page.getByLabel(`Position, ${axis}`).first());
    const [x0, y0] = await inside(page, 'model.scene.lights[0].place');
    const enter = async (field, text) => {
        await field.fill(text);
        await field.press('Tab');
    };
    await enter(x, 'abc');
    await noteOf(x).getByText('x: “abc” is not a number.').waitFor();
    await shot(page, 'wrong-field');
    await enter(z, '1600');
    await until(page, `model.isSettled && model.scene.lights[0].place.join() === '${x0},${y0},1600'`);
    equal([await x.inputValue(), await x.getAttribute('aria-invalid')], ['abc', 'true'], 'the field to be mended');
    await enter(y, '');
    await noteOf(x).getByText('y: A number is needed here.').waitFor();
    await enter(y, '310');
    await enter(x, '330');
    await until(page, "model.scene.lights[0].place.join() === '330,310,1600'");
    equal(await noteOf(x).textContent(), '', 'what is wrong after mending');
    const intensity = page.getByLabel(/^Intensity/).first();
    const text = await inside(page, 'model.text');
    await enter(intensity, 'much');
    await noteOf(intensity).getByText('“much” is not a number.').waitFor();
    equal([await inside(page, 'model.text'), await inside(page, 'model.stale')], [text, false], 'the scene beside it');
    await enter(intensity, '12');
    await until(page, "model.text.includes('intensity: 12')");
    equal(await noteOf(intensity).textContent(), '', 'what is wrong after mending');
    await page.locator('details.more > summary').first().click();
    await page.getByLabel('Name').first().fill('a "b"');
    await page.getByLabel('Name').first().press('Enter');
    await until(page, `model.scene?.lights[0].name === 'a "b"'`);
    await page.waitForFunction(() => document.querySelector('.form summary').textContent.includes('a "b"'));
    equal(await page.getByLabel('Name').first().inputValue(), 'a "b"', 'a name with quotes');
}

/** Ctrl+K finds a parameter by words of its label, its key or its meaning, wherever it is, and brings the keys to its field. */
async function findsParameters(page) {
    await openScene(page, 'three-lights');
    await page.getByLabel(/^Intensity/).first().focus();
    await page.keyboard.press('Control+k');
    const dialog = page.getByRole('dialog', { name: 'Find a parameter' });
    await page.keyboard.type('shininess');
    equal(await dialog.getByRole('option').first().locator('code').textContent(), 'surfaces[0].material.shininess', 'what is found');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement.closest('[data-tab=matter]')?.offsetParent);
    await page.keyboard.press('Control+k');
    await page.keyboard.type('rim intensity');
    equal(await dialog.getByRole('option').first().locator('code').textContent(), 'lights[2].intensity', 'what has both words');
    await shot(page, 'finder');
    await page.keyboard.press('Enter');
    await page.keyboard.press('ControlOrMeta+a');
    await page.keyboard.type('7\n');
    await until(page, '/intensity: 7\\b/.test(model.wholeText)');
    await page.keyboard.press('Control+k');
    await page.keyboard.type('rim nonsense');
    equal(await dialog.getByRole('option').count(), 0, 'parameters that there are not');
    await page.keyboard.press('Escape');
    equal(await dialog.isVisible(), false, 'the dialog after Escape');
    await page.keyboard.press('Control+z');
    await until(page, '!/intensity: 7\\b/.test(model.wholeText)');
}

/** Ctrl+Z undoes a step of the scene, whichever field has the focus, but what is just being typed. */
async function undoes(page) {
    await openScene(page, 'report');
    const field = page.getByLabel(/^Intensity/).first();
    const before = await inside(page, 'model.text');
    await field.fill('20');
    await field.press('Enter');
    await until(page, '/intensity: 20\\b/.test(model.wholeText)');
    await page.keyboard.press('Control+z');
    await until(page, `model.text === ${JSON.stringify(before)} && model.text === model.wholeText`);
    await page.waitForFunction((field) => field.value === '10', await field.elementHandle());
    await page.keyboard.press('Tab');
    await page.waitForTimeout(300);
    equal(await inside(page, 'model.text'), before, 'the text after the field was left');
    const slider = page.locator('.field', { has: field }).locator('input[type=range]');
    const start = await slider.inputValue();
    await slider.focus();
    await slider.press('ArrowRight');
    await until(page, `model.text !== ${JSON.stringify(before)}`);
    await slider.press('Control+z');
    await until(page, `model.text === ${JSON.stringify(before)}`);
    await page.waitForFunction(([field, value]) => field.value === value, [await slider.elementHandle(), start]);
    const box = page.getByLabel('Enabled').first();
    await box.uncheck();
    await until(page, "model.wholeText.includes('enabled: false')");
    await box.press('Control+z');
    await until(page, `model.text === ${JSON.stringify(before)}`);
    await field.focus();
    await page.keyboard.press('End');
    await page.keyboard.type('5');
    await page.keyboard.press('Control+z');
    equal(await inside(page, 'model.text'), before, 'a step of the scene was undone instead of a letter');
    await field.fill('10');
}

/** Keys alone select a lamp and move it, in both views. */
async function selectsByKeys(page) {
    await openScene(page, 'three-lights');
    const chosen = () => page.getByText(/^Selected:/).textContent();
    await page.locator('canvas.space').focus();
    for (const which of [1, 2, 3]) {
        await page.keyboard.press('Space');
        check((await chosen()).startsWith(`Selected: light ${which} `), await chosen());
    }
    await page.keyboard.press('Shift+Space');
    check((await chosen()).startsWith('Selected: light 2 '), await chosen());
    const before = await inside(page, 'model.scene.lights[1].place');
    await page.keyboard.press('ArrowRight');
    await until(page, `model.scene.lights[1].place[0] === ${before[0] + 10}`);
    await page.keyboard.press('Escape');
    equal(await chosen(), 'Selected: nothing', 'after Escape');
    await page.locator('canvas.picture').focus();
    await page.keyboard.press('Space');
    check((await chosen()).startsWith('Selected: light 1 '), await chosen());
    const [x, y, height] = await inside(page, 'model.scene.lights[0].place');
    await page.keyboard.press('Control+ArrowUp');
    await until(page, `model.scene.lights[0].place[1] > ${y} && model.text === model.wholeText`);
    const after = await inside(page, 'model.scene.lights[0].place');
    equal([after[0], after[2]], [x, height], 'x and height of the lamp');
    await page.keyboard.press('+');
    check((await inside(page, 'picture.zoom')) > 1, 'plus does not zoom');
    await page.keyboard.press('0');
    equal(await inside(page, 'picture.zoom'), 1, 'zoom');
}

/** A number is dragged aside, as one step of the history; a press alone enters its field. */
async function dragsNumbers(page) {
    await openScene(page, 'sphere');
    const field = page.getByLabel('Position, x').first();
    const before = await inside(page, 'model.scene.lights[0].place');
    const box = await boxOf(field);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 8; i++) await page.mouse.move(x + 5 * i, y);
    await page.mouse.up();
    const size = 10 ** (Math.floor(Math.log10(Math.abs(before[0]))) - 2);
    await until(page, `Math.abs(model.scene.lights[0].place[0] - ${before[0] + 40 * size}) < 1e-6 && model.text === model.wholeText`);
    equal((await inside(page, 'model.scene.lights[0].place')).slice(1), before.slice(1), 'y and z');
    await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, `model.scene.lights[0].place.join() === '${before.join()}'`);
    await page.mouse.click(x, y);
    equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Position, x', 'the field that is entered');
    await page.keyboard.press('Escape');
}

/** Fingers on a phone: one on the picture shows the number, one turns the space view, two zoom either. */
async function touches(browser, url) {
    const page = await opened(browser, url, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await openScene(page, 'report');
    const touch = await page.context().newCDPSession(page);
    const at = (type, ...points) =>
        touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    await look(page, 'picture');
    const picture = await boxOf(page.locator('canvas.picture'));
    const middle = [picture.x + picture.width / 2, picture.y + picture.height / 2];
    const near = (dx, dy) => [middle[0] + dx, middle[1] + dy];
    await at('touchStart', near(20, 10));
    await at('touchMove', near(28, 14));
    await at('touchMove', near(36, 18));
    await until(page, `picture.probe[0] > 0 && document.querySelector('.readout').textContent.includes('W/sr')`);
    const readout = await page.locator('.readout').boundingBox();
    check(readout && readout.y >= 0 && readout.y + readout.height <= 844, 'the number is not in sight');
    equal(await page.locator('.readout').textContent(), await page.locator('.value').textContent(), 'the number');
    await shot(page, 'phone-finger');
    await at('touchEnd');
    const pinch = async (view) => {
        await look(page, view);
        const box = await boxOf(page.locator(`canvas.${view}`));
        const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
        await at('touchStart', [x - 20, y + 60]);
        await at('touchStart', [x - 20, y + 60], [x + 20, y + 60]);
        for (let i = 1; i <= 4; i++) await at('touchMove', [x - 20 - 10 * i, y + 60], [x + 20 + 10 * i, y + 60]);
        await at('touchEnd');
        return inside(page, `${view}.zoom`);
    };
    const zooms = [await pinch('picture'), await pinch('space')];
    check(zooms.every((zoom) => zoom > 2 && zoom < 4), `two fingers zoom by ${zooms}`);
    await shot(page, 'phone-zoomed');
    const turn = await inside(page, 'space.turn');
    const box = await boxOf(page.locator('canvas.space'));
    const corner = [box.x + 20, box.y + 120];
    await at('touchStart', corner);
    for (let i = 1; i <= 4; i++) await at('touchMove', [corner[0] + 10 * i, corner[1]]);
    await at('touchEnd');
    check((await inside(page, 'space.turn')) !== turn, 'one finger does not turn the view');
    // Two fingers that go along turn it, too; one on a body leaves it, and asks for the value there.
    await page.getByRole('button', { name: 'Show all' }).click();
    await until(page, 'space.stage.made && model.isCurrent(space.stage.made.of) && !space.stage.awaitedSince');
    const before = await inside(page, '[space.turn, space.tilt, space.zoom]');
    const pair = (dx, dy) => [[corner[0] + dx, corner[1] + dy], [corner[0] + 60 + dx, corner[1] + dy]];
    await at('touchStart', pair(0, 0)[0]);
    await at('touchStart', ...pair(0, 0));
    for (let i = 1; i <= 4; i++) await at('touchMove', ...pair(8 * i, 6 * i));
    await at('touchEnd');
    const turned = await inside(page, '[space.turn, space.tilt, space.zoom]');
    check(turned[0] !== before[0] && turned[1] !== before[1], `two fingers turn from ${before} to ${turned}`);
    check(Math.abs(turned[2] - before[2]) < 0.2 * before[2], 'fingers that keep their distance zoom');
    await page.getByRole('button', { name: 'Show all' }).click();
    await until(page, 'space.stage.made && model.isCurrent(space.stage.made.of) && !space.stage.awaitedSince');
    const [bx, by] = await page.evaluate(() => {
        const { space } = window.luxel.inside;
        const found = [];
        for (let y = 0; y < 300; y += 4)
            for (let x = 40; x < 300; x += 4) if (space.placeAt(x, y) && space.placeAt(x + 8, y + 4) && !space.thingAt(x, y)) found.push([x, y]);
        return found[found.length >> 1];
    });
    const probe = await inside(page, 'picture.probe');
    const still = await inside(page, 'space.turn');
    await at('touchStart', [box.x + bx, box.y + by]);
    for (let i = 1; i <= 4; i++) await at('touchMove', [box.x + bx + 2 * i, box.y + by + i]);
    await until(page, `picture.probe.join() !== '${probe.join()}' || document.querySelector('.readout').textContent.includes('not seen')`);
    await at('touchEnd');
    equal(await inside(page, 'space.turn'), still, 'the turn after a finger on a body');
    await look(page, 'picture');
    await page.getByRole('button', { name: 'Show all' }).click();
    equal(await inside(page, 'picture.zoom'), 1, 'zoom of the picture');
    equal(page.faults, [], 'faults');
    await page.context().close();
}

/** The language changes without a network; where its words could not be had, the page says so and keeps its own. */
async function speaksOffline(browser, folder, url) {
    const page = await opened(browser, url);
    await page.context().setOffline(true);
    await page.getByLabel('Language').selectOption('ru');
    await page.getByRole('heading', { name: 'Вид в пространстве' }).waitFor();
    await page.context().close();
    const { server, url: other } = await serve(folder, { 'ru.json': (response) => response.writeHead(503).end() });
    const without = await opened(browser, other, {}, 'model.client.isWhole');
    await without.getByLabel('Language').selectOption('ru');
    await without.getByText('The words of that language could not be loaded').waitFor();
    equal(await without.getByLabel('Language').inputValue(), 'en', 'the language that is told');
    await without.getByRole('heading', { name: 'Space view' }).waitFor();
    await without.context().close();
    server.close();
}

/** Names in links that are no scene's are told; files are called by the scene. */
async function names(browser, url) {
    const page = await opened(browser, `${url}#scene=nonsense`);
    // It is said for some seconds, in which a busy machine may not have got this far.
    await page.getByText('There is no built-in scene of this name: nonsense').waitFor({ state: 'attached' });
    await page.context().close();
    const named = await opened(browser, `${url}#scene=spot`);
    const [file] = await Promise.all([
        named.waitForEvent('download'),
        named.getByLabel('Download').selectOption('.png'),
    ]);
    equal(file.suggestedFilename(), 'spot.png', 'the name of a file');
    await named.context().close();
}

export async function typed(browser, folder, url) {
    const page = await opened(browser, url);
    await test('what is no number is told at its field', () => tellsWrongNumbers(page));
    await test('Ctrl+K finds parameters', () => findsParameters(page));
    await test('Ctrl+Z undoes beside fields and sliders', () => undoes(page));
    await test('keys alone select and move a lamp', () => selectsByKeys(page));
    await test('numbers are dragged', () => dragsNumbers(page));
    await test('no fault was reported while it was typed', () => equal(page.faults, [], 'faults'));
    await page.context().close();
    await test('fingers show the number, turn and zoom', () => touches(browser, url));
    await test('the language changes without a network', () => speaksOffline(browser, folder, url));
    await test('scenes and files have names', () => names(browser, url));
}
