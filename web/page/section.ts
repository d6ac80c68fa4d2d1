// SPDX-License-Identifier: MIT
// Sections: the value, or each lamp's share of it, along the line through the probe at any angle, or along a line that
// stays where its ends were put.
import type { Compare } from './compare';
import { choice, faded, fitted, h, lightColour, showIn, styleColour, takeIn } from './dom';
import { coarseFirst, placeOn, rowOn, type Row, type Section } from './line';
import { download } from './link';
import type { Model } from './model';
import { number, t, typedNumber } from './words';

const SAMPLES = 241;
const PAUSE = 60; // milliseconds between two sections while the probe moves

const MARGIN = { left: 44, right: 6, bottom: 18, top: 8 };

/** A curve, or, with what it stands on, a band. */
interface Curve {
    values: (number | null)[];
    colour: string;
    thick: number;
    under?: (number | null)[];
    isDashed?: boolean;
}

const MOST_BANDS = 12; // lamps
const BAND = 0.42; // how much of its colour a band has

export class SectionPanel {
    readonly canvas = h('canvas', { class: 'section', role: 'img' });
    /** The last section; its ends are drawn in the picture.  While it is being found, samples are missing. */
    last: (Section & { isKnown: boolean[] }) | null = null;
    /** The ends of a line that stays, in mm on the screen. */
    fixed: [number, number][] | null = null;
    onLine: () => void = () => undefined;
    private degrees = 0;
    private showsShares = false;
    private probe: [number, number] = [0, 0];
    private timer = 0;
    private asked = 0; // counts the sections that were wanted
    private readonly csv = h('button', { type: 'button', onclick: () => this.save() }, 'CSV');
    private readonly note = h('p', { class: 'dim', hidden: true });
    /** What stands below the controls. */
    readonly element = h('div', { class: 'section-box' }, this.canvas, this.note);
    private ends: HTMLInputElement[] = [];

    constructor(
        private readonly model: Model,
        private readonly compare: Compare,
    ) {
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        model.follow(this.element, () => this.last?.of ?? null);
        model.listen(() => this.tell());
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.last = null;
        this.fixed = null;
        this.asked++;
        clearTimeout(this.timer);
        this.draw();
        this.onLine();
    }

    // A table is handed over where all of it is known and of the present scene with all its light.
    private tell() {
        const { last } = this;
        const isPartial = !!last && this.model.isPartial(last.of);
        const isWhole = !!last && !isPartial && last.isKnown.every((each) => each) && this.model.isCurrent(last.of);
        this.csv.disabled = !isWhole;
        this.note.hidden = !isPartial;
        this.note.textContent = t('direct light alone');
    }

    /** The controls, in the words of the present language. */
    controls(): HTMLElement {
        this.canvas.setAttribute('aria-label', t('Section'));
        const angle = h('input', { type: 'range', min: 0, max: 179, value: this.degrees, 'aria-label': t('Angle') });
        const told = h('output', {}, `${this.degrees}°`);
        angle.addEventListener('input', () => {
            this.degrees = Number(angle.value);
            told.textContent = `${this.degrees}°`;
            this.want();
        });
        const box = h('input', { type: 'checkbox', checked: this.fixed !== null });
        const places = h('span', { class: 'ends', hidden: this.fixed === null });
        box.addEventListener('change', () => {
            this.fixed = box.checked && this.last ? [pair(this.last.from), pair(this.last.to)] : null;
            places.hidden = this.fixed === null;
            angle.disabled = this.fixed !== null;
            this.want();
        });
        this.ends = ['x₁', 'y₁', 'x₂', 'y₂'].map((name, i) =>
            h('input', {
                type: 'text',
                inputmode: 'decimal',
                class: 'place',
                'aria-label': `${name}, ${t('mm')}`,
                onchange: () => this.typed(i),
            }),
        );
        places.append(...this.ends);
        const what = choice(
            t('Curves'),
            [
                ['values', t('values')],
                ['shares', t('shares of the lights, %')],
            ],
            this.showsShares ? 'shares' : 'values',
            (word) => {
                this.showsShares = word === 'shares';
                this.draw();
            },
        );
        this.csv.setAttribute('aria-label', `${t('Section')} (CSV)`);
        this.tell();
        return h(
            'div',
            { class: 'controls' },
            what,
            h('label', {}, t('Angle'), angle, told),
            h('label', {}, box, t('Fix the line')),
            places,
            this.csv,
        );
    }

    private typed(i: number) {
        const value = typedNumber(this.ends[i].value);
        this.ends[i].setAttribute('aria-invalid', String(value === null));
        takeIn(this.ends[i]);
        if (value === null || !this.fixed) return;
        this.fixed[i >> 1][i & 1] = value;
        this.want();
    }

