// SPDX-License-Identifier: MIT
// The picture that a link to the page is shown by elsewhere (Open Graph): node card.mjs FOLDER CARD.png.  The core in FOLDER computes
// it, in the page's own colours; it is made anew when the core has changed.
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { compiled, coreModule, moduleOf } from './node_core.mjs';

const SCENE = 'pot';
const [COLUMNS, ROWS] = [600, 315]; // the least that is shown large
const WIDTH = 1250; // mm of the screen

// The sum that PNG has of each of its parts.
function crc32(bytes) {
    let sum = ~0;
    for (const byte of bytes) {
        sum ^= byte;
        for (let bit = 0; bit < 8; bit++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return ~sum >>> 0;
}

function chunk(type, content) {
    const named = Buffer.concat([Buffer.from(type), content]);
    const framed = Buffer.alloc(named.length + 8);
    framed.writeUInt32BE(content.length, 0);
    named.copy(framed, 4);
    framed.writeUInt32BE(crc32(named), named.length + 4);
    return framed;
}

/** A PNG file of pixels of four bytes, without the fourth. */
function png(pixels, columns, rows) {
    const lines = Buffer.alloc(rows * (3 * columns + 1));
    for (let i = 0, at = 0; i < rows * columns; i++) {
        if (i % columns === 0) lines[at++] = 0;
        for (let k = 0; k < 3; k++) lines[at++] = pixels[4 * i + k];
    }
    const head = Buffer.alloc(13);
    head.writeUInt32BE(columns, 0);
    head.writeUInt32BE(rows, 4);
    head.set([8, 2, 0, 0, 0], 8);
    const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
    return Buffer.concat([signature, chunk('IHDR', head), chunk('IDAT', zlib.deflateSync(lines, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}

async function picture(folder) {
    const [first, second] = await Promise.all(['luxel-core.wasm', 'luxel-core-2.wasm'].map((name) => compiled(path.join(folder, name))));
    const core = await (await coreModule()).Core.start(first, second);
    const { paint } = await moduleOf('page/colours.ts');
    const { text } = core.builtins().find(({ name }) => name === SCENE);
    const screen = `screen={width: ${WIDTH}, height: ${(WIDTH * ROWS) / COLUMNS}, resolution: [${COLUMNS}, ${ROWS}]}`;
    const wide = core.edit(text, [{ set: screen }]);
    if (!core.open(wide) || !core.render(1)) throw new Error(JSON.stringify(core.messages()));
    const { values, mask } = core.samples();
    const bright = [...values].sort((a, b) => a - b)[Math.floor(0.995 * values.length)];
    return png(paint(values, mask, { map: 'tone', logarithmic: false, locked: true, low: 0, high: bright, exposure: 0 }), COLUMNS, ROWS);
}

const [folder, target] = process.argv.slice(2);
const isNew = fs.existsSync(target) && fs.statSync(target).mtimeMs > fs.statSync(path.join(folder, 'luxel-core-2.wasm')).mtimeMs;
if (!isNew) fs.writeFileSync(target, await picture(folder));
