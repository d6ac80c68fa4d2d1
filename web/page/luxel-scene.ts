// SPDX-License-Identifier: MIT
// The element <luxel-scene> for pages of courses: a scene that is seen and moved there.  It is a frame around the
// page, so that neither changes the other's looks and a fault of one stays in it.
//
//     <script src="luxel/luxel-scene.js" defer></script>
//     <luxel-scene scene="two-spheres" view="both"></luxel-scene>
//     <luxel-scene view="picture" files="lamp.ies"><script type="text/yaml"> … </script></luxel-scene>
import { packed } from './link';

const WATCHED = ['scene', 'view', 'lang', 'src', 'label'];

/** The text without the indentation that it has in the page around it. */
function outdented(text: string): string {
    const lines = text
        .replace(/^\s*\n/, '')
        .trimEnd()
        .split('\n');
    const indents = lines.filter((line) => line.trim()).map((line) => line.length - line.trimStart().length);
    const least = Math.min(...indents, 1000);
    return `${lines.map((line) => line.slice(least)).join('\n')}\n`;
}

export class LuxelScene extends HTMLElement {
    static observedAttributes = WATCHED;
    /** Where the page lies: beside this script. */
    static home = new URL('index.html', (document.currentScript as HTMLScriptElement | null)?.src ?? location.href).href;
    private frame: HTMLIFrameElement | null = null;
    private current = '';
    private isReady = false;
    private readonly hear = (event: MessageEvent) => this.heard(event);

    /** The text of the scene, as it is now; setting it shows another. */
    get text(): string {
        return this.current;
    }

    set text(text: string) {
        this.current = text;
        if (this.isReady) this.say({ text });
        else this.build();
    }

    connectedCallback() {
        window.addEventListener('message', this.hear);
        this.style.display ||= 'block';
        // What the element holds may not have been read yet.
        queueMicrotask(() => this.build());
    }

    disconnectedCallback() {
        window.removeEventListener('message', this.hear);
        this.frame?.remove();
        this.frame = null;
        this.isReady = false;
    }

    attributeChangedCallback() {
        if (this.frame) {
            this.current = '';
            this.build();
        }
    }

    private async build() {
        if (!this.isConnected) return;
        const written = this.current || this.querySelector('script')?.textContent || '';
        const name = this.getAttribute('scene');
        const parts = [`view=${this.getAttribute('view') ?? 'both'}`];
        const language = this.getAttribute('lang') ?? this.closest('[lang]')?.getAttribute('lang');
        if (language) parts.push(`lang=${language}`);
        if (written.trim()) parts.unshift((await packed(outdented(written))).slice(1));
        else if (name) parts.unshift(`scene=${encodeURIComponent(name)}`);
        const address = `${this.getAttribute('src') ?? LuxelScene.home}#${parts.join('&')}`;
        const frame = document.createElement('iframe');
        frame.title = this.getAttribute('label') ?? (name ? `Luxel: ${name}` : 'Luxel');
        frame.src = address;
        frame.loading = 'lazy';
        frame.style.cssText = 'display: block; width: 100%; height: 600px; border: 0;';
        this.frame?.remove();
        this.isReady = false;
        this.frame = frame;
        this.append(frame);
    }

    private say(message: object) {
        this.frame?.contentWindow?.postMessage({ luxel: message }, '*');
    }

    private heard({ source, data }: MessageEvent) {
        const said = source !== null && source === this.frame?.contentWindow && data?.luxel;
        if (!said) return;
        if (said.ready) this.begin();
        if (typeof said.height === 'number') this.frame!.style.height = `${Math.ceil(said.height)}px`;
        if (typeof said.text === 'string') {
            this.current = said.text;
            this.dispatchEvent(new CustomEvent('luxel-change', { detail: { text: said.text }, bubbles: true }));
        }
    }

    // The files that the scene names are the page's around it, which fetches them.
    private async begin() {
        this.isReady = true;
        for (const name of (this.getAttribute('files') ?? '').split(/\s+/).filter(Boolean)) {
            const answer = await fetch(name).catch(() => null);
            if (answer?.ok)
                this.say({ name: name.slice(name.lastIndexOf('/') + 1), bytes: await answer.arrayBuffer() });
        }
    }
}

customElements.define('luxel-scene', LuxelScene);
