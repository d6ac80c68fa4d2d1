// SPDX-License-Identifier: MIT
// The colour of the value under the probe: its channels with bounds, chromaticity and colour temperature, in words that
// the tool has, and a patch that shows it.
import type { Client } from './client';
import type { Colour } from './core';
import { h } from './dom';
import type { Model } from './model';
import { swatch } from './srgb';
import type { Of, Version } from './version';
import { currentLanguage, fixed, bound, exactly, number, t } from './words';

const SHOWN = 4; // digits behind the point of x, y and Duv

/** What channels mean, in one line. */
function meaning({ xy, cct, duv }: Colour): string {
    if (!xy) return '';
    const place = `x, y ${xy.map((part) => fixed(part, SHOWN)).join(currentLanguage() === 'ru' ? '; ' : ', ')}`;
    return cct === null
        ? `${place}; ${t('no colour temperature')}`
        : `${place}; ${Math.round(cct)} ${t('K')}, Duv ${fixed(duv!, SHOWN)} (${t('nearest black body in u, v')})`;
}

export class ColourCard {
    readonly element = h('div', { class: 'colour-card' });
    private of: Version | null = null;

    constructor(private readonly model: Model) {
        model.follow(this.element, () => this.of);
    }

    clear() {
        this.of = null;
        this.element.replaceChildren();
    }

    /** Asks for the colour at a place, of a scene that may have one, and shows it. */
    async ask(client: Client, of: Of, [x, y]: [number, number]) {
        const found = this.model.picture?.facts.colour ? await client.ask('color', of, x, y).catch(() => null) : null;
        if (!this.model.isCurrent(of)) return;
        this.of = of;
        this.element.replaceChildren(...(found ? this.parts(found) : []));
        this.model.dim();
    }

    private parts(colour: Colour): HTMLElement[] {
        const patch = h('span', { class: 'patch' });
        patch.style.background = swatch(colour.rgb);
        const channels = ['R', 'G', 'B'].map((name, i) => {
            const error = colour.error[i];
            const told = error > 0 ? `± ${bound(error)}` : '';
            return h('span', { class: 'channel', title: `${number(colour.rgb[i], 12)} ${told}` }, `${name} ${exactly(colour.rgb[i], error)}`);
        });
        return [h('p', { class: 'channels' }, patch, ...channels), h('p', { class: 'dim' }, meaning(colour))];
    }
}
