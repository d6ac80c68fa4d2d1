// SPDX-License-Identifier: MIT
// The two parts of the core: they are small, the first one makes the first pictures alone, and no call of the second
// one is answered before that is there.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { moduleOf } from '../node_core.mjs';
import { SCENES, tryCore } from '../split.mjs';
import { PARTS, partsOf } from './core.mjs';
import { check, equal, test } from './tap.mjs';

const MOST_OF_FIRST = 330e3; // bytes, gzip; docs/WEB.md tells what they are
const MOST_OF_BOTH = 800e3;

export const MESH = `luxel: 1
screen: {width: 700, height: 700, resolution: [120, 120]}
observer: {z: 1700}
surfaces: [{type: mesh, file: 'builtin:pot.ply', position: [0, 0, 300]}]
lights: [{type: luminaire, file: 'builtin:office-lamp.ies', position: [420, 300, 1250]}]
`;

function areSmall(folder) {
    const size = (name) => gzipSync(fs.readFileSync(path.join(folder, name)), { level: 9 }).length;
    const [first, second] = PARTS.map(size);
    check(first <= MOST_OF_FIRST, `the first part has ${first} bytes`);
    check(first + second <= MOST_OF_BOTH, `both have ${first + second} bytes`);
    return `${first} + ${second} bytes, gzip`;
}

const split = (values) => spawnSync('node', [fileURLToPath(new URL('../split.mjs', import.meta.url)), ...values]);

/** Splitting again gives the same bytes; what is no core is refused. */
function areRepeated(folder, scratch) {
    const again = PARTS.map((name) => path.join(scratch, name));
    const { status, stderr } = split([path.join(folder, 'core/web/core/luxel-core.wasm'), ...again]);
    equal([status, stderr.toString()], [0, ''], 'splitting');
    PARTS.forEach((name, i) =>
        check(fs.readFileSync(again[i]).equals(fs.readFileSync(path.join(folder, name))), `${name} has other bytes`),
    );
    const wrong = split([path.join(folder, PARTS[1]), ...again]);
    equal(wrong.status, 1, 'status for a part as the whole');
    const told = wrong.stderr.toString();
    check(told.startsWith('split.mjs: the core could not be split in two: '), told);
}

async function beginsAlone({ first, second, Core }) {
    const alone = await Core.start(first);
    const whole = await Core.start(first, second);
    const { firstScene } = await moduleOf('page/first_scene.ts');
    tryCore(alone, firstScene('en'));
    const scenes = alone.builtins().filter(({ name }) => SCENES.includes(name));
    for (const { name, text } of [...scenes, { name: 'the first scene', text: firstScene('ru') }]) {
        const [mine, other] = [alone, whole].map((core) => {
            check(core.open(text) && core.render(1), name);
            return [core.samples().values, core.probe(12, 34)];
        });
        check(Buffer.from(mine[0].buffer).equals(Buffer.from(other[0].buffer)), `${name} has other samples`);
        equal(mine[1], other[1], `probe of ${name}`);
    }
}

/** Scenes that each name one of the files that the core brings, whose bytes come with the second part. */
const NAMING_FILES = ['knot.ply', 'pot.ply', 'office-lamp.ies'].map((name) =>
    name.endsWith('.ply')
        ? MESH.replace('builtin:pot.ply', `builtin:${name}`).replace(/lights: .*/, 'lights: [{type: ambient, irradiance: 1}]')
        : MESH.replace(/surfaces: .*/, 'surfaces: [{type: sphere, center: [0, 0, 300], radius: 250}]'),
);

/** Lamps whose colours are found by the colour-matching functions, which come with the second part. */
const COLOURED = ['temperature: 3000', 'xy: [0.31, 0.33]'].map((colour) =>
    `luxel: 1\nchannels: rgb\nunits: photometric\nscreen: {width: 700, height: 700, resolution: [60, 60]}\nobserver: {z: 1700}\nsurfaces: [{type: sphere, center: [0, 0, 300], radius: 250}]\nlights: [{type: point, position: [420, 300, 1250], intensity: 9, color: {${colour}}}]\n`,
);

async function refusesWhatIsMissing({ first, second, Core, PartMissing }, folder) {
    for (const text of [MESH, ...NAMING_FILES, ...COLOURED]) {
        const alone = await Core.start(first);
        let thrown = null;
        try {
            alone.open(text);
        } catch (error) {
            thrown = error;
        }
        check(thrown instanceof PartMissing, `instead of a refusal: ${thrown}, ${JSON.stringify(alone.messages())}`);
    }
    const pot = fs.readFileSync(new URL('../../data/files/pot.ply', import.meta.url)).subarray(-500);
    const holds = PARTS.map((name) => fs.readFileSync(path.join(folder, name)).includes(pot));
    equal(holds, [false, true], 'whether the parts hold a mesh');
    // A core that was not given up takes the second part while it lives.
    const late = await Core.start(first);
    check(late.open(late.builtins()[0].text) && late.render(1), 'the first part alone');
    late.complete(second);
    check(late.open(MESH) && late.render(1), JSON.stringify(late.messages()));
    const whole = await Core.start(first, second);
    check(whole.open(MESH) && whole.render(1), JSON.stringify(whole.messages()));
    equal(late.probe(20, 30), whole.probe(20, 30), 'probe');
    for (const text of [...NAMING_FILES, ...COLOURED]) check(whole.open(text) && whole.render(8), JSON.stringify(whole.messages()));
}

/** A part of another build is told from this one's. */
function belong({ first, second, belongTogether }, folder) {
    check(belongTogether(first, second), 'the parts do not know each other');
    const bytes = fs.readFileSync(path.join(folder, PARTS[1]));
    bytes[bytes.length - 1] ^= 1;
    check(!belongTogether(first, new WebAssembly.Module(bytes)), 'a part of another core is taken');
    const unsigned = new WebAssembly.Module(fs.readFileSync(path.join(folder, 'core/web/core/luxel-core.wasm')));
    check(!belongTogether(unsigned, unsigned), 'parts without a sign are taken');
}

export async function parts(folder) {
    const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-parts-'));
    try {
        await test('the core is small', () => areSmall(folder));
        await test('the same core gives the same parts', () => areRepeated(folder, scratch));
        const both = await partsOf(folder);
        await test('the first part makes the first pictures alone', () => beginsAlone(both));
        await test('what the first part lacks is refused until it is there', () => refusesWhatIsMissing(both, folder));
        await test('parts of other builds are refused', () => belong(both, folder));
    } finally {
        fs.rmSync(scratch, { recursive: true });
    }
}
