// SPDX-License-Identifier: MIT
// The form: every key of the scene that has a value, and those that could have one behind "more", in the core's own
// words, with its units and ranges.  What is typed becomes an assignment to the text.
import { colourPicker, isMaterialColour, LampColour, lampOfColour } from './colour_fields';
import type { Key, Kind } from './core';
import { chip, choice, h, isTypedOver, lightStyle, showIn, takeIn } from './dom';
import { CHOICE, CHOICE_OR_PAIR, CHOICE_OR_WHOLE, NUMBER, NUMBERS, sceneKeys, TEXT, WHOLE, WHOLE_NUMBERS, YES_OR_NO } from './keys';
import type { Model } from './model';
import { dateSliders, sunOf, sunSwitch } from './sun/fields';
import { newSurface } from './new_surface';
import type { Of, Version } from './version';
import { number, t, typedNumber } from './words';

interface Field {
    path: string;
    key: Key;
    update(value: string | null): void;
    row: HTMLElement;
    note: HTMLElement;
    /** What is wrong with what was typed, which the scene therefore does not have; empty: nothing. */
    trouble: string;
}

/** The row of a light or a body: how it is opened, and what it gives at the probe. */
interface Row {
    list: string;
    index: number;
    element: HTMLElement;
    name: HTMLElement;
    open(): void;
    amount: HTMLElement; // of a light: its irradiance at the probe
    bar: HTMLElement;
}

// What says how the formula is meant, rather than what the scene is.
const CONVENTIONS =
    /\.(over_pi|highlight|normalized|falloff|rounding|range|tolerance|parts|pixels|view|opening|interpolation|units)$|^(tolerance|parts|units)$/;

// Names, which stand in the row, and what is changed seldom.
const SELDOM_CHANGED = /^\w+\[\d+\](\.\w+)?\.(name|enabled|up|sides|c0|maintenance_factor)$/;
// What stands first, below each other: the kind, and how much light there is.
const FIRST = [/\.type$/, /^lights\[\d+\]\.(intensity|radiance|power|irradiance|horizontal|zenith|flux)$/];

const MANY = 60; // lights whose irradiance is told seldom while the probe moves
const SELDOM = 250; // milliseconds
const STILL = 3; // pixels that a hand moves without meaning it

/** A key of a thing, and whether the thing has a value of it. */
interface Entry {
    path: string;
    key: Key;
    isGiven: boolean;
}

function quoted(text: string): string {
    return JSON.stringify(text);
}

/** A text as the scene writes it, with quotes or without. */
function unquoted(text: string): string {
    try {
        const read: unknown = text.startsWith('"') ? JSON.parse(text) : text;
        return typeof read === 'string' ? read : text;
    } catch {
        return text;
    }
}

/** What is wrong with a number that was typed; empty: nothing. */
function troubleOf(text: string): string {
    if (!text.trim()) return t('A number is needed here.');
    return typedNumber(text) === null ? `“${text.trim()}” ${t('is not a number.')}` : '';
}

/** The numbers of a value in YAML; a number that JSON writes otherwise: null. */
function numbersOf(text: string | null): number[] | null {
    try {
        const numbers: unknown = JSON.parse(text ?? '[]');
        return Array.isArray(numbers) ? numbers : null;
    } catch {
        return null;
    }
}

// Whether a thing has something else instead: an aim, or another outline than the one that the key is of.
function isUnused(path: string, entries: Entry[]): boolean {
    const given = (wanted: string) => entries.some((each) => each.path === wanted && each.isGiven);
    const [, base, name] = /^(.*)\.(\w+)$/.exec(path) ?? [];
    if (name === 'axis') return given(`${base}.aim`) || (/\]\.\w+$/.test(base) && !given(`${base}.center`));
    return false;
}

/** A parameter of the scene as it is told: of which thing, and in which tab of the drawer it stands. */
export interface Parameter {
    path: string;
    label: string;
    meaning: string;
    thing: string;
    tab: 'light' | 'matter' | 'place';
}

