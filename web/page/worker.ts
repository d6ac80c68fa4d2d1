// SPDX-License-Identifier: MIT
// The worker: the core, and the questions of the page to it in the order in which they come.
import { Core, CoreFailure, type Change } from './core';
import { lastPart } from './folder';

export interface Picture {
    facts: ReturnType<Core['picture']>;
    values: Float32Array<ArrayBuffer>;
    mask: Uint8Array<ArrayBuffer>;
    stride: number;
    text: string; // of its scene
    milliseconds: number;
}

let core: Core;
let openText: string | null = null;

function open(text: string) {
    if (text === openText) return true;
    core.folder.asked.clear();
    const whole = core.open(text);
    openText = whole ? text : null;
    return whole;
}

const questions = {
    async start(module: WebAssembly.Module, words: Record<string, string>, files: Map<string, Uint8Array>) {
        core = await Core.start(module);
        core.translate(words);
        for (const [name, bytes] of files) core.folder.put(name, bytes);
        return core.builtins();
    },
    /** Puts a file that scenes name into the folder, in place of an older one. */
    give(name: string, bytes: Uint8Array) {
        core.folder.put(name, bytes);
        openText = null;
    },
    translate(words: Record<string, string>) {
        core.translate(words);
        return core.builtins();
    },
    parameters: () => core.parameters(),
    /** Judges a text; what it holds where it is whole, and the files that it names: whether each is there. */
    judge(text: string, irradiance: boolean) {
        openText = null;
        core.quantity(irradiance);
        const whole = open(text);
        const messages = core.messages();
        // Those that the scene before named are looked at, too.
        const files = [...core.folder.asked].filter(([name, found]) => !found || text.includes(lastPart(name)));
        return { whole, messages, scene: whole ? core.scene() : null, files };
    },
    /** Computes a picture of a text that was found to be whole, or of each n-th pixel. */
    render(text: string, irradiance: boolean, stride: number): Picture | { messages: ReturnType<Core['messages']> } {
        core.quantity(irradiance);
        if (!open(text)) return { messages: core.messages() };
        const before = performance.now();
        if (!core.render(stride)) return { messages: core.messages() };
        const milliseconds = performance.now() - before;
        return { facts: core.picture(), ...core.samples(), stride, text, milliseconds };
    },
    probe: (x: number, y: number) => core.probe(x, y),
    table: (points: number[][]) => points.map(([x, y]) => core.probe(x, y)),
    explain: (x: number, y: number, format: number, language: string) => core.explain(x, y, format, language),
    section: (x: number, y: number, degrees: number, samples: number) => core.section(x, y, degrees, samples),
    sectionBetween: (from: number[], to: number[], samples: number) => core.sectionBetween(from, to, samples),
    summary: () => core.summary(),
    balance: (text: string) => (open(text) ? core.balance() : null),
    version: () => core.version(),
    isophotes: (wanted: number, logarithmic: boolean) => core.isophotes(wanted, logarithmic),
    extrema: () => core.extrema(),
    values: (keys: string[]) => keys.map((key) => core.get(key)),
    relief: (text: string, surface: number, eye: number[], up: number[], pixels: number) =>
        open(text) ? core.relief(surface, eye, up, pixels) : null,
    silhouette: (text: string, surface: number, right: number[], up: number[]) =>
        open(text) ? core.silhouette(surface, right, up) : null,
    project: (places: number[][]) => places.map((place) => core.project(place)),
    unproject: (x: number, y: number, height: number) => core.unproject(x, y, height),
    edit: (text: string | Uint8Array, changes: Change[]) => {
        const changed = core.edit(text, changes);
        return { text: changed, messages: changed === null ? core.messages() : [] };
    },
    file: (name: string) => {
        const bytes = core.file(name);
        return { bytes, messages: bytes ? [] : core.messages() };
    },
    /** Ends the core as a fault in it would, for the test of what the page does then. */
    crash: () => {
        throw new CoreFailure('asked for');
    },
};

export type Questions = typeof questions;

self.onmessage = async ({ data: { id, name, arguments: values } }) => {
    try {
        const answer = await (questions[name as keyof Questions] as (...values: unknown[]) => unknown)(...values);
        self.postMessage({ id, answer });
    } catch (error) {
        // Whatever ended the core has left its memory in no known state.
        self.postMessage({ id, failure: String(error) });
    }
};
