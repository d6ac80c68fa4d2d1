// SPDX-License-Identifier: MIT
// The measuring grids of a scene in the strip: the irradiance in each cell, what lighting designers read off it, how much
// observers are dazzled, and whether all of it keeps its limits; or, under a sky, the daylight factor in each cell.  While
// they are looked at, grids, their numbers and the observers stand in the space view, too.
import { Apart } from '../apart';
import type { Daylight, Grid, Limit, Measured, Rated } from '../core';
import { h } from '../dom';
import { NOTHING_MEASURED, type InSpace } from './in_space';
import type { Model } from '../model';
import { add, along, unit, type Place } from '../space_math';
import type { Of } from '../version';
import { exactly, number, t } from '../words';

const MOST_COLUMNS = 60; // of a table
const MOST_CELLS = 2500; // of a grid whose numbers stand in the space view
const GAZE = 600; // mm, of the arrow that tells where an observer looks

type Verdict = Limit['verdict'];

const WORDS: Record<Verdict, string> = { pass: 'kept', fail: 'not kept', undecided: 'undecided' };

/** The worst of what is said of limits; null: there are none. */
function worst(limits: Limit[]): Verdict | null {
    return (['fail', 'undecided', 'pass'] as const).find((verdict) => limits.some((limit) => limit.verdict === verdict)) ?? null;
}

export class GridsPanel {
    readonly element = h('div', { class: 'grids' });
    /** Called when something else is to stand in the space view. */
    onChange: () => void = () => undefined;
    private of: Of | null = null; // what is shown
    private found: Measured = { grids: [], observers: [] };
    private readonly apart: Apart<Measured>;
    private readonly underSky: Apart<Daylight>;
    private daylight: { found: Daylight | null; of: Of } | null = null;
    private isOfDaylight = false; // daylight factors are shown, rather than illuminances
    private readonly choice = h('div', { class: 'choice', role: 'group' });
    private readonly told = h('div');

    constructor(private readonly model: Model) {
        model.follow(this.element, () => this.of);
        this.apart = new Apart(
            model,
            (client, of) => client.ask('grids', of),
            (found, of) => {
                [this.found, this.of] = [found ?? { grids: [], observers: [] }, of];
                this.show();
                this.onChange();
            },
        );
        this.underSky = new Apart(
            model,
            (client, of) => client.ask('daylight', of),
            (found, of) => {
                this.daylight = { found, of };
                this.show();
                this.onChange();
            },
        );
        this.element.append(this.choice, this.told);
    }

    clear() {
        this.of = this.daylight = null;
        this.found = { grids: [], observers: [] };
        this.told.replaceChildren();
        this.choice.replaceChildren();
    }

    /** Whether the strip shows it. */
    set isShown(isShown: boolean) {
        this.apart.isShown = isShown;
        this.apart.refresh();
        this.askForDaylight();
        this.onChange();
    }

    /** In other words. */
    again() {
        this.apart.again();
        this.underSky.again();
    }

    private askForDaylight() {
        this.underSky.isShown = this.apart.isShown && this.isUnderSky && this.isOfDaylight;
        this.underSky.refresh();
    }

    // Whether there is a sky by which daylight is counted.
    private get isUnderSky(): boolean {
        return !!this.model.scene?.lights.some(({ type, enabled }) => type === 'sky' && enabled);
    }

    // What is shown of daylight; null: illuminances are.
    private get shownDaylight(): Daylight | null {
        const isShown = this.isOfDaylight && this.isUnderSky && this.daylight?.of.number === this.of?.number;
        return isShown ? (this.daylight?.found ?? null) : null;
    }

    private showChoice() {
        const names: [boolean, string][] = [
            [false, 'Illuminance'],
            [true, 'Daylight factor'],
        ];
        const buttons = names.map(([isOfDaylight, word]) => {
            const choose = () => {
                this.isOfDaylight = isOfDaylight;
                this.askForDaylight();
                this.show();
                this.onChange();
            };
            const isPressed = this.isOfDaylight === isOfDaylight;
            return h('button', { type: 'button', class: 'small', 'aria-pressed': String(isPressed), onclick: choose }, t(word));
        });
        const focused = [...this.choice.children].indexOf(document.activeElement!);
        this.choice.setAttribute('aria-label', t('Quantity'));
        this.choice.replaceChildren(...(this.isUnderSky ? buttons : []));
        if (this.isUnderSky) buttons[focused]?.focus();
    }

