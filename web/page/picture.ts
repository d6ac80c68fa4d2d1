// SPDX-License-Identifier: MIT
// The picture: samples in the colours of the bar, lamps where they are seen, isophotes, measuring points and the probe.
import type { Isophote } from './core';
import { paint, type Scale } from './colours';
import type { Compare, Shown } from './compare';
import { fitted, h, numberMark, styleColour } from './dom';
import { Drag, followPointer } from './drag';
import type { Model, Thing } from './model';
import type { SectionPanel } from './section';
import { t } from './words';

interface Mark {
    thing: Thing;
    seen: number[]; // x and y on the screen, height above it
}

export class PictureView {
    readonly canvas = h('canvas', { tabindex: 0, class: 'picture', role: 'img' });
    readonly scale: Scale = { map: 'grey', logarithmic: false, locked: false, low: 0, high: 1, exposure: 0 };
    showsIsophotes = false;
    selected: Thing | null = null;
    probe: [number, number] | null = null;
    onProbe: (x: number, y: number) => void = () => undefined;
    onWhy: () => void = () => undefined;
    onPaint: () => void = () => undefined;
    onSelect: (thing: Thing) => void = () => undefined;
    private readonly differences: Scale = { ...this.scale, map: 'difference' };
    private marks: Mark[] = [];
    private isophotes: Isophote[] = [];
    readonly image = document.createElement('canvas'); // the samples in their colours
    private isDrawn = true;
    private isDragging = false;

    constructor(
        private readonly model: Model,
        private readonly compare: Compare,
        private readonly section: SectionPanel,
    ) {
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        this.canvas.addEventListener('pointermove', (event) => this.hover(event));
        this.canvas.addEventListener('keydown', (event) => this.key(event));
        followPointer(this.canvas, (x, y) => this.begin(x, y));
    }

    relabel() {
        this.canvas.setAttribute(
            'aria-label',
            t('Picture. Arrow keys move the probe, Shift moves it faster, Enter explains the value.'),
        );
    }

    /** The range of the colour bar for a new picture, unless it is locked. */
    private adapt({ least, most }: Shown) {
        const { scale } = this;
        if (scale.locked) return;
        const factor = 2 ** -scale.exposure;
        scale.high = factor * most;
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
        this.isophotes = this.showsIsophotes ? await this.model.isophotes(this.scale.logarithmic) : [];
        this.repaint();
    }

    repaint() {
        const shown = this.compare.shown();
        if (!shown) return;
        const { columns, rows } = shown;
        this.image.width = columns;
        this.image.height = rows;
        const pixels = paint(shown.values, shown.mask, shown.isDifference ? this.differences : this.scale);
        this.image.getContext('2d')!.putImageData(new ImageData(pixels, columns, rows), 0, 0);
        this.onPaint();
        this.draw();
    }

    async geometryChanged() {
        const movable = this.model.things.filter(({ kind }) => kind === 'light' || kind === 'aim');
        const seen = await this.model.client.ask(
            'project',
            movable.map(({ at }) => at),
        );
        this.marks = movable.flatMap((thing, i) => (seen[i] ? [{ thing, seen: seen[i]! }] : []));
        this.draw();
    }

    draw() {
        if (!this.isDrawn) return;
        this.isDrawn = false;
        requestAnimationFrame(() => {
            this.isDrawn = true;
            this.drawNow();
        });
    }

    // The screen in the canvas: whole, with room around it for lamps beside it.
    private frame(width: number, height: number) {
        const [w, h] = this.model.screen;
        const factor = 0.86 * Math.min(width / w, height / h);
        return { factor, left: (width - w * factor) / 2, top: (height - h * factor) / 2, w: w * factor, h: h * factor };
    }

    private toCanvas(x: number, y: number, width: number, height: number): [number, number] {
        const { factor } = this.frame(width, height);
        return [width / 2 + x * factor, height / 2 - y * factor];
    }

    /** The point of the screen under a point of the canvas, in mm. */
    private toScreen(x: number, y: number): [number, number] {
        const { width, height } = this.canvas.getBoundingClientRect();
        const { factor } = this.frame(width, height);
        return [(x - width / 2) / factor, (height / 2 - y) / factor];
    }

