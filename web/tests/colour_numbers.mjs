// SPDX-License-Identifier: MIT
// The core's answers about colours: levels are those of the tool's file, channels and colours those of its answers.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { check, equal } from './tap.mjs';

/** A point of the scene warm-and-cold on the wall. */
export const POINT = [-120, 40];

/** The levels of an RGB picture of 8 bits whose rows have no filter. */
function levelsOf(png) {
    const parts = [];
    for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
        if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
    const width = 3 * png.readUInt32BE(16);
    const rows = zlib.inflateSync(Buffer.concat(parts));
    return Buffer.concat(Array.from({ length: png.readUInt32BE(20) }, (_, i) => {
        equal(rows[i * (width + 1)], 0, 'filter');
        return rows.subarray(i * (width + 1) + 1, (i + 1) * (width + 1));
    }));
}

/** What the tool answers. */
export function told(tool, ...words) {
    const env = { ...process.env, LC_ALL: 'C' };
    return JSON.parse(execFileSync(tool, [...words, '--json'], { env, stdio: ['ignore', 'pipe', 'pipe'] }));
}

/** The core's answers about colours. */
export function coloursOfCore(core, tool, folder, builtin) {
    check(core.open(builtin.text, builtin.name), JSON.stringify(core.messages()));
    check(core.render(1), JSON.stringify(core.messages()));
    const { rgb, levels, values } = core.samples();
    const file = path.join(folder, 'colour.png');
    const env = { ...process.env, LUXEL_ISA: process.arch === 'x64' ? 'x86-64' : 'generic' };
    execFileSync(tool, ['render', builtin.name, '-q', '-o', file], { env, stdio: 'ignore' });
    check(levelsOf(fs.readFileSync(file)).equals(Buffer.from(levels)), 'the levels are not those of the file');
    const y = 0.2126390058715 * rgb[300] + 0.7151686787678 * rgb[301] + 0.0721923153607 * rgb[302];
    check(Math.abs(y - values[100]) < 1e-5 * core.picture().maximum.value, 'the values are not the luminance');
    const found = core.color(...POINT);
    const [probe] = told(tool, 'probe', builtin.name, '-p', POINT.join()).points;
    for (let c = 0; c < 3; c++) check(Math.abs(found.rgb[c] - probe.rgb.value[c]) <= 1e-12 * probe.value, `channel ${c}`);
    check(Math.abs(found.cct - probe.cct) < 1e-3 && Math.abs(found.xy[0] - probe.xy[0]) < 1e-9, JSON.stringify(found));
    for (const channel of ['red', 'blue', 'cct']) {
        core.view(channel);
        check(core.render(1) && !core.samples().rgb, 'a view has channels');
        const { max } = told(tool, 'stats', builtin.name, '--channel', channel);
        const { maximum } = core.picture();
        check(Math.abs(maximum.value - max.value) < 4e-6 * max.value, `${channel}: ${maximum.value}, not ${max.value}`);
    }
    core.view('luminance');
    equal(core.lightColors().length, 2, 'colours of lights');
}
