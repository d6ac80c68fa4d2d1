// SPDX-License-Identifier: MIT
// Scenes in colour on the page: it shows their colours, and gives lamps and materials some.
import { POINT, told } from './colour_numbers.mjs';
import { inside, look, opened, openScene, openText, shot, tab, until } from './hands.mjs';
import { check, test } from './tap.mjs';

const SCENE = 'warm-and-cold';

async function showsColours(page, tool) {
    await openScene(page, SCENE);
    const shown = await page.evaluate(() => {
        const { picture, model } = window.luxel.inside;
        const { width, height } = picture.image;
        const { data } = picture.image.getContext('2d').getImageData(0, 0, width, height);
        return model.picture.levels.every((level, i) => data[Math.floor(i / 3) * 4 + (i % 3)] === level || !model.picture.mask[Math.floor(i / 3)]);
    });
    check(shown, 'the canvas has other levels than the file');
    await look(page, 'picture');
    await page.evaluate(([x, y]) => window.luxel.inside.picture.moveProbe(x, y), POINT);
    await page.locator('.colour-card .channels').waitFor();
    const card = await page.locator('.colour-card').textContent();
    const [probe] = told(tool, 'probe', SCENE, '-p', POINT.join()).points;
    check(card.includes(`${Math.round(probe.cct)} K`) && card.includes('nearest black body'), card);
    await page.getByLabel('Language').selectOption('ru');
    await page.locator('.colour-card', { hasText: /x, y 0,\d{4}; 0,\d{4};.*Duv −?0,\d{4} / }).waitFor();
    await page.getByLabel('Язык').selectOption('en');
    await page.locator('.colour-card', { hasText: 'nearest black body' }).waitFor();
    await shot(page, 'colour');
    await look(page, 'space');
    await shot(page, 'colour-space');
    await tab(page, 'View');
    await page.getByLabel('Channel', { exact: true }).selectOption('cct');
    await until(page, `model.isSettled && model.picture.of.view === 'cct' && model.picture.facts.unit === 'K'`);
    check(await inside(page, 'model.picture.facts.maximum.value > 2600 && !model.picture.rgb'), 'no temperatures');
    await page.getByLabel('Channel', { exact: true }).selectOption('luminance');
    await until(page, `model.isSettled && !!model.picture.rgb`);
    await tab(page, 'Light');
}

async function setsColours(page) {
    await openScene(page, 'sphere');
    check(await page.getByLabel('Channel', { exact: true }).isHidden(), 'a grey scene has a channel to choose');
    const lamp = page.locator('[data-tab=light] .lamp-colour').first();
    await lamp.locator('select').selectOption('temperature');
    await until(page, `model.isSettled && model.text.includes('temperature: 3000') && model.text.includes('channels: rgb')`);
    await shot(page, 'colour-lamp');
    await lamp.locator('.temperatures').fill('900');
    await until(page, `/temperature: 9\\d\\d\\d/.test(model.text) && model.isSettled`);
    await lamp.locator('select').selectOption('xy');
    await until(page, `model.text.includes('xy: [0.2') && model.isSettled`);
    await lamp.locator('input[type=text]').first().fill('0.9');
    await lamp.locator('input[type=text]').first().press('Enter');
    await until(page, 'model.stale');
    check((await lamp.locator('.note').textContent()).includes('spectral locus'), 'the field does not tell');
    await page.getByRole('button', { name: 'Undo' }).click();
    await until(page, '!model.stale && model.isSettled');
    await lamp.locator('select').selectOption('');
    await until(page, `!model.text.includes('xy:') && model.isSettled`);
    await openText(page, (await inside(page, 'model.text')).replace('diffuse: 0.8', 'diffuse: 0.8, color: [1, 1, 1]'));
    await page.locator('.tabs').getByRole('button', { name: 'Matter', exact: true }).click();
    await page.locator('[data-tab=matter] input[type=color]').first().fill('#ff8040');
    await until(page, `/color: \\[1, 0\\.21\\d*, 0\\.05\\d*\\]/.test(model.text) && model.isSettled`);
    await shot(page, 'colour-material');
}

export async function colours(browser, url, tool) {
    const page = await opened(browser, url);
    await test('a scene in colour is shown in its colours, and its channels', () => showsColours(page, tool));
    await test('lamps and materials get colours', () => setsColours(page));
    await page.context().close();
}