export class Form {
    readonly element = h('div', { class: 'form' });
    private keys: Key[] = [];
    private kinds: Kind[] = [];
    private fields: Field[] = []; // those that were ever to be seen
    private paths: [string, Key][] = []; // of all parameters
    private values = new Map<string, string | null>();
    private titles: (() => void)[] = []; // tell what each light and surface is
    private shape = '';
    private generation = 0; // of the keys' words
    private opened = new Set<string>();
    private rows: Row[] = [];
    private showsMore = false; // whether "more" was opened last
    private sharesOf: Version | null = null; // which the rows of the lights show
    private shares: number[] = [];
    private sharesTimer = 0;
    private refreshTimer = 0;
    private chosen = ''; // the base of the light or body that is chosen
    private together: number[] = []; // lamps that are chosen together
    /** Chooses a light or a body whose row was pressed. */
    onChoose: (list: string, index: number) => void = () => undefined;
    /** Takes a lamp in beside those that are chosen, or all from the last chosen one to it. */
    onChooseMore: (index: number, isRange: boolean) => void = () => undefined;
    /** Told which row the hand is on; null: on none. */
    onHover: (list: string | null, index: number) => void = () => undefined;
    /** Aims a light at the probe. */
    onAim: (index: number) => void = () => undefined;

    /** Shows what a light sends into each direction. */
    onPolar: (index: number) => void = () => undefined;

    private of: Of | null = null; // whose values are shown

    /** `chosenLight`: the number of the light that new ones are like; `several`: what stands above the lamps. */
    constructor(
        private readonly model: Model,
        private readonly chosenLight: () => number,
        private readonly several: HTMLElement,
    ) {
        model.follow(this.element, () => this.of);
        model.follow(
            () => this.rows.map(({ amount }) => amount),
            () => this.sharesOf,
        );
    }

    /** Tells in the rows of the lights the irradiance that each gives at the probe. */
    tellLit(shares: number[], of: Version | null) {
        [this.shares, this.sharesOf] = [shares, of];
        if (shares.length <= MANY) return this.showShares();
        this.sharesTimer ||= window.setTimeout(() => {
            this.sharesTimer = 0;
            this.showShares();
        }, SELDOM);
    }

    private showShares() {
        const { shares } = this;
        const all = shares.reduce((sum, share) => sum + share, 0);
        for (const { list, index, amount, bar } of this.rows) {
            if (list !== 'lights') continue;
            const share = shares[index];
            const unit = this.model.scene?.irradiance_unit ?? '';
            const told = share === undefined ? '' : number(share, 4);
            const [value, ofValue] = [amount.firstChild as Text, amount.lastChild as HTMLElement];
            if (value.data !== told) value.data = told;
            const shown = told && !['relative', t('relative')].includes(unit) ? ` ${unit}` : '';
            if (ofValue.textContent !== shown) ofValue.textContent = shown;
            bar.style.inlineSize = share && all > 0 ? `${Math.max(0, (100 * share) / all)}%` : '0';
        }
        this.model.dim();
    }

    /** Marks the row of what is chosen in the views, and opens it. */
    markChosen(list: string | null, index: number) {
        const base = list === null ? '' : `${list}[${index}]`;
        const isNew = base !== this.chosen;
        this.chosen = base;
        for (const row of this.rows) {
            const isChosen = base === `${row.list}[${row.index}]`;
            row.element.classList.toggle('chosen-row', isChosen);
            if (isChosen && isNew) row.open();
        }
    }

    /** Marks the rows of lamps that are chosen together. */
    markSeveral(indices: number[]) {
        this.together = indices;
        for (const { list, index, element } of this.rows) element.classList.toggle('chosen-too', list === 'lights' && indices.includes(index));
    }

    /** All parameters that the form has, or would have. */
    parameters(): Parameter[] {
        return this.paths.map(([path, { label, meaning }]) => {
            const row = this.rowOf(path);
            const thing = row ? `${row.index + 1}  ${row.name.textContent}` : t('Scene');
            return { path, label: label || path, meaning, thing, tab: !row ? 'place' : row.list === 'lights' ? 'light' : 'matter' };
        });
    }

