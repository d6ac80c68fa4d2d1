// SPDX-License-Identifier: MIT
// What the space view shows of bodies: pictures that the core computes as a camera at the view sees them, lit by the same
// sums as the observer's picture, with how far each pixel is.  The newest view wins; coarse pictures follow the hand, finer
// ones come when it rests.
import type { Client } from './client';
import type { Scale } from './colours';
import type { Samples } from './core';
import { Edges, type Distances } from './edges';
import type { Model } from './model';
import { along, unit, add, type Place } from './space_math';
import { paintSamples } from './srgb';
import type { Of } from './version';

/** A camera: where it is, the middle of what it looks at, its vectors to the right, upwards and back to it, and its scale. */
export interface View {
    eye: Place; // in mm
    target: Place;
    right: Place;
    up: Place;
    back: Place;
    distance: number; // from the target, mm
    factor: number; // pixels of the page for a mm at the target
    width: number; // of the canvas, pixels of the page
    height: number;
}

/** A picture of the bodies, and of which view it is. */
interface Made extends Samples {
    of: Of;
    view: View;
    stride: number; // pixels of the page across one of its own
    columns: number;
    rows: number;
    depth: Float32Array<ArrayBuffer>; // in half as many columns and rows
}

const STRIDES = [0.5, 1, 2, 4, 8, 16];
const STEPS = [14, 250, 1200, 6000, 24000]; // milliseconds that pictures of a view may take, one after the other
const SHARED = [14, 250, 700]; // by the worker that knows reflected light, for whose numbers others wait
const REST = 140; // milliseconds without a change after which the hand rests
const PATIENT = [200, 3200]; // milliseconds that a picture of a view that is gone may still take: twice as long after each that gave way
const MOST_PIXELS = 2.2e6;
const GRAINS = 1e9; // of a mm: what is less of a camera's numbers is rounding, and takes long to be read
const PER_PIXEL = 1.5e-4; // milliseconds, of a scene of which nothing is known yet
const LATE = 250; // milliseconds after which what is shown is of a view that is gone

const FAR_OFF = 8; // of the camera of an observer who looks along parallel lines, in sizes of the screen

const keyOf = (of: Of | null, view: View) =>
    [of?.number, of?.direct, of?.within, ...view.eye, ...view.target, ...view.up, view.factor, view.width, view.height].join();

