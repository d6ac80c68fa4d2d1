// SPDX-License-Identifier: MIT
// What the page shows: the text of the scene with its history, what the core says to it, and the picture.  A change is
// judged at once; pictures follow, the newest wins, and a coarse one comes first where a whole one takes long.
//
// Each change makes a new version, and everything that is found keeps the one that it was found of.  The model alone decides
// whether that is the current one (isCurrent); what is not is dimmed (follow), and nobody copies it.
import type { Change, Message, Probe, SceneFacts } from './core';
import { Client } from './client';
import type { Geometry, Shape, Thing } from './geometry';
import type { ColourView } from './srgb';
import { sunMoves } from './sun/sun';
import type { Of, Version } from './version';
import { isRough, Work } from './work';
import type { Picture } from './worker';

export type { Shape, Thing } from './geometry';

const OFTEN = 24; // milliseconds that a picture may take to follow the hand,
const OFTEN_SMALL = 8; // and one that stands small beside the space view
const SLOW = 200; // milliseconds from which on a second worker makes a picture
const BEARABLE = 400; // milliseconds that the first worker spends on a picture of direct light
const UNKNOWN = 8; // the stride of a scene's first picture
const STRIDES = [1, 2, 4, 8, 16];
const REST = 120; // milliseconds without a change after which the hand rests
const MOMENT = 1500; // milliseconds that a drag waits for its picture, which never came on slow machines if it went on
const MOST_STEPS = 200; // of the history

/** What has changed; begin: another scene was opened, of which nothing is known yet; light: numbers have all their light. */
export type Topic = 'text' | 'begin' | 'scene' | 'geometry' | 'picture' | 'light' | 'work';

/** A version without errors, and what it holds. */
interface Whole extends Version, Geometry {
    facts: SceneFacts;
}

/** Exact values at places, all of one version. */
export interface Told {
    of: Of;
    probes: (Probe | null)[];
}

/** A step of the history, as a tab keeps it. */
export interface Step {
    text: string;
    scene: number;
    name: string;
}

export interface History {
    past: Step[];
    present: Step;
    future: Step[];
}

/** How values come in parts: whether they are still wanted, and what is done with those that are there. */
interface Part {
    isWanted?: () => boolean;
    onSome?: (told: Told) => void;
}

export class Model {
    readonly client = new Client();
    version: Version = { number: 0, scene: 0, text: '', irradiance: false, name: 'scene' };
    /** The last version without errors of the scene that is open; null: there was none yet. */
    whole: Whole | null = null;
    picture: Picture | null = null;
    messages: Message[] = [];
    /** Whether the present text has errors. */
    stale = false;
    /** The whole picture with all its light, where that takes long. */
    work: Work | null = null;
    /** Whether the picture stands small beside the space view, so that a coarse one shows as much. */
    isSmall = false;
    /** How many drags still change the scene: the last movement is taken after the hand has let go. */
    drags = 0;
    /** Whether a thing is not to be moved by hand. */
    isFixed: (thing: Thing) => boolean = () => false;
    /** The files that the text names, and whether they were given. */
    files: [string, boolean][] = [];
    private past: Version[] = [];
    private future: Version[] = [];
    private listeners: ((topic: Topic) => void)[] = [];
    private followed: { elements: () => HTMLElement[]; of: () => Version | null }[] = [];
    private versions = 0;
    private judged: Version | null = null; // what the messages are about
    private judging = false;
    private wantsJudging = false;
    private rendering = false;
    private rendered = 0; // the number of the version of which pictures were asked for last
    private coarse = 1; // the stride at which a picture follows the hand
    private lastMark = '';
    private wholeTime = 0; // milliseconds that a whole picture takes, by the last one
    private awaiting: (() => void)[] = [];
    private failing = ''; // the text with which the core failed last

    get text() {
        return this.version.text;
    }

    get irradiance() {
        return this.version.irradiance;
    }

    get wholeText() {
        return this.whole?.text ?? '';
    }

    get scene(): SceneFacts | null {
        return this.whole?.facts ?? null;
    }

    get things(): Thing[] {
        return this.whole?.things ?? [];
    }

    get shapes(): Shape[] {
        return this.whole?.shapes ?? [];
    }

    get screen(): number[] {
        return this.whole?.screen ?? [1, 1];
    }

    get observer() {
        return this.whole?.observer ?? null;
    }

    get photometric() {
        return this.whole?.photometric ?? false;
    }

    /** Whether something belongs to the present version, of which no errors are known.  Nobody else decides it. */
    isCurrent(of: Version | null | undefined): boolean {
        return !!of && !this.stale && of.number === this.version.number;
    }