    // The row of the light or the body that a parameter is of.  Rows stand in order, list by list.
    private rowOf(path: string): Row | undefined {
        const [, list, index] = /^(lights|surfaces)\[(\d+)\]/.exec(path) ?? [];
        return list ? this.rows[this.rows.findIndex((row) => row.list === list) + Number(index)] : undefined;
    }

    /** Opens the row of a parameter and brings the keys to it. */
    show(path: string) {
        this.rowOf(path)?.open();
        const field = this.fields.find((each) => each.path === path);
        if (!field) return;
        for (let details = field.row.closest('details'); details; details = details.parentElement?.closest('details') ?? null) details.open = true;
        field.row.scrollIntoView({ block: 'center' });
        field.row.querySelector<HTMLElement>('input:not([type=range]), select, button')?.focus();
    }

    /** Marks the row of what the hand is on in the views. */
    markHovered(list: string | null, index: number) {
        for (const row of this.rows) row.element.classList.toggle('hovered-row', row.list === list && row.index === index);
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.of = null;
        this.shape = this.chosen = '';
        this.opened.clear();
        this.fields = [];
        this.rows = [];
        [this.shares, this.sharesOf] = [[], null];
        this.element.replaceChildren();
    }

    async reload() {
        ({ keys: this.keys, kinds: this.kinds } = await this.model.client.ask('parameters'));
        this.generation++;
        await this.refreshNow();
    }

    /** Shows the present values, seldom while a hand changes a scene of very many lights. */
    async refresh() {
        const isMany = this.rows.length > MANY && this.of?.scene === this.model.version.scene;
        if (!isMany) return this.refreshNow();
        this.refreshTimer ||= window.setTimeout(() => {
            this.refreshTimer = 0;
            void this.refreshNow().catch(() => undefined);
        }, SELDOM);
    }

    // The form is built anew only where other keys are to be seen.
    private async refreshNow() {
        const of = this.model.asWhole();
        const { generation } = this;
        if (!of || !this.keys.length) return;
        const { lists, paths: wanted, values } = await sceneKeys(this.model, this.keys);
        if (generation !== this.generation) return; // whoever changed the words comes after this
        if (of.scene !== this.model.version.scene || of.number < (this.of?.number ?? 0)) return;
        this.of = of;
        const shape = JSON.stringify([
            generation,
            lists,
            wanted.map(([path], i) => (values[i] === null ? 0 : path)),
            this.model.photometric,
        ]);
        this.values = new Map(wanted.map(([path], i) => [path, values[i]]));
        if (shape !== this.shape) {
            this.shape = shape;
            this.build(lists, wanted, values);
        }
        this.fields.forEach((field) => field.update(this.values.get(field.path) ?? null));
        this.titles.forEach((tell) => tell());
        this.showShares();
        this.showMessages();
        this.model.dim();
    }

    showMessages() {
        // A row of several keys, as a lamp's colour, tells what is wrong with any of them.
        const told = new Map<HTMLElement, { row: HTMLElement; text: string; isWrong: boolean }>();
        for (const { path, row, note, trouble } of this.fields) {
            const message = this.model.messages.find(({ key }) => key === path);
            const text = told.get(note)?.text || trouble || (message?.message ?? '');
            told.set(note, { row, text, isWrong: told.get(note)?.isWrong || !!trouble || !!message?.error });
        }
        for (const [note, { row, text, isWrong }] of told) {
            note.textContent = text;
            row.classList.toggle('wrong', isWrong);
        }
    }

    // Says what is wrong with what was typed into a field, or that nothing is any more.
    private complain(path: string, trouble: string) {
        const field = this.fields.find((each) => each.path === path);
        if (field) field.trouble = trouble;
        this.showMessages();
    }

