// SPDX-License-Identifier: MIT
// The worker: the core, and the questions of the page to it in the order in which they come.  It begins with the core's
// first part.  A question that needs the second one before that has come waits for it, and those behind it, too: a call
// that was given up halfway leaves the core in no known state, so that the question is asked of a new one.
import { Core, CoreFailure, PartMissing, type Change } from './core';
import { lastPart } from './folder';

export interface Picture {
    facts: ReturnType<Core['picture']>;
    values: Float32Array<ArrayBuffer>;
    mask: Uint8Array<ArrayBuffer>;
    stride: number;
    text: string; // of its scene
    milliseconds: number;
}

/** What a core was told, so that another one can be told the same. */
interface Told {
    module: WebAssembly.Module;
    words: Record<string, string>;
    files: Map<string, Uint8Array>;
    irradiance: boolean;
    text: string | null; // of the present scene
    picture: [text: string, irradiance: boolean, stride: number] | null;
}

let core: Core;
let openText: string | null = null;
let told: Told;
let second: WebAssembly.Module | null = null;
let secondCame: () => void;
const arrival = new Promise<void>((resolve) => (secondCame = resolve));

function open(text: string) {
    if (text === openText) return true;
    core.folder.asked.clear();
    const whole = core.open(text);
    openText = whole ? text : null;
    if (whole) told.text = text;
    return whole;
}

function measure(irradiance: boolean) {
    core.quantity(irradiance);
    told.irradiance = irradiance;
}

async function begin() {
    core = await Core.start(told.module, second);
    openText = null;
    core.translate(told.words);
    for (const [name, bytes] of told.files) core.folder.put(name, bytes);
}

/** A new core in the place and the state of the one before. */
async function beginAnew() {
    const { text, irradiance, picture } = told;
    await begin();
    if (picture) questions.render(...picture);
    measure(irradiance);
    if (text !== null) open(text);
}

const questions = {
    async start(module: WebAssembly.Module, words: Record<string, string>, files: Map<string, Uint8Array>) {
        told = { module, words, files, irradiance: false, text: null, picture: null };
        await begin();
        return core.builtins();
    },
    /** Puts a file that scenes name into the folder, in place of an older one. */
    give(name: string, bytes: Uint8Array) {
        told.files.set(name, bytes);
        core.folder.put(name, bytes);
        openText = null;
    },
    translate(words: Record<string, string>) {
        told.words = words;
        core.translate(words);
        return core.builtins();
    },
    parameters: () => core.parameters(),
    /** Judges a text; what it holds where it is whole, and the files that it names: whether each is there. */
    judge(text: string, irradiance: boolean) {
        openText = null;
        measure(irradiance);
        const whole = open(text);
        const messages = core.messages();
        // Those that the scene before named are looked at, too.
        const files = [...core.folder.asked].filter(([name, found]) => !found || text.includes(lastPart(name)));
        return { whole, messages, scene: whole ? core.scene() : null, files };
    },
    /** Computes a picture of a text that was found to be whole, or of each n-th pixel. */
    render(text: string, irradiance: boolean, stride: number): Picture | { messages: ReturnType<Core['messages']> } {
        measure(irradiance);
        if (!open(text)) return { messages: core.messages() };
        const before = performance.now();
        if (!core.render(stride)) return { messages: core.messages() };
        const milliseconds = performance.now() - before;
        told.picture = [text, irradiance, stride];
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

interface Asked {
    id: number;
    name: keyof Questions;
    arguments: unknown[];
}

async function answerTo({ name, arguments: values }: Asked): Promise<unknown> {
    const question = questions[name] as (...values: unknown[]) => unknown;
    if (second && core && !core.isWhole) core.complete(second);
    try {
        return await question(...values);
    } catch (error) {
        if (!(error instanceof PartMissing)) throw error;
    }
    if (!second) self.postMessage({ isWaiting: true });
    await arrival;
    await beginAnew();
    return question(...values);
}

async function answer(asked: Asked) {
    const { id } = asked;
    try {
        self.postMessage({ id, answer: await answerTo(asked) });
    } catch (error) {
        // Whatever ended the core has left its memory in no known state.
        self.postMessage({ id, failure: String(error) });
    }
}

let last: Promise<void> = Promise.resolve();
self.onmessage = ({ data }: MessageEvent<Asked | { second: WebAssembly.Module }>) => {
    if ('second' in data) {
        second = data.second;
        secondCame();
    } else last = last.then(() => answer(data));
};