    /** Whether the picture is whole, current, and has all light. */
    get isSettled(): boolean {
        const { picture } = this;
        return !!picture && picture.stride === 1 && this.isCurrent(picture.of) && !this.isPartial(picture.of) && !isRough(picture);
    }

    /** Whether long work was stopped, by its user or by a failure. */
    get isStopped(): boolean {
        return this.work?.state === 'stopped' || this.work?.state === 'failed';
    }

    /** Whether something has direct light alone of a scene that has more. */
    isPartial(of: Of): boolean {
        return of.direct && !!this.whole?.reflects;
    }

    /** Dims elements while what they show is of another version than the current one; null: they show nothing. */
    follow(elements: HTMLElement | (() => HTMLElement[]), of: () => Version | null) {
        this.followed.push({ elements: typeof elements === 'function' ? elements : () => [elements], of });
    }

    /** The same for what is told of a text, errors included, until the next one has been judged. */
    followJudgement(element: HTMLElement) {
        this.follow(element, () => (this.judged?.number === this.version.number ? null : this.judged));
    }

    /** Dims what is to be dimmed now. */
    dim() {
        for (const { elements, of } of this.followed) {
            const shown = of();
            const isOld = !!shown && !this.isCurrent(shown);
            for (const element of elements()) element.classList.toggle('old', isOld);
        }
    }

    listen(listener: (topic: Topic) => void) {
        this.listeners.push(listener);
    }

    /** Waits for a picture of the present text, but no longer than a moment: so a drag asks for no more than is shown. */
    pictured(): Promise<void> {
        if (this.isCurrent(this.picture?.of)) return Promise.resolve();
        return new Promise((resolve) => {
            this.awaiting.push(resolve);
            setTimeout(resolve, MOMENT);
        });
    }

    /** Takes one value after the other, the newest of those that came meanwhile, once its picture is shown. */
    newest(commit: (value: string) => Promise<boolean>): (value: string) => Promise<void> {
        let [next, isBusy]: [string | null, boolean] = [null, false];
        return async (value) => {
            next = value;
            if (isBusy) return;
            isBusy = true;
            while (next !== null) {
                const taken: string = next;
                next = null;
                if (await commit(taken).catch(() => false)) await this.pictured();
            }
            isBusy = false;
        };
    }

    private tell(topic: Topic) {
        if (topic === 'picture' || this.stale) this.awaiting.splice(0).forEach((resolve) => resolve());
        this.dim();
        for (const listener of this.listeners) listener(topic);
        this.dim();
    }

    // All that was found before is of another version from here on.
    private renew(change: Partial<Version>) {
        const { scene } = this.version;
        this.version = { ...this.version, ...change, number: ++this.versions };
        this.work?.drop();
        this.work = null;
        this.client.forget(this.version.number);
        if (this.version.scene !== scene) {
            [this.whole, this.picture, this.messages, this.files, this.stale] = [null, null, [], [], false];
            this.coarse = UNKNOWN;
            this.tell('begin');
        }
        this.tell('text');
        void this.judge();
    }

    /** Takes a new text; changes with one mark that follow one another are one step of the history. */
    setText(text: string, mark = '', another: Partial<Version> | null = null) {
        if (text === this.text && !another) return;
        if (this.text && !(mark && mark === this.lastMark)) {
            this.past.push(this.version);
            if (this.past.length > MOST_STEPS) this.past.shift();
        }
        this.lastMark = mark;
        this.future = [];
        this.renew({ text, ...another });
    }

    /** Takes another scene, of which nothing is known yet. */
    begin(text: string, name = 'scene') {
        this.lastMark = '';
        this.setText(text, '', { scene: ++this.versions, name });
    }

    /** Ends a step of the history, so that the next change begins one. */
    endStep() {
        this.lastMark = '';
    }

    /** The present scene and what can be undone and done again. */
    history(): History {
        const step = ({ text, scene, name }: Version): Step => ({ text, scene, name });
        return { past: this.past.map(step), present: step(this.version), future: this.future.map(step) };
    }

    /** Goes on with a history that was kept. */
    resumeHistory({ past, present, future }: History) {
        const most = Math.max(...[...past, present, ...future].map(({ scene }) => scene || 0));
        this.versions += most + 1;
        const version = (step: Step): Version => ({ ...this.version, ...step, number: 0 });
        this.renew({ ...version(present) });
        this.past = past.map(version);
        this.future = future.map(version);
        this.lastMark = '';
        this.tell('text');
    }

