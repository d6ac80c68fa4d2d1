// SPDX-License-Identifier: MIT
// What stands beside the picture: the probe with each light's share, and the explanation.
import type { Probe } from './core';
import type { Compare } from './compare';
import { h, lightColour } from './dom';
import type { Model } from './model';
import { currentLanguage, number, t } from './words';

export function lightName(model: Model, index: number): string {
    const light = model.scene?.lights[index];
    return `${index + 1} ${light?.name ?? light?.label ?? ''}`;
}

export class ProbePanel {
    readonly element = h('section', { class: 'probe', 'aria-live': 'polite' });
    onValue: (probe: Probe | null) => void = () => undefined;
    private busy = false;
    private next: [number, number] | null = null;

    constructor(
        private readonly model: Model,
        private readonly compare: Compare,
    ) {}

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
        const before = this.compare.valueOfA(x, y);
        // Digits that are shown are exact, but for a value whose error may be seen in them.
        const isRough = probe && value !== null && probe.error > 5e-6 * Math.abs(value);
        const bound = isRough ? ` ± ${number(probe.error, 2)}` : '';
        this.element.replaceChildren(
            h(
                'p',
                {},
                h('strong', { class: 'value' }, value === null ? '—' : `${number(value, 6)}${bound} ${unit}`),
                ' ',
                h(
                    'span',
                    { class: 'dim' },
                    value === null && probe?.surface === null ? `${place}: ${t('off every surface')}` : place,
                ),
            ),
            ...(before === null
                ? []
                : [h('p', { class: 'dim' }, `${t('A, the pixel here')}: ${number(before, 4)} ${unit}`)]),
            h('ul', { class: 'shares', 'aria-label': t('Shares of the lights') }, ...(value === null ? [] : bars)),
        );
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
