// SPDX-License-Identifier: MIT
// Tasks: a link tells the scene, what of the page is hidden, and a place of the screen with a question about it.  The answer
// is judged about the scene as the link has it, whatever has been changed since.
import { answering, TOLERANCE } from './answering';
import type { SceneFacts } from './core';
import { h } from './dom';
import type { Model } from './model';
import type { Version } from './version';
import { number, t } from './words';

/** What a task can hide: tabs of the drawer with what they would change on the stage, and all numbers of the scene. */
export const HIDEABLE = ['values', 'light', 'matter', 'place', 'view', 'text'] as const;
export type Hideable = (typeof HIDEABLE)[number];

export const NAMES: Record<Hideable, string> = {
    values: 'Values and shares',
    light: 'Light',
    matter: 'Matter',
    place: 'Place',
    view: 'View',
    text: 'Text',
};

export interface TaskData {
    at: [number, number]; // mm on the screen
    ask: string; // empty: what the value is
    hidden: Hideable[];
}

const LONGEST = 2000; // letters of a question

/** The task of a link; null: it has none. */
export function taskIn(fragment: string): TaskData | null {
    const found = new URLSearchParams(fragment.replace(/^#/, ''));
    const at = (found.get('task') ?? '').split(',').map((part) => (part.trim() ? Number(part) : NaN));
    if (at.length !== 2 || !at.every(isFinite)) return null;
    const words = (found.get('hide') ?? '').split(',');
    return {
        at: [at[0], at[1]],
        ask: (found.get('ask') ?? '').slice(0, LONGEST),
        hidden: HIDEABLE.filter((each) => words.includes(each)),
    };
}

/** The end of a link that sets a task. */
export function told({ at, ask, hidden }: TaskData): string {
    const question = ask.trim() ? `&ask=${encodeURIComponent(ask.trim().slice(0, LONGEST))}` : '';
    const hide = hidden.length ? `&hide=${hidden.join()}` : '';
    return `&task=${at.map((n) => Number(n.toPrecision(7))).join()}${question}${hide}`;
}

export class Task {
    readonly data = taskIn(location.hash);
    readonly element = h('section', { class: 'task' });
    private given: Version | null = null;
    private readonly known: Promise<SceneFacts>; // as soon as the scene has been judged

    constructor(private readonly model: Model) {
        const { data } = this;
        this.known = new Promise((resolve) =>
            model.listen(() => model.scene && model.whole?.irradiance === this.given?.irradiance && resolve(model.scene)),
        );
        if (!data) return;
        document.documentElement.dataset.task = '';
        document.documentElement.dataset.hide = data.hidden.join(' ');
        model.isFixed = ({ kind }) => this.hides(kind === 'surface' ? 'matter' : kind === 'observer' ? 'place' : 'light');
    }

    hides(what: Hideable): boolean {
        const hidden = this.data?.hidden ?? [];
        return hidden.includes(what) || (what === 'view' && hidden.includes('values')); // the range tells values
    }

    /** What the link has is there: the scene that is judged. */
    begin() {
        this.given = this.model.version;
    }

    /** The question and the field for its answer, in the words of the present language. */
    relabel() {
        const { data } = this;
        if (!data) return;
        const words = h('p', { class: 'question' }, data.ask);
        if (!data.ask) void this.known.then(({ word }) => (words.textContent = `${t('Find at P')}: ${t(word)}.`));
        const place = `P: x = ${number(data.at[0], 5)}, y = ${number(data.at[1], 5)} ${t('mm')}`;
        const reset = h('button', { type: 'button', class: 'link', onclick: () => this.reset() }, t('As it was given'));
        this.element.setAttribute('aria-label', t('Task'));
        this.element.replaceChildren(
            h('p', { class: 'tag' }, t('Task')),
            words,
            h('p', { class: 'dim' }, place),
            ...answering({ judge: (typed) => this.judged(typed), unit: () => this.unit() }),
            reset,
        );
    }

    private reset() {
        if (this.given) this.model.setText(this.given.text);
    }

    private of() {
        if (!this.given) throw new Error('there is no scene yet');
        return { ...this.given, direct: false };
    }

    private async unit() {
        const { unit } = await this.known;
        return unit === 'relative' ? t('relative') : unit;
    }

    // By a worker of its own: reflected light may take long.
    private async judged(typed: string) {
        const [x, y] = this.data!.at;
        const worker = await this.model.client.twin();
        try {
            return await worker.ask('answer', this.of(), typed, x, y, TOLERANCE);
        } finally {
            worker.stop();
        }
    }

    /** Where on a body the asked place is; null: on none. */
    async position(): Promise<number[] | null> {
        const [x, y] = this.data!.at;
        const probe = await this.model.client.ask('probe', { ...this.of(), direct: true, number: Infinity }, x, y);
        return probe && probe.surface !== null ? probe.position : null;
    }
}

