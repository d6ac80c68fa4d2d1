// SPDX-License-Identifier: MIT
// The picture: samples in the colours of the bar, lamps where they are seen, isophotes, measuring points and the probe.
import type { Isophote, Probe } from './core';
import type { Scale } from './colours';
import type { Compare, Shown } from './compare';
import { fitted, h, numberMark, styleColour } from './dom';
import { nextOf } from './choosing';
import { Drag, followPointer, movesOf, type Action } from './drag';
import type { Model, Thing } from './model';
import type { SectionPanel } from './section';
import { paintSamples, showsColours } from './srgb';
import { Drawing } from './drawing';
import type { Several } from './several';
import { observerView } from './stage';
import { drawVectors, vectorsAt } from './vectors';
import { number, t } from './words';

interface Mark {
    thing: Thing;
    seen: number[]; // x and y on the screen, height above it
}

const CLOSEST = 256; // the largest zoom
const WIDE = 44; // pixels of the page across a pixel of the picture that its number stands in

export class PictureView {
    readonly canvas = h('canvas', { tabindex: 0, class: 'picture', role: 'application' });
    readonly scale: Scale = { map: 'tone', logarithmic: false, locked: false, low: 0, high: 1, exposure: 0 };
    showsIsophotes = false;
    selected: Thing | null = null;
    probe: [number, number] | null = null;
    /** The place that a task asks about. */
    asked: [number, number] | null = null;
    /** What is known of the probe, and the vector at it that is pointed at elsewhere, as the space view has it. */
    known: Probe | null = null;
    lit: string | null = null;
    /** Told the lamp or aim that the hand is on, and where; null: on none. */
    onMark: (thing: Thing | null, x: number, y: number) => void = () => undefined;
    /** Told that something was dragged to a place. */
    onDrag: (place: number[] | null, x: number, y: number) => void = () => undefined;
    /** Whether no numbers of values are shown. */
    hidesValues = false;
    onProbe: (x: number, y: number) => void = () => undefined;
    onWhy: () => void = () => undefined;
    onPaint: () => void = () => undefined;
    onSelect: (thing: Thing) => void = () => undefined;
    private readonly differences: Scale = { ...this.scale, map: 'difference' };
    private marks: Mark[] = [];
    private isophotes: Isophote[] = [];
    readonly image = document.createElement('canvas'); // the samples in their colours
    private imageScreen = ''; // the size of the screen that they are of
    private isDrawn = true;
    private isDragging = false;
    private zoom = 1;
    private middle: [number, number] = [0, 0]; // of the view, in mm on the screen
    /** Told where a hand is on the picture, in pixels; null: it has left. */
    onHand: (x: number, y: number | null) => void = () => undefined;

    constructor(
        private readonly model: Model,
        private readonly compare: Compare,
        private readonly section: SectionPanel,
        private readonly several: Several,
    ) {
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        this.canvas.addEventListener('pointermove', (event) => this.hover(event));
        this.canvas.addEventListener('pointerleave', () => {
            this.onHand(0, null);
            this.onMark(null, 0, 0);
        });
        this.canvas.addEventListener('keydown', (event) => this.key(event));
        this.canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
        followPointer(
            this.canvas,
            (x, y, event) => (event.button === 2 ? this.beginPan(x, y) : this.begin(x, y, event.ctrlKey || event.metaKey)),
            (factor, x, y, dx, dy) => this.zoomAt(factor, x, y, dx, dy),
            true,
        );
    }

    relabel() {
        this.canvas.setAttribute(
            'aria-label',
            t('Picture. Arrow keys move the probe, Shift moves it faster, Enter explains the value. Space selects the next lamp, Ctrl and arrows move it. Plus, minus and 0 zoom.'),
        );
    }

