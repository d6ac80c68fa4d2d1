// SPDX-License-Identifier: MIT
// What the page says of the core's second part, while something waits for it or if it cannot be had.
import { type Client, type Loading, OtherVersion } from './client';
import { h } from './dom';
import { t } from './words';

export class LoadingNotice {
    readonly element = h('div', { role: 'status', class: 'loading', hidden: true });
    private state: Loading = 'there';

    constructor(private readonly client: Client) {
        client.onLoading = (state) => this.show(state);
        window.addEventListener('online', () => this.hasFailed() && this.again());
    }

    relabel() {
        this.show(this.state);
    }

    private hasFailed() {
        return typeof this.state === 'object';
    }

    private show(state: Loading) {
        // A question may begin to wait after the part was found not to come.
        if (state === 'awaited' && (this.client.isWhole || this.hasFailed())) return;
        this.state = state;
        this.element.hidden = state === 'there';
        if (state === 'awaited')
            this.element.textContent = t('The rest of Luxel is still being loaded. What needs it comes then.');
        else if (typeof state === 'object') this.tell(state.failure);
    }

    private tell(failure: Error) {
        const isOther = failure instanceof OtherVersion;
        const [message, name, act] = isOther
            ? ['Luxel has been renewed on the server. Load the page anew.', 'Load anew', () => this.renew()]
            : ['The rest of Luxel could not be loaded. What needs it waits.', 'Try again', () => this.again()];
        this.element.replaceChildren(
            h('span', {}, isOther ? t(message) : `${t(message)} (${failure.message})`),
            ' ',
            h('button', { type: 'button', onclick: act }, t(name)),
        );
    }

    private async renew() {
        await this.client.renew();
        location.reload();
    }

    // The server is asked and no cache, which may hold what failed.
    private again() {
        this.state = 'there';
        this.show('awaited');
        void this.client.complete({ cache: 'reload' });
    }
}
