// SPDX-License-Identifier: MIT
// What the page shows: the text of the scene with its history, what the core says to it, and the picture.  A change is
// judged at once; pictures follow, the newest wins, and a coarse one comes first where a whole one takes long.
import type { Change, Message, SceneFacts } from './core';
import { Client } from './client';
import type { Picture } from './worker';

const OFTEN = 24; // milliseconds that a picture may take to follow the hand
const SLOW = 200; // milliseconds from which on a second worker makes a picture
const UNKNOWN = 8; // the stride of a scene's first picture
const STRIDES = [1, 2, 4, 8, 16];
const MOMENT = 100; // milliseconds that a drag waits for its picture
const MOST_STEPS = 200; // of the history

export type Topic = 'text' | 'scene' | 'picture' | 'geometry' | 'failure';

/** Objects of the scene that can be grabbed, by the key that moves them. */
export interface Thing {
    kind: 'light' | 'aim' | 'direction' | 'surface' | 'observer';
    index: number;
    key: string; // "lights[0].position"
    at: number[];
    from?: number[]; // of an aim: the light
}

/** A body or outline, as the space view draws it. */
export interface Shape {
    kind: 'surface' | 'light';
    index: number;
    type: string;
    center: number[];
    radius?: number;
    size?: number[];
    height?: number;
    axis?: number[];
    up?: number[];
    outline?: number[][];
    opening?: number; // of a spot, degrees from its axis
    text?: string; // of a mesh: its mapping in the scene
}

const HEAD_KEYS = ['screen.width', 'screen.height', 'observer.z', 'observer.position', 'observer.projection', 'units'];
const SURFACE_KEYS = ['type', 'center', 'radius', 'size', 'height', 'axis', 'up', 'position'];
const BODIES = ['rectangle', 'disk', 'box', 'sphere', 'cylinder'];
const PLACE_KEYS = ['position', 'vertices', ...BODIES.map((body) => `${body}.center`)];
const BODY_KEYS = ['aim', 'outer', 'radius', 'size', 'height'];

/** Values of keys as the scene has them, in YAML. */
class Values {
    constructor(private readonly texts: Map<string, string | null>) {}

    text(key: string): string | null {
        return this.texts.get(key) ?? null;
    }

    /** The numbers of a value, or lists of them; null: it is something else. */
    numbers(key: string): number[] | null {
        try {
            const numbers: unknown = JSON.parse(this.text(key) ?? 'null');
            if (typeof numbers === 'number') return [numbers];
            const isList = Array.isArray(numbers) && numbers.length > 0;
            return isList && !numbers.flat().some((n) => typeof n !== 'number') ? (numbers as number[]) : null;
        } catch {
            return null;
        }
    }
}

/** Where a light's place and size are written. */
interface Body {
    base: string; // of the group of keys: "lights[0]", "lights[0].disk"
    key?: string; // of its place
    at?: number[];
    type?: string; // as it is drawn, where that is not the light's own
    outline?: number[][];
}

function bodyOf(base: string, values: Values): Body {
    const position = values.numbers(`${base}.position`);
    const outline = (values.numbers(`${base}.vertices`) as unknown as number[][] | null) ?? undefined;
    if (position) return { base, key: `${base}.position`, at: position, outline };
    for (const type of BODIES) {
        const center = values.numbers(`${base}.${type}.center`);
        const group = `${base}.${type}`;
        if (center) return { base: group, key: `${group}.center`, at: center, type, outline };
    }
    return { base, type: 'polygon', outline };
}

function sizes(base: string, values: Values): Pick<Shape, 'radius' | 'size' | 'height' | 'axis' | 'up'> {
    const numbers = (key: string) => values.numbers(`${base}.${key}`) ?? undefined;
    return {
        radius: numbers('radius')?.[0],
        size: numbers('size'),
        height: numbers('height')?.[0],
        axis: numbers('axis'),
        up: numbers('up'),
    };
}

