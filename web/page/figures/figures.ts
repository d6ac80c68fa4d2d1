// SPDX-License-Identifier: MIT
// Figures for papers: the picture with its axes and colour bar, the section, a lamp's polar diagram, as SVG, PDF or PNG.
import { colourTable, placeInRange, type Scale } from '../colours';
import { choice, h } from '../dom';
import { download } from '../link';
import type { Model } from '../model';
import { lightName } from '../panels';
import type { PictureView } from '../picture';
import { polarOf, type Polar } from './polar';
import type { SectionPanel } from '../section';
import { pdfOf } from './pdf';
import { curve, drawing, pixelsOf, steps, svg, words } from './svg';
import { number, t } from '../words';

const [WIDTH, HEIGHT] = [720, 560];
const SHARPER = 3; // pixels of a PNG for one of the drawing
const INK = '#1b1d21';
const FAINT = '#c6c8ce';
// Lamps on white paper, as the page has them in light rooms.
const LAMPS = ['#c98218', '#109ce5', '#14805a', '#c82092', '#4423a3', '#a14c0d', '#689751', '#6a0809', '#3e2c5b', '#9e8989'];
const BANDS = 64; // of the colour bar
const end = { 'text-anchor': 'end' };
const middle = { 'text-anchor': 'middle' };

interface Plot {
    left: number;
    top: number;
    width: number;
    height: number;
}

/** Axes with round steps around a plot: where they begin and end, and what they are called. */
function axes({ left, top, width, height }: Plot, x: number[], y: number[], names: [string, string], hasGrid: boolean): string {
    const [right, low] = [left + width, top + height];
    const atX = (value: number) => left + (width * (value - x[0])) / (x[1] - x[0]);
    const atY = (value: number) => low - (height * (value - y[0])) / (y[1] - y[0]);
    const line = (x1: number, y1: number, x2: number, y2: number, stroke = INK) => svg('line', { x1, y1, x2, y2, stroke, 'stroke-width': 1 });
    return [
        ...steps(x[0], x[1], 6).map((value) => (hasGrid ? line(atX(value), top, atX(value), low, FAINT) : '') + line(atX(value), low, atX(value), low + 5) + words(number(value, 4), atX(value), low + 20, middle)),
        ...steps(y[0], y[1], 5).map((value) => (hasGrid ? line(left, atY(value), right, atY(value), FAINT) : '') + line(left - 5, atY(value), left, atY(value)) + words(number(value, 4), left - 9, atY(value) + 4.5, end)),
        svg('rect', { x: left, y: top, width, height, fill: 'none', stroke: INK }),
        words(names[0], left + width / 2, low + 40, middle),
        words(names[1], 0, 0, { ...middle, transform: `translate(16 ${top + height / 2}) rotate(-90)` }),
    ].join('');
}

/** The bar of a scale, its values at its right. */
function bar(scale: Scale, unit: string, { left, top, width, height }: Plot): string {
    const table = colourTable(scale.map);
    const colour = (share: number) => {
        const pixel = table[Math.round(share * (table.length - 1))];
        return `#${[0, 8, 16].map((shift) => ((pixel >> shift) & 255).toString(16).padStart(2, '0')).join('')}`;
    };
    const bands = Array.from({ length: BANDS }, (_, i) =>
        svg('rect', { x: left, y: top + (height * i) / BANDS, width, height: height / BANDS + 0.6, fill: colour(1 - (i + 0.5) / BANDS) }),
    );
    const marks = scale.logarithmic ? decades(scale.low, scale.high) : steps(scale.low, scale.high, 6);
    const told = marks.map((value) => {
        const y = top + height * (1 - placeInRange(value, scale));
        return svg('line', { x1: left + width, x2: left + width + 5, y1: y, y2: y, stroke: INK }) + words(number(value, 4), left + width + 9, y + 4.5);
    });
    return [...bands, svg('rect', { x: left, y: top, width, height, fill: 'none', stroke: INK }), ...told, words(unit, left + width + 72, top - 10, end)].join('');
}

function decades(low: number, high: number): number[] {
    const first = Math.ceil(Math.log10(low) - 1e-9);
    const count = Math.floor(Math.log10(high) + 1e-9) - first + 1;
    return count > 1 ? Array.from({ length: count }, (_, i) => 10 ** (first + i)) : [low, high];
}

export class Figures {
    readonly dialog = h('dialog', { class: 'figures' });
    private kind = 'picture';
    private text = ''; // the drawing
    private readonly shown = h('div', { class: 'drawn', role: 'status' });
    private asked = 0; // counts the drawings that were wanted

    constructor(
        private readonly model: Model,
        private readonly picture: PictureView,
        private readonly section: SectionPanel,
    ) {}

