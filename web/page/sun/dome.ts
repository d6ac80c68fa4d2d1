// SPDX-License-Identifier: MIT
// The dome of a sun that is chosen: the horizon with the points of the compass, and the way of the sun over its day, or up from
// the horizon.
import { lightColour } from '../dom';
import type { Drawing } from '../drawing';
import type { Thing } from '../geometry';
import { add, circle } from '../space_math';
import { wayOf, type Sun } from './sun';
import { currentLanguage } from '../words';

const POINTS = { en: 'NESW', ru: 'СВЮЗ' }; // of the compass

export function drawDome(drawing: Drawing, { at, from, index }: Thing, sun: Sun) {
    const { context } = drawing;
    const radius = Math.hypot(...at.map((c, axis) => c - from![axis]));
    context.strokeStyle = lightColour(index);
    context.lineWidth = 1.25;
    drawing.line(wayOf(sun).map((way) => add(from!, way, radius)));
    context.globalAlpha = 0.5;
    drawing.line(circle(from!, sun.east, sun.north, radius), true);
    context.globalAlpha = 1;
    context.lineWidth = 1;
    context.font = '600 12px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    [...POINTS[currentLanguage()]].forEach((name, i) => {
        const [x, y] = drawing.seen(add(from!, i % 2 ? sun.east : sun.north, (i < 2 ? 1.06 : -1.06) * radius));
        drawing.words(name, x, y);
    });
}