    private build(lists: [string, string[]][], paths: [string, Key][], values: (string | null)[]) {
        const groups = new Map<string, Entry[]>();
        paths.forEach(([path, key], i) => {
            const base = /^(?:surfaces|lights)\[\d+\]/.exec(path)?.[0] ?? 'scene';
            if (!groups.has(base)) groups.set(base, []);
            groups.get(base)!.push({ path, key, isGiven: values[i] !== null });
        });
        this.paths = paths;
        this.fields = [];
        this.titles = [];
        this.rows = [];
        const [light, matter, place] = ['light', 'matter', 'place'].map((tab) => h('div', { 'data-tab': tab }));
        this.element.replaceChildren(light, matter, place);
        for (const [list, types] of lists) {
            const isLights = list === 'lights';
            const room = isLights ? light : matter;
            room.append(h('h3', {}, t(isLights ? 'Lamps' : 'Bodies'), this.adder(list)));
            if (isLights) room.append(this.several);
            types.forEach((type, i) => {
                const isOpen = i === 0 && types.length < 4;
                room.append(this.thing(list, i, type, groups.get(`${list}[${i}]`) ?? [], isOpen));
            });
        }
        place.append(h('h3', {}, t('Scene')), ...this.sectionFields(groups.get('scene') ?? []));
        this.markSeveral(this.together);
        this.markChosen(/^\w+/.exec(this.chosen)?.[0] ?? null, Number(/\d+/.exec(this.chosen)?.[0]));
    }

    // The row of a light or a body, with its fields below it when it is open.
    private thing(list: string, index: number, type: string, entries: Entry[], isFirst: boolean): HTMLElement {
        const base = `${list}[${index}]`;
        const isLights = list === 'lights';
        const name = h('span', { class: 'name' });
        const flux = h('span', { class: 'flux dim' });
        const amount = h('span', { class: 'of-probe' });
        amount.append(document.createTextNode(''), h('span', { class: 'unit' }));
        const bar = h('span', { class: 'bar' });
        if (isLights) bar.style.background = lightStyle(index);
        const mark = isLights ? chip(index) : h('span', { class: 'dim' }, String(index + 1));
        const summary = h(
            'summary',
            { onclick: (event: MouseEvent) => this.choosesRow(event, list, index) },
            mark,
            name,
            isLights && flux,
            amount,
            isLights && h('span', { class: 'track' }, bar),
        );
        const isOpen = this.opened.has(base) || isFirst;
        const details = h('details', { open: isOpen }, summary);
        // Fields are made when they are to be seen: a scene may have thousands of lights.
        let isFilled = false;
        const fill = () => {
            const known = this.titles.length;
            if (!isFilled) details.append(...this.sectionFields(entries), this.actions(list, index));
            isFilled = true;
            this.titles.slice(known).forEach((tell) => tell());
        };
        if (isOpen) fill();
        details.addEventListener('toggle', () => {
            if (details.open) fill();
            details.open ? this.opened.add(base) : this.opened.delete(base);
        });
        const eye = isLights && this.switcher(index);
        const hover = (isOn: boolean) => this.onHover(isOn ? list : null, index);
        const element = h('div', { class: 'thing', onpointerenter: () => hover(true), onpointerleave: () => hover(false) }, details, eye);
        this.titles.push(() => {
            const light = isLights ? this.model.scene?.lights[index] : null; // lists may be newer than the scene
            const own = isLights ? light?.name : unquoted(this.values.get(`${base}.name`) ?? '');
            const kind = this.kindWords(list, type);
            name.replaceChildren(...(own ? [own, h('span', { class: 'dim' }, ` ${kind}`)] : [kind]));
            const given = light?.flux ?? -1;
            flux.textContent = given >= 0 ? `Φ ${number(given, 4)} ${t(this.model.photometric ? 'lm' : 'W')}` : '';
            const isOn = light?.enabled ?? true;
            element.classList.toggle('is-off', !isOn);
            mark.classList.toggle('off', !isOn);
            if (eye) eye.setAttribute('aria-pressed', String(isOn));
        });
        const open = () => {
            details.open = true;
            fill();
            element.scrollIntoView?.({ block: 'nearest' });
        };
        this.rows.push({ list, index, element, name, open, amount, bar });
        return element;
    }

    // The press opens the row or closes it by itself, or takes the lamp in beside others.
    private choosesRow(event: MouseEvent, list: string, index: number) {
        const isMore = event.ctrlKey || event.metaKey || event.shiftKey;
        if (isMore && list === 'lights') {
            event.preventDefault();
            return this.onChooseMore(index, event.shiftKey);
        }
        this.chosen = `${list}[${index}]`;
        this.onChoose(list, index);
    }

