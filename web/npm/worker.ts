// SPDX-License-Identifier: MIT
// The worker of `luxel-core/remote`: scenes by their numbers, and the questions that their other end asks of them.
import { LuxelError, Scene } from './index';
import type { Asked, Said } from './remote';
import { line } from '#read';

const BETWEEN = 50; // milliseconds between two tidings of progress

const scenes = new Map<number, Promise<Scene>>();

function watching(id: number) {
    let told = 0;
    return (done: number) => {
        if (performance.now() - told < BETWEEN) return;
        told = performance.now();
        line.post({ id, progress: done } satisfies Said);
    };
}

async function answer({ id, scene: number, method, values, watched }: Asked): Promise<Said> {
    if (watched >= 0) Object.assign(values[watched] as object, { progress: watching(id) });
    if (method === 'open' || method === 'builtin') {
        const opening = (Scene[method] as (...values: unknown[]) => Promise<Scene>)(...values);
        scenes.set(number, opening);
        return { id, text: (await opening).text };
    }
    const scene = (await scenes.get(number)!) as unknown as Record<string, (...values: unknown[]) => Promise<unknown>>;
    const found = await scene[method](...values);
    return { id, answer: found, text: scene.text as unknown as string };
}

line.listen(async (asked: Asked) => {
    try {
        line.post(await answer(asked));
    } catch (error) {
        const isOurs = error instanceof LuxelError;
        const diagnostics = isOurs ? error.diagnostics : null;
        line.post({ id: asked.id, failure: { message: String(error), diagnostics, scene: isOurs ? error.scene : '' } });
    }
});
