// SPDX-License-Identifier: MIT
// The light on surfaces that reflect it: the mean on each side, and the balance of the flux, by the solution that the picture
// was made of.
import type { Amount, Balance, LitSide } from './core';
import { h } from './dom';
import type { Model } from './model';
import type { Of } from './version';
import { amount, t } from './words';

const MOST_SIDES = 200;

/** "1 ball, outside", "2 room, floor". */
function sideName({ surface, name, part, side }: LitSide): string {
    return [name ? `${surface + 1} ${name}` : `${surface + 1}`, part, side].filter(Boolean).join(', ');
}

function table(caption: string, rows: [string, Amount][]): HTMLElement {
    const lines = rows.map(([name, number]) =>
        h('tr', {}, h('th', { scope: 'row' }, name), h('td', { class: 'amount' }, amount(number))),
    );
    return h('table', {}, h('caption', {}, caption), h('tbody', {}, ...lines));
}

export class BalancePanel {
    readonly element = h('div', { class: 'balance', hidden: true });
    private of: Of | null = null; // what is shown

    constructor(private readonly model: Model) {
        model.follow(this.element, () => this.of);
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.of = null;
        this.element.hidden = true;
        this.element.replaceChildren();
    }

    /** Asks for it where all light is known, and after a change of language. */
    async refresh() {
        const source = this.model.source();
        if (!source) return;
        const { client, of } = source;
        if (!this.model.whole?.reflects) return this.clear();
        if (of.direct) return;
        const balance = await client.ask('balance', of).catch(() => undefined);
        if (balance === undefined || !this.model.isCurrent(of)) return;
        this.of = of;
        this.show(balance);
        this.model.dim();
    }

    private show(balance: Balance | null) {
        this.element.hidden = !balance;
        if (!balance) return;
        const word = (english: string) => this.model.client.word(english);
        const means = this.model.photometric ? 'Mean illuminance of the surfaces' : 'Mean irradiance of the surfaces';
        const fluxes: [string, Amount | undefined][] = [
            ['given off by the sources', balance.emitted],
            ['of that meets no surface', balance.missed],
            ['arrives at surfaces directly', balance.arrives],
            ['absorbed by surfaces', balance.absorbed],
            ['escapes after reflections', balance.escaped],
            ['reflected after the last bounce', balance.pending],
            ['difference, in truth 0', balance.difference],
        ];
        this.element.replaceChildren(
            table(
                `${t(means)}, ${balance.unit}`,
                balance.sides.slice(0, MOST_SIDES).map((side) => [sideName(side), side.irradiance]),
            ),
            table(
                `${t('Balance of the flux')}, ${balance.flux_unit}`,
                fluxes.flatMap(([words, flux]): [string, Amount][] => (flux ? [[word(words), flux]] : [])),
            ),
            balance.closes
                ? ''
                : h('p', { class: 'wrong' }, t('It does not close within its bounds: some number above is wrong.')),
        );
    }
}
