// SPDX-License-Identifier: MIT
// What stands beside the picture: the probe with each light's share, the table of points, the section, the explanation.
import type { Probe } from './core';
import { colourTable, placeInRange, type Scale } from './colours';
import { fitted, h, lightColour, styleColour } from './dom';
import type { Model } from './model';
import { currentLanguage, number, t } from './words';

export function lightName(model: Model, index: number): string {
    const light = model.scene?.lights[index];
    return `${index + 1} ${light?.name ?? light?.type ?? ''}`;
}

export class ProbePanel {
    readonly element = h('section', { class: 'probe', 'aria-live': 'polite' });
    onValue: (probe: Probe | null) => void = () => undefined;
    private busy = false;
    private next: [number, number] | null = null;

    constructor(private readonly model: Model) {}

    /** Asks for the value at a point; the newest one wins. */
    async ask(x: number, y: number) {
        this.next = [x, y];
        if (this.busy) return;
        this.busy = true;
        while (this.next) {
            const place = this.next;
            this.next = null;
            const probe = await this.model.client.ask('probe', ...place).catch(() => null);
            this.show(place, probe);
            this.onValue(probe);
        }
        this.busy = false;
    }

    private show([x, y]: [number, number], probe: Probe | null) {
        const { scene } = this.model;
        if (!scene) return;
        const unit = scene.unit === 'relative' ? t('relative') : scene.unit;
        const value = probe?.value ?? null;
        const place = `x = ${number(x, 4)}, y = ${number(y, 4)} ${t('mm')}`;
        const bars = (probe?.shares ?? []).map((share, i) => {
            const part = value && value > 0 ? Math.max(0, share / value) : 0;
            const bar = h('span', { class: 'bar' });
            bar.style.inlineSize = `${100 * part}%`;
            bar.style.background = lightColour(i);
            return h(
                'li',
                {},
                h('span', {}, lightName(this.model, i)),
                h('span', { class: 'track' }, bar),
                h('span', { class: 'amount' }, `${number(share, 4)} · ${number(100 * part, 3)} %`),
            );
        });
        this.element.replaceChildren(
            h(
                'p',
                {},
                h('strong', { class: 'value' }, value === null ? '—' : `${number(value, 6)} ${unit}`),
                ' ',
                h(
                    'span',
                    { class: 'dim' },
                    value === null && probe?.surface === null ? `${place}: ${t('off every surface')}` : place,
                ),
            ),
            h('ul', { class: 'shares', 'aria-label': t('Shares of the lights') }, ...(value === null ? [] : bars)),
        );
    }
}

export async function pointsTable(model: Model, onChoose: (x: number, y: number) => void): Promise<HTMLElement> {
    const points = model.scene?.points ?? [];
    const probes = await model.client.ask('table', points);
    const unit = model.scene?.unit === 'relative' ? t('relative') : (model.scene?.unit ?? '');
    const head = h(
        'tr',
        {},
        ...['№', `x, ${t('mm')}`, `y, ${t('mm')}`, `${t(model.scene?.word ?? '')}, ${unit}`].map((text) =>
            h('th', { scope: 'col' }, text),
        ),
    );
    const rows = points.map(([x, y], i) => {
        const go = h(
            'button',
            { type: 'button', class: 'small', 'aria-label': `${t('Point')} ${i + 1}`, onclick: () => onChoose(x, y) },
            String(i + 1),
        );
        return h(
            'tr',
            {},
            h('td', {}, go),
            h('td', {}, number(x)),
            h('td', {}, number(y)),
            h('td', {}, number(probes[i]?.value, 6)),
        );
    });
    return h('table', {}, h('caption', {}, t('Points')), h('thead', {}, head), h('tbody', {}, ...rows));
}

