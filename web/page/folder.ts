// SPDX-License-Identifier: MIT
// The memory folder: the files that scenes name, given by the user, as the core's calls of the system see them.  It can
// only be read.  A file is found by its whole name or, as browsers tell no folders, by the last part of it.

const FAULT = { badFile: 8, noSuchFile: -44 }; // EBADF as WASI has it, ENOENT as the system does
const REGULAR = 0o100444; // a file that everybody may read

// Where emscripten's struct stat has what the core looks at.
const STAT = { bytes: 88, mode: 12, links: 16, size: 40, inode: 80 };

interface Kept {
    bytes: Uint8Array;
    inode: number;
}

export function lastPart(name: string): string {
    return name.slice(name.lastIndexOf('/') + 1);
}

export class Folder {
    private readonly kept = new Map<string, Kept>();
    private readonly opened = new Map<number, { bytes: Uint8Array; at: number }>();
    private nextFile = 3;
    private nextInode = 1;
    /** Which files were opened. */
    readonly readings = new Set<string>();
    /** The names that were asked for, and whether they were found. */
    readonly asked = new Map<string, boolean>();

    constructor(private readonly memory: () => ArrayBuffer) {}

    put(name: string, bytes: Uint8Array) {
        this.kept.set(name, { bytes, inode: this.nextInode++ });
    }

    // What begins so is in the core itself.
    private note(path: string, isFound: boolean) {
        if (path && !path.startsWith('builtin:')) this.asked.set(path, isFound);
    }

    private find(path: string): Kept | undefined {
        return this.kept.get(path) ?? this.kept.get(lastPart(path));
    }

    open(path: string): number {
        const found = this.find(path);
        this.note(path, found !== undefined);
        if (!found) return FAULT.noSuchFile;
        this.readings.add(path);
        this.opened.set(this.nextFile, { bytes: found.bytes, at: 0 });
        return this.nextFile++;
    }

    close(file: number): number {
        return this.opened.delete(file) ? 0 : FAULT.badFile;
    }

    /** Writes what is known of a file; false: there is none such. */
    private describe(at: number, bytes: Uint8Array, inode: number) {
        const view = new DataView(this.memory(), at, STAT.bytes);
        for (let i = 0; i < STAT.bytes; i += 4) view.setUint32(i, 0, true);
        view.setUint32(STAT.mode, REGULAR, true);
        view.setUint32(STAT.links, 1, true);
        view.setBigUint64(STAT.size, BigInt(bytes.length), true);
        view.setBigUint64(STAT.inode, BigInt(inode), true);
        return 0;
    }

    // The core asks for the state of a file before it reads it, and of those that it has read already.
    state(path: string, at: number): number {
        const found = this.find(path);
        this.note(path, found !== undefined);
        return found ? this.describe(at, found.bytes, found.inode) : FAULT.noSuchFile;
    }

    stateOfOpen(file: number, at: number): number {
        const found = this.opened.get(file);
        return found ? this.describe(at, found.bytes, file) : -FAULT.badFile;
    }

    /** Reads to a list of places in memory, from an offset or (null) from where the last reading ended. */
    read(file: number, places: number, count: number, from: bigint | null, done: number): number {
        const found = this.opened.get(file);
        if (!found) return FAULT.badFile;
        const view = new DataView(this.memory());
        let at = from === null ? found.at : Number(from);
        const start = at;
        for (let i = 0; i < count; i++) {
            const place = view.getUint32(places + 8 * i, true);
            const length = view.getUint32(places + 8 * i + 4, true);
            const part = found.bytes.subarray(at, at + length);
            new Uint8Array(view.buffer).set(part, place);
            at += part.length;
        }
        if (from === null) found.at = at;
        view.setUint32(done, at - start, true);
        return 0;
    }
}
