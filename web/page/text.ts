// SPDX-License-Identifier: MIT
// The text of the scene with the numbers of its lines, where lines with errors are marked, and the messages below.
import type { Message } from './core';
import { h } from './dom';
import type { Model } from './model';
import { t } from './words';

const PAUSE = 250; // milliseconds without typing until the text is judged

export class TextEditor {
    readonly area = h('textarea', {
        spellcheck: 'false',
        autocapitalize: 'off',
        autocomplete: 'off',
        wrap: 'off',
        id: 'scene-text',
    });
    private readonly lines = h('pre', { 'aria-hidden': 'true' });
    readonly element = h('div', { class: 'text' }, this.lines, this.area);
    private timer = 0;

    constructor(private readonly model: Model) {
        this.area.addEventListener('input', () => {
            clearTimeout(this.timer);
            this.timer = window.setTimeout(() => this.model.setText(this.area.value, 'typing'), PAUSE);
            this.number();
        });
        this.area.addEventListener('blur', () => this.model.endStep());
        this.area.addEventListener('scroll', () => (this.lines.scrollTop = this.area.scrollTop));
    }

    relabel() {
        this.area.setAttribute('aria-label', t('Scene text (YAML)'));
    }

    /** Takes the present text over, as soon as somebody looks. */
    textChanged() {
        if (this.element.hidden) return;
        if (this.area.value !== this.model.text) {
            clearTimeout(this.timer);
            const { selectionStart, scrollTop } = this.area;
            this.area.value = this.model.text;
            if (document.activeElement === this.area) this.area.setSelectionRange(selectionStart, selectionStart);
            this.area.scrollTop = scrollTop;
        }
        this.number();
    }

    number() {
        if (this.element.hidden) return;
        const count = this.area.value.split('\n').length;
        const wrong = new Map(
            this.model.messages.filter(({ line }) => line > 0).map((message) => [message.line, message]),
        );
        this.lines.replaceChildren(
            ...Array.from({ length: count }, (_, i) => {
                const message = wrong.get(i + 1);
                return h(
                    'span',
                    { class: message ? (message.error ? 'error' : 'advice') : undefined, title: message?.message },
                    `${i + 1}\n`,
                );
            }),
        );
        this.lines.scrollTop = this.area.scrollTop;
        this.area.setAttribute('aria-invalid', String(this.model.messages.some(({ error }) => error)));
    }

    /** Goes to the place that a message is about. */
    show(message: Message) {
        const before = this.area.value
            .split('\n')
            .slice(0, message.line - 1)
            .join('\n').length;
        const start = before + (message.line > 1 ? 1 : 0) + Math.max(0, message.column - 1);
        this.area.focus();
        this.area.setSelectionRange(start, start + Math.max(1, message.length));
        this.area.scrollTop = Math.max(0, message.line - 5) * 18;
    }
}
