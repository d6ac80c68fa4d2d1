// SPDX-License-Identifier: MIT
// Splits the core in two: node split.mjs CORE.wasm FIRST.wasm SECOND.wasm.  The first part holds what a page calls
// until its reader has seen, probed and changed a plain scene; all else is the second part, which is fetched meanwhile.
// wasm-split of binaryen, which emscripten brings, parts the functions by a trial: those that are called in it are the
// first part.  The trial is always the same, and so are the parts that it gives of one core.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { moveData } from './move_data.mjs';
import { compiled, coreModule, moduleOf } from './node_core.mjs';

/** The built-in scenes whose first pictures the first part makes. */
export const SCENES = ['sphere', 'report', 'two-spheres', 'three-lights', 'spot', 'distant', 'ambient'];

// What moves or changes a light that has no position.
const PLACES = { planar: 'lights[0].rectangle.center=[-1100, -200, 900]', distant: 'lights[0].irradiance=3', ambient: 'lights[0].irradiance=3' };

/** The files that the core brings: only meshes and photometry are read from them, which the second part does. */
const FILES = new URL('../data/files/', import.meta.url);

/** Tables that hardly can be packed: colour-matching functions, 11 kB, and the coefficients of the all-weather sky. */
const TABLES = [
    ['../src/base/observer_table.h', 'observer_table'],
    ['../src/light/sky/perez.c', 'table'],
];

/** The numbers of a table in C, as memory has them. */
function tableIn([source, name]) {
    const text = fs.readFileSync(new URL(source, import.meta.url), 'utf8');
    const [, numbers] = new RegExp(` ${name}(?:\\[[^\\]]*\\])+ = \\{([^;]*)\\};`).exec(text);
    return Buffer.from(Float64Array.from(numbers.match(/[^\s,{}]+/g), Number).buffer);
}

const PROFILE = 'write_profile';
const FEATURES = ['simd', 'bulk-memory', 'sign-ext', 'nontrapping-float-to-int', 'mutable-globals'];

function binaryen(program, ...values) {
    try {
        return execFileSync(program, values, { maxBuffer: 1 << 28 }).toString();
    } catch (error) {
        throw error.code === 'ENOENT' ? new Error(`there is no ${program}: install binaryen`) : error;
    }
}

export function check(truth, message) {
    if (!truth) throw new Error(message);
}

/** What a page asks in its first seconds; each answer must be there, or the trial has not called what it should. */
export function tryCore(core, firstScene) {
    const builtins = core.builtins();
    check(builtins.length && core.version(), 'it tells no scenes');
    core.translate({ point: 'точечный', brightness: 'яркость' });
    const paths = core.parameters().keys.map(({ path }) => path.replaceAll('[]', '[0]'));
    check(paths.length, 'it tells no parameters');
    // The form and the views ask for most keys, and for some that a light or a surface has not.
    const things = ['lights[0]', 'surfaces[0]'];
    const ends = new Set(paths.map((key) => key.slice(key.lastIndexOf('.') + 1)));
    const keys = [...paths, ...things, ...things.flatMap((thing) => [...ends].map((end) => `${thing}.${end}`))];
    for (const name of ['', ...SCENES]) {
        const scene = name ? builtins.find((each) => each.name === name) : { text: firstScene };
        check(scene, `it has no scene "${name}"`);
        try {
            tryScene(core, scene.text, keys);
        } catch (error) {
            error.message = `scene "${name}": ${error.message}`;
            throw error;
        }
    }
}

