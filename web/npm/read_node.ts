// SPDX-License-Identifier: MIT
// Where the parts of the core and the worker lie in Node: beside this module, as files.
import { readFile } from 'node:fs/promises';
import { Worker as Thread, parentPort } from 'node:worker_threads';

export async function readFrom(address: string | URL): Promise<WebAssembly.Module> {
    return WebAssembly.compile(await readFile(address));
}

/** A part of the core by its number, 1 or 2. */
export function readPart(number: number): Promise<WebAssembly.Module> {
    return readFrom(new URL(number === 1 ? './luxel-core.wasm' : './luxel-core-2.wasm', import.meta.url));
}

/** A thread with the manners of a browser's worker. */
export function startWorker(): Worker {
    const thread = new Thread(new URL('./worker_node.js', import.meta.url));
    const worker = {
        onmessage: (_event: { data: unknown }) => undefined,
        onerror: (_event: { message: string }) => undefined,
        postMessage: (message: unknown) => thread.postMessage(message),
        terminate: () => thread.terminate(),
    };
    thread.on('message', (data) => worker.onmessage({ data }));
    thread.on('error', (error) => worker.onerror({ message: String(error) }));
    return worker as unknown as Worker;
}

/** The other end of a worker's line, in the worker. */
export const line = {
    listen: (hear: (message: any) => void) => void parentPort?.on('message', hear),
    post: (message: unknown) => parentPort?.postMessage(message),
};
