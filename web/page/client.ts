// SPDX-License-Identifier: MIT
// The page's end of the worker: questions as promises, which wait here until it is their turn, and a new worker where the
// old one failed.  Workers begin with the first part of the core, and are given the second one when it has come.
import { belongTogether } from './core';
import { Outdated, type Version } from './version';
import type { Questions } from './worker';
import workerAddress from './worker?worker&url';

type Answer<T> = T extends (...values: never[]) => infer R ? Awaited<R> : never;

function embedded(id: string): Uint8Array<ArrayBuffer> | null {
    const text = document.getElementById(id)?.textContent;
    return text ? Uint8Array.from(atob(text), (character) => character.charCodeAt(0)) : null;
}

async function fetched(name: string | URL, options: RequestInit = {}): Promise<Response> {
    const response = await fetch(new URL(name, document.baseURI), options);
    if (!response.ok) throw new Error(`${name}: ${response.status}`);
    return response;
}

/** A part of the core, compiled while it comes where the server says what it is. */
async function compiled(id: string, name: string, options: RequestInit = {}): Promise<WebAssembly.Module> {
    const own = embedded(id);
    if (own) return WebAssembly.compile(own);
    const response = await fetched(name, options);
    const isTyped = response.headers.get('content-type') === 'application/wasm';
    return isTyped ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** The smallest module with an operation on vectors. */
export function hasVectors(): boolean {
    const module = [
        0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
    ];
    return typeof WebAssembly === 'object' && WebAssembly.validate(new Uint8Array(module));
}

interface Asked {
    id: number;
    version: number | null; // of the scene that it is about
    name: keyof Questions;
    values: unknown[];
    resolve: (answer: any) => void;
    reject: (error: Error) => void;
}

/** What a worker says: the answer to a question, why there is none, how far it is, or that it waits for the second part. */
interface Answered {
    id: number;
    answer: unknown;
    failure?: string;
    isOutdated?: boolean; // of the failure: the core is as it was
    isWaiting?: boolean;
    progress?: number;
}

// Pictures and values may take long, as where surfaces reflect light to each other.
const LONG: (keyof Questions)[] = [
    'render', 'stage', 'probe', 'lit', 'values', 'extrema', 'grids', 'daylight', 'explain', 'balance', 'summary', 'isophotes', 'file',
];
const PATIENCE = 1500; // milliseconds that something urgent waits for them
const LATEST = 1000; // milliseconds after which the second part is fetched, whether there is a picture or not

// Whose turn is next: what changes the scene, then the number under the pointer, the picture, and all else.
const TURNS: Partial<Record<keyof Questions, number>> = {
    probe: 1, render: 2, stageProbe: 2, stage: 3, isophotes: 3, explain: 3, line: 3, lit: 3, values: 4,
    file: 5, summary: 5, extrema: 5, balance: 6, grids: 6, daylight: 6,
};

/** How it stands with the core's second part: some question waits for it, it is there, or it cannot be had. */
export type Loading = 'awaited' | 'there' | { failure: Error };

/** Why the second part is refused: it is not of the same build as the first. */
export class OtherVersion extends Error {}

/** Why a question has no answer: its worker was ended for the sake of something urgent. */
export class Interrupted extends Error {}

export class Client {
    private worker!: Worker;
    private queue: Asked[] = [];
    private present: Asked | null = null; // what the worker is busy with
    /** How often long work was given up for the sake of something urgent. */
    interruptions = 0;
    private next = 0;
    private module!: WebAssembly.Module; // the first part
    private takeSecond!: (second: WebAssembly.Module) => void;
    private second = new Promise<WebAssembly.Module>((resolve) => (this.takeSecond = resolve));
    private isStuck = false; // whether the worker waits for the second part
    /** Whether the second part has come. */
    isWhole = false;
    private source!: string; // the address of the worker's text, which is kept so that a new one asks for nothing
    private words: Record<string, string> = {};
    /** How many files were given. */
    given = 0;
    private isTwin = false;
    private isOver = false; // a twin that was stopped or failed
    /** What the user gave of the files that scenes name. */
    readonly files: Map<string, Uint8Array>;
    private russian: Record<string, string> | null = null;
    /** Called when a worker had to be started anew. */
    onRestart: () => void = () => undefined;
    onLoading: (state: Loading) => void = () => undefined;
    /** Told the share of a question that is done. */
    onProgress: (name: keyof Questions, done: number) => void = () => undefined;

    constructor(files = new Map<string, Uint8Array>()) {
        this.files = files;
    }

    async start(language: string) {
        const worker = async () =>
            embedded('embedded-worker') ??
            (await (await fetched(new URL(workerAddress, import.meta.url))).arrayBuffer());
        const core = compiled('embedded-core', 'luxel-core.wasm');
        const [module, text, words] = await Promise.all([core, worker(), this.wordsOf(language)]);
        [this.module, this.words] = [module, words];
        this.source = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
        setTimeout(this.fetchRest, LATEST);
        return this.restart();
    }

    private isFetching = false;

    // The second part, and then all words, so that they are there offline, too: once, when it is needed or a picture has come.
    private readonly fetchRest = () => {
        if (this.isFetching || this.isTwin) return;
        this.isFetching = true;
        void this.complete().then(() => this.wordsOf('ru').catch(() => undefined));
    };

    /** Gets the core's second part; where that fails, it can be tried again. */
    async complete(options: RequestInit = {}) {
        try {
            const second = await compiled('embedded-core-2', 'luxel-core-2.wasm', options);
            if (!belongTogether(this.module, second)) throw new OtherVersion();
            this.isWhole = true;
            this.takeSecond(second);
            this.onLoading('there');
        } catch (error) {
            this.onLoading({ failure: error as Error });
        }
    }

    /** Has the browser's cache hold what the server has now, for the page that is loaded next. */
    async renew() {
        const names = ['luxel-core.wasm', 'luxel-core-2.wasm', new URL(workerAddress, import.meta.url)];
        await Promise.allSettled(names.map((name) => fetched(name, { cache: 'reload' })));
    }

    /** Another worker with a core of its own, for long work that may be given up. */
    async twin(): Promise<Client> {
        const twin = new Client(this.files);
        const { module, second, source, words, onLoading } = this;
        Object.assign(twin, { module, second, source, words, onLoading, isTwin: true });
        await twin.restart();
        return twin;
    }

    /** Whether it was stopped, or failed as a twin. */
    get isEnded() {
        return this.isOver;
    }

    /** Gives up whatever it does; it cannot be asked any more. */
    stop() {
        this.isOver = true;
        this.worker.terminate();
        this.giveUp('stopped');
    }

    private async wordsOf(language: string): Promise<Record<string, string>> {
        if (language !== 'ru') return {};
        const own = embedded('embedded-words');
        this.russian ??= own ? JSON.parse(new TextDecoder().decode(own)) : await (await fetched('ru.json')).json();
        return this.russian!;
    }

    /** A text of the core in the present language. */
    word(english: string): string {
        return this.words[english] ?? english;
    }

    /** Whether the words of all languages have come. */
    get hasWords() {
        return this.russian !== null;
    }

    /** Has the core speak another language; rejects where its words cannot be had. */
    async translate(language: string) {
        this.words = await this.wordsOf(language);
        return this.ask('translate', this.words);
    }

    /** Has it speak the language of another one. */
    speakAs({ words }: Client) {
        this.words = words;
        return this.ask('translate', words);
    }

    /** Gives a file that scenes name; workers that are started later have it, too. */
    give(name: string, bytes: Uint8Array) {
        this.files.set(name, bytes);
        this.given++;
        return this.ask('give', name, bytes);
    }

    private restart() {
        this.worker?.terminate();
        const worker = (this.worker = new Worker(this.source));
        worker.onmessage = ({ data }) => this.worker === worker && this.answered(data);
        worker.onerror = (event) => this.worker === worker && this.failed(event.message);
        this.isStuck = false;
        void this.second.then((second) => {
            worker.postMessage({ second });
            if (this.worker === worker) this.isStuck = false;
        });
        this.present = null;
        const started = this.ask('start', this.module, this.words, this.files); // before all that waits
        return started;
    }

    /** Asks what does not wait for a picture or a value that takes long: its worker is ended, and another one asked. */
    async urgent<Name extends keyof Questions>(
        name: Name,
        ...values: Parameters<Questions[Name]>
    ): Promise<Answer<Questions[Name]>> {
        const timer = setTimeout(() => this.interrupt(), PATIENCE);
        try {
            return await this.ask(name, ...values);
        } finally {
            clearTimeout(timer);
        }
    }

    // Starts another worker if what it is busy with takes long, or waits for the second part.
    private interrupt() {
        const { present } = this;
        if (!present || !(this.isStuck || LONG.includes(present.name))) return;
        this.interruptions++;
        void this.restart().catch(() => undefined);
        present.reject(new Interrupted('something urgent came'));
    }

    /** Gives up what it is busy with; what waits is asked of a new worker. */
    giveWay() {
        const { present } = this;
        if (!present || this.isOver) return;
        void this.restart().catch(() => undefined);
        present.reject(new Interrupted('something newer is wanted'));
    }

    private answered({ id, answer, failure, isOutdated, isWaiting, progress }: Answered) {
        const asked = this.present;
        if (!asked || asked.id !== id) return;
        if (isWaiting) {
            this.isStuck = true;
            this.fetchRest();
            this.onLoading('awaited');
        } else if (progress !== undefined) this.onProgress(asked.name, progress);
        else {
            this.present = null;
            if (asked.name === 'render') this.fetchRest();
            if (failure === undefined) asked.resolve(answer);
            else if (isOutdated) asked.reject(new Outdated(failure));
            else {
                asked.reject(new Error(failure));
                return this.failed(failure);
            }
            this.advance();
        }
    }

    private giveUp(reason: string) {
        const given = this.present ? [this.present, ...this.queue] : this.queue;
        this.present = null;
        this.queue = [];
        for (const { reject } of given) reject(new Error(reason));
    }

    private failed(reason: string) {
        this.giveUp(reason);
        if (this.isTwin) this.stop();
        else this.restart().then(this.onRestart, () => undefined);
    }

    /** Takes back what waits and is about versions before this one. */
    forget(before: number) {
        const isOld = ({ version }: Asked) => version !== null && version < before;
        const old = this.queue.filter(isOld);
        this.queue = this.queue.filter((asked) => !isOld(asked));
        for (const { reject } of old) reject(new Outdated('the scene has changed'));
    }

    /** Asks the worker, which answers one question at a time, what is more urgent first. */
    ask<Name extends keyof Questions>(
        name: Name,
        ...values: Parameters<Questions[Name]>
    ): Promise<Answer<Questions[Name]>> {
        const [about] = values as unknown[];
        const version = isVersion(about) ? about.number : null;
        return new Promise((resolve, reject) => {
            if (this.isOver) return reject(new Error('stopped'));
            this.queue.push({ id: this.next++, version, name, values, resolve, reject });
            this.advance();
        });
    }

    private advance() {
        if (this.present || !this.queue.length) return;
        const turn = ({ name }: Asked) => (name === 'start' ? -1 : (TURNS[name] ?? 0));
        const first = this.queue.reduce((best, asked) => (turn(asked) < turn(best) ? asked : best));
        this.queue.splice(this.queue.indexOf(first), 1);
        this.present = first;
        const { id, version, name, values } = first;
        this.worker.postMessage({ id, version, name, arguments: values });
    }
}

function isVersion(value: unknown): value is Version {
    return typeof value === 'object' && value !== null && 'number' in value && 'scene' in value;
}