    /** The range of the colour bar for a new picture, unless it is locked. */
    private adapt(shown: Shown) {
        const { scale } = this;
        const { least, most, brightest } = shown;
        if (scale.locked) return;
        const factor = 2 ** -scale.exposure;
        scale.high = factor * (showsColours(shown, scale) ? brightest : most);
        scale.low = scale.logarithmic ? Math.max(factor * least, scale.high * 1e-3) : 0;
    }

    /** What the colours mean: the range of the pictures, or of differences, which no control changes. */
    get shownScale(): Scale {
        return this.compare.shown()?.isDifference ? this.differences : this.scale;
    }

    async pictureChanged() {
        const shown = this.compare.shown();
        if (!shown) return;
        if (shown.isDifference) Object.assign(this.differences, { low: shown.least, high: shown.most });
        else this.adapt(shown);
        this.isophotes = [];
        this.repaint();
        const { picture } = this.model;
        if (!this.showsIsophotes || !picture) return;
        const found = await this.model.isophotes(picture, this.scale.logarithmic);
        if (picture !== this.model.picture || !this.showsIsophotes) return;
        this.isophotes = found;
        this.draw();
    }

    repaint() {
        const shown = this.compare.shown();
        if (!shown) return;
        const { columns, rows } = shown;
        this.imageScreen = this.model.screen.join();
        this.image.width = columns;
        this.image.height = rows;
        const { locked, logarithmic, exposure } = this.scale;
        const isWhole = !(locked || logarithmic || exposure);
        const pixels = paintSamples(shown, shown.isDifference ? this.differences : this.scale, isWhole);
        this.image.getContext('2d')!.putImageData(new ImageData(pixels, columns, rows), 0, 0);
        this.onPaint();
        this.draw();
    }

    geometryChanged() {
        this.marks = this.model.things.flatMap((thing) => (thing.seen ? [{ thing, seen: thing.seen }] : []));
        this.draw();
    }

    /** The zoom and the middle of what is seen, in mm on the screen. */
    get view(): number[] {
        return [this.zoom, ...this.middle];
    }

    set view([zoom, x, y]: number[]) {
        this.zoom = Math.max(1, Math.min(CLOSEST, zoom));
        this.middle = [x, y];
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.marks = [];
        this.isophotes = [];
        this.selected = null;
        this.probe = this.known = null;
        [this.zoom, this.middle] = [1, [0, 0]];
        this.image.width = this.image.height = 1;
        this.onPaint();
        this.draw();
    }

    /** The isophotes that are shown. */
    get linesOfEqualValue(): Isophote[] {
        return this.showsIsophotes ? this.isophotes : [];
    }

    /** The samples in their colours, if they are of the screen that the scene has now. */
    get shownImage(): HTMLCanvasElement | null {
        return this.model.picture && this.imageScreen === this.model.screen.join() ? this.image : null;
    }

    /** Zooms by a factor around a point of the canvas, which moves by dx and dy. */
    private zoomAt(factor: number, x: number, y: number, dx = 0, dy = 0) {
        const [sx, sy] = this.toScreen(x, y);
        this.zoom = Math.max(1, Math.min(CLOSEST, this.zoom * factor));
        const [tx, ty] = this.toScreen(x + dx, y + dy);
        const [w, h] = this.model.screen;
        const within = (place: number, size: number) => Math.max(-size / 2, Math.min(size / 2, place));
        this.middle = this.zoom === 1 ? [0, 0] : [within(this.middle[0] + sx - tx, w), within(this.middle[1] + sy - ty, h)];
        this.draw();
    }

    /** Zooms around the middle; 0: all of the picture. */
    zoomBy(factor: number) {
        const { width, height } = this.canvas.getBoundingClientRect();
        this.zoomAt(factor || 1 / this.zoom, width / 2, height / 2);
    }

    private wheel(event: WheelEvent) {
        // In the frame of another page that one is scrolled; pads send Ctrl where two fingers spread.
        if (!event.ctrlKey && document.documentElement.dataset.view) return;
        event.preventDefault();
        const { left, top } = this.canvas.getBoundingClientRect();
        this.zoomAt(Math.exp(-event.deltaY * 0.001), event.clientX - left, event.clientY - top);
    }

