// SPDX-License-Identifier: MIT
// The page inside another one, in the frame of <luxel-scene>: it shows only the views that the link asks for, takes
// texts and files from the page around it, and tells that page when the scene changes and how high it wants to be.
// Nothing is taken from anybody but the page around it.
import { h } from './dom';
import { packed } from './link';
import type { Model } from './model';
import { t } from './words';

export type Views = 'all' | 'picture' | 'space' | 'both';

/** What stands behind # besides the scene. */
export function wishes(fragment: string): { view: Views; language: string | null } {
    const found = new URLSearchParams(fragment.replace(/^#/, ''));
    const view = found.get('view');
    return {
        view: view === 'picture' || view === 'space' || view === 'both' ? view : 'all',
        language: found.get('lang'),
    };
}

export class Embedding {
    readonly view = wishes(location.hash).view;
    readonly isEmbedded = this.view !== 'all' && window.parent !== window;
    onText: (text: string) => void = () => undefined;

    constructor(private readonly model: Model) {
        if (this.view !== 'all') document.documentElement.dataset.view = this.view;
        if (window.parent === window) return;
        window.addEventListener('message', (event) => this.heard(event));
        new ResizeObserver(() => this.tell({ height: document.body.scrollHeight })).observe(document.body);
        let told = '';
        model.listen((topic) => {
            if (topic !== 'scene' || model.stale || model.text === told) return;
            told = model.text;
            this.tell({ text: told });
        });
    }

    /** Tells the page around this one that it can be asked. */
    begin() {
        if (window.parent !== window) this.tell({ ready: true });
    }

    private tell(message: object) {
        window.parent.postMessage({ luxel: message }, '*');
    }

    private async heard({ source, data }: MessageEvent) {
        const said = source === window.parent && data?.luxel;
        if (!said) return;
        if (typeof said.name === 'string' && said.bytes instanceof ArrayBuffer) {
            await this.model.give(said.name, new Uint8Array(said.bytes));
        }
        if (typeof said.text === 'string') this.onText(said.text);
    }

    /** The way from a frame to the whole page with the present scene. */
    link(): HTMLElement | null {
        if (this.view === 'all') return null;
        const open = async () => window.open(location.href.split('#')[0] + (await packed(this.model.text)), '_blank');
        return h('button', { type: 'button', class: 'small whole', onclick: open }, t('Open the whole page'));
    }
}
