// SPDX-License-Identifier: MIT
// The form's fields of colours: of a lamp, which has one of several keys, by a slider of temperatures with their colours,
// by x and y, by channels or by a file; and of a material, whose factors a picker of colours sets.
import type { Key } from './core';
import { choice, h, showIn, takeIn } from './dom';
import type { Change } from './core';
import type { Model } from './model';
import { curve, swatch, uncurve } from './srgb';
import { number, t, typedNumber } from './words';

/** The keys of a lamp's colour, of which it has one. */
const KINDS = ['temperature', 'xy', 'rgb', 'spectrum'] as const;
type Kind = (typeof KINDS)[number];
const KEY = /^(lights\[\d+\])\.color\.(\w+)$/;

const COLDEST = 1800; // the slider's ends, in K
const HOTTEST = 12000;
const STEPS = 1000;
const STOPS = 12; // of its colours

/** The lamp that a key of a colour is of; null: it is another key. */
export function lampOfColour(path: string): string | null {
    const found = KEY.exec(path);
    return found && KINDS.includes(found[2] as Kind) ? found[1] : null;
}

const temperatureAt = (place: number) => COLDEST * (HOTTEST / COLDEST) ** (place / STEPS);
const placeOf = (kelvin: number) => (STEPS * Math.log(kelvin / COLDEST)) / Math.log(HOTTEST / COLDEST);

/** The chromaticity of channels, as a lamp's colour begins with it. */
function chromaticity([r, g, b]: number[]): number[] {
    const x = 0.4123907992659595 * r + 0.357584339383878 * g + 0.1804807884018343 * b;
    const y = 0.21263900587151 * r + 0.715168678767756 * g + 0.0721923153607337 * b;
    const z = 0.01933081871559182 * r + 0.119194779794626 * g + 0.9505321522496607 * b;
    const sum = x + y + z;
    return sum > 0 && y > 0 ? [x / sum, y / sum] : [0.3127, 0.329];
}

/** What of a form its fields of colours need. */
export interface Host {
    model: Model;
    complain(path: string, trouble: string): void;
}

/** The field of a lamp's colour. */
export class LampColour {
    readonly row: HTMLElement;
    readonly note = h('p', { class: 'note', role: 'alert' });
    private readonly values = new Map<Kind, string | null>();
    private readonly kind: HTMLSelectElement;
    private readonly inputs = h('span', { class: 'inputs' });
    private readonly patch = h('span', { class: 'patch' });
    private isSliding = false;
    private fields: HTMLInputElement[] = [];
    private slider: HTMLInputElement | null = null;
    private shown: Kind | '' | null = null;

    constructor(
        private readonly base: string,
        private readonly keys: Map<string, Key>,
        private readonly host: Host,
    ) {
        const options = KINDS.map((kind): [string, string] => [kind, this.key(kind)?.label ?? kind]);
        this.kind = choice(t('Colour'), [['', t('white')], ...options], '', (kind) => void this.choose(kind as Kind | ''));
        const caption = h('span', { class: 'caption', title: `${base}.color` }, t('Colour'));
        this.row = h('div', { class: 'field lamp-colour' }, caption, h('span', { class: 'inputs' }, this.patch, this.kind), this.inputs, this.note);
    }

    private key(kind: Kind): Key | undefined {
        return this.keys.get(`${this.base}.color.${kind}`);
    }

    /** Shows the value of one of the keys; null: the lamp has not that one. */
    update(path: string, value: string | null) {
        this.values.set(KEY.exec(path)![2] as Kind, value);
        const given = KINDS.find((kind) => (this.values.get(kind) ?? null) !== null) ?? '';
        if (given !== this.shown) this.build(given);
        this.kind.value = given;
        if (given) this.show(given, this.values.get(given)!);
        void this.showPatch();
    }

    private async showPatch() {
        const of = this.host.model.asWhole();
        const colours = of ? await this.host.model.client.ask('lightColors', of).catch(() => []) : [];
        const rgb = colours[Number(/\d+/.exec(this.base))];
        if (rgb) this.patch.style.background = swatch(rgb);
    }

    // A scene in which a lamp gets a colour is computed in colour.
    private set(value: string, mark = '') {
        const changes: Change[] = [{ set: 'channels=rgb' }, { set: `${this.base}.color=${value}` }];
        return this.host.model.change(changes, mark);
    }