    // Switches a light on and off.
    private switcher(index: number): HTMLElement {
        return h(
            'button',
            {
                type: 'button',
                class: 'eye',
                'aria-label': `${t('Lamp on')}: ${index + 1}`,
                title: t('Lamp on'),
                onclick: () => this.set(`lights[${index}].enabled`, String(!this.model.scene?.lights[index]?.enabled)),
            },
            '◉',
        );
    }

    /** The fields of a thing, those that it does not give behind "more". */
    private sectionFields(entries: Entry[]): HTMLElement[] {
        const shown = h('div', {});
        const hidden = h('div', {});
        const known = this.fields.length;
        const isShown = ({ path, isGiven }: Entry) =>
            isGiven && !path.includes('.materials.') && !CONVENTIONS.test(path) && !SELDOM_CHANGED.test(path) && !isUnused(path, entries);
        const rank = ({ path }: Entry) => (FIRST.findIndex((each) => each.test(path)) + FIRST.length + 1) % (FIRST.length + 1);
        const ahead = entries.filter(isShown);
        const add = (entry: Entry, place: HTMLElement, beside: Entry[]) => place.append(this.field(entry.path, this.told(entry.path, entry.key, beside)));
        const isColour = ({ path }: Entry) => lampOfColour(path) !== null;
        for (const entry of ahead.sort((a, b) => rank(a) - rank(b))) if (!isColour(entry)) add(entry, shown, ahead);
        this.lampColours(entries, shown);
        for (const entry of entries) if (!ahead.includes(entry) && !isColour(entry)) add(entry, hidden, entries);
        const sun = entries.find(({ path, isGiven }) => isGiven && sunOf(path));
        if (sun) shown.append(sunSwitch(this.model, sunOf(sun.path)!));
        this.fields.slice(known).forEach((field) => field.update(this.values.get(field.path) ?? null));
        this.showMessages();
        if (hidden.childElementCount === 0) return [shown];
        const more = h('details', { class: 'more', open: this.showsMore }, h('summary', {}, t('More: name, conventions')), hidden);
        more.addEventListener('toggle', () => (this.showsMore = more.open));
        return [shown, more];
    }

    // The keys of a lamp's colour have one field together, which is put into a place.
    private lampColours(entries: Entry[], place: HTMLElement) {
        const keys = new Map(entries.filter(({ path }) => lampOfColour(path)).map(({ path, key }) => [path, key]));
        const [first] = keys.keys();
        if (!first) return;
        const complain = (path: string, trouble: string) => this.complain(path, trouble);
        const field = new LampColour(lampOfColour(first)!, keys, { model: this.model, complain });
        place.append(field.row);
        for (const [path, key] of keys)
            this.fields.push({ path, key, update: (value) => field.update(path, value), row: field.row, note: field.note, trouble: '' });
    }

    private kindWords(list: string, type: string): string {
        return this.kinds.find((kind) => kind.list === list && kind.name === type)?.label ?? type;
    }

    // A key of a part of a thing is told with the part, "Axis, rectangle", where another key of the thing is called the same.
    private told(path: string, key: Key, all: Entry[]): Key {
        const [, part] = /^\w+\[\d+\]\.(\w+)\./.exec(path) ?? [];
        if (!part || !all.some((other) => other.path !== path && other.key.label === key.label)) return key;
        return { ...key, label: `${key.label}, ${this.kindWords('surfaces', part)}` };
    }

    // What is done with a light or a body as a whole.
    private actions(list: string, index: number): HTMLElement {
        const base = `${list}[${index}]`;
        const button = (label: string, onclick: () => unknown) =>
            h('button', { type: 'button', class: 'link', onclick: () => void onclick() }, t(label));
        const solo = list === 'lights' && button('Solo', () => this.model.solo(index));
        const aim = list === 'lights' && button('Aim at the probe', () => this.onAim(index));
        const polar = list === 'lights' && button('Polar diagram', () => this.onPolar(index));
        this.titles.push(() => {
            if (polar) polar.hidden = !this.model.scene?.lights[index]?.place;
            if (solo) solo.setAttribute('aria-pressed', String(this.model.isSolo(index)));
            if (aim) aim.hidden = !this.model.aimOf(index);
            if (solo) solo.hidden = (this.model.scene?.lights.length ?? 0) < 2;
        });
        return h(
            'div',
            { class: 'actions' },
            solo,
            aim,
            polar,
            button('Duplicate', () => this.model.duplicate(list, [index])),
            button('Remove', () => this.model.change([{ remove: base }])),
        );
    }

