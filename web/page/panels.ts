// SPDX-License-Identifier: MIT
// What stands beside the picture: the probe with each light's share, and the explanation.
import type { Client } from './client';
import type { Probe } from './core';
import type { Of, Version } from './version';
import type { Compare } from './compare';
import { ColourCard } from './colour_card';
import { chip, h, lightStyle } from './dom';
import { localized } from './local';
import type { Model } from './model';
import { currentLanguage, exactly, number, t } from './words';

export function lightName(model: Model, index: number): string {
    const light = model.scene?.lights[index];
    return `${index + 1} ${light?.name ?? light?.label ?? ''}`;
}

/** A share in whole per cent. */
function wholePercent(part: number): string {
    return part > 0 && part < 0.01 ? '< 1' : String(Math.round(100 * part));
}

const NOUGHT = 1e-9; // of the screen: what is nearer to its middle is in it
const MOST_SHARES = 12; // that are told one by one

/** The indices of the greatest of some numbers, in their order. */
function greatest(numbers: number[], most: number): number[] {
    const all = numbers.map((_, i) => i);
    if (all.length <= most) return all;
    return all
        .sort((a, b) => numbers[b] - numbers[a])
        .slice(0, most)
        .sort((a, b) => a - b);
}

/** The shares of a value in one bar, for where there is no room for one each. */
function stack(shares: number[], value: number): HTMLElement {
    const parts = shares.map((share, i) => {
        const part = h('span');
        part.style.inlineSize = `${value > 0 ? Math.max(0, (100 * share) / value) : 0}%`;
        part.style.background = lightStyle(i);
        return part;
    });
    return h('div', { class: 'stack', 'aria-hidden': 'true' }, ...parts);
}

export class ProbePanel {
    readonly element = h('section', { class: 'probe', 'aria-live': 'polite' });
    onValue: (probe: Probe | null) => void = () => undefined;
    /** Told the irradiance at the place, and each light's part of it, when the hand rests. */
    onLit: (lit: Probe | null, of: Version | null) => void = () => undefined;
    /** The value as it is shown, in one line. */
    told = '';
    private busy = false;
    private next: [number, number] | null = null;
    private of: Of | null = null; // what is shown
    private readonly colour: ColourCard;

    constructor(
        private readonly model: Model,
        private readonly compare: Compare,
    ) {
        this.colour = new ColourCard(model);
        model.follow(this.element, () => this.of);
    }

    /** What is shown is of this version; null: nothing is. */
    get shown(): Version | null {
        return this.of;
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.next = null;
        this.of = null;
        this.told = '';
        this.element.replaceChildren();
        this.colour.clear();
        this.onValue(null);
        this.onLit(null, null);
    }

    /** Asks for the value at a point; the newest one wins. */
    async ask(x: number, y: number) {
        this.next = [x, y];
        if (this.busy) return;
        this.busy = true;
        while (this.next) {
            const place = this.next;
            this.next = null;
            const source = this.model.source();
            if (!source) continue; // it is asked for when the scene has been judged
            const { client, of } = source;
            const probe = await client.ask('probe', of, ...place).catch(() => undefined);
            if (probe === undefined || !this.model.isCurrent(of)) continue;
            this.show(of, place, probe);
            this.onValue(probe);
            if (of.irradiance) this.onLit(probe, of);
            else if (!this.next) await this.askLit(client, of, place);
            if (!this.next) await this.colour.ask(client, of, place);
        }
        this.busy = false;
    }

    private async askLit(client: Client, of: Of, [x, y]: [number, number]) {
        const lit = await client.ask('lit', of, x, y).catch(() => undefined);
        if (lit !== undefined && this.model.isCurrent(of)) this.onLit(lit, of);
    }

    private show(of: Of, [x, y]: [number, number], probe: Probe | null) {
        const { scene } = this.model;
        if (!scene) return;
        this.of = of;
        const unit = scene.unit === 'relative' ? t('relative') : scene.unit;
        const value = probe?.value ?? null;
        const at = (c: number) => number(Math.abs(c) < NOUGHT * Math.max(...this.model.screen) ? 0 : c, 4);
        const place = `x = ${at(x)}, y = ${at(y)} ${t('mm')}`;
        const shares = probe?.shares ?? [];
        const told = greatest(shares, MOST_SHARES);
        const bars = told.map((i) => {
            const share = shares[i];
            const part = value && value > 0 ? Math.max(0, share / value) : 0;
            const bar = h('span', { class: 'bar' });
            bar.style.inlineSize = `${100 * part}%`;
            bar.style.background = lightStyle(i);
            return h(
                'li',
                { title: lightName(this.model, i) },
                chip(i, scene.lights[i]?.enabled),
                h('span', { class: 'unseen' }, lightName(this.model, i)),
                h('span', { class: 'track' }, bar),
                h('span', { class: 'amount' }, number(share, 4)),
                h('span', { class: 'percent' }, `${wholePercent(part)} %`),
            );
        });
        const left = shares.length - told.length;
        if (left > 0) bars.push(h('li', { class: 'dim rest-of-shares' }, `${t('lights with smaller shares')}: ${left}`));
        const before = this.compare.valueOfA(x, y);
        const partial = this.model.isPartial(of) ? ` (${t('direct light alone')})` : '';
        const digits = value === null ? '—' : exactly(value, probe!.error);
        const rest = value === null ? '' : ` ${unit}${partial}`;
        this.told = digits + rest;
        this.element.replaceChildren(
            h(
                'p',
                {},
                h('strong', { class: 'value' }, digits, h('span', { class: 'unit' }, rest)),
            ),
            h(
                'p',
                { class: 'place' },
                h(
                    'span',
                    { class: 'dim' },
                    value === null && probe?.surface === null ? `${place}: ${t('off every surface')}` : place,
                ),
            ),
            ...(before === null
                ? []
                : [h('p', { class: 'dim' }, `${t('A, the pixel here')}: ${number(before, 4)} ${unit}`)]),
            this.colour.element,
            ...(value === null ? [] : [stack(shares, value)]),
            h('ul', { class: 'shares', 'aria-label': t('Shares of the lights') }, ...(value === null ? [] : bars)),
        );
        this.model.dim();
    }
}

