// SPDX-License-Identifier: MIT
// The packages for npm, installed as their users install them: node test.mjs FOLDER LUXEL.  Their numbers are the tool's, in
// Node, in a plain page, bundled by Vite and by esbuild; the last line is "N passed, N failed".
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { check, equal, summary, test } from '../tests/tap.mjs';
import { inBrowsers } from './test_browsers.mjs';
import { pack } from './pack.mjs';

const MOST_OF_FIRST = 260e3; // bytes, gzip
const HEADER = 128; // bytes of an .npy file before its numbers
const web = path.dirname(path.dirname(fileURLToPath(import.meta.url)));
const [packages, tool] = process.argv.slice(2).map((name) => path.resolve(name));
const place = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-npm-'));
const env = { ...process.env, LUXEL_ISA: process.arch === 'x64' ? 'x86-64' : 'generic', LC_ALL: 'C', LANGUAGE: '' };

const run = (...values) => execFileSync(tool, values, { cwd: place, env, stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28 });
const json = (...values) => JSON.parse(run(...values, '--json'));

/** So near are numbers of two C libraries. */
function near(got, expected, what, relative = 1e-12) {
    check(Math.abs(got - expected) <= relative * Math.abs(expected), `${what}: ${got} instead of ${expected}`);
}

/** Two numbers, each with its bound. */
function within(got, expected, what) {
    const apart = Math.abs(got.value - expected.value);
    check(apart <= got.error + expected.error, `${what}: ${JSON.stringify([got, expected])}`);
}

function install() {
    fs.writeFileSync(path.join(place, 'package.json'), '{"private": true, "type": "module"}\n');
    const archives = fs.readdirSync(packages).filter((name) => name.endsWith('.tgz'));
    check(archives.length === 2, `${archives.length} packages`);
    const files = archives.map((name) => path.join(packages, name));
    execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', ...files], { cwd: place, stdio: 'pipe' });
}

function isSmall() {
    const size = (name) => gzipSync(fs.readFileSync(path.join(packages, 'luxel-core', name)), { level: 9 }).length;
    const [first, second] = ['luxel-core.wasm', 'luxel-core-2.wasm'].map(size);
    check(first <= MOST_OF_FIRST, `the first part has ${first} bytes`);
    return `${first} + ${second} bytes, gzip`;
}

function isRepeated() {
    process.env.SOURCE_DATE_EPOCH ??= execFileSync(path.join(web, '../tools/release_date')).toString().trim();
    for (const name of ['luxel-core', 'luxel-scene']) {
        const archive = fs.readdirSync(packages).find((file) => file.startsWith(`${name}-`));
        check(pack(path.join(packages, name)).equals(fs.readFileSync(path.join(packages, archive))), `${name} has other bytes`);
    }
}

const floats = (bytes) => new Float32Array(Uint8Array.from(bytes.subarray(HEADER)).buffer);

/** The picture of a scene, and that it is the tool's, as docs/WEB.md has it. */
async function picture({ Scene }, name) {
    const scene = await Scene.builtin(name);
    const bytes = await scene.file('a.npy');
    run('render', name, '-q', '-o', 'a.npy');
    const truth = fs.readFileSync(path.join(place, 'a.npy'));
    await scene.close();
    if (truth.equals(Buffer.from(bytes))) return 'the same bytes';
    const [a, b] = [floats(bytes), floats(truth)];
    equal(a.length, b.length, 'numbers');
    const most = a.reduce((all, value, i) => Math.max(all, Math.abs(value - b[i])), 0);
    const apart = most / b.reduce((all, value) => Math.max(all, value), 0);
    check(apart <= 2e-6, `${apart} of the maximum off`);
    return `within ${apart.toExponential(1)} of the maximum`;
}

