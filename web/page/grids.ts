// SPDX-License-Identifier: MIT
// The measuring grids of a scene in the strip: the irradiance in each cell, and what lighting designers read off it.  While
// they are looked at, the numbers stand in the space view, too, where they were measured.
import { Apart } from './apart';
import type { Grid } from './core';
import { h } from './dom';
import type { Model } from './model';
import { along, type Place } from './space_math';
import type { Of } from './version';
import { amount, number, t } from './words';

const MOST_COLUMNS = 60; // of a table
const MOST_CELLS = 2500; // of a grid whose numbers stand in the space view

export class GridsPanel {
    readonly element = h('div', { class: 'grids' });
    /** Called when other numbers are to stand in the space view. */
    onChange: () => void = () => undefined;
    private of: Of | null = null; // what is shown
    private grids: Grid[] = [];
    private readonly apart: Apart<Grid[]>;

    constructor(private readonly model: Model) {
        model.follow(this.element, () => this.of);
        this.apart = new Apart(
            model,
            (client, of) => client.ask('grids', of),
            (grids, of) => {
                [this.grids, this.of] = [grids ?? [], of];
                this.show();
                this.onChange();
            },
        );
    }

    clear() {
        this.of = null;
        this.grids = [];
        this.element.replaceChildren();
    }

    /** Whether the strip shows it. */
    set isShown(isShown: boolean) {
        this.apart.isShown = isShown;
        this.apart.refresh();
        this.onChange();
    }

    /** In other words. */
    again() {
        this.apart.again();
    }

    /** What stands in space while the grids are looked at: cells and their numbers. */
    get cells(): { at: Place; text: string }[] {
        if (!this.apart.isShown || !this.model.isCurrent(this.of)) return [];
        return this.grids.filter(({ values }) => values.length <= MOST_CELLS).flatMap((grid) => placed(grid));
    }

    private show() {
        const parts = this.grids.map((grid, i) => this.table(grid, i));
        this.element.replaceChildren(...(parts.length ? parts : [h('p', { class: 'dim' }, t('This grid cannot be measured.'))]));
        this.model.dim();
    }

    private table(grid: Grid, index: number): HTMLElement {
        const { name, columns, rows, unit, values, measured } = grid;
        const partial = this.of && this.model.isPartial(this.of) ? ` (${t('direct light alone')})` : '';
        const title = `${name ?? `${t('Grid')} ${index + 1}`}, ${columns} × ${rows}, ${unit}${partial}`;
        const facts: [string, string][] = measured
            ? [
                  [t('average'), amount(grid.average)],
                  [t('minimum'), number(grid.minimum.value, 5)],
                  [t('maximum'), number(grid.maximum.value, 5)],
                  ['U₀', grid.u0 === undefined ? '—' : number(grid.u0, 4)],
                  ['U_d', grid.ud === undefined ? '—' : number(grid.ud, 4)],
              ]
            : [];
        const lines = Array.from({ length: rows }, (_, row) =>
            h(
                'tr',
                {},
                ...values
                    .slice(row * columns, row * columns + Math.min(columns, MOST_COLUMNS))
                    .map((value) => h('td', { class: 'amount' }, value === null ? '—' : number(value, 4))),
            ),
        );
        return h(
            'section',
            { class: 'grid', 'aria-label': title },
            h(
                'table',
                {},
                h('caption', {}, title),
                h('tbody', {}, ...facts.map(([key, value]) => h('tr', {}, h('th', { scope: 'row' }, key), h('td', { class: 'amount' }, value)))),
            ),
            h('table', { class: 'cells' }, h('tbody', {}, ...lines)),
        );
    }
}

function placed({ columns, rows, center, size, across, up, values }: Grid): { at: Place; text: string }[] {
    return values.flatMap((value, i) => {
        if (value === null) return [];
        const a = (((i % columns) + 0.5) / columns - 0.5) * size[0];
        const b = (0.5 - (Math.floor(i / columns) + 0.5) / rows) * size[1];
        return [{ at: along(center as Place, across, a, up, b), text: number(value, 3) }];
    });
}