function tryScene(core, text, keys) {
    core.direct(true); // as a text is judged
    core.view('luminance');
    core.within(0);
    check(core.open(text), JSON.stringify(core.messages()));
    core.direct(false);
    const { lights, points } = core.scene();
    check(core.lightColors().length === lights.length, 'it tells no colours of lights');
    keys.forEach((key) => core.get(key));
    for (const stride of [8, 2, 1]) {
        check(core.render(stride), `no picture: ${JSON.stringify(core.messages())}`);
        check(core.samples().values.length, 'no samples');
    }
    for (const irradiance of [true, false]) {
        core.quantity(irradiance);
        check(core.render(1), 'no picture of the other quantity');
        check(core.probe(10, 20) && core.lit(10, 20), 'no probe');
    }
    points.forEach(([x, y]) => core.probe(x, y));
    for (const [from, to] of [core.line(10, 20, 30), [[-100, 0], [100, 50]]])
        for (let i = 0; i < 50; i++) core.probe(...[0, 1].map((axis) => from[axis] + ((to[axis] - from[axis]) * i) / 49));
    // Numbers of cameras are as long as they come.
    for (const [columns, rows, turn] of [[40, 30, 0.65], [98, 58, 1.234567], [246, 142, -2.1]]) {
        const [x, y] = [2345.6789 * Math.sin(turn), -2345.6789 * Math.cos(turn)];
        const width = 2000 * Math.sqrt(1 + columns / 97);
        const camera = [x, y, 1800 / 1.3, 10 / 3, -1e-3, 300.1, x / -7e3, y / -7e3, 0.81234567890123, width, (width / columns) * rows];
        check(core.stage(camera, columns, rows), `no stage: ${JSON.stringify(core.messages())}`);
        check(core.stageDepth(camera, columns / 2, rows / 2), 'no distances of the stage');
        check(core.stageProbe(camera, columns, rows, 10.123, 20.456), 'no probe of the stage');
    }
    check(core.project([0, 0, 100]) && core.unproject(0, 0, 100), 'no place on the screen');
    for (const changes of [
        [{ set: PLACES[lights[0].type] ?? 'lights[0].position=[100, 200, 1500]' }],
        [{ set: 'surfaces[0].center=[10, 20, 300]' }],
    ]) {
        const changed = core.edit(text, changes);
        check(changed, `no change: ${JSON.stringify(core.messages())}`);
        check(core.open(changed) && core.render(2), `not as changed: ${JSON.stringify(core.messages())}`);
    }
}

/** Tries a core that notes which of its functions are called, and takes the note. */
async function profileOf(file, { Core, trial }) {
    const clocks = [Date.now, performance.now];
    let time = 0;
    Date.now = performance.now = () => time++; // nothing may hang on how long it takes, but progress is told
    const core = await Core.start(await compiled(file));
    trial(core);
    [Date.now, performance.now] = clocks;
    const { page_memory, [PROFILE]: write, memory } = core.call;
    const size = write(0, 0);
    const place = page_memory(size);
    check(place && write(place, size) === size, 'its profile could not be written');
    return new Uint8Array(memory.buffer, place, size).slice();
}

/** Appends what tells a core from others: by it the page knows that two parts belong together. */
function sign(file, identity) {
    const name = 'luxel-core'; // core.ts reads it
    const content = Buffer.concat([Buffer.from([name.length]), Buffer.from(name), identity]);
    fs.appendFileSync(file, Buffer.concat([Buffer.from([0, content.length]), content]));
}

// A placeholder is JavaScript, which can be given no vectors: a call of it would end as another fault than it is.
function refuseVectors(file) {
    const lines = binaryen('wasm-dis', file).split('\n');
    const imports = lines.filter((line) => line.includes('(import "placeholder"'));
    check(imports.length, 'nothing is left for the second part');
    check(
        !imports.some((line) => line.includes('v128')),
        'a function of the second part that the first one calls has vectors as arguments: let it take their addresses',
    );
}

/** Splits a core by a trial of it: a function that is given a Core of this class. */
export async function split(whole, first, second, how) {
    const features = FEATURES.map((feature) => `--enable-${feature}`);
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-split-'));
    const [noting, profile] = ['noting.wasm', 'profile'].map((name) => path.join(folder, name));
    try {
        binaryen('wasm-split', '--instrument', `--profile-export=${PROFILE}`, ...features, whole, '-o', noting);
        fs.writeFileSync(profile, await profileOf(noting, how));
        const names = ['--import-namespace=first', '--placeholder-namespace=placeholder']; // core.ts gives them
        binaryen('wasm-split', `--profile=${profile}`, ...names, ...features, whole, '-o1', first, '-o2', second);
    } finally {
        fs.rmSync(folder, { recursive: true });
    }
    const files = fs.readdirSync(FILES).map((name) => fs.readFileSync(new URL(name, FILES)));
    moveData(first, second, [...files, ...TABLES.map(tableIn)]);
    refuseVectors(first);
    const identity = createHash('sha256').update(fs.readFileSync(whole)).digest().subarray(0, 16);
    for (const file of [first, second]) sign(file, identity);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    try {
        const [whole, first, second] = process.argv.slice(2);
        const { Core } = await coreModule();
        const { firstScene } = await moduleOf('page/first_scene.ts');
        await split(whole, first, second, { Core, trial: (core) => tryCore(core, firstScene('en')) });
    } catch (error) {
        console.error(`split.mjs: the core could not be split in two: ${error.message}`);
        process.exitCode = 1;
    }
}
