// SPDX-License-Identifier: MIT
// The table of the points whose values a scene wants.  It is a grid of cells, of which one is in the order of Tab: arrows
// walk, and the probe goes to the point of the row; Enter or F2 changes a coordinate, Delete takes the point out, Insert
// puts in the place of the probe.  The mouse and fingers do the same by cells and buttons.
import type { Change } from './core';
import { h } from './dom';
import type { Of } from './version';
import type { Model } from './model';
import { exactly, number, t, typedNumber } from './words';

const COLUMNS = 4; // number, x, y, value

const isCoordinate = (column: number) => column === 1 || column === 2;

export class PointsPanel {
    readonly element = h('div', { class: 'points' });
    /** Shows a point in the views. */
    onChoose: (x: number, y: number) => void = () => undefined;
    /** Where a new point is put. */
    place: () => [number, number] = () => [0, 0];
    private points: number[][] = [];
    private cells: HTMLTableCellElement[][] = [];
    private at: [row: number, column: number] = [0, 0];
    private input: HTMLInputElement | null = null; // while a coordinate is typed

    private of: Of | null = null; // what is shown

    constructor(private readonly model: Model) {
        model.follow(this.element, () => this.of);
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.input = null;
        this.of = null;
        this.points = [];
        this.cells = [];
        this.element.replaceChildren();
    }

    /** After a change of the scene; a coordinate that is being typed stays. */
    async refresh() {
        const points = this.model.scene?.points ?? [];
        const told = await this.model.valuesAt(points).catch(() => null);
        if (this.input || !told) return;
        const hadFocus = this.element.contains(document.activeElement);
        this.points = points;
        this.of = told.of;
        this.build(told.probes.map((probe) => (typeof probe?.value === 'number' ? exactly(probe.value, probe.error) : '—')));
        if (hadFocus) this.focus();
        this.model.dim();
    }

    private build(values: string[]) {
        const { scene } = this.model;
        const unit = scene?.unit === 'relative' ? t('relative') : (scene?.unit ?? '');
        const partial = this.of && this.model.isPartial(this.of) ? ` (${t('direct light alone')})` : '';
        const heads = [t('No.'), `x, ${t('mm')}`, `y, ${t('mm')}`, `${t(scene?.word ?? '')}, ${unit}${partial}`];
        const head = h('tr', {}, ...heads.map((text) => h('th', { scope: 'col' }, text)));
        this.cells = this.points.map(([x, y], row) => [
            h('th', { scope: 'row', 'aria-label': `${t('Point')} ${row + 1}` }, String(row + 1)),
            ...[number(x), number(y), values[row]].map((text, i) =>
                h('td', { 'aria-readonly': String(!isCoordinate(i + 1)) }, text),
            ),
        ]);
        this.cells.forEach((cells, row) => cells.forEach((cell, column) => this.prepare(cell, row, column)));
        const lines = this.cells.map((cells) => h('tr', {}, ...cells));
        const table = h(
            'table',
            { role: 'grid', 'aria-label': t('Points'), 'aria-describedby': 'points-keys' },
            h('thead', {}, head),
            h('tbody', {}, ...lines),
        );
        const add = h('button', { type: 'button', class: 'small', onclick: () => this.add() }, t('Add the probe’s place'));
        const remove = h('button', { type: 'button', class: 'small', onclick: () => this.remove() }, t('Remove'));
        const keys = t('Arrow keys walk, Enter changes, Delete removes, Insert adds the probe’s place.');
        this.element.replaceChildren(
            h('h3', {}, t('Points'), h('span', { class: 'ends' }, add, this.points.length > 0 && remove)),
            ...(this.points.length ? [table, h('p', { class: 'dim', id: 'points-keys' }, keys)] : []),
        );
        this.moveTo(...this.at);
    }