    /** Opens the dialog with a figure: "picture", "section", or the number of a lamp. */
    open(kind = 'picture') {
        this.kind = kind;
        const lights = this.model.scene?.lights ?? [];
        const placed = lights.flatMap(({ place }, i): [string, string][] => (place ? [[String(i), `${t('Polar diagram')}: ${lightName(this.model, i)}`]] : []));
        const kinds = choice(t('Figure'), [['picture', t('Picture')], ['section', t('Section')], ...placed], kind, (wanted) => {
            this.kind = wanted;
            void this.draw();
        });
        const close = h('button', { type: 'button', onclick: () => this.dialog.close() }, t('Close'));
        const save = (ending: string) => h('button', { type: 'button', onclick: () => void this.save(ending) }, ending.toUpperCase());
        this.dialog.setAttribute('aria-label', t('Figure'));
        this.dialog.replaceChildren(h('div', { class: 'bar-of-buttons' }, h('h2', {}, t('Figure')), close), h('div', { class: 'row' }, kinds, save('svg'), save('pdf'), save('png')), this.shown);
        this.dialog.showModal();
        void this.draw();
    }

    private async save(ending: string) {
        if (!this.text) return;
        const kind = /^\d+$/.test(this.kind) ? `lamp-${Number(this.kind) + 1}` : this.kind;
        const name = `${this.model.version.name}-${kind}.${ending}`;
        if (ending === 'svg') download(name, this.text, 'image/svg+xml');
        else if (ending === 'pdf') download(name, await pdfOf(this.text, WIDTH, HEIGHT), 'application/pdf');
        else download(name, await pixelsOf(this.text, WIDTH, HEIGHT, SHARPER), 'image/png');
    }

    private async draw() {
        const asked = ++this.asked;
        this.text = '';
        this.shown.replaceChildren(h('p', { class: 'dim' }, '…'));
        const made = await this.made().catch(() => null);
        if (asked !== this.asked) return;
        this.text = made ?? '';
        if (!made) return this.shown.replaceChildren(h('p', {}, t('There is nothing to draw yet.')));
        const image = new DOMParser().parseFromString(made, 'image/svg+xml').documentElement;
        this.shown.replaceChildren(document.importNode(image, true));
    }

    private made(): Promise<string | null> {
        if (this.kind === 'picture') return Promise.resolve(this.ofPicture());
        if (this.kind === 'section') return Promise.resolve(this.ofSection());
        return this.ofLamp(Number(this.kind));
    }

    private unit(): string {
        const unit = this.model.scene?.unit ?? '';
        return unit === 'relative' ? t('relative') : unit;
    }

    private title(of: { name: string; irradiance: boolean }, what: string): string {
        const name = of.name === 'scene' ? '' : `${of.name}: `;
        return name + what;
    }

    private ofPicture(): string | null {
        const { picture, screen } = this.model;
        const { image, shownScale: scale } = this.picture;
        if (!picture || picture.stride !== 1 || !this.model.isCurrent(picture.of) || !this.picture.shownImage) return null;
        const most = Math.min((WIDTH - 190) / screen[0], (HEIGHT - 110) / screen[1]);
        const plot = { left: 72, top: 40, width: screen[0] * most, height: screen[1] * most };
        const [half, high] = screen.map((size) => size / 2);
        const at = (x: number, y: number): [number, number] => [plot.left + (x + half) * most, plot.top + (high - y) * most];
        const what = `${t(picture.facts.word)}, ${this.unit()}`;
        const lines = this.picture.linesOfEqualValue.map(({ x, y, closed }) => {
            const places = x.map((c, i) => at(c, y[i]));
            return curve(closed ? [...places, places[0]] : places, { stroke: '#ff5db1', 'stroke-width': 1.25 });
        });
        const points = (this.model.scene?.points ?? []).map(([x, y], i) => {
            const [cx, cy] = at(x, y);
            const casing = { 'paint-order': 'stroke', stroke: '#fff', 'stroke-width': 3 };
            return svg('circle', { cx, cy, r: 3.5, fill: '#fff', stroke: INK }) + words(String(i + 1), cx + 6, cy - 5, casing);
        });
        return drawing(
            WIDTH,
            HEIGHT,
            this.title(picture.of, what),
            svg('rect', { x: plot.left, y: plot.top, width: plot.width, height: plot.height }),
            svg('image', { x: plot.left, y: plot.top, width: plot.width, height: plot.height, href: image.toDataURL(), preserveAspectRatio: 'none' }),
            ...lines,
            ...points,
            axes(plot, [-half, half], [-high, high], [`x, ${t('mm')}`, `y, ${t('mm')}`], false),
            bar(scale, what, { left: plot.left + plot.width + 24, top: plot.top, width: 18, height: plot.height }),
        );
    }