    get canUndo() {
        return this.past.length > 0;
    }

    get canRedo() {
        return this.future.length > 0;
    }

    undo() {
        this.restore(this.past, this.future);
    }

    redo() {
        this.restore(this.future, this.past);
    }

    private restore(from: Version[], to: Version[]) {
        const version = from.pop();
        if (!version) return;
        to.push(this.version);
        this.lastMark = '';
        this.renew({ text: version.text, scene: version.scene, name: version.name });
    }

    setIrradiance(irradiance: boolean) {
        if (irradiance !== this.irradiance) this.renew({ irradiance });
    }

    /** Shows a channel of the picture, or its colour temperatures, in place of the luminance. */
    setView(view: ColourView) {
        if (view !== (this.version.view ?? 'luminance')) this.renew({ view });
    }

    /** Gives a file that scenes name. */
    async give(name: string, bytes: Uint8Array) {
        await this.client.give(name, bytes);
        this.renew({});
    }

    /** Has the core speak another language: numbers stay, words are asked for anew. */
    async translate(language: string) {
        const builtins = await this.client.translate(language);
        const { work } = this;
        if (work?.state === 'done') await work.client?.speakAs(this.client).catch(() => undefined);
        await this.judge();
        return builtins;
    }

    /**
     * Changes values of a version by assignments and the like.  False: it does not go, and messages tell why, or the version
     * is of a scene that is no longer open, or somebody was faster.
     */
    async change(changes: Change[], mark = '', of: Version = this.version): Promise<boolean> {
        const before = this.version;
        if (of.scene !== before.scene) return false;
        const { interruptions } = this.client;
        const { text, messages } = await this.client.urgent('edit', before.text, changes);
        const isInterrupted = this.client.interruptions !== interruptions;
        if (isInterrupted) this.rendered = 0; // a picture was given up
        if (this.version !== before) return false;
        if (text === null || text === before.text) {
            if (text === null) this.messages = messages;
            this.tell('scene');
            void this.render();
            if (isInterrupted) this.tell('light');
            return text !== null;
        }
        this.setText(text, mark);
        return true;
    }

    /** Adds a light of a kind, which fits the scene and is like a chosen one. */
    addLight(kind: string, chosen: number) {
        return this.takeLight(kind, chosen, false);
    }

    /** Makes a light one of another kind, which stands where it stood and is as strong. */
    changeLight(kind: string, index: number) {
        return this.takeLight(kind, index, true);
    }

    private async takeLight(kind: string, like: number, replaces: boolean) {
        const { version } = this;
        const made = await this.client.ask('newLight', version.text, kind, like, replaces);
        if (this.version !== version || !made) return false;
        const insert = { list: 'lights', index: replaces ? like : made.index, insert: made.light };
        return this.change(replaces ? [{ remove: `lights[${like}]` }, insert] : [insert], '', version);
    }

    private before: { index: number; enabled: boolean[] } | null = null; // what was on before a light was alone

    /** Whether this light alone is on, of several. */
    isSolo(index: number): boolean {
        const lights = this.scene?.lights ?? [];
        return lights.length > 1 && lights.every(({ enabled }, i) => enabled === (i === index));
    }

    /** Switches all other lights off; where they are off, those on again that were on before, or all. */
    solo(index: number) {
        const lights = this.scene?.lights ?? [];
        const isOver = this.isSolo(index);
        const { before } = this;
        const isKnown = before && before.index === index && before.enabled.length === lights.length;
        if (!isOver) this.before = { index, enabled: lights.map(({ enabled }) => enabled) };
        const wanted = lights.map((_, i) => (isOver ? !isKnown || before.enabled[i] : i === index));
        const changes = lights.flatMap(({ enabled }, i) => (enabled === wanted[i] ? [] : [{ set: `lights[${i}].enabled=${wanted[i]}` }]));
        return this.change(changes);
    }

    /** What aims a light; undefined: nothing that a hand could move. */
    aimOf(index: number): Thing | undefined {
        return this.things.find((thing) => thing.kind === 'aim' && thing.index === index);
    }