    private prepare(cell: HTMLTableCellElement, row: number, column: number) {
        cell.addEventListener('keydown', (event) => this.key(event));
        cell.addEventListener('click', (event) => {
            if (event.target !== cell) return; // in the field of the cell
            this.moveTo(row, column);
            this.focus();
            this.choose();
            if (isCoordinate(column)) this.edit();
        });
    }

    // The cell in the order of Tab; places beyond the table are its last ones.
    private moveTo(row: number, column: number) {
        this.at = [
            Math.max(0, Math.min(row, this.points.length - 1)),
            Math.max(0, Math.min(column, COLUMNS - 1)),
        ];
        this.cells.forEach((cells, i) =>
            cells.forEach((cell, k) => (cell.tabIndex = i === this.at[0] && k === this.at[1] ? 0 : -1)),
        );
    }

    private focus() {
        (this.cells[this.at[0]]?.[this.at[1]] ?? this.element.querySelector('button'))?.focus();
    }

    private choose() {
        const [x, y] = this.points[this.at[0]];
        this.onChoose(x, y);
    }

    private key(event: KeyboardEvent) {
        if (this.input || event.ctrlKey || event.metaKey || event.altKey) return;
        const [row, column] = this.at;
        const moves: Record<string, [number, number]> = {
            ArrowUp: [row - 1, column],
            ArrowDown: [row + 1, column],
            ArrowLeft: [row, column - 1],
            ArrowRight: [row, column + 1],
            Home: [row, 0],
            End: [row, COLUMNS - 1],
            PageUp: [0, column],
            PageDown: [this.points.length - 1, column],
        };
        const move = moves[event.key];
        if (move) {
            this.moveTo(...move);
            this.focus();
            if (this.at[0] !== row) this.choose();
        } else if (event.key === 'Enter' || event.key === 'F2') this.edit();
        else if (event.key === 'Delete') this.remove();
        else if (event.key === 'Insert') this.add();
        else return;
        event.preventDefault();
    }

    // A coordinate becomes a field; elsewhere Enter shows the point.
    private edit() {
        const [row, column] = this.at;
        if (!isCoordinate(column)) return this.choose();
        const cell = this.cells[row][column];
        const old = cell.textContent ?? '';
        const name = `${t('Point')} ${row + 1}, ${column === 1 ? 'x' : 'y'}, ${t('mm')}`;
        const input = h('input', { type: 'text', inputmode: 'decimal', 'aria-label': name });
        input.value = old;
        const end = (isTaken: boolean) => {
            if (this.input !== input) return;
            this.input = null;
            const hadFocus = document.activeElement === input;
            const value = typedNumber(input.value);
            const isNew = isTaken && value !== null && input.value !== old;
            cell.replaceChildren(isNew ? number(value) : old);
            if (hadFocus) this.focus();
            if (isNew) void this.change([{ set: `points[${row}][${column - 1}]=${value}` }]);
            else void this.refresh();
        };
        input.addEventListener('keydown', (event) => {
            if (event.key === 'Enter' && typedNumber(input.value) === null) input.setAttribute('aria-invalid', 'true');
            else if (event.key === 'Enter' || event.key === 'Escape') end(event.key === 'Enter');
            else return;
            event.preventDefault();
            event.stopPropagation();
        });
        input.addEventListener('blur', () => end(true));
        this.input = input;
        cell.replaceChildren(input);
        input.focus();
        input.select();
    }

    /** Adds the place of the probe, behind the point that was looked at last. */
    add() {
        const row = this.points.length ? this.at[0] + 1 : 0;
        const [x, y] = this.place().map((coordinate) => Number(coordinate.toPrecision(6)));
        this.at = [row, 1];
        void this.change([{ list: 'points', index: row, insert: `[${x}, ${y}]` }]);
    }

    private remove() {
        if (this.points.length) void this.change([{ remove: `points[${this.at[0]}]` }]);
    }

    private async change(changes: Change[]) {
        this.model.endStep();
        if (!(await this.model.change(changes))) await this.refresh();
    }
}