    private adder(list: string) {
        const kinds = this.kinds.filter((kind) => kind.list === list && kind.example);
        const select = choice(
            t('Add'),
            [
                ['', `${t('Add')}…`],
                ...kinds.map(({ name, label, meaning }): [string, string] => [name, `${label}: ${meaning}`]),
            ],
            '',
            (name) => {
                const kind = kinds.find((each) => each.name === name);
                select.value = '';
                if (kind && list === 'lights') this.model.addLight(kind.name, this.chosenLight());
                else if (kind) this.model.change(newSurface(this.model, kind.example!));
            },
        );
        return select;
    }

    private set(path: string, value: string, mark = '') {
        return this.model.change([{ set: `${path}=${value}` }], mark);
    }

    // Another kind of light or surface has other keys: a light is fitted, a surface begins as the example of its kind.
    private choose(path: string, word: string) {
        const found = /^(lights|surfaces)\[(\d+)\]\.type$/.exec(path);
        const kind = found && this.kinds.find(({ list, name }) => list === found[1] && name === word);
        if (!found || !kind?.example) return this.set(path, word);
        const [, list, index] = found;
        if (list === 'lights') return this.model.changeLight(word, Number(index));
        return this.model.change([
            { remove: `${list}[${index}]` },
            { list, index: Number(index), insert: kind.example },
        ]);
    }

    private field(path: string, key: Key): HTMLElement {
        const name = `field-${path}`;
        const note = h('p', { class: 'note', role: 'alert' });
        const unit = this.model.photometric ? key.photometric : key.unit;
        const caption = h(
            'span',
            { class: 'caption', id: name, title: `${path}: ${key.meaning}${key.legal ? ` (${key.legal})` : ''}` },
            key.label,
            unit ? h('span', { class: 'unit' }, ` ${unit}`) : null,
        );
        const { inputs, update } = this.colourInputs(path, key, this.inputs(path, key, name, caption));
        const row = h('div', { class: 'field' }, caption, h('span', { class: 'inputs' }, ...inputs), note);
        this.fields.push({ path, key, update, row, note, trouble: '' });
        return row;
    }

    // A picker beside the numbers of a material's colour.
    private colourInputs(path: string, key: Key, made: { inputs: HTMLElement[]; update(value: string | null): void }) {
        if (!isMaterialColour(path)) return made;
        const set = (value: string, mark: string) => this.model.change([{ set: 'channels=rgb' }, { set: `${path}=${value}` }], mark);
        const picker = colourPicker(key.label, set, () => this.model.endStep());
        const update = (value: string | null) => {
            made.update(value);
            picker.update(value);
        };
        return { inputs: [picker.input, ...made.inputs], update };
    }

    private inputs(
        path: string,
        key: Key,
        name: string,
        caption: HTMLElement,
    ): { inputs: HTMLElement[]; update(value: string | null): void } {
        switch (key.type) {
            case YES_OR_NO: {
                const box = h('input', {
                    type: 'checkbox',
                    'aria-labelledby': name,
                    onchange: () => this.set(path, String(box.checked)),
                });
                return { inputs: [box], update: (value) => (box.checked = value === 'true') };
            }
            case CHOICE: {
                const select = this.choices(path, key, name, '');
                return { inputs: [select], update: (value) => (select.value = value ?? '') };
            }
            case CHOICE_OR_PAIR:
            case CHOICE_OR_WHOLE:
                return this.choiceOrNumbers(path, key, name);
            case NUMBER:
            case WHOLE:
                return this.numberInputs(path, key, name, caption);
            case NUMBERS:
            case WHOLE_NUMBERS:
                return this.vectorInputs(path, key);
            default: {
                const input = h('input', {
                    type: 'text',
                    'aria-labelledby': name,
                    onchange: () => {
                        takeIn(input);
                        this.set(path, key.type === TEXT ? quoted(input.value) : input.value);
                    },
                });
                const sliders = sunOf(path) ? dateSliders(this.model, path) : null;
                input.classList.toggle('date', !!sliders);
                const update = (value: string | null) => {
                    showIn(input, unquoted(value ?? ''));
                    sliders?.update(value === null ? null : unquoted(value));
                };
                return { inputs: [input, ...(sliders?.rows ?? [])], update };
            }
        }
    }

