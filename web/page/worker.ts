// SPDX-License-Identifier: MIT
// The worker: the core, and the questions of the page to it, one after the other.  A question about the scene brings the
// version that it is about, which is opened where it is not the present one.  The worker begins with the core's first part.
// A question that needs the second one before that has come waits for it: a call that was given up halfway leaves the core
// in no known state, so that the question is asked of a new one.
import { Core, CoreFailure, PartMissing, type Change, type Probe, type Samples } from './core';
import { lastPart } from './folder';
import { geometryOf } from './geometry';
import { greatestChannel } from './srgb';
import { Outdated, type Of } from './version';

const SLICE = 25; // milliseconds of values after which what is more urgent has its turn
const BETWEEN = 100; // milliseconds between two tidings of progress

export interface Picture extends Samples {
    of: Of;
    facts: ReturnType<Core['picture']>;
    brightest: number; // the greatest channel
    stride: number;
    milliseconds: number;
}

/** What a core was told, so that another one can be told the same. */
interface Told {
    module: WebAssembly.Module;
    words: Record<string, string>;
    files: Map<string, Uint8Array>;
}

let core: Core;
let openText: string | null = null;
let drawn = ''; // what the core's last picture is of
let told: Told;
let second: WebAssembly.Module | null = null;
let secondCame: () => void;
const arrival = new Promise<void>((resolve) => (secondCame = resolve));
let present = 0; // the number of the question that is being answered
let lastTidings = 0;

/** Makes a version the present scene of the core; false: its text has errors. */
function open({ text, irradiance, direct, within, view }: Of): boolean {
    core.quantity(irradiance);
    core.view(view);
    core.direct(direct);
    core.within(within ?? 0);
    if (text === openText) return true;
    core.folder.asked.clear();
    const whole = core.open(text);
    openText = whole ? text : null;
    return whole;
}

/** The same for what is asked of scenes without errors only. */
function opened(of: Of): Core {
    if (!open(of)) throw new Outdated('the scene has errors');
    return core;
}

function draw(of: Of, stride: number): boolean {
    const name = [of.number, of.direct, of.within, stride].join();
    const isDrawn = drawn === name || core.render(stride);
    if (isDrawn) drawn = name;
    return isDrawn;
}

async function begin() {
    core = await Core.start(told.module, second);
    core.onProgress = (done) => {
        const now = performance.now();
        if (now - lastTidings < BETWEEN) return;
        lastTidings = now;
        self.postMessage({ id: present, progress: done });
    };
    openText = null;
    drawn = '';
    core.translate(told.words);
    for (const [name, bytes] of told.files) core.folder.put(name, bytes);
}

/** Judges a text; what it holds where it is whole, and the files that it names: whether each is there. */
function judge(of: Of) {
    openText = null;
    const whole = open(of);
    const messages = core.messages();
    const facts = whole ? core.scene() : null;
    // Those that the scene before named are looked at, too.
    const files = [...core.folder.asked].filter(([name, found]) => !found || of.text.includes(lastPart(name)));
    const geometry =
        facts &&
        geometryOf(
            facts,
            (key) => core.get(key),
            (place) => core.project(place),
            (x, y, height) => core.unproject(x, y, height),
            (text) => core.sun(text),
        );
    return { messages, files, facts, geometry };
}

/** Computes a picture, or each n-th column and row of it. */
function render(of: Of, stride: number): Picture | { messages: ReturnType<Core['messages']> } {
    if (!open(of)) return { messages: core.messages() };
    const before = performance.now();
    drawn = '';
    if (!draw(of, stride)) return { messages: core.messages() };
    const milliseconds = performance.now() - before;
    const samples = core.samples();
    return { of, facts: core.picture(), ...samples, brightest: greatestChannel(samples.rgb ?? samples.values), stride, milliseconds };
}

/** Exact values at the first of some places, as many as go within a slice of time. */
function values(of: Of, places: number[][]): (Probe | null)[] {
    const until = performance.now() + SLICE;
    const found: (Probe | null)[] = [];
    opened(of);
    for (const [x, y] of places) {
        found.push(core.probe(x, y));
        if (performance.now() > until) break;
    }
    return found;
}

