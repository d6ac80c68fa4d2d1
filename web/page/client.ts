// SPDX-License-Identifier: MIT
// The page's end of the worker: questions as promises, and a new worker where the old one failed.  Workers begin with
// the first part of the core, and are given the second one when it has come.
import { belongTogether } from './core';
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

async function compiled(id: string, name: string, options: RequestInit = {}): Promise<WebAssembly.Module> {
    return WebAssembly.compile(embedded(id) ?? (await (await fetched(name, options)).arrayBuffer()));
}

/** The smallest module with an operation on vectors. */
export function hasVectors(): boolean {
    const module = [
        0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
    ];
    return typeof WebAssembly === 'object' && WebAssembly.validate(new Uint8Array(module));
}

interface Asked {
    name: keyof Questions;
    resolve: (answer: any) => void;
    reject: (error: Error) => void;
}

/** What a worker says: the answer to a question, why there is none, or that it waits for the core's second part. */
interface Answered {
    id: number;
    answer: unknown;
    failure?: string;
    isWaiting?: boolean;
}

// Pictures and values may take long, as where surfaces reflect light to each other.
const LONG: (keyof Questions)[] = ['render', 'probe', 'table', 'section', 'sectionBetween', 'extrema', 'explain', 'balance'];
const PATIENCE = 1500; // milliseconds that something urgent waits for them

/** How it stands with the core's second part: some question waits for it, it is there, or it cannot be had. */
export type Loading = 'awaited' | 'there' | { failure: Error };

/** Why the second part is refused: it is not of the same build as the first. */
export class OtherVersion extends Error {}

/** Why a question has no answer: its worker was ended for the sake of something urgent. */
export class Interrupted extends Error {}

export class Client {
    private worker!: Worker;
    private waiting = new Map<number, Asked>();
    private starting: Promise<unknown> | null = null; // a worker in the place of one that was interrupted
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
    private isTwin = false;
    /** What the user gave of the files that scenes name. */
    readonly files: Map<string, Uint8Array>;
    private russian: Record<string, string> | null = null;
    /** Called when a worker had to be started anew. */
    onRestart: () => void = () => undefined;
    onLoading: (state: Loading) => void = () => undefined;

    constructor(files = new Map<string, Uint8Array>()) {
        this.files = files;
    }

    async start(language: string) {
        this.module = await compiled('embedded-core', 'luxel-core.wasm');
        const text =
            embedded('embedded-worker') ??
            (await (await fetched(new URL(workerAddress, import.meta.url))).arrayBuffer());
        this.source = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
        this.words = await this.wordsOf(language);
        const builtins = await this.restart();
        void this.complete();
        return builtins;
    }

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

    /** Gives up whatever it does; it cannot be asked any more. */
    stop() {
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

    async translate(language: string) {
        this.words = await this.wordsOf(language);
        return this.ask('translate', this.words);
    }

    /** Gives a file that scenes name; workers that are started later have it, too. */
    give(name: string, bytes: Uint8Array) {
        this.files.set(name, bytes);
        return this.ask('give', name, bytes);
    }

    private restart() {
        this.worker?.terminate();
        const worker = (this.worker = new Worker(this.source));
        worker.onmessage = ({ data }) => this.answered(data);
        worker.onerror = (event) => this.failed(event.message);
        this.isStuck = false;
        void this.second.then((second) => {
            worker.postMessage({ second });
            this.isStuck = false;
        });
        return this.post('start', this.module, this.words, this.files);
    }

    /** Asks what does not wait for a picture or a value that takes long: its worker is ended, and another one asked. */
    async urgent<Name extends keyof Questions>(
        name: Name,
        ...values: Parameters<Questions[Name]>
    ): Promise<Answer<Questions[Name]>> {
        await this.starting;
        const id = this.next;
        const timer = setTimeout(() => this.interrupt(id), PATIENCE);
        try {
            return await this.post(name, ...values);
        } catch (error) {
            if (!(error instanceof Interrupted)) throw error;
        } finally {
            clearTimeout(timer);
        }
        return this.urgent(name, ...values);
    }

    // Starts another worker if what was asked before the question with this number takes long or waits.
    private interrupt(before: number) {
        const isLong = (id: number, name: keyof Questions) => id < before && (this.isStuck || LONG.includes(name));
        if (this.starting || ![...this.waiting].some(([id, { name }]) => isLong(id, name))) return;
        this.interruptions++;
        const given = [...this.waiting.values()];
        this.waiting.clear();
        this.starting = this.restart().finally(() => (this.starting = null));
        for (const { reject } of given) reject(new Interrupted('something urgent came'));
    }

    private answered({ id, answer, failure, isWaiting }: Answered) {
        if (isWaiting) {
            this.isStuck = true;
            this.onLoading('awaited');
            return;
        }
        const asked = this.waiting.get(id);
        this.waiting.delete(id);
        if (failure === undefined) asked?.resolve(answer);
        else {
            asked?.reject(new Error(failure));
            this.failed(failure);
        }
    }

    private giveUp(reason: string) {
        for (const asked of this.waiting.values()) asked.reject(new Error(reason));
        this.waiting.clear();
    }

    private failed(reason: string) {
        this.giveUp(reason);
        if (this.isTwin) this.worker.terminate();
        else this.restart().then(this.onRestart, () => undefined);
    }

    async ask<Name extends keyof Questions>(
        name: Name,
        ...values: Parameters<Questions[Name]>
    ): Promise<Answer<Questions[Name]>> {
        while (this.starting) {
            await this.starting;
            await new Promise((resolve) => setTimeout(resolve)); // what is urgent comes first
        }
        return this.post(name, ...values);
    }

    private post<Name extends keyof Questions>(
        name: Name,
        ...values: Parameters<Questions[Name]>
    ): Promise<Answer<Questions[Name]>> {
        const id = this.next++;
        return new Promise((resolve, reject) => {
            this.waiting.set(id, { name, resolve, reject });
            this.worker.postMessage({ id, name, arguments: values });
        });
    }
}