    /** Puts one end of the fixed line somewhere else. */
    moveEnd(i: number, x: number, y: number) {
        if (!this.fixed) return;
        this.fixed[i] = [Math.round(x), Math.round(y)];
        this.want();
    }

    through(x: number, y: number) {
        this.probe = [x, y];
        if (!this.fixed) this.want();
        else this.draw();
    }

    want() {
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => this.ask().catch(() => undefined), PAUSE);
    }

    private async ask() {
        const asked = ++this.asked;
        const isWanted = () => asked === this.asked;
        const source = this.model.source();
        if (!source) return;
        const ends = this.fixed ?? (await source.client.ask('line', source.of, ...this.probe, this.degrees));
        if (!ends || !isWanted() || ends[0].join() === ends[1].join()) return;
        const [from, to] = ends.map((end) => [...end]);
        const order = coarseFirst(SAMPLES);
        const rows: Row[] = order.map((_, i) => rowOn(from, to, SAMPLES, i, null));
        const isKnown = order.map(() => false);
        let taken = 0;
        const places = order.map((i) => placeOn(from, to, SAMPLES, i));
        await this.model.valuesAt(places, {
            isWanted,
            onSome: ({ of, probes }) => {
                for (; taken < probes.length; taken++) {
                    const i = order[taken];
                    rows[i] = rowOn(from, to, SAMPLES, i, probes[taken]);
                    isKnown[i] = true;
                }
                this.show({ of, from, to, rows, isKnown });
            },
        });
    }

    private show(section: NonNullable<SectionPanel['last']>) {
        if (section.isKnown.filter((each) => each).length < SAMPLES / 16) return; // no curve yet
        this.last = section;
        this.ends.forEach((input, i) => {
            const end = this.fixed?.[i >> 1];
            if (end) showIn(input, number(end[i & 1], 5));
        });
        this.draw();
        this.onLine();
        this.tell();
        this.model.dim();
    }

    /** Curves by columns of numbers; of lamps, unless they are many, bands that stand on one another. */
    private curves(section: Section): Curve[] {
        const { rows } = section;
        const lights = rows[0].length - 2;
        const share = (row: (number | null)[], i: number) =>
            row[1] === null ? null : row[1] > 0 ? (100 * (row[i + 2] ?? 0)) / row[1] : 0;
        let below: (number | null)[] = rows.map(() => 0);
        const shares = Array.from({ length: lights }, (_, i): Curve => {
            const values = rows.map((row) =>
                this.showsShares ? share(row, i) : row[1] === null ? null : (row[i + 2] ?? null),
            );
            const curve = { values, colour: lightColour(i), thick: 1.5 };
            if (lights > MOST_BANDS) return curve;
            const under = below;
            below = values.map((value, k) => value === null ? null : value + (under[k] ?? 0));
            return { ...curve, values: below, under };
        });
        if (this.showsShares) return shares;
        const whole = { values: rows.map((row) => row[1]), colour: styleColour('--text'), thick: 2 };
        const before = this.compare.alongA(section.from, section.to, SAMPLES)?.filter((_, i) => this.last?.isKnown[i]);
        const other = before ? [{ values: before, colour: styleColour('--dim'), thick: 1.5, isDashed: true }] : [];
        return [...(lights > 1 ? shares : []), ...other, whole];
    }

    draw() {
        const [width, height, context] = fitted(this.canvas);
        const { last } = this;
        if (!last) return;
        const known = { ...last, rows: last.rows.filter((_, i) => last.isKnown[i]) };
        if (known.rows.every((row) => row[1] === null)) return this.drawNothing(context, width, height);
        const curves = this.curves(known);
        const raised = (most: number, values: (number | null)[]) =>
            values.reduce<number>((greatest, value) => Math.max(greatest, value ?? 0), most);
        const greatest = curves.reduce((most, { values }) => raised(most, values), -Infinity);
        const most = this.showsShares ? 100 : greatest || 1;
        const length = last.rows[last.rows.length - 1][0] ?? 1;
        const place = (s: number, value: number): [number, number] => [
            MARGIN.left + ((width - MARGIN.left - MARGIN.right) * s) / length,
            height - MARGIN.bottom - ((height - MARGIN.bottom - MARGIN.top) * value) / most,
        ];
        this.drawAxes(context, place, most, length, width);
        for (const { values, colour, thick, under, isDashed } of curves) {
            if (under) {
                const at = (k: number, of: (number | null)[]) => place(known.rows[k][0]!, of[k] ?? 0);
                context.fillStyle = faded(colour, BAND);
                context.beginPath();
                for (const [first, last] of runsOf(values)) {
                    context.moveTo(...at(first, under));
                    for (let k = first; k <= last; k++) context.lineTo(...at(k, values));
                    for (let k = last; k > first; k--) context.lineTo(...at(k, under));
                }
                context.fill();
                continue;
            }
            context.strokeStyle = colour;
            context.lineWidth = thick;
            context.setLineDash(isDashed ? [5, 4] : []);
            context.beginPath();
            let drawing = false;
            values.forEach((value, i) => {
                if (value !== null) {
                    if (drawing) context.lineTo(...place(known.rows[i][0]!, value));
                    else context.moveTo(...place(known.rows[i][0]!, value));
                }
                drawing = value !== null;
            });
            context.stroke();
        }
        context.setLineDash([]);
        this.drawProbe(context, place, most, length);
    }

    private drawNothing(context: CanvasRenderingContext2D, width: number, height: number) {
        context.fillStyle = styleColour('--dim');
        context.font = '13px system-ui, sans-serif';
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        context.fillText(t('off every surface'), width / 2, height / 2);
        this.canvas.setAttribute('aria-label', `${t('Section')}: ${t('off every surface')}`);
    }

    private drawAxes(
        context: CanvasRenderingContext2D,
        place: (s: number, value: number) => [number, number],
        most: number,
        length: number,
        width: number,
    ) {
        context.lineWidth = 1;
        context.strokeStyle = styleColour('--line');
        context.fillStyle = styleColour('--dim');
        context.font = '11px system-ui, sans-serif';
        context.textAlign = 'right';
        context.textBaseline = 'middle';
        for (const share of [0, 0.5, 1]) {
            const [cx, cy] = place(0, share * most);
            context.beginPath();
            context.moveTo(cx, cy);
            context.lineTo(width - MARGIN.right, cy);
            context.stroke();
            context.fillText(number(share * most, 3), cx - 4, cy);
        }
        context.textBaseline = 'top';
        context.textAlign = 'center';
        const { name, from, to } = this.abscissa(length);
        const told = `${t('Section')}, ${name}: ${number(from)} … ${number(to)} ${t('mm')}`;
        if (this.canvas.getAttribute('aria-label') !== told) this.canvas.setAttribute('aria-label', told);
        for (const share of [0, 0.5, 1]) {
            const [cx, cy] = place(share * length, 0);
            const at = number(Number((from + share * (to - from)).toPrecision(3)), 3);
            const text = share === 1 ? `${name} = ${at} ${t('mm')}` : at;
            const half = context.measureText(text).width / 2;
            context.fillText(text, Math.min(width - half, cx), cy + 4);
        }
    }

    // A line along x or y is read by that, any other one by the way along it.
    private abscissa(length: number): { name: string; from: number; to: number } {
        const { from, to } = this.last!;
        const along = [0, 1].find((axis) => Math.abs(to[1 - axis] - from[1 - axis]) < 1e-9 * length);
        if (along === undefined) return { name: 's', from: 0, to: length };
        return { name: 'xy'[along], from: from[along], to: to[along] };
    }

    // Where the probe is on the line, if it is near it.
    private drawProbe(
        context: CanvasRenderingContext2D,
        place: (s: number, value: number) => [number, number],
        most: number,
        length: number,
    ) {
        const { from, to } = this.last!;
        const [dx, dy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
        const [px, py] = [this.probe[0] - from[0], this.probe[1] - from[1]];
        const along = px * dx + py * dy;
        if (along < 0 || along > length || Math.abs(py * dx - px * dy) > length / 50) return;
        context.strokeStyle = styleColour('--accent');
        context.lineWidth = 1;
        context.beginPath();
        context.moveTo(...place(along, 0));
        context.lineTo(...place(along, most));
        context.stroke();
    }

    /** The section as a table: place on the line and on the screen, value, and each light's share of it. */
    private save() {
        const { last } = this;
        if (!last || this.csv.disabled) return;
        const names = (this.model.scene?.lights ?? []).map((_, i) => `light_${i + 1}`);
        const length = last.rows[last.rows.length - 1][0] ?? 1;
        const lines = last.rows.map((row) => {
            const at = [0, 1].map((axis) => last.from[axis] + ((last.to[axis] - last.from[axis]) * row[0]!) / length);
            return [row[0], ...at, ...row.slice(1)].map((value) => value ?? '').join(',');
        });
        download(
            `${this.model.version.name}-section.csv`,
            [['s_mm', 'x_mm', 'y_mm', 'value', ...names].join(','), ...lines, ''].join('\n'),
            'text/csv',
        );
    }
}

/** The first and the last place of each run of values that are there. */
function runsOf(values: (number | null)[]): [number, number][] {
    const runs: [number, number][] = [];
    values.forEach((value, k) => {
        if (value === null) return;
        if (k > 0 && values[k - 1] !== null) runs[runs.length - 1][1] = k;
        else runs.push([k, k]);
    });
    return runs;
}

function pair(place: number[]): [number, number] {
    return [Math.round(place[0]), Math.round(place[1])];
}
