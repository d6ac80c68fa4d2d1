// SPDX-License-Identifier: MIT
// What stands where: the stage with its two cameras, the value, the drawer with its tabs, and the strip below the stage.
import { h } from './dom';
import { followPointer } from './drag';
import { t } from './words';

/** Which of the two views fills the stage; the other one is a small picture on it. */
export type Camera = 'space' | 'picture';

export type Tab = 'light' | 'matter' | 'place' | 'view' | 'text' | 'charts';

const TABS: [Tab, string][] = [
    ['light', 'Light'],
    ['matter', 'Matter'],
    ['place', 'Place'],
    ['view', 'View'],
    ['text', 'Text'],
    ['charts', 'Charts'], // on phones, upright and lying
];

export type Chart = 'section' | 'points' | 'histogram' | 'grids' | 'balance';

const CHARTS: [Chart, string][] = [
    ['section', 'Section'],
    ['points', 'Points'],
    ['histogram', 'Histogram'],
    ['grids', 'Grids'],
    ['balance', 'Balance'],
];

type Sheet = 'half' | 'full' | 'tabs';

// Where the strip has no room below the stage, and stands in the sheet.
const PHONE = matchMedia('(max-width: 700px), (max-height: 520px)');

const SWIPE = 24; // pixels that move the sheet

/** Buttons in a row, of which one is pressed. */
class Choice<Name extends string> {
    readonly element: HTMLElement;
    private readonly buttons: [Name, HTMLButtonElement][];

    constructor(names: [Name, string][], style: string, label: string, choose: (name: Name) => void) {
        this.buttons = names.map(([name, word]) => [
            name,
            h('button', { type: 'button', onclick: () => choose(name) }, t(word)),
        ]);
        const all = this.buttons.map(([, button]) => button);
        this.element = h('div', { class: style, role: 'group', 'aria-label': t(label) }, ...all);
    }

    show(chosen: Name) {
        for (const [name, button] of this.buttons) button.setAttribute('aria-pressed', String(name === chosen));
    }

    hide(name: Name, isHidden: boolean) {
        for (const [each, button] of this.buttons) if (each === name) button.hidden = isHidden;
    }
}

/** What the layout puts in its places. */
export interface Parts {
    space: HTMLElement;
    picture: HTMLElement;
    readout: HTMLElement;
    notices: HTMLElement[];
    tools: HTMLElement[];
    dial: HTMLElement;
    chosen: HTMLElement;
    values: HTMLElement;
    form: HTMLElement;
    look: HTMLElement[];
    text: HTMLElement;
    below: HTMLElement[];
    charts: Record<Chart, HTMLElement>;
    /** What stands above the tabs; null: nothing. */
    task: HTMLElement | null;
    /** Tabs that are not offered. */
    hidden: (tab: Tab) => boolean;
}

export class Layout {
    camera: Camera = 'space';
    tab: Tab = 'light';
    onTab: () => void = () => undefined;
    onCamera: () => void = () => undefined;
    /** Told which camera is wanted; calls back when it is to be looked through. */
    onLook: (camera: Camera, go: () => void) => void = (_camera, go) => go();
    /** Told which chart stands below the stage. */
    onChart: (chart: Chart) => void = () => undefined;
    private strip: Chart = 'section';
    private sheet: Sheet = 'half';
    private main = h('main');
    private body = h('div');
    private below = h('section');
    private stage = h('section');
    private edit = h('aside');
    private partial = h('p');
    private cameras!: Choice<Camera>;
    private tabs!: Choice<Tab>;
    private charts!: Choice<Chart>;
    private readonly size = h('span', { class: 'dim' });
    private parts!: Parts;

