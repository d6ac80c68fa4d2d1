// SPDX-License-Identifier: MIT
// The core's numbers are the tool's: every built-in scene, as this machine's kernels of 128 bits compute it, and the
// files that hold it.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { coloursOfCore } from './colour_numbers.mjs';
import { check, equal, test } from './tap.mjs';

const HEADER = 128; // bytes of an .npy file before its numbers

function native(tool, folder, scene, arguments_) {
    return execFileSync(tool, ['render', scene, ...arguments_], {
        cwd: folder,
        env: { ...process.env, LUXEL_ISA: process.arch === 'x64' ? 'x86-64' : 'generic', LC_ALL: 'C' },
        stdio: ['ignore', 'pipe', 'pipe'],
    });
}

function floats(bytes) {
    return new Float32Array(bytes.buffer.slice(bytes.byteOffset + HEADER, bytes.byteOffset + bytes.length));
}

/** The largest difference in units of the picture's maximum. */
function difference(a, b) {
    equal(a.length, b.length, 'numbers');
    let most = 0;
    let greatest = 0;
    for (let i = 0; i < a.length; i++) {
        const off = Math.abs(a[i] - b[i]);
        if (!(off <= most)) most = off; // NaN is off, too
        greatest = Math.max(greatest, Math.abs(b[i]));
    }
    return most / greatest;
}

async function compareScene(core, tool, folder, builtin) {
    check(core.open(builtin.text, builtin.name), JSON.stringify(core.messages()));
    const bytes = core.file('scene.npy');
    check(bytes, JSON.stringify(core.messages()));
    native(tool, folder, builtin.name, ['-o', 'scene.npy']);
    const truth = fs.readFileSync(path.join(folder, 'scene.npy'));
    if (truth.equals(Buffer.from(bytes))) return 'the same bytes';
    equal(Buffer.from(bytes.slice(0, HEADER)).toString(), truth.subarray(0, HEADER).toString(), 'header');
    const off = difference(floats(bytes), floats(truth));
    check(off <= 2e-6, `${off} of the maximum off`);
    return `within ${off.toExponential(1)} of the maximum`;
}

async function compareFiles(core, tool, folder, builtin, ending) {
    core.open(builtin.text, builtin.name);
    const bytes = core.file(`scene${ending}`);
    check(bytes, JSON.stringify(core.messages()));
    native(tool, folder, builtin.name, ['-o', `scene${ending}`]);
    const truth = fs.readFileSync(path.join(folder, `scene${ending}`));
    check(truth.equals(Buffer.from(bytes)), `${bytes.length} other bytes than the ${truth.length} of the tool`);
}

const STAGED = ['sphere', 'three-lights', 'desk', 'room', 'pot'];

