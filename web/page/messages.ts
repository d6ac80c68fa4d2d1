// SPDX-License-Identifier: MIT
// What the core says to the text: each message with the way to its place and, where a hint tells it, the mending.
import type { Message } from './core';
import { h } from './dom';
import type { Model } from './model';
import { t } from './words';

export class Messages {
    private readonly list = h('ul', { class: 'messages' });
    readonly element = h('div', { role: 'status' }, this.list);
    onShow: (message: Message) => void = () => undefined;

    constructor(private readonly model: Model) {
        model.followJudgement(this.element);
    }

    show() {
        this.list.setAttribute('aria-label', t('Messages'));
        this.list.replaceChildren(...this.model.messages.map((message) => this.item(message)));
    }

    private item(message: Message): HTMLElement {
        const show = () => this.onShow(message);
        const go =
            message.line > 0 &&
            h('button', { type: 'button', class: 'small', onclick: show }, `${t('line')} ${message.line}`);
        return h(
            'li',
            { class: message.error ? 'error' : 'advice' },
            go,
            ` ${message.message}`,
            message.hint ? h('span', { class: 'dim' }, ` — ${message.hint.replace(/-s '([^']+)'/g, '$1')}`) : null,
            this.mending(message),
        );
    }

    // A hint of assignments, as the tool takes them behind -s, can be followed by a button.
    private mending(message: Message): HTMLElement | null {
        const changes = [...message.hint.matchAll(/-s '([^']+)'/g)].map(([, set]) => ({ set }));
        if (!changes.length || this.model.stale) return null;
        return h('button', { type: 'button', class: 'small', onclick: () => this.model.change(changes) }, t('Apply'));
    }
}