    /** Selects the next lamp or aim, or the one before. */
    selectNext(step: number) {
        const things = this.marks.map(({ thing }) => thing);
        if (things.length) this.onSelect(nextOf(things, this.selected, step));
    }

    draw() {
        if (!this.isDrawn) return;
        this.isDrawn = false;
        requestAnimationFrame(() => {
            this.isDrawn = true;
            this.drawNow();
        });
    }

    // The screen in the canvas: whole, with room around it for lamps beside it, or part of it.
    frame(width: number, height: number) {
        const [w, h] = this.model.screen;
        const [mx, my] = this.middle;
        const factor = 0.86 * this.zoom * Math.min(width / w, height / h);
        const [left, top] = [width / 2 - (w / 2 + mx) * factor, height / 2 - (h / 2 - my) * factor];
        return { factor, left, top, w: w * factor, h: h * factor };
    }

    private toCanvas(x: number, y: number, width: number, height: number): [number, number] {
        const { factor } = this.frame(width, height);
        return [width / 2 + (x - this.middle[0]) * factor, height / 2 - (y - this.middle[1]) * factor];
    }

    /** The point of the screen under a point of the canvas, in mm. */
    private toScreen(x: number, y: number): [number, number] {
        const { width, height } = this.canvas.getBoundingClientRect();
        const { factor } = this.frame(width, height);
        return [(x - width / 2) / factor + this.middle[0], (height / 2 - y) / factor + this.middle[1]];
    }

    private drawNow() {
        const [width, height, context] = fitted(this.canvas);
        if (!this.model.whole) return;
        const { left, top, w, h } = this.frame(width, height);
        context.fillStyle = '#000';
        context.fillRect(left, top, w, h);
        context.imageSmoothingEnabled = (this.model.picture?.stride ?? 1) > 1;
        const image = this.shownImage;
        if (image) context.drawImage(image, left, top, w, h);
        context.strokeStyle = styleColour('--line');
        context.lineWidth = 1;
        context.strokeRect(left - 0.5, top - 0.5, w + 1, h + 1);
        if (this.compare.which === 'B') this.drawIsophotes(context, width, height);
        this.drawNumbers(context, width, height);
        this.drawSection(context, width, height);
        this.drawPoints(context, width, height);
        this.drawMarks(context, width, height);
        this.drawProbe(context, width, height);
        this.drawVectors(context, width, height);
    }

    // The vectors at the probe while one is pointed at.
    private drawVectors(context: CanvasRenderingContext2D, width: number, height: number) {
        const { known, lit } = this;
        if (!lit || !known || known.surface === null) return;
        const { factor } = this.frame(width, height);
        const [x, y] = this.toCanvas(0, 0, width, height);
        const view = observerView(this.model, factor, [x - width / 2, height / 2 - y], width, height);
        if (!view) return;
        const length = Math.min(80, 0.17 * Math.min(width, height)) / factor;
        drawVectors(new Drawing(context, null, view, 1), vectorsAt(this.model, known, lit), known.position, length, lit);
    }

    private drawIsophotes(context: CanvasRenderingContext2D, width: number, height: number) {
        context.lineWidth = 1;
        const taken: [number, number][] = []; // where levels are told
        for (const line of this.isophotes) {
            const places = line.x.map((x, i) => this.toCanvas(x, line.y[i], width, height));
            context.strokeStyle = '#ff5db1';
            context.beginPath();
            places.forEach((place, i) => (i ? context.lineTo(...place) : context.moveTo(...place)));
            if (line.closed) context.closePath();
            context.stroke();
            const place = labelPlace(places, width, height, taken);
            if (!place) continue;
            taken.push(place);
            this.wordsOn(context, number(line.level, 3), ...place, '#ffc2e2');
        }
    }

