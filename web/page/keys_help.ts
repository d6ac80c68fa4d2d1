// SPDX-License-Identifier: MIT
// The list of the page's keys, as a dialog.
import { h } from './dom';
import { t } from './words';

// Where they are pressed, what they do, and which they are.
const KEYS: [string, [string, string][]][] = [
    [
        'Stage',
        [
            ['lamp by its number', '1 … 9'],
            ['next lamp or body', 'Space bar'],
            ['move what is chosen', '← ↑ → ↓, Page Up, Page Down'],
            ['add a lamp like the chosen one', 'A'],
            ['duplicate', 'D'],
            ['remove', 'Delete'],
            ['this lamp alone', 'S'],
            ['lamp on or off', 'H'],
            ['why this value', 'W'],
            ['keep the probe’s place as a point', 'P'],
            ['space or observer', 'O'],
            ['orbit, plan, elevation', 'V'],
            ['from the front', 'Home'],
            ['zoom', '+, −'],
            ['all in view', 'F'],
            ['exposure', '[, ]'],
            ['leave what is chosen', 'Esc'],
        ],
    ],
    [
        'Everywhere',
        [
            ['find a parameter', 'Ctrl+K'],
            ['undo, redo', 'Ctrl+Z, Ctrl+Shift+Z'],
            ['to the next part of the page', 'F6, Shift+F6'],
            ['this list', '?'],
        ],
    ],
];

export class KeysHelp {
    readonly dialog = h('dialog', { class: 'keys' });

    open() {
        const close = h('button', { type: 'button', onclick: () => this.dialog.close() }, t('Close'));
        const lines = ([where, keys]: (typeof KEYS)[number]) => [
            h('h3', {}, t(where)),
            h('dl', {}, ...keys.flatMap(([what, key]) => [h('dt', {}, t(what)), h('dd', {}, h('kbd', {}, t(key)))])),
        ];
        this.dialog.setAttribute('aria-label', t('Keys'));
        this.dialog.replaceChildren(h('div', { class: 'bar-of-buttons' }, h('h2', {}, t('Keys')), close), ...KEYS.flatMap(lines));
        if (!this.dialog.open) this.dialog.showModal();
    }
}

/** Brings the keys to the next part of the page, or to the one before. */
export function jump(step: number) {
    const all = ['header', '.stage[data-camera=space] canvas.space', '.stage[data-camera=picture] canvas.picture', '.edit', '.strip:not([hidden])'];
    const parts = all.flatMap((each) => [...document.querySelectorAll<HTMLElement>(each)]);
    const present = parts.findIndex((part) => part.contains(document.activeElement));
    const order = step > 0 ? parts.slice(present + 1).concat(parts) : parts.slice(0, Math.max(present, 0)).reverse().concat([...parts].reverse());
    const target = (part: HTMLElement) =>
        part.tabIndex >= 0 ? part : [...part.querySelectorAll<HTMLElement>('button, select, input, a[href], [tabindex="0"]')].find((each) => each.offsetParent && !('disabled' in each && each.disabled));
    for (const part of order) {
        const to = target(part);
        if (to) return to.focus();
    }
}