/** The dialog that explains a value: what the core writes as a page of HTML, taken into this one. */
export class Explanation {
    readonly dialog = h('dialog', { class: 'why' });
    /** Told the vector that the hand is on in the calculation: "N", "V", or "L" or "H" with the number of its light; null: none. */
    onPoint: (vector: string | null, place: [number, number]) => void = () => undefined;
    private of: Version | null = null;
    private place: [number, number] = [0, 0]; // that is explained
    private pointed: string | null = null;
    private save = h('button', { type: 'button' });

    constructor(
        private readonly model: Model,
        private readonly download: (html: string) => void,
    ) {
        model.follow(this.dialog, () => this.of);
        this.dialog.addEventListener('keydown', (event) => event.key === 'Escape' && this.close());
        this.dialog.addEventListener('pointerover', (event) => this.point(vectorOf(event.target)));
        this.dialog.addEventListener('pointerleave', () => this.point(null));
        model.listen(() => (this.save.disabled = !this.model.isCurrent(this.of)));
    }

    /** Explains the value at a place; of a scene with reflected light when that is known. */
    async show(x: number, y: number) {
        const source = this.model.source();
        const { scene } = this.model.version;
        if (this.model.stale) return this.fill(h('p', {}, t('A scene with errors has no values to explain.')));
        if (!source) return;
        const { client, of } = source;
        this.of = of;
        this.place = [x, y];
        if (this.model.isPartial(of)) return this.fill(h('p', {}, t('The value is explained when reflected light is known.')));
        const told = await client.ask('explain', of, x, y, 3, currentLanguage()).catch(() => null);
        const html = told && localized(told);
        if (!html || this.model.version.scene !== scene || this.of !== of) return;
        // Its own style is for a page of its own, and the policy of this one takes none.
        const bare = html.replace(/<style>[^]*?<\/style>/g, '').replace(/ style="[^"]*"/g, '');
        const page = new DOMParser().parseFromString(bare, 'text/html');
        const body = h('div', { class: 'explanation', tabindex: 0, lang: currentLanguage() });
        body.append(...[...page.body.childNodes].map((node) => document.importNode(node, true)));
        for (const letter of body.querySelectorAll('mi[mathvariant=normal]')) if (vectorOf(letter)) letter.classList.add('vector');
        this.save = h('button', { type: 'button', onclick: () => this.download(html) }, `${t('Download')} (HTML)`);
        this.fill(body, this.save);
    }

    private fill(body: HTMLElement, ...buttons: HTMLElement[]) {
        const close = h('button', { type: 'button', onclick: () => this.close() }, t('Close'));
        this.dialog.setAttribute('aria-label', t('Why this value?'));
        this.dialog.replaceChildren(h('div', { class: 'bar-of-buttons' }, close, ...buttons), body);
        if (!this.dialog.open) this.dialog.show(); // the views stay in reach
        close.focus();
        this.model.dim();
        this.save.disabled = !this.model.isCurrent(this.of);
    }

    private point(vector: string | null) {
        if (vector === this.pointed) return;
        this.pointed = vector;
        this.onPoint(vector, this.place);
    }

    close() {
        this.dialog.close();
        this.point(null);
    }

    /** Closes it: another scene was opened. */
    clear() {
        this.of = null;
        this.close();
    }
}

/** The vector that a letter of the calculation stands for; null: for none. */
function vectorOf(target: EventTarget | null): string | null {
    const letter = target instanceof Element ? target.closest('mi') : null;
    const name = letter?.getAttribute('mathvariant') === 'normal' ? letter.textContent : '';
    if (name === 'N' || name === 'V') return name;
    if (!letter || (name !== 'L' && name !== 'H')) return null;
    // That of a light stands below the heading of the light.
    for (let at: Element | null = letter.closest('.explanation > *'); at; at = at.previousElementSibling) {
        const found = /^H[23]$/.test(at.tagName) && /lights\[(\d+)\]/.exec(at.textContent ?? '');
        if (found) return `${name}${Number(found[1]) + 1}`;
        if (at.tagName === 'H2') break;
    }
    return name === 'H' ? 'H' : 'L1';
}
