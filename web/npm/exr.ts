// SPDX-License-Identifier: MIT
// EXR pictures, which the core has no library for: scan lines of float32 that are not compressed, and the tags of the
// PNG picture as attributes of type string.  They have the bytes that the tool writes.
import type { Field } from './results';

const CHROMATICITIES = [0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329];
const LEADER = 8; // bytes before each line: its row and its length

/** The texts that a PNG picture carries, in their order. */
export function tagsOf(png: Uint8Array): [string, Uint8Array][] {
    const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
    const tags: [string, Uint8Array][] = [];
    for (let at = 8; at < png.length; at += 12 + view.getUint32(at)) {
        const length = view.getUint32(at);
        if (String.fromCharCode(...png.subarray(at + 4, at + 8)) !== 'iTXt') continue;
        const content = png.subarray(at + 8, at + 8 + length);
        const end = content.indexOf(0);
        const language = end + 3; // behind whether and how it is compressed, which it is not
        const translated = content.indexOf(0, language) + 1;
        const key = String.fromCharCode(...content.subarray(0, end));
        tags.push([key, content.subarray(content.indexOf(0, translated) + 1)]);
    }
    return tags;
}

class Writer {
    private readonly parts: Uint8Array[] = [];
    length = 0;

    bytes(part: Uint8Array) {
        this.parts.push(part);
        this.length += part.length;
    }

    text(text: string) {
        this.bytes(new TextEncoder().encode(`${text}\0`));
    }

    whole(...numbers: number[]) {
        this.bytes(new Uint8Array(Int32Array.from(numbers).buffer));
    }

    attribute(name: string, type: string, content: Uint8Array) {
        this.text(name);
        this.text(type);
        this.whole(content.length);
        this.bytes(content);
    }

    joined(): Uint8Array {
        const all = new Uint8Array(this.length);
        let at = 0;
        for (const part of this.parts) {
            all.set(part, at);
            at += part.length;
        }
        return all;
    }
}

const floats = (...numbers: number[]) => new Uint8Array(Float32Array.from(numbers).buffer);
const wholes = (...numbers: number[]) => new Uint8Array(Int32Array.from(numbers).buffer);

function channelList(names: string[]): Uint8Array {
    const list = new Writer();
    for (const name of names) {
        list.text(name);
        list.whole(2, 0, 1, 1); // float, perceptually logarithmic, every column and row
    }
    list.bytes(Uint8Array.of(0));
    return list.joined();
}

function header(field: Field, names: string[], tags: [string, Uint8Array][]): Writer {
    const file = new Writer();
    const box = wholes(0, 0, field.columns - 1, field.rows - 1);
    file.bytes(Uint8Array.of(0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0));
    file.attribute('type', 'string', new TextEncoder().encode('scanlineimage'));
    file.attribute('compression', 'compression', Uint8Array.of(0));
    file.attribute('dataWindow', 'box2i', box);
    file.attribute('displayWindow', 'box2i', box);
    file.attribute('lineOrder', 'lineOrder', Uint8Array.of(0));
    file.attribute('pixelAspectRatio', 'float', floats(1));
    file.attribute('screenWindowCenter', 'v2f', floats(0, 0));
    file.attribute('screenWindowWidth', 'float', floats(1));
    file.attribute('channels', 'chlist', channelList(names));
    if (field.rgb) file.attribute('chromaticities', 'chromaticities', floats(...CHROMATICITIES));
    for (const [key, content] of tags) file.attribute(key, 'string', content);
    file.bytes(Uint8Array.of(0));
    return file;
}

/** The bytes of the picture with its tags. */
export function exr(field: Field, tags: [string, Uint8Array][]): Uint8Array {
    const names = field.rgb ? ['B', 'G', 'R'] : ['Y'];
    const { columns, rows } = field;
    const size = 4 * columns * names.length;
    const file = header(field, names, tags);
    const first = file.length + 8 * rows;
    const table = new BigUint64Array(rows).map((_, row) => BigInt(first + row * (LEADER + size)));
    file.bytes(new Uint8Array(table.buffer));
    for (let row = 0; row < rows; row++) {
        const line = new Float32Array(columns * names.length);
        for (let i = 0; i < columns; i++) {
            const pixel = row * columns + i;
            if (field.rgb) for (let c = 0; c < 3; c++) line[c * columns + i] = field.rgb[3 * pixel + 2 - c];
            else line[i] = field.values[pixel];
        }
        file.whole(row, size);
        file.bytes(new Uint8Array(line.buffer));
    }
    return file.joined();
}
