// SPDX-License-Identifier: MIT
// The vectors of the formula at a place: the normal N, V to the observer, L to each lamp and H between the two.
import type { Probe } from './core';
import { lightColour } from './dom';
import type { Drawing } from './drawing';
import type { Model } from './model';
import { add, dot, unit, type Place } from './space_math';

export interface Vector {
    /** "N", "V", "H", or "L" with the number of its light. */
    key: string;
    letter: string;
    direction: Place;
    colour: string;
    share: number; // of the usual length
}

const MOST = 4; // lights that have a vector when none is pointed at
const THICK = 3.5; // of a vector that is pointed at, pixels
const THIN = 2.25;
const PALE = 0.4;
const READABLE = 24; // pixels from which on a vector has its letter

/** The vectors at a place, and of the light `pointed` in any case. */
export function vectorsAt(model: Model, probe: Probe, pointed: string | null): Vector[] {
    const { observer, scene, whole } = model;
    if (!observer || !scene || !whole) return [];
    const place = probe.position;
    const towards = (to: number[]) => unit(to.map((c, axis) => c - place[axis]));
    const view = observer.perspective ? towards(observer.position) : unit(whole.frame.axis);
    const lit = scene.lights.flatMap((light, i) => {
        if (!light.enabled || !(light.place || light.direction)) return [];
        const to = light.type === 'distant' ? unit(light.direction!.map((c) => -c)) : light.place && towards(light.place);
        return to && dot(to, probe.normal) > 0 ? [{ i, to, share: probe.shares[i] ?? 0 }] : [];
    });
    const first = lit.reduce<(typeof lit)[number] | null>((best, each) => (best && best.share >= each.share ? best : each), null);
    const half = lit.find(({ i }) => pointed === `H${i + 1}`) ?? first;
    const shown = lit.filter(({ i }, k) => k < MOST || pointed === `L${i + 1}`);
    return [
        ...shown.map(({ i, to }) => ({ key: `L${i + 1}`, letter: `L${'₁₂₃₄₅₆₇₈₉'[i] ?? ''}`, direction: to, colour: lightColour(i), share: 1.25 })),
        ...(half ? [{ key: 'H', letter: 'H', direction: unit(add(half.to, view, 1)), colour: '#ffd98a', share: 1.05 }] : []),
        { key: 'V', letter: 'V', direction: view, colour: '#c9ced6', share: 0.9 },
        { key: 'N', letter: 'N', direction: probe.normal as Place, colour: '#ffffff', share: 1.1 },
    ];
}

/** Draws vectors from a place; of one that is pointed at all others are pale. */
export function drawVectors(drawing: Drawing, vectors: Vector[], place: number[], length: number, pointed: string | null) {
    const { context } = drawing;
    const wanted = pointed?.startsWith('H') ? 'H' : pointed;
    context.font = 'italic 700 15px Georgia, "DejaVu Serif", serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    for (const { key, letter, direction, colour, share } of vectors) {
        context.globalAlpha = wanted && wanted !== key ? PALE : 1;
        const [x, y, pixels] = drawing.arrow(place, add(place, direction, share * length), colour, wanted === key ? THICK : THIN);
        if (pixels >= READABLE) drawing.words(letter, x, y, colour);
    }
    context.globalAlpha = 1;
}
