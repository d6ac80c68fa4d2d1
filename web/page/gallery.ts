// SPDX-License-Identifier: MIT
// The built-in scenes with their pictures, which a second worker makes, coarse ones, when they are looked at first.
import type { Scale } from './colours';
import type { Builtin } from './core';
import { h } from './dom';
import type { Client } from './client';
import { paintSamples } from './srgb';
import type { Version } from './version';
import { t } from './words';

const PIXELS = 110; // about so many across a picture

// The pictures are of direct light, and of no scene that is open.
const NO_VERSION: Omit<Version, 'text'> = { number: 0, scene: 0, irradiance: false, name: '' };

function coarseness(text: string): number {
    const across = Number(/resolution:\s*\[\s*(\d+)/.exec(text)?.[1] ?? 400);
    const wanted = across / PIXELS;
    return [16, 8, 4, 2].find((stride) => stride <= wanted) ?? 1;
}

export class Gallery {
    readonly dialog = h('dialog', { class: 'gallery' });
    onChoose: (builtin: Builtin) => void = () => undefined;
    private readonly pictures = new Map<string, HTMLCanvasElement>();
    private making = false;

    constructor(private readonly client: Client) {}

    open(builtins: Builtin[]) {
        const close = h('button', { type: 'button', onclick: () => this.dialog.close() }, t('Close'));
        const items = builtins.map((builtin) => {
            const choose = () => {
                this.dialog.close();
                this.onChoose(builtin);
            };
            const button = h('button', { type: 'button', class: 'card', onclick: choose }, this.picture(builtin.name));
            button.append(h('strong', {}, builtin.name), h('span', {}, builtin.title));
            return h('li', {}, button);
        });
        this.dialog.setAttribute('aria-label', t('Built-in scenes'));
        this.dialog.replaceChildren(
            h('div', { class: 'bar-of-buttons' }, h('h2', {}, t('Built-in scenes')), close),
            h('ul', { class: 'cards' }, ...items),
        );
        this.dialog.showModal();
        if (!this.making) this.make(builtins).catch(() => (this.making = false));
    }

    private picture(name: string): HTMLCanvasElement {
        const found = this.pictures.get(name) ?? h('canvas', { width: 4, height: 3, 'aria-hidden': 'true' });
        this.pictures.set(name, found);
        return found;
    }

    private async make(builtins: Builtin[]) {
        this.making = true;
        const worker = await this.client.twin();
        for (const { name, text } of builtins) {
            const made = await worker.ask('render', { ...NO_VERSION, text, direct: true }, coarseness(text));
            if ('messages' in made) continue;
            const { columns, rows, maximum } = made.facts;
            const canvas = this.picture(name);
            canvas.width = columns;
            canvas.height = rows;
            const scale: Scale = {
                map: 'grey',
                logarithmic: false,
                locked: true,
                low: 0,
                high: maximum.value,
                exposure: 0,
            };
            const pixels = paintSamples(made, scale, true);
            canvas.getContext('2d')!.putImageData(new ImageData(pixels, columns, rows), 0, 0);
        }
        worker.stop();
    }
}
