// SPDX-License-Identifier: MIT
// Comparing two pictures: A is one that was kept, B the present one.  The picture shows either of them or their
// difference, in colours on both sides of zero.
import type { Samples } from './core';
import { choice, h } from './dom';
import type { Model } from './model';
import { number, t } from './words';
import type { Picture } from './worker';

export type Which = 'B' | 'A' | 'difference';

/** What is to be painted. */
export interface Shown extends Samples {
    columns: number;
    rows: number;
    least: number;
    most: number;
    brightest: number; // the greatest channel of a picture in colour
    isDifference: boolean;
}

export class Compare {
    readonly element = h('div', { class: 'controls compare' });
    readonly summary = h('p', { class: 'dim', role: 'status' });
    onChange: () => void = () => undefined;
    which: Which = 'B';
    private kept: Picture | null = null;
    private awaitsWhole = false; // the next whole picture becomes A
    private screen = [1, 1]; // of A, in mm

    constructor(private readonly model: Model) {
        model.follow(this.summary, () => this.model.picture?.of ?? null);
    }

    get hasA() {
        return this.kept !== null;
    }

    relabel() {
        const button = (label: string, onclick: () => void, disabled = false) =>
            h('button', { type: 'button', onclick, disabled }, t(label));
        const { kept } = this;
        const names: [string, string][] = [
            ['B', t('B: the present picture')],
            ['A', t('A: the kept picture')],
            ['difference', 'B − A'],
        ];
        const parts = kept
            ? [
                  choice(t('Compare'), names, this.which, (which) => this.show(which as Which)),
                  button('Scene A', () => this.model.begin(kept.of.text, kept.of.name)),
                  button('Forget A', () => this.keep(null)),
              ]
            : [];
        this.element.replaceChildren(
            button('Keep as A', () => this.keepWhole()),
            ...parts,
        );
        this.tell();
    }

    /** Keeps the present picture or, while it is coarse, the whole one that is on its way. */
    private keepWhole() {
        this.awaitsWhole = !this.model.isSettled;
        if (!this.awaitsWhole) this.keep(this.model.picture);
    }

    private keep(picture: Picture | null) {
        this.kept = picture;
        this.screen = this.model.screen;
        this.which = 'B';
        this.relabel();
        this.onChange();
    }

    private show(which: Which) {
        this.which = which;
        this.tell();
        this.onChange();
    }

    // Pictures are compared pixel by pixel, so both must have the same ones.
    private get fits(): boolean {
        const [a, b] = [this.kept?.facts, this.model.picture?.facts];
        return !!a && !!b && a.columns === b.columns && a.rows === b.rows;
    }

    /** What the picture shows of the two. */
    shown(): Shown | null {
        const { kept } = this;
        const { picture } = this.model;
        const one = this.which === 'A' ? kept : picture;
        if (this.which === 'difference' && this.fits) return this.difference(kept!, picture!);
        if (!one) return null;
        const { columns, rows, maximum, minimum } = one.facts;
        const [least, most] = [minimum.exists ? minimum.value : 0, maximum.exists ? maximum.value : 1];
        const { values, mask, rgb, levels, brightest } = one;
        return { values, mask, rgb, levels, columns, rows, least, most, brightest, isDifference: false };
    }

    private difference(a: Picture, b: Picture): Shown {
        const values = new Float32Array(b.values.length);
        const mask = new Uint8Array(b.values.length);
        let most = 0;
        for (let i = 0; i < values.length; i++) {
            values[i] = (b.mask[i] ? b.values[i] : 0) - (a.mask[i] ? a.values[i] : 0);
            mask[i] = a.mask[i] | b.mask[i];
            most = Math.max(most, Math.abs(values[i]));
        }
        most ||= 1;
        return { values, mask, columns: b.facts.columns, rows: b.facts.rows, least: -most, most, brightest: most, isDifference: true };
    }

    /** Says how far B is from A; called for each new picture. */
    tell() {
        if (this.awaitsWhole && this.model.isSettled) return this.keepWhole();
        const { kept } = this;
        const { picture } = this.model;
        this.summary.hidden = !kept;
        if (!picture) this.summary.textContent = '';
        if (!kept || !picture) return;
        if (!this.fits) {
            if (picture.stride === 1) this.summary.textContent = t('A and B have other numbers of pixels.');
            return;
        }
        const { values, mask, most } = this.difference(kept, picture);
        let squares = 0;
        let count = 0;
        for (let i = 0; i < values.length; i++)
            if (mask[i]) {
                squares += values[i] ** 2;
                count++;
            }
        const greatest = values.every((value) => value === 0) ? 0 : most;
        const part =
            kept.facts.maximum.value > 0 ? ` = ${number((100 * greatest) / kept.facts.maximum.value, 3)} %` : '';
        this.summary.textContent =
            `B − A: ${t('at most')} ${number(greatest, 4)}${part} ${t('of the maximum of A')}, ` +
            `${t('root mean square')} ${number(Math.sqrt(squares / Math.max(count, 1)), 4)}`;
    }

    /** The value of A's pixel at a point of the screen. */
    valueOfA(x: number, y: number): number | null {
        if (!this.kept) return null;
        const { facts, values, mask } = this.kept;
        const [width, height] = this.screen;
        const column = Math.min(facts.columns - 1, Math.floor((x / width + 0.5) * facts.columns));
        const row = Math.min(facts.rows - 1, Math.floor((0.5 - y / height) * facts.rows));
        const pixel = row * facts.columns + column;
        return column >= 0 && row >= 0 && mask[pixel] ? values[pixel] : null;
    }

    /** A's pixels along a line, or null where no A is kept. */
    alongA(from: number[], to: number[], count: number): (number | null)[] | null {
        if (!this.kept) return null;
        return Array.from({ length: count }, (_, i) => {
            const share = i / (count - 1);
            return this.valueOfA(from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]));
        });
    }
}
