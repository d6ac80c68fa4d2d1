// SPDX-License-Identifier: MIT
// Long work on one version of the scene: a worker of its own computes the whole picture with all its light, tells how far
// it is, and then answers what is asked by the same solution.  It is ended when the scene changes, or by its user.
import type { Client } from './client';
import { h } from './dom';
import type { Model } from './model';
import type { Of } from './version';
import { number, t } from './words';
import type { Picture } from './worker';

export type State = 'working' | 'done' | 'stopped' | 'failed';

export class Work {
    state: State = 'working';
    /** The share that is done, 0 to 1. */
    done = 0;
    failure = '';
    client: Client | null = null;
    private readonly start = performance.now();

    constructor(
        readonly of: Of,
        private readonly onState: () => void,
    ) {}

    /** Begins it in a twin of a client; the picture, or null where there is none. */
    async begin(client: Client): Promise<Picture | null> {
        try {
            const twin = await client.twin();
            if (this.state !== 'working') {
                twin.stop();
                return null;
            }
            this.client = twin;
            twin.onProgress = (_name, done) => this.tell(done);
            const picture = await twin.ask('render', this.of, 1);
            if (!this.isAt('working')) return null;
            if ('messages' in picture) throw new Error(picture.messages.map(({ message }) => message).join('; '));
            this.state = 'done';
            return picture;
        } catch (error) {
            if (this.isAt('working')) {
                this.state = 'failed';
                this.failure = (error as Error).message;
                this.client?.stop();
            }
            return null;
        } finally {
            this.onState();
        }
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
        return this.done > 0.005 && past > 2 ? (past * (1 - this.done)) / this.done : null;
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
        const isTold = !!work && work.state !== 'done' && this.model.isCurrent(work.of);
        this.element.hidden = !isTold;
        if (!isTold) return;
        const isWorking = work.state === 'working';
        const reflects = this.model.whole?.reflects;
        const what = t(reflects ? 'Reflected light is being computed; until then all is of direct light alone.' : 'The whole picture is being computed.');
        const ended = t(reflects ? 'Reflected light was not computed: all is of direct light alone.' : 'The whole picture was not computed.');
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