const questions = {
    async start(module: WebAssembly.Module, words: Record<string, string>, files: Map<string, Uint8Array>) {
        told = { module, words, files };
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
    version: () => core.version(),
    edit: (text: string | Uint8Array, changes: Change[]) => {
        const changed = core.edit(text, changes);
        return { text: changed, messages: changed === null ? core.messages() : [] };
    },
    newLight: (text: string, wanted: string, like: number, replaces: boolean) =>
        core.newLight(text, wanted, like, replaces),
    judge,
    render,
    probe: (of: Of, x: number, y: number) => opened(of).probe(x, y),
    lit: (of: Of, x: number, y: number) => opened(of).lit(x, y),
    color: (of: Of, x: number, y: number) => opened(of).color(x, y),
    lightColors: (of: Of) => opened(of).lightColors(),
    blackBody: (kelvin: number) => core.blackBody(kelvin),
    values,
    line: (of: Of, x: number, y: number, degrees: number) => opened(of).line(x, y, degrees),
    /** The values at a point of several scenes, one after the other; null: a scene has errors, or nothing is there. */
    sweep: (scenes: Of[], x: number, y: number) =>
        scenes.map((of) => (open(of) ? (core.probe(x, y)?.value ?? null) : null)),
    variant: (number: number) => core.variant(number),
    /** Judges what was typed for a point; null: it is no number. */
    answer: (of: Of, typed: string, x: number, y: number, tolerance: number) =>
        opened(of).answer(typed, x, y, tolerance),
    explain: (of: Of, x: number, y: number, format: number, language: string) =>
        opened(of).explain(x, y, format, language),
    summary: (of: Of) => opened(of).summary(),
    balance: (of: Of) => opened(of).balance(),
    grids: (of: Of) => opened(of).grids(),
    daylight: (of: Of) => opened(of).daylight(),
    isophotes: (of: Of, stride: number, wanted: number, logarithmic: boolean) =>
        opened(of) && draw(of, stride) ? core.isophotes(wanted, logarithmic) : [],
    extrema: (of: Of) => opened(of).extrema(),
    keys: (of: Of, keys: string[]) => opened(of) && keys.map((key) => core.get(key)),
    /** What another camera sees, how far it is, in half as many columns and rows, and how long it took; null: nothing. */
    stage: (of: Of, camera: number[], columns: number, rows: number) => {
        const before = performance.now();
        const samples = opened(of).stage(camera, columns, rows);
        const depth = samples && core.stageDepth(camera, columns / 2, rows / 2);
        return samples && depth && { of, ...samples, depth, milliseconds: performance.now() - before };
    },
    /** The value that a camera sees through a point of its screen. */
    stageProbe: (of: Of, camera: number[], columns: number, rows: number, x: number, y: number) =>
        opened(of).stageProbe(camera, columns, rows, x, y),
    project: (of: Of, place: number[]) => opened(of).project(place),
    unproject: (of: Of, x: number, y: number, height: number) => opened(of).unproject(x, y, height),
    file: (of: Of, name: string) => {
        const bytes = opened(of).file(name);
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
    version: number | null; // that it is about; null: about no scene
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
    if (!second) self.postMessage({ id: present, isWaiting: true });
    await arrival;
    await begin();
    return question(...values);
}

async function answer(asked: Asked) {
    const { id, version } = asked;
    present = id;
    try {
        self.postMessage({ id, version, answer: await answerTo(asked) });
    } catch (error) {
        // Whatever ended the core has left its memory in no known state.
        self.postMessage({ id, version, failure: String(error), isOutdated: error instanceof Outdated });
    }
}

let last: Promise<void> = Promise.resolve();
self.onmessage = ({ data }: MessageEvent<Asked | { second: WebAssembly.Module }>) => {
    if ('second' in data) {
        second = data.second;
        secondCame();
    } else last = last.then(() => answer(data));
};
