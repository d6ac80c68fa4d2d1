// SPDX-License-Identifier: MIT
// A surface that joins a scene: of a size that is seen whole, and before what is there, whatever the scene's own size.
import type { Change } from './core';
import type { Model } from './model';

const SIZES = ['radius', 'size', 'height'];

/** How much larger a surface of this reach should be, and where its middle should stand. */
export function placing(model: Model, reach: number): { scale: number; center: number[] } {
    const first = model.scene?.surfaces[0];
    const [x, y, z] = first?.center ?? [0, 0, 0];
    const top = z + (first?.reach ?? 0);
    const room = (model.observer?.position[2] ?? Infinity) - top; // before the observer
    const wanted = Math.min(0.25 * Math.min(...model.screen), room > 0 ? room / 3 : Infinity);
    const fits = reach > wanted / 3 && reach <= wanted;
    const scale = fits ? 1 : Number((wanted / reach).toPrecision(3));
    return { scale, center: [x, y, room > 0 ? top + 1.1 * scale * reach : z] };
}

/** The changes by which a surface made from the example of its kind joins the present scene; a room stands as it is. */
export function newSurface(model: Model, example: string): Change[] {
    const index = model.scene?.surfaces.length ?? 0;
    const insert: Change = { list: 'surfaces', index, insert: example };
    // The example itself may not go with the scene, so that the core cannot be asked how large it is.
    const given = SIZES.map((key): [string, number[]] => [
        key,
        (new RegExp(`\\b${key}: \\[?([^\\]}a-z]*)`).exec(example)?.[1] ?? '').split(',').map(parseFloat).filter(isFinite),
    ]);
    const [radius, size, height] = given.map(([, numbers]) => Math.hypot(...numbers));
    const reach = Math.hypot(radius, size / 2, height / 2);
    if (/type: room\b/.test(example) || !(reach > 0)) return [insert];
    const { scale, center } = placing(model, reach);
    const sets = given.filter(([, numbers]) => numbers.length > 0);
    return [
        insert,
        ...[['center', center.map(Math.round)] as [string, number[]], ...sets].map(([key, numbers]) => {
            const written = key === 'center' ? numbers : numbers.map((n) => Number((n * scale).toPrecision(2)));
            const value = numbers.length > 1 ? `[${written.join(', ')}]` : String(written[0]);
            return { set: `surfaces[${index}].${key}=${value}` };
        }),
    ];
}
