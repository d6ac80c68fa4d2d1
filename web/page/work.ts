// SPDX-License-Identifier: MIT
// Long work on one version of the scene: a worker of its own computes the whole picture with all its light, first roughly and
// then better, tells how far it is, and then answers what is asked by the same solution.  It is ended when the scene
// changes, or by its user.
import type { Client } from './client';
import { h } from './dom';
import type { Model } from './model';
import type { Of } from './version';
import { number, t } from './words';
import type { Picture } from './worker';

export type State = 'working' | 'done' | 'stopped' | 'failed';

const ROUNDS = [2, 12, undefined]; // seconds for reflected light, one after the other; the last one has no end
const AT_ONCE = 500; // milliseconds within which nothing is told of it
const LOOK = 500; // milliseconds between them, for other cameras

/** Whether its reflected light is less exact than it should be, as it was found in some seconds. */
export function isRough({ of, facts }: Picture): boolean {
    return of.within !== undefined && !facts.reached;
}

export class Work {
    state: State = 'working';
    /** The share that is done, 0 to 1. */
    done = 0;
    failure = '';
    client: Client | null = null;
    /** What its last picture is of; null: there is none yet. */
    known: Of | null = null;
    private isBetween = false; // two rounds
    private readonly began = performance.now();
    private start = this.began; // of the round
    private isLast = false; // of the rounds

    constructor(
        readonly of: Of,
        private readonly rounds: boolean,
        private readonly onState: () => void,
        private readonly onPicture: (picture: Picture) => void,
    ) {}

    /** Milliseconds since it began. */
    get age(): number {
        return performance.now() - this.began;
    }

    /** Whether what is known can be asked for now. */
    get isOpen(): boolean {
        return this.known !== null && (this.state === 'done' || this.isBetween);
    }

    /** Begins it in a twin of a client. */
    async begin(client: Client) {
        try {
            const twin = await client.twin();
            if (this.state !== 'working') return twin.stop();
            this.client = twin;
            twin.onProgress = (name, done) => name === 'render' && this.tell(done);
            for (const within of this.rounds ? ROUNDS : [undefined]) if (await this.round(twin, within)) break;
        } catch (error) {
            if (this.isAt('working')) {
                this.state = 'failed';
                this.failure = (error as Error).message;
                this.client?.stop();
            }
        } finally {
            this.onState();
        }
    }

    // One picture; true: it is the last.
    private async round(twin: Client, within?: number): Promise<boolean> {
        [this.done, this.start, this.isLast] = [0, performance.now(), within === undefined];
        const picture = await twin.ask('render', { ...this.of, within }, 1);
        if (!this.isAt('working')) return true;
        if ('messages' in picture) throw new Error(picture.messages.map(({ message }) => message).join('; '));
        this.known = picture.of;
        const isLast = !isRough(picture);
        if (isLast) this.state = 'done';
        else this.isBetween = true;
        this.onPicture(picture);
        if (!isLast) await new Promise((resolve) => setTimeout(resolve, LOOK));
        this.isBetween = false;
        return isLast || !this.isAt('working');
    }

    private isAt(state: State) {
        return this.state === state;
    }

    private tell(done: number) {
        if (done <= this.done) return;
        this.done = done;
        if (this.state === 'working') this.onState();
    }

    /** How many seconds it still takes, by what is done; null: nobody knows yet. */
    get left(): number | null {
        const past = (performance.now() - this.start) / 1000;
        return this.isLast && this.done > 0.005 && past > 2 ? (past * (1 - this.done)) / this.done : null;
    }

    stop() {
        if (this.state === 'working') this.state = 'stopped';
        this.client?.stop();
        this.onState();
    }

    /** Ends it for a change of the scene, after which nobody asks for it. */
    drop() {
        this.state = 'stopped';
        this.client?.stop();
    }
}

/** Two digits of seconds or minutes. */
function duration(seconds: number): string {
    if (seconds < 60) return `${number(Math.max(1, Math.round(seconds)), 2)} ${t('s')}`;
    return `${number(seconds / 60, 2)} ${t('min')}`;
}

/** The line that tells of it, with a button that stops it or begins it anew. */
export class WorkNotice {
    private readonly words = h('span');
    private readonly bar = h('progress', { max: 1 });
    private readonly left = h('span', { class: 'dim' });
    private timer = 0;
    private readonly button = h('button', { type: 'button', class: 'small' });
    readonly element = h('div', { class: 'working', hidden: true }, this.words, this.bar, this.left, this.button);

    constructor(private readonly model: Model) {
        this.button.addEventListener('click', () =>
            this.model.work?.state === 'working' ? this.model.work.stop() : this.model.resume(),
        );
        this.words.setAttribute('role', 'status');
    }

    show() {
        const { work } = this.model;
        const isThere = !!work && work.state !== 'done' && this.model.isCurrent(work.of);
        const age = work ? work.age : 0;
        const isSoon = isThere && work.state === 'working' && age < AT_ONCE; // what is done at once need not be told
        clearTimeout(this.timer);
        if (isSoon) this.timer = window.setTimeout(() => this.show(), AT_ONCE - age + 1);
        this.element.hidden = !isThere || isSoon;
        if (!isThere || isSoon) return;
        const isWorking = work.state === 'working';
        const reflects = this.model.whole?.reflects;
        const isRoughly = reflects && work.known;
        const what = t(isRoughly ? 'Reflected light, more exactly' : reflects ? 'Reflected light is being computed' : 'Whole picture');
        const ended = t(isRoughly ? 'Reflected light was computed roughly, for pictures; numbers are of direct light alone.' : reflects ? 'Reflected light was not computed: all is of direct light alone.' : 'The whole picture was not computed.');
        const said = isWorking ? what : `${ended} ${work.failure}`;
        if (this.words.textContent !== said) this.words.textContent = said;
        this.bar.hidden = !isWorking;
        if (work.done > 0) this.bar.value = work.done;
        else this.bar.removeAttribute('value');
        const { left } = work;
        const told = `${number(100 * work.done, 2)} %${left === null ? '' : `, ${t('at most')} ${duration(left)}`}`;
        this.bar.setAttribute('aria-label', told);
        this.left.textContent = isWorking ? told : '';
        this.button.textContent = t(isWorking ? 'Stop' : 'Continue');
    }
}