    /** Adds copies of lights or bodies, a little aside of where those stand: of one behind it, of several behind all. */
    async duplicate(list: string, indices: number[]): Promise<boolean> {
        const { version } = this;
        const whole = this.asWhole();
        if (!whole || whole.number !== version.number) return false;
        const texts = await this.client.ask('keys', whole, indices.map((index) => `${list}[${index}]`));
        if (this.version !== version) return false;
        const kind = list === 'lights' ? 'light' : 'surface';
        const count = (list === 'lights' ? this.scene?.lights : this.scene?.surfaces)?.length ?? 0;
        const aside = Math.max(1, Math.round(0.08 * Math.max(...this.screen)));
        const changes = indices.flatMap((index, i): Change[] => {
            const text = texts[i];
            if (text === null) return [];
            const to = indices.length === 1 ? index + 1 : count + i;
            const insert = { list, index: to, insert: text };
            const thing = this.things.find((each) => each.kind === kind && each.index === index);
            if (!thing || thing.key.endsWith('.vertices')) return [insert];
            const at = thing.at.map((c, axis) => (axis === 0 ? c + aside : c));
            return [insert, { set: `${list}[${to}]${thing.key.slice(`${list}[${index}]`.length)}=[${at.join(', ')}]` }];
        });
        return this.change(changes, '', version);
    }

    async judge() {
        this.wantsJudging = true;
        if (this.judging) return;
        this.judging = true;
        while (this.wantsJudging) {
            this.wantsJudging = false;
            await this.judgeOnce().catch(() => undefined);
        }
        this.judging = false;
    }

    // What was found of an older version of the scene is shown, dimmed, while a newer one is on its way.
    private async judgeOnce() {
        const of = { ...this.version, direct: true };
        const { messages, files, facts, geometry } = await this.client.urgent('judge', of);
        if (of.scene !== this.version.scene) return;
        if (facts && geometry) this.whole = { ...this.versionOf(of), facts, ...geometry };
        if (of.number !== this.version.number) return this.tell('geometry');
        this.judged = this.version;
        this.messages = messages;
        this.files = files;
        this.stale = !facts;
        if (facts) {
            this.tell('geometry');
            void this.render();
        }
        this.tell('scene');
    }

    private versionOf({ number, scene, text, irradiance, view, name }: Version): Version {
        return { number, scene, text, irradiance, view, name };
    }

    /** The last version without errors, for what is asked of the scene itself. */
    asWhole(): Of | null {
        return this.whole && { ...this.versionOf(this.whole), direct: this.whole.reflects };
    }

    private async render() {
        if (this.rendering) return;
        this.rendering = true;
        while (this.whole && this.rendered !== this.whole.number) {
            const { whole } = this;
            this.rendered = whole.number;
            await this.renderOnce(whole, this.coarse).catch(() => undefined);
            if (this.isLeft(whole)) continue;
            if (!whole.reflects && this.picture?.stride === 1) continue;
            // The hand may still be moving.
            do await new Promise((resolve) => setTimeout(resolve, REST));
            while (this.drags > 0 && !this.isLeft(whole));
            if (!this.isLeft(whole)) await this.renderWhole(whole).catch(() => undefined);
        }
        this.rendering = false;
    }

    private isLeft(whole: Whole): boolean {
        return this.whole?.number !== whole.number || this.rendered !== whole.number || !this.isCurrent(whole);
    }

    // All light, and pictures that take long, are a second worker's; meanwhile direct light is shown as finely as is quick.
    private async renderWhole(whole: Whole) {
        const isSlow = this.wholeTime >= SLOW;
        if (whole.reflects || isSlow) this.begins(whole);
        const finest = STRIDES.find((each) => this.wholeTime / (each * each) <= BEARABLE) ?? this.coarse;
        const stride = !isSlow ? 1 : whole.reflects ? finest : this.coarse;
        if (!this.picture || stride < this.picture.stride) await this.renderOnce(whole, stride);
    }

    private begins(whole: Whole) {
        this.work?.drop();
        const isCurrent = () => this.work === work;
        const work: Work = new Work(
            { ...this.versionOf(whole), direct: false },
            whole.reflects,
            () => isCurrent() && this.tell('work'),
            (picture) => isCurrent() && this.take(picture),
        );
        this.work = work;
        this.tell('work');
        void work.begin(this.client).then(async () => {
            if (!isCurrent() || work.state !== 'done') return;
            await work.client!.speakAs(this.client).catch(() => undefined); // the language may have been changed meanwhile
            if (isCurrent() && whole.reflects) this.tell('light');
        });
    }

    /** Begins long work that was stopped anew. */
    resume() {
        if (this.whole && this.isCurrent(this.whole)) this.begins(this.whole);
    }

