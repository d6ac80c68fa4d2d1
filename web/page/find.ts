// SPDX-License-Identifier: MIT
// Finds a parameter of the scene by its label, its key or its meaning, as a dialog; whoever is chosen is shown in the drawer.
import type { Parameter } from './form';
import { h } from './dom';
import { t } from './words';

const MOST = 40; // that are listed

/** A text as it is compared. */
const plain = (text: string) => text.toLowerCase().replaceAll('ё', 'е');

/** How well a parameter fits what was typed, as it is compared; Infinity: it does not. */
function rankOf({ label, path, meaning, thing }: Parameter, words: string[]): number {
    let rank = 0;
    for (const word of words) {
        const texts = [label, path, thing, meaning].map(plain);
        const found = texts.findIndex((text) => text.includes(word));
        if (found < 0) return Infinity;
        rank += texts[0].startsWith(word) ? 0 : 1 + found;
    }
    return rank;
}

export class Finder {
    readonly dialog = h('dialog', { class: 'finder' });
    private readonly input = h('input', {
        type: 'text',
        role: 'combobox',
        'aria-controls': 'found',
        'aria-expanded': 'true',
        autocomplete: 'off',
        spellcheck: 'false',
    });
    private readonly list = h('ul', { id: 'found', role: 'listbox' });
    private all: Parameter[] = [];
    private found: Parameter[] = [];
    private chosen = 0;
    onChoose: (parameter: Parameter) => void = () => undefined;

    constructor() {
        this.input.addEventListener('input', () => this.search());
        this.input.addEventListener('keydown', (event) => this.key(event));
    }

    open(all: Parameter[]) {
        this.all = all;
        this.input.value = '';
        this.dialog.setAttribute('aria-label', t('Find a parameter'));
        this.input.setAttribute('aria-label', t('Find a parameter'));
        this.input.placeholder = t('Find a parameter');
        this.list.setAttribute('aria-label', t('Parameters'));
        const close = h('button', { type: 'button', onclick: () => this.dialog.close() }, t('Close'));
        this.dialog.replaceChildren(h('div', { class: 'bar-of-buttons' }, this.input, close), this.list);
        this.search();
        if (!this.dialog.open) this.dialog.showModal();
        this.input.focus();
    }

    private search() {
        const words = plain(this.input.value).split(/\s+/).filter(Boolean);
        const ranked = this.all.map((parameter) => ({ parameter, rank: rankOf(parameter, words) }));
        const fitting = ranked.filter(({ rank }) => rank < Infinity).sort((a, b) => a.rank - b.rank);
        this.found = fitting.slice(0, MOST).map(({ parameter }) => parameter);
        this.list.replaceChildren(
            ...this.found.map((parameter, i) =>
                h(
                    'li',
                    { id: `found-${i}`, role: 'option', title: parameter.meaning, onclick: () => this.choose(i) },
                    h('span', {}, parameter.label),
                    h('span', { class: 'dim' }, parameter.thing),
                    h('code', { class: 'dim' }, parameter.path),
                ),
            ),
        );
        if (!this.found.length) this.list.append(h('li', { class: 'dim' }, t('Nothing is called so.')));
        this.mark(0);
    }

    private mark(at: number) {
        this.chosen = at;
        [...this.list.children].forEach((item, i) => item.setAttribute('aria-selected', String(i === at)));
        this.input.setAttribute('aria-activedescendant', this.found.length ? `found-${at}` : '');
        if (this.found.length) this.list.children[at].scrollIntoView({ block: 'nearest' });
    }

    private key(event: KeyboardEvent) {
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        const count = this.found.length;
        if (step && count) this.mark((this.chosen + step + count) % count);
        else if (event.key === 'Enter' && count) this.choose(this.chosen);
        else return;
        event.preventDefault();
    }

    private choose(at: number) {
        const parameter = this.found[at];
        this.dialog.close();
        this.onChoose(parameter);
    }
}
