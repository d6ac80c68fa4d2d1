// SPDX-License-Identifier: MIT
// The archive of a package, as `npm pack` makes it but for the order and the dates, which are always the same, so that
// the same files give the same bytes.
import fs from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';

const BLOCK = 512;

/** All files of a folder, as paths with slashes, in the order of their names. */
function filesOf(folder, under = '') {
    return fs
        .readdirSync(path.join(folder, under), { withFileTypes: true })
        .sort((a, b) => (a.name < b.name ? -1 : 1))
        .flatMap((entry) => (entry.isDirectory() ? filesOf(folder, `${under}${entry.name}/`) : [under + entry.name]));
}

function header(name, size, seconds) {
    const block = Buffer.alloc(BLOCK);
    const octal = (number, length) => `${number.toString(8).padStart(length - 1, '0')}\0`;
    block.write(name, 0, 100);
    block.write(octal(0o644, 8) + octal(0, 8) + octal(0, 8) + octal(size, 12) + octal(seconds, 12), 100);
    block.write('        0', 148); // blanks where the sum will stand, and the type of files
    block.write('ustar\x0000', 257);
    const sum = block.reduce((all, byte) => all + byte, 0);
    block.write(`${octal(sum, 7)} `, 148);
    return block;
}

export function pack(folder) {
    const seconds = Number(process.env.SOURCE_DATE_EPOCH ?? 499162500); // the date that npm gives
    const parts = filesOf(folder).flatMap((name) => {
        const content = fs.readFileSync(path.join(folder, name));
        return [header(`package/${name}`, content.length, seconds), content, Buffer.alloc(-content.length & (BLOCK - 1))];
    });
    return gzipSync(Buffer.concat([...parts, Buffer.alloc(2 * BLOCK)]), { level: 9 });
}
