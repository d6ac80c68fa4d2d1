// SPDX-License-Identifier: MIT
// Scenes in a worker, so that what takes long does not hold up the page: the same methods as of Scene, and whoever wants no
// more of an answer ends the worker.
import { LuxelError } from './results';
import type { BuiltinName, Diagnostic, OpenOptions, Options, SceneDocument, SceneMethods } from './results';
import { startWorker } from '#read';

export * from './results';

const METHODS = ['set', 'get', 'insert', 'remove', 'give', 'render', 'file', 'probe', 'explain', 'extrema', 'grids',
    'grid', 'balance', 'lights', 'conventions', 'advice', 'close'] as const; // prettier-ignore

/** A question to the worker. */
export interface Asked {
    id: number;
    scene: number;
    method: string;
    values: unknown[];
    /** The options among the values that want to hear of progress; -1: none. */
    watched: number;
}

/** What it says. */
export interface Said {
    id: number;
    progress?: number;
    answer?: unknown;
    text?: string;
    failure?: { message: string; diagnostics: Diagnostic[] | null; scene: string };
}

interface Waiting {
    resolve: (said: Said) => void;
    reject: (error: Error) => void;
    progress?: (done: number) => void;
}

/** A worker with its scenes. */
export class Remote {
    private readonly waiting = new Map<number, Waiting>();
    private asked = 0;
    private scenes = 0;
    private isEnded = false;

    constructor(private readonly worker: Worker) {
        worker.onmessage = ({ data }) => this.hear(data as Said);
        worker.onerror = (event) => this.fail(new Error(`the worker failed: ${event.message}`));
    }

    /** Opens a scene there. */
    async open(source: string | SceneDocument | Uint8Array, options?: OpenOptions): Promise<SceneMethods> {
        return this.begin('open', [source, options]);
    }

    /** Opens a built-in scene there. */
    async builtin(name?: BuiltinName): Promise<SceneMethods> {
        return this.begin('builtin', [name]);
    }

    /** Ends the worker; what has not been answered is rejected. */
    end(): void {
        this.worker.terminate();
        this.fail(new Error('the worker was ended'));
    }

    private async begin(method: string, values: unknown[]): Promise<SceneMethods> {
        const number = this.scenes++;
        let { text = '' } = await this.ask(number, method, values);
        const scene = Object.defineProperty({} as SceneMethods, 'text', { get: () => text, enumerable: true });
        for (const name of METHODS)
            Object.assign(scene, {
                [name]: async (...given: unknown[]) => {
                    const said = await this.ask(number, name, given);
                    text = said.text ?? text;
                    return said.answer;
                },
            });
        return scene;
    }

    private ask(scene: number, method: string, given: unknown[]): Promise<Said> {
        if (this.isEnded) return Promise.reject(new Error('the worker was ended'));
        const id = this.asked++;
        const watched = given.findIndex((value) => typeof (value as Options)?.progress === 'function');
        const progress = (given[watched] as Options | undefined)?.progress;
        const values = given.map((value, i) => (i === watched ? { ...(value as Options), progress: undefined } : value));
        return new Promise((resolve, reject) => {
            this.waiting.set(id, { resolve, reject, progress });
            this.worker.postMessage({ id, scene, method, values, watched } satisfies Asked);
        });
    }

    private hear(said: Said) {
        const waiting = this.waiting.get(said.id);
        if (!waiting) return;
        if (said.progress !== undefined) return waiting.progress?.(said.progress);
        this.waiting.delete(said.id);
        if (!said.failure) return waiting.resolve(said);
        const { message, diagnostics, scene } = said.failure;
        waiting.reject(diagnostics ? new LuxelError(diagnostics, scene) : new Error(message));
    }

    private fail(error: Error) {
        this.isEnded = true;
        for (const { reject } of this.waiting.values()) reject(error);
        this.waiting.clear();
    }
}

/** Starts a worker, or takes one that runs `luxel-core/worker`, as a bundler may want it. */
export function remote(worker: Worker = startWorker()): Remote {
    return new Remote(worker);
}