export class Model {
    readonly client = new Client();
    text = '';
    wholeText = '';
    messages: Message[] = [];
    scene: SceneFacts | null = null;
    picture: Picture | null = null;
    irradiance = false;
    stale = false;
    /** How many drags still change the scene: the last movement is taken after the hand has let go. */
    drags = 0;
    things: Thing[] = [];
    shapes: Shape[] = [];
    screen: number[] = [1, 1]; // width and height in mm
    observer: { position: number[]; perspective: boolean } | null = null;
    photometric = false;
    /** The files that the text names, and whether they were given. */
    files: [string, boolean][] = [];
    private past: string[] = [];
    private future: string[] = [];
    private listeners: ((topic: Topic) => void)[] = [];
    private judging = false;
    private rendering = false;
    private wantsJudging = false;
    private wantsPicture = false;
    private coarse = 1; // the stride at which a picture follows the hand
    private lastMark = '';
    private wholeTime = 0; // milliseconds that a whole picture takes, by the last one
    private slow: Client | null = null;
    private pictureClient = this.client;
    private awaiting: (() => void)[] = [];
    private failing = ''; // the text with which the core failed last

    listen(listener: (topic: Topic) => void) {
        this.listeners.push(listener);
    }

    /** Waits for a picture of the present text, but no longer than a moment: so a drag asks for no more than is shown. */
    pictured(): Promise<void> {
        if (this.picture?.text === this.text) return Promise.resolve();
        return new Promise((resolve) => {
            this.awaiting.push(resolve);
            setTimeout(resolve, MOMENT);
        });
    }

    private tell(topic: Topic) {
        if (topic === 'picture' || this.stale) this.awaiting.splice(0).forEach((resolve) => resolve());
        for (const listener of this.listeners) listener(topic);
    }

    /** Takes a new text; changes with one mark that follow one another are one step of the history. */
    setText(text: string, mark = '') {
        if (text === this.text) return;
        if (this.text && !(mark && mark === this.lastMark)) {
            this.past.push(this.text);
            if (this.past.length > MOST_STEPS) this.past.shift();
        }
        this.lastMark = mark;
        this.future = [];
        this.text = text;
        this.tell('text');
        this.judge();
    }

    /** Takes another scene, of which a coarse picture comes first, as nobody knows how long it takes. */
    begin(text: string) {
        this.coarse = UNKNOWN;
        this.setText(text);
    }

    /** Ends a step of the history, so that the next change begins one. */
    endStep() {
        this.lastMark = '';
    }

    get canUndo() {
        return this.past.length > 0;
    }

    get canRedo() {
        return this.future.length > 0;
    }

    undo() {
        const text = this.past.pop();
        if (text === undefined) return;
        this.future.push(this.text);
        this.restore(text);
    }

    redo() {
        const text = this.future.pop();
        if (text === undefined) return;
        this.past.push(this.text);
        this.restore(text);
    }

    private restore(text: string) {
        this.lastMark = '';
        this.text = text;
        this.tell('text');
        this.judge();
    }

    setIrradiance(irradiance: boolean) {
        this.irradiance = irradiance;
        this.judge();
    }