/** What another camera sees is the tool's picture by an observer there; each pixel is as far as what the probe meets. */
function stages(core, tool, folder, builtin) {
    const [columns, rows] = [48, 32];
    const upright = builtin.text.includes('type: room');
    const [eye, target] = upright ? [[5000, 4000, 9000], [0, 1200, 2500]] : [[900, -2600, 1900], [0, 0, 300]];
    const up = upright ? [0, 1, 0] : [0, 0, 1];
    const [width, height] = upright ? [7200, 4800] : [1800, 1200];
    const camera = [...eye, ...target, ...up, width, height];
    check(core.open(builtin.text), JSON.stringify(core.messages()));
    core.render(4);
    const before = core.samples().values;
    const seen = core.stage(camera, columns, rows);
    check(seen, JSON.stringify(core.messages()));
    const depth = core.stageDepth(camera, columns, rows);
    check(Buffer.from(before.buffer).equals(Buffer.from(core.samples().values.buffer)), 'the picture is another one');
    native(tool, folder, builtin.name, [
        '-s',
        `observer={position: [${eye}], target: [${target}], up: [${up}], projection: perspective}`,
        '-s',
        `screen={width: ${width}, height: ${height}, resolution: [${columns}, ${rows}]}`,
        '-o',
        'stage.npy',
    ]);
    const truth = floats(fs.readFileSync(path.join(folder, 'stage.npy')));
    const masked = [...seen.mask].flatMap((is, i) => (is ? [i] : []));
    check(masked.length > 20, `${masked.length} pixels show bodies`);
    const off = difference(masked.map((i) => seen.values[i]), masked.map((i) => truth[i]));
    check(off <= 2e-6, `${off} of the maximum off`);
    const back = eye.map((c, i) => c - target[i]);
    const far = Math.hypot(...back);
    for (const i of masked.filter((_, k) => k % 97 === 0)) {
        const at = [(((i % columns) + 0.5) / columns - 0.5) * width, (0.5 - (Math.floor(i / columns) + 0.5) / rows) * height];
        const probe = core.stageProbe(camera, columns, rows, ...at);
        check(Math.abs(probe.value - seen.values[i]) <= 1e-4 * Math.abs(probe.value) + 1e-6, `probe at ${at}: ${probe.value}`);
        const along = probe.position.reduce((sum, c, k) => sum + ((eye[k] - c) * back[k]) / far, 0);
        check(Math.abs(along - depth[i]) < 1e-3 * far, `${depth[i]} instead of ${along} mm`);
    }
    if (builtin.name === 'sphere')
        equal(core.stage([...target, ...eye, ...up, width, height], columns, rows), null, 'what is seen from inside of a body');
    return `${masked.length} pixels`;
}

const LAMP = 'IESNA91\nTILT=NONE\n1 800 1 3 1 1 2 .1 .1 0 1 1 20\n0 45 90 0 300 200 0\n';
const CLOUD = 'x,y,z,intensity\n300,200,1500,4\n-400,0,1700,6\n';
const NAMING = `luxel: 1
screen: {width: 700, height: 700, resolution: [90, 90]}
observer: {z: 1700, projection: orthographic, view: parallel}
surfaces:
  - {type: mesh, file: models/knot.ply, scale: 2, position: [0, 0, 300]}
lights:
  - {type: luminaire, file: lamp.ies, position: [420, 300, 1250]}
  - {type: points, file: cloud.csv}
`;

const POT = `luxel: 1
screen: {width: 700, height: 700, resolution: [90, 90]}
observer: {z: 1700}
surfaces: [{type: mesh, file: 'builtin:pot.ply', position: [0, 0, 300]}]
lights: [{type: luminaire, file: 'builtin:office-lamp.ies', position: [420, 300, 1250]}]
`;

/** Files that the core brings are there without being given, and none of them is asked for. */
function namesOwnFiles(core, tool, folder) {
    check(core.open(POT), JSON.stringify(core.messages()));
    equal(
        [...core.folder.asked.keys()].filter((name) => name.includes('builtin')),
        [],
        'files that are asked for',
    );
    fs.writeFileSync(path.join(folder, 'pot.yaml'), POT);
    const told = compareScene(core, tool, folder, { name: 'pot.yaml', text: POT });
    check(!core.open(POT.replace('pot.ply', 'pan.ply')), 'one that there is not was taken');
    equal(
        core.messages().map(({ key }) => key),
        ['surfaces[0].file'],
        'keys',
    );
    return told;
}

/** Light between surfaces: the tool's numbers, with the bound of what is left out. */
async function reflects(core, tool, folder, builtin) {
    const text = builtin.text.replace(/^luxel: 1$/m, 'luxel: 1\nreflections: 2').replace(/resolution: .*\]/, 'resolution: [50, 40]');
    check(core.open(text), JSON.stringify(core.messages()));
    check(core.render(1), JSON.stringify(core.messages()));
    const { reflected, reached } = core.picture();
    check(reflected > 0 && reflected <= 1e-3 && reached, JSON.stringify(core.picture()));
    fs.writeFileSync(path.join(folder, 'reflections.yaml'), text);
    return compareScene(core, tool, folder, { name: 'reflections.yaml', text });
}

