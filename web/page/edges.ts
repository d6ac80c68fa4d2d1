// SPDX-License-Identifier: MIT
// Coarse pictures of the stage with the edges of bodies in their places: while light alone changes, the distances that came
// with the finest picture of the view tell which of the coarse samples around a pixel belong to what is seen there.
import type { Samples } from './core';

/** How far it is to what is seen, pixel by pixel; 0: nothing is there. */
export interface Distances {
    columns: number;
    rows: number;
    depth: Float32Array;
}

const ALIKE = 0.012; // relative difference of distances within which samples are of one surface
const LEAST = 1e-4; // weight of the others, for what no sample has met

/** Shares of coarse samples in each finer pixel. */
export class Edges {
    readonly columns: number;
    readonly rows: number;
    private readonly weights: Float32Array; // four of each pixel
    private readonly from: Int32Array; // the first of its four samples; -1: nothing is there

    constructor(
        private readonly fine: Distances,
        private readonly coarse: { columns: number; rows: number },
    ) {
        [this.columns, this.rows] = [fine.columns, fine.rows];
        this.weights = new Float32Array(4 * fine.columns * fine.rows);
        this.from = new Int32Array(fine.columns * fine.rows).fill(-1);
        for (let row = 0; row < fine.rows; row++) for (let column = 0; column < fine.columns; column++) this.weigh(column, row);
    }

    /** Whether it is for such pictures. */
    fits(fine: Distances, columns: number, rows: number): boolean {
        return this.fine === fine && this.coarse.columns === columns && this.coarse.rows === rows;
    }

    // The inverse of the distance, which is even over the picture of a plane; 0: nothing is there.
    private inverse(column: number, row: number): number {
        const { columns, rows, depth } = this.fine;
        if (column < 0 || row < 0 || column >= columns || row >= rows) return 0;
        const far = depth[row * columns + column];
        return far > 0 ? 1 / far : 0;
    }

    // How it changes from one pixel to the next on the same surface: the lesser of the changes to the two sides.
    private slope(here: number, before: number, after: number): number {
        const [a, b] = [before ? here - before : Infinity, after ? after - here : Infinity];
        const least = Math.abs(a) < Math.abs(b) ? a : b;
        return Number.isFinite(least) ? least : 0;
    }

    private weigh(column: number, row: number) {
        const { columns } = this.fine;
        const { coarse } = this;
        const here = this.inverse(column, row);
        if (!here) return;
        const [sx, sy] = [this.columns / coarse.columns, this.rows / coarse.rows];
        const [u, v] = [(column + 0.5) / sx - 0.5, (row + 0.5) / sy - 0.5];
        const x0 = Math.max(0, Math.min(coarse.columns - 2, Math.floor(u)));
        const y0 = Math.max(0, Math.min(coarse.rows - 2, Math.floor(v)));
        const across = this.slope(here, this.inverse(column - 1, row), this.inverse(column + 1, row));
        const down = this.slope(here, this.inverse(column, row - 1), this.inverse(column, row + 1));
        const pixel = row * columns + column;
        this.from[pixel] = y0 * coarse.columns + x0;
        const [fx, fy] = [Math.max(0, Math.min(1, u - x0)), Math.max(0, Math.min(1, v - y0))];
        let sum = 0;
        for (let k = 0; k < 4; k++) {
            const [i, j] = [k & 1, k >> 1];
            const [cx, cy] = [Math.floor((x0 + i + 0.5) * sx), Math.floor((y0 + j + 0.5) * sy)];
            const there = this.inverse(cx, cy);
            const off = Math.abs(here + across * (cx - column) + down * (cy - row) - there) / here / ALIKE;
            const near = (i ? fx : 1 - fx) * (j ? fy : 1 - fy) + 1e-3;
            const weight = there ? near / (1 + off ** 4) + LEAST * near : 0;
            this.weights[4 * pixel + k] = weight;
            sum += weight;
        }
        if (sum > 0) for (let k = 0; k < 4; k++) this.weights[4 * pixel + k] /= sum;
        else this.from[pixel] = -1;
    }

    /** The finer picture of coarse samples, and where it has something. */
    apply({ values, mask, rgb }: Samples): Samples {
        const shown = new Uint8Array(this.from.length);
        const finer = new Float32Array(this.from.length);
        this.spread(values, 1, 0, mask, finer, shown);
        if (!rgb) return { values: finer, mask: shown };
        const colours = new Float32Array(3 * this.from.length);
        for (let channel = 0; channel < 3; channel++) this.spread(rgb, 3, channel, mask, colours, shown);
        return { values: finer, mask: shown, rgb: colours };
    }

    // One of so many numbers of each sample.
    private spread(of: Float32Array, step: number, first: number, mask: Uint8Array, finer: Float32Array, shown: Uint8Array) {
        const { columns } = this.coarse;
        const { weights } = this;
        for (let pixel = 0; pixel < this.from.length; pixel++) {
            const corner = this.from[pixel];
            if (corner < 0) continue;
            let [sum, all] = [0, 0];
            for (let k = 0; k < 4; k++) {
                const sample = corner + (k & 1) + (k >> 1) * columns;
                if (!mask[sample]) continue;
                sum += weights[4 * pixel + k] * of[step * sample + first];
                all += weights[4 * pixel + k];
            }
            if (!(all > 0)) continue;
            finer[step * pixel + first] = sum / all;
            shown[pixel] = 1;
        }
    }
}