    /** Changes values by assignments and the like; false: it does not go, and messages tell why. */
    async change(changes: Change[], mark = ''): Promise<boolean> {
        const before = this.text;
        const { interruptions } = this.client;
        const { text, messages } = await this.client.urgent('edit', before, changes);
        if (this.client.interruptions !== interruptions) void this.judge(); // a picture was given up
        if (this.text !== before) return false; // somebody was faster
        if (text === null) {
            this.messages = messages;
            this.tell('scene');
            return false;
        }
        this.setText(text, mark);
        return true;
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

    private async judgeOnce() {
        const text = this.text;
        const { whole, messages, scene, files } = await this.client.urgent('judge', text, this.irradiance);
        if (text !== this.text) return;
        this.messages = messages;
        this.files = files;
        this.stale = !whole;
        if (whole) {
            this.wholeText = text;
            this.scene = scene;
            await this.measure();
            this.tell('geometry');
            this.render();
        }
        this.tell('scene');
    }

    private async render() {
        this.wantsPicture = true;
        this.slow?.stop();
        this.slow = null;
        if (this.rendering) return;
        this.rendering = true;
        while (this.wantsPicture) {
            this.wantsPicture = false;
            const stride = this.coarse;
            await this.renderOnce(stride, this.client).catch(() => undefined);
            if (this.wantsPicture || this.picture?.stride === 1) continue;
            await new Promise((resolve) => setTimeout(resolve, 120)); // the hand may still be moving
            if (!this.wantsPicture) await this.renderWhole().catch(() => undefined);
        }
        this.rendering = false;
    }

    /** A whole picture that takes long is made by a second worker, which is stopped when another one is wanted. */
    private async renderWhole() {
        if (this.wholeTime < SLOW) return this.renderOnce(1, this.client);
        const slow = await this.client.twin();
        if (this.wantsPicture) return slow.stop();
        this.slow = slow;
        await this.renderOnce(1, slow);
    }

    private async renderOnce(stride: number, client: Client) {
        const text = this.wholeText;
        const picture = await client.ask('render', text, this.irradiance, stride);
        if ('messages' in picture) {
            this.messages = picture.messages;
            this.stale = true;
            this.tell('scene');
            return;
        }
        this.failing = '';
        this.wholeTime = picture.milliseconds * stride * stride;
        this.coarse = STRIDES.find((each) => this.wholeTime / (each * each) <= OFTEN) ?? STRIDES[STRIDES.length - 1];
        this.picture = picture;
        this.pictureClient = client;
        this.tell('picture');
    }

    /** Lines of equal value of the picture that is shown. */
    isophotes(logarithmic: boolean) {
        return this.pictureClient.ask('isophotes', 8, logarithmic).catch(() => []);
    }

    /** After a failure of the core: begins anew, but not with a text that made it fail twice. */
    recover(message: string) {
        const isHopeless = this.failing === this.text;
        this.failing = this.text;
        if (!isHopeless) {
            void this.judge();
            return;
        }
        this.stale = true;
        this.messages = [{ error: true, line: 0, column: 0, length: 0, key: null, message, hint: '' }];
        this.tell('scene');
    }

    private async valuesOf(keys: string[]): Promise<Values> {
        const values = await this.client.ask('values', keys);
        return new Values(new Map(keys.map((key, i) => [key, values[i]])));
    }

    /** Reads off the scene where its things stand: in two questions, as each waits for the worker. */
    private async measure() {
        const scene = this.scene!;
        const bases = [
            ...scene.surfaces.map((_, i): [string, string[]] => [`surfaces[${i}]`, SURFACE_KEYS]),
            ...scene.lights.map((_, i): [string, string[]] => [`lights[${i}]`, PLACE_KEYS]),
        ];
        const meshes = scene.surfaces.map((_, i) => `surfaces[${i}]`);
        const values = await this.valuesOf([
            ...HEAD_KEYS,
            ...meshes,
            ...bases.flatMap(([base, keys]) => keys.map((key) => `${base}.${key}`)),
        ]);
        const bodies = scene.lights.map((_, i) => bodyOf(`lights[${i}]`, values));
        const more = await this.valuesOf(bodies.flatMap(({ base }) => BODY_KEYS.map((key) => `${base}.${key}`)));
        this.photometric = values.text('units') === 'photometric';
        this.screen = ['width', 'height'].map((key) => values.numbers(`screen.${key}`)?.[0] ?? 1);
        const position = values.numbers('observer.position');
        const at = position ?? [0, 0, values.numbers('observer.z')?.[0] ?? 0];
        this.observer = { position: at, perspective: values.text('observer.projection') === 'perspective' };
        this.things = [{ kind: 'observer', index: 0, key: position ? 'observer.position' : 'observer.z', at }];
        this.shapes = [];
        scene.surfaces.forEach((_, i) => this.measureSurface(i, values));
        bodies.forEach((body, i) => this.measureLight(i, body, more));
    }

    private measureSurface(index: number, values: Values) {
        const base = `surfaces[${index}]`;
        const type = values.text(`${base}.type`) ?? '';
        const center = values.numbers(`${base}.center`);
        if (type === 'mesh') this.measureMesh(index, values);
        if (!center) return;
        this.things.push({ kind: 'surface', index, key: `${base}.center`, at: center });
        this.shapes.push({ kind: 'surface', index, type, center, ...sizes(base, values) });
    }

    // Of a mesh the page knows the ball around it; its form the space view asks for.
    private measureMesh(index: number, values: Values) {
        const base = `surfaces[${index}]`;
        const ball = this.scene!.surfaces[index];
        const at = values.numbers(`${base}.position`) ?? [0, 0, 0];
        this.things.push({ kind: 'surface', index, key: `${base}.position`, at });
        const text = values.text(base) ?? '';
        if (ball)
            this.shapes.push({ kind: 'surface', index, type: 'mesh', center: ball.center, radius: ball.reach, text });
    }

    private measureLight(index: number, body: Body, values: Values) {
        const light = this.scene!.lights[index];
        const { base, key, at } = body;
        if (key && at) this.things.push({ kind: 'light', index, key, at });
        else if (body.outline && light.place)
            this.things.push({ kind: 'light', index, key: `${base}.vertices`, at: light.place });
        else if (light.type === 'distant' && light.direction) this.measureDistant(index, light.direction);
        if (!light.place) return;
        const aim = values.numbers(`${base}.aim`);
        if (aim) this.things.push({ kind: 'aim', index, key: `${base}.aim`, at: aim, from: light.place });
        this.shapes.push({
            kind: 'light',
            index,
            type: body.type ?? light.type,
            center: light.place,
            ...sizes(base, values),
            axis: light.direction ?? undefined,
            up: undefined,
            opening: values.numbers(`${base}.outer`)?.[0],
            outline: body.outline,
        });
    }

    // Distant light comes from infinitely far; its handle stands a screen away from the first surface.
    private measureDistant(index: number, direction: number[]) {
        const target = this.scene!.surfaces[0]?.center ?? [0, 0, 0];
        const far = 1.2 * Math.max(...this.screen);
        const at = target.map((coordinate, axis) => coordinate - far * direction[axis]);
        this.things.push({ kind: 'direction', index, key: `lights[${index}].direction`, at, from: target });
    }

    /** Moves a thing to a place of the scene. */
    moveThing(thing: Thing, to: number[], mark: string) {
        const whole = to.map((coordinate) => Math.round(coordinate));
        const written = `[${whole.join(', ')}]`;
        if (thing.key === 'observer.z') return this.change([{ set: `observer.z=${Math.max(1, whole[2])}` }], mark);
        if (thing.kind === 'direction') {
            const along = thing.from!.map((coordinate, axis) => Number((coordinate - to[axis]).toPrecision(4)));
            return this.change([{ set: `${thing.key}=[${along.join(', ')}]` }], mark);
        }
        if (thing.key.endsWith('.vertices')) return this.moveVertices(thing, whole, mark);
        return this.change([{ set: `${thing.key}=${written}` }], mark);
    }

    private moveVertices(thing: Thing, to: number[], mark: string) {
        const shape = this.shapes.find((each) => each.kind === 'light' && each.index === thing.index);
        const by = to.map((coordinate, axis) => Math.round(coordinate - thing.at[axis]));
        const moved = (shape?.outline ?? []).map((corner) => `[${corner.map((c, axis) => c + by[axis]).join(', ')}]`);
        return this.change([{ set: `${thing.key}=[${moved.join(', ')}]` }], mark);
    }
}
