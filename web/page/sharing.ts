// SPDX-License-Identifier: MIT
// The dialog that shares a scene: a picture of the stage, a link that opens it as it is shown, and a task made of it: a
// question about a place, with parts of the page hidden, or several such steps.
import { h } from './dom';
import { download, packed } from './link';
import type { Looks } from './looks';
import type { Model } from './model';
import { HIDEABLE, NAMES, told, type Hideable, type TaskStep } from './task';
import { number, t, typedNumber } from './words';

export class Sharing {
    readonly dialog = h('dialog', { class: 'sharing' });
    /** Told the number of the step of a task that is to be set up next. */
    onStep: (step: number) => void = () => undefined;
    private link = '';
    private steps: TaskStep[] = []; // those before the one that is being made
    private beginning = ''; // of the link, up to the first step
    private readonly field = h('input', { type: 'text', readonly: true, class: 'address' });
    private readonly said = h('p', { class: 'dim', role: 'status' });

    /** `picture` paints what the stage shows. */
    constructor(
        private readonly model: Model,
        private readonly looks: Looks,
        private readonly picture: () => HTMLCanvasElement | null,
    ) {}

    async open(probe: [number, number]) {
        const fragment = await packed(this.model.text);
        const scene = location.href.split('#')[0] + fragment + this.looks.told();
        history.replaceState(null, '', scene);
        const close = h('button', { type: 'button', onclick: () => this.dialog.close() }, t('Close'));
        this.field.setAttribute('aria-label', t('Link'));
        this.field.addEventListener('focus', () => this.field.select());
        this.dialog.setAttribute('aria-label', t('Share'));
        this.show(scene);
        this.said.textContent = this.model.files.length ? t('The files that the scene names are not in the link.') : '';
        const copy = h('button', { type: 'button', class: 'prime', onclick: () => this.copy() }, t('Copy link'));
        this.dialog.replaceChildren(
            h('div', { class: 'bar-of-buttons' }, h('h2', {}, t('Share')), close),
            ...this.pictured(),
            h('div', { class: 'row' }, this.field, copy, this.system()),
            this.said,
            this.task(scene, fragment, probe),
        );
        this.dialog.showModal();
        copy.focus();
    }

    private show(link: string) {
        this.link = this.field.value = link;
    }

    private async copy() {
        try {
            await navigator.clipboard.writeText(this.link);
            this.said.textContent = t('Link copied');
        } catch {
            this.field.select(); // for Ctrl+C
            this.said.textContent = t('Press Ctrl+C to copy the link.');
        }
    }

    // The picture, and what can be done with it here.
    private pictured(): HTMLElement[] {
        const canvas = this.picture();
        if (!canvas || !this.model.isCurrent(this.model.whole)) return [];
        canvas.setAttribute('role', 'img');
        canvas.setAttribute('aria-label', t('Picture of the stage'));
        const bytes = () => new Promise<Blob>((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture')))));
        const save = async () => download(`${this.model.version.name}-stage.png`, await bytes(), 'image/png');
        const copy = async () => {
            try {
                await navigator.clipboard.write([new ClipboardItem({ 'image/png': bytes() })]);
                this.said.textContent = t('Picture copied');
            } catch {
                await save();
            }
        };
        const canCopy = typeof ClipboardItem === 'function' && !!navigator.clipboard;
        return [
            canvas,
            h(
                'div',
                { class: 'row' },
                canCopy && h('button', { type: 'button', onclick: copy }, t('Copy picture')),
                h('button', { type: 'button', onclick: save }, t('Save picture')),
            ),
        ];
    }

    // What phones offer to send it by.
    private system(): HTMLElement | null {
        if (typeof navigator.share !== 'function') return null;
        const send = () => navigator.share({ title: document.title, url: this.link }).catch(() => undefined);
        return h('button', { type: 'button', onclick: send }, t('Send…'));
    }

    private task(scene: string, fragment: string, probe: [number, number]): HTMLElement {
        const ask = h('textarea', { rows: 2, maxlength: 2000, 'aria-label': t('Question'), placeholder: t('Empty: what the value at P is') });
        const places = probe.map((c, axis) =>
            h('input', { type: 'text', inputmode: 'decimal', value: number(c, 5), 'aria-label': `P, ${'xy'[axis]}, ${t('mm')}` }),
        );
        const boxes = HIDEABLE.map((what): [Hideable, HTMLInputElement] => [
            what,
            h('input', { type: 'checkbox', checked: what === 'values' || what === 'text' }),
        ]);
        const more = h('button', { type: 'button', class: 'link' }, t('Add another step'));
        const again = h('button', { type: 'button', class: 'link', hidden: !this.steps.length }, t('Begin anew'));
        const element = h(
            'details',
            { class: 'make-task', open: this.steps.length > 0 },
            h('summary', {}, t('Make a task')),
            h('p', { class: 'dim' }, t('The link then asks a question and judges the answer; what is hidden is only out of sight.')),
            h('label', { class: 'wide' }, t('Question'), ask),
            h('div', { class: 'row' }, h('span', {}, t('Place P')), ...places, h('span', { class: 'dim' }, t('mm'))),
            h('fieldset', { class: 'row' }, h('legend', {}, t('Hidden')), ...boxes.map(([what, box]) => h('label', {}, box, t(NAMES[what])))),
            h('div', { class: 'row' }, this.steps.length > 0 && h('span', {}, `${t('Steps before this one')}: ${this.steps.length}`), more, again),
        );
        const present = (): TaskStep | null => {
            const at = places.map((input) => typedNumber(input.value));
            places.forEach((input, axis) => input.setAttribute('aria-invalid', String(at[axis] === null)));
            const [x, y] = at;
            return x === null || y === null ? null : { scene: fragment, at: [x, y], ask: ask.value };
        };
        const update = () => {
            const step = present();
            const hidden = boxes.filter(([, box]) => box.checked).map(([what]) => what);
            if (!element.open) this.show(scene);
            else if (step) this.show((this.steps.length ? this.beginning : scene) + told({ steps: [...this.steps, step], hidden }));
        };
        more.addEventListener('click', () => {
            const step = present();
            if (!step) return;
            if (!this.steps.length) this.beginning = scene;
            this.steps.push(step);
            this.dialog.close(); // the next step is set up on the page
            this.onStep(this.steps.length + 1);
        });
        again.addEventListener('click', () => {
            this.steps = [];
            void this.open(probe);
        });
        element.addEventListener('toggle', update);
        element.addEventListener('input', update);
        update();
        return element;
    }
}