async function files({ Scene }, name, text = null) {
    const scene = text ? await Scene.open(text) : await Scene.builtin(name);
    if (text) fs.writeFileSync(path.join(place, name), text);
    for (const ending of ['png', 'exr', 'npy', 'pfm', 'csv']) {
        const bytes = Buffer.from(await scene.file(`a.${ending}`));
        run('render', name, '-q', '-o', `a.${ending}`);
        check(bytes.equals(fs.readFileSync(path.join(place, `a.${ending}`))), `other bytes in .${ending}`);
        if (!['png', 'exr'].includes(ending)) continue;
        equal((await Scene.open(new Uint8Array(bytes))).text, scene.text, `the scene that .${ending} carries`);
    }
    const field = await scene.render();
    const npy = floats(fs.readFileSync(path.join(place, 'a.npy')));
    check(Buffer.from((field.rgb ?? field.values).buffer).equals(Buffer.from(npy.buffer)), 'other samples');
}

async function statistics({ Scene }) {
    const { statistics: found, unit } = await (await Scene.builtin('report')).render();
    const told = json('render', 'report', '-o', 'a.npy');
    equal([found.maximum.column, found.maximum.row, unit], [...told.max.pixel, told.unit], 'maximum');
    near(found.maximum.value, told.max.value, 'maximum');
    near(found.mean, told.mean, 'mean', 1e-9);
    near(found.lit, told.lit, 'lit');
}

function sameProbe(got, expected) {
    equal([got.on_surface, got.pixel, got.screen_mm], [expected.on_surface, expected.pixel, expected.screen], 'place');
    near(got.value, expected.value, 'value');
    if (expected.pixel_value !== null) near(got.pixel_value, expected.pixel_value, 'pixel', 1e-6);
    equal(got.shares.length, expected.lights.length, 'shares');
    got.shares.forEach((share, i) => {
        for (const key of ['irradiance', 'diffuse', 'specular']) near(share[key], expected.lights[i][key], key, 1e-9);
        equal([share.light, share.type], [expected.lights[i].index, expected.lights[i].type], 'light');
    });
    check(got.error > 0 && got.error <= 1e-9 * got.value, `error ${got.error}`);
}

async function probes({ Scene }) {
    for (const name of ['report', 'three-lights', 'window']) {
        const scene = await Scene.builtin(name);
        const told = json('probe', name, '-p', '20,-30', '-p', '-40,10').points;
        const found = await scene.probe([[20, -30], [-40, 10]]);
        found.forEach((probe, i) => sameProbe(probe, told[i]));
        equal((await scene.probe([20, -30])).value, found[0].value, 'one point');
    }
    const scene = await Scene.builtin('report');
    equal((await scene.probe()).map(({ value }) => value !== null), [true, true, true], "the scene's points");
    equal((await scene.probe([])).length, 0, 'no points');
    const [told] = json('probe', 'report', '--at', '150,0,1259.8,1,0,2').points;
    const found = await scene.probe({ position_mm: [150, 0, 1259.8], normal: [1, 0, 2] });
    near(found.value, told.value, 'element');
    equal([found.screen_mm, found.lies_on_surface], [null, false], 'a free element');
    const irradiance = await scene.probe([150, 0], { quantity: 'irradiance' });
    near(irradiance.value, json('probe', 'report', '-p', '150,0', '--quantity', 'irradiance').points[0].value, 'irradiance');
    equal((await scene.probe([240, 240])).value, null, 'off the surface');
}

async function grids({ Scene }) {
    const scene = await Scene.builtin('desk');
    const [told] = json('grid', 'desk').grids;
    const grid = await scene.grid('desk');
    equal([grid.columns, grid.rows, grid.values.length, grid.values[0].length], [7, 5, 5, 7], 'cells');
    near(grid.average, told.average, 'average');
    for (const key of ['minimum', 'maximum']) near(grid[key].value, told[key].value, key);
    const all = await scene.grids();
    equal(all[0], grid, 'all of them');
    const limits = { average: 300, maximum: 900, ratio: 0.4, share: { above: 200, percent: 95 } };
    await scene.set({ 'grids[0].limits': limits });
    const judged = json('grid', 'desk', '-s', `grids[0].limits=${JSON.stringify(limits)}`).grids[0].limits;
    (await scene.grid('desk')).limits.forEach(({ name, wanted, value, verdict }, i) => {
        equal([name, wanted, verdict], [judged[i].name, judged[i].wanted, judged[i].verdict], 'a limit');
        near(value, judged[i].value, name);
    });
    equal(grid.limits, [], 'limits of a grid without');
    let thrown = null;
    await scene.grid('dask').catch((error) => (thrown = error));
    check(thrown instanceof RangeError && thrown.message.includes('"desk"'), `${thrown}`);
}

