// SPDX-License-Identifier: MIT
// A figure of a lesson: a scene whose text has names for what is dragged or slid, its picture, the value at one place, and a
// curve.  Every number is the core's for the text that stands there at that moment.
import type { Client } from '../client';
import { paint } from '../colours';
import { fitted, h, lightColour, numberMark } from '../dom';
import { packed } from '../link';
import { add, cross, unit, type Place } from '../space_math';
import type { Of } from '../version';
import { number, t } from '../words';
import { Chart, type Line } from './chart';
import { filled, valueOf, type Names } from './expression';

type Coordinate = number | string;

/** What is moved by a slider, and by hand where the mark of the figure hangs on it. */
export interface Control {
    key: string;
    low: number;
    high: number;
    step: number;
    value: number;
    unit: string;
}

/** What a curve shows: the value along a line between two places, or over one of the names. */
export interface Curve {
    along?: [Coordinate[], Coordinate[]];
    over?: string;
    from?: number;
    to?: number;
    most?: number; // of the value: what is above is cut off
    lines?: Names[]; // one curve for each of these; without it one for the figure as it is
}

export interface FigureData {
    scene: string; // without screen and observer, with <names>
    camera: { from: Place; to: Place; width: number } | { z: number; width: number };
    quantity: 'irradiance' | 'brightness';
    at: Coordinate[]; // the place whose value is told
    controls: Control[];
    derived?: Record<string, (names: Record<string, number>) => number>;
    set?: Names; // other names, as words that lines change
    mark?: Coordinate[]; // the place of the lamp's mark, which is dragged
    outlines?: Coordinate[][][]; // lines that show the lamp
    curve?: Curve;
    formula?: string;
}

const ASPECT = 16 / 9;
const COLUMNS = 640;
const SAMPLES = 61; // of a curve
const FAST = 40; // milliseconds of a picture that follows the hand
const REACH = 26; // pixels around a mark that take it

let versions = 0;

export class Figure {
    readonly element = h('div', { class: 'figure' });
    names: Record<string, number | string> = {};
    /** The value that is told, its unit; null: there is none yet. */
    value: number | null = null;
    unit = '';
    onValue: () => void = () => undefined;
    private readonly canvas = h('canvas', { role: 'img', tabindex: '-1' });
    private readonly readout = h('output', { class: 'reading' });
    private readonly chart: Chart | null;
    private readonly sliders = new Map<string, { input: HTMLInputElement; told: HTMLElement }>();
    private readonly image = document.createElement('canvas');
    private high = 0; // of the colours, by the first picture
    private milliseconds = 0; // that a whole picture takes
    private isWanted = true; // as soon as it is seen
    private isBusy = false;
    private isSeen = false;
    private waiting: (() => void)[] = [];

