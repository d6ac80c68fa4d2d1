// SPDX-License-Identifier: MIT
// Tasks: a link tells the scene, what of the page is hidden, and a place of the screen with a question about it, or several
// steps of scenes and questions, a small lesson.  An answer is judged about the scene as the link has it, whatever has been
// changed since.
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

export interface TaskStep {
    scene: string; // the part of the link that tells it; empty: that of the step before
    at: [number, number]; // mm on the screen
    ask: string; // empty: what the value is
}

export interface TaskData {
    steps: TaskStep[];
    hidden: Hideable[];
}

const LONGEST = 2000; // letters of a question
const MOST_STEPS = 30;

/** The task of a link; null: it has none.  A scene, a place and a question belong to the step that they stand in. */
export function taskIn(fragment: string): TaskData | null {
    const found = new URLSearchParams(fragment.replace(/^#/, ''));
    const steps: TaskStep[] = [];
    let [scene, early] = ['', ''];
    for (const [key, value] of found) {
        const numbers = value.split(',').map((part) => (part.trim() ? Number(part) : NaN));
        if (key === 's' || key === 'scene') scene = `#${key}=${value}`;
        else if (key === 'ask' && steps.length) steps[steps.length - 1].ask = value.slice(0, LONGEST);
        else if (key === 'ask') early = value.slice(0, LONGEST);
        else if (key === 'task' && numbers.length === 2 && numbers.every(isFinite) && steps.length < MOST_STEPS) {
            steps.push({ scene, at: [numbers[0], numbers[1]], ask: early });
            [scene, early] = ['', ''];
        }
    }
    const words = (found.get('hide') ?? '').split(',');
    return steps.length ? { steps, hidden: HIDEABLE.filter((each) => words.includes(each)) } : null;
}

/** The end of a link that sets a task, behind the scene of its first step. */
export function told({ steps, hidden }: TaskData): string {
    const written = steps.map(({ scene, at, ask }, i) => {
        const own = i && scene !== steps[i - 1].scene ? `&${scene.replace(/^#/, '')}` : '';
        const question = ask.trim() ? `&ask=${encodeURIComponent(ask.trim().slice(0, LONGEST))}` : '';
        return `${own}&task=${at.map((n) => Number(n.toPrecision(7))).join()}${question}`;
    });
    return written.join('') + (hidden.length ? `&hide=${hidden.join()}` : '');
}

export class Task {
    readonly data = taskIn(location.hash);
    readonly element = h('section', { class: 'task' });
    /** Told that another step is to be opened. */
    onStep: () => void = () => undefined;
    private present = 0; // the step
    private given: Version | null = null;
    private known!: Promise<SceneFacts>; // as soon as the scene has been judged

    constructor(private readonly model: Model) {
        const { data } = this;
        model.listen(() => model.scene && model.whole?.irradiance === this.given?.irradiance && this.becomesKnown(model.scene));
        this.awaitScene();
        if (!data) return;
        document.documentElement.dataset.task = '';
        document.documentElement.dataset.hide = data.hidden.join(' ');
        model.isFixed = ({ kind }) => this.hides(kind === 'surface' ? 'matter' : kind === 'observer' ? 'place' : 'light');
    }

    private becomesKnown: (scene: SceneFacts) => void = () => undefined;

    private awaitScene() {
        this.known = new Promise((resolve) => (this.becomesKnown = resolve));
    }

    /** The present step; null: there is no task. */
    get step(): TaskStep | null {
        return this.data?.steps[this.present] ?? null;
    }

    /** The scene of the present step, as links tell it; empty: they tell none. */
    get scene(): string {
        const told = (this.data?.steps ?? []).slice(0, this.present + 1).filter(({ scene }) => scene);
        return told[told.length - 1]?.scene ?? '';
    }

    private go(step: number) {
        this.present = step;
        this.awaitScene();
        this.onStep();
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
        const { data, step } = this;
        if (!data || !step) return;
        const words = h('p', { class: 'question' }, step.ask);
        if (!step.ask) void this.known.then(({ word }) => (words.textContent = `${t('Find at P')}: ${t(word)}.`));
        const place = `P: x = ${number(step.at[0], 5)}, y = ${number(step.at[1], 5)} ${t('mm')}`;
        const reset = h('button', { type: 'button', class: 'link', onclick: () => this.reset() }, t('As it was given'));
        const count = data.steps.length;
        const turn = (label: string, by: number) => {
            const to = this.present + by;
            return h('button', { type: 'button', class: 'link', disabled: to < 0 || to >= count, onclick: () => this.go(to) }, t(label));
        };
        const tag = count > 1 ? `${t('Task')} ${this.present + 1} / ${count}` : t('Task');
        this.element.setAttribute('aria-label', t('Task'));
        this.element.replaceChildren(
            h('p', { class: 'tag' }, tag),
            words,
            h('p', { class: 'dim' }, place),
            ...answering({ judge: (typed) => this.judged(typed), unit: () => this.unit() }),
            h('div', { class: 'turn' }, reset, ...(count > 1 ? [turn('Back', -1), turn('Next', 1)] : [])),
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
        const [x, y] = this.step!.at;
        const worker = await this.model.client.twin();
        try {
            return await worker.ask('answer', this.of(), typed, x, y, TOLERANCE);
        } finally {
            worker.stop();
        }
    }

    /** Where on a body the asked place is; null: on none. */
    async position(): Promise<number[] | null> {
        const [x, y] = this.step!.at;
        const probe = await this.model.client.ask('probe', { ...this.of(), direct: true, number: Infinity }, x, y);
        return probe && probe.surface !== null ? probe.position : null;
    }
}