async function extrema({ Scene }) {
    const { maximum, minimum } = await (await Scene.builtin('report')).extrema();
    const told = json('stats', 'report');
    near(maximum.value, told.maximum.value, 'maximum');
    equal([maximum.place, minimum.place, maximum.surface], [told.maximum.place, told.minimum.place, 0], 'places');
    check(Math.abs(maximum.x_mm - told.maximum.screen[0]) < 1e-6, `${maximum.x_mm}`);
}

const REFLECTING = `luxel: 1
reflections: 2
screen: {width: 400, height: 400, resolution: [40, 40]}
observer: {z: 1500}
surfaces:
  - {type: sphere, center: [0, 0, 500], radius: 100, name: ball, material: {diffuse: 0.5, specular: 0, over_pi: true}}
  - {type: rectangle, center: [0, 0, 300], size: [600, 600], material: {diffuse: 0.5, specular: 0, over_pi: true}}
lights: [{type: point, position: [300, 200, 1200], intensity: 10}]
`;

async function balance({ Scene }) {
    equal(await (await Scene.builtin('report')).balance(), null, 'of a scene without reflections');
    fs.writeFileSync(path.join(place, 'reflecting.yaml'), REFLECTING);
    const told = json('stats', 'reflecting.yaml').balance;
    const scene = await Scene.open(REFLECTING);
    const found = await scene.balance();
    check(told && found.closes && found.reached, JSON.stringify(found));
    for (const key of ['arrives', 'absorbed', 'escaped', 'pending']) within(found[key], told[key], key);
    equal([found.sides[0].surface_name, found.sides[0].side], ['ball', 'outside'], 'a side');
    const [probe] = json('probe', 'reflecting.yaml', '-p', '10,10').points;
    const lit = await scene.probe([10, 10]);
    within(lit, probe, 'value');
    within(lit.reflected, probe.reflected, 'reflected');
}

async function explains({ Scene }) {
    const scene = await Scene.builtin('report');
    for (const format of ['text', 'markdown', 'html', 'latex']) {
        const told = run('explain', 'report', '-p', '0,0', '-o', '-', '--format', format).toString();
        equal((await scene.explain([0, 0], { format })).trim(), told.trim(), format);
    }
}

/** Each built-in scene read key by key, made anew of these, is the same scene; all of them fit their type. */
async function documents({ Scene, builtinScenes, schema }) {
    const keys = Object.keys((await schema()).properties);
    const program = ["import type { SceneDocument } from 'luxel-core';"];
    for (const { name, text } of await builtinScenes()) {
        const scene = await Scene.open(text, { name });
        const document = {};
        for (const key of keys) {
            const value = await scene.get(key);
            if (value !== null) document[key] = value;
        }
        const again = await Scene.open(document);
        for (const key of keys) equal(await again.get(key), await scene.get(key), `${name}: ${key}`);
        program.push(`export const ${name.replaceAll('-', '_')}: SceneDocument = ${JSON.stringify(document)};`);
        await Promise.all([scene.close(), again.close()]);
    }
    equal(compile(program.join('\n')), '', 'what the compiler tells');
    return `${program.length - 1} scenes`;
}

/** What the compiler tells of a program of the installed package. */
function compile(program) {
    fs.writeFileSync(path.join(place, 'program.ts'), program);
    const options = ['--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2022,dom', 'program.ts'];
    try {
        execFileSync(path.join(web, 'node_modules/.bin/tsc'), options, { cwd: place, stdio: 'pipe' });
        return '';
    } catch (error) {
        return error.stdout.toString();
    }
}