    constructor(
        private readonly client: Client,
        readonly data: FigureData,
        private readonly labels: Record<string, string>,
        caption: string,
    ) {
        for (const { key, value } of data.controls) this.names[key] = value;
        Object.assign(this.names, data.set);
        this.canvas.setAttribute('aria-label', caption);
        this.chart = data.curve ? new Chart(caption) : null;
        const controls = h('div', { class: 'sliders' }, ...data.controls.map((control) => this.slider(control)));
        const picture = h('div', { class: 'lit' }, this.canvas, this.readout);
        this.element.append(h('div', { class: this.chart ? 'pair' : '' }, picture, this.chart?.element), controls);
        if (data.mark) this.takeHand();
        new IntersectionObserver((entries) => {
            this.isSeen = entries.some((entry) => entry.isIntersecting);
            if (this.isSeen) this.want();
        }, { rootMargin: '200px' }).observe(this.element);
        new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    private slider({ key, low, high, step, value, unit }: Control): HTMLElement {
        const told = h('span', { class: 'told' });
        const input = h('input', {
            type: 'range', min: low, max: high, step, value: String(value), 'aria-label': this.labels[key] ?? key,
        });
        input.addEventListener('input', () => this.change({ [key]: Number(input.value) }));
        this.sliders.set(key, { input, told });
        told.textContent = `${number(value, 4)} ${t(unit)}`;
        return h('label', { class: 'slide' }, h('span', {}, this.labels[key] ?? key), input, told);
    }

    /** Moves what has these names, within its bounds. */
    change(names: Names) {
        for (const { key, low, high, step, unit } of this.data.controls) {
            if (!(key in names)) continue;
            const value = low + Math.round((Number(names[key]) - low) / step) * step;
            const kept = Number(Math.max(low, Math.min(high, value)).toFixed(6));
            this.names[key] = kept;
            const { input, told } = this.sliders.get(key)!;
            input.value = String(kept);
            told.textContent = `${number(kept, 4)} ${t(unit)}`;
            input.setAttribute('aria-valuetext', told.textContent);
        }
        this.want();
    }

    /** All names with what is derived from them. */
    all(changed: Names = {}): Names {
        const all: Names = { ...this.names, ...changed };
        for (const [key, derive] of Object.entries(this.data.derived ?? {})) all[key] = derive(all as Record<string, number>);
        return all;
    }

    /** The scene's text, as the tool reads it. */
    text(changed: Names = {}): string {
        const { camera, scene } = this.data;
        const height = camera.width / ASPECT;
        const resolution = [COLUMNS, Math.round(COLUMNS / ASPECT)];
        const observer =
            'z' in camera
                ? `{z: ${camera.z}}`
                : `{position: [${camera.from}], target: [${camera.to}], up: [0, 0, 1], projection: perspective}`;
        const head = `luxel: 1\nscreen: {width: ${camera.width}, height: ${height}, resolution: [${resolution}]}\n`;
        return `${head}observer: ${observer}\n${filled(scene, this.all(changed))}`;
    }

    private of(irradiance: boolean, changed: Names = {}): Of {
        return { number: ++versions, scene: 0, text: this.text(changed), irradiance, name: 'lesson', direct: false };
    }

    private get isIrradiance() {
        return this.data.quantity === 'irradiance';
    }

    private place(coordinates: Coordinate[], names = this.all()): Place {
        return coordinates.map((each) => valueOf(each, names)) as Place;
    }

    /** Where a place is seen on the screen, mm. */
    seen(place: Place): [number, number] {
        const { camera } = this.data;
        if ('z' in camera) return [place[0], place[1]];
        const back = unit(camera.from.map((c, axis) => c - camera.to[axis]));
        const right = unit(cross([0, 0, 1], back));
        const up = cross(back, right);
        const off = add(place, camera.to, -1);
        const dot = (a: number[]) => a[0] * off[0] + a[1] * off[1] + a[2] * off[2];
        const distance = Math.hypot(...camera.from.map((c, axis) => c - camera.to[axis]));
        const factor = distance / (distance - dot(back));
        return [dot(right) * factor, dot(up) * factor];
    }

    private pixel(place: Place): [number, number] {
        const { width, height } = this.canvas.getBoundingClientRect();
        const factor = width / this.data.camera.width;
        const [x, y] = this.seen(place);
        return [width / 2 + x * factor, height / 2 - y * factor];
    }

    /** The core's value at a place, with some names changed; null: there is none. */
    async valueWith(changed: Names = {}, at: Coordinate[] = this.data.at): Promise<number | null> {
        const [x, y] = this.seen(this.place(at, this.all(changed)));
        return (await this.client.ask('probe', this.of(this.isIrradiance, changed), x, y))?.value ?? null;
    }

    /** Has the core judge what was typed as the value. */
    async judged(typed: string, changed: Names, tolerance: number) {
        const [x, y] = this.seen(this.place(this.data.at, this.all(changed)));
        return this.client.ask('answer', this.of(this.isIrradiance, changed), typed, x, y, tolerance);
    }

    /** The address of the full page with this scene, the place and the quantity. */
    async link(changed: Names = {}): Promise<string> {
        const [x, y] = this.seen(this.place(this.data.at, this.all(changed)));
        const quantity = this.isIrradiance ? '&quantity=irradiance' : '';
        const probe = [x, y].map((c) => Number(c.toPrecision(7)));
        return `${await packed(this.text(changed))}${quantity}&probe=${probe}&colours=tone&lang=${document.documentElement.lang}`;
    }

    private want() {
        this.isWanted = true;
        this.draw();
        if (!this.isBusy) void this.run();
    }

    /** Resolves when all that is shown is of the present names. */
    settled(): Promise<void> {
        if (!this.isWanted && !this.isBusy) return Promise.resolve();
        return new Promise((resolve) => this.waiting.push(resolve));
    }

    private async run() {
        this.isBusy = true;
        this.element.setAttribute('aria-busy', 'true');
        while (this.isWanted && this.isSeen) {
            this.isWanted = false;
            try {
                await this.update();
            } catch (error) {
                this.tell(String(error));
            }
        }
        this.isBusy = false;
        this.element.setAttribute('aria-busy', 'false');
        if (this.isWanted) return;
        for (const resolve of this.waiting.splice(0)) resolve();
    }

    private tell(trouble: string) {
        this.readout.textContent = trouble;
        this.readout.classList.add('trouble');
    }

    // The value, a picture as coarse as it must be to follow the hand, the curve, and the whole picture when the hand rests.
    private async update() {
        await this.unitOf();
        this.value = await this.valueWith();
        this.showValue();
        const isSlow = this.milliseconds > FAST;
        await this.picture(isSlow ? 4 : 1);
        if (this.data.curve) await this.curve(this.data.curve);
        if (isSlow && !this.isWanted) await this.picture(1);
    }

    /** The unit of the value. */
    async unitOf(): Promise<string> {
        if (this.unit) return this.unit;
        const { facts, messages } = await this.client.ask('judge', this.of(this.isIrradiance));
        if (!facts) throw new Error(messages.map(({ message }) => message).join(' '));
        return (this.unit = facts.unit === 'relative' ? t('relative') : facts.unit);
    }

    private showValue() {
        this.readout.replaceChildren(
            h('b', {}, this.value === null ? t('off every surface') : number(this.value, 4)),
            this.value === null ? '' : ` ${this.unit}`,
        );
        this.onValue();
    }

    private async picture(stride: number) {
        const made = await this.client.ask('render', this.of(false), stride);
        if ('messages' in made) throw new Error(made.messages.map(({ message }) => message).join(' '));
        if (stride === 1) this.milliseconds = made.milliseconds;
        this.high ||= made.facts.maximum.value || 1;
        const { columns, rows } = made.facts;
        const scale = { map: 'tone' as const, logarithmic: false, locked: true, low: 0, high: this.high, exposure: 0 };
        this.image.width = columns;
        this.image.height = rows;
        this.image.getContext('2d')!.putImageData(new ImageData(paint(made.values, made.mask, scale), columns, rows), 0, 0);
        this.draw();
    }

    private async curve(curve: Curve) {
        const lines: Line[] = [];
        const { over } = curve;
        if (over !== undefined) {
            const [from, to] = [curve.from ?? 0, curve.to ?? 1];
            const steps = Array.from({ length: SAMPLES }, (_, i) => from + ((to - from) * i) / (SAMPLES - 1));
            for (const changed of curve.lines ?? [{}]) lines.push(await this.sweep(over, steps, changed));
        } else if (curve.along) for (const changed of curve.lines ?? [{}]) lines.push(await this.section(curve.along, changed));
        const control = this.data.controls.find(({ key }) => key === over);
        this.chart!.show({
            lines,
            label: over === undefined ? `${t('along the line')}, ${t('mm')}` : `${this.labels[over]}, ${t(control?.unit ?? 'mm')}`,
            unit: this.unit,
            most: curve.most,
            point: over === undefined || this.value === null ? null : [Number(this.names[over]), this.value],
        });
    }

    private async sweep(over: string, steps: number[], changed: Names): Promise<Line> {
        const scenes = steps.map((at) => this.of(this.isIrradiance, { ...changed, [over]: at }));
        const [x, y] = this.seen(this.place(this.data.at));
        const values = await this.client.ask('sweep', scenes, x, y);
        return steps.map((at, i) => [at, values[i]]);
    }

    private async section([from, to]: [Coordinate[], Coordinate[]], changed: Names): Promise<Line> {
        const [a, b] = [this.place(from), this.place(to)];
        const length = Math.hypot(...a.map((c, axis) => b[axis] - c));
        const share = (i: number) => i / (SAMPLES - 1);
        const places = Array.from({ length: SAMPLES }, (_, i) =>
            this.seen(a.map((c, axis) => c + share(i) * (b[axis] - c)) as Place),
        );
        const of = this.of(this.isIrradiance, changed);
        const values: (number | null)[] = [];
        while (values.length < places.length) {
            const part = await this.client.ask('values', of, places.slice(values.length));
            values.push(...part.map((probe) => probe?.value ?? null));
        }
        return values.map((value, i) => [(share(i) - 0.5) * length, value]);
    }

    /** The picture with the mark, the place and what joins them. */
    draw() {
        const [width, height, context] = fitted(this.canvas);
        if (width < 2 || !this.image.width || !this.high) return;
        context.imageSmoothingEnabled = true;
        context.drawImage(this.image, 0, 0, width, height);
        const colour = lightColour(0);
        const trace = (places: Place[]) => {
            context.beginPath();
            places.forEach((place, i) => (i ? context.lineTo(...this.pixel(place)) : context.moveTo(...this.pixel(place))));
        };
        const stroke = (style: string, thickness: number, dash: number[] = []) => {
            context.setLineDash(dash);
            context.lineWidth = thickness;
            context.strokeStyle = style;
            context.stroke();
            context.setLineDash([]);
        };
        for (const outline of this.data.outlines ?? []) {
            trace(outline.map((place) => this.place(place)));
            stroke('rgb(0 0 0 / 40%)', 4);
            stroke(colour, 2);
        }
        const { along } = this.data.curve ?? {};
        if (along) {
            trace(along.map((place) => this.place(place)));
            stroke('rgb(0 0 0 / 35%)', 3.5);
            stroke('#fff', 1.5, [6, 4]);
        }
        const at = this.place(this.data.at);
        const mark = this.data.mark && this.place(this.data.mark);
        if (mark) {
            trace([at, mark]);
            stroke(colour, 1.5, [3, 5]);
        }
        const [x, y] = this.pixel(at);
        context.beginPath();
        context.ellipse(x, y, 8, 8, 0, 0, 2 * Math.PI);
        stroke('rgb(0 0 0 / 50%)', 4);
        stroke('#fff', 2);
        if (mark) numberMark(context, ...this.inside(this.pixel(mark)), 0, true);
    }

    // A mark off the figure stands at its edge.
    private inside([x, y]: [number, number]): [number, number] {
        const { width, height } = this.canvas.getBoundingClientRect();
        return [Math.max(20, Math.min(width - 20, x)), Math.max(20, Math.min(height - 20, y))];
    }

    /** Where the mark stands, in pixels of the page from the canvas's corner. */
    get markAt(): [number, number] {
        return this.inside(this.pixel(this.place(this.data.mark!)));
    }

    private takeHand() {
        const { canvas } = this;
        canvas.classList.add('taken');
        const isOn = (event: PointerEvent) => {
            const { left, top } = canvas.getBoundingClientRect();
            const [x, y] = this.markAt;
            return Math.hypot(event.clientX - left - x, event.clientY - top - y) < REACH;
        };
        canvas.addEventListener('pointermove', (event) => {
            if (!canvas.hasPointerCapture(event.pointerId)) canvas.style.cursor = isOn(event) ? 'grab' : '';
        });
        // A finger that begins elsewhere scrolls the article.
        canvas.addEventListener('touchstart', (event) => {
            const { left, top } = canvas.getBoundingClientRect();
            const [{ clientX, clientY }] = event.touches;
            const [x, y] = this.markAt;
            if (Math.hypot(clientX - left - x, clientY - top - y) < REACH) event.preventDefault();
        }, { passive: false });
        canvas.addEventListener('pointerdown', (event) => {
            if (!isOn(event)) return;
            canvas.setPointerCapture(event.pointerId);
            canvas.style.cursor = 'grabbing';
            let [x, y] = [event.clientX, event.clientY];
            const exact: Record<string, number> = {};
            const move = (next: PointerEvent) => {
                this.drag(next.clientX - x, next.clientY - y, exact);
                [x, y] = [next.clientX, next.clientY];
            };
            const end = () => {
                canvas.removeEventListener('pointermove', move);
                canvas.style.cursor = '';
            };
            canvas.addEventListener('pointermove', move);
            canvas.addEventListener('lostpointercapture', end, { once: true });
        });
    }

    // Changes the names that the mark hangs on so that it follows the hand as well as they allow.
    private drag(dx: number, dy: number, exact: Record<string, number>) {
        const { controls, mark } = this.data;
        const [x, y] = this.pixel(this.place(mark!));
        const slopes = controls.flatMap(({ key, low, high }) => {
            const small = (high - low) * 1e-4;
            const moved = this.place(mark!, this.all({ [key]: Number(this.names[key]) + small }));
            const [mx, my] = this.pixel(moved);
            const slope = { key, low, high, x: (mx - x) / small, y: (my - y) / small };
            return Math.hypot(slope.x, slope.y) > 1e-9 ? [slope] : [];
        });
        const [a, b] = slopes;
        if (!a) return;
        const determinant = b ? a.x * b.y - a.y * b.x : 0;
        const isPlane = Math.abs(determinant) > 1e-3 * Math.hypot(a.x, a.y) * Math.hypot(b?.x ?? 0, b?.y ?? 0);
        const steps = isPlane
            ? [[a, (dx * b.y - dy * b.x) / determinant] as const, [b, (a.x * dy - a.y * dx) / determinant] as const]
            : [[a, (dx * a.x + dy * a.y) / (a.x ** 2 + a.y ** 2)] as const];
        for (const [{ key, low, high }, step] of steps)
            exact[key] = Math.max(low, Math.min(high, (exact[key] ?? Number(this.names[key])) + step));
        this.change(exact);
    }
}