/** The section along x through the probe: the value, and each light's share in its colour. */
export async function drawSection(canvas: HTMLCanvasElement, model: Model, y: number, x: number | null) {
    const rows = await model.client.ask('section', 0, y, 0, 241);
    const [width, height, context] = fitted(canvas);
    if (!rows) return;
    const most = Math.max(...rows.map((row) => row[1] ?? 0), 1e-300);
    const left = 44,
        bottom = 18,
        top = 8;
    const last = rows[rows.length - 1][0] ?? 1;
    const place = (s: number, value: number): [number, number] => [
        left + ((width - left - 6) * s) / last,
        height - bottom - ((height - bottom - top) * value) / most,
    ];
    context.strokeStyle = styleColour('--line');
    context.fillStyle = styleColour('--dim');
    context.font = '11px system-ui, sans-serif';
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const share of [0, 0.5, 1]) {
        const [, cy] = place(0, share * most);
        context.beginPath();
        context.moveTo(left, cy);
        context.lineTo(width - 6, cy);
        context.stroke();
        context.fillText(number(share * most, 3), left - 4, cy);
    }
    context.textBaseline = 'top';
    context.textAlign = 'center';
    for (const share of [0, 0.5, 1])
        context.fillText(
            number((share - 0.5) * last, 3),
            Math.min(width - 20, place(share * last, 0)[0]),
            height - bottom + 4,
        );
    const curve = (column: number, colour: string, thick: number) => {
        context.strokeStyle = colour;
        context.lineWidth = thick;
        context.beginPath();
        let drawing = false;
        for (const row of rows) {
            const value = row[1] === null ? null : row[column];
            if (value !== null && value !== undefined) {
                if (drawing) context.lineTo(...place(row[0]!, value));
                else context.moveTo(...place(row[0]!, value));
            }
            drawing = value !== null;
        }
        context.stroke();
    };
    const lights = rows[0].length - 2;
    if (lights > 1) for (let i = 0; i < lights; i++) curve(i + 2, lightColour(i), 1.5);
    curve(1, styleColour('--text'), 2);
    if (x !== null) {
        const [cx] = place(x + last / 2, 0);
        context.strokeStyle = styleColour('--accent');
        context.lineWidth = 1;
        context.beginPath();
        context.moveTo(cx, top);
        context.lineTo(cx, height - bottom);
        context.stroke();
    }
}

/** The colour bar: from below to above, with the ends of its range and round values between. */
export function drawColourBar(canvas: HTMLCanvasElement, scale: Scale) {
    const [width, height, context] = fitted(canvas);
    const table = colourTable(scale.map);
    const bar = 16;
    for (let y = 0; y < height; y++) {
        const colour = table[Math.round(((height - 1 - y) / (height - 1)) * (table.length - 1))];
        context.fillStyle = `rgb(${colour & 255} ${(colour >> 8) & 255} ${(colour >> 16) & 255})`;
        context.fillRect(0, y, bar, 1.5);
    }
    context.fillStyle = styleColour('--text');
    context.font = '11px system-ui, sans-serif';
    context.textBaseline = 'middle';
    const steps = 4;
    for (let i = 0; i <= steps; i++) {
        const share = i / steps;
        const value =
            scale.logarithmic && scale.low > 0
                ? scale.low * (scale.high / scale.low) ** share
                : scale.low + share * (scale.high - scale.low);
        const y = height - placeInRange(value, scale) * height;
        context.fillText(number(value, 3), bar + 5, Math.max(7, Math.min(height - 7, y)), width - bar - 5);
    }
}

/** The dialog that explains a value: what the core writes as a page of HTML, taken into this one. */
export async function explain(
    model: Model,
    dialog: HTMLDialogElement,
    x: number,
    y: number,
    download: (html: string) => void,
) {
    const html = await model.client.ask('explain', x, y, 3, currentLanguage());
    if (!html) return;
    // Its own style is for a page of its own, and the policy of this one takes none.
    const bare = html.replace(/<style>[^]*?<\/style>/g, '').replace(/ style="[^"]*"/g, '');
    const page = new DOMParser().parseFromString(bare, 'text/html');
    const body = h('div', { class: 'explanation', tabindex: 0, lang: currentLanguage() });
    body.append(...[...page.body.childNodes].map((node) => document.importNode(node, true)));
    const close = h('button', { type: 'button', onclick: () => dialog.close() }, t('Close'));
    const save = h('button', { type: 'button', onclick: () => download(html) }, `${t('Download')} (HTML)`);
    dialog.setAttribute('aria-label', t('Why this value?'));
    dialog.replaceChildren(h('div', { class: 'bar-of-buttons' }, close, save), body);
    if (!dialog.open) dialog.showModal();
    close.focus();
}