    // The numbers of the pixels, where those are large enough to be read.
    private drawNumbers(context: CanvasRenderingContext2D, width: number, height: number) {
        const shown = this.compare.shown();
        const { picture } = this.model;
        if (!shown || this.hidesValues || picture?.stride !== 1 || !this.model.isCurrent(picture.of)) return;
        const { left, top, w, h } = this.frame(width, height);
        const { columns, rows, values, mask } = shown;
        const [across, down] = [w / columns, h / rows];
        if (across < WIDE) return;
        const first = (from: number, size: number) => Math.max(0, Math.floor(-from / size));
        const last = (from: number, size: number, count: number, all: number) => Math.min(count - 1, Math.floor((all - from) / size));
        for (let row = first(top, down); row <= last(top, down, rows, height); row++)
            for (let column = first(left, across); column <= last(left, across, columns, width); column++) {
                const i = row * columns + column;
                if (mask[i]) this.wordsOn(context, number(values[i], 4), left + (column + 0.5) * across, top + (row + 0.5) * down, '#fff');
            }
    }

    private wordsOn(context: CanvasRenderingContext2D, text: string, x: number, y: number, colour: string) {
        context.font = '600 11px system-ui, sans-serif';
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        context.lineJoin = 'round';
        context.lineWidth = 3;
        context.strokeStyle = 'rgb(16 17 20 / 80%)';
        context.strokeText(text, x, y);
        context.fillStyle = colour;
        context.fillText(text, x, y);
        context.lineWidth = 1;
    }

    // The line of the section; its ends can be taken where it stays.
    private drawSection(context: CanvasRenderingContext2D, width: number, height: number) {
        const { last, fixed } = this.section;
        if (!last) return;
        const ends = (fixed ?? [last.from, last.to]).map((end) => this.toCanvas(end[0], end[1], width, height));
        for (const [style, line, dashes] of [
            ['#000', 2.5, []],
            ['#ffd54a', 1, [6, 4]],
        ] as const) {
            context.strokeStyle = style;
            context.globalAlpha = fixed ? 1 : 0.45;
            context.lineWidth = line;
            context.setLineDash([...dashes]);
            context.beginPath();
            context.moveTo(...ends[0]);
            context.lineTo(...ends[1]);
            context.stroke();
        }
        context.setLineDash([]);
        for (const [x, y] of fixed ? ends : []) {
            context.fillStyle = '#ffd54a';
            context.fillRect(x - 6, y - 6, 12, 12);
            context.lineWidth = 1.5;
            context.strokeStyle = '#000';
            context.strokeRect(x - 6, y - 6, 12, 12);
        }
        context.globalAlpha = 1;
    }

    /** The end of a section that stays, under a point of the canvas; -1: none. */
    private endAt(x: number, y: number): number {
        const { width, height } = this.canvas.getBoundingClientRect();
        return (this.section.fixed ?? []).findIndex((end) => {
            const [ex, ey] = this.toCanvas(end[0], end[1], width, height);
            return Math.hypot(ex - x, ey - y) <= 14;
        });
    }

    private drawPoints(context: CanvasRenderingContext2D, width: number, height: number) {
        context.font = '11px system-ui, sans-serif';
        context.textAlign = 'left';
        context.textBaseline = 'bottom';
        const points = (this.model.scene?.points ?? []).map(([x, y], i): [number, number, string] => [x, y, String(i + 1)]);
        if (this.asked) points.push([...this.asked, 'P']);
        for (const [x, y, name] of points) {
            const [cx, cy] = this.toCanvas(x, y, width, height);
            context.beginPath();
            context.arc(cx, cy, 3, 0, 2 * Math.PI);
            context.fillStyle = '#fff';
            context.fill();
            context.lineWidth = 1;
            context.strokeStyle = '#000';
            context.stroke();
            context.lineWidth = 3;
            context.strokeText(name, cx + 5, cy - 2);
            context.fillText(name, cx + 5, cy - 2);
        }
    }