    private async renderOnce(whole: Whole, stride: number) {
        const picture = await this.client.ask('render', { ...this.versionOf(whole), direct: whole.reflects }, stride);
        if (whole.scene !== this.version.scene) return;
        if ('messages' in picture) {
            if (whole.number !== this.version.number) return;
            this.messages = picture.messages;
            this.stale = true;
            this.tell('scene');
            return;
        }
        this.failing = '';
        this.wholeTime = picture.milliseconds * stride * stride;
        const often = this.isSmall ? OFTEN_SMALL : OFTEN;
        this.coarse = STRIDES.find((each) => this.wholeTime / (each * each) <= often) ?? STRIDES[STRIDES.length - 1];
        const shown = this.picture;
        const isFinal = shown?.of.number === whole.number && (shown.of.direct !== whole.reflects || shown.stride < stride);
        if (!isFinal) this.take(picture);
    }

    private take(picture: Picture) {
        this.picture = picture;
        this.tell('picture');
    }

    /** Who knows numbers of the present version, and what they are of: direct light alone, until all light is known. */
    source(): { client: Client; of: Of } | null {
        const { whole, work } = this;
        if (!whole || !this.isCurrent(whole)) return null;
        if (whole.reflects && work?.state === 'done') return { client: work.client!, of: work.known! };
        return { client: this.client, of: { ...this.versionOf(whole), direct: whole.reflects } };
    }

    /** What light other cameras show, and who has all of it at hand; null as client: direct light, which anybody computes. */
    lighting(): { client: Client | null; of: Of } | null {
        const { work } = this;
        const of = this.asWhole();
        if (!of || !this.isCurrent(of)) return null;
        return of.direct && work?.isOpen ? { client: work.client, of: work.known! } : { client: null, of };
    }

    /** Exact values at places of the screen; null: the scene has changed meanwhile.  They come in small parts. */
    async valuesAt(
        places: number[][],
        { isWanted = () => true, onSome = () => undefined }: Part = {},
    ): Promise<Told | null> {
        const source = this.source();
        if (!source) return null;
        const { client, of } = source;
        const told: Told = { of, probes: [] };
        while (told.probes.length < places.length) {
            const some = await client.ask('values', of, places.slice(told.probes.length));
            told.probes.push(...some);
            if (!this.isCurrent(of) || !isWanted()) return null;
            onSome(told);
        }
        return told;
    }

    /** Lines of equal value of a picture. */
    isophotes({ of, stride }: Picture, logarithmic: boolean) {
        const isReflected = this.whole?.reflects && !of.direct;
        if (isReflected && this.work?.state !== 'done') return Promise.resolve([]); // whoever knows that light is busy
        return (isReflected ? this.work!.client! : this.client).ask('isophotes', of, stride, 8, logarithmic).catch(() => []);
    }

    /** After a failure of the core: begins anew, but not with a text that made it fail twice. */
    recover(message: string) {
        const isHopeless = this.failing === this.text;
        this.failing = this.text;
        this.rendered = 0;
        if (!isHopeless) {
            void this.judge();
            return;
        }
        this.stale = true;
        this.messages = [{ error: true, line: 0, column: 0, length: 0, key: null, message, hint: '' }];
        this.tell('scene');
    }

    /** Moves a thing to a place of the scene. */
    moveThing(thing: Thing, to: number[], mark: string, of: Version = this.version) {
        return this.isFixed(thing) ? Promise.resolve(false) : this.change(this.moves(thing, to), mark, of);
    }

    /** The changes of the text that bring a thing to a place of the scene. */
    moves(thing: Thing, to: number[]): Change[] {
        if (this.isFixed(thing)) return [];
        const whole = to.map((coordinate) => Math.round(coordinate));
        if (thing.key === 'observer.z') return [{ set: `observer.z=${Math.max(1, whole[2])}` }];
        if (thing.sun) return sunMoves(this.things, thing, to).changes;
        if (thing.kind === 'direction') {
            const along = thing.from!.map((coordinate, axis) => Number((coordinate - to[axis]).toPrecision(4)));
            return [{ set: `${thing.key}=[${along.join(', ')}]` }];
        }
        if (thing.key.endsWith('.vertices')) return this.movesOfVertices(thing, whole);
        return [{ set: `${thing.key}=[${whole.join(', ')}]` }];
    }

    private movesOfVertices(thing: Thing, to: number[]): Change[] {
        const shape = this.shapes.find((each) => each.kind === 'light' && each.index === thing.index);
        const by = to.map((coordinate, axis) => Math.round(coordinate - thing.at[axis]));
        const moved = (shape?.outline ?? []).map((corner) => `[${corner.map((c, axis) => c + by[axis]).join(', ')}]`);
        return [{ set: `${thing.key}=[${moved.join(', ')}]` }];
    }
}
