// SPDX-License-Identifier: MIT
// Lines, fills and glows of the space view, which bodies hide where they stand before them: by the depths that came with
// the picture of the bodies.
import { faded } from './dom';
import { seenBy, type Stage, type View } from './stage';

const STEP = 7; // pixels of a line that are hidden together or not
const HIDDEN = 0.16; // how much of what is hidden is still seen
const COARSE = 2; // pixels across of a fill that are hidden together

type Point = [x: number, y: number, depth: number];

// What fills are painted on before they come to the view; one for all, as a new one takes longer than what is painted.
const [layer, mask] = [0, 1].map(() => document.createElement('canvas'));

export class Drawing {
    constructor(
        readonly context: CanvasRenderingContext2D,
        private readonly stage: Pick<Stage, 'hides' | 'depthAt'> | null, // null: nothing hides anything
        readonly view: View,
        private readonly ratio: number,
    ) {}

    seen(place: number[]): Point {
        return seenBy(this.view, place);
    }

    isHidden(place: number[]): boolean {
        return !!this.stage?.hides(this.seen(place));
    }

    /** A line through places; where bodies hide it, it is faint. */
    line(places: number[][], isClosed = false) {
        const { context } = this;
        const points = places.map((place) => this.seen(place));
        if (isClosed) points.push(points[0]);
        const [open, hidden] = [new Path2D(), new Path2D()];
        for (let i = 1; i < points.length; i++) {
            const [from, to] = [points[i - 1], points[i]];
            const count = Math.min(200, Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / STEP)));
            const at = (share: number) => from.map((each, k) => each + share * (to[k] - each)) as Point;
            for (let k = 0; k < count; k++) {
                const path = this.stage?.hides(at((k + 0.5) / count)) ? hidden : open;
                const [start, end] = [at(k / count), at((k + 1) / count)];
                path.moveTo(start[0], start[1]);
                path.lineTo(end[0], end[1]);
            }
        }
        context.stroke(open);
        context.save();
        context.globalAlpha *= HIDDEN;
        context.stroke(hidden);
        context.restore();
    }

    /** An arrow with a casing, which nothing hides; returns where its letter stands. */
    arrow(from: number[], to: number[], colour: string, width = 2.25): [number, number, number] {
        const { context } = this;
        const [[x0, y0], [x1, y1]] = [this.seen(from), this.seen(to)];
        const length = Math.hypot(x1 - x0, y1 - y0);
        const [ux, uy] = length > 0 ? [(x1 - x0) / length, (y1 - y0) / length] : [1, 0];
        const head = Math.min(11, length * 0.6);
        const [bx, by] = [x1 - ux * head * 0.8, y1 - uy * head * 0.8];
        const trace = () => {
            context.beginPath();
            context.moveTo(x0, y0);
            context.lineTo(bx, by);
            context.stroke();
            context.beginPath();
            context.moveTo(x1, y1);
            context.lineTo(x1 - ux * head - uy * head * 0.42, y1 - uy * head + ux * head * 0.42);
            context.lineTo(x1 - ux * head + uy * head * 0.42, y1 - uy * head - ux * head * 0.42);
            context.closePath();
        };
        context.lineJoin = context.lineCap = 'round';
        context.strokeStyle = context.fillStyle = 'rgb(0 0 0 / 38%)';
        context.lineWidth = width + 2.75;
        trace();
        context.stroke();
        context.strokeStyle = context.fillStyle = colour;
        context.lineWidth = width;
        trace();
        context.fill();
        context.lineCap = 'butt';
        return [x1 + ux * 13, y1 + uy * 13, length];
    }

    /**
     * Fills an outline in a plane, of which three places are told; what bodies before the plane hide of it is left out.
     */
    fill(outline: number[][], plane: number[][], style: (context: CanvasRenderingContext2D) => string | CanvasGradient) {
        const { context, ratio } = this;
        const points = outline.map((place) => this.seen(place));
        if (points.some(([, , depth]) => depth < 0.05 * this.view.distance)) return;
        const [left, right] = [Math.min, Math.max].map((pick) => pick(...points.map(([x]) => x)));
        const [top, low] = [Math.min, Math.max].map((pick) => pick(...points.map(([, y]) => y)));
        const [x0, y0] = [Math.max(0, Math.floor(left)), Math.max(0, Math.floor(top))];
        const width = Math.min(this.view.width, Math.ceil(right)) - x0;
        const height = Math.min(this.view.height, Math.ceil(low)) - y0;
        if (width < 1 || height < 1) return;
        layer.width = Math.ceil(width * ratio);
        layer.height = Math.ceil(height * ratio);
        const on = layer.getContext('2d')!;
        on.setTransform(ratio, 0, 0, ratio, -x0 * ratio, -y0 * ratio);
        on.beginPath();
        points.forEach(([x, y], i) => (i ? on.lineTo(x, y) : on.moveTo(x, y)));
        on.closePath();
        on.fillStyle = style(on);
        on.fill();
        if (this.covers(plane, x0, y0, width, height)) {
            on.globalCompositeOperation = 'destination-out';
            on.drawImage(mask, x0, y0, mask.width * COARSE, mask.height * COARSE);
        }
        context.drawImage(layer, x0, y0, layer.width / ratio, layer.height / ratio);
    }

    // Paints into the mask where bodies stand before a plane; false: nowhere, or the plane is seen on edge.
    private covers(plane: number[][], x0: number, y0: number, width: number, height: number): boolean {
        // In perspective the inverse of the distance changes evenly over the picture of a plane.
        const [a, b, c] = plane.map((place) => this.seen(place));
        const inverse = [a, b, c].map(([, , depth]) => 1 / depth);
        const [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
        const area = ux * vy - uy * vx;
        if (Math.abs(area) < 1e-6) return false;
        const [p, q] = [inverse[1] - inverse[0], inverse[2] - inverse[0]];
        const [gx, gy] = [(p * vy - q * uy) / area, (q * ux - p * vx) / area];
        const [columns, rows] = [Math.ceil(width / COARSE), Math.ceil(height / COARSE)];
        const pixels = new Uint32Array(columns * rows);
        let isAny = false;
        for (let row = 0; row < rows; row++)
            for (let column = 0; column < columns; column++) {
                const [x, y] = [x0 + (column + 0.5) * COARSE, y0 + (row + 0.5) * COARSE];
                const depth = this.stage?.depthAt(x, y) ?? 0;
                if (depth > 0 && 1 / depth > inverse[0] + gx * (x - a[0]) + gy * (y - a[1]) + 1e-9) {
                    pixels[row * columns + column] = 0xff000000;
                    isAny = true;
                }
            }
        if (!isAny) return false;
        mask.width = columns;
        mask.height = rows;
        const image = new ImageData(new Uint8ClampedArray(pixels.buffer), columns, rows);
        mask.getContext('2d')!.putImageData(image, 0, 0);
        return true;
    }

    /** The glow around a lamp. */
    glow(x: number, y: number, colour: string, strength: number) {
        const { context } = this;
        const gradient = context.createRadialGradient(x, y, 4, x, y, 36);
        gradient.addColorStop(0, colour);
        gradient.addColorStop(0.35, faded(colour, 0.45));
        gradient.addColorStop(1, faded(colour, 0));
        context.save();
        context.globalAlpha = strength;
        context.fillStyle = gradient;
        context.beginPath();
        context.arc(x, y, 36, 0, 2 * Math.PI);
        context.fill();
        context.restore();
    }

    /** A ring around what the hand is on. */
    ring(x: number, y: number, radius: number) {
        const { context } = this;
        for (const [colour, width] of [['rgb(0 0 0 / 45%)', 3.5], ['#fff', 2]] as const) {
            context.beginPath();
            context.arc(x, y, radius, 0, 2 * Math.PI);
            context.strokeStyle = colour;
            context.lineWidth = width;
            context.stroke();
        }
        context.lineWidth = 1;
    }

    /** Words with an edge, so that they are read on anything. */
    words(text: string, x: number, y: number, colour = '#fff') {
        const { context } = this;
        context.lineJoin = 'round';
        context.lineWidth = 2.5;
        context.strokeStyle = colour === '#fff' ? 'rgb(24 25 28 / 80%)' : 'rgb(0 0 0 / 50%)';
        context.strokeText(text, x, y);
        context.fillStyle = colour;
        context.fillText(text, x, y);
    }
}