    // The choices by their labels, and a first entry of no choice.
    private choices(path: string, key: Key, name: string, none: string) {
        const words = (key.choices ?? '').split(', ');
        const select = h('select', {
            'aria-labelledby': name,
            onchange: () => select.value && this.choose(path, select.value),
        });
        select.append(
            h('option', { value: '' }, none),
            ...words.map((word, i) => h('option', { value: word }, key.labels[i] ?? word)),
        );
        return select;
    }

    // The choices, and a field for numbers in their stead, as the scene's text has them: 3 or [0, 5].
    private choiceOrNumbers(path: string, key: Key, name: string) {
        const words = (key.choices ?? '').split(', ');
        const select = this.choices(path, key, name, t('numbers…'));
        const input = h('input', {
            type: 'text',
            'aria-labelledby': name,
            onchange: () => {
                takeIn(input);
                if (input.value.trim()) this.set(path, input.value);
                else this.complain(path, t('A number is needed here.'));
            },
        });
        select.addEventListener('change', () => {
            input.hidden = select.value !== '';
            if (!input.hidden) input.focus();
        });
        const update = (value: string | null) => {
            if (document.activeElement === input && isTypedOver(input)) return;
            const isWord = value !== null && words.includes(value);
            select.value = isWord ? value : '';
            showIn(input, isWord ? '' : (value ?? ''));
            input.hidden = isWord;
        };
        return { inputs: [select, input], update };
    }

    private numberInputs(path: string, key: Key, name: string, caption: HTMLElement) {
        const input = h('input', { type: 'text', inputmode: 'decimal', 'aria-labelledby': name });
        input.addEventListener('change', () => {
            const value = typedNumber(input.value);
            takeIn(input);
            this.complain(path, troubleOf(input.value));
            input.setAttribute('aria-invalid', String(value === null));
            if (value !== null) this.set(path, String(value));
        });
        const commit = (value: string) => this.set(path, value, `step ${path}`);
        input.addEventListener('keydown', (event) => this.step(event, input, commit));
        this.takeHand(input, (value) => commit(key.type === WHOLE ? String(Math.round(Number(value))) : value), [input, caption]);
        const [low, high] = key.advised ?? [null, null];
        const inputs: HTMLElement[] = [input];
        let slider: HTMLInputElement | null = null;
        let isSliding = false;
        const logarithmic = low !== null && high !== null && low > 0 && high / low > 100;
        if (low !== null && high !== null) {
            slider = h('input', { type: 'range', min: 0, max: 1000, 'aria-labelledby': name });
            const slide = this.model.newest((value) => this.set(path, value, `slide ${path}`));
            slider.addEventListener('input', () => {
                isSliding = true;
                const at = Number(slider!.value) / 1000;
                const value = logarithmic ? low * (high / low) ** at : low + (high - low) * at;
                void slide(String(key.type === WHOLE ? Math.round(value) : Number(value.toPrecision(3))));
            });
            slider.addEventListener('change', () => {
                isSliding = false;
                this.model.endStep();
            });
            inputs.push(slider);
        }
        const update = (text: string | null) => {
            const value = text === null ? null : Number(text);
            const isWrong = input.getAttribute('aria-invalid') === 'true'; // what was typed stays to be mended
            if (!isWrong) showIn(input, value === null ? '' : number(value, 10));
            if (slider && value !== null && !isSliding) {
                const at = logarithmic
                    ? Math.log(value / low!) / Math.log(high! / low!)
                    : (value - low!) / (high! - low!);
                slider.value = String(Math.round(1000 * at));
            }
        };
        return { inputs, update };
    }