const TYPED = `import { Scene, type Probe } from 'luxel-core';
import { remote } from 'luxel-core/remote';
import { LuxelScene } from 'luxel-scene';
const scene = await Scene.builtin('report');
const one: Probe = await scene.probe([1, 2]);
const many: Probe[] = await scene.probe([[1, 2]]);
const field: Float32Array = (await scene.render({ quantity: 'irradiance' })).values;
const other = await remote().open({ luxel: 1, screen: { width: 1, height: 1, resolution: [1, 1] }, observer: { z: 1 }, surfaces: [], lights: [] });
export const all = [one, many, field, other, new LuxelScene().text];
`;

/** Keys of the schema, one by one. */
function properties(node, found = []) {
    if (node === null || typeof node !== 'object') return found;
    for (const [key, value] of Object.entries(node.properties ?? {})) {
        if (value !== null && typeof value === 'object' && (value.description || value.const)) found.push(key);
    }
    Object.entries(node).forEach(([key, value]) => key === 'then' || key === 'if' || properties(value, found));
    return found;
}

async function types({ schema }) {
    equal(compile(TYPED), '', 'what the compiler tells');
    for (const [right, wrong] of [["'report'", "'repart'"], ["'irradiance'", "'radiance'"], ['observer: { z', 'observer: { zz']]) {
        const told = compile(TYPED.replace(right, wrong));
        check(told.split('error TS').length === 2, `instead of one error for ${wrong}: ${told}`);
    }
    const text = fs.readFileSync(path.join(packages, 'luxel-core/scene.d.ts'), 'utf8');
    const typed = text.match(/^ +\w+\??: /gm).length;
    const keys = properties(await schema()).filter((key) => key !== 'type').length;
    const kinds = text.match(/^ +type: "/gm).length;
    check(typed - kinds === keys && keys > 300, `${typed - kinds} keys are typed of ${keys}`);
    return `${keys} keys`;
}

async function changes({ Scene }) {
    const scene = await Scene.builtin('report');
    const before = scene.text;
    await scene.set({ 'lights[0].intensity': 20, 'surfaces[0].material': { shininess: 40 } });
    equal([await scene.get('lights[0].intensity'), await scene.get('surfaces[0].material.shininess')], [20, 40], 'values');
    check(scene.text.startsWith(before.split('\n')[0]), 'comments are gone');
    await scene.insert('lights', { type: 'ambient', irradiance: 1, name: "it's, [odd]: \u{1f4a1}" });
    equal([await scene.get('lights[1].name'), (await scene.lights()).length], ["it's, [odd]: \u{1f4a1}", 2], 'a light');
    await scene.remove('lights[1]');
    equal((await scene.lights()).map(({ type }) => type), ['point'], 'lights');
    equal((await scene.conventions()).sampling, 'nodes', 'conventions');
    check((await scene.advice()).some(({ severity }) => severity === 'advice'), 'no advice');
    const text = scene.text;
    let thrown = null;
    await scene.set({ 'surfaces[0].radius': -3 }).catch((error) => (thrown = error));
    check(thrown?.name === 'LuxelError' && thrown.diagnostics[0].key === 'surfaces[0].radius', `${thrown}`);
    equal([scene.text, await scene.get('surfaces[0].radius')], [text, 300], 'the scene after a mistake');
}

const LAMP = 'IESNA91\nTILT=NONE\n1 800 1 3 1 1 2 .1 .1 0 1 1 20\n0 45 90 0 300 200 0\n';

async function namedFiles({ Scene }) {
    const text = REFLECTING.replace('reflections: 2\n', '').replace('{type: point', '{type: luminaire, file: lamp.ies').replace(', intensity: 10', '');
    let thrown = null;
    await Scene.open(text).catch((error) => (thrown = error));
    equal(thrown?.diagnostics.map(({ key }) => key), ['lights[0].file'], 'what is missing');
    fs.writeFileSync(path.join(place, 'lamp.ies'), LAMP);
    fs.writeFileSync(path.join(place, 'lamp.yaml'), text);
    const scene = await Scene.open(text, { files: { 'lamp.ies': Buffer.from(LAMP) } });
    near((await scene.probe([10, 10])).value, json('probe', 'lamp.yaml', '-p', '10,10').points[0].value, 'value');
    await scene.give('lamp.ies', Buffer.from(LAMP.replace('300 200', '600 200')));
    check((await scene.probe([10, 10])).value > json('probe', 'lamp.yaml', '-p', '10,10').points[0].value, 'the old lamp');
}

async function progress({ Scene }) {
    const told = [];
    await (await Scene.open(REFLECTING)).render({ progress: (done) => told.push(done) });
    check(told.length > 1 && told.every((done) => done >= 0 && done <= 1), JSON.stringify(told.slice(0, 9)));
}

async function together({ Scene }) {
    const scenes = await Promise.all(['report', 'spot', 'distant'].map((name) => Scene.builtin(name)));
    const [a, b] = await Promise.all([scenes[0].explain(), scenes[0].render()]);
    check(a.length > 100 && b.values.length === 360 * 360, 'two questions at once');
    await Promise.all(scenes.map((scene, i) => scene.set({ 'screen.width': 100 + i, 'screen.height': 100 + i })));
    equal(await Promise.all(scenes.map((scene) => scene.get('screen.width'))), [100, 101, 102], 'scenes of their own');
}

async function remotely({ remote }, { Scene }) {
    const there = remote();
    const told = [];
    const scene = await there.open(REFLECTING);
    const field = await scene.render({ progress: (done) => told.push(done) });
    const here = await (await Scene.open(REFLECTING)).render();
    check(Buffer.from(field.values.buffer).equals(Buffer.from(here.values.buffer)), 'other samples');
    await scene.set({ 'lights[0].intensity': 20 });
    check(scene.text.includes('intensity: 20'), scene.text);
    let thrown = null;
    await scene.set({ 'lights[0].intensity': -1 }).catch((error) => (thrown = error));
    check(thrown?.name === 'LuxelError' && thrown.diagnostics.length === 1, `${thrown}`);
    const waiting = scene.render().catch((error) => error);
    there.end();
    check((await waiting) instanceof Error, 'what was asked of a worker that was ended');
}

/** Programs of a README, as they stand there. */
const examples = (name) =>
    [...fs.readFileSync(path.join(packages, name, 'README.md'), 'utf8').matchAll(/```js\n([^]*?)```/g)].map(([, code]) => code);

function readme() {
    const programs = examples('luxel-core');
    equal(programs.length, 3, 'examples');
    const told = programs.map((code) => {
        fs.writeFileSync(path.join(place, 'example.mjs'), code);
        return execFileSync('node', ['example.mjs'], { cwd: place, timeout: 120e3 }).toString();
    });
    check(/^[\d.]+ ± [\d.e-]+ W/.test(told[0]) && told[0].split('\n').length > 3, told[0]);
    check(fs.statSync(path.join(place, 'ball.png')).size > 1000, 'no picture');
    check(/^desk, front: [\d.]+ ± [\d.e-]+ lx$/m.test(told[2]), told[2]);
}

try {
    await test('the packages are installed', install);
    await test('the first picture needs little of the core', isSmall);
    await test('the same files give the same packages', isRepeated);
    const core = await import(pathToFileURL(path.join(place, 'node_modules/luxel-core/index_node.js')));
    const others = await import(pathToFileURL(path.join(place, 'node_modules/luxel-core/remote_node.js')));
    for (const name of process.env.LUXEL_SCENES?.split(' ') ?? (await core.builtinScenes()).map((each) => each.name))
        await test(`numbers of ${name}`, () => picture(core, name));
    await test("the tool's bytes in each format", () => files(core, 'report'));
    await test("the tool's bytes in each format, in colour", () => files(core, 'colour.yaml', REFLECTING.replace('reflections: 2', 'channels: rgb').replace('intensity: 10', 'intensity: 10, color: {temperature: 3000}')));
    for (const [name, body] of Object.entries({ statistics, probes, grids, extrema, balance, explains, documents, types, changes, namedFiles, progress, together }))
        await test(name, () => body(core));
    await test('a worker', () => remotely(others, core));
    await test('the examples of the README', readme);
    await inBrowsers(place, run('probe', 'report', '-p', '150,0', '--json').toString());
} finally {
    fs.rmSync(place, { recursive: true });
}
process.exitCode = summary();
