// SPDX-License-Identifier: MIT
// Several lamps chosen together: moved, dimmed, switched, copied and removed as one.
import type { Change } from './core';
import { h } from './dom';
import type { Model, Thing } from './model';
import { number, t } from './words';

// The key that says how strong a light is: the first of these that it has.
const STRENGTHS = ['factor', 'intensity', 'radiance', 'irradiance', 'power', 'flux'];
const MOST = 200; // per cent of its strength that the slider goes to

export class Several {
    /** What is done with them, for the drawer. */
    readonly element = h('div', { class: 'several', hidden: true });
    /** Told that others are chosen. */
    onChange: () => void = () => undefined;
    private chosen = new Set<number>();
    private of = 0; // the scene that they are of
    private dimming: { mark: string; before: [string, number | number[]][] } | null = null;
    private steps = 0;
    private wanted: number | null = null; // per cent, while a hand slides
    private isBusy = false;

    constructor(private readonly model: Model) {
        model.listen((topic) => topic === 'geometry' && this.check());
    }

    /** The lamps that are chosen together; one alone is not. */
    get all(): number[] {
        return this.chosen.size > 1 ? [...this.chosen].sort((a, b) => a - b) : [];
    }

    has(index: number): boolean {
        return this.chosen.size > 1 && this.chosen.has(index);
    }

    /** What goes along when one of them is moved. */
    besides(thing: Thing): Thing[] {
        if (thing.kind !== 'light' || !this.has(thing.index)) return [];
        return this.model.things.filter(({ kind, index }) => kind === 'light' && index !== thing.index && this.chosen.has(index));
    }

    /** Takes a lamp in beside the one that was chosen before, or out again. */
    toggle(index: number, before: Thing | null) {
        const isLamp = before && before.kind !== 'surface' && before.kind !== 'observer';
        if (!this.chosen.size && isLamp) this.chosen.add(before.index);
        if (!this.chosen.delete(index)) this.chosen.add(index);
        this.changed();
    }

    /** Chooses lamps from one to another. */
    from(first: number, last: number) {
        const [low, high] = [Math.min(first, last), Math.max(first, last)];
        this.take(Array.from({ length: high - low + 1 }, (_, i) => low + i));
    }

    everything() {
        this.take((this.model.scene?.lights ?? []).map((_, i) => i));
    }

    clear() {
        if (this.chosen.size) this.take([]);
    }

    private take(chosen: number[]) {
        this.chosen = new Set(chosen);
        this.changed();
    }

    private changed() {
        this.of = this.model.version.scene;
        this.dimming = null;
        this.relabel();
        this.onChange();
    }

    // Lamps may be fewer, or of another scene.
    private check() {
        const count = this.model.scene?.lights.length ?? 0;
        if (!this.chosen.size) return;
        if (this.of !== this.model.version.scene || [...this.chosen].some((index) => index >= count)) this.clear();
    }

    /** In the words of the present language. */
    relabel() {
        const { all } = this;
        this.element.hidden = !all.length;
        if (!all.length) return this.element.replaceChildren();
        const button = (label: string, onclick: () => unknown) => h('button', { type: 'button', class: 'link', onclick: () => void onclick() }, t(label));
        const slider = h('input', { type: 'range', min: 0, max: MOST, value: 100, 'aria-label': t('Brightness of all') });
        const shown = h('output', {}, '100 %');
        slider.addEventListener('input', () => {
            shown.textContent = `${number(Number(slider.value), 3)} %`;
            void this.dim(Number(slider.value));
        });
        slider.addEventListener('change', () => this.model.endStep());
        this.element.replaceChildren(
            h('p', { role: 'status' }, `${t('Lamps chosen')}: ${all.map((i) => i + 1).join(', ')}`),
            h('label', {}, t('Brightness of all'), slider, shown),
            h('div', { class: 'actions' }, button('On or off', () => this.toggleLight()), button('Duplicate', () => this.duplicate()), button('Remove', () => this.remove()), button('One alone', () => this.clear())),
        );
    }

    // Every strength is so many per cent of what it was as the slider was taken first.
    private async dim(percent: number) {
        this.wanted = percent;
        if (this.isBusy) return;
        this.isBusy = true;
        try {
            this.dimming ??= { mark: `dim ${++this.steps} ${this.model.version.scene}`, before: await this.strengths() };
            while (this.wanted !== null) {
                const share = this.wanted / 100;
                this.wanted = null;
                const scaled = (value: number) => Number((value * share).toPrecision(6));
                const changes = this.dimming.before.map(([key, value]): Change => ({
                    set: `${key}=${Array.isArray(value) ? `[${value.map(scaled).join(', ')}]` : scaled(value)}`,
                }));
                if (await this.model.change(changes, this.dimming.mark)) await this.model.pictured();
            }
        } finally {
            this.isBusy = false;
        }
    }

    private async strengths(): Promise<[string, number | number[]][]> {
        const { all } = this;
        const of = this.model.asWhole();
        if (!of) return [];
        const keys = all.flatMap((index) => STRENGTHS.map((key) => `lights[${index}].${key}`));
        const values = await this.model.client.ask('keys', of, keys);
        return all.flatMap((index, i): [string, number | number[]][] => {
            const own = STRENGTHS.map((_, k) => i * STRENGTHS.length + k);
            const first = own.find((k) => values[k] !== null);
            if (first !== undefined) return [[keys[first], JSON.parse(values[first]!) as number | number[]]];
            return this.model.scene?.lights[index]?.type === 'luminaire' ? [[keys[own[0]], 1]] : [];
        });
    }

    /** Switches all of them off, or on where all are off. */
    toggleLight() {
        const { all } = this;
        const isAnyOn = all.some((index) => this.model.scene?.lights[index]?.enabled);
        return this.model.change(all.map((index) => ({ set: `lights[${index}].enabled=${!isAnyOn}` })));
    }

    remove() {
        const changes = this.all.reverse().map((index) => ({ remove: `lights[${index}]` }));
        this.clear();
        return this.model.change(changes);
    }

    /** Copies stand behind all lights, a little aside, and are chosen then. */
    async duplicate() {
        const { all } = this;
        const count = this.model.scene?.lights.length ?? 0;
        if (!(await this.model.duplicate('lights', all))) return;
        this.take(all.map((_, i) => count + i));
    }
}