    /** The elements of the page below its bar, in the words of the present language. */
    build(parts: Parts): HTMLElement {
        this.parts = parts;
        this.cameras = new Choice<Camera>(
            [
                ['space', 'Space'],
                ['picture', 'Observer'],
            ],
            'cameras floating',
            'Camera',
            (camera) => this.look(camera),
        );
        this.tabs = new Choice<Tab>(TABS, 'tabs', 'Drawer', (tab) => this.open(tab));
        this.charts = new Choice<Chart>(CHARTS, 'tabs', 'Below the stage', (chart) => this.chart(chart));
        this.partial = h('p', { class: 'partial', hidden: true });
        const caption = (camera: Camera, words: string, ...rest: HTMLElement[]) =>
            h(
                'button',
                { type: 'button', class: 'caption-of-view', onclick: () => this.look(camera) },
                t(words),
                ...rest,
            );
        this.stage = h(
            'section',
            { class: 'stage', 'aria-label': t('Stage') },
            this.cameras.element,
            h(
                'div',
                { class: 'view of-space' },
                h('h2', { class: 'unseen' }, t('Space view')),
                parts.space,
                this.partial,
            ),
            h(
                'div',
                { class: 'view of-picture' },
                h('h2', { class: 'unseen' }, t('Picture')),
                parts.picture,
                caption('picture', 'Observer’s picture', this.size),
            ),
            parts.readout,
            h('div', { class: 'notices' }, ...parts.notices),
            h('div', { class: 'tools' }, ...parts.tools),
            parts.dial,
            parts.chosen,
        );
        const handle = h('button', { type: 'button', class: 'handle', 'aria-label': t('More or less room for the drawer') });
        this.moveSheet(handle);
        this.body = h('div', { class: 'drawer-body' }, parts.form, h('div', { class: 'look' }, ...parts.look), parts.text);
        this.edit = h(
            'aside',
            { class: 'edit', 'aria-label': t('Drawer') },
            handle,
            parts.task,
            this.tabs.element,
            this.body,
            h('div', { class: 'below' }, ...parts.below),
        );
        this.below = h(
            'section',
            { class: 'strip', 'aria-label': t('Below the stage') },
            this.charts.element,
            h('div', { class: 'panels' }, ...Object.values(parts.charts)),
        );
        this.main = h('main', {}, this.stage, parts.values, this.edit);
        PHONE.onchange = () => this.show();
        const isOffered = (name: Tab) => name !== 'charts' && !parts.hidden(name);
        const offered = TABS.map(([name]) => name).filter(isOffered);
        for (const [name] of TABS) this.tabs.hide(name, parts.hidden(name));
        if (parts.hidden(this.tab) && offered.length) this.tab = offered[0];
        this.edit.classList.toggle('bare', !offered.length);
        this.show();
        return this.main;
    }

    private show() {
        if (this.tab === 'charts' && !PHONE.matches) this.tab = 'light';
        const room = PHONE.matches ? this.body : this.main;
        if (this.below.parentElement !== room) room.append(this.below);
        this.tabs.hide('charts', !PHONE.matches || this.parts.hidden('charts'));
        this.below.hidden = PHONE.matches && this.tab !== 'charts';
        this.stage.dataset.camera = this.camera;
        this.edit.dataset.tab = this.tab;
        this.main.dataset.sheet = this.sheet;
        this.cameras.show(this.camera);
        this.tabs.show(this.tab);
        this.charts.show(this.strip);
        this.parts.form.hidden = this.tab === 'text' || this.tab === 'view' || this.tab === 'charts';
        this.parts.text.hidden = this.tab !== 'text';
        for (const [chart, element] of Object.entries(this.parts.charts))
            element.classList.toggle('unchosen', this.strip !== chart);
    }

    /** Looks through one of the cameras. */
    look(camera: Camera) {
        if (camera === this.camera) return;
        this.cameras.show(camera);
        this.onLook(camera, () => {
            this.camera = camera;
            this.show();
            this.onCamera();
        });
    }

    /** Opens a tab of the drawer. */
    open(tab: Tab) {
        this.tab = tab;
        if (this.sheet === 'tabs') this.sheet = 'half';
        this.show();
        this.onTab();
    }

    /** Shows the form of what was chosen on the stage, where a form is shown. */
    follow(tab: 'light' | 'matter' | 'place') {
        if (this.parts.form.hidden || this.tab === tab || this.parts.hidden(tab)) return;
        this.tab = tab;
        this.show();
    }

    private chart(chart: Chart) {
        this.strip = chart;
        this.show();
        this.onChart(chart);
    }

    /** Offers a chart where the scene has what it shows. */
    offer(chart: Chart, isThere: boolean) {
        this.charts.hide(chart, !isThere);
        if (!isThere && this.strip === chart) this.chart('section');
    }

    /** Says what light is missing in space; nothing: none. */
    tellMissing(words: string) {
        this.partial.textContent = words;
        this.partial.hidden = !words;
    }

    /** The pixels of the picture, in its caption. */
    tellSize(text: string) {
        this.size.textContent = text;
    }

    // On phones: a press goes to the next of half, full and tabs alone; a swipe up or down by one.
    private moveSheet(handle: HTMLElement) {
        const order: Sheet[] = ['tabs', 'half', 'full'];
        const go = (sheet: Sheet) => {
            this.sheet = sheet;
            this.show();
        };
        let wasSwiped = false;
        followPointer(handle, (_x, y) => {
            const from = order.indexOf(this.sheet);
            wasSwiped = false;
            const move = (_: number, ny: number) => {
                const by = Math.abs(ny - y) < SWIPE || wasSwiped ? 0 : Math.sign(y - ny);
                if (!by) return;
                wasSwiped = true;
                go(order[Math.max(0, Math.min(2, from + by))]);
            };
            return { move, end: () => undefined };
        });
        handle.addEventListener('click', () => {
            if (!wasSwiped) go(order[(order.indexOf(this.sheet) + 1) % 3]);
            wasSwiped = false;
        });
    }
}
