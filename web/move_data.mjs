// SPDX-License-Identifier: MIT
// Moves data of one module of WebAssembly to another that has the same memory: what only the second part of the core reads
// is not to be waited for with the first.
import fs from 'node:fs';

const [CODE, DATA, COUNT] = [10, 11, 12]; // sections
const HEAD = 8; // bytes before the first section
const [CONSTANT, END] = [0x41, 0x0b]; // of an address

/** A reader of the numbers and bytes of a module. */
class Reader {
    at = 0;

    constructor(bytes) {
        this.bytes = bytes;
    }

    get isOver() {
        return this.at >= this.bytes.length;
    }

    byte() {
        return this.bytes[this.at++];
    }

    take(length) {
        this.at += length;
        return this.bytes.subarray(this.at - length, this.at);
    }

    // Addresses are written with a sign, which none has: so they are read alike.
    number() {
        let [sum, scale] = [0, 1];
        for (;;) {
            const byte = this.byte();
            sum += (byte & 127) * scale;
            if (byte < 128) return sum;
            scale *= 128;
        }
    }
}

/** A number as modules write it; where a sign is possible the last byte leaves room for it. */
function written(number, hasSign = false) {
    const bytes = [];
    for (let rest = number; ; rest = Math.floor(rest / 128)) {
        const isLast = rest < (hasSign ? 64 : 128);
        bytes.push((rest % 128) | (isLast ? 0 : 128));
        if (isLast) return Buffer.from(bytes);
    }
}

function sectionsOf(bytes) {
    const reader = new Reader(bytes.subarray(HEAD));
    const sections = [];
    while (!reader.isOver) {
        const id = reader.byte();
        sections.push({ id, content: reader.take(reader.number()) });
    }
    return sections;
}

function moduleOf(head, sections) {
    return Buffer.concat([head, ...sections.flatMap(({ id, content }) => [Buffer.from([id]), written(content.length), content])]);
}

/** The pieces of memory that a data section fills at the start. */
function segmentsOf(content) {
    const reader = new Reader(content);
    return Array.from({ length: reader.number() }, () => {
        if (reader.byte() !== 0 || reader.byte() !== CONSTANT) throw new Error('its data are not at fixed addresses');
        const from = reader.number();
        if (reader.byte() !== END) throw new Error('its data are not at fixed addresses');
        return { from, bytes: reader.take(reader.number()) };
    });
}

function dataSection(segments) {
    const parts = segments.flatMap(({ from, bytes }) => [
        Buffer.from([0, CONSTANT]),
        written(from, true),
        Buffer.from([END]),
        written(bytes.length),
        bytes,
    ]);
    return { id: DATA, content: Buffer.concat([written(segments.length), ...parts]) };
}

/** Where bytes lie in what the segments fill, which leave out zeros; -1: nowhere. */
function addressOf(segments, bytes) {
    const memory = Buffer.alloc(Math.max(...segments.map(({ from, bytes: { length } }) => from + length)));
    for (const { from, bytes: content } of segments) content.copy(memory, from);
    return memory.indexOf(bytes);
}

/** Moves data from one file's module to another's. */
export function moveData(source, target, contents) {
    const [from, to] = [source, target].map((file) => fs.readFileSync(file));
    const sections = sectionsOf(from);
    const data = sections.findIndex(({ id }) => id === DATA);
    const segments = segmentsOf(sections[data].content);
    const ranges = contents.map((content) => {
        const address = addressOf(segments, content);
        if (address < 0) throw new Error(`data of ${content.length} bytes are not in it`);
        return [address, address + content.length];
    });
    // Each segment is cut where a range begins and ends.
    const isMoved = (at) => ranges.some(([first, end]) => at >= first && at < end);
    const pieces = segments.flatMap(({ from, bytes }) => {
        const end = from + bytes.length;
        const cuts = [from, ...ranges.flat().filter((at) => at > from && at < end).sort((a, b) => a - b), end];
        return cuts.slice(1).map((cut, i) => ({ from: cuts[i], bytes: bytes.subarray(cuts[i] - from, cut - from) }));
    });
    const [kept, moved] = [false, true].map((is) => pieces.filter(({ from }) => isMoved(from) === is));
    sections[data] = dataSection(kept);
    for (const section of sections) if (section.id === COUNT) section.content = written(kept.length);
    const others = sectionsOf(to);
    if (others.some(({ id }) => id === DATA || id === COUNT)) throw new Error('the other part has data of its own');
    others.splice(others.findIndex(({ id }) => id === CODE) + 1, 0, dataSection(moved));
    fs.writeFileSync(source, moduleOf(from.subarray(0, HEAD), sections));
    fs.writeFileSync(target, moduleOf(to.subarray(0, HEAD), others));
}