    private drawNow() {
        const [width, height, context] = fitted(this.canvas);
        const { left, top, w, h } = this.frame(width, height);
        context.fillStyle = '#000';
        context.fillRect(left, top, w, h);
        context.imageSmoothingEnabled = (this.model.picture?.stride ?? 1) > 1;
        if (this.model.picture) context.drawImage(this.image, left, top, w, h);
        context.strokeStyle = styleColour('--line');
        context.lineWidth = 1;
        context.strokeRect(left - 0.5, top - 0.5, w + 1, h + 1);
        if (this.compare.which === 'B') this.drawIsophotes(context, width, height);
        this.drawSection(context, width, height);
        this.drawPoints(context, width, height);
        this.drawMarks(context, width, height);
        this.drawProbe(context, width, height);
    }

    private drawIsophotes(context: CanvasRenderingContext2D, width: number, height: number) {
        context.strokeStyle = '#ff5db1';
        context.lineWidth = 1;
        for (const line of this.isophotes) {
            context.beginPath();
            line.x.forEach((x, i) => {
                const place = this.toCanvas(x, line.y[i], width, height);
                if (i === 0) context.moveTo(...place);
                else context.lineTo(...place);
            });
            if (line.closed) context.closePath();
            context.stroke();
        }
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
        (this.model.scene?.points ?? []).forEach(([x, y], i) => {
            const [cx, cy] = this.toCanvas(x, y, width, height);
            context.beginPath();
            context.arc(cx, cy, 3, 0, 2 * Math.PI);
            context.fillStyle = '#fff';
            context.fill();
            context.lineWidth = 1;
            context.strokeStyle = '#000';
            context.stroke();
            context.lineWidth = 3;
            context.strokeText(String(i + 1), cx + 5, cy - 2);
            context.fillText(String(i + 1), cx + 5, cy - 2);
        });
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
            const chosen = this.selected?.key === mark.thing.key;
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
            const [mx, my] = this.markPlace(mark, width, height);
            return Math.hypot(mx - x, my - y) <= 16;
        });
        return near.find(({ thing }) => thing.kind === 'aim') ?? near[0] ?? null;
    }

    private begin(x: number, y: number) {
        const mark = this.markAt(x, y);
        const held = mark ? -1 : this.endAt(x, y);
        if (held >= 0) {
            const move = (nx: number, ny: number) => this.section.moveEnd(held, ...this.toScreen(nx, ny));
            return { move, end: () => undefined };
        }
        if (!mark) {
            this.moveProbe(...this.toScreen(x, y));
            return { move: (x: number, y: number) => this.moveProbe(...this.toScreen(x, y)), end: () => undefined };
        }
        const drag = new Drag(this.model, mark.thing);
        this.isDragging = true;
        this.onSelect(mark.thing);
        // A lamp keeps its height above the screen.  From its place on the edge it goes by as much as the hand does.
        const [sx, sy] = this.toScreen(x, y);
        const [ox, oy] = [mark.seen[0] - sx, mark.seen[1] - sy];
        const move = async (x: number, y: number) => {
            const [mx, my] = this.toScreen(x, y);
            const place = await this.model.client.ask('unproject', mx + ox, my + oy, mark.seen[2]);
            if (place) drag.to(place);
        };
        const end = () => {
            this.isDragging = false;
            drag.end();
        };
        return { move, end };
    }

    private hover(event: PointerEvent) {
        if (event.pointerType !== 'mouse' || event.buttons !== 0 || this.isDragging) return;
        const { left, top } = this.canvas.getBoundingClientRect();
        const [x, y] = [event.clientX - left, event.clientY - top];
        this.canvas.style.cursor = this.markAt(x, y) || this.endAt(x, y) >= 0 ? 'grab' : 'crosshair';
        this.moveProbe(...this.toScreen(x, y));
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
        else if (step) {
            const size = (this.model.screen[0] / 100) * (event.shiftKey ? 10 : 1);
            const [x, y] = this.probe ?? [0, 0];
            this.moveProbe(x + step[0] * size, y + step[1] * size);
        } else return;
        event.preventDefault();
    }
}