    // The other key begins with the colour that the lamp has.
    private async choose(kind: Kind | '') {
        if (!kind) return this.host.model.change([{ remove: `${this.base}.color` }]);
        const of = this.host.model.asWhole();
        const colours = of ? await this.host.model.client.ask('lightColors', of).catch(() => []) : [];
        const rgb = colours[Number(/\d+/.exec(this.base))] ?? [1, 1, 1];
        const rounded = (numbers: number[]) => `[${numbers.map((part) => Number(part.toFixed(5))).join(', ')}]`;
        if (kind === 'temperature') return this.set('{temperature: 3000}');
        if (kind === 'xy') return this.set(`{xy: ${rounded(chromaticity(rgb))}}`);
        if (kind === 'rgb') return this.set(`{rgb: ${rounded(rgb)}}`);
        this.build('spectrum');
        this.kind.value = kind;
        this.fields[0]?.focus();
        return true;
    }

    private build(kind: Kind | '') {
        this.shown = kind;
        this.slider = null;
        this.fields = [];
        const count = kind === 'xy' ? 2 : kind === 'rgb' ? 3 : kind ? 1 : 0;
        for (let i = 0; i < count; i++) {
            const label = kind === 'xy' ? 'xy'[i] : kind === 'rgb' ? 'RGB'[i] : (this.key(kind as Kind)?.label ?? kind);
            const input = h('input', { type: 'text', inputmode: kind === 'spectrum' ? 'text' : 'decimal', 'aria-label': label });
            input.addEventListener('change', () => this.commit(kind as Kind));
            this.fields.push(input);
        }
        this.inputs.replaceChildren(...this.fields);
        if (kind === 'temperature') this.inputs.append(this.newSlider());
    }

    private newSlider(): HTMLElement {
        const slider = h('input', { type: 'range', min: 0, max: STEPS, class: 'temperatures', 'aria-label': this.key('temperature')?.label ?? '' });
        slider.addEventListener('input', () => {
            this.isSliding = true;
            const kelvin = Math.round(temperatureAt(Number(slider.value)) / 10) * 10;
            void this.set(`{temperature: ${kelvin}}`, `slide ${this.base}.color`);
        });
        slider.addEventListener('change', () => {
            this.isSliding = false;
            this.host.model.endStep();
        });
        this.slider = slider;
        void this.paintSlider(slider);
        return slider;
    }

    private async paintSlider(slider: HTMLInputElement) {
        const places = Array.from({ length: STOPS }, (_, i) => temperatureAt((STEPS * i) / (STOPS - 1)));
        const colours = await Promise.all(places.map((kelvin) => this.host.model.client.ask('blackBody', kelvin)));
        slider.style.background = `linear-gradient(to right, ${colours.map(swatch).join(', ')})`;
    }

    private commit(kind: Kind) {
        this.fields.forEach(takeIn);
        if (kind === 'spectrum') return void this.set(`{spectrum: ${JSON.stringify(this.fields[0].value)}}`);
        const numbers = this.fields.map((input) => typedNumber(input.value));
        const wrong = this.fields.find((_, i) => numbers[i] === null);
        const path = `${this.base}.color.${kind}`;
        this.host.complain(path, wrong ? `“${wrong.value.trim()}” ${t('is not a number.')}` : '');
        if (!wrong) void this.set(`{${kind}: ${numbers.length > 1 ? `[${numbers.join(', ')}]` : numbers[0]}}`);
    }

    private show(kind: Kind, text: string) {
        if (kind === 'spectrum') {
            showIn(this.fields[0], text.replace(/^"|"$/g, ''));
            return;
        }
        const numbers = JSON.parse(text.startsWith('[') ? text : `[${text}]`) as number[];
        this.fields.forEach((input, i) => showIn(input, number(numbers[i], 10)));
        if (this.slider && !this.isSliding) this.slider.value = String(placeOf(numbers[0]));
    }
}

/** Whether a key is of a material's colour. */
export function isMaterialColour(path: string): boolean {
    return /\.(specular_)?color$/.test(path);
}

/** A picker for three factors of linear sRGB, which shows them as displays do; `set` takes them as YAML. */
export function colourPicker(label: string, set: (value: string, mark: string) => unknown, ended: () => void) {
    const level = (part: number) => Math.round(255 * curve(Math.max(0, Math.min(1, part)))).toString(16).padStart(2, '0');
    const input = h('input', { type: 'color', 'aria-label': label, title: t('linear sRGB: factors, not the levels of a display') });
    input.addEventListener('input', () => {
        const parts = [1, 3, 5].map((i) => Number(uncurve(parseInt(input.value.slice(i, i + 2), 16) / 255).toFixed(4)));
        set(`[${parts.join(', ')}]`, `picker ${label}`);
    });
    input.addEventListener('change', ended);
    const update = (value: string | null) => {
        const parts = (JSON.parse(value ?? '[1, 1, 1]') as number[]) ?? [1, 1, 1];
        if (document.activeElement !== input) input.value = `#${parts.map(level).join('')}`;
    };
    return { input, update };
}
