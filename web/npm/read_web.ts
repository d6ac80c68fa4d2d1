// SPDX-License-Identifier: MIT
// Where the parts of the core and the worker lie in browsers and in what bundlers make for them: beside this module.

async function compiled(address: URL): Promise<WebAssembly.Module> {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`${address.href}: ${answer.status} ${answer.statusText}`);
    const isNamed = answer.headers.get('content-type') === 'application/wasm';
    return isNamed ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

/** A part of the core by its number, 1 or 2. */
export function readPart(number: number): Promise<WebAssembly.Module> {
    // Bundlers look for the whole of each.
    return compiled(
        number === 1
            ? new URL('./luxel-core.wasm', import.meta.url)
            : new URL('./luxel-core-2.wasm', import.meta.url),
    );
}

export function readFrom(address: string | URL): Promise<WebAssembly.Module> {
    return compiled(new URL(address, location.href));
}

export function startWorker(): Worker {
    return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
}

/** The other end of a worker's line, in the worker. */
export const line = {
    listen: (hear: (message: any) => void) => void (self.onmessage = ({ data }) => hear(data)),
    post: (message: unknown) => self.postMessage(message),
};
