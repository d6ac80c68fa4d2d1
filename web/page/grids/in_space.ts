// SPDX-License-Identifier: MIT
// Measuring grids and their observers in space: the numbers of cells, the edges of grids and of the strips around them, the
// ways that eyes look, in the colours of what is said of their limits.
import type { Limit } from '../core';
import { faded, styleColour } from '../dom';
import type { Drawing } from '../drawing';
import type { Place } from '../space_math';

const CELL = [18, 15]; // pixels that a number of a cell takes, of its width the half

export interface InSpace {
    cells: { at: Place; text: string }[];
    /** Edges, which are closed, and ways of looking, which begin at the eye; null: there is nothing to keep. */
    lines: { places: Place[]; isClosed: boolean; verdict: Limit['verdict'] | null; isStrip?: boolean }[];
}

export const NOTHING_MEASURED: InSpace = { cells: [], lines: [] };

const COLOURS = { pass: '--good', fail: '--error', undecided: '--dim' };

export function drawMeasured(drawing: Drawing, { cells, lines }: InSpace) {
    for (const line of lines) drawLine(drawing, line);
    if (cells.length) drawCells(drawing, cells);
}

function drawLine(drawing: Drawing, { places, isClosed, verdict, isStrip }: InSpace['lines'][number]) {
    const { context } = drawing;
    const colour = styleColour(verdict === null ? '--dim' : COLOURS[verdict]);
    if (isStrip) context.setLineDash([6, 4]);
    for (const [style, width] of [[faded(styleColour('--paper'), 0.6), 3.5], [colour, 1.75]] as const) {
        context.strokeStyle = style;
        context.lineWidth = width;
        drawing.line(places, isClosed);
    }
    context.setLineDash([]);
    context.lineWidth = 1;
    if (isClosed) return;
    const [x, y] = drawing.seen(places[0]);
    context.beginPath();
    context.arc(x, y, 4.5, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.fill();
}

// Numbers that would lie on others are left out until the view is near enough.
function drawCells(drawing: Drawing, cells: InSpace['cells']) {
    const { context } = drawing;
    context.font = '600 11px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    const taken = new Set<string>();
    for (const { at, text } of cells) {
        const [x, y] = drawing.seen(at);
        const spots = [-1, 0, 1].map((aside) => [Math.round(x / CELL[0]) + aside, Math.round(y / CELL[1])].join());
        if (spots.some((spot) => taken.has(spot))) continue;
        taken.add(spots[1]);
        context.globalAlpha = drawing.isHidden(at) ? 0.35 : 1;
        drawing.words(text, x, y);
    }
    context.globalAlpha = 1;
}