/** A scene's text but its lights: whether bodies are the same; where it is written in unusual ways it says no. */
function withoutLights(text: string): string {
    return text.replace(/^lights:.*\n(?:[ \t#-].*\n|\n)*/m, '');
}

/** The numbers of a camera as the core takes them, and how many pixels it has. */
export function cameraOf(view: View, stride: number): { camera: number[]; columns: number; rows: number } {
    const even = (count: number) => 2 * Math.max(4, Math.round(count / 2));
    const columns = even(view.width / stride);
    const pixel = view.width / view.factor / columns;
    const rows = even(view.height / view.factor / pixel);
    const numbers = [...view.eye, ...view.target, ...view.up, columns * pixel, rows * pixel];
    return { camera: numbers.map((each) => Math.round(each * GRAINS) / GRAINS), columns, rows };
}

/**
 * The camera of the observer in a canvas, whose screen has so many pixels for a mm, its middle so many beside and above that of
 * the canvas; null: there is no scene yet.
 */
export function observerView({ whole, observer }: Model, factor: number, aside: number[], width: number, height: number): View | null {
    if (!whole || !observer) return null;
    const { corners, middle, axis } = whole.frame;
    const back = unit(axis);
    const [right, up] = [1, 3].map((i) => unit(corners[i].map((c, k) => c - corners[0][k])));
    const far = Math.hypot(...observer.position.map((c, k) => c - middle[k]));
    const distance = observer.perspective ? far : FAR_OFF * Math.max(...whole.screen, far);
    const target = along(middle, right, -aside[0] / factor, up, -aside[1] / factor);
    return { eye: add(target, back, distance), target, right, up, back, distance, factor, width, height };
}

/** Where a place is seen, in pixels of the page, and how far it is along the line of view. */
export function seenBy(view: View, place: number[]): [x: number, y: number, depth: number] {
    const off = place.map((coordinate, axis) => coordinate - view.target[axis]);
    const dot = (a: number[]) => a[0] * off[0] + a[1] * off[1] + a[2] * off[2];
    const depth = view.distance - dot(view.back);
    const factor = (view.factor * view.distance) / Math.max(depth, 0.02 * view.distance);
    return [view.width / 2 + factor * dot(view.right), view.height / 2 - factor * dot(view.up), depth];
}

export class Stage {
    /** What is shown; null: nothing yet. */
    made: Made | null = null;
    readonly image = document.createElement('canvas');
    private wanted: { view: View; of: Of; knowing: Client | null } | null = null; // and who knows its light
    private busy = false;
    private client: Client | null = null;
    private given = 0; // files that its worker has
    private patience = PATIENT[0];
    private perPixel = PER_PIXEL; // milliseconds, by the last picture
    private awaitedSince = 0; // when another view than the one shown was wanted; 0: it is shown
    private failed = ''; // the view of which the core made none
    private painted: unknown[] = [];
    private finest: (Distances & { key: string }) | null = null; // of the bodies in one view
    private edges: Edges | null = null; // by which a coarse picture takes those distances' edges

    constructor(
        private readonly model: Model,
        private readonly scale: () => Scale,
        private readonly onMade: () => void,
    ) {}

    /** Shows nothing: another scene was opened. */
    clear() {
        this.made = null;
        this.wanted = null;
        this.failed = '';
        this.painted = [];
        this.finest = this.edges = null;
        this.perPixel = PER_PIXEL;
        this.awaitedSince = 0;
    }

    /** Whether the view has changed for some time, and its picture has not come. */
    get isLate(): boolean {
        return this.awaitedSince > 0 && performance.now() - this.awaitedSince > LATE;
    }

    /** Asks for what is seen from here; what is shown meanwhile is of the view before. */
    want(view: View) {
        const lighting = this.model.lighting();
        if (!lighting || view.width < 8 || view.height < 8) return;
        const { of, client: knowing } = lighting;
        const { made } = this;
        const isOther = !!made && keyOf(null, made.view) !== keyOf(null, view);
        const hasMore = made?.of.number === of.number && !made.of.direct && of.direct; // which stays while better light is solved for
        this.wanted = hasMore && !isOther ? null : { view, of, knowing };
        if (isOther && !this.awaitedSince) {
            this.awaitedSince = performance.now();
            setTimeout(() => this.isLate && this.onMade(), LATE + 10);
        } else if (!isOther) this.awaitedSince = 0;
        if (!this.busy) void this.run();
    }

    private async run() {
        this.busy = true;
        while (this.wanted) {
            const { view, of, knowing } = this.wanted;
            const key = keyOf(of, view);
            const present = this.made && keyOf(this.made.of, this.made.view) === key ? this.made.stride : Infinity;
            const gainsLight = this.made?.of.number === of.number && keyOf(null, this.made.view) === keyOf(null, view);
            const steps = !knowing ? STEPS : gainsLight ? SHARED.slice(-1) : SHARED;
            const stride = this.next(view, present, steps);
            if (key === this.failed || stride === null) {
                this.wanted = null;
                break;
            }
            if (present !== Infinity) {
                await new Promise((resolve) => setTimeout(resolve, REST)); // the hand may still be moving
                if (this.isGone(key)) continue;
            }
            await this.make(view, of, knowing, stride, key);
        }
        this.busy = false;
    }

    private isGone(key: string): boolean {
        return !this.wanted || keyOf(this.wanted.of, this.wanted.view) !== key;
    }

    // The next finer stride of a view's pictures that is had in some time; null: there is none.
    private next(view: View, present: number, steps: number[]): number | null {
        const finest = Math.max(0.5, 1 / (window.devicePixelRatio || 1)) * 0.999;
        const pixels = (stride: number) => (view.width * view.height) / stride ** 2;
        for (const most of steps) {
            const goes = (stride: number) =>
                stride >= finest && pixels(stride) <= MOST_PIXELS && pixels(stride) * this.perPixel <= most;
            const stride = STRIDES.find(goes) ?? STRIDES[STRIDES.length - 1];
            if (stride < present) return stride;
        }
        return null;
    }

    // Its own worker, so that no number waits for it; another one when files have been given.
    private async worker(): Promise<Client> {
        const { client } = this.model;
        if (!this.client || this.given !== client.given) {
            this.client?.stop();
            this.given = client.given;
            this.client = await client.twin();
        }
        return this.client;
    }

    // On a busy machine a worker that is started anew each time would never come to an end.
    private giveWay() {
        this.client?.giveWay();
        this.patience = Math.min(2 * this.patience, PATIENT[1]);
    }

    private async make(view: View, of: Of, knowing: Client | null, stride: number, key: string) {
        const { camera, columns, rows } = cameraOf(view, stride);
        const timer = setInterval(() => !knowing && this.isGone(key) && this.giveWay(), this.patience);
        const ask = async () => (knowing ?? (await this.worker())).ask('stage', of, camera, columns, rows);
        const found = await ask().catch(() => undefined);
        clearInterval(timer);
        if (of.scene !== this.model.version.scene) return;
        if (found === undefined) {
            // It gave way to another one, or the core has failed and is started anew for the next.
            if (this.client?.isEnded) this.client = null;
            if (!this.isGone(key)) this.failed = key;
            return;
        }
        if (!found) {
            this.failed = key;
            return this.onMade();
        }
        this.patience = Math.max(PATIENT[0], this.patience / 2);
        this.perPixel = Math.max(1e-6, found.milliseconds / (columns * rows));
        this.awaitedSince = 0;
        this.made = { of, view, stride, columns, rows, values: found.values, mask: found.mask, rgb: found.rgb, depth: found.depth };
        this.keepFinest(this.made);
        this.onMade();
    }

    // Distances of a view stay those of the bodies while light alone changes.
    private keepFinest({ of, view, columns, rows, depth }: Made) {
        const key = keyOf(null, view) + withoutLights(of.text);
        if (this.finest?.key !== key || this.finest.columns <= columns / 2) this.finest = { key, columns: columns / 2, rows: rows / 2, depth };
        const isFiner = this.finest.columns > columns;
        if (!isFiner) this.edges = null;
        else if (!this.edges?.fits(this.finest, columns, rows)) this.edges = new Edges(this.finest, { columns, rows });
    }

    /** The picture in the colours of the scale. */
    picture(): HTMLCanvasElement | null {
        const { made } = this;
        if (!made) return null;
        const { map, low, high, logarithmic } = this.scale();
        const wanted = [made, map, low, high, logarithmic];
        if (wanted.some((each, i) => each !== this.painted[i])) {
            this.painted = wanted;
            const { columns, rows } = this.edges ?? made;
            const pixels = paintSamples(this.edges ? this.edges.apply(made) : made, this.scale(), false);
            this.image.width = columns;
            this.image.height = rows;
            this.image.getContext('2d')!.putImageData(new ImageData(pixels, columns, rows), 0, 0);
        }
        return this.image;
    }

    /** How far it is to what is seen at a point of the page; 0: nothing is there. */
    depthAt(x: number, y: number): number {
        const { made } = this;
        if (!made) return 0;
        const { columns, rows, depth } = this.edges && this.finest ? this.finest : { columns: made.columns / 2, rows: made.rows / 2, depth: made.depth };
        const column = Math.floor((x / made.view.width) * columns);
        const row = Math.floor(((y - made.view.height / 2) * columns) / made.view.width + rows / 2);
        if (column < 0 || row < 0 || column >= columns || row >= rows) return 0;
        return depth[row * columns + column];
    }

    /** The size of the picture's pixels in pixels of the page. */
    pixel(): number {
        return this.made ? this.made.view.width / (this.edges ?? this.made).columns : 1;
    }

    /** Whether a body hides a place, which is seen at a point and so far. */
    hides([x, y, depth]: [number, number, number]): boolean {
        const before = this.depthAt(x, y);
        return before > 0 && before < depth * (1 - 2e-3);
    }
}
