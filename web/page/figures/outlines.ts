// SPDX-License-Identifier: MIT
// Letters as outlines: a letter of the page's face is drawn large and the edge of its ink is followed, between pixels, so that
// drawings for print have letters of any language without a font inside.

const SIZE = 160; // pixels of the em
const [LEFT, BASE, HEIGHT] = [40, 180, 240]; // of the canvas: room beside the letter, its base line
const HALF = 127.5; // of the ink
const FINE = 0.12; // pixels that an outline may be off

/** A letter: how far the next one is, and its outlines, in parts of the em with y upwards. */
export interface Letter {
    advance: number;
    outlines: [number, number][][];
}

// The ways through a square of four pixels, from one of its sides to another, ink at the left: by the corners that have ink, of
// which the upper left one counts 1, then clockwise 2, 4, 8.  Sides: 0 upper, 1 right, 2 lower, 3 left.
const WAYS: Record<number, [number, number][]> = {
    1: [[3, 0]], 2: [[0, 1]], 3: [[3, 1]], 4: [[1, 2]], 5: [[3, 0], [1, 2]], 6: [[0, 2]], 7: [[3, 2]],
    8: [[2, 3]], 9: [[2, 0]], 10: [[0, 1], [2, 3]], 11: [[2, 1]], 12: [[1, 3]], 13: [[1, 0]], 14: [[0, 3]],
};

/** A letter by the weight and the family of its face, as CSS has them. */
export function letterOf(sign: string, weight: string, family: string): Letter {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    const face = `${weight} ${SIZE}px ${family}`;
    context.font = face;
    const advance = context.measureText(sign).width;
    [canvas.width, canvas.height] = [Math.ceil(advance) + 2 * LEFT, HEIGHT];
    context.font = face; // a canvas of another size has forgotten it
    context.fillText(sign, LEFT, BASE);
    const { data, width, height } = context.getImageData(0, 0, canvas.width, canvas.height);
    const ink = Float32Array.from({ length: width * height }, (_, i) => data[4 * i + 3]);
    const outlines = edgesOf(ink, width, height).map((edge) => simplified(edge).map(([x, y]): [number, number] => [(x - LEFT) / SIZE, (BASE - y) / SIZE]));
    return { advance: advance / SIZE, outlines };
}

/** The closed lines along which the ink is half. */
function edgesOf(ink: Float32Array, width: number, height: number): [number, number][][] {
    const next = new Map<number, number>(); // from side to side of squares, by their numbers
    const side = (x: number, y: number, which: number) => [2 * (y * width + x), 2 * (y * width + x + 1) + 1, 2 * ((y + 1) * width + x), 2 * (y * width + x) + 1][which];
    for (let y = 0; y + 1 < height; y++)
        for (let x = 0; x + 1 < width; x++) {
            const at = y * width + x;
            const corners = [at, at + 1, at + width + 1, at + width].reduce((sum, pixel, i) => sum + (ink[pixel] > HALF ? 1 << i : 0), 0);
            for (const [from, to] of WAYS[corners] ?? []) next.set(side(x, y, from), side(x, y, to));
        }
    // Where a side is crossed: between its two pixels, as their ink tells.
    const crossing = (number: number): [number, number] => {
        const [first, isUpright] = [number >> 1, number & 1];
        const second = first + (isUpright ? width : 1);
        const share = (HALF - ink[first]) / (ink[second] - ink[first]);
        const [x, y] = [(first % width) + 0.5, Math.floor(first / width) + 0.5];
        return isUpright ? [x, y + share] : [x + share, y];
    };
    const found: [number, number][][] = [];
    while (next.size) {
        const edge: [number, number][] = [];
        let [at] = next.keys();
        for (let to = next.get(at); to !== undefined; to = next.get(at)) {
            edge.push(crossing(at));
            next.delete(at);
            at = to;
        }
        found.push(edge);
    }
    return found;
}

// A closed line with fewer corners, none of the old ones farther from it than is fine: each half by the corner farthest away.
function simplified(edge: [number, number][]): [number, number][] {
    const kept = new Set([0]);
    const keep = (from: number, to: number) => {
        const [[x0, y0], [x1, y1]] = [edge[from], edge[to % edge.length]];
        const length = Math.hypot(x1 - x0, y1 - y0);
        let [farthest, most] = [from, FINE];
        for (let i = from + 1; i < to; i++) {
            const [x, y] = edge[i];
            const off = length ? Math.abs((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)) / length : Math.hypot(x - x0, y - y0);
            if (off > most) [farthest, most] = [i, off];
        }
        if (farthest === from) return;
        kept.add(farthest);
        keep(from, farthest);
        keep(farthest, to);
    };
    keep(0, edge.length);
    return edge.filter((_, i) => kept.has(i));
}
