// SPDX-License-Identifier: MIT
// The light on surfaces that reflect it: the mean on each side, and the balance of the flux.  It takes as long as the
// picture, so a worker of its own finds it once the picture is whole, and is ended when something changes.
import type { Client } from './client';
import type { Amount, Balance, LitSide } from './core';
import { h } from './dom';
import type { Model } from './model';
import { amount, currentLanguage, t } from './words';

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
    private worker: Client | null = null;
    private of = ''; // the language and the text of the scene that is shown or being asked for

    constructor(private readonly model: Model) {}

    /** After each picture, and after a change of language. */
    refresh() {
        const { picture } = this.model;
        const of = picture && currentLanguage() + picture.text;
        if (of === this.of) return;
        this.of = '';
        this.worker?.stop();
        this.worker = null;
        this.element.classList.add('old');
        if (!picture?.facts || picture.facts.reflected === null) this.element.hidden = true;
        else if (picture.stride === 1) {
            this.of = of!;
            void this.find(picture.text).catch(() => undefined);
        }
    }

    private async find(text: string) {
        const { of } = this;
        const worker = await this.model.client.twin();
        if (this.of !== of) return worker.stop();
        this.worker = worker;
        const balance = await worker.ask('balance', text);
        if (this.worker === worker) this.worker = null;
        worker.stop();
        if (this.of === of) this.show(balance);
    }

    private show(balance: Balance | null) {
        this.element.hidden = !balance;
        this.element.classList.remove('old');
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