    // A lamp beyond the edge is shown on the edge, in its direction, so that it can be grabbed.
    private markPlace({ seen }: Mark, width: number, height: number): [number, number] {
        const [x, y] = this.toCanvas(seen[0], seen[1], width, height);
        const [dx, dy] = [x - width / 2, y - height / 2];
        const room = 14;
        const over = Math.max(Math.abs(dx) / (width / 2 - room), Math.abs(dy) / (height / 2 - room), 1);
        return [width / 2 + dx / over, height / 2 + dy / over];
    }

    private drawMarks(context: CanvasRenderingContext2D, width: number, height: number) {
        for (const mark of this.marks) {
            const [x, y] = this.markPlace(mark, width, height);
            const chosen = this.selected?.key === mark.thing.key || (mark.thing.kind === 'light' && this.several.has(mark.thing.index));
            if (mark.thing.kind === 'light') numberMark(context, x, y, mark.thing.index, chosen);
            else {
                context.lineWidth = chosen ? 3 : 2;
                context.strokeStyle = '#ffd54a';
                context.beginPath();
                context.moveTo(x - 7, y);
                context.lineTo(x + 7, y);
                context.moveTo(x, y - 7);
                context.lineTo(x, y + 7);
                context.stroke();
            }
        }
    }

    private drawProbe(context: CanvasRenderingContext2D, width: number, height: number) {
        if (!this.probe) return;
        const [x, y] = this.toCanvas(...this.probe, width, height);
        for (const [style, line] of [
            ['#000', 3],
            ['#fff', 1],
        ] as const) {
            context.strokeStyle = style;
            context.lineWidth = line;
            context.beginPath();
            context.arc(x, y, 6, 0, 2 * Math.PI);
            context.moveTo(x - 12, y);
            context.lineTo(x - 3, y);
            context.moveTo(x + 3, y);
            context.lineTo(x + 12, y);
            context.stroke();
        }
    }

    private markAt(x: number, y: number): Mark | null {
        const { width, height } = this.canvas.getBoundingClientRect();
        const near = this.marks.filter((mark) => {
            if (this.model.isFixed(mark.thing)) return false;
            const [mx, my] = this.markPlace(mark, width, height);
            return Math.hypot(mx - x, my - y) <= 16;
        });
        return near.find(({ thing }) => thing.kind === 'aim') ?? near[0] ?? null;
    }

    private beginPan(x: number, y: number): Action {
        let last: [number, number] = [x, y];
        const move = (nx: number, ny: number) => {
            this.zoomAt(1, last[0], last[1], nx - last[0], ny - last[1]);
            last = [nx, ny];
        };
        return { move, end: () => undefined };
    }

    private begin(x: number, y: number, isMore: boolean): Action {
        const mark = this.markAt(x, y);
        if (mark && isMore) {
            this.several.toggle(mark.thing.index, this.selected);
            return { move: () => undefined, end: () => undefined };
        }
        const held = mark ? -1 : this.endAt(x, y);
        if (held >= 0) {
            const move = (nx: number, ny: number) => this.section.moveEnd(held, ...this.toScreen(nx, ny));
            return { move, end: () => undefined };
        }
        if (!mark) {
            const move = (nx: number, ny: number) => {
                this.moveProbe(...this.toScreen(nx, ny));
                this.onHand(nx, ny);
            };
            move(x, y);
            return { move, end: () => undefined };
        }
        if (!this.several.has(mark.thing.index)) this.several.clear();
        const drag = new Drag(this.model, movesOf(this.model, mark.thing, this.several.besides(mark.thing)));
        this.isDragging = true;
        this.onSelect(mark.thing);
        // A lamp keeps its height above the screen.  From its place on the edge it goes by as much as the hand does.
        const [sx, sy] = this.toScreen(x, y);
        const [ox, oy] = [mark.seen[0] - sx, mark.seen[1] - sy];
        const move = async (x: number, y: number) => {
            const [mx, my] = this.toScreen(x, y);
            const whole = this.model.asWhole();
            if (whole?.scene !== drag.scene) return;
            const place = await this.model.client.ask('unproject', whole, mx + ox, my + oy, mark.seen[2]);
            if (!place || !this.isDragging) return;
            void drag.to(place);
            this.onDrag(place, x, y);
        };
        const end = () => {
            this.isDragging = false;
            drag.end();
            this.onDrag(null, 0, 0);
        };
        return { move, end };
    }