/** A scene that names files: each that is missing is told by its name, and with all of them the numbers are the tool's. */
async function namesFiles(core, tool, folder) {
    const files = { 'knot.ply': fs.readFileSync(MESH), 'lamp.ies': LAMP, 'cloud.csv': CLOUD };
    check(!core.open(NAMING), 'a scene without its files was taken');
    equal(
        core.messages().map(({ key }) => key),
        ['surfaces[0].file', 'lights[0].file', 'lights[1].file'],
        'keys',
    );
    equal([...core.folder.asked.values()], [false, false, false], 'found');
    fs.mkdirSync(path.join(folder, 'models'));
    for (const [name, content] of Object.entries(files)) {
        core.folder.put(name, Buffer.from(content));
        fs.writeFileSync(path.join(folder, name === 'knot.ply' ? `models/${name}` : name), content);
    }
    fs.writeFileSync(path.join(folder, 'naming.yaml'), NAMING);
    check(core.open(NAMING), JSON.stringify(core.messages()));
    const { readings } = core.folder;
    readings.clear();
    check(core.open(NAMING.replace('420', '421')), 'another place of the lamp');
    check(!readings.has('models/knot.ply'), 'a mesh that has not changed is read anew');
    return compareScene(core, tool, folder, { name: 'naming.yaml', text: NAMING });
}

function judgeMistakes(core) {
    check(!core.open('luxel: 1\nlights:\n  - {type: pont}\n'), 'a wrong scene was taken');
    const message = core.messages().find((entry) => entry.key === 'lights[0].type');
    check(message && message.line === 3 && message.column === 12, JSON.stringify(core.messages()));
    check(core.scene() !== null, 'the last whole scene is gone');
}

function editKeepsComments(core, builtin) {
    const changed = core.edit(builtin.text, [{ set: 'lights[0].intensity=20' }]);
    equal(changed, builtin.text.replace('intensity: 10', 'intensity: 20'), 'text');
    equal(core.edit(builtin.text, [{ set: 'nowhere=1' }]), null, 'a change that does not go');
}

function probesAgree(core, tool, builtin) {
    core.open(builtin.text, builtin.name);
    const probe = core.probe(150, 0);
    const answer = JSON.parse(execFileSync(tool, ['probe', builtin.name, '-p', '150,0', '--json']));
    equal(probe.value, answer.points[0].value, 'value');
    equal(probe.shares.length, 1, 'shares');
}

const MESH = new URL('../../examples/meshes/knot.ply', import.meta.url);

/** Tries the core; of the built-in scenes those with these names, or all. */
export async function numbers(core, tool, names = null) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-web-'));
    const builtins = core.builtins();
    try {
        for (const builtin of builtins.filter(({ name }) => !names || names.includes(name)))
            await test(`numbers of ${builtin.name}`, () => compareScene(core, tool, folder, builtin));
        for (const ending of ['.png', '.csv', '.npy', '.pfm'])
            await test(`the tool's bytes in ${ending}`, () => compareFiles(core, tool, folder, builtins[0], ending));
        await test('levels, channels and colours of a scene in colour', () =>
            coloursOfCore(core, tool, folder, builtins.find(({ name }) => name === 'warm-and-cold')));
        await test('files that a scene names', () => namesFiles(core, tool, folder));
        await test('files that the core brings', () => namesOwnFiles(core, tool, folder));
        for (const builtin of builtins.filter(({ name }) => STAGED.includes(name)))
            await test(`what another camera sees of ${builtin.name}`, () => stages(core, tool, folder, builtin));
        if (!names)
            await test('light between surfaces', () =>
                reflects(core, tool, folder, builtins.find(({ name }) => name === 'two-spheres')));
        await test('mistakes are told in place, and the last whole scene stays', () => judgeMistakes(core));
        await test('a change leaves all else of the text', () => editKeepsComments(core, builtins[0]));
        await test('a probe gives the number of the tool', () => probesAgree(core, tool, builtins[0]));
    } finally {
        fs.rmSync(folder, { recursive: true });
    }
}
