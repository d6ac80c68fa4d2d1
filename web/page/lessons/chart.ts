// SPDX-License-Identifier: MIT
// The curves of a lesson's figure: values over a length or over what is slid, with the figure's own point on them.
import { h } from '../dom';
import { steps } from '../figures/svg';
import { number } from '../words';

/** Places on the axis and the values there; null: there is none. */
export type Line = [number, number | null][];

export interface Shown {
    lines: Line[];
    label: string; // of the axis
    unit: string; // of the values
    most?: number;
    point: [number, number] | null;
}

const SVG = 'http://www.w3.org/2000/svg';
const [WIDTH, HEIGHT] = [360, 300];
const [LEFT, RIGHT, TOP, LOW] = [52, WIDTH - 14, 30, HEIGHT - 44];

function draw(name: string, attributes: Record<string, string | number>, text = ''): SVGElement {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
    if (text) made.textContent = text;
    return made;
}

export class Chart {
    private readonly svg = draw('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img' });
    readonly element = h('div', { class: 'curve' });
    /** What is shown; null: nothing yet. */
    shown: Shown | null = null;

    constructor(label: string) {
        this.svg.setAttribute('aria-label', label);
        this.element.append(this.svg);
    }

    show(shown: Shown) {
        this.shown = shown;
        const places = shown.lines.flatMap((line) => line.map(([at]) => at));
        const values = shown.lines.flatMap((line) => line.flatMap(([, value]) => (value === null ? [] : [value])));
        const [from, to] = [Math.min(...places), Math.max(...places)];
        const high = Math.min(shown.most ?? Infinity, 1.08 * Math.max(0, ...values)) || 1;
        const x = (at: number) => LEFT + ((RIGHT - LEFT) * (at - from)) / (to - from || 1);
        const y = (value: number) => LOW - ((LOW - TOP) * Math.min(value, 1.02 * high)) / high;
        const parts: SVGElement[] = [];
        for (const level of steps(0, high))
            parts.push(
                draw('path', { d: `M${LEFT} ${y(level)}H${RIGHT}`, class: 'grid' }),
                draw('text', { x: LEFT - 8, y: y(level) + 4, class: 'end' }, number(level, 3)),
            );
        for (const at of steps(from, to)) parts.push(draw('text', { x: x(at), y: LOW + 18, class: 'middle' }, number(at, 4)));
        parts.push(
            draw('text', { x: RIGHT, y: HEIGHT - 8, class: 'end' }, shown.label),
            draw('text', { x: 8, y: 16 }, shown.unit),
        );
        shown.lines.forEach((line, i) => {
            let isOpen = false;
            const path = line.map(([at, value]) => {
                const isShown = value !== null && value <= 1.02 * high;
                const step = isShown ? `${isOpen ? 'L' : 'M'}${x(at).toFixed(1)} ${y(value).toFixed(1)}` : '';
                isOpen = isShown;
                return step;
            });
            parts.push(draw('path', { d: path.join(''), class: `line line-${i}` }));
        });
        if (shown.point && shown.point[1] <= 1.02 * high) {
            const [px, py] = [x(shown.point[0]), y(shown.point[1])];
            parts.push(
                draw('path', { d: `M${px} ${LOW}V${py}H${LEFT}`, class: 'leader' }),
                draw('circle', { cx: px, cy: py, r: 6, class: 'dot' }),
            );
        }
        this.svg.replaceChildren(...parts);
    }
}