    // Nothing is said of limits before all light is known.
    private get isPartial(): boolean {
        return !!this.of && this.model.isPartial(this.of);
    }

    /** What stands in space while the grids are looked at. */
    get inSpace(): InSpace {
        if (!this.apart.isShown || !this.model.isCurrent(this.of)) return NOTHING_MEASURED;
        const { grids, observers } = this.found;
        const daylight = this.shownDaylight;
        if (daylight) return { cells: grids.flatMap((grid, i) => (grid.values.length > MOST_CELLS ? [] : placed({ ...grid, ...daylight.grids[i] }))), lines: grids.flatMap((grid) => outlines(grid, () => null)) };
        const told = (limits: Limit[]) => (this.isPartial ? null : worst(limits));
        return {
            cells: grids.filter(({ values }) => values.length <= MOST_CELLS).flatMap((grid) => placed(grid)),
            lines: [...grids.flatMap((grid) => outlines(grid, told)), ...observers.flatMap((observer) => gaze(observer, told(observer.limits)))],
        };
    }

    private show() {
        const { grids, observers } = this.found;
        const daylight = this.shownDaylight;
        const isAwaited = this.isOfDaylight && this.isUnderSky && this.daylight?.of.number !== this.of?.number;
        const parts = daylight
            ? grids.map((grid, i) => this.gridUnderSky(grid, i, daylight))
            : [...grids.map((grid, i) => this.grid(grid, i)), ...observers.map((observer, i) => this.observer(observer, i))];
        const says = (words: string) => [h('p', { class: 'dim' }, words)];
        this.showChoice();
        this.told.replaceChildren(...(isAwaited ? says('…') : parts.length ? parts : says(t('This grid cannot be measured.'))));
        this.model.dim();
    }

    private facts(title: string, facts: [string, string][]): HTMLElement {
        const rows = facts.map(([key, value]) => h('tr', {}, h('th', { scope: 'row' }, key), h('td', { class: 'amount' }, value)));
        return h('table', {}, h('caption', {}, title), h('tbody', {}, ...rows));
    }

    private limits(limits: Limit[], unit: string): HTMLElement | null {
        if (!limits.length) return null;
        return h('table', {}, h('caption', {}, t('Limits')), h('tbody', {}, ...limits.map((limit) => this.limit(limit, unit))));
    }

    // A limit beside the number that it is of, and what is said of it.
    private limit({ word, name, wanted, is_most, has_unit, above, value, error, verdict }: Limit, unit: string): HTMLElement {
        const sign = is_most ? '≤' : '≥';
        const ofShare = name === 'share' ? ` % ${t('from')} ${number(above, 4)}` : '';
        const told = value === null ? '—' : exactly(value, error ?? Infinity);
        const said = this.isPartial ? '…' : t(WORDS[verdict]);
        return h(
            'tr',
            { class: `limit ${this.isPartial ? '' : verdict}` },
            h('th', { scope: 'row' }, word),
            h('td', { class: 'said' }, said),
            h('td', { class: 'amount' }, told),
            h('td', { class: 'amount' }, `${sign} ${number(wanted, 5)}${ofShare}${has_unit || ofShare ? ` ${unit}` : ''}`),
        );
    }

    private grid(grid: Grid, index: number): HTMLElement {
        const { name, columns, rows, unit, values, measured, surround, background } = grid;
        const partial = this.isPartial ? ` (${t('direct light alone')})` : '';
        const title = `${name ?? `${t('Grid')} ${index + 1}`}, ${columns} × ${rows}, ${unit}${partial}`;
        const strips: [string, Grid['surround']][] = [
            [t('average around it'), surround],
            [t('average in the background'), background],
        ];
        const facts: [string, string][] = measured
            ? [
                  [t('average'), exactly(...grid.average)],
                  [t('minimum'), number(grid.minimum.value, 5)],
                  [t('maximum'), number(grid.maximum.value, 5)],
                  ['U₀', grid.u0 === undefined ? '—' : number(grid.u0, 4)],
                  ['U_d', grid.ud === undefined ? '—' : number(grid.ud, 4)],
                  ...strips.flatMap(([key, area]): [string, string][] => (area ? [[key, exactly(...area.average)]] : [])),
              ]
            : [];
        return h('section', { class: 'grid', 'aria-label': title }, this.facts(title, facts), this.limits(grid.limits, unit), cellsOf(values, columns, rows));
    }