    private vectorInputs(path: string, key: Key) {
        const names = key.count === 3 ? ['x', 'y', 'z'] : ['1', '2'];
        let present: number[] = []; // what the scene has
        // What is no number is told, and the scene keeps what it has there; the others count all the same.
        const commit = (mark = '') => {
            const troubles = inputs.map((input) => troubleOf(input.value));
            const numbers = inputs.map((input, i) => typedNumber(input.value) ?? present[i]);
            const told = troubles.flatMap((trouble, i) => (trouble ? [`${names[i]}: ${trouble}`] : []));
            inputs.forEach((input, i) => input.setAttribute('aria-invalid', String(!!troubles[i])));
            this.complain(path, told.join(' '));
            const isNew = numbers.every((value) => value !== undefined) && numbers.join() !== present.join();
            return isNew ? this.set(path, `[${numbers.join(', ')}]`, mark) : Promise.resolve(true);
        };
        const inputs = names.slice(0, key.count).map((axis) => {
            const input = h('input', {
                type: 'text',
                inputmode: 'decimal',
                'aria-label': `${key.label}, ${axis}`,
                onchange: () => {
                    takeIn(input);
                    commit();
                },
            });
            input.addEventListener('keydown', (event) => this.step(event, input, () => commit(`step ${path}`)));
            this.takeHand(input, () => commit(`step ${path}`), [input]);
            return input;
        });
        const update = (text: string | null) => {
            const numbers = numbersOf(text);
            if (!numbers) return;
            present = numbers;
            inputs.forEach((input, i) => {
                const isWrong = input.getAttribute('aria-invalid') === 'true'; // what was typed stays to be mended
                if (!isWrong) showIn(input, numbers[i] === undefined ? '' : number(numbers[i], 10));
            });
        };
        return { inputs: inputs as HTMLElement[], update };
    }

    // A mouse that is pressed on a number or on what it is called, and goes aside, changes it, with Shift by a tenth; a press
    // alone chooses it.
    private takeHand(input: HTMLInputElement, commit: (value: string) => Promise<boolean>, places: HTMLElement[]) {
        const take = this.model.newest((value) => {
            input.value = number(Number(value), 10); // the form may have shown the scene's again
            takeIn(input);
            return commit(value);
        });
        const press = (event: MouseEvent) => {
            const from = typedNumber(input.value);
            const isTyping = document.activeElement === input && event.target === input;
            if (event.button !== 0 || isTyping || from === null) return;
            event.preventDefault(); // the field is not entered yet
            const start = event.clientX;
            const size = from === 0 ? 1 : 10 ** (Math.floor(Math.log10(Math.abs(from))) - 2);
            let isMoved = false;
            const taken: Promise<void>[] = [];
            const move = (next: MouseEvent) => {
                const by = next.clientX - start;
                isMoved ||= Math.abs(by) > STILL;
                if (!isMoved) return;
                taken.push(take(String(Number((from + by * size * (next.shiftKey ? 0.1 : 1)).toPrecision(10)))));
            };
            const end = () => {
                window.removeEventListener('mousemove', move);
                if (isMoved) return void Promise.all(taken).then(() => this.model.endStep()); // the last is taken after the hand has let go
                input.focus();
                input.select();
            };
            window.addEventListener('mousemove', move);
            window.addEventListener('mouseup', end, { once: true });
        };
        for (const place of places) {
            place.classList.add('dragged');
            place.addEventListener('mousedown', press);
        }
    }

    // Up and down change a number by a step of its own size.
    private step(event: KeyboardEvent, input: HTMLInputElement, commit: (value: string) => unknown) {
        const sign = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
        const value = typedNumber(input.value);
        if (!sign || value === null) return;
        event.preventDefault();
        const size = value === 0 ? 10 : 10 ** Math.floor(Math.log10(Math.abs(value)) - 0.5);
        const next = Number((value + sign * size * (event.shiftKey ? 10 : 1)).toPrecision(10));
        input.value = number(next, 10);
        takeIn(input);
        commit(String(next));
    }
}