    private ofSection(): string | null {
        const { last } = this.section;
        if (!last || !this.model.isCurrent(last.of) || !last.isKnown.every((each) => each)) return null;
        const { rows, from, to } = last;
        const lights = rows[0].length - 2;
        const most = 1.05 * Math.max(...rows.map((row) => row[1] ?? 0), 1e-30);
        const along = [0, 1].find((axis) => Math.abs(to[1 - axis] - from[1 - axis]) < 1e-6);
        const length = rows[rows.length - 1][0] ?? 1;
        const range = along === undefined ? [0, length] : [from[along], to[along]].sort((a, b) => a - b);
        const isBack = along !== undefined && to[along] < from[along];
        const plot = { left: 84, top: 30, width: WIDTH - 110, height: HEIGHT - 130 };
        const at = (row: (number | null)[], column: number): [number, number] | null => {
            const share = (row[0] ?? 0) / length;
            const value = row[1] === null ? null : row[column];
            return value === null || value === undefined ? null : [plot.left + plot.width * (isBack ? 1 - share : share), plot.top + plot.height * (1 - value / most)];
        };
        const named = Array.from({ length: lights > 1 ? Math.min(lights, LAMPS.length) : 0 }, (_, i) => i);
        const curves = named.map((i) => curve(rows.map((row) => at(row, i + 2)), { stroke: LAMPS[i], 'stroke-width': 1.75 }));
        const legend = named.map((i, k) => {
            const [x, y] = [plot.left + (k % 4) * 155, HEIGHT - 34 + 18 * Math.floor(k / 4)];
            return svg('line', { x1: x, x2: x + 22, y1: y - 4, y2: y - 4, stroke: LAMPS[i], 'stroke-width': 3 }) + words(lightName(this.model, i).slice(0, 18), x + 28, y);
        });
        const { scene } = this.model;
        const what = `${t(scene?.word ?? '')}, ${this.unit()}`;
        const name = along === undefined ? `s, ${t('mm')}` : `${'xy'[along]}, ${t('mm')}`;
        return drawing(WIDTH, HEIGHT, this.title(last.of, what), axes(plot, range, [0, most], [name, what], true), ...curves, curve(rows.map((row) => at(row, 1)), { stroke: INK, 'stroke-width': 2.25 }), ...legend);
    }

    private async ofLamp(index: number): Promise<string | null> {
        const polar = await polarOf(this.model, index);
        if (!polar || !this.model.isCurrent(polar.of)) return null;
        const most = Math.max(...polar.planes.flat());
        return most > 0 ? this.ofPolar(polar, index, most) : null;
    }

    // The axis of the lamp is down, as luminaires hang.
    private ofPolar({ of, degrees, planes }: Polar, index: number, most: number): string {
        const [step] = steps(0, most * 1.0001, 4).filter((value) => value > 0);
        const circles = Array.from({ length: Math.ceil(most / step - 1e-9) }, (_, i) => (i + 1) * step);
        const top = circles[circles.length - 1];
        const [x, y, radius] = [WIDTH / 2, HEIGHT / 2, HEIGHT / 2 - 62];
        const at = (angle: number, value: number): [number, number] => {
            const turn = (angle * Math.PI) / 180;
            return [x + (radius * value * Math.sin(turn)) / top, y + (radius * value * Math.cos(turn)) / top];
        };
        const rays = Array.from({ length: 12 }, (_, i) => {
            const angle = i * 30 - 150;
            const [rx, ry] = at(angle, top);
            const [tx, ty] = at(angle, 1.07 * top);
            return svg('line', { x1: x, y1: y, x2: rx, y2: ry, stroke: FAINT }) + words(`${Math.abs(angle)}°`, tx, ty + 4.5, middle);
        });
        const unit = this.model.photometric ? t('cd') : t('W/sr');
        const rings = circles.map((value) => svg('circle', { cx: x, cy: y, r: (radius * value) / top, fill: 'none', stroke: FAINT }));
        const told = circles.map((value) => words(number(value, 3), x + 4, y - (radius * value) / top + 15));
        const curves = planes.map((values, i) => curve(values.map((value, k) => at(degrees[k], value)), { stroke: LAMPS[i === 0 ? 0 : 1], 'stroke-width': 2.25, ...(i ? { 'stroke-dasharray': '7 4' } : {}) }));
        const legend = ['C0–C180', 'C90–C270'].map((name, i) => {
            const line = { x1: 24, x2: 52, y1: 60 + 20 * i, y2: 60 + 20 * i, stroke: LAMPS[i === 0 ? 0 : 1], 'stroke-width': 2.25 };
            return svg('line', { ...line, ...(i ? { 'stroke-dasharray': '7 4' } : {}) }) + words(name, 60, 64.5 + 20 * i);
        });
        const what = `${lightName(this.model, index)}: ${t('intensity')}, ${unit}`;
        return drawing(WIDTH, HEIGHT, this.title(of, what), words(what, 24, 30, { 'font-weight': 600 }), ...rings, ...rays, ...told, ...curves, ...legend);
    }
}