    private hover(event: PointerEvent) {
        if (event.pointerType !== 'mouse' || event.buttons !== 0 || this.isDragging) return;
        const { left, top } = this.canvas.getBoundingClientRect();
        const [x, y] = [event.clientX - left, event.clientY - top];
        const mark = this.markAt(x, y);
        this.canvas.style.cursor = mark || this.endAt(x, y) >= 0 ? 'grab' : 'crosshair';
        this.moveProbe(...this.toScreen(x, y));
        this.onHand(x, y);
        this.onMark(mark?.thing ?? null, x, y);
    }

    moveProbe(x: number, y: number) {
        const [w, h] = this.model.screen;
        this.probe = [Math.max(-w / 2, Math.min(w / 2, x)), Math.max(-h / 2, Math.min(h / 2, y))];
        this.onProbe(...this.probe);
        this.draw();
    }

    private key(event: KeyboardEvent) {
        const steps: Record<string, [number, number]> = {
            ArrowLeft: [-1, 0],
            ArrowRight: [1, 0],
            ArrowUp: [0, 1],
            ArrowDown: [0, -1],
        };
        const step = steps[event.key];
        if (event.key === 'Enter') this.onWhy();
        else if (event.key === ' ') this.selectNext(event.shiftKey ? -1 : 1);
        else if (event.key === '+' || event.key === '=') this.zoomBy(1.25);
        else if (event.key === '-') this.zoomBy(0.8);
        else if (event.key === '0' || event.key === 'f' || event.key === 'F') this.zoomBy(0);
        else if (step && event.ctrlKey) void this.nudge(step, event.shiftKey ? 100 : 10);
        else if (step) {
            const size = (this.model.screen[0] / 100) * (event.shiftKey ? 10 : 1);
            const [x, y] = this.probe ?? [0, 0];
            this.moveProbe(x + step[0] * size, y + step[1] * size);
        } else return;
        event.preventDefault();
    }

    // What is selected keeps its height above the screen.
    private async nudge([right, up]: [number, number], size: number) {
        const mark = this.marks.find(({ thing }) => thing.key === this.selected?.key);
        const whole = this.model.asWhole();
        if (!mark || !whole) return;
        const [x, y, height] = mark.seen;
        const place = await this.model.client.ask('unproject', whole, x + right * size, y + up * size, height);
        if (place) await this.model.moveThing(mark.thing, place, `keys ${mark.thing.key}`, whole);
    }
}

const ROOM = 46; // pixels between two labels of isophotes, and of line that has one

/** A place on a line that is in sight and away from those that are taken, as near its middle as can be; null: there is none. */
function labelPlace(places: [number, number][], width: number, height: number, taken: [number, number][]): [number, number] | null {
    const length = places.reduce((sum, [x, y], i) => sum + (i ? Math.hypot(x - places[i - 1][0], y - places[i - 1][1]) : 0), 0);
    if (length < ROOM) return null;
    const middle = places.length / 2;
    const order = places.map((_, i) => i).sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
    for (const i of order) {
        const [x, y] = places[i];
        const isInside = x > 24 && x < width - 24 && y > 12 && y < height - 12;
        if (isInside && taken.every(([tx, ty]) => Math.hypot(tx - x, ty - y) > ROOM)) return [x, y];
    }
    return null;
}