    // Its daylight factors, and the share of it that has so many lx by the scene's own sky, as EN 17037 counts.
    private gridUnderSky({ name, columns, rows }: Grid, index: number, { grids, levels, horizontal }: Daylight): HTMLElement {
        const { values, measured, mean, median, shares } = grids[index];
        const partial = this.daylight && this.model.isPartial(this.daylight.of) ? ` (${t('direct light alone')})` : '';
        const title = `${name ?? `${t('Grid')} ${index + 1}`}, ${t('daylight factor')}, %${partial}`;
        const reaching = levels.flatMap((level, i): [string, string][] => {
            const share = shares[i];
            return share === null ? [] : [[`${t('share from')} ${number(level)} ${t('lx')}`, `${number(100 * share, 3)} %`]];
        });
        const facts: [string, string][] = measured
            ? [
                  [t('average'), exactly(...mean)],
                  [t('median'), exactly(...median)],
                  ...reaching,
                  [t('under the open sky'), `${number(horizontal[0], 5)} ${this.model.photometric ? t('lx') : t('W/m²')}`],
              ]
            : [];
        return h('section', { class: 'grid', 'aria-label': title }, this.facts(title, facts), cellsOf(values, columns, rows));
    }

    private observer({ name, eye, places, ugr, limits }: Rated, index: number): HTMLElement {
        const where = places > 1 ? `${t('places and ways of looking')}: ${places}` : `(${eye.map((c) => number(c, 5)).join('; ')}) ${t('mm')}`;
        const title = `${name ?? `${t('Observer')} ${index + 1}`}, ${where}`;
        const rating = this.isPartial ? '…' : ugr ? exactly(...ugr) : t('nothing dazzles, or all else is dark');
        return h('section', { class: 'grid', 'aria-label': title }, this.facts(title, [[places > 1 ? t('greatest UGR') : 'UGR', rating]]), this.limits(limits, ''));
    }
}

function cellsOf(values: (number | null)[], columns: number, rows: number): HTMLElement {
    const cell = (value: number | null) => h('td', { class: 'amount' }, value === null ? '—' : number(value, 4));
    const lines = Array.from({ length: rows }, (_, row) =>
        h('tr', {}, ...values.slice(row * columns, row * columns + Math.min(columns, MOST_COLUMNS)).map(cell)),
    );
    return h('table', { class: 'cells' }, h('tbody', {}, ...lines));
}

function placed({ columns, rows, center, size, across, up, values }: Grid): InSpace['cells'] {
    return values.flatMap((value, i) => {
        if (value === null) return [];
        const a = (((i % columns) + 0.5) / columns - 0.5) * size[0];
        const b = (0.5 - (Math.floor(i / columns) + 0.5) / rows) * size[1];
        return [{ at: along(center as Place, across, a, up, b), text: number(value, 3) }];
    });
}

/** The edge of a grid, and those of the strips around it, each with what is said of its own limits. */
function outlines({ center, size, across, up, surround, background, limits }: Grid, told: (limits: Limit[]) => Verdict | null): InSpace['lines'] {
    const areas = { '': { center, size }, surround, background };
    return Object.entries(areas).flatMap(([key, area]) => {
        if (!area) return [];
        const [w, d] = area.size;
        const places = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => along(area.center as Place, across, (a * w) / 2, up, (b * d) / 2));
        const verdict = told(limits.filter(({ name }) => (/^(surround|background)_/.exec(name)?.[1] ?? '') === key));
        return [{ places, isClosed: true, verdict, isStrip: key !== '' }];
    });
}

/** Where an observer is and looks. */
function gaze({ eye, view }: Rated, verdict: Verdict | null): InSpace['lines'] {
    return [{ places: [eye as Place, add(eye as Place, unit(view), GAZE)], isClosed: false, verdict }];
}
